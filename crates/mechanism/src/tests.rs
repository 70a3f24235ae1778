use crate::{LawTable, Shape, passage};

/// Passages are the times at which a uniformly accelerated motion is at the coordinate with the speed of its direction.
#[test]
fn a_passage_is_on_the_motion() {
    for speed in [-3.0, -0.5, 0.0, 0.7, 4.0_f64] {
        for acceleration in [-2.0, 0.0, 1.5] {
            for way in [-9.0, -1.0, -0.1, 0.2, 2.0, 7.0] {
                match passage(way, speed, acceleration) {
                    Some(time) => {
                        let moved: f64 = speed * time + 0.5 * acceleration * time * time;
                        assert!((moved - way).abs() < 1e-12, "{speed} {acceleration} {way}: {time}");
                        let leads = if speed == 0.0 { acceleration } else { speed };
                        assert!((speed + acceleration * time) * leads >= 0.0);
                    }
                    // Never: the motion turns back before, or there is none.
                    None => assert!(speed * speed + 2.0 * acceleration * way <= 0.0),
                }
            }
        }
    }
    assert_eq!(passage(0.0, 0.0, 0.0), Some(0.0));
    assert_eq!(passage(3.0, 2.0, 0.0), Some(1.5));
}

#[test]
fn a_mirrored_table_is_the_function_of_the_opposite_argument() {
    let rows = vec![[-1.0, 4.0], [0.5, 1.0], [0.5, 7.0], [3.0, -2.0]];
    for shape in [Shape::Linear, Shape::Step] {
        let table = LawTable { rows: rows.clone(), shape };
        for i in -40..40 {
            let x = 0.1 * f64::from(i) + 0.013;
            assert!((table.mirrored().at(-x) - table.at(x)).abs() < 1e-12, "{shape:?} {x}");
            assert!((table.mirrored().mirrored().at(x) - table.at(x)).abs() < 1e-12, "{shape:?} {x}");
        }
    }
}
