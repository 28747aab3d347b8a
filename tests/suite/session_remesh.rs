//! Remeshing as an edit: what it does to the surface, to selections, and its undoing.

use umbilic::app::{Edit, RemeshOptions, Session};
use umbilic::flow::options::{FlowName, FlowOptions};
use umbilic::remesh::adaptive::Kind;

fn opened(shape: &str, values: &[(&str, f64)]) -> Session {
    let values: Vec<_> = values.iter().map(|(n, v)| ((*n).into(), *v)).collect();
    let mut s = Session::new();
    s.sample(shape, &values).expect("a shape");
    s
}

#[test]
fn a_remeshed_surface_is_the_same_with_as_many_vertices_as_asked_for() {
    let mut s = opened("ellipsoid", &[("level", 3.0), ("jitter", 0.2)]);
    let before = s.info().expect("a mesh");
    let exact = s.frame().expect("a frame").exact;
    for kind in [Kind::Adaptive, Kind::Isotropic] {
        let options = RemeshOptions {
            kind,
            vertices: Some(1500),
            target: None,
        };
        let outcome = s.remesh(&options).expect("remeshed");
        let after = s.info().expect("a mesh");
        assert_eq!(after.vertices, outcome.after.vertices);
        assert!((after.vertices as f64 / 1500.0 - 1.0).abs() < 0.1);
        assert!((after.area / before.area - 1.0).abs() < 1e-12);
        let change = after.volume.expect("closed") / before.volume.expect("closed") - 1.0;
        assert!(change.abs() < 5e-3, "{kind:?}: volume {change:e}");
        assert!(outcome.before.min_angle_degrees < 15.0);
        assert!(outcome.after.min_angle_degrees > 28.0, "{outcome:?}");
        assert!(outcome.after.soundness.expect("closed").is_sound());
        let records = s.provenance().expect("known").edits;
        assert_eq!(
            records.last().map(|r| &r.edit),
            Some(&Edit::Remesh(options))
        );
        s.undo_edit().expect("undone");
        assert!(s.frame().expect("a frame").exact == exact);
    }
}

#[test]
fn a_length_asks_for_edges_of_that_length() {
    let mut s = opened("icosphere", &[("level", 3.0)]);
    let options = RemeshOptions {
        kind: Kind::Isotropic,
        target: Some(0.1),
        vertices: None,
    };
    let outcome = s.remesh(&options).expect("remeshed");
    let ratio = outcome.after.mean_edge_length / 0.1;
    assert!((ratio - 1.0).abs() < 0.05, "{ratio}");
    let both = RemeshOptions {
        vertices: Some(100),
        ..options
    };
    let fault = s.remesh(&both).expect_err("two lengths");
    assert_eq!(fault.message.id, "option-error-conflicting-options");
    let many = RemeshOptions {
        target: Some(1e-5),
        ..options
    };
    let fault = s.remesh(&many).expect_err("a billion");
    assert_eq!(fault.message.id, "app-too-many-vertices");
}

#[test]
fn what_is_held_stays_and_is_held_again() {
    let mut s = opened("icosphere", &[("level", 3.0)]);
    let fixed: Vec<u32> = (0..60).collect();
    let options = FlowOptions {
        flow: FlowName::MeanCurvature,
        fixed: Some(fixed.clone()),
        ..FlowOptions::default()
    };
    s.configure(options).expect("a flow");
    let of = |exact: &[f64], v: u32| exact[3 * v as usize..][..3].to_vec();
    let before = s.frame().expect("a frame").exact.0;
    s.remesh(&RemeshOptions::default()).expect("remeshed");
    let loaded = s.loaded().expect("a mesh");
    let held = loaded.fixed.expect("a selection").0;
    assert_eq!(loaded.free, None);
    s.configure(FlowOptions {
        flow: FlowName::MeanCurvature,
        ..FlowOptions::default()
    })
    .expect("a flow");
    let after = s.frame().expect("a frame").exact.0;
    let mut places: Vec<_> = held.iter().map(|&v| of(&after, v)).collect();
    let mut expected: Vec<_> = fixed.iter().map(|&v| of(&before, v)).collect();
    places.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
    expected.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
    assert!(places == expected);
}
