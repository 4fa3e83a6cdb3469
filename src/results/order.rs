//! The order of the chapters.

/// Thesis B's tables by number, thesis H's illustrations by number, its section on f64, ours by
/// name, the stiff cases last: what is compared to give that order.
pub(super) fn order(id: &str) -> (u32, u32, u32, &str) {
    let numbered = |rest: &str| {
        let mut numbers = rest.split('.').map(|part| part.parse::<u32>().ok());
        let first = numbers.next().flatten()?;
        match (numbers.next(), numbers.next()) {
            (None, _) => Some((first, 0)),
            (Some(second), None) => Some((first, second?)),
            _ => None,
        }
    };
    for (rank, thesis) in [(0, "b-"), (1, "h-")] {
        if let Some((first, second)) = id.strip_prefix(thesis).and_then(numbered) {
            return (rank, first, second, id);
        }
    }
    let rank = match id {
        "h-double" => 2,
        "stability" => 4,
        _ => 3,
    };
    (rank, 0, 0, id)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_numbers_and_ours_come_behind() {
        let wanted = [
            "b-4.1",
            "b-4.2",
            "b-4.9",
            "b-4.10",
            "h-4",
            "h-9",
            "h-10",
            "h-11",
            "h-double",
            "b-side",
            "arithmetic",
            "h-else",
            "zebra",
            "stability",
        ];
        let mut sorted = wanted;
        sorted.reverse();
        sorted.sort_by(|one, other| order(one).cmp(&order(other)));
        let ours = ["arithmetic", "b-side", "h-else", "zebra"];
        assert_eq!(sorted[..9], wanted[..9]);
        assert_eq!(sorted[9..13], ours);
        assert_eq!(sorted[13], "stability");
    }
}
