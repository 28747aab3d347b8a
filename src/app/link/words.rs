//! The words of a link: `name=value`, joined by `&`, as `URLSearchParams` reads and writes them.

use super::error::{LinkError, LinkValue};
use std::collections::BTreeMap;

/// No word of more characters is written: mail and chat programs cut longer links.
pub(super) const LONGEST: usize = 6000;
/// Bytes of a link at most.
const MAX_BYTES: usize = 64 << 10;

/// Words by name.
pub(super) struct Words(BTreeMap<String, String>);

impl Words {
    /// Reads them.
    ///
    /// # Errors
    /// Links that are too long, and words that `is_ours` says are ours and come twice.
    pub(super) fn read(text: &str, is_ours: impl Fn(&str) -> bool) -> Result<Self, LinkError> {
        let (bytes, most) = (text.len(), MAX_BYTES);
        if bytes > most {
            return Err(LinkError::TooLong { bytes, most });
        }
        let mut words = BTreeMap::new();
        for (word, value) in form_urlencoded::parse(text.as_bytes()) {
            if !is_ours(&word) {
                continue;
            }
            let word = word.into_owned();
            if words.insert(word.clone(), value.into_owned()).is_some() {
                return Err(LinkError::Twice { word });
            }
        }
        Ok(Self(words))
    }

    pub(super) fn get(&self, word: &str) -> Option<&str> {
        self.0.get(word).map(String::as_str)
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = (&str, &str)> {
        self.0.iter().map(|(word, value)| (&**word, &**value))
    }

    /// What `read` makes of a word's value, where there is one.
    ///
    /// # Errors
    /// Where it makes nothing of it.
    pub(super) fn read_as<T>(
        &self,
        word: &'static str,
        allowed: LinkValue,
        read: impl FnOnce(&str) -> Option<T>,
    ) -> Result<Option<T>, LinkError> {
        let Some(value) = self.get(word) else {
            return Ok(None);
        };
        match read(value) {
            Some(found) => Ok(Some(found)),
            None => Err(LinkError::bad(word, value, allowed)),
        }
    }

    /// The number of a word's value among some names.
    ///
    /// # Errors
    /// Where it is none of them.
    pub(super) fn choice(
        &self,
        word: &'static str,
        names: &'static [&'static str],
    ) -> Result<Option<usize>, LinkError> {
        let place = |value: &str| names.iter().position(|name| *name == value);
        self.read_as(
            word,
            LinkValue::OneOf {
                names: names.to_vec(),
            },
            place,
        )
    }
}

/// A link being written.
pub(super) struct Written(form_urlencoded::Serializer<'static, String>);

impl Written {
    pub(super) fn new() -> Self {
        Self(form_urlencoded::Serializer::new(String::new()))
    }

    pub(super) fn set(&mut self, word: &str, value: &str) {
        self.0.append_pair(word, value);
    }

    pub(super) fn set_some(&mut self, word: &str, value: Option<&str>) {
        if let Some(value) = value {
            self.set(word, value);
        }
    }

    /// Commas need no escape after `#`.
    pub(super) fn finish(mut self) -> String {
        self.0.finish().replace("%2C", ",")
    }
}

/// Whether a text is of letters, digits and these characters.
pub(super) fn is_among(text: &str, also: &str) -> bool {
    let fits = |byte: u8| byte.is_ascii_alphanumeric() || also.as_bytes().contains(&byte);
    text.bytes().all(fits)
}

/// A step; in the half of a film that is shown backwards a negative one.
pub(super) fn step(text: &str, is_film: bool) -> Option<i32> {
    let step = |text: &str| i32::try_from(whole(text)?).ok();
    match text.strip_prefix('-').filter(|_| is_film) {
        Some(text) => step(text).map(|step| -step),
        None => step(text),
    }
}

/// A number of at most seven digits.
pub(super) fn whole(text: &str) -> Option<usize> {
    let is_short = (1..=7).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_digit());
    text.parse().ok().filter(|_| is_short)
}

/// Whether a text is an energy as links have it.
pub(super) fn is_energy(text: &str) -> bool {
    let digits = text.bytes().any(|byte| byte.is_ascii_digit());
    let is_number = text.parse().is_ok_and(f64::is_finite);
    digits && text.len() < 30 && is_among(text, "+-.") && is_number
}
