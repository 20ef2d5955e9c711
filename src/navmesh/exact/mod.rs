//! The shortest path of all: a search over what can be seen through portals.
//!
//! ```text
//!             ╲   portal   ╱          A cone: everything straight in sight from its root, through a part of a portal.
//!   ────────●──╲════════╱──●────    Behind the portal it falls on the sides of the next face: a cone for each side it
//!               ╲      ╱            falls on. Where it ends at an endpoint, and not earlier, the path may bend round that
//!                ╲    ╱             endpoint: then the sides out of sight get cones, too, with the endpoint as their root.
//!                 root
//! ```
//!
//! The cones are taken in the order of the shortest length that a path through them may have. A cone is stored as two
//! rays, each through two points that were given: what falls on what is decided by exact signs on input points, and
//! points are constructed for that guess alone. A cone with a single successor passes it on without the queue. The rooms
//! it runs through are the faces of the mesh, or larger ones that were merged from them. A cone is left out once a path is
//! known that leads to all that it sees of its portal and is shorter: from an endpoint, along the portal.
//!
//! It ends: there is a way, for start and goal are in one component, so only cones with shorter guesses are ever
//! taken, and there are but finitely many taut paths shorter than a given length. No count is limited, and no answer
//! depends on a tolerance.
//!
//! Source: Cui, Harabor and Grastien, *Compromise-free pathfinding on a navigation mesh*, IJCAI 2017 (Polyanya); Xin and
//! Wang, *Improving Chen and Han's algorithm on the discrete geodesic problem*, 2009, for the cones that are left out.
//!
//! ```text
//!   estimate.rs  The shortest length that a path through a cone may have
//!   expand.rs    From a cone to the cones behind it
//!   side.rs      The sides of a room
//!   ray.rs       On which side of a ray a point is
//! ```

mod cone;
mod estimate;
mod expand;
mod ray;
mod search;
mod side;

pub use cone::Cone;
pub(super) use search::Exact;
