//! `chereme fmt`

use super::files::Text;
use super::{Failure, files, terminal};
use crate::notation::formats::Notation;
use crate::notation::syntax::{Content, File};
use crate::notation::{parse, print};
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  chereme fmt lexicon\n  chereme fmt --check lexicon     change nothing, name the files that would change\n  chereme fmt - < bol.sign        print to standard output\n\nA file with faults is left as it is."
)]
pub(super) struct Format {
    /// Files, folders, or - for standard input to standard output
    #[arg(required = true, value_name = "PATH")]
    paths: Vec<PathBuf>,
    /// Change nothing; name the files that would change, and exit with 1 where there are any
    #[arg(long)]
    check: bool,
}

impl Format {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let (mut faulty, mut changed, mut same) = (0, 0, 0);
        for text in files::read_in(&self.paths, &[Notation::Sign])? {
            if text.notation != Notation::Sign {
                let what = format!("{} is {}; fmt lays out .sign texts", text.source.name, text.notation.name());
                return Err(Failure::Usage(what));
            }
            let Some(new) = laid_out(&text) else {
                faulty += 1;
                continue;
            };
            let differs = new != text.source.text;
            match &text.path {
                None if !self.check => {
                    terminal::out(&new);
                    continue;
                }
                Some(path) if differs && !self.check => files::write_whole(path, new.as_bytes())?,
                _ if differs => terminal::out(&format!("{} would change\n", text.source.name)),
                _ => {}
            }
            if differs { changed += 1 } else { same += 1 }
        }
        if changed + same > 0 {
            let done = if self.check { "would change" } else { "laid out" };
            terminal::err(&format!("{} {done}, {same} already were\n", terminal::count(changed, "file")));
        }
        if faulty > 0 {
            let what = format!("{} with faults left as they are", terminal::count(faulty, "text"));
            return Err(Failure::Faults(Some(what)));
        }
        if self.check && changed > 0 { Err(Failure::Faults(None)) } else { Ok(()) }
    }
}

/// The text laid out; `None` where it has faults, which are told.
fn laid_out(text: &Text) -> Option<String> {
    let (file, mut faults) = parse(&text.source.text);
    faults.extend(text.fault.clone());
    if !faults.is_empty() {
        terminal::tell(&faults, &text.source);
        return None;
    }
    let new = print(&file);
    // A last look, since the file is about to be replaced: nothing may get lost.
    let again = parse(&new).0;
    if said(&file).eq(said(&again)) {
        return Some(new);
    }
    terminal::err(&format!("chereme: {} reads differently when laid out; please report it\n", text.source.name));
    None
}

fn said(file: &File) -> impl Iterator<Item = (&Option<Content>, &Option<String>)> {
    file.lines.iter().map(|l| (&l.content, &l.comment)).filter(|(c, comment)| c.is_some() || comment.is_some())
}
