//! The triangles of a leaf, for a group test.

use crate::batch::{Aosoa, Layout};
use crate::kernels::Kernel;
use crate::structure::leaf::corners;
use crate::workload::Triangle;

use super::tree::{NOBODY, Wide};

/// Records of all groups, number by number within a group; NaN, which nothing hits, where a group is not
/// full.
pub fn records<K: Kernel, const W: usize>(tree: &Wide<W>, triangles: &[Triangle]) -> Vec<f32> {
    let places = size_of::<K::Record<f32>>() / size_of::<f32>();
    let count = tree.groups.len() * W;
    let mut numbers = vec![f32::NAN; count * places];
    for (position, index) in tree.groups.iter().flatten().enumerate() {
        if *index == NOBODY {
            continue;
        }
        let record = K::prepare(&corners(&triangles[*index as usize]));
        for (place, number) in record.as_ref().iter().enumerate() {
            numbers[Aosoa::<W>::position(position, place, places, count)] = *number;
        }
    }
    numbers
}
