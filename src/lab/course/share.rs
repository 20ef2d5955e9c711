//! The file of a course as others may have it: without comments, and without where the hidden cases are.
//!
//! ```text
//!   course.toml ──┬─▶ students        all labs; no secrets
//!                 ├─▶ a grader        one lab; its secret lies beside it as `secret.toml`
//!                 └─▶ a public grader one lab; no secret, and no dates: the course system knows them
//! ```

use super::CourseError;
use crate::toml_file::TomlFile;
use std::path::Path;
use toml::{Table, Value};

/// Where a grader has the hidden cases, from the course file on.
pub const SECRET_BESIDE: &str = "secret.toml";

/// A course file that others get.
#[derive(Clone, PartialEq, Debug)]
pub struct SharedCourse {
    file: Table,
}

impl SharedCourse {
    /// Reads the file of a course. That it is one, [`Course::read`](super::Course::read) tells.
    ///
    /// # Errors
    /// [`CourseError`] if there is no such file, or if it is not TOML.
    pub fn read(path: &Path) -> Result<Self, CourseError> {
        let unreadable = |error| CourseError::Unreadable { path: path.to_owned(), error };
        let text = std::fs::read_to_string(path).map_err(unreadable)?;
        let file = TomlFile { text: &text, source: &path.display().to_string() }.read()?;
        Ok(Self { file })
    }

    /// For students: nothing tells where hidden cases are.
    #[must_use]
    pub fn for_students(&self) -> String {
        let mut file = self.file.clone();
        for lab in labs(&mut file) {
            lab.remove("secret");
        }
        file.to_string()
    }

    /// For a grader of lab number `lab` of the course, from 0, which only instructors can read.
    #[must_use]
    pub fn for_grader(&self, lab: usize) -> String {
        let mut file = self.alone(lab);
        for lab in labs(&mut file) {
            if let Some(secret) = lab.get_mut("secret") {
                *secret = Value::from(SECRET_BESIDE);
            }
        }
        file.to_string()
    }

    /// For a grader of that lab that everybody can read, in a course system that knows when something was handed in.
    /// Known mistakes are not there, so own tests are not counted.
    #[must_use]
    pub fn for_public_grader(&self, lab: usize) -> String {
        let mut file = self.alone(lab);
        file.remove("late");
        for lab in labs(&mut file) {
            for key in ["secret", "due", "late", "own_tests"] {
                lab.remove(key);
            }
        }
        file.to_string()
    }

    /// The course with this lab alone. The labs before it are not there, so it needs none of them.
    fn alone(&self, lab: usize) -> Table {
        let mut file = self.file.clone();
        if let Some(Value::Array(labs)) = file.get_mut("lab") {
            *labs = labs.drain(..).skip(lab).take(1).collect();
        }
        for lab in labs(&mut file) {
            lab.remove("needs");
        }
        file
    }
}

fn labs(file: &mut Table) -> impl Iterator<Item = &mut Table> {
    let labs = file.get_mut("lab").and_then(Value::as_array_mut);
    labs.into_iter().flatten().filter_map(Value::as_table_mut)
}

#[cfg(test)]
mod tests {
    use super::super::Course;
    use super::*;
    use std::fs;

    const WRITTEN: &str = r#"
title = "Geometry"                 # room 7, the key is under the mat
utc_offset = "+02:00"
[late]
every = "day"
takes = "1/3"
[[lab]]
name = "02"
due = 2026-10-05
secret = "away/two.toml"
[[lab]]
name = "half-edge"
due = 2026-10-12T23:59:00
needs = ["02-triangulation"]
secret = "away/four.toml"
own_tests = "20/3"
least = "1/2"
test.face_walk = { points = 7.5, visibility = "after_due_date" }
test.face_vertices = { points = 4.5 }
"#;

    #[test]
    fn what_others_get_is_the_course_without_its_secrets() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("away")).unwrap();
        fs::write(at("away/two.toml"), "seed = 2\n").unwrap();
        fs::write(at("away/four.toml"), "seed = 4\n").unwrap();
        fs::write(at("course.toml"), WRITTEN).unwrap();
        let whole = Course::read(&at("course.toml")).unwrap();
        let shared = SharedCourse::read(&at("course.toml")).unwrap();
        let read = |text: String| {
            assert!(!text.contains("away") && !text.contains("mat"), "{text}");
            fs::write(at("shared.toml"), text).unwrap();
            Course::read(&at("shared.toml"))
        };

        let students = read(shared.for_students()).unwrap();
        let without_secrets = |course: &Course| {
            let mut course = course.clone();
            course.labs.iter_mut().for_each(|lab| lab.secret = None);
            course
        };
        assert_eq!(students, without_secrets(&whole));

        fs::write(at(SECRET_BESIDE), "seed = 44\n").unwrap();
        let grader = read(shared.for_grader(1)).unwrap();
        assert_eq!(grader.labs.len(), 1);
        assert_eq!(grader.labs[0].secret.as_ref().unwrap().1.seed, 44);
        let mut expected = without_secrets(&whole).labs.remove(1);
        expected.needs.clear();
        assert_eq!(without_secrets(&grader).labs[0], expected);

        let public = read(shared.for_public_grader(1)).unwrap();
        (expected.due, expected.late, expected.own_tests) = (None, None, Default::default());
        assert_eq!(public.labs, [expected]);
    }
}
