//! The tiers of a synthesized sign: what each stretch of the motion is, and where it came from.

use super::prepare::Prepared;
use super::schedule::Schedule;
use super::timeline::Timeline;
use super::{Grammar, side_of};
use crate::phonology::symmetry::{acts, resolve};
use crate::phonology::{Channel, Configuration, Hand, Keys, label};
use crate::score::plan::{Act, Plan};
use crate::tier::Tier;
use crate::time::Seconds;

const STATED: &str = "description";
const FOLLOWS: &str = "description, by symmetry";
const PROCEDURE: &str = "procedure";

/// The tiers of a plan: those of its signs one after the other, hand by hand, then contact and non-manuals.
pub(super) fn of_plan(plan: &Plan, prepared: &[Prepared], timelines: &[Timeline], schedule: &Schedule) -> Vec<Tier> {
    let mut tiers = Tiers::default();
    for (n, (sign, timeline)) in prepared.iter().zip(timelines).enumerate() {
        let item = &plan.items[sign.item];
        if sign.item == sign.group.start {
            gloss(sign, &item.gloss, prepared, schedule, &mut tiers);
        }
        of_sign(sign, timeline, &mut tiers);
        let before = n.checked_sub(1).map(|p| prepared[p].item);
        let rested = before.is_none_or(|b| plan.items[b + 1..sign.item].iter().any(|i| matches!(i.act, Act::Rest(_))));
        let way = if rested { "preparation" } else { "transition" };
        phases(sign, timeline, way, plan, schedule, &mut tiers);
    }
    for over in &plan.spans {
        if let [first, .., last] | [first @ last] = schedule.items.get(over.items.clone()).unwrap_or_default() {
            let tier = tiers.of(&over.channel.title());
            tier.push(first.stroke, last.hold_end, label::non_manual(&over.value), STATED);
        }
    }
    tiers.in_order()
}

/// The tiers with the sources of hands that were captured.
pub(super) fn with_captured(tiers: Vec<Tier>, prepared: &[Prepared], grammar: &Grammar) -> Vec<Tier> {
    if grammar.captured.is_empty() {
        return tiers;
    }
    let languages: Vec<Option<&str>> = prepared.iter().map(|p| super::language(p.sign)).collect();
    let source = |label: &str| {
        let named = Configuration::named(label);
        languages.iter().find_map(|language| grammar.captured_hand(&named, *language)).map(|(_, source)| source)
    };
    let again = |tier: Tier| {
        if !tier.name.ends_with("Configuration") {
            return tier;
        }
        let mut made = Tier::new(tier.name.clone());
        for v in tier.values() {
            let source = source(&v.label).unwrap_or(&v.source);
            made.push(v.start, v.end, v.label.clone(), source.clone());
        }
        made
    };
    tiers.into_iter().map(again).collect()
}

/// Tiers by name.
#[derive(Default)]
struct Tiers(Vec<Tier>);

impl Tiers {
    fn of(&mut self, name: &str) -> &mut Tier {
        let at = self.0.iter().position(|t| t.name == name).unwrap_or_else(|| {
            self.0.push(Tier::new(name));
            self.0.len() - 1
        });
        &mut self.0[at]
    }

    /// Those with values: the right hand's, the left hand's, contact, then the non-manuals from head to mouth.
    fn in_order(mut self) -> Vec<Tier> {
        const KINDS: [&str; 6] = ["Gloss", "Phase", "Configuration", "Placement", "Orientation", "Movement"];
        let hands = ["RH", "LH"].iter().flat_map(|hand| KINDS.map(|kind| format!("{hand} {kind}")));
        let others = Channel::ALL.iter().map(|channel| channel.title());
        let order: Vec<String> = hands.chain(["Contact".to_owned()]).chain(others).collect();
        self.0.retain(|t| !t.values().is_empty());
        self.0.sort_by_key(|t| order.iter().position(|name| *name == t.name).unwrap_or(order.len()));
        self.0
    }
}

/// One gloss over all phases of a sign, for each hand that acts in some of them.
fn gloss(sign: &Prepared, label: &str, prepared: &[Prepared], schedule: &Schedule, tiers: &mut Tiers) {
    let times = schedule.items.get(sign.group.clone()).unwrap_or_default();
    let ([first, .., last] | [first @ last]) = times else { return };
    for hand in Hand::BOTH {
        let side = side_of(hand);
        let own = |p: &&Prepared| sign.group.contains(&p.item) && p.hands.iter().any(|h| h.side == side);
        if prepared.iter().any(|p| own(&p)) {
            tiers.of(&format!("{} Gloss", side.hand())).push(first.stroke, last.hold_end, label, STATED);
        }
    }
}

fn of_sign(prepared: &Prepared, timeline: &Timeline, tiers: &mut Tiers) {
    let sign = prepared.sign;
    for hand in Hand::BOTH {
        let side = side_of(hand);
        if !acts(sign, hand) || !prepared.hands.iter().any(|p| p.side == side) {
            continue;
        }
        let prefix = side.hand();
        let said = resolve(sign, hand);
        let own = match hand {
            Hand::Strong => &sign.strong,
            Hand::Weak => &sign.weak,
        };
        let source = |own: bool| if own { STATED } else { FOLLOWS };
        let tier = tiers.of(&format!("{prefix} Configuration"));
        keyed(tier, &said.configuration, timeline, label::configuration, source(!own.configuration.is_empty()));
        let tier = tiers.of(&format!("{prefix} Placement"));
        keyed(tier, &said.placement, timeline, label::placement, source(!own.placement.is_empty()));
        let tier = tiers.of(&format!("{prefix} Orientation"));
        keyed(tier, &said.orientation, timeline, label::orientation, source(!own.orientation.is_empty()));
        let movement = tiers.of(&format!("{prefix} Movement"));
        for (m, span) in said.movement.iter().zip(timeline.keys.windows(2)) {
            movement.push(Seconds(span[0]), Seconds(span[1]), label::movement(m), source(!own.movement.is_empty()));
        }
    }
    keyed(tiers.of("Contact"), &sign.contact, timeline, label::contact, STATED);
    // What the face does holds over all phases.
    let whole = Timeline { hold_end: timeline.sign_end, ..timeline.clone() };
    for (channel, values) in &sign.nonmanual {
        keyed(tiers.of(&channel.title()), values, &whole, label::non_manual, STATED);
    }
}

/// The phases of a sign's hands. `way` is what the way there is called; the way back to rest follows the last sign, and
/// one before a rest.
fn phases(sign: &Prepared, timeline: &Timeline, way: &str, plan: &Plan, schedule: &Schedule, tiers: &mut Tiers) {
    let stroke_end = timeline.keys.last().copied().unwrap_or(timeline.stroke);
    let later = &plan.items[sign.item + 1..];
    let next = later.iter().position(|i| !matches!(i.act, Act::Hold(..)));
    let (held, retracted) = match next.map(|n| (&later[n].act, sign.item + 1 + n)) {
        None => {
            let last = schedule.items.last().map_or(timeline.hold_end, |t| t.hold_end.0);
            (last, Some(schedule.retracted.0))
        }
        Some((Act::Rest(_), rest)) => (schedule.items[rest - 1].hold_end.0, Some(schedule.items[rest].stroke.0)),
        Some((Act::Sign(_) | Act::Hold(..) | Act::Captured(_), next)) => (schedule.items[next - 1].hold_end.0, None),
    };
    let spans = [
        (timeline.start, timeline.stroke, way),
        (timeline.stroke, stroke_end, "stroke"),
        (stroke_end, held, "hold"),
        (held, retracted.unwrap_or(held), "retraction"),
    ];
    for hand in &sign.hands {
        let tier = tiers.of(&format!("{} Phase", hand.side.hand()));
        for (start, end, label) in spans {
            if end > start && (label != "stroke" || sign.sign.intervals > 0) {
                tier.push(Seconds(start), Seconds(end), label, PROCEDURE);
            }
        }
    }
}

/// Values at keys as spans: each holds from its key to the next stated one.
fn keyed<T>(tier: &mut Tier, keys: &Keys<T>, timeline: &Timeline, label: fn(&T) -> String, source: &str) {
    let stated: Vec<(usize, &T)> = keys.iter().collect();
    for (i, (key, value)) in stated.iter().enumerate() {
        let at = |k: usize| timeline.keys.get(k).copied().unwrap_or(timeline.hold_end);
        let start = if i == 0 { timeline.stroke } else { at(*key) };
        let end = stated.get(i + 1).map_or(timeline.hold_end, |(next, _)| at(*next));
        tier.push(Seconds(start), Seconds(end), label(value), source);
    }
}
