//! Charts with axes: how something grows, or compares.
//!
//! ```text
//!   time per triangle (ns)
//!   200 ┤           ╭── shuffled        axis.rs     scales, round numbers
//!       │      ╭────╯                   series.rs   points, error bars, reference lines
//!   100 ┤■──■──╯                        plot.rs     the drawing
//!       │●──●──●────●── ordered
//!     0 ┼───┬──┬────┬
//!      10⁴ 10⁵ 10⁶ 10⁷  triangles
//! ```
//!
//! Series differ by colour, dash and mark, and carry their names at their ends, so that no legend has to be
//! matched. The marks are groups with `data-x` and `data-y`, the values as given.

mod axis;
mod log;
mod plot;
mod series;

pub use crate::figure::kinds::chart::axis::Axis;
pub use crate::figure::kinds::chart::series::{Growth, Sample, Series};

use crate::figure::kinds::chart::series::Reference;
use crate::figure::{Figure, FigureOptions};

/// Why a chart cannot be drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ChartError {
    /// No point has a place on both axes.
    #[error("none of the {points} points has a place on both axes: add finite values, positive ones on log axes")]
    NoPoint {
        /// How many points there are.
        points: usize,
    },
}

/// Series of points over two axes.
///
/// ```
/// use dcel_kit::figure::FigureOptions;
/// use dcel_kit::figure::chart::{Axis, Chart, Growth};
///
/// let mut chart = Chart::new(Axis::log("triangles"), Axis::log("time").unit("ms"));
/// chart.series("builder", [(1e4, 0.5), (1e5, 5.8), (1e6, 59.0)]);
/// chart.reference(Growth::NLogN, [1e4, 0.3]);
/// let svg = chart.figure(&FigureOptions::new("Growth"))?.to_svg();
/// assert!(svg.contains("data-x=\"10000\""));
/// # Ok::<(), dcel_kit::figure::chart::ChartError>(())
/// ```
#[derive(Clone, PartialEq, Debug)]
pub struct Chart {
    x: Axis,
    y: Axis,
    series: Vec<Series>,
    references: Vec<Reference>,
}

impl Chart {
    /// A chart without points.
    #[must_use]
    pub fn new(x: Axis, y: Axis) -> Self {
        Self { x, y, series: Vec::new(), references: Vec::new() }
    }

    /// Adds a series; its points are joined in the order in which they are given.
    pub fn series<S: Into<Sample>>(&mut self, name: &str, samples: impl IntoIterator<Item = S>) -> &mut Series {
        let samples = samples.into_iter().map(Into::into).collect();
        self.series.push(Series::new(name, samples, self.series.len()));
        let last = self.series.len() - 1;
        &mut self.series[last]
    }

    /// Adds a thin line that grows as stated and passes through a point: to compare the slope. It does not count for
    /// the range of the axes.
    pub fn reference(&mut self, growth: Growth, through: [f64; 2]) -> &mut Self {
        self.references.push(Reference { growth, through });
        self
    }

    /// Draws the chart: 640 px wide unless the options say otherwise, at most as high as they allow. Of the options,
    /// those of structures have no say. Points without a place are noted.
    ///
    /// # Errors
    /// [`ChartError::NoPoint`].
    pub fn figure(&self, options: &FigureOptions) -> Result<Figure, ChartError> {
        plot::draw(self, &options.checked())
    }
}
