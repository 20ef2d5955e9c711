//! The structures that cases start from.
//!
//! The k-th edge that a start states becomes the half-edges h(2k), on the side that states it, and h(2k+1), on the
//! other side. f0 is the outer face, f1 the first face inside.

// A lab uses the starts that it needs.
#![allow(dead_code)]

use crate::dcel::{Dcel, FaceId, HalfEdgeId, VertexId};
use crate::harness::{points, whole};

/// The lab's rectangle, 500 wide and 300 high, with a vertex in the middle of its long sides.
///
/// ```text
///   v5 ◀── h8 ── v4 ◀── h6 ── v3
///   │                          ▲         h1, h3, … h11, their twins, run round the outside
///  h10           f1            h4  f0
///   ▼                          │
///   v0 ── h0 ──▶ v1 ── h2 ──▶ v2
/// ```
pub fn rectangle(words: &[&str]) -> Result<Dcel, String> {
    if !words.is_empty() {
        return Err("the rectangle is always the same".to_owned());
    }
    let corners = [[-250.0, -150.0], [0.0, -150.0], [250.0, -150.0], [250.0, 150.0], [0.0, 150.0], [-250.0, 150.0]];
    Ok(polygon_of(&corners))
}

/// `polygon x y x y …`: one face, its corners counter-clockwise.
pub fn polygon(words: &[&str]) -> Result<Dcel, String> {
    let corners = points(words)?;
    if corners.len() < 3 {
        return Err(format!("a polygon has at least 3 corners, not {}", corners.len()));
    }
    Ok(polygon_of(&corners))
}

fn polygon_of(corners: &[[f64; 2]]) -> Dcel {
    let n = corners.len();
    let mut dcel = Dcel::default();
    let outside = dcel.new_face();
    let inside = dcel.new_face();
    dcel.outer_face = outside;
    for &[x, y] in corners {
        dcel.new_vertex(x, y);
    }
    for v in 0..n {
        new_edge(&mut dcel, v, (v + 1) % n, inside, outside);
    }
    for k in 0..n {
        let after = (k + 1) % n;
        dcel.make_next(2 * k, 2 * after);
        dcel.make_next(2 * after + 1, 2 * k + 1);
        dcel.vertices[k].outgoing_half_edge = Some(2 * k);
    }
    dcel.faces[inside].incident_half_edge = Some(0);
    dcel.faces[outside].incident_half_edge = Some(1);
    dcel
}

/// Both sides of a new edge; returns the side that runs from `a` to `b`.
fn new_edge(dcel: &mut Dcel, a: VertexId, b: VertexId, left: FaceId, right: FaceId) -> HalfEdgeId {
    let there = dcel.new_half_edge(a);
    let back = dcel.new_half_edge(b);
    dcel.half_edges[there].face = Some(left);
    dcel.half_edges[back].face = Some(right);
    dcel.make_twin(there, back);
    there
}

/// `triangles x y x y … / i j k …`: points, then the corners of counter-clockwise triangles by number from 0. Their
/// border must be one closed line. Every search here is linear: this is for small cases.
pub fn triangles(words: &[&str]) -> Result<Dcel, String> {
    let mut halves = words.split(|&word| word == "/");
    let (Some(coordinates), Some(corners), None) = (halves.next(), halves.next(), halves.next()) else {
        return Err("write the points, one `/`, then the corners of the triangles".to_owned());
    };
    let corners: Vec<usize> = corners.iter().map(|word| whole(word)).collect::<Result<_, _>>()?;
    if corners.is_empty() || !corners.len().is_multiple_of(3) {
        return Err(format!("triangles have 3 corners each; {} corners are left over", corners.len() % 3));
    }
    let mut dcel = Dcel::default();
    dcel.outer_face = dcel.new_face();
    for [x, y] in points(coordinates)? {
        dcel.new_vertex(x, y);
    }
    for (number, triangle) in corners.chunks(3).enumerate() {
        add_triangle(&mut dcel, triangle).map_err(|problem| format!("triangle {number}: {problem}"))?;
    }
    close_border(&mut dcel)?;
    Ok(dcel)
}

fn add_triangle(dcel: &mut Dcel, corners: &[usize]) -> Result<(), String> {
    let n = dcel.vertices.len();
    if let Some(missing) = corners.iter().find(|&&v| v >= n) {
        return Err(format!("there is no point {missing}: there are {n}"));
    }
    let &[a, b, c] = corners else { return Err("a triangle has 3 corners".to_owned()) };
    let [p, q, r] = [a, b, c].map(|v| dcel.vertices[v].pos);
    if (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x) <= 0.0 {
        return Err("its corners are not counter-clockwise".to_owned());
    }
    let outside = dcel.outer_face;
    let face = dcel.new_face();
    let mut sides = Vec::new();
    for (from, to) in [(a, b), (b, c), (c, a)] {
        let known = (0..dcel.half_edges.len())
            .find(|&h| dcel.half_edges[h].origin == Some(from) && dcel.half_edges[h ^ 1].origin == Some(to));
        let side = match known {
            None => new_edge(dcel, from, to, face, outside),
            Some(h) if dcel.half_edges[h].face == Some(outside) => h,
            Some(_) => return Err(format!("the side from {from} to {to} belongs to another triangle already")),
        };
        dcel.half_edges[side].face = Some(face);
        dcel.vertices[from].outgoing_half_edge.get_or_insert(side);
        sides.push(side);
    }
    for i in 0..3 {
        dcel.make_next(sides[i], sides[(i + 1) % 3]);
    }
    dcel.faces[face].incident_half_edge = Some(sides[0]);
    Ok(())
}

/// Links the half-edges of the outer face, each to the one that starts where it ends.
fn close_border(dcel: &mut Dcel) -> Result<(), String> {
    let outside = dcel.outer_face;
    let border: Vec<HalfEdgeId> =
        (0..dcel.half_edges.len()).filter(|&h| dcel.half_edges[h].face == Some(outside)).collect();
    for &h in &border {
        let end = dcel.half_edges[h ^ 1].origin;
        let mut followers = border.iter().filter(|&&g| dcel.half_edges[g].origin == end);
        match (followers.next(), followers.next()) {
            (Some(&follower), None) => dcel.make_next(h, follower),
            _ => return Err("the border passes a point twice; state the structure as a table".to_owned()),
        }
    }
    let mut length = 0;
    let mut h = border[0];
    loop {
        length += 1;
        h = dcel.next(h);
        if h == border[0] {
            break;
        }
    }
    if length < border.len() {
        return Err("the border is not one closed line; state the structure as a table".to_owned());
    }
    dcel.faces[outside].incident_half_edge = Some(border[0]);
    Ok(())
}

/// A number of corners, spokes or cells.
fn count(word: &str, least: usize) -> Result<usize, String> {
    const MOST: usize = 1_000_000;
    match whole(word)? {
        n if n < least => Err(format!("it takes at least {least}, not {n}")),
        n if n > MOST => Err(format!("it takes at most {MOST}, not {n}")),
        n => Ok(n),
    }
}

/// The k-th of `n` corners of a convex polygon, counter-clockwise: they lie on the parabola y = x².
fn on_parabola(k: usize) -> [f64; 2] {
    [k as f64, (k * k) as f64]
}

/// `convex N`: a polygon with N corners, counter-clockwise.
pub fn convex(words: &[&str]) -> Result<Dcel, String> {
    let &[n] = words else { return Err("it takes one number".to_owned()) };
    let corners: Vec<[f64; 2]> = (0..count(n, 3)?).map(on_parabola).collect();
    Ok(polygon_of(&corners))
}

/// `wheel N`: N triangles round v0. Each states its edges in the order of `triangles`: from v0 outwards, along the rim,
/// back to v0.
pub fn wheel(words: &[&str]) -> Result<Dcel, String> {
    let &[n] = words else { return Err("it takes one number".to_owned()) };
    let n = count(n, 3)?;
    let mut dcel = Dcel::default();
    dcel.outer_face = dcel.new_face();
    // Half-way up from the parabola to the chord that closes it.
    let (middle, last) = ((n - 1) as f64 / 2.0, (n - 1) as f64);
    dcel.new_vertex(middle, (middle * middle + middle * last) / 2.0);
    for [x, y] in (0..n).map(on_parabola) {
        dcel.new_vertex(x, y);
    }
    for k in 0..n {
        dcel.new_face();
        // Spoke k is the edge 2k, the piece of the rim after it is the edge 2k + 1.
        new_edge(&mut dcel, 0, k + 1, k + 1, if k == 0 { n } else { k });
        new_edge(&mut dcel, k + 1, (k + 1) % n + 1, k + 1, 0);
    }
    for k in 0..n {
        let (spoke, rim, other) = (4 * k, 4 * k + 2, 4 * ((k + 1) % n) + 1);
        dcel.make_next(spoke, rim);
        dcel.make_next(rim, other);
        dcel.make_next(other, spoke);
        dcel.make_next(4 * ((k + 1) % n) + 3, rim + 1);
        dcel.faces[k + 1].incident_half_edge = Some(spoke);
        dcel.vertices[k + 1].outgoing_half_edge = Some(rim);
    }
    dcel.vertices[0].outgoing_half_edge = Some(0);
    dcel.faces[0].incident_half_edge = Some(3);
    Ok(dcel)
}

/// `grid N M`: N times M square cells, row by row from below. First all edges to the right, row by row, then all edges
/// upwards.
///
/// ```text
///   v4 ── e2 ─▶ v5 ── e3 ─▶ v6          grid 2 1: f1 on the left, f2 on the right
///   ▲           ▲           ▲
///   e4    f1    e5    f2    e6          e0 has the half-edges h0, on its left, and h1, and so on
///   │           │           │
///   v0 ── e0 ─▶ v1 ── e1 ─▶ v2
/// ```
pub fn grid(words: &[&str]) -> Result<Dcel, String> {
    let &[n, m] = words else { return Err("it takes two numbers".to_owned()) };
    let (n, m) = (count(n, 1)?, count(m, 1)?);
    count(&n.saturating_mul(m).to_string(), 1)?;
    let mut dcel = Dcel::default();
    for _ in 0..=n * m {
        dcel.new_face();
    }
    for y in 0..=m {
        for x in 0..=n {
            dcel.new_vertex(x as f64, y as f64);
        }
    }
    let vertex = |x: usize, y: usize| y * (n + 1) + x;
    let cell = |x: usize, y: usize| if x < n && y < m { 1 + y * n + x } else { 0 };
    let right = |x: usize, y: usize| 2 * (y * n + x);
    let up = |x: usize, y: usize| 2 * (n * (m + 1) + y * (n + 1) + x);
    for y in 0..=m {
        for x in 0..n {
            new_edge(&mut dcel, vertex(x, y), vertex(x + 1, y), cell(x, y), cell(x, y.wrapping_sub(1)));
        }
    }
    for y in 0..m {
        for x in 0..=n {
            new_edge(&mut dcel, vertex(x, y), vertex(x, y + 1), cell(x.wrapping_sub(1), y), cell(x, y));
        }
    }
    for y in 0..m {
        for x in 0..n {
            let sides = [right(x, y), up(x + 1, y), right(x, y + 1) + 1, up(x, y) + 1];
            link_cycle(&mut dcel, &sides);
            dcel.faces[cell(x, y)].incident_half_edge = Some(sides[0]);
            dcel.vertices[vertex(x, y)].outgoing_half_edge = Some(sides[0]);
        }
        dcel.vertices[vertex(n, y)].outgoing_half_edge = Some(up(n, y));
    }
    for x in 0..=n {
        dcel.vertices[vertex(x, m)].outgoing_half_edge = Some(if x < n { right(x, m) } else { up(n, m - 1) + 1 });
    }
    // The half-edges of the outer face run clockwise round the grid.
    let mut border: Vec<HalfEdgeId> = (0..m).map(|y| up(0, y)).collect();
    border.extend((0..n).map(|x| right(x, m)));
    border.extend((0..m).rev().map(|y| up(n, y) + 1));
    border.extend((0..n).rev().map(|x| right(x, 0) + 1));
    link_cycle(&mut dcel, &border);
    dcel.faces[0].incident_half_edge = Some(border[0]);
    Ok(dcel)
}

fn link_cycle(dcel: &mut Dcel, cycle: &[HalfEdgeId]) {
    for (i, &h) in cycle.iter().enumerate() {
        dcel.make_next(h, cycle[(i + 1) % cycle.len()]);
    }
}
