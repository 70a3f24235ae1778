//! Positions of a mechanism with a group of class III: `cargo run -- stephenson2.toml`.

// Linking is what registers plugins: those of assur, and the one of this package.
use assur_all as _;
use own_program as _;

use assur_group::Order;
use assur_kinematics::Linkage;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let file = std::env::args().nth(1).unwrap_or_else(|| "stephenson2.toml".to_owned());
    let mechanism = assur_scene::read(&file, &std::fs::read_to_string(&file)?)?;
    let linkage = Linkage::compile(mechanism)?;
    println!("{}", linkage.structure.formula);
    let mut position = linkage.position();
    for index in 0..linkage.mechanism.input.positions {
        linkage.solve_index(index, Order::Second, &mut position)?;
        println!("q = {:.4}", position.coordinate);
        for (link, body) in linkage.mechanism.links.iter().zip(&position.bodies).skip(1) {
            let angle = body.s.atan2(body.c);
            println!("  {:8} angle {angle:8.4} rad, dphi/dq {:8.4}", link.name, body.w1);
        }
    }
    Ok(())
}
