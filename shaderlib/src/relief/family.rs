//! Methods by name: how each is written, and which budgets of it are measured where none is named.

use std::fmt;
use std::str::FromStr;

use super::Displacement;
use super::method::Method;

/// A method with all its budgets.
struct Family {
    /// The word before the budget.
    name: &'static str,
    /// What stands in its brackets; nothing for a method without a budget.
    budget: &'static str,
    /// Those that a name alone stands for.
    defaults: &'static [Method],
    /// That of a budget as it is written, if there is one.
    with: fn(&str) -> Option<Method>,
}

/// Every method that can be named; a new one is a line here.
const FAMILIES: &[Family] = &[
    single("maximum_mipmaps", &[Method::MaximumMipmaps]),
    single("walk", &[Method::Walk]),
    single("sprint", &[Method::Sprint]),
    single("wide", &[Method::Wide]),
    Family {
        name: "linear_secant",
        budget: "STEPS",
        defaults: &[Method::Linear(32, 0), Method::Linear(128, 0), Method::Linear(512, 0)],
        with: |budget| numbers(budget).filter(|[steps]| *steps > 0).map(|[steps]| Method::Linear(steps, 0)),
    },
    Family {
        name: "linear_binary",
        budget: "STEPS, HALVINGS",
        defaults: &[Method::Linear(32, 6), Method::Linear(128, 6)],
        with: |budget| {
            let both = numbers(budget).filter(|[steps, halvings]| *steps > 0 && *halvings > 0);
            both.map(|[steps, halvings]| Method::Linear(steps, halvings))
        },
    },
    Family {
        name: "parallax_offset",
        budget: "STEPS A TEXEL",
        defaults: &[Method::ParallaxOffset(1280)],
        with: |budget| numbers(budget).map(|[steep]| Method::ParallaxOffset(steep)),
    },
    Family {
        name: "quadtree_displacement",
        budget: "SWITCH: VALUE, …",
        defaults: &[Method::QuadtreeDisplacement(Displacement::PUBLISHED)],
        with: |budget| Displacement::parse(budget).map(Method::QuadtreeDisplacement),
    },
    single("quadtree_displacement_repaired", &[Method::QuadtreeDisplacementRepaired]),
    Family {
        name: "quadtree_relief",
        budget: "FINEST LEVEL",
        defaults: &[Method::QuadtreeRelief(0)],
        with: |budget| numbers(budget).filter(|[finest]| *finest < 16).map(|[finest]| Method::QuadtreeRelief(finest)),
    },
    single("quadtree_relief_exact", &[Method::QuadtreeReliefExact]),
    single("robust_cone", &[Method::RobustCone]),
    single("stride", &[Method::Stride]),
    single("stride_quadrants", &[Method::StrideQuadrants]),
    single("leap", &[Method::Leap]),
    Family {
        name: "cone_step",
        budget: "STEPS",
        defaults: &[Method::ConeStep(0), Method::ConeStep(32)],
        with: |budget| numbers(budget).filter(|[steps]| *steps > 0).map(|[steps]| Method::ConeStep(steps)),
    },
    Family {
        name: "relaxed_cone",
        budget: "STEPS, HALVINGS",
        defaults: &[Method::RelaxedCone(15, 8)],
        with: |budget| {
            let both = numbers(budget).filter(|[steps, _]| *steps > 0);
            both.map(|[steps, halvings]| Method::RelaxedCone(steps, halvings))
        },
    },
];

/// So many whole numbers with commas between them.
fn numbers<const N: usize>(text: &str) -> Option<[u32; N]> {
    let numbers: Vec<u32> = text.split(',').map(|part| part.trim().parse().ok()).collect::<Option<_>>()?;
    numbers.try_into().ok()
}

/// A method without a budget.
const fn single(name: &'static str, defaults: &'static [Method]) -> Family {
    Family { name, budget: "", defaults, with: |_| None }
}

impl Family {
    /// `linear_binary(STEPS, HALVINGS)`
    fn form(&self) -> String {
        if self.budget.is_empty() { self.name.into() } else { format!("{}({})", self.name, self.budget) }
    }
}

/// Why a text names no method.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MethodError {
    /// There is no such name.
    Unknown(String),
    /// The budget is none of the method's: what was written, and how it is.
    Budget(String, String),
}

impl fmt::Display for MethodError {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown(name) => {
                let forms: Vec<String> = FAMILIES.iter().map(|family| format!("`{}`", family.form())).collect();
                write!(to, "there is no method `{name}`; there is {}", forms.join(", "))
            }
            Self::Budget(text, form) => write!(to, "`{text}` is no budget of `{form}`"),
        }
    }
}

impl std::error::Error for MethodError {}

impl Method {
    /// Every method with the budgets that are measured unless others are named.
    #[must_use]
    pub fn all() -> Vec<Self> {
        FAMILIES.iter().flat_map(|family| family.defaults).copied().collect()
    }

    /// The names that methods have, without budgets.
    pub fn names() -> impl Iterator<Item = &'static str> {
        FAMILIES.iter().map(|family| family.name)
    }

    /// The methods that a text means: one with its budget, or by its name alone all that are measured of it.
    ///
    /// # Errors
    /// Those of [`MethodError`].
    pub fn named(text: &str) -> Result<Vec<Self>, MethodError> {
        let text = text.trim();
        match FAMILIES.iter().find(|family| family.name == text) {
            Some(family) => Ok(family.defaults.to_vec()),
            None => Ok(vec![text.parse()?]),
        }
    }

    /// The methods of a list; commas in brackets do not part it. Each stands once.
    ///
    /// # Errors
    /// Those of [`MethodError`].
    pub fn list(text: &str) -> Result<Vec<Self>, MethodError> {
        let mut depth = 0;
        let parts = text.split(|letter| {
            depth += i32::from(letter == '(') - i32::from(letter == ')');
            letter == ',' && depth == 0
        });
        let mut methods = Vec::new();
        for method in parts.map(Self::named).collect::<Result<Vec<_>, _>>()?.concat() {
            if !methods.contains(&method) {
                methods.push(method);
            }
        }
        Ok(methods)
    }

    /// Its name without the budget.
    #[must_use]
    pub fn name(self) -> String {
        let text = self.to_string();
        text.split('(').next().unwrap_or_default().to_owned()
    }
}

impl FromStr for Method {
    type Err = MethodError;

    /// What `Display` writes: `walk`, `linear_binary(32, 6)`.
    fn from_str(text: &str) -> Result<Self, MethodError> {
        let text = text.trim();
        let (name, budget) = match text.split_once('(') {
            Some((name, rest)) => (name.trim_end(), rest.strip_suffix(')').map(str::trim)),
            None => (text, Some("")),
        };
        let family = FAMILIES.iter().find(|family| family.name == name);
        let family = family.ok_or_else(|| MethodError::Unknown(name.into()))?;
        // A method without brackets is one by itself.
        let spelled = |method: &&Method| method.to_string() == text;
        let method = family.defaults.iter().find(spelled).copied().or_else(|| (family.with)(budget?));
        let written = text[name.len()..].trim().to_owned();
        method.ok_or_else(|| MethodError::Budget(written, family.form()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_method_is_read_as_it_is_written() {
        for method in Method::all() {
            assert_eq!(method.to_string().parse(), Ok(method));
        }
        assert_eq!(" linear_secant( 64 ) ".parse(), Ok(Method::Linear(64, 0)));
        assert_eq!("linear_binary(7,3)".parse(), Ok(Method::Linear(7, 3)));
        let switched = Displacement { caps: Some([12, 48]), refines: true, stop: 320, ..Displacement::PUBLISHED };
        let method = Method::QuadtreeDisplacement(switched);
        assert_eq!(method.to_string().parse(), Ok(method));
    }

    #[test]
    fn every_name_is_that_of_its_methods() {
        for family in FAMILIES {
            assert!(!family.defaults.is_empty(), "{}", family.name);
            assert!(family.defaults.iter().all(|method| method.name() == family.name), "{}", family.name);
        }
    }

    #[test]
    fn a_list_keeps_its_order_and_repeats_nothing() {
        let methods = Method::list("linear_binary(8, 2),walk,linear_binary, walk,linear_binary(32,6)").unwrap();
        assert_eq!(methods, [Method::Linear(8, 2), Method::Walk, Method::Linear(32, 6), Method::Linear(128, 6)]);
    }

    #[test]
    fn mistakes_are_said() {
        let said = |text: &str| Method::list(text).unwrap_err().to_string();
        assert!(said("quux").starts_with("there is no method `quux`; there is `maximum_mipmaps`, `walk`, "));
        assert!(said("quux").contains("`linear_binary(STEPS, HALVINGS)`"));
        let none = |budget: &str, form: &str| format!("`{budget}` is no budget of `{form}`");
        assert_eq!(said("linear_secant(0)"), none("(0)", "linear_secant(STEPS)"));
        assert_eq!(said("linear_secant(4, 5)"), none("(4, 5)", "linear_secant(STEPS)"));
        assert_eq!(said("linear_secant(4"), none("(4", "linear_secant(STEPS)"));
        assert_eq!(said("linear_secant(-4)"), none("(-4)", "linear_secant(STEPS)"));
        assert_eq!(said("walk(3)"), none("(3)", "walk"));
        assert!(said("").contains("there is no method ``; there is "));
    }
}
