//! `dcel lab export --course`: all that a course hands out, uploads and shows.
//!
//! ```text
//!   OUT/
//!     README.md        what each folder is for, and who may see it
//!     site/            for students: nothing in it is secret
//!       index.html  style.css  course.toml  course.zip
//!       04-half-edge/index.html  figures/   the handout
//!       04-half-edge.zip                    the folder of a student
//!     classroom50/04-half-edge.zip          can be read by everybody, too
//!     gradescope/04-half-edge.zip           the hidden cases are inside
//! ```

use super::super::super::input::text_of;
use super::super::super::{Failure, Output};
use super::super::{folder, kit};
use super::page::{self, Page, escaped};
use super::{of_kit, packed};
use dcel_lab::course::{Course, CourseLab, SharedCourse};
use dcel_lab::{CourseFiles, Kit, LabFiles, Packed, Points, classroom50_files, gradescope_files};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::Write;
use std::path::Path;

/// What is exported, and with which kit.
pub(super) struct Export<'a> {
    pub(super) file: &'a Path,
    pub(super) labs: Option<&'a Path>,
    pub(super) kit: &'a Kit,
    pub(super) vendor: bool,
}

/// A lab of the course with its files.
struct Of<'a> {
    terms: &'a CourseLab,
    files: LabFiles,
}

impl Export<'_> {
    /// Writes everything into a folder that does not exist yet.
    pub(super) fn write(&self, to: &Path, out: &mut Output) -> Result<(), Failure> {
        let wrong = |error| Failure::input(error, "see the worked course.toml in labs/README.md");
        let course = Course::read(self.file).map_err(wrong)?;
        let shared = SharedCourse::read(self.file).map_err(wrong)?;
        let labs: Vec<Of> = course.labs.iter().map(Of::new).collect::<Result<_, _>>()?;

        let mut files: BTreeMap<String, Packed> = BTreeMap::new();
        files.insert("README.md".to_owned(), readme(&course).into());
        let mut everything = BTreeMap::new();
        for (number, lab) in labs.iter().enumerate() {
            let name = lab.files.name();
            let student = folder::files(&lab.files, self.kit, self.vendor)?;
            let inside = student.into_iter().map(|(path, file)| (format!("{name}/{path}"), file));
            let student: BTreeMap<String, Packed> = inside.collect();
            files.insert(format!("site/{name}.zip"), packed(&student)?);
            everything.extend(student);

            let sources = kit::program_sources;
            let private = self.private(&shared, number, lab)?;
            let grader = of_kit(gradescope_files(name, self.kit, sources(), Some(&private)))?;
            files.insert(format!("gradescope/{name}.zip"), packed(&grader)?);
            let public = Some(shared.for_public_grader(number));
            let grader = of_kit(classroom50_files(name, self.kit, sources(), public))?;
            files.insert(format!("classroom50/{name}.zip"), packed(&grader)?);
        }
        let students: Packed = shared.for_students().into();
        everything.insert("course.toml".to_owned(), students.clone());
        files.insert("site/course.zip".to_owned(), packed(&everything)?);
        files.insert("site/course.toml".to_owned(), students);
        files.extend(site(&course, &labs));
        folder::make(to, &files)?;

        let dir = to.display();
        let s = if labs.len() == 1 { "" } else { "s" };
        writeln!(out, "{dir}: {}, {} lab{s}", course.title, labs.len())?;
        writeln!(out, "  {dir}/site/index.html    the course page, with all handouts and what students download")?;
        writeln!(out, "  {dir}/gradescope/        an autograder each, to upload; hidden cases are inside")?;
        writeln!(out, "  {dir}/classroom50/       an autograder each, for CLASSROOM/autograders/ASSIGNMENT/")?;
        Ok(())
    }

    /// What only the instructor's grader has.
    fn private(&self, shared: &SharedCourse, number: usize, lab: &Of) -> Result<CourseFiles, Failure> {
        let name = lab.files.name();
        let secret = lab.terms.secret.as_ref().map(|(file, _)| text_of(file, "put the secret back"));
        let mut known = BTreeMap::new();
        if lab.terms.own_tests > Points::ZERO {
            let there = super::super::verify::labs(self.labs, &[name.to_owned()])?.join(name);
            let whole = super::super::verify::read(&there)?.files;
            known = whole.iter().map(|(path, text)| (format!("{name}/{path}"), text.to_owned())).collect();
            known.insert(format!("{name}/README.md"), whole.handout());
        }
        Ok(CourseFiles {
            course: shared.for_grader(number),
            secret: secret.transpose()?,
            lab: known,
            is_due: lab.terms.due.is_some(),
        })
    }
}

fn readme(course: &Course) -> String {
    format!(
        "# {}\n\n\
         | folder | what it is | who may have it |\n|---|---|---|\n\
         | `site/` | the course page with all handouts, and what students download: put it on any web server, or hand it \
         out as it is | everybody |\n\
         | `classroom50/` | for each lab what belongs in `CLASSROOM/autograders/ASSIGNMENT/` of Classroom 50; it has no \
         hidden cases, no dates (Classroom 50 knows them), and does not count own tests | everybody |\n\
         | `gradescope/` | for each lab the archive to upload as the autograder; it has the hidden cases and, where own \
         tests give points, the known mistakes | instructors |\n\n\
         After a change of the course file, export again and upload the autograders again.\n",
        course.title
    )
}

/// The pages with what they show.
fn site(course: &Course, labs: &[Of]) -> BTreeMap<String, Packed> {
    let mut files: BTreeMap<String, Packed> = BTreeMap::new();
    files.insert("site/style.css".to_owned(), page::CSS.to_owned().into());
    let body = index(course, labs);
    let index = Page { title: &course.title, up: "", ways: "", body: &body };
    files.insert("site/index.html".to_owned(), index.html().into());
    for (number, lab) in labs.iter().enumerate() {
        let name = lab.files.name();
        for (path, text) in lab.files.iter().filter(|(path, _)| path.starts_with("figures/")) {
            files.insert(format!("site/{name}/{path}"), text.to_owned().into());
        }
        let handout = lab.files.handout();
        let leads = |to: &str| leads(to, labs, &lab.files);
        let text = page::of_markdown(&handout, &leads, &|figure| lab.files.get(figure).and_then(drawn_width));
        let body = format!("{}{text}", about(lab));
        let mut ways = format!("<a href=\"../index.html\">{}</a>", escaped(&course.title));
        let neighbours = [("Before", number.checked_sub(1)), ("Next", Some(number + 1))];
        for (word, other) in neighbours {
            if let Some(other) = other.and_then(|other| labs.get(other)) {
                let (name, title) = (other.files.name(), escaped(&other.title()));
                let _ = write!(ways, "\n<a href=\"../{name}/index.html\">{word}: {title}</a>");
            }
        }
        let title = format!("{}, {}", lab.title(), course.title);
        let page = Page { title: &title, up: "../", ways: &ways, body: &body };
        files.insert(format!("site/{name}/index.html"), page.html().into());
    }
    files
}

impl<'a> Of<'a> {
    fn new(terms: &'a CourseLab) -> Result<Self, Failure> {
        Ok(Self { terms, files: super::super::bundled(&terms.name)? })
    }

    fn title(&self) -> String {
        page::title(&self.files.handout()).unwrap_or_else(|| self.terms.manifest.title.clone())
    }

    fn due(&self) -> Option<String> {
        self.terms.due.map(|due| due.to_string())
    }
}

/// Where a link of a handout leads on the site: to a figure that is there, or to the handout of another lab.
fn leads(to: &str, labs: &[Of], files: &LabFiles) -> Option<String> {
    let (path, part) = to.split_once('#').map_or((to, String::new()), |(path, part)| (path, format!("#{part}")));
    if files.get(path).is_some() && path.starts_with("figures/") {
        return Some(to.to_owned());
    }
    let other = path.strip_prefix("../")?.strip_suffix("/README.md")?;
    let is_there = labs.iter().any(|lab| lab.files.name() == other);
    is_there.then(|| format!("../{other}/index.html{part}"))
}

/// The width that a drawing says it has.
fn drawn_width(svg: &str) -> Option<f64> {
    let tag = svg.get(svg.find("<svg")?..)?;
    let tag = tag.get(..tag.find('>')?)?;
    tag.split_once(" width=\"")?.1.split_once('"')?.0.parse().ok()
}

/// What stands above a handout: when it is due, and where its folder is.
fn about(lab: &Of) -> String {
    let name = lab.files.name();
    let due = lab.due().map_or_else(String::new, |due| format!("Due {}. ", escaped(&due)));
    let needs = needs(lab);
    let needs = if needs.is_empty() { needs } else { format!("Comes after {needs}. ") };
    format!(
        "<p>{due}{needs}{} points. <a href=\"../{name}.zip\" download>Your folder, {name}.zip</a></p>\n",
        lab.terms.manifest.max_points()
    )
}

fn needs(lab: &Of) -> String {
    let link = |name: &String| format!("<a href=\"../{name}/index.html\">{}</a>", escaped(name));
    lab.terms.needs.iter().map(link).collect::<Vec<_>>().join(", ")
}

fn index(course: &Course, labs: &[Of]) -> String {
    let title = escaped(&course.title);
    let mut out = format!(
        "<h1>{title}</h1>\n<p><a href=\"course.zip\" download>All labs in one archive, course.zip</a>. Unpack it, go into \
         the folder of a lab, and say <code>cargo test</code>; you need Rust (<code>rustup</code>). With the program \
         <code>dcel</code> at hand, <code>dcel lab</code> in the unpacked folder tells how far you are.</p>\n\
         <div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"The labs\">\n<table>\n<thead><tr><th>Lab</th>\
         <th class=\"number\">Points</th><th class=\"number\">Share</th><th>Due</th><th>Folder</th></tr></thead>\n<tbody>\n"
    );
    let all: f64 = labs.iter().map(|lab| lab.terms.weight.as_f64()).sum();
    for lab in labs {
        let (name, terms) = (lab.files.name(), lab.terms);
        let share = if all > 0.0 { format!("{:.1} %", 100.0 * terms.weight.as_f64() / all) } else { String::new() };
        let _ = writeln!(
            out,
            "<tr><td><a href=\"{name}/index.html\">{}</a></td><td class=\"number\">{}</td><td class=\"number\">{share}</td>\
             <td>{}</td><td class=\"file\"><a href=\"{name}.zip\" download>{name}.zip</a></td></tr>",
            escaped(&lab.title()),
            terms.manifest.max_points(),
            escaped(&lab.due().unwrap_or_else(|| "—".to_owned())),
        );
    }
    out.push_str("</tbody>\n</table>\n</div>\n");
    let rule = |lab: &Of| lab.terms.due.and(lab.terms.late.as_ref()).map(dcel_lab::course::LateRule::sentence);
    let mut rules: Vec<(String, Vec<String>)> = Vec::new();
    for lab in labs {
        let Some(rule) = rule(lab) else { continue };
        match rules.iter_mut().find(|(other, _)| *other == rule) {
            Some((_, of)) => of.push(lab.title()),
            None => rules.push((rule, vec![lab.title()])),
        }
    }
    if !rules.is_empty() {
        out.push_str("<h2 id=\"late\">What lateness costs</h2>\n");
    }
    let alone = rules.len() == 1;
    for (rule, of) in rules {
        let of = if alone { String::new() } else { format!("{}: ", escaped(&of.join(", "))) };
        let _ = writeln!(out, "<p>{of}{}</p>", escaped(&rule));
    }
    out
}
