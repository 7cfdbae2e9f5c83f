//! `chereme new`

use super::{Failure, files, terminal};
use crate::notation::print::sign_name;
use std::path::PathBuf;
use unicode_normalization::UnicodeNormalization;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  chereme new BOL\n  chereme new BOL -o lexicon/lsf/bol.sign\n  chereme new BOL --language lsf -o bol.sign"
)]
pub(super) struct New {
    /// The name of the sign
    name: String,
    /// The file to write; standard output without it
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// The sign language, where the folder does not say it
    #[arg(long)]
    language: Option<String>,
    /// Replace a file that is there
    #[arg(long)]
    force: bool,
}

impl New {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let name: String = self.name.trim().nfc().collect();
        if name.is_empty() {
            return Err(Failure::Usage("a sign needs a name".to_owned()));
        }
        if let Some(l) = &self.language
            && (l.is_empty() || l.contains(|c: char| c.is_whitespace() || c.is_control() || ",()=\"#".contains(c)))
        {
            return Err(Failure::Usage(format!("`{l}` is no short name of a language, such as `lsf`")));
        }
        let text = template(&name, self.language.as_deref());
        let Some(path) = &self.output else {
            terminal::out(&text);
            return Ok(());
        };
        if path.exists() && !self.force {
            return Err(Failure::Faults(Some(format!("`{}` is there already; --force replaces it", path.display()))));
        }
        if let Some(folder) = path.parent().filter(|f| !f.as_os_str().is_empty()) {
            std::fs::create_dir_all(folder).map_err(|e| Failure::Faults(Some(format!("{}: {e}", folder.display()))))?;
        }
        files::write_whole(path, text.as_bytes())?;
        terminal::err(&format!("wrote {}\n", path.display()));
        Ok(())
    }
}

/// A sign that can be used as it is, with every other tier as a comment.
fn template(name: &str, language: Option<&str>) -> String {
    let head = language.map(|l| format!("language {l}\n\n")).unwrap_or_default();
    let name = sign_name(name);
    format!(
        r#"{head}sign {name}
  # Change the values, take the # away from the tiers you need, delete the rest.
  # meaning        en "bowl", fr "bol"
  # source         "who signs it so, where it is described"
  status         unverified
  # hands          both mirrored          one | weak | both | both mirrored | both parallel
  configuration  flat
  # configuration  U, thumb out           a change; `chereme list --handshapes` has the names
  # configuration  L then S then F        one value at each key
  placement      chest, neutral distance
  # placement      forehead right, touch, with index tip
  orientation    fingers up, palm in
  # Directions are the signer's: up down left right out in, joined by hyphens: up-left, down-out.
  movement       out 10cm
  # movement       arc up-right 15cm then circle axis out radius 5cm, repeated 2
  # movement       down 5cm to other palm, touch, fast while wiggle
  # contact        strong index tip touches weak palm at end
  # duration       0.9s
  # brows          raised
  # gaze           towards out
  # mouth          mouthing "bOl"
"#
    )
}
