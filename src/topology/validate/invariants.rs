//! The invariants that hold on every surface, family by family.

use super::super::flat::{Fault, Flat, NONE, closed_orbits};
use super::Violation;
use super::marks::{END, FACE, Marks, NEXT, TWIN};
use super::rules::{B1, B2, C1, C2, C3, D1, F1, H1, I1, I2, I3, N1, N2, O1, O2, R1, R2, S1, T1, T2};
use crate::ids::{Element, FaceId, HalfEdgeId, VertexId};
use crate::topology::InnerComponent;
use std::ops::ControlFlow;

type Flow = ControlFlow<()>;

/// R1 and R2.
pub(super) fn lost_pointer(fault: &Fault) -> Violation {
    let pointer = fault.owner.map_or(fault.pointer.to_owned(), |owner| format!("{owner}.{}", fault.pointer));
    let elements: Vec<Element> = fault.owner.into_iter().chain(fault.found).collect();
    match fault.found {
        Some(found) => Violation::new(&R2, &elements, &[], format!("{pointer} = {found}, but {found} does not exist")),
        None => Violation::new(&R1, &elements, &[], format!("{pointer} = none")),
    }
    .with(fault.found, None)
}

fn h(number: u32) -> HalfEdgeId {
    HalfEdgeId(number)
}

/// What has been found sound so far; the walks of later invariants run over sound links only.
pub(super) struct Invariants<'a> {
    flat: &'a Flat<'a>,
    report: &'a mut dyn FnMut(Violation) -> Flow,
    marks: Marks,
    /// The face's boundary or one of its inner components is at fault already.
    bad_list: Vec<bool>,
    /// Some half-edge that starts at the vertex.
    start: Vec<u32>,
}

impl<'a> Invariants<'a> {
    pub(super) fn new(flat: &'a Flat<'a>, bad_list: Vec<bool>, report: &'a mut dyn FnMut(Violation) -> Flow) -> Self {
        Self { flat, report, marks: Marks::new(flat.next.len()), bad_list, start: vec![NONE; flat.outgoing.len()] }
    }

    fn report(&mut self, violation: Violation) -> Flow {
        (self.report)(violation)
    }

    /// T1, T2.
    pub(super) fn twins(&mut self) -> Flow {
        for a in self.flat.half_edges() {
            let b = self.flat.twin(a);
            let back = if b == NONE { NONE } else { self.flat.twin(b) };
            if b == a {
                let text = format!("{0}.twin = {0} (expected another half-edge)", h(a));
                self.report(Violation::new(&T1, &[h(a).into()], &[a], text).with(Some(h(a).into()), None))?;
            } else if back == a {
                self.marks.set(a, TWIN);
            } else if back != NONE {
                self.report_back(&T2, "twin", "twin", [a, b, back])?;
            }
        }
        Flow::Continue(())
    }

    /// N1, N2.
    pub(super) fn links(&mut self) -> Flow {
        let Flat { next, prev, .. } = self.flat;
        for a in self.flat.half_edges() {
            let b = prev[a as usize];
            let back = if b == NONE { NONE } else { next[b as usize] };
            if back != a && back != NONE {
                self.report_back(&N1, "prev", "next", [a, b, back])?;
            }
            let b = next[a as usize];
            let back = if b == NONE { NONE } else { prev[b as usize] };
            if back == a {
                self.marks.set(a, NEXT);
            } else if back != NONE {
                self.report_back(&N2, "next", "prev", [a, b, back])?;
            }
        }
        Flow::Continue(())
    }

    /// `a.out = b, but b.home = back (expected a)`.
    fn report_back(&mut self, rule: &'static super::Rule, out: &str, home: &str, [a, b, back]: [u32; 3]) -> Flow {
        let text = format!("{}.{out} = {b}, but {b}.{home} = {} (expected {})", h(a), h(back), h(a), b = h(b));
        let elements = [h(a).into(), h(b).into(), h(back).into()];
        self.report(Violation::new(rule, &elements, &[a, b], text).with(Some(h(back).into()), Some(h(a).into())))
    }

    /// D1, F1, B1, B2, C3: origins and faces along the boundaries.
    pub(super) fn boundaries(&mut self, outer_lost: bool) -> Flow {
        let flat = self.flat;
        let Flat { origin, next, face, boundary, .. } = flat;
        for a in self.flat.half_edges() {
            let b = next[a as usize];
            if b == NONE {
                continue;
            }
            let t = flat.twin(a);
            if self.marks.has(a, TWIN) && origin[b as usize] != NONE && origin[t as usize] != NONE {
                let (start, end) = (VertexId(origin[b as usize]), VertexId(origin[t as usize]));
                if start == end {
                    self.marks.set(a, END);
                } else {
                    let (a, b, t) = (h(a), h(b), h(t));
                    let text = format!(
                        "{a}.next = {b}, but {b}.origin = {start} (expected {end}, the origin of {a}.twin = {t})"
                    );
                    let elements = [a.into(), b.into(), t.into(), start.into(), end.into()];
                    let violation = Violation::new(&D1, &elements, &[a.0, b.0, t.0], text);
                    self.report(violation.with(Some(start.into()), Some(end.into())))?;
                }
            }
            if face[a as usize] != NONE && face[b as usize] != NONE {
                let (here, there) = (FaceId(face[a as usize]), FaceId(face[b as usize]));
                if here == there {
                    self.marks.set(a, FACE);
                } else {
                    let (a, b) = (h(a), h(b));
                    let text = format!("{a}.next = {b}, but {b}.face = {there} (expected {here}, the face of {a})");
                    let elements = [a.into(), b.into(), there.into(), here.into()];
                    let violation = Violation::new(&F1, &elements, &[a.0, b.0], text);
                    self.report(violation.with(Some(there.into()), Some(here.into())))?;
                }
            }
        }
        let mut has_cycle_ring = vec![false; boundary.len()];
        self.flat
            .rings
            .iter()
            .for_each(|&(f, ring)| has_cycle_ring[f as usize] |= matches!(ring, InnerComponent::Cycle(_)));
        for f in self.flat.faces() {
            let (a, id) = (boundary[f as usize], FaceId(f));
            if a != NONE {
                self.check_listed(&B1, f, a)?;
            } else if !self.bad_list[f as usize] && !outer_lost {
                let is_outer = self.flat.outer == Some(f);
                if !is_outer || has_cycle_ring[f as usize] {
                    self.bad_list[f as usize] = true;
                    let text = if is_outer {
                        format!(
                            "{id}.half_edge = none, although {id} has a cycle among its inner components (expected the first of its cycles)"
                        )
                    } else {
                        format!(
                            "{id}.half_edge = none (expected a half-edge of {id}; only an outer face may have none)"
                        )
                    };
                    self.report(Violation::new(&B2, &[id.into()], &[], text))?;
                }
            }
        }
        for &(f, ring) in &self.flat.rings {
            if let InnerComponent::Cycle(a) = ring {
                self.check_listed(&C3, f, a.0)?;
            }
        }
        Flow::Continue(())
    }

    /// B1 and C3: face `f` lists half-edge `a`, whose face should be `f`.
    fn check_listed(&mut self, rule: &'static super::Rule, f: u32, a: u32) -> Flow {
        let found = self.flat.face[a as usize];
        if found == f {
            return Flow::Continue(());
        }
        self.bad_list[f as usize] = true;
        if found == NONE {
            return Flow::Continue(());
        }
        let (f, a, found) = (FaceId(f), h(a), FaceId(found));
        let pointer = if rule.id == B1.id { "half_edge" } else { "inner_component" };
        let text = format!("{f}.{pointer} = {a}, but {a}.face = {found} (expected {f})");
        let elements = [f.into(), a.into(), found.into()];
        self.report(Violation::new(rule, &elements, &[a.0], text).with(Some(found.into()), Some(f.into())))
    }

    /// O1, O2.
    pub(super) fn origins(&mut self) -> Flow {
        let Flat { origin, outgoing, .. } = self.flat;
        for a in self.flat.half_edges().filter(|&a| origin[a as usize] != NONE) {
            let start = &mut self.start[origin[a as usize] as usize];
            *start = (*start).min(a);
        }
        for v in self.flat.vertices() {
            let (a, id, start) = (outgoing[v as usize], VertexId(v), self.start[v as usize]);
            if a != NONE {
                let found = origin[a as usize];
                if found != v && found != NONE {
                    let (a, found) = (h(a), VertexId(found));
                    let text = format!("{id}.outgoing = {a}, but {a}.origin = {found} (expected {id})");
                    let elements = [id.into(), a.into(), found.into()];
                    let violation = Violation::new(&O1, &elements, &[a.0], text);
                    self.report(violation.with(Some(found.into()), Some(id.into())))?;
                }
            } else if start != NONE && !self.outgoing_lost(v) {
                let a = h(start);
                let text = format!(
                    "{id}.outgoing = none, but {a}.origin = {id} (expected {a} or another one that starts there)"
                );
                let violation = Violation::new(&O2, &[id.into(), a.into()], &[start], text);
                self.report(violation.with(None, Some(a.into())))?;
            }
        }
        Flow::Continue(())
    }

    /// S1. One step of the round is h.twin.next, over sound twins and links, so a round that closes up is one
    /// of the fans; one that does not runs into a violation that is reported already.
    pub(super) fn stars(&mut self) -> Flow {
        let Self { flat, report, marks, .. } = self;
        let Flat { origin, outgoing, next, .. } = flat;
        let step = |a: u32| {
            let t = flat.twin(a);
            (marks.has(a, TWIN) && marks.has(t, NEXT | END)).then(|| next[t as usize])
        };
        let named = flat.vertices().map(|v| (v, outgoing[v as usize]));
        let named = named.filter(|&(v, a)| a != NONE && origin[a as usize] == v).map(|(_, a)| a);
        let mut first_round = vec![NONE; outgoing.len()];
        marks.forget_seen();
        closed_orbits(
            named.chain(flat.half_edges()),
            |a| marks.is_new(a),
            step,
            |round| {
                let v = origin[round[0] as usize];
                let first = &mut first_round[v as usize];
                if *first == NONE {
                    *first = round[0];
                    return Flow::Continue(());
                }
                let v = VertexId(v);
                let text = format!(
                    "the round of {v} through {} misses {} (expected one round of all half-edges that start at {v})",
                    h(*first),
                    list(round)
                );
                let elements = [v.into(), h(round[0]).into(), h(*first).into()];
                report(Violation::new(&S1, &elements, round, text).with(Some(h(round[0]).into()), None))
            },
        )
    }

    /// C1, C2. A cycle is judged if its links and faces are sound all round and its face's list has no fault.
    pub(super) fn cycles(&mut self) -> Flow {
        let Self { flat, report, marks, bad_list, .. } = self;
        let Flat { next, face, .. } = flat;
        let mut cycle_of = vec![NONE; next.len()];
        let mut first_listed = Vec::with_capacity(flat.boundary.len());
        let step = |a: u32| marks.has(a, NEXT | FACE).then(|| next[a as usize]);
        marks.forget_seen();
        let _ = closed_orbits::<()>(
            flat.half_edges(),
            |a| marks.is_new(a),
            step,
            |cycle| {
                cycle.iter().for_each(|&a| cycle_of[a as usize] = first_listed.len() as u32);
                first_listed.push(NONE);
                ControlFlow::Continue(())
            },
        );
        for (f, a) in flat.listed_cycles() {
            let cycle = cycle_of[a as usize];
            if cycle == NONE || face[a as usize] != f {
                continue;
            }
            let first = &mut first_listed[cycle as usize];
            if *first == NONE {
                *first = a;
                continue;
            }
            let (f, a, first) = (FaceId(f), h(a), h(*first));
            let text = format!("{f} lists the cycle of {a} twice: as {first} and as {a} (expected once)");
            let elements = [f.into(), a.into(), first.into()];
            report(Violation::new(&C2, &elements, &[a.0], text).with(Some(a.into()), None))?;
        }
        marks.forget_seen();
        closed_orbits(
            flat.half_edges(),
            |a| marks.is_new(a),
            step,
            |cycle| {
                let (a, f) = (cycle[0], face[cycle[0] as usize]);
                if first_listed[cycle_of[a as usize] as usize] != NONE || bad_list[f as usize] {
                    return Flow::Continue(());
                }
                let f = FaceId(f);
                let text = format!(
                    "the cycle {} has face {f}, but neither {f}.half_edge nor an inner component of {f} lies on it",
                    list(cycle)
                );
                report(Violation::new(&C1, &[h(a).into(), f.into()], cycle, text).with(None, Some(h(a).into())))
            },
        )
    }

    /// I1, I2, I3.
    pub(super) fn isolated_vertices(&mut self) -> Flow {
        let mut listed_by = vec![NONE; self.flat.outgoing.len()];
        for (f, v) in self.flat.listed_vertices() {
            let a = self.flat.outgoing[v as usize];
            let first = std::mem::replace(&mut listed_by[v as usize], f);
            let (f, v) = (FaceId(f), VertexId(v));
            if first != NONE {
                let first = FaceId(first);
                let text = format!("{v} lies isolated in {first} and again in {f} (expected one of them)");
                let elements = [v.into(), first.into(), f.into()];
                self.report(Violation::new(&I2, &elements, &[], text).with(Some(f.into()), Some(first.into())))?;
            } else if a != NONE {
                let a = h(a);
                let text = format!("{f} lists {v} as isolated, but {v}.outgoing = {a} (expected none)");
                let elements = [v.into(), f.into(), a.into()];
                self.report(Violation::new(&I1, &elements, &[], text).with(Some(a.into()), None))?;
            }
        }
        for v in self.flat.vertices().filter(|_| self.flat.outer.is_some()) {
            let i = v as usize;
            let isolated = self.flat.outgoing[i] == NONE && self.start[i] == NONE;
            if isolated && listed_by[i] == NONE && !self.outgoing_lost(v) {
                let v = VertexId(v);
                let text = format!("{v} has no edge, and no face lists it (expected one inner component)");
                self.report(Violation::new(&I3, &[v.into()], &[], text))?;
            }
        }
        Flow::Continue(())
    }

    /// H1.
    pub(super) fn outer_face(&mut self) -> Flow {
        match self.flat.outer {
            Some(f) if self.flat.hole[f as usize] => {
                let f = FaceId(f);
                let text = format!("{f} is the outer face and flagged as a hole face");
                self.report(Violation::new(&H1, &[f.into()], &[], text))
            }
            _ => Flow::Continue(()),
        }
    }

    /// Whether `v.outgoing` was reported by R2: then nothing is known about it.
    fn outgoing_lost(&self, v: u32) -> bool {
        self.flat.lost_outgoing.get(v as usize) == Some(&true)
    }
}

/// The half-edges of a chain, shortened in the middle.
fn list(chain: &[u32]) -> String {
    const SHOWN: usize = 8;
    let names: Vec<String> = chain.iter().take(SHOWN).map(|&a| h(a).to_string()).collect();
    let more = chain.len().saturating_sub(SHOWN);
    if more == 0 { names.join(", ") } else { format!("{}, … ({more} more)", names.join(", ")) }
}
