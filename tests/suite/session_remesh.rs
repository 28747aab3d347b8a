//! Remeshing: as an edit, what it does to the surface and to selections; between the steps of a
//! flow, what it gains, and that history and recipes know of it.

use crate::support::parts::{self, Ends};
use std::f64::consts::PI;
use umbilic::app::{Edit, Origin, RemeshOptions, ScriptText, Session};
use umbilic::flow::constraint::Kept;
use umbilic::flow::options::{FlowOptions, Remeshing};
use umbilic::flow::spec::FlowName;
use umbilic::flow::{Status, StepReport};
use umbilic::io::{self, Format};
use umbilic::remesh::adaptive::{Creases, Kind};

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
            ..RemeshOptions::default()
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
        assert!(outcome.after.soundness.expect("closed").is_sound);
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
fn what_is_thinner_than_its_triangles_is_not_made_another_surface() {
    let ball = opened("icosphere", &[("level", 3.0)]);
    let obj = ball.export(Format::Obj).expect("a file");
    let obj = String::from_utf8(obj).expect("a text");
    for (thickness, is_kept) in [(0.02, false), (0.05, false), (0.07, false), (0.4, true)] {
        // A pancake: its rim is bent more sharply than its triangles can tell.
        let line = |line: &str| {
            let words: Vec<&str> = line.split_whitespace().collect();
            match words[..] {
                ["v", x, y, z] => {
                    format!(
                        "v {x} {y} {}\n",
                        thickness * z.parse::<f64>().expect("a number")
                    )
                }
                _ => format!("{line}\n"),
            }
        };
        let text: String = obj.lines().map(line).collect();
        let mut s = Session::new();
        s.load(text.as_bytes(), "pancake.obj").expect("a surface");
        for kind in [Kind::Adaptive, Kind::Isotropic] {
            // Where it is bent so much that it is an edge of the shape, it may stay one.
            for creases in [Creases::Smooth, Creases::Keep] {
                let options = RemeshOptions {
                    kind,
                    creases,
                    ..RemeshOptions::default()
                };
                let may = is_kept || creases == Creases::Keep;
                let before = s.info().expect("a mesh");
                match s.remesh(&options) {
                    Ok(outcome) => {
                        let after = outcome.after;
                        let area = after.area / before.area - 1.0;
                        assert!(may && area.abs() < 0.01, "{thickness}: {area}");
                        let volumes = [after.volume, before.volume].map(|v| v.expect("closed"));
                        let volume = volumes[0] / volumes[1] - 1.0;
                        assert!(volume.abs() < 0.05, "{thickness}: {volume}");
                        s.undo_edit().expect("undone");
                    }
                    Err(fault) => {
                        assert!(!is_kept && fault.kind == "Spoilt", "{thickness}: {fault:?}");
                        assert_eq!(s.info().expect("a mesh"), before);
                    }
                }
            }
        }
    }
}

/// Taken for smooth, an edge of 45° bulges by some per cent of the volume.
#[test]
fn chamfers_stay_as_flat_as_they_are() {
    let outline = parts::chamfered(4.0, 3.0, 0.5);
    let soup = parts::refined(&parts::prism(&outline, &[0.0, 2.0], Ends::Hub), 1);
    let file = io::write(&soup, Format::Ply, "").expect("a file");
    for kind in [Kind::Adaptive, Kind::Isotropic] {
        let mut s = Session::new();
        s.load(&file, "chamfered.ply").expect("a surface");
        let before = s.info().expect("a mesh");
        let options = RemeshOptions {
            kind,
            vertices: Some(1200),
            ..RemeshOptions::default()
        };
        s.remesh(&options).expect("remeshed");
        let after = s.info().expect("a mesh");
        let off = after.volume.expect("closed") / before.volume.expect("closed") - 1.0;
        assert!(off.abs() < 1e-3, "{kind:?}: {off}");
        assert!((after.area / before.area - 1.0).abs() < 1e-3, "{kind:?}");
    }
}

#[test]
fn a_length_asks_for_edges_of_that_length() {
    let mut s = opened("icosphere", &[("level", 3.0)]);
    let options = RemeshOptions {
        kind: Kind::Isotropic,
        target: Some(0.1),
        ..RemeshOptions::default()
    };
    let outcome = s.remesh(&options).expect("remeshed");
    let ratio = outcome.after.mean_edge_length / 0.1;
    assert!((ratio - 1.0).abs() < 0.05, "{ratio}");
    let both = RemeshOptions {
        vertices: Some(100),
        ..options
    };
    let fault = s.remesh(&both).expect_err("two lengths");
    assert_eq!(&*fault.message.id, "option-error-conflicting-options");
    let many = RemeshOptions {
        target: Some(1e-5),
        ..options
    };
    let fault = s.remesh(&many).expect_err("a billion");
    assert_eq!(&*fault.message.id, "app-too-many-vertices");
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

fn flowing(remesh: Remeshing) -> FlowOptions {
    FlowOptions {
        flow: FlowName::PWillmore,
        keep: vec![Kept::Area],
        max_steps: Some(400),
        remesh,
        ..FlowOptions::default()
    }
}

/// An elongated ellipsoid, whose mesh wears as it becomes round.
fn worn(remesh: Remeshing) -> Session {
    let values = [("a", 4.0), ("level", 3.0), ("jitter", 0.2)];
    let mut s = opened("ellipsoid", &values);
    s.configure(flowing(remesh)).expect("a flow");
    s
}

fn exact(s: &mut Session) -> (usize, Vec<u64>) {
    let frame = s.frame().expect("a frame");
    let bits = frame.exact.iter().map(|x| x.to_bits()).collect();
    (frame.state.step, bits)
}

fn steps(s: &mut Session, count: usize) -> Vec<StepReport> {
    let step = |_| s.step().expect("a step");
    (0..count).map_while(step).collect()
}

#[test]
fn a_flow_remeshes_between_steps_and_comes_to_rest_at_the_sphere() {
    let mut s = worn(Remeshing::Adaptive);
    let reports = steps(&mut s, 400);
    let passes = reports.iter().filter(|report| report.pass.is_some());
    assert!(passes.count() > 0);
    for report in &reports {
        assert_eq!(report.remesh_milliseconds > 0.0, report.pass.is_some());
    }
    // The functional falls within each segment, and over them all.
    for report in &reports {
        assert!(report.objective <= report.objective_before * (1.0 + 1e-12));
    }
    let ends: Vec<f64> = reports
        .windows(2)
        .filter(|pair| pair[1].pass.is_some())
        .map(|pair| pair[0].objective)
        .chain(reports.last().map(|report| report.objective))
        .collect();
    for pair in ends.windows(2) {
        assert!(pair[1] < pair[0] * 1.001, "{ends:?}");
    }
    let state = s.state().expect("a state");
    let energy = state.energy / (4.0 * PI);
    assert!((0.985..1.002).contains(&energy), "{energy}");
    assert!(
        state.min_angle_degrees > 25.0,
        "{}",
        state.min_angle_degrees
    );
    // Area is kept across passes as within a segment.
    let [first, last] = [&reports[0], &reports[reports.len() - 1]];
    assert!((last.area / first.area - 1.0).abs() < 1e-10);
    // The page gets the triangles that it does not know.
    let frame = s.frame().expect("a frame");
    assert_eq!(frame.panes.len(), 1);
    assert_eq!(frame.panes[0].positions.len(), frame.positions.len());
    let most = frame.panes[0].triangles.iter().max().expect("triangles");
    assert_eq!(3 * (*most as usize + 1), frame.positions.len());
}

#[test]
fn at_rest_on_needles_that_no_pass_betters_a_run_is_over() {
    // A rod as CAD programs write it: nothing but its edges, joined by needles.
    let n = 31;
    let mut text = String::new();
    for end in [0, 20] {
        for i in 0..n {
            let (sin, cos) = (2.0 * PI * f64::from(i) / f64::from(n)).sin_cos();
            text += &format!("v {cos} {sin} {end}\n");
        }
    }
    for i in 1..=n {
        let (j, k) = (i % n + 1, i + n);
        text += &format!("f {i} {j} {k}\nf {j} {} {k}\n", j + n);
        if (2..n).contains(&i) {
            text += &format!("f 1 {} {i}\nf {} {k} {}\n", i + 1, 1 + n, k + 1);
        }
    }
    let mut s = Session::new();
    s.load(text.as_bytes(), "rod.obj").expect("a rod");
    s.configure(FlowOptions {
        flow: FlowName::PWillmore,
        ..FlowOptions::default()
    })
    .expect("configured");
    let taken = s.run(2000).expect("steps");
    let state = s.state().expect("a state");
    assert!(state.status.is_final() && taken < 500, "{taken}: {state:?}");
    // Going back, and doing it again, it is over in the same step.
    let end = exact(&mut s);
    s.back().expect("a step back");
    s.run(2000).expect("steps");
    assert!(exact(&mut s) == end);
}

#[test]
fn going_back_over_a_pass_and_doing_it_again_is_exact() {
    let mut s = worn(Remeshing::Adaptive);
    let mut seen = vec![exact(&mut s)];
    let mut first_pass = None;
    while first_pass.is_none() || seen.len() < 40 {
        let report = s.step().expect("a step").expect("not at rest");
        first_pass = first_pass.or(report.pass.map(|_| report.step));
        seen.push(exact(&mut s));
    }
    let step = first_pass.expect("a pass");
    // What is stored: every step as it was, on its own mesh.
    for back in [step + 1, step, step - 1, step, 0, seen.len() - 1] {
        s.seek(back).expect("stored");
        assert!(exact(&mut s) == seen[back], "step {back}");
        let frame = s.frame().expect("a frame");
        assert_eq!(frame.panes.len(), usize::from(back >= step));
    }
    // From each the next is told, over the pass as elsewhere.
    s.seek(0).expect("stored");
    for at in 0..seen.len() {
        let timeline = s.timeline().expect("a timeline");
        assert_eq!(timeline.at, at);
        assert_eq!(timeline.next, (at + 1 < seen.len()).then_some(at + 1));
        s.seek(at + 1).expect("stored");
    }
    // Done again from before the pass.
    s.seek(step - 1).expect("stored");
    let again = s.step().expect("a step").expect("a report");
    assert_eq!(again.pass.map(|pass| pass.after_step), Some(step - 1));
    s.step().expect("a step");
    let end = exact(&mut s);
    let origin = Origin::Shape {
        shape: "ellipsoid".into(),
        parameters: [("a", 4.0), ("level", 3.0), ("jitter", 0.2)]
            .map(|(n, v)| (n.to_owned(), v))
            .into(),
    };
    let text = s.write_recipe(Some(&origin)).expect("a recipe");
    let card = s.read_recipe(&text).expect("a card");
    let mut other = Session::new();
    let script = ScriptText::Recipe(text);
    other.prepare(&script, None).expect("begun");
    while !other.advance().expect("a mesh").is_done {}
    other.configure(card.flow).expect("a flow");
    other.follow(&script).expect("begun");
    while !other.advance().expect("a step").is_done {}
    assert!(exact(&mut other) == end);
}

#[test]
fn without_passes_the_mesh_stays_and_with_them_an_edit_takes_it_over() {
    let mut s = worn(Remeshing::Off);
    let n = s.info().expect("a mesh").vertices;
    assert!(steps(&mut s, 60).iter().all(|report| report.pass.is_none()));
    assert_eq!(s.info().expect("a mesh").vertices, n);
    let mut s = worn(Remeshing::Isotropic);
    let passes = steps(&mut s, 60);
    assert!(passes.iter().any(|report| report.pass.is_some()));
    let there = s.info().expect("a mesh");
    let (_, before) = exact(&mut s);
    s.adopt().expect("kept");
    assert_eq!(s.info().expect("a mesh").edges, there.edges);
    s.undo_edit().expect("undone");
    assert!(exact(&mut s).1 == before);
    s.step().expect("a step");
    // And another flow goes on from there.
    let options = FlowOptions {
        flow: FlowName::MeanCurvature,
        ..FlowOptions::default()
    };
    s.continue_with(options).expect("a flow");
    let report = s.step().expect("a step").expect("a report");
    assert!(report.area < there.area);
}

#[test]
fn a_new_session_goes_on_from_a_remeshed_surface_and_back_to_the_mesh_itself() {
    let mut lost = worn(Remeshing::Adaptive);
    let start = lost.frame().expect("a frame");
    assert_eq!(start.triangles, None, "the page has those that were loaded");
    let pass = steps(&mut lost, 60).iter().rposition(|r| r.pass.is_some());
    assert!(pass.is_some());
    let frame = lost.frame().expect("a frame");
    let triangles = frame.triangles.clone().expect("triangles of its own").0;
    assert_eq!(frame.panes[0].triangles, triangles);
    let file = |s: &Session| s.export(Format::Off).expect("a file");
    let (before, there) = (lost.state().expect("a state"), file(&lost));
    let mut s = worn(Remeshing::Adaptive);
    // Those of the start do not fit, nor what is no surface of these vertices.
    let (step, time) = (before.step, before.time);
    let mut turned = triangles.clone();
    turned.swap(0, 1);
    let mut beyond = triangles.clone();
    beyond[0] = u32::MAX;
    for bad in [None, Some(&turned), Some(&beyond)] {
        let bad = bad.map(Vec::as_slice);
        s.restore(&frame.exact, bad, step, time)
            .expect_err("no surface");
        assert!(s.frame().expect("a frame").exact == start.exact);
    }
    let state = s
        .restore(&frame.exact, Some(&triangles), step, time)
        .expect("restored");
    assert_eq!((state.step, state.time), (step, time));
    let same = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-12, "{a} {b}");
    same(state.energy, before.energy);
    same(state.area, before.area);
    assert_eq!(state.min_angle_degrees, before.min_angle_degrees);
    assert!(file(&s) == there, "to the last bit");
    assert_eq!(s.frame().expect("a frame").triangles, frame.triangles);
    // How it came about is not known, and the history begins anew.
    assert_eq!(s.provenance().expect_err("unknown").kind, "NoRecipe");
    assert_eq!(s.timeline().expect("a timeline").start, step);
    let reports = steps(&mut s, 400);
    assert!(
        reports
            .iter()
            .all(|r| (r.area / before.area - 1.0).abs() < 1e-9)
    );
    let energy = s.state().expect("a state").energy / (4.0 * PI);
    assert!((0.985..1.002).contains(&energy), "{energy}");
    // Back to the mesh itself: from the start, and as positions of it.
    s.restore(&start.exact, None, 0, 0.0).expect("restored");
    assert_eq!(s.frame().expect("a frame").triangles, None);
    s.restore(&frame.exact, Some(&triangles), step, time)
        .expect("restored");
    s.reset().expect("the start");
    let frame = s.frame().expect("a frame");
    assert_eq!((frame.triangles, frame.exact), (None, start.exact));
    assert!(s.provenance().is_ok());
}

/// The flow by p = 0 is remeshed on its way to a point, which it is said to be when there is a
/// thousandth of the area that there was at the very first.
#[test]
fn a_surface_vanishes_by_the_area_that_it_had_before_all_remeshing() {
    let mut s = opened("ellipsoid", &[("level", 3.0), ("a", 2.5), ("c", 0.4)]);
    s.configure(FlowOptions {
        flow: FlowName::PWillmore,
        p: 0.0,
        ..FlowOptions::default()
    })
    .expect("options");
    let first = s.state().expect("a state").area;
    let mut passes = 0;
    while !s.state().expect("a state").status.is_final() {
        let report = s.step().expect("a step");
        passes += usize::from(report.is_some_and(|report| report.pass.is_some()));
    }
    let end = s.state().expect("a state");
    assert_eq!(end.status, Status::Singular);
    assert!(passes > 0, "no remeshing");
    let left = end.area / first;
    assert!((1e-5..1e-3).contains(&left), "{left} of the area is left");
}
