//! Path data as polylines.
//!
//! ```text
//!   M0,0 10,0 V10 Q5,5 0,10 Z      (0,0) ── (10,0) ── (10,10) ~~ ... ~~ (0,10) ── back     ~~ is a piece of a curve
//! ```
//!
//! Curves become short pieces: an edge of a half-edge structure is never a curve, but a vertex can be a small round
//! one, and an area with curved sides can hide what lies below it. What programs write as a curve and is straight, is a
//! line: a curve whose control points lie on its chord, but for rounded numbers, and an arc without a radius or with one
//! so large that it rises no more.

use super::numbers::Reader;

/// Pieces of a Bézier curve.
const PIECES: u32 = 8;
/// Pieces of half a turn of an arc.
const TURN: f64 = 12.0;
/// How far from its chord a control point of a straight curve may lie, as a part of the chord.
const STRAIGHT: f64 = 2e-4;
/// The same, as far as rounded numbers excuse it.
const BENT: f64 = 0.01;
/// An arc over a chord longer than this part of its diameter is round.
const FLAT: f64 = 0.5;

/// A stretch of a path from one move to the next.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Subpath {
    /// The points, with whether a curve leads to them.
    pub(super) points: Vec<([f64; 2], bool)>,
    /// Whether it ends with Z.
    pub(super) closed: bool,
}

/// The stretches of a path; what could not be read, if anything.
pub(super) fn read(data: &str) -> Result<Vec<Subpath>, &str> {
    read_within(data, 0.0)
}

/// The same; a curve is a line, too, if its control points lie no farther from its chord than `slack`, and no farther
/// than a hundredth of the chord.
pub(super) fn read_within(data: &str, slack: f64) -> Result<Vec<Subpath>, &str> {
    let mut reader = Reader::new(data);
    let mut pen = Pen { slack, ..Pen::default() };
    let mut command = None;
    while !reader.at_end() {
        let rest = reader.rest();
        let (letter, is_new) = match reader.letter() {
            Some(letter) => (letter, true),
            None => (command.ok_or(rest)?, false),
        };
        if pen.out.is_empty() && !letter.eq_ignore_ascii_case(&b'M') {
            return Err(rest);
        }
        // After Z nothing can be repeated; after M come lines.
        command = match letter {
            b'M' => Some(b'L'),
            b'm' => Some(b'l'),
            b'Z' | b'z' => None,
            other => Some(other),
        };
        let letter = if is_new { letter } else { command.unwrap_or(letter) };
        pen.draw(letter, &mut reader).ok_or(rest)?;
    }
    Ok(pen.out)
}

#[derive(Default)]
struct Pen {
    out: Vec<Subpath>,
    at: [f64; 2],
    start: [f64; 2],
    /// The last control point of a cubic and of a quadratic curve, which S and T mirror.
    cubic: Option<[f64; 2]>,
    quadratic: Option<[f64; 2]>,
    /// How far from its chord a control point of a straight curve may lie at least.
    slack: f64,
}

impl Pen {
    fn draw(&mut self, letter: u8, reader: &mut Reader<'_>) -> Option<()> {
        let [x, y] = if letter.is_ascii_lowercase() { self.at } else { [0.0; 2] };
        let pair = |reader: &mut Reader<'_>| reader.pair().map(|p| [p[0] + x, p[1] + y]);
        let mirrored =
            |control: Option<[f64; 2]>, at: [f64; 2]| control.map_or(at, |c| [2.0 * at[0] - c[0], 2.0 * at[1] - c[1]]);
        let (cubic, quadratic) = (self.cubic.take(), self.quadratic.take());
        let at = self.at;
        match letter.to_ascii_uppercase() {
            b'M' => {
                self.at = pair(reader)?;
                self.start = self.at;
                self.out.push(Subpath { points: vec![(self.at, false)], closed: false });
                Some(())
            }
            b'Z' => {
                self.at = self.start;
                self.out.last_mut()?.closed = true;
                Some(())
            }
            b'L' => self.to(pair(reader)?, false),
            b'H' => self.to([reader.number()? + x, at[1]], false),
            b'V' => self.to([at[0], reader.number()? + y], false),
            b'T' => self.quadratic(mirrored(quadratic, at), pair(reader)?),
            b'Q' => {
                let (control, to) = (pair(reader)?, pair(reader)?);
                if is_straight(at, [control, control], to, self.slack) {
                    self.to(to, false)?;
                    self.quadratic = Some(control);
                    Some(())
                } else {
                    self.quadratic(control, to)
                }
            }
            b'S' => self.cubic(mirrored(cubic, at), pair(reader)?, pair(reader)?),
            b'C' => self.cubic(pair(reader)?, pair(reader)?, pair(reader)?),
            b'A' => {
                let radii = reader.pair()?;
                let degrees = reader.number()?;
                let (large, sweep) = (reader.flag()?, reader.flag()?);
                self.arc(radii, degrees, large, sweep, pair(reader)?)
            }
            _ => None,
        }
    }

    fn to(&mut self, to: [f64; 2], curved: bool) -> Option<()> {
        let open = self.out.last_mut()?;
        if open.closed {
            // A command after Z goes on from the start of the stretch that was closed.
            self.out.push(Subpath { points: vec![(self.at, false), (to, curved)], closed: false });
        } else {
            open.points.push((to, curved));
        }
        self.at = to;
        Some(())
    }

    fn quadratic(&mut self, control: [f64; 2], to: [f64; 2]) -> Option<()> {
        let towards = |end: [f64; 2]| [0, 1].map(|i| end[i] + 2.0 / 3.0 * (control[i] - end[i]));
        let (first, second) = (towards(self.at), towards(to));
        self.pieces(first, second, to)?;
        (self.cubic, self.quadratic) = (None, Some(control));
        Some(())
    }

    /// A curve, or a line if its control points say so.
    fn cubic(&mut self, first: [f64; 2], second: [f64; 2], to: [f64; 2]) -> Option<()> {
        if is_straight(self.at, [first, second], to, self.slack) {
            self.to(to, false)?;
        } else {
            self.pieces(first, second, to)?;
        }
        self.cubic = Some(second);
        Some(())
    }

    fn pieces(&mut self, first: [f64; 2], second: [f64; 2], to: [f64; 2]) -> Option<()> {
        let from = self.at;
        for i in 1..PIECES {
            let t = f64::from(i) / f64::from(PIECES);
            let u = 1.0 - t;
            let weights = [u * u * u, 3.0 * u * u * t, 3.0 * u * t * t, t * t * t];
            let corners = [from, first, second, to];
            let sum = |axis: usize| corners.iter().zip(weights).map(|(p, w)| w * p[axis]).sum();
            self.to([sum(0), sum(1)], true)?;
        }
        self.to(to, true)
    }

    /// An arc of an ellipse, from its ends to its middle (SVG 2, implementation notes, B.2.4).
    fn arc(&mut self, radii: [f64; 2], degrees: f64, large: bool, sweep: bool, to: [f64; 2]) -> Option<()> {
        let from = self.at;
        let mut radii = radii.map(f64::abs);
        let half = [0.5 * (from[0] - to[0]), 0.5 * (from[1] - to[1])];
        let (sine, cosine) = degrees.to_radians().sin_cos();
        let turned = [cosine * half[0] + sine * half[1], cosine * half[1] - sine * half[0]];
        let is_point = half.iter().all(|side| side.abs() <= 0.0);
        if radii.contains(&0.0) || is_point {
            return self.to(to, is_point);
        }
        let unit = [turned[0] / radii[0], turned[1] / radii[1]];
        let far = unit[0] * unit[0] + unit[1] * unit[1];
        if far > 1.0 {
            radii = radii.map(|r| r * far.sqrt());
        }
        let [p, q] = [turned[0] / radii[0], turned[1] / radii[1]];
        if !large && self.is_flat(radii, [p, q], turned) {
            return self.to(to, false);
        }
        let squared = p * p + q * q;
        let off = ((1.0 - squared).max(0.0) / squared).sqrt() * if large == sweep { -1.0 } else { 1.0 };
        // On the circle of radius 1: the middle, and the angles of both ends seen from it.
        let middle = [off * q, -off * p];
        let start = (q - middle[1]).atan2(p - middle[0]);
        let end = (-q - middle[1]).atan2(-p - middle[0]);
        let full = std::f64::consts::TAU;
        let angle = if sweep { (end - start).rem_euclid(full) } else { -(start - end).rem_euclid(full) };
        let pieces = (angle.abs() / std::f64::consts::PI * TURN).ceil().clamp(1.0, 2.0 * TURN) as u32;
        let centre = [0, 1].map(|i| 0.5 * (from[i] + to[i]));
        for i in 1..pieces {
            let (s, c) = (start + angle * f64::from(i) / f64::from(pieces)).sin_cos();
            let [x, y] = [radii[0] * (c + middle[0]), radii[1] * (s + middle[1])];
            self.to([centre[0] + cosine * x - sine * y, centre[1] + sine * x + cosine * y], true)?;
        }
        self.to(to, true)
    }

    /// Whether the smaller arc over a chord lies no farther from it than a straight curve may. `half` is half of the chord
    /// along the axes of the ellipse, `unit` the same on the circle of radius 1.
    fn is_flat(&self, radii: [f64; 2], [p, q]: [f64; 2], half: [f64; 2]) -> bool {
        let (unit, long) = (p.hypot(q), half[0].hypot(half[1]));
        // How far the arc rises on that circle; where the numbers end, nothing.
        let rise = unit * unit / (1.0 + (1.0 - unit * unit).max(0.0).sqrt());
        let apex = if unit > 0.0 { [rise * radii[0] * q / unit, -rise * radii[1] * p / unit] } else { [0.0; 2] };
        let off = (apex[0] * half[1] - apex[1] * half[0]).abs() / long;
        let length = 2.0 * long;
        unit <= FLAT && off <= (STRAIGHT * length).max(self.slack.min(BENT * length))
    }
}

/// Whether the control points of a curve lie on its chord, or nearly.
fn is_straight(from: [f64; 2], controls: [[f64; 2]; 2], to: [f64; 2], slack: f64) -> bool {
    let chord = [to[0] - from[0], to[1] - from[1]];
    let squared = chord[0] * chord[0] + chord[1] * chord[1];
    let length = squared.sqrt();
    let most = (STRAIGHT * squared).max(slack.min(BENT * length) * length);
    let lies_on = |control: [f64; 2]| {
        let way = [control[0] - from[0], control[1] - from[1]];
        let along = way[0] * chord[0] + way[1] * chord[1];
        let off = way[0] * chord[1] - way[1] * chord[0];
        off.abs() <= most && (-most..=squared + most).contains(&along)
    };
    squared > 0.0 && controls.into_iter().all(lies_on)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(data: &str) -> Vec<Vec<[f64; 2]>> {
        read(data).unwrap().iter().map(|s| s.points.iter().map(|p| p.0).collect()).collect()
    }

    #[test]
    fn straight_commands_large_and_small() {
        let square = vec![[1.0, 1.0], [3.0, 1.0], [3.0, 3.0], [1.0, 3.0]];
        for data in ["M1 1L3 1L3 3L1 3z", "m1,1 2,0 0,2 -2,0Z", "M1 1H3V3H1Z", "M1 1h2v2h-2z", "M1 1 3 1 3 3 1 3Z"] {
            assert_eq!(points(data), std::slice::from_ref(&square), "{data}");
            assert!(read(data).unwrap()[0].closed);
        }
        assert_eq!(points("m1 1 1 0zm2 0 1 0"), [[[1.0, 1.0], [2.0, 1.0]], [[3.0, 1.0], [4.0, 1.0]]]);
        assert_eq!(points("M1 1h1zh5"), [[[1.0, 1.0], [2.0, 1.0]], [[1.0, 1.0], [6.0, 1.0]]]);
    }

    #[test]
    fn after_curves_the_pen_is_where_it_should_be() {
        let curved = read("M0 0a5 5 0 0110 0l1 0C1 2 3 4 20,0S1 1 30 0t1 1l1 0").unwrap();
        let straight: Vec<[f64; 2]> = curved[0].points.iter().filter(|p| !p.1).map(|p| p.0).collect();
        assert_eq!(straight, [[0.0, 0.0], [11.0, 0.0], [32.0, 1.0]]);
    }

    #[test]
    fn straight_curves_are_lines() {
        for line in [
            "C2 2 4 4 6 6",
            "c0 0 6 6 6 6",
            "Q3 3 6 6",
            "S3 3 6 6",
            "A0 5 0 0 1 6 6",
            "a3 0 9 1 0 6 6",
            "A1e9 1e9 0 0 1 6 6",
            "A9e99 9e99 0 0 0 6 6",
            "A1e300 1e300 0 0 0 6 6",
        ] {
            assert_eq!(
                read(&format!("M0 0{line}")).unwrap()[0].points,
                [([0.0; 2], false), ([6.0; 2], false)],
                "{line}"
            );
        }
        for curve in [
            "C2 2 4 4.1 6 6",
            "C-1-1 4 4 6 6",
            "Q7 7 6 6",
            "Q3 4 6 6",
            "A5 5 0 0 1 6 6",
            "A400 400 0 0 1 6 6",
            "C1 1 2 2 0 0",
        ] {
            assert!(read(&format!("M0 0{curve}")).unwrap()[0].points[1].1, "{curve}");
        }
    }

    #[test]
    fn circles_of_all_makers_are_round() {
        let k = 0.552_284_75 * 4.0;
        let bezier = format!("M4 0C4 {k} {k} 4 0 4S-4 {k} -4 0C-4 {n} {n} -4 0 -4S4 {n} 4 0z", n = -k);
        for data in [
            &bezier,
            "M4 0A4 4 0 0 1-4 0A4 4 0 0 1 4 0z",
            "M4 0a4 4 0 1 0 -8 0a4 4 30 1 0 8 0z",
            "M0 4A4 4 0 1 1 .0001 4Z",
        ] {
            for &(p, _) in &read(data).unwrap()[0].points {
                assert!((p[0].hypot(p[1]) - 4.0).abs() < 0.002, "{data}: {p:?}");
            }
            assert!(read(data).unwrap()[0].points.len() > 16, "{data}");
        }
        // Radii that are too small grow.
        let grown = read("M-4 0A1 1 0 0 1 4 0").unwrap();
        assert!(grown[0].points.iter().all(|(p, _)| (p[0].hypot(p[1]) - 4.0).abs() < 1e-9 && p[1] < 1e-9));
    }

    #[test]
    fn what_cannot_be_read_is_told() {
        for (data, rest) in [("L1 1", "L1 1"), ("M0 0 1", "1"), ("M0 0 X", "X"), ("M0 0z1 1", "1 1"), ("12", "12")] {
            assert_eq!(read(data), Err(rest), "{data}");
        }
    }
}
