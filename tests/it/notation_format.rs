//! `fmt`: comments kept, columns aligned, printing what was printed changes nothing.

use chereme::notation::{parse, print};

fn check(written: &str, laid_out: &str) {
    let (file, faults) = parse(written);
    assert_eq!(faults, []);
    assert_eq!(print(&file), laid_out);
    let (again, _) = parse(laid_out);
    assert_eq!(print(&again), laid_out);
}

#[test]
fn comments_and_blank_lines_stay() {
    check(
        "# a file\nlanguage lsf\n# about BOL\nsign BOL # the bowl\n#first\nhands both mirrored#second\n\n\n\n# third\nmovement up\n#fourth\n#fifth\nsign B\nhands one\n\n# last\n",
        "# a file\nlanguage lsf\n\n# about BOL\nsign BOL  # the bowl\n  # first\n  hands          both mirrored  # second\n\n  # third\n  \
         movement       up\n\n# fourth\n# fifth\nsign B\n  hands          one\n\n# last\n",
    );
}

#[test]
fn one_column_for_the_values_of_a_sign() {
    check(
        "sign A\nhands both\nstrong configuration flat\nweak placement chest\nsign B\nhands one\n",
        "sign A\n  hands                 both\n  strong configuration  flat\n  weak placement        chest\n\nsign B\n  hands          one\n",
    );
}

#[test]
fn line_ends_and_marks_of_other_systems() {
    check("\u{feff}sign A\r\n\tmovement\tup\r\n", "sign A\n  movement       up\n");
    check("", "");
    check("\n\n#\n", "#\n");
    // What has no line end after it and says nothing is no line: the same file is read from what is printed.
    check("sign A\n  ", "sign A\n");
    assert_eq!(parse("sign A\n  ").0.lines.len(), parse("sign A\n").0.lines.len());
}

#[test]
fn numbers_keep_their_units() {
    check(
        "sign A\nmovement up 150 mm\nduration 900ms\n",
        "sign A\n  movement       up 150mm\n  duration       900ms\n",
    );
}
