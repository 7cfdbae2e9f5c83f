//! The drawing of a [`Figure`]: where its parts stand, in pixels.

use super::scale::Scale;
use super::{Base, Column, Figure, Line, Row};
use std::fmt::Write;

/// The left edge of panels.
const LEFT: f64 = 62.0;
/// The left edge of headings.
pub(super) const EDGE: f64 = 14.0;
pub(super) const RIGHT: f64 = 22.0;
/// Between columns.
const GUTTER: f64 = 18.0;
/// Above each row, for its heading.
const HEADING: f64 = 30.0;
/// How far a row's heading stands above its panel.
const HEADING_LIFT: f64 = 9.0;
/// Below the last row, for the ticks of time.
const FOOT: f64 = 46.0;
/// An average letter of the text's size 12.
pub(super) const LETTER: f64 = 6.7;
/// Colours there are; further keys use them again, dashed.
const COLOURS: usize = 8;

pub(super) const STYLE: &str = "\
text{font:12px system-ui,-apple-system,'Segoe UI','DejaVu Sans',sans-serif;fill:#22262b}
.paper{fill:#ffffff}.title{font-size:18px;font-weight:600}.head{font-weight:600}.soft{fill:#5b6470}.small{font-size:11px}
.grid{stroke:#e3e7eb;stroke-width:1}.axis{stroke:#8b949e;stroke-width:1;fill:none}.band{fill:#eef2f6}.limit{fill:#2f9e6e;fill-opacity:.13}
.mark{stroke:#5b6470;stroke-width:1;stroke-dasharray:2 3}.letter{font-weight:600;font-size:11px}.halo{stroke:#ffffff;stroke-width:4;stroke-opacity:.75;paint-order:stroke}
.line{fill:none;stroke-width:1.9;stroke-linejoin:round;stroke-linecap:round}.dashed{stroke-dasharray:6 4}
.c0{stroke:#1f6fb4}.c1{stroke:#d1495b}.c2{stroke:#23895f}.c3{stroke:#8456bd}.c4{stroke:#c07a12}.c5{stroke:#11889a}.c6{stroke:#b03f8a}.c7{stroke:#6b7078}
@media (prefers-color-scheme:dark){text{fill:#e4e8ec}.paper{fill:#15181c}.soft{fill:#9aa4af}.grid{stroke:#2a3037}.axis{stroke:#6d7681}.band{fill:#1d2228}
.limit{fill:#4fc08d;fill-opacity:.16}.mark{stroke:#9aa4af}.halo{stroke:#15181c}
.c0{stroke:#62aeea}.c1{stroke:#f0808d}.c2{stroke:#55c596}.c3{stroke:#b794e6}.c4{stroke:#e8ab4e}.c5{stroke:#48c3d4}.c6{stroke:#e382c0}.c7{stroke:#a6adb6}}
";

/// Where everything stands.
struct Sheet {
    width: f64,
    panel: f64,
    row: f64,
    /// Top of the first row's heading.
    top: f64,
    /// How far the first heading stands above its panel: letters of instants stand between them.
    lift: f64,
}

impl Sheet {
    fn left(&self, column: usize) -> f64 {
        LEFT + column as f64 * (self.panel + GUTTER)
    }

    fn top(&self, row: usize) -> f64 {
        self.top + HEADING + row as f64 * (self.row + HEADING)
    }

    fn bottom(&self, rows: usize) -> f64 {
        self.top(rows.max(1) - 1) + self.row
    }
}

pub(super) fn draw(figure: &Figure) -> String {
    let columns = figure.columns.len().max(1);
    let panel = match columns {
        1 => 700.0,
        2 => 400.0,
        3 => 300.0,
        _ => 250.0,
    };
    let width = LEFT + columns as f64 * (panel + GUTTER) - GUTTER + RIGHT;
    let mut body = String::new();
    put(&mut body, "title", EDGE, 32.0, "start", &cut(&figure.title, width - EDGE - RIGHT, 10.0));
    let mut y = 32.0;
    if !figure.subtitle.is_empty() {
        y += 21.0;
        put(&mut body, "soft", EDGE, y, "start", &cut(&figure.subtitle, width - EDGE - RIGHT, LETTER));
    }
    y = legend(&mut body, &figure.keys, width, y);
    if figure.columns.iter().any(|c| !c.title.is_empty()) {
        y += 24.0;
    }
    let strips = figure.columns.iter().any(|c| !c.phases.is_empty() || !c.marks.is_empty());
    let row = if figure.rows.len() <= 2 { 190.0 } else { 140.0 };
    let (top, lift) = if strips { (y + 16.0, 18.0) } else { (y + 8.0, HEADING_LIFT) };
    let sheet = Sheet { width, panel, row, top, lift };
    for (i, column) in figure.columns.iter().enumerate() {
        if !column.title.is_empty() {
            let title = cut(&column.title, panel, LETTER);
            put(&mut body, "head", sheet.left(i) + panel / 2.0, y, "middle", &title);
        }
    }
    panels(&mut body, figure, &sheet);
    let height = sheet.bottom(figure.rows.len()) + FOOT;
    let title = escaped(&figure.title);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" role=\"img\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n<rect class=\"paper\" width=\"{width}\" height=\"{height}\"/>\n{body}</svg>\n"
    )
}

/// What each colour means, in lines; returns where the last line stands.
pub(super) fn legend(body: &mut String, keys: &[String], width: f64, above: f64) -> f64 {
    const SAMPLE: f64 = 24.0;
    let (mut x, mut y) = (EDGE, above);
    for (i, key) in keys.iter().enumerate() {
        let label = cut(key, 260.0, LETTER);
        let length = SAMPLE + 7.0 + label.chars().count() as f64 * LETTER + 18.0;
        if i == 0 || x + length > width {
            (x, y) = (EDGE, y + 22.0);
        }
        let class = class(i);
        let _ = writeln!(
            body,
            "<line class=\"{class}\" x1=\"{x:.1}\" x2=\"{:.1}\" y1=\"{:.1}\" y2=\"{:.1}\"/>",
            x + SAMPLE,
            y - 4.0,
            y - 4.0
        );
        put(body, "", x + SAMPLE + 7.0, y, "start", &label);
        x += length;
    }
    y
}

fn panels(body: &mut String, figure: &Figure, sheet: &Sheet) {
    let instants = || figure.rows.iter().flat_map(|r| &r.panels).flat_map(|p| &p.lines).flat_map(|l| &l.points);
    let time = instants().map(|p| p.0).filter(|t| t.is_finite());
    let span = time.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), t| (a.min(t), b.max(t)));
    let bottom = sheet.bottom(figure.rows.len());
    for (c, column) in figure.columns.iter().enumerate() {
        let left = sheet.left(c);
        let x = Scale::new(span, (left, left + sheet.panel), sheet.panel / 75.0);
        for r in 0..figure.rows.len() {
            grounds(body, column, &x, sheet, (c, r));
        }
        heads(body, column, &x, sheet, c);
        for (r, row) in figure.rows.iter().enumerate() {
            let y = scale(row, (sheet.top(r) + sheet.row, sheet.top(r)));
            panel(body, row, sheet, (c, r), (&x, &y));
        }
        for (value, text) in x.ticks() {
            put(body, "small soft", x.at(value), bottom + 17.0, "middle", &text);
        }
    }
    put(body, "small soft", sheet.width - RIGHT, bottom + 35.0, "end", "time (s)");
}

/// The scale of a row: the same in all its columns.
fn scale(row: &Row, pixels: (f64, f64)) -> Scale {
    let values =
        row.panels.iter().flat_map(|p| &p.lines).flat_map(|l| &l.points).map(|p| p.1).filter(|v| v.is_finite());
    let more: &[f64] = match row.base {
        Base::Data => &[],
        Base::Zero => &[0.0],
        Base::Tolerance(size) => &[-1.15 * size, 1.15 * size],
    };
    let all = values.chain(more.iter().copied());
    let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
    Scale::new((low, high), pixels, 4.0).rounded()
}

/// What stands behind the curves of a panel: every second phase has a ground of its own, every instant a line.
fn grounds(body: &mut String, column: &Column, x: &Scale, sheet: &Sheet, (c, r): (usize, usize)) {
    let (top, height) = (sheet.top(r), sheet.row);
    for phase in column.phases.iter().skip(1).step_by(2) {
        let (from, to) = inside(x, sheet, c, phase.start.0, phase.end.0);
        let width = to - from;
        let _ = writeln!(
            body,
            "<rect class=\"band\" x=\"{from:.1}\" y=\"{top:.1}\" width=\"{width:.1}\" height=\"{height:.1}\"/>"
        );
    }
    for (at, _) in marks(column, x, sheet, c) {
        let bottom = top + height;
        let _ =
            writeln!(body, "<line class=\"mark\" x1=\"{at:.1}\" x2=\"{at:.1}\" y1=\"{top:.1}\" y2=\"{bottom:.1}\"/>");
    }
}

/// The instants that lie in a column, in pixels, with their letters.
fn marks<'a>(column: &'a Column, x: &Scale, sheet: &Sheet, c: usize) -> Vec<(f64, &'a str)> {
    let (left, right) = (sheet.left(c) - 0.5, sheet.left(c) + sheet.panel + 0.5);
    let all = column.marks.iter().map(|mark| (x.at(mark.time.0), mark.name.as_str()));
    all.filter(|(at, _)| (left..=right).contains(at)).collect()
}

/// The names of phases in the first row, and the letters of instants above it.
fn heads(body: &mut String, column: &Column, x: &Scale, sheet: &Sheet, c: usize) {
    let top = sheet.top(0);
    for phase in &column.phases {
        let (from, to) = inside(x, sheet, c, phase.start.0, phase.end.0);
        // A name without room is left out: half a word says less than the band.
        if phase.name.chars().count() as f64 * 0.9 * LETTER <= to - from {
            put(body, "small soft halo", (from + to) / 2.0, top + 13.0, "middle", &phase.name);
        }
    }
    for (at, letter) in marks(column, x, sheet, c) {
        put(body, "letter", at, top - 5.0, "middle", letter);
    }
}

/// A stretch of time as pixels of a panel.
fn inside(x: &Scale, sheet: &Sheet, c: usize, start: f64, end: f64) -> (f64, f64) {
    let (left, right) = (sheet.left(c), sheet.left(c) + sheet.panel);
    (x.at(start).clamp(left, right), x.at(end).clamp(left, right))
}

fn panel(body: &mut String, row: &Row, sheet: &Sheet, (c, r): (usize, usize), (x, y): (&Scale, &Scale)) {
    let (left, right) = (sheet.left(c), sheet.left(c) + sheet.panel);
    let (top, bottom) = (sheet.top(r), sheet.top(r) + sheet.row);
    if c == 0 {
        let lift = if r == 0 { sheet.lift } else { HEADING_LIFT };
        put(body, "head", EDGE, top - lift, "start", &row.title);
    }
    for (value, text) in y.ticks() {
        let at = y.at(value);
        let _ =
            writeln!(body, "<line class=\"grid\" x1=\"{left:.1}\" x2=\"{right:.1}\" y1=\"{at:.1}\" y2=\"{at:.1}\"/>");
        if c == 0 {
            put(body, "small soft", left - 8.0, at + 4.0, "end", &text);
        }
    }
    if let Base::Tolerance(size) = row.base
        && size.is_finite()
    {
        let (from, to) = (y.at(size), y.at(-size));
        let _ = writeln!(
            body,
            "<rect class=\"limit\" x=\"{left:.1}\" y=\"{from:.1}\" width=\"{:.1}\" height=\"{:.1}\"/>",
            right - left,
            to - from
        );
    }
    for (value, _) in x.ticks() {
        let at = x.at(value);
        let _ = writeln!(
            body,
            "<line class=\"axis\" x1=\"{at:.1}\" x2=\"{at:.1}\" y1=\"{bottom:.1}\" y2=\"{:.1}\"/>",
            bottom + 4.0
        );
    }
    let _ = writeln!(body, "<path class=\"axis\" d=\"M{left:.1} {top:.1}V{bottom:.1}H{right:.1}\"/>");
    for line in row.panels.get(c).map_or(&[][..], |p| &p.lines) {
        let mut points = String::new();
        for (i, (px, py)) in thinned(line, x, y).into_iter().enumerate() {
            let _ = write!(points, "{}{px:.1},{py:.1}", if i == 0 { "" } else { " " });
        }
        let _ = writeln!(body, "<polyline class=\"{}\" points=\"{points}\"/>", class(line.key));
    }
}

/// The pixels of a line; where a pixel has many points, the least and the greatest of them, so that a long recording stays
/// a small file and no peak is lost.
fn thinned(line: &Line, x: &Scale, y: &Scale) -> Vec<(f64, f64)> {
    let finite = line.points.iter().filter(|(t, v)| t.is_finite() && v.is_finite());
    let mut thin: Vec<(f64, f64)> = Vec::new();
    let mut same = 0;
    for (px, py) in finite.map(|(t, v)| (x.at(*t), y.at(*v))) {
        let n = thin.len();
        same = if n > 0 && (thin[n - 1].0 * 2.0).floor() == (px * 2.0).floor() { same + 1 } else { 1 };
        if same <= 2 {
            thin.push((px, py));
            continue;
        }
        let (low, high) = (thin[n - 2].1.min(thin[n - 1].1), thin[n - 2].1.max(thin[n - 1].1));
        (thin[n - 2].1, thin[n - 1].1) = (low.min(py), high.max(py));
    }
    thin
}

pub(super) fn class(key: usize) -> String {
    format!("line c{}{}", key % COLOURS, if key / COLOURS % 2 == 1 { " dashed" } else { "" })
}

pub(super) fn put(body: &mut String, class: &str, x: f64, y: f64, anchor: &str, text: &str) {
    let text = escaped(text);
    let _ = writeln!(body, "<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{text}</text>");
}

/// As much of a text as fits into so many pixels.
pub(super) fn cut(text: &str, width: f64, letter: f64) -> String {
    let room = (width / letter).max(1.0) as usize;
    match text.chars().count() > room {
        true => text.chars().take(room - 1).chain(['…']).collect(),
        false => text.to_owned(),
    }
}

/// Text that may stand in XML: marks escaped, letters that XML forbids replaced.
pub(super) fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => safe += "&amp;",
            '<' => safe += "&lt;",
            '>' => safe += "&gt;",
            '\t' | '\n' | '\r' => safe.push(' '),
            '\u{0}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => safe.push('\u{fffd}'),
            other => safe.push(other),
        }
    }
    safe
}
