//! The pointers of a placed structure as groups of arrows, one class for each family.
//!
//! ```text
//!   <g class="ptr next" id="FIG-h5-next"> title "h5.next = h8", line "pl", heads "ph" </g>
//! ```

use crate::figure::canvas::scene::{Group, Node};
use crate::figure::layout::crowd::{Crowd, Shape};
use crate::figure::structure::arrows::{self, Arrow, Turn};
use crate::figure::structure::face_arrows::{self, Tagged};
use crate::figure::structure::look::Look;
use crate::figure::structure::notes::Notes;
use crate::figure::structure::plate::Plate;
use crate::figure::structure::skeleton::{faces, half_edges, mutual_twin, vertices};
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use crate::plane::PlanarView;
use crate::topology::has;

crate::named! {
    /// A kind of pointer. `prev` is none of them: it is `next` read backwards.
    #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
    #[non_exhaustive]
    pub enum Pointers {
        /// From every half-edge to the one after it along its face.
        Next = "next",
        /// Between the two halves of every edge.
        Twin = "twin",
        /// From every vertex to the half-edge it knows.
        Outgoing = "outgoing",
        /// From every face to the half-edge it knows.
        Boundary = "boundary",
        /// From every half-edge to its face.
        Face = "face-of",
    }

    /// The class of their arrows, and what ids of arrows end with.
    fn class;
    /// All of them, in the order of a lesson.
    const ALL;
}

/// One pointer, by the element that stores it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Pointer {
    Next(HalfEdgeId),
    Twin(HalfEdgeId),
    Outgoing(VertexId),
    Boundary(FaceId),
    Face(HalfEdgeId),
    /// No family of its own: every shaft begins beside its origin.
    Origin(HalfEdgeId),
}

impl Pointer {
    /// The classes of the group; the id of the group ends with the second.
    const fn classes(self) -> &'static str {
        match self {
            Self::Next(_) => "ptr next",
            Self::Twin(_) => "ptr twin",
            Self::Outgoing(_) => "ptr outgoing",
            Self::Boundary(_) => "ptr boundary",
            Self::Face(_) => "ptr face-of",
            Self::Origin(_) => "ptr origin",
        }
    }

    /// What stores it, its name, and what it says: `h5`, `next`, `h8`.
    fn words<W: PlanarView + ?Sized>(self, view: &W) -> (Element, &'static str, Option<Element>) {
        match self {
            Self::Next(h) => (h.into(), "next", view.next(h).map(Element::from)),
            Self::Twin(h) => (h.into(), "twin", view.twin(h).map(Element::from)),
            Self::Outgoing(v) => (v.into(), "outgoing", view.outgoing(v).map(Element::from)),
            Self::Boundary(f) => (f.into(), "boundary", view.half_edge(f).map(Element::from)),
            Self::Face(h) => (h.into(), "face", view.face(h).map(Element::from)),
            Self::Origin(h) => (h.into(), "origin", view.origin(h).map(Element::from)),
        }
    }
}

impl<V: PlanarView + ?Sized> Plate<'_, V> {
    /// All pointers of a family, as `view` has them; of two twins that agree, one arrow.
    pub(crate) fn family<W: PlanarView + ?Sized>(view: &W, family: Pointers) -> Vec<Pointer> {
        match family {
            Pointers::Next => half_edges(view).map(Pointer::Next).collect(),
            Pointers::Twin => {
                let first = |t: HalfEdgeId, h: HalfEdgeId| h < t || !view.has_half_edge(t);
                let once = half_edges(view).filter(|&h| mutual_twin(view, h).is_none_or(|t| first(t, h)));
                once.map(Pointer::Twin).collect()
            }
            Pointers::Outgoing => vertices(view).map(Pointer::Outgoing).collect(),
            Pointers::Boundary => faces(view).map(Pointer::Boundary).collect(),
            Pointers::Face => half_edges(view).map(Pointer::Face).collect(),
        }
    }

    /// One group for each pointer that is set and has room for an arrow; those without room are noted. `t` is
    /// where along the edge twin arrows stand: 0.5, or 0.36 beside face arrows.
    pub(crate) fn pointers<W: PlanarView + ?Sized>(
        &self,
        view: &W,
        pointers: &[Pointer],
        look: &Look,
        t: f64,
        notes: &mut Notes,
    ) -> Vec<Node> {
        let mut crowd = self.crowd.clone();
        let mut out = Vec::new();
        let (mut without, mut outside) = (Vec::new(), Vec::new());
        for &pointer in pointers {
            let (owner, field, Some(target)) = pointer.words(view) else { continue };
            let Some(Tagged { arrow, tag }) = self.arrow(view, pointer, t, &mut crowd) else {
                let list = if has(view, target) { &mut without } else { &mut outside };
                list.push(format!("{owner}.{field}"));
                continue;
            };
            let class = pointer.classes();
            let ending = class.trim_start_matches("ptr ");
            let mut nodes = arrow.nodes("pl", "ph").to_vec();
            nodes.extend(tag.iter().flat_map(|tag| tag.nodes("tag")));
            out.push(Node::Group(Group {
                class,
                id: Some(format!("{}-{ending}", look.name(&owner.to_string()))),
                title: Some(format!("{owner}.{field} = {target}")),
                nodes,
                ..Group::default()
            }));
        }
        notes.add_words("without room for an arrow", &mut without.into_iter());
        notes.add_words("leading to what is not drawn", &mut outside.into_iter());
        out
    }

    /// The arrow of one pointer, added to the crowd if it may not be crossed.
    pub(crate) fn arrow<W: PlanarView + ?Sized>(
        &self,
        view: &W,
        pointer: Pointer,
        t: f64,
        crowd: &mut Crowd,
    ) -> Option<Tagged> {
        match pointer {
            Pointer::Next(h) => self.next_arrow(view, h).map(Tagged::plain),
            Pointer::Twin(h) => {
                let twin = view.twin(h).filter(|&t| t != h)?;
                let agree = mutual_twin(view, h).is_some();
                arrows::twin(self.shaft(h)?, self.shaft(twin)?, agree, t).map(Tagged::plain)
            }
            Pointer::Outgoing(v) => self.outgoing_arrow(view, v).map(Tagged::plain),
            Pointer::Origin(h) => {
                let v = view.origin(h)?;
                arrows::origin(self.shaft(h)?, self.skeleton().place(v)?, *self.radii.get(v)?).map(Tagged::plain)
            }
            Pointer::Boundary(f) => {
                let shaft = self.shaft(view.half_edge(f)?)?;
                let outer = (view.outer_face() == Some(f)).then_some(self.picture.fit.size);
                face_arrows::boundary(f, self.label_of_face(f), shaft, outer, crowd)
            }
            Pointer::Face(h) => {
                let f = view.face(h)?;
                face_arrows::face(f, self.label_of_face(f), self.shaft(h)?, crowd)
            }
        }
    }

    /// Marks the places of arrows as taken.
    pub(crate) fn block<W: PlanarView + ?Sized>(&self, view: &W, pointers: &[Pointer], t: f64, crowd: &mut Crowd) {
        for &pointer in pointers {
            let shapes = self.arrow(view, pointer, t, crowd).map(|tagged| tagged.arrow.shapes());
            crowd.add_all(shapes.into_iter().flatten(), u32::MAX);
        }
    }

    fn shaft(&self, h: HalfEdgeId) -> Option<&crate::figure::structure::half_edges::Shaft> {
        self.shafts.get(h)?.as_ref()
    }

    /// From the tip of `h` to the tail of its next.
    pub(crate) fn next_arrow<W: PlanarView + ?Sized>(&self, view: &W, h: HalfEdgeId) -> Option<Arrow> {
        let next = view.next(h)?;
        let skeleton = self.skeleton();
        let ([_, end], [start, _]) = (skeleton.ends(h)?, skeleton.ends(next)?);
        let back = mutual_twin(view, h) == Some(next);
        let turn = (end == start).then(|| Some(Turn { at: skeleton.place(end)?, radius: self.radii[end], back }));
        Some(arrows::next(self.shaft(h)?, self.shaft(next)?, turn.flatten()))
    }

    fn outgoing_arrow<W: PlanarView + ?Sized>(&self, view: &W, v: VertexId) -> Option<Arrow> {
        let shaft = self.shaft(view.outgoing(v)?)?;
        arrows::outgoing(self.skeleton().place(v)?, *self.radii.get(v)?, shaft)
    }

    /// The next and outgoing arrows of the placed view, for labels to keep clear of.
    pub(crate) fn local_ink(&self) -> Vec<Shape> {
        let view = self.picture.view;
        let next = half_edges(view).filter_map(|h| self.next_arrow(view, h));
        let outgoing = vertices(view).filter_map(|v| self.outgoing_arrow(view, v));
        next.chain(outgoing).flat_map(|arrow| arrow.shapes()).collect()
    }
}
