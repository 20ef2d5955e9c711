//! Numbers out of bytes, for targets whose input is no text.

/// Bytes that are taken from the front; after the end there are zeros.
pub(crate) struct Bytes<'a>(pub(crate) &'a [u8]);

impl Bytes<'_> {
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub(crate) fn byte(&mut self) -> u8 {
        match self.0.split_first() {
            Some((&first, rest)) => {
                self.0 = rest;
                first
            }
            None => 0,
        }
    }

    pub(crate) fn below(&mut self, bound: usize) -> usize {
        usize::from(self.byte()) % bound.max(1)
    }

    /// A coordinate: mostly of a small grid, so that points fall on points and on segments.
    ///
    /// ```text
    ///   mode 0   -128 .. 127                  mode 2   the same far from the origin, where one unit is the last place
    ///   mode 1   the same in 64ths            mode 3   any eight bytes: infinities, tiny ones, NaN, too
    /// ```
    pub(crate) fn coordinate(&mut self, mode: u8) -> f64 {
        let small = |byte: u8| f64::from(byte.cast_signed());
        match mode % 4 {
            0 => small(self.byte()),
            1 => small(self.byte()) / 64.0,
            2 => (1_u64 << 52) as f64 + small(self.byte()),
            _ => f64::from_bits(u64::from_le_bytes(std::array::from_fn(|_| self.byte()))),
        }
    }
}
