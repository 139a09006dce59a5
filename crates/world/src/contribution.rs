//! What the light of a pixel is told apart by.

/// One lighting contribution. A path belongs to exactly one: `Background` if it met no wide event in the cloud on its way from what is
/// behind (ground, sky or the sun's disc); else `Ground` if it touched the ground; else `Sky` if it came from the sky; else it came from
/// the sun and is told apart by its number of wide events (Θ ≥ θ_f).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Contribution {
    /// Ground, sky or sun's disc, through clear air or sharply through the cloud.
    Background,
    /// Sunlight that met forward events only: the halo.
    Halo,
    /// Sunlight, one wide event.
    Single,
    /// Sunlight, two.
    Double,
    /// Sunlight, three or more.
    Multiple,
    /// Light of the sky.
    Sky,
    /// Light that the ground gave back.
    Ground,
}

impl Contribution {
    /// All of them.
    pub const ALL: [Self; 7] =
        [Self::Background, Self::Halo, Self::Single, Self::Double, Self::Multiple, Self::Sky, Self::Ground];

    /// Its name in files and on command lines.
    pub fn name(self) -> &'static str {
        match self {
            Self::Background => "background",
            Self::Halo => "halo",
            Self::Single => "single",
            Self::Double => "double",
            Self::Multiple => "multiple",
            Self::Sky => "sky",
            Self::Ground => "ground",
        }
    }

    /// Its place in [`ALL`](Self::ALL).
    pub fn index(self) -> usize {
        self as usize
    }
}
