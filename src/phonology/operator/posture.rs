//! What a hand becomes during its movements, said at keys, where operators find it.

use super::invert::filled;
use super::keys_of;
use crate::phonology::{Action, Becoming, Configuration, Keys, Manual, Movement, Orientation};

/// A hand's tiers with the configuration and orientation that it takes on during an interval said at the key after it, where
/// that key says none. An action that is the whole movement of its interval need not say it any more.
pub(super) fn at_keys(own: &Manual) -> Manual {
    let mut said = own.clone();
    let configurations = lasting(&own.movement, &own.configuration, |b| b.configuration.clone());
    if !configurations.is_empty() {
        let first = own.configuration.is_empty().then(|| (0, Configuration::named("rest")));
        said.configuration = more(&own.configuration, first.into_iter().chain(configurations.clone()).collect());
        forget(&mut said.movement, &configurations, |b| b.configuration = None);
    }
    let orientations: Vec<(usize, Orientation)> = lasting(&own.movement, &own.orientation, |b| b.orientation);
    if !orientations.is_empty() && !own.orientation.is_empty() {
        said.orientation = filled(&more(&own.orientation, orientations.clone()));
        forget(&mut said.movement, &orientations, |b| b.orientation = None);
    }
    said
}

/// What is taken on in each interval and kept, at the keys that say nothing themselves.
fn lasting<T>(movements: &[Movement], stated: &Keys<T>, facet: impl Fn(&Becoming) -> Option<T>) -> Vec<(usize, T)> {
    let one = |(interval, movement)| Some((interval + 1, last(movement, &facet)?));
    let all = movements.iter().enumerate().filter_map(one);
    all.filter(|(key, _)| stated.stated(*key).is_none()).collect()
}

/// The last value that a movement takes on.
fn last<T>(movement: &Movement, facet: &impl Fn(&Becoming) -> Option<T>) -> Option<T> {
    match movement {
        Movement::Action(action) => action.becoming.as_deref().and_then(facet),
        Movement::Sequence(parts) | Movement::Together(parts) | Movement::Fused(parts) => {
            parts.iter().rev().find_map(|part| last(part, facet))
        }
        Movement::Repeated(r) => last(&r.movement, facet),
        // It ends with what there was before.
        Movement::Backwards(_) => None,
    }
}

/// What stands at keys now, left out of the actions before them.
fn forget<T>(movements: &mut [Movement], at: &[(usize, T)], drop: impl Fn(&mut Becoming)) {
    for (key, _) in at {
        if let Some(Movement::Action(action)) = movements.get_mut(key - 1)
            && action.repetition.is_none()
        {
            **action = without(action, &drop);
        }
    }
}

fn more<T: Clone>(stated: &Keys<T>, values: Vec<(usize, T)>) -> Keys<T> {
    keys_of(stated.iter().map(|(key, value)| (key, value.clone())).chain(values).collect())
}

/// An action that says a part of what the hand becomes no more.
pub(super) fn without(action: &Action, drop: &impl Fn(&mut Becoming)) -> Action {
    let becoming = action.becoming.clone().map(|mut becoming| {
        drop(&mut becoming);
        becoming
    });
    Action { becoming: becoming.filter(|b| !b.is_empty()), ..action.clone() }
}
