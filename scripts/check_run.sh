#!/usr/bin/env bash
# A quick run of the program from end to end: exit codes, counts and files, no times.
set -euo pipefail
program=$(realpath "${1:-target/release/ray_test}")
scripts=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
# Of its own: nothing here looks at times, so that it may run beside a run that measures.
export RAY_TEST_LOCK="$folder/lock"
# What is checked here are answers and files; no time is asked for, and no neighbour waited for.
export RAY_TEST_PATIENCE=0
passed=0

fail() { printf 'failed: %s\n' "$1" >&2; exit 1; }

# expect CODE NAME COMMAND...: runs a command, its output into $folder/out and err.
expect() {
    local code=$1 name=$2 got=0
    shift 2
    "$@" >out 2>err || got=$?
    [ "$got" -eq "$code" ] || { cat err >&2; fail "$name: exit $got, not $code"; }
    passed=$((passed + 1))
}

has() { grep -q -- "$1" "$2" || { cat "$2" >&2; fail "no '$1' in $2"; }; }

expect 0 "thesis form" "$program" 0.3 2000 100 --format csv
[ "$(awk -F, 'NR > 1 && $5 == 600' out | wc -l)" -eq 3 ] || fail "three kernels with 600 hits"
expect 0 "sweep" "$program" all 2000 10 --format csv
[ "$(awk -F, 'NR > 1 { print $2 }' out | sort -u | wc -l)" -eq 5 ] || fail "five densities"
[ ! -s err ] || fail "a warning for 'all'"
expect 0 "sweep by a wrong word" "$program" maybe 200 10 --format csv
has "warning" err
[ "$(awk -F, 'NR > 1 { print $2 }' out | sort -u | wc -l)" -eq 5 ] || fail "five densities"
expect 0 "msvc, reshuffled, other kernels" "$program" 0.5 500 10 --generator msvc --order reshuffled \
    --kernels moller-trumbore,wald,moller --output tuv --format json
has '"hits": 250' out

expect 2 "no triangles" "$program" 0.3 0 10
expect 2 "negative repeats" "$program" 0.3 10 -1
expect 2 "more tests than can be counted" "$program" 0.3 16777216 18446744073709551615
expect 2 "more triangles than allowed" "$program" 0.3 999999999999 1
expect 2 "a slip of the keyboard" "$program" reprodcue
has "reproduce" err
expect 2 "an unknown kernel" "$program" 0.3 10 10 --kernels mollerr
has "moller" err
printf 'id = "x"\ncolour = "red"\n' >wrong.toml
expect 2 "a wrong key" "$program" run wrong.toml --out wrong
has "wrong.toml" err
[ ! -e wrong ] || fail "a folder for a refused config"
expect 2 "a missing config" "$program" run missing.toml
expect 2 "a folder that cannot be made" "$program" reproduce --out /proc/ray_test
expect 2 "a filter that matches nothing" "$program" reproduce --filter nothing-is-called-this
expect 2 "a filter that is none" "$program" reproduce --filter '('
cat >twice.toml <<'EOF'
id = "twice"
title = "Twice?"
question = "Is it refused?"
why = "An id is the name of a folder."
variants = ["^moller1/f32/single/.*/t$"]
[workload]
kind = "pairs"
density = [0.5]
orders = ["fixed"]
EOF
expect 2 "an experiment twice" "$program" run twice.toml twice.toml
has "twice" err
sed 's/"pairs"/"nearest"/; /density/d; s/orders/rays = 17\norders/' twice.toml >odd.toml
expect 2 "rays that fill no packet" "$program" run odd.toml --dry-run
has "17" err

for what in kernels variants experiments claims levels; do
    expect 0 "list $what" "$program" list "$what" --format csv
    [ "$(wc -l <out)" -gt 1 ] || fail "list $what is empty"
done
expect 0 "dry run" "$program" reproduce --dry-run
expect 0 "two experiments of all" "$program" reproduce --out part --filter '^(moller[013]|wald)/f32/single'
for file in environment.json b-4.1/rows.csv b-4.1/rows.json b-4.1/b-4.1.svg h-5/h-5.svg; do
    [ -s "part/$file" ] || fail "no part/$file"
done
grep -qE 'NaN|inf' part/b-4.1/rows.csv && fail "a number that is none in rows.csv"
expect 0 "go on where nothing is left" "$program" reproduce --out part --resume \
    --filter '^(moller[013]|wald)/f32/single'
has "finished before" err
expect 2 "go on with another filter" "$program" reproduce --out part --resume --filter '^wald/'

expect 0 "a run against itself" "$program" compare part part --format json
has '"verdict": "same"' out
# Beside a neighbour no change of time is confirmed, and whether there was one here is chance: the copies
# were measured alone. In one of them Wald's kernel takes three times as long, in all figures of its time.
for copy in calm slower; do
    cp -r part "$copy"
    awk -v slower="$copy" '{ gsub(/"crowded_share": *[0-9.e-]+/, "\"crowded_share\": 0") }
        slower == "slower" && /"kernel": *"wald"/ {
            figure = "\"(ratio|cycles)_(to_reference|per_test|low|high|first_half|second_half)\": *[0-9.e-]+"
            for (rest = $0; match(rest, figure); rest = substr(rest, RSTART + RLENGTH)) {
                split(substr(rest, RSTART, RLENGTH), part, ": *")
                printf "%s%s:%.17g", substr(rest, 1, RSTART - 1), part[1], 3 * part[2]
            }
            print rest
            next
        }
        { print }' part/h-5/rows.json >"$copy/h-5/rows.json"
done
expect 3 "a slower kernel" "$program" compare calm slower --format csv
has '^regression,h-5,wald/' out
grep -v '^regression,h-5,wald/' out | grep -q '^regression' && fail "another kernel is slower"
expect 0 "a faster kernel" "$program" compare slower calm --format markdown
has '^\*\*improved' out
sed 's/"seed": *[0-9][0-9]*/"seed": 4711/g' part/b-4.1/rows.json >seed.json
expect 2 "another seed" "$program" compare part/b-4.1/rows.json seed.json
has "seed: .* and 4711" err
has "^Refused" out
expect 2 "no such result" "$program" compare part missing
expect 2 "a threshold that is none" "$program" compare part part --threshold 3
expect 2 "an unknown baseline" "$program" run twice.toml --out unmeasured --baseline unknown
has "unknown" err
[ ! -e unmeasured ] || fail "a run for an unknown baseline"
expect 2 "a baseline elsewhere" "$program" run twice.toml --save-baseline ../elsewhere
expect 0 "a baseline is kept" "$program" run twice.toml --out first --save-baseline mine
cmp first/twice/rows.json results/baselines/mine/twice/rows.json || fail "another baseline"
# Whatever this machine is busy with, nothing becomes eleven times slower.
expect 0 "a baseline is held against" "$program" run twice.toml --out second --baseline mine \
    --threshold 1000%
has "threshold 1000 %" out

expect 0 "a report of stored rows" "$program" report part
expect 0 "two measurements side by side" "$program" report part slower --out both
for file in environment.json h-5/rows.csv h-5/h-5--1.svg h-5/h-5--2.svg; do
    [ -s "both/$file" ] || fail "no both/$file"
done
has '#2' both/h-5/rows.csv
expect 0 "what was put together, read again" "$program" report both --out again
cmp both/h-5/rows.csv again/h-5/rows.csv || fail "other rows when read again"
cmp both/h-5/h-5--2.svg again/h-5/h-5--2.svg || fail "another figure when read again"
expect 2 "a report of several without a place" "$program" report part slower
expect 2 "a report of nothing" "$program" report missing
expect 2 "a share that is none" "$program" reproduce --shard 4/3
cat >errors.toml <<'EOF'
id = "errors"
title = "Errors?"
question = "Do shares add up?"
why = "They must."
variants = ["^(wald|keidy|chirkov)/f32/single/sse2/early/last/plain/tuv$"]
[workload]
kind = "errors"
hits = 200
seeds = 3
EOF
expect 0 "shares, one after the other" env RAY_TEST="$program" OUT=array PROFILE=quick \
    "$scripts/slurm_array.sh" --local 4 errors.toml
expect 0 "the same in one" "$program" run errors.toml --out unsplit
cmp array/merged/errors/rows.csv unsplit/errors/rows.csv || fail "shares that do not add up"
printf ':\nme@elsewhere # not reached here\n' >hosts
expect 0 "many machines, dry" "$scripts/many_machines.sh" --dry-run hosts errors.toml
has 'me@elsewhere: .*run errors.toml' out
expect 2 "no machines" "$scripts/many_machines.sh" --dry-run /dev/null errors.toml
expect 0 "builds, dry" "$scripts/builds.sh" --dry-run --levels 2,3 --out builds errors.toml
has 'OPT_LEVEL=2' out

# 3000 cases: hits, edges, misses and one that is no number, in turn.
awk 'BEGIN {
    print "id,ox,oy,oz,dx,dy,dz,ax,ay,az,bx,by,bz,cx,cy,cz"
    split("1,1 2,0 3,3 nan,1", place, " ")
    for (i = 0; i < 3000; i++)
        printf "case-%d,%s,2,0,0,-1,0,0,0,4,0,0,0,4,0\n", i, place[i % 4 + 1]
}' >cases.csv
expect 0 "check" "$program" check cases.csv --kernels moller-trumbore --precision f32 --format csv
for word in interior edge outside not-finite; do
    [ "$(grep -c ",$word," out)" -eq 750 ] || fail "750 cases that are $word"
done
[ "$(grep -c ',agree,' out)" -eq 2250 ] || fail "a wrong answer where all numbers are whole"
awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i }
    { print $1 "," $column["hit"] "," $column["t"] "," $column["u"] "," $column["v"] }' out >answers.csv
expect 0 "check of answers" "$program" check cases.csv --answers answers.csv --format csv
[ "$(grep -c ',answers,f64,.*,agree,' out)" -eq 2250 ] || fail "answers that agree"
sed '2000d' answers.csv >few.csv
expect 2 "an answer too few" "$program" check cases.csv --answers few.csv
has "'case-1998'" err
sed '1001s/,2,/,two,/' cases.csv >word.csv
expect 2 "a case with a word" "$program" check word.csv --kernels wald --precision f64 --format json
has "line 1001, column 4 (oz): 'two'" err
[ "$(grep -c '"id"' out)" -eq 999 ] || fail "rows before the bad line"
tail -n 1 out | grep -qx ']' || fail "an array that is not closed"
expect 2 "no cases" "$program" check /dev/null
expect 0 "check from stdin, all kernels" "$program" check - --format csv <cases.csv
grep -qiE ',-?(nan|inf),' out && fail "a number that is none in the rows of check"

expect 0 "a recommendation" "$program" recommend --from part --format json
has '"variant"' out
expect 0 "a picture" "$program" render icosphere:1 --size 32x24 --compare -o ball.png
head -c 4 ball.png | grep -q PNG || fail "no picture"
expect 0 "a plan" "$program" scene icosphere:2 --out plan --format json
python3 -c '
import json, sys
plan = json.load(open("out"))
assert plan == json.load(open("plan/scene/plan.json"))
assert set(plan) == {"mesh", "rays", "needs", "plan", "answers"}, sorted(plan)
assert set(plan["plan"]) == {"variant", "left_out", "kept"}, sorted(plan["plan"])
assert set(plan["answers"]) == {"rays", "agree", "disagree"}, sorted(plan["answers"])
gone, kept = plan["plan"]["left_out"], plan["plan"]["kept"]
assert all(set(piece) == {"piece", "because", "saves_percent"} for piece in gone), gone
assert all(set(piece) == {"piece", "because"} for piece in kept), kept
names = [piece["piece"] for piece in gone + kept]
assert len(set(names)) == len(names) > 10, names
assert plan["answers"]["disagree"] == 0 < plan["answers"]["agree"], plan["answers"]
' || fail "a plan that is not as promised"
[ -s plan/scene/rows.csv ] || fail "no plan/scene/rows.csv"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n' >broken.obj
for verb in scene render; do
    expect 2 "a broken mesh: $verb" "$program" "$verb" broken.obj
    has "line 4" err
done

for pipe in "check cases.csv" "list variants" "reproduce --dry-run" "all 100 10"; do
    # shellcheck disable=SC2086 # words of a command line
    "$program" $pipe 2>err | head -n 1 >out || fail "a closed pipe: $pipe"
    grep -q panicked err && fail "a panic on a closed pipe: $pipe"
done

printf '%s passed, 0 failed\n' "$passed"
