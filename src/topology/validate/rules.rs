//! The invariants as data: handouts, reports and the command line print them from here.

/// One invariant of the structure.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Rule {
    /// A letter for the family and a number: `N2`. Stable.
    pub id: &'static str,
    /// The invariant as a path: `h.next.prev = h`.
    pub invariant: &'static str,
    /// One or two sentences for people.
    pub explanation: &'static str,
}

macro_rules! rules {
    ($($name:ident: $invariant:literal, $explanation:literal;)*) => {
        $(pub(super) const $name: Rule = Rule { id: stringify!($name), invariant: $invariant, explanation: $explanation };)*
        const ALL: &[Rule] = &[$($name),*];
    };
}

rules! {
    R1: "no pointer of a half-edge is missing",
        "Every half-edge has an origin, a twin, a next, a prev and a face.";
    R2: "every pointer leads to an element that exists",
        "A pointer to a removed element, or to a number that was never given out, leads nowhere.";
    T1: "h.twin != h",
        "The twin is the other half of the edge, so no half-edge is its own twin.";
    T2: "h.twin.twin = h",
        "Twins point to each other.";
    N1: "h.prev.next = h",
        "The half-edge before h is followed by h.";
    N2: "h.next.prev = h",
        "The half-edge after h is preceded by h. next and prev must be set together.";
    D1: "h.next.origin = h.twin.origin",
        "The next half-edge starts where h ends, and h ends where its twin starts.";
    F1: "h.next.face = h.face",
        "All half-edges along a boundary have the same face on their left.";
    B1: "f.half_edge.face = f",
        "A face points to a half-edge that has this face on its left.";
    B2: "f.half_edge exists",
        "Every face points to one of its half-edges. Only an outer face without any cycle has none.";
    O1: "v.outgoing.origin = v",
        "A vertex points to a half-edge that starts there.";
    O2: "v.outgoing exists if any half-edge starts at v",
        "A vertex without outgoing counts as isolated, so no half-edge may start there.";
    S1: "the half-edges that start at v form one round",
        "Turning round a vertex by h.twin.next meets every half-edge that starts there. A second round means that two vertices were made one.";
    C1: "every boundary cycle is listed by its face",
        "Each cycle holds the face's boundary or one of its inner components. A cycle that the face does not know is never walked.";
    C2: "no boundary cycle is listed twice",
        "Each cycle is listed once by its face, as the boundary or as one inner component.";
    C3: "an inner component of f has face f",
        "A face lists as inner components only cycles that have this face on their left.";
    I1: "a vertex listed as isolated has no outgoing",
        "Only a vertex without edges is listed by the face it lies in.";
    I2: "an isolated vertex is listed once",
        "An isolated vertex lies in one face.";
    I3: "an isolated vertex is listed if there is an outer face",
        "In the plane every vertex without edges lies in some face, which lists it.";
    H1: "the outer face is not a hole face",
        "A hole face is a bounded face outside the domain; the outer face is not bounded.";
    E1: "in the plane, V - E + cycles = 2 for every component",
        "Each component can be drawn without crossings (genus 0). Checked only when all other invariants hold. E1 and E2 together give Euler's relation V - E + F = 1 + C.";
    E2: "in the plane, every component is an inner component of exactly one face that encloses it",
        "Going inwards from the outer face, through inner components to components and through boundaries to faces, meets every component once. Checked only when all other invariants hold.";
}

impl Rule {
    /// All rules, in the order in which they are checked.
    #[must_use]
    pub const fn all() -> &'static [Self] {
        ALL
    }

    /// The rule with this id.
    #[must_use]
    pub fn by_id(id: &str) -> Option<&'static Self> {
        ALL.iter().find(|rule| rule.id == id)
    }
}
