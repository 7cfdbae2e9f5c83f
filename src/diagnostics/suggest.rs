//! The nearest known word, for "did you mean".

/// The known word nearest to a mistyped one, if it is near enough: a third of its letters, and one for short words.
///
/// Case and accents count as half a slip of the hand.
///
/// ```
/// use chereme::diagnostics::suggest::nearest;
/// assert_eq!(nearest("placment", ["placement", "movement"]), Some("placement"));
/// assert_eq!(nearest("xyzzy", ["placement", "movement"]), None);
/// ```
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    const LONGEST: usize = 40;
    let folded: Vec<char> = fold(word).chars().take(LONGEST + 1).collect();
    if folded.is_empty() || folded.len() > LONGEST {
        return None;
    }
    let allowed = (folded.len() / 3).max(1);
    let mut best: Option<(usize, &str)> = None;
    for candidate in known {
        let other: Vec<char> = fold(candidate).chars().collect();
        // One letter words are all one slip apart: there a guess says nothing.
        if other.len() > LONGEST || folded.len().abs_diff(other.len()) > allowed || other.len().max(folded.len()) < 2 {
            continue;
        }
        let most = best.map_or(allowed, |(least, _)| least);
        if let Some(slips) = distance(&folded, &other, most)
            && best.is_none_or(|(least, _)| slips < least)
        {
            best = Some((slips, candidate));
        }
    }
    best.map(|(_, word)| word)
}

/// The slips of the hand between two words, if they are at most `most`.
pub(crate) fn slips(a: &str, b: &str, most: usize) -> Option<usize> {
    const LONGEST: usize = 40;
    let length = |word: &str| word.chars().take(LONGEST).count();
    if length(a).abs_diff(length(b)) > most {
        return None;
    }
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().take(LONGEST).collect(), b.chars().take(LONGEST).collect());
    distance(&a, &b, most)
}

/// Lower case without accents.
pub fn fold(word: &str) -> String {
    use unicode_normalization::UnicodeNormalization;
    if word.is_ascii() {
        return word.to_ascii_lowercase();
    }
    let plain = word.nfd().filter(|c| !unicode_normalization::char::is_combining_mark(*c));
    plain.collect::<String>().to_lowercase()
}

/// Slips of the hand between two words, if they are at most `most`: letters left out, put in, exchanged for another, or
/// swapped with the next.
fn distance(a: &[char], b: &[char], most: usize) -> Option<usize> {
    let mut before = vec![0; b.len() + 1];
    let mut last: Vec<usize> = (0..=b.len()).collect();
    let mut row = vec![0; b.len() + 1];
    for i in 1..=a.len() {
        row[0] = i;
        for j in 1..=b.len() {
            let same = usize::from(a[i - 1] != b[j - 1]);
            row[j] = (last[j - 1] + same).min(last[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                row[j] = row[j].min(before[j - 2] + 1);
            }
        }
        // No later row goes below the least of two that follow each other.
        if row.iter().chain(&last).all(|slips| *slips > most) {
            return None;
        }
        std::mem::swap(&mut before, &mut last);
        std::mem::swap(&mut last, &mut row);
    }
    Some(last[b.len()]).filter(|slips| *slips <= most)
}
