//! A laboratory for ray-triangle intersection: every kernel written once, checked against the exact
//! answer, measured side by side, and drawn.
//!
//! ```text
//!  number ─> policy ─> kernels ─> batch, level ─> registry ─┐
//!                                                          ├─> experiment ─> table ─> chart ─> cli
//!  workload ─> oracle ─> accuracy ──────────────────────────┤      rows        the      SVG      │
//!  stats ────> measure <─ job ──────────────────────────────┘                 waist ─> compare ──┘
//! ```
//! Data flows one way. Left of the waist nothing can draw; right of it nothing can run a kernel.
//! [`check`] judges anyone's cases, [`stability`] sweeps stiff ones, without a clock; [`own`] takes a
//! kernel that you have written, judges it and measures it beside ours; [`scene`] reads
//! meshes, draws rays for them, and says what both are like; [`render`] makes pictures of them;
//! [`doctor`] measures a kernel against copies of itself, to tell what the machine is good for.
//! From stored rows alone, [`results`] puts runs together, [`claims`] judges published statements,
//! [`report`] writes what a reader opens, and [`recommend`] tells which variant to take.
//! The module `structure` arranges many triangles for rays, with any kernel at its leaves: bounding
//! volumes, subdivisions of space, hierarchies, and the fast path of groups.
//! The modules below stand in reading order.
//!
//! A kernel is a function of a [number](number::Real) and a [policy](policy::Policy). The same
//! source gives a scalar test, here Moeller and Trumbore's on one ray and one triangle:
//!
//! ```
//! use ray_test::kernels::{Corners, Kernel, MollerTrumbore};
//! use ray_test::number::Vec3;
//! use ray_test::policy::{Compare, Early, Form, Inside, Last, Plain, Ray, Tuv, TwoSided};
//!
//! type Test = MollerTrumbore;
//! type Usual = Form<Early, Last, Plain, Tuv, TwoSided, Compare, Inside>;
//! let triangle = Corners {
//!     a: Vec3([0.0f32, 0.0, 2.0]),
//!     b: Vec3([4.0, 0.0, 2.0]),
//!     c: Vec3([0.0, 4.0, 2.0]),
//! };
//! let ray = Ray {
//!     origin: Vec3([1.0, 2.0, 0.0]),
//!     direction: Vec3([0.0, 0.0, 1.0]),
//!     end: Vec3([1.0, 2.0, 9.0]),
//!     t_min: 0.0,
//!     t_max: f32::MAX,
//! };
//! let met = Test::meet::<Usual, f32>((), &Test::prepare(&triangle));
//! let aim = Test::aim::<Usual, f32>(&ray);
//! let found = Test::test::<Usual, f32>(&ray, &aim, &met).expect("through the middle");
//! assert!(found.hit);
//! assert_eq!((found.t, found.u, found.v), (2.0, 0.25, 0.5));
//! ```
//!
//! and the operations that it executes:
//!
//! ```
//! use ray_test::counting::counters;
//!
//! let kernels: Vec<_> = counters().iter().map(|counter| counter.kernel).collect();
//! assert!(kernels.contains(&"wald") && kernels.contains(&"moller1"));
//! ```
//!
//! What the right answer is, [`oracle`] says exactly, for every finite input:
//!
//! ```
//! use glam::Vec3;
//! use ray_test::oracle::{Class, Query, solve};
//! use ray_test::workload::{Ray, Triangle};
//!
//! let triangle = Triangle { a: Vec3::ZERO, b: Vec3::X, c: Vec3::Y };
//! let origin = Vec3::new(0.5, 0.5, 1.0);
//! let ray = Ray { origin, direction: -Vec3::Z, end: origin, t_min: 0.0, t_max: f32::MAX };
//! let exact = solve(&Query::of(&ray, &triangle));
//! assert_eq!((exact.class, exact.t, exact.u, exact.v), (Class::Edge, 1.0, 0.5, 0.5));
//! ```
//!
//! A kernel of your own is held to it, and measured beside ours, with [`own`]; it is a function over
//! plain numbers. `examples/own_kernel.rs` times one as well. Here one that always hits:
//!
//! ```
//! use ray_test::own::{Entrant, Hit, OwnKernel, Ray, Triangle, examine};
//!
//! struct Always;
//!
//! impl OwnKernel for Always {
//!     const NAME: &'static str = "always";
//!     type Number = f32;
//!     type Record = ();
//!     fn prepare(_: &Triangle<f32>) {}
//!     fn test(_: &Ray<f32>, _: &()) -> Option<Hit<f32>> {
//!         Some(Hit { t: 1.0, u: 0.25, v: 0.5 })
//!     }
//! }
//!
//! let found = &examine(&[Entrant::own::<Always>()], 10, 1)?[0];
//! // Half of the 100 random pairs miss.
//! assert_eq!(found.pairs.accuracy.false_hits, 50);
//! assert!(found.pairs.wrong.is_some());
//! assert!(found.families.iter().all(|family| family.hits == family.cases));
//! # Ok::<(), ray_test::workload::WorkloadError>(())
//! ```
#![forbid(unsafe_code)]
// Both end the program where nobody hears; the command line has ways of its own.
#![cfg_attr(not(test), deny(clippy::print_stderr, clippy::print_stdout))]

pub mod number;

pub mod policy;

pub mod kernels;

pub mod level;

#[cfg(feature = "peers")]
pub mod peers;

pub mod batch;

pub mod job;

pub mod bound;

#[cfg(feature = "cli")]
pub mod structure;

pub mod registry;

pub mod counting;

pub mod workload;

pub mod oracle;

pub mod accuracy;

pub mod check;

pub mod stats;

pub mod measure;

pub mod spread;

pub mod stability;

pub mod own;

#[cfg(feature = "cli")]
pub mod shard;

#[cfg(feature = "cli")]
pub mod table;

#[cfg(feature = "cli")]
pub mod rows;

#[cfg(feature = "cli")]
pub mod chart;

#[cfg(feature = "cli")]
pub mod results;

#[cfg(feature = "cli")]
pub mod claims;

#[cfg(feature = "cli")]
pub mod recommend;

#[cfg(feature = "cli")]
pub mod report;

#[cfg(feature = "cli")]
pub mod compare;

#[cfg(feature = "cli")]
pub mod scene;

#[cfg(feature = "cli")]
pub mod render;

#[cfg(feature = "cli")]
pub mod experiment;

#[cfg(feature = "cli")]
pub mod plan;

#[cfg(feature = "cli")]
pub mod doctor;

#[cfg(feature = "cli")]
pub mod cli;
