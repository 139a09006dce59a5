// From radiance to stored sRGB: stratiform_imaging's Tone with its shoulder, step by step.
fn towards_grey(x: vec3<f32>) -> vec3<f32> {
    let least = min(x.r, min(x.g, x.b));
    if (least >= 0.0) {
        return x;
    }
    let grey = dot(x, vec3<f32>(0.2126, 0.7152, 0.0722));
    if (grey <= 0.0) {
        return vec3<f32>(0.0);
    }
    return max(vec3<f32>(grey) + grey / (grey - least) * (x - grey), vec3<f32>(0.0));
}

fn shoulder(x: vec3<f32>) -> vec3<f32> {
    let bent = 0.6 + 0.4 * (1.0 - exp(-(x - 0.6) / 0.4));
    return select(x, bent, x > vec3<f32>(0.6));
}

fn encoded(x: vec3<f32>) -> vec3<f32> {
    return select(1.055 * pow(x, vec3<f32>(1.0 / 2.4)) - 0.055, 12.92 * x, x <= vec3<f32>(0.0031308));
}

fn shown(radiance: vec3<f32>, exposure_ev: f32) -> vec3<f32> {
    return encoded(shoulder(towards_grey(3.14159274 * exp2(exposure_ev) * radiance)));
}
