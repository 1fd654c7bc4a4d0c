//! WGSL text to a machine.

use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use terrane_codegen::machine::{Domain, Machine, NoTextures, Value};

/// A checked module.
pub(crate) struct Shader {
    pub(crate) module: naga::Module,
    pub(crate) info: ModuleInfo,
}

/// # Panics
/// If naga rejects the text.
#[track_caller]
pub(crate) fn shader(text: &str) -> Shader {
    let module = naga::front::wgsl::parse_str(text).unwrap_or_else(|error| panic!("{}", error.emit_to_string(text)));
    let info = Validator::new(ValidationFlags::all(), Capabilities::all())
        .validate(&module)
        .unwrap_or_else(|error| panic!("{}", error.emit_to_string(text)));
    Shader { module, info }
}

impl Shader {
    pub(crate) fn machine(&self) -> Machine<'_> {
        Machine::new(&self.module, &self.info, &NoTextures)
    }

    /// The result of a function without textures.
    #[track_caller]
    pub(crate) fn call<D: Domain>(&self, function: &str, arguments: &[Value<D>], points: usize) -> Value<D> {
        match self.machine().call(function, arguments, points) {
            Ok((value, _)) => value,
            Err(error) => panic!("{error}"),
        }
    }
}

/// Every `step`th float, by its bits: all magnitudes, signs, infinities, some NaN.
pub(crate) fn floats(step: u32) -> impl Iterator<Item = f32> {
    let special = [0.0, -0.0, 1.0, -1.0, 0.5, 1.5, 2.5, -0.5, -1.5, 8_388_607.5, f32::MAX, f32::MIN_POSITIVE];
    (0..=u32::MAX / step).map(move |i| f32::from_bits(i * step)).chain(special)
}

/// PCG: numbers for tests, the same in every run.
pub(crate) struct Random(u32);

impl Random {
    pub(crate) fn new(seed: u32) -> Self {
        Self(seed.wrapping_mul(2_654_435_761))
    }

    pub(crate) fn bits(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        let word = ((self.0 >> ((self.0 >> 28) + 4)) ^ self.0).wrapping_mul(277_803_737);
        (word >> 22) ^ word
    }

    /// Less than a bound.
    pub(crate) fn below(&mut self, bound: u32) -> u32 {
        self.bits() % bound
    }

    /// 0..1.
    pub(crate) fn unit(&mut self) -> f32 {
        (self.bits() >> 8) as f32 / 16_777_216.0
    }

    /// Finite; mostly of the magnitudes that shaders use, sometimes of any.
    pub(crate) fn float(&mut self) -> f32 {
        match self.below(8) {
            0 => {
                let value = f32::from_bits(self.bits());
                if value.is_finite() { value } else { 0.0 }
            }
            1 => [0.0, 1.0, -1.0, 0.5, 2.0, -0.0, 3.0, 1e-20][self.below(8) as usize],
            2 => (self.unit() - 0.5) * 2000.0,
            3 => self.below(16) as f32 - 8.0,
            _ => (self.unit() - 0.5) * 8.0,
        }
    }
}
