//! Tiers as a TextGrid of the long form, as Praat writes it.

use crate::tier::{Tier, TierValue};
use crate::time::Seconds;

/// The least length of an interval, where a value has none or is pushed aside.
const LEAST_S: f64 = 0.001;

/// A TextGrid of tiers, long form, UTF-8, times in seconds with all their digits.
///
/// It lasts from 0 (or the earliest value) to `end` or the last value, whichever is later. A tier whose values all are
/// instants is a point tier; gaps of the others are filled with empty intervals, as Praat asks for. Praat's intervals
/// follow one another: where two values overlap, the earlier ends as the later begins; an instant among intervals lasts
/// a millisecond, and pushes what follows it aside. A value without a label is a gap to Praat. Values at times that are
/// not finite are left out; sources are not kept.
///
/// ```
/// use chereme::{format::textgrid, tier::Tier, time::Seconds};
/// let mut tier = Tier::new("RH Gloss");
/// tier.push(Seconds(0.3), Seconds(1.2), "say \"BOL\"", "");
/// let file = textgrid::write(&[tier.clone()], Seconds(2.0));
/// assert!(file.contains("text = \"say \"\"BOL\"\"\""));
/// assert_eq!(textgrid::read(file.as_bytes()).unwrap().grid.tiers[0].tier, tier);
/// ```
pub fn write(tiers: &[Tier], end: Seconds) -> String {
    let laid: Vec<Laid> = tiers.iter().map(lay).collect();
    let finite = |time: f64| if time.is_finite() { time } else { 0.0 };
    let times = || laid.iter().flat_map(|tier| tier.values.iter());
    let first = times().map(|value| value.0).fold(0.0, f64::min);
    let last = times().map(|value| value.1).fold(finite(end.0).max(first), f64::max);
    let mut out = String::from("File type = \"ooTextFile\"\nObject class = \"TextGrid\"\n\n");
    out += &format!("xmin = {first} \nxmax = {last} \ntiers? <exists> \nsize = {} \nitem []: \n", tiers.len());
    for (number, (tier, laid)) in tiers.iter().zip(&laid).enumerate() {
        let class = if laid.points { "TextTier" } else { "IntervalTier" };
        out += &format!("    item [{}]:\n        class = \"{class}\" \n", number + 1);
        out += &format!("        name = {} \n        xmin = {first} \n        xmax = {last} \n", quoted(&tier.name));
        if laid.points {
            points(&mut out, &laid.values);
        } else {
            intervals(&mut out, &filled(&laid.values, first, last));
        }
    }
    out
}

/// From, to, and the label.
type Value<'a> = (f64, f64, &'a str);

/// The values of a tier, one after the other.
struct Laid<'a> {
    points: bool,
    values: Vec<Value<'a>>,
}

fn lay(tier: &Tier) -> Laid<'_> {
    let finite = |v: &&TierValue| v.start.0.is_finite() && v.end.0.is_finite();
    let values: Vec<&TierValue> = tier.values().iter().filter(finite).collect();
    let points = !values.is_empty() && values.iter().all(|v| v.start == v.end);
    let mut free = f64::NEG_INFINITY;
    let interval = |(i, v): (usize, &&'_ TierValue)| {
        let begin = v.start.0.max(free);
        let next = values.get(i + 1).map_or(f64::INFINITY, |next| next.start.0);
        let end = v.end.0.min(next);
        free = if end > begin { end } else { begin + LEAST_S };
        (begin, free)
    };
    let times: Vec<(f64, f64)> = match points {
        true => values.iter().map(|v| (v.start.0, v.end.0)).collect(),
        false => values.iter().enumerate().map(interval).collect(),
    };
    Laid { points, values: times.into_iter().zip(values).map(|((a, b), v)| (a, b, v.label.as_str())).collect() }
}

/// The same with empty intervals between.
fn filled<'a>(values: &[Value<'a>], first: f64, last: f64) -> Vec<Value<'a>> {
    let mut all = Vec::with_capacity(values.len() * 2 + 1);
    let mut at = first;
    for &(begin, end, label) in values {
        if begin > at {
            all.push((at, begin, ""));
        }
        all.push((begin, end, label));
        at = end;
    }
    if at < last || all.is_empty() {
        all.push((at, last, ""));
    }
    all
}

fn intervals(out: &mut String, values: &[Value<'_>]) {
    *out += &format!("        intervals: size = {} \n", values.len());
    for (i, (begin, end, label)) in values.iter().enumerate() {
        *out += &format!("        intervals [{}]:\n            xmin = {begin} \n            xmax = {end} \n", i + 1);
        *out += &format!("            text = {} \n", quoted(label));
    }
}

fn points(out: &mut String, values: &[Value<'_>]) {
    *out += &format!("        points: size = {} \n", values.len());
    for (i, (time, _, label)) in values.iter().enumerate() {
        *out += &format!(
            "        points [{}]:\n            number = {time} \n            mark = {} \n",
            i + 1,
            quoted(label)
        );
    }
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\""))
}
