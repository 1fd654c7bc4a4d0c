//! The displaced surface of a shader's layers: where it lies, and what a ray meets of it.

mod rays;
mod wide;

use super::arguments::{Arguments, arguments};
use super::compose::Composer;
use super::names::{Names, layer_word};
use super::text::{Place, Shader};
use crate::library::Library;
use crate::patch::{ReliefPart, Scope, Scopes, Specialization};
use crate::program::{LayerRelief, Program, ProgramLayer, ProgramRelief};
use crate::value::Literal;

/// Writes the functions around the displaced surface.
struct Writer<'a> {
    program: &'a Program,
    patch: &'a Specialization,
    relief: &'a ProgramRelief,
    part: &'a ReliefPart,
    names: &'a Names<'a>,
    shader: &'a mut Shader,
}

/// Everything about relief, if there is any.
pub(super) fn relief(shader: &mut Shader, library: &Library, program: &Program, patch: &Specialization) {
    if let (Some(part), Some(relief)) = (&patch.relief, &program.relief) {
        let names = Names::new(library, program, &patch.live);
        let mut writer = Writer { program, patch, relief, part, names: &names, shader };
        writer.structs();
        writer.coordinates();
        writer.place();
        writer.rays();
    }
}

/// What `terrane_relief` is given: a place, the ground's axes there, the width of a pixel, and what masks and coordinates read.
pub(crate) fn relief_arguments(program: &Program, part: &ReliefPart) -> Arguments {
    arguments(program, &part.live(), &["tangent: vec3f", "bitangent: vec3f", "pixel: f32"])
}

/// The member of a layer in the structs of relief: its name alone may be that of another member, or a word of WGSL.
pub(super) fn relief_member(layer: &str) -> String {
    layer_word(layer, "relief")
}

/// Names and types of the textures of all height maps.
pub(crate) fn textures(relief: &ProgramRelief) -> Vec<(String, String)> {
    relief.maps().map(|(array, texture)| (array.name(texture), texture.wgsl())).collect()
}

impl Writer<'_> {
    /// Visible layers, bottom to top.
    fn layers(&self) -> impl Iterator<Item = (usize, &ProgramLayer)> {
        self.patch.layers.iter().map(|layer| &self.program.layers[*layer]).enumerate()
    }

    /// Names and reliefs of those that have one.
    fn displaced(&self) -> Vec<(String, LayerRelief)> {
        self.layers().filter_map(|(_, layer)| Some((layer.name.clone(), layer.relief?))).collect()
    }

    fn structs(&mut self) {
        let names: Vec<String> = self.displaced().iter().map(|(name, _)| relief_member(name)).collect();
        self.shader.line("");
        self.shader.line("/// Coordinates of the height maps.");
        self.shader.open("struct TerrainCoordinates");
        names.iter().for_each(|name| self.shader.line(&format!("{name}: Coord,")));
        self.shader.close();
        self.shader.line("");
        self.shader.line("/// The displaced ground at one place.");
        self.shader.open("struct TerrainRelief");
        self.shader
            .line("deepest: f32,     // metres from the ground down to the lowest point; 0 where nothing is displaced");
        self.shader.line("bottom: f32,      // metres from the ground down to the highest layer without a relief");
        names.iter().for_each(|name| self.shader.line(&format!("{name}: DisplacedLayer,")));
        self.shader.close();
    }

    fn values(&mut self, scopes: &Scopes) {
        for id in scopes.values(&self.program.pool, Scope::Root) {
            let line = format!("let {} = {};", self.names.name(id), self.names.expression(id));
            self.shader.mapped(Place::Value(id), &line);
        }
    }

    fn coordinates(&mut self) {
        let arguments = arguments(self.program, &self.part.coordinates.live(), &[]);
        self.shader.line("");
        self.shader.line("/// Coordinates of the height maps at a place.");
        self.shader.open(&format!("fn terrane_coordinates({}) -> TerrainCoordinates", arguments.declared()));
        let part = self.part;
        self.values(&part.coordinates);
        let values: Vec<String> = self.displaced().iter().map(|(_, relief)| self.names.read(relief.uv)).collect();
        self.shader.line(&format!("return TerrainCoordinates({});", values.join(", ")));
        self.shader.close();
    }

    fn place(&mut self) {
        let all = relief_arguments(self.program, self.part);
        self.shader.line("");
        self.shader.line("/// The displaced ground under a place. The two vectors span the ground, with length 1; a pixel is so wide in metres.");
        self.shader.open(&format!("fn terrane_relief({}) -> TerrainRelief", all.declared()));
        let part = self.part;
        self.values(&part.masks);
        let (program, patch, names) = (self.program, self.patch, self.names);
        if patch.layers.len() > 1 {
            Composer { program, patch, names, shader: &mut *self.shader }.shares();
        }
        self.axes();
        self.depths();
        self.shader.close();
    }

    fn axes(&mut self) {
        let inner = arguments(self.program, &self.part.coordinates.live(), &[]);
        self.shader.line("");
        self.shader.line("// Coordinates carry their gradients: those along the ground are the axes of the map.");
        self.shader.line("var axes = terrain;");
        self.shader.line("axes.position.ddx = tangent;");
        self.shader.line("axes.position.ddy = bitangent;");
        let call: Vec<&str> = std::iter::once("axes").chain(inner.names().skip(1)).collect();
        self.shader.line(&format!("let coordinates = terrane_coordinates({});", call.join(", ")));
    }

    fn depths(&mut self) {
        let (near, far) = self.relief.trace.fade;
        let number = |value: f32| Literal::f32(value).wgsl();
        self.shader.line(&format!("let fade = displaced_fade(terrain.distance, {}, {});", number(near), number(far)));
        let deepest = self.displaced().iter().map(|(_, relief)| relief.depth).fold(0.0, f32::max);
        self.shader.line(&format!("let deepest = fade * {};", number(deepest)));
        let many = self.patch.layers.len() > 1;
        if many {
            let shares: Vec<String> = self.layers().map(|(_, layer)| layer_word(&layer.name, "share")).collect();
            let largest = shares[1..].iter().fold(shares[0].clone(), |all, share| format!("max({all}, {share})"));
            self.shader.line(&format!("let largest = {largest};"));
        }
        let flat: Vec<String> =
            self.layers().filter(|(_, layer)| layer.relief.is_none()).map(|(_, layer)| layer.name.clone()).collect();
        let sinks = flat.iter().map(|name| format!("displaced_sink({}, largest, deepest)", layer_word(name, "share")));
        let bottom = sinks.fold("deepest".to_owned(), |bottom, sink| format!("min({bottom}, {sink})"));
        self.shader.line(&format!("let bottom = {bottom};"));
        let layers: Vec<String> =
            self.displaced().iter().map(|(name, relief)| self.layer(name, relief, many)).collect();
        self.shader.line("return TerrainRelief(");
        self.shader.line(&format!("    deepest,\n        bottom,\n        {},", layers.join(",\n        ")));
        self.shader.line(");");
    }

    fn layer(&self, name: &str, relief: &LayerRelief, many: bool) -> String {
        let (width, height) = self.relief.arrays[relief.array].size;
        let depth = format!("fade * {}", Literal::f32(relief.depth).wgsl());
        let share = layer_word(name, "share");
        let (depth, sink) = if many {
            let present = format!("select(0.0f, {depth}, {share} > TERRANE_VISIBLE)");
            (present, format!("displaced_sink({share}, largest, deepest)"))
        } else {
            (depth, "0.0f".to_owned())
        };
        let map = format!("vec2i({width}i, {height}i), {}i", relief.layer);
        format!("displaced_layer(coordinates.{}, {map}, {depth}, {sink}, pixel)", relief_member(name))
    }
}
