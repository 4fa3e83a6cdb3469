#!/usr/bin/env bash
# Looks at the machine code of every batch function: that nothing of the generic source is left in
# it, that packets use the widest registers of their level, and that single forms are single.
#
#   scripts/check_codegen.sh [program]    checks a release build with v0 symbols (makes one if none is named)
#   scripts/check_codegen.sh --self-test  feeds it code that it must reject
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
root=$(dirname "$here")

if [ "$(uname -m)" != x86_64 ]; then
    echo "skipped: not x86_64 (1 check)"
    exit 0
fi

need_objdump() {
    if command -v objdump >/dev/null; then return; fi
    if command -v apt-get >/dev/null && apt-get install -y binutils >/dev/null 2>&1; then return; fi
    echo "objdump is missing; install binutils" >&2
    exit 2
}

# v0 names keep kernel and policy in the symbols; older ones keep a hash.
build() {
    RUSTFLAGS="-C symbol-mangling-version=v0" CARGO_TARGET_DIR="$root/target/codegen" \
        cargo build --quiet --release --manifest-path "$root/Cargo.toml" --bin ray_test
}

judge() { awk -f "$here/check_codegen.awk" -f "$here/check_codegen_streams.awk"; }

if [ "${1:-}" = --self-test ]; then
    # shellcheck source=scripts/check_codegen_test.sh
    source "$here/check_codegen_test.sh"
    exit 0
fi

need_objdump
program=${1:-}
if [ -z "$program" ]; then
    build
    program="$root/target/codegen/release/ray_test"
fi
listing=$(mktemp)
trap 'rm -f "$listing"' EXIT
objdump -d -C --no-show-raw-insn -M intel "$program" >"$listing"
judge <"$listing"
