//! Streams of operations at every level, for what they cost at least.

use super::EVERY_FORM;
use crate::batch::{ArithmeticJob, Kind, mix};
use crate::job::Job;
use crate::level::{Level, On, available};
use crate::number::{Element, Toggle};

/// A mix of operations in the registers of a level.
pub struct OneStream {
    /// The mix, see [`mix`].
    pub mix: u64,
    /// `f32` or `f64`.
    pub precision: &'static str,
    /// Numbers in a register.
    pub lanes: usize,
    /// The level.
    pub level: &'static str,
    /// Whether this processor has it.
    pub available: fn() -> bool,
    /// The loop.
    pub job: fn() -> Box<dyn Job>,
}

impl OneStream {
    /// What it is made of: a kind, two in turn (`add + flip`), or one at every third place
    /// (`add + 2 flip`).
    pub fn name(&self) -> String {
        let counts = Kind::ALL.map(|kind| (mix::count(self.mix, kind), kind.word()));
        let mut held: Vec<_> = counts.into_iter().filter(|(count, _)| *count > 0).collect();
        held.sort_by_key(|(count, _)| *count);
        let least = held.first().map_or(1, |(count, _)| *count);
        let word = |(count, word): &(usize, &str)| match count / least {
            1 => (*word).to_owned(),
            times => format!("{times} {word}"),
        };
        held.iter().map(word).collect::<Vec<_>>().join(" + ")
    }

    /// Unique among all streams.
    pub fn id(&self) -> String {
        let OneStream { precision, lanes, level, .. } = self;
        format!("stream/{precision}/packet{lanes}/{level}/{}", self.name().replace(' ', ""))
    }
}

fn one<L: Level, R: Toggle + On<L>, const MIX: u64>(v: &mut Vec<OneStream>) {
    v.push(OneStream {
        mix: MIX,
        precision: R::Element::NAME,
        lanes: R::LANES,
        level: L::NAME,
        available: available::<L>,
        job: || Box::new(ArithmeticJob::stream::<L, R, MIX>()),
    });
}

/// A kind alone, in turn with flips, and with two flips to one of it.
macro_rules! among_flips {
    ($v:ident, $L:ident, $R:ident, $($kind:ident)*) => {$(
        one::<$L, $R, { mix::alone(Kind::$kind) }>($v);
        one::<$L, $R, { mix::half(Kind::$kind, Kind::Flip) }>($v);
        one::<$L, $R, { mix::third(Kind::$kind, Kind::Flip) }>($v);
    )*};
}

/// What every level has. Selections are not among it: twelve numbers, two masks and what SSE needs beside
/// them are more than its registers, and there selections are not bounded.
fn plain<L: Level, R: Toggle + On<L>>(v: &mut Vec<OneStream>) {
    one::<L, R, { mix::alone(Kind::Flip) }>(v);
    one::<L, R, { mix::alone(Kind::Divide) }>(v);
    one::<L, R, { mix::alone(Kind::Load) }>(v);
    one::<L, R, { mix::half(Kind::Add, Kind::Multiply) }>(v);
    among_flips!(v, L, R, Add Multiply Compare);
}

/// And what those have that can round a product and a sum at once.
fn fused<L: Level, R: Toggle + On<L>>(v: &mut Vec<OneStream>) {
    plain::<L, R>(v);
    one::<L, R, { mix::half(Kind::Add, Kind::Fused) }>(v);
    one::<L, R, { mix::half(Kind::Multiply, Kind::Fused) }>(v);
    among_flips!(v, L, R, Fused Select);
}

/// Every level at its native width, and AVX2 in the registers that single numbers are in as well.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
pub fn streams() -> Vec<OneStream> {
    use fearless_simd::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};

    use crate::level::{Avx2, Avx512, Sse2, Sse42};
    use crate::number::Lanes;

    type On<L, V> = Lanes<<L as Level>::Token, V>;
    let mut v = Vec::new();
    plain::<Sse2, On<Sse2, f32x4<_>>>(&mut v);
    fused::<Avx2, On<Avx2, f32x8<_>>>(&mut v);
    if !EVERY_FORM {
        return v;
    }
    plain::<Sse42, On<Sse42, f32x4<_>>>(&mut v);
    fused::<Avx2, On<Avx2, f32x4<_>>>(&mut v);
    fused::<Avx512, On<Avx512, f32x16<_>>>(&mut v);
    plain::<Sse2, On<Sse2, f64x2<_>>>(&mut v);
    fused::<Avx2, On<Avx2, f64x2<_>>>(&mut v);
    fused::<Avx2, On<Avx2, f64x4<_>>>(&mut v);
    fused::<Avx512, On<Avx512, f64x8<_>>>(&mut v);
    v
}

/// The one level at its native width.
#[cfg(target_arch = "aarch64")]
pub fn streams() -> Vec<OneStream> {
    use fearless_simd::{f32x4, f64x2};

    use crate::level::Neon;
    use crate::number::Lanes;

    type On<L, V> = Lanes<<L as Level>::Token, V>;
    let mut v = Vec::new();
    fused::<Neon, On<Neon, f32x4<_>>>(&mut v);
    fused::<Neon, On<Neon, f64x2<_>>>(&mut v);
    v
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn streams_are_named_after_what_they_hold_and_no_two_are_the_same() {
        let all = streams();
        let ids: BTreeSet<String> = all.iter().map(OneStream::id).collect();
        assert_eq!(ids.len(), all.len());
        let names: BTreeSet<String> = all.iter().map(OneStream::name).collect();
        for name in ["divide", "add + multiply", "fused + flip", "select + 2 flip"] {
            assert!(names.contains(name), "{name}: {names:?}");
        }
    }
}
