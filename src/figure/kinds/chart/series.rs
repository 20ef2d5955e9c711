//! What a chart shows: measured series, and the growth one compares them with.

use crate::figure::canvas::text;
use crate::figure::kinds::chart::log::log2;
use crate::figure::sketch::Role;

/// A measured point.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Sample {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) range: Option<[f64; 2]>,
}

impl Sample {
    /// The point (x, y).
    #[must_use]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y, range: None }
    }

    /// With an error bar between two values of y.
    #[must_use]
    pub const fn between(mut self, low: f64, high: f64) -> Self {
        self.range = Some([low, high]);
        self
    }
}

impl From<[f64; 2]> for Sample {
    fn from([x, y]: [f64; 2]) -> Self {
        Self::new(x, y)
    }
}

impl From<(f64, f64)> for Sample {
    fn from((x, y): (f64, f64)) -> Self {
        Self::new(x, y)
    }
}

/// A series of points with a name.
#[derive(Clone, PartialEq, Debug)]
pub struct Series {
    pub(super) name: String,
    pub(super) role: Role,
    pub(super) samples: Vec<Sample>,
    pub(super) joined: bool,
}

/// The roles of series, in turn.
const ROLES: [Role; 8] =
    [Role::Main, Role::Secondary, Role::Start, Role::Goal, Role::Event, Role::Wrong, Role::Right, Role::Plain];

impl Series {
    pub(super) fn new(name: &str, samples: Vec<Sample>, number: usize) -> Self {
        Self { name: text::clean(name), role: ROLES[number % ROLES.len()], samples, joined: true }
    }

    /// Colour, dash and mark. Default: a different role for each of the first eight series.
    pub fn role(&mut self, role: Role) -> &mut Self {
        self.role = role;
        self
    }

    /// Marks without a line between them.
    pub fn points_only(&mut self) -> &mut Self {
        self.joined = false;
        self
    }
}

/// How something may grow with n.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Growth {
    /// 1
    Constant,
    /// log n
    Log,
    /// √n
    Root,
    /// n
    Linear,
    /// n log n
    NLogN,
    /// n²
    Quadratic,
    /// n³
    Cubic,
}

impl Growth {
    /// What it is called.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Constant => "constant",
            Self::Log => "log n",
            Self::Root => "√n",
            Self::Linear => "n",
            Self::NLogN => "n log n",
            Self::Quadratic => "n²",
            Self::Cubic => "n³",
        }
    }

    /// Its value, if it has one.
    pub(super) fn at(self, n: f64) -> Option<f64> {
        Some(match self {
            Self::Constant => 1.0,
            Self::Log => log2(n)?,
            Self::Root => n.sqrt(),
            Self::Linear => n,
            Self::NLogN => n * log2(n)?,
            Self::Quadratic => n * n,
            Self::Cubic => n * n * n,
        })
    }
}

/// A line of some growth through a point.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Reference {
    pub(super) growth: Growth,
    pub(super) through: [f64; 2],
}

impl Reference {
    pub(super) fn at(&self, x: f64) -> Option<f64> {
        let y = self.through[1] * self.growth.at(x)? / self.growth.at(self.through[0])?;
        y.is_finite().then_some(y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn references_grow_as_they_are_called() {
        let at = |growth, x| Reference { growth, through: [2.0, 10.0] }.at(x).unwrap();
        for (growth, at_eight) in [
            (Growth::Constant, 10.0),
            (Growth::Log, 30.0),
            (Growth::Root, 20.0),
            (Growth::Linear, 40.0),
            (Growth::NLogN, 120.0),
            (Growth::Quadratic, 160.0),
            (Growth::Cubic, 640.0),
        ] {
            assert!((at(growth, 8.0) - at_eight).abs() < 1e-9, "{growth:?}: {}", at(growth, 8.0));
        }
        assert_eq!(Reference { growth: Growth::Log, through: [1.0, 5.0] }.at(8.0), None, "log 1 = 0");
        assert_eq!(Reference { growth: Growth::Log, through: [2.0, 5.0] }.at(0.0), None);
    }
}
