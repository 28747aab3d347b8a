//! The browser sees WGSL only at run time; here every shader is parsed and validated, and
//! the uniform blocks are compared with their mirrors in Rust.

use std::fs;
use std::mem::offset_of;
use std::path::Path;

use naga::back::glsl;
use naga::proc::BoundsCheckPolicies;
use naga::valid::{Capabilities, ValidationFlags, Validator};
use naga::{Module, TypeInner};
use umbilic::viewer::bare::bare;
use umbilic::viewer::frame::{Frame, Line};

/// Source of a shader as the viewer compiles it: with the common part in front.
fn source(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/viewer/gpu");
    let read = |name: &str| {
        let text = fs::read(folder.join(name)).expect("shader exists");
        let (kept, count) = bare::<20_000>(&text);
        String::from_utf8(kept[..count].to_vec()).expect("UTF-8")
    };
    if name == "frame.wgsl" {
        read(name)
    } else {
        read("frame.wgsl") + &read(name)
    }
}

fn parse(name: &str) -> Module {
    let source = source(name);
    naga::front::wgsl::parse_str(&source)
        .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(&source)))
}

/// Name and offset of each member of a uniform block, and the size of the whole.
fn layout(module: &Module, block: &str) -> (Vec<(String, usize)>, usize) {
    let found = module
        .types
        .iter()
        .find(|(_, ty)| ty.name.as_deref() == Some(block));
    let (_, ty) = found.unwrap_or_else(|| panic!("no struct {block}"));
    let TypeInner::Struct { members, span } = &ty.inner else {
        panic!("{block} is no struct")
    };
    let member = |m: &naga::StructMember| (m.name.clone().expect("named"), m.offset as usize);
    (members.iter().map(member).collect(), *span as usize)
}

fn named(members: &[(&str, usize)]) -> Vec<(String, usize)> {
    members
        .iter()
        .map(|&(name, offset)| (name.to_owned(), offset))
        .collect()
}

/// Names of all shaders, that in front of each included.
fn shaders() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/viewer/gpu");
    let files = fs::read_dir(folder).expect("folder exists");
    let names = files.map(|file| {
        file.expect("readable")
            .file_name()
            .into_string()
            .expect("UTF-8")
    });
    let shaders: Vec<String> = names.filter(|name| name.ends_with(".wgsl")).collect();
    assert!(shaders.len() >= 6, "only {shaders:?}");
    shaders
}

#[test]
fn every_shader_is_valid() {
    for name in shaders() {
        let module = parse(&name);
        // No capability beyond the core: what passes here runs on every device.
        Validator::new(ValidationFlags::all(), Capabilities::empty())
            .validate(&module)
            .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(&source(&name))));
    }
}

#[test]
fn shaders_use_nothing_that_webgl2_lacks() {
    for name in shaders() {
        for (_, variable) in parse(&name).global_variables.iter() {
            let is_storage = matches!(variable.space, naga::AddressSpace::Storage { .. });
            assert!(!is_storage, "{name}: storage buffer {:?}", variable.name);
        }
    }
}

/// Every stage of every shader as `viewer-webgl` hands it to the browser.
#[test]
fn shaders_can_be_written_for_webgl2() {
    let options = glsl::Options {
        version: glsl::Version::new_gles(300),
        ..Default::default()
    };
    for name in shaders() {
        let module = parse(&name);
        let info = Validator::new(ValidationFlags::all(), Capabilities::empty())
            .validate(&module)
            .unwrap_or_else(|error| panic!("{name}: {}", error.emit_to_string(&source(&name))));
        for entry in &module.entry_points {
            let stage = glsl::PipelineOptions {
                shader_stage: entry.stage,
                entry_point: entry.name.clone(),
                multiview: None,
            };
            let mut text = String::new();
            glsl::Writer::new(
                &mut text,
                &module,
                &info,
                &options,
                &stage,
                BoundsCheckPolicies::default(),
            )
            .and_then(|mut writer| writer.write())
            .unwrap_or_else(|error| panic!("{name}, {}: {error}", entry.name));
        }
    }
}

#[test]
fn frame_block_is_laid_out_as_in_rust() {
    let expected = named(&[
        ("clip_from_view", offset_of!(Frame, clip_from_view)),
        ("view_from_world", offset_of!(Frame, view_from_world)),
        ("weights", offset_of!(Frame, weights)),
        ("centre", offset_of!(Frame, centre)),
        ("rim", offset_of!(Frame, rim)),
        ("front", offset_of!(Frame, front)),
        ("back", offset_of!(Frame, back)),
        ("marked", offset_of!(Frame, marked)),
        ("wire", offset_of!(Frame, wire)),
        ("floor", offset_of!(Frame, floor)),
        ("floor_u", offset_of!(Frame, floor_u)),
        ("floor_v", offset_of!(Frame, floor_v)),
        ("viewport", offset_of!(Frame, viewport)),
        ("pixel_size", offset_of!(Frame, pixel_size)),
        ("near", offset_of!(Frame, near)),
        ("far", offset_of!(Frame, far)),
        ("field_low", offset_of!(Frame, field_low)),
        ("field_scale", offset_of!(Frame, field_scale)),
        ("field_strength", offset_of!(Frame, field_strength)),
        ("flatness", offset_of!(Frame, flatness)),
        ("grazing", offset_of!(Frame, grazing)),
        ("wire_half_width", offset_of!(Frame, wire_half_width)),
        ("hemisphere", offset_of!(Frame, hemisphere)),
        ("outline", offset_of!(Frame, outline)),
        ("occlusion", offset_of!(Frame, occlusion)),
        ("shadow", offset_of!(Frame, shadow)),
        ("radius", offset_of!(Frame, radius)),
        ("n_steps", offset_of!(Frame, n_steps)),
    ]);
    assert_eq!(
        layout(&parse("frame.wgsl"), "Frame"),
        (expected, size_of::<Frame>())
    );
}

#[test]
fn line_block_is_laid_out_as_in_rust() {
    let expected = named(&[
        ("colour", offset_of!(Line, colour)),
        ("half_width", offset_of!(Line, half_width)),
        ("lift", offset_of!(Line, lift)),
    ]);
    assert_eq!(
        layout(&parse("line.wgsl"), "Line"),
        (expected, size_of::<Line>())
    );
}
