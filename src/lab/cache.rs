//! Reports kept from earlier runs, by the content of what was graded.
//!
//! ```text
//!   key = kit, lab and its version, limits, seed and secret, walls, the student's files
//!   FOLDER/HASH.json = key and report; the hash only finds the file, the whole key must agree
//! ```
//!
//! Nothing is kept of runs in which the grader or the machine had a part: a fault of the grader, a deadline.

use super::{Report, Verdict};
use serde::{Deserialize, Serialize};
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io;
use std::path::{Path, PathBuf};

/// A folder of reports.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Cache {
    folder: PathBuf,
}

/// Everything that a report depends on.
#[derive(Clone, PartialEq, Eq, Hash, Debug, Serialize, Deserialize)]
pub(crate) struct Key {
    /// Kit, lab, versions, limits, walls.
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
    pub(crate) fn open(folder: &Path) -> io::Result<Self> {
        fs::create_dir_all(folder)?;
        Ok(Self { folder: folder.to_path_buf() })
    }

    /// The report of an earlier run. What cannot be read is not there.
    pub(crate) fn get(&self, key: &Key) -> Option<Report> {
        let entry: Entry = serde_json::from_slice(&fs::read(self.file(key)).ok()?).ok()?;
        (entry.key == *key).then_some(entry.report)
    }

    /// Keeps a report. Whatever goes wrong, it can be made again. Written beside and moved, so that two graders with
    /// one folder never read half a report.
    pub(crate) fn put(&self, key: Key, report: &Report) {
        let depends = |verdict: Verdict| matches!(verdict, Verdict::GraderFault | Verdict::TimedOut);
        if depends(report.verdict) || report.tests.iter().any(|test| depends(test.verdict)) {
            return;
        }
        let file = self.file(&key);
        let Ok(text) = serde_json::to_vec(&Entry { key, report: report.clone() }) else { return };
        let beside = file.with_extension(super::walls::unguessable());
        if fs::write(&beside, text).and_then(|()| fs::rename(&beside, &file)).is_err() {
            let _ = fs::remove_file(&beside);
        }
    }

    fn file(&self, key: &Key) -> PathBuf {
        self.folder.join(format!("{:016x}.json", hash_of(key)))
    }
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
            submission: None,
            seed: 3,
            verdict,
            message: None,
            tests: Vec::new(),
            walls: Vec::new(),
            printed: String::new(),
            attachments: Vec::new(),
            adjustments: Vec::new(),
            notes: Vec::new(),
            similar: Vec::new(),
            millis: 1,
        }
    }

    #[test]
    fn a_report_is_found_by_all_that_it_depends_on() {
        let folder = tempfile::tempdir().unwrap();
        let cache = Cache::open(&folder.path().join("reports")).unwrap();
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
        fs::write(cache.file(&key), "half a rep").unwrap();
        assert_eq!(cache.get(&key), None);
    }

    #[test]
    fn what_the_machine_had_a_part_in_is_not_kept() {
        let folder = tempfile::tempdir().unwrap();
        let cache = Cache::open(folder.path()).unwrap();
        let key = Key { grader: String::new(), plan: 0, files: Vec::new() };
        for verdict in [Verdict::GraderFault, Verdict::TimedOut] {
            cache.put(key.clone(), &report(verdict));
            assert_eq!(cache.get(&key), None);
        }
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}
