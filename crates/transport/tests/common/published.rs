//! Published fluxes of homogeneous slabs: van de Hulst 1980 and the DISORT test problems 1 to 5a.
//!
//! Their rounding (5 decimals or 6 digits) is far below the standard errors of the traces held against them.

use super::hg;
use std::sync::Arc;
use stratiform_optics::phase::{Isotropic, PhaseFunction, PhaseTable, Rayleigh};
use stratiform_quantities::Incidence;
use stratiform_reference_data::rows;

pub struct Published {
    pub name: String,
    pub phase: Arc<dyn PhaseFunction>,
    pub tau: f64,
    pub omega: f64,
    pub incidence: Incidence,
    pub reflectance: f64,
    pub transmittance: f64,
}

/// All cases of both sources.
pub fn published() -> Vec<Published> {
    let van_de_hulst = rows("van-de-hulst-1980", "fluxes.csv").unwrap().into_iter().map(van_de_hulst);
    van_de_hulst.chain(rows("disort-tests", "fluxes.csv").unwrap().into_iter().map(disort)).collect()
}

fn number(field: &str) -> f64 {
    field.parse().unwrap()
}

/// g, tau, omega, mu0, reflectance, transmittance.
fn van_de_hulst(row: Vec<String>) -> Published {
    Published {
        name: format!("van de Hulst g {} tau {}", row[0], row[1]),
        phase: hg(number(&row[0])),
        tau: number(&row[1]),
        omega: number(&row[2]),
        incidence: row[3].parse().unwrap(),
        reflectance: number(&row[4]),
        transmittance: number(&row[5]),
    }
}

/// case, phase, tau, omega, mu0, incident flux, flux up at the top, direct and diffuse flux down at the bottom.
fn disort(row: Vec<String>) -> Published {
    let incident = number(&row[5]);
    Published {
        name: format!("DISORT {}", row[0]),
        phase: phase(&row[1]),
        tau: number(&row[2]),
        omega: number(&row[3]),
        incidence: row[4].parse().unwrap(),
        reflectance: number(&row[6]) / incident,
        transmittance: (number(&row[7]) + number(&row[8])) / incident,
    }
}

fn phase(name: &str) -> Arc<dyn PhaseFunction> {
    match name.split_once(':') {
        None if name == "isotropic" => Arc::new(Isotropic),
        None if name == "rayleigh" => Arc::new(Rayleigh),
        Some(("hg", g)) => hg(number(g)),
        Some(("moments", file)) => Arc::new(from_coefficients(file)),
        _ => panic!("phase function `{name}`"),
    }
}

/// χ_l from the columns l, beta_l = (2l+1)χ_l.
pub fn coefficients(file: &str) -> Vec<f64> {
    let rows = rows::<(u32, f64)>("disort-tests", file).unwrap();
    rows.iter().map(|(l, beta)| beta / f64::from(2 * l + 1)).collect()
}

fn from_coefficients(file: &str) -> PhaseTable {
    PhaseTable::from_moments(&coefficients(file)).unwrap()
}
