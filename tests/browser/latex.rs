//! Figures in LaTeX: each is a document of one page, of the size of the figure.

use crate::trials::trials;
use dcel_kit::VertexId;
use dcel_kit::figure::{self, Camera, Figure, FigureOptions, HiddenLines, Overrides, Style, Theme, algorithms};
use dcel_kit::plane::{Point, Subdivision};
use dcel_kit::solid::{Platonic, Polyhedron};
use std::process::Command;

/// All that a figure can hold: names, arrows, hatches, dashes, curves, circles, clipped parts, signs that mean something
/// to TeX, small letters, and the colours for dark pages.
fn figures() -> Vec<Figure> {
    let lab = super::lab();
    let sites = [(0., 0.), (6., 1.), (2., 5.), (7., 6.), (3., 2.)].map(Point::from);
    let delaunay = Subdivision::delaunay(&sites).unwrap().subdivision;
    let strange =
        Overrides::default().label(VertexId::new(0), "50% of $x_1 & {y}^~#\\").label(VertexId::new(1), "e_12");
    let dark = Style::default().theme(Theme::Dark);
    let cube = Polyhedron::platonic(Platonic::Cube);
    vec![
        figure::structure(&lab, &FigureOptions::new("Lab & \"more\"").overrides(strange)).unwrap(),
        figure::structure(&lab, &FigureOptions::new("Lab").style(dark).crop([-100.0, -100.0], [200.0, 200.0])).unwrap(),
        figure::focus(&lab, dcel_kit::HalfEdgeId::new(3), &FigureOptions::new("Focus")).unwrap(),
        figure::solid(&cube, &Camera::default(), HiddenLines::Dashed, &FigureOptions::new("Cube")).unwrap(),
        algorithms::voronoi(&delaunay, 4).unwrap().strip(&FigureOptions::new("Voronoi")).unwrap(),
        figure::records(&FigureOptions::new("Records")),
    ]
}

fn every_kind_of_figure_is_a_page_of_latex() {
    for (i, figure) in figures().iter().enumerate() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("figure.tex"), figure.to_tex()).unwrap();
        let arguments = ["-interaction=nonstopmode", "-halt-on-error", "figure.tex"];
        let made = Command::new("pdflatex").current_dir(folder.path()).args(arguments).output().unwrap();
        assert!(made.status.success(), "figure {i}: {}", String::from_utf8_lossy(&made.stdout));
        let log = String::from_utf8_lossy(&std::fs::read(folder.path().join("figure.log")).unwrap()).into_owned();
        assert!(log.contains("(1 page"), "figure {i}: {log}");
        assert!(!log.contains("Overfull"), "figure {i}: {log}");
    }
}

trials! {
    every_kind_of_figure_is_a_page_of_latex: Latex;
}
