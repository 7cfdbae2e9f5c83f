//! GLB: the avatar is read, what is written reads back, and no bytes make the reader panic.

use chereme::format::glb::read::read;
use proptest::prelude::*;

const AVATAR: &[u8] = include_bytes!("../../assets/avatar.glb");

#[test]
fn the_avatar_has_hands_a_face_and_a_skin() {
    let model = read(AVATAR).unwrap();
    assert!(model.joints.len() >= 54);
    let right = model.joint("RightHand").unwrap();
    let above = model.joints[right].parent.unwrap();
    assert!(model.joints[above].name.starts_with("RightForeArm"));
    let hands = model.parts_of("hands").next().unwrap();
    assert!(hands.positions.len() > 1000 && hands.triangles.len() > 1000);
    assert_eq!(hands.positions.len(), hands.normals.len());
    for (weights, joints) in hands.weights.iter().zip(&hands.joints) {
        assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-6);
        assert!(joints.iter().all(|&j| usize::from(j) < model.joints.len()));
    }
    let face = model.parts_of("face").next().unwrap();
    let open = face.morphs.iter().find(|m| m.name == "mouth-open").unwrap();
    assert!(!open.moved.is_empty() && open.moved.len() < face.positions.len());
}

#[test]
fn inverse_binds_take_each_joint_to_its_own_origin() {
    let model = read(AVATAR).unwrap();
    let mut places: Vec<glam::DVec3> = Vec::new();
    for joint in &model.joints {
        let place = joint.parent.map_or(glam::DVec3::ZERO, |p| places[p]) + joint.translation;
        assert!(joint.inverse_bind.transform_point3(place).length() < 1e-6, "{}", joint.name);
        places.push(place);
    }
}

#[test]
fn faults_are_told_in_words() {
    let message = |bytes: &[u8]| read(bytes).unwrap_err().to_string();
    assert!(message(b"").contains("not a GLB file"));
    assert!(message(b"glTF\x01\0\0\0").contains("version 2"));
    assert!(message(&AVATAR[..5000]).contains("cut short"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn any_bytes_are_read_or_refused(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        let _ = read(&bytes);
        let _ = read(&[b"glTF\x02\0\0\0".as_slice(), &bytes].concat());
    }

    #[test]
    fn a_damaged_avatar_is_read_or_refused(at in 0usize..AVATAR.len(), value in any::<u8>(), json in 20usize..40_000) {
        let mut bytes = AVATAR.to_vec();
        bytes[at] = value;
        bytes[json] = b'9';
        let _ = read(&bytes);
    }
}
