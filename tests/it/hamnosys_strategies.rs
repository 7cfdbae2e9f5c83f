//! Random HamNoSys trees: everything that HamNoSys can write, and nothing that it cannot.

use chereme::notation::hamnosys::syntax::*;
use chereme::phonology::roll::Roll;
use chereme::phonology::{Digit, Direction, Size, WristMotion};
use proptest::collection::vec;
use proptest::option::{of, weighted};
use proptest::prelude::*;
use proptest::sample::{select, subsequence};

/// Whether a sign is of one hand: there a contact before a place is that of the hand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Handed {
    One,
    Two,
}

/// One to three phases.
pub fn phases() -> impl Strategy<Value = Vec<Phase>> {
    vec(phase(), 1..4)
}

/// A phase with a hand shape.
pub fn phase() -> impl Strategy<Value = Phase> {
    let one = (Just(Handed::One), prop_oneof![4 => Just(Hands::Strong), 1 => Just(Hands::Weak)]);
    let two = (Just(Handed::Two), symmetry().prop_map(Hands::Both));
    prop_oneof![one.boxed(), two.boxed()].prop_flat_map(|(handed, hands)| {
        let body = vec(of_body(actions(handed, 1)), 0..2);
        let posture = (split(shape()), of(split(fingers())), of(split(palm())));
        (any::<bool>(), body, posture, of(location(handed)), vec(actions(handed, 3), 0..4)).prop_map(
            move |(holds_over, body, (shape, fingers, palm), location, actions)| Phase {
                hands,
                holds_over,
                body,
                posture: Posture { shape: Some(shape), fingers, palm },
                location,
                actions,
                span: Ignored::default(),
            },
        )
    })
}

fn symmetry() -> impl Strategy<Value = Symmetry> {
    any::<[bool; 5]>().prop_map(|[left_right, up_down, out_in, alternating, non_ipsi]| Symmetry {
        left_right,
        up_down,
        out_in,
        alternating,
        non_ipsi,
    })
}

/// A value for both hands, or one each.
pub fn split<T: Clone + std::fmt::Debug>(
    value: impl Strategy<Value = T> + Clone + 'static,
) -> impl Strategy<Value = Split<T>> {
    let each = (weighted(0.8, value.clone()), weighted(0.8, value.clone()))
        .prop_filter("one hand at least", |(a, b)| a.is_some() || b.is_some())
        .prop_map(|(a, b)| Split::Each(a, b));
    prop_oneof![4 => value.prop_map(Split::Both), 1 => each]
}

/// One of the 26 directions.
pub fn direction() -> impl Strategy<Value = Direction> + Clone {
    select(Direction::all().collect::<Vec<_>>())
}

fn size() -> impl Strategy<Value = Size> + Clone {
    select(vec![Size::Small, Size::Normal, Size::Normal, Size::Large])
}

fn finger() -> impl Strategy<Value = Digit> + Clone {
    select(Digit::ALL[1..].to_vec())
}

fn digit() -> impl Strategy<Value = Digit> + Clone {
    select(Digit::ALL.to_vec())
}

fn part() -> impl Strategy<Value = FingerPart> + Clone {
    use FingerPart::*;
    select(vec![Tip, Nail, Pad, MidJoint, Base, Side])
}

fn bend() -> impl Strategy<Value = Bend> + Clone {
    use Bend::*;
    select(vec![Bent, Round, Hooked, DoubleBent, DoubleHooked])
}

fn class() -> impl Strategy<Value = BentClass> + Clone {
    (select(ShapeClass::ALL.to_vec()), of(select(vec![Thumb::Out, Thumb::Across, Thumb::Open])), of(bend()))
        .prop_map(|(class, thumb, bend)| BentClass { class, thumb, bend })
}

/// A hand shape.
pub fn shape() -> impl Strategy<Value = Shape> + Clone {
    let crossing = (digit(), part(), digit()).prop_filter("two digits", |(a, _, b)| a != b);
    let thumb = prop_oneof![
        (finger(), finger()).prop_map(|(a, b)| ThumbSpecial::Between(a, b)),
        Just(ThumbSpecial::Enclosed),
        Just(ThumbSpecial::Exempted),
        part().prop_map(ThumbSpecial::At),
    ];
    let fingers = prop_oneof![3 => Just(Vec::new()), 1 => subsequence(Digit::ALL[1..].to_vec(), 0..4).prop_shuffle()];
    let bent = prop_oneof![3 => Just(Vec::new()), 1 => subsequence(Digit::ALL.to_vec(), 0..4).prop_shuffle()];
    let bends = (weighted(0.2, bend()), bent, vec(bend(), 5));
    let few = prop_oneof![4 => Just(Vec::new()), 1 => vec(crossing, 0..3)];
    (class(), any::<bool>(), weighted(0.2, class()), fingers, bends, few, weighted(0.2, thumb)).prop_map(
        |(main, approximate, between, fingers, (of_index, bent, bends), crossings, thumb)| {
            let may = between.as_ref().unwrap_or(&main).bend.is_some();
            let index = of_index.filter(|_| may).map(|bend| (None, bend));
            Shape {
                main,
                approximate,
                between,
                fingers: fingers.into_iter().map(|finger| ListedFinger { finger, opposed: false }).collect(),
                bends: index.into_iter().chain(bent.into_iter().map(Some).zip(bends)).collect(),
                crossings,
                thumb,
                successive: None,
            }
        },
    )
}

fn fingers() -> impl Strategy<Value = Fingers> + Clone {
    (direction(), weighted(0.2, direction()), any::<bool>()).prop_map(|(direction, between, relative)| Fingers {
        direction,
        between,
        relative,
    })
}

fn roll() -> impl Strategy<Value = Roll> + Clone {
    select(Roll::all().collect::<Vec<_>>())
}

fn palm() -> impl Strategy<Value = Palm> + Clone {
    (roll(), weighted(0.2, roll()), any::<bool>(), any::<bool>()).prop_map(|(a, b, relative, approximate)| Palm {
        facing: Facing::Roll(a),
        between: b.map(Facing::Roll),
        relative,
        approximate,
    })
}

fn side() -> impl Strategy<Value = Option<Side>> + Clone {
    weighted(0.3, select(vec![Side::LeftBeside, Side::LeftAt, Side::RightAt, Side::RightBeside]))
}

fn face() -> impl Strategy<Value = Option<Face>> + Clone {
    weighted(0.2, select(vec![Face::Dorsal, Face::Palmar]))
}

/// Places of head, trunk and arms.
const BODY: [&str; 25] = [
    "head",
    "headtop",
    "forehead",
    "eyebrows",
    "eyes",
    "nose",
    "nostrils",
    "ear",
    "earlobe",
    "cheek",
    "lips",
    "tongue",
    "teeth",
    "chin",
    "underchin",
    "neck",
    "shouldertop",
    "shoulders",
    "chest",
    "stomach",
    "belowstomach",
    "upperarm",
    "elbow",
    "elbowinside",
    "lowerarm",
];

/// A place of body or arm.
pub fn body_level() -> impl Strategy<Value = BodyLevel> + Clone {
    (select(BODY.to_vec()), weighted(0.1, Just(())), side(), face()).prop_map(|(place, approximate, side, face)| {
        let arm = BODY[21..].contains(&place);
        let face = face.filter(|_| arm);
        BodyLevel { place: place.to_owned(), approximate: approximate.is_some(), side, face }
    })
}

fn body_levels() -> impl Strategy<Value = BodyLevels> + Clone {
    (body_level(), weighted(0.2, body_level())).prop_map(|(first, between)| BodyLevels { first, between })
}

fn hand_level(wholes: &'static [&'static str]) -> impl Strategy<Value = HandLevel> + Clone {
    let digits = (subsequence(Digit::ALL.to_vec(), 0..4).prop_shuffle(), of(part()))
        .prop_filter("something", |(digits, part)| !digits.is_empty() || part.is_some())
        .prop_map(|(digits, part)| HandPlace::Digits(digits, part));
    let place = prop_oneof![select(wholes.to_vec()).prop_map(|tag| HandPlace::Hand(tag.to_owned())), digits];
    (place, weighted(0.1, Just(())), side(), face()).prop_map(|(part, approximate, side, face)| HandLevel {
        part,
        approximate: approximate.is_some(),
        side,
        face,
    })
}

/// A part of a hand, which may also be a part of the arm.
pub fn hand_levels() -> impl Strategy<Value = HandLevels> + Clone {
    levels(&["wristback", "wristpulse", "thumbball", "palm", "handback", "thumbside", "pinkyside", "lowerarm", "elbow"])
}

fn levels(wholes: &'static [&'static str]) -> impl Strategy<Value = HandLevels> + Clone {
    (hand_level(wholes), weighted(0.15, hand_level(wholes))).prop_map(|(first, between)| HandLevels { first, between })
}

fn contact() -> impl Strategy<Value = Contact> + Clone {
    use Contact::*;
    select(vec![Touch, Close, Interlock, Cross, ArmExtended])
}

/// A place of one hand.
pub fn site() -> impl Strategy<Value = Site> + Clone {
    prop_oneof![3 => body_site(), 2 => hand_site()]
}

fn body_site() -> impl Strategy<Value = Site> + Clone {
    let near = || of((contact(), weighted(0.2, hand_levels())));
    let body = (weighted(0.8, body_levels()), any::<bool>(), near()).prop_map(|(level, behind, near)| Site::Body {
        behind: behind && level.is_some(),
        level,
        contact: near.as_ref().map(|n| n.0),
        with: near.and_then(|n| n.1),
    });
    prop_oneof![9 => body, 1 => name().prop_map(Site::Named)]
}

fn hand_site() -> impl Strategy<Value = Site> + Clone {
    let place = levels(&["wristback", "wristpulse", "thumbball", "palm", "handback", "thumbside", "pinkyside"]);
    let near = of((contact(), weighted(0.2, hand_levels())));
    (place, near).prop_map(|(level, near)| Site::Hand {
        level,
        contact: near.as_ref().map(|n| n.0),
        with: near.and_then(|n| n.1),
    })
}

fn name() -> impl Strategy<Value = String> + Clone {
    select(vec!["1", "2", "3", "4", "5"]).prop_map(str::to_owned)
}

/// Whether a site says no more than a part of hand or arm.
fn is_point(site: &Site) -> bool {
    match site {
        Site::Hand { contact, with, .. } => contact.is_none() && with.is_none(),
        Site::Body { level, behind, contact, with } => {
            let arm = |level: &BodyLevel| BODY[21..].contains(&level.place.as_str());
            let arms = level.as_ref().is_some_and(|l| arm(&l.first) && l.between.as_ref().is_none_or(arm));
            arms && !behind && contact.is_none() && with.is_none()
        }
        Site::Named(_) => false,
    }
}

fn location(handed: Handed) -> BoxedStrategy<Location> {
    let split = (weighted(0.8, site()), weighted(0.8, site()))
        .prop_filter("a place", |(a, b)| a.is_some() || b.is_some())
        .prop_filter("no constellation", |(a, b)| {
            !(a.as_ref().is_some_and(is_point) && b.as_ref().is_some_and(is_point))
        })
        .prop_map(|(a, b)| Location::Split(a, b));
    let pointed = ((hand_levels(), hand_levels()), of(contact()), of(body_site()))
        .prop_map(|(points, contact, at)| Constellation { points: Some(points), contact, at });
    let bare = (select(vec![Contact::Touch, Contact::Close, Contact::Interlock, Contact::Cross]), of(body_site()))
        .prop_map(move |(contact, at)| {
            // In a sign of one hand the contact would be that of the place.
            let at = at.filter(|_| handed == Handed::Two);
            Constellation { points: None, contact: Some(contact), at }
        });
    prop_oneof![
        5 => site().prop_map(Location::One),
        1 => split,
        1 => pointed.prop_map(Location::Constellation),
        1 => bare.prop_map(Location::Constellation),
    ]
    .boxed()
}

fn growth() -> impl Strategy<Value = Option<Growth>> + Clone {
    weighted(
        0.2,
        (select(vec![Change::Increasing, Change::Decreasing]), size())
            .prop_map(|(change, size)| Growth { change, size }),
    )
}

fn ellipse() -> impl Strategy<Value = Ellipse> + Clone {
    use Ellipse::*;
    select(vec![Horizontal, UpRight, Vertical, UpLeft])
}

fn waves() -> impl Strategy<Value = Option<Waves>> + Clone {
    let waves = (select(vec![WaveStyle::Zigzag, WaveStyle::Wavy]), size(), of(ellipse()));
    weighted(0.2, waves.prop_map(|(style, size, plane)| Waves { style, size, plane }))
}

fn times() -> impl Strategy<Value = Times> + Clone {
    select(vec![Times::Once, Times::Twice])
}

fn straight() -> impl Strategy<Value = Straight> {
    (direction(), size(), weighted(0.2, direction()), of((roll(), size())), waves(), growth()).prop_map(
        |(direction, size, between, arc, waves, growth)| Straight { direction, size, between, arc, waves, growth },
    )
}

fn circle() -> impl Strategy<Value = Circle> {
    let clock = || of((0u8..8).prop_map(|eighths| Clock::new(eighths).unwrap()));
    let ends = (clock(), of(times()), clock())
        .prop_filter("an end alone", |(start, full, end)| start.is_some() || full.is_some() || end.is_none());
    (direction(), size(), weighted(0.2, direction()), ends, of((ellipse(), size())), waves(), growth()).prop_map(
        |(axis, size, between, (start, full, end), ellipse, waves, growth)| Circle {
            axis,
            size,
            between,
            start,
            full,
            end,
            ellipse,
            waves,
            growth,
        },
    )
}

fn replacement() -> impl Strategy<Value = Posture> {
    let successive = weighted(0.1, select(vec![Successive::TowardPinky, Successive::TowardThumb]));
    (of(split(shape())), of(split(fingers())), of(split(palm())), successive).prop_map(
        |(mut shape, fingers, palm, successive)| {
            match &mut shape {
                Some(Split::Both(shape)) => shape.successive = successive,
                Some(Split::Each(a, b)) => a.iter_mut().chain(b).for_each(|shape| shape.successive = successive),
                None => {}
            }
            Posture { shape, fingers, palm }
        },
    )
}

fn motion() -> impl Strategy<Value = Motion> {
    prop_oneof![
        1 => Just(Motion::Nothing),
        4 => straight().prop_map(Motion::Straight),
        2 => circle().prop_map(Motion::Circle),
        2 => (select(WristMotion::ALL.to_vec()), size()).prop_map(|(wrist, size)| Motion::Wrist(wrist, size)),
        1 => subsequence(Digit::ALL.to_vec(), 0..4).prop_map(Motion::FingerPlay),
        3 => replacement().prop_map(Motion::Replace),
        1 => Just(Motion::Cross),
    ]
}

/// A movement with what may be said of it.
pub fn one_move() -> impl Strategy<Value = Move> {
    let manner = prop_oneof![3 => Just([false; 5]), 1 => any::<[bool; 5]>()];
    (motion(), manner, weighted(0.1, site()), weighted(0.1, name())).prop_map(
        |(motion, [fast, slow, tense, rest, halt], brushing, names)| {
            let plain = Move::of(motion);
            Move { fast, slow, tense, rest, halt, brushing, names, ..plain }
        },
    )
}

fn repetition() -> impl Strategy<Value = Repetition> {
    use RepetitionKind::*;
    let kind = || select(vec![FromStart, FromStartSeveral, Continue, ContinueSeveral, Reverse]);
    let shift = (direction(), size(), growth()).prop_map(|(direction, size, growth)| Shift { direction, size, growth });
    (kind(), weighted(0.2, kind()), any::<bool>(), growth(), weighted(0.2, shift))
        .prop_map(|(kind, second, approximate, growth, shift)| Repetition { kind, second, approximate, growth, shift })
}

fn of_body(action: BoxedStrategy<Action>) -> impl Strategy<Value = Action> {
    (body_level(), action).prop_map(|(level, action)| Action::OfBody(level, Box::new(action)))
}

/// An action that nests at most `depth` deep.
fn actions(handed: Handed, depth: u32) -> BoxedStrategy<Action> {
    let leaf = one_move().prop_map(|one| Action::Move(Box::new(one))).boxed();
    leaf.prop_recursive(depth, 12, 3, move |inner| {
        let some = || vec(inner.clone(), 2..4);
        let boxed = || inner.clone().prop_map(Box::new);
        // A side that does nothing is `None`.
        let side = || {
            let nothing = Action::Move(Box::new(Move::of(Motion::Nothing)));
            weighted(0.8, boxed()).prop_map(move |side| side.filter(|action| **action != nothing))
        };
        prop_oneof![
            3 => (boxed(), location(handed)).prop_map(|(action, place)| Action::Target(action, Box::new(place))),
            2 => some().prop_map(Action::Together),
            2 => some().prop_map(Action::Sequence),
            1 => some().prop_map(Action::Fused),
            2 => (side(), side()).prop_map(|(strong, weak)| Action::Split(strong, weak)),
            3 => (boxed(), repetition()).prop_map(|(action, repetition)| Action::Repeated(action, repetition)),
            1 => (boxed(), times()).prop_map(|(action, times)| Action::Alternating(action, times)),
            1 => of_body(boxed().prop_map(|b| *b).boxed()),
        ]
    })
    .boxed()
}
