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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn things_keep_their_order_in_their_groups() {
        let groups = [2, 0, 2, 3, 0, 2];
        assert_eq!(grouped(5, groups.len(), |i| groups[i]), (vec![0, 2, 2, 5, 6, 6], vec![1, 4, 0, 2, 5, 3]));
    }
}
