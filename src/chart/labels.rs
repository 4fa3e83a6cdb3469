//! Labels beside the ends of lines: pushed apart where the lines end close together.

/// Heights for labels that want to be at `wanted`, at least `gap` apart, within `top` to `bottom`
/// as far as there is room. Each run of crowded labels is centred on what its members want.
pub(super) fn pushed_apart(wanted: &[f64], gap: f64, top: f64, bottom: f64) -> Vec<f64> {
    let mut order: Vec<usize> = (0..wanted.len()).collect();
    order.sort_by(|a, b| wanted[*a].total_cmp(&wanted[*b]).then(a.cmp(b)));
    // Runs of labels: (sum of the heights wanted for the first of them, number of labels).
    let mut runs: Vec<(f64, usize)> = Vec::new();
    let place = |run: &(f64, usize)| {
        let last = bottom - gap * (run.1 - 1) as f64;
        (run.0 / run.1 as f64).min(last).max(top)
    };
    for index in &order {
        runs.push((wanted[*index], 1));
        while let [.., upper, lower] = runs.as_slice() {
            if place(upper) + gap * upper.1 as f64 <= place(lower) {
                break;
            }
            // The lower run's first label stands `upper.1` gaps below the merged run's first.
            let merged = (upper.0 + lower.0 - gap * (upper.1 * lower.1) as f64, upper.1 + lower.1);
            runs.truncate(runs.len() - 2);
            runs.push(merged);
        }
    }
    let mut heights = vec![0.0; wanted.len()];
    let mut labels = order.iter();
    for run in &runs {
        for (step, index) in labels.by_ref().take(run.1).enumerate() {
            heights[*index] = place(run) + gap * step as f64;
        }
    }
    heights
}
