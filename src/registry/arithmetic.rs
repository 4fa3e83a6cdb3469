//! The arithmetic units of every level, for calibration.

use crate::batch::ArithmeticJob;
use crate::job::Job;
use crate::level::{Level, On, available};
use crate::number::{Element, Real};

/// A level's arithmetic on one type of number.
pub struct Unit {
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

fn unit<L: Level, R: Real + On<L>>() -> Unit {
    Unit {
        precision: R::Element::NAME,
        lanes: R::LANES,
        level: L::NAME,
        available: available::<L>,
        job: || Box::new(ArithmeticJob::new::<L, R>()),
    }
}

/// Every level, f32 and f64, at its native width.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
pub fn units() -> Vec<Unit> {
    use fearless_simd::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};

    use crate::level::{Avx2, Avx512, Sse2, Sse42};
    use crate::number::Lanes;

    type On<L, V> = Lanes<<L as Level>::Token, V>;
    vec![
        unit::<Sse2, On<Sse2, f32x4<_>>>(),
        unit::<Sse42, On<Sse42, f32x4<_>>>(),
        unit::<Avx2, On<Avx2, f32x8<_>>>(),
        unit::<Avx512, On<Avx512, f32x16<_>>>(),
        unit::<Sse2, On<Sse2, f64x2<_>>>(),
        unit::<Avx2, On<Avx2, f64x4<_>>>(),
        unit::<Avx512, On<Avx512, f64x8<_>>>(),
    ]
}

/// Every level, f32 and f64, at its native width.
#[cfg(target_arch = "aarch64")]
pub fn units() -> Vec<Unit> {
    use fearless_simd::{f32x4, f64x2};

    use crate::level::Neon;
    use crate::number::Lanes;

    type On<L, V> = Lanes<<L as Level>::Token, V>;
    vec![unit::<Neon, On<Neon, f32x4<_>>>(), unit::<Neon, On<Neon, f64x2<_>>>()]
}
