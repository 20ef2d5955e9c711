//! The judges of the labs that come with the kit. Nothing else here knows a lab by its name.
//!
//! A further lab is a folder here, a line in the list of labs, a feature of the package, and a folder in
//! `labs/`. A lab outside of the kit brings its
//! judge along, see [`Lab::with_judge`](crate::Lab::with_judge).

#[cfg(feature = "lab-07")]
pub mod delaunay;
#[cfg(feature = "lab-04")]
pub mod half_edge;
#[cfg(feature = "lab-03")]
pub mod hulls;
#[cfg(feature = "lab-06")]
pub mod navmesh;
#[cfg(feature = "lab-10")]
pub mod polyhedra;
#[cfg(feature = "lab-01")]
pub mod predicates;
#[cfg(feature = "lab-09")]
pub mod primitives;
#[cfg(feature = "lab-11")]
pub mod support;
#[cfg(feature = "lab-05")]
pub mod triangle_list;
#[cfg(feature = "lab-02")]
pub mod triangulation;
#[cfg(feature = "lab-08")]
pub mod voronoi;

use crate::judge::Judge;
use crate::manifest::Manifest;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

macro_rules! labs {
    ($($feature:literal $lab:literal $folder:ident $judge:ident $bundle:expr,)*) => {
        /// The judge of a lab, by the name of its folder: one of the kit's, or one that [`add_own`] has added.
        #[must_use]
        pub fn judge_of(lab: &str) -> Option<&'static dyn Judge> {
            match lab {
                $(#[cfg(feature = $feature)] $lab => Some(&$folder::$judge),)*
                _ => own().into_iter().find(|own| own.name() == lab).map(|own| own.judge),
            }
        }

        /// The labs that are compiled in.
        pub(crate) const BUNDLE: &[&str] = &[$(#[cfg(feature = $feature)] $bundle,)*];

        /// The labs of the kit, and the folder here that each of them needs.
        pub const FOLDERS: &[(&str, &str)] = &[$(($lab, stringify!($folder)),)*];
    };
}

// The feature of the package, the folder in `labs`, the folder here, the judge in it, and what it is made of. A path is
// written out: the kit that students get is found by it.
labs! {
    "lab-01" "01-predicates" predicates Predicates include_str!("../bundle/01-predicates.txt"),
    "lab-02" "02-triangulation" triangulation Triangulation include_str!("../bundle/02-triangulation.txt"),
    "lab-03" "03-convex-hulls" hulls Hulls include_str!("../bundle/03-convex-hulls.txt"),
    "lab-04" "04-half-edge" half_edge HalfEdge include_str!("../bundle/04-half-edge.txt"),
    "lab-05" "05-triangle-list" triangle_list TriangleList include_str!("../bundle/05-triangle-list.txt"),
    "lab-06" "06-navmesh" navmesh NavMeshJudge include_str!("../bundle/06-navmesh.txt"),
    "lab-07" "07-delaunay" delaunay Delaunay include_str!("../bundle/07-delaunay.txt"),
    "lab-08" "08-voronoi" voronoi VoronoiDiagrams include_str!("../bundle/08-voronoi.txt"),
    "lab-09" "09-two-primitives" primitives Primitives include_str!("../bundle/09-two-primitives.txt"),
    "lab-10" "10-polyhedra" polyhedra Polyhedra include_str!("../bundle/10-polyhedra.txt"),
    "lab-11" "11-support" support SupportJudge include_str!("../bundle/11-support.txt"),
}

/// A lab outside of the kit.
#[derive(Clone)]
pub(crate) struct OwnLab {
    /// Where its `lab.toml` lies.
    pub(crate) folder: PathBuf,
    name: String,
    judge: &'static dyn Judge,
}

impl OwnLab {
    /// As its `lab.toml` says; the name of its folder if that cannot be read.
    pub(crate) fn name(&self) -> String {
        self.name.clone()
    }
}

/// The labs that were added to this process.
static OWN: Mutex<Vec<OwnLab>> = Mutex::new(Vec::new());

/// Adds a lab that lies outside of the kit, in the folder with its `lab.toml`: from now on it is found by its name, as
/// those of the kit are.
pub fn add_own(folder: &Path, judge: &'static dyn Judge) {
    // `judge/..` is the lab's folder by another name.
    let folder = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    let manifest = std::fs::read_to_string(folder.join("lab.toml")).ok();
    let manifest = manifest.and_then(|text| Manifest::parse(&text, "lab.toml").ok());
    let of_folder = || folder.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let name = manifest.map_or_else(of_folder, |manifest| manifest.name);
    OWN.lock().unwrap_or_else(PoisonError::into_inner).push(OwnLab { folder, name, judge });
}

/// The labs that were added.
pub(crate) fn own() -> Vec<OwnLab> {
    OWN.lock().unwrap_or_else(PoisonError::into_inner).clone()
}
