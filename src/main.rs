//! The `chereme` program.

fn main() -> std::process::ExitCode {
    chereme::cli::run()
}
