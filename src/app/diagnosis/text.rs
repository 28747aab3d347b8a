//! A sentence with its values, so that it can be put into other languages.

use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt;

/// A sentence in English with `{name}` where a value stands, and the values.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Text {
    /// The sentence.
    pub template: &'static str,
    /// What stands in it.
    pub values: BTreeMap<&'static str, String>,
}

impl Text {
    pub(super) fn new<const N: usize>(
        template: &'static str,
        values: [(&'static str, String); N],
    ) -> Self {
        Self {
            template,
            values: values.into_iter().collect(),
        }
    }

    pub(super) fn plain(template: &'static str) -> Self {
        Self::new(template, [])
    }
}

impl fmt::Display for Text {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut rest = self.template;
        while let Some((before, after)) = rest.split_once('{') {
            f.write_str(before)?;
            let Some((name, after)) = after.split_once('}') else {
                return f.write_str(after);
            };
            f.write_str(self.values.get(name).map_or("", String::as_str))?;
            rest = after;
        }
        f.write_str(rest)
    }
}

/// Three significant digits, for people.
pub(super) fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    if !(1e-3..1e5).contains(&size) {
        return format!("{value:.1e}");
    }
    let digits = (2 - size.log10().floor() as i32).max(0) as usize;
    let text = format!("{value:.digits$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').into()
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_three_digits() {
        for (value, text) in [
            (0.0, "0"),
            (1.0, "1"),
            (0.123_456, "0.123"),
            (12.345, "12.3"),
            (250.0, "250"),
            (1234.5, "1234"),
            (1e-9, "1.0e-9"),
            (9.999, "10"),
        ] {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn values_stand_where_their_names_are() {
        let text = Text::new("{a} and {b}.", [("a", "1".into()), ("b", "2".into())]);
        assert_eq!(text.to_string(), "1 and 2.");
    }
}
