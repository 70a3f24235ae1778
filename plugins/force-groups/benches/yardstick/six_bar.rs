//! The six-bar with all its loads and reactions, by hand.

use assur_number::Real;
use assur_testkit::yardstick::{self, SixBar};

/// Crank at the origin, rocker on (0, -0.4) guided by a stone on the crank pin, ram on y = 0.28 moved by a stone on the
/// rocker; masses on all links, a force on the ram, weights.
pub(crate) const SCENE: &str = r#"
gravity = 9.81
[ground]
points = { O = [0, 0], C = [0, -0.4] }
[link.crank]
points = { O = 0, A = 0.1 }
mass = 4
center = "O"
inertia = 0.04
[link.stone]
points = { A = 0 }
mass = 1.5
inertia = 0.002
[link.rocker]
points = { C = 0, S = 0.375 }
mass = 12
center = "S"
inertia = 0.6
[link.stone2]
points = { B = 0 }
mass = 1.2
inertia = 0.0015
[link.ram]
points = { B = 0, K = [0.25, -0.05] }
mass = 30
center = [0.1, 0.02]
inertia = 0.9
[[slide]]
link = "stone"
on = "rocker"
through = "C"
[[slide]]
link = "stone2"
on = "rocker"
through = "C"
[[slide]]
link = "ram"
on = "ground"
through = [0, 0.28]
[[force]]
link = "ram"
at = "K"
angle = 0
value = 1500
[input]
link = "crank"
positions = 12
[motion]
speed = 6
acceleration = 2
[assembly]
B = [0.17, 0.28]
"#;

const SPEED: f64 = 6.0;
const ACCELERATION: f64 = 2.0;
const G: f64 = 9.81;
const CUTTING: f64 = 1500.0;

/// Reactions of the six-bar; each acts on the link named.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Found<T> {
    /// Force on the crank at O.
    pub(crate) on_crank: [T; 2],
    /// Force on the stone at A.
    pub(crate) on_stone: [T; 2],
    /// Force on the rocker at C.
    pub(crate) on_rocker: [T; 2],
    /// Force across the rocker and moment on the stone, on the stone at B.
    pub(crate) guides: [[T; 2]; 2],
    /// Force on the ram at B.
    pub(crate) on_ram: [T; 2],
    /// Force and moment of the ram's guide on the ram.
    pub(crate) of_ground: [T; 2],
    /// Driving moment on the crank.
    pub(crate) drive: T,
}

/// From sine and cosine of the crank's angle, at the speed and the acceleration of the scene.
#[inline(always)]
pub(crate) fn by_hand<T: Real>([s, c]: [T; 2]) -> Found<T> {
    let number = T::from_f64;
    let (x, y) = (number(0.1) * c, number(0.1) * s);
    let height = number(0.68);
    let SixBar { direction: t, turn: [w, e], ram: [_, ram1, ram2], inverse, .. } = yardstick::six_bar([s, c]);
    let [per_along, per_sine] = inverse;
    // Accelerations in time.
    let (speed2, acceleration) = (number(SPEED * SPEED), number(ACCELERATION));
    let turn2 = w * w * speed2;
    let angular = e * speed2 + w * acceleration;
    let ram = ram2 * speed2 + ram1 * acceleration;
    let stone = [-(x * speed2) - y * acceleration, x * acceleration - y * speed2];
    // The ram and its stone: the horizontal forces give the force across the rocker.
    let on_ram_x = ram * number(30.0) - number(CUTTING);
    let stone_x = -(ram * number(1.2));
    let upper = (stone_x - on_ram_x) * per_sine;
    let on_ram_y = upper * t[0] - number(1.2 * G);
    let guide = number(30.0 * G) - on_ram_y;
    let guide_moment = number(0.1 * 30.0 * G) - ram * number(0.02 * 30.0) - number(0.05 * CUTTING);
    let upper_moment = angular * number(0.0015);
    // The rocker about C: the force across it at the lower stone.
    let reach = height * per_sine;
    let centripetal = [-(turn2 * t[0]) - angular * t[1], angular * t[0] - turn2 * t[1]];
    let load_x = -(centripetal[0] * number(12.0 * 0.375));
    let load_y = -(centripetal[1] * number(12.0 * 0.375)) - number(12.0 * G);
    let load_moment = -(angular * number(0.6 + 12.0 * 0.375 * 0.375)) - t[0] * number(12.0 * 0.375 * G);
    let lower_moment = angular * number(0.002);
    let lower = (load_moment - upper * reach - upper_moment - lower_moment) * per_along;
    let on_rocker = [-load_x - (upper + lower) * t[1], (upper + lower) * t[0] - load_y];
    // The stone on the crank pin, and the crank.
    let on_stone =
        [stone[0] * number(1.5) + lower * t[1], stone[1] * number(1.5) + number(1.5 * G) - lower * t[0]];
    let on_crank = [on_stone[0], on_stone[1] + number(4.0 * G)];
    let drive = x * on_stone[1] - y * on_stone[0] + acceleration * number(0.04);
    Found {
        on_crank,
        on_stone,
        on_rocker,
        guides: [[lower, lower_moment], [upper, upper_moment]],
        on_ram: [on_ram_x, on_ram_y],
        of_ground: [guide, guide_moment],
        drive,
    }
}
