//! The structure figure whose half-edges show their pointers: no script, four selectors.
//!
//! ```text
//!   <g class="he" id="FIG-h5" tabindex="0" role="img"> title
//!       hit      an unseen line 13 px wide, so that the shaft is easy to point at
//!       shaft, barb, label
//!       ptr      hidden:  next ╮  prev (as the next of that)  twin ↔  face ┄▸  origin ⌒▸
//!   </g>
//!   shown by    .he:hover .ptr    .he:focus .ptr    .he:target .ptr
//! ```
//!
//! Tab goes through the half-edges in the order of their numbers. The root is a group and every element an image
//! with a name, so that screen readers hear "h0: v0 to v1, face f1, twin h1, next h18, prev h17". As a picture
//! (`<img src="file.svg#FIG-h5">`) the file shows one half-edge in focus.

use crate::figure::canvas::scene::{Group, Node, Scene};
use crate::figure::kinds::focus::TWIN_AT;
use crate::figure::layout::crowd::Crowd;
use crate::figure::structure::face_arrows::Tagged;
use crate::figure::structure::look::Look;
use crate::figure::structure::notes::Notes;
use crate::figure::structure::plate::Plate;
use crate::figure::structure::pointer::Pointer;
use crate::figure::structure::pointer_style;
use crate::figure::structure::skeleton::half_edges;
use crate::figure::{Figure, Style};
use crate::ids::HalfEdgeId;
use crate::plane::PlanarView;

/// The figure of a placed structure, with hidden pointers.
pub(crate) fn figure<V: PlanarView + ?Sized>(placed: Plate<'_, V>) -> Figure {
    let ink = placed.local_ink();
    let plate = Plate::place(placed.picture, placed.notes, &ink);
    let view = plate.picture.view;
    let mut crowd = plate.crowd.clone();
    let mut ids = half_edges(view);
    let mut nodes = plate.nodes(view, &Look::default(), Vec::new());
    for node in &mut nodes {
        let Node::Group(group) = node else { continue };
        if group.id.is_some() {
            group.attributes.push(("role", "img".to_owned()));
        }
        if group.class == "he"
            && let Some(h) = ids.next()
        {
            group.attributes.push(("tabindex", "0".to_owned()));
            if let Some(shaft) = plate.shafts[h].as_ref() {
                group.nodes.insert(0, Node::Line { class: "hit", from: shaft.tail, to: shaft.tip });
            }
            group.nodes.push(plate.pointers_of(h, &mut crowd));
        }
    }
    let Plate { picture, notes: Notes(notes), .. } = plate;
    let mut scene = picture.scene(nodes);
    reading(&mut scene, &picture.options.style, picture.options.description.is_none());
    Figure { scene, detail: picture.detail, notes }
}

/// Role, description and style of the whole.
fn reading(scene: &mut Scene, style: &Style, describe: bool) {
    scene.attributes.push(("role", "group".to_owned()));
    if describe {
        scene.description.push_str(" A half-edge under the mouse or in focus shows its pointers.");
    }
    scene.css.push_str(&pointer_style::css(style, &scene.prefix));
    scene.css.push_str(&css(style, &scene.prefix));
}

fn css(style: &Style, scope: &str) -> String {
    let states = ["hover", "focus", "target"];
    let all = |part: &str| states.map(|state| format!("#{scope} .he:{state} .{part}")).join(",");
    let (shown, bold) = (all("ptr"), all("sh"));
    let width = crate::figure::canvas::number::drawn(1.9 * style.shaft_width);
    format!(
        "#{scope} .ptr{{display:none;pointer-events:none}}\n{shown}{{display:inline}}\n{bold}{{stroke-width:{width}}}\n\
         #{scope} .he:focus{{outline:none}}\n\
         #{scope} .hit{{stroke:#000;stroke-opacity:0;stroke-width:13;fill:none;pointer-events:stroke}}\n"
    )
}

impl<V: PlanarView + ?Sized> Plate<'_, V> {
    /// The pointers of one half-edge. Only one half-edge shows them at a time, so they need not keep clear of
    /// those of others: `crowd` is left as it was.
    fn pointers_of(&self, h: HalfEdgeId, crowd: &mut Crowd) -> Node {
        let view = self.picture.view;
        let prev = view.prev(h).filter(|&p| p != h && view.next(p) == Some(h));
        let cycle: Vec<Pointer> = prev.into_iter().chain([h]).map(Pointer::Next).collect();
        let families: [(&'static str, &[Pointer]); 4] = [
            ("next", &cycle),
            ("twin", &[Pointer::Twin(h)]),
            ("origin", &[Pointer::Origin(h)]),
            ("face-of", &[Pointer::Face(h)]),
        ];
        let len = crowd.len();
        let mut groups = Vec::new();
        for (class, pointers) in families {
            let arrows = pointers.iter().filter_map(|&pointer| self.arrow(view, pointer, TWIN_AT, crowd));
            let (mut nodes, mut heads) = (Vec::new(), Vec::new());
            for Tagged { arrow, tag } in arrows.collect::<Vec<_>>() {
                crowd.add_all(arrow.shapes(), u32::MAX);
                heads.extend(arrow.heads.iter().map(|head| head.to_vec()));
                nodes.push(Node::Curve { class: "pl", start: arrow.start, steps: arrow.steps });
                nodes.extend(tag.iter().flat_map(|tag| tag.nodes("tag")));
            }
            if !heads.is_empty() {
                nodes.push(Node::Area { class: "ph", hatch: None, outlines: heads });
            }
            if !nodes.is_empty() {
                groups.push(Node::Group(Group { class, nodes, ..Group::default() }));
            }
        }
        crowd.truncate(len);
        Node::Group(Group { class: "ptr", nodes: groups, ..Group::default() })
    }
}
