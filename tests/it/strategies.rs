//! Random signs over the whole phonology, for laws: everything that can be meant and written.

use chereme::motion::curve::{Curve, Measure, Phase, Profile, Reference};
use chereme::notation::Vocabulary;
use chereme::phonology::operator::Operator;
use chereme::phonology::recombination::{Base, Recombination};
use chereme::phonology::*;
use chereme::time::Seconds;
use proptest::collection::vec;
use proptest::option::of;
use proptest::prelude::*;
use proptest::sample::select;
use std::collections::BTreeSet;

/// Which names a sign uses.
#[derive(Debug, Clone)]
pub struct Words {
    handshapes: Vec<String>,
    places: Vec<String>,
    nonmanuals: Vec<(Channel, Vec<String>)>,
}

impl Words {
    /// Only names of the program's inventories: signs that synthesis understands.
    pub fn known() -> Words {
        let vocabulary = Vocabulary::builtin();
        let nonmanuals = vocabulary.nonmanuals.iter().map(|(c, n)| (*c, n.ids().map(str::to_owned).collect()));
        Words {
            handshapes: vocabulary.handshapes.ids().map(str::to_owned).collect(),
            places: vocabulary.places.ids().map(str::to_owned).collect(),
            nonmanuals: nonmanuals.collect(),
        }
    }

    /// Also names that are hard to write: reserved words, marks, quotes, spaces.
    pub fn any() -> Words {
        let hard = [
            "then", "at", "between", "a  b", "", "left", "#", "LSF S", "\"", "É è", "to", "strong", "(x)", "12cm",
            "“x”", "60%", "while", "speed", "beside", "named",
        ];
        let add = |names: Vec<String>| names.into_iter().take(20).chain(hard.map(str::to_owned)).collect::<Vec<_>>();
        let known = Words::known();
        Words {
            handshapes: add(known.handshapes),
            places: add(known.places),
            nonmanuals: known.nonmanuals.into_iter().map(|(c, names)| (c, add(names))).collect(),
        }
    }
}

fn metres() -> impl Strategy<Value = f64> {
    prop_oneof![3 => (1u32..200).prop_map(|cm| f64::from(cm) / 100.0), 1 => 0.001f64..3.0]
}

/// One of the 26 directions.
pub fn direction() -> impl Strategy<Value = Direction> {
    select(Direction::all().collect::<Vec<_>>())
}

/// A direction, or the middle of two.
pub fn heading() -> impl Strategy<Value = Heading> {
    let between = (direction(), direction())
        .prop_filter("opposite", |(a, b)| *a != b.opposite())
        .prop_map(|(a, b)| Heading::Between(a, b));
    prop_oneof![4 => direction().prop_map(Heading::Toward), 1 => between]
}

fn digits() -> impl Strategy<Value = Digits> {
    vec(select(Digit::ALL.to_vec()), 0..5).prop_map(Digits::of)
}

/// A point of a hand or an arm, or halfway between two.
pub fn hand_point() -> impl Strategy<Value = HandPoint> {
    (spot(), proptest::option::weighted(0.2, spot())).prop_map(|(first, second)| match second {
        Some(second) => first.halfway(second),
        None => first,
    })
}

fn spot() -> impl Strategy<Value = HandPoint> {
    let flank = || of(select(Flank::ALL.to_vec()));
    let on_digit = (digits(), select(HandPart::OF_A_DIGIT.to_vec()), flank());
    let on_limb =
        (Just(Digits::NONE), select(HandPart::all().filter(|p| !p.needs_digit()).collect::<Vec<_>>()), flank());
    prop_oneof![on_digit, on_limb].prop_filter_map("a finger", |(d, part, flank)| HandPoint::new(d, part, flank))
}

fn some_digits() -> impl Strategy<Value = Digits> {
    vec(select(Digit::ALL.to_vec()), 1..5).prop_map(Digits::of)
}

fn change() -> impl Strategy<Value = HandshapeChange> {
    let two = (select(Digit::ALL.to_vec()), select(Digit::ALL.to_vec()));
    let apart = two.clone().prop_filter("two", |(a, b)| a != b);
    let part = || select(HandPart::OF_A_DIGIT.to_vec());
    prop_oneof![
        select(ThumbPosition::ALL.to_vec()).prop_map(HandshapeChange::Thumb),
        (digits(), select(Bend::ALL.to_vec())).prop_map(|(d, b)| HandshapeChange::Bend(d, b)),
        any::<bool>().prop_map(HandshapeChange::Spread),
        apart.clone().prop_map(|(a, b)| HandshapeChange::Cross(a, b)),
        two.prop_map(|(a, b)| HandshapeChange::ThumbBetween(a, b)),
        some_digits().prop_map(HandshapeChange::On),
        some_digits().prop_map(HandshapeChange::Except),
        select(Opening::ALL.to_vec()).prop_map(HandshapeChange::Opening),
        (apart, part()).prop_map(|((a, b), part)| HandshapeChange::Meet(a, part, b)),
        part().prop_map(HandshapeChange::ThumbAt),
        (digits(), [0u8..=4, 0u8..=4, 0u8..=4]).prop_map(|(d, bends)| HandshapeChange::Joints(d, bends)),
    ]
}

/// A handshape with changes.
pub fn configuration(words: &Words) -> impl Strategy<Value = Configuration> + use<> {
    let names = select(words.handshapes.clone());
    let changes = || vec(change(), 0..3);
    let between = (names.clone(), changes(), changes())
        .prop_map(|(second, first, changes)| Box::new(Between { first, second, changes }));
    (names, of(between), changes()).prop_map(|(base, between, changes)| Configuration { base, between, changes })
}

fn lateral() -> impl Strategy<Value = Lateral> {
    (select(vec![Side::Left, Side::Right]), any::<bool>()).prop_map(|(side, beside)| Lateral { side, beside })
}

fn place(words: &Words) -> impl Strategy<Value = Place> + use<> {
    let axis = || -1i8..=1;
    let leaf = prop_oneof![
        4 => select(words.places.clone()).prop_map(Place::Body),
        2 => hand_point().prop_map(Place::OtherHand),
        2 => (axis(), axis(), axis()).prop_map(|(left, high, far)| Place::Space(Space { left, high, far })),
        1 => [-9.9f64..9.9, -9.9f64..9.9, -9.9f64..9.9].prop_map(|p| Place::Point(glam::DVec3::from_array(p))),
        1 => "[A-Za-z \"\\\\#é]{0,6}".prop_map(Place::Referent),
    ];
    leaf.prop_recursive(3, 8, 2, |inner| {
        prop_oneof![
            2 => ((inner.clone(), of(lateral())), (inner.clone(), of(lateral()))).prop_map(|(a, b)| {
                let sited = |(place, lateral)| Box::new(Sited { place, lateral });
                Place::Between(sited(a), sited(b))
            }),
            1 => inner.prop_map(|at| Place::Towards(Box::new(at))),
        ]
    })
}

/// A placement.
pub fn placement(words: &Words) -> impl Strategy<Value = Placement> + use<> {
    let distance = prop_oneof![
        Just(Distance::Unmarked),
        Just(Distance::Touch),
        Just(Distance::Close),
        Just(Distance::Neutral),
        Just(Distance::Extended),
        (0.0f64..3.0).prop_map(Distance::Metres),
        metres().prop_map(Distance::Metres),
    ];
    (place(words), of(lateral()), distance, any::<bool>(), of(hand_point()), of((direction(), metres()))).prop_map(
        |(place, lateral, distance, behind, with, offset)| Placement { place, lateral, distance, behind, with, offset },
    )
}

/// An orientation whose palm does not face along its fingers.
pub fn orientation() -> impl Strategy<Value = Orientation> {
    (of(heading()), of(heading()), any::<bool>())
        .prop_map(|(fingers, palm, along_path)| Orientation { fingers, palm, along_path })
        .prop_filter("something is said", |o| o.fingers.is_some() || o.palm.is_some() || o.along_path)
}

fn size() -> impl Strategy<Value = Size> {
    select(vec![Size::Small, Size::Normal, Size::Large])
}

fn extent() -> impl Strategy<Value = Extent> {
    prop_oneof![size().prop_map(Extent::Size), metres().prop_map(Extent::Metres)]
}

fn overlay() -> impl Strategy<Value = Option<Overlay>> {
    let overlay = (any::<bool>(), size(), of(direction()), -9i8..=9)
        .prop_map(|(zigzag, size, across, growth)| Overlay { zigzag, size, across, growth });
    of(overlay)
}

fn across(a: glam::DVec3, b: glam::DVec3) -> bool {
    a.cross(b).length() >= 0.21
}

fn motion(interval: usize) -> impl Strategy<Value = Motion> {
    let arc = (heading(), extent(), heading(), size(), overlay())
        .prop_filter("a bulge", |(d, _, b, ..)| across(d.vector(), b.vector()))
        .prop_map(|(direction, extent, bulge, depth, overlay)| Motion::Arc {
            direction,
            extent,
            bulge,
            depth,
            overlay,
        });
    let ellipse = of((0.01f64..0.99, direction()));
    let circle = (heading(), extent(), 0u8..8, 0.1f64..9.0, ellipse, -9i8..=9, overlay())
        .prop_filter("an ellipse", |(axis, _, _, _, e, ..)| e.is_none_or(|(_, d)| across(d.vector(), axis.vector())))
        .prop_map(|(axis, extent, start, turns, ellipse, growth, overlay)| Motion::Circle {
            axis,
            extent,
            start: Clock::new(start).unwrap(),
            turns,
            ellipse,
            growth,
            overlay,
        });
    prop_oneof![
        Just(Motion::Hold),
        Just(Motion::Change),
        (0..=interval).prop_map(|key| Motion::Return { key }),
        (heading(), extent(), overlay()).prop_map(|(direction, extent, overlay)| Motion::Straight {
            direction,
            extent,
            overlay
        }),
        arc,
        circle,
        (select(WristMotion::ALL.to_vec()), size()).prop_map(|(w, s)| Motion::Wrist(w, s)),
        digits().prop_map(Motion::Wiggle),
    ]
}

fn repetition() -> impl Strategy<Value = Repetition> {
    let kinds = vec![RepetitionKind::FromStart, RepetitionKind::Continue, RepetitionKind::ToAndFro];
    let shift = of((direction(), size()).prop_map(|(direction, size)| Shift { direction, size }));
    (select(kinds), 1u8..=50, -9i8..=9, shift).prop_map(|(kind, times, growth, shift)| {
        // There and back once; else performed at least twice.
        let times = if kind == RepetitionKind::ToAndFro { times } else { times.max(2) };
        Repetition { kind, times, growth, shift }
    })
}

fn becoming(words: &Words) -> impl Strategy<Value = Becoming> + use<> {
    let orientation = orientation().prop_filter("a palm", |o| palms_can_be(&Keys::one(*o)));
    (of(configuration(words)), of(orientation), of(contact()))
        .prop_map(|(configuration, orientation, contact)| Becoming { configuration, orientation, contact })
        .prop_filter("something is said", |b| !b.is_empty())
}

fn pace() -> impl Strategy<Value = f64> {
    prop_oneof![6 => Just(1.0), 1 => 0.05f64..20.0]
}

/// A movement of one interval; ways back go to keys up to `interval`.
fn movement(words: &Words, interval: usize) -> impl Strategy<Value = Movement> + use<> {
    let manner = proptest::sample::subsequence(Manner::ALL.to_vec(), 0..=3);
    let posture = proptest::option::weighted(0.2, becoming(words).prop_map(Box::new));
    let more = (pace(), posture, proptest::option::weighted(0.1, text()));
    let action = (
        motion(interval),
        of(placement(words)),
        proptest::option::weighted(0.1, placement(words)),
        manner,
        of(repetition()),
        of(0.01f64..60.0),
        any::<bool>(),
        more,
    );
    let leaf = action.prop_map(|(motion, target, brushing, manner, repetition, duration, alternating, more)| {
        let (pace, becoming, names) = more;
        let duration = duration.map(Seconds);
        let target = target.filter(|_| !matches!(motion, Motion::Return { .. }));
        Movement::Action(Box::new(Action {
            target,
            brushing,
            manner,
            repetition,
            duration,
            alternating,
            pace,
            becoming,
            names,
            ..Action::new(motion)
        }))
    });
    leaf.prop_recursive(2, 6, 3, |inner| {
        let (parts, back) = (vec(inner.clone(), 2..4), inner);
        prop_oneof![
            parts.clone().prop_map(Movement::Sequence),
            parts.clone().prop_map(Movement::Together),
            parts.prop_map(Movement::Fused),
            back.clone().prop_map(|m| Movement::Backwards(Box::new(m))),
            (back, repetition(), any::<bool>()).prop_map(|(movement, repetition, alternating)| {
                let repetition = Repetition { times: repetition.times.min(5), ..repetition };
                Movement::Repeated(Box::new(Repeated { movement, repetition, alternating }))
            }),
        ]
    })
}

/// Values at some of the keys of a sign.
fn keys<T: std::fmt::Debug + Clone + 'static>(
    value: impl Strategy<Value = T> + 'static,
    intervals: usize,
) -> impl Strategy<Value = Keys<T>> {
    vec(proptest::option::weighted(0.5, value), intervals + 1).prop_map(|all| {
        let stated = all.into_iter().enumerate().filter_map(|(k, v)| Some((k, v?))).collect();
        Keys::new(stated).unwrap()
    })
}

fn manual(words: &Words, intervals: usize, moves: bool) -> impl Strategy<Value = Manual> + use<> {
    let count = if moves { intervals } else { 0 };
    (
        keys(configuration(words), intervals),
        keys(placement(words), intervals),
        keys(orientation(), intervals).prop_filter("a palm", palms_can_be),
        (0..count).map(|i| movement(words, i.min(count - 1 - i)).boxed()).collect::<Vec<_>>(),
    )
        .prop_map(|(configuration, placement, orientation, movement)| Manual {
            configuration,
            placement,
            orientation,
            movement,
        })
}

/// No palm faces along the fingers, those of the keys before included.
fn palms_can_be(keys: &Keys<Orientation>) -> bool {
    let (mut fingers, mut palm) = (None, None);
    keys.iter().all(|(_, o)| {
        fingers = o.fingers.or(fingers);
        palm = o.palm.or(palm);
        match (fingers, palm) {
            (Some(f), Some(p)) => f.vector().cross(p.vector()).length() > 0.11,
            _ => true,
        }
    })
}

fn symmetry() -> impl Strategy<Value = Symmetry> {
    (any::<bool>(), any::<[bool; 4]>()).prop_map(|(mirrored, [up_down, out_in, alternating, crossed])| Symmetry {
        relation: if mirrored { Relation::Mirrored } else { Relation::Parallel },
        up_down,
        out_in,
        alternating,
        crossed,
    })
}

fn contact() -> impl Strategy<Value = Contact> {
    let kind = prop_oneof![select(ContactKind::NAMED.to_vec()), (0.0f64..3.0).prop_map(ContactKind::Metres),];
    (hand_point(), hand_point(), kind).prop_map(|(strong, weak, kind)| Contact {
        strong: Some(strong),
        weak: Some(weak),
        kind,
    })
}

fn attested(words: &Words) -> impl Strategy<Value = Attested> + use<> {
    (configuration(words), vec(("[a-z]{2}", text()), 0..3))
        .prop_map(|(configuration, meaning)| Attested { configuration, meaning })
}

fn relocation(words: &Words) -> impl Strategy<Value = Relocation> + use<> {
    let place = place(words).prop_filter("a place", |p| !matches!(p, Place::Towards(_)));
    (place, select(vec![Forced::No, Forced::Yes])).prop_map(|(place, forced)| Relocation { place, forced })
}

fn nonmanual(words: &Words, channel: Channel) -> impl Strategy<Value = NonManual> + use<> {
    let names = words.nonmanuals.iter().find(|(c, _)| *c == channel).map(|(_, n)| n.clone()).unwrap_or_default();
    let names = if names.is_empty() { vec!["x".to_owned()] } else { names };
    let value = prop_oneof![
        3 => select(names).prop_map(NonManualValue::Named),
        1 => heading().prop_map(NonManualValue::Towards),
        1 => placement(words).prop_map(NonManualValue::At),
        1 => "[a-zA-Z@:\"\\\\]{0,6}".prop_map(NonManualValue::Mouthing),
    ];
    let amount = || prop_oneof![Just(Amount::Plain), (0.01f64..3.0).prop_map(Amount::of), Just(Amount::Strong)];
    let leaf = (value, amount(), pace()).prop_map(|(value, amount, pace)| NonManual { value, amount, pace });
    leaf.prop_recursive(2, 6, 3, move |inner| {
        let parts = vec(inner, 2..4);
        let group =
            prop_oneof![parts.clone().prop_map(NonManualValue::Sequence), parts.prop_map(NonManualValue::Together)];
        (group, amount(), pace()).prop_map(|(value, amount, pace)| NonManual { value, amount, pace })
    })
}

fn nonmanuals(words: &Words, intervals: usize) -> impl Strategy<Value = Vec<(Channel, Keys<NonManual>)>> + use<> {
    let words = words.clone();
    proptest::sample::subsequence(Channel::ALL.to_vec(), 0..=3).prop_flat_map(move |channels| {
        channels
            .into_iter()
            .map(|c| {
                keys(nonmanual(&words, c), intervals).prop_filter("said", |k| !k.is_empty()).prop_map(move |k| (c, k))
            })
            .collect::<Vec<_>>()
    })
}

fn text() -> impl Strategy<Value = String> {
    prop_oneof!["[ -~é“”\t\n\\\\\"]{0,12}", any::<String>()]
}

/// What a phase says: hands, manual tiers, contact, time. A sign with intervals has a movement of a hand that acts.
fn phase(words: &Words) -> impl Strategy<Value = Sign> + use<> {
    let hands = prop_oneof![
        Just(Hands::Strong),
        Just(Hands::Weak),
        Just(Hands::Both(None)),
        symmetry().prop_map(|s| Hands::Both(Some(s))),
    ];
    let words = words.clone();
    (hands, 0usize..5, any::<(bool, bool)>()).prop_flat_map(move |(hands, intervals, (strong_moves, weak_moves))| {
        let (acts_strong, acts_weak) = match hands {
            Hands::Strong => (true, false),
            Hands::Weak => (false, true),
            Hands::Both(_) => (true, true),
        };
        let empty = || Just(Manual::default()).boxed();
        // One of them moves, where there is an interval.
        let strong_moves = strong_moves || !weak_moves || !acts_weak;
        let strong = if acts_strong { manual(&words, intervals, strong_moves).boxed() } else { empty() };
        let weak_moves = weak_moves || !acts_strong;
        let weak = if acts_weak { manual(&words, intervals, weak_moves).boxed() } else { empty() };
        let contact = match hands {
            Hands::Both(_) => keys(contact(), intervals).boxed(),
            Hands::Strong | Hands::Weak => Just(Keys::default()).boxed(),
        };
        (strong, weak, contact, of(0.01f64..60.0), pace()).prop_map(move |(strong, weak, contact, duration, speed)| {
            let duration = duration.map(Seconds);
            Sign { hands, intervals, strong, weak, contact, duration, speed, ..Sign::named("") }
        })
    })
}

/// A whole sign in the form that reading gives; some have several phases.
pub fn sign(words: Words) -> impl Strategy<Value = Sign> {
    let name = prop_oneof!["[A-ZÉÈ][A-Z0-9-]{0,8}", "[A-Z#=(]{1,3}( [a-z,]{1,4})?"];
    let header = (
        name,
        prop_oneof![Just(String::new()), "[a-z]{3}"],
        vec(("[a-z]{2}", text()), 0..3),
        of(text()),
        of(text()),
        of(text()),
        vec(attested(&words), 0..3),
        of(relocation(&words)),
    );
    let later = (phase(&words), any::<bool>()).prop_map(|(phase, holds_over)| Sign { holds_over, ..phase });
    let then = prop_oneof![3 => Just(Vec::new()), 1 => vec(later, 1..3)];
    let first = phase(&words).prop_flat_map(move |first| {
        let faces = nonmanuals(&words, first.intervals);
        (Just(first), faces).prop_map(|(first, nonmanual)| Sign { nonmanual, ..first })
    });
    (header, first, then).prop_map(|(header, first, then)| {
        let (name, language, meaning, source, status, note, base, relocated) = header;
        Sign { name, language, meaning, source, status, note, base, relocated, then, ..first }
    })
}

/// A kinematic profile of random points, with phases that may touch, overlap or lie outside.
pub fn profile() -> impl Strategy<Value = Profile> {
    let curve = ("[A-Za-zÉ,\" ;]{1,8}", 0..Reference::ALL.len(), 0..Measure::ALL.len());
    let phase = ("[a-zé,]{0,4}", 0..30u32, 0..30u32);
    let parts = (1..20usize, prop::collection::vec(curve, 0..4), prop::collection::vec(phase, 0..4), 0..1000u64);
    parts.prop_map(|(rows, curves, phases, seed)| {
        let mut names = BTreeSet::new();
        let value = |i: usize, k: usize| ((i * 37 + k * 11) as f64 * (seed as f64 + 0.7)).sin() * 3.0;
        let curves = curves.into_iter().enumerate().filter_map(|(k, (point, reference, measure))| {
            let (reference, measure) = (Reference::ALL[reference], Measure::ALL[measure]);
            let values = (0..rows).map(|i| value(i, k)).collect();
            names.insert((point.clone(), reference, measure)).then_some(Curve { point, reference, measure, values })
        });
        let times = (0..rows).map(|i| Seconds(i as f64 / 30.0)).collect();
        let phases = phases.into_iter().map(|(name, start, length)| {
            let start = f64::from(start) / 40.0;
            Phase { name, start: Seconds(start), end: Seconds(start + f64::from(length) / 40.0) }
        });
        Profile::new(times, curves.collect()).unwrap().with_phases(phases.collect())
    })
}

fn few<T: std::fmt::Debug + Clone + 'static>(
    value: impl Strategy<Value = T> + 'static,
) -> impl Strategy<Value = Keys<T>> {
    vec(value, 1..4).prop_map(|all| Keys::new(all.into_iter().enumerate().collect()).unwrap())
}

/// An operator on signs.
pub fn operator(words: &Words) -> impl Strategy<Value = Operator> + use<> {
    let hand = || of(select(vec![Hand::Strong, Hand::Weak]));
    let gap = of(0.01f64..60.0).prop_map(|s| s.map(Seconds));
    let faces = {
        let words = words.clone();
        select(Channel::ALL.to_vec()).prop_flat_map(move |c| (Just(c), few(nonmanual(&words, c))))
    };
    let moves = {
        let words = words.clone();
        (1usize..4).prop_flat_map(move |n| vec(movement(&words, 0), n))
    };
    let orientations = few(orientation()).prop_filter("a palm", palms_can_be);
    prop_oneof![
        select(vec![
            Operator::Inverted,
            Operator::InvertedMovement,
            Operator::Mirrored,
            Operator::Swapped,
            Operator::Reflected
        ]),
        (2u8..=50, gap, -9i8..=9).prop_map(|(times, gap, growth)| Operator::Repeated { times, gap, growth }),
        (hand(), few(configuration(words))).prop_map(|(h, v)| Operator::Configuration(h, v)),
        (hand(), orientations).prop_map(|(h, v)| Operator::Orientation(h, v)),
        (hand(), few(placement(words))).prop_map(|(h, v)| Operator::Placement(h, v)),
        (hand(), moves).prop_map(|(h, v)| Operator::Movement(h, v)),
        faces.prop_map(|(c, v)| Operator::NonManual(c, v)),
        relocation(words).prop_map(Operator::At),
        prop_oneof![Just(1.4), Just(0.7), 0.05f64..20.0].prop_map(Operator::Speed),
        prop_oneof![Just(1.4), Just(0.7), 0.1f64..5.0].prop_map(Operator::Size),
    ]
}

/// A sign made from others.
pub fn recombination(words: Words) -> impl Strategy<Value = Recombination> {
    let place_of = place(&words).prop_filter("a place", |p| !matches!(p, Place::Towards(_)));
    let base = prop_oneof![
        4 => "[A-ZÉ][A-Z-]{0,5}|then|&|spelled|wrist|a b".prop_map(Base::Named),
        1 => "[A-Z]{1,4}".prop_map(Base::Spelled),
        1 => place_of.prop_map(Base::Pointing),
        1 => [-9.9f64..9.9, -9.9f64..9.9, -9.9f64..9.9].prop_map(|p| Base::WristAt(glam::DVec3::from_array(p))),
    ];
    let operators = vec(operator(&words).boxed(), 0..3);
    let leaf = (base, operators.clone()).prop_map(|(base, operators)| Recombination { base, operators });
    leaf.prop_recursive(2, 6, 3, move |inner| {
        let joined = prop_oneof![
            vec(inner.clone(), 2..4).prop_map(Base::Chain),
            (inner.clone(), inner).prop_map(|(a, b)| Base::Hands(Box::new(a), Box::new(b))),
        ];
        (joined, operators.clone()).prop_map(|(base, operators)| Recombination { base, operators })
    })
}
