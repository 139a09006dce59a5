// 64-bit words as (low, high), and the random stream of one photon: a hash by SplitMix64 of key and photon index, continued by
// PCG-XSH-RR 64/32. Word for word that of the CPU.

struct Stream { state: vec2<u32>, increment: vec2<u32> }

const PCG: vec2<u32> = vec2<u32>(0x4c957f2du, 0x5851f42du);

fn add64(a: vec2<u32>, b: vec2<u32>) -> vec2<u32> {
    let low = a.x + b.x;
    return vec2<u32>(low, a.y + b.y + select(0u, 1u, low < a.x));
}

// The upper half of the product of two 32-bit words. No partial sum overflows.
fn high_product(a: u32, b: u32) -> u32 {
    let low = (a & 0xffffu) * (b & 0xffffu);
    let left = (a >> 16u) * (b & 0xffffu) + (low >> 16u);
    let right = (a & 0xffffu) * (b >> 16u) + (left & 0xffffu);
    return (a >> 16u) * (b >> 16u) + (left >> 16u) + (right >> 16u);
}

fn multiply64(a: vec2<u32>, b: vec2<u32>) -> vec2<u32> {
    return vec2<u32>(a.x * b.x, high_product(a.x, b.x) + a.x * b.y + a.y * b.x);
}

// a ^ (a >> n), 0 < n < 32.
fn fold64(a: vec2<u32>, n: u32) -> vec2<u32> {
    return a ^ vec2<u32>((a.x >> n) | (a.y << (32u - n)), a.y >> n);
}

// The finaliser of SplitMix64.
fn mix64(word: vec2<u32>) -> vec2<u32> {
    var mixed = add64(word, vec2<u32>(0x7f4a7c15u, 0x9e3779b9u));
    mixed = multiply64(fold64(mixed, 30u), vec2<u32>(0x1ce4e5b9u, 0xbf58476du));
    mixed = multiply64(fold64(mixed, 27u), vec2<u32>(0x133111ebu, 0x94d049bbu));
    return fold64(mixed, 31u);
}

fn advance(stream: ptr<function, Stream>) {
    (*stream).state = add64(multiply64((*stream).state, PCG), (*stream).increment);
}

fn photon_stream(key: vec2<u32>, index: vec2<u32>) -> Stream {
    let state = mix64(key ^ mix64(index));
    let selector = mix64(state);
    let increment = vec2<u32>((selector.x << 1u) | 1u, (selector.y << 1u) | (selector.x >> 31u));
    var stream = Stream(add64(state, increment), increment);
    advance(&stream);
    return stream;
}

fn draw(stream: ptr<function, Stream>) -> u32 {
    let state = (*stream).state;
    advance(stream);
    let folded = fold64(state, 18u);
    let word = (folded.x >> 27u) | (folded.y << 5u);
    let turn = state.y >> 27u;
    return (word >> turn) | (word << ((32u - turn) & 31u));
}
