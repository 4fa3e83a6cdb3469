# Judges the code of batch functions. Input: `objdump -d -C --no-show-raw-insn -M intel` of a
# program with v0 symbol names. Rules and limits stand in `limits` and `judge`; -v facts=1 prints a
# line of findings per function instead of judging. Streams are judged in check_codegen_streams.awk.
# POSIX awk.

BEGIN { FS = "\t"; limits() }

/^[0-9a-f]+ <.*>:$/ { finish(); begin($0); next }
inside && /^ *[0-9a-f]+:\t/ { take($0) }
END { finish(); if (!facts) { placebos(); summary() } }

# Keeps a function if it is a batch; its axes are read from its demangled name.
function begin(line,    name, rest) {
    inside = 0
    if (line !~ /level::Level>::enter(::)?</) return
    name = line
    sub(/^[0-9a-f]+ </, "", name); gsub(/\[[0-9a-f]+\]/, "", name)
    vectorized = name ~ /vectorize_/
    # Of `<module::Avx2 as module::Level>::enter::<Pairs<...>, 0>` first `Avx2`, then what is entered.
    level = name; sub(/ as [^ ]*level::Level>::enter(::)?<.*/, "", level)
    sub(/^.*</, "", level); sub(/^.*::/, "", level)
    rest = name; sub(/^.*level::Level>::enter(::)?</, "", rest)
    sub(/>::\{closure#0\}, .*$/, "", rest); sub(/>>:$/, "", rest)
    gsub(/[a-z_0-9]+::/, "", rest)
    # The shell of a level above the baseline holds the code; what enters it is a few instructions.
    if (!vectorized && level ~ /^(Sse4_?2|Avx2|Avx512)$/) return
    drive = rest; sub(/<.*/, "", drive)
    # What other crates write is theirs.
    if (drive == "ForeignPairs") { skip("tests that are not ours"); return }
    kernel = rest; sub(/^[A-Za-z]*</, "", kernel); sub(/[<,].*/, "", kernel)
    form = rest; if (!sub(/^.*Form</, "", form)) form = "Early, None, Plain, Tuv"
    gsub(/>.*/, "", form); split(form, axis, /, /)
    full = axis[1] == "Full"; once = axis[1] == "Once"; exit_ = full ? "full" : "early"
    divides_first = axis[2] == "First"; output = axis[4]
    # The mix of a stream: a digit of 16 for each of its twelve places.
    mix = 0
    if (drive == "Stream" && match(rest, />, [0-9]+/)) mix = substr(rest, RSTART + 3, RLENGTH - 3)
    packet = rest ~ /Lanes</
    # Of a single ray, a vector in a register: its one division is of a register, too.
    vector = rest ~ /Xyz</
    wide = !packet ? "" : rest ~ /f32x16|f64x8/ ? "zmm" : rest ~ /f32x8|f64x4/ ? "ymm" : "xmm"
    registers = rest ~ /Twice<Twice</ ? 4 : rest ~ /Twice</ ? 2 : 1
    # Of a bundle, how many rays: their tests may stand one after the other in one loop.
    bundle = 1
    if (drive == "Bundle") { bundle = rest; sub(/>, [^,]*$/, "", bundle); sub(/^.*, /, "", bundle); bundle += 0 }
    copy = rest; sub(/^.*, /, "", copy); sub(/: usize/, "", copy)
    symbol = level " " rest
    inside = 1; n = 0
    split("", at); split("", text); split("", op); split("", addr)
}

function take(line,    cut, t) {
    cut = index(line, ":\t")
    t = substr(line, cut + 2)
    sub(/^(bnd|notrack|data16|cs|ds|rep|repz|lock) +/, "", t)
    if (t == "" || t ~ /^(nop|xchg +ax,ax|int3)/) t = "nop"
    n++
    addr[n] = substr(line, 1, cut - 1); gsub(/ /, "", addr[n])
    text[n] = t; op[n] = t; sub(/ .*/, "", op[n])
    at[addr[n]] = n
}

# Successors become predecessor lists; a call that never returns ends its block.
function link(    i, target, stops) {
    split("", preds); split("", jump); indirect = 0; cold = 0
    for (i = 1; i <= n; i++) {
        stops = op[i] ~ /^(ret|ud2|jmp)$/
        if (op[i] == "call" && text[i] ~ /panic|_fail|expect/) { stops = 1; cold++ }
        if (op[i] ~ /^j/) {
            target = text[i]; sub(/^[a-z]+ +/, "", target); sub(/ .*/, "", target)
            if (target in at) { jump[i] = at[target]; preds[at[target]] = preds[at[target]] " " i }
            else { jump[i] = 0; if (op[i] == "jmp" && target !~ /^[0-9a-f]+$/) indirect = i }
        }
        falls[i] = !stops && i < n
        if (falls[i]) preds[i + 1] = preds[i + 1] " " i
    }
}

# The natural loop of the back edge from -> head: what reaches `from` without passing `head`.
# Empty if that includes the entry, because then `head` does not dominate `from`.
function grow(head, from,    stack, top, i, k, p, count) {
    split("", body)
    body[head] = 1; top = 0
    if (from != head) { body[from] = 1; stack[++top] = from }
    while (top > 0) {
        i = stack[top--]
        if (i == 1) return 0
        count = split(preds[i], p, " ")
        for (k = 1; k <= count; k++) if (!(p[k] in body)) { body[p[k]] = 1; stack[++top] = p[k] }
    }
    return 1
}

# Every edge back to an instruction on the path from the entry closes a loop.
function loops(    i, top, path, seen, next_, k, to) {
    split("", member); split("", heads); loop_count = 0
    path[top = 1] = 1; seen[1] = 1
    while (top > 0) {
        i = path[top]; to = 0
        if (++next_[i] == 1) to = falls[i] ? i + 1 : jump[i]
        else if (next_[i] == 2 && falls[i]) to = jump[i]
        else if (next_[i] > 1) { seen[i] = 2; top--; continue }
        if (!to || to > n) continue
        if (seen[to] == 1 && grow(to, i)) {
            if (!(to in heads)) heads[to] = ++loop_count
            for (k in body) member[heads[to], k] = 1
        } else if (!seen[to]) { seen[to] = 1; path[++top] = to }
    }
}

# The innermost loop with the most arithmetic (0 if there is none).
function inner_loop(    l, i, best, score, most) {
    best = 0; most = 0
    for (l = 1; l <= loop_count; l++) {
        score = 0
        for (i = 1; i <= n; i++) if ((l, i) in member) {
            if (op[i] ~ /^v?(mul|div|fn?m(add|sub)[0-9]*)(ps|pd|ss|sd)$/) score++
            else if (drive == "Stream" && kind_of(op[i]) != "") score++
            if ((i in heads) && heads[i] != l) { score = 0; break }
        }
        if (score > most) { most = score; best = l }
    }
    return best
}

# What the loops of one function hold.
function finish(    l, i, k, in_loop) {
    if (!inside) return
    inside = 0
    link(); loops(); l = inner_loop()
    split("", found); split("", shown)
    for (i = 1; i <= n; i++) {
        in_loop = 0
        for (k = 1; k <= loop_count; k++) if ((k, i) in member) in_loop = 1
        if (!in_loop) continue
        if (op[i] == "call") note("calls", i)
        if (op[i] == "call" && (l, i) in member) note("inner calls", i)
        if (op[i] ~ /^j/ && op[i] != "jmp") note((l, i) in member ? "jumps" : "outer", i)
        # A walk through a hierarchy has several loops, one in the other.
        if ((l, i) in member || drive == "Through") classify(i)
    }
    if (indirect) note("tables", indirect)
    if (cold) note("panics", cold)
    if (!l && kernel != "AngleSum" && drive != "Through") note("lost", 1)
    if (copy > 0) keep_placebo()
    if (facts) print_facts(); else judge()
}

function note(what, i) { found[what]++; shown[what] = addr[i] ": " text[i] }

# One instruction of the inner loop.
function classify(i,    t) {
    t = text[i]
    note("length", i)
    if (op[i] ~ /^v?div(ss|sd)$/) note("divisions", i)
    if (op[i] ~ /^v?div(ps|pd)$/) note("packed divisions", i)
    if (op[i] ~ /^v?(mul|add|sub|div|fn?m(add|sub)[0-9]*)(ps|pd)$/)
        note(t ~ /zmm/ ? "zmm" : t ~ /ymm/ ? "ymm" : "xmm", i)
    if (t ~ /^v?mov[a-z0-9]* +[XYZ]MMWORD PTR \[rsp[^\]]*\],[xyz]mm/) note("spills", i)
    if (drive == "Stream" && kind_of(op[i]) != "" && (wide == "xmm" || t ~ wide)) note(kind_of(op[i]), i)
}

function print_facts(    k, line, names) {
    split("length jumps outer calls panics tables divisions packed_divisions xmm ymm zmm spills", names, " ")
    line = symbol "\t" level "\t" drive "\t" kernel "\t" (packet ? "packet" : "single") "\t" exit_ "\t" output
    for (k = 1; k in names; k++) { sub(/_/, " ", names[k]); line = line "\t" names[k] "=" (found[names[k]] + 0) }
    print line
}

# One rule on this function: counted, and reported where it does not hold.
function rule(name, holds, what, reason) {
    checked[level " " (packet ? "packet" : "single") "\t" name]++
    if (holds) return
    violations++
    print "violation (" name "): " symbol
    print "    " reason (what in shown ? ": " found[what] ", the last is " shown[what] : "")
}

function skip(reason) { skipped[reason]++ }

function judge() {
    functions[level " " (packet ? "packet" : "single")]++
    rule("loop", !found["lost"], "", "no loop with arithmetic")
    rule("panics", !found["panics"], "panics", "a bounds check")
    rule("tables", !found["tables"], "tables", "a jump table")
    if (kernel == "AngleSum") { skip("angle-sum: arccos is a call of libm"); return }
    if (drive == "Through") { judge_walk(); return }
    # A packet of four registers is cleared and copied by calls, once for all of its triangles.
    if (registers == 4) rule("calls", !found["inner calls"], "inner calls", "calls in the loop over triangles")
    else rule("calls", !found["calls"], "calls", "calls in a loop")
    if (drive == "Stream") { judge_stream(); return }
    if (packet) judge_packet(); else judge_single()
}

function judge_packet(    w, limit, key) {
    for (w in widths) if (w != wide && w != "xmm")
        rule("width", !found[w], w, "arithmetic on " w " where lanes are " wide)
    if (wide != "xmm") rule("width", found["xmm"] <= narrow[kernel], "xmm", \
        "packed arithmetic on xmm beyond the " (narrow[kernel] + 0) " of this kernel's triangle")
    rule("width", found[wide] > 0, "", "no arithmetic on " wide)
    key = level " " exit_ (registers > 1 ? " x" registers : ""); limit = most_spills[key, kernel]
    if (limit == "") limit = most_spills[key, ""]
    if (output == "Surface") limit += surface_spills
    if (limit > 0) limit += slack
    rule("spills", found["spills"] <= limit, "spills", "stores to the stack beyond " (limit + 0))
}

# Boxes and triangles of a group are met on the widest registers. Calls are there, in loops: the stack grows,
# and what rounding might decide is met in f64, elsewhere.
function judge_walk(    w) {
    skip("walks through hierarchies: calls, and what is kept on the stack")
    rule("width", found[wide] > 0, "", "no arithmetic on " wide)
    for (w in widths) if (w != wide && w != "xmm")
        rule("width", !found[w], w, "arithmetic on " w " where lanes are " wide)
}

function judge_single(    d, p, most) {
    # t, u and v of one f64 hit times one reciprocal may be one wide multiplication: inside one test.
    most = !divides_first && (symbol ~ /, f64>/ || kernel == "MollerTrumboreInF64") ? 1 : 0
    rule("width", found["ymm"] <= most, "ymm", "wide arithmetic in a single form beyond " most)
    rule("width", !found["zmm"], "zmm", "wide arithmetic in a single form")
    if (full) {
        rule("jumps", found["jumps"] <= 1, "jumps", "jumps in the inner loop of a full form")
        rule("jumps", found["outer"] <= 2, "outer", "jumps in the outer loop of a full form")
    }
    # The end of the loop, the one question, and what the nearest hit is kept by.
    if (once) rule("jumps", found["jumps"] <= 3, "jumps", "jumps in the inner loop of a form that asks once")
    d = found["divisions"] + 0; p = found["packed divisions"] + 0; most = divisions[kernel] + 0
    if (drive == "Listed") {
        skip("listings: divisions are as printed")
        rule("divisions", !p, "packed divisions", "a packed division")
        return
    }
    most *= bundle
    if (vector) {
        rule("width", found["xmm"] > 0, "", "no packed arithmetic where a vector is a register")
        rule("divisions", !d && p <= most, d ? "divisions" : "packed divisions", "more divisions than the " most " of one test")
        return
    }
    rule("divisions", d + 2 * p <= most, "divisions", "more divisions than the " most " of one test")
    # A test with several of them may do two in one instruction; that is still one test.
    rule("divisions", !p || most >= 2, "packed divisions", "a packed division")
}

# The code of a placebo, without what differs by where it lies.
function keep_placebo(    i, t) {
    placebo_at[drive, copy] = addr[1]
    for (i = 1; i <= n; i++) {
        t = text[i]
        if (op[i] ~ /^j/) t = op[i] " " (jump[i] - i)
        sub(/\[rip\+[^\]]*\] +#/, "", t)
        if (op[i] == "call") sub(/ [0-9a-f]+ /, " ", t)
        if (t == "nop") continue
        if (t ~ "^mov +QWORD PTR .*,0x" copy "$") sub(/0x[0-9]+$/, "COPY", t)
        placebo_code[drive, copy] = placebo_code[drive, copy] "\n" t
    }
}

function placebos(    drives, k, d, c) {
    split("Pairs Nearest", drives, " ")
    level = "placebos"; packet = 0
    for (k = 1; k <= 2; k++) for (c = 2; c <= 3; c++) {
        d = drives[k]; symbol = d " of copy " c
        rule("placebos", placebo_at[d, 1] != "" && placebo_at[d, c] != "", "", "a copy of the reference is missing")
        rule("placebos", placebo_at[d, 1] != placebo_at[d, c], "", "merged with copy 1")
        rule("placebos", placebo_code[d, 1] == placebo_code[d, c], "", "its code is not that of copy 1")
    }
}

function summary(    k, part) {
    for (k in functions) print "checked: " functions[k] " functions, " k | "sort"
    close("sort")
    for (k in checked) { split(k, part, "\t"); print "rule: " part[2] ", " part[1] ": " checked[k] | "sort" }
    close("sort")
    for (k in skipped) print "skipped: " skipped[k] " functions, " k
    print "violations: " violations + 0
    exit violations > 0
}

# What a form may hold. The limits on spills only ever go down. They were read off one build; the
# same source cut into other units of compilation moves a register or two, which is what `slack` is
# for. AVX-512 has registers enough: there light kernels hold to none at all.
function limits(    k, i, list, part) {
    widths["xmm"]; widths["ymm"]; widths["zmm"]
    k = split("MollerTrumbore KenslerShirley Shevtsov Wald PerpendicularPlanes BaldwinWeber " \
        "WoopAffine MollerTrumboreInF64", list, " ")
    for (i = 1; i <= k; i++) divisions[list[i]] = 1
    k = split("BadouelCramer Keidy Chirkov Plucker HalfSpaces SignedAreas EmbreePlucker", list, " ")
    for (i = 1; i <= k; i++) divisions[list[i]] = 2
    # Three of them are the shear of the ray, which a pair has for itself.
    divisions["WoopWatertight"] = 4

    # What these kernels compute of the triangle alone, once per packet, the compiler may pack.
    k = split("KenslerShirley=9 Plucker=11 HalfSpaces=10 Keidy=4 SignedAreas=1", list, " ")
    for (i = 1; i <= k; i++) { split(list[i], part, "="); narrow[part[1]] = part[2] + 1 }

    # Level, exit, most spills. SSE and AVX2 have 16 registers, and a test holds more than that: the
    # best hit (4), the ray (6), the triangle (9 to 12), and what is being computed.
    k = split("Sse2/early=6 Sse2/full=6 Sse42/early=6 Sse42/full=7 Avx2/early=7 Avx2/full=9 " \
        "Avx512/early=0 Avx512/full=0", list, " ")
    for (i = 1; i <= k; i++) { split(list[i], part, "[/=]"); most_spills[part[1] " " part[2], ""] = part[3] }
    # Kernels whose test holds three corners, or edges, and a normal beside the ray.
    k = split("Sse2/early=19 Sse2/full=21 Sse42/early=18 Sse42/full=22 Avx2/early=18 Avx2/full=21 " \
        "Avx512/early=3 Avx512/full=1", list, " ")
    for (i = 1; i <= k; i++) {
        split(list[i], part, "[/=]")
        heavy("Chirkov HalfSpaces Keidy Plucker SignedAreas", part[1] " " part[2], part[3])
    }
    # Kernels that bring every vertex to the ray, by lane, or compute two normals. As read off a build;
    # of AVX-512 in `full` the most is 16, with the normal of the hit and the slack below in it.
    k = split("Sse2/early=22 Sse2/full=28 Sse42/early=22 Sse42/full=26 Avx2/early=22 Avx2/full=22 " \
        "Avx512/early=3 Avx512/full=6", list, " ")
    for (i = 1; i <= k; i++) {
        split(list[i], part, "[/=]")
        heavy("WoopWatertight EmbreePlucker", part[1] " " part[2], part[3])
    }
    # A ray whose components are picked by index lies in memory, and its shrinking bound with it.
    heavy("Wald Shevtsov BadouelCramer", "Avx512 early", 1)
    heavy("Wald Shevtsov BadouelCramer", "Avx512 full", 1)
    # Packets of two registers and of four hold two and four of everything: they spill by design, and what
    # they gain or lose by it is what they are measured for. As read off a build.
    long_packets()
    # The normal of the best hit is three registers more.
    surface_spills = 6
    slack = 4
}

function long_packets() {
    most_spills["Avx2 full x2", ""] = 26
    most_spills["Avx512 full x2", ""] = 8
    most_spills["Avx2 full x4", ""] = 84
    most_spills["Avx512 full x4", ""] = 39
    heavy("Chirkov HalfSpaces Keidy Plucker SignedAreas", "Avx2 full x2", 37)
    heavy("Chirkov HalfSpaces Keidy Plucker SignedAreas", "Avx512 full x2", 22)
    heavy("WoopWatertight EmbreePlucker", "Avx2 full x2", 84)
    heavy("WoopWatertight EmbreePlucker", "Avx512 full x2", 33)
}

function heavy(kernels, key, limit,    k, i, list) {
    k = split(kernels, list, " ")
    for (i = 1; i <= k; i++) most_spills[key, list[i]] = limit
}
