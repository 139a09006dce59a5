// One scattering and one flight in single precision, the same formulas as the CPU's: sums and products, no division, one square
// root. A random word u stands for ξ = (u + ½)/2³².

const LN_TWO: f32 = 0.6931472;
// The bits of √½.
const HALF_ROOT: u32 = 0x3f3504f3u;

// -ln ξ. 2³²ξ = 2ᵏm with m ∈ [√½, √2): -ln ξ = (32-k) ln 2 - ln m.
fn optical_path(word: u32) -> f32 {
    // The exponent field counts from √½, and from 2³² instead of 1.
    let shifted = bitcast<u32>(f32(word) + 0.5) - (HALF_ROOT + (32u << 23u));
    let exponent = f32(bitcast<i32>(shifted) >> 23u);
    let t = bitcast<f32>((shifted & 0x007fffffu) + HALF_ROOT) - 1.0;
    var series = 0.0895992;
    series = series * t - 0.1448219;
    series = series * t + 0.14917377;
    series = series * t - 0.16543737;
    series = series * t + 0.19958417;
    series = series * t - 0.25002947;
    series = series * t + 0.3333416;
    series = series * t - 0.4999998;
    series = series * t + 1.0;
    return exponent * -LN_TWO - t * series;
}

// cosψ, ψ uniform: sin πx, with 2³²x the word as a signed number.
fn azimuth_cosine(word: u32) -> f32 {
    let x = f32(bitcast<i32>(word)) * 2.3283064365386963e-10;
    let square = x * x;
    var series = 0.07722225;
    series = series * square - 0.5980464;
    series = series * square + 2.5500317;
    series = series * square - 5.167707;
    series = series * square + 3.1415925;
    return x * series;
}

// √ξ: the direction cosine of diffuse light on entering.
fn diffuse_cosine(word: u32) -> f32 {
    return sqrt((f32(word) + 0.5) * 2.3283064365386963e-10);
}

// v = 1 - cosΘ. The top 12 bits choose a straight piece (start, slope); where the slope is negative, `start` is the first of 256
// finer ones, which the next 8 bits choose among. The rest of the word is the place in the piece.
fn sampled(word: u32) -> f32 {
    let piece = table[word >> 20u];
    if (piece.y < 0.0) {
        let part = table[u32(piece.x) + ((word >> 12u) & 0xffu)];
        return part.x + (f32(word & 0xfffu) + 0.5) * 0.000244140625 * part.y;
    }
    return piece.x + (f32(word & 0xfffffu) + 0.5) * 9.5367431640625e-7 * piece.y;
}

// The direction cosine after scattering by 1 - cosΘ = v with azimuth cosine `azimuth`.
fn scattered(mu: f32, v: f32, azimuth: f32) -> f32 {
    let sine = sqrt(max((1.0 - mu) * (1.0 + mu) * (v * (2.0 - v)), 0.0));
    return mu - mu * v + sine * azimuth;
}
