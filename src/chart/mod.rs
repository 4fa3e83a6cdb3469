//! Rows -> SVG, one file per kind of chart.
//!
//! A figure is described by the `[[figure]]` table of an experiment ([`Figure`]) and drawn from
//! stored rows alone, so that old results can be drawn again. The same rows give the same bytes.

mod ambiguous;
mod axis;
mod bar_widths;
mod bars;
mod canvas;
mod counts;
mod envelope;
mod figure;
mod figure_label;
mod figure_use;
mod frame;
mod heat;
mod labels;
mod line_marks;
mod lines;
mod normalise;
mod numbers;
mod palette;
mod precision;
mod published;
mod select;
mod shares;
mod stability;
mod svg;
#[cfg(test)]
mod tests;
mod text;
mod timeline;
mod upright;
mod wanted;

pub use ambiguous::differing;
pub use envelope::Envelope;
pub use figure::{Beside, Figure, Kind, Names, Scale, Within};
pub use frame::title;
pub use numbers::{Count, Field, Numbers, numbers};
pub use precision::{Dot, Standing, on_steps};
pub use published::{Measure, Published, PublishedPoint};
pub use select::Point;
pub use stability::stability_figures;
pub use text::figure as short_figure;
pub use timeline::{TIMELINE_QUESTION, timeline, timeline_words};
pub use wanted::{Wanted, admits};

use crate::table::Row;

/// Why a figure cannot be drawn.
#[derive(Debug, thiserror::Error)]
pub enum ChartError {
    /// A key of the figure's table holds something that is not allowed.
    #[error("figure '{figure}', key '{key}': '{value}' is not allowed; allowed: {allowed}")]
    Wrong {
        /// The figure's file name.
        figure: String,
        /// The key.
        key: &'static str,
        /// What stands there.
        value: String,
        /// What may stand there.
        allowed: String,
    },
    /// Several rows claim the same place in the figure.
    #[error(
        "figure '{figure}': several rows are for {place}; they differ in {differing}. \
         Allowed: one row per panel, series and x; name what differs in panels, series, x or filter"
    )]
    Ambiguous {
        /// The figure's file name.
        figure: String,
        /// Panel, series and x.
        place: String,
        /// Columns in which the rows differ.
        differing: String,
    },
    /// There is nothing to draw; [`draw`] makes a placeholder of it.
    #[error("{0}")]
    Nothing(String),
    /// The published figures cannot be read.
    #[error("{0}")]
    Published(String),
    /// The drawing itself failed.
    #[error("drawing failed: {0}")]
    Drawing(String),
}

/// Draws a figure as SVG text. Where the rows have nothing to draw, the picture says so and why.
pub fn draw(figure: &Figure, rows: &[Row], published: &Published) -> Result<String, ChartError> {
    figure.validate(published)?;
    let drawn = match figure.kind {
        Kind::Lines => lines::draw(figure, rows, published),
        Kind::Bars => bars::draw(figure, rows, published),
        Kind::Shares => shares::draw(figure, rows, published),
        Kind::Counts => counts::draw(figure, rows, published),
        Kind::Precision => precision::draw(figure, rows),
        Kind::Heat => heat::draw(figure, rows),
    };
    match drawn {
        Err(ChartError::Nothing(reason)) => frame::placeholder(figure, &reason),
        other => other,
    }
}

/// The picture that stands where a figure could not be drawn, and says why.
pub fn placeholder(figure: &Figure, reason: &str) -> Result<String, ChartError> {
    frame::placeholder(figure, reason)
}
