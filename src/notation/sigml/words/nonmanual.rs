//! Names of tiers and their values.

use super::Words;
use crate::notation::hamnosys::syntax::{FeatureKind, TierKind};

pub(in crate::notation::sigml) const TIER: Words<TierKind> = Words {
    what: "a non-manual tier",
    all: &[
        TierKind::Shoulder,
        TierKind::Body,
        TierKind::Head,
        TierKind::EyeGaze,
        TierKind::FacialExpression,
        TierKind::Mouthing,
        TierKind::Extra,
    ],
    word: |tier| match tier {
        TierKind::Shoulder => "shoulder_tier",
        TierKind::Body => "body_tier",
        TierKind::Head => "head_tier",
        TierKind::EyeGaze => "eyegaze_tier",
        TierKind::FacialExpression => "facialexpr_tier",
        TierKind::Mouthing => "mouthing_tier",
        TierKind::Extra => "extra_tier",
    },
    also: &[],
};

/// The elements for values of a tier at the same time and one after the other.
pub(in crate::notation::sigml) fn groups(tier: TierKind) -> (&'static str, &'static str) {
    match tier {
        TierKind::Shoulder => ("shoulder_par", "shoulder_seq"),
        TierKind::Body => ("body_par", "body_seq"),
        TierKind::Head => ("head_par", "head_seq"),
        TierKind::EyeGaze => ("eye_par", "eye_seq"),
        TierKind::FacialExpression => ("facial_expr_par", "facial_expr_seq"),
        TierKind::Mouthing => ("mouthing_par", "mouthing_seq"),
        TierKind::Extra => ("extra_par", "extra_seq"),
    }
}

const FEATURES: &[FeatureKind] = &[
    FeatureKind::Shoulder,
    FeatureKind::Body,
    FeatureKind::Head,
    FeatureKind::EyeGaze,
    FeatureKind::EyeBrows,
    FeatureKind::EyeLids,
    FeatureKind::Nose,
    FeatureKind::MouthGesture,
    FeatureKind::MouthPicture,
    FeatureKind::Extra,
];

pub(in crate::notation::sigml) const FEATURE: Words<FeatureKind> = Words {
    what: "a non-manual value",
    all: FEATURES,
    word: |kind| match kind {
        FeatureKind::Shoulder => "shoulder_movement",
        FeatureKind::Body => "body_movement",
        FeatureKind::Head => "head_movement",
        FeatureKind::EyeGaze => "eye_gaze",
        FeatureKind::EyeBrows => "eye_brows",
        FeatureKind::EyeLids => "eye_lids",
        FeatureKind::Nose => "nose",
        FeatureKind::MouthGesture => "mouth_gesture",
        FeatureKind::MouthPicture => "mouth_picture",
        FeatureKind::Extra => "extra_movement",
    },
    also: &[],
};

/// The same in H-SiGML.
pub(in crate::notation::sigml) const PLAIN_FEATURE: Words<FeatureKind> = Words {
    what: "a non-manual value",
    all: FEATURES,
    word: |kind| match kind {
        FeatureKind::Shoulder => "hnm_shoulder",
        FeatureKind::Body => "hnm_body",
        FeatureKind::Head => "hnm_head",
        FeatureKind::EyeGaze => "hnm_eyegaze",
        FeatureKind::EyeBrows => "hnm_eyebrows",
        FeatureKind::EyeLids => "hnm_eyelids",
        FeatureKind::Nose => "hnm_nose",
        FeatureKind::MouthGesture => "hnm_mouthgesture",
        FeatureKind::MouthPicture => "hnm_mouthpicture",
        FeatureKind::Extra => "hnm_extra",
    },
    also: &[("hns_extra", FeatureKind::Extra)],
};

/// The tier that a value belongs to.
pub(in crate::notation::sigml) fn tier_of(kind: FeatureKind) -> TierKind {
    match kind {
        FeatureKind::Shoulder => TierKind::Shoulder,
        FeatureKind::Body => TierKind::Body,
        FeatureKind::Head => TierKind::Head,
        FeatureKind::EyeGaze => TierKind::EyeGaze,
        FeatureKind::EyeBrows | FeatureKind::EyeLids | FeatureKind::Nose => TierKind::FacialExpression,
        FeatureKind::MouthGesture | FeatureKind::MouthPicture => TierKind::Mouthing,
        FeatureKind::Extra => TierKind::Extra,
    }
}
