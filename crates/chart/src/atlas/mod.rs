//! Where each method breaks: planes through a base point, every value put into a class.
//!
//! A [`Plane`] runs two inputs over all they can be; a [`Sheet`] adds its clouds and the deterministic solver's truth; [`sweep`] asks a
//! method for radiances on both faces and fluxes, in double precision and as a shader would, and judges each value ([`Class`]).
//! [`answered_outside`] steps over every end of the declared ranges. Errors: [`ChartError`](crate::ChartError).
//!
//! Formulas are asked everywhere; solvers and tracers, which have contracts of their own in `transport`, on thin planes, tracers up to
//! κH = 10. What fails or is worth little, and the remedy:
//!
//! | method | where | what happens | remedy |
//! | --- | --- | --- | --- |
//! | `solver:N` | κH = 1000, ω = 0.5, below | light under the rounding of its sums comes out negative, -1e-17 | set to 0 within 1e-12 |
//! | `solver:8` | κH = 0.01, μ_l = 1e-4 | R off by 1e-3 | promised to 5e-3 only; more streams |
//! | `bouthors-printed` | κH = 3, μ_l = 0.3 | R off by 0.1 | no promise; the refitted table with corrected forms |
//! | `bouthors-corrected*` | μ_l ≤ 0.1, κH = 0.1…1 | R and T off by 0.05…0.1 | promised for μ_l from 0.1737 only |
//! | `diffusion` | κH = 1, μ_l = 0.2 | R off by 0.14 | promised to 0.2; δ-Eddington keeps 0.1 |
//! | `asymptotic` | κH = 10, sun's own azimuth, μ = 0.6 | radiance above 20 % too low | promised to 30 % |
//! | `bouthors-*`, published table | κH < 1 | negative R_3+ | refused: the domain starts at 1 |
//! | `asymptotic` | μ < 0.3 | R_∞ above all light | refused |
//! | `delta-eddington`, `diffusion` | ω < 0.8 | γ2 < 0 | refused |
//! | any with θ_f | θ_f = 0 | no modified medium | refused by `Cloud` |
//! | `fitted*`, `bouthors-*` | ω < 1, other r_e | not what they were fitted to | refused |
//! | `single-hg-draine` | r_e outside 2.5…25 µm | not what the blend was fitted to | refused |
//! | single scattering, octaves, two-stream radiances | thick slabs, peak | errors up to many times the truth | no promise |

mod class;
mod clouds;
mod edges;
mod plane;
mod rows;
mod sweep;
mod truth;

pub use class::{Case, Class, F32_SHARE};
pub use clouds::{BASE_RADIUS_UM, CloudAt, Phases};
pub use edges::answered_outside;
pub use plane::{Density, Input, Place, Plane};
pub use rows::{count, document, rows};
pub use sweep::{Cell, Precision, Sheet, sweep};
pub use truth::SHARE as LARGEST_TRUTH_ERROR;
