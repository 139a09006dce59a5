//! The emitted libraries, each with the drivers that call it.

/// One emitted library: what its files are called, and a driver in each language.
///
/// A driver reads its input as f32 and writes the embedded self-test's count of wrong values, then its values.
pub struct Library {
    /// Files are `name.ending`.
    pub name: &'static str,
    pub(super) c: &'static str,
    pub(super) rust: &'static str,
    pub(super) glsl: &'static str,
    pub(super) fragment: &'static str,
    pub(super) hlsl: &'static str,
    pub(super) wgsl: &'static str,
    /// f32 read and written per input.
    pub(super) sizes: [usize; 2],
    /// Names of the libraries that stand above it.
    pub needs: &'static [&'static str],
}

/// Fluxes: (μ_l, τ), μ_l = -1 for diffuse light, to nine fluxes.
pub static FLUXES: Library = Library {
    name: "stratiform",
    c: include_str!("drivers/fluxes/driver.c"),
    rust: include_str!("drivers/fluxes/driver.rs"),
    glsl: include_str!("drivers/fluxes/driver.glsl"),
    fragment: include_str!("drivers/fluxes/fragment.glsl"),
    hlsl: include_str!("drivers/fluxes/driver.hlsl"),
    wgsl: include_str!("drivers/fluxes/driver.wgsl"),
    sizes: [2, 9],
    needs: &[],
};

/// Phase functions: v = 1 - cosΘ to P, P_S, P_S convolved with itself, and the angle by way of the table's coordinate.
pub static PHASE: Library = Library {
    name: "stratiform_phase",
    c: include_str!("drivers/phase/driver.c"),
    rust: include_str!("drivers/phase/driver.rs"),
    glsl: include_str!("drivers/phase/driver.glsl"),
    fragment: include_str!("drivers/phase/fragment.glsl"),
    hlsl: include_str!("drivers/phase/driver.hlsl"),
    wgsl: include_str!("drivers/phase/driver.wgsl"),
    sizes: [1, 4],
    needs: &[],
};

/// Radiance and halo: (mu_l, mu_v, v, tau, shape) to I1, I2, I3+ at the lit face and at the other, both sums, transparency, and
/// L/F0 of factor 1, and the halo.
pub static RADIANCE: Library = Library {
    name: "stratiform_halo",
    c: include_str!("drivers/radiance/driver.c"),
    rust: include_str!("drivers/radiance/driver.rs"),
    glsl: include_str!("drivers/radiance/driver.glsl"),
    fragment: include_str!("drivers/radiance/fragment.glsl"),
    hlsl: include_str!("drivers/radiance/driver.hlsl"),
    wgsl: include_str!("drivers/radiance/driver.wgsl"),
    sizes: [5, 11],
    needs: &["stratiform", "stratiform_weights", "stratiform_phase", "stratiform_radiance"],
};

/// Fluxes over effective radius: (μ_l, r_e, τ), μ_l = -1 for diffuse light, to nine fluxes.
pub static FAMILY: Library = Library {
    name: "stratiform_family",
    c: include_str!("drivers/family/driver.c"),
    rust: include_str!("drivers/family/driver.rs"),
    glsl: include_str!("drivers/family/driver.glsl"),
    fragment: include_str!("drivers/family/fragment.glsl"),
    hlsl: include_str!("drivers/family/driver.hlsl"),
    wgsl: include_str!("drivers/family/driver.wgsl"),
    sizes: [3, 9],
    needs: &["stratiform"],
};

/// Fitted radiance: (mu_l, mu_v, v, tau) to I1, M and their sum at the lit face and at the other.
pub static SHADE: Library = Library {
    name: "stratiform_shade",
    c: include_str!("drivers/shade/driver.c"),
    rust: include_str!("drivers/shade/driver.rs"),
    glsl: include_str!("drivers/shade/driver.glsl"),
    fragment: include_str!("drivers/shade/fragment.glsl"),
    hlsl: include_str!("drivers/shade/driver.hlsl"),
    wgsl: include_str!("drivers/shade/driver.wgsl"),
    sizes: [4, 6],
    needs: &["stratiform", "stratiform_weights", "stratiform_phase"],
};

/// Phase functions over effective radius: (v, r_e) to P, P_S and P_S convolved with itself.
pub static FAMILY_PHASE: Library = Library {
    name: "stratiform_family_phase",
    c: include_str!("drivers/family_phase/driver.c"),
    rust: include_str!("drivers/family_phase/driver.rs"),
    glsl: include_str!("drivers/family_phase/driver.glsl"),
    fragment: include_str!("drivers/family_phase/fragment.glsl"),
    hlsl: include_str!("drivers/family_phase/driver.hlsl"),
    wgsl: include_str!("drivers/family_phase/driver.wgsl"),
    sizes: [2, 3],
    needs: &["stratiform_phase"],
};

/// A library and what its driver is run on.
pub struct Run<'a> {
    /// Which.
    pub library: &'a Library,
    /// The tables that a library takes from its host; C and Rust carry theirs.
    pub tables: &'a [&'a [u8]],
    /// The driver's input.
    pub input: &'a [u8],
    /// Names and texts of the files that the library needs.
    pub beside: &'a [(String, String)],
}

impl Run<'_> {
    /// The library's `text` below those that it needs, in place of including them.
    pub fn pasted(&self, text: &str) -> String {
        let includes =
            |line: &&str| self.beside.iter().any(|(name, _)| **line == format!("#include \"{name}\""));
        let texts = self.beside.iter().map(|(_, text)| text.as_str()).chain([text]);
        let lines = texts.flat_map(str::lines).filter(|line| !includes(line));
        lines.map(|line| format!("{line}\n")).collect()
    }

    /// Inputs: threads of a shader.
    pub(super) fn count(&self) -> usize {
        self.input.len() / 4 / self.library.sizes[0]
    }

    /// f32 that the driver writes.
    pub(super) fn written(&self) -> usize {
        1 + self.count() * self.library.sizes[1]
    }
}

/// What a driver wrote.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// Wrong values that the embedded self-test counted.
    pub wrong: u32,
    /// What the library's functions gave, input by input.
    pub values: Vec<f32>,
}

impl Output {
    /// From a driver's bytes: the count, then the values.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a count below 2^24 that a driver wrote as f32"
    )]
    pub fn read(bytes: &[u8]) -> Self {
        let values = floats(bytes);
        let wrong = values.first().map_or(u32::MAX, |count| *count as u32);
        Self { wrong, values: values.get(1..).unwrap_or_default().to_vec() }
    }
}

/// Little-endian f32.
pub fn floats(bytes: &[u8]) -> Vec<f32> {
    bytes.as_chunks().0.iter().map(|four| f32::from_le_bytes(*four)).collect()
}
