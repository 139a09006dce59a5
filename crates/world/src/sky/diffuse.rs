//! Light that air has scattered more than once: four moments of the radiance by height.
//!
//! Scalar Rayleigh scattering, P = ¾(1 + cos²Θ), knows of the light only J = ½∫I0 dμ, K = ½∫μ²I0 dμ, A = ¼∫μ√(1-μ²) I1 dμ and
//! B = ¼∫(1-μ²) I2 dμ, where I = I0 + I1 cosφ + I2 cos2φ (S. Chandrasekhar, Radiative Transfer (1950), sections 16 and 71). What it gives
//! back is ⅜[(3-μ²)J + (3μ²-1)K] + (3/2) μ√(1-μ²) A cosφ + ⅜(1-μ²) B cos2φ. A beam E from (μ_s, φ = 0) has the moments
//! E/4π (1, μ_s², μ_s√(1-μ_s²), 1-μ_s²). So successive orders are summed exactly but for the quadrature, in plane
//! layers with the beam's own path round the earth. Aerosol scatters evenly, with (1-g) of its strength. μ > 0 looks up.

use super::air::{Air, Columns, Slant};
use std::f64::consts::PI;
use stratiform_optics::phase::gauss_legendre;

/// Where the air ends, m.
pub(super) const TOP_M: f64 = 80_000.0;
/// Layers, thin at the ground.
const LAYERS: usize = 40;
/// Directions of a hemisphere.
const DIRECTIONS: usize = 16;
/// The last order adds less than this share.
const LAST: f64 = 1e-7;
const MOST_ORDERS: usize = 500;

/// J, K, A, B.
pub(super) type Moments = [f64; 4];

/// The diffuse light of one wavelength per irradiance of the beam above the air.
#[derive(Clone, Debug)]
pub(super) struct Diffuse {
    layers: Vec<Moments>,
}

/// A layer: optical thickness, and the shares that molecules and aerosol scatter.
struct Layer {
    thickness: f64,
    molecules: f64,
    aerosol: f64,
}

/// Moments by layer, and the irradiance of the ground.
struct Field {
    layers: Vec<Moments>,
    ground: f64,
}

impl Diffuse {
    /// The sun's cosine is `sun`.
    pub(super) fn new(air: &Air, columns: &Columns, sun: f64) -> Self {
        let layers: Vec<Layer> = (0..LAYERS).map(|k| layer(air, columns, k)).collect();
        let rule: Vec<(f64, f64)> =
            gauss_legendre(DIRECTIONS).into_iter().map(|(x, w)| (0.5 * (1.0 + x), 0.5 * w)).collect();
        let mut order = beam(air, columns, sun);
        let mut sum = vec![[0.0; 4]; LAYERS];
        for _ in 0..MOST_ORDERS {
            order = scattered(&layers, &rule, &order, air.ground_albedo);
            add(&mut sum, &order.layers);
            let brightest = |field: &[Moments]| field.iter().fold(0.0, |most: f64, m| most.max(m[0]));
            if brightest(&order.layers) <= LAST * brightest(&sum) {
                break;
            }
        }
        Self { layers: sum }
    }

    /// The moments at a height, linear between the middles of the layers.
    pub(super) fn at(&self, altitude_m: f64) -> Moments {
        let most = (LAYERS - 1) as f64;
        let place = (LAYERS as f64 * (altitude_m / TOP_M).max(0.0).sqrt() - 0.5).clamp(0.0, most);
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "between 0 and the number of layers"
        )]
        let below = (place as usize).min(LAYERS - 2);
        let t = place - below as f64;
        std::array::from_fn(|i| {
            self.layers[below][i] + t * (self.layers[below + 1][i] - self.layers[below][i])
        })
    }
}

/// What molecules scatter towards a viewer who looks along (`mu`, `cosine` of the azimuth), over their scattering coefficient.
pub(super) fn rayleigh([j, k, a, b]: Moments, mu: f64, cosine: f64) -> f64 {
    let square = 1.0 - mu * mu;
    let [even, one, two] = modes([j, k, a, b], mu, square);
    even + one * cosine + two * (2.0 * cosine * cosine - 1.0)
}

fn modes([j, k, a, b]: Moments, mu: f64, square: f64) -> [f64; 3] {
    let even = 0.375 * ((3.0 - mu * mu) * j + (3.0 * mu * mu - 1.0) * k);
    [even, 1.5 * mu * square.sqrt() * a, 0.375 * square * b]
}

/// Lower bound of a layer, m.
fn bound(k: usize) -> f64 {
    let share = k as f64 / LAYERS as f64;
    TOP_M * share * share
}

fn layer(air: &Air, columns: &Columns, k: usize) -> Layer {
    let share = |height: f64| libm::exp(-bound(k) / height) - libm::exp(-bound(k + 1) / height);
    let molecules = columns.molecules * share(air.molecules_height_m);
    let aerosol = columns.aerosol * share(air.aerosol_height_m);
    let thickness = molecules + air.similar_share() * aerosol;
    let scattered = air.aerosol_albedo * (1.0 - air.aerosol_asymmetry) * aerosol;
    Layer { thickness, molecules: molecules / thickness, aerosol: scattered / thickness }
}

/// The sun's light before it is scattered: in each layer its mean.
fn beam(air: &Air, columns: &Columns, sun: f64) -> Field {
    let light = |k: usize| {
        let slant = Slant::new(air, bound(k), sun);
        slant.map_or(0.0, |slant| libm::exp(-slant.thickness(columns, air.similar_share())))
    };
    let lights: Vec<f64> = (0..=LAYERS).map(light).collect();
    let square = 1.0 - sun * sun;
    let unit = [1.0, sun * sun, sun * square.sqrt(), square];
    let mean = |pair: &[f64]| match libm::log(pair[1] / pair[0]) {
        rise if rise.is_finite() && rise > 1e-9 => (pair[1] - pair[0]) / rise,
        _ => 0.5 * (pair[0] + pair[1]),
    };
    let layers = lights.windows(2).map(|pair| unit.map(|moment| mean(pair) * moment / (4.0 * PI))).collect();
    Field { layers, ground: sun * lights[0] }
}

/// The light that `from` becomes by one more event.
fn scattered(layers: &[Layer], rule: &[(f64, f64)], from: &Field, albedo: f64) -> Field {
    let mut to = Field { layers: vec![[0.0; 4]; LAYERS], ground: 0.0 };
    for (mu, weight) in rule {
        let mut light = [0.0; 3];
        let rows = || layers.iter().zip(&from.layers);
        for ((layer, moments), into) in rows().zip(&mut to.layers).rev() {
            pass(layer, *moments, (*mu, *weight), &mut light, into);
        }
        to.ground += 2.0 * PI * weight * mu * light[0];
        let mut light = [albedo * from.ground / PI, 0.0, 0.0];
        for ((layer, moments), into) in rows().zip(&mut to.layers) {
            pass(layer, *moments, (-mu, *weight), &mut light, into);
        }
    }
    to
}

/// Light passes a layer, and is counted there.
fn pass(layer: &Layer, from: Moments, (mu, weight): (f64, f64), light: &mut [f64; 3], into: &mut Moments) {
    let square = 1.0 - mu * mu;
    let mut source = modes(from, mu, square).map(|mode| layer.molecules * mode);
    source[0] += layer.aerosol * from[0];
    let path = layer.thickness / mu.abs();
    let lost = -libm::expm1(-path);
    let mean: [f64; 3] = std::array::from_fn(|m| source[m] + (light[m] - source[m]) * lost / path);
    for m in 0..3 {
        light[m] += (source[m] - light[m]) * lost;
    }
    into[0] += 0.5 * weight * mean[0];
    into[1] += 0.5 * weight * mu * mu * mean[0];
    into[2] += 0.25 * weight * mu * square.sqrt() * mean[1];
    into[3] += 0.25 * weight * square * mean[2];
}

fn add(sum: &mut [Moments], other: &[Moments]) {
    for (total, part) in sum.iter_mut().zip(other) {
        for i in 0..4 {
            total[i] += part[i];
        }
    }
}
