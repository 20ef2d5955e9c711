//! What a script can be played on: a structure, and the calls it takes.
//!
//! ```text
//!   Script<Subdivision>    split_face split_in_half split_edge A X Y ...     positions, checked by geometry
//!   Script<Dcel>           split_face split_vertex  split_edge A     ...     whatever is combinatorially legal
//! ```

use super::edit::{Edit, EditError, EditKind, Returned};
use super::kernel::KernelEdit;
use crate::ids::Element;
use crate::plane::{Point, Subdivision};
use crate::topology::{Dcel, Recorder};
use std::fmt;

/// A structure on which scripts are played.
pub trait Ground: Clone + PartialEq + fmt::Debug {
    /// Its edits.
    type Edit: Call;

    /// How its elements hang together.
    fn topology(&self) -> &Dcel;

    /// Makes a call, watched by a recorder.
    ///
    /// # Errors
    /// Those of the operation; a refused call leaves everything bit for bit as it was.
    fn make(&mut self, edit: Self::Edit, rec: &mut impl Recorder) -> Result<Returned, EditError>;
}

/// A call of an edit, with its arguments resolved to ids.
pub trait Call: Copy + PartialEq + fmt::Debug + fmt::Display {
    /// All edits there are.
    const KINDS: &'static [EditKind];

    /// The call with these arguments; `None` if they do not fit.
    fn of(kind: EditKind, elements: &[Element], point: Option<Point>) -> Option<Self>;

    /// Which edit it is.
    fn kind(self) -> EditKind;

    /// The elements among its arguments.
    fn elements(self) -> Vec<Element>;

    /// The place among its arguments.
    fn point(self) -> Option<Point>;

    /// Writes it as a script says it, with ids.
    ///
    /// # Errors
    /// Those of the formatter.
    fn write_call(self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.kind().word())?;
        self.elements().iter().try_for_each(|element| write!(f, " {element}"))?;
        self.point().map_or(Ok(()), |p| write!(f, " {} {}", p.x, p.y))
    }
}

impl Ground for Subdivision {
    type Edit = Edit;

    fn topology(&self) -> &Dcel {
        Self::topology(self)
    }

    fn make(&mut self, edit: Edit, rec: &mut impl Recorder) -> Result<Returned, EditError> {
        edit.apply(self, rec)
    }
}

impl Ground for Dcel {
    type Edit = KernelEdit;

    fn topology(&self) -> &Dcel {
        self
    }

    fn make(&mut self, edit: KernelEdit, rec: &mut impl Recorder) -> Result<Returned, EditError> {
        Ok(edit.apply(self, rec)?)
    }
}
