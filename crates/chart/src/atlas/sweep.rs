//! One method over one plane.

use super::class::{Case, Class};
use super::clouds::{CloudAt, Phases};
use super::plane::{Density, Place, Plane};
use super::truth::{Four, truths};
use crate::{ChartError, Quantity};
use rayon::prelude::*;
use std::path::Path;
use stratiform_methods::{Card, Cloud, FluxPoint, Method, Point, Promise, Ready, Single};
use stratiform_model::angular::Sight;
use stratiform_quantities::Side;
use stratiform_stats::Estimate;

/// κH beyond which tracers are not asked.
const THICKEST_TRACED: f64 = 10.0;

/// A plane with its clouds and truth.
pub struct Sheet {
    /// Which.
    pub plane: Plane,
    /// Its places; without cloud where none can be made.
    pub places: Vec<(Place, Option<Cloud>)>,
    /// What is true there, in the order of [`Quantity::ALL`].
    pub truths: Vec<Four>,
}

impl Sheet {
    /// Clouds and truth of a plane. Radii without a phase function are left out.
    ///
    /// # Errors
    /// [`ChartError`] of the solver.
    pub fn new(
        plane: Plane,
        density: Density,
        phases: &Phases,
        cache: Option<&Path>,
    ) -> Result<Self, ChartError> {
        let mut clouds: Vec<(CloudAt, Option<Cloud>)> = Vec::new();
        let mut places = Vec::new();
        for place in plane.places(density).into_iter().filter(|place| phases.has(place.cloud.r_eff_um)) {
            let known = clouds.iter().find(|(at, _)| *at == place.cloud).map(|(_, cloud)| cloud.clone());
            let cloud = known.unwrap_or_else(|| {
                let made = phases.cloud(place.cloud).ok();
                clouds.push((place.cloud, made.clone()));
                made
            });
            places.push((place, cloud));
        }
        let truths = truths(&places, cache)?;
        Ok(Self { plane, places, truths })
    }

    /// The places that a tracer can be asked for: analog photons need 2τ events each.
    #[must_use]
    pub fn traceable(&self) -> Self {
        self.only(|place| place.point.tau <= THICKEST_TRACED)
    }

    /// The places of a thinner plane.
    #[must_use]
    pub fn thin(&self) -> Self {
        let wanted = self.plane.places(Density::Thin);
        self.only(|place| wanted.contains(place))
    }

    fn only(&self, wanted: impl Fn(&Place) -> bool) -> Self {
        let kept: Vec<usize> = (0..self.places.len()).filter(|i| wanted(&self.places[*i].0)).collect();
        Self {
            plane: self.plane,
            places: kept.iter().map(|i| self.places[*i].clone()).collect(),
            truths: kept.iter().map(|i| self.truths[*i]).collect(),
        }
    }
}

/// In which precision.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// Double.
    F64,
    /// Single: what a shader runs.
    F32,
}

impl Precision {
    /// Its name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::F64 => "f64",
            Self::F32 => "f32",
        }
    }
}

/// One value and what it is worth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Where.
    pub place: Place,
    /// Of what.
    pub quantity: Quantity,
    /// How.
    pub precision: Precision,
    /// The verdict.
    pub class: Class,
    /// What the method said.
    pub value: Option<f64>,
    /// What is true.
    pub truth: Option<f64>,
}

impl Cell {
    /// (value - truth)/truth, if both are known.
    pub fn error(&self) -> Option<f64> {
        let (value, truth) = self.value.zip(self.truth)?;
        Some((value - truth) / truth).filter(|error| error.is_finite())
    }
}

/// Every value that `method` gives on a sheet.
pub fn sweep(method: &dyn Method, sheet: &Sheet) -> Vec<Cell> {
    let card = method.card();
    let mut clouds: Vec<(CloudAt, Vec<usize>)> = Vec::new();
    for (i, (place, _)) in sheet.places.iter().enumerate() {
        match clouds.iter_mut().find(|(at, _)| *at == place.cloud) {
            Some((_, places)) => places.push(i),
            None => clouds.push((place.cloud, vec![i])),
        }
    }
    let of_cloud = |(_, places): &(CloudAt, Vec<usize>)| {
        let cloud = sheet.places[places[0]].1.as_ref();
        let ready = cloud.and_then(|cloud| method.prepare(cloud).ok());
        let asked = Asked { card, cloud, ready: ready.as_deref(), sheet, places };
        let mut cells = Vec::new();
        for quantity in Quantity::ALL {
            match quantity {
                Quantity::Radiance(side) if card.radiance => cells.extend(asked.radiances(side)),
                Quantity::Reflectance if card.flux && sheet.plane.has_fluxes() => {
                    cells.extend(asked.fluxes())
                }
                _ => {}
            }
        }
        cells
    };
    clouds.par_iter().flat_map_iter(of_cloud).collect()
}

/// One cloud's places of a sheet.
struct Asked<'a> {
    card: &'a Card,
    cloud: Option<&'a Cloud>,
    ready: Option<&'a dyn Ready>,
    sheet: &'a Sheet,
    places: &'a [usize],
}

impl Asked<'_> {
    fn radiances(&self, side: Side) -> Vec<Cell> {
        let points: Vec<Point> =
            self.places.iter().map(|i| Point { side, ..self.sheet.places[*i].0.point }).collect();
        let values = answers(self.ready, &points, |ready, points| ready.radiances(points));
        let promise = self.card.promises.radiance.as_ref();
        let mut cells = Vec::new();
        for ((place, point), value) in self.places.iter().zip(&points).zip(values) {
            let judged = Judged {
                place: *place,
                quantity: Quantity::Radiance(side),
                inside: self.is_inside(|| self.card.domain.check(point).is_ok()),
                promise: self.cloud.and_then(|cloud| promise.filter(|promise| promise.covers(cloud, point))),
            };
            let single = self.single(value).and_then(|single| {
                let sight = Sight::new(point.mu_l, point.mu_v, point.phi_deg, side).ok()?;
                Some(f64::from(single.radiance(point.tau as f32, &sight.cast())))
            });
            cells.extend(self.judge(&judged, value, single));
        }
        cells
    }

    fn fluxes(&self) -> Vec<Cell> {
        let point = |i: &usize| {
            let Point { tau, mu_l, .. } = self.sheet.places[*i].0.point;
            FluxPoint { tau, mu_l }
        };
        let points: Vec<FluxPoint> = self.places.iter().map(point).collect();
        let pairs = answers(self.ready, &points, |ready, points| ready.fluxes(points));
        let promise = self.card.promises.flux.as_ref();
        let mut cells = Vec::new();
        for ((place, point), pair) in self.places.iter().zip(&points).zip(pairs) {
            let inside = self.is_inside(|| self.card.domain.check_flux(point).is_ok());
            let promise = self.cloud.and_then(|cloud| promise.filter(|one| one.covers_flux(cloud, point)));
            let reflected = pair.map(|pair| pair.reflectance);
            let single =
                self.single(reflected).map(|single| single.fluxes(point.tau as f32, point.mu_l as f32));
            let of = |quantity| Judged { place: *place, quantity, inside, promise };
            let through = pair.map(|pair| pair.transmittance);
            cells.extend(self.judge(&of(Quantity::Reflectance), reflected, single.map(|pair| pair.0.into())));
            cells.extend(self.judge(&of(Quantity::Transmittance), through, single.map(|pair| pair.1.into())));
        }
        cells
    }

    /// Whether the declared domain includes cloud and point.
    fn is_inside(&self, point: impl Fn() -> bool) -> bool {
        self.cloud.is_some_and(|cloud| self.card.domain.check_cloud(cloud).is_ok()) && point()
    }

    /// What a shader runs, where double precision answers: it checks nothing itself.
    fn single(&self, double: Option<Estimate>) -> Option<&dyn Single> {
        double.and(self.ready)?.single()
    }

    fn judge(&self, judged: &Judged<'_>, value: Option<Estimate>, single: Option<f64>) -> Vec<Cell> {
        let quantity = judged.quantity;
        let at = Quantity::ALL.iter().position(|one| *one == quantity).unwrap_or_default();
        let truth = self.sheet.truths[judged.place][at];
        let flux = !matches!(quantity, Quantity::Radiance(_));
        let case = Case { value, inside: judged.inside, flux, double: None, promise: judged.promise, truth };
        let cell = |precision, case: Case<'_>| Cell {
            place: self.sheet.places[judged.place].0,
            quantity,
            precision,
            class: case.class(),
            value: case.value.map(|value| value.value),
            truth: truth.map(|truth| truth.value),
        };
        let mut cells = vec![cell(Precision::F64, case)];
        let is_shader = self.card.table_bytes.is_some();
        if is_shader {
            let value = single.map(|value| Estimate { value, std_error: 0.0 });
            let double = case.value.map(|value| value.value);
            cells.push(cell(Precision::F32, Case { value, double, ..case }));
        }
        cells
    }
}

/// What one quantity at one place is judged by.
struct Judged<'a> {
    place: usize,
    quantity: Quantity,
    inside: bool,
    promise: Option<&'a Promise>,
}

/// All together; where one is refused, each alone.
fn answers<P, T: Copy, E>(
    ready: Option<&dyn Ready>,
    points: &[P],
    ask: impl Fn(&dyn Ready, &[P]) -> Result<Vec<T>, E>,
) -> Vec<Option<T>> {
    let Some(ready) = ready else { return points.iter().map(|_| None).collect() };
    match ask(ready, points) {
        Ok(values) if values.len() == points.len() => values.into_iter().map(Some).collect(),
        _ => {
            let alone = |point| ask(ready, std::slice::from_ref(point)).ok();
            points.iter().map(|point| alone(point).and_then(|values| values.first().copied())).collect()
        }
    }
}
