//! A kernel that is asked about one triangle at a time, as a leaf of structures.

use super::exact::query;
use crate::oracle::Query;
use crate::structure::{Best, Hit, Leaf};
use crate::workload::{Ray, Triangle};

/// What is asked: t, u and v of a hit, t in units of the query's direction; `None` for a miss.
pub type Ask = Box<dyn Fn(&Query) -> Option<[f64; 3]>>;

/// Triangles that a kernel prepares anew for every ray: for its answers, not for its time.
pub struct AskingLeaf {
    ask: Ask,
    triangles: Vec<Triangle>,
    is_segment: bool,
    ray: Option<Ray>,
}

impl AskingLeaf {
    /// For answers about segments from origin to end, or about rays.
    pub fn new(ask: Ask, triangles: &[Triangle], is_segment: bool) -> Self {
        AskingLeaf { ask, triangles: triangles.to_vec(), is_segment, ray: None }
    }
}

impl Leaf for AskingLeaf {
    fn is_segment(&self) -> bool {
        self.is_segment
    }

    fn triangles(&self) -> usize {
        self.triangles.len()
    }

    fn bytes(&self) -> usize {
        size_of_val(self.triangles.as_slice())
    }

    fn aim(&mut self, ray: &Ray) {
        self.ray = Some(*ray);
    }

    /// Published listings do not look at the range of t, so it is looked at here.
    fn test(&mut self, indices: &[u32], best: &mut Best) {
        let Some(ray) = self.ray else { return };
        for &triangle in indices {
            let query = query(&ray, &self.triangles[triangle as usize], self.is_segment);
            let found = (self.ask)(&query);
            if let Some([t, u, v]) = found.filter(|[t, ..]| query.t_min <= *t && *t <= query.t_max)
            {
                let [t, u, v] = [t, u, v].map(|x| x as f32);
                best.offer(Hit { triangle, t, u, v });
            }
        }
    }
}
