//! Shader languages: to SPIR-V by their own compilers, which is validated, and executed on the device.

use super::library::{Library, Output, Run, floats};
use super::tools::{Scratch, ToolError, words};
use std::path::PathBuf;
use stratiform_gpu::{Gpu, GpuError};

/// Where the drivers start.
const ENTRY: &str = "main";
/// Where DXC is named when it is missing.
pub const DXC: &str = "DXC (libdxcompiler)";

fn validated(scratch: &Scratch, module: &str) -> Result<Vec<u32>, ToolError> {
    scratch.run("spirv-val", &["--target-env", "vulkan1.1", module])?;
    words(&scratch.path(module))
}

/// Validates a binary module for Vulkan.
///
/// # Errors
/// [`ToolError`] if the validator is missing or refuses.
pub fn validate_spirv(bytes: &[u8]) -> Result<Vec<u32>, ToolError> {
    let scratch = Scratch::new()?;
    scratch.write("module.spv", bytes)?;
    validated(&scratch, "module.spv")
}

/// GLSL 450 `text` with its driver as SPIR-V.
///
/// # Errors
/// [`ToolError`] if a tool is missing or refuses.
pub fn glsl_compute(library: &Library, text: &str) -> Result<Vec<u32>, ToolError> {
    let scratch = Scratch::new()?;
    scratch.write("driver.comp", format!("#version 450\n{text}\n{}", library.glsl))?;
    scratch
        .run("glslangValidator", &["-V", "--target-env", "vulkan1.1", "driver.comp", "-o", "driver.spv"])?;
    validated(&scratch, "driver.spv")
}

/// Compiles GLSL `text` of `version` in a fragment shader that calls it.
///
/// # Errors
/// [`ToolError`] if the compiler is missing or refuses.
pub fn glsl_fragment(version: &str, library: &Library, text: &str) -> Result<(), ToolError> {
    let scratch = Scratch::new()?;
    let head = format!("#version {version}\n");
    scratch.write("driver.frag", format!("{head}{text}\n{}", library.fragment))?;
    scratch.run("glslangValidator", &["driver.frag"]).map(drop)
}

/// HLSL `text` with its driver as SPIR-V, by glslang's front end.
///
/// # Errors
/// [`ToolError`] if a tool is missing or refuses.
pub fn hlsl_by_glslang(library: &Library, text: &str) -> Result<Vec<u32>, ToolError> {
    let scratch = Scratch::new()?;
    scratch.write("driver.hlsl", format!("{text}\n{}", library.hlsl))?;
    let arguments = ["-D", "-V", "--target-env", "vulkan1.1", "-S", "comp", "-e", ENTRY];
    scratch.run("glslangValidator", &[&arguments[..], &["driver.hlsl", "-o", "driver.spv"]].concat())?;
    validated(&scratch, "driver.spv")
}

/// HLSL `text` by Microsoft's compiler, warnings denied: alone as a library and with its driver as DXIL, then as SPIR-V.
///
/// # Errors
/// [`ToolError`] if a tool is missing or refuses.
pub fn hlsl_by_dxc(library: &Library, text: &str) -> Result<Vec<u32>, ToolError> {
    let scratch = Scratch::new()?;
    scratch.write("library.hlsl", text)?;
    scratch.write("driver.hlsl", format!("{text}\n{}", library.hlsl))?;
    dxc(&scratch, "library.hlsl", &["-T", "lib_6_3"])?;
    // The driver's bindings are for Vulkan: DXIL has no use for them and warns.
    let kernel = ["-T", "cs_6_0", "-E", ENTRY, "-Wno-ignored-attributes"];
    dxc(&scratch, "driver.hlsl", &kernel)?;
    dxc(&scratch, "driver.hlsl", &[&kernel[..], &["-spirv", "-fspv-target-env=vulkan1.1"]].concat())?;
    validated(&scratch, "compiled")
}

/// Where scripts/test puts the library.
fn dxc_library() -> PathBuf {
    std::env::var_os("STRATIFORM_DXC")
        .map_or_else(|| crate::root().join("target/tools/libdxcompiler.so"), PathBuf::from)
}

fn dxc(scratch: &Scratch, source: &str, options: &[&str]) -> Result<(), ToolError> {
    let library = dxc_library().canonicalize().map_err(|_| ToolError::Missing(DXC))?;
    let script = crate::root().join("scripts/dxc.py").canonicalize()?;
    let (library, script) = (library.to_string_lossy(), script.to_string_lossy());
    let arguments = [&[&*script, &*library, source, "compiled"][..], options, &["-WX"]].concat();
    scratch.run("python3", &arguments).map(drop)
}

/// Workgroups of 64 threads.
#[expect(clippy::cast_possible_truncation, reason = "hundreds of inputs")]
fn groups(run: &Run) -> [u32; 3] {
    [run.count().div_ceil(64) as u32, 1, 1]
}

fn bindings<'a>(run: &'a Run) -> Vec<&'a [u8]> {
    run.table.into_iter().chain([run.input]).collect()
}

/// Runs a driver's validated module on the device.
///
/// # Errors
/// [`GpuError`] if the device refuses.
#[allow(unsafe_code, reason = "the module is validated")]
pub fn run(gpu: &Gpu, run: &Run, module: &[u32]) -> Result<Output, GpuError> {
    // SAFETY: spirv-val has seen the module; the driver stays within its buffers.
    let output = unsafe { gpu.run_spirv(module, ENTRY, &bindings(run), 4 * run.written(), groups(run)) };
    Ok(Output::read(&output?))
}

/// Runs WGSL `text` with its driver on the device.
///
/// # Errors
/// [`GpuError`] if the device refuses.
pub fn run_wgsl(gpu: &Gpu, run: &Run, text: &str) -> Result<Output, GpuError> {
    let module = format!("{}\n{}", run.pasted(text), run.library.wgsl);
    let output = gpu.run(&module, ENTRY, &bindings(run), 4 * run.written(), groups(run))?;
    Ok(Output::read(&output))
}

/// Runs the emitted kernel, which has no count before its values, on the device.
///
/// # Errors
/// [`GpuError`] if the device refuses.
#[allow(unsafe_code, reason = "the module is validated")]
pub fn run_kernel(gpu: &Gpu, run: &Run, module: &[u32], entry: &str) -> Result<Vec<f32>, GpuError> {
    let bytes = 4 * (run.written() - 1);
    // SAFETY: spirv-val has seen the module; the kernel stays within its buffers.
    let output = unsafe { gpu.run_spirv(module, entry, &bindings(run), bytes, groups(run)) };
    Ok(floats(&output?))
}
