//! A link: the scene that the page shows, as words behind the `#` of its address.
//!
//! What is left out has its default, and so a link is short. Everything is read and checked
//! before anything is changed. No text makes this program set aside more than a few times its
//! own size, but for selections of vertices, which are counted first.

mod base;
mod base64;
mod check;
mod error;
mod record;
pub(super) mod region;
mod words;
mod write;

pub use check::{Check, LinkCheck};
pub use write::{Lack, PageScene, WrittenLink};

use super::arrangement::Arrangement;
use super::comparison::{self, Comparison, Lockstep, MOST_PANES, PaneChange};
use super::fault::Fault;
use super::field::FieldName;
use super::provenance::{Action, EditRecord};
use super::recipe::{Estimate, Reader, steps_in};
use super::{Session, library};
use crate::arrays::TypedArray;
use crate::flow::option::{self, Options, Value, Values, as_meant};
use crate::flow::options::FlowOptions;
use crate::flow::spec::FlowName;
use base::{base_of, before_of};
pub use error::{LinkError, LinkValue};
use serde::{Deserialize, Serialize};
use words::{Words, is_among, is_energy, step, whole};

/// Vertices in all selections of a link at most.
const MAX_SELECTED: usize = 1 << 20;
/// Numbers of a camera at most.
const MOST_NUMBERS: usize = 32;
/// Digits of a file's digest that a link has.
const DIGEST: usize = 16;

/// Words that are no options.
const OTHER_WORDS: [&str; 19] = [
    "sample",
    "mesh",
    "hash",
    "figure",
    "edits",
    "path",
    "step",
    "check",
    "version",
    "colour",
    "camera",
    "shading",
    "wireframe",
    "border",
    "cut",
    "scale",
    "panes",
    "lockstep",
    "shown",
];
/// The last of them.
const DIFFERENCE: &str = "difference";

const SHADINGS: &[&str] = &["smooth", "flat"];
const SCALES: &[&str] = &["auto", "linear", "log"];
const YES_OR_NO: &[&str] = &["false", "true"];
const LOCKSTEPS: &[&str] = &["step", "time"];
const LETTERS: [&str; 4] = ["A", "B", "C", "D"];
/// A pane that does as the first.
const SAME: &str = "same";

/// How faces are lit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Shading {
    /// As a smooth surface.
    Smooth,
    /// Each by itself.
    Flat,
}

/// Of the energy's axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Scale {
    /// As suits the numbers.
    Auto,
    /// Equal distances are equal differences.
    Linear,
    /// Equal distances are equal ratios.
    Log,
}

/// How the surface is drawn; what is left out stays as it is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(default)]
pub struct LinkView {
    /// How faces are lit.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub shading: Option<Shading>,
    /// Whether edges are drawn.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub wireframe: Option<bool>,
    /// Whether the boundary is drawn.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub boundary: Option<bool>,
    /// What share of the surface's depth is cut away in front, so that one sees inside; in percent.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub cut: Option<u32>,
    /// Of the energy's axis.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub scale: Option<Scale>,
}

/// A link as it was read.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Link {
    /// Id of a sample; none where the mesh came from a file.
    pub(super) sample: Option<String>,
    /// What the file's mesh is called.
    pub(super) mesh: Option<String>,
    /// The digits that its digest begins with.
    pub(super) hash: Option<String>,
    /// Id of the figure that is shown.
    pub(super) figure: Option<String>,
    /// What made another mesh of it.
    pub(super) edits: Option<Vec<EditRecord>>,
    /// Options that are said.
    pub(super) options: Values,
    /// Of the arrangement too.
    pub(super) arrangement: Values,
    pub(super) colour: Option<FieldName>,
    pub(super) comparison: Option<Comparison>,
    /// Of the half of a film that is shown backwards a negative one.
    pub(super) step: i32,
    /// What leads there, where it is more than steps.
    pub(super) path: Option<Vec<Action>>,
    pub(super) camera: Option<Vec<f32>>,
    pub(super) view: LinkView,
    /// The energy at the step, as it was written.
    pub(super) check: Option<String>,
    /// The version that computed it.
    pub(super) version: Option<String>,
}

/// What a page shows of a link.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct LinkScene {
    /// Id of a sample; null where the mesh came from a file.
    pub sample: Option<String>,
    /// What the file's mesh is called.
    pub mesh: Option<String>,
    /// The first 16 digits of its SHA-256.
    pub hash: Option<String>,
    /// Id of the figure that is shown.
    pub figure: Option<String>,
    /// Whether the mesh was edited, so that it must be prepared.
    pub edited: bool,
    /// Whether what leads to the step must be followed.
    pub has_path: bool,
    /// Options that are said.
    #[cfg_attr(test, ts(type = "Partial<FlowOptions>"))]
    pub options: Values,
    /// How it is arranged, where that is said.
    #[cfg_attr(test, ts(type = "Partial<Arrangement>"))]
    pub arrangement: Values,
    /// What the surface is coloured by; null for nothing.
    pub colour: Option<FieldName>,
    /// Flows beside it.
    pub comparison: Option<Comparison>,
    /// The step that is shown; of the half of a film that is shown backwards a negative one.
    pub step: i32,
    /// As the viewer gave it.
    pub camera: Option<TypedArray<f32>>,
    /// How it is drawn.
    pub view: LinkView,
    /// The energy at the step, as it was written.
    pub check: Option<String>,
    /// The version that computed it.
    pub version: Option<String>,
    /// What it takes to show it.
    pub estimate: Estimate,
    /// The link itself, to be prepared and followed.
    pub text: String,
}

fn is_other(word: &str) -> bool {
    word == DIFFERENCE || OTHER_WORDS.contains(&word)
}

fn is_option(word: &str) -> bool {
    FlowOptions::ROWS.iter().any(|row| row.name == word) || is_of_arrangement(word)
}

fn is_of_arrangement(word: &str) -> bool {
    Arrangement::ROWS.iter().any(|row| row.name == word)
}

impl Link {
    /// Reads the words of a link. In the query of an address (`is_own` is false) there may be
    /// words of others, which are passed over.
    ///
    /// # Errors
    /// The first word that cannot be.
    pub(super) fn read(text: &str, is_own: bool) -> Result<Self, LinkError> {
        let words = Words::read(text, |word| is_own || is_other(word) || is_option(word))?;
        let mut reader = Reader::new(MAX_SELECTED);
        let mut link = Self {
            mesh: words
                .get("mesh")
                .filter(|name| !name.is_empty())
                .map(Into::into),
            ..Self::default()
        };
        link.read_source(&words)?;
        link.read_options(&words, &mut reader)?;
        let step = words.read_as("step", LinkValue::Step, |text| step(text, link.is_film()))?;
        link.step = step.unwrap_or_default();
        link.read_actions(&words, &mut reader)?;
        link.read_view(&words)?;
        link.read_comparison(&words)?;
        let energy = |text: &str| is_energy(text).then(|| text.to_owned());
        link.check = words.read_as("check", LinkValue::Energy, energy)?;
        let version = |text: &str| {
            let fits = (1..=40).contains(&text.len()) && is_among(text, "_.+-");
            fits.then(|| text.to_owned())
        };
        link.version = words.read_as("version", LinkValue::Version, version)?;
        Ok(link)
    }

    /// What it begins with; of a figure without a sample, what the figure shows.
    fn read_source(&mut self, words: &Words) -> Result<(), LinkError> {
        let digest = |text: &str| {
            let is_digit = |byte: u8| byte.is_ascii_digit() || (b'a'..=b'f').contains(&byte);
            let fits = (DIGEST..=64).contains(&text.len()) && text.bytes().all(is_digit);
            fits.then(|| text[..DIGEST].to_owned())
        };
        self.hash = words.read_as("hash", LinkValue::Digest, digest)?;
        let sample = words.read_as("sample", LinkValue::Sample, library::sample)?;
        let figure = words
            .get("figure")
            .map(|id| library::figure(id).ok_or_else(|| LinkError::no_figure(id)));
        let figure = figure.transpose()?;
        self.figure = figure.map(|figure| figure.id.into());
        self.sample = sample.map(|sample| sample.id.into());
        if self.sample.is_some() || self.mesh.is_some() {
            if self.sample.is_some() {
                (self.mesh, self.hash) = (None, None);
            }
            return Ok(());
        }
        self.hash = None;
        let Some(figure) = figure else {
            self.sample = library::SAMPLES.first().map(|sample| sample.id.into());
            return Ok(());
        };
        self.sample = Some(figure.sample.into());
        let base = base_of(Some(figure.sample));
        self.options = comparison::differing(&base, &(figure.options)(base.clone()));
        let rows = Arrangement::ROWS.iter();
        let values = rows.map(|row| (row.name.into(), (row.get)(&figure.arrangement)));
        self.arrangement = values.collect();
        self.colour = figure.colour;
        Ok(())
    }

    fn read_options(&mut self, words: &Words, reader: &mut Reader) -> Result<(), LinkError> {
        let (mut options, mut arrangement) = (Values::new(), Values::new());
        for (word, text) in words.iter().filter(|(word, _)| !is_other(word)) {
            let mut value = Value::Text(text.into());
            if ["free", "fixed"].contains(&word) {
                reader.selection(&mut value)?;
            }
            if is_of_arrangement(word) {
                arrangement.insert(word.into(), value);
            } else {
                options.insert(word.into(), value);
            }
        }
        let mut said = option::read::<FlowOptions>(&options)?;
        as_meant(&mut said, &before_of(self.sample.as_deref()));
        self.options.extend(said);
        self.arrangement
            .extend(option::read::<Arrangement>(&arrangement)?);
        Ok(())
    }

    /// Whether it shows a figure of two halves.
    fn is_film(&self) -> bool {
        let figure = self.figure.as_deref().and_then(library::figure);
        figure.is_some_and(|one| one.back.is_some() && self.sample.as_deref() == Some(one.sample))
    }

    fn read_actions(&mut self, words: &Words, reader: &mut Reader) -> Result<(), LinkError> {
        let edits = words.read_as("edits", LinkValue::Edits, |text| {
            record::decode_edits(text, reader)
        })?;
        self.edits = edits.transpose()?;
        let step = self.step.unsigned_abs() as usize;
        let allowed = LinkValue::Path { step };
        let path = words.read_as("path", allowed.clone(), |text| {
            record::decode_path(text, reader)
        })?;
        self.path = path.transpose()?;
        let total = self.path.as_deref().map(steps_in);
        if total.is_some_and(|total| total as i64 != i64::from(self.step)) {
            return Err(LinkError::bad(
                "path",
                words.get("path").unwrap_or(""),
                allowed,
            ));
        }
        Ok(())
    }

    fn read_view(&mut self, words: &Words) -> Result<(), LinkError> {
        let fields = FieldName::ALL.iter();
        let colour = |text: &str| match text {
            "none" => Some(None),
            text => fields
                .clone()
                .find(|(_, name)| *name == text)
                .map(|(field, _)| Some(*field)),
        };
        const COLOURS: &[&str] = &{
            let mut names = ["none"; FieldName::ALL.len() + 1];
            let mut n = 0;
            while n < FieldName::ALL.len() {
                names[n + 1] = FieldName::ALL[n].1;
                n += 1;
            }
            names
        };
        if let Some(colour) = words.read_as(
            "colour",
            LinkValue::OneOf {
                names: COLOURS.to_vec(),
            },
            colour,
        )? {
            self.colour = colour;
        }
        let camera = |text: &str| {
            let numbers = text.split(',').map(|number| number.parse::<f32>().ok());
            let numbers: Option<Vec<f32>> = numbers.take(MOST_NUMBERS + 1).collect();
            numbers.filter(|all| {
                (2..=MOST_NUMBERS).contains(&all.len()) && all.iter().all(|x| x.is_finite())
            })
        };
        self.camera = words.read_as("camera", LinkValue::Camera, camera)?;
        let yes = |word| Ok::<_, LinkError>(words.choice(word, YES_OR_NO)?.map(|n| n == 1));
        self.view = LinkView {
            shading: (words.choice("shading", SHADINGS)?)
                .map(|n| [Shading::Smooth, Shading::Flat][n]),
            wireframe: yes("wireframe")?,
            boundary: yes("border")?,
            cut: words.read_as("cut", LinkValue::Percent, |text| {
                text.parse().ok().filter(|cut| *cut <= 100)
            })?,
            scale: (words.choice("scale", SCALES)?)
                .map(|n| [Scale::Auto, Scale::Linear, Scale::Log][n]),
        };
        Ok(())
    }

    fn read_comparison(&mut self, words: &Words) -> Result<(), LinkError> {
        let text = words.get("panes").unwrap_or("");
        let panes: Vec<&str> = match text {
            "" => Vec::new(),
            text => text.split('*').take(MOST_PANES + 1).collect(),
        };
        let refused = || LinkError::bad("panes", text, LinkValue::Panes);
        let count = panes.len() + 1;
        let pane = |text: &str| {
            let place = LETTERS.iter().position(|letter| *letter == text);
            place.filter(|place| *place < count)
        };
        let shown = words.read_as("shown", LinkValue::Pane, pane)?;
        let difference = words.read_as(DIFFERENCE, LinkValue::Pane, pane)?;
        let lockstep = words.choice("lockstep", LOCKSTEPS)?;
        if panes.is_empty() {
            return Ok(());
        }
        let first = comparison::options_with(&base_of(self.sample.as_deref()), &self.options)?;
        if panes.len() > MOST_PANES || first.flow == FlowName::Flips {
            return Err(refused());
        }
        let mut all = vec![first.clone()];
        let mut read = Vec::new();
        for text in panes {
            let pane = read_pane(text).ok_or_else(refused)?;
            let mut change = option::read::<FlowOptions>(&pane.change)?;
            as_meant(&mut change, &option::before());
            let options = comparison::options_with(&first, &change)?;
            if options.flow == FlowName::Flips {
                // They change the mesh: nothing can stand beside them.
                return Err(refused());
            }
            all.push(options);
            read.push(PaneChange { change, ..pane });
        }
        let is_by_time = lockstep == Some(1) && comparison::times_agree(&all);
        self.comparison = Some(Comparison {
            panes: read,
            lockstep: [Lockstep::Step, Lockstep::Time][usize::from(is_by_time)],
            shown,
            difference,
        });
        Ok(())
    }

    /// Steps that it takes to show it, those of panes too.
    fn estimate(&self) -> Estimate {
        let steps = match &self.path {
            Some(path) => steps_in(path),
            None => self.step.unsigned_abs().into(),
        };
        let panes = self
            .comparison
            .iter()
            .flat_map(|comparison| &comparison.panes);
        let at = self.step.unsigned_abs() as usize;
        let others = panes.map(|pane| pane.step.unwrap_or(at) as u64);
        let edits = self.edits.as_deref().unwrap_or_default();
        Estimate::of(edits, steps + others.sum::<u64>())
    }

    fn scene(self, text: &str) -> LinkScene {
        LinkScene {
            estimate: self.estimate(),
            edited: self.edits.is_some(),
            has_path: self.path.is_some(),
            sample: self.sample,
            mesh: self.mesh,
            hash: self.hash,
            figure: self.figure,
            options: self.options,
            arrangement: self.arrangement,
            colour: self.colour,
            comparison: self.comparison,
            step: self.step,
            camera: self.camera.map(TypedArray),
            view: self.view,
            check: self.check,
            version: self.version,
            text: text.into(),
        }
    }
}

/// Pairs of option and value, and the step, all joined by `_`, characters that an address need
/// not escape.
fn read_pane(text: &str) -> Option<PaneChange> {
    let mut pane = PaneChange::default();
    if text == SAME {
        return Some(pane);
    }
    let parts: Vec<&str> = text.split('_').collect();
    for pair in parts.chunks(2) {
        let &[word, value] = pair else { return None };
        if word == "step" {
            pane.step = Some(whole(value)?);
        } else {
            let value = Value::Text(value.into());
            pane.change.insert(word.into(), value);
        }
    }
    Some(pane)
}

impl Session {
    /// The scene of a link: its words behind the `#`, or the query of an address (`is_own` is
    /// false), in which there may be words of others.
    ///
    /// # Errors
    /// The first word that cannot be; nothing has changed.
    pub fn read_link(&self, text: &str, is_own: bool) -> Result<LinkScene, Fault> {
        Ok(Link::read(text, is_own)?.scene(text))
    }
}

#[cfg(test)]
mod tests;
