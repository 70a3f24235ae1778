//! Parts against reachability.

use super::components;

#[test]
fn parts_are_those_of_reachability_and_in_order() {
    // Dependences of 12 items by a generator of random numbers, sparse to dense.
    let mut seed = 7_u64;
    let mut random = move |most: usize| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(seed >> 33).unwrap() % most
    };
    for trial in 0..300 {
        let mut needs = vec![Vec::new(); 12];
        (0..trial % 40).for_each(|_| needs[random(12)].push(random(12)));
        let mut reaches: Vec<Vec<bool>> =
            needs.iter().map(|of| (0..12).map(|other| of.contains(&other)).collect()).collect();
        for through in 0..12 {
            for from in 0..12 {
                for to in 0..12 {
                    reaches[from][to] |= reaches[from][through] && reaches[through][to];
                }
            }
        }
        // The greatest item first, as far as what it needs allows.
        let found = components(&needs, |part| std::cmp::Reverse(part[part.len() - 1]));
        let mut left: Vec<usize> = (0..12).rev().collect();
        for part in found {
            let ready =
                |item: usize| left.iter().all(|o| !reaches[item][*o] || reaches[*o][item] || *o == item);
            let first = left.iter().copied().find(|item| ready(*item)).unwrap();
            let own = |item: &usize| *item == first || reaches[first][*item] && reaches[*item][first];
            let mut wanted: Vec<usize> = left.iter().copied().filter(own).collect();
            wanted.reverse();
            assert_eq!(part, wanted);
            left.retain(|item| !own(item));
        }
        assert!(left.is_empty());
    }
}

#[test]
fn a_long_chain_takes_no_recursion() {
    let count = 200_000;
    let needs: Vec<Vec<usize>> = (0..count).map(|item| vec![(item + 1) % count]).collect();
    assert_eq!(components(&needs, |_| 0).len(), 1);
}
