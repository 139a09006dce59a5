//! What is drawn, and how.

use stratiform_model::Form;
use stratiform_model::angular::Emission;
use stratiform_world::Contribution;

/// How the sun's light leaves the cloud.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Model {
    /// The paper's orders with the corrected equations (`stratiform_radiance.wgsl`): local normal for one and two events, vertical for
    /// three and more.
    Angular,
    /// One event exactly and all others as the fitted exponential (`stratiform_shade.wgsl`).
    Fitted,
}

/// How light from one plane to the other is summed: which weights three nested squares of sides h, 2h, 8h get (levels 0, 1, 3 of a pyramid
/// whose texels are h), or every texel its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RingRule {
    /// Levels 0, 1, 3 with the printed weights 0.5, 0.3, 0.2 of discs.
    AsPrinted,
    /// Levels 1, 2, 4 with the same weights.
    WiderSquares,
    /// Levels 0, 1, 3 with the weights of squares, 0.239, 0.315, 0.446 (0.135, 0.390, 0.476 by level).
    SquareWeights,
    /// No squares: every texel with its own form factor.
    Exact,
    /// Every texel with the weight that makes the least error where texels are means and results are read bilinearly.
    LeastSquares,
}

/// Light between ground and cloud.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Radiosity {
    /// Texels a side.
    pub side: u32,
    /// Exchanges; `None`: as many as the ground's albedo and `error` need.
    pub passes: Option<u32>,
    /// Share of the exchanged light that may be missing.
    pub error: f64,
    /// The weights.
    pub rings: RingRule,
    /// Whether shadows and the cloud's source are as printed (parallax h sinθ_l, no cosθ_l) or corrected (h tanθ_l, cosθ_l).
    pub form: Form,
}

/// A set of contributions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Contributions(u32);

impl Contributions {
    /// Every one.
    pub fn all() -> Self {
        Contribution::ALL.into_iter().fold(Self::none(), Self::with)
    }

    /// None.
    pub fn none() -> Self {
        Self(0)
    }

    /// With one more.
    pub fn with(self, contribution: Contribution) -> Self {
        Self(self.0 | 1 << contribution.index())
    }

    /// With one less.
    pub fn without(self, contribution: Contribution) -> Self {
        Self(self.0 & !(1 << contribution.index()))
    }

    /// Whether it is in the set.
    pub fn has(self, contribution: Contribution) -> bool {
        self.0 & (1 << contribution.index()) != 0
    }

    /// A bit per contribution, in the order of [`Contribution::ALL`].
    pub fn bits(self) -> u32 {
        self.0
    }
}

/// Thickness H of the slab that stands for the cloud at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// The thickness above the base where the line of sight meets the cloud.
    Local,
    /// l μ_v of the way l that the line of sight goes in the cloud; the cloud is then as transparent as it is. Beyond some thousand cells
    /// the rest of the way counts as cloudy as the way before.
    Chord,
}

/// Whose normal the sun's light of one and two events leaves the cloud by; that of more leaves it by the vertical.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Normals {
    /// The face's own, as in section 6 of the paper.
    Local,
    /// The vertical.
    Vertical,
}

/// The shapes of light of three and more events in the angular model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Emissions {
    /// Where viewer and sun are on the same side.
    pub top: Emission,
    /// Where they are not.
    pub bottom: Emission,
}

/// What is drawn, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// How the sun's light leaves the cloud.
    pub model: Model,
    /// What is drawn.
    pub contributions: Contributions,
    /// Light between ground and cloud.
    pub radiosity: Radiosity,
    /// H.
    pub depth: Depth,
    /// Normals of the sun's light.
    pub normals: Normals,
    /// Shapes of its last orders, of [`Model::Angular`].
    pub emission: Emissions,
}

impl Default for Settings {
    fn default() -> Self {
        let (rings, form) = (RingRule::LeastSquares, Form::Corrected);
        Self {
            model: Model::Fitted,
            contributions: Contributions::all(),
            radiosity: Radiosity { side: 16, passes: None, error: 1e-3, rings, form },
            depth: Depth::Local,
            normals: Normals::Local,
            emission: Emissions { top: Emission::Lambertian, bottom: Emission::Escape },
        }
    }
}
