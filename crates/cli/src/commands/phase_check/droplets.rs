//! The droplets that the table should be of.

use crate::CliError;
use crate::args::PhaseCheckArgs;
use crate::config::Config;
use crate::output::Talk;
use crate::{pipeline, progress};
use stratiform_artifact::Extinction;
use stratiform_optics::OpticsConfig;
use stratiform_optics::droplets::DropletDistribution;
use stratiform_optics::ensemble::Ensemble;

/// Their optics at one wavelength.
pub(super) struct Droplets {
    pub(super) config: OpticsConfig,
    pub(super) ensemble: Ensemble,
    /// κ, where their number is known.
    pub(super) extinction: Option<Extinction>,
}

impl Droplets {
    /// Computed or taken from the cache; none if none were named.
    pub(super) fn of(
        args: &PhaseCheckArgs,
        config: Option<Config>,
        theta_f_deg: f64,
        talk: Talk,
    ) -> Result<Option<Self>, CliError> {
        let Some((mut config, has_number)) = named(args, config)? else { return Ok(None) };
        config.theta_f_deg = theta_f_deg;
        let spinner = progress::spinner("optics", talk.quiet);
        let ensembles = pipeline::optics::ensembles(&config);
        spinner.finish_and_clear();
        Ok(ensembles?.into_iter().next().map(|ensemble| Self {
            extinction: has_number.then_some(ensemble.extinction),
            ensemble,
            config,
        }))
    }
}

/// The droplets, and whether their number is known.
fn named(args: &PhaseCheckArgs, config: Option<Config>) -> Result<Option<(OpticsConfig, bool)>, CliError> {
    match (config, args.r_eff, args.gamma, args.wavelength) {
        (Some(mut config), ..) => {
            config.optics.wavelengths_um = vec![args.wavelength.unwrap_or(config.transport.wavelength_um)];
            Ok(Some((config.optics, true)))
        }
        (None, Some(effective_radius_um), Some(gamma), Some(wavelength)) => {
            let cloud = OpticsConfig {
                droplets: DropletDistribution::ModifiedGamma { effective_radius_um, gamma },
                number_density_per_cm3: args.n0.unwrap_or(1.0),
                wavelengths_um: vec![wavelength],
                refractive_index: Default::default(),
                theta_f_deg: super::THETA_F_DEG,
                tolerance: Default::default(),
            };
            Ok(Some((cloud, args.n0.is_some())))
        }
        (None, None, None, None) => Ok(None),
        _ => Err(CliError::Input("--wavelength needs --config or --r-eff and --gamma".to_owned())),
    }
}
