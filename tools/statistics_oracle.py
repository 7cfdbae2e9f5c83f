"""Oracle values of the statistics: python3 -m venv v; v/bin/pip install scipy; v/bin/python tools/statistics_oracle.py"""
import numpy as np
from scipy import stats, special
print("scipy", __import__("scipy").__version__)
for a, x in [(0.5, 0.01), (0.5, 3.0), (1.0, 2.0), (2.5, 0.3), (2.5, 9.0), (10.0, 10.0), (50.0, 30.0), (50.0, 90.0), (0.1, 1e-6), (500.0, 520.0)]:
    print(f"    ({a}, {x}, {float(special.gammaincc(a, x))!r}),")
print("lngamma")
for x in [0.1, 0.5, 1.0, 1.5, 3.7, 12.0, 100.5, 1e6]:
    print(f"    ({x}, {float(special.gammaln(x))!r}),")
print("normal")
for z in [-3.0, -1.0, 0.0, 0.5, 1.959963984540054, 4.0, 8.0]:
    print(f"    ({z}, {float(stats.norm.sf(z))!r}),")
A = [5, 4, 4, 3, 5, 2, 4, 5, 3, 4, 4, 5]
B = [3, 2, 4, 1, 3, 3, 2, 5, 4, 2, 3, 3]
C = [4, 3, 3, 2, 5, 4, 3, 3, 2, 4, 1, 4]
k = stats.kruskal(A, B, C); print("kruskal", repr(float(k.statistic)), repr(float(k.pvalue)))
k = stats.kruskal(A, B); print("kruskal2", repr(float(k.statistic)), repr(float(k.pvalue)))
for x, y in [(A, B), (A, C), (B, C)]:
    m = stats.mannwhitneyu(x, y, alternative="two-sided"); print("mwu", float(m.statistic), repr(float(m.pvalue)))
X = [1.1, 2.3, 0.4, 5.2, 3.3]; Y = [2.2, 6.1, 7.5, 4.4, 8.0, 9.1, 3.9]
m = stats.mannwhitneyu(X, Y, alternative="two-sided"); print("exact", float(m.statistic), repr(float(m.pvalue)))
X2 = [0.9, 8.8, 4.1, 3.7, 6.6, 2.0, 7.1, 5.5]; Y2 = list(np.arange(30) * 0.37 + 0.013)
m = stats.mannwhitneyu(X2, Y2, alternative="two-sided"); print("exact8x30", float(m.statistic), repr(float(m.pvalue)))
X3 = list(np.arange(12) * 0.91 + 0.5)
m = stats.mannwhitneyu(X3, Y2, alternative="two-sided"); print("normal12x30", float(m.statistic), repr(float(m.pvalue)))
for h, n in [(0, 10), (8, 10), (36, 57), (49, 57), (10, 10)]:
    r = stats.binomtest(h, n).proportion_ci(method="wilson"); print(f"    ({h}, {n}, {float(r.low)!r}, {float(r.high)!r}),")
print("quantiles", [float(v) for v in np.quantile(A, [.25, .5, .75])], float(np.std(A, ddof=1)))
print("pearson", repr(float(stats.pearsonr(A, C).statistic)))
