//! The buffers of a glTF file that are in files of their own.

use super::super::base64;
use super::{Part, UnpackError, base};
use percent_encoding::percent_decode_str;
use serde_json::Value;

/// Puts into a glTF file the buffers that are among these files: first those in its folder.
pub(super) fn put_into(
    bytes: Vec<u8>,
    name: &str,
    parts: &[Part<'_>],
) -> Result<Vec<u8>, UnpackError> {
    // Whoever reads it says where it breaks off.
    let Ok(mut scene) = serde_json::from_slice::<Value>(&bytes) else {
        return Ok(bytes);
    };
    let folder = &name[..name.len() - base(name).len()];
    let buffers = scene.get_mut("buffers").and_then(Value::as_array_mut);
    let mut is_changed = false;
    for uri in buffers.into_iter().flatten() {
        let Some(uri) = uri.get_mut("uri") else {
            continue;
        };
        let Some(written) = uri.as_str().filter(|uri| !uri.starts_with("data:")) else {
            continue;
        };
        let meant = percent_decode_str(written).decode_utf8_lossy();
        let beside = format!("{folder}{meant}");
        let near = parts.iter().find(|part| part.name == beside);
        let far = || parts.iter().find(|part| base(&part.name) == base(&meant));
        if let Some(part) = near.or_else(far) {
            let data = base64::encode(&part.read()?);
            *uri = format!("data:application/octet-stream;base64,{data}").into();
            is_changed = true;
        }
    }
    Ok(if is_changed {
        scene.to_string().into_bytes()
    } else {
        bytes
    })
}
