//! Forms of the registry, timed side by side on the sample.

use super::evidence::Saving;
use super::form::{Form, Output, translates};
use super::pieces::PIECES;
use crate::experiment::{Bench, Scene, Trouble, cells};
use crate::kernels::{Edges, Fallback, Fixed, NoFallback, Projection};
use crate::measure::{Figures, Order, Protocol};
use crate::registry::{self, Axes, REFERENCE, Variant, variants};
use crate::table::Row;

/// The experiment that rows are of.
pub const EXPERIMENT: &str = "scene";
/// A segment test, which is judged on other questions than rays.
const SEGMENTS: &str = "chirkov";

/// The level of the forms that have every piece: the lowest that there is.
pub fn level() -> &'static str {
    let usual = variants().iter().find(|variant| {
        let axes = &variant.axes;
        axes.kernel == "moller-trumbore" && (variant.available)() && is_plain(axes)
    });
    usual.map_or_else(|| REFERENCE.split('/').nth(3).unwrap_or(""), |usual| usual.axes.level)
}

/// A single ray, everything that no piece is about at its default.
fn is_plain(axes: &Axes) -> bool {
    axes.drive == "single"
        && axes.exit == "early"
        && axes.rounding == "plain"
        && axes.layout == "aos"
        && axes.tests == "compare"
        && axes.reciprocal == "divide"
        && axes.leading_is_native
        && axes.cross.is_empty()
        && axes.priced.is_empty()
        && axes.query == "ray"
        && axes.copy == 0
}

/// What a plan knows of a variant.
pub fn form(variant: &Variant) -> Option<Form> {
    let axes = &variant.axes;
    let has_edges = !axes.edges.is_empty();
    Some(Form {
        id: variant.id(),
        kernel: axes.kernel.to_owned(),
        in_f64: axes.precision == "f64" || axes.kernel.ends_with("-in-f64"),
        output: Output::of(axes.output)?,
        divides_last: axes.division == "last",
        culls: axes.cull == "on",
        projects_along_z: axes.projection == <Fixed<2> as Projection>::NAME,
        prepares: axes.stored != "vertices",
        watertight: variant.about.watertight,
        falls_back: has_edges && axes.edges != NoFallback::NAME,
        translates: translates(axes.kernel),
    })
}

/// The variant that has everything that is needed of what is not always there, and else is what everybody
/// uses: Moeller and Trumbore's test, two-sided, with u and v.
pub fn default_variant(output: Output, watertight: bool, in_f64: bool) -> Option<&'static Variant> {
    let kernel = if watertight { "woop-watertight" } else { "moller-trumbore" };
    let precision = if in_f64 { "f64" } else { "f32" };
    let output = output.max(Output::Tuv).word();
    let level = level();
    registry::find(&format!("{kernel}/{precision}/single/{level}/early/last/plain/{output}"))
        .or_else(|| {
            registry::find(&format!("{kernel}/{precision}/single/{level}/early/last/plain/tuv"))
        })
}

/// The forms that may become the plan: those of a precision that yield what is wanted and do what `needed` says. What
/// culls or projects along one axis exists with u and v only.
pub fn candidates(
    output: Output,
    in_f64: bool,
    needed: &dyn Fn(&Form) -> bool,
) -> Vec<&'static Variant> {
    let level = level();
    let fits = |variant: &&'static Variant| {
        let axes = &variant.axes;
        let single = is_plain(axes)
            && axes.level == level
            && variant.pairs.is_some()
            && variant.nearest.is_some();
        let known = !variant.is_peer() && axes.kernel != SEGMENTS && variant.claims_exactness();
        let other_edges = !["", Fallback::NAME, NoFallback::NAME].contains(&axes.edges);
        let Some(form) = form(variant).filter(|_| single && known && !other_edges) else {
            return false;
        };
        let special = form.culls || form.projects_along_z;
        let enough = form.output == output || (special && form.output > output);
        enough && form.in_f64 == in_f64 && needed(&form)
    };
    variants().iter().filter(fits).collect()
}

/// No more forms than that are timed in the heats.
pub fn forms_at_most(output: Output) -> usize {
    candidates(output, false, &|_| true).len()
}

/// What was timed on one sample.
#[derive(Default)]
pub struct Timed {
    /// A row per variant.
    pub rows: Vec<Row>,
    /// Figures by variant id.
    pub figures: Vec<Figures>,
    /// What identical code differs by, relative; no less than [`Protocol::margin`].
    pub floor: f64,
}

impl Timed {
    /// The figures of a variant, if they stand.
    pub fn of(&self, id: &str) -> Option<&Figures> {
        let found = self.figures.iter().find(|figures| figures.id == id);
        found.filter(|figures| figures.ns_per_test.is_some())
    }
}

/// Times variants on the sample beside the default one. Those with a wrong answer are not timed.
///
/// # Errors
/// A group that cannot be measured.
pub fn time(
    variants: &[&'static Variant],
    default: &'static Variant,
    scene: &Scene,
    bench: &mut Bench<'_>,
) -> Result<Timed, Trouble> {
    let order = Order::Reshuffled;
    let measured = cells::run(EXPERIMENT, variants, default, scene, order, bench)?;
    // What has no copies to be compared with is held to what is no difference anywhere.
    let floors = measured.rows.iter().filter_map(|row| row.noise_floor);
    let floor = floors.fold(Protocol::new(order, scene.facts.seed).margin, f64::max);
    Ok(Timed { rows: measured.rows, figures: measured.figures, floor })
}

/// The variants of all pairs of forms whose pieces may be left out, none twice.
pub fn paired(spare: &dyn Fn(usize) -> bool) -> Vec<&'static Variant> {
    let mut chosen: Vec<&'static Variant> = Vec::new();
    let places = (0..PIECES.len()).filter(|place| spare(*place));
    let pairs = places.filter_map(|place| PIECES[place].pair_at(level()));
    for id in pairs.flatten() {
        if let Some(variant) = registry::find(&id)
            && !chosen.iter().any(|other| std::ptr::eq(*other, variant))
        {
            chosen.push(variant);
        }
    }
    // Forms of one kernel beside each other, as groups are cut.
    chosen.sort_by_key(|variant| variant.axes.kernel);
    chosen
}

/// What the pair of each piece says.
pub fn savings(timed: &Timed) -> Vec<Option<Saving>> {
    let of = |place: usize| {
        let [with, without] = PIECES[place].pair_at(level())?;
        let (with, without) = (timed.of(&with)?, timed.of(&without)?);
        Saving::of(&without.samples, &with.samples, timed.floor)
    };
    (0..PIECES.len()).map(of).collect()
}
