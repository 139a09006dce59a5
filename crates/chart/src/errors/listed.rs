//! Which methods are listed, and what they cost.

use super::ErrorsError;
use super::rows::{flux_point, point};
use std::hint::black_box;
use std::time::{Duration, Instant};
use stratiform_artifact::{ErrorBlock, ErrorMethod, ErrorRow};
use stratiform_methods::{Cloud, Method, MethodError, Single, all, by_name, knobs};
use stratiform_model::angular::Sight;

/// Sizes of phase tables that are listed.
const TEXELS: [f64; 3] = [64.0, 256.0, 1024.0];

/// A method under its name, with the size of its phase table.
pub struct Listed {
    /// What it is.
    pub method: Box<dyn Method>,
    /// The name without what changes no cost.
    stem: String,
    texels: Option<u64>,
}

/// Every method, turned through the values of its knob.
///
/// # Errors
/// [`MethodError`].
pub fn listed() -> Result<Vec<Listed>, MethodError> {
    let mut list = Vec::new();
    for method in all() {
        let name = method.card().name.clone();
        let stem = name.split(':').next().unwrap_or_default().to_owned();
        let Some(knob) = knobs(&stem).filter(|_| method.card().table_bytes.is_some()) else {
            list.push(Listed { method, stem, texels: None });
            continue;
        };
        let texels = knob.counts == "texels";
        for value in knob.values.iter().filter(|value| !texels || TEXELS.contains(*value)) {
            let name = format!("{stem}:{value}");
            let stem = if texels { stem.clone() } else { name.clone() };
            list.push(Listed { method: by_name(&name)?, stem, texels: texels.then_some(*value as u64) });
        }
    }
    list.retain(|one| one.method.card().table_bytes.is_some());
    Ok(list)
}

/// Their records, costs measured at `cloud` over the points of `rows`.
///
/// # Errors
/// [`ErrorsError::Method`].
pub(super) fn records(
    methods: &[Listed],
    cloud: &Cloud,
    rows: &[ErrorRow],
) -> Result<Vec<ErrorMethod>, ErrorsError> {
    let (fluxes, seen): (Vec<_>, Vec<_>) = rows.iter().partition(|row| row.block == ErrorBlock::Flux);
    let seen: Vec<(f32, Sight<f32>)> = seen
        .iter()
        .step_by(seen.len() / 500 + 1)
        .map(|row| {
            let p = point(row);
            Ok((p.tau as f32, Sight::new(p.mu_l, p.mu_v, p.phi_deg, p.side)?.cast()))
        })
        .collect::<Result<_, MethodError>>()?;
    let fluxes: Vec<(f32, f32)> =
        fluxes.iter().map(|row| flux_point(row)).map(|p| (p.tau as f32, p.mu_l as f32)).collect();
    let mut records: Vec<ErrorMethod> = Vec::new();
    for one in methods {
        let card = one.method.card();
        let same =
            methods.iter().position(|other| other.stem == one.stem).and_then(|first| records.get(first));
        let costs = match same {
            // Sizes of a table do not change what is computed: differences would be noise.
            Some(first) => [first.ns, first.flux_ns],
            None => costs(one.method.prepare(cloud)?.single(), &seen, &fluxes),
        };
        records.push(ErrorMethod {
            name: card.name.clone(),
            title: card.title.to_owned(),
            radiance: card.radiance,
            flux: card.flux,
            ns: costs[0].filter(|_| card.radiance),
            flux_ns: costs[1].filter(|_| card.flux),
            table_bytes: card.table_bytes.unwrap_or(0) as u64,
            texels: one.texels,
        });
    }
    Ok(records)
}

fn costs(single: Option<&dyn Single>, seen: &[(f32, Sight<f32>)], fluxes: &[(f32, f32)]) -> [Option<f64>; 2] {
    let Some(single) = single else { return [None, None] };
    [
        Some(ns_each(seen, |(tau, sight)| single.radiance(*tau, sight))),
        Some(ns_each(fluxes, |(tau, mu_l)| {
            let (reflectance, transmittance) = single.fluxes(*tau, *mu_l);
            reflectance + transmittance
        })),
    ]
}

/// Nanoseconds per call, to 0.1: the quickest of several runs.
fn ns_each<T>(inputs: &[T], call: impl Fn(&T) -> f32) -> f64 {
    let run = || {
        let (start, mut calls) = (Instant::now(), 0_usize);
        while start.elapsed() < Duration::from_millis(3) {
            black_box(inputs.iter().fold(0.0_f32, |sum, input| sum + call(black_box(input))));
            calls += inputs.len();
        }
        1e9 * start.elapsed().as_secs_f64() / calls as f64
    };
    let quickest = (0..9).map(|_| run()).fold(f64::INFINITY, f64::min);
    (quickest * 10.0).round() / 10.0
}
