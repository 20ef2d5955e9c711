//! Clip paths: outside of the shapes of such a path nothing of an element is shown.
//!
//! ```text
//!   <clipPath id="c"> <rect/> <use/> </clipPath>      <g clip-path="url(#c)">      all shapes together, in this order
//! ```

use super::{Around, Reader, WORK, length, shapes, word};
use crate::compare::error::Fault;
use crate::compare::ink::{Ink, Own};
use crate::compare::painting::{Area, Clip};
use crate::compare::tags::{size, tag};
use crate::compare::transform::Transform;
use crate::figure::canvas::selectors::Tag;
use roxmltree::Node;

/// How many `use` are followed from a clip path to a shape, and that shape.
const LINKS: usize = 4;

impl<'a, 'i> Reader<'a, 'i> {
    /// The clip that an element names, inside the one around.
    pub(super) fn clip(&mut self, node: Node<'a, 'i>, link: &str, around: &Around) -> Result<Option<u32>, Fault> {
        if !link.starts_with("url(") {
            return Err(word(node.range().start, link, "clip path here: write url(#...) of a <clipPath>"));
        }
        let id = link.strip_prefix("url(").and_then(|rest| rest.split(')').next());
        let id = id.map(|id| id.trim_matches(['"', '\'', ' ']).trim_start_matches('#'));
        let Some(target) = id.and_then(|id| self.by_id(id)).filter(|n| n.tag_name().name() == "clipPath") else {
            self.ignore("clip-path that is not in the file");
            return Ok(around.clip);
        };
        let key = (target.range().start, around.clip, around.transform.bits());
        if let Some(&known) = self.clips.get(&key) {
            return Ok(Some(known));
        }
        if target.attribute("clipPathUnits") == Some("objectBoundingBox") {
            let wanted = "unit of a clip path here: write userSpaceOnUse";
            return Err(word(node.range().start, "objectBoundingBox", wanted));
        }
        let transform = moved(&around.transform, target, target.attribute("transform"))?;
        let mut areas = Vec::new();
        for child in target.children().filter(Node::is_element) {
            areas.extend(self.part_of_clip(child, target, transform, around)?);
        }
        let clip = self.add_clip(areas, around.clip);
        self.clips.insert(key, clip);
        Ok(Some(clip))
    }

    /// What a child of a clip path lets be seen; nothing if it is not displayed.
    fn part_of_clip(
        &mut self,
        child: Node<'a, 'i>,
        target: Node<'a, 'i>,
        mut transform: Transform,
        around: &Around,
    ) -> Result<Option<Area>, Fault> {
        self.work += 1 + child.attributes().map(|a| a.value().len()).sum::<usize>();
        Fault::if_more(self.work, WORK, "elements to draw", child.range().start)?;
        let mut shape = child;
        let mut styled = around.clone();
        for _ in 0..LINKS {
            let Some(own) = self.alone(shape) else { return Ok(None) };
            transform = moved(&transform, shape, own.transform.as_deref().or_else(|| shape.attribute("transform")))?;
            styled.own = own;
            if shape.tag_name().name() != "use" {
                break;
            }
            let corner = [length(shape, "x", 0, &styled)?, length(shape, "y", 1, &styled)?];
            let link = shape.attributes().find(|a| a.name() == "href").map_or("", |a| a.value());
            let Some(used) = link.strip_prefix('#').and_then(|id| self.by_id(id)) else { break };
            transform = transform.after(&Transform::translate(corner[0], corner[1]));
            shape = used;
        }
        let even_odd = [shape, target].iter().find_map(|n| n.attribute("clip-rule")) == Some("evenodd");
        Ok(Some(Area::new(&shapes::rings(shape, &transform, &styled)?, even_odd)))
    }

    /// What an element that stands elsewhere says of itself; `None` if it is not displayed.
    fn alone(&mut self, node: Node<'a, 'i>) -> Option<Own> {
        let mut tags: Vec<Tag> = Vec::new();
        if !self.rules.is_empty() {
            let around = node.ancestors().filter(Node::is_element);
            self.work += around.clone().map(size).sum::<usize>();
            tags.extend(around.map(tag));
            tags.reverse();
        }
        Ink::default().inside(node, &self.rules, &tags).map(|(_, own)| own)
    }

    pub(super) fn add_clip(&mut self, areas: Vec<Area>, around: Option<u32>) -> u32 {
        self.out.painting.clips.push(Clip { areas, around, canvas: false });
        self.out.painting.clips.len() as u32 - 1
    }
}

/// A transform, and the one that is written on an element within.
pub(super) fn moved(around: &Transform, node: Node<'_, '_>, written: Option<&str>) -> Result<Transform, Fault> {
    let Some(text) = written else { return Ok(*around) };
    let own = Transform::read(text).ok_or_else(|| word(node.range().start, text, "transform"))?;
    Ok(around.after(&own))
}
