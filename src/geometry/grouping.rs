//! Things by groups: a counting sort.
//!
//! ```text
//!   thing   0  1  2  3  4  5         starts  0  2  2  5  6        list  1 4 | | 0 2 5 | 3
//!   group   2  0  2  3  0  2                                            g0  g1  g2    g3
//! ```

/// Which group each of `count` things belongs to decides where it goes: the things of group g are
/// `list[starts[g]..starts[g + 1]]`, in increasing order. O(groups + count).
pub(crate) fn grouped(groups: usize, count: usize, group: impl Fn(usize) -> usize) -> (Vec<u32>, Vec<u32>) {
    let mut starts = vec![0_u32; groups + 1];
    (0..count).for_each(|i| starts[group(i)] += 1);
    let mut sum = 0;
    for start in &mut starts {
        sum += *start;
        *start = sum;
    }
    // From the last one down, so that every start ends where its group begins.
    let mut list = vec![0; count];
    for i in (0..count).rev() {
        let place = &mut starts[group(i)];
        *place -= 1;
        list[*place as usize] = i as u32;
    }
    (starts, list)
}

/// Numbers that are joined to sets, pair by pair; each set goes by its smallest number.
///
/// Cost: O(log n) for each join and each question, over many of them.
pub(crate) struct Joined(Vec<u32>);

impl Joined {
    /// The numbers below `count`, each by itself.
    pub(crate) fn none(count: usize) -> Self {
        Self((0..count as u32).collect())
    }

    /// Makes one set of the sets of two numbers. Returns whether they were two.
    pub(crate) fn join(&mut self, a: u32, b: u32) -> bool {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b) as usize] = a.min(b);
        a != b
    }

    /// The smallest number of a set.
    pub(crate) fn root(&mut self, of: u32) -> u32 {
        let mut at = of;
        while self.0[at as usize] != at {
            // Every second link is shortened, so that later walks are short.
            self.0[at as usize] = self.0[self.0[at as usize] as usize];
            at = self.0[at as usize];
        }
        at
    }
}

/// Values by groups, in two flat arrays.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Groups<T> {
    starts: Vec<u32>,
    values: Vec<T>,
}

impl<T: Copy> Groups<T> {
    /// Pairs of a group below `groups` and a value; they are gone through twice. O(groups + pairs).
    pub(crate) fn new(groups: usize, pairs: impl Iterator<Item = (usize, T)> + Clone) -> Self {
        // The place behind the start of a group goes on from there to its end, where the next group starts.
        let mut starts = vec![0_u32; groups + 2];
        pairs.clone().for_each(|(group, _)| starts[group + 2] += 1);
        (1..=groups).for_each(|g| starts[g + 1] += starts[g]);
        let any = pairs.clone().next();
        let mut values = any.map_or_else(Vec::new, |(_, value)| vec![value; starts[groups + 1] as usize]);
        for (group, value) in pairs {
            let place = &mut starts[group + 1];
            values[*place as usize] = value;
            *place += 1;
        }
        starts.pop();
        Self { starts, values }
    }

    /// The number of groups.
    #[inline]
    pub(crate) fn count(&self) -> usize {
        self.starts.len() - 1
    }

    /// The values of one group, in the order given.
    #[inline]
    pub(crate) fn of(&self, group: usize) -> &[T] {
        &self.values[self.starts[group] as usize..self.starts[group + 1] as usize]
    }

    /// The same, to be put into another order.
    #[inline]
    pub(crate) fn of_mut(&mut self, group: usize) -> &mut [T] {
        &mut self.values[self.starts[group] as usize..self.starts[group + 1] as usize]
    }
}

/// Each of the things once, in their order. O(n log n).
pub(crate) fn sorted<T: Ord>(mut list: Vec<T>) -> Vec<T> {
    list.sort_unstable();
    list.dedup();
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn things_keep_their_order_in_their_groups() {
        let groups = [2, 0, 2, 3, 0, 2];
        assert_eq!(grouped(5, groups.len(), |i| groups[i]), (vec![0, 2, 2, 5, 6, 6], vec![1, 4, 0, 2, 5, 3]));
        let pairs = Groups::new(5, groups.into_iter().zip("abcdef".chars()));
        let all: Vec<String> = (0..pairs.count()).map(|group| pairs.of(group).iter().collect()).collect();
        assert_eq!(all, ["be", "", "acf", "d", ""]);
    }
}
