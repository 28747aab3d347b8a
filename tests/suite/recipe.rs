//! Recipes and links made of runs and done again: the same surface to the last bit.

use crate::support::session::{flowing, shown};
use serde_json::{Value as Json, json};
use std::ops::ControlFlow;
use umbilic::app::{
    Arrangement, Check, Compare, Comparison, Edit, FillOptions, FlipOptions, Lack, LinkView,
    Lockstep, Loops, Origin, PageScene, PaneChange, RegulariseOptions, RemeshOptions, RunCommand,
    ScriptText, Session, SubdivideOptions, WrittenLink,
};
use umbilic::flow::option::{Value, Values};
use umbilic::flow::options::{FlowOptions, Integrator, Scheme};
use umbilic::flow::spec::FLOWS;
use umbilic::flow::spec::FlowName;
use umbilic::io::Format;
use umbilic::remesh::Mode;
use umbilic::remesh::flips::reduction::Criterion;

fn shape(name: &str, parameters: &[(&str, f64)]) -> Origin {
    Origin::Shape {
        shape: name.into(),
        parameters: parameters
            .iter()
            .map(|(name, x)| ((*name).into(), *x))
            .collect(),
    }
}

fn sample(id: &str) -> Origin {
    Origin::Sample { id: id.into() }
}

fn file(name: &str) -> Origin {
    Origin::File {
        name: name.into(),
        file: None,
        sha256: None,
        bytes: None,
    }
}

/// Does what was begun, to its end; answers the shares on the way.
fn finished(session: &mut Session) -> Result<Vec<f64>, String> {
    let mut shares = Vec::new();
    loop {
        let progress = session
            .advance()
            .map_err(|fault| fault.message.to_string())?;
        shares.push(progress.share);
        if progress.is_done {
            return Ok(shares);
        }
    }
}

/// A session that has done what a recipe says.
fn replayed(text: &str, bytes: Option<&[u8]>) -> Session {
    let mut session = Session::new();
    let script = ScriptText::Recipe(text.into());
    let card = session.read_recipe(text).expect("a recipe");
    let bytes = bytes.map(|bytes| (bytes.to_vec(), "given.obj".into()));
    session.prepare(&script, bytes).expect("begun");
    finished(&mut session).expect("prepared");
    session.configure(card.flow).expect("a flow");
    session.follow(&script).expect("begun");
    finished(&mut session).expect("followed");
    session
}

fn take(session: &mut Session, steps: usize) {
    for _ in 0..steps {
        session.step().expect("a step").expect("there is one");
    }
}

fn bumps(options: FlowOptions) -> Session {
    let mut session = Session::new();
    session
        .sample("bumpy-sphere", &[("level".into(), 2.0)])
        .expect("a shape");
    session.configure(options).expect("a flow");
    session
}

fn parsed(text: &str) -> Json {
    serde_json::from_str(text).expect("JSON")
}

#[test]
fn a_plain_run_is_reproduced_to_the_last_bit() {
    for row in FLOWS {
        let mut session = bumps(flowing(row.id));
        session.run(3).expect("steps");
        let origin = shape("bumpy-sphere", &[("level", 2.0)]);
        let text = session.write_recipe(Some(&origin)).expect("a recipe");
        let keys: Vec<String> = (parsed(&text).as_object().expect("an object").keys())
            .cloned()
            .collect();
        assert_eq!(keys, ["flow", "mesh", "result", "steps", "umbilic"]);
        let again = replayed(&text, None);
        let report = again.compare_recipe(&text).expect("a report");
        assert!(report.same && report.exact, "{:?}: {report:?}", row.id);
        assert_eq!(again.write_recipe(Some(&origin)), Ok(text));
    }
}

#[test]
fn edits_regularisations_flips_and_looks_back_are_done_again() {
    let mut source = Session::new();
    source
        .sample("torus", &[("around".into(), 24.0), ("tube".into(), 12.0)])
        .expect("a torus");
    let bytes = source.export(Format::Obj).expect("OBJ");
    let mut session = Session::new();
    session.load(&bytes, "torus.obj").expect("a torus");
    let options = FlowOptions {
        regularise: Mode::Off,
        ..flowing(FlowName::PWillmore)
    };
    session.configure(options).expect("a flow");
    take(&mut session, 3);
    session.seek(1).expect("a step");
    let settings = RegulariseOptions {
        epsilon: 0.02,
        ..RegulariseOptions::default()
    };
    session.regularise(&settings).expect("regularised");
    take(&mut session, 2);
    session.adopt().expect("kept");
    let options = FlowOptions {
        criterion: Criterion::Area,
        ..flowing(FlowName::Flips)
    };
    session.configure(options).expect("flips");
    let arrangement = Arrangement {
        compare: Compare::Criteria,
        flips_per_step: Some(3),
        ..Arrangement::default()
    };
    session.arrange(arrangement).expect("arranged");
    while session.step().expect("a step").is_some() {}
    session.seek(6).expect("a step");
    session.adopt().expect("kept");
    let options = FlowOptions {
        integrator: Integrator::Lbfgs,
        fixed: Some(vec![0, 1, 2]),
        ..flowing(FlowName::Circle)
    };
    session.configure(options).expect("a flow");
    take(&mut session, 6);
    session.seek(3).expect("a step");
    take(&mut session, 2);
    let origin = |sha256: &str| Origin::File {
        name: "torus".into(),
        file: Some("torus.obj".into()),
        sha256: Some(sha256.into()),
        bytes: Some(bytes.len()),
    };
    let other = session
        .write_recipe(Some(&origin(&"0".repeat(64))))
        .expect("a recipe");
    let path = json!([{"steps": 3}, "anew", {"steps": 2}]);
    assert_eq!(parsed(&other)["path"], path);
    let mut before = Session::new();
    let prepare = |session: &mut Session, text: &str, bytes| {
        session
            .prepare(&ScriptText::Recipe(text.into()), bytes)
            .expect("begun");
        finished(session)
    };
    let given = || Some((bytes.clone(), "x.obj".to_owned()));
    let refused = prepare(&mut before, &other, given()).expect_err("another file");
    assert!(
        refused.starts_with("recipe-another-mesh name=torus.obj"),
        "{refused}"
    );
    let digest = &refused[refused.find("found=").expect("digits") + 6..][..12];
    let missing = prepare(&mut before, &other, None).expect_err("no file");
    assert_eq!(missing, "recipe-mesh-missing name=torus.obj");
    assert!(before.loaded().is_err(), "nothing was changed");
    // Its digest, known by its first digits, is that of the file.
    let whole = sha256_of(&bytes);
    assert!(whole.starts_with(digest));
    let text = session
        .write_recipe(Some(&origin(&whole)))
        .expect("a recipe");
    let again = replayed(&text, Some(&bytes));
    assert!(again.compare_recipe(&text).expect("a report").same);
    assert!(shown(&again) == shown(&session));
    let edits = again.provenance().expect("known").edits;
    assert_eq!(edits, session.provenance().expect("known").edits);
}

fn sha256_of(bytes: &[u8]) -> String {
    use sha2::{Digest, Sha256};
    let digest = Sha256::digest(bytes);
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[test]
fn a_fill_and_the_flow_that_fairs_it_are_done_again() {
    let mut session = Session::new();
    session
        .sample("tubes", &[("count".into(), 2.0)])
        .expect("tubes");
    let options = FillOptions {
        loops: Loops::Some(vec![0, 2]),
        connect: true,
        max_vertices: None,
    };
    let mut go_on = |_: &str, _: f64| ControlFlow::Continue(());
    session.fill(&options, &mut go_on).expect("filled");
    session.configure(flowing(FlowName::Mmcv)).expect("a flow");
    take(&mut session, 2);
    let origin = shape("tubes", &[("count", 2.0)]);
    let text = session.write_recipe(Some(&origin)).expect("a recipe");
    let recipe = parsed(&text);
    let fill = json!({"fill": {"loops": [0, 2], "connect": true, "maxVertices": null}});
    assert_eq!(recipe["edits"][0]["edit"], fill);
    assert_eq!(
        recipe["flow"]["free"],
        Json::Null,
        "the new vertices, which are known"
    );
    assert!(
        replayed(&text, None)
            .compare_recipe(&text)
            .expect("a report")
            .same
    );
}

/// Edits of every kind, and a run that looked back and went on with other flows.
fn edited() -> Session {
    let mut session = Session::new();
    session
        .sample("tubes", &[("count".into(), 2.0)])
        .expect("tubes");
    let options = FillOptions {
        loops: Loops::Some(vec![0, 2]),
        connect: true,
        max_vertices: None,
    };
    let mut go_on = |_: &str, _: f64| ControlFlow::Continue(());
    session.fill(&options, &mut go_on).expect("filled");
    session.configure(flowing(FlowName::Mmcv)).expect("a flow");
    take(&mut session, 1);
    session.adopt().expect("kept");
    session
        .subdivide(SubdivideOptions::default())
        .expect("finer");
    session.invert([3.1, 0.2, -1.0 / 3.0]).expect("inverted");
    let options = FlowOptions {
        epsilon: 0.03,
        free: Some(vec![5, 6, 7, 40, 41]),
        ..flowing(FlowName::Circle)
    };
    session.configure(options).expect("a flow");
    take(&mut session, 2);
    session.adopt().expect("kept");
    let options = FlowOptions {
        criterion: Criterion::Willmore,
        ..flowing(FlowName::Flips)
    };
    session.configure(options).expect("flips");
    take(&mut session, 2);
    session.adopt().expect("kept");
    session
        .flip(&FlipOptions {
            max: Some(1),
            ..FlipOptions::default()
        })
        .expect("flipped");
    session
        .remesh(&RemeshOptions {
            vertices: Some(300),
            ..RemeshOptions::default()
        })
        .expect("remeshed");
    session
        .configure(flowing(FlowName::Circle))
        .expect("a flow");
    take(&mut session, 3);
    session.seek(1).expect("a step");
    take(&mut session, 1);
    let options = FlowOptions {
        scheme: Scheme::Paper,
        tau: Some(1e-5),
        ..flowing(FlowName::Circle)
    };
    session.continue_with(options).expect("a flow");
    take(&mut session, 1);
    session
}

fn scene(source: Origin, origin: Origin) -> PageScene {
    PageScene {
        source,
        origin: Some(origin),
        figure: None,
        comparison: None,
        view: LinkView::default(),
        camera: None,
        goal: None,
        shared: false,
    }
}

fn configure(session: &mut Session, values: Values) {
    session
        .perform(RunCommand::Configure { options: values })
        .expect("a flow");
}

#[test]
fn edits_of_every_kind_go_through_a_link_and_a_recipe() {
    let session = edited();
    let written = session
        .write_link(&scene(file("tubes"), sample("two-tubes")))
        .expect("a link");
    assert_eq!(written.lacks, []);
    let read = session.read_link(&written.text, true).expect("a scene");
    assert!(read.edited && read.has_path);
    assert_eq!((read.step, read.estimate.steps), (3, 8));

    let mut again = Session::new();
    let script = ScriptText::Link(written.text.clone());
    again.prepare(&script, None).expect("begun");
    finished(&mut again).expect("prepared");
    configure(&mut again, read.options.clone());
    again.frame().expect("a frame");
    again.follow(&script).expect("begun");
    let shares = finished(&mut again).expect("followed");
    assert!(shares.is_sorted() && shares.len() >= 5, "{shares:?}");
    assert!(shown(&again) == shown(&session));
    assert_eq!(again.provenance(), session.provenance());
    let there = scene(file("tubes"), sample("two-tubes"));
    assert_eq!(again.write_link(&there), Ok(written));
    let check = again.check_link(&read.check.expect("an energy"), 3);
    assert_eq!(check.expect("a mesh").expect("there").outcome, Check::Same);

    // The next frame has the flow that was changed on the way, and all steps.
    let frame = again.frame().expect("a frame");
    let scheme = frame.flow.expect("another flow").options.scheme;
    assert_eq!(scheme, Scheme::Paper);
    let steps: Vec<usize> = frame.reports.iter().map(|report| report.step).collect();
    assert_eq!(steps, [1, 2, 3]);

    let origin = shape("tubes", &[("count", 2.0)]);
    let text = session.write_recipe(Some(&origin)).expect("a recipe");
    let report = replayed(&text, None)
        .compare_recipe(&text)
        .expect("a report");
    assert!(report.same && report.exact, "{report:?}");
}

#[test]
fn a_link_says_no_more_than_it_must() {
    let mut session = bumps(flowing(FlowName::Circle));
    let plain = scene(sample("bumpy-sphere"), sample("bumpy-sphere"));
    let write = |session: &Session, scene: &PageScene| {
        let WrittenLink { text, lacks } = session.write_link(scene).expect("a link");
        assert_eq!(lacks, []);
        text
    };
    // Nothing to check at the start, unless it is sent.
    assert_eq!(write(&session, &plain), "sample=bumpy-sphere&flow=circle");
    let shared = PageScene {
        shared: true,
        ..plain.clone()
    };
    assert!(write(&session, &shared).contains("&version=0.1.0&check="));
    take(&mut session, 4);
    let here = write(&session, &plain);
    assert!(here.contains("&step=4&version=0.1.0&check="), "{here}");
    // Nor on the way to a step.
    let goal = PageScene {
        goal: Some(9),
        ..shared
    };
    assert_eq!(
        write(&session, &goal),
        "sample=bumpy-sphere&flow=circle&step=9"
    );
    // Of a path, the steps that are left come at its end.
    session.seek(2).expect("a step");
    take(&mut session, 1);
    let text = write(&session, &goal);
    let mut again = bumps(flowing(FlowName::Circle));
    again.follow(&ScriptText::Link(text)).expect("begun");
    finished(&mut again).expect("followed");
    take(&mut session, 6);
    assert!(shown(&again) == shown(&session));

    // A figure of the sample, flows beside it, how it is drawn.
    let whole = PageScene {
        figure: Some("circle-6".into()),
        comparison: Some(Comparison {
            panes: vec![
                PaneChange {
                    change: Values::from([("epsilon".into(), Value::Number(0.02))]),
                    step: Some(7),
                },
                PaneChange {
                    change: Values::new(),
                    step: Some(9),
                },
            ],
            lockstep: Lockstep::Time,
            shown: Some(1),
            difference: Some(0),
        }),
        camera: Some(vec![0.578_125, -2.031_25, 1e-7, 123_456.0].into()),
        ..scene(sample("icosahedron"), sample("icosahedron"))
    };
    let text = write(&session, &whole);
    let panes = "&panes=epsilon_0.02_step_7*same&lockstep=time&shown=B&difference=A";
    assert!(
        text.starts_with("sample=icosahedron&figure=circle-6&flow=circle"),
        "{text}"
    );
    assert!(text.contains(panes), "{text}");
    // As `toPrecision(5)` rounds.
    assert!(
        text.contains("&camera=0.57813,-2.0313,1e-7,123460&"),
        "{text}"
    );
    let elsewhere = PageScene {
        figure: Some("circle-9".into()),
        ..whole
    };
    assert!(!write(&session, &elsewhere).contains("figure"));
}

#[test]
fn a_link_carries_what_stands_beside_the_surface_where_that_means_something() {
    let arrangement = Arrangement {
        compare: Compare::Criteria,
        subdivide: 2,
        flips_per_step: None,
    };
    let own = scene(sample("sampled-torus"), sample("sampled-torus"));
    let mut session = bumps(flowing(FlowName::Circle));
    session.arrange(arrangement).expect("arranged");
    let text = |session: &Session| session.write_link(&own).expect("a link").text;
    // Of the sample's own options only the flow is said; the arrangement is one of flips.
    let plain = "sample=sampled-torus&flow=";
    assert_eq!(text(&session), format!("{plain}circle"));
    session.configure(flowing(FlowName::Flips)).expect("flips");
    let words = "&compare=criteria&subdivide=2&flipsPerStep=all";
    assert_eq!(text(&session), format!("{plain}flips{words}"));
    let read = session.read_link(&text(&session), true).expect("a scene");
    session
        .perform(RunCommand::Arrange {
            arrangement: read.arrangement,
        })
        .expect("arranged");
    assert_eq!(text(&session), format!("{plain}flips{words}"));
    session
        .configure(flowing(FlowName::SurfaceDiffusion))
        .expect("a flow");
    assert_eq!(text(&session), format!("{plain}surface-diffusion"));
    session
        .arrange(Arrangement {
            compare: Compare::Flows,
            ..Arrangement::default()
        })
        .expect("arranged");
    let words = "&compare=flows";
    assert_eq!(text(&session), format!("{plain}surface-diffusion{words}"));
}

#[test]
fn panes_are_told_from_the_options_that_the_link_begins_with() {
    let mut session = bumps(FlowOptions {
        epsilon: 0.02,
        ..flowing(FlowName::Circle)
    });
    take(&mut session, 1);
    session
        .continue_with(FlowOptions {
            epsilon: 0.05,
            ..flowing(FlowName::Circle)
        })
        .expect("a flow");
    take(&mut session, 1);
    let own = sample("bumpy-sphere");
    let pane = |change: Values| PaneChange { change, step: None };
    let scheme = Values::from([("scheme".into(), Value::Text("paper".into()))]);
    let scene = PageScene {
        comparison: Some(Comparison {
            panes: vec![pane(scheme), pane(Values::new())],
            ..Comparison::default()
        }),
        ..scene(own.clone(), own)
    };
    let text = session.write_link(&scene).expect("a link").text;
    assert!(text.contains("&epsilon=0.02&"), "{text}");
    let panes = "&panes=scheme_paper_epsilon_0.05*epsilon_0.05&";
    assert!(text.contains(panes), "{text}");
}

#[test]
fn what_a_link_lacks_is_said() {
    let session = bumps(flowing(FlowName::Circle));
    let lacks =
        |session: &Session, scene: PageScene| session.write_link(&scene).expect("a link").lacks;
    let own = |sha256: Option<&str>| Origin::File {
        name: "a".into(),
        file: None,
        sha256: sha256.map(Into::into),
        bytes: None,
    };
    let digest = "ab".repeat(32);
    assert_eq!(lacks(&session, scene(own(None), own(None))), [Lack::File]);
    let known = || own(Some(&digest));
    assert_eq!(
        lacks(&session, scene(known(), known())),
        [Lack::FileByDigest]
    );
    let text = session
        .write_link(&scene(known(), known()))
        .expect("a link")
        .text;
    assert!(
        text.starts_with("mesh=a&hash=abababababababab&flow="),
        "{text}"
    );
    let mut lost = bumps(flowing(FlowName::Circle));
    let exact = lost.frame().expect("a frame").exact;
    lost.restore(&exact, None, 2, 0.1).expect("restored");
    assert_eq!(
        lacks(&lost, scene(own(None), sample("pipe"))),
        [Lack::EditsUnknown]
    );
    // More edits than fit.
    let mut many = bumps(flowing(FlowName::Circle));
    for n in 0..150 {
        let options = FlowOptions {
            epsilon: 0.01 + 1e-6 * f64::from(n),
            ..flowing(FlowName::Circle)
        };
        many.configure(options).expect("a flow");
        many.adopt().expect("kept");
    }
    let written = many
        .write_link(&scene(file("a"), sample("bumpy-sphere")))
        .expect("a link");
    assert_eq!(written.lacks, [Lack::EditsTooLong]);
    assert!(written.text.starts_with("mesh=a&"), "{}", written.text);
}

#[test]
fn what_is_cancelled_or_cannot_be_done_leaves_the_mesh_at_hand() {
    let session = edited();
    let text = session
        .write_recipe(Some(&shape("tubes", &[("count", 2.0)])))
        .expect("a recipe");
    let mut other = bumps(flowing(FlowName::Circle));
    take(&mut other, 2);
    let before = shown(&other);
    other
        .prepare(&ScriptText::Recipe(text.clone()), None)
        .expect("begun");
    for _ in 0..4 {
        assert!(!other.advance().expect("done").is_done);
    }
    other.cancel_replay().expect("given up");
    assert!(shown(&other) == before);
    assert_eq!(other.advance().expect_err("nothing").kind, "NotReplaying");
    let mut wrong = parsed(&text);
    wrong["edits"][2] = json!({"flow": null, "path": [], "edit": {"fill": {"loops": [77]}}});
    other
        .prepare(&ScriptText::Recipe(wrong.to_string()), None)
        .expect("begun");
    assert!(finished(&mut other).is_err());
    assert!(shown(&other) == before);
    assert!(!other.can_undo_edit());
}

#[test]
fn a_flow_that_ends_before_its_last_step_says_so() {
    let mut session = bumps(flowing(FlowName::Flips));
    while session.step().expect("a step").is_some() {}
    let last = session.state().expect("a state").step;
    let origin = shape("bumpy-sphere", &[("level", 2.0)]);
    let mut recipe = parsed(&session.write_recipe(Some(&origin)).expect("a recipe"));
    recipe["steps"] = json!(last + 50);
    let script = ScriptText::Recipe(recipe.to_string());
    session.configure(flowing(FlowName::Flips)).expect("flips");
    session.follow(&script).expect("begun");
    let message = finished(&mut session).expect_err("an end");
    let start = format!("recipe-ends-early step={last} goal={} reason=", last + 50);
    assert!(message.starts_with(&start), "{message}");
    assert_eq!(session.state().expect("a state").step, last);
}

#[test]
fn changes_of_the_flow_are_bounded_by_the_mesh() {
    let mut session = Session::new();
    session
        .sample("ellipsoid", &[("level".into(), 5.0)])
        .expect("a sphere");
    session
        .configure(flowing(FlowName::Circle))
        .expect("a flow");
    take(&mut session, 1);
    let vertices = session.loaded().expect("a mesh").positions.len() / 3;
    let most = (16 << 20) / vertices;
    let origin = shape("ellipsoid", &[("level", 5.0)]);
    let mut recipe = parsed(&session.write_recipe(Some(&origin)).expect("a recipe"));
    // The same flow again costs nothing here.
    let mut path = vec![json!({"flow": {}}); most + 1];
    path.push(json!({"steps": 1}));
    recipe["path"] = Json::Array(path);
    session
        .follow(&ScriptText::Recipe(recipe.to_string()))
        .expect("begun");
    let message = finished(&mut session).expect_err("too many");
    let said = format!(
        "recipe-too-many-flows count={} vertices={vertices}",
        most + 1
    );
    assert!(message.starts_with(&said), "{message}");
}

#[test]
fn a_recipe_needs_a_known_beginning_and_a_flow() {
    let mut session = Session::new();
    session.sample("icosphere", &[]).expect("a sphere");
    let origin = shape("icosphere", &[]);
    let kind = |result: Result<String, umbilic::app::Fault>| result.expect_err("none").kind;
    assert_eq!(kind(session.write_recipe(Some(&origin))), "NoRecipe");
    session
        .configure(flowing(FlowName::Circle))
        .expect("a flow");
    assert!(session.write_recipe(Some(&origin)).is_ok());
    assert_eq!(kind(session.write_recipe(None)), "NoRecipe");
    assert_eq!(kind(session.write_recipe(Some(&file("a")))), "NoRecipe");
    let text = session
        .write_recipe(Some(&sample("icosahedron")))
        .expect("a recipe");
    assert_eq!(parsed(&text)["mesh"]["sample"], "icosahedron");
    let card = session.read_recipe(&text).expect("a card");
    assert!(card.plain);
    assert_eq!(card.origin, sample("icosahedron"));
    // A sample that is another by now is a shape like any other.
    let changed = text.replace("\"sample\": \"icosahedron\"", "\"sample\": \"pipe\"");
    let card = session.read_recipe(&changed).expect("a card");
    assert!(matches!(card.origin, Origin::Shape { .. }) && !card.plain);
}

#[test]
fn a_link_is_checked_only_where_it_was_reached() {
    let mut session = bumps(flowing(FlowName::Circle));
    take(&mut session, 2);
    let check = |session: &Session, sent: &str, step| {
        let check = session.check_link(sent, step).expect("a mesh");
        check.map(|check| check.outcome)
    };
    let energy = session.state().expect("a state").energy.to_string();
    assert_eq!(check(&session, &energy, 2), Some(Check::Same));
    assert_eq!(check(&session, "13.0000000", 2), Some(Check::Off));
    // Paused by the user on the way, or played on.
    assert_eq!(check(&session, &energy, 3), None);
    assert_eq!(check(&session, &energy, 1), None);
    let mut flips = bumps(flowing(FlowName::Flips));
    while flips.step().expect("a step").is_some() {}
    assert_eq!(check(&flips, &energy, 1_000_000), Some(Check::EndsEarly));
}

#[test]
fn an_edit_of_a_recipe_is_read_as_it_is_written() {
    for edit in [
        Edit::Adopt,
        Edit::Fill(FillOptions {
            loops: Loops::Word("all".into()),
            ..FillOptions::default()
        }),
        Edit::Flip(FlipOptions::default()),
        Edit::Subdivide(SubdivideOptions::default()),
        Edit::Remesh(RemeshOptions::default()),
        Edit::Invert([1.0, 0.5, -2.0]),
    ] {
        let written = serde_json::to_value(&edit).expect("JSON");
        assert_eq!(
            serde_json::from_value::<Edit>(written.clone()).map_err(|e| e.to_string()),
            Ok(edit),
            "{written}"
        );
    }
}
