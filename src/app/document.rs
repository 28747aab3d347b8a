//! The mesh a session works on, as loaded and as flowed.

use super::colours::Colours;
use super::fault::Fault;
use super::lineage::Lineage;
use super::message::Notice;
use super::numbers::{Numbers, first_of};
use super::readings::Info;
use super::repairs::{Memo, Mended, RepairItem, gap_left, preview};
use crate::geometry::frame::Frame;
use crate::geometry::measure;
use crate::geometry::quality::flat_triangles;
use crate::geometry::upright::stands_along_z;
use crate::interrupt;
use crate::io::Read;
use crate::mesh::shape::{Sample, Up};
use crate::mesh::{self, Built, HalfedgeMesh};
use crate::message::{Message, Say};
use crate::operator::Elements;
use glam::DVec3;
use std::rc::Rc;

/// Edges below this share of the mean are worth a warning: such a pair of vertices never
/// separates, the flow being nearly normal there.
const NEARLY_COINCIDENT: f64 = 1e-6;

/// A loaded mesh: connectivity as in the file, a triangulated copy, positions.
#[derive(Clone)]
pub(super) struct Document {
    /// Base name without extension.
    pub(super) name: String,
    /// Faces as in the file, of any degree.
    pub(super) polygons: Rc<HalfedgeMesh>,
    /// The same vertices with triangles only.
    pub(super) triangles: Rc<HalfedgeMesh>,
    /// Where the file's coordinates lie.
    pub(super) frame: Frame,
    /// Positions at step 0, in the frame.
    pub(super) start: Vec<DVec3>,
    /// What the file gives its vertices.
    pub(super) colours: Colours,
    /// Which meshes it came of.
    pub(super) lineage: Rc<Lineage>,
    /// How its vertices and faces are numbered.
    pub(super) numbers: Numbers,
    /// What was repaired, and is to be known of it.
    pub(super) warnings: Vec<Message>,
    /// What of that was done when the file was opened.
    pub(super) opened: Vec<RepairItem>,
    /// What a repair changed to make this of what was there before.
    pub(super) repaired: Vec<RepairItem>,
    /// What a repair would make of it, as far as that is known.
    pub(super) mended: Memo,
    /// Vertices to hold or to move, of a sample that suggests them.
    pub(super) fixed: Option<Vec<u32>>,
    /// See `fixed`.
    pub(super) free: Option<Vec<u32>>,
    /// Which way up it is looked at.
    pub(super) up: Up,
}

/// What a file has.
pub(super) enum Opened {
    Surface(Document),
    /// What is no surface, and why.
    Broken(Read, Fault),
}

impl Opened {
    pub(super) fn of(bytes: &[u8], file_name: &str) -> Result<Self, Fault> {
        let read = crate::io::read(bytes, file_name)?;
        let first = first_of(read.format);
        let mut built = match mesh::build(&read.soup) {
            Ok(built) => built,
            Err(error) => return Ok(Self::Broken(read, error.counted_from(first).into())),
        };
        let repairs = built.repairs.into_iter();
        built.repairs = repairs.map(|r| r.counted_from(first)).collect();
        let warnings = read.warnings.into_iter().map(Message::from).collect();
        let colours = Colours::of(&read.soup, &built.soup_vertex);
        let numbers = Numbers::of(&read.soup, first, &built);
        let document = Document::of_built(stem(file_name), built, warnings)?.upright();
        Ok(Self::Surface(Document {
            colours,
            numbers,
            ..document
        }))
    }
}

impl Document {
    /// From a file that is no surface until it is repaired.
    pub(super) fn from_broken(read: Read, mended: Mended, file_name: &str) -> Result<Self, Fault> {
        let Mended { built, items, were } = mended;
        let mut warnings: Vec<Message> = read.warnings.into_iter().map(Message::from).collect();
        warnings.extend(items.iter().map(|item| item.message.clone()));
        let told = Built {
            repairs: Vec::new(),
            ..built
        };
        let document = Self::of_built(stem(file_name), told, warnings)?.upright();
        Ok(Self {
            repaired: items,
            colours: Colours::of(&read.soup, &were),
            numbers: Numbers {
                first: first_of(read.format),
                ..document.numbers
            },
            ..document
        })
    }

    /// As a file's surface is looked at: files do not say which way is up.
    fn upright(self) -> Self {
        let stands = stands_along_z(&self.triangles, &self.start);
        let up = if stands { Up::Z } else { Up::Y };
        Self { up, ..self }
    }

    /// From a sample shape.
    pub(super) fn from_sample(name: &str, sample: Sample) -> Result<Self, Fault> {
        let built = match sample.keeps_sides {
            true => mesh::build_as_given(&sample.soup)?,
            false => mesh::build(&sample.soup)?,
        };
        let document = Self::of_built(name, built, Vec::new())?;
        Ok(Self {
            fixed: sample.fixed,
            free: sample.free,
            up: sample.up,
            ..document
        })
    }

    fn of_built(name: &str, built: Built, mut warnings: Vec<Message>) -> Result<Self, Fault> {
        let opened = RepairItem::opened(&built);
        let Built {
            mesh: polygons,
            positions: mut start,
            repairs,
            ..
        } = built;
        warnings.extend(repairs.into_iter().map(Message::from));
        let polygons = Rc::new(polygons);
        let triangles = triangulated(&polygons, &start)?;
        if !polygons.is_triangular() {
            let larger = polygons
                .faces()
                .filter(|&f| polygons.face_vertices(f).count() > 3)
                .count();
            let is_kept =
                larger == polygons.n_faces() && Elements::convex(&polygons, &start).is_some();
            let polygons = Notice::Polygons {
                count: larger,
                kept: if is_kept { "p-willmore" } else { "none" },
            };
            warnings.push(polygons.into());
        }
        let frame = Frame::of(&start);
        frame.enter(&mut start);
        let document = Self {
            name: name.into(),
            numbers: Numbers::default().plain(&polygons),
            polygons,
            triangles,
            frame,
            start,
            colours: Colours::default(),
            lineage: Rc::default(),
            warnings,
            opened,
            repaired: Vec::new(),
            mended: Memo::default(),
            fixed: None,
            free: None,
            up: Up::default(),
        };
        Ok(document.with_shape_warnings())
    }

    /// With warnings about triangles that are hard on any flow, in the place of earlier ones.
    pub(super) fn with_shape_warnings(mut self) -> Self {
        let ids = [
            Notice::FlatTriangles {
                count: 0,
                face: 0,
                vertices: Vec::new(),
            }
            .message()
            .id,
            Notice::ShortEdges {
                count: 0,
                a: 0,
                b: 0,
            }
            .message()
            .id,
        ];
        self.warnings.retain(|warning| !ids.contains(&warning.id));
        let (mesh, x) = (&self.triangles, &self.start);
        let flat = flat_triangles(mesh, x);
        if let Some(f) = flat.first() {
            let vertices = mesh.triangle(*f).map(|v| v.0).to_vec();
            let notice = Notice::FlatTriangles {
                count: flat.len(),
                face: f.0,
                vertices,
            };
            self.warnings.push(notice.into());
        }
        let shortest = NEARLY_COINCIDENT * measure::mean_edge_length(mesh, x);
        let near = mesh
            .edges()
            .filter(|&e| measure::edge_length(mesh, x, e) < shortest);
        let mut near = near.peekable();
        if let Some(&e) = near.peek() {
            let [a, b] = mesh.ends(e).map(|v| v.0);
            let count = near.count();
            self.warnings
                .push(Notice::ShortEdges { count, a, b }.into());
        }
        self
    }

    /// Diagnosis at the start.
    pub(super) fn info(&self) -> Info {
        let mut repairs = self.opened.clone();
        repairs.extend(preview(&self.mended, &self.polygons, &self.start));
        let gap = gap_left(&self.mended, &self.polygons, &self.start);
        interrupt::pulse();
        Info {
            repairs,
            gap,
            ..Info::of(&self.polygons, &self.triangles, &self.start, &self.warnings)
        }
    }
}

/// What a file's mesh is called.
fn stem(file_name: &str) -> &str {
    let base = file_name.rsplit(['/', '\\']).next().unwrap_or(file_name);
    let name = base.rsplit_once('.').map_or(base, |(stem, _)| stem);
    if name.is_empty() { "mesh" } else { name }
}

/// The same surface with triangles only; the mesh itself if it has no others.
pub(super) fn triangulated(
    polygons: &Rc<HalfedgeMesh>,
    x: &[DVec3],
) -> Result<Rc<HalfedgeMesh>, Fault> {
    if polygons.is_triangular() {
        return Ok(Rc::clone(polygons));
    }
    let cut = polygons.to_soup(x).triangulated();
    Ok(Rc::new(mesh::build_as_given(&cut)?.mesh))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::Value;

    #[test]
    fn triangles_have_the_numbers_of_the_faces_that_they_were_cut_from() {
        let points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 3 0.5 0\n";
        let text = format!("{points}f 1 1 2\nf 1 2 3 4\nf 2 5 7 6 3\nf 5 1 2\n");
        let Ok(Opened::Surface(document)) = Opened::of(text.as_bytes(), "a.obj") else {
            panic!("refused");
        };
        let numbers = |document: &Document| document.numbers.faces.clone().map(|list| list.0);
        // The file's first face has a corner twice and is gone.
        assert_eq!(numbers(&document), Some(vec![1, 1, 2, 2, 2, 3]));
        let flat = document.warnings.iter();
        let flat = flat.filter(|warning| &*warning.id == "notice-flat-triangles");
        let faces: Vec<_> = flat.map(|warning| warning.number("face")).collect();
        assert_eq!(faces, [Some(5.0)]);
        let plain = document.numbers.plain(&document.polygons);
        assert_eq!(plain.faces.map(|list| list.0), Some(vec![0, 0, 1, 1, 1, 2]));
    }

    /// Two triangles that share their third vertex alone.
    #[test]
    fn vertices_of_a_file_are_numbered_as_its_format_numbers_them() {
        let points = ["0 0 0", "1 0 0", "2 1 0", "3 2 0", "2 2 1"];
        let obj = format!("v {}\nf 1 2 3\nf 3 4 5\n", points.join("\nv "));
        let off = format!("OFF\n5 2 0\n{}\n3 0 1 2\n3 2 3 4\n", points.join("\n"));
        for (text, name, number, first) in [(obj, "a.obj", 3_u32, 1.0), (off, "a.off", 2, 0.0)] {
            let Ok(Opened::Surface(document)) = Opened::of(text.as_bytes(), name) else {
                panic!("{name} is refused");
            };
            let split = &document.warnings[0];
            assert_eq!(&*split.id, "repair-split-vertices");
            let numbers = Value::from(vec![number]);
            assert_eq!(split.value("vertices"), Some(&numbers), "{name}");
            assert_eq!(split.number("first"), Some(first), "{name}");
            // What points at the surface counts from 0 whatever the file does.
            assert_eq!(document.opened[0].message, *split);
            assert_eq!(document.opened[0].vertices.0, [2]);
        }
    }
}
