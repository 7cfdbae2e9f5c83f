//! What the tests of synthesis share: the avatar, the lexicon, and measuring a clip.

use chereme::body::signer::Signer;
use chereme::motion::pose::ModelPose;
use chereme::notation::Lexicon;
use chereme::notation::{Vocabulary, read};
use chereme::phonology::Sign;
use chereme::phonology::operator::Tables;
use chereme::synthesis::{Grammar, Options, Performance, synthesize};
use chereme::time::Seconds;
use std::sync::OnceLock;

/// The avatar and the inventories, read once.
pub struct World {
    pub grammar: Grammar,
    pub signer: Signer,
    pub vocabulary: Vocabulary,
}

pub fn world() -> &'static World {
    static WORLD: OnceLock<World> = OnceLock::new();
    WORLD.get_or_init(|| World {
        grammar: Grammar::builtin(),
        signer: chereme::avatar::signer().unwrap(),
        vocabulary: Vocabulary::builtin(),
    })
}

/// The one sign of a text.
pub fn sign(text: &str) -> Sign {
    let reading = read(text, &world().vocabulary, "lsf");
    assert_eq!(reading.diagnostics, [], "{text}");
    reading.signs.into_iter().next().expect("a sign").sign
}

pub fn perform(sign: &Sign) -> Performance {
    perform_with(sign, &Options::default())
}

pub fn perform_with(sign: &Sign, options: &Options) -> Performance {
    let world = world();
    synthesize(sign, &world.grammar, &world.signer, options).unwrap_or_else(|e| panic!("{e}"))
}

/// The inventories that operators look things up in.
pub fn tables() -> Tables<'static> {
    Tables { locations: &world().grammar.locations, movements: &world().grammar.movements }
}

/// The embedded lexicon, read once.
pub fn lexicon() -> &'static Lexicon {
    static LEXICON: OnceLock<Lexicon> = OnceLock::new();
    LEXICON.get_or_init(Lexicon::builtin)
}

/// All signs of a language's lexicon, its letters included.
pub fn signs_of(language: &str) -> Vec<Sign> {
    let signs: Vec<Sign> = lexicon().entries().map(|e| e.sign.clone()).filter(|s| s.language == language).collect();
    assert!(!signs.is_empty(), "no signs of {language}");
    signs
}

/// The body at an instant of a performance, model space.
pub fn body_at(performance: &Performance, time: Seconds) -> ModelPose {
    performance.track.clip.sample(time).pose.to_model(&world().signer.skeleton)
}
