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
//! size needs the memory of what was handed in and of a few reports.

use super::cache::{Cache, Key, hash_of, judge_itself};
use super::grade::{grade, suites};
use super::judge::Suite;
use super::sandbox::Resident;
use super::similar::{Fingerprints, Given, THRESHOLD, alike};
use super::submission::{
    Built, Intake, IntakeError, Submission, Toolchain, Tree, USUAL_BUILD, WorkFolders, build, scan_all,
    take_in_unscanned,
};
use super::{
    Barrier, Hidden, Lab, Limits, Plan, Report, Sandbox, SandboxChoice, SandboxedProgram, Similar, Stop, Verdict,
};
use std::collections::HashMap;
use std::hash::{BuildHasher, RandomState};
use std::io;
use std::num::NonZeroUsize;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, mpsc};
use std::time::Instant;

/// How many similar submissions are told of one.
const MOST_SIMILAR: usize = 20;

/// How submissions are graded.
#[derive(Clone, PartialEq, Debug)]
pub struct GradeOptions {
    /// The barriers that may be used.
    pub sandbox: SandboxChoice,
    /// The program that puts the barriers up: one whose `main` calls [`launched`](super::launched) first. `None` is the
    /// running program.
    pub launcher: Option<PathBuf>,
    /// What no submission may see: the labs with their solutions, the instructor's secret, the other submissions. A
    /// program in the sandbox tries to read it before anything is graded; the reports say what came of it.
    pub hidden: Vec<Hidden>,
    /// What the compiler may use; what the program may use is said by the lab.
    pub build: Limits,
    /// How many submissions are graded at the same time; `None` is one for each core.
    pub workers: Option<NonZeroUsize>,
    /// Where work folders are made; `None` is where the system keeps temporary files.
    pub work_folders: Option<PathBuf>,
    /// A folder in which reports are kept, so that nothing is graded twice under one plan; `None` keeps none. It
    /// holds what was handed in and what was said of it: it is for the instructor only.
    pub cache: Option<PathBuf>,
    /// Whether reports of runs that came to a deadline are kept, too. A busy machine may be to blame for those.
    pub keep_deadlines: bool,
    /// Whether what was kept before is passed over, and written anew.
    pub again: bool,
    /// From how many percent on two submissions are told to look alike, names and comments aside.
    pub similar_from: u8,
    /// Whether the files are scanned before they are built. Only tests of the barriers behind the scan switch it off.
    pub scan: bool,
    /// Only every so many-th group of equal files is graded, for one of several machines: the number of the part, from
    /// 0, and how many parts there are. What looks alike is still looked for in the whole class.
    pub shard: Option<(usize, usize)>,
    /// Ends a class: what is being graded is ended without a verdict, what is done stays.
    pub stop: Stop,
}

/// How the grading of a class ended.
#[derive(Clone, PartialEq, Eq, Debug)]
#[must_use]
pub enum Outcome {
    /// Every submission has its report.
    All,
    /// It was stopped: so many have none.
    Stopped {
        /// How many.
        left: usize,
    },
    /// The grader fails whatever it is given, and why. Those that it failed at have no report.
    Fault(String),
}

impl Default for GradeOptions {
    fn default() -> Self {
        let sandbox = SandboxChoice::default();
        Self {
            sandbox,
            launcher: None,
            hidden: Vec::new(),
            build: USUAL_BUILD,
            workers: None,
            work_folders: None,
            cache: None,
            keep_deadlines: false,
            again: false,
            similar_from: THRESHOLD,
            scan: true,
            shard: None,
            stop: Stop::new(),
        }
    }
}

/// A grader of one lab: the barriers tried, the toolchain found.
///
/// ```no_run
/// use dcel_lab::{GradeOptions, Grader, Lab, Outcome, Plan, Submission};
///
/// let grader = Grader::new(Lab::bundled("04")?, &GradeOptions::default())?;
/// let class = Submission::class(&["alice".into(), "bob.rs".into()], None)?;
/// let outcome = grader.grade_all(&class, &Plan::with_seed(7), |i, report| {
///     println!("{}: {}", class[i].name(), report.points());
/// });
/// assert_eq!(outcome, Outcome::All);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Grader {
    lab: Lab,
    sandbox: Sandbox,
    toolchain: Result<Toolchain, String>,
    work_folders: WorkFolders,
    options: GradeOptions,
    workers: usize,
    cache: Option<Cache>,
    /// The judge itself and the compiler, for the keys of the cache.
    judge: String,
    /// What is asked, and by which plan.
    suites: Mutex<Option<(Plan, Arc<Vec<Suite>>)>>,
}

impl Grader {
    /// Gets ready to grade submissions to a lab. What is missing on the machine (the toolchain, barriers) is not an
    /// error here but is said in the reports, so that there always are reports.
    ///
    /// Cost: some 100 ms; more where the toolchain must be copied to be within reach.
    ///
    /// # Errors
    /// If no folder can be made for the work folders or for the cache.
    pub fn new(lab: Lab, options: &GradeOptions) -> io::Result<Self> {
        let sandbox = Sandbox::probe(options.launcher.as_deref(), options.sandbox).until(&options.stop);
        let work_folders = WorkFolders::new(&sandbox, options.work_folders.as_deref())?;
        let toolchain = Toolchain::find(&sandbox, work_folders.folder());
        let mut needed = vec![work_folders.folder().to_path_buf()];
        let tools = toolchain.as_ref().map_or(Vec::new(), |toolchain| toolchain.parts().to_vec());
        needed.extend(tools.clone());
        let sandbox = sandbox.hiding(&options.hidden, &tools, &needed);
        let open = |folder| Cache::open(folder, options.keep_deadlines);
        let cache = options.cache.as_deref().map(open).transpose()?;
        // Only a cache asks who judged: reading the whole program is not free.
        let judge = match (&cache, &toolchain) {
            (Some(_), Ok(toolchain)) => {
                format!("{} {}", judge_itself(sandbox.launcher())?, toolchain.version().unwrap_or_default())
            }
            _ => String::new(),
        };
        let cores = || std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
        let workers = options.workers.map_or_else(cores, NonZeroUsize::get);
        let options = options.clone();
        let suites = Mutex::default();
        Ok(Self { lab, sandbox, toolchain, work_folders, options, workers, cache, judge, suites })
    }

    /// The barriers that stand, and those that are missing.
    #[must_use]
    pub fn sandbox(&self) -> &[Barrier] {
        self.sandbox.said()
    }

    /// What was found in the folder of kept reports that is none; it was graded anew.
    #[must_use]
    pub fn complaints(&self) -> Vec<String> {
        self.cache.as_ref().map_or_else(Vec::new, Cache::complaints)
    }

    /// The seed of a folder that keeps reports, so that a later run asks the same: the one that is kept there, or
    /// `fresh`, which is kept from now on.
    ///
    /// # Errors
    /// If the folder cannot be made or written to.
    pub fn kept_seed(folder: &Path, fresh: u64) -> io::Result<u64> {
        Cache::seed(folder, fresh)
    }

    /// Grades one submission. Never panics, and takes no longer than the limits of the build and of the judge's runs
    /// together; when it returns, nothing that the submission started is left.
    #[must_use]
    pub fn grade(&self, submission: &Submission, plan: &Plan) -> Report {
        let begin = Instant::now();
        let mut report = match take_in_unscanned(&self.lab.manifest, submission) {
            Ok(intake) => {
                let report = self.grade_intake(&intake, plan);
                Report { attachments: intake.optional, notes: intake.notes, ..report }
            }
            Err(error) => self.not_taken(submission, &error, plan),
        };
        report.submission = Some(submission.name().to_owned());
        report.millis = millis_since(begin);
        report
    }

    /// Grades a class. `done` is called with the place of a submission in the list and its report, as they come.
    ///
    /// Every submission is read once, before the first one is graded: what is compared is what is graded, and what
    /// changes on the disk meanwhile changes nothing. Kept in memory until they are graded are the files themselves.
    ///
    /// When the grader fails at a submission, it tries the file that the lab gives. If it fails at that, too, the
    /// failure is not that submission's: the class is ended ([`Outcome::Fault`]), and no report tells of it.
    pub fn grade_all(&self, submissions: &[Submission], plan: &Plan, mut done: impl FnMut(usize, Report)) -> Outcome {
        let mut jobs = self.jobs(submissions);
        if let Some((part, parts)) = self.options.shard {
            jobs = jobs.into_iter().skip(part).step_by(parts.max(1)).collect();
        }
        let next = AtomicUsize::new(0);
        let fault = Mutex::new(None);
        let (send, receive) = mpsc::sync_channel(1);
        let mut left: usize = jobs.iter().map(|job| lock(job).as_ref().map_or(0, |job| job.who.len())).sum();
        std::thread::scope(|scope| {
            for _ in 0..self.workers.min(jobs.len()) {
                let (send, jobs, next, fault) = (send.clone(), &jobs, &next, &fault);
                scope.spawn(move || {
                    let go_on = || !self.options.stop.is_wished() && lock(fault).is_none();
                    while let Some(job) = go_on().then(|| jobs.get(next.fetch_add(1, Ordering::Relaxed))).flatten() {
                        let Some(job) = lock(job).take() else { continue };
                        self.grade_job(job, submissions, plan, fault, &send);
                    }
                });
            }
            drop(send);
            for (i, report) in receive {
                left -= 1;
                done(i, report);
            }
        });
        match fault.into_inner().unwrap_or_else(PoisonError::into_inner) {
            Some(why) => Outcome::Fault(why),
            None if left > 0 => Outcome::Stopped { left },
            None => Outcome::All,
        }
    }

    /// Reads every submission, and puts those with equal graded files together, in the order of the first of each.
    fn jobs(&self, submissions: &[Submission]) -> Vec<Mutex<Option<Job>>> {
        let given = Given::new(&self.lab.files, &self.lab.manifest.graded);
        let mut prints: Vec<Option<Fingerprints>> = Vec::with_capacity(submissions.len());
        let mut jobs: Vec<Job> = Vec::new();
        let mut job_of = Vec::with_capacity(submissions.len());
        // The key is drawn anew for each run, and the files themselves are compared: nobody can hand in a file that
        // is taken for another one.
        let hasher = RandomState::new();
        let mut places: HashMap<u64, Vec<usize>> = HashMap::new();
        for (i, submission) in submissions.iter().enumerate() {
            let taken = take_in_unscanned(&self.lab.manifest, submission);
            prints.push(taken.as_ref().ok().and_then(|intake| given.fingerprints(&intake.graded)));
            let mut extras = Extras { place: i, optional: Vec::new(), notes: Vec::new(), similar: Vec::new() };
            let files = taken.map(|Intake { graded, optional, notes }| {
                (extras.optional, extras.notes) = (optional, notes);
                graded
            });
            let same = files.as_ref().ok().map(|graded| places.entry(hasher.hash_one(graded)).or_default());
            let known = same.as_ref().and_then(|places| {
                places.iter().copied().find(|&job| jobs[job].files.as_ref().ok() == files.as_ref().ok())
            });
            let place = known.unwrap_or(jobs.len());
            job_of.push(place);
            match jobs.get_mut(place) {
                Some(job) => job.who.push(extras),
                None => {
                    same.into_iter().for_each(|places| places.push(place));
                    jobs.push(Job { files, who: vec![extras] });
                }
            }
        }
        let alike = alike(&prints.iter().map(Option::as_ref).collect::<Vec<_>>(), self.options.similar_from);
        for (place, job) in jobs.iter_mut().enumerate() {
            let together: Vec<usize> = job.who.iter().map(|extras| extras.place).collect();
            for extras in &mut job.who {
                let nothing = prints[extras.place].as_ref().is_some_and(Fingerprints::is_empty);
                let same = together.iter().filter(|&&other| other != extras.place && !nothing);
                let name = |other: usize| submissions[other].name().to_owned();
                let same = same.map(|&other| Similar { submission: name(other), percent: 100, identical: true });
                let near = alike[extras.place].iter().filter(|(other, _)| job_of[*other] != place);
                let near = near.map(|&(other, percent)| Similar { submission: name(other), percent, identical: false });
                extras.similar = same.chain(near).take(MOST_SIMILAR).collect();
            }
        }
        jobs.into_iter().map(|job| Mutex::new(Some(job))).collect()
    }

    /// Grades equal files once; the reports differ in name and in what only people read.
    fn grade_job(
        &self,
        job: Job,
        submissions: &[Submission],
        plan: &Plan,
        fault: &Mutex<Option<String>>,
        send: &mpsc::SyncSender<(usize, Report)>,
    ) {
        let intake = job.files.map(|graded| Intake { graded, optional: Vec::new(), notes: Vec::new() });
        let mut first: Option<Report> = None;
        for extras in job.who {
            let begin = Instant::now();
            let submission = &submissions[extras.place];
            let mut report = match (&first, &intake) {
                (Some(first), _) => first.clone(),
                (None, Ok(intake)) => {
                    let report = self.grade_intake(intake, plan);
                    if report.verdict == Verdict::GraderFault && !self.options.stop.is_wished() {
                        let mut fault = lock(fault);
                        *fault = fault.take().or_else(|| self.strikes_all(plan));
                        if fault.is_some() {
                            return;
                        }
                    }
                    report
                }
                (None, Err(error)) => self.not_taken(submission, error, plan),
            };
            // What was ended on the way is no verdict.
            if self.options.stop.is_wished() {
                return;
            }
            // A fault of the grader may not befall the next one.
            if first.is_none() && report.verdict != Verdict::GraderFault {
                first = Some(report.clone());
            }
            report.submission = Some(submission.name().to_owned());
            (report.attachments, report.notes, report.similar) = (extras.optional, extras.notes, extras.similar);
            report.millis = millis_since(begin);
            // Nobody listens any more only if the caller's `done` panicked.
            let _ = send.send((extras.place, report));
        }
    }

    /// Whether the grader fails whatever it is given, and why: it fails at the file that the lab gives.
    fn strikes_all(&self, plan: &Plan) -> Option<String> {
        let Lab { manifest, files, .. } = &self.lab;
        let given = manifest.graded.iter().map(|path| Some((path.clone(), files.get(path)?.to_owned())));
        let intake = Intake { graded: given.collect::<Option<_>>()?, optional: Vec::new(), notes: Vec::new() };
        let report = self.grade_new(&intake, plan);
        let failed = report.verdict == Verdict::GraderFault && !self.options.stop.is_wished();
        let first = report.tests.iter().find(|test| test.verdict == Verdict::GraderFault);
        let why = report.message.or_else(|| first.map(|test| test.message.clone()));
        failed.then(|| why.unwrap_or_else(|| "no words".to_owned()))
    }

    fn not_taken(&self, submission: &Submission, error: &IntakeError, plan: &Plan) -> Report {
        let report = self.stopped(plan, error.verdict(), error.to_string());
        Report { notes: submission.notes().to_vec(), ..report }
    }

    /// The report of an earlier run, or a new one.
    fn grade_intake(&self, intake: &Intake, plan: &Plan) -> Report {
        let keeps = self.cache.as_ref().map(|cache| (cache, self.key(intake, plan)));
        if let Some(report) = keeps.as_ref().filter(|_| !self.options.again).and_then(|(cache, key)| cache.get(key)) {
            return report;
        }
        let report = self.grade_new(intake, plan);
        if let Some((cache, key)) = keeps.filter(|_| !self.options.stop.is_wished()) {
            cache.put(key, &report);
        }
        report
    }

    fn grade_new(&self, intake: &Intake, plan: &Plan) -> Report {
        let graded = catch_unwind(AssertUnwindSafe(|| {
            if self.options.scan
                && let Err(error) = scan_all(intake)
            {
                return self.stopped(plan, error.verdict(), error.to_string());
            }
            self.build_and_judge(intake, plan)
        }));
        graded.unwrap_or_else(|panic| {
            let words = panic.downcast_ref::<String>().map(String::as_str);
            let words = words.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("no words");
            self.stopped(plan, Verdict::GraderFault, format!("the grader panicked: {words}"))
        })
    }

    fn key(&self, intake: &Intake, plan: &Plan) -> Key {
        let Self { lab, judge, options: GradeOptions { build, scan, .. }, .. } = self;
        let limits = &lab.manifest.limits;
        // The lab's files too: while it is being written its version stays the same.
        let files: Vec<_> = lab.files.iter().collect();
        // A course can change points, needs and visibility without a change of the files.
        let tests = format!("{:?}", lab.manifest.tests);
        let lab = (&lab.name, &lab.manifest.version, hash_of(&files), hash_of(&tests));
        let grader = format!("{judge} {lab:?} {limits:?} {build:?} {:?} {scan}", self.sandbox.up());
        Key { grader, plan: hash_of(&format!("{plan:?}")), files: intake.graded.clone() }
    }

    fn build_and_judge(&self, intake: &Intake, plan: &Plan) -> Report {
        let fault = |message: String| self.stopped(plan, Verdict::GraderFault, message);
        let toolchain = match &self.toolchain {
            Ok(toolchain) => toolchain,
            Err(why) => return fault(why.clone()),
        };
        let resident = match self.sandbox.resident() {
            Ok(resident) => Arc::new(resident),
            Err(error) => return fault(error.to_string()),
        };
        let tree = match Tree::lay(self.work_folders.next(), &self.lab, intake, &*resident) {
            Ok(tree) => tree,
            Err(error) => return fault(format!("no room for the submission: {error}")),
        };
        let report = self.judge_built(build(&tree, toolchain, self.options.build, &*resident), &resident, plan);
        // The room goes last: nothing may run that still writes there.
        if resident.leave() { report } else { fault("something that it started could not be ended".to_owned()) }
    }

    fn judge_built(&self, built: Built, resident: &Arc<Resident>, plan: &Plan) -> Report {
        match built {
            Built::Program(path) => {
                let program = SandboxedProgram::new(Arc::clone(resident), &path, self.lab.manifest.limits);
                grade(&self.lab, &program, plan, &self.suites(plan), false).0
            }
            Built::Not { verdict, message } => self.stopped(plan, verdict, message),
        }
    }

    /// The suites of a plan: those of the last one are kept, since a class is asked by one plan.
    fn suites(&self, plan: &Plan) -> Arc<Vec<Suite>> {
        let mut kept = lock(&self.suites);
        match &*kept {
            Some((of, suites)) if of == plan => Arc::clone(suites),
            _ => {
                let made = Arc::new(suites(&self.lab, plan));
                *kept = Some((plan.clone(), Arc::clone(&made)));
                made
            }
        }
    }

    /// The report on a submission of which no test could run.
    fn stopped(&self, plan: &Plan, verdict: Verdict, message: String) -> Report {
        let report = Report::untested(&self.lab.manifest, verdict, message);
        Report { seed: plan.seed, sandbox: self.sandbox.said().to_vec(), ..report }
    }
}

/// Files to be graded, and all who handed them in.
struct Job {
    /// The graded files: path and text.
    files: Result<Vec<(String, String)>, IntakeError>,
    who: Vec<Extras>,
}

/// What tells two submissions with equal files apart.
struct Extras {
    /// The place in the list of submissions.
    place: usize,
    optional: Vec<(String, String)>,
    notes: Vec<String>,
    similar: Vec<Similar>,
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

fn millis_since(begin: Instant) -> u64 {
    u64::try_from(begin.elapsed().as_millis()).unwrap_or(u64::MAX)
}
