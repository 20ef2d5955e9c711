//! Grading submissions: one, or a whole class.
//!
//! ```text
//!   alice ─┐          ┌ worker: take in ▸ build ▸ judge ▸ end everything ┐
//!   bob   ─┼─ groups ─┤                                                   ├─▶ done(i, report)
//!   carol ─┘ of equal └ worker: …                                        ┘
//!            files
//! ```
//!
//! A submission that cannot be taken, does not compile, or does its worst, gets a report that says so, and the next
//! one is graded. Equal files are graded once. Reports are passed on as they come and not kept, so a class of any
//! size needs the memory of a few submissions.

use super::cache::{Cache, Key, hash_of};
use super::submission::{
    Built, Intake, IntakeError, Rooms, Toolchain, Tree, USUAL_BUILD, build, take_in, take_in_unscanned,
};
use super::walls::Resident;
use super::{Hidden, Lab, Limits, Plan, Report, Verdict, Wall, WallChoice, WalledProgram, Walls, grade_program};
use std::collections::BTreeMap;
use std::hash::{BuildHasher, RandomState};
use std::io;
use std::num::NonZeroUsize;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, mpsc};
use std::time::Instant;

/// How submissions are graded.
#[derive(Clone, PartialEq, Debug)]
pub struct GradeOptions {
    /// The walls that may be used.
    pub walls: WallChoice,
    /// The program that puts the walls up: one whose `main` calls [`launched`](super::launched) first. `None` is the
    /// running program.
    pub launcher: Option<PathBuf>,
    /// What no submission may see: the labs with their solutions, the instructor's secret, the other submissions. A
    /// program behind the walls tries to read it before anything is graded; the reports say what came of it.
    pub hidden: Vec<Hidden>,
    /// What the compiler may use; what the program may use is said by the lab.
    pub build: Limits,
    /// How many submissions are graded at the same time; `None` is one for each core.
    pub workers: Option<NonZeroUsize>,
    /// Where rooms are made; `None` is where the system keeps temporary files.
    pub rooms: Option<PathBuf>,
    /// A folder in which reports are kept, so that nothing is graded twice under one plan; `None` keeps none. It
    /// holds what was handed in and what was said of it: it is for the instructor only.
    pub cache: Option<PathBuf>,
    /// Whether the files are scanned before they are built. Only tests of the walls behind the scan switch it off.
    pub scan: bool,
}

impl Default for GradeOptions {
    fn default() -> Self {
        let walls = WallChoice::default();
        Self {
            walls,
            launcher: None,
            hidden: Vec::new(),
            build: USUAL_BUILD,
            workers: None,
            rooms: None,
            cache: None,
            scan: true,
        }
    }
}

/// A grader of one lab: the walls tried, the toolchain found.
///
/// ```no_run
/// use dcel_kit::lab::{GradeOptions, Grader, Lab, Plan};
///
/// let grader = Grader::new(Lab::bundled("04")?, &GradeOptions::default())?;
/// let class = ["alice".into(), "bob.rs".into()];
/// grader.grade_all(&class, &Plan::with_seed(7), |i, report| println!("{}: {}", class[i].display(), report.points()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Grader {
    lab: Lab,
    walls: Walls,
    toolchain: Result<Toolchain, String>,
    rooms: Rooms,
    build: Limits,
    workers: usize,
    cache: Option<Cache>,
    scan: bool,
}

impl Grader {
    /// Gets ready to grade submissions to a lab. What is missing on the machine (the toolchain, walls) is not an
    /// error here but is said in the reports, so that there always are reports.
    ///
    /// Cost: some 100 ms; more where the toolchain must be copied to be within reach.
    ///
    /// # Errors
    /// If no folder can be made for the rooms or for the cache.
    pub fn new(lab: Lab, options: &GradeOptions) -> io::Result<Self> {
        let walls = Walls::probe(options.launcher.as_deref(), options.walls);
        let rooms = Rooms::new(&walls, options.rooms.as_deref())?;
        let toolchain = Toolchain::find(&walls, rooms.folder());
        let mut needed = vec![rooms.folder().to_path_buf()];
        let tools = toolchain.as_ref().map_or(Vec::new(), |toolchain| toolchain.parts().to_vec());
        needed.extend(tools.clone());
        let walls = walls.hiding(&options.hidden, &tools, &needed);
        let cache = options.cache.as_deref().map(Cache::open).transpose()?;
        let cores = || std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
        let workers = options.workers.map_or_else(cores, NonZeroUsize::get);
        Ok(Self { lab, walls, toolchain, rooms, build: options.build, workers, cache, scan: options.scan })
    }

    /// The walls that stand, and those that are missing.
    #[must_use]
    pub fn walls(&self) -> &[Wall] {
        self.walls.said()
    }

    /// Grades one submission. Never panics, and takes no longer than the limits of the build and of the judge's runs
    /// together; when it returns, nothing that the submission started is left.
    #[must_use]
    pub fn grade(&self, submission: &Path, plan: &Plan) -> Report {
        self.grade_intake(submission, self.take_in(submission), plan)
    }

    /// Grades a class. `done` is called with the place of a submission in the list and its report, as they come.
    pub fn grade_all(&self, submissions: &[PathBuf], plan: &Plan, mut done: impl FnMut(usize, Report)) {
        let groups = self.groups(submissions);
        let next = AtomicUsize::new(0);
        let (send, receive) = mpsc::sync_channel(1);
        std::thread::scope(|scope| {
            for _ in 0..self.workers.min(groups.len()) {
                let (send, groups, next) = (send.clone(), &groups, &next);
                scope.spawn(move || {
                    while let Some(group) = groups.get(next.fetch_add(1, Ordering::Relaxed)) {
                        self.grade_group(submissions, group, plan, &send);
                    }
                });
            }
            drop(send);
            for (i, report) in receive {
                done(i, report);
            }
        });
    }

    fn take_in(&self, submission: &Path) -> Result<Intake, IntakeError> {
        let how = if self.scan { take_in } else { take_in_unscanned };
        how(&self.lab.manifest, submission)
    }

    /// Submissions with equal graded files, in the order of the first of each. The key is drawn anew for each run,
    /// so nobody can hand in a file that is taken for another one.
    fn groups(&self, submissions: &[PathBuf]) -> Vec<Vec<usize>> {
        let hasher = [RandomState::new(), RandomState::new()];
        let mut places: BTreeMap<[u64; 2], usize> = BTreeMap::new();
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for (i, submission) in submissions.iter().enumerate() {
            let known = match take_in_unscanned(&self.lab.manifest, submission) {
                Ok(intake) => {
                    *places.entry([0, 1].map(|k: usize| hasher[k].hash_one(&intake.graded))).or_insert(groups.len())
                }
                Err(_) => groups.len(),
            };
            match groups.get_mut(known) {
                Some(group) => group.push(i),
                None => groups.push(vec![i]),
            }
        }
        groups
    }

    fn grade_group(
        &self,
        submissions: &[PathBuf],
        group: &[usize],
        plan: &Plan,
        send: &mpsc::SyncSender<(usize, Report)>,
    ) {
        let mut first: Option<Report> = None;
        for &i in group {
            let report = match &first {
                None => self.grade(&submissions[i], plan),
                Some(first) => {
                    let mut report = first.clone();
                    report.submission = Some(name_of(&submissions[i]));
                    report.attachments = self.take_in(&submissions[i]).map_or(Vec::new(), |intake| intake.optional);
                    report
                }
            };
            // A fault of the grader may not befall the next one.
            if first.is_none() && group.len() > 1 && report.verdict != Verdict::GraderFault {
                first = Some(report.clone());
            }
            // Nobody listens any more only if the caller's `done` panicked.
            let _ = send.send((i, report));
        }
    }

    fn grade_intake(&self, submission: &Path, intake: Result<Intake, IntakeError>, plan: &Plan) -> Report {
        let begin = Instant::now();
        let mut report = match intake {
            Ok(intake) => {
                let mut report = self.known_or_new(&intake, plan);
                report.attachments = intake.optional;
                report
            }
            Err(error) => self.stopped(plan, error.verdict(), error.to_string()),
        };
        report.submission = Some(name_of(submission));
        report.millis = u64::try_from(begin.elapsed().as_millis()).unwrap_or(u64::MAX);
        report
    }

    /// The report of an earlier run, or a new one.
    fn known_or_new(&self, intake: &Intake, plan: &Plan) -> Report {
        let keeps = self.cache.as_ref().map(|cache| (cache, self.key(intake, plan)));
        if let Some(report) = keeps.as_ref().and_then(|(cache, key)| cache.get(key)) {
            return report;
        }
        let graded = catch_unwind(AssertUnwindSafe(|| self.build_and_judge(intake, plan)));
        let report = graded.unwrap_or_else(|panic| {
            let words = panic.downcast_ref::<String>().map(String::as_str);
            let words = words.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("no words");
            self.stopped(plan, Verdict::GraderFault, format!("the grader panicked: {words}"))
        });
        if let Some((cache, key)) = keeps {
            cache.put(key, &report);
        }
        report
    }

    fn key(&self, intake: &Intake, plan: &Plan) -> Key {
        let kit = env!("CARGO_PKG_VERSION");
        let Self { lab, build, scan, .. } = self;
        let limits = &lab.manifest.limits;
        // The lab's files too: while it is being written its version stays the same.
        let files: Vec<_> = lab.files.iter().collect();
        let lab = (&lab.name, &lab.manifest.version, hash_of(&files));
        let grader = format!("{kit} {lab:?} {limits:?} {build:?} {:?} {scan}", self.walls.up());
        Key { grader, plan: hash_of(&format!("{plan:?}")), files: intake.graded.clone() }
    }

    fn build_and_judge(&self, intake: &Intake, plan: &Plan) -> Report {
        let fault = |message: String| self.stopped(plan, Verdict::GraderFault, message);
        let toolchain = match &self.toolchain {
            Ok(toolchain) => toolchain,
            Err(why) => return fault(why.clone()),
        };
        let resident = match self.walls.resident() {
            Ok(resident) => Arc::new(resident),
            Err(error) => return fault(error.to_string()),
        };
        let tree = match Tree::lay(self.rooms.next(), &self.lab, intake, &*resident) {
            Ok(tree) => tree,
            Err(error) => return fault(format!("no room for the submission: {error}")),
        };
        let report = self.judge_built(build(&tree, toolchain, self.build, &*resident), &resident, plan);
        // The room goes last: nothing may run that still writes there.
        if resident.leave() { report } else { fault("something that it started could not be ended".to_owned()) }
    }

    fn judge_built(&self, built: Built, resident: &Arc<Resident>, plan: &Plan) -> Report {
        match built {
            Built::Program(path) => {
                let program = WalledProgram::new(Arc::clone(resident), &path, self.lab.manifest.limits);
                grade_program(&self.lab, &program, plan)
            }
            Built::Not { verdict, message } => self.stopped(plan, verdict, message),
        }
    }

    /// The report on a submission of which no test could run.
    fn stopped(&self, plan: &Plan, verdict: Verdict, message: String) -> Report {
        let report = Report::untested(&self.lab.manifest, verdict, message);
        Report { seed: plan.seed, walls: self.walls.said().to_vec(), ..report }
    }
}

/// What a submission is called: its file or folder, without the ending `.rs`.
fn name_of(submission: &Path) -> String {
    let path = submission.canonicalize().unwrap_or_else(|_| submission.to_path_buf());
    let name = path.file_name().map_or_else(|| path.to_string_lossy(), |name| name.to_string_lossy());
    name.strip_suffix(".rs").unwrap_or(&name).to_owned()
}
