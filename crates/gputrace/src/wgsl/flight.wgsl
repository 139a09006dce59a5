// One scattering and one flight in single precision, the same formulas as the CPU's: sums and products, no division, one square
// root. A random word u stands for ξ = (u + ½)/2³²; a flight takes its azimuth from a word and its path from the lower 22 bits.

const LN_TWO: f32 = 0.6931472;
// The bits of √½.
const HALF_ROOT: u32 = 0x3f3504f3u;

// -ln(x/2ⁿ), n = `bits`. x = 2ᵏm with m ∈ [√½, √2): it is (n-k) ln 2 - ln m.
fn minus_logarithm(x: f32, bits: u32) -> f32 {
    // The exponent field counts from √½, and from 2ⁿ instead of 1.
    let shifted = bitcast<u32>(x) - (HALF_ROOT + (bits << 23u));
    let exponent = f32(bitcast<i32>(shifted) >> 23u);
    let t = bitcast<f32>((shifted & 0x007fffffu) + HALF_ROOT) - 1.0;
    let square = t * t;
    var even = 0.161805;
    even = even * square + 0.19906883;
    even = even * square + 0.33334714;
    even = even * square + 1.0;
    var odd = -0.100823775;
    odd = odd * square - 0.17243224;
    odd = odd * square - 0.24971229;
    odd = odd * square - 0.5000032;
    return exponent * -LN_TWO - t * (even + t * odd);
}

// -ln ξ.
fn optical_path(word: u32) -> f32 {
    return minus_logarithm(f32(word) + 0.5, 32u);
}

// -ln ξ of the lower bits.
fn flight_path(word: u32) -> f32 {
    return minus_logarithm(f32(word & 0x3fffffu) + 0.5, 22u);
}

// cosψ, ψ uniform: sin πy, y = ½ - |ψ/π|, with 2³¹ψ/π the word as a signed number.
fn azimuth_cosine(word: u32) -> f32 {
    let y = 0.5 - abs(f32(bitcast<i32>(word)) * 4.656612873077393e-10);
    let square = y * y;
    var series = -0.5546345;
    series = series * square + 2.5418985;
    series = series * square - 5.1671429;
    series = series * square + 3.141582;
    return y * series;
}

// √ξ: the direction cosine of diffuse light on entering.
fn diffuse_cosine(word: u32) -> f32 {
    return sqrt((f32(word) + 0.5) * 2.3283064365386963e-10);
}

// v = 1 - cosΘ. The top 12 bits choose a straight piece (first, step); where the step is negative, `first` is the index of the first of 256
// finer ones, which the next 8 bits choose among. The rest of the word is the place in the piece.
fn sampled(word: u32) -> f32 {
    let piece = table[word >> 20u];
    if (piece.y < 0.0) {
        let part = table[u32(piece.x) + ((word >> 12u) & 0xffu)];
        return part.x + f32(word & 0xfffu) * part.y;
    }
    return piece.x + f32(word & 0xfffffu) * piece.y;
}

// The direction cosine after scattering by 1 - cosΘ = v with azimuth cosine `azimuth`.
fn scattered(mu: f32, v: f32, azimuth: f32) -> f32 {
    let sine = sqrt(max((1.0 - mu) * (1.0 + mu) * (v * (2.0 - v)), 0.0));
    return mu - mu * v + sine * azimuth;
}
