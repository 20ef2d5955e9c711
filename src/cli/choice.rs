//! Words for the values of an option, each with a line of help; numbers.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// A word of the command line, what it says in the help, and what it stands for.
pub(crate) type Choice<T> = (&'static str, &'static str, T);

/// As many finite numbers with commas between; nothing if there is anything else.
pub(crate) fn numbers<const N: usize>(text: &str) -> Option<[f64; N]> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|word| word.trim().parse::<f64>()).collect();
    let numbers: Option<[f64; N]> = numbers.ok()?.try_into().ok();
    numbers.filter(|numbers| numbers.iter().all(|x| x.is_finite()))
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
