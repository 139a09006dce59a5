//! MEDIUM on the command line: a phase function by name or file, an albedo, full or modified.

use crate::args::MediumArgs;
use crate::config::Config;
use crate::{CliError, numbers, pipeline};
use std::path::Path;
use std::sync::Arc;
use stratiform_artifact::TracedMedium;
use stratiform_optics::OpticsError;
use stratiform_optics::phase::{
    Draine, HenyeyGreenstein, Isotropic, Modified, Norm, PhaseFunction, PhaseTable, Rayleigh,
};
use stratiform_quantities::{Asymmetry, Medium as Kind, SingleScatteringAlbedo};
use stratiform_transport::TraceMedium;

/// What light is traced through, with what artifacts say about it.
pub struct Medium {
    record: TracedMedium,
    traced: TraceMedium,
}

/// A phase function with what came along with it.
struct Source {
    phase: Arc<dyn PhaseFunction>,
    omega: Option<SingleScatteringAlbedo>,
    config: Option<Config>,
    extinction_per_m: Option<f64>,
}

impl Source {
    fn of(phase: impl PhaseFunction + 'static) -> Self {
        Self { phase: Arc::new(phase), omega: None, config: None, extinction_per_m: None }
    }
}

impl Medium {
    /// Understands what was typed; reads the file it names; for `config:` computes the optics.
    ///
    /// # Errors
    /// [`CliError::Input`] naming what is wrong.
    pub fn parse(args: &MediumArgs) -> Result<Self, CliError> {
        let norm = if args.renormalise { Norm::Any } else { Norm::Strict };
        let source = source(&args.phase, norm)?;
        let omega = match args.omega {
            Some(omega) => SingleScatteringAlbedo::new(omega)?,
            None => source.omega.unwrap_or(SingleScatteringAlbedo::CONSERVATIVE),
        };
        let config = source.config.as_ref();
        let mut record = TracedMedium {
            phase: args.phase.clone(),
            single_scattering_albedo: omega.get(),
            asymmetry: source.phase.asymmetry(),
            medium: Kind::Full,
            theta_f_deg: None,
            forward_fraction: None,
            wavelength_um: config.map(|config| config.transport.wavelength_um),
            extinction_convention: config.map(|c| c.transport.extinction_convention),
            extinction_per_m: source.extinction_per_m,
        };
        let traced = match args.modified {
            None => TraceMedium::full(source.phase, omega),
            Some(theta_f_deg) => {
                let modified = Modified::new(source.phase, theta_f_deg)?;
                let forward_fraction = modified.forward_fraction();
                record.medium = Kind::Modified;
                record.theta_f_deg = Some(theta_f_deg);
                record.forward_fraction = Some(forward_fraction);
                TraceMedium::modified(Arc::new(modified), omega, forward_fraction)
                    .map_err(pipeline::trace_error)?
            }
        };
        Ok(Self { record, traced })
    }

    /// What artifacts say about it.
    pub fn record(&self) -> &TracedMedium {
        &self.record
    }

    /// What the tracers need.
    pub fn traced(&self) -> &TraceMedium {
        &self.traced
    }
}

fn source(phase: &str, norm: Norm) -> Result<Source, CliError> {
    let (name, rest) = phase.split_once(':').unwrap_or((phase, ""));
    let input = |message: String| CliError::Input(format!("--phase {phase}: {message}"));
    let asymmetry = |g: f64| Asymmetry::new(g).map_err(|error| input(error.to_string()));
    match (name, rest) {
        ("isotropic", "") => Ok(Source::of(Isotropic)),
        ("rayleigh", "") => Ok(Source::of(Rayleigh)),
        ("hg", g) => Ok(Source::of(HenyeyGreenstein::new(asymmetry(numbers::finite(g).map_err(input)?)?))),
        ("draine", pair) => {
            let [g, alpha] = numbers::pair(pair).map_err(input)?;
            Ok(Source::of(Draine::new(asymmetry(g)?, alpha).map_err(|error| input(error.to_string()))?))
        }
        ("moments" | "table", _) => phase_table(phase, norm).map(Source::of),
        ("config", file) => from_config(Path::new(file)),
        _ => Err(CliError::Input(format!(
            "--phase {phase}: not one of isotropic, rayleigh, hg:G, draine:G,ALPHA, moments:FILE, table:FILE, config:FILE"
        ))),
    }
}

/// The phase function of `moments:FILE`, `table:FILE` or `config:FILE` as a table.
///
/// # Errors
/// [`CliError::Input`] naming what is wrong.
pub fn phase_table(phase: &str, norm: Norm) -> Result<PhaseTable, CliError> {
    match phase.split_once(':') {
        Some(("moments", file)) => named(file, PhaseTable::read_moments(Path::new(file))),
        Some(("table", file)) => named(file, PhaseTable::read(Path::new(file), norm)),
        Some(("config", file)) => {
            Ok(pipeline::optics::at_transport_wavelength(&Config::load(Path::new(file))?)?.phase)
        }
        _ => {
            Err(CliError::Input(format!("--phase {phase}: not one of moments:FILE, table:FILE, config:FILE")))
        }
    }
}

/// The table read from `file`; what is wrong with the numbers is told with the file's name.
fn named(file: &str, table: Result<PhaseTable, OpticsError>) -> Result<PhaseTable, CliError> {
    table.map_err(|error| match error {
        OpticsError::Artifact(error) => error.into(),
        other => CliError::Input(format!("{file}: {other}")),
    })
}

fn from_config(file: &Path) -> Result<Source, CliError> {
    let config = Config::load(file)?;
    let cloud = pipeline::optics::at_transport_wavelength(&config)?;
    Ok(Source {
        phase: Arc::new(cloud.phase),
        omega: Some(cloud.omega),
        extinction_per_m: Some(cloud.extinction_per_m),
        config: Some(config),
    })
}
