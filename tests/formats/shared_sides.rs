//! Polygons on a small grid that share sides, parts of sides and corners, wrongly: whatever the message says of two rings
//! is true of them. The judge has whole numbers and its own ideas.

use crate::support::Random;
use dcel_kit::io::{Format, LoadOptions, ReadOptions, assemble, read_bytes};
use std::collections::BTreeMap;
use std::fmt::Write as _;

type P = [i64; 2];
type Ring = Vec<P>;

fn turn([ax, ay]: P, [bx, by]: P, [cx, cy]: P) -> i64 {
    (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
}

fn sides(ring: &Ring) -> impl Iterator<Item = [P; 2]> + '_ {
    (0..ring.len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]])
}

/// Whether a point lies on a side, its ends with it.
fn on([a, b]: [P; 2], p: P) -> bool {
    let between = |i: usize| a[i].min(b[i]) <= p[i] && p[i] <= a[i].max(b[i]);
    turn(a, b, p) == 0 && between(0) && between(1)
}

/// How many sides of a ring run along the whole of this one.
fn runs_along(ring: &Ring, [p, q]: [P; 2]) -> usize {
    sides(ring).filter(|&side| p != q && on(side, p) && on(side, q)).count()
}

fn is_on(ring: &Ring, p: P) -> bool {
    sides(ring).any(|side| on(side, p))
}

/// Whether a ring goes round a point that does not lie on it.
fn goes_round(ring: &Ring, p: P) -> bool {
    let crossed = |&[a, b]: &[P; 2]| (a[1] > p[1]) != (b[1] > p[1]) && (turn(a, b, p) > 0) == (b[1] > a[1]);
    sides(ring).filter(crossed).count() % 2 == 1
}

/// A point close to the middle of a side, on its left, all measures 1000 times as long.
fn beside([p, q]: [P; 2], left: bool) -> P {
    let sign = if left { 1 } else { -1 };
    [500 * (p[0] + q[0]) - sign * (q[1] - p[1]), 500 * (p[1] + q[1]) + sign * (q[0] - p[0])]
}

fn scaled(ring: &Ring) -> Ring {
    ring.iter().map(|p| p.map(|x| 1000 * x)).collect()
}

/// The polygons by feature, ring by ring.
struct Map(Vec<Vec<Ring>>);

impl Map {
    /// One to three polygons of triangles and rectangles; holes begin at corners of what is there, often.
    fn random(random: &mut Random) -> Self {
        let mut known: Vec<P> = Vec::new();
        let mut point = |random: &mut Random, size: usize| {
            let p = match known.len() {
                0 => [0, 0],
                _ if random.below(2) == 0 => known[random.below(known.len())],
                _ => [random.below(size) as i64, random.below(size) as i64],
            };
            known.push(p);
            p
        };
        let mut ring = |random: &mut Random| loop {
            let [a, b, c] = [(); 3].map(|()| point(random, 5));
            let mut ring: Ring = match random.below(3) {
                0 => vec![a, [b[0], a[1]], b, [a[0], b[1]]],
                _ => vec![a, b, c],
            };
            if turn(ring[0], ring[1], ring[2]) == 0 {
                continue;
            }
            if random.below(2) == 0 {
                ring.reverse();
            }
            let first = random.below(ring.len());
            ring.rotate_left(first);
            return ring;
        };
        let polygon = |random: &mut Random, ring: &mut dyn FnMut(&mut Random) -> Ring| {
            let shell = if random.below(2) == 0 { vec![[0, 0], [4, 0], [4, 4], [0, 4]] } else { ring(random) };
            let mut rings = vec![shell];
            (0..random.below(3)).for_each(|_| rings.push(ring(random)));
            rings
        };
        Self((0..=random.below(3)).map(|_| polygon(random, &mut ring)).collect())
    }

    fn text(&self) -> String {
        let mut text = "{\"type\":\"FeatureCollection\",\"features\":[".to_owned();
        for (i, rings) in self.0.iter().enumerate() {
            let closed = |ring: &Ring| ring.iter().chain(&ring[..1]).copied().collect::<Vec<P>>();
            let rings: Vec<Ring> = rings.iter().map(closed).collect();
            let comma = if i == 0 { "" } else { "," };
            let _ = write!(
                text,
                "{comma}{{\"type\":\"Feature\",\"properties\":null,\"geometry\":{{\"type\":\"Polygon\",\"coordinates\":{rings:?}}}}}"
            );
        }
        text + "]}"
    }

    fn ring(&self, [f, r]: [usize; 2]) -> &Ring {
        &self.0[f][r]
    }

    /// Whether a polygon covers a point, of 1000 times the size, that lies on none of its rings.
    fn covers(&self, f: usize, p: P) -> bool {
        let round: Vec<bool> = self.0[f].iter().map(|ring| goes_round(&scaled(ring), p)).collect();
        round[0] && !round[1..].contains(&true)
    }

    /// Whether close to a point two polygons cover the same, or two holes of one, or a hole sticks out of its shell.
    fn misfit_round(&self, [x, y]: P, one: [usize; 2], other: [usize; 2]) -> bool {
        const SIZE: i64 = 100_000;
        let large = |f: usize| -> Vec<Ring> {
            self.0[f].iter().map(|ring| ring.iter().map(|p| p.map(|x| SIZE * x)).collect()).collect()
        };
        let (ones, others) = (large(one[0]), large(other[0]));
        let covered =
            |rings: &[Ring], p: P| goes_round(&rings[0], p) && !rings[1..].iter().any(|hole| goes_round(hole, p));
        (0..360).any(|i| {
            // No other line comes so close, and none in another direction: the numbers are small.
            let (sin, cos) = (f64::from(i) + 0.37).to_radians().sin_cos();
            let p = [SIZE * x + (10_000.0 * cos) as i64, SIZE * y + (10_000.0 * sin) as i64];
            match (one[0] == other[0], one[1]) {
                (false, _) => covered(&ones, p) && covered(&others, p),
                (true, 0) => goes_round(&ones[other[1]], p) && !goes_round(&ones[0], p),
                (true, _) => goes_round(&ones[one[1]], p) && goes_round(&ones[other[1]], p),
            }
        })
    }

    /// Whether what is said is true; the kind of the message.
    fn judge(&self, message: &str) -> Result<&'static str, &'static str> {
        let message = message.split(" (features[").next().unwrap_or(message);
        let (names, points) = (rings(message), points(message));
        let is = |part: &str| message.contains(part);
        let sure = |true_: bool, kind, why| if true_ { Ok(kind) } else { Err(why) };
        let side = || [points[0], points[1]];
        let along = || names.iter().all(|&name| runs_along(self.ring(name), side()) > 0);
        let two = names.len() == 2 && names[0] != names[1];
        let same = two && names[0][0] == names[1][0];
        let round = |name: [usize; 2], left| goes_round(&scaled(self.ring(name)), beside(side(), left));
        if is("both lie on the same side of the edge") {
            let both = |left| names.iter().all(|&name| round(name, left));
            return sure(two && along() && (both(true) || both(false)), "same side", "not on one side");
        }
        if is("both polygons would lie on the same side") {
            // The hole is named once more.
            let (names, apart) = (&names[..2], names[0][0] != names[1][0]);
            let hole = names.contains(&names_of_hole(message)) && names_of_hole(message)[1] > 0;
            let along = names.iter().all(|&name| runs_along(self.ring(name), side()) > 0);
            let both = |left| names.iter().all(|&name| round(name, left) == (name[1] == 0));
            return sure(apart && hole && along && (both(true) || both(false)), "as a hole", "not on one side");
        }
        if is("so that none of the polygon lies between them") {
            let between = [true, false].iter().all(|&left| !self.covers(names[0][0], beside(side(), left)));
            return sure(same && along() && between, "in common", "not in common");
        }
        if is("lies outside of ring 0 there") {
            let apart = round(names[0], true) != round(names[1], true);
            return sure(same && names[0][1] == 0 && along() && apart, "outside", "not outside");
        }
        if is("no more than two rings") {
            let mut all = names.clone();
            all.dedup();
            return sure(all.len() > 2 && all.len() == names.len() && along(), "three rings", "not three rings");
        }
        if is("in common: they overlap") {
            let p = polygons(message);
            let all = p.iter().all(|&f| self.0[f].iter().any(|ring| runs_along(ring, side()) > 0));
            return sure(p.len() > 2 && all, "three polygons", "not three polygons");
        }
        if is("at their common") {
            let here = |&name: &[usize; 2]| is_on(self.ring(name), points[0]);
            let true_ = two && names.iter().all(here) && self.misfit_round(points[0], names[0], names[1]);
            return sure(true_, "at a corner", "nothing wrong at a common corner");
        }
        if is("run along each other from") {
            return sure(two && along(), "along each other", "not along each other");
        }
        if is(" cross at ") {
            let have = |i: usize| {
                sides(self.ring(names[i])).any(|[a, b]| {
                    let given = &points[points.len() - 4 + 2 * i..][..2];
                    given == [a, b] || given == [b, a]
                })
            };
            return sure(two && have(0) && have(1), "cross", "other sides");
        }
        if is("is cut into pieces") {
            let touch = |&p: &P| self.0[names[0][0]].iter().filter(|ring| is_on(ring, p)).count() > 1;
            // No places are told where rings cross.
            return sure(points.len() != 1 && points.iter().all(touch), "in pieces", "its rings do not touch there");
        }
        if is(" touch at ") {
            let [at, a, b] = [points[0], points[1], points[2]];
            let true_ =
                self.ring(names[0]).contains(&at) && runs_along(self.ring(names[1]), [a, b]) > 0 && on([a, b], at);
            return sure(two && true_, "touch", "do not touch");
        }
        if is("is to be a hole") {
            return sure(names[0][1] > 0 && self.ring(names[0]).contains(&points[0]), "hole outside", "not its corner");
        }
        if is("lies inside") {
            let p = polygons(message);
            let at = points[0];
            let outer = *p.last().unwrap_or(&0);
            let inside = self.covers(outer, at.map(|x| 1000 * x)) && !self.0[outer].iter().any(|ring| is_on(ring, at));
            return sure(outer != names[0][0] && self.ring(names[0]).contains(&at) && inside, "inside", "not inside");
        }
        if is("repeats") {
            let same = |mut a: Ring, mut b: Ring| {
                a.sort_unstable();
                b.sort_unstable();
                a == b
            };
            let p = polygons(message);
            let rings = if names.is_empty() { [[p[0], 0], [p[1], 0]] } else { [names[0], names[1]] };
            let whole = !names.is_empty() || rings.iter().all(|ring| self.0[ring[0]].len() == 1);
            let [one, other] = rings.map(|ring| self.ring(ring).clone());
            return sure(rings[0] != rings[1] && whole && same(one, other), "repeats", "no repetition");
        }
        if is("overlap round") {
            return sure(
                names.len() > 1 && names.iter().all(|&n| is_on(self.ring(n), points[0])),
                "round",
                "not there",
            );
        }
        if is("run along each other at") {
            let here = |&name: &[usize; 2]| is_on(self.ring(name), points[0]);
            return sure(two && names.iter().all(here), "along at", "not there");
        }
        if is("do not fit together at (") {
            let here = |&name: &[usize; 2]| is_on(self.ring(name), points[0]);
            return sure(two && names.iter().all(here), "near", "not there");
        }
        if is("does not fit what lies round its corner") {
            let strictly = |f: usize| {
                let p = points[0];
                let on_it = self.0[f].iter().any(|ring| is_on(ring, p));
                f != names[0][0] && !on_it && self.covers(f, p.map(|x| 1000 * x))
            };
            let lies = (0..self.0.len()).any(strictly);
            return sure(!lies && self.ring(names[0]).contains(&points[0]), "near", "it lies inside");
        }
        Err("not known")
    }
}

/// The numbers behind a word, with what follows them.
fn behind<'a>(text: &'a str, word: &'a str) -> impl Iterator<Item = (usize, &'a str)> {
    text.split(word).skip(1).filter_map(|rest| {
        let digits = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
        Some((rest[..digits].parse().ok()?, &rest[digits..]))
    })
}

/// The ring behind `as`.
fn names_of_hole(message: &str) -> [usize; 2] {
    message.split_once(": as ").and_then(|(_, rest)| rings(rest).first().copied()).unwrap_or([0, 0])
}

fn polygons(message: &str) -> Vec<usize> {
    behind(message, "features[").map(|(number, _)| number).collect()
}

/// `features[0] polygon 0 ring 1`, and `rings 0 and 1 of features[0] polygon 0`.
fn rings(message: &str) -> Vec<[usize; 2]> {
    if let Some((first, rest)) = behind(message, "rings ").next() {
        let second = behind(rest, " and ").next().expect("two rings").0;
        let feature = polygons(rest)[0];
        return vec![[feature, first], [feature, second]];
    }
    let ring =
        |(feature, rest): (usize, &str)| Some([feature, behind(rest.strip_prefix("] polygon 0")?, " ring ").next()?.0]);
    let all = message.match_indices("features[").map(|(at, _)| &message[at..]);
    all.filter_map(|text| {
        let end = text[1..].find("features[").map_or(text.len(), |end| end + 1);
        behind(&text[..end], "features[").next().and_then(ring)
    })
    .collect()
}

/// Those of whole coordinates, and of others [`i64::MAX`].
fn points(message: &str) -> Vec<P> {
    let inner = message.split('(').skip(1).filter_map(|rest| rest.split_once(')')).map(|(inner, _)| inner);
    let pairs = inner.filter_map(|inner| inner.split_once(", "));
    pairs.map(|(x, y)| [x, y].map(|word| word.parse().unwrap_or(i64::MAX))).collect()
}

#[test]
fn what_is_said_of_rings_that_share_sides_is_true() {
    let mut random = Random::new(20);
    let (mut seen, mut wrong) = (BTreeMap::<String, usize>::new(), Vec::new());
    for round in 0..20_000 {
        let map = Map::random(&mut random);
        let text = map.text();
        for trust in [false, true] {
            let read = read_bytes(text.as_bytes(), Format::GeoJson, "x", &ReadOptions::default()).unwrap();
            let Err(error) = assemble(read, "x", &LoadOptions { trust, ..LoadOptions::default() }) else {
                *seen.entry(format!("fits, {trust}")).or_default() += 1;
                continue;
            };
            match map.judge(&error.to_string()) {
                // Where all is checked, more than the place is known, but for holes that do not lie in their own shells.
                Ok("near") if !trust && rings(&error.to_string()).iter().all(|ring| ring[1] == 0) => {
                    wrong.push(format!("{round}: vague: {error}\n{text}"));
                }
                Ok(kind) => *seen.entry(format!("{kind}, {trust}")).or_default() += 1,
                Err(why) => wrong.push(format!("{round}, {trust}: {why}: {error}\n{text}")),
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {seen:?}\n{}", wrong.len(), wrong[..wrong.len().min(8)].join("\n"));
    for kind in [
        "same side",
        "as a hole",
        "in common",
        "outside",
        "three rings",
        "three polygons",
        "at a corner",
        "cross",
        "inside",
    ] {
        let count: usize = [false, true].iter().filter_map(|trust| seen.get(&format!("{kind}, {trust}"))).sum();
        assert!(count > 20, "too few of `{kind}`: {seen:?}");
    }
}
