#!/usr/bin/env bash
# Measures two commits in turns on one machine and tells what the second made slower or less exact.
#
#   scripts/compare_commits.sh [--pairs N] [--profile P] [--threshold T] [--keep DIR] BASE NEW CONFIG...
#
# BASE and NEW are commits, CONFIG are experiments as they are in NEW. Both are built here, with the
# same compiler and flags, then run A B B A A B ...: whatever drifts meets both alike. Each pair is
# compared, and a regression is what all pairs (3 by default) find: one that chance finds once in
# twenty times is found three times in a row once in 8000. Exit 3 if there is one, 0 if not, 2 for
# wrong usage and for commits that cannot be compared, 1 if something failed. --keep leaves the
# results in DIR.
#
# For GitHub Actions, as a step for pull requests that touch a kernel:
#
#   jobs:
#     compare:
#       runs-on: ubuntu-latest
#       steps:
#         - uses: actions/checkout@v4
#           with: { fetch-depth: 0 }    # the merge base must be there
#         - name: Is a kernel slower or less exact than before?
#           run: |
#             base=$(git merge-base HEAD "origin/${{ github.base_ref }}")
#             scripts/compare_commits.sh "$base" HEAD configs/b-4.2.toml | tee -a "$GITHUB_STEP_SUMMARY"
#           shell: bash                 # with -o pipefail, so that exit 3 gets through tee
set -euo pipefail

usage() {
    printf 'error: %s\nusage: %s [--pairs N] [--profile P] [--threshold T] [--keep DIR] BASE NEW CONFIG...\n' \
        "$1" "${0##*/}" >&2
    exit 2
}

pairs=3 profile=quick threshold=3% keep=
while [ $# -gt 0 ]; do
    case $1 in
        --pairs | --profile | --threshold | --keep)
            [ $# -gt 1 ] || usage "$1 needs a value"
            declare "${1#--}=$2"
            shift 2
            ;;
        -h | --help)
            # The comment above, without its marks.
            awk 'NR > 1 { if (!/^#/) exit; sub(/^# ?/, ""); print }' "$0"
            exit 0
            ;;
        -*) usage "unknown option '$1'; allowed: --pairs, --profile, --threshold, --keep" ;;
        *) break ;;
    esac
done
[[ $pairs =~ ^[1-9][0-9]?$ ]] || usage "--pairs '$pairs'; allowed: 1 to 99"
[ $# -ge 3 ] || usage "two commits and at least one config are needed"
start=$PWD
cd "$(git -C "$(dirname "$0")" rev-parse --show-toplevel)"
commit() { git rev-parse --verify --quiet "$1^{commit}" || usage "'$1' is no commit of this repository"; }
base=$(commit "$1")
new=$(commit "$2")
shift 2
for config in "$@"; do
    git cat-file -e "$new:$config" 2>/dev/null || usage "there is no '$config' in ${new:0:12}"
done

work=$(mktemp -d)
cleanup() {
    local tree
    for tree in base new; do
        [ ! -d "$work/$tree" ] || git worktree remove --force "$work/$tree"
    done
    rm -rf "$work"
}
trap cleanup EXIT
# A signal ends the script through EXIT, and so through the cleaning up.
trap 'exit 130' INT TERM

say() { printf '%s\n' "$*" >&2; }

# build SIDE COMMIT: checks a commit out and builds it; the program is $work/SIDE-program.
build() {
    local side=$1 of=$2
    say "building $side: $(git log -1 --format='%h %s' "$of")"
    git worktree add --quiet --detach "$work/$side" "$of"
    if [ "$side" = new ] && [ "$base" = "$new" ]; then
        cp "$work/base-program" "$work/new-program"
        return
    fi
    # Functions and blocks on lines of 64 bytes, in both: where code happens to lie is no change of
    # it, and can look like several percent.
    (
        cd "$work/$side"
        export RUSTFLAGS="${RUSTFLAGS--C llvm-args=-align-all-functions=6 -C llvm-args=-align-all-nofallthru-blocks=6}"
        CARGO_INCREMENTAL=0 CARGO_TARGET_DIR="$work/$side-target" cargo build --quiet --release
    )
    cp "$work/$side-target/release/ray_test" "$work/$side-program"
    # It may take as much room as the disk has left.
    rm -rf "$work/$side-target"
}

build base "$base"
build new "$new"
configs=("${@/#/$work/new/}")

if [ -n "$keep" ]; then
    results=$(cd "$start" && mkdir -p "$keep" && cd "$keep" && pwd)
else
    results=$work/results
fi

# measure SIDE PAIR: a run that ends with wrong answers (4) has rows all the same; they are compared.
measure() {
    local code=0
    say "pair $2 of $pairs: $1"
    "$work/$1-program" run "${configs[@]}" --profile "$profile" --out "$results/$2/$1" \
        >"$work/out" 2>"$work/err" || code=$?
    case $code in
        0 | 4) ;;
        *)
            cat "$work/err" >&2
            say "error: $1 ended with exit $code"
            exit "$((code == 2 ? 2 : 1))"
            ;;
    esac
}

tables=()
for ((pair = 1; pair <= pairs; pair++)); do
    if ((pair % 2)); then
        measure base "$pair"
        measure new "$pair"
    else
        measure new "$pair"
        measure base "$pair"
    fi
    code=0
    "$work/new-program" compare "$results/$pair/base" "$results/$pair/new" \
        --threshold "$threshold" --format csv >"$results/$pair/findings.csv" 2>"$work/err" || code=$?
    if [ "$code" -ne 0 ] && [ "$code" -ne 3 ]; then
        cat "$work/err" >&2
        exit "$((code == 2 ? 2 : 1))"
    fi
    tables+=("$results/$pair/findings.csv")
done

# Columns: kind,experiment,id,workload,order,density,figure,ratio,low,high,code,base,new. Of the two
# figures of a time, cycles and ratio, each pair names one: they count as the same.
awk -F, -v pairs="$pairs" '
    $1 == "regression" {
        time = $7 == "cycles_per_test" || $7 == "ratio_to_reference"
        code = $11 == "" ? "" : " code " $11
        key = (time ? "time" : $7) " of " $3 code " in " $2 " " $4 " " $5 " " $6
        if (!(key in found)) order[++keys] = key
        found[key]++
        change[key] = change[key] (time ? sprintf(" %+.1f %%", 100 * ($8 - 1)) : " " $12 " to " $13)
    }
    END {
        for (place = 1; place <= keys; place++) {
            key = order[place]
            if (found[key] < pairs) { once++; continue }
            print "regression: " key ":" change[key]
            all++
        }
        if (once) print once " found by some of the pairs only, which is chance or too small to tell"
        print "regressions found by all " pairs " pairs: " all + 0
        exit all ? 3 : 0
    }' "${tables[@]}"
