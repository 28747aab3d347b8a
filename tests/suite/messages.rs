//! Every message that the crate can give has words in every language, and every word there is
//! has a message.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use umbilic::app::{
    AppError, Label, LinkError, LinkValue, MustBe, Notice, RecipeError, RunNotice, Symptom,
};
use umbilic::flow::option::{Allowed, OptionError};
use umbilic::flow::{Advice, Cause, Clock, FlowError, Reason, Warning};
use umbilic::io::packed::UnpackError;
use umbilic::io::{Expected, Extra, Format, Found, Loss, Oddity, Place, ReadError, WriteError};
use umbilic::linalg::LinalgError;
use umbilic::mesh::shape::{Conflict, ShapeError};
use umbilic::mesh::subdivide::SubdivisionError;
use umbilic::mesh::{MeshError, Repair};
use umbilic::message::{Message, Value};
use umbilic::remesh::adaptive::RemeshError;
use umbilic::remesh::fill::{FillError, FillNotice};
use umbilic::remesh::repair::RepairChange;
use umbilic::remesh::static_pass::RegulariseError;
use umbilic::viewer::error::ViewerError;

/// Variants and the names of their values.
type Messages = &'static [(&'static str, &'static [&'static str])];

/// By language, then by id.
type Words = BTreeMap<String, BTreeSet<String>>;

/// The files whose words are the crate's; those of `page.ftl` are the page's own.
const FILES: [&str; 7] = [
    "app", "files", "flow", "mesh", "recipe", "refusal", "viewer",
];

/// Errors that another one within says more of, with a hint of its own.
const PASSED_ON: [&str; 9] = [
    "fill-linear",
    "fill-mesh",
    "flow-linear",
    "flow-option",
    "link-figure",
    "link-option",
    "link-recipe",
    "recipe-option",
    "regularise-linear",
];

macro_rules! groups {
    ($($name:ident),* $(,)?) => {
        [$(($name::GROUP, $name::MESSAGES)),*]
    };
}

/// What is refused or fails, with a hint at what can be done.
fn errors() -> Vec<(&'static str, Messages)> {
    groups![
        ReadError,
        UnpackError,
        WriteError,
        MeshError,
        SubdivisionError,
        ShapeError,
        LinalgError,
        FillError,
        RegulariseError,
        RemeshError,
        FlowError,
        OptionError,
        AppError,
        RecipeError,
        LinkError,
        ViewerError,
    ]
    .to_vec()
}

fn others() -> Vec<(&'static str, Messages)> {
    groups![
        Place,
        Found,
        Expected,
        Oddity,
        Extra,
        Loss,
        Repair,
        RepairChange,
        Conflict,
        FillNotice,
        Allowed,
        Warning,
        Advice,
        Cause,
        Clock,
        Reason,
        Notice,
        RunNotice,
        Symptom,
        Label,
        MustBe,
        LinkValue,
    ]
    .to_vec()
}

/// Ids, and the values that their words may use.
fn ids() -> Words {
    let mut ids = Words::new();
    let mut add = |groups: Vec<(&str, Messages)>, is_error: bool| {
        for (group, messages) in groups {
            for (variant, names) in messages {
                let values: BTreeSet<String> = names.iter().map(|n| (*n).into()).collect();
                let said = Message::new(group, variant, Vec::new());
                if is_error && !PASSED_ON.contains(&&*said.id) {
                    ids.insert(said.clone().hint().id.into(), values.clone());
                }
                assert_eq!(ids.insert(said.id.to_string(), values), None, "{}", said.id);
            }
        }
    };
    add(errors(), true);
    add(others(), false);
    for format in Format::all() {
        let Value::Message(said) = Value::from(format) else {
            panic!("{format:?} has no words")
        };
        ids.insert(said.id.into(), BTreeSet::new());
    }
    ids
}

/// The words of a language: ids, and the values that they use.
fn words(language: &str) -> Words {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/locales");
    let mut words = Words::new();
    for file in FILES {
        let path = folder.join(language).join(file).with_extension("ftl");
        let text = fs::read_to_string(&path).expect("a file of words");
        let (mut id, mut name) = (String::new(), String::new());
        for line in text.lines().filter(|line| !line.starts_with('#')) {
            let (left, right) = line.split_once(" = ").unwrap_or(("", line));
            if let Some(part) = left.strip_prefix("    .") {
                name = format!("{id}.{part}");
            } else if !left.is_empty() && !left.starts_with([' ', '}']) {
                (id, name) = (left.to_owned(), left.to_owned());
            }
            let used = right.split('$').skip(1);
            let end = |c: char| !(c.is_ascii_alphanumeric() || c == '_');
            let names = used.map(|rest| rest.split(end).next().unwrap_or_default().to_owned());
            words.entry(name.clone()).or_default().extend(names);
        }
    }
    words.remove("");
    words
}

#[test]
fn every_message_has_words_in_every_language_and_no_words_are_left_over() {
    let ids = ids();
    for language in ["en", "de"] {
        let words = words(language);
        let lacking: Vec<_> = ids.keys().filter(|id| !words.contains_key(*id)).collect();
        assert!(lacking.is_empty(), "{language} lacks {lacking:?}");
        let left: Vec<_> = words.keys().filter(|id| !ids.contains_key(*id)).collect();
        assert!(left.is_empty(), "{language} has words of nothing: {left:?}");
        for (id, used) in words {
            assert!(used.is_subset(&ids[&id]), "{language} {id} uses {used:?}");
        }
    }
}

fn rust_sources(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    paths
        .flat_map(|path| match path.is_dir() {
            true => rust_sources(&path),
            false => vec![path],
        })
        .collect()
}

/// A group that this file does not know would have no words.
#[test]
fn every_group_of_messages_is_known_here() {
    let known: BTreeSet<_> = errors()
        .into_iter()
        .chain(others())
        .map(|(g, _)| g)
        .collect();
    let mut declared = BTreeSet::new();
    for file in rust_sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src")) {
        let text = fs::read_to_string(&file).expect("a source");
        let code = text
            .split("#[cfg(test)]")
            .next()
            .unwrap_or_default()
            .to_owned();
        let marked = code
            .lines()
            .filter_map(|line| line.trim().strip_prefix("pub enum "));
        let groups = marked.filter_map(|line| line.split_once(" as \"")?.1.split_once('"'));
        declared.extend(groups.map(|(group, _)| group.to_owned()));
    }
    assert!(declared.len() > 20, "{declared:?}");
    assert_eq!(declared, known.into_iter().map(String::from).collect());
}
