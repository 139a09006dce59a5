//! Languages that run on the processor: C, C++, Rust, and Metal's by a stand-in for its library.

use super::library::{Output, Run};
use super::tools::{Scratch, ToolError};

/// A folder with the library's `text` under `name` and what it needs beside it.
fn scratch(run: &Run, name: &str, text: &str) -> Result<Scratch, ToolError> {
    let scratch = Scratch::new()?;
    scratch.write(name, text)?;
    for (name, text) in run.beside {
        scratch.write(name, text)?;
    }
    Ok(scratch)
}

/// What stands in for Metal's library.
pub const METAL_LIBRARY: &str = include_str!("drivers/metal_stdlib");

/// Warnings that users' builds may have on, all of them errors here.
const WARNINGS: [&str; 7] =
    ["-Wall", "-Wextra", "-Werror", "-pedantic", "-Wshadow", "-Wconversion", "-Wdouble-promotion"];

/// Compiles the header `text`, included twice, with every warning an error, by `compiler` in `standard`; then runs it.
///
/// # Errors
/// [`ToolError`] if the compiler is missing or refuses.
pub fn c(compiler: &'static str, standard: &str, run: &Run, text: &str) -> Result<Output, ToolError> {
    let scratch = scratch(run, "library.h", text)?;
    scratch.write("driver.c", run.library.c)?;
    let language = if standard.contains("++") { "c++" } else { "c" };
    let include = ["-include", "library.h"];
    let arguments = [
        &[standard, "-O2", "-I."][..],
        &WARNINGS,
        &include,
        &include,
        &["-x", language, "driver.c", "-o", "driver", "-lm"],
    ];
    scratch.run(compiler, &arguments.concat())?;
    Ok(Output::read(&scratch.run_program("driver", run.input)?))
}

/// Compiles the module `text` in `edition` with warnings denied, optimised, and runs it.
///
/// # Errors
/// [`ToolError`] if the compiler is missing or refuses.
pub fn rust(edition: &str, run: &Run, text: &str) -> Result<Output, ToolError> {
    let scratch = scratch(run, "library.rs", text)?;
    scratch.write("driver.rs", run.library.rust)?;
    scratch.run("rustc", &["--edition", edition, "-D", "warnings", "-O", "driver.rs"])?;
    Ok(Output::read(&scratch.run_program("driver", run.input)?))
}

/// Compiles Metal's `text` as C++ against the stand-in for its library, and runs it.
///
/// # Errors
/// [`ToolError`] if the compiler or GLM is missing, or it refuses.
pub fn metal(run: &Run, text: &str) -> Result<Output, ToolError> {
    let scratch = scratch(run, "library.metal", text)?;
    scratch.write("metal_stdlib", METAL_LIBRARY)?;
    scratch.write("driver.c", run.library.c)?;
    let arguments = [
        &["-std=c++17", "-O1", "-fsingle-precision-constant", "-I."][..],
        &["-Wall", "-Wextra", "-Werror", "-Wno-attributes", "-Wno-unused-function"],
        &["-include", "library.metal", "-x", "c++", "driver.c", "-o", "driver"],
    ];
    scratch.run("g++", &arguments.concat()).map_err(|error| match error {
        ToolError::Refused { said, .. } if said.contains("GLM is missing") => {
            ToolError::Missing("libglm-dev")
        }
        error => error,
    })?;
    let input = [run.table.unwrap_or_default(), run.input].concat();
    Ok(Output::read(&scratch.run_program("driver", &input)?))
}
