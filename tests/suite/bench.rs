//! Tables of measurements: their columns and rows. Nothing is said of how long anything takes.

use umbilic::app::{Bench, BenchOptions, OpenedFile, Session, TableName, read_flags};
use umbilic::flow::option::{Value as Given, Values};
use umbilic::io::Format;
use umbilic::message::Value;

/// A row by its columns.
struct Row(Vec<(&'static str, Value)>);

impl Row {
    fn value(&self, column: &str) -> &Value {
        let found = self.0.iter().find(|(name, _)| *name == column);
        &found
            .unwrap_or_else(|| panic!("there is no column {column}"))
            .1
    }

    fn number(&self, column: &str) -> f64 {
        match self.value(column) {
            Value::Number(number) => *number,
            other => panic!("{column} is {other:?}"),
        }
    }

    fn text(&self, column: &str) -> &str {
        match self.value(column) {
            Value::Text(text) => text,
            other => panic!("{column} is {other:?}"),
        }
    }
}

fn rows(table: TableName, options: BenchOptions) -> Vec<Row> {
    let options = BenchOptions {
        table: Some(table),
        ..options
    };
    let mut bench = Bench::new(&options).expect("a table");
    std::iter::from_fn(|| {
        let report = bench.advance().expect("measured");
        let row = report.row?;
        assert_eq!(row.len(), report.columns.len());
        Some(Row(report.columns.into_iter().zip(row).collect()))
    })
    .collect()
}

fn small(max_vertices: usize) -> BenchOptions {
    BenchOptions {
        max_vertices: Some(max_vertices),
        steps: 2,
        ..BenchOptions::default()
    }
}

#[test]
fn the_smallest_row_of_each_table_of_times_is_whole() {
    let circle = rows(TableName::Circle, small(3000));
    assert_eq!(circle.len(), 1);
    let sizes = ["vertices", "faces"].map(|column| circle[0].number(column));
    assert_eq!(sizes, [2601.0, 5202.0]);
    for part in ["assemble", "factor", "solve", "search", "regularise"] {
        assert!(circle[0].number(part) <= circle[0].number("step"), "{part}");
    }
    // Of a step without refusals it is all, and of any other less.
    assert!(circle[0].number("trial") <= circle[0].number("step"));

    let flips = rows(TableName::Flips, small(3600));
    let criteria: Vec<&str> = flips.iter().map(|row| row.text("criterion")).collect();
    assert_eq!(criteria, ["area", "willmore", "localised"]);
    for row in &flips {
        // A closed surface of Euler characteristic 0 has three edges a vertex.
        assert_eq!(row.number("edges"), 3.0 * 84.0 * 42.0);
        let (flips, rate) = (row.number("flips"), row.number("kiloflips"));
        assert!((rate * row.number("milliseconds") - flips).abs() < 1e-9 * flips);
    }

    let mmcv = rows(TableName::Mmcv, small(1200));
    assert!(!mmcv.is_empty());
    for row in &mmcv {
        let steps = row
            .text("steps")
            .split_once(' ')
            .expect("steps, and how they ended");
        assert!(steps.0.parse::<usize>().expect("a count") <= 60);
        if let Value::Number(paper) = row.value("paper") {
            assert!((row.number("ratio") * row.number("step") - paper).abs() < 1e-9 * paper);
        }
    }
    assert!(rows(TableName::PWillmore, small(10)).is_empty());

    let repair = rows(TableName::Repair, small(3000));
    assert_eq!(repair.len(), 1);
    let sizes = ["triangles", "vertices"].map(|column| repair[0].number(column));
    assert_eq!(sizes, [4096.0, 2048.0]);
}

#[test]
fn the_table_of_refinement_has_the_orders_of_the_study() {
    let rows = rows(TableName::Refinement, small(700));
    let sphere = &rows[1];
    assert_eq!(
        sphere.text("shape"),
        "",
        "the second resolution of the first shape"
    );
    assert_eq!(sphere.number("vertices"), 642.0);
    // Flat triangles inscribed in a sphere: second order.
    assert!((sphere.number("areaOrder") - 2.0).abs() < 0.1);
    assert_eq!(rows[0].value("areaOrder"), &Value::None);
    assert_eq!(rows[0].text("shape"), "icosphere");
    assert!(rows.iter().all(|row| row.number("vertices") <= 700.0));
}

#[test]
fn what_is_refused_is_a_row_too_and_the_others_go_on() {
    let mut session = Session::new();
    session
        .sample("ellipsoid", &[("level".into(), 2.0)])
        .expect("an ellipsoid");
    let tall = session.export(Format::Ply).expect("PLY");
    let square = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
    let file = |name: &str, bytes: &[u8]| OpenedFile {
        name: name.into(),
        bytes: bytes.to_vec().into(),
    };
    let options = BenchOptions {
        meshes: vec![
            file("mesh.obj", b"v 0 0 0\nf 1 2 3\n"),
            file("square.off", square.as_bytes()),
            file("tall.ply", &tall),
        ],
        ..BenchOptions::default()
    };
    let found = rows(TableName::Robustness, options);
    let of = |name: &str| -> Vec<&Row> {
        found
            .iter()
            .filter(|row| row.text("case") == name)
            .collect()
    };
    assert_eq!(of("mesh.obj").len(), 1);
    let refusal = of("mesh.obj")[0].text("ending");
    assert!(refusal.starts_with("refused: "), "{refusal}");
    let flows =
        |name: &str| -> Vec<&str> { of(name).into_iter().map(|row| row.text("flow")).collect() };
    let every = [
        "circle",
        "p-willmore",
        "p-willmore, area, volume",
        "mean-curvature",
        "surface-diffusion",
        "willmore",
        "mmcv",
    ];
    assert_eq!(flows("square.off"), every);
    assert_eq!(of("square.off")[1].text("ending"), "refused: NotClosed");
    assert_eq!(flows("tall.ply"), every);
    for row in of("tall.ply") {
        let (flow, ending) = (row.text("flow"), row.text("ending"));
        assert!(
            !ending.contains("refused") && !ending.contains("failed"),
            "{flow}: {ending}"
        );
        assert!((1.0..=100.0).contains(&row.number("steps")), "{flow}");
        assert!(row.number("last") < row.number("first"), "{flow}");
        // A reading by fits may lie a thousandth above its least.
        let most = if ["willmore", "mmcv"].contains(&flow) {
            1e-3
        } else {
            0.0
        };
        assert!(row.number("rise") <= most, "{flow}: {}", row.number("rise"));
    }
}

#[test]
fn figures_are_those_asked_for_in_the_order_of_the_gallery() {
    let asked = ["flips-8", "circle-9"].map(String::from).to_vec();
    let options = BenchOptions {
        figures: Some(asked),
        ..BenchOptions::default()
    };
    let found = rows(TableName::Figures, options);
    let ends: Vec<_> = found
        .iter()
        .map(|row| (row.text("id"), row.text("verdict"), row.number("steps")))
        .collect();
    assert_eq!(ends, [("circle-9", "✓", 50.0), ("flips-8", "✓", 1.0)]);
    let Value::Message(expected) = found[0].value("expected") else {
        panic!("it is no message")
    };
    assert_eq!(&*expected.id, "figure-circle-9.expected");
}

fn words(pairs: &[(&str, &str)]) -> Values {
    let text = |(name, text): &(&str, &str)| ((*name).into(), Given::Text((*text).into()));
    pairs.iter().map(text).collect()
}

#[test]
fn flags_are_read_by_the_rows_of_their_command() {
    let read = |command: &str, pairs: &[(&str, &str)]| read_flags(command, &words(pairs));
    let refused = |command: &str, pairs: &[(&str, &str)]| {
        read(command, pairs).expect_err("it is refused").kind
    };
    let number = Given::Number;
    let energy = read("energy", &[("p", "2.5, 6"), ("boundary", "free")]).expect("options");
    assert_eq!(energy["p"], Given::List(vec![number(2.5), number(6.0)]));
    assert_eq!(refused("energy", &[("p", "2,-1")]), "BadOption");
    let one = |command: &str, name: &str, word: &str| {
        let mut values = read(command, &[(name, word)]).expect("it may be");
        values.remove(name).expect("a value")
    };
    assert_eq!(one("fill", "loops", "small"), Given::Absent);
    assert_eq!(one("fill", "loops", "all"), Given::Text("all".into()));
    assert_eq!(one("repair", "weld", "auto"), Given::Absent);
    assert_eq!(one("repair", "weld", "off"), Given::Text("off".into()));
    assert_eq!(one("repair", "weld", "1e-3"), number(1e-3));
    for weld in ["0", "-1", "wide"] {
        assert_eq!(refused("repair", &[("weld", weld)]), "BadOption");
    }
    assert_eq!(refused("fill", &[("loops", "inner")]), "BadOption");
    assert_eq!(refused("fill", &[("loops", "0,1.5")]), "BadOption");
    assert_eq!(refused("regularise", &[("mode", "off")]), "BadOption");
    assert_eq!(refused("regularise", &[("epsilon", "0")]), "BadOption");
    assert_eq!(refused("flips", &[("max", "-1")]), "BadOption");
    assert_eq!(refused("flips", &[("goal", "smooth")]), "UnknownOption");
    assert_eq!(
        refused("remesh", &[("vertices", "9"), ("target", "0.1")]),
        "ConflictingOptions"
    );
    assert_eq!(refused("bench", &[]), "MissingOption");
    assert_eq!(
        refused("bench", &[("table", "circle"), ("quick", "true")]),
        "LoneOption"
    );
    assert!(read("bench", &[("table", "figures"), ("quick", "true")]).is_ok());

    // Smoothing takes a set number of steps, and leading a volume keeps area and volume.
    let smooth = [("goal", "smooth"), ("maxSteps", "4")];
    assert_eq!(
        read("flow", &smooth).expect("options")["smoothSteps"],
        number(4.0)
    );
    let led = [("flow", "p-willmore"), ("reducedVolume", "0.8")];
    let kept = ["area", "volume"].map(|name| Given::Text(name.into()));
    assert_eq!(
        read("flow", &led).expect("options")["keep"],
        Given::List(kept.to_vec())
    );
}

#[test]
fn a_run_that_is_over_says_how_it_ended() {
    let mut session = Session::new();
    session
        .sample("icosahedron", &[("level".into(), 2.0)])
        .expect("a shape");
    let options = umbilic::flow::options::FlowOptions {
        max_steps: Some(2),
        ..Default::default()
    };
    session.configure(options).expect("a flow");
    session.run(10).expect("two steps");
    let outcome = session.outcome().expect("an outcome");
    assert!(!outcome.is_breakdown && outcome.fault.is_none());
    assert_eq!(&*outcome.message.id, "run-over");
    let Some(Value::Message(ended)) = outcome.message.value("ended") else {
        panic!("it does not say how")
    };
    assert_eq!(ended.value("status"), Some(&"stepLimit".into()));
    assert_eq!(ended.number("steps"), Some(2.0));
    assert_eq!(outcome.reason, session.state().expect("a state").message);
}
