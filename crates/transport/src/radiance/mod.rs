//! Radiance leaving one slab by Monte Carlo, per scattering order, scattered light only.
//!
//! Unit: reflectance factor πL/(μ0F0). A photon carries μ0F0/N per unit area. Two estimators:
//!
//! - **At given directions** ([`trace_radiance`]): each collision sends ωP(Θ)/4π per steradian towards the view, of which
//!   e^{-s} arrives, s the optical path to the face. Radiance is that power per projected area: the collision adds
//!   ωP(Θ)/4 · e^{-s}/μ to the reflectance factor (local estimate; Marchuk et al. 1980). Azimuths φ and -φ are
//!   equals and are both scored.
//! - **In angular bins** ([`trace_radiance_bins`]): photons that leave through the bin, in whole numbers k. The
//!   mean factor over the bin, weighted with μ dμ dφ, is π(k/N)/∫μ dμ dφ, with the error of the proportion k/N.
//!
//! **Spikes.** A forward peak makes rare collisions that head for the view add up to ωP_max/(4μ), thousands of times the
//! mean in a full medium of cloud droplets. Nothing is clamped: values are unbiased. Instead
//! - every standard error contains what one more event of the largest possible score would add (ωP_max/(4μN), in
//!   quadrature), so that a spike not yet met is not taken for certainty, as for proportions without hits;
//! - [`ViewRadiance::is_settled`] says whether the scatter met exceeds three such events: until then the error's size is a
//!   guess, not a measurement; [`ViewRadiance::largest_share`] is the largest share of one photon.
//!
//! Order 1 has no spikes (Θ is that of sun and view), nor have bins. In the modified medium there is no peak.
//!
//! Domain: τ from 0 to 1e6, μ0 from 0 (a limit) to 1, ω from 0 to 1; a view's μ above 0. Memory does not grow with
//! photons. The same bytes for any number of threads.

mod bins;
mod flight;
mod request;
mod rounds;
mod score;
mod viewers;
mod views;

pub use bins::{AngularBins, BinRadiance, trace_radiance_bins};
pub use request::{MAX_CELLS, RadianceRequest};
pub use views::{ViewRadiance, check_views, trace_radiance};
