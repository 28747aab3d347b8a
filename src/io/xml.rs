//! Elements, attributes and text of XML, without copying: as much of it as mesh files use. Names
//! are taken without their prefix; entities are left as they stand, as numbers need none.

use super::text::shortened;
use super::{Expected, Format, Found, Place, ReadError};

/// What stands next in a file.
pub(super) enum Event<'a> {
    /// `<name …>`; of `<name/>` an end follows.
    Start(Tag<'a>),
    /// `</name>`.
    End(&'a [u8]),
    /// Between two tags; never blank.
    Text(&'a [u8]),
    /// `<?name …?>`: what stands in it.
    Instruction(&'a [u8]),
}

/// A tag that opens an element.
#[derive(Clone, Copy)]
pub(super) struct Tag<'a> {
    pub(super) name: &'a [u8],
    attributes: &'a [u8],
    format: Format,
    pub(super) place: Place,
}

impl<'a> Tag<'a> {
    /// The value of an attribute.
    pub(super) fn get(&self, name: &str) -> Option<&'a [u8]> {
        let mut rest = self.attributes;
        loop {
            let (written, after) = rest.split_at(rest.iter().position(|&b| b == b'=')?);
            let quoted = after[1..].trim_ascii_start();
            let quote = *quoted.first()?;
            let length = quoted[1..].iter().position(|&b| b == quote)?;
            if local(written.trim_ascii()) == name.as_bytes() {
                return Some(&quoted[1..=length]);
            }
            rest = &quoted[length + 2..];
        }
    }

    /// The same of one that must be there.
    pub(super) fn need(&self, name: &'static str) -> Result<&'a [u8], ReadError> {
        self.get(name).ok_or_else(|| self.error(None, name))
    }

    /// A number that must be there.
    pub(super) fn number<T>(
        &self,
        name: &'static str,
        parse: fn(&[u8]) -> Option<T>,
    ) -> Result<T, ReadError> {
        let word = self.need(name)?.trim_ascii();
        parse(word).ok_or_else(|| self.error(Some(word), name))
    }

    /// The error that an attribute is not what it should be; `None` that it is missing.
    pub(super) fn error(&self, found: Option<&[u8]>, name: &'static str) -> ReadError {
        let word = shortened(found.unwrap_or(self.name));
        let (found, expected) = (Found::Word { word }, Expected::XmlAttribute { name });
        ReadError::syntax(self.format, self.place, found, expected)
    }
}

/// A name without its prefix.
fn local(name: &[u8]) -> &[u8] {
    let colon = name.iter().rposition(|&b| b == b':');
    &name[colon.map_or(0, |at| at + 1)..]
}

/// The outermost element's name.
pub(super) fn root(bytes: &[u8]) -> Option<&[u8]> {
    let mut xml = Xml::new(Format::Vtp, bytes);
    loop {
        match xml.next() {
            Ok(Some(Event::Start(tag))) => return Some(tag.name),
            Ok(Some(Event::Instruction(_))) => {}
            _ => return None,
        }
    }
}

/// A file that is read from the front.
pub(super) struct Xml<'a> {
    format: Format,
    rest: &'a [u8],
    line: usize,
    /// The element just begun is empty.
    closing: Option<&'a [u8]>,
}

impl<'a> Xml<'a> {
    pub(super) fn new(format: Format, bytes: &'a [u8]) -> Self {
        Self {
            format,
            rest: bytes,
            line: 1,
            closing: None,
        }
    }

    pub(super) fn place(&self) -> Place {
        Place::Line { line: self.line }
    }

    /// The error that something else stands where `name` should.
    pub(super) fn error(&self, found: Option<&[u8]>, name: &'static str) -> ReadError {
        let found = found.map_or(Found::EndOfFile, |word| Found::Word {
            word: shortened(word),
        });
        let expected = Expected::XmlElement { name };
        ReadError::syntax(self.format, self.place(), found, expected)
    }

    fn step(&mut self, count: usize) -> &'a [u8] {
        let (taken, rest) = self.rest.split_at(count.min(self.rest.len()));
        self.line += taken.iter().filter(|&&b| b == b'\n').count();
        self.rest = rest;
        taken
    }

    /// What stands before `end`, and steps past that.
    fn until(&mut self, end: &'static str) -> Result<&'a [u8], ReadError> {
        let found = self
            .rest
            .windows(end.len())
            .position(|at| at == end.as_bytes());
        let Some(found) = found else {
            return Err(self.error(None, end));
        };
        let taken = self.step(found);
        self.step(end.len());
        Ok(taken)
    }

    /// What comes next; `None` at the file's end.
    pub(super) fn next(&mut self) -> Result<Option<Event<'a>>, ReadError> {
        if let Some(name) = self.closing.take() {
            return Ok(Some(Event::End(name)));
        }
        loop {
            let text = self.rest.iter().position(|&b| b == b'<');
            let text = self.step(text.unwrap_or(self.rest.len()));
            if !text.trim_ascii().is_empty() {
                return Ok(Some(Event::Text(text)));
            }
            match self.rest {
                [] => return Ok(None),
                [b'<', b'!', b'-', b'-', ..] => {
                    self.step(4);
                    self.until("-->")?;
                }
                [b'<', b'!', b'[', ..] => {
                    self.step(b"<![CDATA[".len());
                    return self.until("]]>").map(|text| Some(Event::Text(text)));
                }
                [b'<', b'!', ..] => {
                    self.until(">")?;
                }
                [b'<', b'?', ..] => {
                    self.step(2);
                    return self.until("?>").map(|text| Some(Event::Instruction(text)));
                }
                [b'<', b'/', ..] => {
                    self.step(2);
                    let name = self.until(">")?;
                    return Ok(Some(Event::End(local(name.trim_ascii()))));
                }
                _ => return self.start().map(|tag| Some(Event::Start(tag))),
            }
        }
    }

    fn start(&mut self) -> Result<Tag<'a>, ReadError> {
        let place = self.place();
        let mut quote = None;
        // A value may hold what would end the tag.
        let end = self.rest.iter().position(|&byte| match quote {
            Some(open) => {
                if byte == open {
                    quote = None;
                }
                false
            }
            None => {
                if matches!(byte, b'"' | b'\'') {
                    quote = Some(byte);
                }
                byte == b'>'
            }
        });
        let Some(end) = end else {
            return Err(self.error(None, ">"));
        };
        let tag = &self.step(end + 1)[1..end];
        let (tag, is_empty) = match tag.strip_suffix(b"/") {
            Some(tag) => (tag, true),
            None => (tag, false),
        };
        let length = tag.iter().position(u8::is_ascii_whitespace);
        let (name, attributes) = tag.split_at(length.unwrap_or(tag.len()));
        let name = local(name);
        if is_empty {
            self.closing = Some(name);
        }
        Ok(Tag {
            name,
            attributes,
            format: self.format,
            place,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(text: &str) -> Vec<String> {
        let mut xml = Xml::new(Format::Vtp, text.as_bytes());
        let mut told = Vec::new();
        let shown = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        while let Some(event) = xml.next().unwrap() {
            told.push(match event {
                Event::Start(tag) => {
                    let Place::Line { line } = tag.place else {
                        panic!("a line");
                    };
                    let a = tag.get("a").map(shown).unwrap_or_default();
                    format!("+{}@{line} {a}", shown(tag.name))
                }
                Event::End(name) => format!("-{}", shown(name)),
                Event::Text(text) => shown(text.trim_ascii()),
                Event::Instruction(text) => format!("?{}", shown(text)),
            });
        }
        told
    }

    #[test]
    fn elements_attributes_and_text() {
        let text = "<?xml version='1.0'?>\n<!DOCTYPE x>\n<!-- <no> -->\n<p:x b = \"a='0'\" q:a='>'>\n \
                    1 2 <y/><![CDATA[<3>]]></p:x >";
        assert_eq!(
            told(text),
            [
                "?xml version='1.0'",
                "+x@4 >",
                "1 2",
                "+y@5 ",
                "-y",
                "<3>",
                "-x"
            ]
        );
    }

    #[test]
    fn what_is_cut_short_is_refused() {
        for text in ["<x", "<x a='>", "<!-- ", "<![CDATA[ ]]", "</x", "<?x"] {
            let mut xml = Xml::new(Format::Vtp, text.as_bytes());
            assert!(
                matches!(xml.next(), Err(ReadError::Syntax { .. })),
                "{text}"
            );
        }
        let mut xml = Xml::new(Format::Vtp, b"<x a b='1' c=>");
        let Ok(Some(Event::Start(tag))) = xml.next() else {
            panic!("a tag");
        };
        assert_eq!(tag.get("c"), None);
    }
}
