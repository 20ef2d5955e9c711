//! What the navmesh promises: location, components, dead ends, routes and lengths, against plain programs.
//!
//! `maps.rs` makes maps from seeds, `oracle.rs` answers slowly: a visibility graph and Dijkstra, scans, floods. Every
//! failure names its seed. Lengths are compared to 1e-9 of their size, work by its counters, never by time.

mod blocking;
mod corridors;
mod inset;
mod junctions;
mod links;
mod live;
mod live_faults;
mod live_sets;
mod live_truth;
mod location;
mod many_corners;
mod maps;
mod merged;
mod oracle;
mod prices;
mod reach;
mod routes;
mod sight;
mod slivers;
mod surface;
mod surface_ends;
mod surface_links;
mod surface_shapes;
mod surface_sight;
mod traps;
mod weld;
