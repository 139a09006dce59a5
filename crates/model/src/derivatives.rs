//! Analytic derivatives of the corrected form, for the fitter.
//!
//! T_ms by (β, b, c); T_1, T_2, R_1, R_2 by (κ_c, t, r). Thickness in the parameters' unit. Tested against
//! central differences.

use crate::{
    Parameters, Thickness,
    brackets::{once_each, rise, twice_back},
};

/// (∂T_ms/∂β, ∂T_ms/∂b, ∂T_ms/∂c).
pub fn t_ms(parameters: &Parameters<f64>, thickness: Thickness<f64>) -> [f64; 3] {
    let (v, h) = (parameters.values, thickness.get());
    let (denominator, onset) = (1.0 + parameters.slope * h, rise(v.c * h));
    let numerator = 1.0 - (1.0 - v.b) * onset;
    let by_beta = numerator * h / (v.beta * denominator * (v.beta * denominator));
    [by_beta, onset / denominator, -(1.0 - v.b) * h * libm::exp(-v.c * h) / denominator]
}

/// (∂T_1/∂κ_c, ∂T_1/∂t, ∂T_1/∂r).
pub fn t_1(parameters: &Parameters<f64>, thickness: Thickness<f64>) -> [f64; 3] {
    let (v, h) = (parameters.values, thickness.get());
    let x = v.kappa_c * h;
    let decay = libm::exp(-x);
    [v.t * h * (1.0 - x) * decay, x * decay, 0.0]
}

/// (∂T_2/∂κ_c, ∂T_2/∂t, ∂T_2/∂r).
pub fn t_2(parameters: &Parameters<f64>, thickness: Thickness<f64>) -> [f64; 3] {
    let (v, h) = (parameters.values, thickness.get());
    let x = v.kappa_c * h;
    let (decay, back) = (libm::exp(-x), twice_back(2.0 * x));
    let by_x = 0.5 * v.t * v.t * x * (2.0 - x) + 0.25 * v.r * v.r * (2.0 * rise(2.0 * x) - back);
    [by_x * decay * h, v.t * x * x * decay, 0.5 * v.r * decay * back]
}

/// (∂R_1/∂κ_c, ∂R_1/∂t, ∂R_1/∂r).
pub fn r_1(parameters: &Parameters<f64>, thickness: Thickness<f64>) -> [f64; 3] {
    let (v, h) = (parameters.values, thickness.get());
    let y = 2.0 * v.kappa_c * h;
    [v.r * h * libm::exp(-y), 0.0, 0.5 * rise(y)]
}

/// (∂R_2/∂κ_c, ∂R_2/∂t, ∂R_2/∂r).
pub fn r_2(parameters: &Parameters<f64>, thickness: Thickness<f64>) -> [f64; 3] {
    let (v, h) = (parameters.values, thickness.get());
    let y = 2.0 * v.kappa_c * h;
    let bracket = once_each(y);
    [v.r * v.t * h * y * libm::exp(-y), 0.5 * v.r * bracket, 0.5 * v.t * bracket]
}
