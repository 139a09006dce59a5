//! Nanoseconds per radiance in f32 on one thread: the corrected model of Bouthors 2006 (row of the table, fluxes, I1, I2,
//! I3+) and single scattering with a fitted rest, over the same scattered sights and thicknesses.

#![expect(clippy::print_stdout, reason = "a benchmark prints its figures")]

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;
use stratiform_model::angular::{Angular, Emission, PhaseLookup, Sight};
use stratiform_model::radiance::{Coefficients, POWERS, Slab, TERMS};
use stratiform_model::table::{Angle, ParameterGrid};
use stratiform_model::{Form, Thickness, Values};
use stratiform_quantities::Side;

const COUNT: usize = 4096;
const REPEATS: usize = 60;
const NODES: usize = 1024;
const KEPT: f32 = 0.545;

/// Optical thickness and sight.
type Point = (f32, Sight<f32>);

/// Tables over √(v/2) = sin(Θ/2), read linearly.
struct Tables([Vec<f32>; 2]);

impl Tables {
    fn read(&self, table: usize, v: f32) -> f32 {
        let place = (0.5 * v).sqrt() * (NODES - 1) as f32;
        let node = (place as usize).min(NODES - 2);
        let pair = &self.0[table][node..node + 2];
        pair[0] + (place - node as f32) * (pair[1] - pair[0])
    }
}

impl PhaseLookup<f32> for Tables {
    fn full(&self, v: f32) -> f32 {
        self.read(0, v)
    }

    fn wide(&self, v: f32) -> f32 {
        self.read(0, v)
    }

    fn wide_squared(&self, v: f32) -> f32 {
        self.read(1, v)
    }
}

fn grid() -> Result<ParameterGrid<f32>, Box<dyn Error>> {
    let row = |i: i32| {
        let slant = 1.0 + 0.2 * f64::from(i);
        let values = Values {
            beta: 0.9,
            b: 1.2 - 0.08 * f64::from(i),
            c: 0.3,
            kappa_c: 0.6 * slant,
            t: 0.8,
            r: 0.06 * slant,
            kappa_s: 0.545,
        };
        Angle { theta_l_deg: 10.0 * f64::from(i), values }
    };
    Ok(ParameterGrid::new(&(0..10).map(row).collect::<Vec<_>>())?)
}

/// Scattered thicknesses and sights of both faces.
fn points() -> Result<Vec<Point>, Box<dyn Error>> {
    let fraction = |i: usize, step: f64| (0.5 + i as f64 * step).fract();
    let point = |i: usize| {
        let side = if fraction(i, 0.414_213_562) < 0.5 { Side::Top } else { Side::Bottom };
        let mu = |step| 0.18 + 0.82 * fraction(i, step);
        let sight =
            Sight::new(mu(0.819_172_513), mu(0.671_043_607), 180.0 * fraction(i, 0.549_700_478), side)?;
        Ok((libm::exp(4.0 * fraction(i, 0.618_033_989)) as f32, sight.cast()))
    };
    (0..COUNT).map(point).collect()
}

/// Fastest of some passes, ns per radiance.
fn measure(points: &[Point], radiance: impl Fn(f32, &Sight<f32>) -> f32) -> f64 {
    let mut best = f64::INFINITY;
    for _ in 0..REPEATS {
        let start = Instant::now();
        for (tau, sight) in points {
            black_box(radiance(*black_box(tau), black_box(sight)));
        }
        best = best.min(start.elapsed().as_secs_f64() * 1e9 / points.len() as f64);
    }
    best
}

fn main() -> Result<(), Box<dyn Error>> {
    let table = |scale: f32| (0..NODES).map(|i| scale / (1.0 + i as f32)).collect();
    let phase = Tables([table(20.0), table(8.0)]);
    let (grid, points) = (grid()?, points()?);
    let face: [[f32; TERMS]; POWERS] =
        std::array::from_fn(|j| std::array::from_fn(|k| 0.1 / (1 + j + k) as f32));
    let cloud = Coefficients { similarity: 0.147, kept: KEPT, top: face, bottom: face };
    let corrected = measure(&points, |tau, sight| {
        let (Ok(row), Ok(thickness)) = (grid.at(sight.mu_l), Thickness::new(tau)) else { return 0.0 };
        let fluxes = row.fluxes(Form::Corrected, thickness);
        Angular::unchecked(KEPT * tau, *sight).orders(&phase, &fluxes, Emission::Lambertian).total()
    });
    let fitted = measure(&points, |tau, sight| Slab::unchecked(&cloud, tau, *sight).radiance(&phase));
    let single = measure(&points, |tau, sight| Slab::unchecked(&cloud, tau, *sight).one(&phase));
    println!(
        "corrected {corrected:.1} ns, single scattering {single:.1} ns, with the fitted rest {fitted:.1} ns"
    );
    println!("ratio to corrected {:.2}", fitted / corrected);
    Ok(())
}
