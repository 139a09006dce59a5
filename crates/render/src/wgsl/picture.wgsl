// The picture: a ray a pixel, shaded at its first point in the cloud, over what lies behind. The fourth number of a pixel is 1, or 0 where
// a ray did not end.
@group(0) @binding(8) var<storage, read_write> picture: array<vec4<f32>>;

// Contributions, a bit each.
const BACKGROUND: u32 = 1u;
const HALO: u32 = 2u;
const SINGLE: u32 = 4u;
const DOUBLE: u32 = 8u;
const MULTIPLE: u32 = 16u;
const SKY: u32 = 32u;
const GROUND: u32 = 64u;

// Rays nearer to the horizontal than this are followed at it.
const LEAST_RISE: f32 = 1e-3;

fn drawn(contribution: u32) -> f32 {
    return select(0.0, 1.0, (view.contributions & contribution) != 0u);
}

fn ray_of(pixel: vec2<u32>) -> vec3<f32> {
    let centre = 0.5 * vec2<f32>(view.size);
    let across = (vec2<f32>(pixel) + 0.5 - centre) * vec2<f32>(view.pixel, -view.pixel);
    let d = normalize(view.ahead + across.x * view.right + across.y * view.up);
    let rise = select(min(d.z, -LEAST_RISE), max(d.z, LEAST_RISE), d.z >= 0.0);
    return vec3<f32>(d.xy, rise);
}

// The part of a ray between base and greatest thickness, and the way to it; reach is negative if it does not get there.
struct Slab {
    ray: Ray,
    way: f32,
}

fn slab_of(d: vec3<f32>) -> Slab {
    let height = view.position.z - view.base;
    let to_base = -height / d.z;
    let to_top = (view.most - height) / d.z;
    let way = max(min(to_base, to_top), 0.0);
    let reach = max(to_base, to_top) - way;
    let scale = f32(view.side) / view.extent;
    let place = view.position.xy + way * d.xy;
    let texel = (place - floor(place / view.extent) * view.extent) * scale - 0.5;
    let start = clamp(height, 0.0, view.most);
    return Slab(Ray(texel, d.xy * scale, start, d.z, reach), way);
}

// The first point in the cloud.
struct Hit {
    // Way from the camera, m.
    way: f32,
    // Optical thickness of the slab that stands for the cloud there.
    tau: f32,
    // Normal of the face, out of the cloud.
    normal: vec3<f32>,
}

fn hit_of(slab: Slab, found: March) -> Hit {
    let ray = slab.ray;
    let texel = ray.texel + found.entry * ray.slope;
    let height = ray.height + found.entry * ray.rise;
    let through_base = ray.rise > 0.0 && height <= 0.0;
    var thick = thickness(texel);
    if (view.depth == 1u) {
        thick = found.chord * abs(ray.rise);
    }
    let normal = select(top_normal(texel), vec3<f32>(0.0, 0.0, -1.0), through_base);
    return Hit(slab.way + found.entry, view.kappa * thick, normal);
}

// Towards the viewer against a normal; `same_side` is that of viewer and sun.
fn sight_of(d: vec3<f32>, normal: vec3<f32>) -> Sight {
    let to_viewer = -d;
    let mu_v = dot(to_viewer, normal);
    let mu_l = dot(view.sun, normal);
    let half_way = to_viewer + view.sun;
    return Sight(min(abs(mu_l), 1.0), clamp(mu_v, 0.0, 1.0), min(0.5 * dot(half_way, half_way), 2.0), mu_l > 0.0);
}

// Light of the sun.
fn sun_light(d: vec3<f32>, hit: Hit) -> vec3<f32> {
    let upright = vec3<f32>(0.0, 0.0, select(1.0, -1.0, d.z > 0.0));
    let far = sight_of(d, upright);
    let near = sight_of(d, select(hit.normal, upright, view.normals == 1u));
    let orders = sun_orders(near, far, hit.tau);
    let halo = select(stratiform_halo(near.mu_l, near.mu_v, near.v, hit.tau), 0.0, near.same_side);
    let unit = stratiform_radiance_from_factor(1.0, near.mu_l);
    return view.sun_irradiance
        * (drawn(HALO) * vec3<f32>(halo * unit)
            + drawn(SINGLE) * orders.one
            + drawn(DOUBLE) * orders.two
            + drawn(MULTIPLE) * orders.more);
}

// Light of sky and ground, by reciprocity from what the slab does to a beam along the line of sight.
fn surrounding_light(d: vec3<f32>, hit: Hit, clear: f32) -> vec3<f32> {
    let slab = stratiform_turned(stratiform_parameters(min(abs(d.z), 1.0)), hit.tau);
    let ground = 0.318309886 * cloud_from_ground_at(hit.way * d.xy);
    let through = slab.t_ms - clear;
    let above = d.z < 0.0;
    return drawn(SKY) * select(through, slab.r_ms, above) * view.sky_mean
        + drawn(GROUND) * select(slab.r_ms, through, above) * ground;
}

fn radiance_of(d: vec3<f32>) -> vec4<f32> {
    let behind = drawn(BACKGROUND) * background(d);
    let slab = slab_of(d);
    if (slab.ray.reach <= 0.0 || view.most <= 0.0) {
        return vec4<f32>(behind, 1.0);
    }
    let found = march(slab.ray, view.depth == 1u);
    if (found.entry < 0.0) {
        return vec4<f32>(behind, select(0.0, 1.0, found.ended));
    }
    let hit = hit_of(slab, found);
    let clear = stratiform_transparency(abs(d.z), hit.tau);
    let light = sun_light(d, hit) + surrounding_light(d, hit, clear) + clear * behind;
    return vec4<f32>(light, select(0.0, 1.0, found.ended));
}

@compute @workgroup_size(8, 8)
fn picture_pixels(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x >= view.size.x || id.y >= view.size.y) {
        return;
    }
    picture[id.y * view.size.x + id.x] = radiance_of(ray_of(id.xy));
}
