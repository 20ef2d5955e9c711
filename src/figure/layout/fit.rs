//! From the plane to the canvas, and how much detail there is room for.
//!
//! ```text
//!   ┌──────────────── width ───────────────┐
//!   │  padding                             │
//!   │    ┌────────────────────────────┐ ymax      X = left + (x - xmin) · scale
//!   │    │  scale = px of a unit      │    │      Y = top  + (ymax - y) · scale
//!   │    └────────────────────────────┘    │
//!   │   xmin                               │
//!   └──────────────────────────────────────┘
//! ```

use crate::figure::canvas::vector::{Xy, xy};
use crate::figure::layout::options::{Detail, FigureOptions};
use crate::geometry::point::corners;
use crate::plane::Point;

/// Structures with at most this many edges may grow.
const SMALL: usize = 60;
/// The length at which a median edge has room for arrows and labels on both sides.
const ROOMY: f64 = 110.0;

/// The map from the plane to the canvas.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Fit {
    pub(crate) size: Xy,
    /// px of a unit of the plane.
    pub(crate) scale: f64,
    corner: Point,
    origin: Xy,
}

impl Fit {
    /// Where a point of the plane is drawn. The subtraction comes first: it keeps small details at large
    /// offsets.
    pub(crate) fn place(&self, p: Point) -> Xy {
        self.origin + xy((p.x - self.corner.x) * self.scale, (self.corner.y - p.y) * self.scale)
    }

    /// The point of the plane that is drawn at a place.
    #[cfg(feature = "play")]
    pub(crate) fn point(&self, at: Xy) -> Point {
        let way = at - self.origin;
        Point::new(self.corner.x + way.x / self.scale, self.corner.y - way.y / self.scale)
    }
}

/// The box round all points: its corner (xmin, ymax) and its size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    corner: Point,
    size: Xy,
}

impl Extent {
    pub(crate) fn of(points: impl IntoIterator<Item = Point>) -> Self {
        let [low, high] = corners(points);
        if low.x > high.x {
            return Self { corner: Point::default(), size: Xy::default() };
        }
        Self { corner: Point::new(low.x, high.y), size: xy(high.x - low.x, high.y - low.y) }
    }

    /// The longer side.
    pub(crate) fn span(&self) -> f64 {
        self.size.x.max(self.size.y)
    }

    /// The scale at which the extent fits into a canvas of this size.
    fn scale(&self, canvas: Xy, padding: f64) -> f64 {
        let along =
            |room: f64, size: f64| if size > 0.0 { (room - 2.0 * padding).max(1.0) / size } else { f64::INFINITY };
        let scale = along(canvas.x, self.size.x).min(along(canvas.y, self.size.y));
        if scale.is_finite() { scale } else { 1.0 }
    }

    fn fit(&self, scale: f64, padding: f64) -> Fit {
        let drawn = self.size * scale;
        let smallest = 2.0 * padding + 36.0;
        let whole = |length: f64| ((length + 2.0 * padding).max(smallest) * 100.0).round() / 100.0;
        let size = xy(whole(drawn.x), whole(drawn.y));
        Fit { size, scale, corner: self.corner, origin: (size - drawn) * 0.5 }
    }
}

/// What the choice of scale and detail depends on.
pub(crate) struct Load {
    pub(crate) edges: usize,
    pub(crate) vertices: usize,
    /// The median length of the edges in units of the plane, if there are edges.
    pub(crate) median: Option<f64>,
}

/// Chooses scale and detail: fit to the width; let a small structure grow; look how long the edges are then;
/// without half-edges a smaller padding is enough.
pub(crate) fn choose(extent: &Extent, load: &Load, options: &FigureOptions) -> (Fit, Detail) {
    let style = &options.style;
    let width = options.width.unwrap_or(options.usual_width);
    let height = options.height.unwrap_or(1.25 * width);
    let canvas = xy(width, height);
    let [padding, small_padding] =
        [style.padding, style.small_padding].map(|p| if options.crop.is_some() { 0.0 } else { p });
    let mut scale = extent.scale(canvas, padding);
    let median = load.median.filter(|&m| m > 0.0);
    if let Some(median) = median
        && options.width.is_none()
        && load.edges <= SMALL
    {
        let wide = extent.scale(xy(options.widest, options.height.unwrap_or(options.widest)), padding);
        scale = scale.max((ROOMY / median).min(wide));
    }
    let detail = options.detail.unwrap_or_else(|| detail(load, median.map(|m| m * scale)));
    let fit = if detail >= Detail::Arrows {
        extent.fit(scale, padding)
    } else {
        extent.fit(scale.max(extent.scale(canvas, small_padding)), small_padding)
    };
    (fit, detail)
}

fn detail(load: &Load, median: Option<f64>) -> Detail {
    let by_length = match median {
        Some(px) if px < 8.0 => Detail::Tiles,
        Some(px) if px < 25.0 => Detail::Edges,
        Some(px) if px < 60.0 => Detail::Arrows,
        _ => Detail::Full,
    };
    let by_number = match load.edges.max(load.vertices) {
        0..=2_000 => Detail::Full,
        2_001..=5_000 => Detail::Arrows,
        5_001..=20_000 => Detail::Edges,
        _ => Detail::Tiles,
    };
    by_length.min(by_number)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn load(edges: usize, median: f64) -> Load {
        Load { edges, vertices: 4, median: Some(median) }
    }

    #[test]
    fn a_small_structure_grows_until_its_median_edge_is_roomy() {
        let extent = Extent::of([Point::new(0.0, 0.0), Point::new(10.0, 10.0)]);
        let grown = |edges, median| choose(&extent, &load(edges, median), &FigureOptions::default()).0.scale;
        assert!((grown(60, 1.0) - 110.0).abs() < 1e-9);
        assert!((grown(61, 1.0) - 51.6).abs() < 1e-9, "61 edges do not grow");
        assert!((grown(60, 0.1) - 147.6).abs() < 1e-9, "not beyond 1600 px");
        assert!((grown(60, 9.0) - 51.6).abs() < 1e-9, "large enough already");
        let fixed = choose(&extent, &load(60, 1.0), &FigureOptions::default().width(640.0)).0;
        assert!((fixed.scale - 51.6).abs() < 1e-9, "a width given by the caller is kept");
    }

    #[test]
    fn the_level_changes_at_the_stated_lengths() {
        let level = |px| detail(&load(100, 1.0), Some(px));
        let levels = [(60.0, Detail::Full), (59.9, Detail::Arrows), (25.0, Detail::Arrows), (24.9, Detail::Edges)];
        for (px, expected) in levels.into_iter().chain([(8.0, Detail::Edges), (7.9, Detail::Tiles)]) {
            assert_eq!(level(px), expected, "{px} px");
        }
        assert_eq!(detail(&load(20_001, 1.0), Some(1e3)), Detail::Tiles);
    }

    #[test]
    fn far_away_and_degenerate_extents_have_a_scale() {
        let far = Extent::of([Point::new(1e9, 1e9), Point::new(1e9 + 1e-3, 1e9)]);
        let (fit, _) = choose(&far, &load(1, 1e-3), &FigureOptions::default());
        let ends = [fit.place(Point::new(1e9, 1e9)), fit.place(Point::new(1e9 + 1e-3, 1e9))];
        assert!((ends[1].x - ends[0].x - 516.0).abs() < 1e-6, "{ends:?}");
        for points in [vec![], vec![Point::new(5e-324, 0.0), Point::new(0.0, 0.0)], vec![Point::new(7.0, 7.0)]] {
            let (fit, _) = choose(&Extent::of(points), &load(0, 0.0), &FigureOptions::default());
            assert!(fit.scale.is_finite() && fit.size.x > 100.0 && fit.size.y > 100.0, "{fit:?}");
        }
    }
}
