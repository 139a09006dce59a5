//! The droplets of an atlas: phase functions by effective radius, clouds by θ_f and ω.

use crate::ChartError;
use std::path::Path;
use std::sync::Arc;
use stratiform_methods::Cloud;
use stratiform_optics::droplets::DropletDistribution;
use stratiform_optics::phase::PhaseTable;
use stratiform_optics::{OpticsConfig, OpticsError, compute, load_or_compute};
use stratiform_quantities::SingleScatteringAlbedo;

/// r_e of Bouthors, Neyret & Lefebvre 2006, µm; the cloud of the fitted tables.
pub const BASE_RADIUS_UM: f64 = 7.0;

/// What tells the clouds of an atlas apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CloudAt {
    /// r_e.
    pub r_eff_um: f64,
    /// θ_f.
    pub theta_f_deg: f64,
    /// ω.
    pub omega: f64,
}

impl CloudAt {
    /// The paper's.
    pub const BASE: Self = Self { r_eff_um: BASE_RADIUS_UM, theta_f_deg: 5.0, omega: 1.0 };
}

/// Phase functions that are known.
#[derive(Clone, Debug)]
pub struct Phases(Vec<(f64, Arc<PhaseTable>)>);

impl Phases {
    /// One droplet size.
    pub fn one(r_eff_um: f64, phase: PhaseTable) -> Self {
        Self(vec![(r_eff_um, Arc::new(phase))])
    }

    /// Of these radii at 0.55 µm, from the cache or computed.
    ///
    /// # Errors
    /// [`ChartError::Optics`].
    pub fn of_radii(radii: &[f64], cache: Option<&Path>) -> Result<Self, ChartError> {
        let one = |radius: &f64| Ok((*radius, Arc::new(phase(*radius, cache)?)));
        Ok(Self(radii.iter().map(one).collect::<Result<_, OpticsError>>()?))
    }

    /// The cloud at `at`, but said to have another effective radius.
    ///
    /// # Errors
    /// As [`cloud`](Self::cloud).
    pub fn relabelled(&self, at: CloudAt, r_eff_um: f64) -> Result<Cloud, ChartError> {
        let cloud = self.cloud(at)?;
        let phase = cloud.phase().as_ref().clone();
        Ok(Cloud::new(phase, cloud.omega(), at.theta_f_deg, Some(r_eff_um))?)
    }

    /// Whether there is this radius.
    pub fn has(&self, r_eff_um: f64) -> bool {
        self.0.iter().any(|(known, _)| *known == r_eff_um)
    }

    /// A cloud; refused as [`Cloud::new`] does, θ_f = 0 for example, or because its radius is not here.
    ///
    /// # Errors
    /// [`ChartError`].
    pub fn cloud(&self, at: CloudAt) -> Result<Cloud, ChartError> {
        let missing = || OpticsError::Config(format!("no phase function for r_e = {} um", at.r_eff_um));
        let (_, phase) = self.0.iter().find(|(radius, _)| *radius == at.r_eff_um).ok_or_else(missing)?;
        let omega = SingleScatteringAlbedo::new(at.omega)?;
        Ok(Cloud::new(phase.as_ref().clone(), omega, at.theta_f_deg, Some(at.r_eff_um))?)
    }
}

fn phase(effective_radius_um: f64, cache: Option<&Path>) -> Result<PhaseTable, OpticsError> {
    let config = OpticsConfig {
        droplets: DropletDistribution::ModifiedGamma { gamma: 2.0, effective_radius_um },
        number_density_per_cm3: 300.0,
        wavelengths_um: vec![0.55],
        refractive_index: Default::default(),
        theta_f_deg: CloudAt::BASE.theta_f_deg,
        tolerance: Default::default(),
    };
    let found = match cache.map(|folder| load_or_compute(&config, folder)) {
        // A cache that cannot be read or written is no reason to stop.
        None | Some(Err(OpticsError::Artifact(_))) => compute(&config),
        Some(result) => result,
    }?;
    let none = || OpticsError::Config("no optics at 0.55 um".to_owned());
    Ok(found.into_iter().next().ok_or_else(none)?.phase)
}
