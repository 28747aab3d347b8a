use super::file::Recipe;
use super::*;
use crate::flow::options::Remeshing;
use serde_json::{Value as Json, json};

const PLAIN: &str = include_str!("../../../tests/golden/recipes/plain.json");

#[test]
fn recipes_are_written_as_they_were_read() {
    for text in [
        PLAIN,
        include_str!("../../../tests/golden/recipes/edited.json"),
        include_str!("../../../tests/golden/recipes/file.json"),
    ] {
        let recipe = Recipe::read(text).expect("a recipe");
        assert_eq!(recipe.write(), text);
    }
}

/// The refusal of a recipe that is `change` in place of what `PLAIN` has.
fn refused(change: &Json) -> Fault {
    let mut recipe: Json = serde_json::from_str(PLAIN).expect("JSON");
    for (key, value) in change.as_object().expect("an object") {
        recipe[key] = value.clone();
    }
    Recipe::read(&recipe.to_string())
        .expect_err(&change.to_string())
        .into()
}

#[test]
fn a_bad_value_is_refused_by_its_place() {
    let flow: Json = serde_json::from_str::<Json>(PLAIN).expect("JSON")["flow"].clone();
    let with = |name: &str, value: Json| {
        let mut flow = flow.clone();
        flow[name] = value;
        json!({ "flow": flow })
    };
    let record = |edit: Json| json!({"edits": [{"flow": null, "path": [], "edit": edit}]});
    for (change, kind, said) in [
        (
            json!({"umbilic": null}),
            "BadRecipe",
            "recipe-malformed key=umbilic must=(must-be-version",
        ),
        (
            json!({"steps": -1}),
            "BadRecipe",
            "recipe-malformed key=steps must=(must-be-count",
        ),
        (
            json!({"steps": 1.5}),
            "BadRecipe",
            "recipe-malformed key=steps must=(must-be-count",
        ),
        (
            json!({"steps": 1e12}),
            "BadRecipe",
            "must=(must-be-count most=1000000000)",
        ),
        (
            with("flo", json!(1)),
            "UnknownOption",
            "option-error-unknown-option name=flo ",
        ),
        (
            with("epsilon", json!("small")),
            "BadOption",
            "option-error-bad-option name=epsilon value=small ",
        ),
        (
            with("maxSeconds", json!(0)),
            "BadOption",
            "option-error-bad-option name=maxSeconds value=0 ",
        ),
        (
            json!({"flow": []}),
            "BadRecipe",
            "recipe-malformed key=flow must=(must-be-options",
        ),
        (
            json!({"path": [{"flow": {"perturbation": 0.5}}, {"steps": 3}]}),
            "BadOption",
            "option-error-bad-option name=perturbation ",
        ),
        (
            json!({"path": [{"steps": 2}]}),
            "BadRecipe",
            "recipe-malformed key=path must=(must-be-steps total=3",
        ),
        (
            json!({"path": [{"steps": 3, "more": 1}]}),
            "BadRecipe",
            "recipe-malformed key=path[0] must=(must-be-action",
        ),
        (
            json!({"path": [{"steps": -3}]}),
            "BadRecipe",
            "recipe-malformed key=path[0] must=(must-be-",
        ),
        (
            json!({"path": [{"regularise": {"epsilonn": 1}}]}),
            "BadRecipe",
            "recipe-malformed key=path[0].regularise must=(must-be-regularisation",
        ),
        (
            json!({"path": [{"regularise": {"iterations": 1e9 as u64}}]}),
            "BadRecipe",
            "recipe-malformed key=path[0].regularise ",
        ),
        (
            json!({"arrangement": {"subdivide": 9}}),
            "BadOption",
            "option-error-bad-option name=subdivide value=9 ",
        ),
        (
            json!({"arrangement": {"compare": "all"}}),
            "BadOption",
            "option-error-bad-option name=compare value=all ",
        ),
        (
            json!({"mesh": {"shape": "a", "parameters": {"x": "y"}}}),
            "BadRecipe",
            "recipe-malformed key=mesh.parameters ",
        ),
        (
            json!({"mesh": {"name": "a.obj", "sha256": "12", "bytes": 3}}),
            "BadRecipe",
            "recipe-malformed key=mesh.sha256 ",
        ),
        (
            json!({"edits": {}}),
            "BadRecipe",
            "recipe-malformed key=edits must=(must-be-list",
        ),
        (
            record(json!("bend")),
            "BadRecipe",
            "recipe-malformed key=edits[0].edit ",
        ),
        (
            record(json!({"fill": {"maxVertices": 5_000_000}})),
            "BadRecipe",
            "recipe-malformed key=edits[0].edit ",
        ),
        (
            record(json!({"invert": [1, 2]})),
            "BadRecipe",
            "recipe-malformed key=edits[0].edit ",
        ),
        (
            json!({"edits": [{"path": [], "edit": "adopt"}]}),
            "BadRecipe",
            "recipe-malformed key=edits[0].flow ",
        ),
        (
            json!({"result": {"energy": 1}}),
            "BadRecipe",
            "recipe-malformed key=result.area must=(must-be-number",
        ),
        (
            json!({"result": 7}),
            "BadRecipe",
            "recipe-malformed key=result must=(must-be-object",
        ),
    ] {
        let fault = refused(&change);
        assert_eq!(fault.kind, kind, "{change}: {}", fault.message);
        assert!(
            fault.message.to_string().contains(said),
            "{change}: {}",
            fault.message
        );
    }
}

#[test]
fn what_another_version_wrote_is_refused_with_its_name() {
    let mut flow: Json = serde_json::from_str::<Json>(PLAIN).expect("JSON")["flow"].clone();
    flow["gone"] = json!(1);
    let fault = refused(&json!({"umbilic": "0.0.1", "flow": flow}));
    assert_eq!(fault.kind, "UnknownOption");
    assert!(
        fault.message.to_string().contains("version=0.0.1"),
        "{}",
        fault.message
    );
    // As versions wrote it that had a budget of steps only.
    let older = PLAIN.replace(" \"maxSeconds\": 500000000,\n ", "");
    assert_ne!(older, PLAIN);
    Recipe::read(&older).expect("a recipe");
    // And before there were passes of remeshing.
    let older = PLAIN.replace(" \"remesh\": \"adaptive\",\n ", "");
    assert_ne!(older, PLAIN);
    let older = older.replace("\"flow\": \"circle\"", "\"flow\": \"p-willmore\"");
    let recipe = Recipe::read(&older).expect("a recipe");
    assert_eq!(recipe.flow.remesh, Remeshing::Off);
}

#[test]
fn what_is_no_json_is_refused_by_its_line() {
    let line = 1 + PLAIN[..PLAIN.find("\"steps\"").expect("steps")]
        .matches('\n')
        .count();
    let broken = PLAIN.replace("\"steps\": 3,", "\"steps\": 3;");
    for (text, line) in [(broken.as_str(), line), ("", 1), ("{\n\n\"a\" 1}", 3)] {
        assert_eq!(Recipe::read(text), Err(RecipeError::NotJson { line }));
    }
    // Not even a deep one ends the program.
    let deep = "[".repeat(100_000);
    assert!(matches!(
        Recipe::read(&deep),
        Err(RecipeError::NotJson { .. })
    ));
}

#[test]
fn a_recipe_sets_aside_no_more_than_its_text_asks_for() {
    let long = " ".repeat(17 << 20);
    assert!(matches!(
        Recipe::read(&long),
        Err(RecipeError::TooLong { .. })
    ));
    // A region in a few characters, as links have it, beside the two vertices of the flow.
    let region = json!({"flow": {"free": "rAICAgAg"}});
    let fault = refused(&json!({"path": [region, {"steps": 3}]}));
    assert!(
        fault
            .message
            .to_string()
            .contains("recipe-too-many-selected count=16777218 "),
        "{}",
        fault.message
    );
}

#[test]
fn a_recipe_tells_how_many_steps_it_takes() {
    let session = Session::new();
    let card = session.read_recipe(PLAIN).expect("a card");
    assert_eq!(
        (card.estimate.steps, card.estimate.is_long, card.plain),
        (3, false, false)
    );
    let long = PLAIN.replace("\"steps\": 3,", "\"steps\": 10001,");
    let card = session.read_recipe(&long).expect("a card");
    assert_eq!((card.estimate.steps, card.estimate.is_long), (10_001, true));
    let edited = include_str!("../../../tests/golden/recipes/edited.json");
    let card = session.read_recipe(edited).expect("a card");
    assert_eq!(card.estimate.steps, 1 + 2 + 2 + 3);
}

#[test]
fn a_result_agrees_to_the_last_bit_or_as_near_as_another_version_comes() {
    let recipe = Recipe::read(PLAIN).expect("a recipe");
    let promised = recipe.result.clone();
    let next = ReplayResult {
        energy: f64::from_bits(promised.energy.to_bits() + 1),
        ..promised.clone()
    };
    let same = recipe.compare(promised.clone());
    assert!(same.same && same.exact && same.differing.is_empty());
    assert_eq!(recipe.compare(next.clone()).differing, ["energy"]);
    let positions = Some("0".repeat(64));
    let moved = ReplayResult {
        positions,
        ..promised.clone()
    };
    assert_eq!(recipe.compare(moved.clone()).differing, ["positions"]);
    let older = Recipe::read(&PLAIN.replace("\"0.1.0\"", "\"0.0.1\"")).expect("a recipe");
    assert!(older.compare(next).same && older.compare(moved).same);
    let far = ReplayResult {
        energy: promised.energy * (1.0 + 1e-5),
        volume: None,
        ..promised
    };
    assert_eq!(older.compare(far).differing, ["energy", "volume"]);
}

#[test]
fn digests_are_those_of_the_standard() {
    // The example of FIPS 180-2, appendix B.1.
    let expected = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
    assert_eq!(file::sha256(b"abc"), expected);
}
