//! Integrals between known places, by the rules of Gauss and Kronrod (QUADPACK, qk15) over panels that are halved until the two
//! rules agree.

/// Places of a panel at which an integrand is asked for.
pub const PLACES: usize = 15;

/// How many times a panel is halved at most: the rest lies beside a jump at a place that is not known.
const HALVINGS: u32 = 36;

/// Integrals, and how sure they are.
#[derive(Debug, Clone, PartialEq)]
pub struct Integrals {
    /// The integral of each value.
    pub values: Vec<f64>,
    /// By how much any of them may be off: the sum of what the two rules differ by.
    pub error: f64,
}

/// Integrates several values at once over panels, in each of which they should be smooth: a corner or a jump inside a panel costs
/// halvings, and is found only if the rules see it. `integrand` gives the values at the places of a panel; `None` ends it all.
/// The rules differ by no more than `accuracy` times the greatest integral over a panel, unless that takes more than `most` halvings.
pub fn integrals<V: AsRef<[f64]>>(
    panels: impl IntoIterator<Item = [f64; 2]>,
    accuracy: f64,
    most: usize,
    mut integrand: impl FnMut(&[f64; PLACES]) -> Option<Vec<V>>,
) -> Option<Integrals> {
    let mut left = Vec::new();
    for ends in panels {
        left.push((ends, panel(ends, &mut integrand)?, 0));
    }
    let greatest = left.iter().flat_map(|(_, panel, _)| &panel.values).map(|value| value.abs());
    let accuracy = accuracy * greatest.fold(0.0, f64::max);
    let count = left.first().map_or(0, |(_, panel, _)| panel.values.len());
    let (mut all, mut halved) = (Integrals { values: vec![0.0; count], error: 0.0 }, 0);
    while let Some((ends, panel_sums, depth)) = left.pop() {
        if panel_sums.error <= accuracy || depth >= HALVINGS || halved >= most {
            all.values.iter_mut().zip(&panel_sums.values).for_each(|(sum, value)| *sum += value);
            all.error += panel_sums.error;
            continue;
        }
        halved += 1;
        let middle = f64::midpoint(ends[0], ends[1]);
        for half in [[ends[0], middle], [middle, ends[1]]] {
            left.push((half, panel(half, &mut integrand)?, depth + 1));
        }
    }
    Some(all)
}

/// The panels between places: each part between two of `parts` + 1 even steps and the places themselves. What is narrower than
/// `least` is left out.
pub fn panels([from, to]: [f64; 2], parts: u32, known: &[f64], least: f64) -> Vec<[f64; 2]> {
    let [low, high] = [from.min(to), from.max(to)];
    let even = (1..parts).map(|part| low + (high - low) * f64::from(part) / f64::from(parts));
    let mut inside: Vec<f64> =
        even.chain(known.iter().copied()).filter(|at| *at > low && *at < high).collect();
    inside.sort_by(f64::total_cmp);
    let mut ends = vec![low];
    ends.extend(inside);
    ends.push(high);
    ends.windows(2).map(|two| [two[0], two[1]]).filter(|two| two[1] - two[0] > least).collect()
}

/// The integrals over one panel by the finer rule, and the greatest difference of the two.
fn panel<V: AsRef<[f64]>>(
    [low, high]: [f64; 2],
    integrand: &mut impl FnMut(&[f64; PLACES]) -> Option<Vec<V>>,
) -> Option<Integrals> {
    let (middle, half) = (f64::midpoint(low, high), 0.5 * (high - low));
    let places = std::array::from_fn(|index| {
        let side = if index % 2 == 0 { -1.0 } else { 1.0 };
        middle + side * half * NODES[index / 2].0
    });
    let values = integrand(&places)?;
    let count = values.first()?.as_ref().len();
    let (mut fine, mut coarse) = (vec![0.0; count], vec![0.0; count]);
    for (index, row) in values.iter().enumerate() {
        let (_, kronrod, gauss) = NODES[index / 2];
        for (k, value) in row.as_ref().iter().enumerate() {
            fine[k] += half * kronrod * value;
            coarse[k] += half * gauss * value;
        }
    }
    let error = fine.iter().zip(&coarse).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    Some(Integrals { values: fine, error })
}

/// The integral over equally spaced values, an odd number of them, by the rule of Simpson.
pub fn simpson(step: f64, values: &[f64]) -> f64 {
    let last = values.len() - 1;
    let weight = |index: usize| match index {
        0 => 1.0,
        _ if index == last => 1.0,
        _ if index % 2 == 1 => 4.0,
        _ => 2.0,
    };
    step / 3.0 * values.iter().enumerate().map(|(index, value)| weight(index) * value).sum::<f64>()
}

/// Places of the rule of Kronrod on (0, 1), its weights, and those of Gauss; the last place, the middle, is there once.
const NODES: [(f64, f64, f64); 8] = [
    (0.991_455_371_120_812_6, 0.022_935_322_010_529_224, 0.0),
    (0.949_107_912_342_758_5, 0.063_092_092_629_978_55, 0.129_484_966_168_869_7),
    (0.864_864_423_359_769_1, 0.104_790_010_322_250_18, 0.0),
    (0.741_531_185_599_394_4, 0.140_653_259_715_525_92, 0.279_705_391_489_276_67),
    (0.586_087_235_467_691_1, 0.169_004_726_639_267_9, 0.0),
    (0.405_845_151_377_397_2, 0.190_350_578_064_785_4, 0.381_830_050_505_118_9),
    (0.207_784_955_007_898_47, 0.204_432_940_075_298_9, 0.0),
    (0.0, 0.209_482_141_084_727_82, 0.417_959_183_673_469_4),
];

#[cfg(test)]
mod tests;
