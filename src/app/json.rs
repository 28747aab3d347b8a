//! JSON and numbers as JavaScript writes them, so that what this program writes is the same
//! bytes wherever it is written.

use serde::Serialize;
use serde_json::ser::{CompactFormatter, Formatter, PrettyFormatter, Serializer};
use std::io::{Result, Write};

/// A number as `String(x)` has it: the shortest digits that are read back as the same number
/// (ECMA-262, Number::toString).
pub(super) fn number(x: f64) -> String {
    if !x.is_finite() {
        let infinity = if x > 0.0 { "Infinity" } else { "-Infinity" };
        return if x.is_nan() { "NaN" } else { infinity }.into();
    }
    let text = format!("{:e}", x.abs());
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let digits = mantissa.replace('.', "");
    // Where the decimal point stands, counted from before the first digit.
    let point = exponent.parse::<i32>().unwrap_or(0) + 1;
    let count = digits.len() as i32;
    let zeros = |count: i32| "0".repeat(count as usize);
    let body = if digits == "0" {
        digits
    } else if (count..=21).contains(&point) {
        format!("{digits}{}", zeros(point - count))
    } else if (1..=21).contains(&point) {
        let (whole, part) = digits.split_at(point as usize);
        format!("{whole}.{part}")
    } else if (-5..=0).contains(&point) {
        format!("0.{}{digits}", zeros(-point))
    } else {
        let (first, rest) = digits.split_at(1);
        let dot = if rest.is_empty() { "" } else { "." };
        format!("{first}{dot}{rest}e{:+}", point - 1)
    };
    if x < 0.0 { format!("-{body}") } else { body }
}

/// `JSON.stringify(value)`.
pub(super) fn compact<T: Serialize>(value: &T) -> String {
    written(value, CompactFormatter)
}

/// `JSON.stringify(value, null, 1)`.
pub(super) fn indented<T: Serialize>(value: &T) -> String {
    written(value, PrettyFormatter::with_indent(b" "))
}

fn written<T: Serialize, F: Formatter>(value: &T, layout: F) -> String {
    let mut bytes = Vec::new();
    let mut serializer = Serializer::with_formatter(&mut bytes, AsJavaScript(layout));
    // Fails only for maps whose keys are no text, of which nothing here is made.
    let _ = value.serialize(&mut serializer);
    String::from_utf8(bytes).unwrap_or_default()
}

/// A layout with numbers as JavaScript has them.
struct AsJavaScript<F>(F);

macro_rules! as_laid_out {
    ($($method:ident($($flag:ident)?)),*) => {$(
        fn $method<W: ?Sized + Write>(&mut self, writer: &mut W $(, $flag: bool)?) -> Result<()> {
            self.0.$method(writer $(, $flag)?)
        }
    )*};
}

impl<F: Formatter> Formatter for AsJavaScript<F> {
    fn write_f64<W: ?Sized + Write>(&mut self, writer: &mut W, value: f64) -> Result<()> {
        writer.write_all(number(value).as_bytes())
    }

    as_laid_out!(
        begin_array(),
        end_array(),
        begin_array_value(first),
        end_array_value(),
        begin_object(),
        end_object(),
        begin_object_key(first),
        end_object_key(),
        begin_object_value(),
        end_object_value()
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_javascript_writes_them() {
        // What `String(x)` gives in a browser.
        for (x, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (2.0, "2"),
            (-0.5, "-0.5"),
            (1e21, "1e+21"),
            (123_456_789_012_345_680_000.0, "123456789012345680000"),
            (1e-6, "0.000001"),
            (1e-7, "1e-7"),
            (1.5e-7, "1.5e-7"),
            (0.1 + 0.2, "0.30000000000000004"),
            (5e-324, "5e-324"),
            (f64::MAX, "1.7976931348623157e+308"),
            (100.0, "100"),
            (12.5, "12.5"),
            (f64::NEG_INFINITY, "-Infinity"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(number(x), text);
        }
    }

    #[test]
    fn json_is_laid_out_as_javascript_lays_it_out() {
        let value = serde_json::json!({"a": [1.0, 0.5, []], "b": {}, "c": null, "d": "“\n"});
        assert_eq!(
            compact(&value),
            r#"{"a":[1,0.5,[]],"b":{},"c":null,"d":"“\n"}"#
        );
        assert_eq!(
            indented(&value),
            "{\n \"a\": [\n  1,\n  0.5,\n  []\n ],\n \"b\": {},\n \"c\": null,\n \"d\": \"“\\n\"\n}"
        );
    }
}
