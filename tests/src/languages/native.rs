//! Languages that run on the processor: C, C++, Rust, and Metal's by a stand-in for its library.

use super::Output;
use super::tools::{Scratch, ToolError};

const DRIVER_C: &str = include_str!("drivers/driver.c");
const DRIVER_RUST: &str = include_str!("drivers/driver.rs");
/// What stands in for Metal's library.
pub const METAL_LIBRARY: &str = include_str!("drivers/metal_stdlib");

/// Warnings that users' builds may have on, all of them errors here.
const WARNINGS: [&str; 7] =
    ["-Wall", "-Wextra", "-Werror", "-pedantic", "-Wshadow", "-Wconversion", "-Wdouble-promotion"];

/// Compiles the header `text` twice included, with every warning an error, by `compiler` in `standard`; then runs it.
///
/// # Errors
/// [`ToolError`] if the compiler is missing or refuses.
pub fn c(compiler: &'static str, standard: &str, text: &str, input: &[u8]) -> Result<Output, ToolError> {
    let scratch = Scratch::new()?;
    scratch.write("stratiform.h", text)?;
    scratch.write("driver.c", DRIVER_C)?;
    let language = if standard.contains("++") { "c++" } else { "c" };
    let include = ["-include", "stratiform.h"];
    let arguments = [
        &[standard, "-O2", "-I."][..],
        &WARNINGS,
        &include,
        &include,
        &["-x", language, "driver.c", "-o", "driver", "-lm"],
    ];
    scratch.run(compiler, &arguments.concat())?;
    Ok(Output::read(&scratch.run_program("driver", input)?))
}

/// Compiles the module `text` in `edition` with warnings denied, optimised, and runs it.
///
/// # Errors
/// [`ToolError`] if the compiler is missing or refuses.
pub fn rust(edition: &str, text: &str, input: &[u8]) -> Result<Output, ToolError> {
    let scratch = Scratch::new()?;
    scratch.write("stratiform.rs", text)?;
    scratch.write("driver.rs", DRIVER_RUST)?;
    scratch.run("rustc", &["--edition", edition, "-D", "warnings", "-O", "driver.rs"])?;
    Ok(Output::read(&scratch.run_program("driver", input)?))
}

/// Compiles Metal's `text` as C++ against the stand-in for its library, and runs it.
///
/// # Errors
/// [`ToolError`] if the compiler or GLM is missing, or it refuses.
pub fn metal(text: &str, input: &[u8]) -> Result<Output, ToolError> {
    let scratch = Scratch::new()?;
    scratch.write("metal_stdlib", METAL_LIBRARY)?;
    scratch.write("stratiform.metal", text)?;
    scratch.write("driver.c", DRIVER_C)?;
    let arguments = [
        &["-std=c++17", "-O1", "-fsingle-precision-constant", "-I."][..],
        &["-Wall", "-Wextra", "-Werror", "-Wno-attributes", "-Wno-unused-function"],
        &["-include", "stratiform.metal", "-x", "c++", "driver.c", "-o", "driver"],
    ];
    scratch.run("g++", &arguments.concat()).map_err(|error| match error {
        ToolError::Refused { said, .. } if said.contains("GLM is missing") => {
            ToolError::Missing("libglm-dev")
        }
        error => error,
    })?;
    Ok(Output::read(&scratch.run_program("driver", input)?))
}
