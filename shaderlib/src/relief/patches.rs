//! One image for the patches of all mips of a map: the four heights of a cell in one texel.

use super::dirty::Region;
use super::mips::Mip;

/// Where the first patch of a mip stands: the mips under the map, each to the right of the one before.
pub(super) fn corner([width, height]: [u32; 2], mip: u32) -> [u32; 2] {
    match mip {
        0 => [0, 0],
        _ => [width - (width >> (mip - 1)), height],
    }
}

/// Columns and rows of the image over a map of so many cells.
pub(super) fn size([width, height]: [u32; 2], has_mips: bool) -> [u32; 2] {
    [width, if has_mips { height + height / 2 } else { height }]
}

/// Writes the patches of some cells of a mip: its texels to the corner, along x in the high half, the row behind in the second word.
/// Behind the last texel is the first again where the mip wraps, else the last once more. `set` puts one into a texel of the image.
pub(super) fn write<T>(
    image: &mut [T],
    columns: u32,
    [left, top]: [u32; 2],
    (mip, wraps): (&Mip, bool),
    cells: &Region,
    set: impl Fn(&mut T, [u32; 2]),
) {
    let [width, height] = mip.size.map(|side| side as usize);
    let [across, down] = cells.clone().map(|range| range.start as usize..range.end as usize);
    let behind = |at: usize, side: usize| if wraps { at % side } else { at.min(side - 1) };
    let pairs = |y: usize| {
        let row = &mip.texels[behind(y, height) * width..][..width];
        across.clone().map(move |x| u32::from(row[x]) | u32::from(row[behind(x + 1, width)]) << 16)
    };
    for y in down {
        let row = &mut image[(top as usize + y) * columns as usize + left as usize..][across.clone()];
        row.iter_mut().zip(pairs(y).zip(pairs(y + 1))).for_each(|(texel, words)| set(texel, words.into()));
    }
}

/// The texels of the mips of a map, read from their patches.
pub(super) fn mips(image: &[[u32; 2]], map: [u32; 2], count: u32) -> Vec<Mip> {
    let of = |mip: u32| {
        let (size, [left, top]) = (map.map(|side| side >> mip), corner(map, mip).map(|at| at as usize));
        let rows = image.chunks_exact(map[0] as usize).skip(top).take(size[1] as usize);
        let texels = rows.flat_map(|row| &row[left..][..size[0] as usize]).map(|patch| patch[0] as u16).collect();
        Mip { size, texels }
    };
    (0..count).map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patches_hold_their_corners_and_mips_lie_apart() {
        let map = [8, 4];
        let mut image = vec![[9; 2]; 8 * 6];
        for mip in (0..=2).rev() {
            let size = map.map(|side| side >> mip);
            let texels: Vec<u16> = (0..size[0] * size[1]).map(|index| (100 * mip + index) as u16).collect();
            let mip = (corner(map, mip), Mip { size, texels });
            write(&mut image, 8, mip.0, (&mip.1, true), &size.map(|side| 0..side), |texel, patch| *texel = patch);
        }
        assert_eq!(size_of_all(map), 8 * 6);
        assert_eq!(image[0], [1 << 16, 8 | 9 << 16]);
        assert_eq!(image[31], [31 | 24 << 16, 7]);
        assert_eq!(image[32], [100 | 101 << 16, 104 | 105 << 16]);
        assert_eq!(image[36], [200 | 201 << 16, 200 | 201 << 16]);
        // What no mip covers.
        assert_eq!(image.iter().filter(|patch| **patch == [9; 2]).count(), 48 - 32 - 8 - 2);
        assert_eq!(mips(&image, map, 3)[1].texels, (100..108).collect::<Vec<u16>>());
    }

    #[test]
    fn a_map_that_ends_goes_on_as_it_ends() {
        let mut image = [[0; 2]; 4];
        let mip = Mip { size: [2, 2], texels: vec![1, 2, 3, 4] };
        write(&mut image, 2, [0, 0], (&mip, false), &[0..2, 0..2], |texel, patch| *texel = patch);
        assert_eq!(image, [[1 | 2 << 16, 3 | 4 << 16], [2 | 2 << 16, 4 | 4 << 16], [3 | 4 << 16; 2], [4 | 4 << 16; 2]]);
    }

    fn size_of_all(map: [u32; 2]) -> u32 {
        let [width, height] = size(map, true);
        width * height
    }
}
