//! The targets and what sets them apart.

use super::c_family::{self, Dialect};
use super::parse::parse;
use super::syntax::Type;
use super::{SubsetError, rust};
use serde::{Deserialize, Serialize};

/// A language that is emitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Target {
    /// WebGPU: the text that the others are printed from.
    Wgsl,
    /// Desktop OpenGL 4.5 and Vulkan.
    #[serde(rename = "glsl-450")]
    Glsl450,
    /// Desktop OpenGL 3.3.
    #[serde(rename = "glsl-330")]
    Glsl330,
    /// OpenGL ES 3.0 and WebGL 2.
    #[serde(rename = "glsl-300es")]
    Glsl300Es,
    /// Direct3D, shader model 5 and later.
    Hlsl,
    /// Metal.
    Msl,
    /// A C99 header that is valid C++ too.
    C,
    /// A Rust module.
    Rust,
    /// The self-test kernel for Vulkan, made by naga.
    Spirv,
}

impl Target {
    /// All of them, in the order in which they are listed.
    pub const ALL: [Self; 9] = [
        Self::Wgsl,
        Self::Glsl450,
        Self::Glsl330,
        Self::Glsl300Es,
        Self::Hlsl,
        Self::Msl,
        Self::C,
        Self::Rust,
        Self::Spirv,
    ];

    /// What its files end in; none for SPIR-V, which is no text.
    pub fn extension(self) -> Option<&'static str> {
        match self {
            Self::Wgsl => Some("wgsl"),
            Self::Glsl450 => Some("450.glsl"),
            Self::Glsl330 => Some("330.glsl"),
            Self::Glsl300Es => Some("300es.glsl"),
            Self::Hlsl => Some("hlsl"),
            Self::Msl => Some("metal"),
            Self::C => Some("h"),
            Self::Rust => Some("rs"),
            Self::Spirv => None,
        }
    }

    /// How the file is used, for its header.
    pub(crate) fn usage(self) -> &'static str {
        match self {
            Self::Wgsl => "paste it above your entry points",
            Self::Glsl450 => "paste it below #version 450",
            Self::Glsl330 => "paste it below #version 330",
            Self::Glsl300Es => "paste it below #version 300 es",
            Self::Hlsl => "include or paste it; shader model 5.0 or later",
            Self::Msl => "include or paste it; Metal 2.0 or later",
            Self::C => "include it, in as many places as you like; C99 or C++11 and later; link with -lm",
            Self::Rust => "make it a module of your crate; edition 2021 or later",
            Self::Spirv => "",
        }
    }

    fn dialect(self) -> Dialect {
        let glsl = Dialect {
            float: "float",
            uint: "uint",
            float_suffix: "",
            constant: "const ",
            function: "",
            constructor: true,
            c: false,
        };
        match self {
            Self::Hlsl => {
                Dialect { float_suffix: "f", constant: "static const ", constructor: false, ..glsl }
            }
            Self::Msl => Dialect {
                float_suffix: "f",
                constant: "constant ",
                function: "inline ",
                constructor: false,
                ..glsl
            },
            Self::C => Dialect {
                uint: "uint32_t",
                float_suffix: "f",
                constant: "static const ",
                function: "static inline ",
                constructor: false,
                c: true,
                ..glsl
            },
            _ => glsl,
        }
    }
}

/// A library before it is printed: `code` in the subset, which may call the one function of `glue`.
pub(crate) struct Library<'a> {
    /// Comment lines.
    pub head: String,
    /// The file's name without extension.
    pub name: &'a str,
    /// WGSL in the subset.
    pub code: String,
    /// What the language needs to reach data; none if nothing.
    pub glue: Option<Glue<'a>>,
}

/// The function that reads the bound table, `(row: u32, index: u32) -> f32`.
pub(crate) struct Glue<'a> {
    pub function: &'a str,
    /// The structure whose members the functions become in MSL, where no buffer is bound at program scope.
    pub owner: &'a str,
    pub text: Box<dyn Fn(Target) -> String>,
}

/// The library in the language of `target`; none for SPIR-V.
pub(crate) fn translate(library: &Library<'_>, target: Target) -> Result<Option<String>, SubsetError> {
    let Some(extension) = target.extension() else { return Ok(None) };
    let externals: Vec<_> = library.glue.iter().map(|glue| (glue.function, Type::F32)).collect();
    let items = parse(&library.code, &externals)?;
    let glue_text = library.glue.as_ref().map_or(String::new(), |glue| (glue.text)(target));
    let code = match target {
        Target::Wgsl => library.code.clone(),
        Target::Rust => rust::print(&items),
        Target::Msl => c_family::print(
            &items,
            &target.dialect(),
            library.glue.as_ref().map(|glue| (glue.owner, &*glue_text)),
        ),
        other => c_family::print(&items, &other.dialect(), None),
    };
    let glue = if target == Target::Msl { String::new() } else { glue_text };
    let guard = format!("{}_H", library.name.to_uppercase());
    let guarded = |includes: &str| {
        let end = if target == Target::C { format!("/* {guard} */") } else { format!("// {guard}") };
        (format!("#ifndef {guard}\n#define {guard}\n\n{includes}"), format!("\n#endif {end}\n"))
    };
    let (before, after) = match target {
        Target::C => guarded("#include <math.h>\n#include <stdbool.h>\n#include <stdint.h>\n\n"),
        Target::Msl => guarded("#include <metal_stdlib>\nusing namespace metal;\n\n"),
        Target::Hlsl => guarded(""),
        Target::Glsl300Es => ("precision highp float;\nprecision highp int;\n\n".to_owned(), String::new()),
        Target::Rust => (RUST_ALLOWED.to_owned(), String::new()),
        _ => Default::default(),
    };
    let head = library.head.replace("@USE@", &format!("{}.{extension}: {}", library.name, target.usage()));
    Ok(Some(format!("{head}\n{before}{glue}{code}{after}")))
}

/// Lints that generated text cannot please: a table of nodes, and literals with all their digits.
const RUST_ALLOWED: &str =
    "#![allow(dead_code, missing_docs, clippy::excessive_precision, clippy::approx_constant)]\n\n";
