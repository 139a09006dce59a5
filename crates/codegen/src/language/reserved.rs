//! Names that some target reserves, defines as a macro, or that the printer needs itself.

use std::collections::HashSet;
use std::sync::LazyLock;

/// Keywords and reserved words of WGSL, GLSL 4.5 and ES 3.0, HLSL, Metal, C, C++ and Rust, and their types.
const KEYWORDS: &str = "
abstract active alias alignas alignof and and_eq array as asm async atomic attribute auto await become bitand bitor
bitcast bool box break buffer case cast catch cbuffer centroid char class coherent column_major common compl compile
compute concept const const_assert const_cast const_eval constant constexpr constinit continue continuing co_await
co_return co_yield crate decltype default delete device diagnostic discard discard_fragment do double dword dyn
dynamic_cast else enable enum explicit export extern external f16 f32 f64 fallthrough false filter final finally fixed
flat float fn for foreach fragment friend from function gen get global globallycoherent goto groupshared half handle
highp i32 if image impl import in inline inout inst_offset int interface invariant isampler1D isampler2D isampler3D
isamplerCube iterator kernel layout let lerp linear lineadj long loop lowp macro mat2 mat3 mat4 match matrix mediump
meta mod module move mut mutable namespace new nil no_perspective noexcept noinline nointerpolation noperspective not
not_eq null nullptr object of operator or or_eq out output override packoffset packed partition pass patch patch_in
pixelfragment pixelshader point precise precision premerge priv private protected ptr pub public readonly ref register
reinterpret_cast require requires resource restrict return row_major sample sampler sampler1D sampler2D sampler3D
samplerCube sampler_state self set shared short signed sizeof smooth snorm staging stateblock static static_assert
static_cast storage string struct subroutine super superp switch tbuffer technique template texture texture1D texture2D
texture3D textureCube this thread thread_local threadgroup throw trait triangle triangleadj true try type typedef typeid
typename typeof u32 uint uniform union unless unorm unsafe unsized unsigned usampler1D usampler2D usampler3D use using
vec2 vec3 vec4 var varying vector vertex vertexshader virtual visible void volatile wchar_t wgsl where while workgroup
writeonly xor xor_eq yield Self SamplerState Texture2D Buffer StructuredBuffer";

/// Macros of headers that the text may stand below: windows.h, math.h, complex.h.
const MACROS: &str = "
near far small hyper pascal cdecl interface min max IN OUT I NULL ERROR CONST TRUE FALSE DIFFERENCE OPTIONAL OPAQUE
TRANSPARENT DOMAIN SING OVERFLOW UNDERFLOW PLOSS TLOSS HUGE INFINITY NAN EOF assert errno signbit isnan isinf";

/// Functions that a variable of the same name would hide.
const FUNCTIONS: &str = "
acos all any asin atan ceil clamp cross ddx ddy degrees determinant distance dot exp2 fabs fmax fmin fma fract frac
gamma index inversesqrt isfinite j0 j1 jn ldexp length lgamma log2 mad mix modf mul normalize pow10 radians reflect
refract round rsqrt saturate sign sincos sinh smoothstep step tan tanh transpose trunc y0 y1 yn";

/// What the printer calls a structure on its way out.
const RESULT: &str = "result";

/// All words that mean something else.
static WORDS: LazyLock<HashSet<&str>> = LazyLock::new(|| {
    [KEYWORDS, MACROS, FUNCTIONS].iter().flat_map(|words| words.split_whitespace()).collect()
});

/// Why nothing can be called `name`; none if it can.
pub(super) fn reason(name: &str) -> Option<&'static str> {
    if WORDS.contains(name) {
        Some("means something else in a target")
    } else if name.starts_with('_') || name.starts_with("gl_") || name.contains("__") {
        Some("has a form that targets reserve")
    } else if name == RESULT {
        Some("is the printer's own")
    } else {
        None
    }
}
