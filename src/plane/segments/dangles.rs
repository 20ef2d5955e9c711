//! Edges that bound nothing: what is left over when only the faces count.
//!
//! ```text
//!   ┌──────┐          ┌──────┐
//!   │      ├── cut ───┤      ├──── dangle ──●        a dangle goes if free ends are taken away again and again;
//!   └──────┘          └──────┘                       a cut edge has the same face on both sides and joins parts
//!                                                    that would fall apart without it
//! ```
//!
//! Source: the names are those of JTS, class Polygonizer.

use crate::ids::{EdgeId, VertexId, VertexMap};
use crate::plane::Subdivision;

/// The edges of a subdivision with the same face on both sides, in increasing order. They are legal.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct DanglesAndCutEdges {
    /// Edges of trees that hang on something, or on nothing.
    pub dangles: Vec<EdgeId>,
    /// Edges that are no dangles and without which a component would fall apart.
    pub cut_edges: Vec<EdgeId>,
}

impl Subdivision {
    /// The edges that separate nothing. O(V + E).
    ///
    /// ```
    /// use dcel_kit::{EdgeId, plane::{Point, Subdivision}};
    /// let side = |a: (f64, f64), b: (f64, f64)| [Point::from(a), Point::from(b)];
    /// let flag = [side((0., 0.), (0., 3.)), side((0., 3.), (2., 2.)), side((2., 2.), (0., 2.)), side((0., 2.), (0., 3.))];
    /// let pole = Subdivision::from_segments(&[side((0., 0.), (0., 2.)), flag[1], flag[2], flag[3]])?;
    /// assert_eq!(pole.dangles_and_cut_edges().dangles, [EdgeId::new(0)]);
    /// # Ok::<(), dcel_kit::plane::SegmentsError>(())
    /// ```
    #[must_use]
    pub fn dangles_and_cut_edges(&self) -> DanglesAndCutEdges {
        let mut degree: VertexMap<u32> = VertexMap::filled(self.dcel.vertex_bound(), 0);
        self.dcel.half_edges().for_each(|h| degree[self.dcel.origin(h)] += 1);
        let mut gone = vec![false; self.dcel.edge_bound()];
        let mut ends: Vec<VertexId> = self.dcel.vertices().filter(|&v| degree[v] == 1).collect();
        while let Some(v) = ends.pop() {
            let Some(last) = self.dcel.outgoing_half_edges(v).find(|h| !gone[h.edge().index()]) else { continue };
            gone[last.edge().index()] = true;
            let other = self.dcel.destination(last);
            degree[v] -= 1;
            degree[other] -= 1;
            if degree[other] == 1 {
                ends.push(other);
            }
        }
        let same_face = |e: EdgeId| {
            let [h, t] = e.half_edges();
            self.dcel.face(h) == self.dcel.face(t)
        };
        let (dangles, rest): (Vec<EdgeId>, Vec<EdgeId>) = self.dcel.edges().partition(|e| gone[e.index()]);
        DanglesAndCutEdges { dangles, cut_edges: rest.into_iter().filter(|&e| same_face(e)).collect() }
    }
}
