//! What counting tells of a surface: Euler's number, missing edges, regularity, the genus.

use super::surface::Surface;
use crate::answers::Wrong;
use crate::fault::Exchange;
use crate::protocol::Value;

/// Vertices, edges, faces.
pub(super) fn counts(surface: &Surface) -> [i64; 3] {
    [surface.points.len(), surface.half_edges().count() / 2, surface.faces().count()].map(|count| count as i64)
}

pub(super) fn euler_of(surface: &Surface) -> i64 {
    let [v, e, f] = counts(surface);
    v - e + f
}

/// For each vertex the number of its part, and how many parts there are.
pub(super) fn parts_of(surface: &Surface) -> (Vec<usize>, usize) {
    let mut part = vec![usize::MAX; surface.points.len()];
    let mut count = 0;
    for root in 0..part.len() {
        if part[root] != usize::MAX {
            continue;
        }
        let mut open = vec![root];
        part[root] = count;
        while let Some(v) = open.pop() {
            for w in surface.spokes(v as u32).into_iter().filter_map(|h| surface.end(h)) {
                if let Some(of) = part.get_mut(w as usize).filter(|of| **of == usize::MAX) {
                    *of = count;
                    open.push(w as usize);
                }
            }
        }
        count += 1;
    }
    (part, count)
}

/// How many edges cut all faces into triangles, face by face.
fn cuts(surface: &Surface) -> i64 {
    surface.faces().map(|f| surface.of_face(f).len() as i64 - 3).sum()
}

/// Corners of each face, edges at each vertex.
pub(super) fn sizes(surface: &Surface) -> [Vec<usize>; 2] {
    let faces = surface.faces().map(|f| surface.of_face(f).len()).collect();
    [faces, (0..surface.points.len() as u32).map(|v| surface.spokes(v).len()).collect()]
}

/// The one number that all are.
pub(super) fn common(sizes: &[usize]) -> Option<usize> {
    sizes.first().copied().filter(|first| sizes.iter().all(|size| size == first))
}

pub(super) fn euler(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let surface = Surface::of(exchange.records_before()?);
    let [v, e, f] = counts(&surface);
    let expected = v - e + f;
    let [Value::Number(found)] = values else { return Some(Wrong::kind("one number")) };
    let found = *found as i64;
    (found != expected).then(|| {
        Wrong::value(&Value::Number(expected as f64), format!("there are {v} vertices, {e} edges and {f} faces")).is([
            (found == v - 2 * e + f, "V - 2E + F, half-edges counted for edges"),
            (found == v + e - f, "V + E - F, with the signs of edges and faces exchanged"),
            (found == 2, "2, which is right for one part without handles only"),
        ])
    })
}

pub(super) fn missing_edges(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let surface = Surface::of(exchange.records_before()?);
    let [v, e, _] = counts(&surface);
    let expected = cuts(&surface);
    let [Value::Number(found)] = values else { return Some(Wrong::kind("one number")) };
    let found = *found as i64;
    let listed = surface.table.half_edges.len() as i64 - 3 * surface.table.faces.len() as i64;
    (found != expected).then(|| {
        Wrong::value(&Value::Number(expected as f64), "a face with k corners takes k - 3 more edges").is([
            (found == 3 * v - 6 - e, "3V - 6 - E, which is right only if V - E + F is 2"),
            (found == listed, "what the lengths of the lists give, with what was removed"),
            (found == -expected, "the opposite sign"),
        ])
    })
}

pub(super) fn regular(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let surface = Surface::of(exchange.records_before()?);
    let [faces, vertices] = sizes(&surface);
    let Some((p, q)) = common(&faces).zip(common(&vertices)) else {
        let unlike = |sizes: &[usize], one: &str, has: &str| {
            let other = sizes.iter().position(|&size| size != sizes[0])?;
            Some(format!("one {one} has {} {has} and another {}", sizes[0], sizes[other]))
        };
        let because = unlike(&faces, "face", "corners").or_else(|| unlike(&vertices, "vertex", "edges"))?;
        let is_refused = matches!(values, [Value::Refusal(_)]);
        return (!is_refused)
            .then(|| Wrong { expected: Some("None".to_owned()), ..Wrong::because("regular", because) });
    };
    let because = format!("every face has {p} corners and every vertex {q} edges");
    if let [Value::Refusal(_)] = values {
        return Some(Wrong { expected: Some(format!("{p} {q}")), ..Wrong::because("refused", because) });
    }
    let found: Vec<usize> = values.iter().filter_map(Value::id).map(|id| id as usize).collect();
    (found != [p, q]).then(|| {
        let wrong = Wrong { expected: Some(format!("{p} {q}")), ..Wrong::because("pair", because) };
        wrong.is([(found == [q, p], "the two numbers exchanged")])
    })
}

pub(super) fn genus(exchange: &Exchange, values: &[Value]) -> Option<Wrong> {
    let surface = Surface::of(exchange.records_before()?);
    let (part, parts) = parts_of(&surface);
    if parts == 1 {
        let expected = (2 - euler_of(&surface)) / 2;
        if let [Value::Refusal(_)] = values {
            let because = "edges lead from vertex 0 to all vertices, so the answer is an Ok";
            return Some(Wrong { expected: Some(expected.to_string()), ..Wrong::because("refused", because) });
        }
        let [Value::Id(found)] = values else { return Some(Wrong::kind("a genus")) };
        let found = i64::from(*found);
        return (found != expected).then(|| {
            let expected_words = Value::Id(expected as u32);
            Wrong::value(&expected_words, "V - E + F = 2 - 2g").is([
                (found == 2 * expected, "2g instead of g"),
                (found > i64::from(i32::MAX), "a negative number, which an unsigned type cannot hold"),
            ])
        });
    }
    let [Value::Refusal(named)] = values else {
        return Some(Wrong::because("accepted", "the surface is not connected, so the answer is an Err"));
    };
    let vertex = named.strip_prefix('v').and_then(|number| number.parse::<usize>().ok());
    let is_apart = vertex.and_then(|v| part.get(v)).is_some_and(|&of| of != part[0]);
    (!is_apart).then(|| Wrong::because("names", "edges lead from vertex 0 to that vertex, or there is no such vertex"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::courses::polyhedra::shapes;
    use dcel_kit::topology::View;

    #[test]
    fn missing_edges_are_what_the_formula_of_planar_graphs_says_where_it_holds() {
        for (name, faces) in shapes::all() {
            let surface = shapes::blind(&faces);
            let [v, e, f] = counts(&surface);
            assert_eq!(cuts(&surface), 2 * e - 3 * f, "{name}");
            assert_eq!(cuts(&surface), 3 * v - 3 * (v - e + f) - e, "{name}");
            assert_eq!(surface.table.half_edges.len() as i64, 2 * e, "{name}");
            assert!(surface.table.face(dcel_kit::HalfEdgeId::new(0)).is_some(), "{name}");
        }
    }
}
