//! Your part of the lab: two primitives on a half-edge structure, and the surfaces that grow from them.
//!
//! The tasks are numbered as in the handout, README.md. Replace each `todo!(…)` by code; the functions that help
//! are in `dcel.rs` and `walks.rs`. `cargo test` says how far you are.

use crate::dcel::{Dcel, HalfEdgeId, VertexId};
use crate::svg::{Place, Svg};

/// Task 1. The double-sided disc: a polygon of `sides` corners with two faces.
pub fn ring(sides: usize) -> Dcel {
    // BEGIN SOLUTION
    // STARTER: let _ = sides;
    // STARTER: todo!("ring")
    let mut disc = Dcel::default();
    let (back, front) = (disc.new_face(), disc.new_face());
    for _ in 0..sides {
        disc.new_vertex(0.0, 0.0);
    }
    for v in 0..sides {
        let inside = disc.new_half_edge(v);
        let outside = disc.new_half_edge((v + 1) % sides);
        disc.make_twin(inside, outside);
        disc.half_edges[inside].face = Some(front);
        disc.half_edges[outside].face = Some(back);
        disc.vertices[v].outgoing_half_edge = Some(inside);
    }
    for v in 0..sides {
        let after = (v + 1) % sides;
        disc.make_next(2 * v, 2 * after);
        disc.make_next(2 * after + 1, 2 * v + 1);
    }
    disc.faces[back].incident_half_edge = Some(1);
    disc.faces[front].incident_half_edge = Some(0);
    disc
    // END SOLUTION
}

/// Task 1. The torus with one vertex, one face and two edges.
pub fn torus_seed() -> Dcel {
    // BEGIN SOLUTION
    // STARTER: todo!("torus_seed")
    let mut seed = Dcel::default();
    let v = seed.new_vertex(0.0, 0.0);
    let f = seed.new_face();
    let h = [0; 4].map(|_| seed.new_half_edge(v));
    seed.make_twin(h[0], h[1]);
    seed.make_twin(h[2], h[3]);
    for (before, after) in [(0, 2), (2, 1), (1, 3), (3, 0)] {
        seed.make_next(h[before], h[after]);
        seed.half_edges[h[before]].face = Some(f);
    }
    seed.vertices[v].outgoing_half_edge = Some(h[0]);
    seed.faces[f].incident_half_edge = Some(h[0]);
    seed
    // END SOLUTION
}

/// The two primitives.
impl Dcel {
    /// Task 2. Splits the vertex where `first` and `last` start: the half-edges from `first` on, counter-clockwise, up
    /// to but without `last`, start at a new vertex afterwards. Returns the new half-edge, from the old vertex to
    /// the new one. `None` if the two do not start at one vertex.
    pub fn split_vertex(&mut self, first: HalfEdgeId, last: HalfEdgeId) -> Option<HalfEdgeId> {
        // BEGIN SOLUTION
        // STARTER: let _ = (first, last);
        // STARTER: todo!("split_vertex")
        let old = self.origin(first);
        if self.origin(last) != old {
            return None;
        }
        let new = self.new_vertex(0.0, 0.0);
        let out = self.new_half_edge(old);
        let back = self.new_half_edge(new);
        self.make_twin(out, back);
        let mut moved = first;
        while moved != last {
            self.half_edges[moved].origin = Some(new);
            moved = self.ccw(moved);
        }
        let (to_first, to_last) = (self.twin(first), self.twin(last));
        let (after_first, after_last) = (self.next(to_first), self.next(to_last));
        self.half_edges[out].face = self.half_edges[to_last].face;
        self.half_edges[back].face = self.half_edges[to_first].face;
        self.make_next(to_first, back);
        self.make_next(out, after_last);
        self.make_next(to_last, out);
        self.make_next(back, after_first);
        if first == last {
            self.make_next(out, back);
        }
        self.vertices[old].outgoing_half_edge = Some(out);
        self.vertices[new].outgoing_half_edge = Some(back);
        Some(out)
        // END SOLUTION
    }

    /// Task 3. Splits the face of `h1` and `h2` by an edge between their origins. Returns the new half-edge from the
    /// origin of `h1` to the origin of `h2`; on its left lies the new face. `None` if the two have different faces.
    pub fn split_face(&mut self, h1: HalfEdgeId, h2: HalfEdgeId) -> Option<HalfEdgeId> {
        // BEGIN SOLUTION
        // STARTER: let _ = (h1, h2);
        // STARTER: todo!("split_face")
        let old = self.face(h1);
        if self.face(h2) != old {
            return None;
        }
        let (before1, before2) = (self.prev(h1), self.prev(h2));
        let new = self.new_face();
        let there = self.new_half_edge(self.origin(h1));
        let back = self.new_half_edge(self.origin(h2));
        self.make_twin(there, back);
        self.make_next(before1, there);
        self.make_next(there, h2);
        self.make_next(before2, back);
        self.make_next(back, h1);
        self.half_edges[back].face = Some(old);
        for h in self.cycle(there) {
            self.half_edges[h].face = Some(new);
        }
        self.faces[old].incident_half_edge = Some(back);
        self.faces[new].incident_half_edge = Some(there);
        Some(there)
        // END SOLUTION
    }

    /// Task 4. V - E + F.
    pub fn euler(&self) -> i64 {
        // BEGIN SOLUTION
        // STARTER: todo!("euler")
        let [v, h, f] = [self.vertices.len(), self.half_edges.len(), self.faces.len()].map(|n| n as i64);
        v - h / 2 + f
        // END SOLUTION
    }

    /// Task 4. How many handles the surface has. It is closed and connected.
    pub fn genus(&self) -> i64 {
        // BEGIN SOLUTION
        // STARTER: todo!("genus")
        (2 - self.euler()) / 2
        // END SOLUTION
    }
}

/// What the primitives make together.
impl Dcel {
    /// Task 5. Puts a vertex into the face of `h`, and a spoke to each of its corners. Returns the new vertex.
    pub fn pole(&mut self, h: HalfEdgeId) -> VertexId {
        // BEGIN SOLUTION
        // STARTER: let _ = h;
        // STARTER: todo!("pole")
        let corners = self.cycle(h);
        let mut back = self.spur(h);
        let middle = self.origin(back);
        for &corner in &corners[1..] {
            if let Some(spoke) = self.split_face(corner, back) {
                back = self.twin(spoke);
            }
        }
        middle
        // END SOLUTION
    }

    /// Task 6. Cuts the edge of `h` into `pieces`. Returns the piece that starts where `h` started; those of the face
    /// of `h` follow each other.
    pub fn divide(&mut self, h: HalfEdgeId, pieces: usize) -> HalfEdgeId {
        // BEGIN SOLUTION
        // STARTER: let _ = (h, pieces);
        // STARTER: todo!("divide")
        // At the tip of a spur a split makes another spur: there the edge is cut from its other end, and h stays the first.
        if self.ccw(h) == h {
            for _ in 1..pieces {
                let back = self.twin(h);
                self.split_vertex(back, self.ccw(back));
            }
            return h;
        }
        let mut start = h;
        for piece in 1..pieces {
            let new = self.split_vertex(h, self.ccw(h));
            if let (1, Some(new)) = (piece, new) {
                start = new;
            }
        }
        start
        // END SOLUTION
    }

    /// Task 6. The face of `h` has four sides, of `n`, `m`, `n` and `m` half-edges; `h` is the first of the first
    /// side. Cuts the face in n times m quads.
    pub fn fill(&mut self, h: HalfEdgeId, n: usize, m: usize) {
        // BEGIN SOLUTION
        // STARTER: let _ = (h, n, m);
        // STARTER: todo!("fill")
        let sides = self.cycle(h);
        for i in 1..n {
            if let Some(up) = self.split_face(sides[i], sides[2 * n + m - i]) {
                self.divide(up, m);
            }
        }
        for &bottom in &sides[..n] {
            let strip = self.cycle(bottom);
            for j in 1..m {
                self.split_face(strip[1 + j], strip[2 * m + 2 - j]);
            }
        }
        // END SOLUTION
    }

    /// Task 7. Extrudes the face of `h`: the face moves up, and a wall of four sides stands under each of its sides.
    /// Returns the half-edge of the face above `h`.
    pub fn extrude(&mut self, h: HalfEdgeId) -> HalfEdgeId {
        // BEGIN SOLUTION
        // STARTER: let _ = h;
        // STARTER: todo!("extrude")
        let corners = self.cycle(h);
        let down: Vec<HalfEdgeId> = corners.iter().map(|&corner| self.spur(corner)).collect();
        let mut top = h;
        for i in 0..down.len() {
            let end = if i + 1 < down.len() { down[i + 1] } else { top };
            if let Some(edge) = self.split_face(end, down[i])
                && i == 0
            {
                top = self.twin(edge);
            }
        }
        top
        // END SOLUTION
    }
}

/// Task 6. The grid: a square cut in n times m, its front and its back.
pub fn grid(n: usize, m: usize) -> Dcel {
    // BEGIN SOLUTION
    // STARTER: let _ = (n, m);
    // STARTER: todo!("grid")
    let mut square = ring(4);
    let start = square.divide(0, n);
    square.divide(2, m);
    square.divide(4, n);
    square.divide(6, m);
    square.fill(start, n, m);
    // The last piece of the bottom is h0 still; behind it, its twin runs from the right to the left.
    let behind = square.twin(0);
    square.fill(behind, n, m);
    square
    // END SOLUTION
}

/// Task 6. The torus of n times m quads.
pub fn torus(n: usize, m: usize) -> Dcel {
    // BEGIN SOLUTION
    // STARTER: let _ = (n, m);
    // STARTER: todo!("torus")
    let mut torus = torus_seed();
    let start = torus.divide(0, n);
    torus.divide(2, m);
    torus.fill(start, n, m);
    torus
    // END SOLUTION
}

/// Task 7. The cylinder: a ring, extruded `layers` times.
pub fn cylinder(sides: usize, layers: usize) -> Dcel {
    // BEGIN SOLUTION
    // STARTER: let _ = (sides, layers);
    // STARTER: todo!("cylinder")
    let mut tube = ring(sides);
    let mut top = 0;
    for _ in 0..layers {
        top = tube.extrude(top);
    }
    tube
    // END SOLUTION
}

/// Task 7. The cube whose faces are cut in `steps` times `steps` squares.
pub fn cube(steps: usize) -> Dcel {
    // BEGIN SOLUTION
    // STARTER: let _ = steps;
    // STARTER: todo!("cube")
    let mut cube = cylinder(4, 1);
    for h in 0..cube.half_edges.len() {
        if h < cube.twin(h) {
            cube.divide(h, steps);
        }
    }
    let corners = 8;
    for face in 0..6 {
        let Some(mut h) = cube.faces[face].incident_half_edge else { continue };
        while cube.origin(h) >= corners {
            h = cube.next(h);
        }
        cube.fill(h, steps, steps);
    }
    cube
    // END SOLUTION
}

/// Task 7. The cone: a cylinder of one layer less, with a pole on top. `layers` is 1 or more.
pub fn cone(sides: usize, layers: usize) -> Dcel {
    // BEGIN SOLUTION
    // STARTER: let _ = (sides, layers);
    // STARTER: todo!("cone")
    let mut cone = cylinder(sides, layers - 1);
    if let Some(top) = cone.faces[1].incident_half_edge {
        cone.pole(top);
    }
    cone
    // END SOLUTION
}

/// Task 7. The sphere: `bands` from pole to pole, the first and the last of triangles. `bands` is 2 or more.
pub fn sphere(sides: usize, bands: usize) -> Dcel {
    // BEGIN SOLUTION
    // STARTER: let _ = (sides, bands);
    // STARTER: todo!("sphere")
    let mut sphere = cylinder(sides, bands - 2);
    let ends = [0, 1].map(|face| sphere.faces[face].incident_half_edge);
    for end in ends.into_iter().flatten() {
        sphere.pole(end);
    }
    sphere
    // END SOLUTION
}

/// Where the vertices are in space.
impl Dcel {
    /// Task 8. The place of each vertex of a surface of revolution, by the number of the vertex. `rows` are the radius
    /// and the height of its rings, from below; one of radius 0 is a pole. `h` goes round the lowest ring, from the
    /// angle 0 on, with a wall on its left.
    pub fn revolve(&self, h: HalfEdgeId, rows: &[[f64; 2]]) -> Vec<Place> {
        // BEGIN SOLUTION
        // STARTER: let _ = (h, rows);
        // STARTER: todo!("revolve")
        let mut places = vec![[0.0; 3]; self.vertices.len()];
        let mut sides = if rows.len() == 1 { self.cycle(h) } else { vec![h] };
        loop {
            let ahead = self.next(self.twin(self.next(sides[sides.len() - 1])));
            if rows.len() == 1 || ahead == h {
                break;
            }
            sides.push(ahead);
        }
        let mut is_lowest = true;
        for (j, &[radius, height]) in rows.iter().enumerate() {
            if radius == 0.0 {
                let spoke = self.prev(if j == 0 { self.twin(h) } else { sides[0] });
                places[self.origin(spoke)] = [0.0, 0.0, height];
                continue;
            }
            if !is_lowest {
                sides = sides.iter().map(|&side| self.twin(self.next(self.next(side)))).collect();
            }
            is_lowest = false;
            for (i, &side) in sides.iter().enumerate() {
                let (sin, cos) = (std::f64::consts::TAU * i as f64 / sides.len() as f64).sin_cos();
                places[self.origin(side)] = [radius * cos, radius * sin, height];
            }
        }
        places
        // END SOLUTION
    }
}

/// Task 9. The picture: six surfaces in space, each in its panel, as the handout lists them.
pub fn picture(svg: &mut Svg) {
    // BEGIN SOLUTION
    // STARTER: let _ = svg;
    // STARTER: todo!("picture")
    let stages: [(Dcel, &[[f64; 2]]); 6] = [
        (ring(6), &[[1.0, 0.0]]),
        (cylinder(6, 1), &[[1.0, 0.0], [1.0, 0.7]]),
        (cylinder(6, 2), &[[1.0, 0.0], [1.0, 0.7], [1.0, 1.4]]),
        (cone(6, 3), &[[1.0, 0.0], [0.7, 0.5], [0.4, 1.0], [0.0, 1.6]]),
        (sphere(6, 4), &[[0.0, -1.0], [0.7, -0.7], [1.0, 0.0], [0.7, 0.7], [0.0, 1.0]]),
        (torus(8, 4), &[[1.4, 0.0], [1.0, 0.4], [0.6, 0.0], [1.0, -0.4]]),
    ];
    for (panel, (surface, rows)) in stages.iter().enumerate() {
        svg.panel(panel);
        let places = surface.revolve(0, rows);
        for h in 0..surface.half_edges.len() {
            if h < surface.twin(h) {
                svg.line(places[surface.origin(h)], places[surface.origin(surface.twin(h))]);
            }
        }
        for &place in &places {
            svg.dot(place);
        }
    }
    // END SOLUTION
}
