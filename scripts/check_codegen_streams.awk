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

# Exactly the operations of its mix, in the widest registers, and nothing kept on the stack. Several walks
# may be done at once. What joins comparisons is among the logic, and operands may be moved.
function judge_stream(    place, rest, want, k, kinds, walks) {
    split("", want)
    split("add multiply fused divide compare", kinds, " ")
    rest = mix
    for (place = 0; place < 12; place++) { k = rest % 16; want[k == 8 ? 1 : k]++; rest = int(rest / 16) }
    walks = 1
    for (k = 1; k <= 5; k++) if (want[k] && found[kinds[k]] > want[k]) walks = int(found[kinds[k]] / want[k])
    for (k = 1; k <= 5; k++) rule("mix", found[kinds[k]] + 0 == walks * want[k], kinds[k], \
        found[kinds[k]] + 0 " times " kinds[k] " where " walks " walks have " walks * want[k])
    rule("mix", found["logic"] + 0 >= walks * (want[6] + want[7]), "logic", \
        "selections and flips fewer than the " walks * (want[6] + want[7]) " of " walks " walks")
    rule("spills", !found["spills"], "spills", "stores to the stack in a stream")
}
