//! What lateness costs.
//!
//! ```text
//!   due ──grace──┬── every day that has begun takes `takes`, together not more than `most` ──┬── closes_after: all
//!     nothing    │                                                                           │
//! ```

use super::time::Time;
use crate::{Adjustment, HandedIn, Points};

/// The late rule of a course or of a lab.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct LateRule {
    /// What is counted; one that has begun counts as a whole one.
    pub every: Every,
    /// What each of them takes.
    pub takes: Takes,
    /// The greatest share of the earned points that is taken in this way.
    pub most: Option<Points>,
    /// After so many of them, all points are lost.
    pub closes_after: Option<u32>,
    /// So many minutes late is in time.
    pub grace_minutes: u32,
}

/// What is counted.
#[derive(Clone, Copy, PartialEq, Eq, Debug, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Every {
    /// Days of 24 hours after the due date.
    Day,
    /// Hours.
    Hour,
}

/// What one day or hour costs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Takes {
    /// This share of what the tests gave.
    Share(Points),
    /// So many points.
    Points(Points),
}

impl Every {
    fn seconds(self) -> i64 {
        match self {
            Self::Day => 24 * 3600,
            Self::Hour => 3600,
        }
    }

    fn word(self, count: i64) -> String {
        let word = match self {
            Self::Day => "day",
            Self::Hour => "hour",
        };
        format!("{count} {word}{}", if count == 1 { "" } else { "s" })
    }
}

impl LateRule {
    /// The rule in a sentence for students.
    #[must_use]
    pub fn sentence(&self) -> String {
        let each = self.every.word(1).split_off(2);
        let takes = match self.takes {
            Takes::Share(share) => format!("{} % of what was earned", share.times(100)),
            Takes::Points(points) => format!("{points} points"),
        };
        let mut text = format!("Each {each} that has begun after the due date takes {takes}");
        if let Some(most) = self.most {
            text += &format!(", {} % at most", most.times(100));
        }
        if let Some(last) = self.closes_after {
            text += &format!("; after {} nothing counts any more", self.every.word(last.into()));
        }
        text.push('.');
        match self.grace_minutes {
            0 => {}
            1 => text += " One minute late is in time.",
            minutes => text += &format!(" Up to {minutes} minutes late is in time."),
        }
        text
    }

    /// What is taken of these points, and why; `None` if it was handed in in time. Not more than was earned.
    pub(super) fn cost(&self, earned: Points, handed_in: &HandedIn, due: Time) -> Option<Adjustment> {
        let at = handed_in.at.as_ref().and_then(|at| at.parse::<Time>().ok());
        let (count, how) = match at {
            Some(at) => {
                let late = at.seconds_after(due);
                if late <= i64::from(self.grace_minutes) * 60 {
                    return None;
                }
                let count = (late + self.every.seconds() - 1).div_euclid(self.every.seconds());
                (count, format!("late: {} after {due}", self.every.word(count)))
            }
            None if handed_in.marked_late => {
                (1, format!("marked as late without a time: counted as {}", self.every.word(1)))
            }
            None => return None,
        };
        if self.closes_after.is_some_and(|last| count > i64::from(last)) {
            let last = self.every.word(self.closes_after.unwrap_or_default().into());
            return Some(Adjustment { reason: format!("{how}, and closed after {last}"), points: -earned });
        }
        let times = u32::try_from(count).unwrap_or(u32::MAX);
        let (cost, each) = match self.takes {
            Takes::Share(share) => {
                // A hundred days of any share that can be written take all; more would only overflow.
                let all = share.times(times.min(100_000)).min(Points::from(1));
                (earned.share(all), format!("{} % each", share.times(100)))
            }
            Takes::Points(points) => (points.times(times), format!("{points} points each")),
        };
        let most = self.most.map_or(earned, |most| earned.share(most));
        let reason = if cost > most && self.most.is_some() {
            format!("{how}, {each}, at most {} %", self.most.unwrap_or_default().times(100))
        } else {
            format!("{how}, {each}")
        };
        Some(Adjustment { reason, points: -cost.min(most).max(Points::ZERO) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rule() -> LateRule {
        let takes = Takes::Share("1/3".parse().unwrap());
        LateRule { every: Every::Day, takes, most: None, closes_after: None, grace_minutes: 15 }
    }

    fn cost(rule: &LateRule, earned: &str, at: &str) -> Option<(String, String)> {
        let due: Time = "2026-10-12T23:59:00+02:00".parse().unwrap();
        let handed_in = HandedIn { at: Some(at.to_owned()), ..HandedIn::default() };
        let cost = rule.cost(earned.parse().unwrap(), &handed_in, due)?;
        Some((cost.points.to_string(), cost.reason))
    }

    #[test]
    fn a_day_begins_with_its_first_second_and_a_fraction_is_exact() {
        let points = |at: &str| cost(&rule(), "90", at).map(|(points, _)| points);
        assert_eq!(points("2026-10-12T23:59:00+02:00"), None);
        assert_eq!(points("2026-10-13T00:14:00+02:00"), None, "grace");
        assert_eq!(points("2026-10-13T00:14:01+02:00").as_deref(), Some("-30"), "after the grace it is a whole day");
        assert_eq!(points("2026-10-13T21:59:00Z").as_deref(), Some("-30"), "the last second of the first day");
        assert_eq!(points("2026-10-13T21:59:01Z").as_deref(), Some("-60"));
        assert_eq!(points("2026-10-20T00:00:00Z").as_deref(), Some("-90"), "never more than was earned");
        assert_eq!(cost(&rule(), "62", "2026-10-13T12:00:00Z").unwrap().0, "-20.667");
    }

    #[test]
    fn the_rule_is_said_in_a_sentence() {
        let third = "Each day that has begun after the due date takes 33.333 % of what was earned";
        assert_eq!(rule().sentence(), format!("{third}. Up to 15 minutes late is in time."));
        let most = LateRule { most: Some("1/2".parse().unwrap()), closes_after: Some(1), grace_minutes: 0, ..rule() };
        assert_eq!(most.sentence(), format!("{third}, 50 % at most; after 1 day nothing counts any more."));
        let hours = LateRule { every: Every::Hour, takes: Takes::Points("2.5".parse().unwrap()), ..most };
        let hours = LateRule { most: None, closes_after: Some(30), ..hours };
        let sentence =
            "Each hour that has begun after the due date takes 2.5 points; after 30 hours nothing counts any more.";
        assert_eq!(hours.sentence(), sentence);
    }

    #[test]
    fn most_closing_hours_and_points_are_kept_to() {
        let most = LateRule { most: Some("50 %".parse().unwrap()), closes_after: Some(5), ..rule() };
        assert_eq!(cost(&most, "80", "2026-10-15T00:00:00Z").unwrap().0, "-40");
        assert!(cost(&most, "80", "2026-10-15T00:00:00Z").unwrap().1.contains("at most 50 %"));
        assert_eq!(cost(&most, "80", "2026-10-17T21:59:00Z").unwrap().0, "-40", "the last second of the fifth day");
        let closed = cost(&most, "80", "2026-10-17T21:59:01Z").unwrap();
        assert_eq!((closed.0.as_str(), closed.1.contains("closed after 5 days")), ("-80", true), "{closed:?}");
        let hours = LateRule { every: Every::Hour, takes: Takes::Points("2.5".parse().unwrap()), ..rule() };
        let late = cost(&hours, "80", "2026-10-13T02:00:00+02:00").unwrap();
        assert_eq!(
            (late.0.as_str(), late.1.as_str()),
            ("-7.5", "late: 3 hours after 2026-10-12 23:59:00+02:00, 2.5 points each")
        );
    }

    #[test]
    fn a_mark_without_a_time_counts_once_and_says_so() {
        let due: Time = "2026-10-12T23:59:00+02:00".parse().unwrap();
        let marked = HandedIn { marked_late: true, ..HandedIn::default() };
        let late = rule().cost(Points::from(9), &marked, due).unwrap();
        assert_eq!(late.points, Points::from(-3));
        assert!(late.reason.contains("without a time"), "{}", late.reason);
        assert_eq!(rule().cost(Points::from(9), &HandedIn::default(), due), None);
    }
}
