//! Reads the paths in Rust source: enough of the language to know which module a file reaches for.
//!
//! Comments, strings and characters are taken out first. Inline modules are followed, so that `super` inside
//! `mod tests { … }` is the file's own module.

/// What a piece of source text is made of, as far as paths go.
#[derive(Debug, Clone, PartialEq)]
enum Token {
    Word(String),
    PathSeparator,
    Sign(char),
}

/// The words and signs of a source text without comments, strings, characters and lifetimes.
fn tokens(text: &str) -> Vec<Token> {
    let text: Vec<char> = text.chars().collect();
    let at = |i: usize| text.get(i).copied().unwrap_or('\0');
    let mut found = Vec::new();
    let mut i = 0;
    while i < text.len() {
        let c = text[i];
        if c == '/' && at(i + 1) == '/' {
            i += text[i..].iter().take_while(|c| **c != '\n').count();
        } else if c == '/' && at(i + 1) == '*' {
            i = end_of_block_comment(&text, i);
        } else if c == '"' {
            i = end_of_string(&text, i + 1);
        } else if c == '\'' {
            i = end_of_quote(&text, i);
        } else if c == ':' && at(i + 1) == ':' {
            found.push(Token::PathSeparator);
            i += 2;
        } else if c.is_alphanumeric() || c == '_' {
            let end = i + text[i..].iter().take_while(|c| c.is_alphanumeric() || **c == '_').count();
            let word: String = text[i..end].iter().collect();
            i = match raw_string(&text, end).filter(|_| matches!(word.as_str(), "r" | "br" | "cr")) {
                Some(end) => end,
                // r#type is the word `type`.
                None if word == "r" && at(end) == '#' => end + 1,
                None => {
                    found.push(Token::Word(word));
                    end
                }
            };
        } else {
            if !c.is_whitespace() {
                found.push(Token::Sign(c));
            }
            i += 1;
        }
    }
    found
}

/// Past the end of a block comment, which may hold others.
fn end_of_block_comment(text: &[char], start: usize) -> usize {
    let (mut depth, mut i) = (0, start);
    while i < text.len() {
        match (text[i], text.get(i + 1)) {
            ('/', Some('*')) => (depth, i) = (depth + 1, i + 2),
            ('*', Some('/')) => (depth, i) = (depth - 1, i + 2),
            _ => i += 1,
        }
        if depth == 0 {
            break;
        }
    }
    i
}

/// Past the closing quote of a string whose text starts at `i`.
fn end_of_string(text: &[char], mut i: usize) -> usize {
    while i < text.len() && text[i] != '"' {
        i += if text[i] == '\\' { 2 } else { 1 };
    }
    i + 1
}

/// Past a raw string whose `#`s or quote stand at `i`, if there is one.
fn raw_string(text: &[char], i: usize) -> Option<usize> {
    let hashes = text.get(i..)?.iter().take_while(|c| **c == '#').count();
    let open = i + hashes;
    if text.get(open) != Some(&'"') {
        return None;
    }
    let closes = |at: usize| text[at] == '"' && text[at + 1..].iter().take_while(|c| **c == '#').count() >= hashes;
    Some((open + 1..text.len()).find(|at| closes(*at)).map_or(text.len(), |at| at + 1 + hashes))
}

/// Past a character such as `'{'`, or past the tick of a lifetime.
fn end_of_quote(text: &[char], i: usize) -> usize {
    if text.get(i + 1) == Some(&'\\') {
        let rest = text.get(i + 3..).unwrap_or_default();
        return i + 4 + rest.iter().take_while(|c| **c != '\'').count();
    }
    if text.get(i + 2) == Some(&'\'') { i + 3 } else { i + 1 }
}

/// Every path of a source text that starts with a word and has a `::`, with `use` groups taken apart.
///
/// `module` is the path of the file's module (`["motion", "easing"]`; empty for the crate's root). Paths that start
/// with `crate`, `super` or `self` come back from the crate's root, with `crate` before them; others as written.
/// A macro call comes back as its name and `!`.
pub fn paths(text: &str, module: &[&str]) -> Vec<Vec<String>> {
    let tokens = tokens(text);
    let mut here: Vec<String> = module.iter().map(|s| (*s).to_owned()).collect();
    let mut open: Vec<bool> = Vec::new(); // for each open brace: does it open an inline module?
    let mut found = Vec::new();
    let word = |i: usize| match tokens.get(i) {
        Some(Token::Word(word)) => Some(word.as_str()),
        _ => None,
    };
    let mut i = 0;
    while i < tokens.len() {
        match &tokens[i] {
            Token::Word(name) if name == "mod" && tokens.get(i + 2) == Some(&Token::Sign('{')) => {
                here.extend(word(i + 1).map(str::to_owned));
                open.push(true);
                i += 3;
                continue;
            }
            Token::Word(name) if tokens.get(i + 1) == Some(&Token::Sign('!')) => {
                found.push(vec![format!("{name}!")]);
            }
            Token::Word(_) if tokens.get(i + 1) == Some(&Token::PathSeparator) => {
                let mut written = Vec::new();
                i = tree(&tokens, i, &mut Vec::new(), &mut written);
                found.extend(written.into_iter().map(|path| resolve(path, &here)));
                continue;
            }
            Token::Sign('{') => open.push(false),
            Token::Sign('}') if open.pop() == Some(true) => {
                here.pop();
            }
            _ => {}
        }
        i += 1;
    }
    found
}

/// Reads one path or `use` tree at `i`, adding its leaves to `found`; returns where it ends.
fn tree(tokens: &[Token], mut i: usize, prefix: &mut Vec<String>, found: &mut Vec<Vec<String>>) -> usize {
    let depth = prefix.len();
    loop {
        match tokens.get(i) {
            Some(Token::Word(word)) => prefix.push(word.clone()),
            Some(Token::Sign('*')) if !prefix.is_empty() => prefix.push("*".to_owned()),
            Some(Token::Sign('{')) => {
                i = group(tokens, i + 1, prefix, found);
                prefix.truncate(depth);
                return i;
            }
            // `Vec::<T>::new` and `<T as U>::V`: what came before the bracket is the path.
            _ => break,
        }
        i += 1;
        if tokens.get(i) != Some(&Token::PathSeparator) {
            break;
        }
        i += 1;
    }
    if prefix.len() > depth {
        found.push(prefix.clone());
    }
    prefix.truncate(depth);
    i
}

/// Reads the trees of a group, up to and past its closing brace.
fn group(tokens: &[Token], mut i: usize, prefix: &mut Vec<String>, found: &mut Vec<Vec<String>>) -> usize {
    while let Some(token) = tokens.get(i) {
        match token {
            Token::Sign('}') => return i + 1,
            Token::Word(word) if word == "as" => i += 2,
            Token::Word(_) | Token::Sign('*' | '{') => i = tree(tokens, i, prefix, found),
            _ => i += 1,
        }
    }
    i
}

/// A path from the crate's root, where it starts with `crate`, `super` or `self`; else the path as it is.
fn resolve(path: Vec<String>, here: &[String]) -> Vec<String> {
    if !matches!(path[0].as_str(), "crate" | "super" | "self") {
        return path;
    }
    let mut at: Vec<String> = here.to_vec();
    for part in path {
        match part.as_str() {
            "crate" => at.clear(),
            "super" => {
                at.pop();
            }
            "self" => {}
            _ => at.push(part),
        }
    }
    at.insert(0, "crate".to_owned());
    at
}

/// The paths of `text` in the module `motion::easing`, joined, for a short comparison.
#[cfg(test)]
fn check(text: &str, expected: &[&str]) {
    let found: Vec<String> = paths(text, &["motion", "easing"]).iter().map(|p| p.join("::")).collect();
    assert_eq!(found, expected, "{text}");
}

#[test]
fn plain_and_grouped_paths() {
    check("use crate::time::Fps;", &["crate::time::Fps"]);
    check(
        "use crate::{body::{arm::A, hand}, time as t, tier::*};",
        &["crate::body::arm::A", "crate::body::hand", "crate::time", "crate::tier::*"],
    );
    check("use {crate::body::A, super::pose};", &["crate::body::A", "crate::motion::pose"]);
    check("use crate\n  ::\n  body;", &["crate::body"]);
    check("fn f(a: &mut crate::body::A<crate::time::B>) {}", &["crate::body::A", "crate::time::B"]);
    check("let x = crate::body::f::<u8>(crate::time::g());", &["crate::body::f", "crate::time::g"]);
    check("pub(in crate::motion) fn f() {} pub(crate) fn g() {}", &["crate::motion"]);
    check("macro_rules! m { () => { $crate::body::f() } }", &["macro_rules!", "crate::body::f"]);
    check("impl super::Walk for Clip {}", &["crate::motion::Walk"]);
    check("use crate::body::r#type::X;", &["crate::body::type::X"]);
}

#[test]
fn super_goes_up_and_inline_modules_go_down() {
    check("use super::pose::P;", &["crate::motion::pose::P"]);
    check("use super::super::body::A;", &["crate::body::A"]);
    check(
        "use super::{super::body, rotation::{unit, self}};",
        &["crate::body", "crate::motion::rotation::unit", "crate::motion::rotation"],
    );
    check("use self::inner::X; use self::super::super::tier;", &["crate::motion::easing::inner::X", "crate::tier"]);
    check(
        "mod tests { use super::*; fn f() { if true {} } use super::super::pose; } use super::clip;",
        &["crate::motion::easing::*", "crate::motion::pose", "crate::motion::clip"],
    );
    check(
        "mod a; mod b { mod c { use super::super::super::super::body; } } use super::x;",
        &["crate::body", "crate::motion::x"],
    );
    check("fn f(&self) { self.g() } use super::super::*;", &["crate::*"]);
}

#[test]
fn comments_strings_and_characters_hold_no_paths() {
    check("// use crate::body;\n/// [`crate::body::A`]\n//! crate::body\nfn f() {}", &[]);
    check("/* crate::body /* crate::tier */ crate::time */ use crate::track;", &["crate::track"]);
    check(r##"let s = "crate::body"; let e = "\" crate::body"; use crate::tier;"##, &["crate::tier"]);
    check("let s = r#\"crate::body \"inner\" \"#; let b = br\"\\\"; use crate::tier;", &["crate::tier"]);
    check("let q = '\"'; use crate::tier; let p = '\"';", &["crate::tier"]);
    check(
        "let b = '{'; let c = '\\''; let d = b'}'; mod t { use super::x; } let u = '\\u{7d}';",
        &["crate::motion::easing::x"],
    );
    check("fn f<'a>(x: &'a str) -> crate::time::T<'a> {}", &["crate::time::T"]);
    check("const CRATE: &str = \"//\"; use crate::tier;", &["crate::tier"]);
    check("let slash = '/'; /* ' */ use crate::tier; // '", &["crate::tier"]);
}

#[test]
fn macros_and_the_standard_library() {
    check("println!(\"{}\", std::env::args().len())", &["println!", "std::env::args"]);
    check(
        "use std::{fs, io::{self, Write, stdin}};",
        &["std::fs", "std::io::self", "std::io::Write", "std::io::stdin"],
    );
}
