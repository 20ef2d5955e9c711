//! Path data as polylines.
//!
//! ```text
//!   M0,0 10,0 V10 Q5,5 0,10 Z      (0,0) ── (10,0) ── (10,10) ~~ (0,10) ── back     ~~ is a curve, its end is kept
//! ```
//!
//! Straight commands (M L H V Z, large and small) are read in full. Of a curve (C S Q T A) only the end is known,
//! so that what follows has the right place: an edge of a half-edge structure is never a curve.

use super::numbers::Reader;

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
    let mut reader = Reader::new(data);
    let mut pen = Pen::default();
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
}

impl Pen {
    fn draw(&mut self, letter: u8, reader: &mut Reader<'_>) -> Option<()> {
        let [x, y] = if letter.is_ascii_lowercase() { self.at } else { [0.0; 2] };
        let pair = |reader: &mut Reader<'_>| reader.pair().map(|p| [p[0] + x, p[1] + y]);
        let (to, curved) = match letter.to_ascii_uppercase() {
            b'M' => {
                self.at = pair(reader)?;
                self.start = self.at;
                self.out.push(Subpath { points: vec![(self.at, false)], closed: false });
                return Some(());
            }
            b'Z' => {
                self.at = self.start;
                self.out.last_mut()?.closed = true;
                return Some(());
            }
            b'L' => (pair(reader)?, false),
            b'H' => ([reader.number()? + x, self.at[1]], false),
            b'V' => ([self.at[0], reader.number()? + y], false),
            b'T' => (pair(reader)?, true),
            b'S' | b'Q' => {
                pair(reader)?;
                (pair(reader)?, true)
            }
            b'C' => {
                pair(reader)?;
                pair(reader)?;
                (pair(reader)?, true)
            }
            b'A' => {
                reader.pair()?;
                reader.number()?;
                reader.flag()?;
                reader.flag()?;
                (pair(reader)?, true)
            }
            _ => return None,
        };
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
    fn of_curves_the_end_is_known() {
        let curved = read("M0 0a5 5 0 0110 0l1 0C1 2 3 4 20,0S1 1 30 0t1 1").unwrap();
        let expected = [([0.0, 0.0], false), ([10.0, 0.0], true), ([11.0, 0.0], false), ([20.0, 0.0], true)];
        assert_eq!(curved[0].points[..4], expected);
        assert_eq!(curved[0].points[5], ([31.0, 1.0], true));
    }

    #[test]
    fn what_cannot_be_read_is_told() {
        for (data, rest) in [("L1 1", "L1 1"), ("M0 0 1", "1"), ("M0 0 X", "X"), ("M0 0z1 1", "1 1"), ("12", "12")] {
            assert_eq!(read(data), Err(rest), "{data}");
        }
    }
}
