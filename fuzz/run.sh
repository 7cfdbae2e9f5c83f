#!/usr/bin/env bash
# Fuzzes one reader: bash fuzz/run.sh TARGET SECONDS [options of libFuzzer]
# TARGET is sign_text, hamnosys, sigml, table, gloss, bvh, eaf, textgrid, segments, markers, corpus_yaml, corpus_query,
# corpus_cache or glb_rig. What fails lies in fuzz/found/TARGET afterwards; new inputs that reach new code are kept in
# fuzz/found/TARGET/corpus, so that the small corpus that we keep stays as it is.
set -euo pipefail
cd "$(dirname "$0")"
target=${1:?which target} seconds=${2:?how many seconds}
shift 2
host=$(rustc -vV | sed -n 's/^host: //p')

# Coverage and the address sanitizer without cargo-fuzz and without a nightly compiler.
export RUSTC_BOOTSTRAP=1
export RUSTFLAGS="--cfg fuzzing -Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 \
-Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table \
-Cllvm-args=-sanitizer-coverage-trace-compares -Zsanitizer=address -Ccodegen-units=1"
cargo build --release --locked --target "$host" --bin "$target"

mkdir -p "found/$target/corpus"
"${CARGO_TARGET_DIR:-target}/$host/release/$target" "found/$target/corpus" "corpus/$target" \
  -dict=words.dict -artifact_prefix="found/$target/" -max_total_time="$seconds" -max_len=4096 -timeout=10 -rss_limit_mb=1024 "$@"
