//! The sphere turned inside out: a film of two halves, and what is measured on it.

use std::f64::consts::PI;
use umbilic::app::library::{Figure, figure};
use umbilic::app::{Check, LinkView, Origin, PageScene, Session, State};
use umbilic::message::Value;

fn eversion() -> &'static Figure {
    figure("eversion").expect("a figure")
}

fn begun() -> Session {
    let mut session = Session::new();
    eversion().begin(&mut session).expect("a surface");
    session
}

fn exact(session: &mut Session) -> (State, Vec<u64>) {
    let frame = session.frame().expect("a frame");
    let bits = frame.exact.iter().map(|x| x.to_bits()).collect();
    (frame.state, bits)
}

/// To the end of a half: its last state, and the volumes and energies of its steps.
fn run(session: &mut Session) -> (State, Vec<(f64, f64)>) {
    let mut readings = Vec::new();
    while session.step().expect("a step").is_some() {
        let state = session.state().expect("a state");
        readings.push((state.volume.expect("closed"), state.energy));
        if state.status.is_final() {
            break;
        }
    }
    (session.state().expect("a state"), readings)
}

/// Kusner's Morin surface, pushed to either side, comes to the round sphere without ever ceasing
/// to be immersed; the two ends have opposite sides out.
#[test]
fn the_figure_comes_out() {
    let finding = eversion().run().expect("a run");
    println!("{:?}", finding.message);
    assert!(finding.ok, "{:?}", finding.message);
    let value = |name: &str| match finding.message.value(name) {
        Some(Value::Number(value)) => *value,
        other => panic!("{name}: {other:?}"),
    };
    for end in ["firstEnergy", "lastEnergy"] {
        assert!((0.985..1.005).contains(&value(end)), "{end}");
    }
    assert!((3.8..4.2).contains(&value("halfway")));
    assert!((value("firstVolume") - 1.0).abs() < 0.01);
    assert!((value("lastVolume") + 1.0).abs() < 0.01);
    assert!(value("crossings") > 300.0);
    assert_eq!([value("firstCrossings"), value("lastCrossings")], [0.0; 2]);
    assert!(value("alignment") > 0.3);
    // A session that shows both halves is judged as a run of the figure, whichever is at hand.
    let mut session = begun();
    let id = "measured-incomplete";
    let judged = |session: &Session| {
        eversion()
            .judged(session)
            .expect("a mesh")
            .expect("a finding")
    };
    assert_eq!(&*judged(&session).message.id, id);
    session.turn("eversion").expect("the half shown backwards");
    run(&mut session);
    assert!(!judged(&session).ok);
    session.turn("eversion").expect("the other half");
    run(&mut session);
    assert_eq!(judged(&session), finding);
    session.turn("eversion").expect("the half shown backwards");
    assert_eq!(judged(&session), finding);
}

/// Energy falls from the halfway surface on both sides, and the volume goes each its own way.
#[test]
fn a_film_has_two_halves_between_which_one_turns() {
    let mut session = begun();
    let (start, _) = exact(&mut session);
    let turned = session.turn("eversion").expect("the other half");
    assert_eq!(turned.step, 0);
    // The same triangles on both sides of the seam, and next to the same surface.
    let [one, other] = [&start, &turned];
    assert!((one.area / other.area - 1.0).abs() < 0.01);
    assert!((one.energy / other.energy - 1.0).abs() < 0.005);
    let jump = one.volume.expect("closed") - other.volume.expect("closed");
    assert!(jump.abs() < 0.3, "{jump}");
    let (end, readings) = run(&mut session);
    let ball = end.area.powf(1.5) / (6.0 * PI.sqrt());
    assert!((end.volume.expect("closed") / ball - 1.0).abs() < 0.01);
    assert_eq!(end.crossings, Some(0));
    let fell = readings.iter().filter(|(volume, _)| *volume > 0.0).count();
    assert!(fell as f64 > 0.9 * readings.len() as f64);
    let there = exact(&mut session);
    // The half that waits is as it was left, and goes on from there.
    let here = session.turn("eversion").expect("the first half");
    assert_eq!((here.step, here.energy), (0, start.energy));
    session.step().expect("a step").expect("a report");
    let stepped = exact(&mut session);
    session.turn("eversion").expect("the other half");
    assert!(exact(&mut session) == there);
    session.seek(end.step / 2).expect("stored");
    session.seek(end.step).expect("stored");
    assert_eq!(exact(&mut session).1, there.1);
    session.turn("eversion").expect("the first half");
    assert!(exact(&mut session) == stepped);
    let mut alone = begun();
    alone.step().expect("a step");
    assert_eq!(exact(&mut alone).1, stepped.1);
}

#[test]
fn another_mesh_or_flow_forgets_the_other_half() {
    let mut session = begun();
    session.turn("eversion").expect("the other half");
    session.step().expect("a step");
    session.turn("eversion").expect("the first half");
    let options = session.options().expect("a mesh").expect("a flow");
    session.configure(options).expect("a flow");
    assert_eq!(session.turn("eversion").expect("made anew").step, 0);
    for id in ["circle-6", "no-such-figure"] {
        let fault = session.turn(id).expect_err("no halves");
        assert_eq!(fault.kind, "UnknownFigure");
    }
}

/// What a link and what comes of it say of the half that is shown backwards.
#[test]
fn a_link_has_a_step_of_either_half() {
    let sample = Origin::Sample {
        id: eversion().sample.into(),
    };
    let scene = PageScene {
        source: sample.clone(),
        origin: Some(sample),
        figure: Some("eversion".into()),
        comparison: None,
        view: LinkView::default(),
        camera: None,
        goal: None,
        shared: true,
    };
    let mut session = begun();
    let stepped = |session: &mut Session| {
        session.turn("eversion").expect("a half");
        for _ in 0..2 {
            session.step().expect("a step").expect("a report");
        }
        let link = session.write_link(&scene).expect("a link");
        session.read_link(&link.text, true).expect("a scene")
    };
    let back = stepped(&mut session);
    let forth = stepped(&mut session);
    assert_eq!([&back, &forth].map(|link| link.step), [-2, 2]);
    let (sent_back, sent_forth) = (back.check.expect("one"), forth.check.expect("one"));
    assert_ne!(sent_back, sent_forth);
    // The other half is at hand: that is no comparison.
    let same = |found: Option<umbilic::app::LinkCheck>| {
        found.map(|found| (found.outcome == Check::Same, found.step))
    };
    let check = |session: &Session, sent: &str, step| {
        same(session.check_link(sent, step).expect("a surface"))
    };
    assert_eq!(check(&session, &sent_forth, 2), Some((true, 2)));
    assert_eq!(check(&session, &sent_back, -2), None);
    session.turn("eversion").expect("the half shown backwards");
    assert_eq!(check(&session, &sent_back, -2), Some((true, -2)));
    assert_eq!(check(&session, &sent_forth, -2), Some((false, -2)));
    // On the way there it says where it goes.
    let goal = PageScene {
        goal: Some(-9),
        ..scene.clone()
    };
    let link = session.write_link(&goal).expect("a link").text;
    assert!(
        link.contains("figure=eversion") && link.contains("step=-9"),
        "{link}"
    );
    // Without its figure nobody could turn.
    let bare = PageScene {
        figure: None,
        ..scene.clone()
    };
    let link = session.write_link(&bare).expect("a link").text;
    assert!(
        !link.contains("step=") && !link.contains("check="),
        "{link}"
    );
}

#[test]
fn an_edit_that_is_undone_leaves_both_halves() {
    let mut session = begun();
    session.step().expect("a step").expect("a report");
    let forth = exact(&mut session);
    session.turn("eversion").expect("the half shown backwards");
    for _ in 0..2 {
        session.step().expect("a step").expect("a report");
    }
    let back = exact(&mut session);
    session.adopt().expect("the start");
    session.undo_edit().expect("undone");
    assert!(exact(&mut session) == back);
    session.turn("eversion").expect("the other half");
    assert!(exact(&mut session) == forth);
    session.turn("eversion").expect("the half shown backwards");
    assert!(exact(&mut session) == back);
}

#[test]
fn crossings_are_read_where_the_start_has_some() {
    let mut session = begun();
    let found = session.self_intersections().expect("a mesh").expect("few");
    let state = session.state().expect("a state");
    assert_eq!(state.crossings, Some(found.pairs.len() / 2));
    session.sample("icosphere", &[]).expect("a sphere");
    session.step().expect("a step");
    assert_eq!(session.state().expect("a state").crossings, None);
}
