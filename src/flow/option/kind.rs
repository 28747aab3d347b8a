//! What an option may be: its range or its names, read from text and checked.

use super::error::Allowed;
use super::value::Value;
use crate::message::Say;
use serde::Serialize;
use serde::de::value::Error;
use serde::de::{self, DeserializeOwned, Deserializer, IntoDeserializer, Visitor};

/// Numbers between two ends, each belonging to them or not.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Range {
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// The lower end itself is none of them.
    pub low_open: bool,
    /// Whole numbers only.
    pub whole: bool,
    /// A single number outside.
    pub also: Option<f64>,
}

impl Range {
    /// Both ends included.
    pub const fn closed(low: f64, high: f64) -> Self {
        Self {
            low,
            high,
            low_open: false,
            whole: false,
            also: None,
        }
    }

    /// Above 0, up to `high`.
    pub const fn positive(high: f64) -> Self {
        Self {
            low_open: true,
            ..Self::closed(0.0, high)
        }
    }

    /// Whole numbers from `low`, as far as any count goes.
    pub const fn count(low: f64) -> Self {
        Self {
            whole: true,
            ..Self::closed(low, 1e9)
        }
    }

    /// The same up to `high`.
    pub const fn up_to(self, high: f64) -> Self {
        Self { high, ..self }
    }

    /// These and 0.
    pub const fn or_zero(self) -> Self {
        Self {
            also: Some(0.0),
            ..self
        }
    }

    fn holds(&self, x: f64) -> bool {
        let above = if self.low_open {
            x > self.low
        } else {
            x >= self.low
        };
        Some(x) == self.also || above && x <= self.high && (!self.whole || x.fract() == 0.0)
    }
}

impl From<Range> for Allowed {
    fn from(range: Range) -> Self {
        let Range { low, high, .. } = range;
        match (range.also, range.whole, range.low_open) {
            (Some(_), ..) => Self::ZeroOrRange { low, high },
            (None, true, _) => Self::WholeRange { low, high },
            (None, false, true) => Self::Above { low, high },
            (None, false, false) => Self::Range { low, high },
        }
    }
}

/// What an option may be.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// A number.
    Number(Range),
    /// One of some names.
    Choice(fn() -> &'static [&'static str]),
    /// Any of some names, each at most once.
    Set(fn() -> &'static [&'static str]),
    /// Yes or no.
    Switch,
    /// Any number of numbers.
    Numbers(Range),
    /// Vertex numbers, counted from 0.
    Vertices,
}

impl Kind {
    /// One of the names of an enum, as serde writes them.
    pub const fn choice<T: DeserializeOwned>() -> Self {
        Self::Choice(ids::<T>)
    }

    /// Any of the names of an enum.
    pub const fn set<T: DeserializeOwned>() -> Self {
        Self::Set(ids::<T>)
    }

    /// Reads a text; what is none of this kind stays a text, which [`holds`](Self::holds) refuses.
    pub fn read(&self, text: &str) -> Value {
        let list = |read: fn(&str) -> Option<Value>| {
            let parts = text.split(',').map(str::trim);
            parts.map(read).collect::<Option<Vec<_>>>().map(Value::List)
        };
        let value = match self {
            Self::Number(_) => text.trim().parse().ok().map(Value::Number),
            Self::Choice(_) => None,
            Self::Set(_) if text == "none" => Some(Value::List(Vec::new())),
            Self::Set(_) => list(|name| Some(Value::Text(name.into()))),
            Self::Switch => text.parse().ok().map(Value::Switch),
            Self::Numbers(_) | Self::Vertices => {
                list(|number| number.parse().ok().map(Value::Number))
            }
        };
        value.unwrap_or_else(|| Value::Text(text.into()))
    }

    /// Whether a value is one of this kind.
    pub fn holds(&self, value: &Value) -> bool {
        match (self, value) {
            (Self::Number(range), Value::Number(x)) => range.holds(*x),
            (Self::Choice(ids), Value::Text(id)) => ids().contains(&id.as_str()),
            (Self::Set(ids), Value::List(values)) => values.iter().enumerate().all(|(n, value)| {
                let Value::Text(id) = value else { return false };
                ids().contains(&id.as_str()) && !values[..n].contains(value)
            }),
            (Self::Switch, Value::Switch(_)) => true,
            (Self::Numbers(range), Value::List(values)) => values.iter().all(|value| match value {
                Value::Number(x) => range.holds(*x),
                _ => false,
            }),
            (Self::Vertices, Value::List(values)) => values.iter().all(|value| match value {
                Value::Number(x) => *x >= 0.0 && *x <= f64::from(u32::MAX) && x.fract() == 0.0,
                _ => false,
            }),
            _ => false,
        }
    }

    /// The allowed values.
    pub fn allowed(&self) -> Allowed {
        match self {
            Self::Number(range) => (*range).into(),
            Self::Choice(ids) => Allowed::OneOf {
                names: ids().to_vec(),
            },
            Self::Set(ids) => Allowed::AnyOf {
                names: ids().to_vec(),
            },
            Self::Switch => Allowed::Switch,
            Self::Numbers(range) => Allowed::SeveralOf {
                allowed: Allowed::from(*range).message(),
            },
            Self::Vertices => Allowed::Vertices,
        }
    }
}

/// The names of an enum, in its order: what its own reader says that it knows.
pub fn ids<T: DeserializeOwned>() -> &'static [&'static str] {
    let mut names: &'static [&'static str] = &[];
    // It always fails, after it has been told the names.
    let _ = T::deserialize(Names(&mut names));
    names
}

/// The value of that name.
pub fn named<T: DeserializeOwned>(id: &str) -> Option<T> {
    let reader: de::value::StrDeserializer<'_, Error> = id.into_deserializer();
    T::deserialize(reader).ok()
}

/// The name of a value; empty for one that has none.
pub fn id_of<T: DeserializeOwned + PartialEq>(value: &T) -> &'static str {
    let found = ids::<T>()
        .iter()
        .find(|id| named(id).as_ref() == Some(value));
    found.copied().unwrap_or_default()
}

struct Names<'a>(&'a mut &'static [&'static str]);

impl<'de> Deserializer<'de> for Names<'_> {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, _: V) -> Result<V::Value, Error> {
        Err(de::Error::custom("no enum"))
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        names: &'static [&'static str],
        _: V,
    ) -> Result<V::Value, Error> {
        *self.0 = names;
        Err(de::Error::custom("names only"))
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 u8 u16 u32 u64 f32 f64 char str string bytes byte_buf option unit
        unit_struct newtype_struct seq tuple tuple_struct map struct identifier ignored_any
    }
}
