//! Comparing two drawings of half-edge structures by what they mean.
//!
//! ```text
//!   reference.svg ─┐  0 well-formed   1 same bytes?   2 same declared structure?   3 same drawn geometry?
//!   student.svg ───┴─ markup.rs       equal           declared.rs  tables.rs       drawing/  painting.rs
//!                                                     links.rs  faces.rs           sketch.rs  eye/  drawn.rs
//!                     4 where no point fits: the right shape in the wrong place?   shape.rs
//!                     answer: answer.rs (report.rs), and a picture of the differences: diff.rs
//! ```
//!
//! ```text
//!   along.rs       Where lines and barbs lie along an edge
//!   animations.rs  Elements that change something after a moment
//!   areas.rs       Layer 3, faces
//!   arrows.rs      How half-edges are drawn
//!   beside.rs      What is drawn beside a structure and is no part of it
//!   cells.rs       Where coats lie
//!   colour.rs      Colours as CSS writes them
//!   dashes.rs      How much of a line its dashes draw
//!   declarations.rs  What is said of an element
//!   diff_style.rs  The style of the picture of differences
//!   ends.rs        Where lines end
//!   error.rs       Why a file cannot be compared, and where
//!   exchanged.rs   Vertices at each other's places
//!   filling.rs     What is seen of faces and holes
//!   frame.rs       From the student's canvas to the coordinates of the reference
//!   geometry.rs    Geometry that a style says
//!   graph.rs       Vertices and edges of two drawings
//!   halves.rs      Half-edges that are declared and drawn
//!   ink.rs         What can be seen
//!   labels.rs      Letters as outlines, and boxes round letters
//!   legends.rs     Legends within the box of a drawing
//!   legible.rs     Whether letters can be read
//!   letters.rs     How large letters are
//!   markers.rs     Which markers a line carries
//!   names.rs       Names drawn beside what they name
//!   numbers.rs     Lists of numbers in attributes
//!   pairing.rs     Which point is which
//!   path.rs        Path data as polylines
//!   placed.rs      A declared structure with its vertices and edges by place
//!   retraced.rs    Lines and circles where decoration lies
//!   rings.rs       Closed outlines as cyclic sequences of points, in a form in which equal ones are equal
//!   segments.rs    Lines cut at the points they pass, by a grid over the points
//!   served.rs      What url(#...) paints
//!   servers.rs     Gradients and patterns
//!   snap.rs        Points by place, each with a number
//!   sparse.rs      Lines that dashes leave out in part, or nearly whole
//!   spelling.rs    What a text says that stands at an element
//!   spots.rs       Where elements lie
//!   standing.rs    Where names stand
//!   strangers.rs   Faces without a partner, counted
//!   strokes.rs     Whether lines of half-edges are seen
//!   surplus.rs     Names too many
//!   tags.rs        Elements as rules see them
//!   tiles.rs       How much of its tile a pattern paints
//!   transform.rs   Transforms
//!   valid.rs       Values that browsers drop
//!   values.rs      Values that browsers work out and a comparison does not
//!   viewport.rs    Viewports
//!   windows.rs     Holes in faces that the reference fills
//!   yours.rs       What was handed in, drawn small beside the differences
//! ```
#![doc = include_str!("../../figures/difference.svg")]
//!
//! **0** Both files are XML within limits (8 MiB, 200,000 elements), without declarations and scripts, all numbers
//! finite; errors name line and column. **1** Equal bytes are equal. **2** If both files declare their structure in
//! `data-*` attributes, all invariants are checked, vertices are matched by place, half-edges by their ends, and every
//! pointer is compared through that map: numbers may differ, and which of its half-edges a vertex or a face names.
//! **3** What is drawn is always compared, and must be what is declared, and can be seen: colours are worked out at
//! points along every edge, in every circle and face. **4** If hardly a point lies where it should, connections are
//! compared without places. Pixels are never compared: a test of the pixels passes drawings that are wrong and fails
//! drawings that are right.
//!
//! # What a program has to write
//!
//! | drawn | by |
//! |---|---|
//! | edge | `line`, `polyline`, `polygon`, `rect`, or `path`, with a `stroke`; a line through several vertices is several edges; twice is no fault; an end within or at the rim of a circle to whose middle the line points is at that vertex; a thin filled rectangle from vertex to vertex is a line, too, and so is an arrow from vertex to vertex that is one slender filled outline, the same on both sides; a head of two strokes, or a small triangle, with its tip at a vertex is a marker |
//! | vertex | `circle`, `ellipse` or a closed `path` that is one, filled or with a stroke; a line of no length with round ends; at the end of a line a small square or cross, or a small box at whose rim lines end that point to its middle (at a square also at the circle through its corners), a small triangle, star or polygon at whose corners nothing else ends, or a circle that a marker draws; a stamp that looks like these is one wherever it stands, and so is a square of the colour of the circles, about as large |
//! | face | `polygon`, `path` or `rect`, filled with a colour, a gradient or a pattern: the corners of a bounded face, counter-clockwise as seen; hole faces of a declared structure, and what the fill rule of the reference leaves empty in a face, may be left as paper or filled, which is noted, but no other hole; a hole may be a second outline in the path or be reached over a bridge (a keyhole); further corners on its straight sides are no fault |
//! | half-edge | where one is declared: a straight line on the left of its edge with a head: a filled one, a marker, strokes that meet, straight or bent, or all of it as one filled outline; twice is no fault |
//!
//! Groups, `use`, `symbol`, `switch`, inner `svg` with `viewBox`, `transform`, clip paths, units (`mm`, `pt`, ...),
//! curves and arcs that are straight (but for 0.05 px of a canvas of 600 px), `style` attributes and style sheets (names, `*`,
//! ids, classes, attributes, `:not`, descendants, children, `@media screen` and `<style media="print">`, strings) are
//! understood, and a `DOCTYPE` that declares nothing. A style also says where a circle, an ellipse, a rectangle or a
//! picture lies and how large it is (`cx`, `r`, `width`, ...), and the `d` of a path; a background of the root is its
//! paper. Passed over: texts and markers of ordinary size, labels in a `foreignObject`, curves, what is not displayed,
//! an area round everything (paper) with the lines along its border, a rectangle round everything, filled or not, sharp
//! or with round corners (in a reference: if vertices are circles there, and it has none), and the ticks beyond it,
//! what is called legend or axis and stands clear of the structure, what lies behind axes of matplotlib, their spines
//! and ticks, a legend in a free corner of it, without a box, or with one that lets edges shine through (one whose box
//! hides something is told as that), small areas that touch no vertex (letters), rims of letters, white lines along their sides and boxes round them,
//! animations of what is not read, and anything else with a note. A filled outline clear of the structure is no letter:
//! it is a face too many. In the kit's own figures (`data-figure` on the root) half-edges, pointers, tables, insets
//! (but not `--plain` ones, which say no more what they are) and other decoration are passed over, too, but the
//! half-edges that are declared there have to be seen: each line on the left of its edge, about as far as others, with
//! a barb behind its tip at the end of that line (that of a marker may stand in its middle), on the side of its face or
//! on both sides, none that points back, and not much shorter than the reference draws it: three quarters of that, or as
//! near to the vertices. Vertices that are drawn at each other's places are named. A line that lies where decoration is
//! drawn, in the same file or, with all circles at their places, in the reference, is no edge. y points down in SVG:
//! write `height - y`. A face that a reference drawn by another program lists clockwise may run either way.
//!
//! Refused, with the place in the file, is what may hide or move something and cannot be told: a rule of which it is
//! not understood what it fits or whether it applies (`@supports`, `@media (min-width: ...)`), an animation of
//! anything that is read, a box in a `foreignObject` that may reach anywhere, and properties that move an element
//! otherwise than by `transform`; values that browsers work out and a comparison does not (`var(...)`, `calc(...)`,
//! `color-mix(...)`, widths in `em`), but for `var(...)` as the size of letters, style sheets outside of the file, and
//! an edge or a vertex behind a mask or a filter. A value that browsers drop, as `stroke: blackish`, is as if it were
//! not written.
//!
//! # What has to be seen
//!
//! An edge is seen if its lines have another colour than the paper and than what lies on both sides, nearly all along;
//! what crosses it, as letters do, may hide stretches of up to a twentieth of the drawing, but no plain polygon without
//! letters in it that is larger than a letter: a side of a thirtieth of the drawing; the small box of a label with
//! letters in it may hide a longer one in its middle, in all up to 45 parts of 100; dashes as usual leave gaps: but no gap
//! of more than 24 px that is a third of the edge, or a quarter at its end. An edge that the reference does not have is
//! told if more than a tenth of it is seen between the circles at its ends, or one of its dashes if these draw hardly
//! anything of it. A vertex is seen if its circle is, and
//! reaches no other vertex; it hides no more than half of an edge; its radius is not less than 0.1 px, and it reaches
//! beyond the lines there or has clearly another colour. A face is seen if it has another colour than the paper. A thin
//! line of decoration hides nothing of a half-edge that it crosses if it is seen itself; one that runs along it, in
//! another colour, hides it if no rim of it shows. So what is covered by an area, a circle, a picture or a line, cut
//! off by a clip path or the `viewBox`, left out by dashes, without a size, filled twice under `evenodd`, transparent,
//! painted by a gradient that is not there, below large letters or markers or letters that have the colour of what lies
//! round them is told, with the reason. So is a line of less than 0.1 px, of which a screen shows a tenth of the ink,
//! on a drawing of its own size, but at least 600 px, or 1200 px if it has no size; one narrower than a px is as pale
//! as a screen shows it. Of lines over each other it is enough that one shows: they may be cased or double. What the
//! reference's own drawing hides nobody has to show. Colours themselves are not compared.
//!
//! With [`Options::names`], every name that the reference shows has to be drawn: by a number (`v0`, `v_0`, `v₀`), the name
//! of a face, or both of them (`f1 Garden`); another text stands for none. It stands in the group of what it names or
//! loose, at a vertex no further from its disc than four heights of letters or a tenth of the shortest edge there, or at
//! the end of a line that leads from it. A name is seen if its letters have clearly another colour than what lies below
//! them and than their own halo (a rim of a fifth of their size or more), less than half of them is covered, no other text
//! is written at their place, and they are at least 4 px high on that same drawing, and not squeezed below that by a
//! `textLength`: the smallest ones of the kit are 7.2 px, 4.5 px where a figure of 640 px is shown 400 px wide, and
//! below 4 px digits cannot be told apart. A text that is as a whole the name of something else in the structure, or a
//! name that is drawn already, is a name too many if it stands in the group of something that is declared, or within
//! the structure or no more than four heights of letters beside it; not in tables, insets, legends, titles, captions
//! and notes (by `class` or `id`), and not where it is a copy of the name below it.
//!
//! A drawing may be scaled and shifted, not mirrored, turned or stretched, be it by `preserveAspectRatio="none"`. A
//! point is where it should be if it is within 0.05 px of its place on a drawing of 600 px ([`Options::tolerance`]); a
//! larger tolerance also lets lines end farther from rims and tips of arrows, and a smaller one lets them point less far
//! aside of the middles of vertices.
//! The outer face may be filled, or not, as long as it hides nothing. A root without width or height shows nothing.
//!
//! ```text
//!   <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 600 400">
//!   <polygon points="62,338 538,338 538,62" fill="#e8f0ff"/>
//!   <line x1="62" y1="338" x2="538" y2="338" stroke="black"/>
//!   <circle cx="62" cy="338" r="4"/>
//!   </svg>
//! ```

mod along;
mod animations;
mod answer;
mod areas;
mod arrows;
mod beside;
mod cells;
mod colour;
mod dashes;
mod declarations;
mod declared;
mod diff;
mod diff_style;
mod drawing;
mod drawn;
mod ends;
mod error;
mod exchanged;
mod eye;
mod faces;
mod filling;
mod frame;
mod geometry;
mod graph;
mod halves;
mod ink;
mod labels;
mod legends;
mod legible;
mod letters;
mod links;
mod markers;
mod markup;
mod names;
mod numbers;
mod painting;
mod pairing;
mod path;
mod placed;
mod report;
mod retraced;
mod rings;
mod segments;
mod served;
mod servers;
mod shape;
mod sketch;
mod snap;
mod sparse;
mod spelling;
mod spots;
mod standing;
mod strangers;
mod strokes;
mod surplus;
mod tables;
mod tags;
mod tiles;
mod transform;
mod valid;
mod values;
mod viewport;
mod windows;
mod yours;

pub use answer::Comparison;
pub use error::{CompareError, Problem, Side};
pub use report::{Difference, Kind, Layer};

use crate::figure::{Figure, FigureError, FigureOptions};
use crate::plane::Subdivision;
use crate::topology::Table;
use answer::Scenery;
use drawing::Drawing;
use drawn::{Seen, Target};
use error::Fault;
use placed::Placed;
use sketch::Sketch;
use std::collections::BTreeSet;

/// Pairs of differences looked at to tell each thing once.
const TOLD: usize = 5_000_000;

/// What a comparison asks for.
#[derive(Clone, Debug)]
pub struct Options {
    names: bool,
    tolerance: f64,
    faces: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { names: false, tolerance: 0.05, faces: true }
    }
}

impl Options {
    /// Structure, places and faces, but no names.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Whether the numbers of vertices, half-edges and faces, and the names of faces, must be the same, too, and the
    /// names that the reference draws must be drawn where they belong, so that they can be read, and nowhere else.
    /// Default: no. Needs files that declare their structure; others are refused.
    #[must_use]
    pub fn names(self, names: bool) -> Self {
        Self { names, ..self }
    }

    /// How far a drawn point may be from its place, in px of a drawing of 600 px. Default: 0.05. Values that are no
    /// such length change nothing.
    #[must_use]
    pub fn tolerance(self, px: f64) -> Self {
        Self { tolerance: if px > 0.0 && px <= 100.0 { px } else { self.tolerance }, ..self }
    }

    /// The tolerance as a part of the drawing.
    fn part(&self) -> f64 {
        self.tolerance / drawn::CANVAS
    }

    /// Whether filled polygons are compared. Default: yes, if the reference has any.
    #[must_use]
    pub fn faces(self, faces: bool) -> Self {
        Self { faces, ..self }
    }
}

/// The text of an SVG file: UTF-8, with or without a byte order mark.
///
/// # Errors
/// [`Problem::Compressed`] and [`Problem::Encoding`].
pub fn text(bytes: &[u8], side: Side) -> Result<&str, CompareError> {
    markup::text(bytes).map_err(|fault| fault.located(side, ""))
}

/// Compares a student's drawing with the reference: see the [module](self).
///
/// The drawn geometry is always compared; the declared structure too if both files declare one. Nothing is
/// compared by pixels.
///
/// Cost: O(n log n); a drawing of a lab takes about a millisecond, 10^5 edges less than a second.
///
/// # Errors
/// [`CompareError`] if a file cannot be read, is too large, holds scripts, or draws nothing, or if the reference
/// contradicts itself.
///
/// ```
/// use dcel_kit::compare::{Options, compare};
/// let square = "<svg xmlns='http://www.w3.org/2000/svg'><path stroke='red' fill='none' d='M0 0H9V9H0Z'/></svg>";
/// let open = "<svg xmlns='http://www.w3.org/2000/svg'><path stroke='red' fill='none' d='M0 0H9V9H0'/></svg>";
/// let answer = compare(square, open, &Options::new())?;
/// assert_eq!(answer.differences()[0].text, "edge between (0, 0) and (0, 9) is missing");
/// assert!(compare(square, square, &Options::new())?.is_equal());
/// # Ok::<(), dcel_kit::compare::CompareError>(())
/// ```
pub fn compare(reference: &str, student: &str, options: &Options) -> Result<Comparison, CompareError> {
    let same = reference == student;
    let [reference, student] = [reference, student].map(markup::without_mark);
    let at = |side: Side, text: &'_ str| {
        let text = text.to_owned();
        move |fault: Fault| fault.located(side, &text)
    };
    let expected = File::read(reference, options).map_err(at(Side::Reference, reference))?;
    expected.check_names(options).map_err(at(Side::Reference, reference))?;
    let target = expected.target(options).map_err(at(Side::Reference, reference))?;
    if same {
        return Ok(expected.answer(Layer::Bytes, &target, Vec::new(), Vec::new(), String::new(), None));
    }
    let found = File::read(student, options).map_err(at(Side::Student, student))?;
    found.check_names(options).map_err(at(Side::Student, student))?;
    expected.compare(&target, &found, options).map_err(at(Side::Student, student))
}

/// A file that has been read.
struct File {
    table: Option<Table>,
    drawing: Drawing,
}

impl File {
    fn read(text: &str, options: &Options) -> Result<Self, Fault> {
        let document = markup::parse(text)?;
        Ok(Self { table: declared::read(&document)?, drawing: Drawing::read(&document, options.part())? })
    }

    /// Names can be compared of what is declared only.
    fn check_names(&self, options: &Options) -> Result<(), Fault> {
        if options.names && self.table.is_none() { Err(Problem::NoNames.into()) } else { Ok(()) }
    }

    /// This file as a reference: what it declares must be sound, and be what it draws.
    fn target(&self, options: &Options) -> Result<Target<'_>, Fault> {
        let Some(table) = &self.table else {
            return Target::of_drawing(&self.drawing, options);
        };
        let contradiction = |reason: String| Fault::from(Problem::Reference { reason });
        Subdivision::from_table(table).map_err(|error| contradiction(error.to_string()))?;
        let mut target = Target::of_table(&Placed::new(table), options)?;
        target.hint(&self.drawing);
        let own = target.compare(&self.drawing, options)?;
        match own.differences.first() {
            Some(first) => Err(contradiction(format!("it does not draw what it declares: {}", first.text))),
            None => {
                target.draws(&self.drawing);
                Ok(target)
            }
        }
    }

    fn compare(&self, target: &Target<'_>, found: &Self, options: &Options) -> Result<Comparison, Fault> {
        let mut notes = found.drawing.notes.clone();
        let mut seen = target.compare(&retraced::without_decoration(&self.drawing, &found.drawing), options)?;
        notes.append(&mut seen.notes);
        let placed = self.table.as_ref().zip(found.table.as_ref());
        let placed = placed.map(|(mine, theirs)| [mine, theirs].map(Placed::new));
        let tables = [self.table.as_ref(), found.table.as_ref()];
        let drawings = [&self.drawing, &found.drawing];
        seen.differences.extend(exchanged::compare(&found.drawing, placed.is_some()));
        seen.differences.extend(halves::compare(drawings, tables, placed.as_ref().map(<[_; 2]>::each_ref)));
        if let (true, Some([mine, theirs])) = (options.names, &placed) {
            seen.differences.extend(names::compare([(drawings[0], mine), (drawings[1], theirs)]));
        }
        let student = Some((std::mem::take(&mut seen.sketch), seen.fits));
        let Some([mine, theirs]) = &placed else {
            let mut differences = seen.differences;
            let table = found.table.as_ref();
            differences.extend(table.and_then(|table| contradiction(table, &found.drawing, options)));
            let layer = layer(&differences, Layer::Drawn);
            let agreed = agreed(seen.agreed, "edges");
            return Ok(self.answer(layer, target, differences, notes, agreed, student));
        };
        let declared = tables::compare(mine, theirs, options);
        notes.extend(declared.notes.iter().cloned());
        let edges = seen.agreed;
        let (layer, differences) = merged(declared.differences, seen, &mut notes);
        // What agrees is counted where the answer was found.
        let agreed = if layer == Layer::Drawn { agreed(edges, "edges") } else { agreed(declared.agreed, "half-edges") };
        Ok(self.answer(layer, target, differences, notes, agreed, student))
    }

    fn answer(
        &self,
        layer: Layer,
        target: &Target<'_>,
        differences: Vec<Difference>,
        notes: Vec<String>,
        agreed: String,
        student: Option<(Sketch, bool)>,
    ) -> Comparison {
        let graph = || Scenery::Graph(target.sketch.graph.clone());
        let scenery = self.table.as_ref().map_or_else(graph, |table| Scenery::Table(table.clone()));
        Comparison { layer, differences, notes, agreed, scenery, student }
    }
}

/// The layer of the first difference.
fn layer(differences: &[Difference], otherwise: Layer) -> Layer {
    differences.first().map_or(otherwise, |difference| difference.layer)
}

/// What both layers say, each thing once.
fn merged(declared: Vec<Difference>, seen: Seen, notes: &mut Vec<String>) -> (Layer, Vec<Difference>) {
    let deciding = match (declared.is_empty(), seen.differences.is_empty()) {
        (true, false) => {
            notes.push("what the file declares (data-*) agrees with the reference; what it draws does not".to_owned());
            layer(&seen.differences, Layer::Drawn)
        }
        (false, true) => {
            notes.push("what the file draws agrees with the reference; what it declares (data-*) does not".to_owned());
            layer(&declared, Layer::Declared)
        }
        _ => layer(&declared, Layer::Declared),
    };
    let more: Vec<Difference> = untold(&declared, seen.differences).collect();
    let mut differences = declared;
    differences.extend(more);
    differences.sort_by_key(|difference| difference.kind);
    (deciding, differences)
}

/// What of the second is not told by the first, perhaps in other words. Of very many only the words are compared.
fn untold(told: &[Difference], others: Vec<Difference>) -> impl Iterator<Item = Difference> + '_ {
    let texts: BTreeSet<&str> = told.iter().map(|difference| difference.text.as_str()).collect();
    let mut looked = 0;
    others.into_iter().filter(move |new| {
        looked += told.len();
        let is_told = texts.contains(new.text.as_str()) || looked <= TOLD && told.iter().any(|old| old.says(new));
        !is_told
    })
}

/// A file that declares one thing and draws another.
fn contradiction(table: &Table, drawing: &Drawing, options: &Options) -> Option<Difference> {
    let placed = Placed::new(table);
    let text = match Target::of_table(&placed, options) {
        Err(_) => "what the file declares (data-*) cannot be drawn: give every vertex data-x and data-y".to_owned(),
        Ok(target) => {
            let seen = target.compare(drawing, options).ok()?;
            format!("the file does not draw what it declares (data-*): {}", seen.differences.first()?.text)
        }
    };
    Some(Difference::new(Kind::Drawing, Layer::Declared, text, report::Spot::Nowhere))
}

/// Compares two structures with positions: `expected`, which must be a sound one, and `actual`, right or wrong.
/// Vertices are matched by place, everything else through them; numbers may differ. O(n log n).
#[must_use]
pub fn compare_tables(expected: &Table, actual: &Table, options: &Options) -> Comparison {
    let placed = Placed::new(actual);
    let found = tables::compare(&Placed::new(expected), &placed, options);
    Comparison {
        layer: Layer::Declared,
        differences: found.differences,
        notes: found.notes,
        agreed: agreed(found.agreed, "half-edges"),
        scenery: Scenery::Table(expected.clone()),
        student: Some((Sketch::of_table(&placed), true)),
    }
}

fn agreed((right, all): (usize, usize), what: &str) -> String {
    format!("{right} of {all} {what} agree")
}

/// The picture of what differs between two structures with positions: see [`Comparison::figure`].
///
/// # Errors
/// Those of [`structure`](crate::figure::structure()).
pub fn diff_figure(expected: &Table, actual: &Table, options: &FigureOptions) -> Result<Figure, FigureError> {
    compare_tables(expected, actual, &Options::default()).figure(options)
}
