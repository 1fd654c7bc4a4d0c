//! Terrane: the renderer and the measuring.
