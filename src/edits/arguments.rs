//! Arguments of an edit, and how a row reads them.

use crate::ids::{EdgeId, Element, FaceId, HalfEdgeId, VertexId};
use crate::plane::{Affine, Point};
use std::slice::Iter;

/// An argument of an edit.
#[derive(Clone, Copy, PartialEq, Debug)]
#[non_exhaustive]
pub enum Argument {
    /// An element.
    Element(Element),
    /// A place; in the plane the third coordinate is 0.
    Place([f64; 3]),
    /// A number.
    Number(f64),
    /// `yes` or `no`.
    Switch(bool),
}

impl<E: Into<Element>> From<E> for Argument {
    fn from(element: E) -> Self {
        Self::Element(element.into())
    }
}

impl From<Point> for Argument {
    fn from(point: Point) -> Self {
        Self::Place([point.x, point.y, 0.0])
    }
}

impl From<[f64; 3]> for Argument {
    fn from(place: [f64; 3]) -> Self {
        Self::Place(place)
    }
}

impl From<f64> for Argument {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<bool> for Argument {
    fn from(yes: bool) -> Self {
        Self::Switch(yes)
    }
}

/// The arguments of a call as a row reads them, one after the other. They have been checked against what the row says
/// it takes.
#[derive(Clone, Debug)]
pub struct Arguments<'a> {
    list: Iter<'a, Argument>,
    dimension: usize,
}

const CHECKED: &str = "a call is made only with the arguments that its row takes";

impl<'a> Arguments<'a> {
    /// The arguments for a structure with so many coordinates.
    pub(super) fn new(list: &'a [Argument], dimension: usize) -> Self {
        Self { list: list.iter(), dimension }
    }

    fn element(&mut self) -> Element {
        let Some(&Argument::Element(element)) = self.list.next() else { panic!("{CHECKED}") };
        element
    }

    /// The next argument, a vertex.
    ///
    /// # Panics
    /// As the others, if the row reads another kind than it says.
    pub fn vertex(&mut self) -> VertexId {
        VertexId::from_element(self.element()).expect(CHECKED)
    }

    /// The next argument, a half-edge.
    pub fn half_edge(&mut self) -> HalfEdgeId {
        HalfEdgeId::from_element(self.element()).expect(CHECKED)
    }

    /// The next argument, an edge.
    pub fn edge(&mut self) -> EdgeId {
        EdgeId::from_element(self.element()).expect(CHECKED)
    }

    /// The next argument, a face.
    pub fn face(&mut self) -> FaceId {
        FaceId::from_element(self.element()).expect(CHECKED)
    }

    /// The rest of the arguments, vertices.
    pub fn vertices(&mut self) -> Vec<VertexId> {
        (0..self.list.len()).map(|_| self.vertex()).collect()
    }

    /// The next argument, a place; the origin where there are no coordinates.
    pub fn place(&mut self) -> Place {
        if self.dimension == 0 {
            return Place([0.0; 3]);
        }
        let Some(&Argument::Place(place)) = self.list.next() else { panic!("{CHECKED}") };
        Place(place)
    }

    /// The next argument, a number.
    pub fn number(&mut self) -> f64 {
        let Some(&Argument::Number(number)) = self.list.next() else { panic!("{CHECKED}") };
        number
    }

    /// The next arguments, an affine map.
    pub fn map(&mut self) -> Map {
        let mut numbers = [0.0; 12];
        let count = self.dimension * (self.dimension + 1);
        numbers[..count].iter_mut().for_each(|x| *x = self.number());
        Map(numbers)
    }

    /// The next argument, `yes` or `no`.
    pub fn switch(&mut self) -> bool {
        let Some(&Argument::Switch(yes)) = self.list.next() else { panic!("{CHECKED}") };
        yes
    }
}

/// A place, as a point of the plane or of space.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Place([f64; 3]);

impl Place {
    /// The first two coordinates.
    #[must_use]
    pub fn xy(self) -> [f64; 2] {
        [self.0[0], self.0[1]]
    }
}

impl From<Place> for Point {
    fn from(place: Place) -> Self {
        Self::new(place.0[0], place.0[1])
    }
}

impl From<Place> for [f64; 3] {
    fn from(place: Place) -> Self {
        place.0
    }
}

/// An affine map of the plane or of space, as it was written.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Map([f64; 12]);

impl Map {
    /// The map of the plane.
    #[must_use]
    pub fn in_plane(self) -> Affine<2> {
        let [a, b, c, d, x, y, ..] = self.0;
        Affine { matrix: [[a, b], [c, d]], shift: [x, y] }
    }

    /// The map of space.
    #[must_use]
    pub fn in_space(self) -> Affine<3> {
        let [a, b, c, d, e, f, g, h, i, x, y, z] = self.0;
        Affine { matrix: [[a, b, c], [d, e, f], [g, h, i]], shift: [x, y, z] }
    }
}
