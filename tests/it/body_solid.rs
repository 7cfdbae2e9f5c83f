//! The room that the body takes up: landmarks lie on it, what is before them outside, and its way out leads out.

use chereme::body::signer::{Signer, Turn};
use chereme::motion::pose::ModelPose;
use chereme::phonology::{Configuration, HandshapeInventory};
use glam::DVec3;
use proptest::prelude::*;

/// The signer at rest, and with head and trunk turned.
fn bodies() -> (Signer, [ModelPose; 2]) {
    let signer = chereme::avatar::signer().unwrap();
    let relaxed = HandshapeInventory::builtin().angles(&Configuration::named("rest"), None).unwrap();
    let standing = signer.neutral(&relaxed);
    let mut turned = standing.clone();
    signer.turn_torso(Turn { pitch: 0.1, yaw: 0.3, roll: -0.1 }, &mut turned);
    signer.turn_head(Turn { pitch: 0.1, yaw: -0.5, roll: 0.2 }, &mut turned);
    let poses = [standing.to_model(&signer.skeleton), turned.to_model(&signer.skeleton)];
    (signer, poses)
}

#[test]
fn landmarks_lie_on_it() {
    let (signer, poses) = bodies();
    let solid = &signer.solid;
    // The coarse surface is off the skin by so much; nose and chin stand out of it.
    let near = |id: &str| if ["nose", "nostrils", "chin"].contains(&id) { 0.045 } else { 0.02 };
    for model in &poses {
        for id in ["chest", "shoulders", "stomach", "forehead", "eyes", "headtop", "ear", "chin", "nose", "nostrils"] {
            let Ok(mark) = signer.landmarks.body_place(id, None).or_else(|_| {
                let side = chereme::phonology::Lateral { side: chereme::phonology::Side::Left, beside: false };
                signer.landmarks.body_place(id, Some(side))
            }) else {
                panic!("{id}")
            };
            let (at, out) = (mark.position(model), mark.normal(model));
            let (deep, _) = solid.depth(at, model);
            // A trunk that bends carries its landmarks by other joints than the whole of it.
            assert!(deep.abs() < near(id) + if *model == poses[0] { 0.0 } else { 0.03 }, "{id}: {deep:.3}");
            assert!(solid.depth(at + out * 0.08, model).0 < 0.0, "{id}: before it");
            assert!(solid.depth(at - out * 0.06, model).0 > 0.0, "{id}: behind it");
            assert!(solid.from_landmark(at, model) < 1e-9);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 512, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_way_out_leads_out(x in -0.3..0.3f64, y in 0.8..1.8f64, z in -0.2..0.4f64, turned in any::<bool>()) {
        let (signer, poses) = bodies();
        let solid = &signer.solid;
        let model = &poses[usize::from(turned)];
        let point = DVec3::new(x, y, z);
        let (deep, out) = solid.depth(point, model);
        prop_assert!(deep.is_finite() && (out.length() - 1.0).abs() < 1e-9);
        if deep > 0.0 {
            // Out of the trunk a point may come into the head; what is left of an ellipsoid's way is little.
            let (left, _) = solid.depth(point + out * (deep + 1e-9), model);
            prop_assert!(left < deep * 0.7 + 0.04, "{deep} {left}");
            prop_assert!(!solid.is_beyond(0.0, point, model));
        }
        if solid.is_beyond(0.1, point, model) {
            prop_assert!(deep <= 0.0);
        }
    }
}
