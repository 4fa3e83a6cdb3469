//! Searches and pictures: structures around triangles, and what is made with them.

/// Adds its columns to those before, and passes them to the next list.
macro_rules! searches_columns {
    ([$next:ident $($rest:ident)*] { $($before:tt)* }) => {
        $next! { [$($rest)*] { $($before)*
            /// What triangles are searched with: a structure's name, `wide` for the fast path, or that of
            /// another crate's hierarchy.
            structure: String,
            /// Built-in scene or file that the triangles are of, without its size.
            scene: String,
            /// Structures: in which order triangles were inserted. Pictures: which pixels got a ray.
            variation: String,
            /// Triangles that a ray was tested against, on average.
            tests_per_ray: Option<f64>,
            /// Nodes that a ray opened, on average.
            nodes_per_ray: Option<f64>,
            /// Cells of a subdivision of space that a ray visited, on average.
            cells_per_ray: Option<f64>,
            /// Bounding volumes that a ray was tested against, on average.
            volumes_per_ray: Option<f64>,
            /// Share of them that it met.
            passed_share: Option<f64>,
            /// Bytes of the structure, without its triangles.
            structure_bytes: Option<u64>,
            /// Rays whose answer is another than the list's, or where that took too long, than that of the
            /// structure that stands for it.
            differences: Option<u64>,
            /// Those of them where that answer is a false hit, or nearer than the triangle is.
            excused: Option<u64>,
            /// Pairs of a volume and one in it that enough lines met.
            chance_pairs: Option<u64>,
            /// Largest distance between the share of lines that met the inner one, too, and the ratio of
            /// the surfaces, in standard errors.
            chance_error_max: Option<f64>,
            /// Median time of building the structure and preparing the triangles.
            build_ms: Option<f64>,
            /// Lower end of its interval.
            build_low: Option<f64>,
            /// Upper end of it.
            build_high: Option<f64>,
            /// Rays from which on building and searching take less than the list; empty where they never do.
            build_pays_rays: Option<f64>,
            /// Bounding volumes: time over the list's that B + p I foretells.
            predicted_ratio: Option<f64>,
            /// Lower end of its interval.
            predicted_low: Option<f64>,
            /// Upper end of it.
            predicted_high: Option<f64>,
            /// 1 where the measured ratio is on the same side of 1 as the foretold one, 0 where it is on
            /// the other; empty where an interval is on both.
            pays_as_predicted: Option<u64>,
            /// Exponent of the time over the number of triangles, from 100 of them on: 1 is linear.
            growth: Option<f64> [signed],
            /// Triangles from which on searching takes less than the list; the least measured number where
            /// that is less already, empty where it never is.
            pays_triangles: Option<f64>,
            /// The same with building included, of a picture's rays.
            pays_triangles_built: Option<f64>,
            /// Pictures: time of one.
            seconds_per_frame: Option<f64>,
            /// Pictures a second.
            frames_per_s: Option<f64>,
            /// Share of a picture's time that goes into searching for hits.
            intersection_percent: Option<f64> [signed],
            /// Share of the pixels that were filled without a ray.
            filled_percent: Option<f64>,
        } }
    };
}

pub(super) use searches_columns;
