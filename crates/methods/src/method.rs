//! The trait that all methods share.

use crate::{Card, Cloud, FluxPair, FluxPoint, MethodError, Point};
use stratiform_model::angular::Sight;
use stratiform_stats::Estimate;

/// A way to shade a cloud layer.
pub trait Method: Send + Sync {
    /// What it is.
    fn card(&self) -> &Card;

    /// Does once per cloud what can be done once.
    ///
    /// # Errors
    /// [`MethodError`] if the cloud lies outside its domain.
    fn prepare(&self, cloud: &Cloud) -> Result<Box<dyn Ready>, MethodError>;
}

/// A method prepared for one cloud.
pub trait Ready: Send + Sync {
    /// Reflectance factors; errors are 0 for closed forms, estimates or standard errors elsewhere.
    ///
    /// # Errors
    /// [`MethodError`] if a point lies outside the domain or no radiance is given.
    fn radiances(&self, points: &[Point]) -> Result<Vec<Estimate>, MethodError>;

    /// R and T.
    ///
    /// # Errors
    /// [`MethodError`] if a point lies outside the domain or no flux is given.
    fn fluxes(&self, points: &[FluxPoint]) -> Result<Vec<FluxPair>, MethodError>;

    /// What a shader would run for each pixel; `None` for solvers and tracers.
    fn single(&self) -> Option<&dyn Single> {
        None
    }
}

/// One evaluation in single precision, unchecked: the caller stays inside the declared domain.
pub trait Single: Send + Sync {
    /// Reflectance factor; 0 where the card says that none is given.
    fn radiance(&self, tau: f32, sight: &Sight<f32>) -> f32;

    /// R and T; 0 where the card says that none are given.
    fn fluxes(&self, tau: f32, mu_l: f32) -> (f32, f32);
}
