//! Points with the triangulation or the diagram that belongs to them, made anew for every place of a dragged point.

use super::canvas::{Canvas, Over};
use crate::plane::{Point, Subdivision, Window};

/// No more points are taken: each frame of a drag makes everything anew.
const MOST: usize = 2000;

crate::named! {
    /// What is drawn over the triangulation.
    #[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
    pub(super) enum Layer {
        #[default]
        Nothing = "delaunay",
        Circles = "circles",
        Voronoi = "voronoi",
    }

    /// The word for it.
    fn word;
    /// All of them.
    const ALL;
}

impl Layer {
    pub(super) fn of(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|layer| layer.word() == word)
    }
}

/// Points, their triangulation, and the points before each change.
#[derive(Clone, Debug, Default)]
pub(super) struct Points {
    points: Vec<Point>,
    delaunay: Subdivision,
    past: Vec<Vec<Point>>,
    undone: Vec<Vec<Point>>,
    pub(super) layer: Layer,
}

impl Points {
    /// The points, all of different places.
    pub(super) fn new(points: Vec<Point>) -> Result<Self, String> {
        let mut scene = Self::default();
        scene.set(points)?;
        Ok(scene)
    }

    pub(super) fn points(&self) -> &[Point] {
        &self.points
    }

    pub(super) fn delaunay(&self) -> &Subdivision {
        &self.delaunay
    }

    pub(super) fn history(&self) -> [bool; 2] {
        [!self.past.is_empty(), !self.undone.is_empty()]
    }

    /// These points from now on. On an error everything stays.
    fn set(&mut self, points: Vec<Point>) -> Result<(), String> {
        if points.len() > MOST {
            return Err(format!("{} points: {MOST} can be moved here; `dcel delaunay` takes any number", points.len()));
        }
        let built = Subdivision::delaunay(&points).map_err(|error| error.to_string())?;
        if let Some(&(_, first)) = built.repeated.first() {
            return Err(format!("v{first} is there already; choose another place"));
        }
        self.delaunay = built.subdivision;
        self.points = points;
        Ok(())
    }

    /// As [`set`](Self::set), to be undone.
    fn change(&mut self, points: Vec<Point>) -> Result<(), String> {
        let before = self.points.clone();
        self.set(points)?;
        self.past.push(before);
        self.undone.clear();
        Ok(())
    }

    pub(super) fn add(&mut self, p: Point) -> Result<(), String> {
        let mut points = self.points.clone();
        points.push(p);
        self.change(points)
    }

    pub(super) fn remove(&mut self, i: usize) -> Result<(), String> {
        let mut points = self.points.clone();
        if i < points.len() {
            points.remove(i);
        }
        self.change(points)
    }

    /// The points with one of them at another place.
    fn moved(&self, i: usize, p: Point) -> Vec<Point> {
        let mut points = self.points.clone();
        points.get_mut(i).into_iter().for_each(|at| *at = p);
        points
    }

    pub(super) fn place(&mut self, i: usize, p: Point) -> Result<(), String> {
        self.change(self.moved(i, p))
    }

    /// The triangulation with a point held over a place; nothing is kept.
    pub(super) fn held(&self, i: usize, p: Point) -> Result<Self, String> {
        let mut held = Self { past: Vec::new(), undone: Vec::new(), ..self.clone() };
        held.set(self.moved(i, p))?;
        Ok(held)
    }

    pub(super) fn undo(&mut self) -> bool {
        let Some(before) = self.past.pop() else { return false };
        let now = self.points.clone();
        // They were there before.
        let done = self.set(before).is_ok();
        self.undone.push(now);
        done
    }

    pub(super) fn redo(&mut self) -> bool {
        let Some(after) = self.undone.pop() else { return false };
        let now = self.points.clone();
        let done = self.set(after).is_ok();
        self.past.push(now);
        done
    }

    /// The circles or the diagram, over the picture of the triangulation.
    pub(super) fn over(&self, canvas: &Canvas) -> String {
        let mut over = Over::default();
        let Ok(voronoi) = self.delaunay.voronoi() else { return String::new() };
        match self.layer {
            Layer::Nothing => {}
            Layer::Circles => {
                for f in self.delaunay.faces() {
                    let corner = voronoi.corner_of(f).and_then(|i| voronoi.corners().get(i as usize));
                    let rim = self.delaunay.half_edge(f).map(|h| self.delaunay.point(self.delaunay.origin(h)));
                    let (Some(&corner), Some(rim)) = (corner, rim) else { continue };
                    if let (Some(centre), Some(rim)) = (canvas.place(corner), canvas.place(rim)) {
                        over.circle("circle", centre, (rim - centre).length());
                    }
                }
            }
            Layer::Voronoi => {
                let Some([low, high]) = canvas.frame() else { return String::new() };
                let window = Window { low, high };
                for edge in voronoi.edges() {
                    let Some([a, b]) = voronoi.piece(edge, &window) else { continue };
                    if let (Some(a), Some(b)) = (canvas.place(a), canvas.place(b)) {
                        over.line("voronoi", a, b);
                    }
                }
            }
        }
        over.0
    }
}
