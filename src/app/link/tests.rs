use super::*;
use crate::flow::option::Value;
use crate::flow::options::Remeshing;
use serde_json::{Value as Json, json};

const LINKS: &str = include_str!("../../../tests/golden/links.txt");

#[test]
fn links_are_written_as_they_were_read() {
    for line in LINKS.lines() {
        let text = line.strip_prefix('#').expect("a link");
        let link = Link::read(text, true).unwrap_or_else(|error| panic!("{error}: {text}"));
        let written = link.write();
        assert_eq!(written.text, text);
        assert_eq!(written.lacks, []);
    }
    let holds = |word: &str| LINKS.lines().filter(|line| line.contains(word)).count();
    for word in [
        "edits=", "path=", "panes=", "free=b", "free=r", "camera=", "check=",
    ] {
        assert!(holds(word) > 3, "{word}");
    }
}

fn encoded(value: &Json) -> String {
    base64::encode(value.to_string().as_bytes())
}

fn refused(text: &str) -> Fault {
    Link::read(text, true).expect_err(text).into()
}

#[test]
fn a_word_that_cannot_be_is_refused() {
    let potato = encoded(&json!([{"flow": null, "path": [], "edit": "potato"}]));
    let two = encoded(&json!([{"steps": 2}]));
    let not_a_path = encoded(&json!({"steps": 2}));
    for (words, kind, said) in [
        (
            "camera=Infinity",
            "BadValue",
            "link-bad-word word=camera value=Infinity ",
        ),
        ("camera=1,2,x", "BadValue", "link-bad-word word=camera "),
        ("camera=1e39,2", "BadValue", "link-bad-word word=camera "),
        ("camera=1,NaN", "BadValue", "link-bad-word word=camera "),
        ("camera=3", "BadValue", "link-bad-word word=camera "),
        (
            "colour=pink",
            "BadValue",
            "link-bad-word word=colour value=pink ",
        ),
        ("shading=matt", "BadValue", "link-bad-word word=shading "),
        ("cut=101", "BadValue", "link-bad-word word=cut "),
        ("cut=half", "BadValue", "link-bad-word word=cut "),
        ("scale=cubic", "BadValue", "link-bad-word word=scale "),
        ("wireframe=yes", "BadValue", "link-bad-word word=wireframe "),
        ("border=", "BadValue", "link-bad-word word=border "),
        ("step=-1", "BadValue", "link-bad-word word=step "),
        ("step=12345678", "BadValue", "link-bad-word word=step "),
        (
            "sample=gone",
            "BadValue",
            "link-bad-word word=sample value=gone ",
        ),
        (
            "figure=gone",
            "UnknownFigure",
            "app-unknown-figure name=gone",
        ),
        ("mesh=a&hash=xyz", "BadValue", "link-bad-word word=hash "),
        ("check=NaN", "BadValue", "link-bad-word word=check "),
        ("check=1e999", "BadValue", "link-bad-word word=check "),
        ("check=", "BadValue", "link-bad-word word=check "),
        ("version=<i>", "BadValue", "link-bad-word word=version "),
        (
            "compare=everything",
            "BadOption",
            "option-error-bad-option name=compare value=everything ",
        ),
        (
            "flow=flips&subdivide=9",
            "BadOption",
            "option-error-bad-option name=subdivide ",
        ),
        (
            "epsilon=7",
            "BadOption",
            "option-error-bad-option name=epsilon value=7 ",
        ),
        (
            "epsilonn=0.5",
            "UnknownOption",
            "option-error-unknown-option name=epsilonn ",
        ),
        (
            "free=r%25",
            "BadOption",
            "option-error-bad-option name=free ",
        ),
        (
            "panes=tau_soon",
            "BadOption",
            "option-error-bad-option name=tau value=soon ",
        ),
        ("panes=flow_flips", "BadValue", "link-bad-word word=panes "),
        (
            "flow=flips&panes=same",
            "BadValue",
            "link-bad-word word=panes ",
        ),
        ("panes=tau", "BadValue", "link-bad-word word=panes "),
        (
            "panes=same*same*same*same",
            "BadValue",
            "link-bad-word word=panes ",
        ),
        (
            "panes=same&shown=C",
            "BadValue",
            "link-bad-word word=shown ",
        ),
        (
            "panes=same&lockstep=never",
            "BadValue",
            "link-bad-word word=lockstep ",
        ),
        ("tau=1&tau=2", "BadLink", "link-twice word=tau"),
        ("edits=%25%25", "BadValue", "link-bad-word word=edits "),
        (
            &format!("edits={potato}"),
            "BadRecipe",
            "recipe-malformed key=edits[0].edit ",
        ),
        (
            &format!("edits={}", "A".repeat(7000)),
            "BadValue",
            "link-bad-word word=edits ",
        ),
        (
            &format!("path={two}"),
            "BadValue",
            "link-bad-word word=path ",
        ),
        (
            &format!("step=3&path={two}"),
            "BadValue",
            "link-bad-word word=path ",
        ),
        (
            &format!("step=2&path={not_a_path}"),
            "BadRecipe",
            "recipe-malformed key=path must=(must-be-list",
        ),
    ] {
        let fault = refused(words);
        assert_eq!(fault.kind, kind, "{words}: {}", fault.message);
        assert!(
            fault.message.to_string().contains(said),
            "{words}: {}",
            fault.message
        );
        assert!(fault.hint.id.ends_with(".hint"), "{words}");
    }
    // In a query there may be words of others.
    let link = Link::read("embed&epsilonn=0.5&step=2&lang=de&lang=en", false);
    assert_eq!(link.expect("a link").step, 2);
}

/// Flows of links that were written before there were passes of remeshing, with what they meant.
#[test]
fn a_default_that_moved_is_what_it_was_in_links_of_before() {
    let remesh = |link: &Link| link.options.get("remesh").map(ToString::to_string);
    let read = |text: &str| Link::read(text, true).expect("a link");
    for (text, meant) in [
        ("sample=vesicle&flow=p-willmore", Some("off")),
        ("mesh=bunny&flow=p-willmore&p=4", Some("off")),
        // It says so itself.
        ("sample=morin&flow=p-willmore", Some("adaptive")),
        (
            "sample=vesicle&flow=p-willmore&remesh=isotropic",
            Some("isotropic"),
        ),
        // What this program did not write, and what reads no such option, have the default of now.
        ("sample=vesicle", None),
        ("flow=circle", None),
        // The paper knows no passes, whoever asks for its figure.
        ("figure=p-willmore-6", Some("off")),
    ] {
        let link = read(text);
        assert_eq!(remesh(&link).as_deref(), meant, "{text}");
        let again = read(&link.write().text);
        assert_eq!(again.options, link.options, "{text}");
    }
    let link = read("panes=flow_p-willmore*same");
    let change = &link.comparison.expect("panes").panes[0].change;
    assert_eq!(change["remesh"], Value::Text("off".into()));
    let flow = json!([{"flow": {"flow": "p-willmore"}}, {"steps": 2}]);
    let link = read(&format!("step=2&path={}", encoded(&flow)));
    let path = link.path.clone().expect("a path");
    let Action::Flow(options) = &path[0] else {
        panic!("{path:?}")
    };
    assert_eq!(options.remesh, Remeshing::Off);
    // Said both ways now, so that nothing depends on what is left out.
    for remesh in [Remeshing::Off, Remeshing::Adaptive] {
        let options = FlowOptions {
            remesh,
            ..(**options).clone()
        };
        let path = vec![Action::Flow(Box::new(options)), Action::Steps(2)];
        let path = Some(path);
        let written = Link {
            path,
            ..link.clone()
        }
        .write()
        .text;
        let Some(Action::Flow(found)) = read(&written).path.expect("a path").into_iter().next()
        else {
            panic!("{written}")
        };
        assert_eq!(found.remesh, remesh);
    }
}

#[test]
fn what_is_left_out_has_its_default() {
    let plain = Link::read("", true).expect("a link");
    assert_eq!(plain.sample.as_deref(), Some("icosahedron"));
    assert_eq!((plain.options.len(), plain.step, plain.mesh), (0, 0, None));
    let own = Link::read("mesh=a+b%26&hash=0123456789abcdef0123", true).expect("a link");
    assert_eq!((own.sample, own.mesh.as_deref()), (None, Some("a b&")));
    assert_eq!(own.hash.as_deref(), Some("0123456789abcdef"));
    // A figure alone is a scene of its own; with a sample it is the sample's.
    let figure = Link::read("figure=p-willmore-2-p4&step=3", true).expect("a link");
    assert_eq!(figure.sample.as_deref(), Some("letter-c"));
    assert_eq!(figure.options.get("p"), Some(&Value::Number(4.0)));
    assert_eq!(figure.colour, Some(FieldName::MeanCurvature));
    // Steps count backwards in the half of a film that is shown so, and nowhere else.
    let film = |more: &str| Link::read(&format!("figure=eversion&step=-3{more}"), true);
    assert_eq!(film("").expect("a link").step, -3);
    assert_eq!(film("").expect("a link").scene("").estimate.steps, 3);
    let path = encoded(&json!([{"steps": 3}]));
    for more in ["&sample=pipe".to_owned(), format!("&path={path}")] {
        assert!(film(&more).is_err(), "{more}");
    }
    let changed = Link::read("figure=p-willmore-2-p4&p=3&colour=none", true).expect("a link");
    assert_eq!(changed.options.get("p"), Some(&Value::Number(3.0)));
    assert_eq!(changed.colour, None);
    let sample = Link::read("figure=circle-6&sample=pipe", true).expect("a link");
    assert_eq!(
        (sample.sample.as_deref(), sample.options.len()),
        (Some("pipe"), 0)
    );
}

/// A path whose flow changes so many times to one with these vertices free.
fn changing(times: usize, region: &str) -> String {
    let flow = json!({"flow": {"free": region}});
    format!("path={}", encoded(&Json::Array(vec![flow; times])))
}

#[test]
fn a_short_link_sets_aside_little() {
    // 2²⁴ vertices in eight characters, sixty times.
    let text = changing(60, "rAICAgAg");
    assert!(text.len() < 3000, "{}", text.len());
    let fault = refused(&text);
    assert!(
        fault
            .message
            .to_string()
            .contains("recipe-too-many-selected count=16777216 "),
        "{}",
        fault.message
    );
    // Each is allowed, and all are not: 2¹⁵ vertices.
    let region = "rAICAAg";
    assert_eq!(region::parse(region).expect("a region").count(), 1 << 15);
    assert!(Link::read(&changing(32, region), true).is_ok());
    let fault = refused(&changing(33, region));
    assert!(
        fault
            .message
            .to_string()
            .contains("recipe-too-many-selected count=1081344 "),
        "{}",
        fault.message
    );
    // The link's own regions count too, and those of edits.
    let edits = encoded(&json!([{"flow": {"fixed": region}, "path": [], "edit": "adopt"}]));
    for more in [format!("&free={region}"), format!("&edits={edits}")] {
        assert!(
            refused(&(changing(32, region) + &more))
                .message
                .to_string()
                .contains("1081344")
        );
    }
    assert!(matches!(
        Link::read(&"x".repeat(70_000), true),
        Err(LinkError::TooLong { .. })
    ));
    let deep = base64::encode("[".repeat(4000).as_bytes());
    assert_eq!(refused(&format!("edits={deep}")).kind, "BadValue");
}

#[test]
fn a_link_tells_how_many_steps_it_takes() {
    let estimate = |text: &str| {
        let scene = Session::new().read_link(text, true).expect("a scene");
        (scene.estimate.steps, scene.estimate.is_long)
    };
    assert_eq!(estimate("step=10000"), (10_000, false));
    assert_eq!(estimate("step=10001"), (10_001, true));
    assert_eq!(estimate("step=4000&panes=step_3000*tau_1"), (11_000, true));
    let path = encoded(&json!([{"steps": 5}, "anew", {"steps": 2}]));
    let edits = encoded(&json!([{"flow": {}, "path": [{"steps": 999_999_999}], "edit": "adopt"}]));
    assert_eq!(estimate(&format!("step=7&path={path}")), (7, false));
    let both = format!("step=7&path={path}&edits={edits}");
    assert_eq!(estimate(&both), (1_000_000_006, true));
}

#[test]
fn what_fits_no_link_is_left_out_and_that_is_said() {
    let vertices = (0..60_000).map(|v| Value::Number(f64::from(2 * v)));
    let scattered = Value::List(vertices.collect());
    let link = Link {
        sample: Some("pipe".into()),
        options: Values::from([("free".into(), scattered)]),
        ..Link::default()
    };
    let written = link.write();
    assert_eq!(written.text, "sample=pipe");
    assert_eq!(written.lacks, [Lack::RegionTooLong]);
}
