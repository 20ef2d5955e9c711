//! Judging the picture that a student's program draws: as it is seen; how it is written does not matter.

use super::fault::{Fault, FaultKind, answered};
use super::protocol::{Called, Case, CaseAnswer, Reply, Step};
use dcel_kit::compare::{Options, compare};
use dcel_kit::plane::Point;
use std::fmt::Write;

/// What is wrong with a picture, compared with a reference that has the coordinates which the handout asks for.
///
/// `reply` is the answer to a step `svg`, `step` the number of that step, `test` the graded test. A picture shows more
/// or less than the reference, in other places or colours: one fault for each difference.
#[must_use]
pub fn judge(test: &'static str, step: usize, reply: &Reply, reference: &str) -> Vec<Fault> {
    let fault = |kind: FaultKind, words: String| Fault::new(test, kind, step, ["picture", ""], words);
    let svg = match reply {
        Reply::Svg(svg) => svg,
        Reply::Called(Called { end, .. }) => {
            let kind = FaultKind::of_end(end).unwrap_or(FaultKind::Wrong);
            return vec![fault(kind, format!("the picture {}", end.words()))];
        }
        _ => return vec![fault(FaultKind::Wrong, "there is no picture".to_owned())],
    };
    match compare(reference, svg, &Options::new()) {
        Ok(comparison) => {
            let differences = comparison.differences().iter();
            differences.map(|difference| fault(FaultKind::Wrong, difference.text.clone())).collect()
        }
        Err(error) => vec![fault(FaultKind::Wrong, error.to_string())],
    }
}

/// What is wrong with the pictures that a case asks for, compared with a reference that is made if there are any.
pub fn judge_case(test: &'static str, case: &Case, answer: &CaseAnswer, reference: impl Fn() -> String) -> Vec<Fault> {
    let drawn = answered(case, answer).filter(|(_, step, _)| **step == Step::Svg);
    drawn.flat_map(|(step, _, reply)| judge(test, step, reply, &reference())).collect()
}

/// As [`judge_case`]; here what differs tells one mistake from another.
pub fn told_apart(test: &'static str, case: &Case, answer: &CaseAnswer, reference: impl Fn() -> String) -> Vec<Fault> {
    let faults = judge_case(test, case, answer, reference).into_iter();
    faults.map(|fault| Fault { tag: fault.words.clone(), ..fault }).collect()
}

/// A plain drawing to compare with. Its y points up.
pub struct Plain(String);

impl Plain {
    /// An empty one that shows this part of the plane: left, top (with y pointing down), width and height.
    #[must_use]
    pub fn new(part: &str) -> Self {
        Self(format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{part}\">\n"))
    }

    /// A face by its corners.
    pub fn face(&mut self, corners: impl IntoIterator<Item: Into<Point>>) {
        self.polygon(corners, "fill=\"#dddddd\"");
    }

    /// A closed line without a face.
    pub fn ring(&mut self, corners: impl IntoIterator<Item: Into<Point>>) {
        self.polygon(corners, "fill=\"none\" stroke=\"#3a86c8\"");
    }

    fn polygon(&mut self, corners: impl IntoIterator<Item: Into<Point>>, look: &str) {
        let corner = |Point { x, y }| format!("{x},{}", 0.0 - y);
        let corners: Vec<String> = corners.into_iter().map(Into::into).map(corner).collect();
        let _ = writeln!(self.0, "<polygon points=\"{}\" {look}/>", corners.join(" "));
    }

    /// An edge by its ends.
    pub fn edge(&mut self, from: impl Into<Point>, to: impl Into<Point>) {
        self.line(from.into(), to.into(), "");
    }

    /// An edge that is seen on both sides of another line that crosses or touches it.
    pub fn wide_edge(&mut self, from: impl Into<Point>, to: impl Into<Point>) {
        self.line(from.into(), to.into(), " stroke-width=\"2\"");
    }

    fn line(&mut self, Point { x: x1, y: y1 }: Point, Point { x: x2, y: y2 }: Point, width: &str) {
        let (y1, y2) = (0.0 - y1, 0.0 - y2);
        let _ = writeln!(self.0, "<line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\" stroke=\"#000000\"{width}/>");
    }

    /// A vertex.
    pub fn vertex(&mut self, at: impl Into<Point>) {
        let Point { x, y } = at.into();
        let _ = writeln!(self.0, "<circle cx=\"{x}\" cy=\"{}\" r=\"4\"/>", 0.0 - y);
    }

    /// The drawing.
    #[must_use]
    pub fn svg(self) -> String {
        self.0 + "</svg>\n"
    }
}

/// Fails if a figure of the handouts shows anything else than a picture.
#[cfg(test)]
pub fn assert_shown(figure: &str, picture: &str) {
    let file = format!("{}/../../figures/{figure}", env!("CARGO_MANIFEST_DIR"));
    let figure = std::fs::read_to_string(file).unwrap();
    let comparison = compare(picture, &figure, &Options::new()).unwrap();
    assert_eq!(comparison.differences().len(), 0, "{:?}", comparison.differences());
}
