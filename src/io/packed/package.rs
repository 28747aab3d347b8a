//! 3MF packages, and what file systems add to archives.

use super::super::Format;
use super::super::xml::{Event, Xml};
use super::{Content, Part, UnpackError, base};
use std::borrow::Cow;

/// Which of a package's models comes first.
const RELATIONS: &str = "_rels/.rels";
/// Where it is unless the package says so.
const USUAL: &str = "3d/3dmodel.model";

/// What is in an archive: a 3MF package is one file.
pub(super) fn recognised<'a>(name: &str, all: Vec<Part<'a>>) -> Vec<Part<'a>> {
    let (mut relations, others): (Vec<_>, Vec<_>) =
        all.into_iter().partition(|part| part.name == RELATIONS);
    let relations = relations.pop().map(Box::new);
    let is_model = |part: &Part<'_>| {
        let name = part.name.to_ascii_lowercase();
        name.ends_with(".model") && (relations.is_some() || name.starts_with("3d/"))
    };
    let seen = others.into_iter().filter(|part| !is_hidden(&part.name));
    let (models, others): (Vec<_>, Vec<_>) = seen.partition(is_model);
    if models.is_empty() {
        return others;
    }
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    vec![Part {
        name: format!("{stem}.3mf"),
        size: models.iter().map(|part| part.size).sum(),
        content: Content::Package(models, relations),
    }]
}

/// Whether it is what a file system puts beside the files of people.
fn is_hidden(name: &str) -> bool {
    name.starts_with("__MACOSX/") || base(name).starts_with('.')
}

/// The models of a package as one file, the first of them in front; each after an instruction that
/// says its path, by which they name each other.
pub(super) fn joined<'a>(
    models: &[Part<'a>],
    relations: Option<&Part<'a>>,
) -> Result<Cow<'a, [u8]>, UnpackError> {
    if let [only] = models {
        return only.read();
    }
    let first = first_model(relations)?;
    let (front, rest): (Vec<_>, Vec<_>) = models
        .iter()
        .partition(|model| model.name.eq_ignore_ascii_case(&first));
    let mut whole = Vec::new();
    for model in front.into_iter().chain(rest) {
        whole.extend_from_slice(format!("<?model /{}?>\n", model.name).as_bytes());
        whole.extend_from_slice(&model.read()?);
        whole.push(b'\n');
    }
    Ok(Cow::Owned(whole))
}

/// The path of the model that a package begins with.
fn first_model(relations: Option<&Part<'_>>) -> Result<String, UnpackError> {
    let Some(relations) = relations else {
        return Ok(USUAL.to_owned());
    };
    let bytes = relations.read()?;
    let mut xml = Xml::new(Format::ThreeMf, &bytes);
    // What is not well-formed says nothing.
    while let Ok(Some(event)) = xml.next() {
        let Event::Start(tag) = event else { continue };
        let is_model = tag
            .get("Type")
            .is_some_and(|kind| kind.ends_with(b"/3dmodel"));
        if let Some(target) = tag.get("Target").filter(|_| is_model) {
            let target = String::from_utf8_lossy(target);
            return Ok(target.trim_start_matches('/').to_owned());
        }
    }
    Ok(USUAL.to_owned())
}
