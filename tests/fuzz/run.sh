#!/usr/bin/env bash
# Fuzzes one parser, guided by the code that it reaches, from the files in corpus/ and found/:
#   tests/fuzz/run.sh TARGET [SECONDS]        TARGET is a name in fuzz_targets/, SECONDS 600 where none are given
# What fails it leaves in tests/fuzz/artifacts/TARGET; once mended, that file belongs into found/TARGET, where the test
# `parsers` reads it for ever; `cargo fuzz run` with that file alone shows what it says. Inputs of a few KB that ask for 256 MB at once, or take 10 s, are failures as well.
set -euo pipefail
cd "$(dirname "$0")"
target=$1 seconds=${2:-600}
cargo fuzz --version >/dev/null 2>&1 || cargo install cargo-fuzz --locked

# Words of the files, as a dictionary: a header of a hundred columns is not found letter by letter.
work=${FUZZ_WORK:-$(mktemp -d)}
mkdir -p "$work/$target" "$work/tmp" "artifacts/$target" "corpus/$target" "found/$target"
grep -aohE '[A-Za-z_][A-Za-z0-9_.-]{2,24}' "corpus/$target"/* | sort -u | sed 's/.*/"&"/' >"$work/$target.dict"

# Without a sanitizer, since there is no unsafe code of ours to watch; that also leaves any toolchain free.
export TMPDIR=$work/tmp
unset RUSTFLAGS
exec cargo fuzz run --release --fuzz-dir . -s none "$target" "$work/$target" "corpus/$target" "found/$target" -- \
    -dict="$work/$target.dict" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=1024 -malloc_limit_mb=256 \
    -max_len="${FUZZ_LENGTH:-8192}" -close_fd_mask=3 -print_final_stats=1
