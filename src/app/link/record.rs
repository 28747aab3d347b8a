//! What was done to a surface, as words of a link: as in a recipe, but of a flow's options only
//! those that are not the default, and selections as regions.

use super::base64;
use super::region;
use super::words::LONGEST;
use crate::app::json;
use crate::app::provenance::{Action, Edit, EditRecord};
use crate::app::recipe::{Node, Reader, RecipeError};
use crate::flow::option::{Options, Row, Value};
use crate::flow::options::FlowOptions;
use crate::order;
use crate::remesh::static_pass::RegulariseOptions;
use serde::ser::{Serialize, Serializer};

/// Options by name, in the order in which a recipe has them.
struct Entries(Vec<(&'static str, Value)>);

impl Serialize for Entries {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

#[derive(serde::Serialize)]
#[serde(rename_all = "camelCase")]
enum LinkAction<'a> {
    Steps(usize),
    Regularise(&'a RegulariseOptions),
    Anew,
    Flow(Entries),
}

#[derive(serde::Serialize)]
struct LinkRecord<'a> {
    flow: Option<Entries>,
    path: Vec<LinkAction<'a>>,
    edit: &'a Edit,
}

/// The rows of options, in the order in which a recipe has them.
fn rows_in_order() -> Vec<&'static Row<FlowOptions>> {
    let recipe = json::compact(&FlowOptions::default());
    let mut rows: Vec<_> = FlowOptions::ROWS.iter().collect();
    order::sort_by_key(&mut rows, |row| recipe.find(&format!("\"{}\":", row.name)));
    rows
}

/// `None` where a selection fits no link.
fn compact(flow: &FlowOptions, room: &mut Reader) -> Option<Entries> {
    let usual = FlowOptions::default();
    let mut entries = Vec::new();
    for row in rows_in_order() {
        let list = match row.name {
            "free" => &flow.free,
            "fixed" => &flow.fixed,
            _ => &None,
        };
        if let Some(list) = list {
            room.select(list.len()).ok()?;
            entries.push((row.name, Value::Text(region::encode(list)?)));
            continue;
        }
        let value = (row.get)(flow);
        if value != (row.get)(&usual) || row.must_be_said(flow) {
            entries.push((row.name, value));
        }
    }
    Some(Entries(entries))
}

fn compact_path<'a>(path: &'a [Action], room: &mut Reader) -> Option<Vec<LinkAction<'a>>> {
    let action = |action: &'a Action| {
        Some(match action {
            Action::Steps(count) => LinkAction::Steps(*count),
            Action::Regularise(settings) => LinkAction::Regularise(settings),
            Action::Anew => LinkAction::Anew,
            Action::Flow(options) => LinkAction::Flow(compact(options, room)?),
        })
    };
    path.iter().map(action).collect()
}

fn encode<T: Serialize>(value: &T) -> Option<String> {
    let text = json::compact(value);
    (base64::length(text.len()) <= LONGEST).then(|| base64::encode(text.as_bytes()))
}

/// `None` where they fit no link. `room` counts what is selected.
pub(super) fn encode_edits(edits: &[EditRecord], room: &mut Reader) -> Option<String> {
    let mut records = Vec::new();
    for EditRecord { flow, path, edit } in edits {
        let flow = match flow {
            Some(flow) => Some(compact(flow, room)?),
            None => None,
        };
        let path = compact_path(path, room)?;
        records.push(LinkRecord { flow, path, edit });
    }
    encode(&records)
}

/// `None` where it fits no link. `room` counts what is selected.
pub(super) fn encode_path(path: &[Action], room: &mut Reader) -> Option<String> {
    encode(&compact_path(path, room)?)
}

fn decode(text: &str) -> Option<serde_json::Value> {
    if text.len() > LONGEST {
        return None;
    }
    serde_json::from_slice(&base64::decode(text)?).ok()
}

/// `None` where the text is not even JSON.
pub(super) fn decode_edits(
    text: &str,
    reader: &mut Reader,
) -> Option<Result<Vec<EditRecord>, RecipeError>> {
    let json = decode(text)?;
    Some(reader.edits(&Node::new(&json, "edits")))
}

/// `None` where the text is not even JSON.
pub(super) fn decode_path(
    text: &str,
    reader: &mut Reader,
) -> Option<Result<Vec<Action>, RecipeError>> {
    let json = decode(text)?;
    Some(reader.path(&Node::new(&json, "path")))
}
