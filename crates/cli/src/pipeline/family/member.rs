//! One member of a family: optics, fluxes from the solver, and the table fitted to them.

use super::phase::texels;
use crate::CliError;
use crate::config::Config;
use crate::pipeline::cut::Cut;
use crate::pipeline::fluxes::nodes;
use crate::pipeline::ladder::loss::{Place, places};
use crate::pipeline::optics::{ensembles, of_ensemble, optics_error};
use crate::pipeline::reference::Media;
use crate::pipeline::{solved, source};
use stratiform_artifact::{Extinction, FamilyMember, ParametersDocument};
use stratiform_codegen::ReferencePoint;
use stratiform_optics::phase::{PhaseFunction, PhaseTable};

/// Everything that is known of one effective radius.
pub struct Computed {
    /// r_e, µm.
    pub radius_um: f64,
    /// g_S.
    pub modified_asymmetry: f64,
    /// P of the full medium.
    pub full: PhaseTable,
    /// P_S convolved with itself.
    pub squared: PhaseTable,
    /// The fitted table.
    pub parameters: ParametersDocument,
    /// Incidences and optical thicknesses of the fit.
    pub places: Vec<Place>,
    /// The solver's fluxes there.
    pub points: Vec<ReferencePoint>,
    number_density_per_cm3: f64,
    extinction: Extinction,
}

impl Computed {
    /// Computes the member of the config's family at `radius_um`.
    ///
    /// # Errors
    /// Those of optics, solver and fit.
    pub fn new(config: &Config, radius_um: f64) -> Result<Self, CliError> {
        let config = at_radius(config, radius_um)?;
        let mut ensembles = ensembles(&config.optics)?;
        let ensemble = ensembles.pop().ok_or_else(|| CliError::Input("no wavelength".to_owned()))?;
        let extinction = ensemble.extinction;
        let cloud = of_ensemble(&config, ensemble)?;
        let tau = cloud.tau(&config);
        let referred = solved::solve(&config, &Media::new(&config, &cloud)?, &tau, &nodes(&config))?;
        let mut points = Vec::new();
        for one in &referred {
            points.extend(one.fluxes.points(&config)?);
        }
        let references: Vec<_> = referred.into_iter().map(|one| one.reference).collect();
        let parameters = source::fit(&config, &cloud, &references, crate::pipeline::provenance(&config))?;
        let cut = Cut::new(&cloud, config.optics.theta_f_deg)?;
        Ok(Self {
            radius_um,
            modified_asymmetry: cut.wide.asymmetry(),
            squared: cut.squared,
            full: cloud.phase,
            parameters,
            places: places(&nodes(&config), &tau),
            points,
            number_density_per_cm3: config.optics.number_density_per_cm3,
            extinction,
        })
    }

    /// What is kept of it.
    pub fn artifact(&self) -> FamilyMember {
        FamilyMember {
            effective_radius_um: self.radius_um,
            number_density_per_cm3: self.number_density_per_cm3,
            extinction_per_m: self.extinction,
            modified_asymmetry: self.modified_asymmetry,
            phase: texels(&self.full),
            phase_squared: texels(&self.squared),
            parameters: self.parameters.clone(),
        }
    }
}

/// The config at another effective radius and the same N0 π r_e², at the transport's wavelength alone.
fn at_radius(config: &Config, radius_um: f64) -> Result<Config, CliError> {
    let mut changed = config.clone();
    let own = config.optics.resolve().map_err(optics_error)?.effective_radius();
    let ratio = own / radius_um;
    changed.optics.number_density_per_cm3 *= ratio * ratio;
    changed.optics.droplets = config.optics.droplets.at_effective_radius(radius_um).map_err(optics_error)?;
    changed.optics.wavelengths_um = vec![config.transport.wavelength_um];
    Ok(changed)
}
