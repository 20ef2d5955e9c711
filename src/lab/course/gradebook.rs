//! The grades of all labs of a course together.
//!
//! ```text
//!                   01-predicates   04-half-edge   course
//!   weight                      1              2
//!   anna               90 of 100     100 of 105    93.49 %     = (1 * 90/100 + 2 * 100/105) / (1 + 2)
//!   ben                         -      62 of 105   39.37 %     nothing handed in counts as nothing
//! ```

use super::Course;
use crate::reports::rows;
use crate::{Points, Report, Verdict};
use std::collections::BTreeMap;

/// A row for each student, a column for each lab that was graded.
#[derive(Clone, PartialEq, Debug)]
pub struct Gradebook {
    /// In the order of the course.
    pub labs: Vec<GradedLab>,
    /// By name.
    pub students: Vec<StudentGrades>,
}

/// A column.
#[derive(Clone, PartialEq, Debug)]
pub struct GradedLab {
    /// As its folder is called.
    pub name: String,
    /// How much it counts.
    pub weight: Points,
    /// The points of its graded tests and of own tests.
    pub max_points: Points,
}

/// A row.
#[derive(Clone, PartialEq, Debug)]
pub struct StudentGrades {
    /// As the reports call the student.
    pub name: String,
    /// One for each lab of the book.
    pub grades: Vec<LabGrade>,
}

/// What a student has in a lab.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LabGrade {
    /// There is no report: it counts as no points.
    Missing,
    /// After lateness, adjustments and bounds.
    Points(Points),
    /// The grader failed, so there is no grade yet, and none of the course.
    Unknown,
}

impl LabGrade {
    fn words(self) -> Option<String> {
        match self {
            Self::Missing => Some("-".to_owned()),
            Self::Points(points) => Some(points.to_string()),
            Self::Unknown => None,
        }
    }
}

/// Why there is no book of grades.
#[derive(Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GradebookError {
    /// A report of a lab that the course does not have.
    #[error("a report of {lab}, which the course does not have; it has {known}")]
    OtherLab {
        /// The lab.
        lab: String,
        /// Those of the course.
        known: String,
    },
    /// A student stands twice in the reports of a lab.
    #[error("two reports on {student} of {lab}: {points}")]
    Twice {
        /// The student.
        student: String,
        /// The lab.
        lab: String,
        /// What each of them gives.
        points: String,
    },
    /// A report that does not say who handed in.
    #[error("a report of {lab} does not say who handed in")]
    Nobody {
        /// The lab.
        lab: String,
    },
}

impl Gradebook {
    /// Puts the reports of all graded labs together, settled by the course as it is now. Labs without any report are
    /// not in the book.
    ///
    /// # Errors
    /// [`GradebookError`].
    pub fn new(course: &Course, reports: &[Report]) -> Result<Self, GradebookError> {
        let mut grades: BTreeMap<&str, BTreeMap<&str, LabGrade>> = BTreeMap::new();
        let mut graded = Vec::new();
        for report in reports {
            let Some(lab) = course.lab(&report.lab) else {
                let known: Vec<&str> = course.labs.iter().map(|lab| lab.name.as_str()).collect();
                return Err(GradebookError::OtherLab { lab: report.lab.clone(), known: known.join(", ") });
            };
            let Some(student) = report.submission.as_deref() else {
                return Err(GradebookError::Nobody { lab: lab.name.clone() });
            };
            let grade = if report.verdict == Verdict::GraderFault {
                LabGrade::Unknown
            } else {
                let mut settled = report.without_details();
                lab.settle(&mut settled);
                LabGrade::Points(settled.points())
            };
            if let Some(other) = grades.entry(student).or_default().insert(&lab.name, grade) {
                let points =
                    [other, grade].map(|grade| grade.words().unwrap_or_else(|| "none".to_owned())).join(" and ");
                let (student, lab) = (student.to_owned(), lab.name.clone());
                return Err(GradebookError::Twice { student, lab, points });
            }
            graded.push(lab.name.as_str());
        }
        let labs: Vec<GradedLab> = course
            .labs
            .iter()
            .filter(|lab| graded.contains(&lab.name.as_str()))
            .map(|lab| GradedLab {
                name: lab.name.clone(),
                weight: lab.weight,
                max_points: lab.manifest.max_points() + lab.own_tests,
            })
            .collect();
        let of_lab = |of: &BTreeMap<&str, LabGrade>, lab: &GradedLab| {
            of.get(lab.name.as_str()).copied().unwrap_or(LabGrade::Missing)
        };
        let students = grades
            .iter()
            .map(|(name, of)| StudentGrades {
                name: (*name).to_owned(),
                grades: labs.iter().map(|lab| of_lab(of, lab)).collect(),
            })
            .collect();
        Ok(Self { labs, students })
    }

    /// The share of all that can be had, by the weights of the labs in the book, 1 for all; `None` if a grade is not
    /// known, or if no lab of the book counts.
    #[must_use]
    pub fn share(&self, student: &StudentGrades) -> Option<f64> {
        let mut sum = 0.0;
        for (lab, grade) in self.labs.iter().zip(&student.grades) {
            let points = match grade {
                LabGrade::Unknown => return None,
                LabGrade::Missing => Points::ZERO,
                LabGrade::Points(points) => *points,
            };
            if lab.max_points > Points::ZERO {
                sum += lab.weight.as_f64() * points.as_f64() / lab.max_points.as_f64();
            }
        }
        let weights: f64 = self.labs.iter().map(|lab| lab.weight.as_f64()).sum();
        (weights > 0.0).then(|| sum / weights)
    }

    /// A row for each student, for a spreadsheet: the points of each lab, then the course in percent. A cell is empty
    /// where no grade is known.
    #[must_use]
    pub fn to_csv(&self) -> String {
        let column = |lab: &GradedLab| format!("{} (of {})", lab.name, lab.max_points);
        let columns: Vec<String> = self.labs.iter().map(column).collect();
        let mut head = vec!["student"];
        head.extend(columns.iter().map(String::as_str));
        head.push("course (%)");
        let row = |student: &StudentGrades| {
            let points = student.grades.iter().map(|grade| match grade {
                LabGrade::Missing => "0".to_owned(),
                grade => grade.words().unwrap_or_default(),
            });
            let name = std::iter::once(student.name.clone());
            name.chain(points).chain([self.percent(student).unwrap_or_default()]).collect()
        };
        rows(&head, self.students.iter().map(row).collect())
    }

    /// The same for a terminal.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut table: Vec<Vec<String>> = Vec::new();
        let labs = self.labs.iter();
        let line = |first: &str, cells: Vec<String>, last: &str| {
            let ends = (std::iter::once(first.to_owned()), std::iter::once(last.to_owned()));
            ends.0.chain(cells).chain(ends.1).collect()
        };
        table.push(line("", labs.clone().map(|lab| lab.name.clone()).collect(), "course"));
        table.push(line("of", labs.clone().map(|lab| lab.max_points.to_string()).collect(), "100 %"));
        table.push(line("weight", labs.map(|lab| lab.weight.to_string()).collect(), ""));
        for student in &self.students {
            let cells = student.grades.iter().map(|grade| grade.words().unwrap_or_else(|| "?".to_owned())).collect();
            let percent = self.percent(student).map_or_else(|| "?".to_owned(), |percent| format!("{percent} %"));
            table.push(line(&student.name, cells, &percent));
        }
        let width = |column: usize| table.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..self.labs.len() + 2).map(width).collect();
        let mut out = String::new();
        for row in &table {
            let cells = row.iter().zip(&widths).enumerate().map(|(i, (cell, width))| {
                // By hand: a width in a format string ends at 65,535.
                let blanks = " ".repeat(width - cell.chars().count());
                if i == 0 { format!("{cell}{blanks}") } else { format!("{blanks}{cell}") }
            });
            out += cells.collect::<Vec<_>>().join("  ").trim_end();
            out.push('\n');
        }
        out
    }

    fn percent(&self, student: &StudentGrades) -> Option<String> {
        Some(format!("{:.2}", 100.0 * self.share(student)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Lab;
    use std::fs;

    fn course(text: &str) -> Course {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("course.toml");
        fs::write(&file, text).unwrap();
        Course::read(&file).unwrap()
    }

    const COURSE: &str = "title = \"x\"\n[[lab]]\nname = \"02\"\n[[lab]]\nname = \"03\"\n[[lab]]\nname = \"04\"\n\
                          weight = 3\nown_tests = 25\nmost = 110\n";

    /// A report that gives the points of the first tests, up to a sum.
    fn report(lab: &str, student: &str, up_to: i32) -> Report {
        let lab = Lab::bundled(lab).unwrap();
        let mut report = Report::untested(&lab.manifest, Verdict::Wrong, "x");
        report.message = None;
        report.submission = Some(student.to_owned());
        let mut sum = Points::ZERO;
        for test in &mut report.tests {
            if sum + test.max_points <= Points::from(up_to) {
                sum = sum + test.max_points;
                (test.verdict, test.points) = (Verdict::Passed, test.max_points);
            }
        }
        report
    }

    #[test]
    fn labs_count_by_their_weights_and_what_is_missing_counts_as_nothing() {
        let course = course(COURSE);
        let mut late = report("04-half-edge", "ben", 100);
        late.adjustments.push(crate::Adjustment { reason: "late".to_owned(), points: "-37.5".parse().unwrap() });
        let mut failed = report("02-triangulation", "=cara", 0);
        failed.verdict = Verdict::GraderFault;
        let reports = [report("04-half-edge", "anna", 100), report("02-triangulation", "anna", 0), late, failed];
        let book = Gradebook::new(&course, &reports).unwrap();
        // Lab 03 was not graded yet. Own tests can give 25 more in lab 04.
        assert_eq!(book.labs.iter().map(|lab| lab.max_points).collect::<Vec<_>>(), [100, 125]);
        let shares: Vec<Option<f64>> = book.students.iter().map(|student| book.share(student)).collect();
        // cara has no grade yet; anna has 3/4 of 100/125 = 0.6, ben 3/4 of 62.5/125 = 0.375.
        assert_eq!(shares[0], None);
        assert!((shares[1].unwrap() - 0.6).abs() < 1e-12 && (shares[2].unwrap() - 0.375).abs() < 1e-12, "{shares:?}");
        assert_eq!(
            book.to_csv(),
            "student,02-triangulation (of 100),04-half-edge (of 125),course (%)\n'=cara,,0,\nanna,0,100,60.00\n\
             ben,0,62.5,37.50\n"
        );
        assert_eq!(
            book.to_text(),
            "        02-triangulation  04-half-edge   course\nof                   100           125    100 %\n\
             weight                 1             3\n=cara                  ?             -        ?\n\
             anna                   0           100  60.00 %\nben                    -          62.5  37.50 %\n"
        );
    }

    #[test]
    fn a_name_of_any_length_keeps_its_line() {
        let name = "x".repeat(70_000);
        let book = Gradebook::new(&course(COURSE), &[report("04-half-edge", &name, 100)]).unwrap();
        let text = book.to_text();
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines[3].starts_with(&name) && lines[3].ends_with(" %"), "{}", &lines[3][70_000..]);
        assert!(lines.iter().all(|line| line.len() <= lines[3].len()));
    }

    #[test]
    fn a_changed_course_counts() {
        let reports = [report("04-half-edge", "anna", 100)];
        let book = Gradebook::new(&course(&COURSE.replace("110", "80")), &reports).unwrap();
        assert_eq!(book.students[0].grades, [LabGrade::Points(Points::from(80))]);
    }

    #[test]
    fn what_does_not_fit_together_is_named() {
        let course = course(COURSE);
        let error = |reports: &[Report]| Gradebook::new(&course, reports).unwrap_err().to_string();
        let one = report("03-convex-hulls", "anna", 100);
        let other = report("03-convex-hulls", "anna", 0);
        assert_eq!(error(&[one.clone(), other]), "two reports on anna of 03-convex-hulls: 100 and 0");
        let foreign = report("01-predicates", "anna", 0);
        let known = "it has 02-triangulation, 03-convex-hulls, 04-half-edge";
        assert_eq!(error(&[foreign]), format!("a report of 01-predicates, which the course does not have; {known}"));
        let nobody = Report { submission: None, ..one };
        assert_eq!(error(&[nobody]), "a report of 03-convex-hulls does not say who handed in");
    }
}
