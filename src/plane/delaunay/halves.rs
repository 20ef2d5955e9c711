//! Half-edges while a triangulation is being made: origin, next and prev, no faces yet.
//!
//! ```text
//!    p1 ──>── ● ──>── g1                p1 ──>── ● ──>── g1
//!                                              h │ ^          connect(g1, g2) puts an edge into the corners
//!                               ==>              │ │ t        before g1 and g2, on their left. Within one cycle
//!                                                v │          it parts it in two; between two it makes one.
//!    g2 ──<── ● ──<── p2                g2 ──<── ● ──<── p2
//! ```

/// A growing set of half-edges, in a part of the columns of the finished structure. The twin of h is h ^ 1, as everywhere.
/// Removed edges leave their place to the next one that is made.
pub(super) struct Halves<'a> {
    /// The number of the first half-edge.
    base: u32,
    origin: &'a mut [u32],
    next: &'a mut [u32],
    prev: &'a mut [u32],
    /// So many places were used.
    made: u32,
    /// Edges that are not in use, among these places.
    free: Vec<u32>,
}

impl<'a> Halves<'a> {
    /// No edge yet; numbers start at `base`.
    pub(super) fn new(base: u32, [origin, next, prev]: [&'a mut [u32]; 3]) -> Self {
        Self { base, origin, next, prev, made: 0, free: Vec::new() }
    }

    /// All places are in use, but those of the given edges. The last of these is made first.
    pub(super) fn filled(base: u32, columns: [&'a mut [u32]; 3], free: Vec<u32>) -> Self {
        let made = columns[0].len() as u32;
        Self { made, free, ..Self::new(base, columns) }
    }

    /// The edges that are not in use, all others of its places among them.
    pub(super) fn into_free(mut self) -> Vec<u32> {
        let [first, end] = [self.made, self.origin.len() as u32].map(|place| (self.base + place) / 2);
        self.free.splice(0..0, (first..end).rev());
        self.free
    }

    #[inline(always)]
    fn place(&self, h: u32) -> usize {
        (h - self.base) as usize
    }

    #[inline]
    pub(super) fn origin(&self, h: u32) -> u32 {
        self.origin[self.place(h)]
    }

    #[inline]
    pub(super) fn destination(&self, h: u32) -> u32 {
        self.origin(h ^ 1)
    }

    #[inline]
    pub(super) fn next(&self, h: u32) -> u32 {
        self.next[self.place(h)]
    }

    #[inline]
    pub(super) fn prev(&self, h: u32) -> u32 {
        self.prev[self.place(h)]
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
        let (h_place, next_place) = (self.place(h), self.place(next));
        self.next[h_place] = next;
        self.prev[next_place] = h;
    }

    /// A new edge from `a` to `b` that touches nothing else; returns the half that starts at `a`.
    #[inline]
    pub(super) fn edge(&mut self, a: u32, b: u32) -> u32 {
        let h = match self.free.pop() {
            None => {
                let h = self.base + self.made;
                self.made += 2;
                h
            }
            Some(edge) => 2 * edge,
        };
        let place = self.place(h);
        (self.origin[place], self.origin[place + 1]) = (a, b);
        (self.next[place], self.next[place + 1]) = (h ^ 1, h);
        (self.prev[place], self.prev[place + 1]) = (h ^ 1, h);
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

    /// Fills the gaps: the last edges move into the places of removed ones. `keep` is a half-edge; returned are its number
    /// afterwards, and a number that all are below. O(removed edges log).
    pub(super) fn fill_gaps(mut self, mut keep: u32) -> (u32, usize) {
        let mut free = std::mem::take(&mut self.free);
        free.sort_unstable();
        // Gaps from the front, to be filled; at the end, to be cut off.
        let (mut first, mut end) = (0, free.len());
        let mut last = (self.base + self.made) / 2;
        while first < end {
            last -= 1;
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
        }
        (keep, 2 * last as usize)
    }

    /// Gives a half-edge another number.
    fn move_half(&mut self, from: u32, to: u32) {
        let (next, prev) = (self.next(from), self.prev(from));
        let place = self.place(to);
        self.origin[place] = self.origin(from);
        self.link(to, if next == from { to } else { next });
        self.link(if prev == from { to } else { prev }, to);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps_are_filled_from_the_end_and_the_kept_half_edge_is_followed() {
        let [mut origin, mut next, mut prev] = [[0; 8]; 3];
        let mut halves = Halves::new(0, [&mut origin, &mut next, &mut prev]);
        let first = halves.edge(0, 1);
        let second = halves.extend(first, 2);
        let third = halves.extend(second, 3);
        let fourth = halves.extend(third, 4);
        halves.remove(first);
        halves.remove(third);
        // The second edge is alone now, and the last one, too; it moves to the front.
        assert_eq!(halves.fill_gaps(fourth ^ 1), (1, 4));
        assert_eq!(origin[..4], [3, 4, 1, 2]);
        assert_eq!((&next[..4], &prev[..4]), (&[1, 0, 3, 2][..], &[1, 0, 3, 2][..]));
        assert_eq!(second, 2);
    }

    #[test]
    fn edges_that_join_two_parts_lie_in_places_that_these_did_not_use() {
        let [mut origin, mut next, mut prev] = [[9; 14]; 3];
        let mut first = Halves::new(0, [&mut origin[..8], &mut next[..8], &mut prev[..8]]);
        assert_eq!((first.edge(0, 1), first.edge(2, 3), first.edge(4, 5)), (0, 2, 4));
        first.remove(2);
        let mut free = first.into_free();
        let mut second = Halves::new(8, [&mut origin[8..], &mut next[8..], &mut prev[8..]]);
        assert_eq!((second.edge(6, 7), second.origin(8), second.destination(8)), (8, 6, 7));
        free.extend(second.into_free());
        // The edges 3, 5 and 6 were never used, 1 was taken out: the last one that is offered is the next one.
        assert_eq!(free, [3, 1, 6, 5]);
        let mut both = Halves::filled(0, [&mut origin, &mut next, &mut prev], free);
        assert_eq!([both.connect(0, 8), both.extend(4, 8)], [10, 12]);
        assert_eq!((both.origin(10), both.destination(10), both.next(10), both.prev(8)), (0, 6, 8, 10));
        // One edge of six moves, that of the highest number; half-edge 13 is half-edge 3 then.
        assert_eq!(both.fill_gaps(13), (3, 10));
        assert_eq!(origin[..10], [0, 1, 5, 8, 4, 5, 0, 6, 6, 7]);
    }
}
