//! The figures, one file each. A figure is data in [`crate::chart`] terms; what its inputs lack, it lacks.

mod agreement;
mod convergence;
mod droplets;
mod ladder;
mod misfit;
mod orders;
mod parameters;
mod phase;
mod principal_plane;
mod quadrature;
mod solver_cost;

use crate::chart::Figure;
use crate::input::Inputs;
pub use ladder::RUNGS;
pub use orders::chosen_angles;

/// All figures that the inputs allow, in the order of the page.
pub fn all(inputs: &Inputs) -> Vec<Figure> {
    let mut figures = vec![droplets::figure(&inputs.optics), phase::figure(inputs)];
    figures.extend(chosen_angles(&inputs.orders).into_iter().map(|theta| orders::figure(inputs, theta)));
    figures.extend(inputs.principal_plane.iter().flat_map(|rows| principal_plane::figures(rows)));
    figures.push(parameters::figure(inputs));
    figures.push(misfit::figure(inputs));
    figures.extend(inputs.agreement.as_ref().map(|(document, rows)| agreement::figure(document, rows)));
    figures.extend(inputs.ladder.as_deref().map(ladder::figure));
    figures.extend(inputs.convergence.as_deref().map(convergence::figure));
    figures.extend(inputs.solver_cost.as_deref().map(solver_cost::figure));
    figures.extend(inputs.quadrature.as_deref().map(quadrature::figure));
    figures
}
