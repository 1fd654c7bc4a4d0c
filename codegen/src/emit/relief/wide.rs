//! Where the bounds of `wide` begin, mip by mip: nothing that a shader could work out.

use terrane_shaderlib::relief::wide_corners;

use super::Writer;

impl Writer<'_> {
    /// A function of a map's size and a mip.
    pub(super) fn wide_corner(&mut self) {
        let sizes: Vec<(u32, u32)> = self.relief.arrays.iter().map(|array| array.size).collect();
        self.shader.line("");
        self.shader.line("/// The first node of a mip in the wide bounds over maps of a size.");
        self.shader.open("fn terrane_wide_corner(size: vec2i, mip: i32) -> i32");
        for (width, height) in sizes.iter().skip(1) {
            self.shader.open(&format!("if all(size == vec2i({width}i, {height}i))"));
            self.by_mip([*width, *height]);
            self.shader.close();
        }
        self.by_mip([sizes[0].0, sizes[0].1]);
        self.shader.close();
    }

    fn by_mip(&mut self, map: [u32; 2]) {
        let corners = wide_corners(map);
        self.shader.open("switch mip");
        for (mip, corner) in corners.iter().enumerate().skip(1) {
            self.shader.line(&format!("case {mip}i: {{ return {corner}i; }}"));
        }
        self.shader.line(&format!("default: {{ return {}i; }}", corners[0]));
        self.shader.close();
    }
}
