//! The one condition that ties numbers of a mechanism together.

use assur_number::{ROUNDING, elementary};

use crate::{GROUND, LinkId, Point, Slide};

/// The links without a slide whose pins, two or more, all coincide: such a link turns freely about them, so its angle
/// is not determined.
pub fn links_of_length_zero(links: usize, points: &[Point], slides: &[Slide]) -> Vec<LinkId> {
    let places = || points.iter().flat_map(|point| &point.places);
    let greatest = places().flat_map(|place| place.at).fold(0.0, |most: f64, x| most.max(x.abs()));
    // By link: the place of its first pin, how many pins it has, and whether all are at that place.
    let mut pins = vec![([0.0; 2], 0_usize, true); links];
    for place in points.iter().filter(|point| point.is_pin()).flat_map(|point| &point.places) {
        let (first, count, together) = &mut pins[place.link];
        if *count == 0 {
            *first = place.at;
        }
        *count += 1;
        *together &= elementary::hypot(place.at[0] - first[0], place.at[1] - first[1]) <= ROUNDING * greatest;
    }
    let slides_on = |link: LinkId| slides.iter().any(|slide| slide.link == link || slide.on == link);
    let zero = |link: &LinkId| {
        let (_, count, together) = pins[*link];
        count > 1 && together && !slides_on(*link)
    };
    (GROUND + 1..links).filter(zero).collect()
}
