//! The cells of `examples/notebook.ipynb`, as a program: what a cell ends with is shown.

use super::Shown;
use std::error::Error;

pub(super) fn run(show: &mut dyn FnMut(&dyn Shown)) -> Result<(), Box<dyn Error>> {
    // %% [markdown]
    // # Half-edges in a notebook
    //
    // [evcxr](https://github.com/evcxr/evcxr) is a kernel for Jupyter that runs Rust. A subdivision, a solid, a figure or a
    // page at the end of a cell is shown as a picture. The first cell takes a while: the kit is compiled.
    // %%
    // :dep dcel-kit = { path = ".." }
    // %%
    use dcel_kit::{HalfEdgeId, Subdivision};

    let mut lab = Subdivision::lab_rectangle();
    show(&lab);
    // %% [markdown]
    // `split_face` joins two corners of a face. Half-edge `h2` begins at one of them, `h8` at the other.
    // %%
    let (h, f) = lab.split_face(HalfEdgeId::new(2), HalfEdgeId::new(8))?;
    let corners: Vec<_> = lab.incident_vertices(f).collect();
    println!("{h} is new, and on its left is {f} with the corners {corners:?}");
    show(&lab);
    // %% [markdown]
    // What cannot be done is refused, and changes nothing.
    // %%
    println!("{}", lab.split_face(h, h).unwrap_err());
    // %% [markdown]
    // Figures have options; their titles tell them apart.
    // %%
    use dcel_kit::figure::{self, FigureOptions, Pointers};

    show(&figure::pointers(&lab, &[Pointers::Next, Pointers::Twin], &FigureOptions::new("Pointers"))?);
    // %%
    use dcel_kit::solid::{Platonic, Polyhedron};

    show(&Polyhedron::platonic(Platonic::Dodecahedron));
    Ok(())
}
