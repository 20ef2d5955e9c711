//! Half-edges while a triangulation is being made: origin, next and prev, no faces yet.
//!
//! ```text
//!    p1 ──>── ● ──>── g1                p1 ──>── ● ──>── g1
//!                                              h │ ^          connect(g1, g2) puts an edge into the corners
//!                               ==>              │ │ t        before g1 and g2, on their left. Within one cycle
//!                                                v │          it parts it in two; between two it makes one.
//!    g2 ──<── ● ──<── p2                g2 ──<── ● ──<── p2
//! ```

/// A half-edge. Its twin is h ^ 1, as everywhere.
#[derive(Clone, Copy, Debug)]
pub(super) struct Half {
    pub(super) origin: u32,
    pub(super) next: u32,
    pub(super) prev: u32,
}

/// A growing set of half-edges. Removed edges leave their place to the next one that is made.
pub(super) struct Halves {
    half: Vec<Half>,
    /// Removed edges.
    free: Vec<u32>,
}

impl Halves {
    /// No edge yet, and room for so many.
    pub(super) fn with_room(edges: usize) -> Self {
        Self { half: Vec::with_capacity(2 * edges), free: Vec::new() }
    }

    #[inline]
    pub(super) fn origin(&self, h: u32) -> u32 {
        self.half[h as usize].origin
    }

    #[inline]
    pub(super) fn destination(&self, h: u32) -> u32 {
        self.origin(h ^ 1)
    }

    #[inline]
    pub(super) fn next(&self, h: u32) -> u32 {
        self.half[h as usize].next
    }

    #[inline]
    pub(super) fn prev(&self, h: u32) -> u32 {
        self.half[h as usize].prev
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
        self.half[h as usize].next = next;
        self.half[next as usize].prev = h;
    }

    /// A new edge from `a` to `b` that touches nothing else; returns the half that starts at `a`.
    #[inline]
    pub(super) fn edge(&mut self, a: u32, b: u32) -> u32 {
        let h = self.free.pop().map_or(self.half.len() as u32, |e| 2 * e);
        let [there, back] = [(a, h ^ 1), (b, h)].map(|(origin, other)| Half { origin, next: other, prev: other });
        if h as usize == self.half.len() {
            self.half.extend([there, back]);
        } else {
            self.half[h as usize] = there;
            self.half[h as usize | 1] = back;
        }
        h
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
        let shift = self.half.len() as u32;
        let shifted = |half: Half| Half { next: half.next + shift, prev: half.prev + shift, ..half };
        self.half.extend(other.half.into_iter().map(shifted));
        self.free.extend(other.free.into_iter().map(|edge| edge + shift / 2));
        shift
    }

    /// All half-edges without gaps: the last edges move into the places of removed ones. `keep` is a half-edge;
    /// returned with its number afterwards. O(removed edges log).
    pub(super) fn without_gaps(mut self, mut keep: u32) -> (Vec<Half>, u32) {
        let mut free = std::mem::take(&mut self.free);
        free.sort_unstable();
        // Gaps from the front, to be filled; at the end, to be cut off.
        let (mut first, mut end) = (0, free.len());
        while first < end {
            let last = self.half.len() as u32 / 2 - 1;
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
            self.half.truncate(2 * last as usize);
        }
        (self.half, keep)
    }

    /// Gives a half-edge another number.
    fn move_half(&mut self, from: u32, to: u32) {
        let Half { origin, next, prev } = self.half[from as usize];
        self.half[to as usize].origin = origin;
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
        let (half, keep) = halves.without_gaps(fourth ^ 1);
        assert_eq!((half.len(), keep), (4, 1));
        assert_eq!([0, 1, 2, 3].map(|h: usize| half[h].origin), [3, 4, 1, 2]);
        for (h, record) in half.iter().enumerate() {
            assert_eq!((record.next as usize, record.prev as usize), (h ^ 1, h ^ 1));
        }
        assert_eq!(second, 2);
    }
}
