#!/usr/bin/env bash
# Runs the same experiments on many machines, fetches the results, and puts them side by side.
#
#   scripts/many_machines.sh [--program FILE] [--out DIR] [--profile P] [--jobs N] HOSTS CONFIG...
#   scripts/many_machines.sh --dry-run HOSTS CONFIG...
#
# HOSTS is a file with one machine a line, as ssh knows it (`me@server`, or a name in ~/.ssh/config);
# `:` is this machine, without ssh, and what stands behind a # is left out. CONFIG are experiments.
# --program (target/release/ray_test) must run on all of them: a static build does, made with
# `cargo build --release --target x86_64-unknown-linux-musl`. Each machine measures into a folder of
# its own, OUT/1, OUT/2 ... in the order of HOSTS (OUT is results/machines); OUT/merged gets what
# `ray_test report` makes of them. --dry-run says what would be done, and does nothing.
#
# GNU parallel (over ssh, with rsync on both sides) sends the program and the configs, runs, fetches the results and removes what it sent;
# at most --jobs (all) machines at once, never two runs on one. A machine that fails is told, and the
# others are put together without it: exit 1 then, 2 for wrong usage.
set -euo pipefail

usage() {
    printf 'error: %s\nusage: %s [--program FILE] [--out DIR] [--profile P] [--jobs N] [--dry-run] HOSTS CONFIG...\n' \
        "$1" "${0##*/}" >&2
    exit 2
}

program=target/release/ray_test out=results/machines profile=quick jobs=0 dry=''
while [ $# -gt 0 ]; do
    case $1 in
        --program | --out | --profile | --jobs)
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
        -*) usage "unknown option '$1'; allowed: --program, --out, --profile, --jobs, --dry-run" ;;
        *) break ;;
    esac
done
[ $# -ge 2 ] || usage "a file of machines and at least one config are needed"
[[ $jobs =~ ^[0-9]+$ ]] || usage "--jobs '$jobs'; allowed: a number, 0 for all machines at once"
hosts=$1
shift
[ -r "$hosts" ] || usage "'$hosts' cannot be read; allowed: a file with one machine a line"
mapfile -t machines < <(sed 's/#.*//; s/[[:space:]]//g; /^$/d' "$hosts")
[ ${#machines[@]} -gt 0 ] || usage "there is no machine in '$hosts'"
for config in "$@"; do
    [ -r "$config" ] || usage "'$config' cannot be read"
done
[ -n "$dry" ] || [ -x "$program" ] || usage "'$program' is no program; allowed: a built ray_test"

# What is sent is one folder: the program and the configs, under names without a path.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# A signal ends the script through EXIT, and so through the cleaning up.
trap 'exit 130' INT TERM
bundle=$work/ray_test-bundle
mkdir "$bundle"
[ -n "$dry" ] || cp "$program" "$bundle/ray_test"
cp "$@" "$bundle/"
configs=()
for config in "$@"; do configs+=("$(printf '%q' "${config##*/}")"); done

# One line of shell, the same on every machine: results in a folder beside the program.
command="cd ray_test-bundle && ./ray_test run ${configs[*]} --profile $(printf '%q' "$profile") --out result-{#}"

if [ -n "$dry" ]; then
    for ((number = 1; number <= ${#machines[@]}; number++)); do
        printf '%s: %s -> %s\n' "${machines[number - 1]}" "${command//\{#\}/$number}" "$out/$number"
    done
    printf 'ray_test report %s/[1-%s] --out %s/merged\n' "$out" "${#machines[@]}" "$out"
    exit 0
fi
command -v parallel >/dev/null || {
    echo "error: GNU parallel is not there; Debian has it as the package 'parallel'" >&2
    exit 1
}

mkdir -p "$out"
out=$(cd "$out" && pwd)
# shellcheck disable=SC2317 # called by parallel
# One job for each machine: -S with one machine, so that each gets its own and none gets two.
run_on() {
    local machine=$1 number=$2 line=${command//\{#\}/$2} folder=$work/$2
    mkdir "$folder"
    cp -r "$bundle" "$folder/"
    if [ "$machine" = : ]; then
        (cd "$folder" && bash -c "$line")
    else
        # Fetched even after wrong answers (exit 4), which leave rows.
        (cd "$folder" && parallel --will-cite --sshlogin "1/$machine" --workdir ... \
            --transferfile ray_test-bundle --return "ray_test-bundle/result-$number" --cleanup \
            "$line; true {}" ::: once)
    fi >"$folder/log" 2>&1 || true
    rm -rf "${out:?}/$number"
    if [ -d "$folder/ray_test-bundle/result-$number" ]; then
        mv "$folder/ray_test-bundle/result-$number" "$out/$number"
        printf '%s: %s\n' "$machine" "$out/$number" >&2
    else
        { printf '%s: no results\n' "$machine"; tail -n 5 "$folder/log"; } >&2
        return 1
    fi
}
export -f run_on
export command bundle work out

failed=0
parallel --will-cite --jobs "$jobs" --link run_on ::: "${machines[@]}" \
    ::: $(seq ${#machines[@]}) || failed=1
folders=()
for ((number = 1; number <= ${#machines[@]}; number++)); do
    [ ! -d "$out/$number" ] || folders+=("$out/$number")
done
[ ${#folders[@]} -gt 0 ] || exit 1
"$program" report "${folders[@]}" --out "$out/merged"
exit "$failed"
