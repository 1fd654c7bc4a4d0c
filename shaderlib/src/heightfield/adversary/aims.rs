//! What a ray is aimed at.

use super::rays::{Case, Rays};
use crate::heightfield::Border;

/// What a ray is aimed at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// Down from above, from almost level to almost straight.
    Above,
    /// Through texels: corners of cells, where up to four meet.
    Vertices,
    /// Along the line of a row or column of texels: in two cells at once.
    Edges,
    /// At 45° through texels, or half-way between them.
    Diagonals,
    /// Along ±x or ±y.
    Axis,
    /// Straight down, or up, or standing still.
    Vertical,
    /// With components of ±0, of the smallest number, and of others that lead nowhere.
    Tiny,
    /// From a point on a border or a corner, any way.
    Borders,
    /// From the surface, or in the ground.
    Inside,
    /// Past the tip of a texel: 1/256 of a step above, at the very height, 1/256 below.
    Tips,
    /// Touches a saddle in the middle of its cell: both roots are one.
    Saddles,
    /// Any of the others a million tiles away; of a clamped map, from far outside.
    Far,
}

/// Every aim.
pub const AIMS: [Aim; 12] = {
    use Aim::{Above, Axis, Borders, Diagonals, Edges, Far, Inside, Saddles, Tiny, Tips, Vertical, Vertices};
    [Above, Vertices, Edges, Diagonals, Axis, Vertical, Tiny, Borders, Inside, Tips, Saddles, Far]
};

/// Tangents of elevations: 1°, 2°, 8°, 20°, 45°, 80°.
const ELEVATIONS: [f64; 6] = [0.0175, 0.0349, 0.1405, 0.364, 1.0, 5.67];

impl Rays<'_> {
    /// The next ray of a kind.
    pub fn case(&mut self, aim: Aim) -> Case {
        match aim {
            Aim::Above => {
                let tangent = self.random.one_of(&ELEVATIONS);
                self.above(tangent)
            }
            Aim::Vertices => {
                let [x, y] = self.texel();
                let way = [(); 2].map(|()| self.random.between(-3, 3) as i32);
                self.towards([x * 256, y * 256], way)
            }
            Aim::Edges => {
                let ([x, y], offset) = (self.texel(), self.random.between(0, 255));
                let way = self.axis();
                // Along y it is x that must be whole, and the other way round.
                let point = [x * 256 + offset * i64::from(way[0].abs()), y * 256 + offset * i64::from(way[1].abs())];
                self.towards(point, way)
            }
            Aim::Diagonals => {
                let ([x, y], offset) = (self.texel(), self.random.one_of(&[0, 0, 128]));
                let way = [(); 2].map(|()| self.random.one_of(&[-1, 1]));
                self.towards([x * 256 + offset, y * 256], way)
            }
            Aim::Axis => {
                let (point, way) = (self.place(), self.axis());
                self.towards(point, way)
            }
            Aim::Vertical => {
                let point = self.random.one_of(&[true, false]).then(|| self.texel().map(|at| at * 256));
                let point = point.unwrap_or_else(|| self.place());
                self.towards(point, [0, 0])
            }
            Aim::Tiny => self.tiny(),
            Aim::Borders => {
                let ([x, y], [dx, dy]) = (self.texel(), self.azimuth());
                let offset = self.random.one_of(&[0, 1, 77, 255]);
                let (z, dz) = self.fall();
                self.from([x * 256, y * 256 + offset, z], [dx, dy, dz])
            }
            Aim::Inside => {
                let ([x, y], [dx, dy]) = (self.texel(), self.azimuth());
                let depth = self.random.one_of(&[0, 0, 1, 256, 25600]);
                let rise = self.random.between(-100_000, 1_000_000) as i32;
                self.from([x * 256, y * 256, self.step(x, y) * 256 - depth], [dx, dy, rise])
            }
            Aim::Tips => self.tip(),
            Aim::Saddles => self.saddle(),
            Aim::Far => self.far(),
        }
    }

    /// Through a point at any height, with a direction of so many 1/256 of a way that t is rarely a round number.
    fn towards(&mut self, [x, y]: [i64; 2], way: [i32; 2]) -> Case {
        let many = self.random.between(1, 600) as i32;
        let (z, dz) = self.fall();
        self.through([x, y, z], [way[0] * many, way[1] * many, dz])
    }

    /// A height between the lowest and the highest texel, and a rate downwards, sometimes upwards, sometimes 0.
    fn fall(&mut self) -> (i64, i32) {
        let height = self.random.between(0, self.tip[2] * 256 + 256);
        let most = self.random.one_of(&[0, 1, 256, self.range * 16, self.range * 256]);
        (height, self.random.between(-most, most / 4) as i32)
    }

    fn tiny(&mut self) -> Case {
        let aim = self.random.one_of(&[Aim::Edges, Aim::Axis, Aim::Vertical, Aim::Tips]);
        let mut case = self.case(aim);
        for axis in 0..3 {
            // On a clamped map's border the smallest component would lead beyond it.
            let last = self.heights.size().map(|side| (i64::from(side) - 1) * 256);
            let edge = |axis: usize| axis < 2 && [0, last[axis]].contains(&case.fixed.origin[axis]);
            let signs = &[0.0, -0.0, 5e-324, -5e-324, 1e-310, -1e-310, 1e-200, -1e-200];
            let zeros = self.heights.border() == Border::Clamp && edge(axis);
            let tiny = self.random.one_of(if zeros { &signs[..2] } else { signs });
            if case.fixed.direction[axis] == 0 {
                case.ray.direction[axis] = tiny;
            }
        }
        case
    }

    fn tip(&mut self) -> Case {
        let any = self.texel();
        let [x, y, z] = self.random.one_of(&[self.tip, [any[0], any[1], self.step(any[0], any[1])]]);
        let lift = self.random.one_of(&[-1, 0, 0, 1]);
        let ([dx, dy], dz) = (self.azimuth(), self.random.one_of(&[0, 0, 1, -1, -777]));
        self.through([x * 256, y * 256, z * 256 + lift], [dx, dy, dz])
    }

    /// Along a diagonal the surface is a parabola, and the tangent in its middle has whole numbers, in 1/256.
    fn saddle(&mut self) -> Case {
        let [x, y] = self.texel();
        let [a, b, c, d] = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| self.step(x + i, y + j));
        let many = self.random.between(1, 256);
        let (turn, slope) = if a - b - c + d > 0 { (-1, b - c) } else { (1, d - a) };
        let point = [x * 256 + 128, y * 256 + 128, 64 * (a + b + c + d)];
        self.through(point, [many, turn * many, slope * many].map(|rate| rate as i32))
    }

    fn far(&mut self) -> Case {
        let near = self.random.one_of(&AIMS[..11]);
        if self.heights.border() == Border::Clamp {
            let ([x, y], [dx, dy]) = (self.texel(), self.azimuth());
            let z = self.random.between(0, self.tip[2] * 256);
            return self.since([x * 256, y * 256, z], [dx, dy, 0], 10_000);
        }
        let mut case = self.case(near);
        for axis in [0, 1] {
            let tiles = self.random.between(-1_000_000, 1_000_000);
            case.fixed.origin[axis] += tiles * i64::from(self.heights.size()[axis]) * 256;
            case.ray.origin[axis] = case.fixed.origin[axis] as f64 / 256.0;
        }
        case
    }

    fn axis(&mut self) -> [i32; 2] {
        self.random.one_of(&[[1, 0], [-1, 0], [0, 1], [0, -1]])
    }

    fn texel(&mut self) -> [i64; 2] {
        self.heights.size().map(|side| self.random.between(0, i64::from(side) - 1))
    }

    fn place(&mut self) -> [i64; 2] {
        self.heights.size().map(|side| self.random.between(0, i64::from(side) * 256 - 1))
    }

    fn step(&self, x: i64, y: i64) -> i64 {
        self.heights.height(x, y) as i64
    }
}
