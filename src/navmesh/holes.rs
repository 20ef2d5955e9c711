//! The names of the holes: of what is no face of the mesh.
//!
//! ```text
//!   ┌─────┬──────┐  f0      Hole faces side by side are one hole, whatever it is cut into. Its name is the one with the
//!   │ f4 ╱│      │          lowest number: here f2. The outer face is a hole by itself.
//!   │  ╱f2│ mesh │
//!   └─────┴──────┘          Obstacles change nothing here: what they cut off a hole keeps the name of that hole.
//! ```
//!
//! Memory: nothing for holes of one face each; else a few bits for each number that is no face of the mesh.

use super::records::FaceTable;
use crate::ids::FaceId;
use crate::plane::Subdivision;
use std::collections::BTreeMap;

/// The hole to which each hole face belongs.
#[derive(Clone, Debug, Default)]
pub(super) struct Holes {
    /// The names, and for each number without a record in the table of faces which of them it has: `width` bits, one
    /// after the other. Nothing if all names are as in `own`.
    names: Vec<u32>,
    width: usize,
    words: Vec<u64>,
    /// Names that are not the face's own number; they go before.
    own: BTreeMap<u32, u32>,
}

impl Holes {
    /// The holes of a map. O(n).
    pub(super) fn new(map: &Subdivision, faces: &FaceTable) -> Self {
        let mut own = BTreeMap::new();
        let mut name_of = vec![0; if map.hole_faces().next().is_some() { map.face_bound() } else { 0 }];
        let mut names = vec![0];
        let mut stack = Vec::new();
        for hole in map.hole_faces() {
            if name_of[hole.index()] != 0 {
                continue;
            }
            // Names are numbered from 1; 0 is the outer face.
            let name = names.len() as u32;
            names.push(hole.number());
            name_of[hole.index()] = name;
            stack.push(hole);
            while let Some(f) = stack.pop() {
                if f != hole {
                    own.insert(f.number(), hole.number());
                }
                for h in map.cycles(f).flat_map(|h| map.cycle(h)) {
                    let beside = map.face(h.twin());
                    if map.is_hole(beside) && name_of[beside.index()] == 0 {
                        name_of[beside.index()] = name;
                        stack.push(beside);
                    }
                }
            }
        }
        let last = (0..map.face_bound()).rev().find_map(|f| faces.hole_slot(f));
        let Some(count) = last.map(|last| last + 1).filter(|_| !own.is_empty()) else {
            return Self { own, ..Self::default() };
        };
        let width = (u32::BITS - (names.len() as u32 - 1).leading_zeros()) as usize;
        let mut words = vec![0u64; (count * width).div_ceil(64) + 1];
        for f in map.hole_faces() {
            let bit = faces.hole_slot(f.index()).unwrap_or(0) * width;
            let name = u128::from(name_of[f.index()]) << (bit % 64);
            words[bit / 64] |= name as u64;
            words[bit / 64 + 1] |= (name >> 64) as u64;
        }
        Self { names, width, words, own: BTreeMap::new() }
    }

    /// The name of the hole that has a face which is none of the mesh.
    pub(super) fn name(&self, faces: &FaceTable, hole: u32) -> u32 {
        if let Some(&name) = self.own.get(&hole) {
            return name;
        }
        match faces.hole_slot(hole as usize) {
            Some(slot) if !self.names.is_empty() => {
                let bit = slot * self.width;
                let words = u128::from(self.words[bit / 64]) | u128::from(self.words[bit / 64 + 1]) << 64;
                self.names[((words >> (bit % 64)) as usize) & ((1 << self.width) - 1)]
            }
            _ => hole,
        }
    }

    /// Writes down all names one by one, for a table of faces with a record for each number. O(n).
    pub(super) fn unpack(&mut self, map: &Subdivision, faces: &FaceTable) {
        let names = map.hole_faces().map(|f| (f.number(), self.name(faces, f.number())));
        let own = names.filter(|(f, name)| f != name).collect();
        *self = Self { own, ..Self::default() };
    }

    /// A piece of a hole has been cut off, or has another name again: it belongs to the hole of `of`.
    pub(super) fn put(&mut self, faces: &FaceTable, piece: FaceId, of: FaceId) {
        let name = self.name(faces, of.number());
        self.own.insert(piece.number(), name);
    }

    /// A face is gone.
    pub(super) fn forget(&mut self, face: FaceId) {
        self.own.remove(&face.number());
    }

    /// About as many bytes.
    pub(super) fn memory(&self) -> usize {
        4 * self.names.len() + 8 * self.words.len() + 12 * self.own.len()
    }
}
