#!/usr/bin/env bash
# Format, lints, tests, the check of the generated code, a quick run from end to end, and a browser that
# opens the report. On a fresh machine with a Rust toolchain it installs what else it needs (binutils and
# Chromium where apt can, rustfmt and clippy where rustup can). One build serves the tests, the check and
# the run: symbols are mangled so that they keep the names of kernels and policies, which changes no
# instruction.
set -euo pipefail
cd "$(dirname "$0")/.."
export RUSTFLAGS="${RUSTFLAGS:-} -C symbol-mangling-version=v0"
export CARGO_TERM_COLOR=never
# A build that is made once has nothing to gain from being kept in pieces.
export CARGO_INCREMENTAL=0

step() { printf '\n== %s\n' "$1"; }

step "format"
cargo fmt --version >/dev/null 2>&1 || rustup component add rustfmt
cargo fmt --check

step "lints"
cargo clippy --version >/dev/null 2>&1 || rustup component add clippy
# With the peers, whose code is added to that of a build without them, and without the command line.
cargo clippy --release --all-targets --features peers -- -D warnings
cargo clippy --release --no-default-features --lib -- -D warnings

step "build"
cargo build --release

step "tests"
cargo test --release

step "documentation"
RUSTDOCFLAGS="-D warnings" cargo doc --release --no-deps --quiet

step "generated code"
scripts/check_codegen.sh --self-test
scripts/check_codegen.sh target/release/ray_test

step "from end to end"
scripts/check_run.sh target/release/ray_test

step "where things break"
scripts/check_breaks.sh target/release/ray_test

step "report"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
target/release/ray_test report results/reference --out "$folder" >/dev/null
scripts/check_report.sh "$folder/report.html"
