//! How much is wrong, and why so much.

/// Shares that change the optical thickness of transport, (1-g)τ, or that of the modified medium, (1-P_f)τ: 2 %, the slip of a
/// parameter that `stratiform check` must not let pass.
pub const TRANSPORT: f64 = 0.02;

/// Integral: 1e-3, what the tracer, the solver and the shaders accept of a table
/// ([`NORM`](stratiform_optics::phase::NORM)).
pub const INTEGRAL: f64 = 1e-3;

/// Two rules of integration may differ by this before a table is too coarse: half of [`TRANSPORT`], because at equal
/// steps the difference comes out as the relative error of 1-P_f.
pub const RULES: f64 = 0.01;

/// The integral of a table of P that nobody normalised is off by this much of the difference between the rules: 1 at equal
/// steps, 2 at steps that grow with Θ.
pub const INTEGRAL_PER_RULES: f64 = 2.5;

/// Share of light that linear interpolation may misplace: a quarter of [`TRANSPORT`].
pub const MISPLACED: f64 = 0.005;

/// P(0), relative. It grows like r_e², so that 10 % is 5 % of the droplets' size.
pub const FORWARD_PEAK: f64 = 0.1;

/// Total variation beyond θ_f: the 2 % of [`TRANSPORT`] as shares of light.
pub const WIDE_SHAPE: f64 = 0.02;

/// Fogbow's angle, degrees: twice the sun's diameter, which blurs it.
pub const FOGBOW_DEG: f64 = 1.0;

/// Contrast of the fogbow, and P within 10° of the glory's centre, relative: as [`FORWARD_PEAK`].
pub const SEEN: f64 = 0.1;

/// Extinction coefficient, relative: as [`TRANSPORT`].
pub const EXTINCTION: f64 = 0.02;
