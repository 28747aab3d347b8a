//! Subdivision as an edit: what it does to the surface, to selections, and its undoing.

use umbilic::app::{Session, SubdivideOptions, SubdivisionScheme};
use umbilic::flow::options::FlowOptions;
use umbilic::flow::spec::FlowName;

fn subdivide(session: &mut Session, scheme: SubdivisionScheme) {
    let options = SubdivideOptions { scheme };
    session.subdivide(options).expect("subdivided");
}

#[test]
fn the_linear_scheme_keeps_the_surface_and_loops_scheme_shrinks_a_sphere() {
    let mut s = Session::new();
    s.sample("icosahedron", &[("level".into(), 1.0)])
        .expect("a shape");
    s.configure(FlowOptions::default()).expect("configured");
    let before = s.info().expect("a mesh");
    subdivide(&mut s, SubdivisionScheme::Linear);
    s.configure(FlowOptions::default()).expect("configured");
    let linear = s.info().expect("a mesh");
    assert_eq!(linear.faces, 4 * before.faces);
    assert_eq!(linear.vertices, before.vertices + before.edges);
    assert!((linear.area / before.area - 1.0).abs() < 1e-12);
    s.undo_edit().expect("undone");
    assert_eq!(s.info().expect("a mesh"), before);
    subdivide(&mut s, SubdivisionScheme::Loop);
    let smooth = s.info().expect("a mesh");
    assert_eq!(smooth.faces, 4 * before.faces);
    // An affine mask of a convex surface stays inside it.
    assert!(smooth.volume.expect("closed") < 0.95 * before.volume.expect("closed"));
}

#[test]
fn what_is_free_on_the_finer_mesh_is_what_moved_on_the_coarser() {
    let mut s = Session::new();
    s.sample("icosahedron", &[("level".into(), 1.0)])
        .expect("a shape");
    let configured = FlowOptions {
        flow: FlowName::MeanCurvature,
        free: Some(vec![0]),
        ..FlowOptions::default()
    };
    s.configure(configured).expect("configured");
    let options = SubdivideOptions::default();
    let loaded = s.subdivide(options).expect("subdivided");
    // Vertex 0 has five neighbours in an icosahedron, and six edges meet nowhere near it.
    let mut free = loaded.free.expect("a selection");
    free.sort_unstable();
    assert_eq!(free.len(), 1 + 5);
    assert_eq!(free[0], 0);
    s.undo_edit().expect("undone");
    // Held: the vertex, its five neighbours, and the midpoints of spokes and rim.
    let triangles = s.loaded().expect("a mesh").triangles;
    let around = triangles.chunks_exact(3).filter(|t| t.contains(&0));
    let mut fixed: Vec<u32> = around.flatten().copied().collect();
    fixed.sort_unstable();
    fixed.dedup();
    assert_eq!(fixed.len(), 6);
    let configured = FlowOptions {
        flow: FlowName::MeanCurvature,
        fixed: Some(fixed),
        ..FlowOptions::default()
    };
    s.configure(configured).expect("configured");
    let fixed = s.subdivide(options).expect("subdivided").fixed;
    assert_eq!(fixed.expect("a selection").len(), 6 + 5 + 5);
}

#[test]
fn polygons_are_cut_into_triangles_that_are_divided() {
    let mut s = Session::new();
    let quad = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    s.load(quad, "quad.obj").expect("a mesh");
    s.subdivide(SubdivideOptions::default()).expect("divided");
    let info = s.info().expect("a mesh");
    assert_eq!((info.faces, info.vertices), (8, 9));
    s.undo_edit().expect("undone");
    assert_eq!(s.info().expect("a mesh").faces, 1);
}
