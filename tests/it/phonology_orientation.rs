//! Directions, and HamNoSys palms as directions: expectations 42 and 43 of facts/phonology.md §9.

use chereme::phonology::roll::Roll;
use chereme::phonology::{Direction, Heading};

fn faces(fingers: Direction, tag: &str, palm: Direction) {
    let roll = Roll::from_tag(tag).expect("a palm symbol");
    let found = roll.palm(fingers.vector());
    assert!((found - palm.vector()).length() < 1e-9, "fingers {fingers}, palm symbol {tag}: {found}, not {palm}");
}

#[test]
fn expectation_42_palm_symbols_are_rolls() {
    faces(Direction::UP, "d", Direction::OUT);
    faces(Direction::UP, "u", Direction::IN);
    faces(Direction::OUT, "d", Direction::DOWN);
    faces(Direction::LEFT, "l", Direction::IN);
    faces(Direction::OUT, "u", Direction::UP);
}

#[test]
fn expectation_43_directions_are_26_distinct_unit_vectors_in_antipodal_pairs() {
    let all: Vec<Direction> = Direction::all().collect();
    assert_eq!(all.len(), 26);
    for (i, a) in all.iter().enumerate() {
        assert!((a.vector().length() - 1.0).abs() < 1e-12);
        assert!(all[i + 1..].iter().all(|b| a != b && a.vector().distance(b.vector()) > 0.1));
        assert!((a.vector() + a.opposite().vector()).length() < 1e-12);
        assert!(all.contains(&a.opposite()));
        assert_eq!(a.to_string().parse(), Ok(*a));
        assert_eq!(Direction::nearest(a.vector()), Some(*a));
    }
}

#[test]
fn every_palm_symbol_has_a_heading_that_leads_back_to_it() {
    for fingers in Direction::all() {
        for roll in Roll::all() {
            let heading = roll.heading(Heading::Toward(fingers));
            let off =
                heading.vector().reject_from_normalized(fingers.vector()).angle_between(roll.palm(fingers.vector()));
            assert!(
                off.to_degrees() < 1.0,
                "fingers {fingers}, palm {}: {heading} is {}° off",
                roll.tag(),
                off.to_degrees()
            );
            assert_eq!(Roll::nearest(fingers.vector(), heading.vector()), roll, "fingers {fingers}");
        }
    }
}

#[test]
fn a_palm_is_always_across_the_fingers() {
    for fingers in Direction::all() {
        for roll in Roll::all() {
            let palm = roll.palm(fingers.vector());
            assert!(palm.dot(fingers.vector()).abs() < 1e-12 && (palm.length() - 1.0).abs() < 1e-12);
        }
    }
}
