//! Filling as a session does it: the free set, cancelling, undoing.

use std::ops::ControlFlow;
use umbilic::app::{Fault, FillOptions, FillOutcome, FlipOptions, Loops, Session};
use umbilic::flow::Status;
use umbilic::flow::options::FlowOptions;
use umbilic::flow::spec::FlowName;
use umbilic::io::Format;
use umbilic::remesh::fill::FillProgress;

fn session(name: &str, values: &[(&str, f64)]) -> Session {
    let values: Vec<(String, f64)> = values.iter().map(|&(n, v)| (n.into(), v)).collect();
    let mut session = Session::new();
    session.sample(name, &values).expect("a shape");
    session
}

/// Outer rims too.
fn all() -> FillOptions {
    FillOptions {
        loops: Loops::Word("all".into()),
        ..FillOptions::default()
    }
}

fn fill(session: &mut Session, options: &FillOptions) -> Result<FillOutcome, Fault> {
    let go_on: FillProgress<'_> = &mut |_, _| ControlFlow::Continue(());
    session.fill(options, go_on)
}

/// Everything a session tells of its mesh and its run.
fn everything(session: &Session) -> impl PartialEq + std::fmt::Debug + use<> {
    let reports = session.reports().expect("reports");
    (
        session.export(Format::Ply).expect("exported"),
        session.loaded().expect("a mesh"),
        session.state().expect("a state"),
        // All their numbers: they are printed so that they can be read back.
        format!("{reports:?}"),
        session.held_vertices().expect("a selection"),
    )
}

#[test]
fn the_next_flow_moves_the_new_vertices_only() {
    let mut s = session("monkey-saddle", &[]);
    let before = s.positions().expect("positions");
    let n = before.len() / 3;
    let outcome = fill(&mut s, &all()).expect("filled");
    assert_eq!(
        (outcome.filled.as_slice(), outcome.first_vertex),
        (&[0][..], n)
    );
    let info = s.info().expect("a mesh");
    assert!(info.closed && info.genus == Some(0));
    assert_eq!(info.vertices, n + outcome.new_vertices);
    assert!(
        info.warnings
            .iter()
            .any(|w| &*w.id == "notice-filled" && w.number("count") == Some(1.0))
    );
    // Whatever was asked of the flow before.
    let configured = s.configure(FlowOptions::default()).expect("configured");
    assert_eq!(configured.free_vertices, outcome.new_vertices);
    let held = s.held_vertices().expect("a selection");
    assert!(held[..n].iter().all(|&h| h == 1) && held[n..].iter().all(|&h| h == 0));
    let start = s.positions().expect("positions");
    s.run(5).expect("steps");
    let after = s.positions().expect("positions");
    assert_eq!(after[..3 * n], before[..]);
    assert_ne!(after[3 * n..], start[3 * n..]);
}

/// What a page does with a sphere with holes, or with tubes: fill, choose a flow, play.
#[test]
fn a_fill_is_faired_by_the_flow_that_is_chosen_next() {
    let mut s = session("holed-sphere", &[("level", 4.0), ("holes", 4.0)]);
    let n = s.positions().expect("positions").len() / 3;
    let outcome = fill(&mut s, &FillOptions::default()).expect("filled");
    assert_eq!((outcome.filled.len(), outcome.first_vertex), (4, n));
    assert!(outcome.warnings.is_empty(), "{:?}", outcome.warnings);
    assert!(s.info().expect("a mesh").closed);
    let off = |s: &Session| {
        let x = s.positions().expect("positions");
        let radius = |p: &[f32]| p.iter().map(|c| f64::from(*c).powi(2)).sum::<f64>().sqrt();
        let off = x.chunks_exact(3).map(|p| (radius(p) - 1.0).abs());
        off.fold(0.0, f64::max)
    };
    let first = off(&s);
    let options = FlowOptions {
        flow: FlowName::Mmcv,
        ..FlowOptions::default()
    };
    let configured = s.configure(options).expect("configured");
    assert_eq!(configured.free_vertices, outcome.new_vertices);
    s.run(100).expect("steps");
    assert_eq!(s.state().expect("a state").status, Status::Converged);
    // A surface of constant H is kept, and no surface else.
    assert!(off(&s) < 5e-5 && first > 2e-4, "{first} -> {}", off(&s));
    let jump = s.curvature_jump().expect("a mesh").expect("rims");
    assert!(jump.relative < 1e-3, "{jump:?}");
}

#[test]
fn a_selection_from_before_does_not_outlive_the_fill() {
    let mut s = session("hemisphere", &[]);
    s.configure(FlowOptions::default()).expect("configured");
    let held = s.held_vertices().expect("a selection");
    let inner = held.iter().position(|h| *h == 0).expect("a free vertex");
    let options = FlowOptions {
        free: Some(vec![inner as u32]),
        ..FlowOptions::default()
    };
    s.configure(options).expect("configured");
    let outcome = fill(&mut s, &all()).expect("filled");
    s.reset().expect("reset");
    let free = s
        .held_vertices()
        .expect("a selection")
        .iter()
        .filter(|h| **h == 0)
        .count();
    assert_eq!(free, outcome.new_vertices);
}

#[test]
fn cancelling_and_failing_leave_everything_as_it_was() {
    let mut s = session("cylinder", &[]);
    s.run(3).expect("steps");
    let before = everything(&s);
    for calls in [0, 3, 9] {
        let mut left = calls;
        let stop: FillProgress<'_> = &mut |_, _| {
            left -= 1;
            if left < 0 {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        };
        let fault = s.fill(&all(), stop).expect_err("cancelled");
        assert_eq!(fault.kind, "Cancelled");
        assert!(everything(&s) == before && !s.can_undo_edit(), "{calls}");
    }
    for (loops, kind) in [
        (Loops::Some(vec![7]), "LoopOutOfRange"),
        (Loops::Word("some".into()), "UnknownLoops"),
    ] {
        let options = FillOptions {
            loops,
            ..FillOptions::default()
        };
        assert_eq!(fill(&mut s, &options).expect_err("refused").kind, kind);
        assert!(everything(&s) == before);
    }
    assert_eq!(
        Session::new().boundary_loops().expect_err("no mesh").kind,
        "NoMesh"
    );
}

#[test]
fn undo_restores_a_session_bit_for_bit_and_the_flow_goes_on() {
    let mut s = session("monkey-saddle", &[("rings", 8.0)]);
    let mut twin = session("monkey-saddle", &[("rings", 8.0)]);
    s.run(4).expect("steps");
    twin.run(4).expect("steps");
    let before = everything(&s);
    assert_eq!(s.positions(), twin.positions());
    fill(&mut s, &all()).expect("filled");
    s.run(2).expect("steps");
    assert!(before != everything(&s) && s.can_undo_edit());
    let loaded = s.undo_edit().expect("undone");
    assert!(everything(&s) == before && loaded == twin.loaded().expect("a mesh"));
    assert!(!s.can_undo_edit());
    // And on as if nothing had been.
    s.run(1).expect("a step");
    twin.run(1).expect("a step");
    assert_eq!(s.positions(), twin.positions());
    let last = |s: &Session| {
        s.reports()
            .expect("reports")
            .last()
            .map(|r| (r.step, r.time, r.tau))
    };
    assert_eq!(last(&s), last(&twin));
    s.back().expect("back");
    twin.back().expect("back");
    assert_eq!(s.positions(), twin.positions());
    assert_eq!(s.undo_edit().expect_err("nothing").kind, "NothingToUndo");
}

#[test]
fn flips_and_fills_are_undone_in_turn_and_a_new_mesh_forgets_them() {
    let mut s = session("scar", &[]);
    let start = everything(&s);
    let flips = s.flip(&FlipOptions::default()).expect("flips").flips;
    assert!(flips > 0);
    s.undo_edit().expect("undone");
    assert!(everything(&s) == start);

    let mut s = session("cylinder", &[]);
    let start = everything(&s);
    let options = FillOptions {
        loops: Loops::Some(vec![1]),
        ..FillOptions::default()
    };
    fill(&mut s, &options).expect("filled");
    let half = everything(&s);
    fill(&mut s, &all()).expect("filled");
    s.undo_edit().expect("undone");
    assert!(everything(&s) == half);
    s.undo_edit().expect("undone");
    assert!(everything(&s) == start);
    fill(&mut s, &options).expect("filled");
    s.sample("disk", &[]).expect("a shape");
    assert!(!s.can_undo_edit());
}

#[test]
fn loops_are_told_in_the_order_of_their_numbers() {
    let mut s = session("cylinder", &[("around", 30.0)]);
    let loops = s.boundary_loops().expect("a mesh");
    assert_eq!(loops.iter().map(|l| l.edges).collect::<Vec<_>>(), [30, 30]);
    for l in &loops {
        let polygon = 60.0 * (std::f64::consts::PI / 30.0).sin();
        assert!((l.length - polygon).abs() < 1e-12 && l.vertices.len() == 30);
    }
    let options = FillOptions {
        loops: Loops::Some(vec![0]),
        ..FillOptions::default()
    };
    fill(&mut s, &options).expect("filled");
    assert_eq!(s.boundary_loops().expect("a mesh"), loops[1..]);
}

/// A curved sheet of `n` by `n` squares without those of a list, as an OBJ file.
fn sheet(n: usize, without: &[(usize, usize)], scale: f64, far: f64) -> Vec<u8> {
    let mut text = String::new();
    for j in 0..=n {
        for i in 0..=n {
            let (x, y) = (i as f64 / n as f64, j as f64 / n as f64);
            let z = 0.2 * (2.5 * x).sin() * (1.0 + y);
            let [x, y, z] = [x, y, z].map(|c| c * scale + far);
            text += &format!("v {x:?} {y:?} {z:?}\n");
        }
    }
    for j in 0..n {
        for i in (0..n).filter(|i| !without.contains(&(*i, j))) {
            let a = j * (n + 1) + i + 1;
            let [b, c, d] = [a + 1, a + n + 2, a + n + 1];
            text += &format!("f {a} {b} {c}\nf {a} {c} {d}\n");
        }
    }
    text.into_bytes()
}

fn opened(bytes: &[u8]) -> Session {
    let mut session = Session::new();
    session.load(bytes, "sheet.obj").expect("a surface");
    session
}

#[test]
fn holes_that_share_a_corner_are_two_and_the_outer_rim_stays_open() {
    // Squares along a side, those that are left out, size and place.
    type Case = (usize, &'static [(usize, usize)], f64, f64);
    let cases: [Case; 4] = [
        (8, &[(3, 3), (4, 4)], 1.0, 0.0),
        (9, &[(4, 4), (5, 3)], 1e-6, 1.0),
        (12, &[(2, 2), (3, 3), (4, 4)], 1e6, 5e6),
        (10, &[(2, 2), (3, 3), (2, 3), (4, 4), (7, 7)], 1e3, 0.0),
    ];
    for (n, without, scale, far) in cases {
        let mut s = opened(&sheet(n, without, scale, far));
        let loops = s.boundary_loops().expect("a mesh");
        let info = s.info().expect("a mesh");
        assert_eq!(info.boundary_loops, loops.len());
        let small: Vec<usize> = (0..loops.len()).filter(|n| loops[*n].small).collect();
        // Squares that share an edge are one hole.
        let holes = if without.len() == 5 { 3 } else { without.len() };
        assert_eq!((loops.len(), small.len()), (holes + 1, holes), "{loops:?}");
        let vertices = info.vertices;
        let outcome = fill(&mut s, &FillOptions::default()).expect("filled");
        assert_eq!((&outcome.filled, &outcome.warnings[..]), (&small, &[][..]));
        let after = s.info().expect("a mesh");
        assert_eq!((after.boundary_loops, after.components), (1, 1));
        assert_eq!((after.euler_characteristic, after.genus), (1, Some(0)));
        // The copies of a corner are one vertex again.
        assert!(outcome.first_vertex < vertices && after.oriented);
        assert_eq!(after.vertices, outcome.first_vertex + outcome.new_vertices);
        assert!(s.boundary_loops().expect("a mesh").iter().all(|l| !l.small));
        s.undo_edit().expect("undone");
        // One of them alone, and then the next by the number that it has then.
        let one = |n: usize| FillOptions {
            loops: Loops::Some(vec![n]),
            ..FillOptions::default()
        };
        let mut left = loops.len();
        while let Some(n) = s
            .boundary_loops()
            .expect("a mesh")
            .iter()
            .position(|l| l.small)
        {
            fill(&mut s, &one(n)).expect("filled");
            left -= 1;
            assert_eq!(s.boundary_loops().expect("a mesh").len(), left);
        }
        assert_eq!(s.info().expect("a mesh").euler_characteristic, 1);
    }
}

/// A tube about the z-axis of so many rings, without some of its squares, as an OBJ file; `tip` is
/// the radius at its end over that at its beginning.
fn tube(rings: usize, length: f64, tip: f64, without: &[(usize, usize)]) -> Vec<u8> {
    use std::fmt::Write as _;
    const AROUND: usize = 16;
    let mut text = String::new();
    for i in 0..=rings {
        let t = i as f64 / rings as f64;
        let r = 1.0 + t * (tip - 1.0);
        for j in 0..AROUND {
            let (sin, cos) = (j as f64 * std::f64::consts::TAU / AROUND as f64).sin_cos();
            writeln!(text, "v {} {} {}", r * cos, r * sin, length * t).expect("text");
        }
    }
    for i in 0..rings {
        for j in (0..AROUND).filter(|j| !without.contains(&(i, *j))) {
            let v = |i: usize, j: usize| i * AROUND + j % AROUND + 1;
            let corners = [v(i, j), v(i, j + 1), v(i + 1, j + 1), v(i + 1, j)];
            let [a, b, c, d] = corners;
            writeln!(text, "f {a} {b} {c} {d}").expect("text");
        }
    }
    text.into_bytes()
}

#[test]
fn the_mouths_of_a_tube_are_no_holes_and_a_missing_tip_is_one() {
    let small = |bytes: &[u8]| {
        let loops = opened(bytes).boundary_loops().expect("a mesh");
        let lengths = loops.iter().map(|l| (l.small, l.length < 4.0));
        lengths.collect::<Vec<_>>()
    };
    for (rings, length) in [(24, 6.5), (24, 12.0), (60, 40.0), (90, 90.0)] {
        // Both ends are shorter than the diagonal of the box.
        let whole = tube(rings, length, 1.0, &[]);
        assert_eq!(small(&whole), [(false, false); 2], "{length}");
        let found = small(&tube(rings, length, 1.0, &[(9, 3), (9, 4)]));
        assert_eq!(
            found.iter().filter(|l| l.0).count(),
            1,
            "{length}: {found:?}"
        );
        assert!(found.contains(&(true, length < 40.0)) || length >= 40.0);
    }
    // A spike without its tip: the wide end is a mouth, and the narrow one is to be closed.
    assert_eq!(
        small(&tube(60, 20.0, 0.05, &[])),
        [(false, false), (true, true)]
    );
}

#[test]
fn an_outer_rim_is_filled_only_when_it_is_chosen() {
    for (name, loops) in [("disk", 1), ("hemisphere", 1), ("monkey-saddle", 1)] {
        let mut s = session(name, &[]);
        let before = everything(&s);
        let fault = fill(&mut s, &FillOptions::default()).expect_err("no hole");
        assert_eq!(
            (fault.kind, fault.message.number("loops")),
            ("NoSmallLoops", Some(1.0))
        );
        assert!(everything(&s) == before);
        assert_eq!(fill(&mut s, &all()).expect("filled").filled.len(), loops);
        assert!(s.info().expect("a mesh").closed);
    }
    let mut s = opened(&sheet(8, &[(3, 3)], 1.0, 0.0));
    let outcome = fill(&mut s, &FillOptions::default()).expect("filled");
    assert_eq!(
        (
            outcome.filled.len(),
            s.info().expect("a mesh").boundary_loops
        ),
        (1, 1)
    );
    let Some(folder) = crate::support::shared_folder("cases/files") else {
        return;
    };
    for (name, holes) in [("flat_hole.obj", 1), ("bowtie_hole.obj", 2)] {
        let mut s = opened(&std::fs::read(folder.join(name)).expect("a file"));
        let outcome = fill(&mut s, &FillOptions::default()).expect("filled");
        let info = s.info().expect("a mesh");
        assert_eq!(
            (outcome.filled.len(), info.boundary_loops),
            (holes, 1),
            "{name}"
        );
        if name == "flat_hole.obj" {
            assert!((info.area - 1.0).abs() < 1e-9, "{}", info.area);
        }
    }
}

/// Where there is no room for a patch the builder would leave faces out, and what was known of the
/// patches by their numbers would be of others.
#[test]
fn a_folded_quadrilateral_beside_another_component_is_left_open() {
    let cube =
        "v 5 0 0\nv 6 0 0\nv 6 1 0\nv 5 1 0\nv 5.5 .5 1\nf 5 6 9\nf 6 7 9\nf 7 8 9\nf 8 5 9\n";
    for (n, fourth) in [
        "0 1 0",
        "1e-12 1 0",
        "0 1.0000001 0",
        "1 0 1e-7",
        "0 0 1e-9",
        ".5 .5 0",
    ]
    .iter()
    .enumerate()
    {
        for faces in ["f 1 2 3 4\n", "f 1 2 3\nf 1 3 4\n", "f 1 2 4\nf 2 3 4\n"] {
            let text = format!("v 1 0 0\nv 0 1 0\nv 0 0 0\nv {fourth}\n{cube}{faces}");
            let mut session = Session::new();
            if session.load(text.as_bytes(), "fold.obj").is_err() {
                continue;
            }
            for options in [all(), FillOptions::default()] {
                match fill(&mut session, &options) {
                    Ok(_) => {
                        session.info().expect("a mesh");
                        session.run(1).ok();
                        session.undo_edit().expect("undone");
                    }
                    Err(fault) => assert!(
                        ["NoRoom", "TouchingLoop", "NoSmallLoops"].contains(&fault.kind),
                        "{n}: {fault:?}"
                    ),
                }
            }
        }
    }
}

/// A sphere without these faces, as an OBJ file.
fn sphere_without(gone: &[usize]) -> Vec<u8> {
    let s = session("icosphere", &[("level", 3.0)]);
    let text = String::from_utf8(s.export(Format::Obj).expect("a file")).expect("text");
    let mut face = 0;
    let kept = text.lines().filter(|line| {
        let is_face = line.starts_with("f ");
        face += usize::from(is_face);
        !is_face || !gone.contains(&(face - 1))
    });
    kept.map(|line| format!("{line}\n"))
        .collect::<String>()
        .into_bytes()
}

/// Faces that have corners in common with others, in the order of the file.
fn faces_of(bytes: &[u8]) -> Vec<Vec<u32>> {
    let text = std::str::from_utf8(bytes).expect("text");
    let faces = text.lines().filter_map(|line| line.strip_prefix("f "));
    let numbers = |face: &str| {
        face.split(' ')
            .map(|v| v.parse().expect("a number"))
            .collect()
    };
    faces.map(numbers).collect()
}

#[test]
fn holes_around_an_island_are_filled_and_it_stays_a_part_of_the_surface() {
    let whole = sphere_without(&[]);
    let faces = faces_of(&whole);
    let beside = |f: usize| -> Vec<usize> {
        let shared = |g: &usize| faces[*g].iter().filter(|v| faces[f].contains(v)).count();
        (0..faces.len())
            .filter(|g| *g != f && shared(g) == 2)
            .collect()
    };
    let area = opened(&whole).info().expect("a mesh").area;
    let mut state = 3_u64;
    let mut random = |n: usize| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 33) as usize % n
    };
    // About one face, about two, and wherever chance has it.
    let mut cases = vec![beside(100), [beside(100), beside(700)].concat()];
    cases.extend((0..12).map(|k| (0..12 + 8 * k).map(|_| random(faces.len())).collect()));
    // About a square of a sheet, whose outer rim stays.
    for (n, scale) in [(7, 1.0), (8, 1e-3)] {
        let mut s = opened(&sheet(n, &[(3, 2), (2, 3), (4, 3), (3, 4)], scale, 0.0));
        fill(&mut s, &FillOptions::default()).expect("filled");
        let after = s.info().expect("a mesh");
        let told = (
            after.components,
            after.boundary_loops,
            after.self_intersections,
        );
        assert_eq!(told, (1, 1, Some(0)));
    }
    for gone in cases {
        let mut s = opened(&sphere_without(&gone));
        let loops = s.boundary_loops().expect("a mesh");
        assert_eq!(s.info().expect("a mesh").boundary_loops, loops.len());
        fill(&mut s, &FillOptions::default()).expect("filled");
        let after = s.info().expect("a mesh");
        let told = (after.components, after.closed, after.genus);
        assert_eq!(told, (1, true, Some(0)), "{} gone: {after:?}", gone.len());
        assert!((after.area / area - 1.0).abs() < 2e-3, "{}", after.area);
        assert_eq!(after.self_intersections, Some(0));
    }
}
