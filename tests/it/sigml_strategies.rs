//! Random trees of what gestural SiGML can say, each value in the one form that reading comes to.

use chereme::notation::hamnosys::syntax::*;
use chereme::phonology::roll::Roll;
use chereme::phonology::{Digit, Direction, Size, WristMotion};
use proptest::collection::vec;
use proptest::option::of;
use proptest::prelude::*;
use proptest::sample::{select, subsequence};

/// A sign.
pub fn sign() -> impl Strategy<Value = Sign> {
    (of(text()), (number(), number(), number()), vec(tier(), 0..3), vec(phase(), 0..3)).prop_map(
        |(gloss, (speed, duration, timescale), nonmanual, phases)| Sign {
            gloss,
            timing: Timing { speed, duration, timescale },
            nonmanual,
            phases,
            span: Ignored::default(),
        },
    )
}

/// Any characters that XML can hold.
fn text() -> impl Strategy<Value = String> {
    prop_oneof![Just(String::new()), "[ -~\t\n\ré”\u{E000}]{0,8}"]
}

fn number() -> impl Strategy<Value = Option<f64>> {
    of(prop_oneof![0.001f64..100.0, Just(1.0), Just(1e-7), Just(1e300)])
}

fn direction() -> impl Strategy<Value = Direction> {
    select(Direction::all().collect::<Vec<_>>())
}

fn size() -> impl Strategy<Value = Size> {
    select(vec![Size::Small, Size::Normal, Size::Large])
}

fn roll() -> impl Strategy<Value = Roll> {
    select(Roll::all().collect::<Vec<_>>())
}

/// Digits in any order, each once.
fn digits(of: &'static [Digit], count: std::ops::RangeInclusive<usize>) -> impl Strategy<Value = Vec<Digit>> {
    subsequence(of, count).prop_shuffle()
}

fn pair() -> impl Strategy<Value = (Digit, Digit)> {
    digits(&Digit::ALL, 2..=2).prop_map(|two| (two[0], two[1]))
}

// Non-manuals -------------------------------------------------------------------------------------------------------

fn tier() -> BoxedStrategy<Tier> {
    use TierKind::*;
    let kind = select(vec![Shoulder, Body, Head, EyeGaze, FacialExpression, Mouthing, Extra]);
    let one = feature().prop_map(Cue::One);
    let cue = one.prop_recursive(3, 8, 3, |inner| {
        prop_oneof![vec(inner.clone(), 0..3).prop_map(Cue::Together), vec(inner, 0..3).prop_map(Cue::Sequence)]
    });
    (kind, vec(cue, 0..3)).prop_map(|(kind, cues)| Tier { kind, cues }).boxed()
}

fn feature() -> impl Strategy<Value = Feature> {
    use FeatureKind::*;
    let kind = select(vec![Shoulder, Body, Head, EyeGaze, EyeBrows, EyeLids, Nose, MouthGesture, MouthPicture, Extra]);
    (kind, text(), of(0.0f64..2.0), number()).prop_map(|(kind, value, amount, speed)| Feature {
        kind,
        value,
        amount,
        speed,
        span: Ignored::default(),
    })
}

// Postures ----------------------------------------------------------------------------------------------------------

fn phase() -> BoxedStrategy<Phase> {
    let flags = (any::<bool>(), any::<bool>(), any::<bool>(), any::<bool>(), any::<bool>());
    let symmetry = flags.prop_map(|(left_right, up_down, out_in, alternating, non_ipsi)| {
        Hands::Both(Symmetry { left_right, up_down, out_in, alternating, non_ipsi })
    });
    let hands = prop_oneof![Just(Hands::Strong), Just(Hands::Weak), symmetry];
    let body = vec((body_level(), action()).prop_map(|(part, action)| Action::OfBody(part, Box::new(action))), 0..2);
    (hands, any::<bool>(), body, posture(), of(location()), vec(action(), 0..3))
        .prop_map(|(hands, holds_over, body, posture, location, actions)| Phase {
            hands,
            holds_over,
            body,
            posture,
            location,
            actions,
            span: Ignored::default(),
        })
        .boxed()
}

fn split<T: std::fmt::Debug + Clone>(value: impl Strategy<Value = T> + Clone) -> impl Strategy<Value = Split<T>> {
    prop_oneof![
        value.clone().prop_map(Split::Both),
        (value.clone(), of(value.clone())).prop_map(|(strong, weak)| Split::Each(Some(strong), weak)),
        value.prop_map(|weak| Split::Each(None, Some(weak))),
    ]
}

fn posture() -> BoxedStrategy<Posture> {
    let shape = split(shape().boxed());
    (of(shape), of(split(fingers().boxed())), of(split(palm().boxed())))
        .prop_map(|(shape, fingers, palm)| Posture { shape, fingers, palm })
        .boxed()
}

fn bend() -> impl Strategy<Value = Bend> {
    use Bend::*;
    prop_oneof![
        select(vec![Bent, Round, Hooked, DoubleBent, DoubleHooked, HalfBent]),
        [0u8..=4, 0u8..=4, 0u8..=4].prop_map(Quarters)
    ]
}

fn class() -> impl Strategy<Value = BentClass> {
    let class = select(ShapeClass::ALL.to_vec());
    let thumb = of(select(vec![Thumb::Out, Thumb::Across, Thumb::Open]));
    (class, thumb, of(bend())).prop_map(|(class, thumb, bend)| BentClass { class, thumb, bend })
}

fn part() -> impl Strategy<Value = FingerPart> {
    use FingerPart::*;
    select(vec![Tip, Nail, Pad, MidJoint, Base, Side])
}

fn shape() -> BoxedStrategy<Shape> {
    let fingers = digits(&Digit::FINGERS, 0..=4).prop_flat_map(|fingers| {
        let count = fingers.len();
        (Just(fingers), vec(any::<bool>(), count))
    });
    let fingers = fingers.prop_map(|(fingers, opposed)| {
        fingers.into_iter().zip(opposed).map(|(finger, opposed)| ListedFinger { finger, opposed }).collect::<Vec<_>>()
    });
    let bends = digits(&Digit::ALL, 0..=3).prop_flat_map(|digits| {
        let count = digits.len();
        (Just(digits), vec(bend(), count))
    });
    let bends = bends.prop_map(|(digits, bends)| digits.into_iter().map(Some).zip(bends).collect::<Vec<_>>());
    let crossings = vec((pair(), part()).prop_map(|((a, b), part)| (a, part, b)), 0..3);
    let thumb = of(prop_oneof![
        pair().prop_map(|(a, b)| ThumbSpecial::Between(a, b)),
        Just(ThumbSpecial::Enclosed),
        Just(ThumbSpecial::Exempted),
        part().prop_map(ThumbSpecial::At),
    ]);
    let successive = of(select(vec![Successive::TowardPinky, Successive::TowardThumb]));
    (class(), any::<bool>(), of(class()), fingers, bends, crossings, thumb, successive)
        .prop_map(|(main, approximate, between, fingers, bends, crossings, thumb, successive)| Shape {
            main,
            approximate,
            between,
            fingers,
            bends,
            crossings,
            thumb,
            successive,
        })
        .boxed()
}

fn fingers() -> impl Strategy<Value = Fingers> {
    (direction(), of(direction()), any::<bool>()).prop_map(|(direction, between, relative)| Fingers {
        direction,
        between,
        relative,
    })
}

/// Both ends are symbols or both are directions: the other is an error of the writer.
fn palm() -> impl Strategy<Value = Palm> {
    let symbols = (roll(), of(roll())).prop_map(|(a, b)| (Facing::Roll(a), b.map(Facing::Roll)));
    let toward = (direction(), of(direction())).prop_map(|(a, b)| (Facing::Toward(a), b.map(Facing::Toward)));
    (prop_oneof![symbols, toward], any::<bool>(), any::<bool>())
        .prop_map(|((facing, between), relative, approximate)| Palm { facing, between, relative, approximate })
}

// Places ------------------------------------------------------------------------------------------------------------

fn flank() -> impl Strategy<Value = (Option<Side>, Option<Face>)> {
    let side = select(vec![Side::LeftBeside, Side::LeftAt, Side::RightAt, Side::RightBeside]);
    let face = select(vec![Face::Dorsal, Face::Palmar]);
    prop_oneof![Just((None, None)), side.prop_map(|side| (Some(side), None)), face.prop_map(|face| (None, Some(face)))]
}

fn body_level() -> BoxedStrategy<BodyLevel> {
    let place = select(vec!["head", "chin", "shoulders", "belowstomach", "lowerarm", "elbowinside", "lowereyelid"]);
    (place, any::<bool>(), flank())
        .prop_map(|(place, approximate, (side, face))| BodyLevel { place: place.to_owned(), approximate, side, face })
        .boxed()
}

fn hand_level() -> impl Strategy<Value = HandLevel> {
    let hand = select(vec!["palm", "handback", "thumbball", "wristback", "lowerarm"]);
    let part = prop_oneof![
        hand.prop_map(|place| HandPlace::Hand(place.to_owned())),
        (digits(&Digit::ALL, 0..=5), of(part())).prop_map(|(digits, part)| HandPlace::Digits(digits, part)),
    ];
    (part, any::<bool>(), flank()).prop_map(|(part, approximate, (side, face))| HandLevel {
        part,
        approximate,
        side,
        face,
    })
}

fn hand_levels() -> BoxedStrategy<HandLevels> {
    let says = |level: &HandLevel| {
        level.part != HandPlace::Digits(Vec::new(), None) || level.side.is_some() || level.face.is_some()
    };
    let second = hand_level().prop_map(|level| HandLevel { approximate: false, ..level });
    (hand_level(), of(second.prop_filter("a place that is named", says)))
        .prop_map(|(first, between)| HandLevels { first, between })
        .boxed()
}

fn contact() -> impl Strategy<Value = Option<Contact>> {
    of(select(vec![Contact::Touch, Contact::Close, Contact::Interlock, Contact::Cross, Contact::ArmExtended]))
}

fn body_site() -> BoxedStrategy<Site> {
    let second = body_level().prop_map(|level| BodyLevel { approximate: false, ..level });
    let levels = (body_level(), of(second)).prop_map(|(first, between)| BodyLevels { first, between });
    (of(levels), any::<bool>(), contact(), of(hand_levels()))
        .prop_map(|(level, behind, contact, with)| Site::Body { level, behind, contact, with })
        .boxed()
}

fn site() -> BoxedStrategy<Site> {
    let hand = (hand_levels(), contact(), of(hand_levels())).prop_map(|(level, contact, with)| Site::Hand {
        level,
        contact,
        with,
    });
    prop_oneof![4 => body_site(), 3 => hand, 1 => text().prop_map(Site::Named)].boxed()
}

fn location() -> BoxedStrategy<Location> {
    let at = prop_oneof![body_site(), text().prop_map(Site::Named)];
    let constellation = (of((hand_levels(), hand_levels())), contact(), of(at))
        .prop_map(|(points, contact, at)| Location::Constellation(Constellation { points, contact, at }));
    prop_oneof![
        site().prop_map(Location::One),
        (site(), of(site())).prop_map(|(strong, weak)| Location::Split(Some(strong), weak)),
        constellation,
    ]
    .boxed()
}

// Actions -----------------------------------------------------------------------------------------------------------

fn growth() -> impl Strategy<Value = Option<Growth>> {
    of((select(vec![Change::Increasing, Change::Decreasing]), size())
        .prop_map(|(change, size)| Growth { change, size }))
}

fn ellipse() -> impl Strategy<Value = Ellipse> {
    select(vec![Ellipse::Horizontal, Ellipse::UpRight, Ellipse::Vertical, Ellipse::UpLeft])
}

fn waves(plane: impl Strategy<Value = Option<Ellipse>>) -> impl Strategy<Value = Option<Waves>> {
    of((select(vec![WaveStyle::Zigzag, WaveStyle::Wavy]), size(), plane).prop_map(|(style, size, plane)| Waves {
        style,
        size,
        plane,
    }))
}

fn motion() -> BoxedStrategy<Motion> {
    let straight = (direction(), size(), of(direction()), of((roll(), size())), waves(of(ellipse())), growth())
        .prop_map(|(direction, size, between, arc, waves, growth)| {
            Motion::Straight(Straight { direction, size, between, arc, waves, growth })
        });
    let clock = || of((0u8..8).prop_map(|eighths| Clock::new(eighths).unwrap()));
    let circle = (
        (direction(), size(), of(direction())),
        (clock(), of(select(vec![Times::Once, Times::Twice])), clock()),
        (of((ellipse(), size())), waves(Just(None)), growth()),
    );
    let circle = circle.prop_map(|((axis, size, between), (start, full, end), (ellipse, waves, growth))| {
        Motion::Circle(Circle { axis, size, between, start, full, end, ellipse, waves, growth })
    });
    prop_oneof![
        2 => Just(Motion::Nothing),
        4 => straight,
        2 => circle,
        1 => (select(WristMotion::ALL.to_vec()), size()).prop_map(|(motion, size)| Motion::Wrist(motion, size)),
        1 => digits(&Digit::ALL, 0..=5).prop_map(Motion::FingerPlay),
        2 => posture().prop_map(Motion::Replace),
        1 => Just(Motion::Cross),
    ]
    .boxed()
}

fn moved() -> BoxedStrategy<Move> {
    let flags = vec(prop::bool::weighted(0.2), 6);
    (motion(), flags, number(), of(site()), of(text()))
        .prop_map(|(motion, flags, speed, brushing, names)| Move {
            // A change of posture brushes nothing.
            brushing: brushing.filter(|_| !matches!(motion, Motion::Replace(_))),
            motion,
            fast: flags[0],
            slow: flags[1],
            tense: flags[2],
            rest: flags[3],
            halt: flags[4],
            bouncing: flags[5],
            speed,
            names,
            span: Ignored::default(),
        })
        .boxed()
}

fn repetition() -> BoxedStrategy<Repetition> {
    use RepetitionKind::*;
    let kind = || select(vec![FromStart, FromStartSeveral, Continue, ContinueSeveral, Reverse, ToFroTo]);
    let shift =
        of((direction(), size(), growth()).prop_map(|(direction, size, growth)| Shift { direction, size, growth }));
    (kind(), of(kind()), any::<bool>(), growth(), shift)
        .prop_map(|(kind, second, approximate, growth, shift)| Repetition { kind, second, approximate, growth, shift })
        .boxed()
}

/// A hand of a split motion; one that does nothing is `None`.
fn hand(action: Option<Action>) -> Option<Box<Action>> {
    let nothing = Action::Move(Box::new(Move::of(Motion::Nothing)));
    action.filter(|action| *action != nothing).map(Box::new)
}

fn action() -> BoxedStrategy<Action> {
    let leaf = moved().prop_map(|moved| Action::Move(Box::new(moved)));
    leaf.prop_recursive(3, 8, 2, |inner| {
        let several = || vec(inner.clone(), 0..3);
        let alternating = |(action, times)| match action {
            Action::Alternating(action, _) => Action::Alternating(action, times),
            action => Action::Alternating(Box::new(action), times),
        };
        prop_oneof![
            several().prop_map(Action::Together),
            several().prop_map(Action::Sequence),
            several().prop_map(Action::Fused),
            (inner.clone(), location())
                .prop_map(|(action, location)| Action::Target(Box::new(action), Box::new(location))),
            (of(inner.clone()), of(inner.clone())).prop_map(|(strong, weak)| Action::Split(hand(strong), hand(weak))),
            (inner.clone(), repetition()).prop_map(|(action, how)| Action::Repeated(Box::new(action), how)),
            (inner.clone(), select(vec![Times::Once, Times::Twice])).prop_map(alternating),
            (body_level(), inner.clone()).prop_map(|(part, action)| Action::OfBody(part, Box::new(action))),
        ]
    })
    .boxed()
}
