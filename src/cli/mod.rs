//! The command line: files, folders, printing and exit codes. Nothing else of the crate touches them.
//!
//! Exit codes: 0 where all is well (warnings included), 1 where a text has faults or a task failed, 2 where the
//! command line itself is wrong (an unknown option, a file that is not there).

mod check;
mod convert;
mod corpus;
mod evaluate;
mod explain;
mod files;
mod format;
mod gloss;
mod list;
mod new;
mod parallel;
mod profile;
mod render;
mod signs;
mod template;
mod terminal;
mod world;

use clap::{Args, CommandFactory, Parser, Subcommand};
use std::path::PathBuf;
use std::process::ExitCode;

/// Signs written as text, one tier a line.
#[derive(Debug, Parser)]
#[command(
    name = "chereme",
    version,
    arg_required_else_help = true,
    after_help = "Examples:\n  chereme render BOL -o bol.html            see it signed, in a browser\n  chereme render \"BONJOUR, CHIEN BOL@left\" -o line.html\n                                            a line of glosses, as one motion\n  chereme new BOL -o lexicon/lsf/bol.sign   begin a sign\n  chereme check lexicon                     find its faults\n  chereme fmt lexicon                       lay it out\n  chereme convert haus.sigml -o haus.sign   from one notation to another\n  chereme explain BOL                       say it in plain words\n\nExit codes: 0 fine, 1 faults found, 2 wrong usage."
)]
struct Cli {
    #[command(flatten)]
    sources: Sources,
    #[command(subcommand)]
    command: Command,
}

/// Where names come from.
#[derive(Debug, Args)]
pub(crate) struct Sources {
    /// A folder of signs that adds to or overrides the program's own (repeatable; ./lexicon is looked at too)
    #[arg(long, value_name = "DIR", global = true)]
    lexicon: Vec<PathBuf>,
    /// A folder of inventories (handshapes.ron, locations.ron, nonmanuals.ron) that adds to or overrides the program's
    /// own (repeatable; ./grammar is looked at too)
    #[arg(long, value_name = "DIR", global = true)]
    grammar: Vec<PathBuf>,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Turn signs into motion: a page to look at, or a file for other programs
    Render(render::Render),
    /// Measure motions: speeds, heights, fingertips over time, as tables and figures, and against golden ones
    Profile(Box<profile::ProfileArgs>),
    /// Find the faults of signs, and of their motion
    Check(check::Check),
    /// Convert signs from any notation to any other: .sign, HamNoSys, SiGML
    Convert(convert::Convert),
    /// Recordings of signing: begin, check and build a corpus of motion capture and annotations
    Corpus(corpus::Corpus),
    /// Lay signs out: two spaces before a tier, values in one column, comments kept
    Fmt(format::Format),
    /// List the signs, handshapes or places that are known
    List(list::List),
    /// Begin a sign: a template with all tiers as comments
    New(new::New),
    /// Say a sign in plain words: each tier, and where its value comes from
    Explain(explain::Explain),
    /// The paper's analyses: questionnaires and their ratings, interpolations against captured motion, lags between channels
    Evaluate(Box<evaluate::EvaluateArgs>),
    /// Print a completion script for a shell
    #[command(after_help = "Example:\n  chereme completions bash > ~/.local/share/bash-completion/completions/chereme")]
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
}

/// Why a command did not do its task.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Faults were found and told, or a task failed with this message.
    Faults(Option<String>),
    /// The command line is wrong.
    Usage(String),
}

/// Runs the program with the arguments of the process.
pub fn run() -> ExitCode {
    let cli = Cli::parse();
    let done = match cli.command {
        Command::Render(render) => render.run(&cli.sources),
        Command::Profile(profile) => profile.run(&cli.sources),
        Command::Check(check) => check.run(&cli.sources),
        Command::Convert(convert) => convert.run(&cli.sources),
        Command::Corpus(corpus) => corpus.run(&cli.sources),
        Command::Fmt(format) => format.run(),
        Command::List(list) => list.run(&cli.sources),
        Command::New(new) => new.run(),
        Command::Explain(explain) => explain.run(&cli.sources),
        Command::Evaluate(evaluate) => evaluate.run(&cli.sources),
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(shell, &mut Cli::command(), "chereme", &mut script);
            terminal::out(&String::from_utf8_lossy(&script));
            Ok(())
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure::Faults(message)) => {
            if let Some(message) = message {
                terminal::err(&format!("chereme: {message}\n"));
            }
            ExitCode::from(1)
        }
        Err(Failure::Usage(message)) => {
            terminal::err(&format!("chereme: {message}\n"));
            ExitCode::from(2)
        }
    }
}
