//! The tables of flows and options: they say what the flows do, and what JavaScript knows of them
//! is written from them.

use serde_json::{Value as Json, json};
use std::path::Path;
use umbilic::app::{
    Arrangement, BenchOptions, EnergyOptions, FieldName, FillOptions, FlipOptions,
    RegulariseOptions, RemeshOptions, RepairOptions, Session,
};
use umbilic::energy::circle::Boundary;
use umbilic::flow::equation::{MONITORED, STEPS, SYMBOLS, functional};
use umbilic::flow::option::{Kind, Options, Range, Row, Value};
use umbilic::flow::options::FlowOptions;
use umbilic::flow::spec::{FLOWS, Family, FlowName, FlowRow};
use umbilic::io::Format;

#[test]
fn the_tables_in_javascript_are_those_of_the_solver() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/generated");
    for (name, text) in [("schema.js", schema()), ("equation.js", equation())] {
        let path = folder.join(name);
        if std::env::var_os("UPDATE_SCHEMA").is_some() {
            std::fs::create_dir_all(&folder).expect("the folder is made");
            std::fs::write(&path, &text).expect("the table is written");
        }
        let found = std::fs::read_to_string(&path).unwrap_or_default();
        let same = found == text;
        assert!(
            same,
            "{name} is out of date: UPDATE_SCHEMA=1 cargo test --test schema"
        );
    }
}

/// What the page states of a flow: beside the schema, as it is fetched only with its view.
fn equation() -> String {
    let functionals = MONITORED.iter().map(|one| {
        let name = serde_json::to_value(one).expect("JSON");
        (name.as_str().expect("a name").to_owned(), functional(*one))
    });
    let functionals: serde_json::Map<String, Json> =
        functionals.map(|(name, tex)| (name, json!(tex))).collect();
    let steps: serde_json::Map<String, Json> = STEPS
        .iter()
        .map(|(name, tex)| ((*name).to_owned(), json!(tex)))
        .collect();
    let object = |key: &str, kind: &str, name: &str, value: serde_json::Map<String, Json>| {
        let lines: Vec<String> = value
            .iter()
            .map(|(key, value)| format!("  {:?}: {value},", key))
            .collect();
        format!(
            "/** @type {{Readonly<Record<{key}, {kind}>>}} */\nexport const {name} = {{\n{}\n}};\n",
            lines.join("\n")
        )
    };
    let symbols: Vec<Json> = SYMBOLS
        .iter()
        .map(|one| serde_json::to_value(one).expect("JSON"))
        .collect();
    let head = "// The functional, the step and the symbols of each flow. Written from src/flow/equation.rs by
// `UPDATE_SCHEMA=1 cargo test --test schema`.

/** @import { Monitored } from './types.js' */

/**
 * A symbol, and where it matters: where all that is said of it holds.
 * @typedef {{ tex: string, id: string, families: readonly string[], reads: string | null, keeps: string | null, inFormula: boolean, isSet: boolean }} Symbol
 */
";
    [
        head.to_owned(),
        // All that can be monitored, or the type check fails.
        object("Monitored", "readonly string[]", "functionals", functionals),
        object("string", "string", "steps", steps),
        list("readonly Symbol[]", "symbols", &symbols),
    ]
    .join("\n")
}

fn schema() -> String {
    let flows: Vec<Json> = FLOWS.iter().map(flow_json).collect();
    let head = "// Flows, options and file formats as the solver knows them. Written from src/flow/spec.rs,
// src/flow/option/rows.rs, src/app/given.rs, src/app/options.rs and src/io/format.rs by
// `UPDATE_SCHEMA=1 cargo test --test schema`.

/**
 * What an option may be, and what reads it. `absent` is the word for null.
 * @typedef {object} Row
 * @property {string} name
 * @property {string} flag
 * @property {'number' | 'choice' | 'set' | 'switch' | 'numbers' | 'vertices'} kind
 * @property {{ low: number, high: number, lowOpen: boolean, whole: boolean, also: number | null } | null} range
 * @property {readonly string[]} ids
 * @property {any} default
 * @property {string | null} absent
 * @property {string} unit
 * @property {string} group
 * @property {readonly FlowName[]} flows
 * @property {string | null} scheme
 * @property {string | null} goal
 * @property {string | null} remesh
 * @property {boolean} ofOneFlow  a change of flow takes its value back
 */

/**
 * @typedef {object} Flow
 * @property {FlowName} id
 * @property {string} family
 * @property {string} paper
 * @property {number} order
 * @property {number} timePower      dt has the unit length^k with this k …
 * @property {boolean} timePowerAddsP  … and p more
 * @property {string} tau
 * @property {readonly import('./types.js').Monitored[]} monitored
 * @property {string} formula
 * @property {{ open: boolean, quads: boolean, oneSided: boolean }} meshes
 * @property {'clamped' | 'fixed' | 'free' | null} boundary  unless told otherwise
 * @property {Partial<FlowOptions>} sets  options of its family that make it this flow
 */

/**
 * A flag of a command, or of the flow that fairs a fill, and what help says of it: what follows it,
 * where it counts, what it may be, and its words by their id.
 * @typedef {{ name: string, flag: string, value: string | null, isMany: boolean, of: string, notes: string, words: string }} Flag
 */

/** A format of mesh files. @typedef {{ name: string, extensions: readonly string[], isWritten: boolean }} MeshFormat */
";
    let ids: Vec<String> = FlowName::all().map(|f| format!("'{}'", f.id())).collect();
    [
        head.to_owned(),
        format!("/** @typedef {{{}}} FlowName */\n", ids.join(" | ")),
        typedef::<FlowOptions>("FlowOptions"),
        typedef::<Arrangement>("Arrangement"),
        list("readonly Flow[]", "flows", &flows),
        list("readonly Row[]", "options", &rows::<FlowOptions>()),
        list("readonly Row[]", "arrangement", &rows::<Arrangement>()),
        list("readonly MeshFormat[]", "meshFormats", &mesh_formats()),
        "// What a surface can be coloured by.\n".into(),
        list(
            "readonly import('./types.js').FieldName[]",
            "fields",
            &fields(),
        ),
        format!(
            "/** @type {{Record<string, readonly Flag[]>}} */\nexport const flags = {{\n{}}};\n",
            [
                flags("flow", "option", moving()),
                flags("energy", "energy", EnergyOptions::ROWS),
                flags("regularise", "regularise", RegulariseOptions::ROWS),
                flags("repair", "repair", RepairOptions::ROWS),
                flags("fill", "fill", FillOptions::ROWS),
                fairing(),
                flags("remesh", "remesh", RemeshOptions::ROWS),
                flags("flips", "flips", FlipOptions::ROWS),
                flags("bench", "bench", BenchOptions::ROWS),
            ]
            .concat()
        ),
    ]
    .join("\n")
}

fn fields() -> Vec<Json> {
    FieldName::ALL.iter().map(|(_, name)| json!(name)).collect()
}

fn mesh_formats() -> Vec<Json> {
    let json = |format: Format| {
        json!({
            "name": format.name(),
            "extensions": format.extensions(),
            "isWritten": format.is_written(),
        })
    };
    Format::all().map(json).collect()
}

#[test]
fn the_read_me_names_every_format_that_is_read() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md");
    let text = std::fs::read_to_string(&path).expect("the document");
    for ending in Format::endings() {
        assert!(text.contains(&format!("`.{ending}`")), "{ending}");
    }
}

fn list(kind: &str, name: &str, values: &[Json]) -> String {
    let lines: Vec<String> = values.iter().map(|value| format!("  {value},")).collect();
    let lines = lines.join("\n");
    format!("/** @type {{{kind}}} */\nexport const {name} = [\n{lines}\n];\n")
}

fn flow_json(row: &FlowRow) -> Json {
    serde_json::to_value(row).expect("JSON")
}

fn rows<S: Options>() -> Vec<Json> {
    S::ROWS.iter().map(row_json).collect()
}

fn row_json<S: Options>(row: &Row<S>) -> Json {
    let (kind, range, ids) = match row.kind {
        Kind::Number(range) => ("number", Some(range), &[][..]),
        Kind::Choice(ids) => ("choice", None, ids()),
        Kind::Set(ids) => ("set", None, ids()),
        Kind::Switch => ("switch", None, &[][..]),
        Kind::Numbers(range) => ("numbers", Some(range), &[][..]),
        Kind::Vertices => ("vertices", None, &[][..]),
    };
    let number = |x: f64| serde_json::to_value(Value::Number(x)).expect("JSON");
    let range = range.map(|range| {
        json!({
            "low": number(range.low),
            "high": number(range.high),
            "lowOpen": range.low_open,
            "whole": range.whole,
            "also": range.also.map(number),
        })
    });
    let flows: Vec<&str> = row.read_by.flows.iter().map(|flow| flow.id()).collect();
    json!({
        "name": row.name,
        "flag": row.flag,
        "kind": kind,
        "range": range,
        "ids": ids,
        "default": (row.get)(&S::default()),
        "absent": row.absent,
        "unit": row.unit,
        "group": row.group,
        "flows": flows,
        "scheme": row.read_by.scheme,
        "goal": row.read_by.goal,
        "remesh": row.read_by.remesh,
        "ofOneFlow": row.is_of_one_flow,
    })
}

/// The options of flows that move vertices: flips have a command of their own.
fn moving() -> impl Iterator<Item = &'static Row<FlowOptions>> {
    FlowOptions::ROWS.iter().filter(|row| {
        let mut flows = row.read_by.flows.iter();
        flows.any(|flow| *flow != FlowName::Flips)
    })
}

/// The flow that fairs a fill, one that can hold what is around a patch, and how long it may go on.
/// It relaxes, and has no other goal.
fn fairing() -> String {
    let row = |name: &str| moving().find(|row| row.name == name).expect("a row");
    let flows = row("free").read_by.flows.iter().map(|flow| flow.id());
    let value: Vec<&str> = std::iter::once("none").chain(flows).collect();
    let mut all = vec![json!({
        "name": "fair",
        "flag": "fair",
        "value": value.join("|"),
        "isMany": false,
        "of": "",
        "notes": "default none",
        "words": "fill-fair",
    })];
    for name in ["maxSteps", "maxSeconds"] {
        let mut limit = flag("option", row(name));
        limit["of"] = json!("--fair");
        all.push(limit);
    }
    table("fair", all)
}

/// The flags of a command.
fn flags<S: Options>(
    command: &str,
    words: &str,
    rows: impl IntoIterator<Item = &'static Row<S>>,
) -> String {
    table(command, rows.into_iter().map(|row| flag(words, row)))
}

fn table(command: &str, flags: impl IntoIterator<Item = Json>) -> String {
    let lines = flags.into_iter().map(|flag| format!("    {flag},\n"));
    let lines: String = lines.collect();
    format!("  {command}: [\n{lines}  ],\n")
}

fn flag<S: Options>(words: &str, row: &Row<S>) -> Json {
    let absent = row.absent.map(str::to_owned);
    let of = |own: String| [absent.as_slice(), &[own]].concat().join("|");
    let one = |range: Range| match range.whole {
        _ if row.unit == "length" => "LENGTH",
        true => "N",
        false => "VALUE",
    };
    let number = |range: Range| [row.words, &[one(range)]].concat().join("|");
    let value = match row.kind {
        Kind::Number(range) => Some(of(number(range))),
        Kind::Numbers(range) => Some(of([number(range).as_str(), one(range)].join(","))),
        Kind::Choice(ids) => Some(of(ids()
            .iter()
            .copied()
            .filter(|id| row.name != "flow" || *id != FlowName::Flips.id())
            .collect::<Vec<_>>()
            .join("|"))),
        Kind::Set(ids) if ids().len() > 4 => Some(of("ID,ID".into())),
        Kind::Set(ids) => Some(ids().join(",")),
        Kind::Switch => None,
        Kind::Vertices => Some("FILE.json".into()),
    };
    let usual = match (row.get)(&S::default()) {
        _ if matches!(row.kind, Kind::Set(_) | Kind::Numbers(_)) => Json::Null,
        usual => json!(usual),
    };
    let usual = match usual {
        Json::Null => absent.clone(),
        Json::String(word) => Some(word),
        other => Some(other.to_string()),
    };
    let usual = usual.map(|usual| format!("default {usual}"));
    let notes: Vec<String> = match row.kind {
        Kind::Vertices => {
            let usual = usual.unwrap_or_default();
            vec![format!("numbered as in the file, OBJ from 1; {usual}")]
        }
        Kind::Switch if usual.as_deref() == Some("default true") => {
            vec![format!("default; --no-{} for not", row.flag)]
        }
        Kind::Switch => Vec::new(),
        Kind::Number(range) if range.low > -1e4 => {
            usual.into_iter().chain([limits(range)]).collect()
        }
        _ => usual.into_iter().collect(),
    };
    json!({
        "name": row.name,
        "flag": row.flag,
        "value": value,
        "isMany": matches!(row.kind, Kind::Numbers(_)),
        "of": readers(row),
        "notes": notes.join("; "),
        "words": format!("{words}-{}", row.name),
    })
}

fn limits(range: Range) -> String {
    let also = range.also.map_or(String::new(), |x| {
        format!("{} or ", json!(Value::Number(x)))
    });
    let low = json!(Value::Number(range.low));
    let from = if range.low_open { "above" } else { "from" };
    let to = match range.high < 1e4 {
        true => format!(" to {}", json!(Value::Number(range.high))),
        false => String::new(),
    };
    format!("{also}{from} {low}{to}")
}

/// The flows that read an option, or the few that do not, and the other options that it needs.
fn readers<S: Options>(row: &Row<S>) -> String {
    let by = row.read_by;
    let moving = FLOWS
        .iter()
        .filter(|flow| flow.order > 0)
        .map(|flow| flow.id);
    let others: Vec<String> = moving
        .filter(|flow| !by.flows.contains(flow))
        .map(|flow| format!("not {}", flow.id()))
        .collect();
    let mut of = match others.len() < by.flows.len() {
        true => others,
        false => by.flows.iter().map(|flow| flow.id().to_owned()).collect(),
    };
    for (flag, value) in [
        ("scheme", json!(by.scheme)),
        ("goal", json!(by.goal)),
        ("remesh", json!(by.remesh)),
    ] {
        of.extend(value.as_str().map(|value| format!("--{flag} {value}")));
    }
    of.join(", ")
}

fn typedef<S: Options>(name: &str) -> String {
    let property = |row: &Row<S>| {
        let of = |ids: &[&str]| {
            let quoted: Vec<String> = ids.iter().map(|id| format!("'{id}'")).collect();
            quoted.join(" | ")
        };
        let kind = match row.kind {
            Kind::Number(_) => "number".into(),
            Kind::Choice(ids) => of(ids()),
            Kind::Set(ids) => format!("({})[]", of(ids())),
            Kind::Switch => "boolean".into(),
            Kind::Numbers(_) | Kind::Vertices => "number[]".into(),
        };
        let null = if row.absent.is_some() { " | null" } else { "" };
        format!(" * @property {{{kind}{null}}} [{}]", row.name)
    };
    let properties: Vec<String> = S::ROWS.iter().map(property).collect();
    format!(
        "/**\n * @typedef {{object}} {name}\n{}\n */\n",
        properties.join("\n")
    )
}

/// A cap of 10 × 10 squares, scaled, as triangles or as quadrilaterals.
fn cap(scale: f64, quads: bool) -> String {
    const N: usize = 10;
    let mut text = String::new();
    for i in 0..=N {
        for j in 0..=N {
            let [x, y] = [i, j].map(|k| k as f64 / N as f64 - 0.5);
            let z = (1.5 - x * x - y * y).sqrt() + 0.02 * (9.0 * x).sin() * (7.0 * y).cos();
            let [x, y, z] = [x, y, z].map(|c| scale * c);
            text += &format!("v {x} {y} {z}\n");
        }
    }
    for i in 0..N {
        for j in 0..N {
            let [a, b] = [i * (N + 1) + j + 1, (i + 1) * (N + 1) + j + 1];
            let faces = if quads {
                vec![format!("f {a} {b} {} {}", b + 1, a + 1)]
            } else {
                vec![
                    format!("f {a} {b} {}", b + 1),
                    format!("f {a} {} {}", b + 1, a + 1),
                ]
            };
            text += &(faces.join("\n") + "\n");
        }
    }
    text
}

fn options(flow: FlowName) -> FlowOptions {
    FlowOptions {
        flow,
        ..FlowOptions::default()
    }
}

/// Whether a flow takes the mesh; the kind of its refusal otherwise.
fn takes(session: &mut Session, flow: FlowName) -> Result<(), &'static str> {
    session
        .configure(options(flow))
        .map(|_| ())
        .map_err(|fault| fault.kind)
}

#[test]
fn flows_take_the_meshes_that_their_rows_say() {
    let mut open = Session::new();
    open.load(cap(1.0, false).as_bytes(), "cap.obj")
        .expect("a cap");
    let mut quads = Session::new();
    quads
        .load(cap(1.0, true).as_bytes(), "quads.obj")
        .expect("a cap");
    let mut one_sided = Session::new();
    let size = [("along".into(), 24.0), ("around".into(), 12.0)];
    one_sided.sample("klein-bottle", &size).expect("a bottle");
    for row in FLOWS {
        let refusal = |session, taken: bool, kind: &'static str| {
            let expected = if taken { Ok(()) } else { Err(kind) };
            assert_eq!(takes(session, row.id), expected, "{:?}", row.id);
        };
        refusal(&mut open, row.meshes.open, "NotClosed");
        refusal(&mut one_sided, row.meshes.one_sided, "NotOriented");
        // Quadrilaterals are taken as triangles, if not as they are.
        if !row.meshes.quads {
            refusal(&mut quads, true, "");
        }
    }
}

#[test]
fn a_step_size_scales_as_its_unit_says() {
    for row in FLOWS.iter().filter(|row| row.family != Family::Flips) {
        for p in [1.0, 2.0, 4.0] {
            let ratio = |level: f64, scale: f64| {
                let mut session = Session::new();
                if row.meshes.open {
                    session
                        .load(cap(scale, false).as_bytes(), "cap.obj")
                        .expect("a cap");
                } else {
                    let size = [("level".into(), level)];
                    session.sample("icosphere", &size).expect("a sphere");
                    let mut obj =
                        String::from_utf8(session.export(umbilic::io::Format::Obj).expect("OBJ"))
                            .expect("text");
                    obj = scaled(&obj, scale);
                    session
                        .load(obj.as_bytes(), "sphere.obj")
                        .expect("a sphere");
                }
                let options = FlowOptions {
                    p,
                    ..options(row.id)
                };
                let configured = session.configure(options).expect("a flow");
                configured.dt / configured.tau
            };
            let k = f64::from(row.time_power) + if row.time_power_adds_p { p } else { 0.0 };
            let measured = (ratio(2.0, 3.0) / ratio(2.0, 1.0)).log(3.0);
            assert!(
                (measured - k).abs() < 1e-5,
                "{:?} p {p}: {measured}",
                row.id
            );
        }
    }
}

/// The vertices of an OBJ file times a factor.
fn scaled(obj: &str, factor: f64) -> String {
    let line = |line: &str| match line.strip_prefix("v ") {
        Some(rest) => {
            let numbers = rest
                .split_whitespace()
                .map(|x| x.parse::<f64>().expect("a number"));
            let numbers: Vec<String> = numbers.map(|x| (factor * x).to_string()).collect();
            format!("v {}\n", numbers.join(" "))
        }
        None => format!("{line}\n"),
    };
    obj.lines().map(line).collect()
}

#[test]
fn flows_monitor_one_of_the_functionals_of_their_rows() {
    for row in FLOWS {
        let mut session = Session::new();
        session
            .sample("ellipsoid", &[("level".into(), 2.0)])
            .expect("an ellipsoid");
        session.configure(options(row.id)).expect("a flow");
        for _ in 0..3 {
            session.step().expect("a step");
            let monitored = session.state().expect("a state").monitored;
            assert!(
                row.monitored.contains(&monitored),
                "{:?}: {monitored:?}",
                row.id
            );
        }
    }
}

#[test]
fn a_flow_holds_at_the_boundary_what_its_row_says() {
    for row in FLOWS {
        let Some(usual) = row.boundary else { continue };
        let held = |boundary| {
            let mut session = Session::new();
            session
                .load(cap(1.0, false).as_bytes(), "cap.obj")
                .expect("a cap");
            let options = FlowOptions {
                boundary,
                ..options(row.id)
            };
            session.configure(options).expect("a flow");
            session.held_vertices().expect("a flow")
        };
        assert_eq!(held(None), held(Some(usual)), "{:?}", row.id);
        // Of 11 × 11 vertices the outermost 40, and with them the next 32.
        let expected = match usual {
            Boundary::Fixed => 40,
            Boundary::Clamped => 72,
            Boundary::Free => 0,
        };
        let count = held(None).iter().filter(|held| **held == 1).count();
        assert_eq!(count, expected, "{:?}", row.id);
    }
}
