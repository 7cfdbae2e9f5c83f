#[path = "it/cli.rs"]
mod cli;
#[path = "it/cli_corpus.rs"]
mod cli_corpus;
#[path = "it/corpus_build.rs"]
mod corpus_build;
#[path = "it/corpus_manifest.rs"]
mod corpus_manifest;
#[path = "it/corpus_recordings.rs"]
mod corpus_recordings;
#[path = "it/shared.rs"]
mod shared;
