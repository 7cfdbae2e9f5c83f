#!/usr/bin/env bash
# Kills `chereme corpus build` at a hundred random instants (or as many as the first argument says); after each, the next
# build has to make the very bytes that an undisturbed one makes, and leave nothing else behind.
set -euo pipefail
cd "$(dirname "$0")/.."
CHEREME_KILLS=${1:-100} cargo test --test it corpus_build::a_build_that_is_killed -- --nocapture
