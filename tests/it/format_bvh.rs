//! BVH: laws on random clips and random bytes, what odd files say, and what broken ones are told.

use super::motion_easing::any_rotation;
use super::shared::shared;
use super::signing::{perform, sign};
use chereme::diagnostics::render::render;
use chereme::diagnostics::{Diagnostic, Severity};
use chereme::format::bvh::{self, Bvh, Channel, ClipOptions, Joint, Options, Roots, TwistLeaves};
use chereme::motion::clip::{Clip, Frame};
use chereme::motion::pose::LocalPose;
use chereme::motion::rotation::angle_between;
use chereme::motion::skeleton::{self, JointId, Skeleton};
use chereme::time::{Fps, Seconds};
use glam::{DQuat, DVec3};
use proptest::collection::vec;
use proptest::prelude::*;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

fn near_place() -> impl Strategy<Value = DVec3> {
    (-2.0..2.0f64, -2.0..2.0f64, -2.0..2.0f64).prop_map(DVec3::from)
}

/// Any rotation, and many next to gimbal lock of the written order.
fn rotation() -> impl Strategy<Value = DQuat> {
    let turn = || -7.0..7.0f64;
    let hair = prop_oneof![Just(0.0), -1e-3..1e-3f64, -1e-7..1e-7f64, -1e-9..1e-9f64];
    let locked = (turn(), any::<bool>(), hair, turn()).prop_map(|(a, up, hair, c)| {
        let b = if up { FRAC_PI_2 } else { -FRAC_PI_2 } + hair;
        DQuat::from_rotation_z(a) * DQuat::from_rotation_x(b) * DQuat::from_rotation_y(c)
    });
    prop_oneof![any_rotation(), locked, Just(DQuat::IDENTITY)]
}

/// A skeleton of any shape, its joints in any order that has parents first.
fn rig() -> impl Strategy<Value = Arc<Skeleton>> {
    vec((any::<prop::sample::Index>(), near_place(), near_place()), 1..12).prop_map(|rows| {
        let joints = rows.iter().enumerate().map(|(i, (parent, rest_model, tail_model))| skeleton::Joint {
            name: format!("joint {i}"),
            parent: (i > 0).then(|| JointId(parent.index(i.max(1)) as u16)),
            rest_model: *rest_model,
            tail_model: *tail_model,
        });
        Arc::new(Skeleton::new(joints.collect()).unwrap())
    })
}

fn clip() -> impl Strategy<Value = Clip> {
    (rig(), prop_oneof![Just(60.0), Just(30_000.0 / 1001.0), Just(25.0), 1.5..999.0f64]).prop_flat_map(|(rig, fps)| {
        let frame = (near_place(), vec(rotation(), rig.len()))
            .prop_map(|(root_model, rotations)| Frame { pose: LocalPose { root_model, rotations }, weights: vec![] });
        vec(frame, 1..6)
            .prop_map(move |frames| Clip::new(rig.clone(), Fps::new(fps).unwrap(), Arc::new(vec![]), frames).unwrap())
    })
}

/// The data of a text without faults or warnings.
fn plain(text: &str) -> Bvh {
    let reading = bvh::read(text.as_bytes()).unwrap_or_else(|faults| panic!("{faults:?}\n{text}"));
    assert_eq!(reading.warnings, [], "{text}");
    reading.bvh
}

/// The clip that writing and reading gives.
fn again(clip: &Clip, options: &Options) -> Clip {
    let text = bvh::write(clip, options).unwrap();
    let converted = bvh::to_clip(&plain(&text), &ClipOptions::default()).unwrap();
    assert_eq!(converted.warnings, [] as [String; 0]);
    converted.clip
}

proptest! {
    #[test]
    fn a_clip_reads_back_as_it_was_written(clip in clip()) {
        let back = again(&clip, &Options::default());
        let (rig, rig_back) = (clip.skeleton(), back.skeleton());
        prop_assert_eq!(rig.len(), rig_back.len());
        prop_assert!((clip.fps().get() / back.fps().get() - 1.0).abs() < 1.1e-4);
        prop_assert_eq!(clip.frames().len(), back.frames().len());
        for id in rig.ids() {
            let there = rig_back.joint(&rig[id].name).unwrap();
            let parent = |rig: &Skeleton, id: JointId| rig[id].parent.map(|p| rig[p].name.clone());
            prop_assert_eq!(parent(rig, id), parent(rig_back, there));
            if rig[id].parent.is_some() {
                prop_assert!(rig.offset(id).distance(rig_back.offset(there)) < 1e-6);
            }
            for (frame, frame_back) in clip.frames().iter().zip(back.frames()) {
                let angle = angle_between(frame.pose.rotation(id), frame_back.pose.rotation(there));
                prop_assert!(angle < 1e-6, "{} by {angle}", rig[id].name);
            }
        }
        for (frame, frame_back) in clip.frames().iter().zip(back.frames()) {
            prop_assert!(frame.pose.root_model.distance(frame_back.pose.root_model) < 1e-6);
        }
    }
}

#[test]
fn a_sign_reads_back_with_every_joint_where_it_was() {
    let clip = perform(&sign("sign BOL\n hands both mirrored\n configuration round-B\n movement arc up-right 15cm"))
        .track
        .clip;
    for twist_leaves in [TwistLeaves::Omit, TwistLeaves::Keep] {
        let back = again(&clip, &Options { twist_leaves });
        assert_eq!(back.fps(), Fps::DEFAULT);
        assert_eq!(
            back.skeleton().len(),
            clip.skeleton().len() - if twist_leaves == TwistLeaves::Omit { 4 } else { 0 }
        );
        for (frame, frame_back) in clip.frames().iter().zip(back.frames()) {
            let (model, model_back) = (frame.pose.to_model(clip.skeleton()), frame_back.pose.to_model(back.skeleton()));
            for joint in back.skeleton().joints() {
                let (id, id_back) =
                    (clip.skeleton().joint(&joint.name).unwrap(), back.skeleton().joint(&joint.name).unwrap());
                assert!(model.position(id).distance(model_back.position(id_back)) < 1e-6, "{}", joint.name);
            }
        }
    }
}

/// Any data, in any order and number of channels; numbers of up to six decimals, as they are printed.
fn data() -> impl Strategy<Value = Bvh> {
    let number = || (-400_000_000..400_000_000i64).prop_map(|n| n as f64 / 1e6);
    let place = move || (number(), number(), number()).prop_map(DVec3::from);
    let channels = Just(Channel::ALL.to_vec())
        .prop_shuffle()
        .prop_flat_map(|all| (0..=6usize).prop_map(move |n| all[..n].to_vec()));
    let name = "[A-Za-zé:_]([A-Za-z0-9é \t]{0,6}[A-Za-z0-9.])?";
    let joint = (name, place(), channels, vec(place(), 0..3), 0..4usize);
    let joints = vec(joint, 1..10).prop_map(|rows| {
        // How far up the new joint's parent is from the joint before; beyond the root it is a new root.
        let mut above: Vec<usize> = Vec::new();
        let mut joints = Vec::new();
        for (i, (name, offset, channels, end_sites, up)) in rows.into_iter().enumerate() {
            above.truncate(above.len().saturating_sub(up));
            joints.push(Joint { name, parent: above.last().copied(), offset, channels, end_sites });
            above.push(i);
        }
        joints
    });
    (joints, 1e-3..2.0f64).prop_flat_map(move |(joints, frame_time)| {
        let channels: usize = joints.iter().map(|j| j.channels.len()).sum();
        let rows = vec(vec(number(), channels), if channels == 0 { 0..1 } else { 0..5 });
        rows.prop_map(move |rows| Bvh::new(joints.clone(), Seconds(frame_time), rows.concat()).unwrap())
    })
}

proptest! {
    #[test]
    fn data_reads_back_as_it_was_printed(bvh in data()) {
        let text = bvh::print(&bvh);
        let read = bvh::read(text.as_bytes()).unwrap().bvh;
        prop_assert!((read.frame_time().0 / bvh.frame_time().0 - 1.0).abs() < 1e-5);
        prop_assert!(read.rows().eq(bvh.rows()));
        prop_assert_eq!(read.joints().len(), bvh.joints().len());
        for (at, (a, b)) in bvh.joints().iter().zip(read.joints()).enumerate() {
            let leaf = bvh.joints().iter().all(|j| j.parent != Some(at));
            let sites = if leaf && a.end_sites.is_empty() { vec![DVec3::ZERO] } else { a.end_sites.clone() };
            prop_assert_eq!(&Joint { end_sites: sites, ..a.clone() }, b);
        }
        prop_assert_eq!(bvh::print(&read), text);
    }

    #[test]
    fn numbers_are_the_standard_librarys(number in "[-+]?([0-9]{1,22}[.]?[0-9]{0,22}|[.][0-9]{1,20})([eE][-+]?[0-9]{1,3})?") {
        let text = format!("HIERARCHY\nROOT a {{ OFFSET {number} 0 0\nCHANNELS 0 }}\nMOTION\nFrames: 0\nFrame Time: 1e-2");
        let expected: f64 = number.parse().unwrap();
        match bvh::read(text.as_bytes()) {
            Ok(reading) => prop_assert_eq!(reading.bvh.joints()[0].offset.x.to_bits(), expected.to_bits()),
            Err(_) => prop_assert!(expected.is_infinite(), "{number} refused"),
        }
    }

    /// A row of many: most numbers have others after them, which the fast way needs.
    #[test]
    fn rows_of_numbers_are_the_standard_librarys(
        numbers in vec((prop_oneof![
            4 => "-?[0-9]{1,4}[.][0-9]{1,12}",
            2 => "-?(0|00|[0-9]{1,17}|[.][0-9]{1,15}|[0-9]{1,15}[.])",
            1 => "[-+]?([0-9]{1,22}[.]?[0-9]{0,22}|[.][0-9]{1,20})([eE][-+]?[0-9]{1,3})?",
        ].prop_filter("within range", |n| n.parse::<f64>().unwrap().is_finite()), "[ \\t]{1,2}"), 12),
        end in prop_oneof![Just("\n"), Just("\r\n"), Just(" \n"), Just("")],
    ) {
        let channels = "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation";
        let head = format!(
            "HIERARCHY\nROOT A {{ OFFSET 0 0 0\n{channels}\nJOINT B {{ OFFSET 0 0 0\n{channels}\n}} }}\nMOTION\nFrames: 1\nFrame Time: 1e-2\n"
        );
        let row: String = numbers.iter().map(|(number, blank)| format!("{number}{blank}")).collect();
        let row = row.trim_end();
        let expected: Vec<u64> = numbers.iter().map(|(n, _)| n.parse::<f64>().unwrap().to_bits()).collect();
        let read = |text: String| -> Vec<u64> { plain(&text).rows().next().unwrap().iter().map(|v| v.to_bits()).collect() };
        prop_assert_eq!(read(format!("{head}{row}{end}")), expected.clone());
        // A byte that is no blank makes the row another, wherever it stands.
        let at = row.len() / 2;
        let spoilt = format!("{head}{}x{}{end}", &row[..at], &row[at..]);
        prop_assert!(bvh::read(spoilt.as_bytes()).is_err());
    }

    #[test]
    fn a_file_with_mistakes_is_read_or_refused(
        bvh in data(),
        changes in vec((any::<prop::sample::Index>(), 0..8usize, prop_oneof![any::<u8>(), Just(b'\n'), Just(b'{'), Just(b'}')]), 0..8),
    ) {
        let mut bytes = bvh::print(&bvh).into_bytes();
        for (place, how, byte) in changes {
            let at = place.index(bytes.len() + 1).min(bytes.len());
            match how {
                0 => bytes.truncate(at),
                1 => bytes.insert(at, byte),
                2 => drop(bytes.drain(at..(at + 1).min(bytes.len()))),
                // A piece again, elsewhere.
                3 => {
                    let piece = bytes[at..(at + 20).min(bytes.len())].to_vec();
                    let to = at * usize::from(byte) / 256;
                    bytes.splice(to..to, piece);
                }
                _ if at < bytes.len() => bytes[at] = byte,
                _ => {}
            }
        }
        judge(&bytes)?;
    }

    #[test]
    fn any_bytes_are_read_or_refused(bytes in vec(any::<u8>(), 0..200)) {
        judge(&bytes)?;
    }

    #[test]
    fn any_words_are_read_or_refused(words in vec(prop::sample::select(WORDS.to_vec()), 0..40)) {
        judge(words.join(" ").as_bytes())?;
        judge(("HIERARCHY\n".to_owned() + &words.join("\n")).as_bytes())?;
    }
}

const WORDS: [&str; 24] = [
    "HIERARCHY",
    "ROOT",
    "JOINT",
    "End",
    "Site",
    "End Site",
    "OFFSET 0 0 0",
    "OFFSET",
    "CHANNELS 3 Zrotation Xrotation Yrotation",
    "CHANNELS 0",
    "CHANNELS",
    "{",
    "}",
    "MOTION",
    "Frames: 1",
    "Frames:",
    "Frame Time: 0.1",
    "Frame",
    "Time:",
    "1 2 3",
    "nan",
    "-",
    "\n",
    "Hips",
];

/// Whatever was read keeps what it promises; whatever was not says why, and can be shown.
fn judge(bytes: &[u8]) -> Result<(), TestCaseError> {
    match bvh::read(bytes) {
        Ok(reading) => {
            let bvh = reading.bvh;
            let again = Bvh::new(bvh.joints().to_vec(), bvh.frame_time(), bvh.rows().flatten().copied().collect());
            prop_assert_eq!(again.as_ref(), Ok(&bvh));
            let _ = bvh::to_clip(&bvh, &ClipOptions { roots: Roots::First, ..ClipOptions::default() });
            bvh::propose_unit(&bvh);
        }
        Err(notes) => {
            prop_assert!(
                notes.iter().any(|n| n.severity == Severity::Fault && !n.message.is_empty() && !n.label.is_empty())
            );
            let source = bvh::source_of_bytes("a.bvh", bytes);
            prop_assert!(notes.iter().all(|n| !render(n, &source, false).is_empty()));
        }
    }
    Ok(())
}

#[test]
fn each_mistake_has_its_message() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/suite/bvh");
    let update = std::env::var_os("UPDATE").is_some();
    let (mut wrong, mut count) = (Vec::new(), 0);
    for path in files(&folder) {
        count += 1;
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let bytes = std::fs::read(&path).unwrap();
        let source = bvh::source_of_bytes(&name, &bytes);
        let notes = bvh::read(&bytes).map_or_else(|faults| faults, |reading| reading.warnings);
        assert!(!notes.is_empty(), "{name} has no fault");
        let text: String = notes.iter().map(|d| render(d, &source, false) + "\n\n").collect();
        let beside = path.with_extension("txt");
        if update {
            std::fs::write(&beside, text.trim_end().to_owned() + "\n").unwrap();
        } else if std::fs::read_to_string(&beside).unwrap_or_default().trim_end() != text.trim_end() {
            wrong.push(format!("{name}:\n{text}"));
        }
    }
    assert!(count >= 40, "{count} files");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The BVH files below a folder, in order of their paths.
pub fn files(folder: &std::path::Path) -> Vec<std::path::PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path));
        } else if path.extension().is_some_and(|e| e == "bvh") {
            found.push(path);
        }
    }
    found.sort();
    found
}

const TWO: &str = "HIERARCHY\nROOT Hips\n{\n\tOFFSET 0 1 0\n\tCHANNELS 3 Zrotation Xrotation Yrotation\n\tJOINT Spine\n\t{\n\
                   \t\tOFFSET 0 2 0\n\t\tCHANNELS 3 Zrotation Xrotation Yrotation\n\t\tEnd Site\n\t\t{\n\t\t\tOFFSET 0 3 0\n\t\t}\n\t}\n}\n\
                   MOTION\nFrames: 2\nFrame Time: 0.02\n1 2 3 4 5 6\n7 8 9 10 11 12\n";

#[test]
fn spellings_that_programs_use_mean_the_same() {
    let same = |text: &str| assert_eq!(plain(text), plain(TWO), "{text}");
    same(&TWO.replace('\n', "\r\n"));
    same(&TWO.replace('\n', "\r"));
    same(&TWO.replace('\t', ""));
    same(&TWO.replace(' ', "\t").replace("End\tSite", "End Site"));
    same(&TWO.replace("\n{", " {"));
    same(&TWO.replace("Hips\n{", "Hips{"));
    same(&format!("\u{feff}{TWO}"));
    same(&TWO.replace('\n', "\n\n"));
    same(&TWO.replace("Frames:", "Frames :").replace("Frame Time:", "Frame Time :"));
    same(&TWO.replace("Frames:", "frames").replace("Frame Time: ", "FRAME TIME:"));
    same(&TWO.to_uppercase().replace("HIPS", "Hips").replace("SPINE", "Spine"));
    same(&TWO.replace("1 2 3 4", " +1.0 2e0  .3E+1 4.0000000000000000000000000000 "));
    same(TWO.trim_end());
}

#[test]
fn what_files_say_is_kept_as_it_is() {
    let spaced = plain(&TWO.replace("Spine", "Left Hand of God"));
    assert_eq!(spaced.joints()[1].name, "Left Hand of God");
    let leafless = plain(&TWO.replace("\t\tEnd Site\n\t\t{\n\t\t\tOFFSET 0 3 0\n\t\t}\n", ""));
    assert_eq!(leafless.joints()[1].end_sites, []);
    let ends = plain(&TWO.replace("\t\tEnd Site", "End Site { OFFSET 1 0 0 }\n\t\tEnd Site"));
    assert_eq!(ends.joints()[1].end_sites, [DVec3::X, DVec3::Y * 3.0]);
    let reading = bvh::read(TWO.replace("Frames: 2", "Frames: 99999999999999999999999").as_bytes()).unwrap();
    assert_eq!((reading.bvh.rows().len(), reading.warnings.len()), (2, 1));
}

#[test]
fn depth_and_counts_cost_no_more_than_their_text() {
    const DEPTH: usize = 70_000;
    let mut deep = "HIERARCHY\nROOT j { OFFSET 0 0 0\nCHANNELS 1 Xrotation\n".to_owned();
    (1..DEPTH).for_each(|i| deep += &format!("JOINT {i} {{ OFFSET 0 0 0\nCHANNELS 0\n"));
    deep += &"}".repeat(DEPTH);
    let bvh = plain(&(deep.clone() + "\nMOTION\nFrames: 1\nFrame Time: 0.1\n1\n"));
    assert_eq!(plain(&bvh::print(&bvh)).joints().len(), DEPTH);
    assert!(bvh::to_clip(&bvh, &ClipOptions::default()).unwrap_err().to_string().contains("too many joints"));
    // Many joints that never move, and many short rows.
    let many = plain(&(deep + "\nMOTION\nFrames: 20\nFrame Time: 0.1\n" + &"1\n".repeat(20)));
    assert!(bvh::to_clip(&many, &ClipOptions::default()).unwrap_err().to_string().contains("never move"));
    let wide = TWO.replace("3 Zrotation", &format!("3 {}", "Wrotation ".repeat(100_000)));
    assert!(bvh::read(wide.as_bytes()).unwrap_err().len() < 200);
    let rows = TWO.replace("1 2 3 4 5 6", &"x\n".repeat(100_000));
    assert_eq!(bvh::read(rows.as_bytes()).unwrap_err().len(), 21);
}

#[test]
fn channels_turn_in_the_order_they_are_listed() {
    let clip = |channels: &str| {
        let text = TWO.replacen("Zrotation Xrotation Yrotation", channels, 1);
        bvh::to_clip(&plain(&text), &ClipOptions::default()).unwrap().clip.frames()[0].pose.clone()
    };
    let [x, y, z]: [fn(f64) -> DQuat; 3] = [DQuat::from_rotation_x, DQuat::from_rotation_y, DQuat::from_rotation_z];
    let is = |pose: &LocalPose, q: DQuat| assert!(angle_between(pose.rotations[0], q) < 1e-12);
    let [one, two, three] = [1.0f64, 2.0, 3.0].map(f64::to_radians);
    is(&clip("Zrotation Xrotation Yrotation"), z(one) * x(two) * y(three));
    is(&clip("Yrotation Zrotation Xrotation"), y(one) * z(two) * x(three));
    let mixed = clip("Yrotation Zposition Xrotation");
    is(&mixed, y(one) * x(three));
    assert_eq!(mixed.root_model, DVec3::new(0.0, 0.01, 0.02), "y from the offset, z from the channel");
}

#[test]
fn a_clip_says_what_it_cannot_hold() {
    let refuse = |text: &str, options: &ClipOptions, said: &str| {
        let error = bvh::to_clip(&plain(text), options).unwrap_err().to_string();
        assert!(error.contains(said), "{error}");
    };
    let ours = ClipOptions::default();
    refuse(TWO, &ClipOptions { metres_per_unit: 0.0, ..ours }, "unit of length");
    refuse(TWO, &ClipOptions { metres_per_unit: f64::NAN, ..ours }, "unit of length");
    refuse(&TWO.replace("Frame Time: 0.02", "Frame Time: 0.0002"), &ours, "no frame rate");
    refuse(&TWO[..TWO.find("1 2 3 4").unwrap()].replace("Frames: 2", "Frames: 0"), &ours, "no rows");
    let moved = TWO.replacen("3 Zrotation Xrotation Yrotation", "3 Xposition Yposition Zposition", 1);
    refuse(&moved.replace("7 8 9", "7 1e12 9"), &ours, "row 1 has its root more than 1000000000 m away");
    refuse(&TWO.replace("OFFSET 0 2 0", "OFFSET 0 -1e300 0"), &ours, "joint Spine rests more than");
    let roots = TWO.replace("MOTION", "ROOT Prop { OFFSET 0 0 0\nCHANNELS 0 }\nMOTION");
    refuse(&roots, &ours, "several roots (Hips, Prop)");
    let first = bvh::to_clip(&plain(&roots), &ClipOptions { roots: Roots::First, ..ours }).unwrap();
    assert_eq!((first.clip.skeleton().len(), first.warnings.len()), (2, 1));
    let twice = bvh::read(TWO.replace("Spine", "Hips").as_bytes()).unwrap().bvh;
    assert!(bvh::to_clip(&twice, &ours).unwrap_err().to_string().contains("Hips is listed twice"));
    let stretched = TWO.replace("3 Zrotation Xrotation Yrotation\n\t\tEnd", "3 Xposition Yposition Zrotation\n\t\tEnd");
    let warnings = bvh::to_clip(&plain(&stretched), &ours).unwrap().warnings;
    assert!(warnings.len() == 1 && warnings[0].contains("Spine by up to 13"), "{warnings:?}");
}

#[test]
fn frame_rates_come_back_from_rounded_frame_times() {
    let rate = |time: &str| {
        let bvh = plain(&TWO.replace("0.02", time));
        bvh::to_clip(&bvh, &ClipOptions::default()).unwrap().clip.fps().get()
    };
    for (time, expected) in [
        ("0.0333333", 30.0),
        ("0.008333", 120.0),
        ("0.01666667", 60.0),
        ("0.041667", 24.0),
        ("0.0417083750417", 24000.0 / 1001.0),
        ("0.03336667", 30000.0 / 1001.0),
        ("0.033", 1.0 / 0.033),
        ("0.00922764", 1.0 / 0.00922764),
    ] {
        assert!((rate(time) - expected).abs() < 1e-9, "{time}: {}", rate(time));
    }
}

#[test]
fn a_clip_that_the_format_cannot_hold_is_refused() {
    let rig = |name: &str| {
        let joint = skeleton::Joint { name: name.into(), parent: None, rest_model: DVec3::Y, tail_model: DVec3::Y };
        Arc::new(Skeleton::new(vec![joint]).unwrap())
    };
    let write = |name: &str, place: DVec3, rotation: DQuat| {
        let frame = Frame { pose: LocalPose { root_model: place, rotations: vec![rotation] }, weights: vec![] };
        let clip = Clip::new(rig(name), Fps::DEFAULT, Arc::new(vec![]), vec![frame]).unwrap();
        bvh::write(&clip, &Options::default()).map_err(|e| e.to_string())
    };
    assert!(write("Hips", DVec3::Y, DQuat::IDENTITY).is_ok());
    assert!(write("Hi{ps", DVec3::Y, DQuat::IDENTITY).unwrap_err().contains("Hi{ps"));
    assert!(write("", DVec3::Y, DQuat::IDENTITY).is_err());
    assert!(write("Hips", DVec3::NAN, DQuat::IDENTITY).unwrap_err().contains("frame 0"));
    assert!(
        write("Hips", DVec3::Y, DQuat::from_xyzw(f64::NAN, 0.0, 0.0, 1.0)).unwrap_err().contains("rotation of Hips")
    );
}

#[test]
fn curves_have_no_jumps() {
    // A joint that turns three times, and one that goes through gimbal lock.
    let rig: Vec<skeleton::Joint> = (0..2u16)
        .map(|i| skeleton::Joint {
            name: format!("joint {i}"),
            parent: (i > 0).then_some(JointId(0)),
            rest_model: DVec3::Y,
            tail_model: DVec3::Y,
        })
        .collect();
    let frame = |i: usize| {
        let t = i as f64 / 100.0;
        let rotations =
            vec![DQuat::from_rotation_z(t * 18.0), DQuat::from_rotation_y(0.3) * DQuat::from_rotation_x(t * 3.0)];
        Frame { pose: LocalPose { root_model: DVec3::Y, rotations }, weights: vec![] }
    };
    let rig = Arc::new(Skeleton::new(rig).unwrap());
    let clip = Clip::new(rig, Fps::DEFAULT, Arc::new(vec![]), (0..=100).map(frame).collect()).unwrap();
    let rows: Vec<Vec<f64>> = bvh::from_clip(&clip, &Options::default()).unwrap().rows().map(<[f64]>::to_vec).collect();
    let jump = |at: usize| rows.windows(2).map(|w| (w[1][at] - w[0][at]).abs()).fold(0.0, f64::max);
    assert!((3..9).all(|at| jump(at) < 20.0), "{:?}", (3..9).map(jump).collect::<Vec<_>>());
    assert!((rows[100][3] - (18.0f64).to_degrees()).abs() < 1e-6, "turns are counted");
}

/// Fails where `bvh_anim` reads other joints or, beyond `f32`, other numbers.
pub fn agrees_with_bvh_anim(name: &str, bytes: &[u8], ours: &Bvh) {
    let theirs = bvh_anim::from_bytes(bytes).unwrap_or_else(|e| panic!("{name}: {e}"));
    let joints: Vec<_> = theirs.joints().map(|j| j.data().clone()).collect();
    assert_eq!(joints.len(), ours.joints().len(), "{name}");
    let near = |a: f64, b: f32| (a - f64::from(b)).abs() <= 1e-6 * a.abs().max(1.0);
    for (a, b) in ours.joints().iter().zip(&joints) {
        // It cuts names at colons.
        assert_eq!(a.name.split(':').next(), Some(&b.name().to_string()[..]), "{name}");
        assert_eq!(a.parent, b.parent_index(), "{name}");
        assert!(
            near(a.offset.x, b.offset().x) && near(a.offset.y, b.offset().y) && near(a.offset.z, b.offset().z),
            "{name}"
        );
        let words: Vec<&str> = a.channels.iter().map(|c| c.word()).collect();
        assert_eq!(words, b.channels().iter().map(|c| c.channel_type().as_str()).collect::<Vec<_>>(), "{name}");
        assert_eq!(a.end_sites.len(), usize::from(b.has_end_site()), "{name}");
    }
    let frame_time = theirs.frame_time().as_secs_f64();
    assert!((frame_time - ours.frame_time().0).abs() < 1e-8, "{name}");
    assert_eq!(theirs.frames().len(), ours.rows().len(), "{name}");
    for (a, b) in ours.rows().zip(theirs.frames()) {
        assert!(a.len() == b.len() && a.iter().zip(b.as_slice()).all(|(a, b)| near(*a, *b)), "{name}");
    }
}

#[test]
fn bvh_anim_reads_the_same_in_our_files() {
    let text = sign_text();
    agrees_with_bvh_anim("BOL", text.as_bytes(), &plain(&text));
    agrees_with_bvh_anim("TWO", TWO.as_bytes(), &plain(TWO));
}

fn sign_text() -> String {
    let clip = perform(&sign("sign BOL\n hands both mirrored\n configuration round-B\n movement arc up-right 15cm"))
        .track
        .clip;
    bvh::write(&clip, &Options::default()).unwrap()
}

/// Whether `bvh_anim` can be asked: a leaf without End Site it drops, of several End Sites it makes joints, and a row
/// count that differs (which is a warning of ours) it refuses.
pub fn can_be_compared(reading: &bvh::Reading) -> bool {
    let joints = reading.bvh.joints();
    let is_leaf = |at: usize| joints.iter().all(|j| j.parent != Some(at));
    let one_end = |(at, joint): (usize, &Joint)| joint.end_sites.len() == usize::from(is_leaf(at));
    reading.warnings.is_empty() && joints.iter().enumerate().all(one_end)
}

#[test]
fn recordings_are_read_as_bvh_anim_reads_them() {
    let Some(folder) = shared("data/mocap") else { return };
    let all = std::env::var("CI").as_deref() == Ok("true") || !cfg!(debug_assertions);
    let every = files(&folder);
    assert!(every.len() >= 950, "{} files", every.len());
    let (mut refused, mut compared) = (Vec::new(), 0);
    for (at, path) in every.iter().enumerate() {
        let odd = path.parent().is_some_and(|p| p.ends_with("bvh_oddities"));
        if !(all || odd || at % 40 == 0) {
            continue;
        }
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let bytes = std::fs::read(path).unwrap();
        match bvh::read(&bytes) {
            Err(faults) => refused.push((name, faults[0].message.clone())),
            Ok(reading) => {
                let unknown: Vec<&Diagnostic> =
                    reading.warnings.iter().filter(|w| !w.message.starts_with("Frames: says")).collect();
                assert!(unknown.is_empty(), "{name}: {unknown:?}");
                if can_be_compared(&reading) {
                    compared += 1;
                    agrees_with_bvh_anim(&name, &bytes, &reading.bvh);
                }
                bvh::to_clip(&reading.bvh, &ClipOptions::default()).unwrap_or_else(|e| panic!("{name}: {e}"));
            }
        }
    }
    assert!(compared >= if all { 900 } else { 30 }, "{compared} files compared");
    assert_eq!(
        refused,
        [("gestification__header-only.bvh".to_owned(), "`7ttttttttt` is not a word of a BVH hierarchy".to_owned())]
    );
}

#[test]
fn units_are_proposed_from_the_skeletons_size() {
    let Some(folder) = shared("data/mocap") else { return };
    let proposed = |file: &str| {
        let bvh = bvh::read(&std::fs::read(folder.join(file)).unwrap()).unwrap().bvh;
        bvh::propose_unit(&bvh).map(|p| p.name)
    };
    assert_eq!(proposed("sign_body/ISL_Thanks_final.bvh"), Some("centimetre"));
    assert_eq!(proposed("cmu_body/01_01.bvh"), Some("CMU's 1/0.45 inch"));
    assert_eq!(proposed("hand_leap_jaanga/clenching.bvh"), None);
    assert_eq!(bvh::propose_unit(&plain(&sign_text())).map(|p| p.metres_per_unit), Some(0.01));
}

/// The conversions behind the feature `bvh_anim`: `cargo test --features bvh_anim --test it format_bvh`.
#[cfg(feature = "bvh_anim")]
#[test]
fn bvh_anims_own_data_converts_both_ways() {
    let ours = plain(&sign_text());
    let theirs = bvh_anim::Bvh::try_from(&ours).unwrap();
    let back = Bvh::try_from(&theirs).unwrap();
    assert_eq!(back.joints().len(), ours.joints().len());
    let near = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-6 * a.abs().max(1.0);
    assert!(back.rows().flatten().zip(ours.rows().flatten()).all(near));
    let spaced = plain(&TWO.replace("Spine", "Left Hand"));
    assert!(bvh_anim::Bvh::try_from(&spaced).unwrap_err().to_string().contains("name"));
}
