//! The axis `exit`: where a test may end, with a jump or without any.

use std::hint::black_box;

use super::Miss;
use crate::number::{Mask, Real};

/// When a test may end.
pub trait Exit: Copy + 'static {
    /// The column `exit`.
    const NAME: &'static str;
    /// Whether the answers of all tests are united, so that no test ends between the first and the last.
    const UNITES: bool;
    /// Whether the range test waits for the end.
    const DEFERS_RANGE: bool;
    /// Whether what few lanes need is computed: in `early` where one does, else always.
    fn corrects<M: Mask>(needed: M) -> bool;
    /// Behind each test: goes on, or leaves with `code`.
    fn keep<M: Mask>(mask: M, code: u8) -> Result<M, Miss>;
    /// Behind the last test, before what a hit alone needs: goes on, or leaves.
    fn settle<M: Mask>(mask: M) -> Result<M, Miss>;
    /// `yes` where `mask` holds, else `no`; `early` may jump for it.
    fn select<R: Real, const N: usize>(mask: R::Mask, yes: [R; N], no: [R; N]) -> [R; N];
    /// All bits set for a hit, none otherwise; in `full` without a jump around what it masks.
    fn spread(hit: bool) -> u64;
}

/// Leave as soon as no lane can hit.
#[derive(Clone, Copy)]
pub struct Early;
/// Unite the answers of all tests and ask once, before the division and what is reported.
#[derive(Clone, Copy)]
pub struct Once;
/// Do all the work, whatever the lanes say (the thesis's worst case).
#[derive(Clone, Copy)]
pub struct Full;

impl Exit for Early {
    const NAME: &'static str = "early";
    const UNITES: bool = false;
    const DEFERS_RANGE: bool = false;
    #[inline(always)]
    fn corrects<M: Mask>(needed: M) -> bool {
        needed.any()
    }
    #[inline(always)]
    fn keep<M: Mask>(mask: M, code: u8) -> Result<M, Miss> {
        if mask.any() { Ok(mask) } else { Err(Miss(code)) }
    }
    #[inline(always)]
    fn settle<M: Mask>(mask: M) -> Result<M, Miss> {
        Ok(mask)
    }
    #[inline(always)]
    fn select<R: Real, const N: usize>(mask: R::Mask, yes: [R; N], mut no: [R; N]) -> [R; N] {
        for (no, yes) in no.iter_mut().zip(yes) {
            *no = R::select(mask, yes, *no);
        }
        no
    }
    #[inline(always)]
    fn spread(hit: bool) -> u64 {
        u64::from(hit).wrapping_neg()
    }
}

impl Exit for Once {
    const NAME: &'static str = "once";
    const UNITES: bool = true;
    const DEFERS_RANGE: bool = false;
    #[inline(always)]
    fn corrects<M: Mask>(_: M) -> bool {
        true
    }
    #[inline(always)]
    fn keep<M: Mask>(mask: M, _: u8) -> Result<M, Miss> {
        Ok(mask)
    }
    /// The only way out, code 1. The comparisons of one scalar are united where the optimiser cannot
    /// look: it would take them apart again, into a jump behind each.
    #[inline(always)]
    fn settle<M: Mask>(mask: M) -> Result<M, Miss> {
        let mask = if M::LANES == 1 { black_box(mask) } else { mask };
        if mask.any() { Ok(mask) } else { Err(Miss(1)) }
    }
    #[inline(always)]
    fn select<R: Real, const N: usize>(mask: R::Mask, yes: [R; N], no: [R; N]) -> [R; N] {
        Early::select(mask, yes, no)
    }
    #[inline(always)]
    fn spread(hit: bool) -> u64 {
        Early::spread(hit)
    }
}

impl Exit for Full {
    const NAME: &'static str = "full";
    const UNITES: bool = true;
    const DEFERS_RANGE: bool = true;
    #[inline(always)]
    fn corrects<M: Mask>(_: M) -> bool {
        true
    }
    #[inline(always)]
    fn keep<M: Mask>(mask: M, _: u8) -> Result<M, Miss> {
        Ok(mask)
    }
    #[inline(always)]
    fn settle<M: Mask>(mask: M) -> Result<M, Miss> {
        Ok(mask)
    }
    #[inline(always)]
    fn select<R: Real, const N: usize>(mask: R::Mask, yes: [R; N], no: [R; N]) -> [R; N] {
        R::blend(mask, yes, no)
    }
    #[inline(always)]
    fn spread(hit: bool) -> u64 {
        black_box(u64::from(hit).wrapping_neg())
    }
}
