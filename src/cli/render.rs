//! `ray_test render`: a picture of a scene with any kernel, its time, and where it differs from the
//! exact one.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;

use super::arguments::Format;
use super::failure::Failure;
use super::render_frames::{Contender, Shown, Studio};
use super::render_kernels::{Chosen, chosen};
use super::render_rows::{Common, lines, sheet, verdict};
use super::show::{aligned, print};
use super::words::words;
use super::{interrupt, lock, render_files};
use crate::registry::REFERENCE;
use crate::render::{Following, Interpolation, Manner, Stage, Subsampling};
use crate::report::count;
use crate::scene;
use crate::structure::{KINDS, Kind, Structure, kind};

/// What is said below the options.
pub const HELP: &str = "\
Examples:
  ray_test render cornell-box -o box.png
  ray_test render bunny.ply --size 400x300 --kernel wald --compare
  ray_test render icosphere:6 --kernel moller1,badouel,chirkov-line --frames 20 --format csv
  ray_test render terrain --grid 8x8 --tolerance 0.1

MODEL is a file (OBJ, PLY or STL), or a built-in scene: cornell-box, icosphere, needle-sphere, terrain,
soup or room-far, with a size behind a colon if wanted.

A kernel stands for its single, early form in f32 with output tuv; several take turns, frame by frame,
and the picture is that of the first. Pictures depend on which triangles rays hit and on nothing else.
seconds_per_frame is the median, seconds_low and seconds_high are its 95 % interval from six frames on.
intersection_percent is what is saved by making the picture again from recorded hits.

--compare holds every answer against the exact one about the same ray, and paints where they differ:
cracks (vermilion; the nearest triangle is not hit, and what is behind is seen), false hits (blue),
wrong triangles (green), wrong distances (orange), outlines (sky blue; missed within rounding of where
the surface ends), wrong shadows (purple). The exit code is 4 if a kernel that claims right answers gave
one that rounding does not explain.";

/// `ray_test render`
#[derive(Args, Debug)]
pub struct Render {
    /// File, or built-in scene
    pub model: String,
    /// Kernel, or variant by its full id; several are separated by commas
    #[arg(long, value_name = "ID", value_delimiter = ',', default_values_t = [REFERENCE.to_owned()])]
    pub kernel: Vec<String>,
    /// Columns and rows of the picture
    #[arg(long, value_name = "WxH", default_value = "640x480", value_parser = size)]
    pub size: [u32; 2],
    /// The picture; differences go beside it, with -compare in the name
    #[arg(short, long, value_name = "FILE.png", default_value = "out.png")]
    pub out: PathBuf,
    /// How often the picture is made
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub frames: u32,
    /// What is built around the triangles (`list` tests all)
    #[arg(long, default_value = "surface")]
    pub structure: String,
    /// Mirrors in a row that a ray is followed into
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u32).range(0..=64))]
    pub depth: u32,
    /// Primary rays only: no shadows, no mirrors
    #[arg(long)]
    pub cast_only: bool,
    /// Adaptive subsampling: rays so many columns and rows apart, and between them where they differ
    #[arg(long, value_name = "XxY", default_value = "1x1", value_parser = size)]
    pub grid: [u32; 2],
    /// Colours of a cell's corners, from 0 to 1, that differ by less than this need no more rays
    #[arg(long, default_value_t = 0.05, value_parser = tolerance)]
    pub tolerance: f64,
    /// What is shown where no ray was cast
    #[arg(long, value_enum, default_value_t = InterpolationWord::Bilinear)]
    pub interpolate: InterpolationWord,
    /// Paint where the kernel's answers differ from the exact ones
    #[arg(long)]
    pub compare: bool,
    /// How figures are printed
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

words! {
    /// What is shown where no ray was cast.
    InterpolationWord for Interpolation {
        Bilinear => Interpolation::Bilinear,
        Nearest => Interpolation::Nearest,
    }
}

/// Largest side of a picture.
const LARGEST: u32 = 16_384;

fn size(text: &str) -> Result<[u32; 2], String> {
    let side = |text: &str| text.parse().ok().filter(|side| (1..=LARGEST).contains(side));
    let sides = text.split_once('x').and_then(|(x, y)| Some([side(x)?, side(y)?]));
    sides.ok_or_else(|| format!("allowed: two numbers from 1 to {LARGEST}, as in 400x300"))
}

fn tolerance(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number: &f64| (0.0..=1.0).contains(number));
    number.ok_or_else(|| "allowed: a number from 0 to 1".to_owned())
}

/// Checks everything, makes the pictures, writes and prints.
///
/// # Errors
/// Usage for an unknown scene, kernel or structure, and for a file that cannot be written; interrupted,
/// after what was made is saved; a wrong picture of a kernel that claims right ones.
pub fn run(arguments: &Render) -> Result<(), Failure> {
    let chosen = chosen(&arguments.kernel)?;
    let structure = known(&arguments.structure)?;
    let files = render_files::check(arguments, &chosen)?;
    let mesh = scene::open(&arguments.model)?;
    // Its seconds are compared between kernels.
    let _lock = lock::take()?;
    let stage = Stage::new(&mesh, arguments.size);
    let start = Instant::now();
    let structure = (structure.build)(&stage.triangles);
    let building = start.elapsed().as_secs_f64();
    let made = make(arguments, chosen, &stage, structure.as_ref());
    let (contenders, ended) = made?;
    let shown: Vec<&Shown> = contenders.iter().map(|one| &one.shown).collect();
    files.write(&shown)?;
    let common = Common { arguments, stage: &stage, building, bytes: structure.bytes() };
    let sheet = sheet(&common, &shown);
    match arguments.format {
        Format::Text => writeln!(std::io::stdout(), "{}", aligned(&lines(&sheet)))?,
        format => print(&sheet, format)?,
    }
    ended?;
    verdict(&shown, arguments.size[0])
}

/// What is built around the triangles.
///
/// # Errors
/// Usage for a word that stands for nothing.
pub fn known(word: &str) -> Result<&'static Kind, Failure> {
    kind(word).ok_or_else(|| {
        let all: Vec<&str> = KINDS.iter().map(|kind| kind.id).collect();
        let all = all.join(", ");
        Failure::Usage(format!("--structure: '{word}' is not allowed; allowed: {all}"))
    })
}

fn manner(arguments: &Render) -> Manner {
    Manner {
        following: Following { depth: arguments.depth, casts_only: arguments.cast_only },
        subsampling: Subsampling {
            grid: arguments.grid,
            tolerance: arguments.tolerance,
            interpolation: arguments.interpolate.value(),
        },
    }
}

/// The kernels with what they showed, and whether all of it was done.
type Made<'a> = (Vec<Contender<'a>>, Result<(), Failure>);

/// Makes all pictures.
///
/// # Errors
/// Interrupted before there is a picture of every kernel.
fn make<'a>(
    arguments: &Render,
    chosen: Vec<Chosen>,
    stage: &'a Stage,
    structure: &'a dyn Structure,
) -> Result<Made<'a>, Failure> {
    let (cancel, manner) = (interrupt::flag(), manner(arguments));
    let frames = arguments.frames as usize;
    let each = 2 * frames + 1 + usize::from(arguments.compare);
    let mut studio = Studio::new((stage, structure), manner, cancel, each * chosen.len());
    let mut all: Vec<Contender<'a>> =
        chosen.into_iter().map(|chosen| studio.contender(chosen)).collect();
    announce(arguments, stage, structure, &mut all)?;
    let mut work = || {
        studio.frames(&mut all, frames)?;
        for one in &mut all {
            studio.without_tests(one, frames)?;
            if arguments.compare {
                studio.compare(one)?;
            }
        }
        Ok(())
    };
    let ended = work();
    studio.bar.finish_and_clear();
    match ended {
        Err(failure) if all.iter().any(|one| one.shown.frame.is_none()) => Err(failure),
        ended => Ok((all, ended)),
    }
}

/// Says on stderr what is about to be done and how long it takes, by a picture of a 16th of the size.
fn announce(
    arguments: &Render,
    stage: &Stage,
    structure: &dyn Structure,
    all: &mut [Contender<'_>],
) -> Result<(), Failure> {
    const PART: u32 = 16;
    let small = stage.resized(arguments.size.map(|side| side.div_ceil(PART)));
    let mut studio = Studio::new((&small, structure), manner(arguments), interrupt::flag(), 0);
    let mut seconds = 0.0;
    for one in all.iter_mut() {
        seconds += f64::from(arguments.frames) * studio.tried(one, false)?;
        if arguments.compare {
            seconds += studio.tried(one, true)?;
        }
        if !one.shown.chosen.prepares_once() {
            say!(
                "warning: {} prepares triangles anew for every test; its time says nothing",
                one.shown.chosen.word
            );
        }
    }
    let pixels = |stage: &Stage| stage.size().map(f64::from).iter().product::<f64>();
    let [columns, rows] = arguments.size;
    say!(
        "{}: {}, {columns} x {rows} pixels, {} by {}, about {:.0} s",
        arguments.model,
        count(stage.triangles.len(), "triangle", "triangles"),
        count(arguments.frames as usize, "frame", "frames"),
        count(all.len(), "kernel", "kernels"),
        (seconds * pixels(stage) / pixels(&small)).ceil()
    );
    Ok(())
}

/// `box.png` and `-compare` make `box-compare.png`.
pub fn beside(path: &Path, what: &str) -> PathBuf {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!("{stem}{what}.png"))
}
