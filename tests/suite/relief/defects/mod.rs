//! Defects of the published methods: each shown where it is smallest, beside a method without it.

mod light;
mod linear;
mod parallax_offset;
mod quadtree_displacement;
mod quadtree_relief;
