//! Words for the values of an option, each with a line of help; numbers.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use std::fmt::Display;
use std::num::NonZeroUsize;
use std::ops::RangeInclusive;
use std::str::FromStr;

/// A word of the command line, what it says in the help, and what it stands for.
pub(crate) type Choice<T> = (&'static str, &'static str, T);

/// As many finite numbers with commas between; nothing if there is anything else.
pub(crate) fn numbers<const N: usize>(text: &str) -> Option<[f64; N]> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|word| word.trim().parse::<f64>()).collect();
    let numbers: Option<[f64; N]> = numbers.ok()?.try_into().ok();
    numbers.filter(|numbers| numbers.iter().all(|x| x.is_finite()))
}

/// A finite number.
pub(crate) fn number(text: &str) -> Result<f64, String> {
    let finite = text.parse().ok().filter(|x: &f64| x.is_finite());
    finite.ok_or_else(|| "this is no finite number: write it like 1.5".to_owned())
}

/// A coordinate of a point that is asked about: what is not finite is told with the point.
pub(crate) fn coordinate(text: &str) -> Result<f64, String> {
    text.parse().map_err(|_| "this is no finite number: write it like 1.5".to_owned())
}

/// A whole number from 0, as large as its type takes.
pub(crate) fn whole<T: FromStr>(text: &str) -> Result<T, String> {
    text.parse().map_err(|_| "write a whole number, 0 or more, for example 3".to_owned())
}

/// A whole number from 1.
pub(crate) fn positive(text: &str) -> Result<NonZeroUsize, String> {
    text.parse().map_err(|_| "write a whole number, 1 or more, for example 4".to_owned())
}

/// A whole number in a range.
pub(crate) fn within<T>(range: RangeInclusive<T>) -> impl Fn(&str) -> Result<T, String> + Clone + Send + Sync + 'static
where
    T: FromStr + PartialOrd + Display + Clone + Send + Sync + 'static,
{
    move |text| {
        let (least, most) = (range.start(), range.end());
        match text.parse() {
            Ok(number) if range.contains(&number) => Ok(number),
            Ok(number) => {
                Err(format!("{number} is not in {least}..={most}: write a whole number from {least} to {most}"))
            }
            Err(_) => Err(format!("write a whole number from {least} to {most}")),
        }
    }
}

/// Two numbers, as an option takes them.
pub(crate) fn pair(text: &str) -> Result<[f64; 2], String> {
    numbers(text).ok_or_else(|| "write two numbers with a comma between, for example 5,3".to_owned())
}

/// Reads one of these words as what it stands for.
pub(crate) fn one_of<T>(choices: &'static [Choice<T>]) -> impl TypedValueParser<Value = T>
where
    T: Clone + Send + Sync + 'static,
{
    let words = choices.iter().map(|&(word, help, _)| PossibleValue::new(word).help(help));
    PossibleValuesParser::new(words).try_map(|given| {
        let found = choices.iter().find(|(word, ..)| *word == given);
        found.map(|(.., value)| value.clone()).ok_or("no such word")
    })
}

/// The commands of a group, each with the module that has its `Args` and runs it.
macro_rules! commands {
    ($($(#[$how:meta])* $name:ident $module:ident,)*) => {
        #[derive(clap::Subcommand, Debug)]
        enum Command {
            $($(#[$how])* $name(Box<$module::Args>),)*
        }

        impl Command {
            fn run(&self, out: &mut $crate::Output) -> Result<$crate::Answer, $crate::Failure> {
                match self {
                    $(Self::$name(args) => $module::run(args, out),)*
                }
            }
        }
    };
}
pub(crate) use commands;
