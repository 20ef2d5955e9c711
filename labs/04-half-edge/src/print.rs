//! A structure as text, one record a line, and the way back.
//!
//! ```text
//!   outer 0
//!   vertex 0 -250 -150 0              number x y outgoing
//!   half_edge 0 0 1 2 10 1            number origin twin next prev face
//!   face 0 1                          number boundary            `-` stands for a reference that is not set
//! ```

use crate::dcel::{Dcel, Face, HalfEdge, Point, Vertex};
use std::fmt::Write;

/// The lines of a dump.
pub fn dump(dcel: &Dcel) -> String {
    let mut text = format!("outer {}\n", dcel.outer_face);
    let end_line = |text: &mut String, references: &[Option<usize>]| {
        for to in references {
            let _ = match to {
                Some(number) => write!(text, " {number}"),
                None => write!(text, " -"),
            };
        }
        text.push('\n');
    };
    for (v, record) in dcel.vertices.iter().enumerate() {
        let Point { x, y } = record.pos;
        let _ = write!(text, "vertex {v} {x} {y}");
        end_line(&mut text, &[record.outgoing_half_edge]);
    }
    for (h, record) in dcel.half_edges.iter().enumerate() {
        let _ = write!(text, "half_edge {h}");
        end_line(&mut text, &[record.origin, record.twin, record.next, record.prev, record.face]);
    }
    for (f, record) in dcel.faces.iter().enumerate() {
        let _ = write!(text, "face {f}");
        end_line(&mut text, &[record.incident_half_edge]);
    }
    text
}

/// Adds the record of a line of a dump. The records of a kind come in the order of their numbers.
pub fn read_record(dcel: &mut Dcel, kind: &str, words: &[&str]) -> Result<(), String> {
    let kinds = [("outer", 1), ("vertex", 4), ("half_edge", 6), ("face", 2)];
    let Some(&(_, count)) = kinds.iter().find(|&&(word, _)| word == kind) else {
        return Err(format!("a table has no line `{kind}`; it has outer, vertex, half_edge, face, end_table"));
    };
    if words.len() != count {
        return Err(format!("`{kind}` has {count} values, not {}", words.len()));
    }
    let number = whole(words[0])?;
    let expected = match kind {
        "vertex" => dcel.vertices.len(),
        "half_edge" => dcel.half_edges.len(),
        "face" => dcel.faces.len(),
        _ => number,
    };
    if number != expected {
        return Err(format!("the next {kind} has the number {expected}, not {number}"));
    }
    match kind {
        "outer" => dcel.outer_face = number,
        "vertex" => {
            let pos = Point { x: coordinate(words[1])?, y: coordinate(words[2])? };
            dcel.vertices.push(Vertex { outgoing_half_edge: reference(words[3])?, pos });
        }
        "half_edge" => {
            let fields: Result<Vec<_>, _> = words[1..].iter().map(|word| reference(word)).collect();
            let &[origin, twin, next, prev, face] = fields?.as_slice() else {
                return Err("a half_edge has five references".to_owned());
            };
            dcel.half_edges.push(HalfEdge { origin, face, prev, next, twin });
        }
        _ => dcel.faces.push(Face { incident_half_edge: reference(words[1])? }),
    }
    Ok(())
}

/// A number from 0.
pub fn whole(word: &str) -> Result<usize, String> {
    word.parse().map_err(|_| format!("`{word}` is not a number such as 0, 1, 2"))
}

/// A coordinate.
pub fn coordinate(word: &str) -> Result<f64, String> {
    let number: Option<f64> = word.parse().ok();
    number.filter(|x| x.is_finite()).ok_or_else(|| format!("`{word}` is not a number such as -2.5"))
}

fn reference(word: &str) -> Result<Option<usize>, String> {
    if word == "-" { Ok(None) } else { whole(word).map(Some) }
}
