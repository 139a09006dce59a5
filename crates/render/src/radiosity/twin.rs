//! The passes on the CPU in f64: the same sums as the device's, and the exchange alone for any sources.

use super::{Plan, RadiosityError, Slab, Weights};
use stratiform_world::{HeightField, Map};

/// A linear sRGB triple per texel, row by row from the south.
pub type Light = Vec<[f64; 3]>;

/// Two facing planes on the texels of an exchange.
#[derive(Clone, Debug)]
pub struct Planes {
    /// From plane to plane.
    pub weights: Weights,
    /// ρ_G.
    pub ground_albedo: Light,
    /// ρ_C.
    pub cloud_albedo: Light,
    /// S_G, irradiance.
    pub ground_source: Light,
    /// S_C, radiosity.
    pub cloud_source: Light,
}

/// What the planes receive of each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Received {
    /// R_G, without S_G.
    pub ground: Light,
    /// R_C.
    pub cloud: Light,
}

impl Planes {
    /// After this many pairs of passes, ground to cloud and back.
    pub fn exchange(&self, passes: u32) -> Received {
        let mut ground = self.weights.gather(&self.cloud_source);
        let mut cloud = vec![[0.0; 3]; ground.len()];
        let mut given_back = times(&self.ground_albedo, &sum(&ground, &self.ground_source));
        for _ in 0..passes {
            let up = self.weights.gather(&given_back);
            cloud = sum(&cloud, &up);
            let down = self.weights.gather(&times(&self.cloud_albedo, &up));
            ground = sum(&ground, &down);
            given_back = times(&self.ground_albedo, &down);
        }
        Received { ground, cloud }
    }
}

/// S_G per texel of the height field.
///
/// # Errors
/// [`RadiosityError::Model`] outside the parameters' domain.
pub fn ground_direct(field: &HeightField, slab: &Slab, plan: &Plan) -> Result<Light, RadiosityError> {
    let (map, n) = (field.map(), plan.field_side);
    let along = |i: usize, offset: f64| (i as f64 + 0.5 + offset) / n as f64 * map.extent_m();
    let at = |i: usize| {
        let thickness = field.thickness(along(i % n, plan.offset[0]), along(i / n, plan.offset[1]));
        let f = slab.beam(plan.mu_l, plan.extinction_per_m * thickness)?;
        Ok(plan.sun.map(|sun| plan.mu_l * (f.t_0 + f.t_1 + f.t_2) * sun))
    };
    (0..n * n).map(at).collect()
}

/// The planes of a plan; `direct` of [`ground_direct`].
///
/// # Errors
/// [`RadiosityError`] outside the parameters' domain.
pub fn planes(
    field: &HeightField,
    slab: &Slab,
    plan: &Plan,
    direct: Light,
) -> Result<Planes, RadiosityError> {
    let direct = Map::new(plan.field_side, plan.texels.extent_m, direct)
        .map_err(|error| RadiosityError::Contents(error.to_string()))?;
    let means = plan.texels.means(|x, y| {
        let tau = plan.extinction_per_m * field.thickness(x, y);
        let (beam, diffuse, [r, g, b]) = (slab.beam(plan.mu_l, tau)?, slab.diffuse(tau)?, direct.value(x, y));
        Ok::<_, RadiosityError>([beam.t_3_plus, diffuse.t_ms, diffuse.r_ms, r, g, b])
    })?;
    let source = |beam: f64, through: f64| {
        std::array::from_fn(|c| beam * plan.source_mu * plan.sun[c] + through * plan.sky[c])
    };
    Ok(Planes {
        weights: plan.weights.clone(),
        ground_albedo: plan.ground_albedo.clone(),
        cloud_albedo: means.iter().map(|mean| [mean[2]; 3]).collect(),
        ground_source: means.iter().map(|mean| [mean[3], mean[4], mean[5]]).collect(),
        cloud_source: means.iter().map(|mean| source(mean[0], mean[1])).collect(),
    })
}

fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|c| a[c] + b[c])
}

fn sum(a: &[[f64; 3]], b: &[[f64; 3]]) -> Light {
    a.iter().zip(b).map(|(a, b)| add(*a, *b)).collect()
}

fn times(albedo: &[[f64; 3]], light: &[[f64; 3]]) -> Light {
    albedo.iter().zip(light).map(|(a, e)| std::array::from_fn(|c| a[c] * e[c])).collect()
}
