#!/usr/bin/env bash
# Builds the program for 64 and 32 bit at optimisation levels 2 and 3, runs the same experiments with
# each, and puts the results side by side: does the compiler change what is fast, or what is exact?
#
#   scripts/builds.sh [--out DIR] [--profile P] [--targets T,...] [--levels L,...] [--dry-run] [CONFIG...]
#
# Without CONFIG these: b-4.2, h-7, h-8, h-10, h-11. Without --targets this machine's own, and for
# x86-64 i686 as well; without --levels 2,3. What cannot be built here is told, `skipped: ...`, and
# why. Each build has a folder of its own for its object files, OUT/target-..., and for its results,
# OUT/<target>-o<level>; OUT (results/builds) gets what `ray_test report` makes of them in merged/.
# --dry-run says what would be built and run. Exit 0 if at least one build ran, 1 if none did or one
# failed on the way, 2 for wrong usage.
#
# A 32-bit build needs `rustup target add i686-unknown-linux-gnu` (done here where rustup can) and a
# linker with 32-bit libraries: on Debian, `apt-get install gcc-multilib`.
set -euo pipefail
start=$PWD
cd "$(dirname "$0")/.."

usage() {
    printf 'error: %s\nusage: %s [--out DIR] [--profile P] [--targets T,...] [--levels L,...] [--dry-run] [CONFIG...]\n' \
        "$1" "${0##*/}" >&2
    exit 2
}
say() { printf '%s\n' "$*" >&2; }

host=$(rustc -vV | sed -n 's/^host: //p')
out=results/builds profile=quick levels=2,3 dry='' targets=$host
# The same system in 32 bit.
[[ $host != x86_64-* ]] || targets=$host,i686-${host#x86_64-}
while [ $# -gt 0 ]; do
    case $1 in
        --out | --profile | --targets | --levels)
            [ $# -gt 1 ] || usage "$1 needs a value"
            declare "${1#--}=$2"
            shift 2
            ;;
        --dry-run)
            dry=yes
            shift
            ;;
        -h | --help)
            # The comment above, without its marks.
            awk 'NR > 1 { if (!/^#/) exit; sub(/^# ?/, ""); print }' "$0"
            exit 0
            ;;
        -*) usage "unknown option '$1'; allowed: --out, --profile, --targets, --levels, --dry-run" ;;
        *) break ;;
    esac
done
[[ $levels =~ ^[0-3sz](,[0-3sz])*$ ]] || usage "--levels '$levels'; allowed: some of 0, 1, 2, 3, s, z"
[[ $targets =~ ^[a-z0-9_.-]+(,[a-z0-9_.-]+)*$ ]] || usage "--targets '$targets'; allowed: target triples"
[[ $out = /* ]] || out=$start/$out
configs=()
for config in "$@"; do
    [[ $config = /* ]] || config=$start/$config
    [ -r "$config" ] || usage "'$config' cannot be read"
    configs+=("$config")
done
[ ${#configs[@]} -gt 0 ] || configs=(configs/{b-4.2,h-7,h-8,h-10,h-11}.toml)

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# A signal ends the script through EXIT, and so through the cleaning up.
trap 'exit 130' INT TERM

# can_build TARGET: whether a program for it can be compiled and linked; says why not.
can_build() {
    local target=$1
    [ "$target" = "$host" ] && return
    if ! [ -d "$(rustc --print sysroot)/lib/rustlib/$target/lib" ]; then
        if ! command -v rustup >/dev/null; then
            say "skipped: $target: the standard library for it is not there, and no rustup to fetch it"
            return 1
        fi
        # A dry run changes nothing.
        [ -z "$dry" ] || { say "would fetch: the standard library for $target"; return; }
        if ! rustup --quiet target add "$target" >"$work/rustup" 2>&1; then
            say "skipped: $target: rustup target add: $(tail -n 1 "$work/rustup")"
            return 1
        fi
    fi
    echo 'fn main() {}' >"$work/empty.rs"
    if ! rustc --target "$target" -o "$work/empty" "$work/empty.rs" >"$work/linked" 2>&1; then
        local why
        why=$(grep -m 1 -oE '[a-z.-]*ld: .*|.*not found.*' "$work/linked" || tail -n 1 "$work/linked")
        say "skipped: $target: no program for it can be linked: $why"
        return 1
    fi
    if ! "$work/empty" 2>/dev/null; then
        say "skipped: $target: this machine does not run its programs"
        return 1
    fi
}

folders=() failed=0 program=
for target in ${targets//,/ }; do
    can_build "$target" || continue
    for level in ${levels//,/ }; do
        name=$target-o$level
        if [ -n "$dry" ]; then
            echo "CARGO_PROFILE_RELEASE_OPT_LEVEL=$level cargo build --release --target $target" \
                "--target-dir $out/target-$name"
            echo "ray_test run ${configs[*]} --profile $profile --out $out/$name"
            folders+=("$out/$name")
            continue
        fi
        say "building $name"
        if ! CARGO_PROFILE_RELEASE_OPT_LEVEL=$level CARGO_INCREMENTAL=0 cargo build --quiet \
            --release --target "$target" --target-dir "$out/target-$name"; then
            say "failed: $name does not build"
            failed=1
            continue
        fi
        built=$out/target-$name/$target/release/ray_test code=0
        "$built" run "${configs[@]}" --profile "$profile" --out "$out/$name" >/dev/null || code=$?
        case $code in
            # Wrong answers (4) are rows, too, and may be what a build is to blame for.
            0 | 4) folders+=("$out/$name") ;;
            130) exit 130 ;;
            *)
                say "failed: $name ended with exit $code"
                failed=1
                continue
                ;;
        esac
        program=${program:-$built}
    done
done
[ ${#folders[@]} -gt 0 ] || { say "error: nothing could be built"; exit 1; }
if [ -n "$dry" ]; then
    echo "ray_test report ${folders[*]} --out $out/merged"
    exit 0
fi
"$program" report "${folders[@]}" --out "$out/merged"
exit "$failed"
