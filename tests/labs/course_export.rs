//! What `dcel lab export --course` writes: pages whose links lead somewhere, autograders with the terms of the course,
//! and no secret where students can look.

use crate::shell::Folder;
use roxmltree::Document;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Read;
use std::path::Path;

const COURSE: &str = r#"title = "Geometry & graphs <1>"   # the key is under the mat
utc_offset = "+02:00"
[late]
every = "day"
takes = "10 %"
[[lab]]
name = "02"
due = 2026-10-05
secret = "hidden/two.toml"
[[lab]]
name = "03"
[[lab]]
name = "half-edge"
weight = 2
due = 2026-10-12T23:59:00
needs = ["02-triangulation"]
secret = "hidden/four.toml"
own_tests = 5
[lab.test]
face_walk = { points = 7.5 }
face_vertices = { points = "9/2" }
"#;

const LABS: [&str; 3] = ["02-triangulation", "03-convex-hulls", "04-half-edge"];

fn course() -> Folder {
    let shell = Folder::new();
    shell.write("course.toml", COURSE);
    fs::create_dir(shell.path("hidden")).unwrap();
    shell.write("hidden/two.toml", "seed = 246813579\n");
    shell.write("hidden/four.toml", "seed = 135792468\n");
    shell
}

/// The folder `labs` of this checkout.
fn labs() -> String {
    format!("{}/../../labs", env!("CARGO_MANIFEST_DIR"))
}

/// The files below a folder; of an archive what is in it, as `ARCHIVE/PATH`.
fn files(root: &Path, prefix: &str, found: &mut BTreeMap<String, Vec<u8>>) {
    for entry in fs::read_dir(root).unwrap() {
        let entry = entry.unwrap();
        let path = format!("{prefix}{}", entry.file_name().to_string_lossy());
        if entry.file_type().unwrap().is_dir() {
            files(&entry.path(), &format!("{path}/"), found);
        } else if path.ends_with(".zip") {
            let mut archive = zip::ZipArchive::new(fs::File::open(entry.path()).unwrap()).unwrap();
            for i in 0..archive.len() {
                let mut file = archive.by_index(i).unwrap();
                let mut bytes = Vec::new();
                file.read_to_end(&mut bytes).unwrap();
                found.insert(format!("{path}/{}", file.name().unwrap()), bytes);
            }
        } else {
            found.insert(path, fs::read(entry.path()).unwrap());
        }
    }
}

fn exported(shell: &Folder) -> BTreeMap<String, Vec<u8>> {
    shell.dcel(&format!("lab export --course course.toml --out out --labs {}", labs())).fine();
    let mut found = BTreeMap::new();
    files(&shell.path("out"), "", &mut found);
    found
}

fn text(files: &BTreeMap<String, Vec<u8>>, path: &str) -> String {
    let bytes = files.get(path).unwrap_or_else(|| panic!("{path} is not there: {:?}", files.keys().take(9)));
    String::from_utf8(bytes.clone()).unwrap()
}

/// All that is wrong with the links of a page, which must be XML but for the line `<!DOCTYPE html>` and what HTML
/// leaves open.
fn wrong_links(files: &BTreeMap<String, Vec<u8>>, archives: &BTreeSet<String>, path: &str) -> Vec<String> {
    let mut page = text(files, path);
    for open in ["meta", "link", "img", "br", "hr"] {
        page = page.replace(&format!("<{open} "), &format!("<{open}-open "));
        page = page.replace(&format!("<{open} />"), "");
    }
    let closed: String = page
        .split_inclusive('>')
        .map(|tag| {
            let is_open = tag.rfind('<').is_some_and(|at| tag[at..].contains("-open ") && !tag.ends_with("/>"));
            if is_open { format!("{}/>", &tag[..tag.len() - 1]) } else { tag.to_owned() }
        })
        .collect();
    let closed = closed.replacen("<!DOCTYPE html>", "", 1).replace(" download>", " download=\"\">");
    let document = Document::parse(&closed).unwrap_or_else(|error| panic!("{path}: {error}"));
    let all = || document.descendants().filter(roxmltree::Node::is_element);
    let ids: Vec<&str> = all().filter_map(|node| node.attribute("id")).collect();
    let mut wrong: Vec<String> = Vec::new();
    let unique: BTreeSet<&str> = ids.iter().copied().collect();
    if unique.len() != ids.len() {
        wrong.push(format!("an id twice in {ids:?}"));
    }
    let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
    for link in all().filter_map(|node| node.attribute("href").or(node.attribute("src"))) {
        let (to, part) = link.split_once('#').map_or((link, None), |(to, part)| (to, Some(part)));
        let mut there: Vec<&str> = folder.split('/').collect();
        for step in to.split('/').filter(|step| !step.is_empty()) {
            if step == ".." {
                there.pop();
            } else {
                there.push(step);
            }
        }
        let there = there.join("/");
        let leads = match part {
            _ if link.starts_with("https://") => true,
            Some(part) if to.is_empty() => unique.contains(part),
            Some(part) => {
                files.get(&there).is_some_and(|page| String::from_utf8_lossy(page).contains(&format!("id=\"{part}\"")))
            }
            None => files.contains_key(&there) || archives.contains(&there),
        };
        if !leads {
            wrong.push(format!("{link} leads nowhere"));
        }
    }
    wrong
}

#[test]
fn the_page_of_a_course_has_every_handout_and_no_link_that_leads_nowhere() {
    let files = exported(&course());
    let archives: BTreeSet<String> =
        files.keys().filter_map(|path| Some(format!("{}.zip", path.split_once(".zip/")?.0))).collect();
    let pages: Vec<&String> =
        files.keys().filter(|path| path.starts_with("site/") && path.ends_with("/index.html")).collect();
    assert_eq!(pages.len(), 4, "{pages:?}");
    for page in pages {
        assert_eq!(wrong_links(&files, &archives, page), [""; 0], "{page}");
        let html = text(&files, page);
        assert!(!html.contains("<script") && !html.contains("src=\"http"), "{page} needs something from outside");
    }
    let index = text(&files, "site/index.html");
    assert!(index.contains("<h1>Geometry &amp; graphs &lt;1&gt;</h1>"));
    // The heaviest lab is half of the course.
    assert!(index.contains("50.0 %") && index.contains("25.0 %"), "{index}");
    assert!(index.contains("takes 10 % of what was earned"));
    let handout = text(&files, "site/04-half-edge/index.html");
    for part in [
        "<h2 id=\"splitting-a-face\">Splitting a face</h2>",
        "Due 2026-10-12 23:59:00+02:00",
        "<a href=\"../02-triangulation/index.html\">02-triangulation</a>",
        "<a href=\"figures/records.svg\" title=\"The drawing alone\"><img src=\"figures/records.svg\" alt=",
        "--drawn: ",
    ] {
        assert!(handout.contains(part), "{part}");
    }
    // A file of the student's folder is named, and not linked.
    assert!(!handout.contains("href=\"answers.md\"") && handout.contains("answers.md"));
}

#[test]
fn secrets_lie_in_the_instructors_graders_and_nowhere_else() {
    let files = exported(&course());
    for (path, bytes) in &files {
        let text = String::from_utf8_lossy(bytes);
        let is_private = path.starts_with("gradescope/");
        for secret in ["246813579", "135792468", "hidden/", "under the mat"] {
            // The sources of the kit may have such words of their own.
            let found = !path.contains("/kit/") && text.contains(secret);
            assert!(!found || is_private && secret.ends_with(|c: char| c.is_ascii_digit()), "{path}: {secret}");
        }
        let is_solution = path.contains("/solution/") && !path.contains("/template/");
        assert!(!is_solution || path.starts_with("gradescope/04-half-edge.zip/labs/04-half-edge/"), "{path}");
    }
    assert_eq!(text(&files, "gradescope/02-triangulation.zip/secret.toml"), "seed = 246813579\n");
    assert_eq!(text(&files, "gradescope/04-half-edge.zip/secret.toml"), "seed = 135792468\n");
    assert!(!files.contains_key("gradescope/03-convex-hulls.zip/secret.toml"));
    let call = |lab: &str| {
        let run = text(&files, &format!("gradescope/{lab}.zip/run_autograder"));
        run.lines().find(|line| line.starts_with("dcel grade")).unwrap().to_owned()
    };
    assert!(
        call("04-half-edge").contains("--metadata /autograder/submission_metadata.json --own /autograder/source/labs ")
    );
    assert!(call("02-triangulation").contains("--metadata ") && !call("02-triangulation").contains("--own"));
    // Without a due date, no time matters.
    assert!(call("03-convex-hulls").contains("--course /autograder/source/course.toml --report"));
}

#[test]
fn the_graders_and_the_students_read_what_they_get() {
    let shell = course();
    let files = exported(&shell);
    for system in ["gradescope", "classroom50"] {
        fs::create_dir(shell.path(system)).unwrap();
    }
    for lab in LABS {
        for system in ["gradescope", "classroom50"] {
            let path = format!("{system}/{lab}.zip/course.toml");
            shell.write(&format!("{system}/course.toml"), &text(&files, &path));
            if let Some(secret) = files.get(&format!("{system}/{lab}.zip/secret.toml")) {
                shell.write(&format!("{system}/secret.toml"), &String::from_utf8_lossy(secret));
            }
            let of = dcel_lab::course::Course::read(&shell.path(&format!("{system}/course.toml"))).unwrap();
            assert_eq!((of.labs.len(), of.labs[0].name.as_str()), (1, lab));
            assert_eq!(of.labs[0].secret.is_some(), system == "gradescope" && lab != "03-convex-hulls");
            assert_eq!(of.labs[0].due.is_some(), system == "gradescope" && lab != "03-convex-hulls");
        }
    }
    // The folder with everything is the course of `dcel lab`.
    for (path, bytes) in &files {
        if let Some(path) = path.strip_prefix("site/course.zip/") {
            let to = shell.path(&format!("unpacked/{path}"));
            fs::create_dir_all(to.parent().unwrap()).unwrap();
            fs::write(to, bytes).unwrap();
        }
    }
    let told = shell.command("lab").current_dir(shell.path("unpacked")).output().unwrap();
    let told = String::from_utf8(told.stdout).unwrap();
    assert!(told.starts_with("Geometry & graphs <1>, in "), "{told}");
    assert!(told.contains("03-convex-hulls") && !told.contains("01-predicates"), "{told}");
}

#[test]
fn what_cannot_be_exported_is_said_and_nothing_is_written() {
    let shell = course();
    let export = "lab export --course course.toml --out out";
    shell.dcel(export).fails(2, "no labs are here", "name its folder with --labs DIR");
    shell.dcel(&format!("{export} --labs hidden")).fails(2, "04-half-edge is not there", "--labs DIR");
    assert!(!shell.path("out").exists());
    fs::create_dir(shell.path("out")).unwrap();
    shell.write("out/mine.txt", "kept\n");
    shell.dcel(&format!("{export} --labs {}", labs())).fails(2, "out: is not empty", "does not exist yet");
    assert_eq!(shell.read("out/mine.txt"), "kept\n");
    shell.write("course.toml", &COURSE.replace("name = \"03\"", "name = \"33\""));
    shell.dcel(&format!("{export}2")).fails(2, "course.toml:11:8: there is no lab `33`", "labs/README.md");
    shell.dcel("lab export --course no.toml --out out2").fails(2, "no.toml: ", "");
    assert!(!shell.path("out2").exists());
    for wrong in ["lab export", "lab export 04", "lab export --course course.toml", "lab export 04 --out x"] {
        assert_eq!(shell.dcel(wrong).code, Some(2), "{wrong}");
    }
}
