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

# need COMMAND PACKAGE: installs it where apt can.
need() {
    command -v "$1" >/dev/null || apt-get install -y "$2" >/dev/null 2>&1 ||
        { echo "$1 is missing; install it" >&2; exit 2; }
}

step "format"
cargo fmt --version >/dev/null 2>&1 || rustup component add rustfmt
cargo fmt --check

step "lints"
cargo clippy --version >/dev/null 2>&1 || rustup component add clippy
# With the peers, whose code is added to that of a build without them, and without the command line.
cargo clippy --release --all-targets --features peers -- -D warnings
cargo clippy --release --no-default-features --lib -- -D warnings

step "supply"
# The stricter program where it is; it takes minutes to build, and asks for advisories on the network.
if cargo deny --version >/dev/null 2>&1; then
    cargo deny --config scripts/deny.toml --all-features check licenses bans sources
else
    need python3 python3
    scripts/check_supply.py --self-test
    scripts/check_supply.py
fi

step "minimum Rust version"
rust=$(sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml)
if [[ "$(rustc --version)" == "rustc $rust."* ]]; then
    echo "all that follows is built with it: $rust"
elif rustup toolchain list 2>/dev/null | grep -q "^$rust"; then
    cargo "+$rust" check --release
else
    echo "skipped: no Rust $rust (1 check)"
fi

# The library, and the library with its own tests, side by side.
step "build"
cargo test --release --no-run

# Three at a time, since none of them keeps two cores busy: runs that are killed and gone on with, what
# needs the program alone, and all other tests.
step "tests, and what needs the program alone"
work=$(mktemp -d)
beside=()
trap 'kill "${beside[@]}" 2>/dev/null || true; rm -rf "$work"' EXIT
killed_runs() {
    step "runs that are killed"
    cargo test --release --test interruptions
}
program_alone() {
    step "generated code"
    scripts/check_codegen.sh --self-test
    scripts/check_codegen.sh target/release/ray_test
    step "from end to end"
    scripts/check_run.sh target/release/ray_test
    step "where things break"
    scripts/check_breaks.sh target/release/ray_test
    step "documentation"
    RUSTDOCFLAGS="-D warnings" cargo doc --release --no-deps --quiet
    step "report"
    target/release/ray_test report results/reference --out "$work/report" >/dev/null
    scripts/check_report.sh "$work/report/report.html"
}
# Every file of tests but the one that is run beside the others.
targets=()
for file in tests/*.rs tests/*/main.rs; do
    name=${file#tests/} name=${name%.rs}
    [ "$name" = interruptions/main ] || targets+=(--test "${name%/main}")
done
for part in killed_runs program_alone; do
    (set -e; "$part") >"$work/$part" 2>&1 &
    beside+=($!)
done
cargo test --release --lib --bins --examples "${targets[@]}"
cargo test --release --doc
for part in killed_runs program_alone; do
    wait "${beside[0]}" || { cat "$work/$part"; exit 1; }
    beside=("${beside[@]:1}")
    cat "$work/$part"
done
