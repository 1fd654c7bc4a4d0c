//! The settings of quadtree displacement mapping as published.

use std::fmt;

/// `QuadtreeDisplacementSwitches` of `shaderlib/wgsl/relief/quadtree_displacement.wgsl`. Source: Drobot, "Quadtree Displacement
/// Mapping with Height Blending", GPU Pro 1, 2010, listing 1.3 and section 1.4.3.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Displacement {
    /// Borders by a division of whole numbers, as the listing is written.
    pub integers: bool,
    /// What 0 / 0 counts for among distances.
    pub undefined: Undefined,
    /// At a border up by a level; else on the same one.
    pub ascends: bool,
    /// Nodes after which the place reached counts as a hit, for a ray straight down and for a level one.
    pub caps: Option<[u32; 2]>,
    /// A texel is as wide as so many steps are high: for the caps alone.
    pub steep: u32,
    /// Ends with a step of linear search, from a texel before to a texel behind.
    pub refines: bool,
    /// The level below which the search does not go, in 1/256.
    pub stop: u32,
    /// There, a mix with the level above by the fraction of `stop`.
    pub interpolates: bool,
    /// How much of the shift a fade with distance leaves, in 1/256.
    pub keep: u32,
}

/// What a shader makes of 0 / 0, which WGSL leaves open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Undefined {
    /// No number: Direct3D's minimum takes the other one.
    PassedOver,
    /// 0.
    Zero,
}

impl Displacement {
    /// The listing letter by letter, as Direct3D would run it.
    pub const LISTING: Self = Self { integers: true, ..Self::PUBLISHED };

    /// The listing, but for borders in fractions of the tile, as its comments want them.
    pub const PUBLISHED: Self = Self {
        integers: false,
        undefined: Undefined::PassedOver,
        ascends: true,
        caps: None,
        steep: 1,
        refines: false,
        stop: 0,
        interpolates: false,
        keep: 256,
    };

    /// The same as a value in WGSL.
    pub(super) fn wgsl(&self) -> String {
        let Self { integers, ascends, refines, interpolates, .. } = self;
        let undefined = match self.undefined {
            Undefined::PassedOver => "RELIEF_NEVER",
            Undefined::Zero => "0.0f",
        };
        let [straight, level] = self.caps.unwrap_or([0; 2]);
        let (steep, stop, keep) = (self.steep, f64::from(self.stop) / 256.0, f64::from(self.keep) / 256.0);
        format!(
            "QuadtreeDisplacementSwitches({integers}, {undefined}, {ascends}, vec2f({straight}.0f, {level}.0f), \
             {steep}.0f, {refines}, {stop:?}f, {interpolates}, {keep:?}f)"
        )
    }
}

impl fmt::Display for Displacement {
    /// What differs from [`Self::PUBLISHED`].
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plain = Self::PUBLISHED;
        let caps = self.caps.map(|[straight, level]| format!("straight: {straight}, level: {level}"));
        let parts = [
            (self.integers != plain.integers).then(|| "integers: true".to_owned()),
            (self.undefined != plain.undefined).then(|| "zero: true".to_owned()),
            (self.ascends != plain.ascends).then(|| "stays: true".to_owned()),
            caps,
            (self.steep != plain.steep).then(|| format!("steep: {}", self.steep)),
            (self.refines != plain.refines).then(|| "refines: true".to_owned()),
            (self.stop != plain.stop).then(|| format!("stop: {}", f64::from(self.stop) / 256.0)),
            (self.interpolates != plain.interpolates).then(|| "interpolates: true".to_owned()),
            (self.keep != plain.keep).then(|| format!("keep: {}", f64::from(self.keep) / 256.0)),
        ];
        let parts: Vec<String> = parts.into_iter().flatten().collect();
        if parts.is_empty() { Ok(()) } else { write!(to, "({})", parts.join(", ")) }
    }
}

impl Displacement {
    /// What [`fmt::Display`] writes between the brackets.
    pub(super) fn parse(text: &str) -> Option<Self> {
        let mut switches = Self::PUBLISHED;
        for part in text.split(',') {
            let (name, value) = part.split_once(':')?;
            switches.set(name.trim(), value.trim())?;
        }
        Some(switches)
    }

    fn set(&mut self, name: &str, value: &str) -> Option<()> {
        let part = |value: &str| {
            let parts = value.parse::<f64>().ok()? * 256.0;
            ((0.0..=65_536.0).contains(&parts) && parts.fract() == 0.0).then_some(parts as u32)
        };
        let caps = self.caps.unwrap_or_default();
        match name {
            "straight" => self.caps = Some([value.parse().ok()?, caps[1]]),
            "level" => self.caps = Some([caps[0], value.parse().ok()?]),
            "integers" => self.integers = value.parse().ok()?,
            "zero" => {
                self.undefined = if value.parse().ok()? { Undefined::Zero } else { Undefined::PassedOver };
            }
            "stays" => self.ascends = !value.parse::<bool>().ok()?,
            "steep" => self.steep = value.parse().ok()?,
            "refines" => self.refines = value.parse().ok()?,
            "stop" => self.stop = part(value)?,
            "interpolates" => self.interpolates = value.parse().ok()?,
            "keep" => self.keep = part(value)?,
            _ => return None,
        }
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_what_differs_from_the_listing() {
        assert_eq!(Displacement::PUBLISHED.to_string(), "");
        assert_eq!(Displacement::LISTING.to_string(), "(integers: true)");
        let many =
            Displacement { caps: Some([12, 48]), steep: 1280, refines: true, stop: 320, ..Displacement::LISTING };
        assert_eq!(
            many.to_string(),
            "(integers: true, straight: 12, level: 48, steep: 1280, refines: true, stop: 1.25)"
        );
    }
}
