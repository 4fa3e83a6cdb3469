//! What triangles are searched with.

use crate::job::Job;
use crate::registry::{LeafForm, WideForm, leaves, wide_forms};
use crate::rows::of_axes;
use crate::structure::{Counts, KINDS, Kind, SearchJob, Structure, StructureJob};
use crate::table::Row;
use crate::workload::{Ray, Triangle};
use std::rc::Rc;

/// Names of the hierarchies of other crates, in every build, so that a config can be read by every build.
const PEERS: [&str; 4] = ["peer-obvhs-bvh2", "peer-obvhs-cwbvh", "peer-bvh", "peer-parry"];

/// The name of the fast path.
const WIDE: &str = "wide";

/// Structures that look at all of their volumes or triangles for every ray.
const LINEAR: [&str; 7] =
    ["list", "sphere", "box", "slabs", "sphere-and-box", "sorted-spheres", "sorted-boxes"];

/// What searches that are alike in speed are measured with each other: a group, in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// Time grows with the number of triangles.
    Linear,
    /// Structures with any kernel at their leaves, searched in f64.
    General,
    /// Groups of triangles to a test, and what other crates do.
    Fast,
}

impl Class {
    /// All of them.
    pub const ALL: [Class; 3] = [Class::Linear, Class::General, Class::Fast];
}

/// A structure with a kernel at its leaves.
pub enum Subject {
    /// One of [`KINDS`].
    General(&'static Kind, LeafForm),
    /// The fast path.
    Wide(WideForm),
    /// Another crate's, by its name.
    Peer(&'static str),
}

/// What is built once for all rays.
pub enum Built {
    /// One of [`KINDS`].
    General(Rc<dyn Structure>),
    /// What is built together with its job.
    WithItsJob,
}

/// A search that is ready to be timed.
pub struct Ready {
    /// The search.
    pub job: Box<dyn Job>,
    /// Bytes of the structure and of what is stored of its triangles, where they are known.
    pub bytes: Option<[usize; 2]>,
    /// What a pass over all rays does, where that is counted.
    pub counts: Option<Counts>,
}

impl Ready {
    fn counted(mut job: StructureJob) -> Self {
        let (bytes, counts) = (Some(job.bytes()), Some(job.counts()));
        Ready { job: Box::new(job), bytes, counts }
    }

    /// Writes bytes and counts into a row.
    pub fn put(&self, row: &mut Row) {
        if let Some([structure, records]) = self.bytes {
            row.structure_bytes = Some(structure as u64);
            row.set_bytes = Some(records as u64);
        }
        let Some(counts) = self.counts else { return };
        let per_ray = |count: u64| Some(count as f64 / counts.rays.max(1) as f64);
        row.tests = Some(counts.triangles);
        row.tests_per_ray = counts.triangles_per_ray();
        row.nodes_per_ray = per_ray(counts.nodes);
        row.cells_per_ray = per_ray(counts.cells);
        row.volumes_per_ray = per_ray(counts.volumes);
        row.passed_share = counts.share_passed();
    }
}

/// The subjects of a name with these kernels.
///
/// # Errors
/// A name that is none, and what is allowed.
pub fn named(name: &str, kernels: &[String]) -> Result<Vec<Subject>, String> {
    if let Some(kind) = crate::structure::kind(name) {
        let of = |leaf| Subject::General(kind, leaf);
        return Ok(leaves_of(kernels)?.into_iter().map(of).collect());
    }
    if name == WIDE {
        let forms = wide_forms().into_iter();
        let wanted = |form: &WideForm| kernels.iter().any(|kernel| kernel == form.about.id);
        return Ok(forms.filter(wanted).map(Subject::Wide).collect());
    }
    if let Some(peer) = PEERS.iter().find(|peer| **peer == name) {
        return Ok(vec![Subject::Peer(peer)]);
    }
    let known: Vec<&str> = KINDS.iter().map(|kind| kind.id).chain([WIDE]).chain(PEERS).collect();
    Err(format!("workload.structures: '{name}' is not allowed; allowed: {}", known.join(", ")))
}

/// The leaves of kernels by their ids; of one with several stored forms the first.
///
/// # Errors
/// An id that is none of a kernel that answers about rays, and what is allowed.
pub fn leaves_of(kernels: &[String]) -> Result<Vec<LeafForm>, String> {
    let of = |kernel: &String| {
        let found = leaves().into_iter().find(|leaf| leaf.about.id == kernel && !leaf.is_segment);
        found.ok_or_else(|| {
            let all = leaves().into_iter().filter(|leaf| !leaf.is_segment);
            let mut ids: Vec<&str> = all.map(|leaf| leaf.about.id).collect();
            ids.dedup();
            format!("workload.kernels: '{kernel}' is not allowed; allowed: {}", ids.join(", "))
        })
    };
    kernels.iter().map(of).collect()
}

impl Subject {
    /// What it is measured with.
    pub fn class(&self) -> Class {
        match self {
            Subject::General(kind, _) if LINEAR.contains(&kind.id) => Class::Linear,
            Subject::General(..) => Class::General,
            Subject::Wide(_) | Subject::Peer(_) => Class::Fast,
        }
    }

    /// The column `structure`.
    pub fn name(&self) -> &'static str {
        match self {
            Subject::General(kind, _) => kind.id,
            Subject::Wide(_) => WIDE,
            Subject::Peer(peer) => peer,
        }
    }

    /// Why it cannot run on this machine or in this build.
    pub fn lacks(&self) -> Option<String> {
        match self {
            Subject::Wide(form) if !(form.available)() => Some(format!("no {}", form.axes.level)),
            Subject::Peer(_) if !cfg!(feature = "peers") => {
                Some("this build lacks the feature 'peers'".to_owned())
            }
            _ => None,
        }
    }

    /// Whether a wrong answer of its that rounding does not explain is a fault of ours.
    pub fn claims_exactness(&self) -> bool {
        let axes = match self {
            Subject::General(_, leaf) => &leaf.axes,
            Subject::Wide(form) => &form.axes,
            Subject::Peer(_) => return false,
        };
        let mut forms = crate::registry::variants().iter();
        forms.any(|form| form.axes.kernel == axes.kernel && form.claims_exactness())
    }

    /// The columns that say what it is.
    pub fn row(&self) -> Row {
        let row = match self {
            Subject::General(_, leaf) => of_axes(&leaf.axes),
            Subject::Wide(form) => of_axes(&form.axes),
            Subject::Peer(peer) => Row {
                kernel: (*peer).into(),
                precision: "f32".into(),
                build: crate::measure::BuildInfo::of_this_program().label(),
                ..Row::default()
            },
        };
        let id = match self {
            Subject::Peer(peer) => (*peer).to_owned(),
            _ => format!("{}/{}", self.name(), row.id),
        };
        Row { id, structure: self.name().into(), ..row }
    }

    /// Builds what rays of every kind share.
    pub fn build(&self, triangles: &[Triangle]) -> Built {
        match self {
            Subject::General(kind, _) => Built::General((kind.build)(triangles).into()),
            Subject::Wide(_) | Subject::Peer(_) => Built::WithItsJob,
        }
    }

    /// Builds it and prepares the triangles, to be thrown away: what is timed of building.
    pub fn rebuild(&self, triangles: &[Triangle]) {
        match self {
            Subject::General(kind, leaf) => {
                std::hint::black_box((kind.build)(triangles).bytes());
                std::hint::black_box((leaf.prepare)(triangles).bytes());
            }
            _ => {
                std::hint::black_box(self.bind(&Built::WithItsJob, triangles, &[]).job.items());
            }
        }
    }

    /// The search for the nearest hits of rays.
    pub fn bind(&self, built: &Built, triangles: &[Triangle], rays: &[Ray]) -> Ready {
        match (self, built) {
            (Subject::General(_, leaf), Built::General(structure)) => {
                let leaf = (leaf.prepare)(triangles);
                Ready::counted(StructureJob::new(Rc::clone(structure), leaf, rays, false))
            }
            (Subject::General(kind, leaf), Built::WithItsJob) => {
                let (built, leaf) = ((kind.build)(triangles), (leaf.prepare)(triangles));
                Ready::counted(StructureJob::new(built, leaf, rays, false))
            }
            (Subject::Wide(form), _) => {
                let job = (form.bind)(triangles, rays, false);
                Ready { bytes: Some(job.bytes()), job, counts: None }
            }
            (Subject::Peer(peer), _) => {
                Ready { job: peers_job(peer, triangles, rays), bytes: None, counts: None }
            }
        }
    }
}

#[cfg(feature = "peers")]
fn peers_job(peer: &str, triangles: &[Triangle], rays: &[Ray]) -> Box<dyn Job> {
    let tree = crate::peers::trees::TREES.iter().find(|tree| tree.id == peer);
    (tree.unwrap_or_else(|| unreachable!("{peer} is no tree of another crate")).bind)(
        triangles, rays,
    )
}

#[cfg(not(feature = "peers"))]
fn peers_job(peer: &str, _: &[Triangle], _: &[Ray]) -> Box<dyn Job> {
    unreachable!("{peer} is left out of builds without the feature")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_structure_is_a_subject_and_the_lists_are_linear() {
        let kernels = ["moller-trumbore".to_owned()];
        for kind in KINDS {
            let subjects = named(kind.id, &kernels).expect("a name of the list");
            let [subject] = subjects.as_slice() else { panic!("{}", kind.id) };
            let linear = LINEAR.contains(&kind.id);
            assert_eq!(subject.class() == Class::Linear, linear, "{}", kind.id);
        }
        assert!(LINEAR.iter().all(|id| crate::structure::kind(id).is_some()));
        #[cfg(feature = "peers")]
        assert_eq!(crate::peers::trees::TREES.map(|tree| tree.id), PEERS);
    }
}
