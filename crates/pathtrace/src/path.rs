//! One path from the camera back to what lit it.

use crate::halo;
use crate::layer::{End, Ray};
use crate::light::{Light, mean};
use crate::random::{cosine, exponential, level, turned, uniform};
use crate::scene::Scene;
use crate::sunlight::balanced;
use glam::DVec3;
use rand::Rng;
use rand_pcg::Pcg32;
use std::f64::consts::PI;
use stratiform_world::Contribution;

/// The path's colour.
pub(crate) struct Carrier {
    /// The channel that is sampled.
    pub(crate) channel: usize,
    /// Products of phase functions over their mean.
    pub(crate) ratio: [f64; 3],
    /// The ground's share so far, roulette included.
    tint: [f64; 3],
}

/// A path under way.
struct Path<'a> {
    scene: &'a Scene<'a>,
    ray: Ray,
    carrier: Carrier,
    /// Wide events so far.
    wide: u32,
    /// Whether the ground was touched, and whether before any wide event.
    ground: bool,
    behind: bool,
    light: Light,
}

/// Traces one path.
pub(crate) fn trace(scene: &Scene<'_>, mut ray: Ray, rng: &mut Pcg32) -> Light {
    ray.direction = level(ray.direction);
    let mut light = Light::default();
    if scene.sunlit {
        halo::collect(scene, &ray, rng, &mut light);
    }
    let channel = (uniform(rng) * 3.0) as usize;
    let carrier = Carrier { channel, ratio: [1.0; 3], tint: [1.0; 3] };
    let mut path = Path { scene, ray, carrier, wide: 0, ground: false, behind: false, light };
    while path.fly(rng) {}
    path.light
}

impl Path<'_> {
    /// To the next event; whether the path goes on.
    fn fly(&mut self, rng: &mut Pcg32) -> bool {
        let length = exponential(rng) / self.scene.extinction;
        match self.scene.layer.follow(&self.ray, length) {
            End::Inside(t) => {
                self.ray.origin = self.ray.at(t);
                self.scatter(rng)
            }
            End::Left(_) if self.ray.direction.z > 0.0 => {
                self.leave();
                false
            }
            End::Left(_) => self.touch_ground(rng),
        }
    }

    fn scatter(&mut self, rng: &mut Pcg32) -> bool {
        let scene = self.scene;
        if scene.albedo < 1.0 && uniform(rng) >= scene.albedo {
            return false;
        }
        let channel = self.carrier.channel;
        let v = if uniform(rng) < scene.forward[channel] {
            scene.phases.forward(channel, rng.next_u32())
        } else {
            if scene.sunlit {
                self.collect_sun(rng);
            }
            self.wide += 1;
            scene.phases.wide(channel, rng.next_u32())
        };
        self.carrier.ratio = balanced(self.carrier.ratio, scene.phases.values(v));
        self.ray.direction = turned(self.ray.direction, v, rng);
        true
    }

    /// Sunlight that a wide event sends along the path. The event is wide by chance 1 - P_f of the path's own channel.
    fn collect_sun(&mut self, rng: &mut Pcg32) {
        let scene = self.scene;
        let Some(arrival) = scene.sunlight(self.ray.origin, &self.carrier, rng) else { return };
        let v = 0.5 * (self.ray.direction - arrival.direction).length_squared();
        if v < scene.phases.edge {
            return;
        }
        let scale = 1.0 / (4.0 * PI * (1.0 - scene.forward[self.carrier.channel]));
        let phase = scene.phases.values(v);
        let radiance = |c: usize| arrival.share[c] * phase[c] * scale * scene.world.sun.irradiance[c];
        let order = match self.wide {
            0 => Contribution::Single,
            1 => Contribution::Double,
            _ => Contribution::Multiple,
        };
        self.add(if self.ground { Contribution::Ground } else { order }, std::array::from_fn(radiance));
    }

    /// To the sky.
    fn leave(&mut self) {
        let radiance = self.scene.world.sky.radiance(self.ray.direction);
        let radiance = std::array::from_fn(|c| radiance[c] * self.carrier.ratio[c]);
        self.add(self.seen(Contribution::Sky), radiance);
    }

    fn touch_ground(&mut self, rng: &mut Pcg32) -> bool {
        let (scene, world) = (self.scene, self.scene.world);
        let p = self.ray.at(-self.ray.origin.z / self.ray.direction.z);
        let albedo = world.ground.albedo.value(p.x, p.y);
        let most = albedo.into_iter().fold(0.0, f64::max);
        if most == 0.0 {
            return false;
        }
        self.ray.origin = DVec3::new(p.x, p.y, 0.0);
        self.behind |= self.wide == 0;
        self.ground = true;
        if scene.sunlit {
            let share = scene.sunlight_on_ground(self.ray.origin, &self.carrier, rng);
            let radiance = |c: usize| share[c] * albedo[c] * world.sun.irradiance[c] / PI;
            self.add(Contribution::Ground, std::array::from_fn(radiance));
        }
        if most < 1.0 && uniform(rng) >= most {
            return false;
        }
        self.carrier.tint = std::array::from_fn(|c| self.carrier.tint[c] * albedo[c] / most);
        self.ray.direction = level(cosine(rng));
        true
    }

    /// What light is counted as that is `otherwise` if it met a wide event and not the ground.
    fn seen(&self, otherwise: Contribution) -> Contribution {
        match (self.ground, self.wide) {
            (true, _) => Contribution::Ground,
            (false, 0) => Contribution::Background,
            _ => otherwise,
        }
    }

    fn add(&mut self, contribution: Contribution, radiance: [f64; 3]) {
        let contribution = if self.behind { Contribution::Background } else { contribution };
        debug_assert!(mean(radiance) >= 0.0);
        self.light.add(contribution, std::array::from_fn(|c| radiance[c] * self.carrier.tint[c]));
    }
}
