// What is behind the cloud, and what lights it from outside: sky, sun's disc, ground.
// Maps are bilinear and periodic. Irradiance of the ground: by the sun directly, at the field's resolution, and by sky and cloud, at that of
// the exchange; irradiance of the cloud's base by the ground at that of the exchange.
@group(0) @binding(4) var<storage, read> albedo: array<vec4<f32>>;
@group(0) @binding(5) var<storage, read> ground_direct: array<vec4<f32>>;
@group(0) @binding(6) var<storage, read> ground_indirect: array<vec4<f32>>;
@group(0) @binding(7) var<storage, read> cloud_from_ground: array<vec4<f32>>;

// Where a map of `side` texels is read at a place given in periods: indices of four texels, and shares.
struct MapPlace {
    index: vec4<u32>,
    at: vec2<f32>,
}

fn map_place(periods: vec2<f32>, side: u32) -> MapPlace {
    let texel = (periods - floor(periods)) * f32(side) - 0.5;
    let whole = floor(texel);
    let n = i32(side);
    let cell = vec2<i32>(whole);
    let west = wrapped(cell.x, n);
    let east = wrapped(cell.x + 1, n);
    let south = wrapped(cell.y, n) * n;
    let north = wrapped(cell.y + 1, n) * n;
    return MapPlace(vec4<u32>(vec4<i32>(south + west, south + east, north + west, north + east)), texel - whole);
}

fn mixed(a: vec4<f32>, b: vec4<f32>, c: vec4<f32>, d: vec4<f32>, at: vec2<f32>) -> vec3<f32> {
    let south = a + (b - a) * at.x;
    let north = c + (d - c) * at.x;
    return (south + (north - south) * at.y).xyz;
}

fn albedo_of(place: vec2<f32>) -> vec3<f32> {
    let p = map_place((view.albedo_at + place) / view.albedo_extent, view.albedo_side);
    return mixed(albedo[p.index.x], albedo[p.index.y], albedo[p.index.z], albedo[p.index.w], p.at);
}

fn ground_direct_at(place: vec2<f32>) -> vec3<f32> {
    let p = map_place((view.position.xy + place) / view.extent, view.side);
    return mixed(
        ground_direct[p.index.x], ground_direct[p.index.y], ground_direct[p.index.z], ground_direct[p.index.w], p.at);
}

fn ground_indirect_at(place: vec2<f32>) -> vec3<f32> {
    let p = map_place((view.position.xy + place) / view.extent, view.exchange_side);
    return mixed(
        ground_indirect[p.index.x], ground_indirect[p.index.y], ground_indirect[p.index.z], ground_indirect[p.index.w],
        p.at);
}

// Irradiance of the cloud's base by the ground at a place relative to the camera.
fn cloud_from_ground_at(place: vec2<f32>) -> vec3<f32> {
    let p = map_place((view.position.xy + place) / view.extent, view.exchange_side);
    return mixed(
        cloud_from_ground[p.index.x], cloud_from_ground[p.index.y], cloud_from_ground[p.index.z],
        cloud_from_ground[p.index.w], p.at);
}

// Radiance of the sky without the sun.
fn sky_radiance(direction: vec3<f32>) -> vec3<f32> {
    return view.sky_uniform;
}

// Radiance that comes from `direction` where no cloud is.
fn background(direction: vec3<f32>) -> vec3<f32> {
    if (direction.z > 0.0) {
        let apart = direction - view.sun;
        let disc = select(vec3<f32>(0.0), view.disc_radiance, 0.5 * dot(apart, apart) <= view.disc_versine);
        return sky_radiance(direction) + disc;
    }
    let place = direction.xy * (view.position.z / -direction.z);
    return 0.318309886 * albedo_of(place) * (ground_direct_at(place) + ground_indirect_at(place));
}
