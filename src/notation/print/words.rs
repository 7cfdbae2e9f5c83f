//! Single values as text.

use crate::notation::lex::{gloss_mark, quote};
use crate::notation::lower::NAME_STOPS;
use crate::notation::parse::words::is_percentage;
use crate::notation::parse::{nonmanual, placement};
use crate::notation::syntax::{
    Attested, Configuration, Contact, ContactKind, Distance, Duration, Key, Length, NonManual, NonManualWhat,
    Orientation, Place, Placement, Relocation, Sited, Values,
};
use crate::phonology::{Amount, Digits, Forced, HandPoint, Hands, HandshapeChange, Relation, Side, Space};
use std::fmt;

/// A name without quotes where it reads back as itself: no mark in it, no word that ends or begins something else.
pub(crate) fn bare(name: &str, stops: &[&str], heads: &[&str]) -> String {
    let is = |word: &str, of: &[&str]| of.iter().any(|w| w.eq_ignore_ascii_case(word));
    let word = |w: &str| {
        !w.is_empty()
            && !w.contains(|c: char| c.is_whitespace() || c.is_control() || ",()=\"#\u{feff}".contains(c))
            && !w.starts_with(['“', '”', '„', '«', '‘', '’', '\''])
            // Names read back in gloss lines too, which have more marks.
            && !w.char_indices().any(|(i, _)| gloss_mark(&w[i..]).is_some())
            && !is(w, stops)
            && !is_percentage(w)
    };
    let first = name.split(' ').next().unwrap_or_default();
    if name.split(' ').all(word) && !is(first, heads) { name.to_owned() } else { quote(name) }
}

/// Values joined by `then`, with their keys.
pub(super) fn values<T>(all: &Values<T>, value: impl Fn(&T) -> String) -> String {
    let all: Vec<String> = all
        .iter()
        .map(|v| {
            let text = value(&v.value);
            match v.at.map(|at| at.value) {
                None => text,
                Some(Key::Start) => format!("{text} at start"),
                Some(Key::Middle) => format!("{text} at middle"),
                Some(Key::End) => format!("{text} at end"),
                Some(Key::Number(n)) => format!("{text} at key {n}"),
            }
        })
        .collect();
    all.join(" then ")
}

pub(super) fn configuration(v: &Configuration) -> String {
    let name = |n: &str| bare(n, &NAME_STOPS, &["between"]);
    let mixed = |n: &str, own: &[HandshapeChange]| match own {
        [] => name(n),
        own => format!("( {}{} )", name(n), changes(own)),
    };
    let text = match &v.between {
        None => name(&v.base.value),
        Some(b) => format!("between {} and {}", mixed(&v.base.value, &b.first), mixed(&b.second.value, &b.changes)),
    };
    text + &changes(&v.changes)
}

/// Changes, each with a comma before it.
fn changes(all: &[HandshapeChange]) -> String {
    let mut text = String::new();
    for change in all {
        text.push_str(", ");
        text.push_str(&match *change {
            HandshapeChange::Thumb(position) => format!("thumb {}", position.name()),
            HandshapeChange::Bend(fingers, bend) if fingers.is_empty() => bend.name().to_owned(),
            HandshapeChange::Bend(fingers, bend) => format!("{} {}", digits(fingers), bend.name()),
            HandshapeChange::Spread(true) => "spread".to_owned(),
            HandshapeChange::Spread(false) => "together".to_owned(),
            HandshapeChange::Cross(over, under) => format!("{} over {}", over.name(), under.name()),
            HandshapeChange::ThumbBetween(a, b) => format!("thumb between {} {}", a.name(), b.name()),
            HandshapeChange::On(fingers) => format!("on {}", digits(fingers)),
            HandshapeChange::Except(fingers) => format!("except {}", digits(fingers)),
            HandshapeChange::Opening(opening) => opening.name().to_owned(),
            HandshapeChange::Meet(digit, part, other) => {
                format!("{} touching {} {}", digit.name(), other.name(), part.name())
            }
            HandshapeChange::ThumbAt(part) => format!("thumb touching {}", part.name()),
            HandshapeChange::Joints(fingers, [a, b, c]) if fingers.is_empty() => format!("joints {a} {b} {c}"),
            HandshapeChange::Joints(fingers, [a, b, c]) => format!("{} joints {a} {b} {c}", digits(fingers)),
        });
    }
    text
}

pub(super) fn digits(fingers: Digits) -> String {
    if fingers == Digits::FINGERS {
        return "fingers".to_owned();
    }
    let names: Vec<&str> = fingers.iter().map(|d| d.name()).collect();
    names.join(" ")
}

fn side(side: Side) -> &'static str {
    match side {
        Side::Left => "left",
        Side::Right => "right",
    }
}

pub(super) fn place(v: &Place) -> String {
    match v {
        Place::Named(name) => bare(&name.value, &placement::STOPS, &placement::HEADS),
        Place::OtherHand(point) => format!("other {point}"),
        Place::Space(cell) => {
            let words: Vec<&str> = std::iter::once("space").chain(cell_words(*cell)).collect();
            words.join(" ")
        }
        Place::Point([x, y, z]) => format!("point {x} {y} {z}"),
        Place::Between(a, b) => {
            format!("between {} and {}", sited(a), sited(b))
        }
        Place::Referent(name) => format!("referent {}", quote(name)),
        Place::Towards(at) => format!("pointing at {}", place(at)),
    }
}

fn sited(v: &Sited) -> String {
    let name = match &v.place {
        Place::Between(..) | Place::Towards(_) => format!("({})", place(&v.place)),
        Place::Named(_) | Place::OtherHand(_) | Place::Space(_) | Place::Point(_) | Place::Referent(_) => {
            place(&v.place)
        }
    };
    match v.side {
        None => name,
        Some((s, true)) => format!("beside {} {name}", side(s)),
        Some((s, false)) => format!("{} {name}", side(s)),
    }
}

/// The words of a cell of the grid, `centre` where it is the middle one.
pub(crate) fn cell_words(cell: Space) -> Vec<&'static str> {
    let word = |value: i8, minus, plus| match value {
        -1 => Some(minus),
        1 => Some(plus),
        _ => None,
    };
    let axes = [word(cell.left, "right", "left"), word(cell.high, "low", "high"), word(cell.far, "near", "far")];
    let words: Vec<&str> = axes.into_iter().flatten().collect();
    if words.is_empty() { vec!["centre"] } else { words }
}

pub(super) fn placement(v: &Placement) -> String {
    let mut text = if v.behind { "behind ".to_owned() } else { String::new() };
    let name = place(&v.place);
    text.push_str(&match v.side {
        None => name,
        Some((s, true)) => format!("beside {} {name}", side(s)),
        Some((s, false)) if matches!(v.place, Place::Named(_)) => format!("{name} {}", side(s)),
        Some((s, false)) => format!("{} {name}", side(s)),
    });
    match v.distance {
        None => {}
        Some(Distance::Touch) => text.push_str(", touch"),
        Some(Distance::Close) => text.push_str(", close"),
        Some(Distance::Neutral) => text.push_str(", neutral distance"),
        Some(Distance::Extended) => text.push_str(", extended"),
        Some(Distance::Length(far)) => text.push_str(&format!(", {far} away")),
    }
    if let Some(point) = v.with {
        text.push_str(&format!(", with {point}"));
    }
    if let Some((way, far)) = v.offset {
        text.push_str(&format!(", offset {way} {far}"));
    }
    text
}

/// Meanings, each with its language.
pub(super) fn meanings(all: &[(String, String)]) -> String {
    let all: Vec<String> = all.iter().map(|(tag, words)| format!("{tag} {}", quote(words))).collect();
    all.join(", ")
}

pub(super) fn base(all: &[Attested]) -> String {
    let one = |a: &Attested| {
        let shape = configuration(&a.configuration);
        if a.meaning.is_empty() { shape } else { format!("{shape} {}", meanings(&a.meaning)) }
    };
    all.iter().map(one).collect::<Vec<_>>().join(" then ")
}

pub(super) fn relocation(to: &Relocation) -> String {
    match to.forced {
        Forced::No => place(&to.place),
        Forced::Yes => format!("{}, forced", place(&to.place)),
    }
}

pub(super) fn orientation(v: &Orientation) -> String {
    let fingers = v.fingers.map(|h| format!("fingers {}", h.value));
    let palm = v.palm.map(|h| format!("palm {}", h.value));
    let path = v.along_path.then(|| "along path".to_owned());
    let parts: Vec<String> = [fingers, palm, path].into_iter().flatten().collect();
    parts.join(", ")
}

pub(super) fn contact(v: &Contact) -> String {
    let kind = match v.kind {
        ContactKind::Touches => "touches".to_owned(),
        ContactKind::CloseTo => "close to".to_owned(),
        ContactKind::Crosses => "crosses".to_owned(),
        ContactKind::Interlocks => "interlocks".to_owned(),
        ContactKind::LengthFrom(far) => format!("{far} from"),
    };
    let point = |of: Option<HandPoint>| of.map_or_else(|| "hand".to_owned(), |point| point.to_string());
    format!("strong {} {kind} weak {}", point(v.strong), point(v.weak))
}

pub(super) fn hands(v: Hands) -> String {
    let Hands::Both(symmetry) = v else {
        return if v == Hands::Weak { "weak" } else { "one" }.to_owned();
    };
    let mut text = "both".to_owned();
    if let Some(s) = symmetry {
        text.push_str(if s.relation == Relation::Mirrored { " mirrored" } else { " parallel" });
        let flags =
            [(s.up_down, " up-down"), (s.out_in, " out-in"), (s.alternating, " alternating"), (s.crossed, " crossed")];
        text.extend(flags.into_iter().filter(|(on, _)| *on).map(|(_, word)| word));
    }
    text
}

pub(crate) fn nonmanual(v: &NonManual) -> String {
    let (mut text, comma) = match &v.what {
        NonManualWhat::Named(name) => (bare(&name.value, &nonmanual::STOPS, &nonmanual::HEADS), ""),
        NonManualWhat::Towards(heading) => (format!("towards {heading}"), ""),
        NonManualWhat::At(place) => (format!("at {}", placement(place)), ","),
        NonManualWhat::Mouthing(sounds) => (format!("mouthing {}", quote(sounds)), ""),
        NonManualWhat::Sequence(parts) => (group(parts, " then "), ""),
        NonManualWhat::Together(parts) => (group(parts, " while "), ""),
    };
    match v.amount {
        Amount::Slight => text.push_str(&format!("{comma} slight")),
        Amount::Plain => {}
        Amount::Strong => text.push_str(&format!("{comma} strong")),
        Amount::Percent(percent) => text.push_str(&format!("{comma} {percent}%")),
    }
    if let Some(pace) = v.pace {
        text.push_str(&format!(" speed {pace}"));
    }
    text
}

/// Non-manual values in brackets.
fn group(parts: &[NonManual], by: &str) -> String {
    format!("( {} )", parts.iter().map(nonmanual).collect::<Vec<_>>().join(by))
}

pub(super) fn growth(v: i8) -> String {
    let word = match v {
        0 => return String::new(),
        1.. => "growing",
        _ => "shrinking",
    };
    if v.unsigned_abs() == 1 { format!(" {word}") } else { format!(" {word} {}", v.unsigned_abs()) }
}

pub(crate) fn duration(v: Duration) -> String {
    format!("{}{}", v.number, if v.milliseconds { "ms" } else { "s" })
}

impl fmt::Display for Length {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.number, self.unit.name())
    }
}
