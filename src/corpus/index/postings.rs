//! Lists of segments by what they have, one after the other in one array.

/// For each number of a thing the sorted numbers of the segments that have it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Postings {
    /// Where each list begins, and after the last one where it ends.
    from: Vec<u32>,
    segments: Vec<u32>,
}

impl Postings {
    /// Lists where each segment has one thing at most: `things` gives it for each segment; numbers from `count` on are none.
    ///
    /// ```
    /// use chereme::corpus::index::Postings;
    /// let lists = Postings::one_each([1, 0, 1, 7].into_iter(), 2);
    /// assert_eq!(lists.of(1), [0, 2]);
    /// ```
    pub fn one_each(things: impl Iterator<Item = u32> + Clone, count: usize) -> Postings {
        let all: Vec<u32> = things.collect();
        Postings::several_each(all.len(), count, |segment, put| put(all[segment]))
    }

    /// Lists where `things` tells, for a segment's number, all that it has, any of them more than once.
    pub fn several_each(segments: usize, count: usize, things: impl Fn(usize, &mut dyn FnMut(u32))) -> Postings {
        // Two passes: count, then put. The last segment put tells what was there already.
        let mut sizes = vec![0u32; count];
        let mut last = vec![u32::MAX; count];
        each(segments, &things, &mut last, |thing, _| sizes[thing] += 1);
        let mut from = Vec::with_capacity(count + 1);
        from.push(0);
        for size in sizes {
            from.push(from[from.len() - 1] + size);
        }
        let mut next: Vec<u32> = from[..count].to_vec();
        let mut all = vec![0u32; from[count] as usize];
        last.fill(u32::MAX);
        each(segments, &things, &mut last, |thing, segment| {
            all[next[thing] as usize] = segment;
            next[thing] += 1;
        });
        Postings { from, segments: all }
    }

    /// The segments that have a thing, sorted; none for a number that is no thing.
    pub fn of(&self, thing: usize) -> &[u32] {
        match self.from.get(thing..thing + 2) {
            Some([start, end]) => &self.segments[*start as usize..*end as usize],
            _ => &[],
        }
    }
}

/// Tells each thing of each segment once.
fn each(
    segments: usize,
    things: &impl Fn(usize, &mut dyn FnMut(u32)),
    last: &mut [u32],
    mut tell: impl FnMut(usize, u32),
) {
    for segment in 0..segments {
        things(segment, &mut |thing| {
            let (thing, segment) = (thing as usize, segment as u32);
            if thing < last.len() && last[thing] != segment {
                last[thing] = segment;
                tell(thing, segment);
            }
        });
    }
}

/// Sorted lists walked together: all segments that are in one of them at least.
#[derive(Debug, Clone)]
pub(in crate::corpus) struct Union<'a> {
    lists: Vec<&'a [u32]>,
}

impl<'a> Union<'a> {
    pub(in crate::corpus) fn of(lists: Vec<&'a [u32]>) -> Union<'a> {
        Union { lists }
    }

    /// The least segment from a number on; what is before is not asked for again.
    pub(in crate::corpus) fn from(&mut self, least: u32) -> Option<u32> {
        let mut found = None;
        for list in &mut self.lists {
            *list = skip(list, least);
            if let Some(first) = list.first() {
                found = Some(found.map_or(*first, |f: u32| f.min(*first)));
            }
        }
        found
    }
}

/// The rest of a sorted list from a number on, found by doubling steps (Bentley & Yao 1976).
fn skip(list: &[u32], least: u32) -> &[u32] {
    let mut step = 1;
    while list.get(step - 1).is_some_and(|n| *n < least) {
        step *= 2;
    }
    let (low, high) = (step / 2, (step - 1).min(list.len()));
    &list[low + list[low..high].partition_point(|n| *n < least)..]
}
