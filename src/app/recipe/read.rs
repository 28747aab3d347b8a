//! Reading recipes: every value is checked and refused by its place, and no more is set aside
//! than the text can ask for.

use super::error::{MustBe, RecipeError};
use super::file::{Recipe, RecipeMesh, ReplayResult};
use super::script::steps_in;
use crate::app::arrangement::Arrangement;
use crate::app::edit::options::{FillOptions, RepairOptions};
use crate::app::link::region;
use crate::app::provenance::{Action, Edit, EditRecord};
use crate::flow::option::{self, OptionError, Value, Values};
use crate::flow::options::FlowOptions;
use crate::remesh::repair::Weld;
use crate::remesh::static_pass::RegulariseOptions;
use serde::Deserialize;
use serde_json::Value as Json;

/// Bytes of a recipe at most: a selection of a million vertices and much else.
const MAX_BYTES: usize = 16 << 20;
/// Vertices in all selections of a recipe at most.
const MAX_SELECTED: usize = 8 << 20;
/// The largest count that anything has.
const MAX_COUNT: u64 = 1_000_000_000;
/// Passes of a regularisation at most.
const MAX_PASSES: usize = 1000;
/// New vertices of a fill at most.
const MAX_NEW_VERTICES: usize = 1_000_000;

static MISSING: Json = Json::Null;

/// A value, and its place in the text.
pub(in crate::app) struct Node<'a> {
    value: &'a Json,
    key: String,
}

impl<'a> Node<'a> {
    pub(in crate::app) fn new(value: &'a Json, key: &str) -> Self {
        let key = key.into();
        Self { value, key }
    }

    fn bad<T>(&self, must: MustBe) -> Result<T, RecipeError> {
        let key = self.key.clone();
        Err(RecipeError::Malformed { key, must })
    }

    fn is_object(&self) -> bool {
        self.value.is_object()
    }

    fn is_null(&self) -> bool {
        self.value.is_null()
    }

    /// A member of an object; null where there is none.
    fn member(&self, name: &str) -> Self {
        let value = self.value.get(name).unwrap_or(&MISSING);
        let dot = if self.key.is_empty() { "" } else { "." };
        let key = format!("{}{dot}{name}", self.key);
        Self { value, key }
    }

    /// The only member of an object, where it is of that name.
    fn only(&self, name: &str) -> Option<Self> {
        let object = self.value.as_object()?;
        (object.len() == 1 && object.contains_key(name)).then(|| self.member(name))
    }

    fn text(&self, must: MustBe) -> Result<String, RecipeError> {
        match self.value {
            Json::String(text) => Ok(text.clone()),
            _ => self.bad(must),
        }
    }

    fn list(&self) -> Result<Vec<Self>, RecipeError> {
        let Json::Array(values) = self.value else {
            return self.bad(MustBe::List);
        };
        let node = |(n, value): (usize, &'a Json)| Self {
            value,
            key: format!("{}[{n}]", self.key),
        };
        Ok(values.iter().enumerate().map(node).collect())
    }

    fn count(&self) -> Result<usize, RecipeError> {
        let most = MAX_COUNT;
        match self.value.as_f64() {
            Some(x) if x >= 0.0 && x <= most as f64 && x.fract() == 0.0 => Ok(x as usize),
            _ => self.bad(MustBe::Count { most }),
        }
    }

    fn number(&self) -> Result<f64, RecipeError> {
        match self.value.as_f64() {
            Some(x) if x.is_finite() => Ok(x),
            _ => self.bad(MustBe::Number),
        }
    }

    fn digest(&self) -> Result<String, RecipeError> {
        let text = self.text(MustBe::Digest)?;
        let is_digit = |byte: u8| byte.is_ascii_digit() || (b'a'..=b'f').contains(&byte);
        match text.len() == 64 && text.bytes().all(is_digit) {
            true => Ok(text),
            false => self.bad(MustBe::Digest),
        }
    }

    fn options(&self) -> Result<Values, RecipeError> {
        match (self.is_object(), Values::deserialize(self.value)) {
            (true, Ok(values)) => Ok(values),
            _ => self.bad(MustBe::Options),
        }
    }
}

/// Reads what was done to a surface, and keeps count of what that sets aside.
pub(in crate::app) struct Reader {
    selected: usize,
    most: usize,
    /// The version that wrote it, where that is another.
    version: Option<String>,
}

impl Reader {
    /// Of selections with `most` vertices in all.
    pub(in crate::app) fn new(most: usize) -> Self {
        Self {
            selected: 0,
            most,
            version: None,
        }
    }

    fn refused(&self, error: OptionError) -> RecipeError {
        match self.version.clone() {
            Some(version) => RecipeError::OldOption {
                error: Box::new(error),
                version,
                present: env!("CARGO_PKG_VERSION"),
            },
            None => error.into(),
        }
    }

    /// So many vertices more are selected.
    pub(in crate::app) fn select(&mut self, count: usize) -> Result<(), RecipeError> {
        self.selected = self.selected.saturating_add(count);
        let (count, most) = (self.selected, self.most);
        match count > most {
            true => Err(RecipeError::TooManySelected { count, most }),
            false => Ok(()),
        }
    }

    /// A selection as a link writes it, as a list; any other text is left to be refused.
    ///
    /// # Errors
    /// Where there are too many vertices, before any are set aside.
    pub(in crate::app) fn selection(&mut self, value: &mut Value) -> Result<(), RecipeError> {
        match value {
            Value::List(vertices) => self.select(vertices.len()),
            Value::Text(text) => {
                let Some(found) = region::parse(text) else {
                    return Ok(());
                };
                self.select(found.count())?;
                let vertices = found.vertices();
                *value = Value::List(vertices.map(|v| Value::Number(f64::from(v))).collect());
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn flow(&mut self, node: &Node<'_>) -> Result<FlowOptions, RecipeError> {
        let mut values = node.options()?;
        for name in ["free", "fixed"] {
            if let Some(value) = values.get_mut(name) {
                self.selection(value)?;
            }
        }
        option::as_meant(&mut values, &option::before());
        option::options_of(&values).map_err(|error| self.refused(error))
    }

    fn action(&mut self, node: &Node<'_>) -> Result<Action, RecipeError> {
        if node.value.as_str() == Some("anew") {
            return Ok(Action::Anew);
        }
        if let Some(steps) = node.only("steps")
            && let Ok(count) = steps.count()
        {
            return Ok(Action::Steps(count));
        }
        if let Some(flow) = node.only("flow").filter(Node::is_object) {
            return Ok(Action::Flow(Box::new(self.flow(&flow)?)));
        }
        let Some(settings) = node.only("regularise").filter(Node::is_object) else {
            return node.bad(MustBe::Action);
        };
        match RegulariseOptions::deserialize(settings.value) {
            Ok(options) if options.iterations <= MAX_PASSES => Ok(Action::Regularise(options)),
            _ => settings.bad(MustBe::Regularisation),
        }
    }

    /// What was done, in turn.
    pub(in crate::app) fn path(&mut self, node: &Node<'_>) -> Result<Vec<Action>, RecipeError> {
        node.list()?.iter().map(|node| self.action(node)).collect()
    }

    /// Runs, each with the edit that ended it.
    pub(in crate::app) fn edits(
        &mut self,
        node: &Node<'_>,
    ) -> Result<Vec<EditRecord>, RecipeError> {
        node.list()?.iter().map(|node| self.record(node)).collect()
    }

    fn record(&mut self, node: &Node<'_>) -> Result<EditRecord, RecipeError> {
        if !node.is_object() {
            return node.bad(MustBe::Object);
        }
        let flow = node.member("flow");
        // Left out it is a mistake, null where none was chosen.
        if flow.is_null() && node.value.get("flow").is_none() {
            return flow.bad(MustBe::Options);
        }
        let flow = match flow.is_null() {
            true => None,
            false => Some(self.flow(&flow)?),
        };
        let path = self.path(&node.member("path"))?;
        let edit = node.member("edit");
        let is_bounded = |edit: &Edit| match edit {
            Edit::Fill(FillOptions { max_vertices, .. }) => {
                max_vertices.is_none_or(|most| most <= MAX_NEW_VERTICES)
            }
            Edit::Repair(RepairOptions {
                weld: Weld::Within(length),
            }) => length.is_finite() && *length >= 0.0,
            _ => true,
        };
        match Edit::deserialize(edit.value) {
            Ok(found) if is_bounded(&found) => Ok(EditRecord {
                flow,
                path,
                edit: found,
            }),
            _ => edit.bad(MustBe::Edit),
        }
    }
}

impl RecipeMesh {
    fn read(node: &Node<'_>) -> Result<Self, RecipeError> {
        if !node.is_object() {
            return node.bad(MustBe::Object);
        }
        let member = |name| node.member(name);
        if node.value.get("shape").is_none() {
            return Ok(Self::File {
                name: member("name").text(MustBe::File)?,
                sha256: member("sha256").digest()?,
                bytes: member("bytes").count()?,
            });
        }
        let numbers = member("parameters");
        let Ok(parameters) = Deserialize::deserialize(numbers.value) else {
            return numbers.bad(MustBe::Numbers);
        };
        let sample = member("sample");
        Ok(Self::Shape {
            sample: match sample.is_null() {
                true => None,
                false => Some(sample.text(MustBe::Sample)?),
            },
            shape: member("shape").text(MustBe::Shape)?,
            parameters,
        })
    }
}

impl ReplayResult {
    fn read(node: &Node<'_>) -> Result<Self, RecipeError> {
        if !node.is_object() {
            return node.bad(MustBe::Object);
        }
        let number = |name| node.member(name).number();
        let (volume, positions) = (node.member("volume"), node.member("positions"));
        Ok(Self {
            energy: number("energy")?,
            area: number("area")?,
            volume: match volume.is_null() {
                true => None,
                false => Some(
                    volume
                        .number()
                        .or_else(|_| volume.bad(MustBe::NumberOrNull))?,
                ),
            },
            min_angle_degrees: number("minAngleDegrees")?,
            time: number("time")?,
            positions: match positions.is_null() {
                true => None,
                false => Some(positions.digest()?),
            },
        })
    }
}

impl Recipe {
    /// Reads a recipe and checks all of it.
    ///
    /// # Errors
    /// The line that is no JSON, or the place of the first value that cannot be.
    pub(in crate::app) fn read(text: &str) -> Result<Self, RecipeError> {
        let (bytes, most) = (text.len(), MAX_BYTES);
        if bytes > most {
            return Err(RecipeError::TooLong { bytes, most });
        }
        let json: Json =
            serde_json::from_slice(text.as_bytes()).map_err(|error| RecipeError::NotJson {
                line: error.line().max(1),
            })?;
        let node = Node::new(&json, "");
        let version = node.member("umbilic").text(MustBe::Version)?;
        let mut reader = Reader::new(MAX_SELECTED);
        reader.version = (version != env!("CARGO_PKG_VERSION")).then(|| version.clone());
        let mesh = RecipeMesh::read(&node.member("mesh"))?;
        let edits = match node.value.get("edits") {
            Some(_) => reader.edits(&node.member("edits"))?,
            None => Vec::new(),
        };
        let flow = reader.flow(&node.member("flow"))?;
        let arrangement = match node.value.get("arrangement") {
            Some(_) => node.member("arrangement").options()?,
            None => Values::new(),
        };
        option::options_of::<Arrangement>(&arrangement).map_err(|error| reader.refused(error))?;
        let steps = node.member("steps").count()?;
        let path = match node.value.get("path") {
            Some(_) => Some(reader.path(&node.member("path"))?),
            None => None,
        };
        let total = steps as u64;
        if path.as_deref().is_some_and(|path| steps_in(path) != total) {
            return node.member("path").bad(MustBe::Steps { total });
        }
        let result = ReplayResult::read(&node.member("result"))?;
        Ok(Self {
            version,
            mesh,
            edits,
            flow,
            arrangement,
            steps,
            path,
            result,
        })
    }
}
