//! The first half of a BVH file: joints in braces.

use super::data::{Channel, Joint};
use super::number::number;
use super::words::{Word, Words};
pub(super) use crate::diagnostics::xml::short;
use crate::diagnostics::{Diagnostic, Span};
use glam::DVec3;
use std::collections::HashMap;

/// A fault that makes the rest of the hierarchy unreadable.
type Stop = Box<Diagnostic>;

/// Faults and warnings beyond this many would only take memory.
const MOST_NOTES: usize = 100;

/// What is being described between braces.
#[derive(Clone, Copy, PartialEq)]
enum Block {
    Joint(usize),
    EndSite(usize),
}

/// A brace that is not closed yet.
struct Open {
    block: Block,
    brace: Span,
    has_offset: bool,
    has_channels: bool,
}

/// Joints in the making.
pub(super) struct Hierarchy {
    pub joints: Vec<Joint>,
    /// Where each joint's name stands.
    names: Vec<Span>,
    open: Vec<Open>,
    pub notes: Vec<Diagnostic>,
}

/// Reads from `HIERARCHY` up to `MOTION`, which it leaves unread. Faults and warnings are in `notes`; after a fault that
/// leaves open what belongs to what, reading stops there.
pub(super) fn hierarchy(words: &mut Words) -> Hierarchy {
    let mut made = Hierarchy { joints: vec![], names: vec![], open: vec![], notes: vec![] };
    if let Err(stop) = made.read(words) {
        made.notes.push(*stop);
    }
    made.check_names();
    made
}

impl Hierarchy {
    fn read(&mut self, words: &mut Words) -> Result<(), Stop> {
        match words.next() {
            Some(word) if word.is("HIERARCHY") => {}
            Some(word) => {
                let hint = "a BVH file begins with the line HIERARCHY; is this another kind of file?";
                return Err(stop(word.span, "this is no BVH file", "expected HIERARCHY").hint(hint).into());
            }
            None => return Err(stop(words.here(), "the file is empty", "expected HIERARCHY").into()),
        }
        while let Some(word) = words.peek() {
            if word.is("MOTION") {
                break;
            }
            if self.notes.len() >= MOST_NOTES {
                return Err(stop(word.span, "too many faults and warnings", "the rest is not read").into());
            }
            words.next();
            self.entry(word, words)?;
        }
        if let Some(open) = self.open.last() {
            let what = match open.block {
                Block::Joint(joint) => format!("joint {}", self.joints[joint].name),
                Block::EndSite(joint) => format!("the End Site of {}", self.joints[joint].name),
            };
            let (at, label) = match words.peek() {
                Some(motion) => (motion.span, "expected } before this"),
                None => (words.here(), "expected }"),
            };
            let n = self.open.len();
            let message = if n == 1 { "a brace is not closed".into() } else { format!("{n} braces are not closed") };
            return Err(stop(at, message, label).related(open.brace, format!("{what} begins here")).into());
        }
        if self.joints.is_empty() {
            return Err(stop(words.here(), "the hierarchy has no joint", "expected ROOT and a name").into());
        }
        Ok(())
    }

    fn entry(&mut self, word: Word, words: &mut Words) -> Result<(), Stop> {
        let inside = self.open.last().map(|open| open.block);
        if word.is("ROOT") || word.is("JOINT") {
            self.joint(word, inside, words)
        } else if word.is("End") {
            self.end_site(word, inside, words)
        } else if word.is("OFFSET") {
            self.offset(word, words)
        } else if word.is("CHANNELS") {
            self.channels(word, words)
        } else if word.text == "}" {
            self.close(word)
        } else if word.text == "{" {
            Err(stop(word.span, "a brace without a joint", "expected ROOT, JOINT or End Site before it").into())
        } else if word.is("HIERARCHY") {
            let hint = "if these are two files in one, cut them apart";
            Err(stop(word.span, "HIERARCHY is said twice", "a second hierarchy").hint(hint).into())
        } else {
            let expected = match inside {
                None => "expected ROOT or MOTION",
                Some(Block::Joint(_)) => "expected OFFSET, CHANNELS, JOINT, End Site or }",
                Some(Block::EndSite(_)) => "expected OFFSET or }",
            };
            Err(stop(word.span, format!("`{}` is not a word of a BVH hierarchy", short(word.text)), expected).into())
        }
    }

    fn joint(&mut self, word: Word, inside: Option<Block>, words: &mut Words) -> Result<(), Stop> {
        let parent = match (word.is("ROOT"), inside) {
            (true, None) => None,
            (false, Some(Block::Joint(parent))) => Some(parent),
            (true, Some(_)) => {
                let fault = stop(word.span, "a ROOT inside a joint", "expected JOINT");
                return Err(fault.hint("or a } is missing before it").into());
            }
            (false, None) => {
                let fault = stop(word.span, "a JOINT without a parent", "expected ROOT");
                return Err(fault.hint("the first joint is a ROOT; after it, a } may stand too early").into());
            }
            (false, Some(Block::EndSite(_))) => {
                let fault = stop(word.span, "a JOINT inside an End Site", "expected OFFSET or }");
                return Err(fault.hint("an End Site only says where the last bone ends").into());
            }
        };
        let name = words.rest_of_line();
        if name.text.is_empty() {
            return Err(stop(word.span, format!("a {} without a name", word.text), "expected a name after it").into());
        }
        let at = self.joints.len();
        let name_text = name.text.to_owned();
        self.joints.push(Joint { name: name_text, parent, offset: DVec3::ZERO, channels: vec![], end_sites: vec![] });
        self.names.push(name.span);
        self.brace(Block::Joint(at), words)
    }

    fn end_site(&mut self, word: Word, inside: Option<Block>, words: &mut Words) -> Result<(), Stop> {
        let Some(Block::Joint(joint)) = inside else {
            return Err(stop(word.span, "an End Site outside a joint", "expected it inside the last joint").into());
        };
        let rest = words.rest_of_line();
        if !rest.text.split_whitespace().next().is_some_and(|site| site.eq_ignore_ascii_case("Site")) {
            return Err(stop(word.span.to(rest.span), "`End` without `Site`", "expected End Site").into());
        }
        self.joints[joint].end_sites.push(DVec3::ZERO);
        self.brace(Block::EndSite(joint), words)
    }

    /// The brace that opens a block, on the same line or below.
    fn brace(&mut self, block: Block, words: &mut Words) -> Result<(), Stop> {
        let here = words.here();
        match words.peek() {
            Some(word) if word.text == "{" => {
                words.next();
                self.open.push(Open { block, brace: word.span, has_offset: false, has_channels: false });
                Ok(())
            }
            Some(word) => Err(stop(word.span, "a { is missing", "expected { before this").into()),
            None => Err(stop(here, "the file ends inside the hierarchy", "expected {").into()),
        }
    }

    fn close(&mut self, word: Word) -> Result<(), Stop> {
        let Some(open) = self.open.pop() else {
            let fault = stop(word.span, "a } without its {", "nothing is open here");
            return Err(fault.hint("a } too many before this one ends a joint too early").into());
        };
        if !open.has_offset {
            self.notes.push(stop(open.brace, "an OFFSET is missing", "expected OFFSET x y z in this block"));
        }
        if let Block::Joint(joint) = open.block
            && !open.has_channels
        {
            let message = format!("joint {} has no CHANNELS", self.joints[joint].name);
            let warning = Diagnostic::warning(open.brace, message).label("no CHANNELS in this block");
            self.notes.push(warning.hint("it counts as `CHANNELS 0`: a joint that never moves"));
        }
        Ok(())
    }

    fn offset(&mut self, word: Word, words: &mut Words) -> Result<(), Stop> {
        let Some(open) = self.open.last_mut() else {
            return Err(stop(word.span, "an OFFSET outside a joint", "expected ROOT before it").into());
        };
        if std::mem::replace(&mut open.has_offset, true) {
            self.notes.push(stop(word.span, "a second OFFSET in one block", "expected one"));
        }
        let block = open.block;
        let mut xyz = [0.0; 3];
        for (value, axis) in xyz.iter_mut().zip(["x", "y", "z"]) {
            let Some(said) = words.next_on_line() else {
                let fault = stop(word.span, "an OFFSET is three numbers", format!("{axis} is missing"));
                return Err(fault.into());
            };
            match finite(said) {
                Ok(number) => *value = number,
                Err(fault) => self.notes.push(*fault),
            }
        }
        if let Some(more) = words.clone().next_on_line().filter(|w| w.text != "}") {
            let label = "expected the end of the line";
            self.notes.push(stop(more.span, "an OFFSET is three numbers", label));
            words.rest_of_line();
        }
        let value = DVec3::from_array(xyz);
        match block {
            Block::Joint(joint) => self.joints[joint].offset = value,
            Block::EndSite(joint) => {
                if let Some(site) = self.joints[joint].end_sites.last_mut() {
                    *site = value;
                }
            }
        }
        Ok(())
    }

    fn channels(&mut self, word: Word, words: &mut Words) -> Result<(), Stop> {
        let Some(Open { block: Block::Joint(joint), has_channels, .. }) = self.open.last_mut() else {
            return Err(stop(word.span, "CHANNELS outside a joint", "expected it inside ROOT or JOINT").into());
        };
        let joint = *joint;
        if std::mem::replace(has_channels, true) {
            return Err(stop(word.span, "a second CHANNELS in one joint", "expected one").into());
        }
        let Some(said) = words.next_on_line() else {
            return Err(stop(word.span, "CHANNELS without a count", "expected a number from 0 to 6").into());
        };
        let Some(count) = said.text.parse::<usize>().ok().filter(|n| *n <= 6) else {
            let message = format!("`{}` is not a count of channels", short(said.text));
            return Err(stop(said.span, message, "expected a number from 0 to 6").into());
        };
        let mut last = said.span;
        let mut listed = 0;
        while let Some(name) = words.clone().next_on_line().filter(|w| w.text != "}" && listed <= Channel::ALL.len()) {
            words.next_on_line();
            (listed, last) = (listed + 1, name.span);
            match Channel::ALL.into_iter().find(|c| name.is(c.word())) {
                None => self.notes.push(unknown_channel(name)),
                Some(channel) if self.joints[joint].channels.contains(&channel) => {
                    let message = format!("{} is listed twice", channel.word());
                    self.notes.push(stop(name.span, message, "each channel is listed once"));
                }
                Some(channel) => self.joints[joint].channels.push(channel),
            }
        }
        if listed != count {
            words.rest_of_line();
            let message = format!("CHANNELS says {count}, and {listed} are listed");
            let fault = stop(said.span.to(last), message, "count and list differ");
            self.notes.push(fault.hint("the list stands on the line of its count"));
        }
        Ok(())
    }

    /// Two joints of one name are told apart by number only; that is odd, not wrong.
    fn check_names(&mut self) {
        let mut seen: HashMap<&str, Span> = HashMap::new();
        for (joint, span) in self.joints.iter().zip(&self.names) {
            if self.notes.len() >= MOST_NOTES {
                break;
            }
            if let Some(first) = seen.insert(&joint.name, *span) {
                let warning = Diagnostic::warning(*span, format!("two joints are named {}", short(&joint.name)));
                self.notes.push(warning.label("the second").related(first, "the first"));
            }
        }
    }
}

/// A fault with its expectation at the caret.
pub(super) fn stop(span: Span, message: impl Into<String>, label: impl Into<String>) -> Diagnostic {
    Diagnostic::fault(span, message).label(label)
}

/// A word that is a finite number, all of it; else what is wrong with it.
pub(super) fn finite(word: Word) -> Result<f64, Stop> {
    let fault = |message: String, hint: &str| {
        let fault = stop(word.span, message, "expected a number");
        Err(Box::new(if hint.is_empty() { fault } else { fault.hint(hint) }))
    };
    let text = short(word.text);
    match number(word.text.as_bytes()) {
        Some((value, length)) if length == word.text.len() && value.is_finite() => Ok(value),
        Some((_, length)) if length == word.text.len() => fault(format!("{text} is too large a number"), ""),
        _ if is_not_finite(word.text) => {
            fault(format!("{text} is not a finite number"), "the program that wrote this divided by zero somewhere")
        }
        _ if word.text.contains(',') => fault(
            format!("`{text}` is not a number"),
            "decimals are written with a point, and numbers parted by spaces",
        ),
        _ => fault(format!("`{text}` is not a number"), ""),
    }
}

/// Whether a word is how some program writes what is no number: `nan`, `-inf`, `1.#QNAN`, `-nan(ind)`.
fn is_not_finite(word: &str) -> bool {
    let word = word.to_ascii_lowercase();
    let bare = word.trim_start_matches(['-', '+']);
    bare.starts_with("nan") || bare.starts_with("inf") || bare.contains('#')
}

fn unknown_channel(word: Word) -> Diagnostic {
    let all = Channel::ALL.map(Channel::word).join(", ");
    let fault = stop(word.span, format!("`{}` is not a channel", short(word.text)), "expected a channel");
    let scaled = word.text.to_ascii_lowercase().ends_with("scale");
    fault.hint(if scaled { "scales are not of BVH; export without them".into() } else { format!("channels are {all}") })
}
