//! A questionnaire about motions, as one HTML file: it shows the avatar moving, asks, and writes the answers as CSV.
//!
//! The page opens from disk and asks nothing of a network; answers stay in it until they are downloaded. It is blind: it
//! holds opaque names of stimuli, and neither what they are nor which answer is right. Its parts stand in
//! `assets/viewer/questionnaire/`; the avatar, camera and stage are the viewer's.

use super::{glb, html};
use crate::diagnostics::Error;
use crate::track::Track;
use base64::Engine;
use serde_json::{Value, json};

const TEMPLATE: &str = include_str!("../../assets/viewer/questionnaire/page.html");
const STYLE: &str = include_str!("../../assets/viewer/questionnaire/style.css");
const MODULES: [(&str, &str); 3] = [
    ("words.js", include_str!("../../assets/viewer/questionnaire/words.js")),
    ("answers.js", include_str!("../../assets/viewer/questionnaire/answers.js")),
    ("main.js", include_str!("../../assets/viewer/questionnaire/main.js")),
];

/// A text in both languages of the page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Words {
    /// English.
    pub en: String,
    /// French.
    pub fr: String,
}

impl Words {
    /// A text in English and French.
    pub fn new(en: impl Into<String>, fr: impl Into<String>) -> Words {
        Words { en: en.into(), fr: fr.into() }
    }

    fn json(&self) -> Value {
        json!({ "en": self.en, "fr": self.fr })
    }
}

/// A possible answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Choice {
    /// What the CSV says.
    pub value: String,
    /// What people read.
    pub label: Words,
}

/// What is asked about a stimulus, beside how realistic it is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Question {
    /// The question.
    pub prompt: Words,
    /// The possible answers; none where only realism is asked.
    pub choices: Vec<Choice>,
}

/// One stimulus with its question.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Task {
    /// The opaque name of the stimulus: the track of that name is shown.
    pub stimulus: String,
    /// The number of the question.
    pub question: usize,
}

/// A questionnaire, in the order in which it is asked.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Questionnaire {
    /// The name that files and answers bear.
    pub id: String,
    /// The heading.
    pub title: Words,
    /// What people read first.
    pub introduction: Words,
    /// The questions.
    pub questions: Vec<Question>,
    /// One after the other.
    pub tasks: Vec<Task>,
}

/// The page of a questionnaire; `avatar` is the avatar's GLB file, `tracks` the motions by their opaque names.
///
/// # Errors
/// Those of [`glb::write_all`]; a task without its motion or question.
///
/// ```
/// use chereme::format::questionnaire::{Question, Questionnaire, Task, Words, write};
/// use chereme::motion::{clip::{Clip, Frame}, pose::LocalPose, skeleton::Skeleton};
/// use chereme::{avatar, time::Fps, track::Track};
/// let rig = Skeleton::from_json(avatar::SKELETON).unwrap();
/// let rest = Frame { pose: LocalPose::rest(&rig), weights: vec![] };
/// let clip = Clip::new(rig.into(), Fps::DEFAULT, vec![].into(), vec![rest.clone(), rest]).unwrap();
/// let page = Questionnaire {
///     id: "q".into(), title: Words::new("Signs", "Signes"), introduction: Words::new("", ""),
///     questions: vec![Question { prompt: Words::new("", ""), choices: vec![] }],
///     tasks: vec![Task { stimulus: "7f3a".into(), question: 0 }],
/// };
/// let html = write(avatar::GLB, &[("7f3a", &Track { clip, tiers: vec![] })], &page).unwrap();
/// assert!(html.contains("\"stimulus\":\"7f3a\""));
/// assert!(write(avatar::GLB, &[], &page).is_err());
/// ```
pub fn write(avatar: &[u8], tracks: &[(&str, &Track)], page: &Questionnaire) -> Result<String, Error> {
    for task in &page.tasks {
        if task.question >= page.questions.len() || tracks.iter().all(|(name, _)| *name != task.stimulus) {
            return Err(Error::new(format!("the task `{}` has no motion or no question", task.stimulus)));
        }
    }
    let glb = glb::write_all(avatar, tracks)?;
    let choice = |c: &Choice| json!({ "value": c.value, "en": c.label.en, "fr": c.label.fr });
    let question = |q: &Question| {
        let choices: Vec<Value> = q.choices.iter().map(choice).collect();
        json!({ "prompt": q.prompt.json(), "choices": choices })
    };
    let task = |t: &Task| json!({ "stimulus": t.stimulus, "question": t.question });
    let data = json!({
        "id": page.id,
        "title": page.title.json(),
        "introduction": page.introduction.json(),
        "questions": page.questions.iter().map(question).collect::<Vec<_>>(),
        "tasks": page.tasks.iter().map(task).collect::<Vec<_>>(),
        "glb": base64::engine::general_purpose::STANDARD.encode(glb),
    });
    Ok(html::join(TEMPLATE, &[STYLE], &data.to_string(), &MODULES))
}
