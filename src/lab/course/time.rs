//! Points in time: due dates, and when something was handed in.

use std::fmt;
use std::str::FromStr;
use std::time::{SystemTime, UNIX_EPOCH};
use toml::value::{Date, Datetime, Offset, Time as Clock};

/// A second, with the clock that it is shown by.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Time {
    /// Seconds since 1970 in UTC.
    seconds: i64,
    /// How far the clock is ahead of UTC, in minutes.
    offset: i16,
}

const DAY: i64 = 24 * 3600;

impl Time {
    /// The time that is written in a TOML file, or as RFC 3339 writes it. A date alone is the last second of that day.
    /// `clock` is how far clocks are ahead of UTC, in minutes, where that is not said.
    ///
    /// # Errors
    /// What is missing, as a sentence.
    pub(super) fn new(written: &Datetime, clock: Option<i16>) -> Result<Self, String> {
        let Some(date) = written.date else {
            return Err("the day is missing; write 2026-10-12T23:59:00+02:00".to_owned());
        };
        let offset = match written.offset {
            Some(Offset::Z) => 0,
            Some(Offset::Custom { minutes }) => minutes,
            None => {
                clock.ok_or("it is not said by which clock; write 2026-10-12T23:59:00+02:00, or `utc_offset` above")?
            }
        };
        let end_of_day = Clock { hour: 23, minute: 59, second: Some(59), nanosecond: None };
        let time = written.time.unwrap_or(end_of_day);
        let of_day = i64::from(time.hour) * 3600 + i64::from(time.minute) * 60 + i64::from(time.second.unwrap_or(0));
        Ok(Self { seconds: days(date) * DAY + of_day - i64::from(offset) * 60, offset })
    }

    /// The time that a system gives a file, shown by the clock of another time.
    pub(super) fn of_system(time: SystemTime, like: Self) -> Self {
        let seconds = match time.duration_since(UNIX_EPOCH) {
            Ok(after) => i64::try_from(after.as_secs()).unwrap_or(i64::MAX),
            Err(before) => -i64::try_from(before.duration().as_secs()).unwrap_or(i64::MAX),
        };
        Self { seconds, ..like }
    }

    /// The same second by another clock.
    pub(super) fn by_clock_of(self, other: Self) -> Self {
        Self { offset: other.offset, ..self }
    }

    /// How many seconds after another time it is; negative if before.
    #[must_use]
    pub fn seconds_after(self, other: Self) -> i64 {
        self.seconds.saturating_sub(other.seconds)
    }
}

/// As RFC 3339 writes it, with the clock.
impl FromStr for Time {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let written: Datetime =
            text.trim().parse().map_err(|_| format!("{text:?} is no time; write 2026-10-12T23:59:00+02:00"))?;
        Self::new(&written, None)
    }
}

/// `2026-10-12 23:59:00+02:00`, which can be read again.
impl fmt::Display for Time {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let local = self.seconds.saturating_add(i64::from(self.offset) * 60);
        let (year, month, day) = date(local.div_euclid(DAY));
        let of_day = local.rem_euclid(DAY);
        let (hour, minute, second) = (of_day / 3600, of_day / 60 % 60, of_day % 60);
        let (sign, offset) = (if self.offset < 0 { '-' } else { '+' }, self.offset.unsigned_abs());
        write!(
            f,
            "{year}-{month:02}-{day:02} {hour:02}:{minute:02}:{second:02}{sign}{:02}:{:02}",
            offset / 60,
            offset % 60
        )
    }
}

/// The days from 1970 to a date. Years begin in March here, so that the day which is sometimes there is the last one.
fn days(date: Date) -> i64 {
    let (month, day) = (i64::from(date.month), i64::from(date.day));
    let year = i64::from(date.year) - i64::from(month <= 2);
    let of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    365 * year + year.div_euclid(4) - year.div_euclid(100) + year.div_euclid(400) + of_year - 719_468
}

/// The date of a day since 1970.
fn date(days: i64) -> (i64, i64, i64) {
    let days = days + 719_468;
    let era = days.div_euclid(146_097);
    let of_era = days.rem_euclid(146_097);
    let year_of_era = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let from_march = (5 * of_year + 2) / 153;
    let month = if from_march < 10 { from_march + 3 } else { from_march - 9 };
    (year_of_era + era * 400 + i64::from(month <= 2), month, of_year - (153 * from_march + 2) / 5 + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn time(text: &str) -> Time {
        text.parse().unwrap()
    }

    #[test]
    fn seconds_are_those_of_the_systems_clock() {
        // Asked of `date -u -d TEXT +%s`.
        for (text, seconds) in [
            ("1970-01-01T00:00:00Z", 0),
            ("2024-02-29T12:00:00Z", 1_709_208_000),
            ("2026-10-12T23:59:00+02:00", 1_791_842_340),
            ("2100-03-01T00:00:00Z", 4_107_542_400),
            ("1999-12-31T23:59:59-05:00", 946_702_799),
            ("2018-07-01T14:22:32.365935-07:00", 1_530_480_152),
        ] {
            assert_eq!(time(text).seconds, seconds, "{text}");
        }
    }

    #[test]
    fn a_time_is_shown_as_it_was_written() {
        for text in ["2026-10-12 23:59:00+02:00", "2024-02-29 00:00:01-09:30", "2000-01-01 12:00:00+00:00"] {
            assert_eq!(time(text).to_string(), text);
            assert_eq!(time(&text.replace(' ', "T")), time(text));
        }
        for day in (-800_000..800_000).step_by(17) {
            let (year, month, number) = date(day);
            if let Ok(year) = u16::try_from(year) {
                assert_eq!(days(Date { year, month: month as u8, day: number as u8 }), day);
            }
        }
    }

    #[test]
    fn a_day_ends_with_its_last_second_and_a_clock_must_be_known() {
        let day: Datetime = "2026-10-12".parse().unwrap();
        assert_eq!(Time::new(&day, Some(120)).unwrap().to_string(), "2026-10-12 23:59:59+02:00");
        assert!(Time::new(&day, None).unwrap_err().contains("utc_offset"));
        let clock: Datetime = "23:59:00".parse().unwrap();
        assert!(Time::new(&clock, Some(0)).unwrap_err().contains("the day is missing"));
        assert!("yesterday".parse::<Time>().unwrap_err().contains("2026-10-12T23:59:00+02:00"));
        assert_eq!(time("2026-10-12T12:00:00Z").seconds_after(time("2026-10-12T13:00:00+02:00")), 3600);
    }
}
