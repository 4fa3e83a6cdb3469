# Sourced by check_codegen.sh: small disassemblies, one good and many that must fail by their rule.

form='ray_test::policy::Form<ray_test::policy::axes::Full, ray_test::policy::scale::First, ray_test::policy::axes::Plain, ray_test::policy::axes::Tuv>'
kernel='ray_test::kernels::wald::Wald'
lanes='ray_test::number::Lanes<fearless_simd::Avx512, fearless_simd::f32x16<fearless_simd::Avx512>>'
packet="<<fearless_simd::Avx512 as fearless_simd::Simd>::vectorize::vectorize_avx512::<<ray_test::level::avx512::Avx512 as ray_test::level::Level>::enter<ray_test::batch::Nearest<$kernel, $form, $lanes>, 0: usize>::{closure#0}, ray_test::job::Tally>>:"
# Six fused and six flips in turn, as 0x373737373737.
stream="<<fearless_simd::Avx512 as fearless_simd::Simd>::vectorize::vectorize_avx512::<<ray_test::level::avx512::Avx512 as ray_test::level::Level>::enter<ray_test::batch::stream::Stream<$lanes, 60710289094455: u64>, 0: usize>::{closure#0}, u64>>:"
single="<<ray_test::level::sse2::Sse2 as ray_test::level::Level>::enter::<ray_test::batch::Nearest<$kernel, $form, f32>, 0>>:"
vector="<<ray_test::level::sse2::Sse2 as ray_test::level::Level>::enter::<ray_test::batch::in_registers::InRegisters<$kernel, $form, ray_test::number::xyz::Xyz<fearless_simd::Sse2, ray_test::number::xyz::Horizontal>>, 0>>:"
placebo="<<ray_test::level::sse2::Sse2 as ray_test::level::Level>::enter::<ray_test::batch::DRIVE<$kernel, $form, f32>, COPY>>:"

# code NAME INSTRUCTION...: a function as objdump prints it, eight bytes an instruction.
code() {
    local name=$1 at=$2
    shift 2
    printf '%016x %s\n' "$at" "$name"
    for instruction; do
        printf '  %x:\t%s\n' "$at" "$instruction"
        at=$((at + 8))
    done
}

# Three equal copies for each batch, so that only the function under test can fail.
placebos() {
    local drive copy at=65536 name
    for drive in Pairs Nearest; do
        for copy in 1 2 3; do
            name=${placebo/DRIVE/$drive}
            code "${name/COPY/$copy}" $at "mov    QWORD PTR [rsp-0x8],0x$copy" \
                "${placebo_extra[$copy]:-divss  xmm0,xmm1}" "jne    $(printf %x $((at + 8))) <x>" "ret"
            at=$((at + 256))
        done
    done
}

# expect RULE NAME INSTRUCTION...: the code must fail by that rule only; RULE "none" must pass.
expect() {
    local rule=$1 output status=0
    shift
    output=$({ placebos; code "$1" 4096 "${@:2}"; } | judge) || status=$?
    local rules
    rules=$(sed -n 's/^violation (\([a-z]*\)).*/\1/p' <<<"$output" | sort -u)
    if [ "${rules:-none}" != "$rule" ] || { [ "$rule" = none ] && [ $status -ne 0 ]; } || { [ "$rule" != none ] && [ $status -eq 0 ]; }; then
        echo "self-test: expected '$rule', found '${rules:-none}' (exit $status)" >&2
        echo "$output" >&2
        exit 1
    fi
    tests=$((tests + 1))
}

tests=0
declare -A placebo_extra=()
loop='jne    1000 <x>'
wide='vmulps zmm0,zmm1,zmm2'
good='mulss  xmm0,xmm1'

expect none "$packet" "$wide" "$loop" ret
expect none "$single" "$good" 'divss  xmm0,xmm1' "$loop" ret
expect none "$vector" 'mulps  xmm0,xmm1' 'divps  xmm0,xmm1' "$loop" ret
expect divisions "$vector" 'divps  xmm0,xmm1' 'divps  xmm0,xmm1' 'mulps  xmm0,xmm1' "$loop" ret
expect divisions "$vector" 'divss  xmm0,xmm1' 'mulps  xmm0,xmm1' "$loop" ret
expect width "$vector" "$good" "$loop" ret
# An inner loop that is entered in its middle, as compilers rotate them, is found.
expect width "$packet" 'jmp    1018 <x>' 'vmulps ymm0,ymm1,ymm2' "$wide" "$wide" 'jne    1008 <x>' ret
expect calls "$packet" "$wide" 'call   9000 <helper>' "$loop" ret
expect panics "$packet" "$wide" "$loop" ret 'call   9000 <core::panicking::panic_bounds_check>'
expect tables "$packet" "$wide" "$loop" 'jmp    rax'
expect width "$packet" "$wide" 'vmulps ymm0,ymm1,ymm2' "$loop" ret
expect width "$packet" "$wide" 'vmulps xmm0,xmm1,xmm2' "$loop" ret
expect width "$packet" 'vmulss xmm0,xmm1,xmm2' "$loop" ret
expect spills "$packet" "$wide" 'vmovups ZMMWORD PTR [rsp+0x40],zmm3' 'vmovups ZMMWORD PTR [rsp+0x80],zmm3' 'vmovups ZMMWORD PTR [rsp+0xc0],zmm3' \
    'vmovups ZMMWORD PTR [rsp+0x100],zmm3' 'vmovups ZMMWORD PTR [rsp+0x140],zmm3' \
    'vmovups ZMMWORD PTR [rsp+0x180],zmm3' "$loop" ret
expect width "$single" "$good" 'vmulps ymm0,ymm1,ymm2' "$loop" ret
expect divisions "$single" "$good" 'divps  xmm0,xmm1' "$loop" ret
expect divisions "$single" "$good" 'divss  xmm0,xmm1' 'divss  xmm2,xmm3' "$loop" ret
expect jumps "$single" "$good" 'je     1018 <x>' "$good" "$loop" ret
expect jumps "${single/axes::Full/exit::Once}" "$good" 'je     1018 <x>' "$good" 'je     1028 <x>' "$good" \
    'je     1038 <x>' "$good" "$loop" ret
expect loop "$single" "$good" ret
walk=${packet/batch::Nearest/structure::wide::walk::Through}
expect none "$walk" "$wide" 'call   9000 <grow>' 'jne    1008 <x>' "$loop" ret
expect width "$walk" 'vmulss xmm0,xmm1,xmm2' 'call   9000 <grow>' "$loop" ret
# What other crates' tests do is no matter.
expect none "${single/batch::Nearest/batch::foreign::ForeignPairs}" 'call   9000 <theirs>' "$loop" ret
flip='vpxord zmm0,zmm0,zmm1'
fused='vfmadd213ps zmm0,zmm1,zmm2'
pairs=("$flip" "$fused" "$flip" "$fused" "$flip" "$fused" "$flip" "$fused" "$flip" "$fused")
expect none "$stream" "${pairs[@]}" "$flip" "$fused" "$loop" ret
expect mix "$stream" "${pairs[@]}" "$flip" "$loop" ret
expect mix "$stream" "${pairs[@]}" "$fused" "$loop" ret
expect mix "$stream" "${pairs[@]}" "$flip" "$fused" "$fused" "$loop" ret
expect mix "$stream" "${pairs[@]}" "$flip" "${fused//zmm/ymm}" "$loop" ret
expect spills "$stream" "${pairs[@]}" "$flip" "$fused" 'vmovups ZMMWORD PTR [rsp+0x40],zmm3' "$loop" ret
placebo_extra[2]='divss  xmm0,xmm2'
expect placebos "$packet" "$wide" "$loop" ret
echo "self-test: $tests cases"
