//! A sign shown at six places, and named from its motion alone.
//!
//! Naert et al. (2021, §7.1, figure 14) showed BOL spatialized to places of a scene and asked which of six it was; listeners found the
//! synthesized ones in 86 % of cases. Here the six are the neighbours of the neutral place along each axis of the grid of signing space
//! (right, left, low, high, near, far), and who is asked is the annotation: the hands' wrists, their mean while they sign, are nearest to
//! one of the six.

use crate::body::signer::Signer;
use crate::corpus::annotate::{Annotation, Annotator, Coverage, Options, Phase};
use crate::diagnostics::Error;
use crate::motion::clip::Clip;
use crate::motion::pose::ModelPose;
use crate::phonology::{Forced, Place, Placement, Relocation, Sign, Space};
use crate::synthesis::{self, Grammar, synthesize};
use glam::DVec3;

/// The six places: right, left, low, high, near and far of the neutral place.
pub const SIX_PLACES: [Space; 6] = [
    Space { left: -1, high: 0, far: 0 },
    Space { left: 1, high: 0, far: 0 },
    Space { left: 0, high: -1, far: 0 },
    Space { left: 0, high: 1, far: 0 },
    Space { left: 0, high: 0, far: -1 },
    Space { left: 0, high: 0, far: 1 },
];

/// The place of some at which a clip is signed: what the wrists' mean place is nearest to while the hands stroke and hold. `None` where no
/// hand signs, or of no places.
pub fn choose<'p>(
    places: &'p [Placement],
    clip: &Clip,
    annotation: &Annotation,
    annotator: &Annotator,
    signer: &Signer,
) -> Option<&'p Placement> {
    let (mut sum, mut count, mut body): (DVec3, usize, Option<ModelPose>) = (DVec3::ZERO, 0, None);
    for (n, frame) in clip.frames().iter().enumerate() {
        let time = clip.fps().time_of(crate::time::FrameIndex(n)).0;
        let signs = |hand: &&crate::corpus::annotate::HandAnnotation| {
            let during = |p: &&crate::corpus::annotate::Value<Phase>| p.start.0 <= time && time <= p.end.0;
            let phase = hand.phases.iter().find(during);
            phase.is_some_and(|p| matches!(p.value, Phase::Stroke | Phase::Hold))
        };
        let hands: Vec<_> = annotation.hands.iter().filter(signs).collect();
        if hands.is_empty() {
            continue;
        }
        let model = frame.pose.to_model(clip.skeleton());
        sum += hands.iter().map(|hand| model.position(signer.arm(hand.side).hand)).sum::<DVec3>();
        count += hands.len();
        body.get_or_insert(model);
    }
    let model = body?;
    annotator.placer().nearest_of(places, sum / count.max(1) as f64, &model)
}

/// A sign moved to each of the six places and named from its motion: for each place the one that was chosen.
///
/// # Errors
/// Those of the synthesis.
///
/// ```
/// use chereme::corpus::annotate::Annotator;
/// use chereme::evaluation::annotation::{SIX_PLACES, six_places};
/// use chereme::notation::Lexicon;
/// use chereme::synthesis::Grammar;
/// let (grammar, signer) = (Grammar::builtin(), chereme::avatar::signer().unwrap());
/// let annotator = Annotator::new(&signer, &grammar.handshapes, &grammar.locations);
/// let bol = &Lexicon::builtin().find("BOL", Some("lsf")).unwrap().sign.clone();
/// let named = six_places(bol, &annotator, &grammar, &signer).unwrap();
/// assert_eq!(named, SIX_PLACES.map(Some));
/// ```
pub fn six_places(
    sign: &Sign,
    annotator: &Annotator,
    grammar: &Grammar,
    signer: &Signer,
) -> Result<[Option<Space>; 6], Error> {
    let places = SIX_PLACES.map(|cell| Placement::at(Place::Space(cell)));
    let mut named = [None; 6];
    for (name, cell) in named.iter_mut().zip(SIX_PLACES) {
        let relocated = Some(Relocation { place: Place::Space(cell), forced: Forced::No });
        let moved = Sign { relocated, ..sign.clone() };
        let clip = synthesize(&moved, grammar, signer, &synthesis::Options::default())?.track.clip;
        let annotation = annotator.annotate(&clip, Coverage::WHOLE, &Options::default());
        let chosen = choose(&places, &clip, &annotation, annotator, signer);
        *name = chosen.and_then(|p| if let Place::Space(cell) = p.place { Some(cell) } else { None });
    }
    Ok(named)
}
