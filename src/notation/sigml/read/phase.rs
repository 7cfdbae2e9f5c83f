//! `sign_manual`: one phase, or several within each other, to any depth.

use super::place::PLACES;
use super::reader::{Node, Reader, attributes, elements, tag_span};
use crate::notation::hamnosys::syntax::{Hands, Ignored, Phase, Posture, Symmetry};

/// Elements that a phase has besides places and motions.
const CONFIGS: [&str; 3] = ["handconfig", "split_handconfig", "nonmanualconfig"];

impl<'a> Reader<'a> {
    /// The outermost `sign_manual`. One with nothing in it is a sign that the hands do not make.
    pub(super) fn manual(&mut self, node: Node<'a>, phases: &mut Vec<Phase>) {
        if node.attributes().len() == 0 && !node.has_children() {
            return;
        }
        self.phases(node, Hands::Strong, phases);
    }

    fn phases(&mut self, node: Node<'a>, outer: Hands, phases: &mut Vec<Phase>) {
        let mut phase = Phase {
            hands: outer,
            holds_over: false,
            body: Vec::new(),
            posture: Posture::default(),
            location: None,
            actions: Vec::new(),
            span: Ignored(node.range().into()),
        };
        self.hands(node, &mut phase);
        self.no_text(node);
        let is_phase = |child: &Node| child.tag_name().name() == "sign_manual";
        if !elements(node).any(|child| is_phase(&child)) {
            elements(node).for_each(|child| self.content(child, &mut phase));
            phases.push(phase);
            return;
        }
        if node.attributes().len() > 0 {
            let told = self.warning(tag_span(node), "this `sign_manual` holds others: what it says is said of each");
            self.say(told.label("here"));
        }
        let direct = elements(node).any(|child| !is_phase(&child));
        if direct {
            let told = self.warning(tag_span(node), "phases and their parts stand side by side");
            self.say(told.label("what stands directly in it is read as a phase before the others"));
            let mut first = phase.clone();
            elements(node).filter(|child| !is_phase(child)).for_each(|child| self.content(child, &mut first));
            phases.push(first);
        }
        let hands = phase.hands;
        elements(node).filter(is_phase).for_each(|child| self.phases(child, hands, phases));
    }

    /// Which hands act.
    fn hands(&mut self, node: Node<'a>, phase: &mut Phase) {
        const KNOWN: &[&str] =
            &["both_hands", "lr_symm", "ud_symm", "oi_symm", "outofphase", "realspace", "nondominant", "holdover"];
        let (mut both, mut weak, mut written) = (None, None, false);
        let mut symmetry = Symmetry::default();
        for attr in attributes(node) {
            let flag = match attr.name {
                "lr_symm" => &mut symmetry.left_right,
                "ud_symm" => &mut symmetry.up_down,
                "oi_symm" => &mut symmetry.out_in,
                "outofphase" | "alternating" => &mut symmetry.alternating,
                "realspace" => &mut symmetry.non_ipsi,
                "both_hands" => {
                    both = Some(self.truth(&attr));
                    continue;
                }
                "nondominant" => {
                    weak = Some(self.truth(&attr));
                    continue;
                }
                "holdover" => {
                    phase.holds_over = self.truth(&attr);
                    continue;
                }
                _ => {
                    self.unknown_attribute(&attr, KNOWN);
                    continue;
                }
            };
            *flag = self.truth(&attr);
            written |= *flag;
        }
        if written && both != Some(true) {
            let told = self.warning(tag_span(node), "a symmetry without `both_hands=\"true\"`: both hands are meant");
            self.say(told.label("here"));
        }
        phase.hands = match (both == Some(true) || written, weak) {
            (true, Some(true)) => {
                let told = self.warning(tag_span(node), "both hands and the weak hand alone: both are read");
                self.say(told.label("here"));
                Hands::Both(symmetry)
            }
            (true, _) => Hands::Both(symmetry),
            (false, Some(true)) => Hands::Weak,
            (false, Some(false)) => Hands::Strong,
            (false, None) if both == Some(false) => Hands::Strong,
            (false, None) => phase.hands,
        };
    }

    /// An element within a phase.
    fn content(&mut self, node: Node<'a>, phase: &mut Phase) {
        let name = node.tag_name().name();
        match name {
            "handconfig" => {
                let config = self.handconfig(node);
                if config.weak {
                    let told = self.warning(tag_span(node), "`nondominant` is no hand shape: the weak hand is meant");
                    self.say(told.label("here").hint("write `nondominant=\"true\"` on the `sign_manual`"));
                    phase.hands = match phase.hands {
                        Hands::Strong | Hands::Weak => Hands::Weak,
                        Hands::Both(symmetry) => Hands::Both(symmetry),
                    };
                }
                self.add(&mut phase.posture, config, node);
            }
            "split_handconfig" => self.split_handconfig(node, &mut phase.posture),
            "nonmanualconfig" => phase.body.extend(self.of_body(node)),
            _ if PLACES.contains(&name) => {
                if phase.location.is_some() {
                    let told = self.warning(tag_span(node), "the phase has a place already: this one is passed over");
                    self.say(told.label("not read").hint("a place for each hand goes into a `split_location`"));
                } else {
                    phase.location = self.location(node);
                }
            }
            _ => phase.actions.extend(self.action(node, &CONFIGS)),
        }
    }
}
