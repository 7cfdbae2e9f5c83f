//! The `chereme` program.
fn main() {}
