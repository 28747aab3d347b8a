//! Edge flips in a session: steps and the way back, criteria side by side, samples with
//! known ends, edits and their undoing.

use umbilic::app::{Arrangement, Compare, Curve, FlipOptions, Session};
use umbilic::energy::circle::Boundary;
use umbilic::flow::options::FlowOptions;
use umbilic::flow::spec::FlowName;
use umbilic::flow::{Reason, Status};
use umbilic::io::Format;
use umbilic::remesh::flips::reduction::Criterion;

fn options(criterion: Criterion) -> FlowOptions {
    FlowOptions {
        flow: FlowName::Flips,
        criterion,
        ..FlowOptions::default()
    }
}

fn arrange(session: &mut Session, compare: Compare, subdivide: usize, per_step: Option<usize>) {
    let arrangement = Arrangement {
        compare,
        subdivide,
        flips_per_step: per_step,
    };
    session.arrange(arrangement).expect("arranged");
}

fn session(shape: &str, values: &[(&str, f64)]) -> Session {
    let values: Vec<(String, f64)> = values.iter().map(|(n, v)| ((*n).into(), *v)).collect();
    let mut session = Session::new();
    session.sample(shape, &values).expect("a sample");
    session
}

fn export(session: &Session) -> Vec<u8> {
    session.export(Format::Ply).expect("a file")
}

/// Edges as pairs of vertices, sorted.
fn edges(wire: &[u32]) -> Vec<[u32; 2]> {
    let ordered = |e: &[u32]| [e[0].min(e[1]), e[0].max(e[1])];
    let mut edges: Vec<_> = wire.chunks_exact(2).map(ordered).collect();
    edges.sort_unstable();
    edges
}

/// Where the three criteria end, run beside each other.
fn ends(mut session: Session) -> Vec<(usize, f64, f64, Vec<[u32; 2]>)> {
    arrange(&mut session, Compare::Criteria, 0, None);
    session
        .configure(options(Criterion::Area))
        .expect("configured");
    session.run(10).expect("runs");
    let state = session.state().expect("a state");
    assert_eq!(state.status, Status::Converged);
    let readings = state.flips.expect("flips");
    let panes = session.panes("none").expect("panes");
    let names: Vec<_> = panes.iter().map(|pane| pane.name).collect();
    assert_eq!(names, ["area", "willmore", "localised"]);
    let order = [Criterion::Area, Criterion::Willmore, Criterion::Localised];
    order
        .iter()
        .zip(&panes)
        .map(|(criterion, pane)| {
            let r = readings.iter().find(|r| r.criterion == *criterion);
            let r = r.expect("each criterion runs");
            (r.flips, r.area, r.circle, edges(&pane.wire_edges))
        })
        .collect()
}

/// A torus on which all three criteria lead to the same mesh, and one on which they do not:
/// the sameness of figure 6 is a matter of the start.
#[test]
fn criteria_agree_on_one_torus_and_not_on_another() {
    let same = ends(session("sampled-torus", &[("jitter", 0.05)]));
    assert!(same[0].3 == same[1].3 && same[0].3 == same[2].3);
    assert_eq!(same[0].0, 203);
    let other = ends(session("sampled-torus", &[]));
    assert_eq!(
        other.iter().map(|e| e.0).collect::<Vec<_>>(),
        [240, 235, 240]
    );
    assert!(other[0].3 == other[2].3 && other[0].3 != other[1].3);
    assert!((other[1].2 - 107.543_447).abs() < 1e-5 && (other[0].2 - 108.351_304).abs() < 1e-5);
}

#[test]
fn face_and_head_take_as_many_flips_as_ever() {
    let face = ends(session("creased-face", &[]));
    let counts: Vec<_> = face.iter().map(|end| end.0).collect();
    assert_eq!(counts, [1843, 1730, 1841]);
    let head = ends(session("eared-head", &[("jitter", 0.2)]));
    let counts: Vec<_> = head.iter().map(|end| end.0).collect();
    assert_eq!(counts, [498, 417, 495]);
}

#[test]
fn steps_of_any_length_lead_the_same_way_and_back() {
    let run = |per_step| {
        let mut session = session("sampled-torus", &[]);
        arrange(&mut session, Compare::None, 0, per_step);
        let chosen = options(Criterion::Localised);
        session.configure(chosen).expect("configured");
        session
    };
    let mut whole = run(None);
    let start = export(&whole);
    whole.run(10).expect("runs");
    let end = export(&whole);
    let state = whole.state().expect("a state");
    assert_eq!((state.step, state.status), (240, Status::Converged));
    let criterion = "localised";
    assert_eq!(state.message, Some(Reason::NoFlips { criterion }.into()));
    let mut single = run(Some(1));
    assert_eq!(single.run(1000).expect("runs"), 240);
    assert_eq!(export(&single), end);
    let mut tens = run(Some(10));
    tens.run(1000).expect("runs");
    assert_eq!(tens.state().expect("a state").step, 240);
    // Flip by flip to the start, with the readings there were on the way.
    let energies: Vec<f64> = single
        .reports()
        .expect("reports")
        .iter()
        .map(|r| r.energy)
        .collect();
    for (made, energy) in energies.iter().enumerate().rev() {
        let state = single.state().expect("a state");
        assert_eq!((state.step, state.energy), (made + 1, *energy));
        single.back().expect("back");
    }
    assert!(!single.state().expect("a state").can_step_back);
    assert!(edges_of(&start) == edges_of(&export(&single)));
    single.run(1000).expect("runs again");
    assert_eq!(export(&single), end);
    // As after a crash: positions and the number of flips.
    let mut again = run(Some(7));
    let positions = again.frame().expect("a frame").exact;
    again
        .restore(&positions, None, 240, 240.0)
        .expect("restored");
    assert_eq!(export(&again).len(), end.len());
    assert!(edges_of(&export(&again)) == edges_of(&end));
}

/// The edges of a file, which may name its faces in another order.
fn edges_of(file: &[u8]) -> Vec<[u32; 2]> {
    let mut session = Session::new();
    edges(&session.load(file, "a.ply").expect("a mesh").wire_edges)
}

#[test]
fn panes_show_the_start_the_criteria_and_the_limit_surface() {
    let mut s = session("sampled-torus", &[]);
    arrange(&mut s, Compare::None, 0, Some(20));
    s.configure(options(Criterion::Willmore))
        .expect("configured");
    s.step().expect("a step");
    let panes = s.panes("none").expect("panes");
    assert_eq!(panes.len(), 1);
    assert_eq!(panes[0].name, "willmore");
    assert!(panes[0].field.is_none());
    // Twenty flips, some of them of an edge the step had made already.
    assert!((20..=40).contains(&panes[0].highlight.len()));
    let drawn = edges(&panes[0].wire_edges);
    for edge in edges(&panes[0].highlight) {
        assert!(drawn.binary_search(&edge).is_ok());
    }
    arrange(&mut s, Compare::Start, 1, Some(20));
    let panes = s.panes("gauss-curvature").expect("panes");
    assert_eq!([panes[0].name, panes[1].name], ["start", "willmore"]);
    let fields: Vec<_> = panes
        .iter()
        .map(|p| p.field.as_ref().expect("a field"))
        .collect();
    assert_eq!(
        (fields[0].low, fields[0].high),
        (fields[1].low, fields[1].high)
    );
    for pane in &panes {
        assert_eq!(pane.positions.len(), 3 * (392 + 1176));
        assert_eq!(pane.triangles.len(), 3 * 4 * 784);
    }
    arrange(&mut s, Compare::Criteria, 0, Some(20));
    let state = s.state().expect("a state").flips.expect("flips");
    // The others have caught up with the chosen one.
    assert_eq!(
        state.iter().map(|r| r.flips).collect::<Vec<_>>(),
        [20, 20, 20]
    );
    arrange(&mut s, Compare::None, 0, Some(20));
    assert_eq!(s.panes("none").expect("panes").len(), 1);
    let mut flowing = session("icosphere", &[]);
    flowing
        .configure(FlowOptions::default())
        .expect("configured");
    assert!(flowing.panes("none").expect("panes").is_empty());
}

/// Figure 6: the Gaussian curvature of the limit surface becomes smoother.
#[test]
fn gaussian_curvature_of_the_subdivided_torus_improves() {
    let mut s = session("sampled-torus", &[("jitter", 0.05)]);
    arrange(&mut s, Compare::Start, 2, None);
    s.configure(options(Criterion::Localised))
        .expect("configured");
    s.run(3).expect("runs");
    let panes = s.panes("gauss-curvature").expect("panes");
    // One scale of colours for both.
    let range = |i: usize| panes[i].field.as_ref().map(|f| (f.low, f.high));
    assert_eq!(range(0), range(1));
    let roughness = |i: usize| {
        let values = &panes[i].field.as_ref().expect("a field").values;
        let ends = panes[i].wire_edges.chunks_exact(2);
        ends.map(|e| (values[e[0] as usize] - values[e[1] as usize]).abs())
            .sum::<f32>()
    };
    println!("variation of K {} -> {}", roughness(0), roughness(1));
    assert!(
        roughness(1) < 0.7 * roughness(0),
        "{} {}",
        roughness(0),
        roughness(1)
    );
}

#[test]
fn a_flow_starts_from_the_flipped_mesh_and_undo_brings_the_old_one_back() {
    let mut s = session("sampled-torus", &[]);
    arrange(&mut s, Compare::None, 0, None);
    s.configure(options(Criterion::Localised))
        .expect("configured");
    let before = export(&s);
    s.run(5).expect("runs");
    let flipped = export(&s);
    let info = s.info().expect("info");
    assert_eq!((info.edges, info.euler_characteristic), (1176, 0));
    let adopted = s.adopt().expect("adopted");
    assert_eq!(edges(&adopted.wire_edges), edges_of(&flipped));
    s.configure(FlowOptions::default()).expect("configured");
    let start = s.state().expect("a state").energy;
    assert!((start - 108.3513).abs() < 1e-3, "{start}");
    s.run(5).expect("flows");
    assert!(s.state().expect("a state").energy < start);
    // The surface as it has flowed can be kept in turn, and each edit taken back.
    s.adopt().expect("adopted");
    s.undo_edit().expect("undone");
    s.configure(options(Criterion::Localised))
        .expect("configured");
    assert!(edges_of(&export(&s)) == edges_of(&flipped));
    s.undo_edit().expect("undone");
    s.configure(options(Criterion::Localised))
        .expect("configured");
    assert_eq!(export(&s), before);
    assert_eq!(s.undo_edit().expect_err("none left").kind, "NothingToUndo");
    // The one-shot optimisation is such an edit too.
    let outcome = s.flip(&FlipOptions::default()).expect("flips");
    assert_eq!(outcome.flips, 240);
    s.undo_edit().expect("undone");
    assert_eq!(export(&s), before);
}

#[test]
fn polygons_are_cut_into_triangles_that_are_flipped() {
    // Two that meet at the bottom of a long valley, which a flip across it fills.
    let points = [
        "-1 -.5 1", "0 -3 0", "0 3 0", "-1 .5 1", "1 -.5 1", "1 .5 1",
    ];
    let quads = format!("v {}\nf 1 2 3 4\nf 2 5 6 3\n", points.join("\nv "));
    let mut s = Session::new();
    s.load(quads.as_bytes(), "quads.obj").expect("a mesh");
    s.configure(options(Criterion::Area)).expect("configured");
    assert!(s.run(9).expect("runs") > 0);
    let mut t = Session::new();
    t.load(quads.as_bytes(), "quads.obj").expect("a mesh");
    let outcome = t.flip(&FlipOptions {
        criterion: Criterion::Area,
        ..FlipOptions::default()
    });
    assert!(outcome.expect("flips").flips > 0);
    let after = t.info().expect("a mesh");
    assert_eq!((after.faces, after.vertices), (4, 6));
    assert_eq!(edges_of(&export(&t)), edges_of(&export(&s)));
    t.undo_edit().expect("undone");
    assert_eq!(t.info().expect("a mesh").faces, 2);
}

#[test]
fn what_cannot_be_flipped_is_refused_and_the_flow_before_stays() {
    let mut s = session("sampled-torus", &[]);
    s.configure(options(Criterion::Area)).expect("configured");
    let none = Arrangement {
        flips_per_step: Some(0),
        ..Arrangement::default()
    };
    assert_eq!(s.arrange(none).expect_err("none").kind, "BadOption");
    s.step().expect("a step");
    assert_eq!(s.state().expect("a state").step, 1);
    // Nothing to flip: one triangle, and the boundary.
    let mut s = Session::new();
    s.load(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "one.obj")
        .expect("a mesh");
    s.configure(options(Criterion::Area)).expect("configured");
    assert_eq!(s.run(3).expect("runs"), 0);
    assert_eq!(s.state().expect("a state").status, Status::Converged);
}

#[test]
fn the_conjecture_fails_on_its_counterexample() {
    let mut s = session("counterexample", &[]);
    let report = s.conjecture().expect("a report");
    assert_eq!(
        (report.counterexamples, report.counts.localised_only),
        (1, 1)
    );
    assert_eq!(report.counts.total(), 1);
    let corners = <[u32; 4]>::try_from(report.corners.0).expect("one edge");
    let quad = s.quadrilateral(corners).expect("numbers");
    let area = 7.5 - 8f64.sqrt() - 0.5 * 89f64.sqrt();
    assert!((quad.area - area).abs() < 1e-14, "{}", quad.area);
    assert!(
        (quad.localised - 0.006_791_145_062_469_087).abs() < 1e-13,
        "{}",
        quad.localised
    );
    assert!((quad.total_area - 7.5).abs() < 1e-14);
    // The fourth point stands upright over the edge.
    assert!(
        (quad.fold_degrees[0] - 90.0).abs() < 1e-10,
        "{:?}",
        quad.fold_degrees
    );
    assert_eq!(
        s.quadrilateral([0, 1, 2, 9]).expect_err("none").kind,
        "NoSuchVertex"
    );
    // Each criterion by itself: the area keeps the edge, the localised energy flips it.
    for (criterion, flips) in [(Criterion::Area, 0), (Criterion::Localised, 1)] {
        s.configure(options(criterion)).expect("configured");
        s.run(3).expect("runs");
        assert_eq!(s.state().expect("a state").step, flips, "{criterion:?}");
    }
    // In a plane f_a = 0, and with an obtuse kite f_l > 0; a square decides nothing.
    let kite = "v 0 0 0\nv 4 0 0\nv 1 .5 0\nv 1 -.5 0\nf 1 3 2\nf 1 2 4\n";
    let square = "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 3 2\nf 1 2 4\n";
    for (text, expected) in [(kite, 1), (square, 0)] {
        let mut plane = Session::new();
        plane.load(text.as_bytes(), "plane.obj").expect("a mesh");
        let report = plane.conjecture().expect("a report");
        assert_eq!(report.counterexamples, expected, "{text}");
    }
    let face = session("creased-face", &[]).conjecture().expect("a report");
    assert_eq!((face.counts.both, face.counts.area_only), (1601, 1));
    assert_eq!(face.area.len() * 4, face.corners.len());
    assert!(face.area[0] > 0.0 && face.localised[0] <= 0.0);
}

#[test]
fn the_lab_grows_and_shows_the_law_of_the_angle() {
    let mut session = Session::new();
    session.lab(100_000);
    let report = session.lab(900_000);
    assert_eq!(report.tetrahedra, 1_000_000);
    let rate = report.counterexamples.iter().sum::<usize>() as f64 / 1e6;
    // Four standard deviations.
    assert!((rate - 0.003734).abs() < 0.00025, "{rate}");
    let total: usize = report.classes.iter().map(|c| c.total).sum();
    assert_eq!(total, 2_000_000);
    for c in &report.classes {
        println!("below {}°: {} of {}", c.below, c.counterexamples, c.total);
    }
    // Nearly flat: none. Wider: by a power of the angle.
    let below = |degrees: f64| report.classes.iter().filter(move |c| c.below <= degrees);
    assert_eq!(below(1.0).map(|c| c.counterexamples).sum::<usize>(), 0);
    let flat = below(1.0).map(|c| c.total).sum::<usize>();
    // Without those that a flip would fold over.
    assert!((45_000..55_000).contains(&flat), "{flat}");
    let share = |degrees: f64| {
        let class = report.classes.iter().find(|c| c.below == degrees);
        let class = class.expect("a class");
        class.counterexamples as f64 / class.total as f64
    };
    // A power of the angle between 1 and 3: of these about 1.5, of tetrahedra alone 1.9.
    let slope = (share(64.0) / share(16.0)).log2() / 2.0;
    println!(
        "rates {:.5} {:.5} {:.5}: order {slope:.2}",
        share(16.0),
        share(32.0),
        share(64.0)
    );
    assert!((1.1..2.2).contains(&slope), "order {slope}");
    let strongest = report.strongest.expect("a counterexample");
    assert!(strongest.area * strongest.localised < 0.0);
    assert_eq!(session.lab(0).tetrahedra, 0);
}

#[test]
fn curves_follow_every_run_to_its_end() {
    let mut s = session("sampled-torus", &[]);
    s.configure(options(Criterion::Area)).expect("configured");
    let curves = s.curves().expect("curves");
    assert_eq!((curves.flips.0, curves.runs.len()), (vec![0.0], 1));
    arrange(&mut s, Compare::Criteria, 0, Some(50));
    s.run(100).expect("runs");
    let curves = s.curves().expect("curves");
    assert_eq!(curves.flips.len(), 241);
    let state = s.state().expect("a state").flips.expect("flips");
    for curve in &curves.runs {
        let (area, circle) = (&curve.area, &curve.circle);
        let is_willmore = curve.criterion == Criterion::Willmore;
        let n = if is_willmore { 235 } else { 240 };
        let falls = |values: &[f64]| values[..=n].windows(2).all(|w| w[1] < w[0]);
        match curve.criterion {
            Criterion::Area => assert!(falls(area)),
            Criterion::Willmore => assert!(falls(circle)),
            Criterion::Localised => {}
        }
        let end = state.iter().find(|r| r.flips == n && r.circle == circle[n]);
        assert_eq!(end.expect("as in the readings").area, area[n]);
        assert!((n + 2..=240).all(|i| area[i].is_nan() && circle[i].is_nan()));
    }
    let mut large = session("creased-face", &[]);
    arrange(&mut large, Compare::Criteria, 0, None);
    large
        .configure(options(Criterion::Area))
        .expect("configured");
    large.run(3).expect("runs");
    let curves = large.curves().expect("curves");
    assert!(
        (300..=401).contains(&curves.flips.len()),
        "{}",
        curves.flips.len()
    );
    assert_eq!(curves.flips.last(), Some(&1843.0));
    // Every curve has its end, also one between two points of the plot.
    for reading in large.state().expect("a state").flips.expect("flips") {
        let found = |curve: &Curve| {
            curve.area.contains(&reading.area) && curve.circle.contains(&reading.circle)
        };
        assert!(curves.runs.iter().any(found), "{:?}", reading.criterion);
    }
}

/// W of flips is what `energy` tells, on open surfaces that with a free boundary.
#[test]
fn flips_and_energies_tell_the_same_w() {
    for shape in ["hemisphere", "moebius", "monkey-saddle", "ellipsoid"] {
        for criterion in Criterion::ALL {
            let mut session = session(shape, &[]);
            let told = |session: &Session| {
                let readings = session.energy(Boundary::Free, &[]).expect("a mesh");
                readings.circle
            };
            let before = told(&session);
            let options = FlipOptions {
                criterion,
                ..FlipOptions::default()
            };
            let outcome = session.flip(&options).expect("flips");
            let after = told(&session);
            let close = |a: f64, b: f64| (a - b).abs() < 1e-9 * b.abs().max(1.0);
            assert!(
                close(outcome.before.circle, before),
                "{shape} {criterion:?}: {before}"
            );
            assert!(
                close(outcome.after.circle, after),
                "{shape} {criterion:?}: {after}"
            );
        }
    }
}

/// Flips cut off a part of an ear, and nothing of a ball.
#[test]
fn flips_that_cut_the_shape_say_so() {
    for (mut s, is_cut) in [
        (session("eared-head", &[("jitter", 0.2)]), true),
        (session("icosphere", &[("level", 3.0)]), false),
    ] {
        let before = s.info().expect("a mesh").volume.expect("closed");
        let options = FlipOptions {
            criterion: Criterion::Area,
            ..FlipOptions::default()
        };
        let outcome = s.flip(&options).expect("flips");
        let after = s.info().expect("a mesh").volume.expect("closed");
        assert_eq!((after / before - 1.0).abs() > 0.005, is_cut);
        let ids: Vec<&str> = outcome.warnings.iter().map(|one| &*one.id).collect();
        let said: &[&str] = if is_cut {
            &["notice-flipped-volume"]
        } else {
            &[]
        };
        assert_eq!(ids, said);
    }
}
