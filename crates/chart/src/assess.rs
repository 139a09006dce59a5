//! One method held against one scene.
//!
//! Shader code is held against every point. Solvers and tracers, which have no [`Single`](stratiform_methods::Single), are held
//! against a part of the main cloud's points only, the ends of the ranges of thickness and sun and every third view, and timed
//! while they answer.

use crate::cost::{Effort, alone, flux_ns, radiance_ns};
use crate::parallel::side_by_side;
use crate::{ChartError, CloudSample, Quantity, Sample, Statistics, Watch};
use stratiform_methods::{Card, FluxPair, FluxPoint, Method, MethodError, Point, Ready};
use stratiform_stats::Estimate;

/// Of the views, solvers and tracers are asked for one in so many.
const EVERY: usize = 3;

/// [`assess`] of every method, in their order: shader code one after the other, whose times are short, then solvers and tracers side by
/// side, a thread each.
///
/// # Errors
/// As [`assess`], and [`ChartError::Cancelled`].
pub(crate) fn assess_all(
    methods: &[&dyn Method],
    sample: &Sample,
    effort: Effort,
    watch: Watch<'_>,
) -> Result<Vec<Vec<Assessment>>, ChartError> {
    let one =
        |place: &usize| watch.over(|| assess(methods[*place], sample, effort)).map(|found| (*place, found));
    let (shaders, others): (Vec<usize>, Vec<usize>) =
        (0..methods.len()).partition(|place| methods[*place].card().table_bytes.is_some());
    let mut found = shaders.iter().map(one).collect::<Result<Vec<_>, _>>()?;
    found.extend(side_by_side(&others, one).into_iter().collect::<Result<Vec<_>, _>>()?);
    found.sort_by_key(|(place, _)| *place);
    Ok(found.into_iter().map(|(_, found)| found).collect())
}

/// How a method fared.
#[derive(Clone, Debug, PartialEq)]
pub struct Assessment {
    /// In what.
    pub quantity: Quantity,
    /// Points with a truth.
    pub points: usize,
    /// Points without.
    pub excluded: usize,
    /// Of the points with a truth: not answered.
    pub refused: usize,
    /// Answered by no finite number.
    pub not_finite: usize,
    /// Errors of the rest; `None` of none.
    pub statistics: Option<Statistics>,
    /// Cost of one evaluation.
    pub ns: Option<f64>,
    /// Whether `ns` is one evaluation in f32 (or a share of a batch).
    pub single: bool,
}

/// Errors and counts as they come in.
struct Tally {
    quantity: Quantity,
    errors: Vec<f64>,
    excluded: usize,
    refused: usize,
    not_finite: usize,
    ns: Option<f64>,
    single: bool,
}

impl Tally {
    fn new(quantity: Quantity) -> Self {
        Self { quantity, errors: Vec::new(), excluded: 0, refused: 0, not_finite: 0, ns: None, single: false }
    }

    /// Counts an answer; `None` is a refusal.
    fn count(&mut self, answer: Option<f64>, truth: f64) {
        match answer {
            None => self.refused += 1,
            Some(value) if value.is_finite() => self.errors.push((value - truth) / truth),
            Some(_) => self.not_finite += 1,
        }
    }

    fn finish(self) -> Assessment {
        Assessment {
            quantity: self.quantity,
            points: self.errors.len() + self.refused + self.not_finite,
            excluded: self.excluded,
            refused: self.refused,
            not_finite: self.not_finite,
            statistics: Statistics::of(&self.errors),
            ns: self.ns,
            single: self.single,
        }
    }
}

/// Errors and costs of what `method` gives and the scene shows.
///
/// # Errors
/// [`ChartError::Method`] if a cost cannot be measured.
pub fn assess(method: &dyn Method, sample: &Sample, effort: Effort) -> Result<Vec<Assessment>, ChartError> {
    let mut tallies = Quantity::ALL.map(Tally::new);
    for (place, one) in sample.clouds.iter().enumerate() {
        let ready = method.card().domain.check_cloud(&one.cloud).and_then(|()| method.prepare(&one.cloud));
        let slow = matches!(&ready, Ok(ready) if ready.single().is_none());
        if slow && place > 0 {
            continue;
        }
        let asked =
            Asked { card: method.card(), ready: ready.as_deref().ok(), one, slow, effort, main: place == 0 };
        if method.card().radiance {
            asked.radiances(&mut tallies)?;
        }
        if method.card().flux {
            asked.fluxes(&mut tallies)?;
        }
    }
    let asked = |tally: &Tally| match tally.quantity {
        Quantity::Radiance(side) => method.card().radiance && sample.scene.view.sides.contains(&side),
        _ => method.card().flux,
    };
    Ok(tallies.into_iter().filter(asked).map(Tally::finish).collect())
}

/// A method at one cloud.
struct Asked<'a> {
    card: &'a Card,
    /// `None` if the cloud was refused.
    ready: Option<&'a dyn Ready>,
    one: &'a CloudSample,
    slow: bool,
    effort: Effort,
    /// Costs are measured at the main cloud.
    main: bool,
}

impl Asked<'_> {
    fn radiances(&self, tallies: &mut [Tally; 4]) -> Result<(), ChartError> {
        let all = self.one.grid.points();
        let views = self.one.grid.views().len();
        let place = |quantity| Quantity::ALL.iter().position(|one| *one == quantity).unwrap_or_default();
        let mut points = Vec::new();
        for (i, point) in all
            .iter()
            .enumerate()
            .filter(|(i, _)| self.is_asked(i / views) && (!self.slow || (i % views).is_multiple_of(EVERY)))
        {
            let tally = &mut tallies[place(Quantity::Radiance(point.side))];
            match self.one.truth.radiances[i] {
                None => tally.excluded += 1,
                Some(_) if self.card.domain.check(point).is_err() => tally.refused += 1,
                Some(truth) => points.push((*point, truth.value)),
            }
        }
        let inputs: Vec<Point> = points.iter().map(|(point, _)| *point).collect();
        let (answers, ns) = self.answer(&inputs, |ready, points| ready.radiances(points))?;
        for ((point, truth), answer) in points.iter().zip(&answers) {
            let value = answer.map(|estimate: Estimate| estimate.value);
            tallies[place(Quantity::Radiance(point.side))].count(value, *truth);
        }
        for tally in tallies.iter_mut().filter(|_| self.main) {
            let Quantity::Radiance(side) = tally.quantity else { continue };
            let there: Vec<Point> = inputs.iter().copied().filter(|point| point.side == side).collect();
            let single = self.ready.and_then(|ready| ready.single());
            tally.single = !self.slow;
            tally.ns = match single {
                Some(single) => radiance_ns(single, &there, self.effort)?,
                None => ns,
            };
        }
        Ok(())
    }

    fn fluxes(&self, tallies: &mut [Tally; 4]) -> Result<(), ChartError> {
        let all = self.one.grid.flux_points();
        let asked = all.iter().enumerate().filter(|(i, _)| self.is_asked(*i));
        let (inside, outside): (Vec<_>, Vec<_>) =
            asked.partition(|(_, point)| self.card.domain.check_flux(point).is_ok());
        let inputs: Vec<FluxPoint> = inside.iter().map(|(_, point)| **point).collect();
        let (answers, ns) = self.answer(&inputs, |ready, points| ready.fluxes(points))?;
        let [.., reflectance, transmittance] = tallies;
        for ((i, _), answer) in inside.iter().zip(&answers) {
            let truth = self.one.truth.flux(*i);
            reflectance.count(answer.map(|pair: FluxPair| pair.reflectance.value), truth.reflectance.value);
            transmittance.count(answer.map(|pair| pair.transmittance.value), truth.transmittance.value);
        }
        let single = self.ready.and_then(|ready| ready.single());
        let ns = single.map_or(ns, |single| flux_ns(single, &inputs, self.effort));
        for tally in [reflectance, transmittance] {
            tally.refused += outside.len();
            if self.main {
                (tally.ns, tally.single) = (ns, !self.slow);
            }
        }
        Ok(())
    }

    /// Whether the sun and thickness of that place among the flux points are asked for.
    fn is_asked(&self, place: usize) -> bool {
        let (suns, thicknesses) = (self.one.grid.theta_l_deg.len(), self.one.grid.tau.len());
        let end = |i: usize, count: usize| i == 0 || i + 1 == count;
        !self.slow || (end(place / thicknesses, suns) && end(place % thicknesses, thicknesses))
    }

    /// An answer or a refusal for each point, and for batches the time of one.
    fn answer<P: Sync, T: Copy + Send>(
        &self,
        points: &[P],
        ask: impl Fn(&dyn Ready, &[P]) -> Result<Vec<T>, MethodError> + Sync,
    ) -> Result<(Vec<Option<T>>, Option<f64>), ChartError> {
        let Some(ready) = self.ready else { return Ok((points.iter().map(|_| None).collect(), None)) };
        if !self.slow || points.is_empty() {
            return Ok((answers(ready, points, &ask), None));
        }
        let (answers, ns) = alone(|| answers(ready, points, &ask))?;
        Ok((answers, Some(ns / points.len() as f64)))
    }
}

/// All together; where one is refused, each alone.
fn answers<P, T: Copy>(
    ready: &dyn Ready,
    points: &[P],
    ask: &impl Fn(&dyn Ready, &[P]) -> Result<Vec<T>, MethodError>,
) -> Vec<Option<T>> {
    match ask(ready, points) {
        Ok(values) if values.len() == points.len() => values.into_iter().map(Some).collect(),
        Err(MethodError::NotGiven { .. }) => points.iter().map(|_| None).collect(),
        _ => points
            .iter()
            .map(|point| {
                ask(ready, std::slice::from_ref(point)).ok().and_then(|values| values.first().copied())
            })
            .collect(),
    }
}
