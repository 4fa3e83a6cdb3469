//! A volume and rays behind a [`Job`]: what B of `B + p I < I` costs.

use std::hint::black_box;

use super::Beam;
use super::bounded::Bounded;
use super::volume::{Both, Bounds, Slabs, Sphere, Volume};
use crate::job::{Answer, Block, Job, Tally};
use crate::workload::{Ray, Triangle};

/// A volume that can be timed alone.
#[derive(Clone, Copy, Debug)]
pub struct VolumeForm {
    /// The id of the [`super::Kind`] that has it around a list.
    pub id: &'static str,
    /// Makes a job of tests of rays against the volume around the triangles.
    pub bind: fn(&[Triangle], &[Ray]) -> Box<dyn Job>,
}

/// All of them.
pub const VOLUMES: [VolumeForm; 4] = [
    VolumeForm { id: "sphere", bind: bind::<Sphere> },
    VolumeForm { id: "box", bind: bind::<Bounds> },
    VolumeForm { id: "slabs", bind: bind::<Slabs> },
    VolumeForm { id: "sphere-and-box", bind: bind::<Both<Sphere, Bounds>> },
];

fn bind<V: Volume>(triangles: &[Triangle], rays: &[Ray]) -> Box<dyn Job> {
    let volume = Bounded::new(triangles).volume().copied();
    let beams: Vec<Option<Beam>> = rays.iter().map(Beam::of_ray).collect();
    Box::new(VolumeJob::<V> { volume, original: beams.clone(), beams })
}

/// Rays, prepared, against one volume. Its tallies count those that meet it.
struct VolumeJob<V> {
    volume: Option<V>,
    original: Vec<Option<Beam>>,
    beams: Vec<Option<Beam>>,
}

impl<V: Volume> VolumeJob<V> {
    #[inline(always)]
    fn near(&self, beam: &Option<Beam>) -> Option<f64> {
        let (volume, beam) = (self.volume.as_ref()?, beam.as_ref()?);
        volume.hit(beam, &V::aim(beam), beam.t_max)
    }
}

impl<V: Volume> Job for VolumeJob<V> {
    fn items(&self) -> usize {
        self.beams.len()
    }

    fn tests_per_item(&self) -> u64 {
        1
    }

    fn run(&mut self, block: Block) -> Tally {
        let mut tally = Tally::default();
        let (passes, in_a_row) =
            if block.literal { (1, block.repeats) } else { (block.repeats, 1) };
        for _ in 0..passes {
            for beam in &self.beams[block.first..][..block.items] {
                for _ in 0..in_a_row {
                    // Rays are tested one by one, as in a structure.
                    black_box(());
                    if let Some(near) = self.near(beam) {
                        tally.hits += 1;
                        tally.bits[0] = tally.bits[0].wrapping_add(near.to_bits());
                    }
                }
            }
        }
        tally
    }

    fn permute(&mut self, permutation: &[u32]) {
        for (place, from) in self.beams.iter_mut().zip(permutation) {
            *place = self.original[*from as usize];
        }
    }

    fn answers(&mut self) -> Vec<Answer> {
        let answer = |beam: &Option<Beam>| {
            self.near(beam).map_or_else(Answer::default, |t| Answer {
                triangle: Some(0),
                t,
                ..Answer::default()
            })
        };
        self.original.iter().map(answer).collect()
    }
}
