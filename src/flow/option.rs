//! Options as rows of a table: one a field, with its name, what it may be and who reads it.
//!
//! Whoever gives options, a command line, a link, a recipe or a page, has them read and checked
//! here, and so a bad value is refused with the same words everywhere. The rows of a flow are in
//! `option/rows.rs`; others give theirs by [`Options`].

pub mod error;
pub mod kind;
mod rows;
pub mod value;

pub use error::{Allowed, OptionError, nearest};
pub use kind::{Kind, Range};
pub(crate) use rows::row;
pub use value::Value;

use super::options::{FlowOptions, Goal, Remeshing, Scheme};
use super::spec::FlowName;
use crate::message::{Message, Say};
use kind::{id_of, ids, named};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::collections::BTreeMap;

/// Where an option stands among the others, in forms and in help.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "camelCase")]
pub enum Group {
    /// Which flow, and how faithful to its paper.
    Flow,
    /// What moves and what is held.
    Surface,
    /// What the flow minimises, and what it keeps.
    Functional,
    /// How large a step is.
    Step,
    /// How a step is taken.
    Method,
    /// When a run ends.
    Budget,
    /// How it is shown.
    Display,
}

/// What reads an option; what none of this holds for ignores it.
#[derive(Clone, Copy, Debug)]
pub struct ReadBy {
    /// These flows …
    pub flows: &'static [FlowName],
    /// … under this scheme only …
    pub scheme: Option<Scheme>,
    /// … and with this goal only, where a flow has goals, …
    pub goal: Option<Goal>,
    /// … and with these passes of remeshing only, where a flow has some.
    pub remesh: Option<Remeshing>,
}

impl ReadBy {
    /// A command of its own, whatever flow runs.
    pub const COMMAND: Self = Self::flows(&[]);

    /// Flows, whatever their scheme and goal.
    pub const fn flows(flows: &'static [FlowName]) -> Self {
        Self {
            flows,
            scheme: None,
            goal: None,
            remesh: None,
        }
    }

    /// Under this scheme only.
    pub const fn scheme(self, scheme: Scheme) -> Self {
        Self {
            scheme: Some(scheme),
            ..self
        }
    }

    /// With this goal only.
    pub const fn goal(self, goal: Goal) -> Self {
        Self {
            goal: Some(goal),
            ..self
        }
    }

    /// With these passes of remeshing only.
    pub const fn remesh(self, remesh: Remeshing) -> Self {
        Self {
            remesh: Some(remesh),
            ..self
        }
    }

    /// Refuses an option that what runs does not read.
    fn check(&self, name: &'static str, options: &FlowOptions) -> Result<(), OptionError> {
        let is_read = self.flows.contains(&options.flow)
            && self.scheme.is_none_or(|scheme| scheme == options.scheme)
            && self.goal.is_none_or(|goal| goal == options.goal);
        if !is_read {
            return Err(OptionError::UnreadOption {
                name,
                flows: self.flows.iter().map(|flow| flow.id()).collect(),
                scheme: self.scheme.map_or("any", |scheme| id_of(&scheme)),
                goal: self.goal.map_or("any", |goal| id_of(&goal)),
            });
        }
        match self.remesh {
            Some(remesh) if remesh != options.remeshing() => Err(OptionError::LoneOption {
                name,
                other: "remesh",
                value: id_of(&remesh),
            }),
            _ => Ok(()),
        }
    }
}

/// One option of `S`.
pub struct Row<S: 'static> {
    /// Of the field, in recipes and links.
    pub name: &'static str,
    /// On the command line, without dashes.
    pub flag: &'static str,
    /// What it may be.
    pub kind: Kind,
    /// The word for `null`, where the option may be left to the program or be no limit.
    pub absent: Option<&'static str>,
    /// Its default before, where that is another by now: what a record means that does not say it.
    pub was: Option<&'static str>,
    /// Words that stand for themselves beside the kind.
    pub words: &'static [&'static str],
    /// Of a number, as text; empty where it has none.
    pub unit: &'static str,
    /// Where it stands.
    pub group: Group,
    /// What reads it.
    pub read_by: ReadBy,
    /// Whether its value means nothing to another flow, so that a change of flow takes it back.
    pub is_of_one_flow: bool,
    /// The field's value.
    pub get: fn(&S) -> Value,
    /// Writes a value that was checked; false for one that does not fit.
    pub set: fn(&mut S, &Value) -> bool,
}

impl<S> Row<S> {
    /// The same, of which `word` is `null`.
    pub const fn or(self, word: &'static str) -> Self {
        Self {
            absent: Some(word),
            ..self
        }
    }

    /// The same, whose default was another before.
    pub const fn was(self, word: &'static str) -> Self {
        Self {
            was: Some(word),
            ..self
        }
    }

    /// The same, of which these words stand for themselves.
    pub const fn words(self, words: &'static [&'static str]) -> Self {
        Self { words, ..self }
    }

    /// The same, of which a change of flow takes the value back.
    pub const fn of_one_flow(self) -> Self {
        Self {
            is_of_one_flow: true,
            ..self
        }
    }

    /// A text as a value; other values are what they are.
    pub fn read(&self, value: &Value) -> Value {
        match value {
            Value::Text(text) if Some(text.as_str()) == self.absent => Value::Absent,
            Value::Text(text) if self.words.contains(&text.as_str()) => value.clone(),
            Value::Text(text) => self.kind.read(text),
            other => other.clone(),
        }
    }

    /// The allowed values.
    pub fn allowed(&self) -> Allowed {
        let words = self.absent.iter().chain(self.words).rev();
        words.fold(self.kind.allowed(), |allowed, word| Allowed::WordOr {
            word,
            allowed: allowed.message(),
        })
    }

    /// Refuses what it cannot be.
    ///
    /// # Errors
    /// [`OptionError::BadOption`].
    pub fn check(&self, value: &Value) -> Result<(), OptionError> {
        let is_word = match value {
            Value::Absent => self.absent.is_some(),
            Value::Text(text) => self.words.contains(&text.as_str()),
            _ => false,
        };
        if is_word || self.kind.holds(value) {
            return Ok(());
        }
        Err(OptionError::BadOption {
            name: self.name,
            value: value.to_string(),
            allowed: self.allowed(),
        })
    }
}

/// What has a row for each of its fields.
pub trait Options: Default + 'static {
    /// The rows, in the order of forms and help.
    const ROWS: &'static [Row<Self>];
}

/// Values by the names of their options.
pub type Values = BTreeMap<String, Value>;

/// The row of a name.
///
/// # Errors
/// [`OptionError::UnknownOption`].
pub fn find<S: Options>(name: &str) -> Result<&'static Row<S>, OptionError> {
    let found = S::ROWS.iter().find(|row| row.name == name);
    found.ok_or_else(|| unknown(name, S::ROWS.iter().map(|row| (row.name, row.flag))))
}

/// The refusal of a name that is none of these; each is also called by its flag.
pub fn unknown<'a>(
    name: &str,
    known: impl Iterator<Item = (&'a str, &'a str)> + Clone,
) -> OptionError {
    let near = nearest(name, known.clone().flat_map(|(name, flag)| [name, flag]));
    let near = near.and_then(|near| known.clone().find(|(a, b)| *a == near || *b == near));
    OptionError::UnknownOption {
        name: name.chars().take(60).collect(),
        near: near.map_or("none", |(name, _)| name).into(),
        flag: near.map_or("none", |(_, flag)| flag).into(),
    }
}

/// The options that values amount to; those not given are the default.
///
/// # Errors
/// The first that there is not, or that has a value it cannot have.
pub fn options_of<S: Options>(values: &Values) -> Result<S, OptionError> {
    let mut options = S::default();
    for (name, value) in values {
        let row = find::<S>(name)?;
        row.check(value)?;
        if !(row.set)(&mut options, value) {
            return Err(OptionError::BadOption {
                name: row.name,
                value: value.to_string(),
                allowed: row.allowed(),
            });
        }
    }
    Ok(options)
}

impl Row<FlowOptions> {
    /// Whether a record of options must say this one though it has its default.
    pub fn must_be_said(&self, options: &FlowOptions) -> bool {
        self.was.is_some() && self.read_by.flows.contains(&options.flow)
    }
}

/// The defaults as they were, where they are others by now.
pub fn before() -> FlowOptions {
    let mut options = FlowOptions::default();
    for row in FlowOptions::ROWS {
        if let Some(was) = row.was {
            (row.set)(&mut options, &row.read(&Value::Text(was.into())));
        }
    }
    options
}

/// Adds to a record of options what it leaves out and meant by that: what options of its time
/// were, where defaults are others by now. What says no flow was not written by this program, and
/// means the defaults of now.
pub fn as_meant(record: &mut Values, of_its_time: &FlowOptions) {
    let flow = record.get("flow").and_then(FlowName::of);
    for row in FlowOptions::ROWS.iter().filter(|row| row.was.is_some()) {
        if flow.is_some_and(|flow| row.read_by.flows.contains(&flow)) {
            let value = || (row.get)(of_its_time);
            record.entry(row.name.into()).or_insert_with(value);
        }
    }
}

/// Reads the texts among `words` and checks all values: what a link or a command line gave.
///
/// # Errors
/// As [`options_of`].
pub fn read<S: Options>(words: &Values) -> Result<Values, OptionError> {
    let mut values = Values::new();
    for (name, word) in words {
        let row = find::<S>(name)?;
        let value = row.read(word);
        row.check(&value)?;
        values.insert(name.clone(), value);
    }
    Ok(values)
}

/// Checks every field.
///
/// # Errors
/// [`OptionError::BadOption`] of the first that cannot be.
pub fn check<S: Options>(options: &S) -> Result<(), OptionError> {
    let mut rows = S::ROWS.iter();
    rows.try_for_each(|row| row.check(&(row.get)(options)))
}

impl FlowOptions {
    /// Refuses values that make no sense.
    ///
    /// # Errors
    /// [`OptionError::BadOption`] naming the option.
    pub fn check(&self) -> Result<(), OptionError> {
        check(self)
    }
}

/// [`read`], and refuses what would change nothing: on a command line that is a mistake.
///
/// # Errors
/// As [`read`]; [`OptionError::UnreadOption`], [`OptionError::LoneOption`],
/// [`OptionError::ConflictingOptions`].
pub fn read_strictly(words: &Values) -> Result<Values, OptionError> {
    let values = read::<FlowOptions>(words)?;
    let options = options_of::<FlowOptions>(&values)?;
    for name in values.keys() {
        let row = find::<FlowOptions>(name)?;
        row.read_by.check(row.name, &options)?;
    }
    let both = |a, b| [a, b].iter().all(|name| values.contains_key(*name));
    let same = [("dt", "tau"), ("maxSteps", "maxSeconds")];
    match same.into_iter().find(|(a, b)| both(*a, *b)) {
        Some((first, second)) => Err(OptionError::ConflictingOptions { first, second }),
        None => Ok(values),
    }
}

/// A field that values can be written into.
pub trait Field: Sized {
    /// As a value.
    fn value(&self) -> Value;
    /// From a value, where it fits.
    fn of(value: &Value) -> Option<Self>;
}

impl Field for f64 {
    fn value(&self) -> Value {
        Value::Number(*self)
    }

    fn of(value: &Value) -> Option<Self> {
        match value {
            Value::Number(x) => Some(*x),
            _ => None,
        }
    }
}

/// Counts, exact up to 2⁵³.
impl Field for usize {
    fn value(&self) -> Value {
        Value::Number(*self as f64)
    }

    fn of(value: &Value) -> Option<Self> {
        f64::of(value).filter(|x| *x >= 0.0).map(|x| x as Self)
    }
}

impl Field for u32 {
    fn value(&self) -> Value {
        Value::Number(f64::from(*self))
    }

    fn of(value: &Value) -> Option<Self> {
        f64::of(value).filter(|x| *x >= 0.0).map(|x| x as Self)
    }
}

impl Field for bool {
    fn value(&self) -> Value {
        Value::Switch(*self)
    }

    fn of(value: &Value) -> Option<Self> {
        match value {
            Value::Switch(x) => Some(*x),
            _ => None,
        }
    }
}

/// A name out of a list that is no enum.
impl Field for String {
    fn value(&self) -> Value {
        Value::Text(self.clone())
    }

    fn of(value: &Value) -> Option<Self> {
        match value {
            Value::Text(text) => Some(text.clone()),
            _ => None,
        }
    }
}

impl<T: Field> Field for Option<T> {
    fn value(&self) -> Value {
        self.as_ref().map_or(Value::Absent, T::value)
    }

    fn of(value: &Value) -> Option<Self> {
        match value {
            Value::Absent => Some(None),
            value => T::of(value).map(Some),
        }
    }
}

impl<T: Field> Field for Vec<T> {
    fn value(&self) -> Value {
        Value::List(self.iter().map(T::value).collect())
    }

    fn of(value: &Value) -> Option<Self> {
        match value {
            Value::List(values) => values.iter().map(T::of).collect(),
            _ => None,
        }
    }
}

/// An enum whose names serde knows.
pub trait Named: DeserializeOwned + PartialEq {}

impl<T: Named> Field for T {
    fn value(&self) -> Value {
        Value::Text(id_of(self).into())
    }

    fn of(value: &Value) -> Option<Self> {
        match value {
            Value::Text(id) => named(id),
            _ => None,
        }
    }
}

impl FlowName {
    /// As it is called in recipes, links and on the command line.
    pub fn id(self) -> &'static str {
        id_of(&self)
    }

    /// What it is called: in the locale files `flow-<id>`.
    pub fn message(self) -> Message {
        Message {
            id: format!("flow-{}", self.id()).into(),
            values: [].into(),
        }
    }

    /// All, in the order of menus.
    pub fn all() -> impl Iterator<Item = Self> {
        ids::<Self>().iter().filter_map(|id| named(id))
    }
}
