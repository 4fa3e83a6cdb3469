#!/usr/bin/env bash
#SBATCH --job-name=ray_test
#SBATCH --array=1-8
#SBATCH --cpus-per-task=4
#SBATCH --time=01:00:00
#SBATCH --output=ray_test-%A_%a.out
#
# Shares out what needs no clock (operations, errors, stiff families) over the tasks of a Slurm job
# array; each writes a folder of its own, and `ray_test report` puts them together, bit for bit what
# one task alone would have written.
#
#   sbatch [--array=1-N] scripts/slurm_array.sh [CONFIG...]    every built-in experiment without CONFIG
#   scripts/slurm_array.sh --local N [CONFIG...]               the same here, one task after the other
#   scripts/slurm_array.sh --merge                             after the array: puts its folders together
#   scripts/slurm_array.sh --dry-run N [CONFIG...]             says what each task would do
#
# Without CONFIG the sweep of stiff cases is shared out with them. How much is drawn there is $PROFILE (quick,
# standard or thorough; standard). Folders go to $OUT (results/array), the program is $RAY_TEST
# (target/release/ray_test).
# To have the merging done by itself:
#
#   array=$(sbatch --parsable scripts/slurm_array.sh)
#   sbatch --dependency=afterok:"$array" --wrap 'scripts/slurm_array.sh --merge'
#
# What is timed is not shared out: give it a whole node for itself, with `ray_test run`.
set -euo pipefail

program=${RAY_TEST:-target/release/ray_test}
out=${OUT:-results/array}
profile=${PROFILE:-standard}

usage() {
    printf 'error: %s\nusage: %s [--local N | --dry-run N | --merge] [CONFIG...], or as a job array\n' \
        "$1" "${0##*/}" >&2
    exit 2
}

# task I N CONFIG...: the command of a task, which can be gone on with after a time-out.
task() {
    local part=$1 of=$2
    shift 2
    local verb=(reproduce)
    [ $# -eq 0 ] || verb=(run "$@")
    printf '%q ' "$program" "${verb[@]}" --profile "$profile" --shard "$part/$of" \
        --out "$out/part-$part" --resume
    echo
}

# Runs a task.
run() { bash -euc "$(task "$@")"; }

# All folders into one. A part that is missing is told by the report.
merge() {
    local parts=("$out"/part-*/)
    [ -d "${parts[0]}" ] || usage "--merge: there is no part in $out"
    "$program" report "${parts[@]%/}" --out "$out/merged"
}

number() { [[ ${2:-} =~ ^[1-9][0-9]*$ ]] || usage "$1 needs a number of tasks, 1 or more"; }

case ${1:-} in
    -h | --help)
        # The comment above, without its marks.
        awk 'NR > 1 && !/^#SBATCH/ { if (!/^#/) exit; sub(/^# ?/, ""); print }' "$0"
        ;;
    --dry-run)
        number "$@"
        for ((part = 1; part <= $2; part++)); do task "$part" "$2" "${@:3}"; done
        ;;
    --local)
        number "$@"
        for ((part = 1; part <= $2; part++)); do run "$part" "$2" "${@:3}"; done
        merge
        ;;
    --merge) merge ;;
    -*) usage "unknown option '$1'; allowed: --local, --dry-run, --merge" ;;
    *)
        [ -n "${SLURM_ARRAY_TASK_ID:-}" ] ||
            usage "this is no task of a job array; allowed: sbatch, or --local N"
        # Tasks may be numbered from anything.
        run "$((SLURM_ARRAY_TASK_ID - SLURM_ARRAY_TASK_MIN + 1))" "$SLURM_ARRAY_TASK_COUNT" "$@"
        ;;
esac
