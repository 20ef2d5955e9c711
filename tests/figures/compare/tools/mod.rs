//! The same small drawing made with matplotlib, svgwrite, drawsvg, cairo, TikZ, Inkscape and librsvg, right and wrong.
//!
//! The files in `tools/` are what those programs wrote; `tools/README.md` says how they were made.

use super::judge;

macro_rules! drawings {
    ($($name:ident: $file:literal, $verdict:ident $($said:literal)?;)*) => {
        $(
            #[test]
            fn $name() {
                $verdict($file, include_str!($file) $(, $said)?);
            }
        )*

        /// The names of all files.
        const FILES: &[&str] = &[$($file),*];
    };
}

const REFERENCE: &str = include_str!("reference.svg");

fn equal(file: &str, svg: &str) {
    let answer = judge(REFERENCE, svg);
    assert!(answer.is_equal(), "{file}: {}", answer.text());
}

fn says(file: &str, svg: &str, said: &str) {
    let answer = judge(REFERENCE, svg);
    assert!(answer.text().contains(said) && !answer.is_equal(), "{file}: {}", answer.text());
}

#[test]
fn every_file_of_the_folder_is_judged() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/figures/compare/tools");
    let mut found = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        if name.ends_with(".svg") && name != "reference.svg" {
            assert!(FILES.contains(&name.as_str()), "{name} has no verdict");
            found += 1;
        }
    }
    assert_eq!(found, FILES.len());
}

drawings! {
    cairo_covered: "cairo-covered.svg", says "drawn over";
    cairo_edge_missing: "cairo-edge-missing.svg", says "is missing";
    cairo_hollow: "cairo-hollow.svg", equal;
    cairo_plain: "cairo-plain.svg", equal;
    cairo_vertex_moved: "cairo-vertex-moved.svg", says "4 px away: yours lies at";
    cairosvg_group_flipped: "cairosvg-group-flipped.svg", equal;
    cairosvg_symbols: "cairosvg-symbols.svg", equal;
    cairosvg_vertex_moved: "cairosvg-vertex-moved.svg", says "4 px away: yours lies at";
    drawsvg_arrow_markers: "drawsvg-arrow-markers.svg", equal;
    drawsvg_edge_missing: "drawsvg-edge-missing.svg", says "is missing";
    drawsvg_faces_last: "drawsvg-faces-last.svg", says "drawn over";
    drawsvg_nested_group: "drawsvg-nested-group.svg", equal;
    drawsvg_plain: "drawsvg-plain.svg", equal;
    drawsvg_turned: "drawsvg-turned.svg", says "turned by 40° to the right";
    drawsvg_use: "drawsvg-use.svg", equal;
    drawsvg_vertex_moved: "drawsvg-vertex-moved.svg", says "4 px away: yours lies at";
    inkscape_circles_to_path: "inkscape-circles-to-path.svg", equal;
    inkscape_combined: "inkscape-combined.svg", equal;
    inkscape_edge_missing_to_path: "inkscape-edge-missing-to-path.svg", says "is missing";
    inkscape_flipped: "inkscape-flipped.svg", says "mirrored left-right";
    inkscape_grouped: "inkscape-grouped.svg", equal;
    inkscape_lines_stroke_to_path: "inkscape-lines-stroke-to-path.svg", equal;
    inkscape_object_to_path: "inkscape-object-to-path.svg", equal;
    inkscape_plain: "inkscape-plain.svg", equal;
    inkscape_polygons_lowered: "inkscape-polygons-lowered.svg", equal;
    inkscape_polygons_raised: "inkscape-polygons-raised.svg", says "drawn over";
    inkscape_resaved: "inkscape-resaved.svg", equal;
    inkscape_rotated: "inkscape-rotated.svg", says "turned by 15° to the right";
    inkscape_stroke_to_path_edge_missing: "inkscape-stroke-to-path-edge-missing.svg", says "is missing";
    matplotlib_axes: "matplotlib-axes.svg", equal;
    matplotlib_big_markers: "matplotlib-big-markers.svg", says "make the circles smaller";
    matplotlib_collections: "matplotlib-collections.svg", equal;
    matplotlib_crosses: "matplotlib-crosses.svg", equal;
    matplotlib_crosses_vertex_moved: "matplotlib-crosses-vertex-moved.svg", says "4 px away: yours lies at";
    matplotlib_dark: "matplotlib-dark.svg", equal;
    matplotlib_edge_missing: "matplotlib-edge-missing.svg", says "is missing";
    matplotlib_extra_edge: "matplotlib-extra-edge.svg", says "is not in the reference";
    matplotlib_faces_over_lines: "matplotlib-faces-over-lines.svg", says "drawn over";
    matplotlib_hatched: "matplotlib-hatched.svg", equal;
    matplotlib_hatched_edge_missing: "matplotlib-hatched-edge-missing.svg", says "is missing";
    matplotlib_labels_as_text: "matplotlib-labels-as-text.svg", equal;
    matplotlib_legend: "matplotlib-legend.svg", equal;
    matplotlib_legend_inside: "matplotlib-legend-inside.svg", equal;
    matplotlib_legend_inside_edge_missing: "matplotlib-legend-inside-edge-missing.svg", says "is missing";
    matplotlib_legend_over_lines: "matplotlib-legend-over-lines.svg", says "is not in the reference";
    matplotlib_mirrored: "matplotlib-mirrored.svg", says "mirrored left-right";
    matplotlib_no_markers: "matplotlib-no-markers.svg", says "no vertex is drawn";
    matplotlib_one_path: "matplotlib-one-path.svg", equal;
    matplotlib_plain: "matplotlib-plain.svg", equal;
    matplotlib_pluses: "matplotlib-pluses.svg", equal;
    matplotlib_polygons_with_edges: "matplotlib-polygons-with-edges.svg", equal;
    matplotlib_squares: "matplotlib-squares.svg", equal;
    matplotlib_squares_edge_missing: "matplotlib-squares-edge-missing.svg", says "is missing";
    matplotlib_translucent_over_lines: "matplotlib-translucent-over-lines.svg", equal;
    matplotlib_transparent: "matplotlib-transparent.svg", equal;
    matplotlib_turned: "matplotlib-turned.svg", says "turned by 25° to the left";
    matplotlib_unequal_axes: "matplotlib-unequal-axes.svg", says "the drawing is stretched";
    matplotlib_vertex_moved: "matplotlib-vertex-moved.svg", says "4 px away: yours lies at";
    matplotlib_white_lines: "matplotlib-white-lines.svg", says "have the colour of the paper";
    rsvg_box_over_lines: "rsvg-box-over-lines.svg", says "drawn over";
    rsvg_css: "rsvg-css.svg", equal;
    rsvg_edge_missing: "rsvg-edge-missing.svg", says "is missing";
    rsvg_plain: "rsvg-plain.svg", equal;
    svgwrite_bar_missing: "svgwrite-bar-missing.svg", says "is missing";
    svgwrite_bars: "svgwrite-bars.svg", equal;
    svgwrite_box_over_lines: "svgwrite-box-over-lines.svg", says "drawn over";
    svgwrite_clipped_line: "svgwrite-clipped-line.svg", says "its clip-path cuts it off";
    svgwrite_css: "svgwrite-css.svg", equal;
    svgwrite_edge_missing: "svgwrite-edge-missing.svg", says "is missing";
    svgwrite_empty_dashes: "svgwrite-empty-dashes.svg", says "its dashes leave it out";
    svgwrite_faint_line: "svgwrite-faint-line.svg", says "it is almost transparent";
    svgwrite_group_flipped: "svgwrite-group-flipped.svg", equal;
    svgwrite_huge_circles: "svgwrite-huge-circles.svg", says "make the";
    svgwrite_label_on_edge: "svgwrite-label-on-edge.svg", equal;
    svgwrite_mm: "svgwrite-mm.svg", equal;
    svgwrite_one_path: "svgwrite-one-path.svg", equal;
    svgwrite_plain: "svgwrite-plain.svg", equal;
    svgwrite_polylines: "svgwrite-polylines.svg", equal;
    svgwrite_stretched: "svgwrite-stretched.svg", says "x is drawn 0.7143 times as large as y";
    svgwrite_symbols: "svgwrite-symbols.svg", equal;
    svgwrite_there_and_back: "svgwrite-there-and-back.svg", equal;
    svgwrite_vertex_moved: "svgwrite-vertex-moved.svg", says "4 px away: yours lies at";
    tikz_dvisvgm_edge_missing: "tikz-dvisvgm-edge-missing.svg", says "is missing";
    tikz_dvisvgm_faces_last: "tikz-dvisvgm-faces-last.svg", says "drawn over";
    tikz_dvisvgm_hollow: "tikz-dvisvgm-hollow.svg", equal;
    tikz_dvisvgm_labels: "tikz-dvisvgm-labels.svg", equal;
    tikz_dvisvgm_plain: "tikz-dvisvgm-plain.svg", equal;
    tikz_dvisvgm_vertex_moved: "tikz-dvisvgm-vertex-moved.svg", says "4 px away: yours lies at";
    tikz_dvisvgm_white_edge_on_tinted_faces: "tikz-dvisvgm-white-edge-on-tinted-faces.svg", says "it has the colour of the paper";
    tikz_pdf2svg_edge_missing: "tikz-pdf2svg-edge-missing.svg", says "is missing";
    tikz_pdf2svg_faces_last: "tikz-pdf2svg-faces-last.svg", says "drawn over";
    tikz_pdf2svg_hollow: "tikz-pdf2svg-hollow.svg", equal;
    tikz_pdf2svg_plain: "tikz-pdf2svg-plain.svg", equal;
    tikz_pdf2svg_vertex_moved: "tikz-pdf2svg-vertex-moved.svg", says "4 px away: yours lies at";
    tikz_pdf2svg_white_edge_on_tinted_faces: "tikz-pdf2svg-white-edge-on-tinted-faces.svg", says "it has the colour of the paper";
}
