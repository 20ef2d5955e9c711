//! What is seen of faces and holes: their colour at points well inside.

use super::eye::{Eye, contrast, cut_by};
use super::ink::Hidden;
use super::painting::{Area, Clip, PALE, Part, Shape};
use crate::plane::Point;

/// What is seen of a face.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Filling {
    Seen,
    /// It has the colour of the paper.
    Pale,
    /// Its own path fills nothing in it.
    Hollow,
    /// A clip path or the border of the canvas cuts it off.
    Cut(Hidden),
}

impl Eye<'_> {
    /// What is seen of a face whose corners on the canvas are a ring, painted by a coat.
    pub(super) fn face(&mut self, coat: u32, ring: Vec<Point>) -> Filling {
        let painting = self.painting;
        let Shape::Area(area) = &painting.coats[coat as usize].shape else { return Filling::Seen };
        let ring = Area::new(&[ring], false);
        let points = area.inner_points(&ring);
        if points.is_empty() {
            return Filling::Hollow;
        }
        let coat = &painting.coats[coat as usize];
        let cut: Vec<&Clip> = points.iter().filter_map(|&p| painting.cut_off(coat, p)).collect();
        if let Some(why) = cut_by(cut.iter().copied()).filter(|_| 2 * cut.len() > points.len()) {
            return Filling::Cut(why);
        }
        let seen = self.count_filled(&points);
        if 2 * seen > points.len() { Filling::Seen } else { Filling::Pale }
    }

    /// Whether something that is no paper fills a ring of corners on the canvas.
    pub(super) fn is_filled(&mut self, ring: Vec<Point>) -> bool {
        let ring = Area::new(&[ring], false);
        let points = ring.inner_points(&ring);
        2 * self.count_filled(&points) > points.len() && !self.is_tired()
    }

    /// At how many points something else than paper is seen, lines and marks aside; at all, if there is too much to look at.
    fn count_filled(&mut self, points: &[Point]) -> usize {
        let mut seen = 0;
        for &p in points {
            if self.is_tired() {
                return points.len();
            }
            self.look(p);
            let areas = self.colour(|_, coat| coat.part == Part::Area);
            seen += usize::from(contrast(areas, self.blank()) >= PALE);
        }
        seen
    }
}
