//! How close to the limit: what operations cost on this machine, and what a test needs at least.

use super::arithmetic::{Member, measure};
use super::bench::Bench;
use super::run::Trouble;
use crate::batch::PLACES;
use crate::bound::{Bound, Costs};
use crate::registry::{OneStream, Variant, streams};
use crate::table::Row;

/// A fraction above this is said so: costs are measured as well, within 5 % of what units can do.
const MOST: f64 = 1.05;

/// Bytes of the smallest vector register, in which single numbers are computed as well.
const NARROW_BYTES: usize = 16;

/// Registers of a level, by precision, level and lanes.
type Registers = (&'static str, &'static str, usize);

fn registers(stream: &OneStream) -> Registers {
    (stream.precision, stream.level, stream.lanes)
}

/// Streams of the same registers are measured together.
fn groups(streams: Vec<OneStream>) -> Vec<Vec<OneStream>> {
    let mut groups: Vec<Vec<OneStream>> = Vec::new();
    for stream in streams {
        match groups.last_mut() {
            Some(group) if registers(&group[0]) == registers(&stream) => group.push(stream),
            _ => groups.push(vec![stream]),
        }
    }
    groups
}

/// How many streams of each group are measured on this machine.
pub fn group_sizes() -> Vec<usize> {
    let measured = |group: Vec<OneStream>| group.iter().filter(|one| (one.available)()).count();
    groups(streams()).into_iter().map(measured).filter(|size| *size > 0).collect()
}

/// A row per stream; a `test` is one operation of one lane.
///
/// # Errors
/// A group that cannot be measured or kept.
pub fn run(experiment: &str, seed: u64, bench: &mut Bench<'_>) -> Result<Vec<Row>, Trouble> {
    let mut rows = Vec::new();
    for group in groups(streams()) {
        let (precision, level, lanes) = registers(&group[0]);
        let piece = format!("streams {precision} {level} {lanes}");
        let member = |stream: OneStream| {
            let row = Row {
                id: stream.id(),
                experiment: experiment.into(),
                kernel: "stream".into(),
                form: stream.name(),
                precision: precision.into(),
                drive: format!("packet{lanes}"),
                level: level.into(),
                tests: Some((PLACES * lanes) as u64),
                seed: Some(seed),
                ..Row::default()
            };
            Member { row, job: (stream.available)().then(stream.job) }
        };
        rows.extend(measure(&piece, group.into_iter().map(member).collect(), seed, bench)?);
    }
    Ok(rows)
}

/// What operations cost in each kind of registers.
struct Measured(Vec<(Registers, Costs)>);

impl Measured {
    fn of(rows: &[Row]) -> Self {
        let mut all = Vec::new();
        for group in groups(streams()) {
            let mut costs = Costs::default();
            for stream in &group {
                let row = rows.iter().find(|row| row.id == stream.id() && row.status == "ok");
                if let Some(cycles) = row.and_then(|row| row.cycles_per_test) {
                    costs.insert(stream.mix, cycles * stream.lanes as f64);
                }
            }
            if !costs.is_empty() {
                all.push((registers(&group[0]), costs));
            }
        }
        Measured(all)
    }

    /// The costs in the widest registers of a level, with their lanes, or in the narrowest.
    fn at(&self, precision: &str, level: &str, widest: bool) -> Option<(usize, &Costs)> {
        let own = self.0.iter().filter(|((p, l, _), _)| (*p, *l) == (precision, level));
        let own = own.map(|((.., lanes), costs)| (*lanes, costs));
        if widest { own.max_by_key(|own| own.0) } else { own.min_by_key(|own| own.0) }
    }

    /// The bound of a variant whose work was counted. Single numbers of AVX-512 are in the registers
    /// that AVX2 has them in.
    fn bound(&self, variant: &Variant) -> Option<Bound> {
        let work = variant.work?();
        let (precision, level) = (variant.axes.precision, variant.axes.level);
        if variant.rays == 1 {
            let level = if level == "avx512" { "avx2" } else { level };
            return self.at(precision, level, false)?.1.single(&work);
        }
        let (lanes, costs) = self.at(precision, level, true)?;
        let narrow = NARROW_BYTES / if precision == "f64" { 8 } else { 4 };
        costs.packet(&work, variant.rays, lanes, narrow)
    }
}

/// Puts the bounds into the rows of variants whose work was counted, by the rows of streams.
pub fn put(rows: &mut [Row], variants: &[&'static Variant], streams: &[Row]) {
    if streams.is_empty() {
        return;
    }
    let measured = Measured::of(streams);
    for variant in variants {
        let Some(bound) = measured.bound(variant) else { continue };
        let id = variant.id();
        for row in rows.iter_mut().filter(|row| row.id == id) {
            put_bound(row, &bound);
        }
    }
}

/// The columns of a bound, and a word where the row is below it.
fn put_bound(row: &mut Row, bound: &Bound) {
    let Some(cycles) = row.cycles_per_test else { return };
    let fraction = bound.cycles / cycles;
    row.bound_cycles_per_test = Some(bound.cycles);
    row.bound_resource.clone_from(&bound.resource);
    row.bound_fraction = Some(fraction);
    if fraction > MOST {
        let note = format!(
            "{cycles:.3} cycles are below the bound of its operations, {:.3} ({})",
            bound.cycles, bound.resource
        );
        if !row.reason.is_empty() {
            row.reason += "; ";
        }
        row.reason += &note;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::batch::{Kind, mix};
    use crate::registry::find;

    const SINGLE: &str = "wald/f32/single/sse2/full/last/plain/tuv";

    fn row(id: &str, cycles: f64) -> Row {
        Row { id: id.into(), status: "ok".into(), cycles_per_test: Some(cycles), ..Row::default() }
    }

    /// Half a cycle an instruction of four lanes, whatever it is, but 4 for divisions.
    fn scripted() -> Vec<Row> {
        let of = |stream: OneStream| {
            let is_division = stream.mix == mix::alone(Kind::Divide);
            row(&stream.id(), if is_division { 4.0 } else { 0.5 } / stream.lanes as f64)
        };
        streams().into_iter().map(of).collect()
    }

    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    #[test]
    fn rows_say_what_their_operations_need_and_what_limits_them() {
        // 12 +, 17 x and a division of half a cycle.
        let mut rows = vec![row(SINGLE, 30.0), row("another", 30.0)];
        let variant = find(SINGLE).unwrap();
        put(&mut rows, &[variant], &scripted());
        assert_eq!(rows[0].bound_cycles_per_test, Some(15.0));
        assert_eq!(rows[0].bound_resource, "vector units");
        assert_eq!(rows[0].bound_fraction, Some(0.5));
        assert_eq!((rows[1].bound_fraction, rows[0].reason.as_str()), (None, ""));
    }

    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    #[test]
    fn packets_are_bounded_per_ray() {
        let id = "wald/f32/packet4/sse2/full/last/plain/tuv";
        let mut rows = vec![row(id, 6.0)];
        put(&mut rows, &[find(id).unwrap()], &scripted());
        // 12 +, 17 x, 6 comparisons, 2 flips and a division, for four rays; SSE's selections are free.
        assert_eq!(rows[0].bound_cycles_per_test, Some(38.0 / 2.0 / 4.0));
        assert_eq!(rows[0].bound_resource, "vector units");
    }

    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    #[test]
    fn a_row_below_its_bound_is_said_so() {
        let variant = find(SINGLE).unwrap();
        // 15 / 14.3 is 1.049, 15 / 14.2 is 1.056.
        for (cycles, is_noted) in [(14.3, false), (14.2, true)] {
            let mut rows = vec![Row { reason: "first".into(), ..row(SINGLE, cycles) }];
            put(&mut rows, &[variant], &scripted());
            assert_eq!(
                rows[0].reason.contains("; 14.200 cycles are below"),
                is_noted,
                "{}",
                rows[0].reason
            );
        }
    }

    #[test]
    fn without_streams_or_times_or_a_count_there_is_no_bound() {
        let early = find(crate::registry::REFERENCE);
        let mut rows = vec![row(crate::registry::REFERENCE, 9.0)];
        put(&mut rows, &early.into_iter().collect::<Vec<_>>(), &scripted());
        assert_eq!(rows[0].bound_cycles_per_test, None);
        let mut rows = vec![Row { cycles_per_test: None, ..row(SINGLE, 9.0) }];
        let full = find(SINGLE).into_iter().collect::<Vec<_>>();
        put(&mut rows, &full, &scripted());
        put(&mut rows, &full, &[]);
        assert_eq!(rows[0].bound_fraction, None);
    }
}
