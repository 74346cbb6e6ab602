//! The instruction set of the kernel.

use std::fmt;

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use fearless_simd::Level;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use fearless_simd::x86::{Avx2, Avx512};

#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use crate::double::pair::Fused;
use crate::double::pair::{Arithmetic, Native};

/// An instruction set that this processor supports.
///
/// All give results within the same bound; [`InstructionSet::baseline`] may differ from the others in the last place.
#[derive(Clone, Copy, Debug)]
pub struct InstructionSet(Instructions);

#[derive(Clone, Copy, Debug)]
enum Instructions {
    Baseline,
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    Avx2(Avx2),
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    Avx512(Avx512),
}

/// Loops that are compiled for each instruction set. `run` must be inlined, with all functions it calls.
pub(in crate::double) trait Work {
    type Output;

    fn run<A: Arithmetic>(self, arithmetic: A) -> Self::Output;
}

/// The work compiled for the instruction set of the token; all of them have FMA.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
#[inline(always)]
fn vectorized<S: fearless_simd::Simd, W: Work>(token: S, work: W) -> W::Output {
    token.vectorize(
        #[inline(always)]
        || work.run(Fused),
    )
}

impl InstructionSet {
    /// The work with these instructions.
    #[inline]
    pub(in crate::double) fn run<W: Work>(self, work: W) -> W::Output {
        match self.0 {
            Instructions::Baseline => work.run(Native),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Instructions::Avx2(token) => vectorized(token, work),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Instructions::Avx512(token) => vectorized(token, work),
        }
    }

    /// The target of the compilation: on x86-64 two points at once, without fused multiply-add.
    pub fn baseline() -> InstructionSet {
        InstructionSet(Instructions::Baseline)
    }

    /// Four points at once, with fused multiply-add: AVX2 and FMA of x86.
    pub fn avx2() -> Option<InstructionSet> {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        return Level::new().as_avx2().map(|token| InstructionSet(Instructions::Avx2(token)));
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        None
    }

    /// Eight points at once: AVX-512 of Ice Lake and later.
    pub fn avx512() -> Option<InstructionSet> {
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        return Level::new().as_avx512().map(|token| InstructionSet(Instructions::Avx512(token)));
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        None
    }

    /// All that this processor supports, the fastest first.
    pub fn available() -> impl Iterator<Item = InstructionSet> {
        [InstructionSet::avx512(), InstructionSet::avx2(), Some(InstructionSet::baseline())].into_iter().flatten()
    }

    /// The fastest that this processor supports.
    pub fn fastest() -> InstructionSet {
        InstructionSet::avx512().or_else(InstructionSet::avx2).unwrap_or_else(InstructionSet::baseline)
    }
}

impl fmt::Display for InstructionSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.0 {
            Instructions::Baseline => "baseline",
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Instructions::Avx2(_) => "AVX2",
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Instructions::Avx512(_) => "AVX-512",
        })
    }
}
