//! What edits are made on.
//!
//! ```text
//!   Dcel           no coordinates: whatever is combinatorially legal       Journal
//!   Subdivision    x y, straight edges that do not cross                   PlaneJournal
//!   Polyhedron     x y z, a surface that may have borders                  SurfaceJournal
//! ```

use super::kind::{Parameter, Takes};
use super::row::{Apply, Row};
use crate::plane::{PlaneJournal, Subdivision};
#[cfg(feature = "solid")]
use crate::solid::{Polyhedron, SurfaceJournal};
use crate::topology::{Dcel, Journal};
use std::fmt;

/// How affine maps are written: `XY` is the share of y in the new x.
const PLANE_MAP: &str = " XX XY YX YY DX DY";
const SPACE_MAP: &str = " XX XY XZ YX YY YZ ZX ZY ZZ DX DY DZ";

/// A structure that has edits.
pub trait Editable: Clone + PartialEq + fmt::Debug + Sized + 'static {
    /// Keeps all changes of its edits.
    type Log: Default + Clone + fmt::Debug;

    /// How many coordinates a place has.
    const DIMENSION: usize;

    /// What it is called in messages: `the kernel`, `the plane`, `a surface in space`.
    const NAME: &'static str;

    /// How its elements hang together.
    fn topology(&self) -> &Dcel;

    /// How it makes the edit of a row, if it has it.
    fn column(row: &Row) -> Option<Apply<Self, Self::Log>>;

    /// Takes back all changes of a log. The structure is bit for bit what it was before.
    fn take_back(&mut self, log: &mut Self::Log);

    /// The changes of the pointers in a log.
    fn pointers(log: Self::Log) -> Journal;
}

impl Row {
    /// What a call takes on this structure: a map is as many numbers, and without coordinates there is no place.
    pub(crate) fn takes_on<S: Editable>(&self) -> impl Iterator<Item = Takes> {
        self.takes.iter().flat_map(|parameter| {
            let count = match parameter.takes {
                Takes::Place => usize::from(S::DIMENSION > 0),
                Takes::Map => S::DIMENSION * (S::DIMENSION + 1),
                _ => 1,
            };
            std::iter::repeat_n(parameter.takes, count)
        })
    }

    /// How it is written for this structure: `split_edge A X Y`.
    #[must_use]
    pub fn usage<S: Editable>(&self) -> String {
        let mut out = self.word.to_owned();
        for Parameter { name, takes } in self.takes {
            let name = name.to_uppercase();
            match takes {
                Takes::Element(_) | Takes::Number => out.push_str(&format!(" {name}")),
                // One place of several is known by its name.
                Takes::Place => ["X", "Y", "Z"][..S::DIMENSION].iter().for_each(|axis| match name.as_str() {
                    "AT" => out.push_str(&format!(" {axis}")),
                    _ => out.push_str(&format!(" {name}{axis}")),
                }),
                Takes::Map => out.push_str(if S::DIMENSION == 2 { PLANE_MAP } else { SPACE_MAP }),
                Takes::Switch => out.push_str(" yes|no"),
                Takes::Vertices => out.push_str(&format!(" {name} {name} ...")),
            }
        }
        out
    }
}

impl Editable for Dcel {
    type Log = Journal;
    const DIMENSION: usize = 0;
    const NAME: &'static str = "the kernel";

    fn topology(&self) -> &Dcel {
        self
    }

    fn column(row: &Row) -> Option<Apply<Self, Journal>> {
        row.kernel
    }

    fn take_back(&mut self, log: &mut Journal) {
        self.undo(log, 0);
    }

    fn pointers(log: Journal) -> Journal {
        log
    }
}

impl Editable for Subdivision {
    type Log = PlaneJournal;
    const DIMENSION: usize = 2;
    const NAME: &'static str = "the plane";

    fn topology(&self) -> &Dcel {
        Self::topology(self)
    }

    fn column(row: &Row) -> Option<Apply<Self, PlaneJournal>> {
        row.plane
    }

    fn take_back(&mut self, log: &mut PlaneJournal) {
        self.undo(log, 0);
    }

    fn pointers(log: PlaneJournal) -> Journal {
        log.into_kernel()
    }
}

#[cfg(feature = "solid")]
impl Editable for Polyhedron {
    type Log = SurfaceJournal;
    const DIMENSION: usize = 3;
    const NAME: &'static str = "a surface in space";

    fn topology(&self) -> &Dcel {
        Self::topology(self)
    }

    fn column(row: &Row) -> Option<Apply<Self, SurfaceJournal>> {
        row.solid
    }

    fn take_back(&mut self, log: &mut SurfaceJournal) {
        self.undo(log, 0);
    }

    fn pointers(log: SurfaceJournal) -> Journal {
        log.into_kernel()
    }
}
