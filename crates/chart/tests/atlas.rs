//! The contract of every method: inside its declared domain finite values that are not negative, in both precisions, and within its
//! promise; outside a refusal. Every way to break it is caught.
#![allow(clippy::unwrap_used, reason = "a test may stop where it fails")]

use std::sync::LazyLock;
use stratiform_chart::atlas::{
    BASE_RADIUS_UM, Cell, Class, CloudAt, Density, Input, Phases, Plane, Sheet, answered_outside, sweep,
};
use stratiform_methods::{
    Card, Cloud, Domain, FluxPair, FluxPoint, Method, MethodError, Point, Promise, Promises, Ready, all,
    by_name,
};
use stratiform_optics::phase::{Norm, PhaseTable};
use stratiform_quantities::Range;
use stratiform_stats::Estimate;

static PHASES: LazyLock<Phases> = LazyLock::new(|| {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fit-configs/appendix-b/accepted/phase_full.csv");
    Phases::one(BASE_RADIUS_UM, PhaseTable::read(path.as_ref(), Norm::Strict).unwrap())
});

static SHEETS: LazyLock<Vec<Sheet>> = LazyLock::new(|| {
    let planes = [Input::MuL, Input::PhiDeg, Input::Omega].map(|y| Plane { x: Input::Tau, y });
    planes.map(|plane| Sheet::new(plane, Density::Thin, &PHASES, None).unwrap()).into()
});

fn cells(method: &dyn Method) -> Vec<Cell> {
    SHEETS.iter().flat_map(|sheet| sweep(method, sheet)).collect()
}

/// Tracers and solvers have contracts of their own in `transport`.
fn is_formula(method: &dyn Method) -> bool {
    method.card().table_bytes.is_some()
}

#[test]
fn formulas_keep_their_contract() {
    for method in all().iter().filter(|method| is_formula(&***method)) {
        let found = cells(&**method);
        let name = &method.card().name;
        let broken: Vec<&Cell> = found.iter().filter(|cell| !cell.class.is_allowed()).collect();
        assert!(broken.is_empty(), "{name}: {} of {}: {broken:?}", broken.len(), found.len());
        assert!(found.iter().any(|cell| cell.value.is_some()), "{name} refuses everything");
        let promises = &method.card().promises;
        if promises.radiance.is_some() || promises.flux.is_some() {
            assert!(
                found.iter().any(|cell| cell.class == Class::Ok),
                "{name}: no promise was put to the test"
            );
        }
    }
}

#[test]
fn every_end_of_every_range_is_guarded() {
    for method in all() {
        let answered = answered_outside(&*method, &PHASES, CloudAt::BASE);
        assert!(answered.is_empty(), "{}: {answered:?}", method.card().name);
    }
}

/// How the planted method goes wrong.
#[derive(Clone, Copy)]
enum Fault {
    NotFinite,
    Negative,
    AboveOne,
    TooFar,
    NeverRefuses,
}

struct Planted {
    card: Card,
    fault: Fault,
}

struct PlantedReady {
    fault: Fault,
    card: Card,
}

impl Planted {
    fn new(fault: Fault) -> Self {
        let card = by_name("delta-eddington").unwrap().card().clone();
        let domain = Domain { tau: Range::closed(0.0, 100.0), omega: Range::closed(0.0, 1.0), ..card.domain };
        let promise = Promise::relative(0.1, domain.clone());
        let promises = Promises { radiance: None, flux: matches!(fault, Fault::TooFar).then_some(promise) };
        Self { card: Card { domain, promises, ..card }, fault }
    }
}

impl Method for Planted {
    fn card(&self) -> &Card {
        &self.card
    }

    fn prepare(&self, _cloud: &Cloud) -> Result<Box<dyn Ready>, MethodError> {
        Ok(Box::new(PlantedReady { fault: self.fault, card: self.card.clone() }))
    }
}

/// 0.5, but for one place, κH = 3.
impl Ready for PlantedReady {
    fn radiances(&self, points: &[Point]) -> Result<Vec<Estimate>, MethodError> {
        let of = |point: &Point| {
            if !matches!(self.fault, Fault::NeverRefuses) {
                self.card.domain.check(point)?;
            }
            let value = match self.fault {
                Fault::NotFinite if point.tau == 3.0 => f64::NAN,
                Fault::Negative if point.tau == 3.0 => -1e-12,
                _ => 0.5,
            };
            Ok(Estimate { value, std_error: 0.0 })
        };
        points.iter().map(of).collect()
    }

    fn fluxes(&self, points: &[FluxPoint]) -> Result<Vec<FluxPair>, MethodError> {
        let of = |point: &FluxPoint| {
            if !matches!(self.fault, Fault::NeverRefuses) {
                self.card.domain.check_flux(point)?;
            }
            let value = if matches!(self.fault, Fault::AboveOne) && point.tau == 3.0 { 1.01 } else { 0.5 };
            let half = Estimate { value, std_error: 0.0 };
            Ok(FluxPair { reflectance: half, transmittance: half })
        };
        points.iter().map(of).collect()
    }
}

#[test]
fn planted_faults_are_caught() {
    for (fault, class) in [
        (Fault::NotFinite, Class::NotFinite),
        (Fault::Negative, Class::Negative),
        (Fault::AboveOne, Class::AboveOne),
        (Fault::TooFar, Class::OverBound),
        (Fault::NeverRefuses, Class::NotRefused),
    ] {
        let planted = Planted::new(fault);
        let found = cells(&planted);
        assert!(found.iter().any(|cell| cell.class == class), "{class:?}");
        let other = |cell: &&Cell| !cell.class.is_allowed() && cell.class != class;
        assert_eq!(found.iter().find(other), None, "{class:?}");
    }
    let answered = answered_outside(&Planted::new(Fault::NeverRefuses), &PHASES, CloudAt::BASE);
    assert!(answered.iter().any(|what| what.starts_with("tau")), "{answered:?}");
    assert!(answered.iter().any(|what| what.contains("NaN")), "{answered:?}");
}
