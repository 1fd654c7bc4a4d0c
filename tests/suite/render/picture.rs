//! Pictures: depth against rays, the tone curve, the same bytes every time.

use glam::DVec3;
use terrane::render::material::Material;
use terrane::render::{
    Camera, Gpu, HeightField, Image, NEAR, Progress, RenderError, RenderScene, Selection, render_scene,
    render_with_depth,
};

use super::world::{ALPINE, GREY, OUT, gpu, mountains, shader};

fn scene<'a>(field: &'a HeightField, shader: &'a str, material: &'a Material, camera: Camera) -> RenderScene<'a> {
    RenderScene {
        shader,
        material,
        field,
        shadow: true,
        occlusion: 4,
        surroundings: false,
        camera,
        sun: [130.0, 28.0],
        turbidity: 3.0,
        exposure: 0.0,
        objects: &[],
        image: [160, 90],
        supersampling: 1,
        tolerance: 0.0,
    }
}

fn over(field: &HeightField, x: f64, z: f64, up: f64) -> [f64; 3] {
    [x, field.bilinear(x, z) + up, z]
}

/// Height of a point over the bilinear surface.
fn above(field: &HeightField, at: DVec3) -> f64 {
    at.y - field.bilinear(at.x, at.z)
}

/// Every pixel's depth must be a point on the surface with nothing in front of it. The triangles of a cell and its
/// bilinear patch differ by a quarter of the cell's twist at most.
#[test]
fn depth_agrees_with_rays_cast_on_the_cpu() {
    let Ok(gpu) = gpu().map_err(super::super::skip::Skip::report) else { return };
    let field = mountains(256, 8.0);
    let camera = Camera { eye: over(&field, 300.0, 350.0, 40.0), target: [1300.0, 250.0, 1200.0], fov: 60.0 };
    let (text, material) = (shader(&format!("{OUT}{GREY}")), Material::default());
    let scene = scene(&field, &text, &material, camera);
    let rendered = render_with_depth(&gpu, &scene, Progress::Hidden).expect("a sound scene");
    let view = camera.view(160, 90).expect("a good camera");
    let (mut ground, mut sky) = (0, 0);
    for (index, &depth) in rendered.depth.iter().enumerate().step_by(7) {
        let ray = view.ray((index as f64 % 160.0 + 0.5) / 160.0, ((index / 160) as f64 + 0.5) / 90.0);
        let hit = (depth > 0.0).then(|| NEAR / f64::from(depth) / ray.dot(view.forward));
        check_ray(&field, view.eye, ray, hit, index);
        if hit.is_some() { ground += 1 } else { sky += 1 }
    }
    assert!(ground > 500 && sky > 50, "{ground} pixels of ground, {sky} of sky");
}

fn check_ray(field: &HeightField, eye: DVec3, ray: DVec3, hit: Option<f64>, index: usize) {
    let [width, depth] = field.extent();
    let inside = |at: DVec3| at.x > 4.0 && at.z > 4.0 && at.x < width - 4.0 && at.z < depth - 4.0;
    // Twist of an 8 m cell of these mountains, measured: below 6 m.
    let slack = 1.5;
    if let Some(t) = hit {
        let off = above(field, eye + ray * t);
        assert!(off.abs() < slack, "pixel {index}: the depth is {off} m off the surface");
    }
    let end = hit.unwrap_or(4000.0);
    let blocked = (1..2000)
        .map(|i| eye + ray * (end * f64::from(i) / 2000.0))
        .find(|&at| inside(at) && above(field, at) < -slack);
    assert!(blocked.is_none(), "pixel {index}: the surface at {blocked:?} is in front of the depth {hit:?}");
}

#[test]
fn two_renders_give_the_same_bytes() {
    let Ok(gpu) = gpu().map_err(super::super::skip::Skip::report) else { return };
    let field = mountains(128, 16.0);
    let camera = Camera { eye: over(&field, 400.0, 300.0, 60.0), target: [1400.0, 250.0, 1200.0], fov: 60.0 };
    let (text, material) = (shader(&format!("{OUT}{ALPINE}")), Material::default());
    let mut scene = scene(&field, &text, &material, camera);
    scene.supersampling = 2;
    let first = render_scene(&gpu, &scene, Progress::Hidden).expect("a sound scene");
    let threads = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("one thread");
    let second = threads.install(|| render_scene(&gpu, &scene, Progress::Hidden)).expect("a sound scene");
    assert_eq!((first.width, first.height, first.pixels.len()), (160, 90, 160 * 90 * 3));
    assert!(first == second, "the pictures differ");
    assert!(first.pixels.iter().any(|&byte| byte != first.pixels[0]), "the picture is empty");
}

/// A black plane that glows in steps of 1/20 stop from left to right, seen from above.
#[test]
fn brighter_light_gives_a_brighter_pixel() {
    let Ok(gpu) = gpu().map_err(super::super::skip::Skip::report) else { return };
    let field = HeightField::new([64, 64], [1.0, 1.0], vec![0.0; 64 * 64]).expect("finite heights");
    let core = format!(
        "{OUT}
fn terrane_shade(frame: HostFrame) -> TerrainOut {{
    let stops = floor(frame.terrain_uv.uv.x * 400.0) / 20.0 - 12.0;
    return TerrainOut(vec3f(0.0), vec3f(0.0, 0.0, 1.0), 1.0, 0.0, 0.0, vec3f(exp2(stops)));
}}
"
    );
    let camera = Camera { eye: [32.0, 20.0, 32.01], target: [32.0, 0.0, 31.9], fov: 60.0 };
    let (text, material) = (shader(&core), Material::default());
    let mut scene = scene(&field, &text, &material, camera);
    (scene.shadow, scene.occlusion) = (false, 0);
    let image = render_scene(&gpu, &scene, Progress::Hidden).expect("a sound scene");
    // The mean of many rows: dithering adds half a step to single pixels.
    let column = |x: u32| -> f64 {
        (30..60).map(|y| f64::from(image.pixels[((y * 160 + x) * 3 + 1) as usize])).sum::<f64>() / 30.0
    };
    for x in 1..160 {
        assert!(column(x) >= column(x - 1) - 0.35, "column {x}: {} after {}", column(x), column(x - 1));
    }
    assert!(column(0) < 30.0 && column(159) > 235.0, "{} to {}", column(0), column(159));
}

#[test]
fn shadows_fall_away_from_the_sun() {
    let Ok(gpu) = gpu().map_err(super::super::skip::Skip::report) else { return };
    // A wall from north to south in the middle; the sun in the east.
    let heights = (0..128 * 128).map(|i| if i % 128 == 64 { 20.0 } else { 0.0 }).collect();
    let field = HeightField::new([128, 128], [1.0, 1.0], heights).expect("finite heights");
    let camera = Camera { eye: [64.0, 90.0, 64.01], target: [64.0, 0.0, 64.01], fov: 60.0 };
    let (text, material) = (shader(&format!("{OUT}{GREY}")), Material::default());
    let mut scene = scene(&field, &text, &material, camera);
    scene.sun = [90.0, 30.0];
    let image = render_scene(&gpu, &scene, Progress::Hidden).expect("a sound scene");
    let pixel = |x: u32| f64::from(image.pixels[((45 * 160 + x) * 3 + 1) as usize]);
    let (west, east) = (pixel(80 - 12), pixel(80 + 12));
    assert!(west < 0.7 * east && west > 5.0, "{west} in the west, {east} in the east");
}

#[test]
fn a_png_comes_back_as_it_went() {
    let folder = tempfile::tempdir().expect("a writable temporary folder");
    let path = folder.path().join("picture.png");
    let image = Image { width: 3, height: 2, pixels: (0..18).map(|i| i * 13).collect() };
    image.write_png(&path).expect("a writable folder");
    let mut reader = png::Decoder::new(std::io::BufReader::new(std::fs::File::open(&path).expect("just written")))
        .read_info()
        .expect("a PNG");
    let mut pixels = vec![0; 18];
    let frame = reader.next_frame(&mut pixels).expect("a whole PNG");
    assert_eq!((frame.width, frame.height, frame.color_type), (3, 2, png::ColorType::Rgb));
    assert_eq!(pixels, image.pixels);
    assert_eq!(std::fs::read_dir(folder.path()).expect("it exists").count(), 1, "a temporary file is left");
    let new = folder.path().join("a/new/folder.png");
    image.write_png(&new).expect("folders are made");
    assert_eq!(std::fs::read(new).expect("just written"), std::fs::read(path).expect("written before"));
}

#[test]
fn a_broken_shader_is_an_error() {
    let Ok(gpu) = gpu().map_err(super::super::skip::Skip::report) else { return };
    let field = mountains(64, 16.0);
    let camera = Camera { eye: [10.0, 2000.0, 10.0], target: [500.0, 100.0, 500.0], fov: 60.0 };
    let (text, material) = (shader(OUT), Material::default());
    let error =
        render_scene(&gpu, &scene(&field, &text, &material, camera), Progress::Hidden).expect_err("no function");
    assert!(matches!(&error, RenderError::Refused { .. }), "{error}");
    assert!(error.to_string().contains("terrane_shade"), "{error}");
}

#[test]
fn scenes_that_make_no_picture_are_errors() {
    let Ok(gpu) = gpu().map_err(super::super::skip::Skip::report) else { return };
    let field = mountains(64, 16.0);
    let camera = Camera { eye: [10.0, 2000.0, 10.0], target: [500.0, 100.0, 500.0], fov: 60.0 };
    let (text, material) = (shader(&format!("{OUT}{GREY}")), Material::default());
    let good = scene(&field, &text, &material, camera);
    let refused = |scene: RenderScene<'_>, words: &str| {
        let error = render_scene(&gpu, &scene, Progress::Hidden).expect_err(words);
        assert!(error.to_string().contains(words), "{error}");
    };
    refused(RenderScene { image: [0, 90], ..good.clone() }, "0 x 90");
    refused(RenderScene { image: [9000, 90], ..good.clone() }, "9000 x 90");
    refused(RenderScene { sun: [0.0, -5.0], ..good.clone() }, "-5 degrees");
    refused(RenderScene { camera: Camera { fov: 0.0, ..camera }, ..good.clone() }, "field of view");
    refused(RenderScene { camera: Camera { target: camera.eye, ..camera }, ..good.clone() }, "must not be the eye");
    let buried = Camera { eye: over(&field, 500.0, 500.0, -10.0), ..camera };
    refused(RenderScene { camera: buried, ..good.clone() }, "under the ground");
}

#[test]
fn an_unknown_adapter_is_named_with_those_that_exist() {
    if gpu().map_err(super::super::skip::Skip::report).is_err() {
        return;
    }
    let error = Gpu::new(&Selection::parse("Voodoo 2")).expect_err("no such adapter");
    let text = error.to_string();
    assert!(text.starts_with("no adapter called `Voodoo 2`; there is 0: "), "{text}");
    let error = Gpu::new(&Selection::parse("99")).expect_err("no such adapter");
    assert!(error.to_string().contains("`99`"), "{error}");
    let name = Gpu::list().remove(0);
    assert_eq!(Gpu::new(&Selection::parse(&name)).expect("the first adapter").name(), name);
}
