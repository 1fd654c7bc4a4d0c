//! Where the command line writes: folders are made, and what cannot be written is said before anybody waits.

use std::fs;

use terrane::render::Gpu;

use crate::scratch::Scratch;
use crate::skip::Skip;

const SURFACE: &str = "graphs/surfaces/sand.ron";

#[test]
fn render_makes_the_folder_of_its_picture() {
    if Gpu::list().is_empty() {
        return Skip("no adapter".into()).report();
    }
    let scratch = Scratch::of("examples/build_script");
    scratch.terrane(&["render", SURFACE, "-o", "new/folder/sand.png", "--size", "16x9", "--samples", "1"]);
    assert!(scratch.path("new/folder/sand.png").is_file());
}

#[test]
fn a_picture_that_cannot_be_written_is_refused_before_anything_is_made() {
    let scratch = Scratch::of("examples/build_script");
    fs::write(scratch.path("taken"), "old").unwrap();
    fs::create_dir(scratch.path("folder.png")).unwrap();
    for (output, why) in [("taken/sand.png", "taken is no folder"), ("folder.png", "it is there and no file")] {
        let run = scratch.run(&["render", SURFACE, "-o", output]);
        let said = String::from_utf8(run.stderr).unwrap();
        assert_eq!(said, format!("error: cannot write {output}: {why}\n"));
        assert_eq!(run.status.code(), Some(3));
    }
    assert!(!scratch.path("textures").exists(), "textures were made for a picture that nobody gets");
    assert_eq!(fs::read_to_string(scratch.path("taken")).unwrap(), "old");
}
