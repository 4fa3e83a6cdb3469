//! `ray_test list`: what there is.

use serde_json::{Value, json};

use super::arguments::{List, Listed};
use super::built_in::built_in;
use super::failure::Failure;
use super::show::{Sheet, print};
use crate::claims::{Claim, Ledger};
use crate::level::levels;
use crate::registry::{COLUMNS, kernels, variants};

/// Prints what was asked for.
pub fn run(arguments: &List) -> Result<(), Failure> {
    let sheet = match arguments.what {
        Listed::Kernels => list_kernels(),
        Listed::Variants => list_variants(),
        Listed::Experiments => list_experiments()?,
        Listed::Claims => list_claims()?,
        Listed::Levels => list_levels(),
        Listed::Families => list_families(),
    };
    print(&sheet, arguments.format)
}

fn list_kernels() -> Sheet {
    let row = |variant: &&crate::registry::Variant| -> Vec<Value> {
        let about = variant.about;
        vec![
            json!(about.id),
            json!(about.name),
            json!(about.year),
            json!(about.source),
            json!(about.setup),
            json!(variant.bytes_per_triangle),
            json!(about.watertight),
        ]
    };
    Sheet {
        columns: vec!["id", "name", "year", "source", "setup", "bytes_per_triangle", "watertight"],
        rows: kernels().iter().map(row).collect(),
    }
}

fn list_variants() -> Sheet {
    let mut columns = vec!["id", "available"];
    columns.extend(COLUMNS);
    let row = |variant: &crate::registry::Variant| -> Vec<Value> {
        let mut row = vec![json!(variant.id()), json!((variant.available)())];
        row.extend(variant.axes.values().map(|value| json!(value)));
        row
    };
    Sheet { columns, rows: variants().iter().map(row).collect() }
}

fn list_experiments() -> Result<Sheet, Failure> {
    let mut rows = Vec::new();
    for (file, experiment) in built_in()? {
        rows.push(vec![
            json!(experiment.id),
            json!(experiment.title),
            json!(experiment.mirrors),
            json!(file),
        ]);
    }
    Ok(Sheet { columns: vec!["id", "title", "mirrors", "config"], rows })
}

fn list_claims() -> Result<Sheet, Failure> {
    let ledger = Ledger::embedded()?;
    let row = |claim: &Claim| vec![json!(claim.id), json!(claim.source), json!(claim.statement)];
    let rows = ledger.claims().iter().map(row).collect();
    Ok(Sheet { columns: vec!["id", "source", "statement"], rows })
}

fn list_families() -> Sheet {
    let row = |family: &crate::stability::Family| -> Vec<Value> {
        vec![json!(family.id), json!(family.knob), json!(family.range()), json!(family.passes)]
    };
    let rows = crate::stability::families().iter().map(row).collect();
    Sheet { columns: vec!["id", "knob", "range", "passes"], rows }
}

fn list_levels() -> Sheet {
    let row = |(id, available): (&str, bool)| vec![json!(id), json!(available)];
    Sheet { columns: vec!["id", "available"], rows: levels().into_iter().map(row).collect() }
}
