//! Rivers cut into rising land: the stream power law, solved downstream to upstream in one pass.
//! Source: Braun and Willett, "A very efficient O(n), implicit and parallel method to solve the stream power equation",
//! 2013; the deposits follow Davy and Lague, 2009. Slopes that grow too steep slide.

use super::flow::{Flow, route, run};
use super::land::Land;

/// What rock does against rivers: a number for each cell.
#[derive(Clone, Debug)]
pub struct Rock {
    /// Whether water leaves the land here.
    pub outlet: Vec<bool>,
    /// Metres that rise in a unit of time.
    pub uplift: Vec<f32>,
    /// How easily a river cuts: K of the stream power law.
    pub erodibility: Vec<f32>,
    /// Rise over run of the steepest slope that stands.
    pub stable: Vec<f32>,
}

/// Exponent of the drainage area.
const AREA_EXPONENT: f32 = 0.4;

/// Part of the load that settles.
const SETTLING: f32 = 0.35;

/// One step of time. `load` is the sediment that passed through each cell in the step before, metres of height of the
/// cell; it is replaced.
pub fn cut(land: &mut Land, rock: &Rock, time: f32, seed: u32, load: &mut Vec<f32>) -> Flow {
    let flow = route(land, &rock.outlet, seed);
    load.resize(land.height.len(), 0.0);
    let mut worn = vec![0.0; land.height.len()];
    for &index in &flow.order {
        let index = index as usize;
        let receiver = flow.receiver[index] as usize;
        if receiver == index {
            continue;
        }
        let before = land.height[index];
        let run = run(land, index, receiver);
        let cells = flow.area[index] / (land.cell * land.cell);
        let settled = (SETTLING * load[index] / cells).min(0.5 * time);
        let power = rock.erodibility[index] * time * libm::powf(flow.area[index], AREA_EXPONENT) / run;
        let raised = before + rock.uplift[index] * time + settled;
        let cut = (raised + power * land.height[receiver]) / (1.0 + power);
        let slid = cut.min(land.height[receiver] + rock.stable[index] * run);
        land.height[index] = slid;
        worn[index] = (raised - slid).max(0.0);
    }
    *load = worn;
    for &index in flow.order.iter().rev() {
        let receiver = flow.receiver[index as usize] as usize;
        if receiver != index as usize {
            load[receiver] += load[index as usize];
        }
    }
    flow
}
