# Judges streams of operations, beside check_codegen.awk, whose facts it uses. POSIX awk.

# The kind of operation of a stream that an instruction does. Selections and flips are what logic and
# blends do, in one instruction or several.
function kind_of(name) {
    if (name ~ /^v?add(ps|pd)$/) return "add"
    if (name ~ /^v?mul(ps|pd)$/) return "multiply"
    if (name ~ /^vfn?m(add|sub)[0-9]*(ps|pd)$/) return "fused"
    if (name ~ /^v?div(ps|pd)$/) return "divide"
    if (name ~ /^v?cmp[a-z_]*(ps|pd)$/) return "compare"
    if (name ~ /^v?(p?x?or|p?andn?|pternlog|p?blendm?|blendv|mova)(ps|pd|d|q|vb)?$/) return "logic"
    return ""
}

# Exactly the operations of its mix, in the widest registers, and nothing kept on the stack.
function judge_stream(    place, rest_, want) {
    split("", want)
    rest_ = mix
    for (place = 0; place < 12; place++) { want[rest_ % 16]++; rest_ = int(rest_ / 16) }
    rule("mix", found["add"] + 0 == want[1] + want[8], "add", "additions other than " want[1] + want[8])
    rule("mix", found["multiply"] + 0 == want[2] + 0, "multiply", "multiplications other than " want[2] + 0)
    rule("mix", found["fused"] + 0 == want[3] + 0, "fused", "fused operations other than " want[3] + 0)
    rule("mix", found["divide"] + 0 == want[4] + 0, "divide", "divisions other than " want[4] + 0)
    rule("mix", found["compare"] + 0 == want[5] + 0, "compare", "comparisons other than " want[5] + 0)
    rule("mix", found["logic"] + 0 >= want[6] + want[7], "logic", "selections and flips fewer than " want[6] + want[7])
    rule("spills", !found["spills"], "spills", "stores to the stack in a stream")
}
