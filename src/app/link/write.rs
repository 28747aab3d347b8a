//! Writing a link: what the session knows of the scene, and what the page adds.

use super::base::base_of;
use super::error::LinkError;
use super::record::{encode_edits, encode_path};
use super::region;
use super::words::Written;
use super::{
    Comparison, DIGEST, LETTERS, Link, LinkView, Lockstep, MAX_SELECTED, SAME, Scale, Shading,
};
use crate::app::arrangement::Arrangement;
use crate::app::comparison::{change_between, differing, options_with, say_whole};
use crate::app::fault::Fault;
use crate::app::field::FieldName;
use crate::app::provenance::{Action, Provenance};
use crate::app::recipe::{Origin, Reader, is_plain, steps_in};
use crate::app::{Session, json, library};
use crate::arrays::TypedArray;
use crate::flow::option::{Options, Row, Value, Values};
use crate::flow::options::FlowOptions;
use serde::{Deserialize, Serialize};

/// What the page knows of its scene and the session does not.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct PageScene {
    /// What the open mesh is called.
    pub source: Origin,
    /// What it was made of; null where that is not known.
    pub origin: Option<Origin>,
    /// Id of the figure that is shown.
    pub figure: Option<String>,
    /// Flows beside it, changed from the options in force.
    pub comparison: Option<Comparison>,
    /// How it is drawn.
    pub view: LinkView,
    /// As the viewer gives it.
    pub camera: Option<TypedArray<f32>>,
    /// The step that it runs to; of the half of a film that is shown backwards a negative one.
    pub goal: Option<i32>,
    /// Whether it is sent to somebody, so that there is always an energy to compare.
    pub shared: bool,
}

/// Something that a link does not carry.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum Lack {
    /// Edits that are too long.
    EditsTooLong,
    /// Edits that are not known any more.
    EditsUnknown,
    /// A file, named only.
    File,
    /// A file, known by its digest.
    FileByDigest,
    /// A selection that is too scattered.
    RegionTooLong,
    /// Changes on the way that are too long.
    PathTooLong,
}

/// A link, and what it lacks.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct WrittenLink {
    /// Its words.
    pub text: String,
    /// What must be sent along.
    pub lacks: Vec<Lack>,
}

/// A value as a word of a link.
fn text_of<S>(row: &Row<S>, value: &Value) -> String {
    match value {
        Value::Absent | Value::Object => row.absent.unwrap_or("auto").into(),
        Value::Switch(yes) => yes.to_string(),
        Value::Number(x) => json::number(*x),
        Value::Text(text) => text.clone(),
        Value::List(values) if values.is_empty() => "none".into(),
        Value::List(values) => {
            let words: Vec<String> = values.iter().map(|value| text_of(row, value)).collect();
            words.join(",")
        }
    }
}

/// Five significant digits, as `toPrecision` rounds: halves away from zero.
fn five_digits(x: f32) -> String {
    // All digits that a number in single precision has.
    let text = format!("{:.120e}", f64::from(x.abs()));
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let digits: Vec<u32> = mantissa.chars().filter_map(|c| c.to_digit(10)).collect();
    let kept = digits.iter().take(5).fold(0, |n, digit| 10 * n + digit);
    let rounded = kept + u32::from(digits.get(5).is_some_and(|digit| *digit >= 5));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let sign = if x < 0.0 { "-" } else { "" };
    let shown = format!("{sign}{rounded}e{}", exponent - 4);
    json::number(shown.parse().unwrap_or(0.0))
}

fn selection<'a>(values: &'a Values, name: &str) -> Option<&'a [Value]> {
    match values.get(name) {
        Some(Value::List(vertices)) => Some(vertices),
        _ => None,
    }
}

fn region_of(vertices: &[Value], room: &mut Reader) -> Option<String> {
    room.select(vertices.len()).ok()?;
    let numbers = vertices.iter().map(|value| match value {
        Value::Number(x) => Some(*x as u32),
        _ => None,
    });
    region::encode(&numbers.collect::<Option<Vec<u32>>>()?)
}

impl Link {
    /// Its words, and what fits none.
    pub(super) fn write(&self) -> WrittenLink {
        let mut words = Written::new();
        let mut lacks = Vec::new();
        let mut room = Reader::new(MAX_SELECTED);
        words.set_some("sample", self.sample.as_deref());
        words.set_some("mesh", self.mesh.as_deref());
        words.set_some("hash", self.hash.as_deref());
        let edits = self.edits.as_deref();
        words.set_some(
            "edits",
            edits
                .and_then(|edits| encode_edits(edits, &mut room))
                .as_deref(),
        );
        words.set_some("figure", self.figure.as_deref());
        for row in FlowOptions::ROWS
            .iter()
            .filter(|row| !is_selection(row.name))
        {
            if let Some(value) = self.options.get(row.name) {
                words.set(row.name, &text_of(row, value));
            }
        }
        for name in ["free", "fixed"] {
            let Some(vertices) = selection(&self.options, name) else {
                continue;
            };
            match region_of(vertices, &mut room) {
                Some(region) => words.set(name, &region),
                None => lacks.push(Lack::RegionTooLong),
            }
        }
        for row in Arrangement::ROWS {
            if let Some(value) = self.arrangement.get(row.name) {
                words.set(row.name, &text_of(row, value));
            }
        }
        let name = |field: FieldName| FieldName::ALL.iter().find(|known| known.0 == field);
        words.set_some("colour", self.colour.and_then(name).map(|(_, name)| *name));
        if let Some(comparison) = &self.comparison {
            write_comparison(&mut words, comparison);
        }
        self.write_view(&mut words);
        if self.step != 0 {
            words.set("step", &self.step.to_string());
        }
        if let Some(path) = &self.path {
            match encode_path(path, &mut room) {
                Some(path) => words.set("path", &path),
                None => lacks.push(Lack::PathTooLong),
            }
        }
        words.set_some("version", self.version.as_deref());
        words.set_some("check", self.check.as_deref());
        let text = words.finish();
        lacks.dedup();
        WrittenLink { text, lacks }
    }

    fn write_view(&self, words: &mut Written) {
        let LinkView {
            shading,
            wireframe,
            boundary,
            cut,
            scale,
        } = self.view;
        if shading == Some(Shading::Flat) {
            words.set("shading", "flat");
        }
        if wireframe == Some(true) {
            words.set("wireframe", "true");
        }
        if boundary == Some(false) {
            words.set("border", "false");
        }
        if let Some(cut) = cut.filter(|cut| *cut > 0) {
            words.set("cut", &cut.to_string());
        }
        match scale {
            Some(Scale::Log) => words.set("scale", "log"),
            Some(Scale::Linear) => words.set("scale", "linear"),
            Some(Scale::Auto) | None => {}
        }
        if let Some(camera) = &self.camera {
            let numbers: Vec<String> = camera.iter().map(|x| five_digits(*x)).collect();
            words.set("camera", &numbers.join(","));
        }
    }
}

fn is_selection(name: &str) -> bool {
    ["free", "fixed"].contains(&name)
}

fn write_comparison(words: &mut Written, comparison: &Comparison) {
    let pane = |pane: &super::PaneChange| {
        let rows = FlowOptions::ROWS
            .iter()
            .filter(|row| !is_selection(row.name));
        let mut pairs: Vec<String> = rows
            .filter_map(|row| {
                let value = pane.change.get(row.name)?;
                Some(format!("{}_{}", row.name, text_of(row, value)))
            })
            .collect();
        pairs.extend(pane.step.map(|step| format!("step_{step}")));
        if pairs.is_empty() {
            SAME.into()
        } else {
            pairs.join("_")
        }
    };
    let panes: Vec<String> = comparison.panes.iter().map(pane).collect();
    words.set("panes", &panes.join("*"));
    if comparison.lockstep == Lockstep::Time {
        words.set("lockstep", "time");
    }
    let letter = |place: Option<usize>| LETTERS.get(place?).copied();
    words.set_some("shown", letter(comparison.shown));
    words.set_some(super::DIFFERENCE, letter(comparison.difference));
}

impl Session {
    /// The scene as a link.
    ///
    /// # Errors
    /// [`Fault::no_mesh`]; panes with options that cannot be.
    pub fn write_link(&self, scene: &PageScene) -> Result<WrittenLink, Fault> {
        let state = self.state()?;
        let mut known = self.provenance().ok();
        let here = self.signed(state.step);
        let mut step = scene.goal.unwrap_or(here);
        let (steps, is_back) = (step.unsigned_abs() as usize, step < 0);
        if let (Some(known), Some(more)) = (&mut known, steps.checked_sub(state.step)) {
            go_on(&mut known.path, more);
        }
        let mut link = Link::default();
        let mut lacks = link.begin(scene, known.as_ref());
        let current = self.options()?.unwrap_or_default();
        let path = known.as_ref().map(|known| &known.path);
        let path = path.filter(|path| !is_plain(path) && steps_in(path) == steps as u64);
        // What else than steps was done in the half that is shown backwards has no words.
        if is_back && (path.is_some() || scene.figure.is_none()) {
            step = 0;
        }
        let path = path.filter(|_| !is_back);
        link.path = path.cloned();
        let first = known
            .and_then(|known| known.flow)
            .filter(|_| link.changes_its_flow());
        link.set_options(first.as_ref().unwrap_or(&current));
        link.arrangement = self.runner()?.arrangement_that_matters();
        link.colour = self.view.field;
        link.comparison = compared(
            scene.comparison.as_ref(),
            &current,
            first.as_ref(),
            state.step,
        )?;
        link.view = scene.view;
        link.camera = scene.camera.clone().map(|camera| camera.0);
        link.step = step;
        // On the way to another step the energy there is not known yet. At the start it follows
        // from the rest of the link.
        if step == here && (step != 0 || scene.shared) {
            link.version = Some(env!("CARGO_PKG_VERSION").into());
            link.check = Some(state.energy)
                .filter(|energy| energy.is_finite())
                .map(json::number);
        }
        let mut written = link.write();
        if written.lacks.contains(&Lack::PathTooLong) && first.is_some() {
            // Without what led there, the options that are in force are nearest.
            link.path = None;
            link.set_options(&current);
            written.text = link.write().text;
        }
        lacks.append(&mut written.lacks);
        written.lacks = lacks;
        Ok(written)
    }
}

/// A path that is longer by so many steps.
fn go_on(path: &mut Vec<Action>, more: usize) {
    if more == 0 {
        return;
    }
    match path.last_mut() {
        Some(Action::Steps(count)) => *count += more,
        _ => path.push(Action::Steps(more)),
    }
}

/// The panes, by how they differ from the options that the link begins with.
fn compared(
    comparison: Option<&Comparison>,
    current: &FlowOptions,
    first: Option<&FlowOptions>,
    step: usize,
) -> Result<Option<Comparison>, LinkError> {
    use crate::flow::spec::FlowName::Flips;
    let base = first.unwrap_or(current);
    let Some(comparison) = comparison.filter(|one| !one.panes.is_empty() && base.flow != Flips)
    else {
        return Ok(None);
    };
    let mut comparison = comparison.clone();
    for pane in &mut comparison.panes {
        let options = options_with(current, &pane.change)?;
        if first.is_some() {
            pane.change = change_between(base, &options)?;
        }
        if pane.change.contains_key("flow") {
            say_whole(&mut pane.change, &options);
        }
        pane.step = pane.step.filter(|other| *other != step);
    }
    Ok(Some(comparison))
}

impl Link {
    /// What it begins with: the mesh that was loaded, with what was done to it, or only the name
    /// of what came of it, where that is not known or fits no link. Answers what it lacks.
    fn begin(&mut self, scene: &PageScene, known: Option<&Provenance>) -> Vec<Lack> {
        let mut lacks = Vec::new();
        let mut from = &scene.source;
        let is_edited = scene.origin.as_ref() != Some(from);
        if is_edited {
            let named = |origin: &&Origin| !matches!(origin, Origin::Shape { .. });
            match (known, scene.origin.as_ref().filter(named)) {
                (Some(known), Some(origin)) => {
                    let mut room = Reader::new(MAX_SELECTED);
                    if encode_edits(&known.edits, &mut room).is_some() {
                        self.edits = Some(known.edits.clone());
                        from = origin;
                    } else {
                        lacks.push(Lack::EditsTooLong);
                    }
                }
                (Some(known), None) if known.edits.is_empty() => {}
                _ => lacks.push(Lack::EditsUnknown),
            }
        }
        match from {
            Origin::Sample { id } => {
                self.sample = Some(id.clone());
                let shows = |id: &&String| {
                    library::figure(id)
                        .is_some_and(|figure| Some(figure.sample) == self.sample.as_deref())
                };
                let figure = scene.figure.as_ref().filter(shows);
                self.figure = figure.filter(|_| self.edits.is_none()).cloned();
            }
            Origin::File { name, sha256, .. } => {
                self.mesh = Some(name.clone());
                self.hash = sha256
                    .as_ref()
                    .and_then(|all| all.get(..DIGEST))
                    .map(Into::into);
                if lacks.is_empty() {
                    let is_known = self.hash.is_some();
                    lacks.push([Lack::File, Lack::FileByDigest][usize::from(is_known)]);
                }
            }
            Origin::Shape { shape, .. } => self.mesh = Some(shape.clone()),
        }
        lacks
    }

    fn changes_its_flow(&self) -> bool {
        let path = self.path.iter().flatten();
        path.into_iter()
            .any(|action| matches!(action, Action::Flow(_)))
    }

    /// The flow, and what is not as usual of the sample.
    fn set_options(&mut self, options: &FlowOptions) {
        let base = base_of(self.sample.as_deref());
        self.options = differing(&base, options);
        let flow = FlowOptions::ROWS.iter().find(|row| row.name == "flow");
        if let Some(row) = flow {
            self.options.insert(row.name.into(), (row.get)(options));
        }
        say_whole(&mut self.options, options);
    }
}
