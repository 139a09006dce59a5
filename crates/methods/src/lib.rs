//! Every way to get the radiance or the fluxes of a cloud layer, behind one trait.
//!
//! A [`Method`] says what it is ([`Card`]) and prepares itself for a [`Cloud`]; what comes out, [`Ready`], answers lists of
//! [`Point`]s in double precision and, where it is code for a shader, single ones in f32 ([`Single`]). Whatever is asked outside of
//! the declared [`Domain`] is refused with a [`MethodError`]; no value is clamped. [`all`] lists them, [`by_name`] finds one.
//!
//! In the classes of Hufnagel & Held 2012, section 4.1 (`shader`: code for a pixel; `f`, `r`: fluxes, radiance):
//!
//! | class | method | gives |
//! | --- | --- | --- |
//! | 4.1.1 single scattering | `single-mie`, `single-hg`, `single-hg-draine`; with forward orders `harris-lastra`, `multiple-forward` | shader r |
//! | 4.1.2 diffusion | `two-stream`, `delta-eddington`, `diffusion`, `asymptotic` | shader f r |
//! | 4.1.3 path tracing | `monte-carlo`, `monte-carlo-modified` | f r |
//! | | `half-space`, `half-space-modified` | f |
//! | 4.1.4 path integration | none: the equations of Premože et al. 2004 are not at hand to be checked | |
//! | 4.1.6 mixed | `bouthors-printed`, `-published`, `-corrected`, `-corrected-isotropic`, `-corrected-escape`, `-corrected-halo`, `-family` | shader f r |
//! | | `fitted`, `fitted-halo` | shader r |
//! | 4.1.7 heuristics | `octaves`, `beer-powder` | shader r |
//! | not in the survey | `solver` | f r |
//! | | `orders` | f, up to order 2 r |
//!
//! 4.1.5, photon mapping, has nothing to say about a homogeneous slab that path tracing has not. Each method's file states
//! formula, source, how a march through a volume becomes a closed form in a slab, and where it holds.

mod card;
mod cloud;
mod error;
mod grid;
mod halo;
mod lobe;
mod lookup;
mod method;
mod point;
mod promise;
mod registry;
mod rivals;
mod scalar;
mod shade;
mod simple;

pub use card::{Card, Class, Domain};
pub use cloud::Cloud;
pub use error::MethodError;
pub use lookup::{EMITTED_TEXELS, Exact, Texels};
pub use method::{Method, Ready, Single};
pub use point::{FluxPair, FluxPoint, Point};
pub use promise::{Promise, Promises};
pub use registry::{Knob, all, by_name, knobs};
pub use scalar::Scalar;
