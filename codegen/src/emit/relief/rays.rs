//! What rays meet of the displaced surface: of the eye, of the sun, of the sky.
//!
//! Each search stands in the text once for all layers whose height maps are as large, and for both mips between which a pixel
//! lies. Drivers inline every call: with a copy for each layer and mip an NVIDIA driver compiled `graphs/scenes/yard.ron` 2.7 times as
//! long, and llvmpipe three times.

use terrane_shaderlib::relief::{Bounds, MapTexture};

use super::{Writer, relief_member, textures};
use crate::graph::model::{ReliefMethod, ReliefShadow};
use crate::program::ReliefArray;
use crate::value::Literal;

/// A line for each layer, and what is around it.
struct OverLayers<'a> {
    doc: &'a str,
    /// The function's head; RELIEF is the surface with its maps.
    head: &'a str,
    begin: &'a str,
    /// LAYER is a layer, MAPS those of its maps.
    each: &'a str,
    /// What it reads.
    maps: &'a [MapTexture],
    end: &'a str,
}

/// The function that gives a layer of an array by its number.
fn numbered(array: &ReliefArray) -> String {
    format!("terrane_relief_{}x{}", array.size.0, array.size.1)
}

impl Writer<'_> {
    pub(super) fn rays(&mut self) {
        if self.relief.method.bounds() == Bounds::Wide {
            self.wide_corner();
        }
        self.search();
        self.numbered();
        self.displace();
        self.shadow();
        self.occlusion();
    }

    /// The arrays of height maps with the members of their layers.
    fn arrays(&self) -> Vec<(ReliefArray, Vec<String>)> {
        let displaced = self.displaced();
        let members = |index: usize| {
            let own = displaced.iter().filter(|(_, relief)| relief.array == index);
            own.map(|(name, _)| relief_member(name)).collect::<Vec<_>>()
        };
        let all = self.relief.arrays.iter().enumerate().map(|(index, array)| (array.clone(), members(index)));
        all.filter(|(_, members)| !members.is_empty()).collect()
    }

    /// The first hit of one layer, on the mip that fits the pixel or between two.
    fn search(&mut self) {
        let method = self.relief.method;
        let maps = self.relief.searched();
        let maps = maps.iter().map(|texture| format!(", {}: {}", texture.name(), texture.wgsl()));
        let maps: String = maps.collect();
        self.shader.line("");
        self.shader.line("/// The first hit of one layer, on the mip that fits the pixel or between two.");
        self.shader.open(&format!("fn terrane_search(layer: DisplacedLayer, ray: DisplacedRay{maps}) -> DisplacedHit"));
        self.shader.line("let first = i32(layer.level);");
        if let ReliefMethod::Auto { max_error } = self.relief.trace.method {
            let error = Literal::f32(max_error).wgsl();
            self.shader.open(&format!("if displaced_way(displaced_search(layer, ray, first)) <= {error}"));
            self.shader.line("return displaced_glance(heights, layer, ray);");
            self.shader.close();
        }
        self.shader.line("var hit = DisplacedHit(0.0f, 0u, true);");
        self.shader.open("for (var coarser = 0i; coarser < displaced_mips(layer); coarser++)");
        self.shader.line("let mip = first + coarser;");
        self.shader.line("let search = displaced_search(layer, ray, mip);");
        self.shader.line(match method.bounds() {
            Bounds::Wide => "let field = displaced_field_wide(layer, mip, terrane_wide_corner(layer.size, mip));",
            _ => "let field = displaced_field(layer, mip);",
        });
        let bounds = method.bounds();
        let surface = bounds.surface().map_or("", MapTexture::name);
        let found = method.call(surface, MapTexture::Bounds(bounds).name(), "field", "search.ray");
        self.shader.line(&format!("let found = displaced_found(search, {found});"));
        self.shader.line("hit = displaced_between(hit, found, displaced_part(layer, coarser));");
        self.shader.close();
        self.shader.line("return hit;");
        self.shader.close();
    }

    fn numbered(&mut self) {
        for (array, members) in self.arrays().iter().filter(|(_, members)| members.len() > 1) {
            self.shader.line("");
            self.shader.line("/// One of the layers whose height maps are of this size, by its number.");
            let head = format!("fn {}(relief: TerrainRelief, index: u32) -> DisplacedLayer", numbered(array));
            self.shader.open(&head);
            self.shader.line(&format!("var layer = relief.{};", members[0]));
            self.shader.open("switch index");
            for (index, member) in members.iter().enumerate().skip(1) {
                self.shader.line(&format!("case {index}u: {{ layer = relief.{member}; }}"));
            }
            self.shader.line("default: {}");
            self.shader.close();
            self.shader.line("return layer;");
            self.shader.close();
        }
    }

    /// A function over all layers that are there.
    fn over_layers(&mut self, over: &OverLayers<'_>) {
        let textures = textures(self.relief).into_iter().map(|(name, ty)| format!("{name}: {ty}"));
        let arguments: Vec<String> = std::iter::once("relief: TerrainRelief".to_owned()).chain(textures).collect();
        self.shader.line("");
        self.shader.line(over.doc);
        self.shader.open(&over.head.replace("RELIEF", &arguments.join(", ")));
        self.shader.line(over.begin);
        for (array, members) in self.arrays() {
            let maps = over.maps.iter().map(|texture| array.name(*texture)).collect::<Vec<_>>().join(", ");
            let each = |layer: &str| over.each.replace("LAYER", layer).replace("MAPS", &maps);
            if let [member] = members.as_slice() {
                self.if_there(&format!("relief.{member}"), &each(&format!("relief.{member}")));
            } else {
                self.shader.open(&format!("for (var index = 0u; index < {}u; index++)", members.len()));
                self.shader.line(&format!("let layer = {}(relief, index);", numbered(&array)));
                self.if_there("layer", &each("layer"));
                self.shader.close();
            }
        }
        self.shader.line(over.end);
        self.shader.close();
    }

    fn if_there(&mut self, layer: &str, line: &str) {
        self.shader.open(&format!("if {layer}.depth > 0.0f"));
        self.shader.line(line);
        self.shader.close();
    }

    fn displace(&mut self) {
        self.over_layers(&OverLayers {
            doc: "/// Where a ray from the eye meets the displaced ground.",
            head: "fn terrane_displace(ray: DisplacedRay, RELIEF) -> DisplacedHit",
            begin: "var hit = displaced_plane(ray, relief.bottom);",
            each: "hit = displaced_nearer(hit, terrane_search(LAYER, ray, MAPS));",
            maps: &self.relief.searched(),
            end: "return hit;",
        });
    }

    fn shadow(&mut self) {
        let each = match self.relief.trace.shadow {
            ReliefShadow::Off => return,
            ReliefShadow::Hard => "share = min(share, displaced_light_hard(LAYER, ray, MAPS));".to_owned(),
            ReliefShadow::Cone { planes } => {
                format!("share = min(share, displaced_light_disc(LAYER, ray, radius, {planes}u, MAPS));")
            }
        };
        self.over_layers(&OverLayers {
            doc: "/// How much of a disc the displaced ground leaves visible; `radius` is the tangent of its angular radius.",
            head: "fn terrane_relief_shadow(ray: DisplacedRay, radius: f32, RELIEF) -> f32",
            begin: "var share = 1.0f;",
            each: &each,
            maps: &MapTexture::LIGHT,
            end: "return share;",
        });
    }

    fn occlusion(&mut self) {
        let directions = self.relief.trace.occlusion;
        if directions > 0 {
            let each =
                format!("share = min(share, displaced_light_sky(LAYER, point, normal, turn, {directions}u, MAPS));");
            self.over_layers(&OverLayers {
                doc: "/// How much of the sky's light the displaced ground lets in, on a surface with a normal; `turn` is an angle.",
                head: "fn terrane_relief_occlusion(point: vec3f, normal: vec3f, turn: f32, RELIEF) -> f32",
                begin: "var share = 1.0f;",
                each: &each,
                maps: &MapTexture::LIGHT,
                end: "return share;",
            });
        }
    }
}
