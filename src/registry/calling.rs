//! How a variant is called from Rust: lines to paste. The types' names are the compiler's own, so that
//! no list of them can go out of date.

use std::any::type_name;

use super::{Axes, KernelVisitor, Offers, Variant, visit_kernels};
use crate::level;
use crate::policy::{
    Compare, Division, Early, Exit, First, Full, Fused, Hit, Inside, Last, Leading, Once, Output,
    Plain, Products, Rounding, SignBits, SignBitsSafe, Surface, T, Tests, Tuv, TwoSided,
};

impl Variant {
    /// Lines of Rust that call it: a single ray's test by its types, as in the example of the crate's
    /// documentation; anything else by its id, over whole batches.
    pub fn call(&self) -> String {
        typed(&self.axes).unwrap_or_else(|| by_id(&self.id()))
    }
}

fn by_id(id: &str) -> String {
    format!(
        "let variant = ray_test::registry::find(\"{id}\");\n\
         let nearest = variant.and_then(|it| it.nearest.as_ref()).expect(\"it is built in\");\n\
         let answers = nearest(&rays, &triangles).answers();"
    )
}

fn typed(axes: &Axes) -> Option<String> {
    let is_scalar = axes.drive == "single" && axes.layout == "aos" && axes.priced.is_empty();
    let is_usual = axes.cull == "off" && axes.reciprocal == "divide" && axes.query == "ray";
    if !is_scalar || !is_usual {
        return None;
    }
    let (kernel, form, precision) = (kernel(axes)?, form(axes)?, axes.precision);
    let lowest = level::levels().first().is_none_or(|(level, _)| *level == axes.level);
    let note = if lowest {
        String::new()
    } else {
        format!("// Timed as code for {}: build with -C target-cpu=native.\n", axes.level)
    };
    // An alias, since an expression does not fill in the default parameters of a type.
    Some(format!(
        "{note}type Test = {kernel};\n\
         type Usual = {form};\n\
         let met = Test::meet::<Usual, {precision}>((), &Test::prepare(&triangle));\n\
         let aim = Test::aim::<Usual, {precision}>(&ray);\n\
         let found = Test::test::<Usual, {precision}>(&ray, &aim, &met);"
    ))
}

/// A type's name without the modules that it and its parameters are in.
fn name<T: ?Sized>() -> String {
    let full = type_name::<T>();
    let mut short = String::new();
    for part in full.split_inclusive(['<', '>', ',', ' ']) {
        short += part.rsplit("::").next().unwrap_or(part);
    }
    short
}

/// The kernel's type.
fn kernel(axes: &Axes) -> Option<String> {
    struct Search<'a>(&'a Axes, Option<String>);
    impl KernelVisitor for Search<'_> {
        fn kernel<K: Offers>(&mut self) {
            let about = &K::ABOUT;
            let own = [about.id, about.stored, K::EDGES, K::PROJECTION, K::CROSS];
            let axes = self.0;
            if own == [axes.kernel, axes.stored, axes.edges, axes.projection, axes.cross] {
                self.1 = Some(name::<K>());
            }
        }
    }
    let mut search = Search(axes, None);
    visit_kernels(&mut search);
    search.1
}

/// The form's type; parameters that have their default are left out where they can be.
fn form(axes: &Axes) -> Option<String> {
    let exits = [
        (Early::NAME, name::<Early>()),
        (Once::NAME, name::<Once>()),
        (Full::NAME, name::<Full>()),
    ];
    let divisions = [(First::NAME, name::<First>()), (Last::NAME, name::<Last>())];
    let roundings = [(Plain::NAME, name::<Plain>()), (Fused::NAME, name::<Fused>())];
    let outputs = [
        (Hit::NAME, name::<Hit>()),
        (T::NAME, name::<T>()),
        (Tuv::NAME, name::<Tuv>()),
        (Surface::NAME, name::<Surface>()),
    ];
    let tests = [
        (Compare::NAME, name::<Compare>()),
        (SignBits::NAME, name::<SignBits>()),
        (SignBitsSafe::NAME, name::<SignBitsSafe>()),
        (Products::NAME, name::<Products>()),
    ];
    let find = |words: &[(&str, String)], word: &str| {
        words.iter().find(|(name, _)| *name == word).map(|(_, of)| of.clone())
    };
    let mut parts = vec![
        find(&exits, axes.exit)?,
        find(&divisions, axes.division)?,
        find(&roundings, axes.rounding)?,
        find(&outputs, axes.output)?,
    ];
    if axes.leading == Inside::NAME || axes.tests != Compare::NAME {
        parts.extend([name::<TwoSided>(), find(&tests, axes.tests)?]);
    }
    if axes.leading == Inside::NAME {
        parts.push(name::<Inside>());
    }
    Some(format!("Form<{}>", parts.join(", ")))
}

#[cfg(test)]
mod tests {
    use crate::registry::{REFERENCE, find};

    #[test]
    fn the_reference_is_called_as_in_the_documentation_which_compiles() {
        let call = find(REFERENCE).expect("it is there").call();
        let documentation: String = include_str!("../lib.rs")
            .lines()
            .filter_map(|line| Some(format!("{}\n", line.strip_prefix("//! ")?)))
            .collect();
        for line in call.lines() {
            // There, the last line goes on.
            assert!(documentation.contains(line.trim_end_matches(';')), "{line}");
        }
        assert_eq!(call.lines().count(), 5);
    }
}
