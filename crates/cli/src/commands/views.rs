//! What `trace` and `solve` share of radiance: suns and views as typed, rows as printed.

use crate::CliError;
use crate::args::ViewArgs;
use crate::commands::order_rows;
use stratiform_artifact::RadianceResult;
use stratiform_quantities::{Incidence, Order, Side};
use stratiform_stats::Estimate;
use stratiform_transport::solve::View;

/// Suns, none of them diffuse.
///
/// # Errors
/// [`CliError::Input`] naming the word that is no cosine.
pub fn cosines(words: &[String]) -> Result<Vec<f64>, CliError> {
    let cosine = |incidence| {
        match incidence {
        Incidence::Beam(mu0) => Ok(mu0.get()),
        Incidence::Diffuse => Err(CliError::Input(
            "--mu0 diffuse: radiance needs a sun; by reciprocity, what diffuse light sends towards mu is the reflectance \
             and transmittance that `solve --mu0` without views lists for that mu"
                .to_owned(),
        )),
    }
    };
    order_rows::parse_incidences(words)?.into_iter().map(cosine).collect()
}

/// Every μ at every azimuth, above and below.
pub fn views(args: &ViewArgs) -> Vec<View> {
    let azimuths = if args.phi.is_empty() { &[0.0][..] } else { &args.phi };
    let mut views = Vec::new();
    for &mu in &args.view_mu {
        for &phi_deg in azimuths {
            views.extend([Side::Top, Side::Bottom].map(|side| View { side, mu, phi_deg }));
        }
    }
    views
}

/// A row of the document.
pub fn result(
    (tau, mu0): (f64, f64),
    view: &View,
    order: Order,
    estimate: Estimate,
    settled: Option<bool>,
) -> RadianceResult {
    let View { side, mu, phi_deg } = *view;
    let Estimate { value, std_error } = estimate;
    RadianceResult { tau, mu0, mu, phi_deg, side, order, value, std_error, settled }
}
