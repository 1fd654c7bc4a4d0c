//! The cells under a row of nodes.

use super::windows::steepen;

/// Nodes that are looked at together.
const TOGETHER: usize = 32;

/// The slopes and tips of the cells under a row of nodes, and what they were at first at the least.
pub(super) struct NodeRow<'a> {
    level: usize,
    width: usize,
    tips: &'a [f32],
    slopes: &'a mut [f32],
    /// The lowest tip and the gentlest slope under each node.
    least: Vec<[f32; 2]>,
    /// The heights of nodes, one for each column of cells.
    spread: Vec<f32>,
}

impl<'a> NodeRow<'a> {
    pub(super) fn new(level: usize, width: usize, tips: &'a [f32], slopes: &'a mut [f32]) -> Self {
        let mut least = vec![[f32::MAX; 2]; width.div_ceil(1 << level)];
        for (tips, slopes) in tips.chunks_exact(width).zip(slopes.chunks_exact(width)) {
            let nodes = tips.chunks(1 << level).zip(slopes.chunks(1 << level));
            for ([tip, slope], (tips, slopes)) in least.iter_mut().zip(nodes) {
                *tip = tips.iter().fold(*tip, |least, tip| smaller(least, *tip));
                *slope = slopes.iter().fold(*slope, |least, slope| smaller(least, *slope));
            }
        }
        Self { level, width, tips, slopes, least, spread: Vec::new() }
    }

    /// Brings slopes up to those to what stands highest at a distance from each node, of which one over it is the share.
    pub(super) fn steepen(&mut self, highest: &[f32], share: f32) {
        for (part, (highest, least)) in highest.chunks(TOGETHER).zip(self.least.chunks(TOGETHER)).enumerate() {
            if !highest.iter().zip(least).any(|(highest, [tip, slope])| (highest - tip) * share > *slope) {
                continue;
            }
            let from = (part * TOGETHER) << self.level;
            self.spread.clear();
            for highest in highest {
                self.spread.resize(self.spread.len() + (1 << self.level), *highest);
            }
            for (slopes, tips) in self.slopes.chunks_exact_mut(self.width).zip(self.tips.chunks_exact(self.width)) {
                steepen(&mut slopes[from..], &tips[from..], &self.spread, share);
            }
        }
    }
}

fn smaller(a: f32, b: f32) -> f32 {
    if b < a { b } else { a }
}
