//! `ray_test scene`: what a mesh and its rays need of a test, and what can be left out.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

use clap::Args;
use serde_json::json;

use super::arguments::{Format, ProfileWord};
use super::failure::Failure;
use super::folder::Folder;
use super::instruments::Instruments;
use super::show::{Sheet, csv};
use super::{interrupt, lock, progress, scene_text};
use crate::check::read::ReadError;
use crate::experiment::KeepNothing;
use crate::measure::{Environment, Pin};
use crate::plan::{Asking, Outcome, Output, Report, Task, Use, Wanted};
use crate::scene::mesh::Mesh;
use crate::scene::open;
use crate::scene::rays::Asked;
use crate::table::{RunFile, SCHEMA_VERSION, make_folder, write_atomically, write_csv, write_json};
use crate::workload::Triangle;
use crate::workload::hash::Fnv;

/// What is said below the options.
pub const HELP: &str = "Examples:
  ray_test scene icosphere:4
  ray_test scene model.obj --use shadow --format json
  ray_test scene terrain --rays my-rays.csv --needs t --out results/terrain

MODEL is a file (OBJ, PLY, STL) or a built-in scene: cornell-box, icosphere, needle-sphere, terrain,
soup, room-far, with a size behind a colon if wanted. A file of rays is CSV with the header
ox,oy,oz,dx,dy,dz[,tmin,tmax].";

/// `ray_test scene`
#[derive(Args, Debug)]
pub struct Scene {
    /// File, or built-in scene
    pub model: String,
    /// What a hit has to tell [default: what the use needs]
    #[arg(long, value_enum)]
    pub needs: Option<NeedsWord>,
    /// What the rays are for; says which rays and what they need, unless that is said
    #[arg(long = "use", value_enum)]
    pub usage: Option<UseWord>,
    /// Rays: primary, shadow, ambient, random, or a file [default: those of the use]
    #[arg(long)]
    pub rays: Option<String>,
    /// How much is measured: 64, 256 or 1024 rounds
    #[arg(long, value_enum, default_value_t = ProfileWord::Quick)]
    pub profile: ProfileWord,
    /// Where the random generators start
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Folder for the results [default: results/<UTC time>-<config hash>]
    #[arg(long)]
    pub out: Option<PathBuf>,
    /// Processor to measure on: `auto` (between groups, the quietest), `off` (any), or its number
    #[arg(long, default_value_t = Pin::Auto)]
    pub pin: Pin,
    /// How the plan is printed
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// What a hit has to tell.
#[derive(clap::ValueEnum, Clone, Copy, Debug)]
pub enum NeedsWord {
    /// Whether there is one
    Hit,
    /// And its distance
    T,
    /// And its place in the triangle
    Tuv,
    /// And point and normal
    Surface,
}

/// What rays are for.
#[derive(clap::ValueEnum, Clone, Copy, Debug)]
pub enum UseWord {
    /// Pictures: nearest hits of a camera's rays
    Raytracing,
    /// Whether anything is before a light
    Shadow,
    /// Where small and fast things hit: few short segments
    Collision,
    /// Whether one point sees another: few segments
    Visibility,
    /// Whether patches see each other: all pairs
    Radiosity,
}

/// Refuses what is wrong, then looks, measures, writes and prints.
pub fn run(arguments: &Scene) -> Result<(), Failure> {
    let wanted = wanted(arguments);
    let mesh = open(&arguments.model).map_err(refused)?;
    let triangles: Vec<Triangle> = mesh.list();
    let task =
        Task::new(&mesh, &triangles, wanted, Asking::new(arguments.seed)).map_err(refused)?;
    let _lock = lock::take()?;
    let (mut instruments, environment) = Instruments::set_up(arguments.pin)?;
    let hash = hash(arguments, &environment);
    let folder = Folder::new(arguments.out.as_deref(), hash, environment.clone(), String::new());
    folder.create()?;
    let path = folder.path().join(EXPERIMENT);
    let rounds = arguments.profile.value().rounds();
    say!("{}; results in {}", about(&mesh, &task, rounds), path.display());
    let cancel = interrupt::flag();
    let bar = progress::bar(task.blocks(rounds));
    let mut done = |blocks: usize| bar.inc(blocks as u64);
    let keep = &mut KeepNothing;
    let outcome = task
        .run(&mut instruments.bench(rounds, &mut done, cancel, keep))
        .map_err(|trouble| Failure::Runtime(trouble.into()))?;
    bar.finish_and_clear();
    let saved = save(&path, environment, &outcome, arguments.seed);
    if let Some(found) = &outcome.found {
        // Shown even where it cannot be saved: to find it out took its time.
        let printed = print(&found.report, arguments.format, || scene_text::text(found));
        return saved.and(printed);
    }
    saved?;
    Err(without_plan(cancel.load(Ordering::Relaxed), &mesh, &path))
}

/// Why there is no plan.
fn without_plan(is_interrupted: bool, mesh: &Mesh, path: &Path) -> Failure {
    if is_interrupted {
        say!("what was measured is saved in {}", path.display());
        return Failure::Interrupted;
    }
    Failure::Runtime(anyhow::anyhow!(
        "{}: the default variant could not be timed on a sample of it; {} says why",
        mesh.name,
        path.join("rows.csv").display()
    ))
}

/// The folder and the experiment of the rows.
const EXPERIMENT: &str = "scene";

fn refused(error: ReadError) -> Failure {
    Failure::Usage(error.to_string())
}

/// What the plan is made for.
pub fn wanted(arguments: &Scene) -> Wanted {
    let output = arguments.needs.map(|word| match word {
        NeedsWord::Hit => Output::Hit,
        NeedsWord::T => Output::T,
        NeedsWord::Tuv => Output::Tuv,
        NeedsWord::Surface => Output::Surface,
    });
    let usage = arguments.usage.map(|word| match word {
        UseWord::Raytracing => Use::Raytracing,
        UseWord::Shadow => Use::Shadow,
        UseWord::Collision => Use::Collision,
        UseWord::Visibility => Use::Visibility,
        UseWord::Radiosity => Use::Radiosity,
    });
    Wanted::of(output, usage, arguments.rays.as_deref().map(Asked::of))
}

/// What is begun, and how long it takes.
fn about(mesh: &Mesh, task: &Task<'_>, rounds: usize) -> String {
    let (triangles, rays) = (mesh.triangles.len(), task.rays());
    let seconds = (BLOCK_SECONDS * task.blocks(rounds) as f64).ceil();
    format!(
        "{}: {triangles} triangles, {rays} rays; about {seconds:.0} s, beside other work some times as long",
        mesh.name
    )
}

/// A block with its new order, and the readings of the ruler before and after it.
const BLOCK_SECONDS: f64 = 150e-6;

fn hash(arguments: &Scene, environment: &Environment) -> u64 {
    let mut hash = Fnv::default();
    let Scene { model, needs, usage, rays, profile, seed, .. } = arguments;
    hash.bytes(format!("{model} {needs:?} {usage:?} {rays:?} {profile:?} {seed}").as_bytes());
    hash.bytes(format!("{:?}", environment.build).as_bytes());
    hash.bytes(environment.testbed_id.as_bytes());
    hash.finish()
}

fn save(
    path: &Path,
    environment: Environment,
    outcome: &Outcome,
    seed: u64,
) -> Result<(), Failure> {
    make_folder(path)?;
    write_csv(&path.join("rows.csv"), &outcome.rows)?;
    if let Some(found) = &outcome.found {
        write_atomically(&path.join("plan.json"), json_of(&found.report)?.as_bytes())?;
    }
    let runtime = |error: serde_json::Error| Failure::Runtime(error.into());
    let mut environment = serde_json::to_value(environment).map_err(runtime)?;
    environment["complete"] = json!(outcome.found.is_some());
    let mut hash = Fnv::default();
    outcome.rows.iter().for_each(|row| hash.bytes(row.workload_hash.as_bytes()));
    let run = RunFile {
        schema_version: SCHEMA_VERSION.to_owned(),
        environment,
        seed,
        workload_hash: format!("{:016x}", hash.finish()),
        rows: outcome.rows.clone(),
    };
    // Last: it says that everything is there.
    Ok(write_json(&path.join("rows.json"), &run)?)
}

fn json_of(report: &Report) -> Result<String, Failure> {
    let text = serde_json::to_string_pretty(report);
    text.map(|text| text + "\n").map_err(|error| Failure::Runtime(error.into()))
}

fn print(report: &Report, format: Format, text: impl Fn() -> String) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    match format {
        Format::Text => out.write_all(text().as_bytes())?,
        Format::Json => out.write_all(json_of(report)?.as_bytes())?,
        Format::Csv => csv(&sheet(report), &mut out)?,
    }
    Ok(())
}

/// A row a piece.
fn sheet(report: &Report) -> Sheet {
    let plan = &report.plan;
    let row = |piece: &str, left_out: bool, because: &str, saves: Option<f64>| {
        let verdict = if left_out { "left-out" } else { "kept" };
        let Report { mesh, rays, needs, .. } = report;
        vec![
            json!(mesh),
            json!(rays),
            json!(needs),
            json!(plan.variant),
            json!(piece),
            json!(verdict),
            json!(saves),
            json!(because),
        ]
    };
    let gone = plan.left_out.iter();
    let gone = gone.map(|one| row(one.piece, true, &one.because, Some(one.saves_percent)));
    let kept = plan.kept.iter().map(|one| row(one.piece, false, &one.because, None));
    Sheet {
        columns: vec![
            "mesh",
            "rays",
            "needs",
            "variant",
            "piece",
            "verdict",
            "saves_percent",
            "because",
        ],
        rows: gone.chain(kept).collect(),
    }
}
