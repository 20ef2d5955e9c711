//! An edit beside the same edit with a slip: an assignment that is forgotten, or that writes something else.
//!
//! ```text
//!   3 Insert the new half-edges …
//!   right                              with the slip
//!   h12.next = h8, h13.next = h2       left out: h13.next = h2
//!   ┌───────────────────┐              ┌───────────────────┐
//!   │                   │              │                   │    one canvas, one layout
//!   └───────────────────┘              └───────────────────┘
//!                                      at the end: the invariants that do not hold
//! ```

use super::draw::{Stage, union};
use super::frames::{Film, Frame};
use super::reel::Reel;
use super::sheet::{Caption, head_height, heading};
use super::sides;
use super::slip::Slip;
use crate::figure::canvas::scene::{Group, Node};
use crate::figure::canvas::vector::xy;
use crate::figure::layout::grid::GAP;
use crate::figure::{Figure, FigureError, FigureOptions};
use crate::ids::Element;
use crate::topology::{Change, Slot, has, violations};

/// So many invariants that do not hold are written out.
const MOST: usize = 2;

/// Why a slip cannot be shown.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SlipError {
    /// No edit of the film writes that pointer.
    #[error("no edit writes {}: written are {}", .slip.slot, listed(.written))]
    NotWritten {
        /// The slip.
        slip: Slip,
        /// What the edits write, in order.
        written: Vec<Slot>,
    },
    /// No edit writes all of the pointers.
    #[error("no edit writes both {} and {}: only one edit is shown", .first.slot, .second.slot)]
    Apart {
        /// The first slip.
        first: Slip,
        /// One that is not in the same edit as those before it.
        second: Slip,
    },
    /// The other target does not exist when the edit is over.
    #[error("{slip}: there is no such element after the edit")]
    NoTarget {
        /// The slip.
        slip: Slip,
    },
    /// What is written instead is what should be written.
    #[error("{slip} is what the edit writes")]
    NoSlip {
        /// The slip.
        slip: Slip,
    },
    /// There is no slip.
    #[error("there is no slip to show")]
    Empty,
    /// The film is one of a surface in space.
    #[error("slips are shown in the plane and without coordinates, not in space")]
    InSpace,
}

/// The pointers of a message.
fn listed(written: &[Slot]) -> String {
    let mut words: Vec<String> = Vec::new();
    for slot in written.iter().map(ToString::to_string) {
        if !words.contains(&slot) {
            words.push(slot);
        }
    }
    if words.is_empty() { "no pointers".to_owned() } else { words.join(", ") }
}

/// An edit beside the same edit with slips; made by [`Film::beside`].
#[derive(Clone, Debug)]
pub struct SlipFilm {
    /// The edit alone.
    film: Film,
    slips: Vec<Slip>,
}

impl Film {
    /// The first edit that writes all pointers of the slips, beside what it comes to with them: step by step, and at the end the
    /// invariants that do not hold. What follows the edit is not shown: on a structure that is broken, other edits have
    /// no meaning.
    ///
    /// ```
    /// use dcel_kit::figure::{Film, FigureOptions};
    /// use dcel_kit::script::Script;
    /// let script = Script::parse("rectangle\nsplit_face h2 h8\n", "example")?;
    /// let film = Film::of_script(&script).beside(&["h12.next".parse()?])?;
    /// let [right, wrong] = film.frames().pop().expect("a film has frames");
    /// assert!(right.marked.is_empty());
    /// assert_eq!(wrong.text, "R1: h12.next = none");
    /// assert!(film.strip(&FigureOptions::new("Slip"))?.to_svg().contains("id=\"slip-6b-h12\""));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`SlipError`] if no edit writes all of them, or what is written instead does not exist.
    pub fn beside(&self, slips: &[Slip]) -> Result<SlipFilm, SlipError> {
        #[cfg(feature = "solid")]
        if !self.solids.is_empty() {
            return Err(SlipError::InSpace);
        }
        let &first = slips.first().ok_or(SlipError::Empty)?;
        let edits = || 0..self.edit_count();
        let writes = |shot: usize, slip: &Slip| self.writes(shot).any(|(slot, _)| slot == slip.slot);
        if let Some(&slip) = slips.iter().find(|slip| !edits().any(|shot| writes(shot, slip))) {
            let written = edits().flat_map(|shot| self.writes(shot)).map(|(slot, _)| slot).collect();
            return Err(SlipError::NotWritten { slip, written });
        }
        let all = |count: usize| edits().find(|&shot| slips[..count].iter().all(|slip| writes(shot, slip)));
        let Some(shot) = all(slips.len()) else {
            let fitting = (1..slips.len()).take_while(|&count| all(count).is_some()).count();
            return Err(SlipError::Apart { first, second: slips[fitting] });
        };
        for &slip in slips {
            let Some(target) = slip.instead else { continue };
            if !has(&self.states[shot + 1], target) {
                return Err(SlipError::NoTarget { slip });
            }
            if self.writes(shot).filter(|(slot, _)| *slot == slip.slot).last() == Some((slip.slot, Some(target))) {
                return Err(SlipError::NoSlip { slip });
            }
        }
        Ok(SlipFilm { film: self.only(shot), slips: slips.to_vec() })
    }

    /// What an edit writes.
    fn writes(&self, shot: usize) -> impl Iterator<Item = (Slot, Option<Element>)> + '_ {
        self.journal(shot).changes().iter().filter_map(|change| match *change {
            Change::Write { slot, new, .. } => Some((slot, new)),
            _ => None,
        })
    }
}

impl SlipFilm {
    /// Each frame of the edit, right and with the slips.
    ///
    /// Cost: O(frames x size of the structure).
    #[must_use]
    pub fn frames(&self) -> Vec<[Frame; 2]> {
        let right = self.film.frames();
        let mut wrong = self.film.frames_with(&self.slips);
        for (frame, right) in wrong.iter_mut().zip(&right) {
            let slipped: Vec<(Slip, String)> =
                self.slips.iter().filter_map(|slip| Some((*slip, slip.in_step(&right.changes)?))).collect();
            if !slipped.is_empty() {
                frame.marked = slipped.iter().map(|(slip, _)| slip.slot.owner()).collect();
                frame.text = slipped.into_iter().map(|(_, words)| words).collect::<Vec<_>>().join("; ");
            }
        }
        if let Some(last) = wrong.last_mut() {
            let found = violations(&last.table);
            let mut words: Vec<String> = found.iter().take(MOST).map(ToString::to_string).collect();
            match found.len() {
                0 => words.push("every invariant holds all the same".to_owned()),
                count if count > MOST => words.push(format!("and {} more", count - MOST)),
                _ => {}
            }
            last.text = words.join(", ");
            last.marked = found.iter().filter_map(|violation| violation.elements.first().copied()).collect();
        }
        right.into_iter().zip(wrong).map(<[Frame; 2]>::from).collect()
    }

    /// All pairs of frames, one below the other. Ids read `FIG-3-h5` in the fourth frame, `FIG-3b-h5` beside it.
    ///
    /// # Errors
    /// Those of [`Film::strip`].
    pub fn strip(&self, options: &FigureOptions) -> Result<Figure, FigureError> {
        Ok(self.reel(options)?.sheet(&in_one_column(options), false))
    }

    /// One pair at a time, with links; see [`Film::stepper`].
    ///
    /// # Errors
    /// Those of [`Film::strip`].
    pub fn stepper(&self, options: &FigureOptions) -> Result<Figure, FigureError> {
        Ok(self.reel(options)?.sheet(&in_one_column(options), true))
    }

    /// A page that plays the pairs; see [`Film::page`].
    ///
    /// # Errors
    /// Those of [`Film::strip`].
    pub fn page(&self, options: &FigureOptions) -> Result<String, FigureError> {
        Ok(self.reel(options)?.page(&in_one_column(options)))
    }

    /// Each pair alone, all of one size.
    ///
    /// # Errors
    /// Those of [`Film::strip`].
    pub fn singles(&self, options: &FigureOptions) -> Result<Vec<Figure>, FigureError> {
        Ok(self.reel(options)?.singles(options))
    }

    /// The pairs, drawn.
    fn reel(&self, options: &FigureOptions) -> Result<Reel, FigureError> {
        let mut options = options.of_panels();
        options.crop = None;
        let roomy = self.film.with_room(&mut options)?.map(|film| Self { film, slips: self.slips.clone() });
        let this = roomy.as_ref().unwrap_or(self);
        let (placed, names) = this.film.placed();
        let options = &sides::labelled(&options, &names);
        let union = union(&placed);
        let mut stage = Stage::new(&this.film.states, &placed, &union, options)?;
        if roomy.is_some() {
            stage.leave_out_short();
        }
        let mut scene = stage.plates[0].picture.scene(Vec::new());
        scene.css.push_str(&sides::css(&options.style, &scene.prefix, &placed));
        let detail = stage.plates[0].picture.detail;

        let frames = this.frames();
        let beside = |[right, wrong]: &[Frame; 2]| -> [Caption; 2] {
            [("right".to_owned(), right.text.clone()), ("with the slip".to_owned(), wrong.text.clone())]
        };
        let below: Vec<Caption> = frames.iter().flat_map(beside).collect();
        let head = head_height(&below, scene.size.x);
        let panel = scene.size;
        scene.size = xy(2.0 * panel.x + GAP, head + panel.y);
        let drawings = frames.iter().enumerate().map(|(i, pair)| {
            let sides = pair.iter().zip(beside(pair)).zip(["", "b"]).zip([0.0, panel.x + GAP]);
            let sides = sides.map(|(((frame, caption), letter), x)| {
                let mut nodes = heading(&caption, panel.x);
                let drawing = stage.draw(frame, &format!("{i}{letter}"));
                nodes.push(Node::Group(Group { shift: Some(xy(0.0, head)), nodes: drawing, ..Group::default() }));
                Node::Group(Group { shift: Some(xy(x, 0.0)), nodes, ..Group::default() })
            });
            sides.collect()
        });
        let drawings = drawings.collect();
        let captions = frames.iter().map(|[frame, _]| (frame.heading.clone(), String::new())).collect();
        Ok(Reel { scene, captions, drawings, detail, notes: Vec::new() })
    }
}

/// One pair a row, unless the caller wants more.
fn in_one_column(options: &FigureOptions) -> FigureOptions {
    let mut options = options.checked();
    options.columns = options.columns.or(Some(1));
    options
}
