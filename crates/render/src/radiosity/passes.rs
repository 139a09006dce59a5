//! How many pairs of passes an error needs.
//!
//! Light that the cloud receives for the (i+1)-th time is K ρ_G K ρ_C of that of the i-th. Summed over the plane it is at most q times as much,
//! q = max K(ρ_C K ρ_G), because what is given out is spread by K twice before it counts; likewise for the ground with the planes exchanged. After n
//! pairs at most q^n of all the exchanged light is missing: n = ln(error)/ln(q), rounded up. On uniform planes q = ρ_G ρ_C is the ratio itself.
//! (Bouthors, Neyret & Lefebvre 2006, section 5.2: "roughly ρ^i", ρ the ground's mean albedo, the cloud's taken as 1.)

use super::{RadiosityError, Weights};
use stratiform_quantities::Range;

/// More pairs of passes than this are refused.
pub const MOST_PASSES: u32 = 4096;

/// q of two planes.
pub fn kept(weights: &Weights, ground_albedo: &[[f64; 3]], cloud_albedo: &[[f64; 3]]) -> f64 {
    let times = |a: &[[f64; 3]], b: &[[f64; 3]]| -> Vec<[f64; 3]> {
        a.iter().zip(b).map(|(a, b)| std::array::from_fn(|c| a[c] * b[c])).collect()
    };
    let there_and_back =
        |near: &[[f64; 3]], far: &[[f64; 3]]| weights.gather(&times(near, &weights.gather(far)));
    let most = |light: Vec<[f64; 3]>| light.into_iter().flatten().fold(0.0, f64::max);
    most(there_and_back(cloud_albedo, ground_albedo)).max(most(there_and_back(ground_albedo, cloud_albedo)))
}

/// The least n >= 1 with `kept`^n <= `error`.
///
/// # Errors
/// [`RadiosityError::Domain`] for `error` outside (0, 1), `kept` outside \[0, 1), or more than [`MOST_PASSES`].
pub fn passes_for(kept: f64, error: f64) -> Result<u32, RadiosityError> {
    Range::open(0.0, 1.0).check("radiosity.error", error)?;
    Range { max_included: false, ..Range::closed(0.0, 1.0) }.check("ground albedo x cloud albedo", kept)?;
    if kept == 0.0 {
        return Ok(1);
    }
    let passes = libm::ceil(libm::log(error) / libm::log(kept)).max(1.0);
    Range::closed(1.0, f64::from(MOST_PASSES)).check("radiosity passes for the error", passes)?;
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked above")]
    Ok(passes as u32)
}
