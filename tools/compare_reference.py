#!/usr/bin/env python3
"""Our motion of a published lexicon beside the reference engine's, split as docs/reference.md has it.

usage: tools/compare_reference.py FOLDER_OF_BVH [SHARED]

FOLDER_OF_BVH: `chereme render SHARED/data/lexica/ngt --each -o 'FOLDER/{stem}.bvh' --fps 30`. SHARED is ../shared where it is not said.

Measured are the hands that the description speaks of. SHARED/tools/compare_motion.py also counts a hand that moves in the reference
while nothing is said of it: it rests elsewhere there (at the waist; ours hangs), and goes along when the trunk leans.

Besides what SHARED/tools/compare_motion.py measures (wrists; fingertips by a hand of 1.95 times its palm), it measures
  place at the palm: the middle between wrist and middle knuckle, which is where the description puts an open hand;
  shape by own length: each hand's fingertips by the length of that hand, wrist to middle fingertip when it is stretched.
Two bodies are not of one size: the avatar's fingers are longer for its palm than the reference's. Needs numpy only."""
import os
import sys
import xml.etree.ElementTree as ElementTree

import numpy as np

HEAD = {
    "head", "headtop", "forehead", "eyebrows", "eyes", "nose", "nostrils", "ear", "earlobe", "cheek", "lips", "tongue",
    "teeth", "chin", "underchin", "upperlip", "lowerlip", "uppereyelid", "lowereyelid",
}  # fmt: skip


def stretched(points):
    """The length of a hand when it is stretched: wrist to middle fingertip, in wrist-to-knuckle lengths."""
    tips = np.linalg.norm(points[..., 7, :] - points[..., 1, :], axis=-1)
    palms = np.linalg.norm(points[..., 3, :] - points[..., 1, :], axis=-1)
    return np.percentile(tips / np.maximum(palms, 1e-9), 98)


def described(lexicon):
    """The hands that a sign speaks of: 0 is the strong one, 1 the weak one."""
    both = False
    for manual in lexicon.iter("sign_manual"):
        splits = [e for e in manual.iter() if e.tag.startswith("split_") or e.tag == "handconstellation"]
        both = both or manual.get("both_hands") == "true" or manual.get("nondominant") == "true" or bool(splits)
    return (0, 1) if both else (0,)


def main():
    folder = sys.argv[1]
    shared = sys.argv[2] if len(sys.argv) > 2 else os.path.join(os.path.dirname(__file__), "..", "..", "shared")
    sys.path.insert(0, os.path.join(shared, "tools"))
    import compare_motion as tool

    reference = np.load(os.path.join(shared, "data", "reference_motion", "ngt.npz"))
    offsets, points = reference["offsets"], reference["points"].astype(float)
    names = [str(name) for name in reference["names"]]
    ours = {}
    for name in names:
        path = os.path.join(folder, f"{name}.bvh")
        if os.path.exists(path):
            ours[name] = tool.points_of(path)
    if not ours:
        sys.exit(f"no sign of the lexicon lies in {folder}")
    lengths = stretched(points), stretched(np.concatenate(list(ours.values())))
    print(f"{len(ours)} of {len(names)} signs; a stretched hand is {lengths[0]:.2f} palms long there, {lengths[1]:.2f} here")

    def shape(p, hand, length):
        return tool.shape(p, hand) * 1.95 / length

    rows = []
    for i, name in enumerate(names):
        if name not in ours:
            continue
        there, here = points[offsets[i] : offsets[i + 1]], ours[name]
        lexicon = ElementTree.parse(os.path.join(shared, "data", "lexica", "ngt", f"{name}.sigml"))
        at = {e.get(a) for e in lexicon.iter("location_bodyarm") for a in ("location", "second_location")}
        wrist, finger, palm, tips = tool.compare(there, here)[:4]
        moved = [np.linalg.norm(there[:, h, 1] - there[0, h, 1], axis=-1).max() for h in (0, 1)]
        hands = [h for h in described(lexicon) if moved[h] > 0.08] or [0]
        there = there[tool.stroke_start(there, hands) :]

        def feature(p):
            parts = []
            for h in hands:
                f, n, _ = tool.hand_frame(p[:, h], h)
                parts += [p[:, h, 1], 0.15 * f, 0.1 * n, 0.1 * tool.shape(p[:, h], h).reshape(len(p), -1)]
            return np.concatenate(parts, -1)

        a, b = tool.warp(feature(there), feature(here))
        middle = lambda p: (p[:, 1] + p[:, 3]) / 2
        of_wrist = np.concatenate([np.linalg.norm(there[a, h, 1] - here[b, h, 1], axis=-1) * 55 for h in hands])
        of_palm = np.concatenate(
            [np.linalg.norm(middle(there[a, h]) - middle(here[b, h]), axis=-1) * 55 for h in hands]
        )
        own = [shape(there[a, h], h, lengths[0]) - shape(here[b, h], h, lengths[1]) for h in hands]
        own = np.concatenate([np.linalg.norm(d, axis=-1).mean(-1) * 100 for d in own])
        rows.append((bool(at & HEAD), wrist, np.median(of_wrist), np.median(of_palm), finger, palm, tips, np.median(own)))
    rows = np.array(rows, float)
    head = rows[:, 0] > 0
    for label, column, unit, limits in (
        ("wrist, as the tool", 1, "cm", (5, 7)),
        ("wrist, hands said", 2, "cm", (5, 7)),
        ("palm, hands said", 3, "cm", (5, 7)),
    ):
        for where, which in (("away from the head", ~head), ("at the head", head)):
            v = rows[which, column]
            within = ", ".join(f"{100 * (v <= l).mean():.1f} % within {l} {unit}" for l in limits)
            print(f"{label:20} {where:20} {len(v):5} signs  median {np.median(v):4.1f} {unit}  {within}")
    for label, column, unit, limit in (
        ("finger direction", 4, "°", 15),
        ("palm direction", 5, "°", 15),
        ("shape, 1.95 palms", 6, "%", 10),
        ("shape, own length", 7, "%", 10),
    ):
        v = rows[:, column]
        print(f"{label:41} {len(v):5} signs  median {np.median(v):4.1f} {unit}   {100 * (v <= limit).mean():.1f} % within {limit} {unit}")


if __name__ == "__main__":
    main()
