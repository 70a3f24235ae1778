//! Strokes, centers and curvature against closed forms, and against differences.

#![expect(clippy::unwrap_used, reason = "a test fails where something is missing")]

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use assur_all as _;
use assur_geometry::{CenterAt, Centers, Curvature, Geometry, centers_of, geometry, instant_centers};
use assur_group::{Body, Order};
use assur_kinematics::Linkage;
use assur_mechanism::{GROUND, Named};
use assur_testkit::specimen::Recipe;

fn compile(scene: &str) -> Linkage {
    let mechanism = assur_scene::read("test.toml", scene).unwrap_or_else(|errors| panic!("{errors}"));
    Linkage::compile(mechanism).unwrap()
}

fn measured(scene: &str) -> Geometry {
    geometry(&compile(scene), GROUND).unwrap()
}

fn near(found: f64, wanted: f64, limit: f64) {
    assert!((found - wanted).abs() <= limit, "{found} instead of {wanted}: {:e} apart", found - wanted);
}

/// Crank 100 mm at O, rocker about C 400 mm below: the rocker turns back where the crank is normal to it.
#[test]
fn quick_return_of_a_shaper() {
    let swing = 0.25_f64.asin();
    for (direction, cw) in [("ccw", false), ("cw", true)] {
        let scene = assur_fixtures::scene("shaper").replace(
            "link = \"crank\"\npositions",
            &format!("link = \"crank\"\ndirection = \"{direction}\"\npositions"),
        );
        let found = measured(&scene);
        let ram = &found.slides["ram/ground"];
        let stroke = ram.stroke.as_ref().unwrap();
        near(stroke.stroke, 2.0 * 0.7 * 0.25, 1e-12);
        near(ram.pf0.unwrap().max, 0.175, 1e-12);
        near(stroke.time_ratio.unwrap(), (PI + 2.0 * swing) / (PI - 2.0 * swing), 1e-12);
        near(stroke.overlap.unwrap(), 2.0 * swing, 1e-12);
        // The crank is normal to the rocker at -swing and at 180 degrees + swing.
        let dead = if cw { [-swing, -(PI - swing)] } else { [PI + swing, TAU - swing] };
        for (found, wanted) in stroke.dead_points.iter().zip(dead) {
            near(*found, wanted, 1e-12);
        }
        // 60 rpm: a stroke in each part of a second.
        let times = stroke.intervals.unwrap().map(|interval| interval / TAU);
        for (speed, time) in stroke.mean_speeds.unwrap().iter().zip(times) {
            near(*speed, 0.35 / time, 1e-12);
        }
        let rocker = &found.links["rocker"];
        near(rocker.stroke.as_ref().unwrap().stroke, 2.0 * swing, 1e-12);
        assert_eq!(rocker.rests.len(), 2);
        assert_eq!(found.links["crank"].turns, Some(if cw { -1.0 } else { 1.0 }));
        // D moves on an arc: the chord between its dead points.
        near(found.points["D"].stroke.as_ref().unwrap().stroke, 0.35, 1e-12);
        // Rocker vertical, crank towards C or away from it: r/(d - r) and r/(d + r).
        near(rocker.pf1.min, -1.0 / 3.0, 1e-12);
        near(rocker.pf1.max, 0.2, 1e-12);
        near(found.points["D"].pf1.max, 0.7 / 3.0, 1e-12);
    }
}

/// An in-line slider-crank: stroke 2 r, dead points at 0 and 180 degrees, which are samples of any even division.
#[test]
fn slider_crank_in_line() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0, A = 0.05 }\n[link.rod]\npoints = { A = 0, B = 0.2 }\n\
        [link.piston]\npoints = { B = 0 }\n[[slide]]\nlink = 'piston'\non = 'ground'\n[input]\nlink = 'crank'\npositions = 8\n[assembly]\nB = [0.25, 0]";
    let found = measured(scene);
    let slide = &found.slides["piston/ground"];
    let stroke = slide.stroke.as_ref().unwrap();
    near(stroke.stroke, 0.1, 1e-14);
    near(stroke.time_ratio.unwrap(), 1.0, 1e-12);
    near(stroke.dead_points[0], 0.0, 1e-12);
    near(stroke.dead_points[1], PI, 1e-12);
    assert_eq!(stroke.mean_speeds, None);
    // PF2 at the dead points: -r (1 + r/l) and r (1 - r/l); the greatest PF2 of a short rod lies elsewhere.
    near(slide.pf2.min, -0.05 * 1.25, 1e-13);
    near(slide.pf2.at_min.min(TAU - slide.pf2.at_min), 0.0, 1e-5);
    // The pressure angle is greatest where the crank is normal to the guide.
    let angles = &found.groups[0];
    near(angles.extremes.max, 0.25_f64.asin(), 1e-12);
    near(angles.extremes.min, 0.0, 1e-7);
    let piston = &found.links["piston"];
    assert!(piston.rests_always == Some(false) && piston.stroke.is_none());
    assert_eq!(piston.rests.len(), 2);
}

/// Rod of 300 mm with its ends on two guides at a right angle: Cardan's circles.
#[test]
fn elliptic_trammel_rolls_a_circle_in_one_of_twice_its_size() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.a]\npoints = { A = 0 }\n[link.rod]\npoints = { A = 0, B = 0.3, E = [0.1, 0.05] }\n\
        [link.b]\npoints = { B = 0 }\n[[slide]]\nlink = 'a'\non = 'ground'\n[[slide]]\nlink = 'b'\non = 'ground'\nangle = '90 deg'\n\
        [input]\nlink = 'a'\nfrom = -0.28\nto = 0.28\npositions = 29\n[assembly]\nB = [0, 0.1]";
    let linkage = compile(scene);
    let found = geometry(&linkage, GROUND).unwrap();
    for at in &found.positions {
        let centers = &at.links["rod"];
        let CenterAt::Point([x, y]) = centers.center else { panic!() };
        near(x.hypot(y), 0.3, 1e-12);
        let [u, v] = centers.on_link.unwrap();
        near((u - 0.15).hypot(v), 0.15, 1e-12);
        // All points of the inflection circle move straight through O: its diameter is PO.
        let pole = centers.inflection_pole.unwrap();
        near(pole[0].hypot(pole[1]), 0.0, 1e-12);
    }
    // Seen from the rod, the ground rolls: the two centrodes change their parts.
    let rod = linkage.mechanism.link("rod").unwrap();
    let turned = geometry(&linkage, rod).unwrap();
    assert_eq!(turned.against, "rod");
    assert!(turned.positions[3].links.iter().all(|(name, _)| *name != "rod"));
}

fn solved(linkage: &Linkage, q: f64) -> assur_kinematics::Position {
    let mut position = linkage.position();
    linkage.solve(q, Order::Second, &mut position).unwrap();
    position
}

/// The point J on the ray from the center P through a point A, whose path has the center of curvature C: PA² = AC AJ.
fn euler_savary(pole: [f64; 2], point: [f64; 2], center: [f64; 2]) -> [f64; 2] {
    let minus = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
    let [pa, ca] = [minus(point, pole), minus(point, center)];
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    // Along the unit vector from P to A: AJ = PA² / CA with signs.
    let along = dot(pa, pa) / dot(ca, pa);
    [0, 1].map(|i| point[i] - along * pa[i])
}

#[test]
fn inflection_circle_and_curvature_of_a_coupler_point() {
    let linkage = compile(assur_fixtures::scene("four-bar"));
    let coupler = linkage.mechanism.link("coupler").unwrap();
    let place =
        |name: &str, link: usize| linkage.mechanism.place_in(linkage.mechanism.point(name).unwrap(), link);
    let [o, c] = ["O", "C"].map(|name| place(name, GROUND).unwrap());
    let k = place("K", coupler).unwrap();
    let scale = linkage.structure.scale;
    for i in 0..36 {
        let q = 0.1 + f64::from(i) * TAU / 36.0;
        let position = solved(&linkage, q);
        let body = &position.bodies[coupler];
        let centers = centers_of(body, &Body::ground(), scale);
        let CenterAt::Point(pole) = centers.center else { panic!() };
        let inflection = centers.inflection_pole.unwrap();
        // The pins A and B of the coupler move on circles about O and C.
        for (name, center) in [("A", o), ("B", c)] {
            let point = body.point(place(name, coupler).unwrap());
            let on_circle = euler_savary(pole, point, center);
            // Thales: the circle with the diameter from the pole to the inflection pole.
            let [to_pole, to_end] = [pole, inflection].map(|end| [0, 1].map(|i| end[i] - on_circle[i]));
            let product: f64 = to_pole[0] * to_end[0] + to_pole[1] * to_end[1];
            let size = to_pole[0].hypot(to_pole[1]) * to_end[0].hypot(to_end[1]);
            assert!(
                product.abs() <= 1e-9 * size.max(scale * scale),
                "{name} at {q}: {product:e} of {size:e}"
            );
        }
        // Curvature of K by differences of its path.
        let motion = linkage.point_motion(linkage.mechanism.point("K").unwrap(), &position);
        let curvature = Curvature::of(&motion, 1e-3).unwrap();
        let h = 1e-4;
        let [before, here, after] = [q - h, q, q + h].map(|q| solved(&linkage, q).bodies[coupler].point(k));
        let d1 = [0, 1].map(|i| (after[i] - before[i]) / (2.0 * h));
        let d2 = [0, 1].map(|i| (after[i] - 2.0 * here[i] + before[i]) / (h * h));
        let wanted = (d1[0] * d2[1] - d1[1] * d2[0]) / d1[0].hypot(d1[1]).powi(3);
        near(curvature.curvature, wanted, 1e-4 * wanted.abs().max(1.0));
        // Euler-Savary from its center of curvature leads to the inflection circle as well.
        if let Some(center) = curvature.center {
            let on_circle = euler_savary(pole, motion.pf0, center);
            let middle = [0, 1].map(|i| 0.5 * (pole[i] + inflection[i]));
            let radius = 0.5 * (pole[0] - inflection[0]).hypot(pole[1] - inflection[1]);
            let found = (on_circle[0] - middle[0]).hypot(on_circle[1] - middle[1]);
            near(found / radius, 1.0, 1e-7);
        }
        // No acceleration at its pole.
        let pole = centers.acceleration_pole.unwrap();
        let rest = body.second([pole[0] - body.x, pole[1] - body.y]);
        near(rest[0].hypot(rest[1]), 0.0, 1e-12);
    }
}

/// Relative motion: derivatives of the pose in the frame of the other link, by differences.
#[test]
fn relative_motion_agrees_with_differences() {
    let linkage = compile(assur_fixtures::scene("four-bar"));
    let [coupler, rocker] = ["coupler", "rocker"].map(|name| linkage.mechanism.link(name).unwrap());
    let place = linkage.mechanism.place_in(linkage.mechanism.point("B").unwrap(), coupler).unwrap();
    let at = solved(&linkage, 0.7);
    // The pin that joins two links is their relative center.
    let centers = centers_of(&at.bodies[coupler], &at.bodies[rocker], linkage.structure.scale);
    for (found, wanted) in centers.on_link.unwrap().iter().zip(place) {
        near(*found, wanted, 1e-12);
    }
    // The coupler turns about the pin, so every point's relative path is a circle about it: the inflection circle shrinks
    // to the pin.
    let CenterAt::Point(center) = centers.center else { panic!() };
    for (found, wanted) in centers.inflection_pole.unwrap().iter().zip(center) {
        near(*found, wanted, 1e-12);
    }
    // Crank against rocker share no pin; their center lies on the line of the pins A, B (Kennedy).
    let crank = linkage.mechanism.link("crank").unwrap();
    let found = centers_of(&at.bodies[crank], &at.bodies[rocker], linkage.structure.scale);
    let CenterAt::Point(center) = found.center else { panic!() };
    let center = at.bodies[rocker].point(center);
    let [a, b] = ["A", "B"].map(|name| {
        let point = linkage.mechanism.point(name).unwrap();
        linkage.point_motion(point, &at).pf0
    });
    let apart = (b[0] - a[0]) * (center[1] - a[1]) - (b[1] - a[1]) * (center[0] - a[0]);
    near(apart, 0.0, 1e-12);
}

/// The transmission angle of a crank-rocker is extreme where the crank lies along the frame.
#[test]
fn transmission_angle_of_a_crank_rocker() {
    let scene = "[ground]\npoints = { O = 0, C = 0.32 }\n[link.crank]\npoints = { O = 0, A = 0.09 }\n[link.coupler]\npoints = { A = 0, B = 0.28 }\n\
        [link.rocker]\npoints = { C = 0, B = 0.21 }\n[input]\nlink = 'crank'\npositions = 10\n[assembly]\nB = [0.3, 0.18]";
    let found = measured(scene);
    let angle = &found.groups[0];
    assert_eq!(angle.what.to_string(), "transmission angle between the links");
    let between = |d: f64| ((0.28_f64.powi(2) + 0.21_f64.powi(2) - d * d) / (2.0 * 0.28 * 0.21)).acos();
    let [least, greatest] = [between(0.32 - 0.09), between(0.32 + 0.09)];
    let acute = [least, greatest].map(|angle: f64| angle.min(PI - angle));
    near(angle.extremes.min, acute[0].min(acute[1]), 1e-12);
    near(angle.extremes.max, FRAC_PI_2, 1e-7);
    // Half a grid step never hides the extreme: it lies at a position of the crank along the frame.
    let at = angle.extremes.at_min;
    near(at.min((at - PI).abs()).min(TAU - at), 0.0, 1e-6);
}

/// The links that form a rigid part with one of a scene.
fn rigid_with(linkage: &Linkage, link: &str) -> Vec<Named<usize>> {
    let found = geometry(linkage, linkage.mechanism.link(link).unwrap()).unwrap();
    for name in &found.rigid {
        for at in &found.positions {
            let Centers { center, on_link, inflection_pole, acceleration_pole } = at.links[name];
            assert_eq!((center, on_link), (CenterAt::Everywhere, None));
            assert_eq!((inflection_pole, acceleration_pole), (None, None));
        }
    }
    found.rigid
}

/// A dyad whose outer pins are both on the rod, one of them on the crank as well, can't move against the rod.
#[test]
fn a_dyad_on_one_link_is_rigid_with_it() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.crank]\npoints = { O = 0, A = 0.1 }\n\
        [link.rod]\npoints = { A = 0, B = 0.4, G = [0.2, 0.05] }\n[link.piston]\npoints = { B = 0 }\n\
        [link.one]\npoints = { A = 0, H = 0.15 }\n[link.two]\npoints = { H = 0, G = 0.14 }\n\
        [link.third]\npoints = { H = 0, K = 0.1 }\n[link.fourth]\npoints = { K = 0, B = 0.25 }\n\
        [[slide]]\nlink = 'piston'\non = 'ground'\nthrough = [0, 0.03]\n[input]\nlink = 'crank'\npositions = 24\n\
        [assembly]\nB = [0.5, 0.03]\nH = [0.2, 0.15]\nK = [0.3, 0.15]";
    let linkage = compile(scene);
    assert_eq!(rigid_with(&linkage, "rod"), ["one", "two", "third", "fourth"]);
    assert_eq!(rigid_with(&linkage, "third"), ["rod", "one", "two", "fourth"]);
    for link in ["ground", "crank", "piston"] {
        assert_eq!(rigid_with(&linkage, link), [""; 0], "{link}");
    }
    let position = solved(&linkage, 0.7);
    let everywhere = instant_centers(&linkage, &position).into_iter();
    let everywhere = everywhere.filter(|center| center.at == CenterAt::Everywhere);
    // Ten pairs of five links; crank and rod share a point with them, no more.
    assert_eq!(everywhere.count(), 10);
}

/// Two stones on parallel guides and the rod between them translate alike, because of their dimensions alone.
#[test]
fn links_that_move_alike_are_rigid_with_each_other() {
    let scene = "[ground]\npoints = { O = 0 }\n[link.one]\npoints = { A = 0 }\n[link.rod]\npoints = { A = 0, B = 0.3 }\n\
        [link.other]\npoints = { B = 0 }\n[[slide]]\nlink = 'one'\non = 'ground'\nangle = 0.3\n\
        [[slide]]\nlink = 'other'\non = 'ground'\nthrough = [0, 0.2]\nangle = 0.3\n\
        [input]\nlink = 'one'\nfrom = 0\nto = 0.5\npositions = 11\n[assembly]\nB = [0.2, 0.26]";
    let linkage = compile(scene);
    assert_eq!(rigid_with(&linkage, "one"), ["rod", "other"]);
    assert_eq!(rigid_with(&linkage, "ground"), [""; 0]);
    // A guide that is turned by a millionth is no such dimension.
    let linkage = compile(&scene.replacen("angle = 0.3", "angle = 0.300001", 1));
    assert_eq!(rigid_with(&linkage, "one"), [""; 0]);
}

/// Links form a rigid part where their relative pose does not change, and nowhere else.
#[test]
fn rigid_parts_of_random_mechanisms() {
    let (mut rigid, mut moving) = (0, 0);
    for seed in 0..20 {
        let Some(specimen) = Recipe { loads: false, ..Recipe::of(3) }.specimen(seed) else { continue };
        let linkage = Linkage::compile(specimen.mechanism).unwrap();
        let input = &linkage.mechanism.input;
        let all: Vec<_> = (0..input.positions).map(|i| solved(&linkage, input.coordinate(i))).collect();
        for against in 0..linkage.mechanism.links.len() {
            let Ok(found) = geometry(&linkage, against) else { continue };
            for (link, data) in linkage.mechanism.links.iter().enumerate().skip(1) {
                // The place of a body in the frame of the other one: its arm and its angle.
                let place = |at: &assur_kinematics::Position| {
                    let [one, two] = [&at.bodies[link], &at.bodies[against]];
                    let [x, y] = [one.x - two.x, one.y - two.y];
                    let back = |x: f64, y: f64| [x * two.c + y * two.s, y * two.c - x * two.s];
                    let ([x, y], [c, s]) = (back(x, y), back(one.c, one.s));
                    [x / linkage.structure.scale, y / linkage.structure.scale, c, s]
                };
                let first = place(&all[0]);
                let apart = |at| place(at).iter().zip(first).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                let most = all.iter().map(apart).fold(0.0, f64::max);
                let still = most < 1e-9;
                assert!(still || most > 1e-6, "seed {seed}: {most:e} decides nothing");
                let is_rigid = found.rigid.iter().any(|name| data.name == name.as_str()) || link == against;
                assert_eq!(is_rigid, still, "seed {seed}: {} against {}, {most:e}", data.name, found.against);
                *(if still { &mut rigid } else { &mut moving }) += usize::from(link != against);
            }
        }
    }
    assert!(rigid > 4 && moving > 100, "{rigid} {moving}");
}

#[test]
fn every_shipped_scene_is_measured_and_serializes() {
    for (name, scene) in assur_fixtures::SCENES {
        let linkage = compile(scene);
        match geometry(&linkage, GROUND) {
            Ok(found) => {
                assert_eq!(found.positions.len(), linkage.mechanism.input.positions, "{name}");
                let text = serde_json::to_string(&found).unwrap();
                assert!(!text.contains("null"), "{name}");
                // No sampled position has a value beyond the extremes.
                for at in &found.positions {
                    for (angle, (group, all)) in at.angles.iter().zip(&found.groups) {
                        let e = &all.extremes;
                        assert!(*angle >= e.min - 1e-9 && *angle <= e.max + 1e-9, "{name} {group}");
                    }
                }
            }
            Err(error) => panic!("{name}: {error}"),
        }
    }
}
