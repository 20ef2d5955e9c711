//! Components and the faces that join them, compared from the leaves to the centre, then matched from the centre
//! to the leaves.
//!
//! ```text
//!   P0 ─ f1 ─ P1         pieces (components) are joined by the faces that several of them border. Every leaf
//!        │               is a piece, so leaves are an even number of steps apart and a tree has exactly one
//!        P2 ─ f5 ─ P3    centre: here P2. A face without any piece is a tree of its own.
//! ```

use super::super::flat::NONE;
use super::colour::{Look, mix, refine};
use super::difference::which;
use super::explain::first_pointer;
use super::matcher::Matcher;
use super::world::World;
use super::{Difference, Matching, Which};
use crate::geometry::grouping::{Groups, sorted};
use std::collections::{BTreeMap, VecDeque};

/// Marks the class of a face while its piece is looked at from within that face.
const PARENT: u32 = 1 << 31;

/// Compares the two sides of a world.
pub(super) fn compare(world: &World) -> Result<Matching, Difference> {
    let mut forest = Forest::new(world);
    for &f in world.faces.iter().filter(|&&f| !world.isolated.of(f as usize).is_empty()) {
        if !forest.joins[f as usize] {
            forest.classify_face(f);
        }
    }
    let order = forest.peel()?;
    for &node in &order {
        match node {
            Node::Piece(p) => forest.classify_piece(p),
            Node::Face(f) => forest.classify_face(f),
        }
    }
    let pairs = forest.pair_roots(&order)?;
    let mut matcher = Matcher::new(world);
    for (a, b) in pairs {
        forest.match_trees(&mut matcher, a, b);
    }
    for &f in world.faces.iter().take_while(|&&f| f < world.split.face) {
        if let Some(others) =
            (matcher.face_to[f as usize] != NONE).then(|| world.isolated.of(matcher.face_to[f as usize] as usize))
        {
            matcher.match_isolated(world.isolated.of(f as usize), others);
        }
    }
    let (here, there): (Vec<u32>, Vec<u32>) = world.adrift.iter().partition(|&&v| v < world.split.vertex);
    matcher.match_isolated(&here, &there);
    matcher.finish()
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Node {
    Piece(u32),
    Face(u32),
}

struct Forest<'a> {
    world: &'a World,
    /// The half-edges of each piece.
    pieces: Groups<u32>,
    /// The pieces at each joining face, without repetition.
    pieces_at: Groups<u32>,
    /// The joining faces of each piece.
    faces_at: Groups<u32>,
    /// Whether the face is a node: it borders more than one piece, or none.
    joins: Vec<bool>,
    /// The face through which the centre is reached; `NONE` for a root.
    parent: Vec<u32>,
    /// The piece through which the centre is reached.
    face_parent: Vec<u32>,
    /// Equal for faces with equal labels and equal content; for joining faces from `classify_face` on.
    face_class: Vec<u32>,
    piece_class: Vec<u32>,
    root: Vec<u32>,
    colour: Vec<u64>,
    contents: BTreeMap<(u32, Vec<u32>, Vec<u32>), u32>,
    /// The first piece of every class met so far, by hash.
    kinds: BTreeMap<u64, Vec<u32>>,
    scratch: Matcher<'a>,
}

impl<'a> Forest<'a> {
    fn new(world: &'a World) -> Self {
        let (bound, face_bound) = (world.next.len(), world.face_label.len());
        let (pieces, piece_of) = pieces(world);
        let count = pieces.count();
        let cycles = world.faces.iter().flat_map(|&f| world.cycles.of(f as usize).iter().map(move |&h| (f, h)));
        let mut at_faces: Vec<(u32, u32)> = sorted(cycles.map(|(f, h)| (f, piece_of[h as usize])).collect());
        let mut joins = vec![false; face_bound];
        let pieces_at = Groups::new(face_bound, at_faces.iter().map(|&(f, p)| (f as usize, p)));
        world.faces.iter().for_each(|&f| joins[f as usize] = pieces_at.of(f as usize).len() != 1);
        at_faces.retain(|&(f, _)| joins[f as usize]);
        let face_class = (0..face_bound).map(|f| world.face_label[f] | if joins[f] { PARENT } else { 0 }).collect();
        Self {
            world,
            pieces,
            pieces_at: Groups::new(face_bound, at_faces.iter().map(|&(f, p)| (f as usize, p))),
            faces_at: Groups::new(count, at_faces.iter().map(|&(f, p)| (p as usize, f))),
            joins,
            parent: vec![NONE; count],
            face_parent: vec![NONE; face_bound],
            face_class,
            piece_class: vec![NONE; count],
            root: vec![NONE; count],
            colour: vec![0; bound],
            contents: BTreeMap::new(),
            kinds: BTreeMap::new(),
            scratch: Matcher::new(world),
        }
    }

    /// Takes away leaves, layer by layer, and notes the way to the centre. Returns all nodes in that order.
    fn peel(&mut self) -> Result<Vec<Node>, Difference> {
        let joining: Vec<u32> = self.world.faces.iter().copied().filter(|&f| self.joins[f as usize]).collect();
        let mut piece_degree: Vec<usize> = (0..self.parent.len()).map(|p| self.faces_at.of(p).len()).collect();
        let mut face_degree: Vec<usize> = (0..self.joins.len()).map(|f| self.pieces_at.of(f).len()).collect();
        let (mut piece_done, mut face_done) = (vec![false; piece_degree.len()], vec![false; face_degree.len()]);
        let mut queue: VecDeque<Node> = (0..piece_degree.len() as u32)
            .filter(|&p| piece_degree[p as usize] <= 1)
            .map(Node::Piece)
            .chain(joining.iter().copied().filter(|&f| face_degree[f as usize] <= 1).map(Node::Face))
            .collect();
        let mut order = Vec::with_capacity(piece_degree.len() + joining.len());
        while let Some(node) = queue.pop_front() {
            order.push(node);
            match node {
                Node::Piece(p) => {
                    piece_done[p as usize] = true;
                    if let Some(&f) = self.faces_at.of(p as usize).iter().find(|&&f| !face_done[f as usize]) {
                        self.parent[p as usize] = f;
                        face_degree[f as usize] -= 1;
                        if face_degree[f as usize] == 1 {
                            queue.push_back(Node::Face(f));
                        }
                    }
                }
                Node::Face(f) => {
                    face_done[f as usize] = true;
                    if let Some(&p) = self.pieces_at.of(f as usize).iter().find(|&&p| !piece_done[p as usize]) {
                        self.face_parent[f as usize] = p;
                        piece_degree[p as usize] -= 1;
                        if piece_degree[p as usize] == 1 {
                            queue.push_back(Node::Piece(p));
                        }
                    }
                }
            }
        }
        match joining.iter().find(|&&f| !face_done[f as usize]) {
            Some(&f) => Err(Difference::Undecided { face: self.world.split.face(f) }),
            None => Ok(order),
        }
    }

    /// Gives a piece, whose faces but the parent are classified, its class and its root.
    fn classify_piece(&mut self, p: u32) {
        let world = self.world;
        let parent = self.parent[p as usize];
        let members = self.pieces.of(p as usize);
        let Look { hash, root } = refine(world, members, &self.face_class, &mut self.colour);
        self.root[p as usize] = root;
        let kinds = self.kinds.entry(mix(hash, u64::from(parent == NONE))).or_default();
        for &other in kinds.iter() {
            let (rep, class) = (self.root[other as usize], self.piece_class[other as usize]);
            let other_size = self.pieces.of(other as usize).len();
            let (colour, face_class) = (&self.colour, &self.face_class);
            let mut starts = members.iter().copied().filter(|&h| colour[h as usize] == colour[rep as usize]);
            if other_size == members.len()
                && starts.any(|h| {
                    let fits = self.scratch.walk(face_class, rep, h);
                    self.scratch.forget();
                    fits
                })
            {
                self.piece_class[p as usize] = class;
                return;
            }
        }
        kinds.push(p);
        self.piece_class[p as usize] = p;
    }

    /// Gives a joining face, whose pieces but the parent are classified, its class.
    fn classify_face(&mut self, f: u32) {
        let parent = self.face_parent[f as usize];
        let children = self.pieces_at.of(f as usize).iter().filter(|&&p| p != parent);
        let mut classes: Vec<u32> = children.map(|&p| self.piece_class[p as usize]).collect();
        let isolated = self.world.isolated.of(f as usize);
        let mut labels: Vec<u32> = isolated.iter().map(|&v| self.world.vertex_label[v as usize]).collect();
        classes.sort_unstable();
        labels.sort_unstable();
        let fresh = (self.world.face_label.len() + self.contents.len()) as u32;
        let key = (self.world.face_label[f as usize], classes, labels);
        self.face_class[f as usize] = *self.contents.entry(key).or_insert(fresh);
    }

    /// Pairs the trees of the two sides by the classes of their roots.
    fn pair_roots(&self, order: &[Node]) -> Result<Vec<(Node, Node)>, Difference> {
        let split = self.world.split;
        let mut sides = [Vec::new(), Vec::new()];
        for &node in order {
            let (is_root, class, side) = match node {
                Node::Piece(p) => {
                    let first = which(self.root[p as usize], split.half_edge);
                    (self.parent[p as usize] == NONE, Node::Piece(self.piece_class[p as usize]), first)
                }
                Node::Face(f) => (
                    self.face_parent[f as usize] == NONE,
                    Node::Face(self.face_class[f as usize]),
                    which(f, split.face),
                ),
            };
            if is_root {
                sides[usize::from(side == Which::Second)].push((class, node));
            }
        }
        sides.iter_mut().for_each(|side| side.sort_unstable());
        let [first, second] = sides;
        if let Some(node) = surplus(&first, &second) {
            return Err(
                first_pointer(self.world).unwrap_or_else(|| self.no_counterpart(node, surplus(&second, &first)))
            );
        }
        Ok(first.into_iter().zip(second).map(|((_, a), (_, b))| (a, b)).collect())
    }

    /// What to say of a root of the first view that has no partner, when `other` of the second has none either:
    /// of two faces, the component in the one that is not in the other.
    fn no_counterpart(&self, node: Node, other: Option<Node>) -> Difference {
        let piece = match (node, other) {
            (Node::Piece(p), _) => Some(Node::Piece(p)),
            (Node::Face(f), Some(Node::Face(g))) => {
                let [here, there] = [f, g].map(|f| {
                    let children = self.children(f).into_iter();
                    children.map(|p| (Node::Piece(self.piece_class[p as usize]), Node::Piece(p))).collect::<Vec<_>>()
                });
                surplus(&here, &there)
            }
            (Node::Face(_), _) => None,
        };
        match (piece, node) {
            (Some(Node::Piece(p)), _) => {
                let members = self.pieces.of(p as usize);
                Difference::Component { h: self.world.split.half_edge(members[0]), half_edges: members.len() }
            }
            (_, Node::Face(f) | Node::Piece(f)) => Difference::Content { face: self.world.split.face(f) },
        }
    }

    /// Matches two trees whose roots have the same class, from the centre outwards.
    fn match_trees(&self, matcher: &mut Matcher, a: Node, b: Node) {
        let mut faces = Vec::new();
        match (a, b) {
            (Node::Piece(p), Node::Piece(q)) => self.match_pieces(matcher, p, q, &mut faces),
            (Node::Face(f), Node::Face(g)) => {
                matcher.pair_faces(f, g);
                faces.push((f, g));
            }
            _ => {}
        }
        while let Some((f, g)) = faces.pop() {
            for (p, q) in self.children(f).into_iter().zip(self.children(g)) {
                self.match_pieces(matcher, p, q, &mut faces);
            }
        }
    }

    fn children(&self, f: u32) -> Vec<u32> {
        let pieces = self.pieces_at.of(f as usize).iter().copied();
        let mut children: Vec<u32> = pieces.filter(|&p| p != self.face_parent[f as usize]).collect();
        children.sort_by_key(|&p| self.piece_class[p as usize]);
        children
    }

    /// Matches two pieces of one class, whose parent faces are matched already, and hands out the joining faces
    /// they lead to.
    fn match_pieces(&self, matcher: &mut Matcher, p: u32, q: u32, faces: &mut Vec<(u32, u32)>) {
        let (root, parent) = (self.root[p as usize], self.parent[p as usize]);
        let starts = self.pieces.of(q as usize).iter().copied();
        for start in starts.filter(|&h| self.colour[h as usize] == self.colour[root as usize]) {
            if matcher.walk(&self.face_class, root, start) {
                matcher.keep();
                break;
            }
            matcher.forget();
        }
        let found = self.faces_at.of(p as usize).iter().copied().filter(|&f| f != parent);
        faces.extend(found.map(|f| (f, matcher.face_to[f as usize])).filter(|&(_, g)| g != NONE));
    }
}

/// The half-edges that `next` and `twin` connect, piece by piece, and the piece of each.
fn pieces(world: &World) -> (Groups<u32>, Vec<u32>) {
    let mut piece_of = vec![NONE; world.next.len()];
    let (mut count, mut members) = (0, Vec::with_capacity(world.half_edges.len()));
    for &start in &world.half_edges {
        if piece_of[start as usize] != NONE {
            continue;
        }
        let mut at = members.len();
        piece_of[start as usize] = count;
        members.push((count as usize, start));
        while let Some(&(_, h)) = members.get(at) {
            at += 1;
            for g in [world.next[h as usize], world.twin[h as usize]] {
                if std::mem::replace(&mut piece_of[g as usize], count) == NONE {
                    members.push((count as usize, g));
                }
            }
        }
        count += 1;
    }
    (Groups::new(count as usize, members.into_iter()), piece_of)
}

/// The first of `here` that has no partner of its class in `there`; both are sorted by class.
fn surplus(here: &[(Node, Node)], there: &[(Node, Node)]) -> Option<Node> {
    let mut others = there.iter().map(|&(class, _)| class).peekable();
    here.iter().find_map(|&(class, node)| {
        while others.next_if(|&other| other < class).is_some() {}
        others.next_if_eq(&class).is_none().then_some(node)
    })
}
