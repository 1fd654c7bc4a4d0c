//! From a combination to what must be computed, and where.

use std::collections::{BTreeMap, BTreeSet};

use super::{Combination, ReliefPart, Scope, Scopes, Specialization};
use crate::graph::model::Blend;
use crate::program::{Options, Program, ProgramLayer};
use crate::value::Literal;

/// Decides what a combination of layers needs.
pub fn specialize(program: &Program, combination: &Combination, options: Options) -> Specialization {
    let layers = visible(program, combination);
    let blended = blended(program, &layers);
    let mut scopes = Scopes::new(if options.guard { parents(program.blend, layers.len()) } else { BTreeMap::new() });
    for (index, layer) in layers.iter().enumerate() {
        let layer = &program.layers[*layer];
        let at = |scope| if options.guard { scope } else { Scope::Root };
        // The bottom layer lies everywhere.
        if index > 0 {
            scopes.demand(layer.mask, at(mask_scope(program.blend, index, layers.len())));
        }
        if layers.len() > 1 && program.blend != Blend::Over {
            scopes.demand(layer.outputs["height"], at(Scope::Weigh(index)));
        }
        for (name, value) in layer.outputs.iter().filter(|(name, _)| **name != "height") {
            let scope = if blended.contains(name) { at(Scope::Paint(index)) } else { Scope::Root };
            scopes.demand(*value, scope);
        }
    }
    scopes.settle(&program.pool);
    let relief = relief(program, &layers);
    let traced = relief.iter().flat_map(ReliefPart::live);
    let live = scopes.live().into_iter().chain(traced).collect();
    Specialization { combination: combination.clone(), layers, scopes, guard: options.guard, blended, relief, live }
}

/// Every visible layer is asked how much of the ground it covers, those with a relief also where their maps lie.
fn relief(program: &Program, layers: &[usize]) -> Option<ReliefPart> {
    let layers: Vec<&ProgramLayer> = layers.iter().map(|layer| &program.layers[*layer]).collect();
    layers.iter().any(|layer| layer.relief.is_some()).then(|| {
        let (mut masks, mut coordinates) = (Scopes::default(), Scopes::default());
        layers.iter().skip(1).for_each(|layer| masks.demand(layer.mask, Scope::Root));
        for relief in layers.iter().filter_map(|layer| layer.relief) {
            coordinates.demand(relief.uv, Scope::Root);
        }
        masks.settle(&program.pool);
        coordinates.settle(&program.pool);
        ReliefPart { masks, coordinates }
    })
}

/// Layers whose mask is known to be 0 are gone, and so is what lies under a mask known to be 1.
fn visible(program: &Program, combination: &Combination) -> Vec<usize> {
    let mask = |layer: usize| program.pool.literal(program.layers[layer].mask);
    let present = |layer: &usize| *layer == 0 || mask(*layer) != Some(Literal::f32(0.0));
    let layers: Vec<usize> = combination.0.iter().copied().filter(present).collect();
    let opaque = layers.iter().rposition(|layer| mask(*layer) == Some(Literal::f32(1.0)));
    layers[opaque.unwrap_or(0)..].to_vec()
}

/// An output that is the same value in every layer needs no blending.
fn blended(program: &Program, layers: &[usize]) -> BTreeSet<&'static str> {
    let names = program.layers.iter().flat_map(|layer| layer.outputs.keys().copied());
    let differs = |name: &&'static str| {
        let values: BTreeSet<_> = layers.iter().map(|layer| program.layers[*layer].outputs[*name]).collect();
        values.len() > 1
    };
    names.filter(|name| *name != "height").filter(differs).collect()
}

/// Strict order asks for a mask only where something is left to cover; heights are compared among all layers at once.
fn mask_scope(blend: Blend, index: usize, count: usize) -> Scope {
    match blend {
        Blend::Over if index + 1 < count => Scope::Cover(index),
        _ => Scope::Root,
    }
}

fn parents(blend: Blend, count: usize) -> BTreeMap<Scope, Scope> {
    let mut parents = BTreeMap::new();
    for index in 0..count {
        let cover = if index + 1 < count { Scope::Cover(index) } else { Scope::Root };
        if blend == Blend::Over {
            parents.insert(Scope::Paint(index), cover);
            let above = if index + 2 < count { Scope::Cover(index + 1) } else { Scope::Root };
            parents.insert(Scope::Cover(index), above);
        } else {
            // A layer that is painted has been weighed: the share of a weight below the threshold is 0.
            parents.insert(Scope::Paint(index), Scope::Weigh(index));
            parents.insert(Scope::Weigh(index), Scope::Root);
        }
    }
    parents
}
