//! Every way in which emitted text is compiled and executed.

use super::library::{Output, Run};
use super::tools::{ToolError, available, skip};
use super::{native, shaders};
use std::sync::OnceLock;
use stratiform_gpu::{Gpu, GpuError};

/// Where the compiled text runs.
enum Place {
    /// On the processor: compiles and runs.
    Processor(fn(&Run, &str) -> Result<Output, ToolError>),
    /// On the device, from the SPIR-V that a compiler makes.
    Device(fn(&Run, &str) -> Result<Vec<u32>, ToolError>),
    /// On the device, which takes the text.
    Text,
}

/// One compiler of one language.
pub struct Way {
    /// Language and compiler.
    pub name: &'static str,
    /// What the emitted file's name ends in.
    pub ending: &'static str,
    place: Place,
}

const fn way(name: &'static str, ending: &'static str, place: Place) -> Way {
    Way { name, ending, place }
}

static WAYS: [Way; 11] = [
    way("C by gcc", "h", Place::Processor(|run, text| native::c("gcc", "-std=c99", run, text))),
    way("C by clang", "h", Place::Processor(|run, text| native::c("clang", "-std=c99", run, text))),
    way("C++ by g++", "h", Place::Processor(|run, text| native::c("g++", "-std=c++17", run, text))),
    way("C++ by clang++", "h", Place::Processor(|run, text| native::c("clang++", "-std=c++17", run, text))),
    way("Rust 2021", "rs", Place::Processor(|run, text| native::rust("2021", run, text))),
    way("Rust 2024", "rs", Place::Processor(|run, text| native::rust("2024", run, text))),
    way("Metal on the processor", "metal", Place::Processor(native::metal)),
    way(
        "GLSL 450",
        "450.glsl",
        Place::Device(|run, text| shaders::glsl_compute(run.library, &run.pasted(text))),
    ),
    way(
        "HLSL by glslang",
        "hlsl",
        Place::Device(|run, text| shaders::hlsl_by_glslang(run.library, &run.pasted(text))),
    ),
    way(
        "HLSL by DXC",
        "hlsl",
        Place::Device(|run, text| shaders::hlsl_by_dxc(run.library, &run.pasted(text))),
    ),
    way("WGSL", "wgsl", Place::Text),
];

/// Tools that may be missing everywhere: a second opinion beside another that is required.
const OPTIONAL: [&str; 3] = ["clang", "clang++", shaders::DXC];

/// The ways of one language.
pub fn ways(ending: &str) -> impl Iterator<Item = &'static Way> {
    WAYS.iter().filter(move |way| way.ending == ending)
}

impl Way {
    /// What the driver gives with `text`; `None` after a loud skip where a tool or a device is missing.
    ///
    /// # Panics
    /// If a tool or the device refuses: a test then fails.
    pub fn execute(&self, run: &Run, text: &str) -> Option<Output> {
        let on_device = |module: Vec<u32>| device().map(|gpu| shaders::run(gpu, run, &module));
        let output = match self.place {
            Place::Processor(execute) => return available(execute(run, text), &OPTIONAL),
            Place::Device(compile) => on_device(available(compile(run, text), &OPTIONAL)?)?,
            Place::Text => shaders::run_wgsl(device()?, run, text),
        };
        Some(output.unwrap_or_else(|error| panic!("{}: {error}", self.name)))
    }
}

/// The device, opened once; or a loud skip. With `STRATIFORM_REQUIRE_GPU=1` that is a failure.
///
/// # Panics
/// If there is one that fails: a test then fails.
pub fn device() -> Option<&'static Gpu> {
    static DEVICE: OnceLock<Result<Gpu, GpuError>> = OnceLock::new();
    match DEVICE.get_or_init(Gpu::new) {
        Ok(gpu) => Some(gpu),
        Err(error @ GpuError::NoAdapter { .. }) if std::env::var_os("STRATIFORM_REQUIRE_GPU").is_none() => {
            skip(error);
            None
        }
        Err(error) => panic!("{error}"),
    }
}
