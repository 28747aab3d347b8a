//! What the program says, in no language: an id and values. The words stand in
//! `www/locales/<language>`, where `www/words.js` finds them.

use serde::ser::{Serialize, SerializeStruct, Serializer};
use std::fmt;

/// Something to be said. In JSON `{ id, values }`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Message {
    /// Of the words, which may use each of the values.
    pub id: Box<str>,
    /// By name.
    #[cfg_attr(test, ts(type = "Record<string, unknown>"))]
    pub values: Box<[(&'static str, Value)]>,
}

/// What stands in a sentence.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// Nothing is known.
    None,
    /// As measured: how many digits are shown is up to the words.
    Number(f64),
    /// A name, or what a file or a user wrote.
    Text(String),
    /// A clause that is said in its place.
    Message(Message),
    /// Several of a kind.
    List(Vec<Value>),
}

impl Message {
    /// With the id `group-name`, `name` written in capitals and small letters as Rust's variants
    /// are and here in small letters with hyphens.
    pub fn new(group: &str, name: &str, values: Vec<(&'static str, Value)>) -> Self {
        let mut id = String::from(group);
        for c in name.chars() {
            if c.is_ascii_uppercase() {
                id.push('-');
            }
            id.push(c.to_ascii_lowercase());
        }
        Self {
            id: id.into(),
            values: values.into(),
        }
    }

    /// What can be done about it: a further sentence of the same words.
    #[must_use]
    pub fn hint(mut self) -> Self {
        self.id = (self.id.into_string() + ".hint").into();
        self
    }

    /// The value of that name.
    pub fn value(&self, name: &str) -> Option<&Value> {
        let found = self.values.iter().find(|(known, _)| *known == name);
        found.map(|(_, value)| value)
    }

    /// The value of that name, where it is a number.
    pub fn number(&self, name: &str) -> Option<f64> {
        match self.value(name) {
            Some(Value::Number(number)) => Some(*number),
            _ => None,
        }
    }
}

/// For developers; people read the words.
impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.id)?;
        for (name, value) in self.values.iter() {
            write!(f, " {name}={value}")?;
        }
        Ok(())
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => f.write_str("none"),
            Self::Number(number) => number.fmt(f),
            Self::Text(text) => f.write_str(text),
            Self::Message(message) => write!(f, "({message})"),
            Self::List(values) => values.iter().try_for_each(|value| write!(f, "{value};")),
        }
    }
}

struct Values<'a>(&'a [(&'static str, Value)]);

impl Serialize for Values<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

impl Serialize for Message {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut object = serializer.serialize_struct("Message", 2)?;
        object.serialize_field("id", &self.id)?;
        object.serialize_field("values", &Values(&self.values))?;
        object.end()
    }
}

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::None => serializer.serialize_none(),
            Self::Number(number) => serializer.serialize_f64(*number),
            Self::Text(text) => serializer.serialize_str(text),
            Self::Message(message) => message.serialize(serializer),
            Self::List(values) => serializer.collect_seq(values),
        }
    }
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<u32> for Value {
    fn from(number: u32) -> Self {
        Self::Number(f64::from(number))
    }
}

impl From<usize> for Value {
    fn from(number: usize) -> Self {
        Self::Number(number as f64)
    }
}

impl From<u64> for Value {
    fn from(number: u64) -> Self {
        Self::Number(number as f64)
    }
}

impl From<i64> for Value {
    fn from(number: i64) -> Self {
        Self::Number(number as f64)
    }
}

impl From<String> for Value {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.into())
    }
}

impl From<Message> for Value {
    fn from(message: Message) -> Self {
        Self::Message(message)
    }
}

impl From<[f64; 3]> for Value {
    fn from(numbers: [f64; 3]) -> Self {
        Self::from(numbers.to_vec())
    }
}

impl<T: Into<Self>> From<Vec<T>> for Value {
    fn from(values: Vec<T>) -> Self {
        Self::List(values.into_iter().map(Into::into).collect())
    }
}

impl<T: Into<Self>> From<Box<T>> for Value {
    fn from(value: Box<T>) -> Self {
        (*value).into()
    }
}

impl<T: Into<Self>> From<Option<T>> for Value {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::None, Into::into)
    }
}

/// What has a kind, words, and a hint at what can be done.
pub trait Say {
    /// Name of the variant, or of the one within that says more.
    fn kind(&self) -> &'static str;

    /// The words.
    fn message(&self) -> Message;

    /// What can be done about it; of errors only.
    fn hint(&self) -> Message;
}

/// Declares an enum each variant of which is a message: `enum Name as "group"` with the ids
/// `group-variant` and the fields as values. A variant `Inner(name: Other)` says what another
/// message within says, has its kind and its hint, and is made of it by `?`.
macro_rules! messages {
    (
        $(#[$attribute:meta])*
        pub enum $name:ident as $group:literal {
            $(
                $(#[$note:meta])*
                $variant:ident
                $({ $( $(#[$field_note:meta])* $field:ident : $type:ty ),* $(,)? })?
                $(( $inner:ident : $other:ty ))?
            ),* $(,)?
        }
    ) => {
        $(#[$attribute])*
        pub enum $name {
            $(
                $(#[$note])*
                $variant $({ $( $(#[$field_note])* $field: $type ),* })? $(($other))?
            ),*
        }

        impl $name {
            /// Of every variant its name and those of its values.
            pub const MESSAGES: &'static [(&'static str, &'static [&'static str])] = &[
                $((
                    stringify!($variant),
                    &[$($(stringify!($field)),*)? $(stringify!($inner))?],
                )),*
            ];

            /// What the ids begin with.
            pub const GROUP: &'static str = $group;
        }

        impl $crate::message::Say for $name {
            fn kind(&self) -> &'static str {
                match self {
                    $(
                        Self::$variant { .. } => {
                            $( if let Self::$variant($inner) = self { return $inner.kind(); } )?
                            stringify!($variant)
                        }
                    ),*
                }
            }

            fn message(&self) -> $crate::message::Message {
                let (name, values) = match self {
                    $(
                        Self::$variant $({ $($field),* })? $(($inner))? => (
                            stringify!($variant),
                            vec![
                                $($((
                                    stringify!($field),
                                    <$type as Clone>::clone($field).into(),
                                )),*)?
                                $((stringify!($inner), <$other as Clone>::clone($inner).into()))?
                            ],
                        )
                    ),*
                };
                $crate::message::Message::new($group, name, values)
            }

            fn hint(&self) -> $crate::message::Message {
                $($( if let Self::$variant($inner) = self { return $inner.hint(); } )?)*
                self.message().hint()
            }
        }

        impl From<$name> for $crate::message::Message {
            fn from(said: $name) -> Self {
                $crate::message::Say::message(&said)
            }
        }

        impl From<$name> for $crate::message::Value {
            fn from(said: $name) -> Self {
                Self::Message($crate::message::Say::message(&said))
            }
        }

        impl serde::Serialize for $name {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                $crate::message::Say::message(self).serialize(serializer)
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                $crate::message::Say::message(self).fmt(f)
            }
        }

        impl std::error::Error for $name {}

        #[cfg(test)]
        impl ts_rs::TS for $name {
            type WithoutGenerics = Self;
            type OptionInnerType = Self;

            fn name(config: &ts_rs::Config) -> String {
                <$crate::message::Message as ts_rs::TS>::name(config)
            }

            fn inline(config: &ts_rs::Config) -> String {
                Self::name(config)
            }

            fn visit_generics(visitor: &mut impl ts_rs::TypeVisitor) {
                visitor.visit::<$crate::message::Message>();
            }
        }

        $($(
            impl From<$other> for $name {
                fn from(inner: $other) -> Self {
                    Self::$variant(inner)
                }
            }
        )?)*
    };
}

pub(crate) use messages;

#[cfg(test)]
mod tests {
    use super::*;

    messages! {
        /// Inside.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Reason as "reason" {
            /// Plain.
            NoRoom,
        }
    }

    messages! {
        /// Around it.
        #[derive(Clone, Debug, PartialEq)]
        pub enum Refusal as "refusal" {
            /// With values.
            TooMany {
                /// How many.
                count: usize,
                /// Which.
                names: Vec<&'static str>,
            },
            /// With another.
            Inner(reason: Reason),
        }
    }

    #[test]
    fn a_variant_is_an_id_and_its_fields_are_values() {
        let said = Refusal::TooMany {
            count: 2,
            names: vec!["a", "b"],
        };
        let json = serde_json::to_string(&said.message()).unwrap();
        assert_eq!(
            json,
            r#"{"id":"refusal-too-many","values":{"count":2.0,"names":["a","b"]}}"#
        );
        assert_eq!(said.kind(), "TooMany");
        assert_eq!(&*said.hint().id, "refusal-too-many.hint");
        assert_eq!(said.hint().number("count"), Some(2.0));
        assert_eq!(said.to_string(), "refusal-too-many count=2 names=a;b;");
        let names: [(&str, &[&str]); 2] =
            [("TooMany", &["count", "names"]), ("Inner", &["reason"])];
        assert_eq!(Refusal::MESSAGES, names);
    }

    #[test]
    fn what_is_wrong_within_has_the_kind_and_the_hint() {
        let said = Refusal::from(Reason::NoRoom);
        assert_eq!(
            (said.kind(), &*said.hint().id),
            ("NoRoom", "reason-no-room.hint")
        );
        let json = serde_json::to_string(&said.message()).unwrap();
        assert_eq!(
            json,
            r#"{"id":"refusal-inner","values":{"reason":{"id":"reason-no-room","values":{}}}}"#
        );
    }
}
