//! Samples, and the figures of the papers: none is left out, and those that take a few
//! seconds come out as the papers and the closed forms say.

use serde::{Serialize, Serializer};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Mutex;
use std::thread;
use umbilic::app::library;
use umbilic::app::library::{
    Figure, FigureRun, Finding, Group, SAMPLES, Sample, Steps, figure, figures, sample,
};
use umbilic::app::{Arrangement, Compare, FillOptions, Session};
use umbilic::flow::Status;
use umbilic::flow::options::FlowOptions;

/// Numbers of the figures that show a result; the others explain notation. Huisken's paper has
/// none.
const RESULTS: [(&str, &[&str]); 4] = [
    ("circle", &["6", "7", "8", "9", "10", "11", "12"]),
    (
        "p-willmore",
        &[
            "1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12",
        ],
    ),
    ("flips", &["6", "7", "8"]),
    ("curvature", &["5.1", "5.2", "5.3", "5.4", "5.5", "5.6"]),
];

#[test]
fn every_figure_that_shows_a_result_is_there_and_no_other() {
    for (paper, numbers) in RESULTS {
        let ours = figures().filter(|figure| figure.paper == paper);
        let found: BTreeSet<&str> = ours
            .map(|figure| figure.number.split(' ').next().unwrap_or_default())
            .collect();
        assert_eq!(found, numbers.iter().copied().collect(), "{paper}");
        let sound = |figure: &&Figure| figure.paper == paper && figure.quick && !figure.falls_short;
        assert!(figures().filter(sound).count() >= 3, "{paper}");
    }
}

#[test]
fn samples_and_figures_have_ids_of_their_own_and_options_that_can_be() {
    let ids: BTreeSet<&str> = figures().map(|figure| figure.id).collect();
    assert_eq!(ids.len(), figures().count());
    let names: BTreeSet<&str> = SAMPLES.iter().map(|sample| sample.id).collect();
    assert_eq!(names.len(), SAMPLES.len());
    for id in ids.iter().chain(&names) {
        let is_plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || "-.".contains(c);
        assert!(id.chars().all(is_plain), "{id}");
    }
    for figure in figures() {
        assert!(
            figure.sample().is_some(),
            "{}: {}",
            figure.id,
            figure.sample
        );
        figure.whole_options().check().expect(figure.id);
    }
    for sample in SAMPLES {
        sample.whole_options().check().expect(sample.id);
    }
}

/// The English words of the library, and of the first visit, which begins with some of its samples.
struct Words(String);

impl Words {
    fn read() -> Self {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/locales/en");
        let read = |name: &str| std::fs::read_to_string(folder.join(name)).expect("words");
        Self(["library.ftl", "first.ftl"].map(read).concat())
    }

    /// A sentence and its parts, each on a line of its own.
    fn of(&self, id: &str) -> &str {
        let start = format!("\n{id} = ");
        let found = self.0.find(&start).map(|at| &self.0[at + start.len()..]);
        let rest = found.unwrap_or_else(|| panic!("no words for {id}"));
        let end = rest
            .match_indices('\n')
            .find(|(at, _)| !rest[at + 1..].starts_with(' '));
        end.map_or(rest, |(at, _)| &rest[..at])
    }

    /// A finding is said with all of its values and no other.
    fn check(&self, finding: &Finding) {
        let message = &finding.message;
        let shown: BTreeSet<&str> = (self.of(&message.id).split('$').skip(1))
            .map(|rest| rest.split([' ', ',']).next().unwrap_or_default())
            .collect();
        let known: BTreeSet<&str> = message.values.iter().map(|(name, _)| *name).collect();
        assert_eq!(shown, known, "{}", message.id);
        for (_, value) in &message.values {
            let value = serde_json::to_value(value).expect("JSON");
            if let Some(id) = value["id"].as_str() {
                self.of(id);
            }
        }
    }
}

#[test]
fn samples_and_figures_have_words_and_words_their_samples_and_figures() {
    let words = Words::read();
    let group = |group: Group| json!(group).as_str().expect("a name").to_owned();
    for sample in SAMPLES {
        words.of(&format!("sample-{}", sample.id));
        words.of(&format!("sample-{}-shows", sample.id));
        words.of(&format!("group-{}", group(sample.group)));
    }
    for figure in figures() {
        let sentence = words.of(&format!("figure-{}", figure.id.replace('.', "-")));
        assert!(sentence.contains("{ $number }"), "{}", figure.id);
        for part in ["title", "reports", "expected"] {
            assert!(
                sentence.contains(&format!("\n    .{part} = ")),
                "{} {part}",
                figure.id
            );
        }
        let has_reason = sentence.contains("\n    .shortfall = ");
        assert_eq!(has_reason, figure.falls_short, "{}", figure.id);
    }
    let begin = |what: &str| words.0.matches(&format!("\n{what}-")).count();
    // Its name, and what to look for.
    assert_eq!(begin("sample"), 2 * SAMPLES.len());
    // Two more tell how far a figure on the page has come.
    assert_eq!(begin("figure"), figures().count() + 2);
}

/// What the values of a finding come to, for whoever reads a failure.
fn said(finding: &Finding) -> String {
    serde_json::to_string(&finding.message).expect("numbers and names")
}

#[test]
fn quick_figures_come_out() {
    let quick = Mutex::new(figures().filter(|figure| figure.quick));
    let next = || quick.lock().expect("no panic in between").next();
    let judge = || {
        while let Some(figure) = next() {
            let finding = figure.run().expect(figure.id);
            Words::read().check(&finding);
            println!("{}: {}", figure.id, said(&finding));
            // A shortfall that is no more must not be spoken of any longer.
            let (ok, said) = (finding.ok, said(&finding));
            assert_eq!(ok, !figure.falls_short, "{}: {said}", figure.id);
        }
    };
    thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(judge);
        }
    });
}

#[test]
fn a_start_is_no_result() {
    let words = Words::read();
    for figure in figures() {
        let mut session = Session::new();
        figure.begin(&mut session).expect(figure.id);
        match figure.judged(&session).expect(figure.id) {
            Some(finding) => {
                assert!(!finding.ok, "{}: {}", figure.id, said(&finding));
                words.check(&finding);
            }
            None => assert!(figure.is_compound(), "{}", figure.id),
        }
    }
}

#[test]
fn a_session_that_shows_a_figure_is_judged_as_a_run_of_it() {
    for id in ["circle-9", "circle-8", "flips-6", "flips-8-volume"] {
        let figure = figure(id).expect("a figure");
        let mut session = Session::new();
        figure.begin(&mut session).expect(id);
        while session.step().expect(id).is_some() && !session.state().expect(id).status.is_final() {
        }
        let judged = figure.judged(&session).expect(id).expect("all of it");
        assert_eq!(judged, figure.run().expect(id), "{id}");
        if id == "circle-9" {
            // Looking back is no other run: it has the same start.
            session.seek(49).expect("a stored step");
            let finding = figure.judged(&session).expect(id).expect("all of it");
            assert!(finding.ok && finding != judged, "{}", said(&finding));
            let here = session.frame().expect("a frame").exact;
            session
                .restore(&here, None, 49, 1.0)
                .expect("positions that fit");
            assert_eq!(figure.judged(&session).expect(id), None);
        }
    }
}

#[test]
fn flows_side_by_side_are_run_to_the_rest_of_each() {
    let figure = figure("curvature-5.6").expect("a figure");
    let mut run = FigureRun::new(figure);
    while run.advance().expect("a step").is_none() {}
    let panes = run.session().panes("none").expect("panes");
    assert_eq!(panes.len(), 4);
    for pane in panes {
        let state = pane.state.expect("a flow");
        assert_eq!(state.status, Status::Converged, "{}", pane.name);
    }
}

#[test]
fn of_a_scan_the_holes_are_filled_and_its_outer_rim_is_not() {
    let mut session = Session::new();
    let sample = sample("holed-scan").expect("a sample");
    let loaded = sample.load(&mut session, &[]).expect("a surface");
    assert_eq!(loaded.info.boundary_loops, 1);
    let mut open = Session::new();
    open.sample(
        "scan-clean",
        &[("resolution".into(), 140.0), ("loops".into(), 30.0)],
    )
    .expect("a surface");
    let loops = open.boundary_loops().expect("loops");
    let left = session.boundary_loops().expect("loops");
    let longest = loops.iter().map(|one| one.length).fold(0.0, f64::max);
    assert_eq!(left[0].length, longest);
    let recipe = serde_json::to_value(session.provenance().expect("a recipe")).expect("JSON");
    assert_eq!(recipe["edits"][0]["edit"]["fill"]["loops"], "small");
    assert_eq!(left.len(), 1);
}

#[test]
fn coarser_meshes_come_first_and_each_counts_its_own_steps() {
    let figure = figure("p-willmore-10-p2").expect("a figure");
    let mut run = FigureRun::new(figure);
    let (mut vertices, mut steps) = (Vec::new(), Vec::new());
    while run.advance().expect("a step").is_none() {
        let Ok(info) = run.session().info() else {
            continue;
        };
        if vertices.last() != Some(&info.vertices) {
            vertices.push(info.vertices);
            steps.push(0);
        }
        if let Some(last) = steps.last_mut() {
            *last = run.steps().max(*last);
        }
    }
    assert_eq!(vertices, [162, 642, 2562]);
    assert_eq!(steps, [30, 30, 30]);
}

#[derive(Serialize)]
struct SampleRow {
    id: &'static str,
    group: Group,
    shape: &'static str,
    parameters: Parameters,
    options: Value,
    #[serde(skip_serializing_if = "Option::is_none")]
    fill: Option<FillOptions>,
    vertices: usize,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct FigureRow {
    id: &'static str,
    paper: &'static str,
    number: &'static str,
    sample: &'static str,
    options: Value,
    arrangement: Arrangement,
    colour: Value,
    steps: Value,
    #[serde(skip_serializing_if = "Option::is_none")]
    back: Option<Parameters>,
    quick: bool,
    falls_short: bool,
}

/// In the order they are written in: recipes tell parameters in that order.
struct Parameters(library::Parameters);

impl Serialize for Parameters {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().copied())
    }
}

/// What of `whole` is not in `base`.
fn difference(whole: &FlowOptions, base: &FlowOptions) -> Value {
    let [whole, base] = [whole, base].map(|o| serde_json::to_value(o).expect("options"));
    let (Value::Object(whole), Value::Object(base)) = (whole, base) else {
        unreachable!("options are an object");
    };
    let differs = whole
        .into_iter()
        .filter(|(key, value)| base.get(key) != Some(value));
    Value::Object(differs.collect())
}

fn sample_row(sample: &Sample) -> SampleRow {
    SampleRow {
        id: sample.id,
        group: sample.group,
        shape: sample.shape.name,
        parameters: Parameters(sample.shape.parameters),
        options: difference(&sample.whole_options(), &FlowOptions::default()),
        fill: sample.holes.options(),
        vertices: sample
            .load(&mut Session::new(), &[])
            .expect(sample.id)
            .info
            .vertices,
    }
}

fn figure_row(figure: &Figure) -> FigureRow {
    let base = figure.sample().expect("a sample").whole_options();
    FigureRow {
        id: figure.id,
        paper: figure.paper,
        number: figure.number,
        sample: figure.sample,
        options: difference(&figure.whole_options(), &base),
        arrangement: figure.arrangement,
        colour: figure.colour.map_or(json!("none"), |colour| json!(colour)),
        steps: match figure.steps {
            Steps::Rest => json!("rest"),
            Steps::Count(count) => json!(count),
        },
        back: figure.back.map(Parameters),
        quick: figure.quick,
        falls_short: figure.falls_short,
    }
}

/// The module that page and command line read, a row a line.
fn module() -> String {
    let mut text = String::from(
        "// Samples and figures as src/app/library has them. Written by tests/suite/library.rs.

/** @import { FlowOptions } from \"./schema.js\" */
/** @import { Arrangement, FieldName, FillOptions } from \"./types.js\" */

/**
 * A surface to begin with; the words are `sample-<id>`.
 * @typedef {object} Sample
 * @property {string} id
 * @property {'closed' | 'tubes' | 'boundary' | 'repair' | 'flips'} group
 * @property {string} shape        name of the solver's shape …
 * @property {Record<string, number>} parameters  … and its parameters
 * @property {FlowOptions} options  over the defaults
 * @property {Partial<FillOptions>} [fill]   holes filled at once
 * @property {number} vertices     that it then has
 */

/**
 * A figure of a paper; the words are `figure-<id>`.
 * @typedef {object} Figure
 * @property {string} id
 * @property {string} paper        the words are `paper-<paper>`
 * @property {string} number       as the paper has it
 * @property {string} sample       id of the sample it begins with
 * @property {FlowOptions} options  over those of the sample
 * @property {Arrangement} arrangement
 * @property {FieldName | 'none'} colour
 * @property {number | 'rest'} steps  how far it runs; 0 for a figure without a flow
 * @property {Record<string, number>} [back]  parameters of the surface from which the same is run
 *   first, to be shown backwards ahead of it
 * @property {boolean} quick       a few seconds at most
 * @property {boolean} fallsShort  known not to come out as the paper has it
 */
",
    );
    text += "\n/** @type {readonly Sample[]} */\nexport const samples = [\n";
    text.extend(SAMPLES.iter().map(|sample| line(&sample_row(sample))));
    text += "];\n\n/** @type {readonly Figure[]} */\nexport const figures = [\n";
    text.extend(figures().map(|figure| line(&figure_row(figure))));
    text += "];\n";
    text
}

/// JavaScript writes whole numbers without a point.
fn line(row: &impl Serialize) -> String {
    let row = serde_json::to_string(row).expect("JSON");
    format!("  {},\n", row.replace(".0,", ",").replace(".0}", "}"))
}

#[test]
fn what_the_page_reads_is_up_to_date() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/generated/library.js");
    let now = module();
    if std::fs::read_to_string(&file).is_ok_and(|text| text == now) {
        return;
    }
    std::fs::create_dir_all(file.parent().expect("a folder")).expect("a folder");
    std::fs::write(&file, now).expect("a file");
    panic!(
        "{} was out of date and has been written anew",
        file.display()
    );
}

#[test]
fn figures_show_side_by_side_what_their_flows_have() {
    for figure in figures() {
        let own: &[Compare] = match figure.paper {
            "flips" => &[Compare::None, Compare::Start, Compare::Criteria],
            "curvature" => &[Compare::None, Compare::Flows],
            _ => &[Compare::None],
        };
        assert!(own.contains(&figure.arrangement.compare), "{}", figure.id);
        if figure.paper != "flips" {
            let flips = Arrangement {
                compare: figure.arrangement.compare,
                ..Arrangement::PLAIN
            };
            assert_eq!(figure.arrangement, flips, "{}", figure.id);
        }
    }
}
