//! Inputs of the benchmarks, the same in every run.

/// A list of triangles over the vertices `0 .. vertices`.
pub struct Triangles {
    /// What the tables call it.
    pub name: &'static str,
    /// The number of vertices.
    pub vertices: usize,
    /// Three corners each, counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
}

/// A small generator of random numbers (xorshift64*), so that every run has the same inputs.
pub struct Random(u64);

impl Random {
    /// A generator with this seed.
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    /// The next 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    /// A number below `bound`.
    pub fn below(&mut self, bound: usize) -> usize {
        ((u128::from(self.bits()) * bound as u128) >> 64) as usize
    }

    /// A number in `[0, 1)`.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Puts the items in random order.
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            items.swap(i, self.below(i + 1));
        }
    }
}

/// A square grid of about `count` triangles, row by row.
pub fn ordered(count: usize) -> Triangles {
    let side = ((count / 2) as f64).sqrt().round() as u32;
    let at = |x: u32, y: u32| y * (side + 1) + x;
    let triangles = (0..side)
        .flat_map(|y| (0..side).map(move |x| (x, y)))
        .flat_map(|(x, y)| {
            let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    Triangles { name: "ordered", vertices: ((side + 1) * (side + 1)) as usize, triangles }
}

/// The same grid with vertices and triangles renumbered at random.
pub fn shuffled(count: usize) -> Triangles {
    let mut random = Random::new(1);
    let grid = ordered(count);
    let mut new: Vec<u32> = (0..grid.vertices as u32).collect();
    random.shuffle(&mut new);
    let mut triangles: Vec<_> = grid.triangles.iter().map(|t| t.map(|v| new[v as usize])).collect();
    random.shuffle(&mut triangles);
    Triangles { name: "shuffled", vertices: grid.vertices, triangles }
}

/// The Delaunay triangulation of random points, as its program lists it: about `count` triangles.
pub fn delaunay(count: usize) -> Triangles {
    let mut random = Random::new(2);
    let points: Vec<_> = (0..count / 2).map(|_| delaunator::Point { x: random.unit(), y: random.unit() }).collect();
    let corners = delaunator::triangulate(&points).triangles;
    let triangles = corners.chunks_exact(3).map(|t| [t[0] as u32, t[1] as u32, t[2] as u32]).collect();
    Triangles { name: "Delaunay", vertices: points.len(), triangles }
}

/// The three orders of the tables.
pub fn three_orders(count: usize) -> [Triangles; 3] {
    [ordered(count), shuffled(count), delaunay(count)]
}
