//! What the search for relief did, pixel by pixel.

use super::error::Result;
use super::frame::{read_depth, read_halves};
use super::gpu::Gpu;
use super::image::Image;
use super::progress::Progress;
use super::scene::{RenderScene, draw};

/// The searches of a picture, one for each pixel, row by row.
#[derive(Clone, Debug)]
pub struct Searched {
    /// Pixels across and down.
    pub size: [u32; 2],
    /// Nodes and samples that were read.
    pub reads: Vec<f32>,
    /// Whether the search came to its end.
    pub done: Vec<bool>,
    /// Texels of the finest map in a metre.
    pub texels: Vec<f32>,
    /// Metres from the ground along the eye's ray; `None` where nothing is displaced.
    pub distance: Vec<Option<f32>>,
}

/// Draws what the search does instead of what it finds. The scene's shader is within
/// `terrane_shaderlib::hosts::WGPU_TERRAIN_SEARCHED`, its picture of one sample a pixel.
///
/// # Errors
/// As [`render_scene`](super::render_scene).
pub fn search_scene(gpu: &Gpu, scene: &RenderScene<'_>, progress: Progress) -> Result<Searched> {
    // What stands before the ground is no part of the search.
    let targets = draw(gpu, &RenderScene { objects: &[], ..scene.clone() }, progress)?;
    let search = read_halves(gpu, &targets.radiance)?;
    let distance = targets.displaced.map_or(Ok(Vec::new()), |displaced| read_depth(gpu, &displaced))?;
    // Where nothing is displaced there is the sky, or nothing.
    let part = |channel: usize, none: f32| {
        let texels = search.chunks_exact(4).zip(&distance);
        texels.map(move |(texel, distance)| if *distance > 0.0 { texel[channel] } else { none })
    };
    Ok(Searched {
        size: scene.image,
        reads: part(0, 0.0).collect(),
        done: part(1, 1.0).map(|done| done > 0.5).collect(),
        texels: part(2, 0.0).map(f32::exp2).collect(),
        distance: distance.iter().map(|distance| (*distance > 0.0).then_some(distance - 1.0)).collect(),
    })
}

impl Searched {
    /// Texels from what another search found, where both found something.
    #[must_use]
    pub fn errors(&self, truth: &Self) -> Vec<Option<f32>> {
        let pairs = self.distance.iter().zip(&truth.distance).zip(&self.texels);
        pairs
            .map(|((found, there), texels)| found.zip(*there).map(|(found, there)| (found - there).abs() * texels))
            .collect()
    }

    /// What a line of text can say of it: reads, and texels from the truth.
    #[must_use]
    pub fn figures(&self, truth: &Self) -> String {
        let traced = self.distance.iter().zip(&self.reads).filter_map(|(distance, reads)| distance.and(Some(*reads)));
        let mut errors: Vec<f32> = self.errors(truth).into_iter().flatten().collect();
        errors.sort_by(f32::total_cmp);
        let count = errors.len().max(1);
        let mean = traced.sum::<f32>() / count as f32;
        let p99 = errors.get(errors.len() * 99 / 100).copied().unwrap_or_default();
        let largest = errors.last().copied().unwrap_or_default();
        let lost = self.done.iter().filter(|done| !**done).count();
        format!(
            "{count} pixels with relief: {mean:.1} reads, {:.0} at most; texels from the exact hit: p99 {p99:.2e}, at most \
             {largest:.2e}; {lost} given up",
            most(self)
        )
    }
}

fn most(searched: &Searched) -> f32 {
    searched.reads.iter().fold(1.0, |most, reads| most.max(*reads))
}

/// A picture, what was read, and how far that is from the truth, side by side.
#[must_use]
pub fn searched_beside(picture: &Image, searched: &Searched, truth: &Searched) -> Image {
    let (width, height) = (picture.width, picture.height);
    let errors = searched.errors(truth);
    let most = most(searched);
    let mut pixels = Vec::with_capacity(9 * width as usize * height as usize);
    for y in 0..height as usize {
        let row = y * width as usize..(y + 1) * width as usize;
        pixels.extend(&picture.pixels[3 * row.start..3 * row.end]);
        pixels.extend(row.clone().flat_map(|index| heat(searched.reads[index] / most, [0, 1, 2])));
        pixels.extend(row.flat_map(|index| match (searched.done[index], errors[index]) {
            (false, _) => [0, 255, 0],
            (true, error) => heat(error.map_or(0.0, share), [2, 1, 0]),
        }));
    }
    Image { width: 3 * width, height, pixels }
}

/// From 0.001 texels to 100 by the logarithm.
fn share(error: f32) -> f32 {
    (error.max(1e-3).log10() + 3.0) / 5.0
}

/// From black over the first channel and the second to white.
fn heat(share: f32, order: [usize; 3]) -> [u8; 3] {
    let mut color = [0; 3];
    for (step, channel) in order.into_iter().enumerate() {
        color[channel] = ((3.0 * share - step as f32).clamp(0.0, 1.0) * 255.0).round() as u8;
    }
    color
}

#[cfg(test)]
mod tests {
    use super::*;

    fn searched(distance: [Option<f32>; 2]) -> Searched {
        let (reads, done, texels) = (vec![4.0, 8.0], vec![true, false], vec![100.0, 100.0]);
        Searched { size: [2, 1], reads, done, texels, distance: distance.to_vec() }
    }

    #[test]
    fn errors_are_texels_where_both_found_something() {
        let (found, truth) = (searched([Some(0.5), None]), searched([Some(0.25), Some(1.0)]));
        assert_eq!(found.errors(&truth), [Some(25.0), None]);
        assert!(
            found.figures(&truth).contains("8 at most; texels from the exact hit: p99 2.50e1"),
            "{}",
            found.figures(&truth)
        );
    }

    #[test]
    fn the_three_stand_side_by_side() {
        let picture = Image { width: 2, height: 1, pixels: vec![1, 2, 3, 4, 5, 6] };
        let image = searched_beside(&picture, &searched([Some(0.5), None]), &searched([Some(0.5), None]));
        assert_eq!((image.width, image.height), (6, 1));
        assert_eq!(image.pixels[..6], picture.pixels);
        assert_eq!(image.pixels[6..12], [255, 128, 0, 255, 255, 255]);
        // No error is black, what was given up is green.
        assert_eq!(image.pixels[12..], [0, 0, 0, 0, 255, 0]);
    }
}
