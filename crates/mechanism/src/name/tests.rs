use super::{appearance, likeness};

#[test]
fn names_of_two_alphabets_look_the_same() {
    assert_eq!(appearance("ВА1"), "BA1");
    assert_ne!("ВА1", "BA1");
    assert_eq!(appearance("шатун"), "шaтyн");
}

#[test]
fn a_name_in_other_letters_is_alike() {
    for (one, other) in [("b", "B"), ("O_1", "o1"), ("С", "c")] {
        assert_eq!(likeness(one), likeness(other));
    }
    assert_ne!(likeness("A1"), likeness("A2"));
}
