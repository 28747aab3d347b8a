//! 3MF: the model of a package, whose zip was unpacked before. Objects are meshes or are made of
//! others; the list of what to build puts them in place.
//!
//! Source: "3D Manufacturing Format, Core Specification" 1.3, and for parts in other files its
//! Production Extension 1.1. A package of several model files is read as these files after each
//! other, each after an instruction `<?model PATH?>`.

use std::collections::BTreeMap;
use std::ops::Range;

use glam::{DAffine3, DMat3, DVec3};

use super::assembly::Assembly;
use super::budget::Budget;
use super::placed::{COPIES, turned};
use super::text::{parse_float, parse_integer};
use super::xml::{Event, Tag, Xml};
use super::{Expected, Extra, Format, Found, Oddity, Place, Read, ReadError};

/// Objects within objects; a file that goes deeper goes in circles.
const DEEPEST: usize = 32;

/// Which file of a package, and which object of it.
type Key<'a> = (&'a [u8], &'a [u8]);

/// An object put in place.
struct Component<'a> {
    key: Key<'a>,
    transform: DAffine3,
    place: Place,
}

struct Object<'a> {
    place: Place,
    positions: Range<usize>,
    triangles: Range<usize>,
    components: Vec<Component<'a>>,
}

/// All objects, and what to build of them.
#[derive(Default)]
struct Model<'a> {
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    objects: BTreeMap<Key<'a>, Object<'a>>,
    build: Vec<Component<'a>>,
}

/// Reads the model of a 3MF package.
pub(super) fn read(bytes: &[u8]) -> Result<Read, ReadError> {
    let mut xml = Xml::new(Format::ThreeMf, bytes);
    let mut model = Model::default();
    let mut file: &[u8] = b"";
    let mut open: Option<Key<'_>> = None;
    let mut colours = false;
    let mut texture = false;
    let mut first_file = None;
    let mut has_list = false;
    while let Some(event) = xml.next()? {
        let tag = match event {
            Event::Instruction(text) => {
                if let Some(path) = text.strip_prefix(b"model ") {
                    file = path.trim_ascii();
                }
                continue;
            }
            Event::End(b"object") => {
                open = None;
                continue;
            }
            Event::End(b"build") => {
                has_list = true;
                continue;
            }
            Event::Start(tag) => tag,
            _ => continue,
        };
        let object = open.and_then(|key| model.objects.get_mut(&key));
        match (tag.name, object) {
            (b"object", _) => {
                let key = (file, tag.need("id")?);
                open = Some(key);
                let (p, t) = (model.positions.len(), model.triangles.len());
                let object = Object {
                    place: tag.place,
                    positions: p..p,
                    triangles: t..t,
                    components: Vec::new(),
                };
                model.objects.insert(key, object);
            }
            (b"vertex", Some(object)) => {
                let number = |name| tag.number(name, parse_float);
                let position = DVec3::new(number("x")?, number("y")?, number("z")?);
                if !position.is_finite() {
                    let (number, place) = (object.positions.len() + 1, tag.place);
                    return Err(ReadError::NonFiniteVertex { number, place });
                }
                model.positions.push(position);
                object.positions.end += 1;
            }
            (b"triangle", Some(object)) => {
                let corner = |name| vertex(&tag, name, object.positions.len());
                model
                    .triangles
                    .push([corner("v1")?, corner("v2")?, corner("v3")?]);
                object.triangles.end += 1;
            }
            (b"component", Some(object)) => object.components.push(component(&tag, file)?),
            // Only the first file says what to build; of others it says how they look alone.
            (b"item", _) if *first_file.get_or_insert(file) == file => {
                model.build.push(component(&tag, file)?);
            }
            (b"colorgroup" | b"basematerials", _) => colours = true,
            (b"texture2d", _) => texture = true,
            _ => {}
        }
    }
    let is_built = !model.build.is_empty();
    if !is_built {
        if !has_list {
            return Err(xml.error(None, "build"));
        }
        model.build = model.alone();
    }
    let mut assembly = Assembly::new();
    let mut budget = Budget::new(bytes, COPIES);
    for item in &model.build {
        model.place(
            item,
            &DAffine3::IDENTITY,
            DEEPEST,
            &mut budget,
            &mut assembly,
        )?;
    }
    let mut read = assembly.finish(Format::ThreeMf)?;
    let extra = [
        (Extra::Colours, colours),
        (Extra::TextureCoordinates, texture),
    ];
    read.warnings.extend(Oddity::left_out(&extra));
    if !is_built {
        read.warnings.push(Oddity::NothingToBuild);
    }
    Ok(read)
}

fn vertex(tag: &Tag<'_>, name: &'static str, vertices: usize) -> Result<u32, ReadError> {
    let index = tag.number(name, parse_integer)?;
    match u32::try_from(index) {
        Ok(vertex) if (vertex as usize) < vertices => Ok(vertex),
        _ => Err(ReadError::IndexOutOfRange {
            format: Format::ThreeMf,
            place: tag.place,
            index,
            vertices,
        }),
    }
}

/// An object put in place, of the file at hand unless a path names another.
fn component<'a>(tag: &Tag<'a>, file: &'a [u8]) -> Result<Component<'a>, ReadError> {
    Ok(Component {
        key: (tag.get("path").unwrap_or(file), tag.need("objectid")?),
        transform: match tag.get("transform") {
            Some(text) => {
                let transform = transform(text);
                transform.ok_or_else(|| wrong(tag.place, text, Expected::Transform))?
            }
            None => DAffine3::IDENTITY,
        },
        place: tag.place,
    })
}

/// The rows of a matrix that multiplies from the right: where x, y, z and the origin go.
fn transform(text: &[u8]) -> Option<DAffine3> {
    let mut numbers = [0.0; 12];
    let mut words = text
        .split(u8::is_ascii_whitespace)
        .filter(|word| !word.is_empty());
    for number in &mut numbers {
        *number = parse_float(words.next()?).filter(|x| x.is_finite())?;
    }
    let row = |k: usize| DVec3::new(numbers[k], numbers[k + 1], numbers[k + 2]);
    let matrix = DMat3::from_cols(row(0), row(3), row(6));
    words
        .next()
        .is_none()
        .then(|| DAffine3::from_mat3_translation(matrix, row(9)))
}

fn wrong(place: Place, found: &[u8], expected: Expected) -> ReadError {
    let word = super::text::shortened(found);
    ReadError::syntax(Format::ThreeMf, place, Found::Word { word }, expected)
}

impl<'a> Model<'a> {
    /// Every object that is no part of another, where it is.
    fn alone(&self) -> Vec<Component<'a>> {
        let parts: Vec<_> = self
            .objects
            .values()
            .flat_map(|object| &object.components)
            .map(|part| part.key)
            .collect();
        let alone = self.objects.iter().filter(|(key, _)| !parts.contains(key));
        let placed = alone.map(|(&key, object)| Component {
            key,
            transform: DAffine3::IDENTITY,
            place: object.place,
        });
        placed.collect()
    }

    fn place(
        &self,
        component: &Component<'_>,
        outer: &DAffine3,
        depth: usize,
        budget: &mut Budget,
        assembly: &mut Assembly,
    ) -> Result<(), ReadError> {
        let Component {
            key,
            transform,
            place,
        } = component;
        let object = self.objects.get(key).filter(|_| depth > 0);
        let object = object.ok_or_else(|| wrong(*place, key.1, Expected::ModelObject))?;
        let transform = *outer * *transform;
        budget.part(object.positions.len(), object.triangles.len(), *place)?;
        let first = assembly.n_vertices() as u32;
        for position in &self.positions[object.positions.clone()] {
            assembly.vertex(transform.transform_point3(*position), *place)?;
        }
        for triangle in &self.triangles[object.triangles.clone()] {
            let corners = turned(*triangle, &transform).map(|corner| first + corner);
            assembly.face(&corners, *place)?;
        }
        for component in &object.components {
            self.place(component, &transform, depth - 1, budget, assembly)?;
        }
        Ok(())
    }
}
