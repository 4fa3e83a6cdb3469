#!/usr/bin/env bash
# The program where things break: full disks, closed pipes, broken files, signals, limits, a machine that
# refuses. Nothing panics, hangs or leaves half a file; what is refused is named. No times. What this
# machine cannot do is skipped, by name.
set -euo pipefail
program=$(realpath "${1:-target/release/ray_test}")
configs=$(cd "$(dirname "$0")/../configs" && pwd)
folder=$(mktemp -d)
clean() { for place in full fixed; do umount "$folder/$place" 2>/dev/null || :; done; rm -rf "$folder"; }
trap clean EXIT
cd "$folder"
# Of its own: nothing here looks at times, so that it may run beside a run that measures.
export RAY_TEST_LOCK="$folder/lock" RAY_TEST_PATIENCE=0
passed=0 skipped=0

fail() { printf 'failed: %s\n' "$1" >&2; exit 1; }
skip() { printf 'skipped: %s\n' "$1"; skipped=$((skipped + 1)); }
has() { grep -aq -- "$1" "$2" || { cat "$2" >&2; fail "no '$1' in $2"; }; }
hears_no_panic() { ! grep -aq panicked err || { cat err >&2; fail "$1: a panic"; }; }
# Half a file would be one that was to be renamed.
is_whole() { [ -z "$(find "$1" -name '*.partial')" ] || fail "$2: half a file is left"; }

# expect CODE NAME COMMAND...: runs a command, its output into $folder/out and err; two minutes are for
# what hangs.
expect() {
    local code=$1 name=$2 got=0
    shift 2
    timeout -k 5 120 "$@" >out 2>err </dev/null || got=$?
    hears_no_panic "$name"
    [ "$got" -eq "$code" ] || { cat err >&2; fail "$name: exit $got, not $code"; }
    passed=$((passed + 1))
}
# set_up SETTINGS COMMAND...: a command in a shell that has limits ('ulimit -n 16') or other streams
# ('exec >/dev/full') of its own.
# shellcheck disable=SC2016 # of the shell that is begun
printf '#!/usr/bin/env bash\neval "$1"\nshift\nexec "$@"\n' >set_up
chmod +x set_up

cat >tiny.toml <<'END'
id = "tiny"
title = "Tiny?"
question = "Is it whole?"
why = "It must be."
variants = ["^(keidy|wald)/f32/single/sse2/early/last/plain/tuv$"]
[workload]
kind = "pairs"
count = 60
reshuffled_count = 60
density = [0.5]
orders = ["fixed"]
END
sed 's/"tiny"/"other"/' tiny.toml >other.toml
printf 'id,ox,oy,oz,dx,dy,dz,ax,ay,az,bx,by,bz,cx,cy,cz\n1,1,2,0,0,-1,0,0,0,0,4,0,0,0,4,0\n' >cases.csv
stiff=(stability --families needle --kernels wald --depth quick)
picture=(render icosphere:1 --size 320x240 --compare)
expect 0 "a run" "$program" run tiny.toml --out base
has "^1 experiment, about" err
is_whole base "a run"

# What each verb prints, quickly.
quick=("0.5 200 10" "all 200 10 --format csv" "run tiny.toml --dry-run" "compare base base --format json"
    "check cases.csv" "check cases.csv --format json" "recommend --from base" "list kernels"
    "list variants --format csv" "man" "completions bash" "--help" "--version")
# What each verb writes.
written=("run tiny.toml --out @/run" "report base --out @/report" "${stiff[*]} --out @/stiff"
    "${picture[*]} -o @/ball.png" "reproduce --filter ^wald/f32/single --shard 1/9 --out @/share")

if mkdir -p full fixed && mount -t tmpfs -o size=16k tmpfs full 2>/dev/null; then
    expect 1 "disk full: two experiments" "$program" run tiny.toml other.toml --out full/two
    has "error: .*full/two/.*No space left" err
    has "to go on.*:$" err
    has "^  .* --out full/two --resume$" err
    is_whole full "disk full"
    mount -o remount,size=4m full
    expect 0 "with space again" "$program" run tiny.toml other.toml --out full/two --resume
    [ -s full/two/report.html ] || fail "no report with space again"
    for words in "${written[@]}" "scene icosphere:2 --out @/scene"; do
        umount full
        mount -t tmpfs -o size=8k tmpfs full
        # shellcheck disable=SC2086 # words of a command line
        expect 1 "disk full: $words" "$program" ${words//@/full}
        has "error: .*full/.*No space left" err
        [ "$(grep -o "No space left" err | wc -l)" -eq 1 ] || fail "told twice: $words"
        is_whole full "disk full: $words"
    done
    [ -s out ] || fail "a plan that cannot be saved is not shown"
    mount -t tmpfs -o size=4m tmpfs fixed
    cp -r base tiny.toml fixed
    mount -o remount,ro fixed
    for words in "${written[@]}" "scene icosphere:2 --out @/scene" "report @/base" "run tiny.toml --out @/base --resume"; do
        # shellcheck disable=SC2086 # words of a command line
        expect 2 "read-only: $words" "$program" ${words//@/fixed}
        has "Read-only.*allowed" err
    done
    expect 2 "a baseline where nothing can be written" env -C fixed "$program" run tiny.toml \
        --out "$folder/unmeasured" --save-baseline mine
    has "save-baseline.*Read-only" err
    [ ! -e unmeasured ] || fail "measured, for a baseline that cannot be written"
else
    skip "no mount: full and read-only disks"
fi

touch file
ln -s nowhere/at-all dangling
for place in file file/below dangling /dev/null /proc/ray_test; do
    for words in "run tiny.toml" "report base" "${stiff[*]}"; do
        # shellcheck disable=SC2086 # words of a command line
        expect 2 "no folder: $words --out $place" "$program" $words --out "$place"
        has "--out: .*allowed" err
    done
done
expect 0 "a name that is no text" "$program" "${stiff[@]}" --out $'a\377b'
has "^1 family, .* forms of kernels, about" err

if [ -c /dev/full ]; then
    for words in "${quick[@]}"; do
        # shellcheck disable=SC2086 # words of a command line
        expect 1 "stdout full: $words" ./set_up 'exec >/dev/full' "$program" $words
        has "stdout: No space left" err
    done
    for words in "${quick[@]}" "${written[@]}"; do
        # shellcheck disable=SC2086 # words of a command line
        expect 0 "stderr full: $words" ./set_up 'exec 2>/dev/full' "$program" ${words//@/unheard}
    done
    expect 2 "stderr full: a refusal" ./set_up 'exec 2>/dev/full' "$program" 0.3 0 10
else
    skip "no /dev/full"
fi
for words in "${quick[@]}" "run tiny.toml --out closed"; do
    # shellcheck disable=SC2086 # words of a command line
    expect 0 "all closed: $words" ./set_up 'exec <&- >&- 2>&-' "$program" $words
    # shellcheck disable=SC2086 # words of a command line
    expect 0 "a reader that has gone: $words" ./set_up 'exec 2> >(exec true)' "$program" $words
done

for words in "${quick[@]}" "${written[@]}"; do
    # shellcheck disable=SC2086 # words of a command line
    expect 0 "256 MB, 16 files, 256 KB of stack: $words" ./set_up 'ulimit -v 262144 -n 16 -s 256' \
        "$program" ${words//@/limited}
done
# In blocks of 1 KB; what is printed goes to files as well, and is short.
expect 1 "files of 4 KB at most" ./set_up 'ulimit -f 4' "$program" report base --out small
has "File too large" err
is_whole small "files of 4 KB at most"
expect 1 "files of 4 KB at most: a name that is no text" ./set_up 'ulimit -f 4' "$program" run tiny.toml --out $'c\377 d'
has "^  .* --out \$'c.xff d' --resume$" err
next=$(grep -a -- '--resume$' err)
eval "expect 0 'what was printed goes on there' $next"
[ -s $'c\377 d/report.html' ] || fail "what was printed went on elsewhere"
if command -v taskset >/dev/null; then
    expect 0 "one processor" taskset -c "$(taskset -cp $$ | sed 's/.*: *//; s/[,-].*//')" \
        "$program" run tiny.toml --out single
else
    skip "no taskset: one processor"
fi

# 2nd argument: system calls that fail, by their numbers on x86-64.
cat >refused.py <<'END'
import ctypes, os, struct, sys
numbers = [int(number) for number in sys.argv[1].split(",")]
step = lambda code, k, t=0, f=0: struct.pack("HBBI", code, t, f, k)
tests = [step(0x15, number, len(numbers) - i, 0) for i, number in enumerate(numbers)]
text = step(0x20, 0) + b"".join(tests) + step(0x06, 0x7FFF0000) + step(0x06, 0x00050001)
class Filter(ctypes.Structure):
    _fields_ = [("len", ctypes.c_ushort), ("code", ctypes.c_void_p)]
code = ctypes.create_string_buffer(text)
filter = Filter(len(text) // 8, ctypes.cast(code, ctypes.c_void_p))
call = ctypes.CDLL(None).prctl
if call(38, 1, 0, 0, 0) or call(22, 2, ctypes.byref(filter), 0, 0):
    sys.exit(77)
os.execvp(sys.argv[2], sys.argv[2:])
END
if [ "$(uname -m)" = x86_64 ] && python3 refused.py 298 true 2>/dev/null; then
    # Counters, the choice of a processor, addresses that stay, locks.
    for numbers in 203 298,204 135,73; do
        expect 0 "system calls refused: $numbers" python3 refused.py $numbers "$program" run tiny.toml --out calls
    done
    for words in "run tiny.toml --out @" "${stiff[*]} --out @" "check cases.csv"; do
        # shellcheck disable=SC2086 # words of a command line
        expect 0 "no threads: $words" python3 refused.py 56,435 "$program" ${words//@/threads}
    done
else
    skip "no python3 or seccomp for x86-64: refused system calls"
fi

clock=$(find /usr/lib /usr/lib64 -name libfaketime.so.1 2>/dev/null | head -n 1)
if [ -n "$clock" ]; then
    for time in '1969-01-01 00:00:00' '@2200-01-01 00:00:00' '+0 i-2.0'; do
        expect 0 "wall clock: $time" env LD_PRELOAD="$clock" FAKETIME_DONT_FAKE_MONOTONIC=1 \
            FAKETIME="$time" "$program" run tiny.toml --out clock
    done
    expect 1 "a clock that stands" env LD_PRELOAD="$clock" FAKETIME_DONT_FAKE_MONOTONIC=0 \
        FAKETIME='2030-01-01 00:00:00' "$program" run tiny.toml --out stands
    has "stands still" err
    expect 1 "a clock a thousand times too slow" env LD_PRELOAD="$clock" FAKETIME_DONT_FAKE_MONOTONIC=0 \
        FAKETIME='+0 x0.001' "$program" run tiny.toml --out stands
    has "far too slow" err
    [ ! -e stands ] || fail "a folder where nothing can be timed"
else
    skip "no faketime: clocks that jump or stand"
fi

if command -v flock >/dev/null; then
    printf 'pid 999999 since long ago\n' >stale
    expect 0 "a stale lock" env RAY_TEST_LOCK=stale "$program" run tiny.toml --out stale-run
    head -c 100000 /dev/urandom >odd
    expect 1 "a lock that is held" env RAY_TEST_LOCK=odd flock odd "$program" run tiny.toml --out second
    has "another run is measuring" err
    for words in "0.5 200 10" "render icosphere:1 --size 32x24 -o second.png"; do
        # shellcheck disable=SC2086 # words of a command line
        expect 1 "a lock that is held: $words" env RAY_TEST_LOCK=odd flock odd "$program" $words
        has "another run is measuring" err
    done
    expect 2 "a lock that is held: what is refused anyway" env RAY_TEST_LOCK=odd flock odd "$program" 0.5 99999999 10
    if [ -e second ] || [ -e second.png ]; then fail "a folder or a picture beside another run"; fi
else
    skip "no flock: a lock that is held"
fi

# broken NAME FILTER: rows.json of a copy of the run goes through a filter.
rows=broken/tiny/rows.json
broken() { rm -rf broken; cp -r base broken; "${@:2}" <base/tiny/rows.json >$rows; }
named() {
    for words in "report broken --out elsewhere" "compare base broken" "recommend --from broken" \
        "run tiny.toml --out broken --resume"; do
        # shellcheck disable=SC2086 # words of a command line
        expect 2 "$1: $words" "$program" $words
        has "error: .*$rows.*allowed" err
    done
}
broken "no rows" true; named "an empty file"
broken "cut" head -c 5000; named "a file that was cut"
broken "zeros" sed '20s/^/\x00/'; named "zeros"
broken "newer" sed 's/"schema_version": "1/"schema_version": "2/'; named "another schema"
broken "a word" sed 's/"tests":[0-9]*/"tests":"many"/'; named "a word for a number"
broken "below 0" sed 's/"ns_per_test":[0-9.e-]*/"ns_per_test":-1/'; named "a time below 0"
has "row 1, column 'ns_per_test': '-1' is not allowed" err
broken "a column less" sed 's/"order":"[a-z]*",//'; named "a column less"
broken "a column more" sed 's/"kernel":/"colour":"red","kernel":/'
expect 0 "a column more" "$program" report broken
broken "line ends" sed 's/$/\r/'
expect 0 "line ends of another system" "$program" report broken
broken "elsewhere" sed 's|"experiment":"tiny"|"experiment":"../../evil"|'
rm broken/tiny/experiment.toml
expect 2 "rows that name a folder elsewhere" "$program" report broken --out deep/er
has "'../../evil' is not allowed" err
[ ! -e evil ] || fail "a folder outside of --out"

for value in 0 -1 1e308 NaN inf 18446744073709551616 '' '١٢' 0x10; do
    for words in "0.5|$value|3" "0.5|20|$value" "0.5|20|3|--seed=${value/#0/-}" "run|tiny.toml|--dry-run|--pin=x$value" \
        "reproduce|--dry-run|--shard=$value/$value" "compare|base|base|--threshold=x$value" \
        "render|icosphere:1|--frames=$value" "render|icosphere:1|--size=${value}x8" "render|terrain:$value"; do
        IFS='|' read -r -a list <<<"$words|"
        expect 2 "a number: ${list[*]}" "$program" "${list[@]}"
    done
done
for variable in TERM=dumb COLUMNS=0 COLUMNS=10 COLUMNS=99999999999 NO_COLOR=1 LC_ALL=de_DE.UTF-8 TMPDIR=/nowhere; do
    expect 0 "$variable" env "$variable" "$program" list kernels
    expect 0 "$variable: help" env "$variable" "$program" --help
done
expect 0 "no environment" env -i "$program" recommend --from base

# signalled SIGNALS CODE NAME COMMAND...: a run that has begun, and is told to end.
set -m
signalled() {
    local signal=$1 code=$2 name=$3 got=0 pid
    shift 3
    rm -rf told
    "$@" run "$configs/b-4.2.toml" --profile thorough --filter '^(moller1|wald)/f32/single' --out told \
        >out 2>err </dev/null &
    pid=$!
    # Its file is there when it begins; the first rows are kept at the end of what takes turns.
    for _ in {1..600}; do
        [ -s told/b-4.2/rows.ndjson ] && break
        sleep 0.1
    done
    sleep 1
    for one in $signal; do
        kill -s "$one" "$pid"
        sleep 0.2
    done
    wait "$pid" 2>/dev/null || got=$?
    hears_no_panic "$name"
    [ "$got" -eq "$code" ] || { cat err >&2; fail "$name: exit $got, not $code"; }
    passed=$((passed + 1))
}
ends=(INT TERM HUP)
if [ $((0x$(sed -n 's/^SigIgn:\t//p' /proc/self/status 2>/dev/null || echo 0) & 1)) -eq 1 ]; then
    skip "no SIGHUP: this was begun by nohup"
    ends=(INT TERM)
fi
for signal in "${ends[@]}"; do
    signalled "$signal" 130 "told to end: $signal" "$program"
    has "--resume$" err
    is_whole told "told to end: $signal"
done
signalled "HUP TERM" 130 "HUP under nohup" nohup "$program"
has "--resume$" err
# Told once: what was begun would take several times as long as it is given to end; then it is killed, which is 137.
for words in "stability --depth thorough --out told-stiff" "0.3 16777216 10"; do
    # shellcheck disable=SC2086 # words of a command line
    expect 130 "told to end: $words" timeout --foreground --preserve-status -s INT -k 5 1 "$program" $words
    has "interrupted$" err
done
is_whole told-stiff "told to end: stability"
signalled KILL 137 "killed" "$program"
expect 0 "what a killed run leaves" "$program" report told

printf '%s passed, %s skipped, 0 failed\n' "$passed" "$skipped"
