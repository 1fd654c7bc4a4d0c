//! Writes random WGSL.

use crate::support::Random;

/// A function `program(a: f32, b: f32, n: u32) -> vec4f` with branches, loops, jumps, arrays and a call.
pub(super) fn write(seed: u32) -> String {
    let mut writer = Writer { random: Random::new(seed), loops: 0, depth: 0, helper: true };
    let mut text = String::from("fn helper(a: f32, out: ptr<function, f32>) -> f32 {\n");
    text += "var x = array<f32, 3>(a, 0.5, *out); var n = 3u; var result = 0.25;\n";
    text += &writer.block();
    text += "*out = x[0] + *out * 0.5;\nreturn result + x[1];\n}\n";
    writer.helper = false;
    text += "fn program(a: f32, b: f32, m: u32) -> vec4f {\n";
    text += "var x = array<f32, 3>(a, b, a * b); var n = m; var result = vec4f(0.0);\n";
    (0..3).for_each(|_| text += &writer.block());
    text + "return result + vec4f(x[0], x[1], x[2], f32(n & 0xffffu));\n}\n"
}

struct Writer {
    random: Random,
    /// How many loops enclose the place.
    loops: u32,
    depth: u32,
    /// Whether the helper is written, which cannot call itself and returns a scalar.
    helper: bool,
}

impl Writer {
    fn block(&mut self) -> String {
        self.depth += 1;
        let count = 1 + self.random.below(3);
        let text = (0..count).map(|_| self.statement()).collect();
        self.depth -= 1;
        text
    }

    fn statement(&mut self) -> String {
        let deep = self.depth > 3;
        match self.random.below(if deep { 4 } else { 10 }) {
            0 => format!("n = {};\n", self.whole()),
            1 => format!("x[{}] = {};\n", self.element(), self.float(2)),
            2 if !self.helper => {
                let place = self.random.below(3);
                format!("result.y += helper({}, &x[{place}]);\n", self.float(1))
            }
            2 | 3 => format!("x[{}] = {};\n", self.random.below(3), self.float(3)),
            4 | 5 => format!("if ({}) {{\n{}{}}}\n", self.condition(2), self.block(), self.jump()),
            6 => format!(
                "if ({}) {{\n{}}} else {{\n{}{}}}\n",
                self.condition(2),
                self.block(),
                self.block(),
                self.jump()
            ),
            7 => self.for_loop(),
            8 => self.plain_loop(),
            _ => self.switch(),
        }
    }

    fn for_loop(&mut self) -> String {
        let bound = match self.random.below(3) {
            0 => "n & 3u".to_owned(),
            _ => format!("{}u", 1 + self.random.below(4)),
        };
        let name = format!("i{}", self.loops);
        self.loops += 1;
        let body = self.block();
        self.loops -= 1;
        format!("for (var {name} = 0u; {name} < ({bound}); {name}++) {{\n{body}}}\n")
    }

    fn plain_loop(&mut self) -> String {
        let name = format!("i{}", self.loops);
        self.loops += 1;
        let body = self.block();
        self.loops -= 1;
        let end = self.condition(1);
        format!("var {name} = 0u; loop {{\n{body}continuing {{ {name}++; break if {name} > 4u || {end}; }}\n}}\n")
            .replacen("var", "{ var", 1)
            + "}\n"
    }

    fn switch(&mut self) -> String {
        let selector = match self.random.below(2) {
            0 => format!("u32(abs({})) % 4u", self.float(1)),
            _ => "n % 4u".to_owned(),
        };
        // A jump out of a switch in a loop would be a `break` of the switch: only `continue` and `return` leave it.
        format!(
            "switch ({selector}) {{\ncase 0u: {{\n{}}}\ncase 1u, 2u: {{\n{}{}}}\ndefault: {{\n{}}}\n}}\n",
            self.block(),
            self.block(),
            self.jump(),
            self.block()
        )
    }

    /// What may end a block.
    fn jump(&mut self) -> String {
        match self.random.below(6) {
            0 if self.helper => format!("return {};\n", self.float(1)),
            0 => format!("return vec4f({}, x[0], x[1], f32(n & 0xffu));\n", self.float(1)),
            1 if self.loops > 0 => "break;\n".to_owned(),
            2 if self.loops > 0 => "continue;\n".to_owned(),
            _ => String::new(),
        }
    }

    fn condition(&mut self, depth: u32) -> String {
        match self.random.below(if depth == 0 { 3 } else { 6 }) {
            0 => format!("{} < {}", self.float(1), self.float(1)),
            1 => format!("x[{}] >= {}", self.random.below(3), self.constant()),
            2 => format!("(n & {}u) == 0u", 1 + self.random.below(3)),
            3 => format!("({}) && ({})", self.condition(depth - 1), self.condition(depth - 1)),
            4 => format!("({}) || ({})", self.condition(depth - 1), self.condition(depth - 1)),
            _ => format!("!({})", self.condition(depth - 1)),
        }
    }

    fn element(&mut self) -> String {
        match self.random.below(3) {
            0 => "n % 3u".to_owned(),
            1 => format!("u32(abs(x[0] + {}))", self.float(1)),
            _ => self.random.below(3).to_string(),
        }
    }

    fn constant(&mut self) -> String {
        format!("({:?}f)", (self.random.below(60) as f32 - 30.0) / 10.0)
    }

    fn whole(&mut self) -> String {
        match self.random.below(4) {
            0 => format!("n + {}u", self.random.below(5)),
            1 => format!("select(n, {}u, {})", self.random.below(9), self.condition(1)),
            2 => format!("u32({}) ^ (n >> 1u)", self.float(1)),
            _ => "(n * 5u + 3u) & 15u".to_owned(),
        }
    }

    fn float(&mut self, depth: u32) -> String {
        if depth == 0 {
            return match self.random.below(5) {
                0 => self.constant(),
                1 => "a".to_owned(),
                2 => "f32(n & 7u)".to_owned(),
                3 => format!("x[{}]", self.element_plain()),
                _ => format!("x[{}]", self.random.below(3)),
            };
        }
        let mut part = || self.float(depth - 1);
        let (a, b, c) = (part(), part(), part());
        match self.random.below(12) {
            0 => format!("({a} + {b})"),
            1 => format!("({a} - {b})"),
            2 => format!("clamp({a} * {b}, -9.0, 9.0)"),
            3 => format!("({a} / (1.0 + abs({b})))"),
            4 => format!("min({a}, {b})"),
            5 => format!("max({a}, -{b})"),
            6 => format!("(floor({a}) + fract({b}))"),
            7 => format!("mix({a}, {b}, saturate({c}))"),
            8 => format!("select({a}, {b}, {c} > {a})"),
            9 => format!("dot(vec3f({a}, {b}, 1.0), vec3f(0.5, {c}, -0.25))"),
            10 => format!("smoothstep(-2.0, 3.0, {a})"),
            _ => format!("clamp(abs({a}), {}, 5.0)", "0.5"),
        }
    }

    fn element_plain(&mut self) -> String {
        if self.random.below(2) == 0 { "n % 3u".to_owned() } else { self.random.below(3).to_string() }
    }
}
