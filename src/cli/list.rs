//! `chereme list`

use super::{Failure, Sources, terminal, world};
use crate::notation::{Names, Vocabulary};

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  chereme list --language lsf\n  chereme list --where\n  chereme list --handshapes")]
pub(super) struct List {
    /// Only signs of this language
    #[arg(long, value_name = "NAME")]
    language: Option<String>,
    /// Show the file and line of each sign
    #[arg(long)]
    r#where: bool,
    /// List handshapes instead
    #[arg(long, conflicts_with_all = ["places", "nonmanuals"])]
    handshapes: bool,
    /// List places instead
    #[arg(long, conflicts_with = "nonmanuals")]
    places: bool,
    /// List non-manual values instead
    #[arg(long)]
    nonmanuals: bool,
}

impl List {
    pub(super) fn run(&self, sources: &Sources) -> Result<(), Failure> {
        let words = world::words(&world::grammar(sources)?);
        if self.handshapes || self.places || self.nonmanuals {
            terminal::out(&self.names(&words.vocabulary));
            return Ok(());
        }
        let lexicon = world::lexicon(sources, &words)?;
        let mut rows = Vec::new();
        for entry in lexicon.entries() {
            if self.language.as_ref().is_some_and(|l| !l.eq_ignore_ascii_case(&entry.sign.language)) {
                continue;
            }
            let meaning = entry.sign.meaning.first().map(|(_, words)| words.clone()).unwrap_or_default();
            let place = format!("{}{}:{}", if entry.layer == 0 { "built in " } else { "" }, entry.path, entry.line);
            rows.push([entry.sign.language.clone(), entry.sign.name.clone(), meaning, place]);
        }
        if rows.is_empty() {
            let of = self.language.as_ref().map(|l| format!(" of `{l}`")).unwrap_or_default();
            terminal::err(&format!("there are no signs{of}\n"));
            return Ok(());
        }
        terminal::out(&columns(&rows, if self.r#where { 4 } else { 3 }));
        Ok(())
    }

    fn names(&self, vocabulary: &Vocabulary) -> String {
        let lines = |names: &Names| names.ids().map(|id| format!("{id}\n")).collect::<String>();
        if self.handshapes {
            lines(&vocabulary.handshapes)
        } else if self.places {
            lines(&vocabulary.places)
        } else {
            let all = vocabulary.nonmanuals.iter();
            all.flat_map(|(channel, names)| names.ids().map(move |id| format!("{:10}{id}\n", channel.name()))).collect()
        }
    }
}

/// Rows with their first columns aligned.
fn columns(rows: &[[String; 4]], shown: usize) -> String {
    let width = |i: usize| rows.iter().map(|r| r[i].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..shown).map(width).collect();
    let mut text = String::new();
    for row in rows {
        let cells: Vec<String> = widths.iter().zip(row).map(|(w, cell)| format!("{cell:w$}")).collect();
        text.push_str(cells.join("  ").trim_end());
        text.push('\n');
    }
    text
}
