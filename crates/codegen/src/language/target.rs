//! The targets and what sets them apart.

use super::c_family::{self, Dialect, Members};
use super::parse::parse;
use super::syntax::{Item, Type};
use super::{SubsetError, rust};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

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

    /// How the file is used, for its header, where it stands below the files `needs`.
    pub(crate) fn usage(self, needs: &[String]) -> String {
        let needs = needs.join(", ");
        let paste = |version: &str| match (needs.as_str(), version) {
            ("", "") => "paste it above your entry points".to_owned(),
            ("", version) => format!("paste it below #version {version}"),
            (needs, _) => format!("paste it below {needs}"),
        };
        let beside = |text: &str| match needs.as_str() {
            "" => text.to_owned(),
            needs => format!("{text}; it wants {needs} beside it"),
        };
        match self {
            Self::Wgsl => paste(""),
            Self::Glsl450 => paste("450"),
            Self::Glsl330 => paste("330"),
            Self::Glsl300Es => paste("300 es"),
            Self::Hlsl => beside("include or paste it; shader model 5.0 or later"),
            Self::Msl => beside("include or paste it; Metal 2.0 or later"),
            Self::C => {
                beside("include it, in as many places as you like; C99 or C++11 and later; link with -lm")
            }
            Self::Rust => beside("make it a module of your crate; edition 2021 or later"),
            Self::Spirv => String::new(),
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

/// A library before it is printed: `code` in the subset, which may call the one function of `glue` and all of `needs`.
pub(crate) struct Library<'a> {
    /// Comment lines.
    pub head: String,
    /// The file's name without extension.
    pub name: &'a str,
    /// WGSL in the subset.
    pub code: String,
    /// The structure whose members the functions become in MSL, where no buffer is bound at program scope; none if they
    /// reach no table.
    pub owner: Option<&'a str>,
    /// What the language needs to reach data; none if nothing.
    pub glue: Option<Glue<'a>>,
    /// Libraries that stand above it, each below those that it needs.
    pub needs: Vec<&'a Library<'a>>,
}

/// The function that reads the bound table, `(row: u32, index: u32) -> f32`.
pub(crate) struct Glue<'a> {
    pub function: &'a str,
    pub text: Box<dyn Fn(Target) -> String>,
}

/// A library as a tree.
struct Tree {
    /// The items of the needed libraries and its own.
    items: Vec<Item>,
    /// Where its own begin.
    own: usize,
    /// In MSL: functions of needed libraries that are members, each with the structure that it is called on.
    callees: BTreeMap<String, String>,
}

/// What a structure is called as a member of another: `StratiformPhase phase`.
fn member(owner: &str) -> String {
    owner.trim_start_matches("Stratiform").to_lowercase()
}

fn tree(library: &Library<'_>) -> Result<Tree, SubsetError> {
    let glues = library.needs.iter().copied().chain([library]).filter_map(|one| one.glue.as_ref());
    let externals: Vec<_> = glues.map(|glue| (glue.function, Type::F32)).collect();
    let (mut text, mut own, mut callees) = (String::new(), 0, BTreeMap::new());
    for needed in &library.needs {
        text.push_str(&needed.code);
        let items = parse(&text, &externals)?;
        for item in &items[own..] {
            if let (Some(owner), Item::Function(function)) = (needed.owner, item) {
                callees.insert(function.name.clone(), member(owner));
            }
        }
        own = items.len();
    }
    let above = text.lines().count();
    text.push_str(&library.code);
    let place = |error: SubsetError| SubsetError { line: error.line.saturating_sub(above), ..error };
    Ok(Tree { items: parse(&text, &externals).map_err(place)?, own, callees })
}

/// The first lines of the structure that the functions are members of.
fn members(library: &Library<'_>, glue: &str) -> String {
    let needed = library.needs.iter().filter_map(|needed| needed.owner);
    let needed: String = needed.map(|owner| format!("{owner} {};\n", member(owner))).collect();
    format!("{needed}{}{glue}", if needed.is_empty() { "" } else { "\n" })
}

/// The library in the language of each of `targets`, under its file's name; SPIR-V is left out.
pub(crate) fn translate(
    library: &Library<'_>,
    targets: &[Target],
) -> Result<Vec<(String, String)>, SubsetError> {
    let tree = tree(library)?;
    let text = |target: &Target| {
        let extension = target.extension()?;
        Some((format!("{}.{extension}", library.name), print(library, &tree, *target, extension)))
    };
    Ok(targets.iter().filter_map(text).collect())
}

/// The whole file in the language of `target`.
fn print(library: &Library<'_>, tree: &Tree, target: Target, extension: &str) -> String {
    let glue = library.glue.as_ref().map_or(String::new(), |glue| (glue.text)(target));
    let print = |members| c_family::print(&tree.items, tree.own, &target.dialect(), members);
    let code = match (target, library.owner) {
        (Target::Wgsl, _) => glue + &library.code,
        (Target::Rust, _) => glue + &rust::print(&tree.items, tree.own),
        (Target::Msl, Some(owner)) => {
            let text = members(library, &glue);
            print(Some(Members { owner, text: &text, callees: &tree.callees }))
        }
        _ => glue + &print(None),
    };
    let (before, after) = frame(library, target, extension);
    let usage =
        target.usage(&library.needs.iter().map(|n| format!("{}.{extension}", n.name)).collect::<Vec<_>>());
    let head = library.head.replace("@USE@", &format!("{}.{extension}: {usage}", library.name));
    format!("{head}\n{before}{code}{after}")
}

/// What stands above and below the code.
fn frame(library: &Library<'_>, target: Target, extension: &str) -> (String, String) {
    let guard = format!("{}_H", library.name.to_uppercase());
    let needed: String =
        library.needs.iter().map(|needed| format!("#include \"{}.{extension}\"\n", needed.name)).collect();
    let needed = if needed.is_empty() { needed } else { needed + "\n" };
    let guarded = |includes: &str| {
        let end = if target == Target::C { format!("/* {guard} */") } else { format!("// {guard}") };
        (format!("#ifndef {guard}\n#define {guard}\n\n{includes}{needed}"), format!("\n#endif {end}\n"))
    };
    match target {
        Target::C => guarded("#include <math.h>\n#include <stdbool.h>\n#include <stdint.h>\n\n"),
        Target::Msl => guarded("#include <metal_stdlib>\nusing namespace metal;\n\n"),
        Target::Hlsl => guarded(""),
        Target::Glsl300Es => ("precision highp float;\nprecision highp int;\n\n".to_owned(), String::new()),
        Target::Rust => {
            let needed = library.needs.iter().map(|needed| format!("use super::{}::*;\n", needed.name));
            let needed: String = needed.collect();
            let gap = if needed.is_empty() { "" } else { "\n" };
            (format!("{RUST_ALLOWED}{needed}{gap}"), String::new())
        }
        _ => Default::default(),
    }
}

/// Lints that generated text cannot please: a table of nodes, and literals with all their digits.
const RUST_ALLOWED: &str =
    "#![allow(dead_code, missing_docs, clippy::excessive_precision, clippy::approx_constant)]\n\n";
