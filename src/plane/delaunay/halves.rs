//! Half-edges while a triangulation is being made: origin, next and prev, no faces yet.
//!
//! ```text
//!    p1 ──>── ● ──>── g1                p1 ──>── ● ──>── g1
//!                                              h │ ^          connect(g1, g2) puts an edge into the corners
//!                               ==>              │ │ t        before g1 and g2, on their left. Within one cycle
//!                                                v │          it parts it in two; between two it makes one.
//!    g2 ──<── ● ──<── p2                g2 ──<── ● ──<── p2
//! ```

/// A growing set of half-edges, in the columns of the finished structure. The twin of h is h ^ 1, as everywhere. Removed edges
/// leave their place to the next one that is made.
pub(super) struct Halves {
    pub(super) origin: Vec<u32>,
    pub(super) next: Vec<u32>,
    pub(super) prev: Vec<u32>,
    /// Removed edges.
    free: Vec<u32>,
}

impl Halves {
    /// No edge yet, and room for so many.
    pub(super) fn with_room(edges: usize) -> Self {
        let [origin, next, prev] = [(); 3].map(|()| Vec::with_capacity(2 * edges));
        Self { origin, next, prev, free: Vec::new() }
    }

    #[inline]
    pub(super) fn origin(&self, h: u32) -> u32 {
        self.origin[h as usize]
    }

    #[inline]
    pub(super) fn destination(&self, h: u32) -> u32 {
        self.origin(h ^ 1)
    }

    #[inline]
    pub(super) fn next(&self, h: u32) -> u32 {
        self.next[h as usize]
    }

    #[inline]
    pub(super) fn prev(&self, h: u32) -> u32 {
        self.prev[h as usize]
    }

    /// The next half-edge counter-clockwise round the origin of `h`.
    #[inline]
    pub(super) fn ccw(&self, h: u32) -> u32 {
        self.prev(h) ^ 1
    }

    /// The next half-edge clockwise round the origin of `h`.
    #[inline]
    pub(super) fn cw(&self, h: u32) -> u32 {
        self.next(h ^ 1)
    }

    #[inline]
    fn link(&mut self, h: u32, next: u32) {
        self.next[h as usize] = next;
        self.prev[next as usize] = h;
    }

    /// A new edge from `a` to `b` that touches nothing else; returns the half that starts at `a`.
    #[inline]
    pub(super) fn edge(&mut self, a: u32, b: u32) -> u32 {
        match self.free.pop() {
            None => {
                let h = self.origin.len() as u32;
                for (column, halves) in
                    [(&mut self.origin, (a, b)), (&mut self.next, (h ^ 1, h)), (&mut self.prev, (h ^ 1, h))]
                {
                    column.push(halves.0);
                    column.push(halves.1);
                }
                h
            }
            Some(edge) => {
                let h = 2 * edge;
                (self.origin[h as usize], self.origin[h as usize | 1]) = (a, b);
                self.link(h, h ^ 1);
                self.link(h ^ 1, h);
                h
            }
        }
    }

    /// A new edge from the origin of `g1` to that of `g2`, in the corners before them. Returns its half that
    /// starts at `g1`; `g2` follows it.
    #[inline]
    pub(super) fn connect(&mut self, g1: u32, g2: u32) -> u32 {
        let h = self.edge(self.origin(g1), self.origin(g2));
        let (p1, p2) = (self.prev(g1), self.prev(g2));
        self.link(p1, h);
        self.link(h, g2);
        self.link(p2, h ^ 1);
        self.link(h ^ 1, g1);
        h
    }

    /// A new edge from the destination of `h` to `c`, in the corner after `h`. Returns its half that follows `h`.
    pub(super) fn extend(&mut self, h: u32, c: u32) -> u32 {
        let g = self.edge(self.destination(h), c);
        let after = self.next(h);
        self.link(h, g);
        self.link(g ^ 1, after);
        g
    }

    /// Takes an edge away.
    #[inline]
    pub(super) fn remove(&mut self, h: u32) {
        let t = h ^ 1;
        let (p1, n1, p2, n2) = (self.prev(h), self.next(h), self.prev(t), self.next(t));
        self.link(p1, n2);
        self.link(p2, n1);
        self.free.push(h >> 1);
    }

    /// Takes over the half-edges of another set, which touch none of these; each gets the number that is returned more.
    /// O(those of the other set).
    pub(super) fn append(&mut self, other: Self) -> u32 {
        let shift = self.origin.len() as u32;
        self.origin.extend(other.origin);
        self.next.extend(other.next.into_iter().map(|h| h + shift));
        self.prev.extend(other.prev.into_iter().map(|h| h + shift));
        self.free.extend(other.free.into_iter().map(|edge| edge + shift / 2));
        shift
    }

    /// Fills the gaps: the last edges move into the places of removed ones. `keep` is a half-edge; returned is its number
    /// afterwards. O(removed edges log).
    pub(super) fn fill_gaps(&mut self, mut keep: u32) -> u32 {
        let mut free = std::mem::take(&mut self.free);
        free.sort_unstable();
        // Gaps from the front, to be filled; at the end, to be cut off.
        let (mut first, mut end) = (0, free.len());
        while first < end {
            let last = self.origin.len() as u32 / 2 - 1;
            if free[end - 1] == last {
                end -= 1;
            } else {
                for side in 0..2 {
                    self.move_half(2 * last + side, 2 * free[first] + side);
                }
                if keep >> 1 == last {
                    keep = 2 * free[first] + (keep & 1);
                }
                first += 1;
            }
            for column in [&mut self.origin, &mut self.next, &mut self.prev] {
                column.truncate(2 * last as usize);
            }
        }
        keep
    }

    /// Gives a half-edge another number.
    fn move_half(&mut self, from: u32, to: u32) {
        let (next, prev) = (self.next(from), self.prev(from));
        self.origin[to as usize] = self.origin(from);
        self.link(to, if next == from { to } else { next });
        self.link(if prev == from { to } else { prev }, to);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_are_filled_from_the_end_and_the_kept_half_edge_is_followed() {
        let mut halves = Halves::with_room(4);
        let first = halves.edge(0, 1);
        let second = halves.extend(first, 2);
        let third = halves.extend(second, 3);
        let fourth = halves.extend(third, 4);
        halves.remove(first);
        halves.remove(third);
        // The second edge is alone now, and the last one, too; it moves to the front.
        assert_eq!(halves.fill_gaps(fourth ^ 1), 1);
        assert_eq!(halves.origin, [3, 4, 1, 2]);
        assert_eq!((halves.next, halves.prev), (vec![1, 0, 3, 2], vec![1, 0, 3, 2]));
        assert_eq!(second, 2);
    }
}
