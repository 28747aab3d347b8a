//! glTF 2.0, in one binary file or in JSON with its data in it: triangles of the scene, each mesh
//! where its nodes put it.
//!
//! Source: "glTF 2.0 Specification", Khronos. Positions may be quantised (`KHR_mesh_quantization`);
//! Draco and meshopt are named and refused. The format splits vertices where a
//! normal or a texture has a seam, meshes by material, and, without indices, all triangles: there
//! vertices of a mesh at the same position are joined again.

mod asset;

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use glam::{DAffine3, DMat3, DQuat, DVec3};

use self::asset::{Asset, Numbers};
use super::assembly::{Tally, strip_triangle};
use super::budget::Budget;
use super::json::Json;
use super::placed::{COPIES, turned};
use super::weld::Weld;
use super::{Expected, Extra, Oddity, Place, Read, ReadError, colour};

/// Reads a GLB file.
pub(super) fn read_binary(bytes: &[u8]) -> Result<Read, ReadError> {
    Scene::new(&Asset::of_binary(bytes)?, bytes).read()
}

/// Reads glTF in JSON.
pub(super) fn read_json(bytes: &[u8]) -> Result<Read, ReadError> {
    Scene::new(&Asset::of_json(bytes)?, bytes).read()
}

/// A scene on its way into one mesh.
struct Scene<'a> {
    asset: &'a Asset<'a>,
    budget: Budget,
    weld: Weld,
    /// Vertices met, joined or not.
    met: usize,
    skipped: Tally,
    /// Whether there are colours, texture coordinates and materials.
    extra: [bool; 3],
}

impl<'a> Scene<'a> {
    fn new(asset: &'a Asset<'a>, bytes: &[u8]) -> Self {
        Self {
            asset,
            budget: Budget::new(bytes, COPIES),
            weld: Weld::new(),
            met: 0,
            skipped: Tally::default(),
            extra: [false; 3],
        }
    }

    fn read(mut self) -> Result<Read, ReadError> {
        let nodes = self.asset.list("nodes");
        let meshes = self.asset.list("meshes");
        if nodes.is_empty() {
            for mesh in &meshes {
                self.mesh(*mesh, &DAffine3::IDENTITY)?;
            }
        }
        let mut open: Vec<(usize, DAffine3)> = Vec::new();
        let mut roots = self.roots(&nodes)?;
        roots.reverse();
        open.extend(roots.into_iter().map(|root| (root, DAffine3::IDENTITY)));
        let mut seen = vec![false; nodes.len()];
        while let Some((index, outer)) = open.pop() {
            let node = &nodes[index];
            if seen[index] {
                return Err(self.asset.expected(Some(*node), Expected::SceneNode));
            }
            seen[index] = true;
            let transform = outer * self.transform(*node)?;
            if let Some(mesh) = node.get("mesh") {
                let found = mesh.index().and_then(|mesh| meshes.get(mesh));
                let found = found.ok_or_else(|| self.asset.wrong(Some(mesh), "mesh"))?;
                // What is bent by bones is placed by these.
                let is_placed = node.get("skin").is_none();
                let own = if is_placed {
                    transform
                } else {
                    DAffine3::IDENTITY
                };
                self.mesh(*found, &own)?;
            }
            let before = open.len();
            let children = node.get("children").into_iter().flat_map(Json::items);
            for child in children {
                open.push((self.node(child, &nodes)?, transform));
            }
            open[before..].reverse();
        }
        let format = self.asset.format;
        let joined = self.met - self.weld.assembly.n_vertices();
        let mut read = self.weld.assembly.finish(format)?;
        let other = |(count, first)| Oddity::OtherCells { count, first };
        read.warnings.extend(self.skipped.met().map(other));
        if joined > 0 {
            read.warnings.push(Oddity::SeamsJoined { count: joined });
        }
        let [colours, texture, materials] = self.extra;
        read.warnings.extend(Oddity::left_out(&[
            (Extra::Colours, colours),
            (Extra::TextureCoordinates, texture),
            (Extra::Materials, materials),
        ]));
        Ok(read)
    }

    /// A node by its number.
    fn node(&self, number: Json<'a>, nodes: &[Json<'a>]) -> Result<usize, ReadError> {
        let found = number.index().filter(|&index| index < nodes.len());
        found.ok_or_else(|| self.asset.expected(Some(number), Expected::SceneNode))
    }

    /// Nodes of the scene that is shown; where there is none, those that are in no other.
    fn roots(&self, nodes: &[Json<'a>]) -> Result<Vec<usize>, ReadError> {
        let scenes = self.asset.list("scenes");
        let shown = self.asset.json.get("scene").and_then(Json::index);
        if let Some(scene) = scenes.get(shown.unwrap_or(0)) {
            let shown = scene.get("nodes").into_iter().flat_map(Json::items);
            return shown.map(|number| self.node(number, nodes)).collect();
        }
        let mut is_root = vec![true; nodes.len()];
        for child in nodes
            .iter()
            .filter_map(|node| node.get("children"))
            .flat_map(Json::items)
        {
            if let Some(is_root) = child.index().and_then(|child| is_root.get_mut(child)) {
                *is_root = false;
            }
        }
        Ok((0..nodes.len()).filter(|&node| is_root[node]).collect())
    }

    /// Where a node puts what is in it: a matrix, or a scale, a rotation and a translation.
    fn transform(&self, node: Json<'a>) -> Result<DAffine3, ReadError> {
        if let Some(matrix) = node.get("matrix") {
            let m: [f64; 16] = self.asset.numbers(matrix, "matrix")?;
            let column = |k: usize| DVec3::new(m[4 * k], m[4 * k + 1], m[4 * k + 2]);
            let matrix = DMat3::from_cols(column(0), column(1), column(2));
            return Ok(DAffine3::from_mat3_translation(matrix, column(3)));
        }
        let given = |name, usual: [f64; 3]| match node.get(name) {
            Some(list) => self.asset.numbers(list, name).map(DVec3::from_array),
            None => Ok(DVec3::from_array(usual)),
        };
        let rotation = match node.get("rotation") {
            Some(list) => DQuat::from_array(self.asset.numbers(list, "rotation")?),
            None => DQuat::IDENTITY,
        };
        // One that is not of unit length would scale as well.
        let length = rotation.length();
        let rotation = if length > 0.0 {
            rotation / length
        } else {
            DQuat::IDENTITY
        };
        Ok(DAffine3::from_scale_rotation_translation(
            given("scale", [1.0; 3])?,
            rotation,
            given("translation", [0.0; 3])?,
        ))
    }

    fn mesh(&mut self, mesh: Json<'a>, transform: &DAffine3) -> Result<(), ReadError> {
        let primitives = mesh.get("primitives").into_iter().flat_map(Json::items);
        let primitives: Vec<Json<'a>> = primitives.collect();
        let splits = |(name, _): (&[u8], _)| {
            name == b"NORMAL" || name == b"TANGENT" || name.starts_with(b"TEXCOORD")
        };
        let mut attributes = primitives.iter().filter_map(|one| one.get("attributes"));
        let is_split = primitives.len() > 1
            || attributes.any(|of_one| of_one.members().any(splits))
            || primitives.iter().any(|one| one.get("indices").is_none());
        self.weld.forget();
        // Vertices of an accessor that several primitives share.
        let mut vertices = BTreeMap::new();
        for primitive in primitives {
            let place = self.asset.place(primitive);
            // Also of one that is skipped: many nodes may show it.
            self.budget.part(0, 0, place)?;
            self.note(primitive);
            let mode = primitive.get("mode").map_or(Some(4), Json::index);
            if !matches!(mode, Some(4..=6)) {
                self.skipped.count(place);
                continue;
            }
            let attributes = primitive.get("attributes");
            let Some(accessor) = attributes.and_then(|list| list.get("POSITION")) else {
                self.skipped.count(place);
                continue;
            };
            let key = accessor.index().unwrap_or(usize::MAX);
            let of_accessor = match vertices.entry(key) {
                Entry::Occupied(known) => known.into_mut(),
                Entry::Vacant(free) => {
                    let numbers = self.asset.accessor(accessor, primitive)?;
                    let made = self.positions(&numbers, accessor, transform, is_split)?;
                    self.colours(primitive, &made);
                    free.insert(made)
                }
            };
            self.faces(primitive, mode, of_accessor, transform, place)?;
        }
        Ok(())
    }

    /// Remembers what is left out of a primitive.
    fn note(&mut self, primitive: Json<'a>) {
        let attributes = primitive.get("attributes");
        for (name, _) in attributes.into_iter().flat_map(Json::members) {
            self.extra[0] |= name.starts_with(b"COLOR") && name != b"COLOR_0";
            self.extra[1] |= name.starts_with(b"TEXCOORD");
        }
        self.extra[2] |= primitive.get("material").is_some();
    }

    fn positions(
        &mut self,
        numbers: &Numbers<'_>,
        accessor: Json<'a>,
        transform: &DAffine3,
        is_split: bool,
    ) -> Result<Vec<u32>, ReadError> {
        if numbers.width != 3 {
            let expected = Expected::JsonMember { name: "VEC3" };
            return Err(self.asset.expected(Some(accessor), expected));
        }
        self.budget.part(numbers.count, 0, numbers.place)?;
        let mut vertices = Vec::with_capacity(numbers.count);
        for row in 0..numbers.count {
            let [x, y, z] = [0, 1, 2].map(|axis| numbers.value(row, axis));
            let position = transform.transform_point3(DVec3::new(x, y, z));
            self.met += 1;
            vertices.push(if is_split {
                self.weld.corner(position, numbers.place)?
            } else {
                let vertex = self.weld.assembly.n_vertices() as u32;
                self.weld.assembly.vertex(position, numbers.place)?;
                vertex
            });
        }
        Ok(vertices)
    }

    /// Gives vertices the colours of a primitive, if they can be read: light, in the format.
    fn colours(&mut self, primitive: Json<'a>, vertices: &[u32]) {
        let attributes = primitive.get("attributes");
        let Some(accessor) = attributes.and_then(|list| list.get("COLOR_0")) else {
            return;
        };
        let numbers = self.asset.accessor(accessor, primitive).ok();
        let fitting = |of: &Numbers<'_>| of.count == vertices.len() && matches!(of.width, 3 | 4);
        let Some(numbers) = numbers.filter(fitting) else {
            self.extra[0] = true;
            return;
        };
        for (row, vertex) in vertices.iter().enumerate() {
            let part = |column| match column < numbers.width {
                true => numbers.value(row, column).clamp(0.0, 1.0) as f32,
                false => 1.0,
            };
            let colour = colour::to_screen([0, 1, 2, 3].map(part));
            let assembly = &mut self.weld.assembly;
            assembly.colour(*vertex as usize, colour.map(f64::from));
        }
    }

    fn faces(
        &mut self,
        primitive: Json<'a>,
        mode: Option<usize>,
        vertices: &[u32],
        transform: &DAffine3,
        place: Place,
    ) -> Result<(), ReadError> {
        let indices = primitive.get("indices");
        let indices = indices.map(|indices| self.asset.accessor(indices, primitive));
        let indices = indices.transpose()?;
        let count = indices.as_ref().map_or(vertices.len(), |list| list.count);
        // In strips and fans each makes one.
        self.budget.part(0, count, place)?;
        let mut corners: Vec<u32> = Vec::with_capacity(count);
        for k in 0..count {
            let index = indices.as_ref().map_or(k as f64, |list| list.value(k, 0));
            let found = (index >= 0.0).then(|| vertices.get(index as usize));
            let Some(vertex) = found.flatten() else {
                return Err(ReadError::IndexOutOfRange {
                    format: self.asset.format,
                    place,
                    index: index as i64,
                    vertices: vertices.len(),
                });
            };
            corners.push(*vertex);
            let triangle = match (mode, &corners[..]) {
                (Some(4), &[a, b, c]) => {
                    corners.clear();
                    Some([a, b, c])
                }
                (Some(5), so_far) => strip_triangle(so_far),
                (Some(6), &[a, .., b, c]) => Some([a, b, c]),
                _ => None,
            };
            if let Some(triangle) = triangle {
                let assembly = &mut self.weld.assembly;
                assembly.face(&turned(triangle, transform), place)?;
            }
        }
        Ok(())
    }
}
