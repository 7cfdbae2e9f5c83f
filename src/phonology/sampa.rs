//! Words mouthed: SAMPA as people write it, read into sounds.
//!
//! SAMPA writes the sounds of a language in ASCII, case telling them apart (`s` and `S`). What real lexica hold is
//! looser: doubled letters for long sounds (`zev@@nfeRt@x`), diphthongs tied (`ta_Im`), letters of IPA, of the
//! alphabet or of X-SAMPA beside it. So nothing is refused: a sign that stands for no sound is passed over, and an
//! unknown letter becomes the nearest sound that a mouth can show.
//!
//! Lengths are relative: an ordinary vowel is 1. They follow what eyes see of speech: vowels last, consonants pass.

/// One sound of a mouthed word.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sound {
    /// Its sign, one of [`SOUNDS`].
    pub sign: char,
    /// How long it lasts; 1 for an ordinary vowel.
    pub length: f64,
}

/// The signs of vowels.
pub const VOWELS: &str = "aAeEiIoOuUyY@29{}QV36";

/// All signs that a reading may hold; each has a mouth shape in `grammar/nonmanuals.ron`.
pub const SOUNDS: &str = "aAeEiIoOuUyY@29{}QV36jwHmbpfvtdnszlrTDSZkgNxhR";

/// A long vowel lasts so much longer.
const LONG: f64 = 1.6;

/// The sounds of a word.
///
/// ```
/// use chereme::phonology::sampa;
/// let signs: String = sampa::read("so:nmud").iter().map(|s| s.sign).collect();
/// assert_eq!(signs, "sonmud");
/// ```
pub fn read(text: &str) -> Vec<Sound> {
    let mut sounds: Vec<Sound> = Vec::new();
    let (mut tied, mut stressed) = (false, false);
    let mut chars = text.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            ':' | 'ː' => longer(sounds.last_mut()),
            '"' | '%' | 'ˈ' | 'ˌ' => stressed = true,
            // SAMPA of Polish: s' is said as S is; elsewhere an apostrophe is a stress mark.
            '\'' => match sounds.last_mut() {
                Some(last) if matches!(last.sign, 's' | 'z') => last.sign = last.sign.to_ascii_uppercase(),
                Some(_) | None => stressed = true,
            },
            '=' => {
                if let Some(last) = sounds.last_mut() {
                    last.length = last.length.max(1.0);
                }
            }
            '_' => match chars.peek() {
                Some(next) if nearest(*next).is_some() => tied = true,
                // A diacritic of X-SAMPA (`_~`, `_=`).
                Some(_) => {
                    chars.next();
                }
                None => {}
            },
            other => {
                let Some(sign) = nearest(other) else { continue };
                match sounds.last_mut() {
                    Some(last) if last.sign == sign && !tied => longer(Some(last)),
                    Some(_) | None => {
                        let glide = if std::mem::take(&mut tied) { 0.55 } else { 1.0 };
                        let stress = if std::mem::take(&mut stressed) { 1.15 } else { 1.0 };
                        sounds.push(Sound { sign, length: usual(sign) * glide * stress });
                    }
                }
            }
        }
    }
    sounds
}

/// A sound said long; saying so twice makes it no longer.
fn longer(sound: Option<&mut Sound>) {
    if let Some(sound) = sound {
        sound.length = (sound.length * LONG).min(usual(sound.sign) * LONG * 1.15);
    }
}

/// How long a sound lasts where nothing is said.
fn usual(sign: char) -> f64 {
    match sign {
        '@' | '6' => 0.7,
        // What the lips do not show may pass quickly.
        'k' | 'g' | 'N' | 'x' | 'h' | 'R' => 0.5,
        vowel if VOWELS.contains(vowel) => 1.0,
        _ => 0.65,
    }
}

/// The sound of a letter: its own, or the one whose mouth shape is nearest.
fn nearest(letter: char) -> Option<char> {
    if SOUNDS.contains(letter) {
        return Some(letter);
    }
    let sound = match letter {
        '1' | '5' | 'ä' | 'ɛ' | 'è' | 'ê' | 'ε' => 'E',
        '7' | '8' | 'ə' | 'ɘ' => '@',
        '&' | 'æ' => '{',
        '0' | '§' | 'ɔ' | 'å' | 'ó' | 'ô' => 'o',
        'ɑ' | 'ɐ' | 'à' | 'â' | 'á' => 'A',
        'é' => 'e',
        'í' | 'î' | 'ì' => 'i',
        'ɪ' => 'I',
        'ʊ' | 'ú' | 'ù' => 'U',
        'ʏ' | 'ü' => 'y',
        'M' | 'ɯ' => 'u',
        'ø' | 'ö' => '2',
        'œ' => '9',
        'ɒ' => 'Q',
        'ʌ' => 'V',
        'ɜ' => '3',
        'B' | 'β' => 'b',
        'F' | 'ɱ' => 'f',
        'P' | 'ʋ' => 'v',
        'W' | 'ʍ' => 'w',
        'ɥ' => 'H',
        'J' | 'ñ' | 'ɲ' => 'n',
        'L' | 'K' | 'ʎ' | 'ɫ' => 'l',
        '4' | 'ɾ' | 'ɹ' => 'r',
        'c' | 'q' | 'ʔ' => 'k',
        'ŋ' => 'N',
        'C' | 'X' | 'G' | 'ç' | 'χ' | 'ɣ' => 'x',
        'ʁ' | 'ʀ' => 'R',
        'θ' => 'T',
        'ð' => 'D',
        'ʃ' | 'š' => 'S',
        'ʒ' | 'ž' => 'Z',
        'ß' => 's',
        other if other.is_ascii_alphabetic() && SOUNDS.contains(other.to_ascii_lowercase()) => {
            other.to_ascii_lowercase()
        }
        _ => return None,
    };
    Some(sound)
}
