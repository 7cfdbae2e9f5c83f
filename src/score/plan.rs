//! A plan: the items of a gloss line, one after the other, with every name resolved.

use crate::diagnostics::Span;
use crate::phonology::nonmanual::{Channel, NonManual};
use crate::phonology::operator::Operator;
use crate::phonology::recombination::Taken;
use crate::phonology::{Hand, Place, Sign};
use crate::time::Seconds;
use std::ops::Range;

/// What is signed, in order.
///
/// Signs stand as the signer signs them: recombined, and for a left-handed signer with the hands exchanged already.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Plan {
    /// One after the other.
    pub items: Vec<Item>,
    /// Non-manuals over several items, such as raised brows over a question.
    pub spans: Vec<Over>,
}

/// One item of a plan.
#[derive(Debug, Clone, PartialEq)]
pub struct Item {
    /// What the gloss tier says.
    pub gloss: String,
    /// What is done.
    pub act: Act,
    /// Where it stands in the text that it was read from.
    pub span: Option<Span>,
}

/// What is done in an item.
#[derive(Debug, Clone, PartialEq)]
pub enum Act {
    /// A sign, a pointing, a spelled word.
    Sign(Box<Sign>),
    /// The posture reached is held: of both hands, or of one while the other goes on with the next items.
    Hold(Option<Hand>, Option<Seconds>),
    /// Both hands go to the neutral pose, and rest.
    Rest(Option<Seconds>),
    /// A sign as it was captured, edited as motion.
    Captured(Box<Captured>),
}

/// A captured sign and what is done with it, in this order.
#[derive(Debug, Clone, PartialEq)]
pub struct Captured {
    /// Which motion.
    pub what: CapturedSign,
    /// Operators, one after the other, as far as motion can be operated on.
    pub operators: Vec<Operator>,
    /// How often it is made in all.
    pub times: u8,
    /// The hands are exchanged: the weak hand makes it, or the signer is left-handed.
    pub swapped: bool,
    /// Where it is moved to.
    pub place: Option<Place>,
}

/// Which captured motion a sign is.
#[derive(Debug, Clone, PartialEq)]
pub enum CapturedSign {
    /// One with this gloss: which, the corpus chooses.
    Gloss(String),
    /// Exactly this take, perhaps with channels of others.
    Take(Taken),
}

/// A non-manual value over a stretch of items.
#[derive(Debug, Clone, PartialEq)]
pub struct Over {
    /// Numbers of the items.
    pub items: Range<usize>,
    /// Which part of head, trunk or face.
    pub channel: Channel,
    /// What it does.
    pub value: NonManual,
}

impl Plan {
    /// A plan of one sign.
    pub fn of(sign: Sign) -> Plan {
        Plan {
            items: vec![Item { gloss: sign.name.clone(), act: Act::Sign(Box::new(sign)), span: None }],
            spans: Vec::new(),
        }
    }
}
