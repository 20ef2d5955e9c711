//! What stands somewhere else than where it is drawn: inner drawings, and elements that `use` shows.

use super::lengths::length;
use super::{Around, Reader, corners, flipped, word};
use crate::compare::error::Fault;
use crate::compare::painting::Area;
use crate::compare::tags::tag;
use crate::compare::transform::Transform;
use crate::compare::viewport;
use crate::figure::canvas::selectors::Tag;
use roxmltree::Node;

impl<'a, 'i> Reader<'a, 'i> {
    /// What is inside an `svg` or a `symbol`, placed by `place`: at its own x and y, its `viewBox` fitted in, cut off
    /// at its border.
    pub(super) fn inner(
        &mut self,
        node: Node<'a, 'i>,
        place: Node<'a, 'i>,
        [x, y]: [f64; 2],
        mut around: Around,
    ) -> Result<Around, Fault> {
        if let Some(text) = around.own.geometry.differing(|key| node.attribute(key)) {
            let wanted = "style that all browsers read on an inner <svg> or a symbol: write it as an attribute";
            return Err(word(node.range().start, &text, wanted));
        }
        let side = |name: &str, axis: usize| match place.attribute(name).or_else(|| node.attribute(name)) {
            None | Some("auto") => Ok(around.room.map(|room| room[2 + axis])),
            Some(_) => {
                let holder = if place.has_attribute(name) { place } else { node };
                length(holder, name, axis, &around).map(Some)
            }
        };
        let (width, height) = (side("width", 0)?, side("height", 1)?);
        if node.attribute("viewBox").is_some_and(viewport::is_empty) {
            // Such a box is not drawn.
            around.clip = Some(self.add_clip(Vec::new(), around.clip));
        }
        let inside = node.attribute("viewBox").and_then(viewport::view_box);
        let size = width.zip(height);
        if let Some((width, height)) = size.filter(|_| !around.own.overflows) {
            let ring = corners([x, y, width, height]).map(|p| flipped(around.transform.apply(p)));
            around.clip = Some(self.add_clip(vec![Area::new(&[ring.to_vec()], false)], around.clip));
        }
        let moved = match (inside, size) {
            (Some(inside), Some((width, height))) => {
                let ratio = node.attribute("preserveAspectRatio").unwrap_or("");
                viewport::fitted(inside, [x, y, width, height], ratio)
            }
            (Some(_), None) => {
                self.ignore("viewBox of an inner <svg> without a size");
                Transform::translate(x, y)
            }
            (None, _) => Transform::translate(x, y),
        };
        around.transform = around.transform.after(&moved);
        around.room = inside.or(size.map(|(width, height)| [0.0, 0.0, width, height]));
        Ok(around)
    }

    /// What `use` shows: an element of the file once more.
    pub(super) fn reuse(&mut self, node: Node<'a, 'i>, mut around: Around, depth: usize) -> Result<(), Fault> {
        let link = node.attributes().find(|a| a.name() == "href").map_or("", |a| a.value());
        let Some(target) = link.trim().strip_prefix('#').and_then(|id| self.by_id(id)) else {
            self.ignore("<use> of something that is not in the file");
            return Ok(());
        };
        let corner = [length(node, "x", 0, &around)?, length(node, "y", 1, &around)?];
        // Rules look at the place where it stands; what it inherits comes from here.
        let outside = std::mem::take(&mut self.path);
        self.path = self.tags_around(target)?;
        if matches!(target.tag_name().name(), "symbol" | "svg") {
            self.enter(target);
            if let Some(styled) = self.inside(target, &around)? {
                let inner = self.inner(target, node, corner, styled)?;
                self.children(target, &inner, depth + 1)?;
            }
        } else {
            around.transform = around.transform.after(&Transform::translate(corner[0], corner[1]));
            self.element(target, &around, depth + 1)?;
        }
        self.path = outside;
        Ok(())
    }

    /// The tags from the root to what an element stands in, if there are rules that look at them.
    fn tags_around(&mut self, node: Node<'a, 'i>) -> Result<Vec<Tag>, Fault> {
        if self.rules.is_empty() {
            return Ok(Vec::new());
        }
        let mut out = Vec::new();
        for element in node.ancestors().skip(1).filter(Node::is_element) {
            self.visit(element)?;
            out.push(tag(element));
        }
        out.reverse();
        Ok(out)
    }
}
