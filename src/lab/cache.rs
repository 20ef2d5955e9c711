//! Reports kept from earlier runs, by the content of what was graded.
//!
//! ```text
//!   key = the judge itself, rustc, lab with all of its files, limits, seed and secret, barriers, the student's files
//!   FOLDER/HASH.json = key and report; the hash only finds the file, the whole key must agree
//!   FOLDER/seed      = the seed of the random cases, for those who do not say one
//! ```
//!
//! The judge itself is the running program, hashed whole: checks, cases, geometry, every library in it and the
//! compiler that made it. So a verdict is never taken from another build, whatever changed, and nothing has to be
//! told when something does. (A hash of the sources would miss the libraries and needs the sources at hand.)
//!
//! Nothing is kept of runs in which the grader or the machine had a part: a fault of the grader, and a deadline
//! unless it is asked for.

use super::{Report, Verdict};
use dcel_kit::files::write_whole;
use serde::{Deserialize, Serialize};
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// A folder of reports.
#[derive(Debug)]
pub(crate) struct Cache {
    folder: PathBuf,
    /// Whether runs that came to a deadline are kept, too.
    deadlines: bool,
    /// What was found in it that is no report.
    complaints: Mutex<Vec<String>>,
}

/// Everything that a report depends on.
#[derive(Clone, PartialEq, Eq, Hash, Debug, Serialize, Deserialize)]
pub(crate) struct Key {
    /// Kit, lab, versions, limits, barriers.
    pub(crate) grader: String,
    /// The seed and the secret, not to be read from the folder.
    pub(crate) plan: u64,
    /// The graded files: path and text.
    pub(crate) files: Vec<(String, String)>,
}

#[derive(Serialize, Deserialize)]
struct Entry {
    key: Key,
    report: Report,
}

impl Cache {
    /// The reports in a folder, which is made if it is not there.
    pub(crate) fn open(folder: &Path, deadlines: bool) -> io::Result<Self> {
        fs::create_dir_all(folder)?;
        Ok(Self { folder: folder.to_path_buf(), deadlines, complaints: Mutex::default() })
    }

    /// The report of an earlier run. What cannot be read is not there, and will be written anew; that is noted, for
    /// somebody else has been at the folder.
    pub(crate) fn get(&self, key: &Key) -> Option<Report> {
        let file = self.file(key);
        match serde_json::from_slice::<Entry>(&fs::read(&file).ok()?) {
            Ok(entry) => (entry.key == *key).then_some(entry.report),
            Err(error) => {
                let complaint = format!("{}: this is no kept report, and graded anew: {error}", file.display());
                self.complaints.lock().unwrap_or_else(PoisonError::into_inner).push(complaint);
                None
            }
        }
    }

    /// What was found that is no report.
    pub(crate) fn complaints(&self) -> Vec<String> {
        self.complaints.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// The seed that belongs to a folder: the one that is kept there, or else `fresh`, which is kept from now on.
    pub(crate) fn seed(folder: &Path, fresh: u64) -> io::Result<u64> {
        fs::create_dir_all(folder)?;
        let file = folder.join("seed");
        if let Some(seed) = fs::read_to_string(&file).ok().and_then(|text| text.trim().parse().ok()) {
            return Ok(seed);
        }
        write_whole(&file, format!("{fresh}\n").as_bytes())?;
        Ok(fresh)
    }

    /// Keeps a report. Whatever goes wrong, it can be made again. Written beside and moved, so that two graders with
    /// one folder never read half a report.
    pub(crate) fn put(&self, key: Key, report: &Report) {
        let depends = |verdict| match verdict {
            Verdict::GraderFault => true,
            Verdict::TimedOut => !self.deadlines,
            _ => false,
        };
        if depends(report.verdict) || report.tests.iter().any(|test| depends(test.verdict)) {
            return;
        }
        let file = self.file(&key);
        let Ok(text) = serde_json::to_vec(&Entry { key, report: report.clone() }) else { return };
        let _ = write_whole(&file, &text);
    }

    fn file(&self, key: &Key) -> PathBuf {
        self.folder.join(format!("{:016x}.json", hash_of(key)))
    }
}

/// A number for the running program and the one that puts the barriers up: another build, another number.
pub(crate) fn judge_itself(launcher: &Path) -> io::Result<String> {
    // What runs, even if its file has been replaced since it was started.
    let running = Path::new("/proc/self/exe");
    let running = if running.exists() { running.to_path_buf() } else { std::env::current_exe()? };
    let mut words = vec![env!("CARGO_PKG_VERSION").to_owned()];
    for file in [&running, launcher] {
        let mut reader = fs::File::open(file)?;
        let mut hasher = DefaultHasher::new();
        let mut chunk = vec![0; 1 << 16];
        let mut length = 0;
        while let n @ 1.. = reader.read(&mut chunk)? {
            hasher.write(&chunk[..n]);
            length += n;
        }
        words.push(format!("{:016x}+{length}", hasher.finish()));
    }
    Ok(words.join(" "))
}

/// A number for anything; the same in every run of one build of the kit.
pub(crate) fn hash_of(what: &impl Hash) -> u64 {
    let mut hasher = DefaultHasher::new();
    what.hash(&mut hasher);
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn report(verdict: Verdict) -> Report {
        Report {
            kit: "1".to_owned(),
            lab: "04".to_owned(),
            lab_version: "1".to_owned(),
            seed: 3,
            verdict,
            millis: 1,
            ..Report::default()
        }
    }

    #[test]
    fn a_report_is_found_by_all_that_it_depends_on() {
        let folder = tempfile::tempdir().unwrap();
        let cache = Cache::open(&folder.path().join("reports"), false).unwrap();
        let key = Key { grader: "a".to_owned(), plan: 1, files: vec![("src/lab.rs".to_owned(), "x".to_owned())] };
        assert_eq!(cache.get(&key), None);
        cache.put(key.clone(), &report(Verdict::Wrong));
        assert_eq!(cache.get(&key), Some(report(Verdict::Wrong)));
        for other in [
            Key { grader: "b".to_owned(), ..key.clone() },
            Key { plan: 2, ..key.clone() },
            Key { files: vec![("src/lab.rs".to_owned(), "y".to_owned())], ..key.clone() },
        ] {
            assert_eq!(cache.get(&other), None);
            // Not even where the hash of another key leads to it.
            fs::copy(cache.file(&key), cache.file(&other)).unwrap();
            assert_eq!(cache.get(&other), None);
        }
        assert!(cache.complaints().is_empty());
        fs::write(cache.file(&key), "half a rep").unwrap();
        assert_eq!(cache.get(&key), None);
        assert!(cache.complaints()[0].contains("no kept report"), "{:?}", cache.complaints());
        cache.put(key.clone(), &report(Verdict::Wrong));
        assert_eq!(cache.get(&key), Some(report(Verdict::Wrong)), "written anew");
    }

    #[test]
    fn a_folder_keeps_its_seed() {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path().join("kept");
        assert_eq!([Cache::seed(&place, 5).unwrap(), Cache::seed(&place, 6).unwrap()], [5, 5]);
        fs::write(place.join("seed"), "x").unwrap();
        assert_eq!([Cache::seed(&place, 7).unwrap(), Cache::seed(&place, 8).unwrap()], [7, 7]);
    }

    #[test]
    fn another_judge_or_launcher_is_another_key() {
        let folder = tempfile::tempdir().unwrap();
        let launcher = folder.path().join("launcher");
        let mut seen = Vec::new();
        for text in ["one", "two", "twoo"] {
            fs::write(&launcher, text).unwrap();
            let key = judge_itself(&launcher).unwrap();
            assert_eq!(key, judge_itself(&launcher).unwrap());
            assert!(!seen.contains(&key), "{key} {seen:?}");
            seen.push(key);
        }
    }

    #[test]
    fn what_the_machine_had_a_part_in_is_not_kept() {
        let folder = tempfile::tempdir().unwrap();
        let cache = Cache::open(folder.path(), false).unwrap();
        let key = Key { grader: String::new(), plan: 0, files: Vec::new() };
        for verdict in [Verdict::GraderFault, Verdict::TimedOut] {
            cache.put(key.clone(), &report(verdict));
            assert_eq!(cache.get(&key), None);
        }
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
        let cache = Cache::open(folder.path(), true).unwrap();
        cache.put(key.clone(), &report(Verdict::GraderFault));
        assert_eq!(cache.get(&key), None);
        cache.put(key.clone(), &report(Verdict::TimedOut));
        assert_eq!(cache.get(&key), Some(report(Verdict::TimedOut)));
    }
}
