//! Scenes as they are written.

use super::Named;
use super::call::call;
use super::object::objects;
use crate::diagnostic::Diagnostic;
use crate::graph::limits;
use crate::graph::model::{Camera, Object, Sun};
use crate::graph::syntax::{Field, Fields};

/// Preetham's turbidity where a scene does not say: clear air.
const TURBIDITY: f32 = 3.0;

/// A scene.
#[derive(Clone, Debug)]
pub(crate) struct SceneFile {
    pub(crate) terrain: Option<Named>,
    pub(crate) image: Option<(u32, u32)>,
    pub(crate) camera: Option<Camera>,
    pub(crate) sun: Option<Sun>,
    pub(crate) turbidity: f32,
    pub(crate) exposure: f32,
    pub(crate) objects: Vec<Object>,
}

/// Reads the fields of a scene.
pub(super) fn read(fields: &mut Fields<'_>, findings: &mut Vec<Diagnostic>) -> SceneFile {
    let terrain = fields.need("terrain", findings);
    let terrain = terrain.and_then(|field| Some(Named::new(&field.text(findings)?, field.raw.span())));
    let image = fields.take("image").map_or(Some((1280, 720)), |field| image(field, findings));
    let camera = fields.need("camera", findings).and_then(|field| camera(field, findings));
    let sun = fields.need("sun", findings).and_then(|field| sun(field, findings));
    let turbidity = fields.take("sky").and_then(|field| sky(field, findings)).unwrap_or(TURBIDITY);
    let exposure = fields.take("exposure").and_then(|field| field.number(-16.0, 16.0, findings)).unwrap_or(0.0);
    let objects = fields.take("objects").map(|field| objects(field, findings)).unwrap_or_default();
    SceneFile { terrain, image, camera, sun, turbidity, exposure, objects }
}

fn image(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<(u32, u32)> {
    let [width, height] = field.tuple(findings)?;
    let width = width.whole(1, limits::IMAGE_SIDE, findings);
    let height = height.whole(1, limits::IMAGE_SIDE, findings);
    width.zip(height)
}

fn camera(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<Camera> {
    let mut fields = Fields::open(field.raw, "`camera`", findings)?;
    let (low, high) = (-1.0e7, 1.0e7);
    let eye = fields.need("eye", findings).and_then(|field| field.numbers::<3>(low, high, findings));
    let target = fields.need("target", findings);
    let place = target.map(|field| field.raw.span());
    let target = target.and_then(|field| field.numbers::<3>(low, high, findings));
    let fov = fields.take("fov").map_or(Some(55.0), |field| field.number(1.0, 170.0, findings));
    fields.close(findings);
    if let (Some(eye), Some(target), Some(place)) = (eye, target, place)
        && eye == target
    {
        let message = "the camera looks at the point where it stands";
        let finding = Diagnostic::error(crate::graph::codes::OUT_OF_RANGE, place, message);
        findings.push(finding.help("`target` is a point in the middle of the picture, away from `eye`"));
        return None;
    }
    Some(Camera { eye: eye?, target: target?, fov: fov? })
}

fn sun(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<Sun> {
    let mut fields = Fields::open(field.raw, "`sun`", findings)?;
    let azimuth = fields.need("azimuth", findings).and_then(|field| field.number(-360.0, 360.0, findings));
    let elevation = fields.need("elevation", findings).and_then(|field| field.number(-90.0, 90.0, findings));
    fields.close(findings);
    Some(Sun { azimuth: azimuth?, elevation: elevation? })
}

fn sky(field: Field<'_>, findings: &mut Vec<Diagnostic>) -> Option<f32> {
    let mut call = call(field, "`clear`", findings)?;
    if call.name.name != "clear" {
        findings.push(field.unknown_choice(&call.name.name, &["clear"]));
        return None;
    }
    let turbidity = call.fields.take("turbidity").map(|field| field.number(1.8, 10.0, findings));
    call.close(findings);
    turbidity.unwrap_or(Some(TURBIDITY))
}
