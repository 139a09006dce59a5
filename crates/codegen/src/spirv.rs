//! SPIR-V of the self-test kernel, by naga: nobody reads it, and it shows that the WGSL is valid before it is written.

use crate::CodegenError;
use naga::back::spv;
use naga::valid::{Capabilities, ValidationFlags, Validator};

/// The module `wgsl` as SPIR-V 1.3 words in little-endian bytes.
pub(crate) fn module(wgsl: &str) -> Result<Vec<u8>, CodegenError> {
    let shader = |message: String| CodegenError::Shader { message };
    let module = naga::front::wgsl::parse_str(wgsl).map_err(|error| shader(error.emit_to_string(wgsl)))?;
    let info = Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .map_err(|error| shader(error.emit_to_string(wgsl)))?;
    // Names kept, whatever profile this is built in: the default flags depend on it.
    let flags = spv::WriterFlags::DEBUG;
    let options = spv::Options { lang_version: (1, 3), flags, ..spv::Options::default() };
    let words = spv::write_vec(&module, &info, &options, None).map_err(|error| shader(error.to_string()))?;
    Ok(words.iter().flat_map(|word| word.to_le_bytes()).collect())
}
