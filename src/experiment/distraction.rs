//! What happens between two cold calls of a kernel: other kernels run, for the predictor and the
//! first caches, and a stretch of memory is read, for the second-level cache.

use std::hint::black_box;

use crate::job::{Block, Job};
use crate::measure::{Forget, Machine};
use crate::registry::variants;
use crate::workload::{Generator, draw_pairs};

/// Forms that are run, each of half a kilobyte of code and more: several times what a first-level
/// cache of instructions holds (32 to 64 KiB).
const FORMS: usize = 192;

/// Pairs that each of them is run on. Random ones, so that its branches leave their traces.
const PAIRS: usize = 12;

/// Second-level cache where the system does not tell, bytes.
const USUAL_CACHE_BYTES: u64 = 2 << 20;

/// Numbers of a cache line of 64 bytes.
const LINE: usize = 8;

/// Many compiled forms, each with a few pairs, and memory that fills a second-level cache twice.
pub struct Distraction {
    jobs: Vec<(&'static str, Box<dyn Job>)>,
    memory: Vec<u64>,
}

impl Distraction {
    /// Forms of every kernel that this processor can run, spread evenly over the registry.
    pub fn new() -> Self {
        let (mut rays, mut triangles) = (Vec::new(), Vec::new());
        let drawn = draw_pairs(Generator::Pcg, 7, PAIRS, |ray, triangle| {
            rays.push(ray);
            triangles.push(triangle);
        });
        let able = variants().iter().filter(|v| v.pairs.is_some() && (v.available)());
        let able: Vec<_> = if drawn.is_ok() { able.collect() } else { Vec::new() };
        let step = able.len().div_ceil(FORMS).max(1);
        let bound = able.iter().step_by(step).filter_map(|variant| {
            let bind = variant.pairs.as_ref()?;
            Some((variant.axes.kernel, bind(&rays, &triangles)))
        });
        let caches = Machine::this().caches;
        let second = caches.iter().filter(|cache| cache.level == 2 && cache.kind != "Instruction");
        let bytes = second.map(|cache| cache.size_bytes).max().unwrap_or(USUAL_CACHE_BYTES);
        let memory = vec![1; 2 * bytes as usize / size_of::<u64>()];
        Distraction { jobs: bound.collect(), memory }
    }
}

impl Default for Distraction {
    fn default() -> Self {
        Self::new()
    }
}

impl Forget for Distraction {
    /// Runs every form but those of the kernel that is about to be called: they would remind the
    /// processor of it.
    fn forget(&mut self, id: &str) {
        black_box(self.memory.iter().step_by(LINE).sum::<u64>());
        let kernel = id.split('/').next().unwrap_or(id);
        for (_, job) in self.jobs.iter_mut().filter(|(of, _)| *of != kernel) {
            black_box(job.run(Block::whole(job.as_ref())));
        }
    }
}
