//! Reading SiGML: a file of signs of both kinds.

mod action;
mod movement;
mod nonmanual;
mod phase;
mod place;
mod posture;
mod reader;
mod shape;
mod tokens;

use super::{MOST_BYTES, MOST_DEEP, words};
use crate::diagnostics::xml::Xml;
use crate::diagnostics::{Diagnostic, Source};
use crate::notation::hamnosys::syntax::{Ignored, Sign};
use reader::{Node, Reader, attributes, elements, short};

/// Reads the signs of a SiGML file: those without a fault, and everything that is to be said of the others.
///
/// ```
/// use chereme::{diagnostics::Source, notation::sigml};
/// let text = r#"<sigml><hamgestural_sign gloss="HOUSE"><sign_manual both_hands="true" lr_symm="true">
///     <handconfig handshape="flat" extfidir="uo" palmor="l"/>
///     <directedmotion direction="do"/>
/// </sign_manual></hamgestural_sign></sigml>"#;
/// let (signs, told) = sigml::read(&Source::new("house.sigml", text));
/// assert_eq!(signs[0].gloss.as_deref(), Some("HOUSE"));
/// assert_eq!(signs[0].phases[0].actions.len(), 1);
/// assert!(told.is_empty());
/// ```
pub fn read(source: &Source) -> (Vec<Sign>, Vec<Diagnostic>) {
    let text = source.text.as_str();
    let format = Xml { name: "SiGML", most_bytes: MOST_BYTES, most_deep: MOST_DEEP };
    let document = match format.parse(text) {
        Ok(document) => document,
        Err(fault) => return (Vec::new(), vec![fault]),
    };
    let mut reader = Reader::new();
    let mut signs = Vec::new();
    reader.file(document.root_element(), &mut signs);
    (signs, reader.told())
}

impl<'a> Reader<'a> {
    /// The root: `sigml`, or one sign.
    fn file(&mut self, root: Node<'a>, signs: &mut Vec<Sign>) {
        match root.tag_name().name() {
            "sigml" | "hamgestural_sign" | "hns_sign" => self.top(root, signs),
            name => {
                let message = format!("`{}` is not the beginning of SiGML", short(name));
                let fault = Diagnostic::fault(reader::tag_span(root), message).label("the root of this file");
                let hint = "signs are `hns_sign` or `hamgestural_sign` elements, as a rule within `sigml`";
                self.say(fault.hint(hint));
            }
        }
    }

    fn top(&mut self, node: Node<'a>, signs: &mut Vec<Sign>) {
        match node.tag_name().name() {
            "sigml" => {
                self.no_text(node);
                elements(node).for_each(|child| self.top(child, signs));
            }
            "hamgestural_sign" => self.sign(node, signs, Reader::gestural),
            "hns_sign" => self.sign(node, signs, Reader::plain),
            "signing_ref" => {
                let told = self.warning(reader::tag_span(node), "another file is named here, and is not read");
                self.say(told.label("passed over").hint("read that file by itself"));
            }
            _ => self.unknown_element(node, &["hns_sign", "hamgestural_sign"]),
        }
    }

    /// A sign, kept where it has no fault.
    fn sign(&mut self, node: Node<'a>, signs: &mut Vec<Sign>, body: fn(&mut Reader<'a>, Node<'a>, &mut Sign)) {
        let mut sign = Sign { span: Ignored(node.range().into()), ..Sign::default() };
        self.next_sign(node.attribute("gloss"));
        let faults = self.faults();
        for attr in attributes(node) {
            match attr.name {
                "gloss" => sign.gloss = Some(attr.raw.to_owned()),
                "speed" => sign.timing.speed = self.factor(&attr),
                "duration" => sign.timing.duration = self.factor(&attr),
                "timescale" => sign.timing.timescale = self.factor(&attr),
                _ => self.unknown_attribute(&attr, &["gloss", "speed", "duration", "timescale"]),
            }
        }
        body(self, node, &mut sign);
        if self.faults() == faults {
            signs.push(sign);
        }
        self.end_sign();
    }

    fn gestural(&mut self, node: Node<'a>, sign: &mut Sign) {
        self.no_text(node);
        for child in elements(node) {
            match child.tag_name().name() {
                "sign_nonmanual" => self.nonmanual(child, &mut sign.nonmanual),
                "sign_manual" => self.manual(child, &mut sign.phases),
                _ => self.unknown_element(child, &["sign_nonmanual", "sign_manual"]),
            }
        }
    }

    fn plain(&mut self, node: Node<'a>, sign: &mut Sign) {
        self.no_text(node);
        for child in elements(node) {
            match child.tag_name().name() {
                "hamnosys_nonmanual" => self.plain_nonmanual(child, &mut sign.nonmanual),
                "hamnosys_manual" => self.plain_manual(child, &mut sign.phases),
                _ => self.unknown_element(child, &["hamnosys_nonmanual", "hamnosys_manual"]),
            }
        }
    }
}
