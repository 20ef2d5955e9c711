//! Areas of a map and what a unit of length costs in them: faces by their numbers, by a name, or inside a polygon.

use super::super::failure::Failure;
use super::numbers::number;
use dcel_kit::io::{Labels, PolygonSoup, closest};
use dcel_kit::plane::predicates::orientation;
use dcel_kit::plane::{Location, Point, PointIndex, Subdivision, TriangulationMethod, rounding_room};
use dcel_kit::{FaceId, FaceMap, HalfEdgeId};
use std::collections::BTreeSet;

/// An area and what it costs.
#[derive(Clone, Debug)]
pub(super) struct Area {
    place: AreaPlace,
    cost: f64,
}

#[derive(Clone, Debug)]
enum AreaPlace {
    Faces(Vec<[FaceId; 2]>),
    /// By a group, object, material, or the name of a face itself.
    Named(String),
    /// The corners as the file has them.
    Inside(Vec<[f64; 2]>),
}

/// An area of the command line.
pub(super) fn area(text: &str) -> Result<Area, String> {
    let form = || "write it like f3=2.5, f3,f7-f9=2.5, mud=2.5 or 0,0,4,0,4,3=2.5".to_owned();
    let (place, cost) = text.rsplit_once('=').ok_or_else(form)?;
    let cost = number(cost.trim())?;
    if cost < 0.0 {
        return Err("a cost is 0 or more".to_owned());
    }
    let place = place.trim();
    if place.is_empty() {
        return Err(form());
    }
    let words: Vec<&str> = place.split(',').map(str::trim).collect();
    if let Ok(numbers) = words.iter().map(|word| number(word)).collect::<Result<Vec<f64>, String>>() {
        if numbers.len() < 6 || !numbers.len().is_multiple_of(2) {
            return Err("an area has three corners or more: give x and y of each".to_owned());
        }
        let corners = numbers.chunks_exact(2).map(|p| [p[0], p[1]]).collect();
        return Ok(Area { place: AreaPlace::Inside(corners), cost });
    }
    let face = |word: &str| word.trim().parse::<FaceId>().ok();
    let range = |word: &&str| match word.split_once('-') {
        Some((first, last)) => Some([face(first)?, face(last)?]),
        None => face(word).map(|f| [f, f]),
    };
    let place = match words.iter().map(range).collect::<Option<Vec<_>>>() {
        Some(faces) => AreaPlace::Faces(faces),
        None => AreaPlace::Named(place.to_owned()),
    };
    Ok(Area { place, cost })
}

/// The names of the faces of a file, and the map before its faces were cut, if they were.
#[derive(Default)]
pub(super) struct Names {
    labels: Labels,
    own: Vec<Option<String>>,
    before: Option<PointIndex>,
}

impl Names {
    pub(super) fn of(soup: &PolygonSoup) -> Self {
        Self { labels: soup.labels.clone(), own: soup.names.clone(), before: None }
    }

    /// Whether there is any name.
    pub(super) fn is_empty(&self) -> bool {
        self.own.iter().flatten().next().is_none() && self.labels.names().is_empty()
    }

    /// Remembers the map as it was before faces were cut.
    pub(super) fn remember(&mut self, map: &Subdivision) {
        self.before = Some(PointIndex::new(map.clone()));
    }

    /// Whether a face of the file has the name.
    fn has(&self, face: FaceId, name: &str) -> bool {
        let Some(i) = face.index().checked_sub(1) else { return false };
        let own = self.own.get(i).and_then(Option::as_deref);
        own == Some(name) || self.labels.of(i).iter().any(|label| label == name)
    }

    /// All names, in the order of the alphabet.
    fn all(&self) -> Vec<&str> {
        let mut all: BTreeSet<&str> = self.labels.names().into_iter().collect();
        all.extend(self.own.iter().flatten().map(String::as_str));
        all.into_iter().collect()
    }
}

/// The faces of a map or a surface, as far as areas ask for them.
pub(super) struct Faces<'a> {
    pub(super) source: &'a str,
    pub(super) bound: usize,
    pub(super) all: Vec<FaceId>,
    pub(super) names: &'a Names,
    /// A point inside a face, in the coordinates of the map.
    pub(super) inside: &'a dyn Fn(FaceId) -> Point,
    /// A point of the file, in those of the map; none on a surface, whose faces cannot be cut.
    pub(super) place: Option<&'a dyn Fn([f64; 2]) -> Point>,
}

impl Faces<'_> {
    /// What a unit of length costs in each face; `None` if no area was given. Of areas that overlap the last counts.
    pub(super) fn costs(&self, areas: &[Area]) -> Result<Option<FaceMap<f64>>, Failure> {
        if areas.is_empty() {
            return Ok(None);
        }
        let mut costs = FaceMap::filled(self.bound, 1.0);
        for Area { place, cost } in areas {
            for f in self.of(place)? {
                costs[f] = *cost;
            }
        }
        Ok(Some(costs))
    }

    fn of(&self, place: &AreaPlace) -> Result<Vec<FaceId>, Failure> {
        let wrong = |what: String, help: String| Failure::input(format!("{}: --cost: {what}", self.source), help);
        match place {
            AreaPlace::Faces(ranges) => {
                let numbers = ranges.iter().flat_map(|&[first, last]| first.number()..=last.number());
                let faces: Vec<FaceId> = numbers.map(FaceId::new).take(self.bound + 1).collect();
                match faces.iter().find(|f| self.all.binary_search(f).is_err()) {
                    Some(f) => {
                        let help = "dcel navmesh locate tells the face of a point";
                        Err(wrong(format!("{f} is no face of the mesh"), help.to_owned()))
                    }
                    None => Ok(faces),
                }
            }
            AreaPlace::Named(name) => {
                let was = |f: FaceId| match &self.names.before {
                    Some(index) => match index.locate((self.inside)(f)) {
                        Location::Face(before) => before,
                        _ => f,
                    },
                    None => f,
                };
                let faces: Vec<FaceId> = self.all.iter().copied().filter(|&f| self.names.has(was(f), name)).collect();
                if !faces.is_empty() {
                    return Ok(faces);
                }
                let all = self.names.all();
                let help = match closest(name, all.iter().copied()) {
                    _ if all.is_empty() => "this file names no faces: give faces by number, or corners".to_owned(),
                    Some(close) => format!("did you mean {close}?"),
                    None => format!("the names are {}", all.into_iter().take(10).collect::<Vec<_>>().join(", ")),
                };
                Err(wrong(format!("no face has the name `{name}`"), help))
            }
            AreaPlace::Inside(corners) => {
                let Some(place) = self.place else {
                    let what = "an area with corners cannot be used where heights differ: faces would be cut";
                    return Err(wrong(what.to_owned(), "name the faces, or a group or material of them".to_owned()));
                };
                let corners: Vec<Point> = corners.iter().map(|&p| place(p)).collect();
                Ok(self.all.iter().copied().filter(|&f| is_inside(&corners, (self.inside)(f))).collect())
            }
        }
    }
}

/// Whether a point is inside corners, by the even-odd rule. Exact, but for points on the line round them.
fn is_inside(corners: &[Point], p: Point) -> bool {
    let sides = corners.iter().zip(corners.iter().cycle().skip(1));
    let crossed = sides.filter(|&(&a, &b)| {
        let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
        low.y <= p.y && p.y < high.y && orientation(low, high, p).is_gt()
    });
    crossed.count() % 2 == 1
}

/// Cuts a map along the sides of all areas with corners, and into triangles, so that each face lies in an area or not.
/// `place` takes points of the file to those of the map. Returns whether there was anything to cut.
pub(super) fn cut_along(
    areas: &[Area],
    source: &str,
    map: &mut Subdivision,
    place: impl Fn([f64; 2]) -> Point,
) -> Result<(), Failure> {
    let outlines: Vec<Vec<Point>> = areas
        .iter()
        .filter_map(|area| match &area.place {
            AreaPlace::Inside(corners) => Some(corners.iter().map(|&p| place(p)).collect()),
            _ => None,
        })
        .collect();
    if outlines.is_empty() {
        return Ok(());
    }
    let failure = |error: &dyn std::fmt::Display| Failure::input(format!("{source}: --cost: {error}"), "");
    let before = PointIndex::new(map.clone());
    // Sides meet where it cannot be told to the last place: they are led through what is that near.
    let corners = map.vertices().map(|v| map.point(v)).chain(outlines.iter().flatten().copied());
    let near = rounding_room(corners);
    for outline in &outlines {
        for (&p, &q) in outline.iter().zip(outline.iter().cycle().skip(1)) {
            map.insert_segment_within(p, q, near).map_err(|error| failure(&error))?;
        }
    }
    let given = map.edge_bound();
    map.triangulate(TriangulationMethod::default()).map_err(|error| failure(&error))?;
    map.make_delaunay(|edge| edge.index() < given);
    // What sides of areas enclose beyond the map is none of it.
    let bounded: Vec<FaceId> = map.faces().filter(|&f| f != map.outer_face() && !map.is_hole(f)).collect();
    for f in bounded {
        let corners: Vec<Point> = map.incident_half_edges(f).map(|h: HalfEdgeId| map.point(map.origin(h))).collect();
        let was = before.locate(middle(&corners));
        let is_out = matches!(was, Location::Face(was) if was == before.subdivision().outer_face() || before.subdivision().is_hole(was));
        if is_out {
            map.set_hole(f, true);
        }
    }
    Ok(())
}

/// The mean of points.
pub(super) fn middle(points: &[Point]) -> Point {
    let share = 1.0 / points.len().max(1) as f64;
    points.iter().fold(Point::default(), |sum, p| Point::new(sum.x + share * p.x, sum.y + share * p.y))
}
