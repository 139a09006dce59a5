//! One path from the camera back to what lit it.

use crate::carrier::Carrier;
use crate::halo;
use crate::layer::{End, Ray};
use crate::light::Light;
use crate::random::{cosine, exponential, level, turned, uniform};
use crate::scene::Scene;
use glam::DVec3;
use rand::Rng;
use rand_pcg::Pcg32;
use std::f64::consts::PI;
use stratiform_world::Contribution;

/// A path under way.
struct Path<'a> {
    scene: &'a Scene<'a>,
    ray: Ray,
    carrier: Carrier,
    /// The ground's share so far, roulette included.
    tint: [f64; 3],
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
    let carrier = Carrier::new((uniform(rng) * 3.0) as usize);
    let tint = [1.0; 3];
    let mut path = Path { scene, ray, carrier, tint, wide: 0, ground: false, behind: false, light };
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
        let (scene, channel) = (self.scene, self.carrier.channel);
        if scene.albedo < 1.0 && uniform(rng) >= scene.albedo {
            return false;
        }
        let forward = uniform(rng) < scene.forward[channel];
        if !forward {
            if scene.sunlit {
                self.collect(rng);
            }
            self.wide += 1;
        }
        let v = scene.phases.sample(channel, forward, rng.next_u32());
        let p = scene.phases.values(v);
        self.ray.direction = turned(self.ray.direction, v, rng);
        self.carrier.scatter(p);
        p != [0.0; 3]
    }

    /// Sunlight that the coming event sends along the path. That it is wide had the chance 1 - P_f of the path's own channel.
    fn collect(&mut self, rng: &mut Pcg32) {
        let scene = self.scene;
        let Some(arrival) = scene.sunlight(self.ray.origin, self.carrier, rng) else { return };
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
        let contribution = match (self.ground, self.wide) {
            (true, _) => Contribution::Ground,
            (false, 0) => Contribution::Background,
            _ => Contribution::Sky,
        };
        self.add(contribution, radiance);
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
        self.tint = std::array::from_fn(|c| self.tint[c] * albedo[c] / most);
        self.ray.direction = level(cosine(rng));
        true
    }

    fn add(&mut self, contribution: Contribution, radiance: [f64; 3]) {
        let contribution = if self.behind { Contribution::Background } else { contribution };
        self.light.add(contribution, std::array::from_fn(|c| radiance[c] * self.tint[c]));
    }
}
