//! `ladder.csv`: one approximation after another, each with what it alone loses.
//!
//! | rung | compared with | at | isolates |
//! | --- | --- | --- | --- |
//! | `solver` | nothing: its own estimated error | table, half-way | discretisation |
//! | `monte-carlo` | solver | table | noise; beside it the σ expected; of the fluxes that were traced |
//! | `model` | solver, f64 both | table | the model's form, with the emitted parameters |
//! | `f32` | model in f64, same parameters | table | single precision |
//! | `interpolation` | f32 model with parameters fitted half-way | half-way | the table's gaps |
//! | `shader` | f32 model with the interpolated table | table, half-way | the device's arithmetic |
//! | `together` | solver | table, half-way | all of them: f32, interpolated table |
//!
//! *table*: the table's angles and diffuse light; *half-way*: the angles between; both at every thickness of the fit. The
//! model is compared with the solver, not with photons, so that their noise stays on its own rung. The parameters fitted
//! half-way share the table's β. Losses are absolute, in shares of the incident flux.

pub(in crate::pipeline) mod loss;
mod shader;

use super::curves;
use super::fluxes::{between, light, nodes};
use super::optics::Cloud;
use crate::CliError;
use crate::config::Config;
use loss::{Fluxes, Nine, Place, Step, at, not_measured, places};
pub use shader::Device;
use std::fmt::Write as _;
use std::path::Path;
use stratiform_artifact::{LadderRow, ParametersDocument, RowIncidence, read_csv, read_json, write_csv};
use stratiform_codegen::{diffuse_parameters, parameter_grid};
use stratiform_fit::{FitConfig, ParameterBounds, Reference};
use stratiform_model::table::{ParameterGrid, cos_degrees};
use stratiform_model::{Form, ModelError, Parameters, Real, Thickness, Values};
use stratiform_quantities::Incidence;

/// Folders of the two sources, relative to the pipeline's.
pub struct Folders {
    /// The solver's fluxes.
    pub solved: &'static str,
    /// The photons', if there are any.
    pub traced: Option<&'static str>,
}

/// Measures every rung and writes the file.
///
/// # Errors
/// [`CliError::Input`] for a missing or damaged artifact, [`CliError::Failed`] if a device refuses the emitted shader.
pub fn write(
    config: &Config,
    cloud: &Cloud,
    parameters: &ParametersDocument,
    folders: &Folders,
    device: &Device,
    dir: &Path,
) -> Result<Vec<String>, CliError> {
    let tau = cloud.tau(config);
    let ladder = Ladder {
        parameters,
        at_nodes: places(&nodes(config), &tau),
        half_way: places(&between(config), &tau),
        everywhere: places(&[nodes(config), between(config)].concat(), &tau),
        solved: read_csv(&dir.join(folders.solved).join("reference.csv"))?,
    };
    let mut rows = ladder.solver()?;
    rows.extend(ladder.monte_carlo(folders.traced.map(|folder| dir.join(folder)).as_deref())?);
    rows.extend(ladder.model()?);
    rows.extend(ladder.single()?);
    let references: Vec<Reference> = read_json(&dir.join(folders.solved).join("reference_between.json"))?;
    let table = direct_fit(config, parameters, &references)?;
    rows.extend(ladder.interpolation(&table)?);
    rows.extend(ladder.shader(device, dir)?);
    rows.extend(ladder.together()?);
    write_csv(&dir.join("ladder.csv"), &rows)?;
    Ok(vec!["ladder.csv".to_owned()])
}

/// Parameters fitted half-way between the table's angles, with the table's β.
fn direct_fit(
    config: &Config,
    parameters: &ParametersDocument,
    references: &[Reference],
) -> Result<ParametersDocument, CliError> {
    let beta = parameters.optical.beta.value;
    let settings = FitConfig {
        theta_l_deg: between(config).iter().filter_map(RowIncidence::degrees).collect(),
        shared_beta_up_to_deg: 90.0,
        bounds: ParameterBounds { beta: [beta * (1.0 - 1e-12), beta], ..config.fit.bounds },
        thickness_m: config.fit.thickness_m,
    };
    stratiform_fit::fit(&settings, references, parameters.medium.clone(), parameters.provenance.clone())
        .map_err(super::input_error)
}

struct Ladder<'a> {
    parameters: &'a ParametersDocument,
    at_nodes: Vec<Place>,
    half_way: Vec<Place>,
    everywhere: Vec<Place>,
    solved: Vec<stratiform_codegen::ReferencePoint>,
}

impl Ladder<'_> {
    fn solver(&self) -> Result<Vec<LadderRow>, CliError> {
        let errors = at(&self.everywhere, &self.solved)?.errors;
        let exact = vec![[0.0; 9]; errors.len()];
        let note = "estimated by the solver".to_owned();
        Ok(step("solver", &self.everywhere, &exact, &errors, note).rows())
    }

    fn monte_carlo(&self, folder: Option<&Path>) -> Result<Vec<LadderRow>, CliError> {
        let Some(folder) = folder else {
            return Ok(vec![not_measured("monte-carlo", "the config has no photons")]);
        };
        let traced: Vec<_> = read_csv(&folder.join("reference.csv"))?;
        let Fluxes { known, values, errors } = at(&self.at_nodes, &traced)?;
        let solved = at(&self.at_nodes, &self.solved)?.values;
        let step = step("monte-carlo", &self.at_nodes, &solved, &values, String::new());
        Ok(Step { chance: Some(&errors), known, ..step }.rows())
    }

    fn model(&self) -> Result<Vec<LadderRow>, CliError> {
        let solved = at(&self.at_nodes, &self.solved)?.values;
        let model = self.fitted::<f64>(&self.at_nodes, self.parameters)?;
        Ok(step("model", &self.at_nodes, &solved, &model, String::new()).rows())
    }

    fn single(&self) -> Result<Vec<LadderRow>, CliError> {
        let double = self.fitted::<f64>(&self.at_nodes, self.parameters)?;
        let single = self.fitted::<f32>(&self.at_nodes, self.parameters)?;
        Ok(step("f32", &self.at_nodes, &double, &single, String::new()).rows())
    }

    fn interpolation(&self, direct: &ParametersDocument) -> Result<Vec<LadderRow>, CliError> {
        let fitted = self.fitted::<f32>(&self.half_way, direct)?;
        let interpolated = self.interpolated(&self.half_way)?;
        Ok(step("interpolation", &self.half_way, &fitted, &interpolated, String::new()).rows())
    }

    fn shader(&self, device: &Device, dir: &Path) -> Result<Vec<LadderRow>, CliError> {
        let adapter = match device.name() {
            Ok(adapter) => adapter.to_owned(),
            Err(reason) => return Ok(vec![not_measured("shader", reason)]),
        };
        let mut inputs = Vec::new();
        for place in &self.everywhere {
            let mu = match light(&place.row)? {
                Incidence::Beam(mu) => f32::of(mu.get()),
                Incidence::Diffuse => -1.0,
            };
            inputs.push([mu, f32::of(place.tau)]);
        }
        let executed = device.evaluate(dir, &inputs)?;
        let twin = self.interpolated(&self.everywhere)?;
        Ok(step("shader", &self.everywhere, &twin, &executed, adapter).rows())
    }

    fn together(&self) -> Result<Vec<LadderRow>, CliError> {
        let solved = at(&self.everywhere, &self.solved)?.values;
        let emitted = self.interpolated(&self.everywhere)?;
        Ok(step("together", &self.everywhere, &solved, &emitted, String::new()).rows())
    }

    /// The model with the parameters fitted at each place's own row.
    fn fitted<F: Real>(
        &self,
        places: &[Place],
        document: &ParametersDocument,
    ) -> Result<Vec<Nine>, CliError> {
        let one = |place: &Place| {
            let row = document.optical.rows.iter().find(|row| row.theta_l_deg == place.row);
            let missing = || CliError::Input(format!("no parameters at theta_l = {}", place.row));
            let values = curves::emitted(&document.optical, row.ok_or_else(missing)?);
            fluxes(&parameters::<F>(&values, light(&place.row)?)?, place.tau)
        };
        places.iter().map(one).collect()
    }

    /// The model in single precision with the table interpolated, as shaders do.
    fn interpolated(&self, places: &[Place]) -> Result<Vec<Nine>, CliError> {
        let optical = &self.parameters.optical;
        let grid: ParameterGrid<f32> = parameter_grid(optical).map_err(super::input_error)?;
        let diffuse: Parameters<f32> = diffuse_parameters(optical).map_err(super::input_error)?;
        let one = |place: &Place| match place.row.degrees() {
            Some(degrees) => fluxes(&grid.at(f32::of(cos_degrees(degrees))).map_err(model)?, place.tau),
            None => fluxes(&diffuse, place.tau),
        };
        places.iter().map(one).collect()
    }
}

fn step<'a>(
    rung: &'static str,
    places: &'a [Place],
    before: &'a [Nine],
    after: &'a [Nine],
    note: String,
) -> Step<'a> {
    Step { rung, places, before, after, chance: None, known: [true; 9], note }
}

fn model(error: ModelError) -> CliError {
    super::input_error(error)
}

fn parameters<F: Real>(values: &Values<f64>, incidence: Incidence) -> Result<Parameters<F>, CliError> {
    Parameters::new(values, incidence).map_err(model)
}

fn fluxes<F: Real>(parameters: &Parameters<F>, tau: f64) -> Result<Nine, CliError> {
    let thickness = Thickness::new(F::of(tau)).map_err(model)?;
    Ok(parameters.fluxes(Form::Corrected, thickness).named().map(|(_, value)| value.to_f64()))
}

/// The ladder for a terminal: T_ms and the worst of the orders, up to 80 degrees.
pub fn table(rows: &[LadderRow]) -> String {
    let mut text = format!(
        "{:<14} {:>9} {:>9}   {:>9} {:>9}  worst of all at\n",
        "ladder to 80", "T_ms rms", "worst", "order rms", "worst"
    );
    let mut rungs: Vec<&str> = rows.iter().map(|row| row.rung.as_str()).collect();
    rungs.dedup();
    for rung in rungs {
        let here = || rows.iter().filter(|row| row.rung == rung);
        let steep = || here().filter(|row| row.angles == LadderRow::TO_80);
        let size = |row: &&LadderRow| row.worst.unwrap_or(0.0);
        let order = || steep().filter(|row| row.quantity != "t_ms");
        let most = |rms: fn(&LadderRow) -> Option<f64>| order().filter_map(rms).fold(0.0, f64::max);
        let total = steep().find(|row| row.quantity == "t_ms");
        match (total, steep().max_by(|a, b| size(a).total_cmp(&size(b)))) {
            (Some(total), Some(worst)) => {
                let [rms, largest] = [total.rms, total.worst].map(|x| x.unwrap_or(0.0));
                let _ = writeln!(
                    text,
                    "{rung:<14} {rms:>9.1e} {largest:>9.1e}   {:>9.1e} {:>9.1e}  {} at {} deg, tau {:.3}",
                    most(|row| row.rms),
                    most(|row| row.worst),
                    worst.quantity,
                    worst.worst_theta_l_deg,
                    worst.worst_tau.unwrap_or(0.0)
                );
            }
            _ => here().for_each(|row| {
                let _ = writeln!(text, "{rung:<14} {}", row.note);
            }),
        }
    }
    text.pop();
    text
}
