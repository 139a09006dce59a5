// Where a ray enters the cloud, and how much of it lies in the cloud.
//
// Within a cell the thickness along a ray is a parabola, so that entries and exits are roots and no step is chosen. Blocks that lie
// below the ray are crossed at once. The software driver ends loops silently after 65535 turns; here MARCH_TURNS is the bound, and a ray that
// meets it says so.

const MARCH_TURNS: u32 = 16384u;
// A chord is followed over so many blocks; what is left of the way then counts as cloudy as what was seen since the entry.
const CHORD_TURNS: u32 = 4096u;

// A ray in the slab between base and greatest thickness.
struct Ray {
    // Where it starts, in texels, and texels per metre of way.
    texel: vec2<f32>,
    slope: vec2<f32>,
    // Height above the base where it starts, and per metre of way.
    height: f32,
    rise: f32,
    // Way to the end of the slab, m.
    reach: f32,
}

struct March {
    // Way to the first point in the cloud, m; negative if there is none.
    entry: f32,
    // Way in the cloud, m: of the whole ray, or 0 where it was not asked for.
    chord: f32,
    // Whether the end was reached.
    ended: bool,
}

// The part of a stretch of way that lies in the cloud: its length and its start as shares of the stretch.
struct Part {
    inside: f32,
    start: f32,
}

// The stretch between two shares, if the parabola is positive in its middle.
fn part_of(part: Part, parabola: vec3<f32>, a: f32, b: f32) -> Part {
    let middle = 0.5 * (a + b);
    if (b > a && parabola.x + middle * (parabola.y + middle * parabola.z) > 0.0) {
        return Part(part.inside + (b - a), min(part.start, a));
    }
    return part;
}

// Where c0 + c1 t + c2 t^2 > 0 for t in [0, 1]; start is 2 if nowhere.
fn positive_part(parabola: vec3<f32>) -> Part {
    let discriminant = parabola.y * parabola.y - 4.0 * parabola.z * parabola.x;
    var first = 1.0;
    var second = 1.0;
    if (discriminant > 0.0) {
        let q = -0.5 * (parabola.y + select(-1.0, 1.0, parabola.y >= 0.0) * sqrt(discriminant));
        let near = select(1.0, parabola.x / q, abs(q) > abs(parabola.x));
        let far = select(1.0, q / parabola.z, abs(parabola.z) > abs(q));
        first = clamp(min(near, far), 0.0, 1.0);
        second = clamp(max(near, far), 0.0, 1.0);
    }
    let one = part_of(Part(0.0, 2.0), parabola, 0.0, first);
    let two = part_of(one, parabola, first, second);
    return part_of(two, parabola, second, 1.0);
}

// Thickness minus height along a stretch of a cell, from way `start` over `length`, as a parabola of the share.
fn parabola_of(ray: Ray, cell: vec2<f32>, start: f32, length: f32) -> vec3<f32> {
    let c = corners(vec2<i32>(cell));
    let at = ray.texel + start * ray.slope - cell;
    let along = ray.slope * length;
    let twist = c.x - c.y - c.z + c.w;
    let slope = (c.y - c.x + twist * at.y) * along.x + (c.z - c.x + twist * at.x) * along.y;
    return vec3<f32>(
        between(c, at) - (ray.height + start * ray.rise),
        slope - ray.rise * length,
        twist * along.x * along.y,
    );
}

// Way to where the ray leaves the block [low, high) of texels.
fn leaving(ray: Ray, low: vec2<f32>, high: vec2<f32>) -> f32 {
    let edge = select(low, high, ray.slope > vec2<f32>(0.0));
    let never = vec2<f32>(3e38);
    let way = select((edge - ray.texel) / ray.slope, never, abs(ray.slope) < vec2<f32>(1e-30));
    return min(way.x, way.y);
}

// The block of `level` around a cell: low and high corner in texels, unwrapped, and its greatest thickness.
struct Block {
    low: vec2<f32>,
    high: vec2<f32>,
    most: f32,
}

fn block_of(cell: vec2<f32>, level: u32) -> Block {
    let side = i32(view.side);
    let here = vec2<i32>(cell);
    let inside = vec2<i32>(wrapped(here.x, side), wrapped(here.y, side));
    let origin = vec2<f32>(here - inside);
    let block = vec2<u32>(inside) >> vec2<u32>(level);
    let low = vec2<f32>(block << vec2<u32>(level));
    let high = min(vec2<f32>((block + 1u) << vec2<u32>(level)), vec2<f32>(f32(side)));
    let table = view.levels[level];
    return Block(origin + low, origin + high, heights[table.x + block.y * table.y + block.x]);
}

// Follows a ray to its first point in the cloud, or with `whole` to its end.
fn march(ray: Ray, whole: bool) -> March {
    // A thousandth of a texel leads past a cell's edge in spite of rounding.
    let speed = max(max(abs(ray.slope.x), abs(ray.slope.y)), 1e-30);
    var found = March(-1.0, 0.0, true);
    var way = 0.0;
    var level = view.top_level;
    for (var turn = 0u; turn < MARCH_TURNS; turn += 1u) {
        if (way >= ray.reach) {
            return found;
        }
        if (turn > CHORD_TURNS && found.entry >= 0.0) {
            found.chord += (ray.reach - way) * (found.chord / (way - found.entry));
            return found;
        }
        let cell = floor(ray.texel + way * ray.slope);
        let block = block_of(cell, level);
        let end = max(min(leaving(ray, block.low, block.high), ray.reach), way);
        let past = end + max(1e-3 / speed, 4e-7 * end);
        let lowest = ray.height + min(way * ray.rise, end * ray.rise);
        if (block.most < lowest) {
            way = past;
            level = min(level + 1u, view.top_level);
        } else if (level > 0u) {
            level -= 1u;
        } else {
            let part = positive_part(parabola_of(ray, cell, way, end - way));
            if (part.start < 2.0 && found.entry < 0.0) {
                found.entry = way + part.start * (end - way);
                if (!whole) {
                    return found;
                }
            }
            found.chord += part.inside * (end - way);
            way = past;
        }
    }
    found.ended = false;
    return found;
}
