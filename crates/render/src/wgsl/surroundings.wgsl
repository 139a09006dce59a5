// What is behind the cloud, and what lights it from outside: sky, sun's disc, ground.
// `outside` holds the ground's albedo, then the table of the sky. Maps are bilinear and periodic. Irradiance of the ground: by the sun directly, at the field's resolution, and by sky and cloud, at that of
// the exchange; irradiance of the cloud's base by the ground at that of the exchange.
@group(0) @binding(4) var<storage, read> outside: array<vec4<f32>>;
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
    return mixed(outside[p.index.x], outside[p.index.y], outside[p.index.z], outside[p.index.w], p.at);
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

// Neighbours of a coordinate in [0, 1] among `count` texels, and its share of the way.
struct Neighbours {
    first: u32,
    second: u32,
    share: f32,
}

fn neighbours(coordinate: f32, count: u32) -> Neighbours {
    let place = clamp(coordinate, 0.0, 1.0) * f32(count - 1u);
    let first = min(u32(place), count - 1u);
    return Neighbours(first, min(first + 1u, count - 1u), place - f32(first));
}

fn sky_texel(x: u32, y: u32) -> vec4<f32> {
    return outside[view.albedo_side * view.albedo_side + y * view.sky_size.x + x];
}

// Radiance of the sky without the sun: a table over sin(half the azimuth from the sun's) and a row that is dense at horizon and zenith.
fn sky_radiance(direction: vec3<f32>) -> vec3<f32> {
    let across = length(direction.xy);
    let along = dot(direction.xy, view.towards_sun);
    let cosine = select(0.0, clamp(along / across, -1.0, 1.0), across > 0.0);
    let z = min(direction.z, 1.0);
    let row = select(1.0 - sqrt(0.5 * (1.0 - z)), sqrt(0.5 * z), z < 0.5);
    let x = neighbours(sqrt(0.5 * (1.0 - cosine)), view.sky_size.x);
    let y = neighbours(row, view.sky_size.y);
    return mixed(
        sky_texel(x.first, y.first), sky_texel(x.second, y.first), sky_texel(x.first, y.second),
        sky_texel(x.second, y.second), vec2<f32>(x.share, y.share));
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
