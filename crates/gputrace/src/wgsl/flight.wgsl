// One scattering and one flight in single precision. A random word u stands for ξ = (u + ½)/2³².

fn uniform_of(word: u32) -> f32 {
    return f32(word) * 2.3283064e-10 + 1.1641532e-10;
}

// -ln ξ.
fn exponential(word: u32) -> f32 {
    return -log(uniform_of(word));
}

// cos πξ.
fn cos_azimuth(word: u32) -> f32 {
    let y = 3.1415927 * (0.5 - uniform_of(word));
    let x = y * y;
    return y * (1.0 + x * (-0.16666667 + x * (0.008333333 + x * (-0.0001984127 + x * (2.7557319e-6 - x * 2.5052108e-8)))));
}

// v = 1 - cosΘ.
fn scattering(word: u32) -> f32 {
    let interval = table[word >> 20u];
    let t = (f32(word & 0xfffffu) + 0.5) * 9.5367431640625e-7;
    return interval.x + t * (interval.y + t * interval.z);
}

// The direction cosine after a scattering by v at an azimuth of cosine `azimuth`.
fn turned(mu: f32, v: f32, azimuth: f32) -> f32 {
    let sine = sqrt(max((1.0 - mu) * (1.0 + mu), 0.0) * v * (2.0 - v));
    return mu * (1.0 - v) + sine * azimuth;
}
