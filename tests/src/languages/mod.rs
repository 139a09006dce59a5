//! The emitted text in every language, through that language's own compilers, and executed where it can be.
//!
//! Each [`library`] has in each language a driver in `drivers/`, which is what a user would write: it evaluates the
//! emitted functions at many inputs. Its output is one list of f32: the count of wrong values that the embedded
//! self-test found, then the functions' values. [`comparator`] holds fluxes against the f64 model.
//!
//! C, C++ and Rust are compiled and run. Metal's language is C++ with a library: g++ with a stand-in for that library
//! (on GLM) checks the types and runs it. GLSL 450 and HLSL become SPIR-V and run on the graphics device; GLSL 330 and
//! 300 es are compiled only.

pub mod comparator;
pub mod held;
pub mod library;
pub mod native;
pub mod shaders;
pub mod signatures;
pub mod tools;
pub mod ways;

use library::Library;
use std::fs;
use std::path::PathBuf;
use stratiform_artifact::read_csv;
use stratiform_codegen::{HaloTable, RadianceVector, SelfTest, ShadeVector};
use stratiform_quantities::Incidence;

/// A folder of emitted files.
pub struct Emitted {
    folder: PathBuf,
    /// Inputs, and what the f64 model gives for them.
    pub test: SelfTest,
}

impl Emitted {
    /// The committed text of the paper's cloud, as a user takes it; or that of the folder `STRATIFORM_EMITTED`.
    ///
    /// # Panics
    /// If it cannot be read: a test then fails.
    pub fn committed() -> Self {
        let committed = || crate::root().join("fit-configs/appendix-b/generated");
        Self::at(std::env::var_os("STRATIFORM_EMITTED").map_or_else(committed, PathBuf::from))
    }

    /// The text in `folder`.
    ///
    /// # Panics
    /// If it cannot be read: a test then fails.
    #[expect(clippy::expect_used, reason = "for tests only")]
    pub fn at(folder: PathBuf) -> Self {
        let test = fs::read_to_string(folder.join("self_test.json")).expect("the self-test's vectors");
        Self { folder, test: serde_json::from_str(&test).expect("vectors that can be read") }
    }

    /// The files, in order.
    ///
    /// # Panics
    /// If the folder cannot be read.
    #[expect(clippy::expect_used, reason = "for tests only")]
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.folder).expect("a folder that can be read");
        let names = entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned());
        let mut names: Vec<_> = names.collect();
        names.sort();
        names
    }

    /// The emitted file `name`.
    ///
    /// # Panics
    /// If it cannot be read: a test then fails.
    pub fn text(&self, name: &str) -> String {
        String::from_utf8(self.bytes(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// The bytes of the emitted file `name`.
    ///
    /// # Panics
    /// If it cannot be read: a test then fails.
    pub fn bytes(&self, name: &str) -> Vec<u8> {
        fs::read(self.folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// Both rows of the phase table, as the host binds them.
    ///
    /// # Panics
    /// If it cannot be read: a test then fails.
    #[expect(clippy::cast_possible_truncation, reason = "a shader's table is in single precision")]
    pub fn phase_table(&self) -> Vec<u8> {
        let text = self.text("phase_warped.csv");
        let column = |i: usize| {
            text.lines().skip(1).map(move |line| line.split(',').nth(i).and_then(|field| field.parse().ok()))
        };
        let values = column(2).chain(column(3)).map(|value: Option<f64>| value.unwrap_or(f64::NAN));
        values.flat_map(|value| (value as f32).to_le_bytes()).collect()
    }

    /// The halo's table, likewise.
    ///
    /// # Panics
    /// If it cannot be read: a test then fails.
    #[expect(clippy::cast_possible_truncation, reason = "a shader's table is in single precision")]
    #[expect(clippy::expect_used, reason = "for tests only")]
    pub fn halo_table(&self) -> Vec<u8> {
        let halo: HaloTable = serde_json::from_str(&self.text("halo.json")).expect("the halo's table");
        halo.values.iter().flat_map(|value| (*value as f32).to_le_bytes()).collect()
    }

    /// Sights, and what the f64 model gives for them.
    ///
    /// # Panics
    /// If they cannot be read: a test then fails.
    #[expect(clippy::expect_used, reason = "for tests only")]
    pub fn radiance_vectors(&self) -> Vec<RadianceVector> {
        read_csv(&self.folder.join("radiance_test.csv")).expect("the radiance's vectors")
    }

    /// The same for the fitted model of radiance.
    ///
    /// # Panics
    /// If they cannot be read: a test then fails.
    #[expect(clippy::expect_used, reason = "for tests only")]
    pub fn shade_vectors(&self) -> Vec<ShadeVector> {
        read_csv(&self.folder.join("shade_test.csv")).expect("the radiance's vectors")
    }

    /// Names and texts of the files that stand above those of `library` with this `ending`.
    ///
    /// # Panics
    /// If one cannot be read: a test then fails.
    pub fn beside(&self, library: &Library, ending: &str) -> Vec<(String, String)> {
        let names = library.needs.iter().map(|name| format!("{name}.{ending}"));
        names.map(|name| (name.clone(), self.text(&name))).collect()
    }

    /// (μ_l, τ) of every vector, μ_l = -1 for diffuse light, as the drivers take them.
    #[expect(clippy::cast_possible_truncation, reason = "the vectors' inputs are f32 exactly")]
    pub fn input(&self) -> Vec<u8> {
        let pair = |mu_l: Incidence, tau: f64| {
            let mu = match mu_l {
                Incidence::Beam(mu) => mu.get(),
                Incidence::Diffuse => -1.0,
            };
            [mu as f32, tau as f32]
        };
        let pairs = self.test.vectors.iter().flat_map(|vector| pair(vector.mu_l, vector.tau));
        pairs.flat_map(f32::to_le_bytes).collect()
    }
}
