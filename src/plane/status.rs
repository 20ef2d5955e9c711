//! The edges under the sweep line, in order.
//!
//! ```text
//!   [ e4 e0 e9 | e2 e7 | e1 e3 e8 e5 ]      chunks of a few hundred: a place is found by two binary searches,
//!     bottom ──────────────────> top        and putting in or taking out moves one chunk
//! ```

/// The edges cut by the sweep line, from bottom to top, in chunks so that insertion stays cheap.
#[derive(Default)]
pub(super) struct Status {
    chunks: Vec<Vec<u32>>,
}

/// A place between two edges: before the edge `offset` of chunk `chunk`.
pub(super) type Place = (usize, usize);

impl Status {
    const CHUNK: usize = 256;

    /// The first place whose edge is not `below`; all edges before it are.
    pub(super) fn partition(&self, below: impl Fn(u32) -> bool) -> Place {
        let chunk = self.chunks.partition_point(|chunk| chunk.last().is_some_and(|&edge| below(edge)));
        let offset = self.chunks.get(chunk).map_or(0, |chunk| chunk.partition_point(|&edge| below(edge)));
        (chunk, offset)
    }

    /// The edges from bottom to top.
    pub(super) fn all(&self) -> impl Iterator<Item = u32> + '_ {
        self.chunks.iter().flatten().copied()
    }

    pub(super) fn get(&self, (chunk, offset): Place) -> Option<u32> {
        self.chunks.get(chunk)?.get(offset).copied()
    }

    pub(super) fn before(&self, (chunk, offset): Place) -> Option<u32> {
        match offset {
            0 => self.chunks.get(chunk.checked_sub(1)?)?.last().copied(),
            _ => self.get((chunk, offset - 1)),
        }
    }

    /// Removes the edge at `at`; `at` then stands before the edge after it.
    pub(super) fn remove(&mut self, at: &mut Place) {
        let chunk = &mut self.chunks[at.0];
        chunk.remove(at.1);
        if chunk.is_empty() {
            self.chunks.remove(at.0);
        } else if at.1 == chunk.len() {
            *at = (at.0 + 1, 0);
        }
    }

    pub(super) fn insert(&mut self, (chunk, offset): Place, edges: &[u32]) {
        if edges.is_empty() {
            return;
        }
        // At the end of the order, or before the first edge of a chunk, the chunk before may take the edges.
        let (chunk, offset) = match (offset, chunk.checked_sub(1)) {
            (0, Some(before)) => (before, self.chunks[before].len()),
            _ => (chunk, offset),
        };
        if self.chunks.is_empty() {
            self.chunks.push(Vec::new());
        }
        let home = &mut self.chunks[chunk];
        home.splice(offset..offset, edges.iter().copied());
        if home.len() > Self::CHUNK {
            let whole = std::mem::take(home);
            self.chunks.splice(chunk..=chunk, whole.chunks(Self::CHUNK / 2).map(<[u32]>::to_vec));
        }
    }
}
