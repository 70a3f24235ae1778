//! The points are nets.

use super::fraction;

/// A digital net in base 2: of 2^k successive points, each of 2^k equal boxes contains one, however the two sides are halved.
#[test]
fn successive_points_are_nets() {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "from 0 to the number of parts"
    )]
    let part = |x: f64, parts: usize| (x * parts as f64) as usize;
    for (seed, first) in [(0, 0), (7, 0), (7, 1 << 16), (9, 3 << 16 | 1 << 10)] {
        for (columns, rows) in [(1, 1024), (32, 32), (1024, 1), (4, 256)] {
            let mut boxes = vec![0; 1024];
            for index in first..first + 1024 {
                let [x, y] = [0, 1].map(|dimension| fraction(index, dimension, seed));
                boxes[part(x, columns) + columns * part(y, rows)] += 1;
            }
            assert!(boxes.iter().all(|count| *count == 1), "{seed} {first} {columns}");
        }
    }
}

#[test]
fn seeds_and_parts_of_the_sequence_differ() {
    let points = |seed: u32, first: usize| -> Vec<u64> {
        (first..first + 64).map(|index| fraction(index, 3, seed).to_bits()).collect()
    };
    assert_ne!(points(0, 0), points(1, 0));
    assert_ne!(points(0, 0), points(0, 1 << 16));
    // The mean of n points of a net is 1/2 within 1/n.
    let mean = (0..4096).map(|index| fraction(index, 17, 5)).sum::<f64>() / 4096.0;
    assert!((mean - 0.5).abs() < 1.0 / 4096.0, "{mean}");
}
