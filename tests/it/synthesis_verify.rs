//! A motion checked by program: planted faults are found, and sound signs are not blamed.

use chereme::body::signer::Signer;
use chereme::motion::clip::{Clip, Frame};
use chereme::motion::rotation::from_vector;
use chereme::notation::{Lexicon, Vocabulary, read};
use chereme::phonology::Sign;
use chereme::synthesis::verify::{Finding, Kind, Weight, verify};
use chereme::synthesis::{Grammar, Options, Performance, synthesize};
use chereme::time::Fps;
use glam::{DQuat, DVec3};

struct World {
    grammar: Grammar,
    signer: Signer,
}

impl World {
    fn new() -> World {
        World { grammar: Grammar::builtin(), signer: chereme::avatar::signer().unwrap() }
    }

    fn perform(&self, sign: &Sign) -> Performance {
        let options = Options { fps: Fps::new(30.0).unwrap(), ..Options::default() };
        synthesize(sign, &self.grammar, &self.signer, &options).unwrap()
    }

    fn verify(&self, sign: &Sign, performance: &Performance) -> Vec<Finding> {
        verify(sign, performance, &self.grammar, &self.signer)
    }

    /// What is found once the frames are changed.
    fn changed(&self, sign: &Sign, change: impl Fn(usize, &mut Frame)) -> Vec<Finding> {
        let mut performance = self.perform(sign);
        let clip = &performance.track.clip;
        let mut frames = clip.frames().to_vec();
        frames.iter_mut().enumerate().for_each(|(n, frame)| change(n, frame));
        let changed = Clip::new(clip.skeleton().clone(), clip.fps(), clip.morphs().clone(), frames);
        performance.track.clip = changed.unwrap();
        self.verify(sign, &performance)
    }
}

fn sign(text: &str) -> Sign {
    let reading = read(text, &Vocabulary::builtin(), "");
    assert_eq!(reading.diagnostics, []);
    reading.signs[0].sign.clone()
}

fn penser() -> Sign {
    sign(
        "sign P\n  configuration index\n  placement forehead right, touch\n  orientation fingers between up-left and up-in-left, palm down-left\n",
    )
}

fn kinds(findings: &[Finding]) -> Vec<Kind> {
    findings.iter().map(|finding| finding.kind).collect()
}

#[test]
fn signs_of_the_lexicon_have_no_faults() {
    let world = World::new();
    for entry in Lexicon::builtin().entries() {
        let found = world.verify(&entry.sign, &world.perform(&entry.sign));
        let faults: Vec<&Finding> = found.iter().filter(|f| f.kind.weight() == Weight::Fault).collect();
        assert!(faults.is_empty(), "{}: {faults:?}", entry.sign.name);
    }
    let sound = penser();
    assert_eq!(world.verify(&sound, &world.perform(&sound)), []);
}

#[test]
fn what_is_no_number_is_found_first_and_alone() {
    let world = World::new();
    let head = world.signer.head();
    let found = world.changed(&penser(), |n, frame| {
        if n == 7 {
            frame.pose.rotations[head.index()].x = f64::NAN;
        }
    });
    assert_eq!(kinds(&found), [Kind::NotFinite]);
    assert!((found[0].time.0 - 7.0 / 30.0).abs() < 1e-9);
    let face = world.changed(&penser(), |_, frame| frame.weights[0] = f32::INFINITY);
    assert_eq!(kinds(&face), [Kind::NotFinite]);
}

#[test]
fn a_stretched_bone_is_found() {
    let world = World::new();
    let fore = world.signer.skeleton.joint("LeftForeArm").unwrap();
    let found = world.changed(&penser(), |_, frame| {
        frame.pose.rotations[fore.index()] = frame.pose.rotation(fore) * 1.01;
    });
    let bone = found.iter().find(|f| f.kind == Kind::BoneLength).unwrap();
    assert!(bone.measured > 1e-3 && bone.what.contains("LeftForeArm"), "{bone}");
}

#[test]
fn a_twisted_and_an_overbent_finger_are_found() {
    let world = World::new();
    let middle = world.signer.skeleton.joint("RightHandMiddle2").unwrap();
    let turned = |by: DVec3| {
        world.changed(&penser(), move |_, frame| {
            frame.pose.set(middle, frame.pose.rotation(middle) * from_vector(by));
        })
    };
    let twisted = turned(DVec3::X * 0.5);
    let finding = twisted.iter().find(|f| f.kind == Kind::FingerTwist).unwrap();
    assert!((finding.measured - 0.5).abs() < 0.1 && finding.what == "middle joint 2", "{finding}");
    let bent = turned(DVec3::Z * -1.0);
    let other = turned(DVec3::Z * 1.0);
    let over = bent.iter().chain(&other).find(|f| f.kind == Kind::Finger).unwrap();
    assert!(over.what == "middle middle joint", "{over}");
}

#[test]
fn elbows_and_wrists_have_limits() {
    let world = World::new();
    let arm = world.signer.arm(chereme::phonology::Side::Right).clone();
    let turned =
        |joint, by: DQuat| world.changed(&penser(), move |_, f| f.pose.set(joint, f.pose.rotation(joint) * by));
    let wrist = turned(arm.hand, DQuat::from_rotation_y(1.2));
    assert!(kinds(&wrist).contains(&Kind::Wrist), "{wrist:?}");
    let elbow = turned(arm.fore, DQuat::from_rotation_z(0.3));
    assert!(kinds(&elbow).contains(&Kind::Elbow), "{elbow:?}");
}

#[test]
fn a_hand_away_from_its_contact_is_found() {
    let world = World::new();
    let arm = world.signer.skeleton.joint("RightArm").unwrap();
    let found = world.changed(&penser(), |_, frame| {
        frame.pose.set(arm, frame.pose.rotation(arm) * DQuat::from_rotation_y(0.1));
    });
    let contact = found.iter().find(|f| f.kind == Kind::Contact).unwrap();
    assert!(contact.measured > 0.02 && contact.what == "from forehead at key 1", "{contact}");
    let touch =
        "sign T\n  hands both\n  strong placement other palm, touch, with index tip\n  weak placement neutral\n";
    let touching = sign(touch);
    assert!(!kinds(&world.verify(&touching, &world.perform(&touching))).contains(&Kind::Contact));
    let found = world.changed(&touching, |_, frame| {
        frame.pose.set(arm, frame.pose.rotation(arm) * DQuat::from_rotation_y(0.1));
    });
    assert!(kinds(&found).contains(&Kind::Contact), "{found:?}");
}

#[test]
fn a_hand_that_looks_elsewhere_is_found() {
    let world = World::new();
    let hand = world.signer.skeleton.joint("RightHand").unwrap();
    let found = world.changed(&penser(), |_, frame| {
        frame.pose.set(hand, DQuat::from_rotation_z(0.2) * frame.pose.rotation(hand));
    });
    let turned: Vec<&Finding> = found.iter().filter(|f| f.kind == Kind::Orientation).collect();
    assert!(turned.iter().any(|f| f.what.ends_with("at key 1")), "{found:?}");
}

#[test]
fn jumps_and_wild_wrists_are_found() {
    let world = World::new();
    let arm = world.signer.skeleton.joint("RightArm").unwrap();
    let found = world.changed(&penser(), |n, frame| {
        if n == 20 {
            frame.pose.set(arm, frame.pose.rotation(arm) * DQuat::from_rotation_y(1.0));
        }
    });
    let found = kinds(&found);
    assert!(found.contains(&Kind::Jump) && found.contains(&Kind::TooFast) && !found.contains(&Kind::Fast), "{found:?}");
}

#[test]
fn what_the_body_cannot_do_is_an_exception_where_the_report_says_so() {
    let world = World::new();
    let bent = sign("sign B\n  placement chest, touch, with index tip\n  orientation fingers up, palm out\n");
    let performance = world.perform(&bent);
    let found = world.verify(&bent, &performance);
    assert!(kinds(&found).contains(&Kind::BeyondWrist), "{found:?}");
    let mut silent = performance;
    silent.report.tilt = 0.0;
    assert!(kinds(&world.verify(&bent, &silent)).contains(&Kind::Orientation));
    let far = sign("sign F\n  placement belowstomach, touch, with index tip, offset down 90cm\n");
    let found = world.verify(&far, &world.perform(&far));
    assert!(kinds(&found).contains(&Kind::OutOfReach), "{found:?}");
}

#[test]
fn signs_that_last_too_short_or_too_long_are_found() {
    let world = World::new();
    let long = sign("sign L\n  movement up 10cm\n  duration 6s\n");
    let found = world.verify(&long, &world.perform(&long));
    assert_eq!(kinds(&found), [Kind::Long]);
    assert!(found[0].to_string().contains("stroke and hold"));
}

#[test]
fn hands_keep_out_of_the_body() {
    let world = World::new();
    // Down along the chest with the little finger's edge on it, over the top of the head, in circles on the shoulder.
    let ways = [
        "sign X\n  configuration flat\n  orientation fingers left, palm in\n  placement shoulders, touch, with pinky-side\n  movement down large\n",
        "sign X\n  configuration flat\n  orientation fingers up, palm left\n  placement cheek right, touch\n  movement left\n",
        "sign X\n  configuration S\n  orientation fingers up-left, palm left\n  placement shoulders, touch\n  movement circle axis right\n",
    ];
    for way in ways {
        let sign = sign(way);
        let performance = world.perform(&sign);
        assert!(performance.report.aside_m > 0.01, "{way}: {:.3} m aside", performance.report.aside_m);
        let found = kinds(&world.verify(&sign, &performance));
        assert!(!found.contains(&Kind::InBody) && !found.contains(&Kind::Contact), "{way} {found:?}");
    }
    let through = sign("sign X\n  configuration flat\n  placement chest, touch\n  movement hold\n");
    let found = world.changed(&through, |_, frame| {
        let arm = world.signer.arm(chereme::phonology::Side::Right);
        // From before the chest about the shoulder, into it.
        let into = DQuat::from_rotation_y(0.8) * frame.pose.rotation(arm.upper);
        frame.pose.set(arm.upper, into);
    });
    assert!(kinds(&found).contains(&Kind::InBody), "{found:?}");
}

#[test]
fn a_fast_turn_takes_longer_instead_of_jumping() {
    let world = World::new();
    let turn = sign(
        "sign X\n  configuration flat\n  placement chest\n  orientation fingers out, palm down then fingers out, palm up\n  movement up 2cm while change\n",
    );
    let performance = world.perform(&turn);
    let found = kinds(&world.verify(&turn, &performance));
    assert!(!found.contains(&Kind::Jump), "{found:?}");
}

#[test]
fn a_hand_that_points_away_from_what_it_touches_touches_it_with_its_wrist() {
    let world = World::new();
    let away = sign(
        "sign X\n  configuration flat\n  placement chest, touch\n  orientation fingers out, palm left\n  movement hold\n",
    );
    let performance = world.perform(&away);
    assert_eq!(kinds(&world.verify(&away, &performance)), []);
}
