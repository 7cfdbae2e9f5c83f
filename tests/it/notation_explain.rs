//! Signs in plain words, in English and French.

use crate::signing::{sign, signs_of};
use crate::strategies::{self, Words};
use chereme::notation::{Tongue, explain_in};
use chereme::phonology::operator::Operator;
use chereme::phonology::recombination::{Base, Recombination};
use chereme::phonology::{Configuration, Keys, LocationInventory, Sign};
use proptest::prelude::*;

fn french(sign: &Sign) -> String {
    explain_in(sign, None, Tongue::French(&LocationInventory::builtin()))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]
    #[test]
    fn every_sign_is_explained(sign in strategies::sign(Words::any())) {
        let names = LocationInventory::builtin();
        let english = explain_in(&sign, None, Tongue::English);
        let french = explain_in(&sign, None, Tongue::French(&names));
        for said in [&english, &french] {
            prop_assert!(said.starts_with(&sign.name));
            prop_assert!(said.lines().count() >= 5, "{said}");
        }
        // The same tiers in both.
        let tiers = |said: &str, of: [&str; 2]| of.map(|of| said.matches(of).count());
        let counted = tiers(&english, ["  strong hand ", "  weak hand "]);
        prop_assert_eq!(counted, tiers(&french, ["  la main dominante, ", "  la main dominée, "]));
    }
}

#[test]
fn the_bowl_in_french() {
    let bowl = sign(
        "sign BOL\n meaning en \"bowl\", fr \"bol\"\n hands both mirrored\n configuration round-B, thumb out\n \
         placement chest, 24cm away\n orientation fingers out-left, palm up then fingers out, palm up-left\n \
         contact strong pinky-side touches weak pinky-side at start\n movement arc up-right 15cm bulging down-right\n",
    );
    let said = french(&bowl);
    let expected = "\
BOL, un signe de la langue lsf : « bowl » (en), « bol » (fr)
  Les deux mains, une main plate, le pouce écarté, arrondi, doigts vers l'avant et la gauche, paume vers le haut, \
                    à 24 cm de la poitrine, mouvement : arc de 15 cm vers le haut et la droite, bombé vers le bas et la droite.
  les mains : les deux, la main dominée en miroir de la main dominante (selon le texte)
  postures et mouvements : 2 postures, 1 mouvement entre elles (d'après le nombre de valeurs)
  la main dominante, configuration : round-B, le pouce écarté (selon le texte)
  la main dominante, emplacement : à 24 cm de la poitrine (selon le texte)
  la main dominante, orientation : doigts vers l'avant et la gauche, paume vers le haut, puis doigts vers l'avant, \
                    paume vers le haut et la gauche (selon le texte)
  la main dominante, mouvement : arc de 15 cm vers le haut et la droite, bombé vers le bas et la droite (selon le texte)
  la main dominée, configuration : en miroir de la main dominante (par symétrie)
  la main dominée, emplacement : en miroir de la main dominante (par symétrie)
  la main dominée, orientation : en miroir de la main dominante (par symétrie)
  la main dominée, mouvement : en miroir de la main dominante (par symétrie)
  le contact : le bord de l'auriculaire de la main dominante touche le bord de l'auriculaire de la main dominée (selon le texte)
  la durée : d'après la longueur et le genre des mouvements (par défaut)
";
    assert_eq!(said, expected, "\n{said}");
}

/// The first line under the name is the whole phase in a sentence: hand shape, directions, place, the first movements.
#[test]
fn a_phase_in_a_sentence() {
    let line = |text: &str, number: usize| {
        chereme::notation::explain(&sign(text)).lines().nth(number).unwrap_or_default().trim().to_owned()
    };
    assert_eq!(
        line(
            "sign X\n configuration 1-along, thumb across\n orientation fingers up, palm out\n placement chin, touch\n",
            1
        ),
        "The dominant hand, one finger stretched with the thumb across, fingers pointing up, palm facing forward, touching the \
         chin, without movement."
    );
    let said = line("sign X\n configuration S\n movement up then down then up then down\n", 1);
    assert!(said.ends_with("… (+ 1)."), "{said}");
    let each = line("sign X\n hands both\n strong configuration flat\n weak configuration S\n", 1);
    assert!(each.starts_with("The dominant hand, a flat hand") && each.contains("; the other hand, a fist"), "{each}");
}

#[test]
fn french_articles_contract() {
    let line = |tier: &str, word: &str| {
        let said = french(&sign(&format!("sign X\n {tier}\n")));
        let line = said.lines().skip(2).find(|l| l.contains(word)).unwrap_or_else(|| panic!("{said}"));
        let said = line.split_once(" : ").map_or(line, |(_, said)| said);
        said.trim_end_matches(" (selon le texte)").to_owned()
    };
    let placed = |placement: &str| line(&format!("placement {placement}"), "emplacement");
    assert_eq!(placed("forehead"), "au front");
    assert_eq!(placed("eyes, close"), "à proximité des yeux");
    assert_eq!(
        placed("cheek right, touch, with index middle tip"),
        "au contact de la joue, du côté droit, avec le bout de l'index et du majeur"
    );
    assert_eq!(placed("other palm"), "à la paume de l'autre main");
    assert_eq!(placed("other elbow, 2.5cm away"), "à 2,5 cm du coude de l'autre bras");
    assert_eq!(placed("space left high"), "à l'espace devant le signeur (à gauche, en haut)");
    let moved = |movement: &str| line(&format!("movement {movement}"), "mouvement :");
    assert_eq!(
        moved("down 8cm, fast repeated twice"),
        "trajet droit de 8 cm vers le bas, rapidement, 2 fois en tout, en revenant chaque fois au départ"
    );
    assert_eq!(moved("to chin, touch"), "passage à la posture suivante, jusqu'au contact du menton");
    assert_eq!(
        moved("circle axis out radius 6cm from 9 turns 2"),
        "cercle de 6 cm de rayon dans le sens horaire pour qui regarde vers l'avant, depuis 9 heures, 2 tours"
    );
    assert_eq!(
        moved("left 20cm while wiggle index middle"),
        "trajet droit de 20 cm vers la gauche et en même temps jeu de l'index et du majeur"
    );
    assert_eq!(
        line("configuration flat, index middle hooked", "configuration :"),
        "flat, l'index et le majeur recourbés"
    );
    assert_eq!(line("brows raised slight", "sourcils"), "« raised », légèrement");
}

/// A sign that says nearly everything.
fn much() -> Sign {
    sign(
        "sign DEUX\n hands both\n strong configuration between ( flat, thumb out ) and 5, index hooked\n weak configuration 1, on pinky\n \
         strong placement between right shoulders and chest, 5cm away, with index tip to index midjoint\n \
         strong orientation fingers up-out, palm left\n \
         movement ( right 5cm, becoming ( configuration 5 and orientation palm up ) then up 5cm zigzag small across out growing ) repeated 2 moving right small, alternating\n \
         contact strong hand touches weak palm\n head ( nod 60% while tilted-left ) speed 1.5\n mouth ( open then mouthing \"ba\" )\n\
         then other hand stays\n configuration C, tight then C, thumb touching pad, index joints 4 1 0\n \
         movement arc left to chin, touch, bouncing, speed 1.2, named \"A\"\n duration 0.6s\n",
    )
}

/// The lines of an explanation without what they come from.
fn lines(said: &str) -> Vec<String> {
    let said = said.lines().map(|l| l.rsplit_once(" (").map_or(l, |(said, _)| said).to_owned());
    said.collect()
}

#[test]
fn every_kind_of_value_in_english() {
    let said = lines(&explain_in(&much(), None, Tongue::English));
    for line in [
        "  phase 1:",
        "    strong hand configuration: halfway between (flat, the thumb out) and 5, the index finger hooked",
        "    strong hand placement: 5 cm from the point halfway between the shoulders (on the right side) and the chest, with the \
         point halfway from the tip of the index finger to the middle joint of the index finger",
        "    strong hand orientation: fingers pointing up and forward, palm facing left",
        "    strong hand movement: (a straight path of 5 cm to the right, the hand becoming meanwhile 5, palm facing up, then a \
         straight path of 5 cm up, in small zigzags that swing forward, larger each time), the whole twice in all, each time from \
         the start, moving a little to the right meanwhile, the hands taking turns",
        "    weak hand configuration: 1, made with the little finger",
        "    contact: the strong hand touches the palm of the weak hand",
        "  then, phase 2, a hand that does not act staying where it was:",
        "    strong hand configuration: C, nearly closed, then C, the thumb touching the fingers at the pad, the index finger bent by \
         4, 1 and 0 quarters at knuckle, middle and last joint",
        "    strong hand movement: an arc to the left, bending up, ending touching the chin, bouncing back a little at its end, \
         1.2 times as fast, to a place that is named “A”",
        "    duration: 0.6 s",
        "  head: (nod, at 60 % and at the same time tilted-left), 1.5 times as fast",
        "  mouth: (open, then mouthing “ba”)",
    ] {
        assert!(said.iter().any(|l| l == line), "{line}\nin\n{}", said.join("\n"));
    }
}

#[test]
fn every_kind_of_value_in_french() {
    let said = lines(&french(&much()));
    for line in [
        "    la main dominante, configuration : à mi-chemin entre (flat, le pouce écarté) et 5, l'index recourbé",
        "    la main dominée, configuration : 1, formée par l'auriculaire",
        "    la main dominante, emplacement : à 5 cm du milieu entre la ligne des épaules (du côté droit) et la poitrine, avec le \
         point à mi-chemin entre le bout de l'index et l'articulation du milieu de l'index",
        "    le contact : la main dominante touche la paume de la main dominée",
        "  puis la phase 2, une main inactive restant où elle était :",
        "    la durée : 0,6 s",
        "  la tête : (« nod », à 60 % et en même temps « tilted-left »), 1,5 fois plus vite",
    ] {
        assert!(said.iter().any(|l| l == line), "{line}\nin\n{}", said.join("\n"));
    }
}

#[test]
fn a_derived_sign_in_french() {
    let operators = vec![Operator::Configuration(None, Keys::one(Configuration::named("U"))), Operator::Inverted];
    let from = Recombination { base: Base::Named("ESCARGOT".into()), operators };
    let said = explain_in(&Sign::named("X"), Some(&from), Tongue::French(&LocationInventory::builtin()));
    assert!(said.contains("fait à partir de : ESCARGOT, avec la configuration U, joué à rebours"), "{said}");
}

#[test]
fn no_place_of_the_inventory_lacks_its_french_name() {
    for row in LocationInventory::builtin().rows() {
        let article = ["le ", "la ", "les ", "l'"].iter().any(|a| row.french.starts_with(a));
        assert!(article, "{}: {:?}", row.id, row.french);
    }
}

#[test]
fn no_sign_of_the_lexicon_is_explained_with_an_uncontracted_article() {
    for sign in signs_of("lsf") {
        let said = french(&sign);
        for wrong in [" de le ", " de les ", " à le ", " à les ", "  (", ", ,"] {
            assert!(!said.contains(wrong), "{wrong:?} in\n{said}");
        }
    }
}
