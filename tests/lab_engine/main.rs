//! The engine of the labs: right programs pass, each wrong one fails at the right promise with the right words, and
//! whatever a program does, the rest of it is still graded.

mod answers;
mod counted;
mod every_lab;
mod explained;
mod fake;
mod kernel;
mod reports;

use dcel_kit::HalfEdgeId;
use dcel_kit::topology::{Table, View};
use dcel_lab::courses::half_edge::spec::TwinSide;
use dcel_lab::{Driver, End, Lab, Limits, Plan, Report, Secret, TestResult, Verdict, grade_and_sign, grade_program};
use fake::{Answer, Done, Fake};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../labs/04-half-edge")
}

fn lab() -> Lab {
    Lab::read(&folder()).unwrap()
}

fn grade(fake: &Fake) -> Report {
    grade_program(&lab(), fake, &Plan::with_seed(3))
}

/// The first test that is not passed.
fn first_open(report: &Report) -> &TestResult {
    report.tests.iter().find(|test| test.verdict != Verdict::Passed).expect("all is passed")
}

/// A program that is wrong in one function, where a call should change something.
fn wrong_in(function: &'static str, twist: impl Fn(&[HalfEdgeId], &mut Done) + Sync + 'static) -> Fake {
    Fake::twisted(move |called, arguments, done| {
        if called == function && done.before != done.after {
            let arguments: Vec<HalfEdgeId> = arguments.iter().map(|&h| HalfEdgeId::new(h)).collect();
            twist(&arguments, done);
        }
    })
}

fn row(table: &mut Table, h: HalfEdgeId) -> &mut dcel_kit::topology::HalfEdgeRow {
    table.half_edges[h.index()].as_mut().unwrap()
}

/// The two half-edges that a split has made.
fn new_ones(done: &Done) -> [HalfEdgeId; 2] {
    [0, 1].map(|i| HalfEdgeId::new((done.before.half_edges.len() + i) as u32))
}

#[test]
fn right_programs_earn_all_points_whichever_twin_is_new() {
    for side in [TwinSide::Moved, TwinSide::Kept] {
        let report = grade(&Fake { side, ..Fake::right() });
        let open: Vec<_> = report.tests.iter().filter(|test| test.verdict != Verdict::Passed).collect();
        assert!(open.is_empty(), "{side:?}: {open:#?}");
        assert_eq!((report.points(), report.tests.len(), report.verdict), (100.into(), 18, Verdict::Passed));
    }
}

#[test]
fn two_runs_say_the_same_and_another_seed_asks_other_cases() {
    let broken = || {
        wrong_in("split_face", |_, done| {
            if done.before.faces.len() > 4 {
                done.after.faces.last_mut().unwrap().as_mut().unwrap().half_edge = None;
            }
        })
    };
    let timeless = |mut report: Report| {
        report.millis = 0;
        report
    };
    let [a, b] = [0, 1].map(|_| timeless(grade(&broken())));
    assert_eq!(a, b);
    let other = timeless(grade_program(&lab(), &broken(), &Plan::with_seed(4)));
    assert_ne!(a, other);
}

#[test]
fn each_bug_is_found_by_the_step_that_it_breaks() {
    type Twisted = Box<dyn Fn(&[HalfEdgeId], &mut Done) + Sync>;
    let bugs: Vec<(&str, &str, &str, Twisted)> = vec![
        (
            "split_face",
            "split_face_0_legal",
            "split_face.0",
            Box::new(|_, done| done.answer = Answer::Returned("false".into())),
        ),
        (
            "split_face",
            "split_face_1_new_face",
            "split_face.1",
            Box::new(|_, done| {
                done.after.faces.pop();
            }),
        ),
        (
            "split_face",
            "split_face_2_half_edges",
            "split_face.2",
            Box::new(|_, done| {
                let [a, b] = new_ones(done);
                let origins = [a, b].map(|h| row(&mut done.after, h).origin);
                (row(&mut done.after, a).origin, row(&mut done.after, b).origin) = (origins[1], origins[0]);
            }),
        ),
        (
            "split_face",
            "split_face_2_half_edges",
            "split_face.2",
            Box::new(|_, done| {
                let [_, b] = new_ones(done);
                row(&mut done.after, b).twin = None;
            }),
        ),
        (
            "split_face",
            "split_face_3_links",
            "split_face.3",
            Box::new(|h, done| row(&mut done.after, h[1]).prev = done.before.prev(h[1])),
        ),
        (
            "split_face",
            "split_face_3_links",
            "split_face.3",
            Box::new(|h, done| {
                let before = done.before.prev(h[0]).unwrap();
                row(&mut done.after, before).next = Some(h[0]);
            }),
        ),
        (
            "split_face",
            "split_face_4_faces",
            "split_face.4",
            Box::new(|h, done| row(&mut done.after, h[1]).face = done.before.face(h[1])),
        ),
        (
            "split_face",
            "split_face_4_faces",
            "split_face.4",
            Box::new(|_, done| {
                let [a, b] = new_ones(done);
                row(&mut done.after, b).face = done.after.face(a);
            }),
        ),
        (
            "split_face",
            "split_face_5_representatives",
            "split_face.5",
            Box::new(|_, done| {
                done.after.faces.last_mut().unwrap().as_mut().unwrap().half_edge = None;
            }),
        ),
        (
            "split_face",
            "split_face_5_representatives",
            "split_face.5",
            Box::new(|h, done| {
                let face = done.before.face(h[0]).unwrap();
                done.after.faces[face.index()].clone_from(&done.before.faces[face.index()]);
            }),
        ),
        (
            "split_in_half",
            "split_in_half_1_vertex",
            "split_in_half.1",
            Box::new(|_, done| {
                let position = &mut done.after.vertices.last_mut().unwrap().as_mut().unwrap().position;
                *position = position.map(|[x, y]| [x.trunc(), y.trunc()]);
            }),
        ),
        (
            "split_in_half",
            "split_in_half_2_half_edges",
            "split_in_half.2",
            Box::new(|h, done| row(&mut done.after, h[0]).twin = None),
        ),
        (
            "split_in_half",
            "split_in_half_2_half_edges",
            "split_in_half.2",
            Box::new(|h, done| {
                let twin = done.before.twin(h[0]).unwrap();
                row(&mut done.after, twin).origin = done.before.origin(twin);
            }),
        ),
        (
            "split_in_half",
            "split_in_half_3_links",
            "split_in_half.3",
            Box::new(|_, done| {
                let [_, d] = new_ones(done);
                row(&mut done.after, d).prev = None;
            }),
        ),
        (
            "split_in_half",
            "split_in_half_3_links",
            "split_in_half.3",
            Box::new(|_, done| {
                done.after.vertices.last_mut().unwrap().as_mut().unwrap().outgoing = None;
            }),
        ),
        (
            "split_in_half",
            "split_in_half_3_links",
            "split_in_half.3",
            Box::new(|h, done| {
                let end = done.before.origin(done.before.twin(h[0]).unwrap()).unwrap();
                done.after.vertices[end.index()] = done.before.vertices[end.index()];
            }),
        ),
    ];
    for (i, (function, name, rule, twist)) in bugs.into_iter().enumerate() {
        let report = grade(&wrong_in(function, twist));
        let open = first_open(&report);
        assert_eq!((open.name.as_str(), open.verdict), (name, Verdict::Wrong), "bug {i}: {open:#?}");
        assert_eq!(open.findings[0].rule, rule, "bug {i}: {open:#?}");
        assert!(open.script.as_ref().unwrap().lines().count() <= 20, "bug {i}: {:?}", open.script);
        assert!(open.picture.is_some(), "bug {i}");
        // What builds on it is skipped; the other operation is graded all the same, up to where both are mixed. The
        // fake draws its drawing without the splits.
        let after: Vec<_> = report.tests.iter().skip_while(|test| test.name != name).skip(1).collect();
        let passed = after.iter().filter(|test| test.verdict == Verdict::Passed).count();
        assert!(
            after.iter().all(|test| matches!(test.verdict, Verdict::Passed | Verdict::Skipped)),
            "bug {i}: {after:#?}"
        );
        assert!(passed >= if function == "split_face" { 5 } else { 2 }, "bug {i}: {after:#?}");
    }
}

#[test]
fn illegal_calls_must_be_refused_and_change_nothing() {
    let accepts = Fake::twisted(|function, arguments, done| {
        if function == "split_face" && arguments[0] == arguments[1] {
            done.answer = Answer::Returned("true".into());
        }
    });
    let report = grade(&accepts);
    assert_eq!(first_open(&report).name, "split_face_0_legal");
    assert!(first_open(&report).message.contains("both are the same half-edge"), "{}", first_open(&report).message);
    let allocates = Fake::twisted(|function, _, done| {
        if function == "split_face" && done.answer == Answer::Returned("false".into()) {
            done.after.faces.push(Some(Default::default()));
        }
    });
    let report = grade(&allocates);
    assert!(first_open(&report).message.contains("it has changed the structure"), "{}", first_open(&report).message);
}

#[test]
fn walks_are_told_what_is_wrong_with_them() {
    let reversed = |list: &str| list.split(' ').rev().collect::<Vec<_>>().join(" ");
    for (function, name) in
        [("walk_face", "face_walk"), ("walk_vertices", "face_vertices"), ("walk_vertex", "vertex_star")]
    {
        let fake = Fake::twisted(move |called, _, done| {
            if let (true, Answer::Returned(list)) = (called == function, &done.answer) {
                done.answer = Answer::Returned(reversed(list));
            }
        });
        let report = grade(&fake);
        let is_wrong = |verdict| !matches!(verdict, Verdict::Passed | Verdict::Skipped);
        let open: Vec<_> = report.tests.iter().filter(|test| is_wrong(test.verdict)).collect();
        assert_eq!(open.len(), 1, "{open:#?}");
        assert_eq!((open[0].name.as_str(), open[0].verdict), (name, Verdict::Wrong));
        assert!(open[0].message.contains("clockwise"), "{}", open[0].message);
    }
    let origin = Fake::twisted(|called, arguments, done| {
        if called == "destination" {
            let h = HalfEdgeId::new(arguments[0]);
            done.answer = Answer::Returned(done.before.origin(h).unwrap().number().to_string());
        }
    });
    let report = grade(&origin);
    assert!(first_open(&report).message.contains("that is the origin"), "{}", first_open(&report).message);
}

/// A call that does the first steps of `split_face` and then is not written, or panics.
fn stops_after(step: usize, message: &'static str) -> Fake {
    ends_after(step, Answer::Panicked(message))
}

/// A call that does the first steps of `split_face` and then ends in this way.
fn ends_after(step: usize, end: Answer) -> Fake {
    Fake::twisted(move |function, _, done| {
        if function != "split_face" || done.before == done.after {
            return;
        }
        done.answer.clone_from(&end);
        let whole = std::mem::replace(&mut done.after, done.before.clone());
        let after = &mut done.after;
        let new = new_ones(&Done { before: done.before.clone(), after: whole.clone(), answer: Answer::Panicked("") });
        if step >= 1 {
            after.faces.push(Some(Default::default()));
        }
        if step >= 2 {
            after.half_edges.extend(new.map(|h| {
                let (origin, twin) = (whole.origin(h), whole.twin(h));
                Some(dcel_kit::topology::HalfEdgeRow { origin, twin, ..Default::default() })
            }));
        }
        for i in 0..after.half_edges.len() {
            let h = HalfEdgeId::new(i as u32);
            if step >= 3 {
                row(after, h).next = whole.next(h);
                row(after, h).prev = whole.prev(h);
            }
            if step >= 4 {
                row(after, h).face = whole.face(h);
            }
        }
        if step >= 5 {
            after.faces.clone_from(&whole.faces);
        }
    })
}

#[test]
fn steps_that_are_done_count_before_a_todo() {
    use Verdict::{Passed, Skipped, Unattempted};
    for done in 0..=5 {
        let report = grade(&stops_after(done, "not yet implemented: split_face"));
        let steps: Vec<Verdict> = report
            .tests
            .iter()
            .filter(|test| test.name.starts_with("split_face_") && test.task == 5)
            .map(|test| test.verdict)
            .collect();
        // Done up to the step; the next one is what there is to do. After the last step, the call must return.
        let open = (done + 1).min(5);
        let expected: Vec<Verdict> = (0..7)
            .map(|i| match i {
                i if i < open => Passed,
                i if i == open => Unattempted,
                _ => Skipped,
            })
            .collect();
        assert_eq!(steps, expected, "after step {done}: {report:#?}");
    }
}

#[test]
fn nothing_but_todos_is_unattempted_everywhere() {
    let report = grade(&Fake::twisted(|_, _, done| {
        done.after.clone_from(&done.before);
        done.answer = Answer::Panicked("not yet implemented");
    }));
    // The fake draws its picture without the student's code.
    let open = report.tests.iter().filter(|test| test.verdict != Verdict::Unattempted).map(|test| &test.name);
    assert_eq!(open.collect::<Vec<_>>(), ["drawing_svg"]);
    assert_eq!(report.points(), 0);
}

#[test]
fn a_panic_is_a_crash_with_its_place() {
    let report = grade(&stops_after(2, "index out of bounds: the len is 3 but the index is 7"));
    let open = first_open(&report);
    assert_eq!((open.name.as_str(), open.verdict), ("split_face_3_links", Verdict::Crashed));
    assert_eq!(open.place.as_deref(), Some("src/lab.rs:7:9"));
}

#[test]
fn a_process_that_dies_loses_the_case_in_progress_only() {
    for (end, verdict, words) in [
        (End::StackOverflow, Verdict::Crashed, "stack overflow"),
        (End::Exited(0), Verdict::Crashed, "ended itself (exit code 0)"),
        (End::Signalled { signal: 11, name: "SIGSEGV" }, Verdict::Crashed, "SIGSEGV"),
        (End::TimedOut, Verdict::TimedOut, "deadline"),
        (End::OutputLimit, Verdict::Crashed, "printed more"),
    ] {
        let dying = end.clone();
        // Round the middle of the window, which has four edges there.
        let report = grade(&Fake::twisted(move |function, _, done| {
            if function == "walk_vertex"
                && done.before.vertices.len() == 9
                && matches!(&done.answer, Answer::Returned(list) if list.split(' ').count() == 4)
            {
                done.answer = Answer::Died(dying.clone());
            }
        }));
        let open: Vec<_> = report.tests.iter().filter(|test| test.verdict != Verdict::Passed).collect();
        assert_eq!(open.len(), 1, "{end:?}: {open:#?}");
        assert_eq!((open[0].name.as_str(), open[0].verdict), ("vertex_star", verdict), "{end:?}");
        assert!(open[0].message.contains(words), "{end:?}: {}", open[0].message);
        assert!(open[0].script.as_ref().unwrap().contains("walk_vertex"), "{end:?}");
        if verdict != Verdict::TimedOut {
            // The cases after it were asked in a new process, and some of them end it again.
            let (_, count) = open[0].message.rsplit_once('(').unwrap();
            let failing: usize = count.split(' ').next().unwrap().parse().unwrap();
            assert!(failing > 1 && count.ends_with(" calls fail.)"), "{}", open[0].message);
        }
    }
}

/// Counts how often a program is started.
struct Counted<'a>(&'a Fake, std::sync::atomic::AtomicUsize);

impl dcel_lab::Program for Counted<'_> {
    fn run(&self, input: &str) -> dcel_lab::Ran {
        self.1.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        self.0.run(input)
    }
}

#[test]
fn a_program_that_is_ended_three_times_by_time_or_memory_is_asked_no_more() {
    for (end, verdict) in [(End::TimedOut, Verdict::TimedOut), (End::OutOfMemory, Verdict::OutOfMemory)] {
        // Everything dies: three starts, and whoever was not asked is told why.
        let dying = end.clone();
        let fake = Fake::twisted(move |_, _, done| done.answer = Answer::Died(dying.clone()));
        let counted = Counted(&fake, Default::default());
        let report = grade_program(&lab(), &counted, &Plan::with_seed(3));
        assert_eq!(report.points(), 0);
        let asked = |test: &&TestResult| test.verdict == verdict && !test.message.contains("It was not run");
        let not_run = |test: &&TestResult| test.verdict == Verdict::Skipped;
        let all: Vec<_> = report.tests.iter().collect();
        assert!(all.iter().copied().filter(asked).count() >= 1, "{all:#?}");
        assert_eq!(all.iter().copied().filter(|test| asked(test) || not_run(test)).count(), all.len(), "{all:#?}");
        let told = all.iter().filter(|test| test.message.contains("ended three times")).count();
        if end == End::TimedOut {
            // Nothing is shown of a program that does not come back, so nothing more is run for that.
            assert_eq!(counted.1.into_inner(), 3);
            assert!(told >= 1, "{all:#?}");
        }

        // One function never comes back: only what calls it is lost, and said to be so.
        let dying = end.clone();
        let fake = Fake::twisted(move |function, _, done| {
            if function == "walk_vertex" {
                done.answer = Answer::Died(dying.clone());
            }
        });
        let report = grade(&fake);
        let open: Vec<_> = report.tests.iter().filter(|test| test.verdict != Verdict::Passed).collect();
        assert!(open[0].name == "vertex_star" && open[0].verdict == verdict, "{open:#?}");
        for test in &open[1..] {
            assert!(
                test.verdict == Verdict::Skipped && test.message.contains("walk_vertex did not come back"),
                "{open:#?}"
            );
        }

        // Once only: everything else is asked, and passed.
        let dying = end.clone();
        let once = std::sync::atomic::AtomicBool::new(true);
        let fake = Fake::twisted(move |function, _, done| {
            if function == "walk_vertex" && once.swap(false, std::sync::atomic::Ordering::Relaxed) {
                done.answer = Answer::Died(dying.clone());
            }
        });
        let report = grade(&fake);
        let open: Vec<_> = report.tests.iter().filter(|test| test.verdict != Verdict::Passed).collect();
        assert_eq!(open.len(), 1, "{open:#?}");
        assert_eq!((open[0].name.as_str(), open[0].verdict), ("vertex_star", verdict));
    }
}

/// A program of which several runs may go on at the same time.
struct AtOnce(Fake, usize);

impl dcel_lab::Program for AtOnce {
    fn run(&self, input: &str) -> dcel_lab::Ran {
        self.0.run(input)
    }

    fn at_once(&self) -> usize {
        self.1
    }
}

#[test]
fn suites_at_the_same_time_come_to_the_same_report() {
    let dying = |ends: &'static [(&'static str, End)]| {
        Fake::twisted(move |function, _, done| {
            if let Some((_, end)) = ends.iter().find(|(dies, _)| *dies == function) {
                done.answer = Answer::Died(end.clone());
            }
        })
    };
    let program = |i| match i {
        0 => stops_after(2, "not yet implemented: split_face"),
        // Both are run at the same time. The first ends late, and the second would have been asked less after it.
        1 => Fake::twisted(|function, _, done| match function {
            "walk_face" if done.before.vertices.len() > 200 => done.answer = Answer::Died(End::TimedOut),
            "destination" => done.answer = Answer::Died(End::OutOfMemory),
            _ => {}
        }),
        2 => dying(&[("destination", End::OutOfMemory)]),
        _ => dying(&[
            ("walk_face", End::StackOverflow),
            ("walk_vertex", End::OutOfMemory),
            ("split_face", End::TimedOut),
        ]),
    };
    for i in 0..4 {
        let report = |at_once| {
            let report = grade_program(&lab(), &AtOnce(program(i), at_once), &Plan::with_seed(11));
            Report { millis: 0, ..report }
        };
        assert_eq!(report(3), report(1), "program {i}");
    }
}

#[test]
fn what_is_not_the_students_fault_is_not_their_loss() {
    struct Missing;
    impl dcel_lab::Program for Missing {
        fn run(&self, _: &str) -> dcel_lab::Ran {
            let end = End::NotStarted("driver: no such file".into());
            dcel_lab::Ran { stdout: Vec::new(), stderr: Vec::new(), end, millis: 0 }
        }
    }
    let report = grade_program(&lab(), &Missing, &Plan::with_seed(1));
    assert!(
        report.tests.iter().all(|test| test.verdict == Verdict::GraderFault && test.message.contains("no such file"))
    );
    let deaf = Fake {
        printed: Box::new(|out| {
            let token = out.trim_start().split(' ').next().unwrap_or_default().to_owned();
            format!("{token} error line 2: `save` is not understood\n{token} done\n")
        }),
        ..Fake::right()
    };
    let report = grade(&deaf);
    assert!(report.tests.iter().all(|test| test.verdict == Verdict::GraderFault), "{report:#?}");
    assert!(report.tests[0].message.contains("`save` is not understood"));
}

#[test]
fn an_answer_without_its_end_is_no_pass() {
    let silent = Fake { printed: Box::new(|_| String::new()), ..Fake::right() };
    assert!(
        grade(&silent).tests.iter().all(|test| test.verdict == Verdict::Crashed || test.verdict == Verdict::Skipped)
    );
    let cut = Fake { printed: Box::new(|out| out[..out.len() * 9 / 10].to_owned()), ..Fake::right() };
    let report = grade(&cut);
    let passed: Vec<_> =
        report.tests.iter().filter(|test| test.points > 0.into()).map(|test| test.name.as_str()).collect();
    assert_eq!(passed, ["drawing"], "it was answered; the end was missing in the picture");
    let undone = Fake { printed: Box::new(|out| out.replace("done", "gone")), ..Fake::right() };
    assert_eq!(grade(&undone).points(), 0);
    // Lines without the token are the student's own.
    let chatty = Fake { printed: Box::new(|out| format!("hello\ndone\ncase x\n{out}")), ..Fake::right() };
    let report = grade(&chatty);
    assert_eq!(report.points(), 100);
    assert!(report.printed.starts_with("hello\ndone\ncase x\n"));
}

/// Right in everything but the split of a face when there are so many, and no more than a sequence makes.
fn wrong_with_faces(count: usize) -> Fake {
    wrong_in("split_face", move |_, done| {
        if (count..30).contains(&done.before.faces.len()) {
            done.after.faces.last_mut().unwrap().as_mut().unwrap().half_edge = None;
        }
    })
}

#[test]
fn a_failing_sequence_is_shrunk_to_the_shortest_script() {
    // The single calls have at most five faces before them.
    let report = grade(&wrong_with_faces(6));
    let open = first_open(&report);
    assert_eq!((open.name.as_str(), open.verdict), ("split_face_sequences", Verdict::Wrong), "{open:#?}");
    let script = open.script.as_ref().unwrap();
    // Two faces, four splits that make the sixth, and the one that fails.
    assert_eq!(script.lines().filter(|line| line.starts_with("split_face")).count(), 5, "{script}");
    assert_eq!(open.findings[0].rule, "split_face.5");
}

#[test]
fn an_error_in_a_file_is_one_line_whatever_its_keys_are() {
    let error = Secret::parse("\"a\\nb\" = 1\n", "secret.toml", &[]).unwrap_err().to_string();
    assert_eq!(error, r"secret.toml:1:1: unknown key `a\nb`; there is seed, sequences, calls");
}

#[test]
fn hidden_cases_say_the_promise_and_nothing_of_the_case() {
    let secret = Secret::parse("seed = 5\ncalls = 40\nsequences = 60\n", "secret.toml", &[]).unwrap();
    let fake = wrong_with_faces(9);
    let visible = grade(&fake);
    assert_eq!(visible.points(), 100, "{:#?}", first_open(&visible));
    let report = grade_program(&lab(), &fake, &Plan { secret: Some(secret), ..Plan::with_seed(3) });
    let open = first_open(&report);
    // Only long sequences, or those that begin with many faces, come so far.
    assert_eq!((open.name.as_str(), open.verdict), ("split_face_sequences", Verdict::Wrong));
    assert!(open.script.is_none() && open.picture.is_none() && open.replay.is_none());
    for words in open.findings.iter().map(|finding| &finding.words).chain([&open.message]) {
        assert!(words.contains("hidden"), "{words}");
        assert!(!words.contains(|c: char| c.is_ascii_digit()), "{words}");
    }
}

#[test]
fn a_signature_does_not_depend_on_how_new_elements_are_numbered() {
    let without_boundary = |side| {
        let fake = wrong_in("split_in_half", |_, done| {
            done.after.vertices.last_mut().unwrap().as_mut().unwrap().outgoing = None;
        });
        Fake { side, ..fake }
    };
    let lab = lab();
    let signature = |fake: &Fake, seed| grade_and_sign(&lab, fake, &Plan::with_seed(seed)).1;
    let [moved, kept] = [TwinSide::Moved, TwinSide::Kept].map(|side| signature(&without_boundary(side), 3));
    assert_eq!(moved.keys().collect::<Vec<_>>(), ["split_in_half_3_links"]);
    assert_eq!(moved, kept);
    assert_eq!(moved, signature(&without_boundary(TwinSide::Moved), 4), "the random cases are no part of it");
    assert!(signature(&Fake::right(), 3).is_empty());
    assert_ne!(signature(&stops_after(2, "oh"), 3), signature(&stops_after(3, "oh"), 3));
}

#[test]
fn only_what_is_wanted_is_run() {
    let plan = Plan { only: Some("split_face_3_links".into()), ..Plan::with_seed(1) };
    let report = grade_program(&lab(), &Fake::right(), &plan);
    let names: Vec<&str> = report.tests.iter().map(|test| test.name.as_str()).collect();
    assert!(names.contains(&"split_face_3_links") && !names.contains(&"face_walk"), "{names:?}");
}

/// The real driver with this text as the student's file.
fn build(dir: &Path, source: &str) -> Driver {
    try_build(dir, source).unwrap_or_else(|said| panic!("{said}"))
}

/// The same; or what the compiler says.
fn try_build(dir: &Path, source: &str) -> Result<Driver, String> {
    for (path, text) in lab().files.iter().filter_map(|(path, text)| Some((path.strip_prefix("src/")?, text))) {
        let file = dir.join(path);
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, text).unwrap();
    }
    fs::write(dir.join("lab.rs"), source).unwrap();
    let driver = dir.join("driver");
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let arguments = ["--edition", "2024", "-A", "warnings", "main.rs", "-o"];
    let out = Command::new(rustc).args(arguments).arg(&driver).current_dir(dir).output().unwrap();
    if !out.status.success() {
        return Err(String::from_utf8_lossy(&out.stderr).into_owned());
    }
    Ok(Driver::new(driver, Limits::default()))
}

#[test]
fn the_marked_solution_earns_all_points_with_the_real_driver() {
    let dir = tempfile::tempdir().unwrap();
    let driver = build(dir.path(), &fs::read_to_string(folder().join("solution/lab.rs")).unwrap());
    let report = grade_program(&lab(), &driver, &Plan::with_seed(3));
    let open: Vec<_> = report.tests.iter().filter(|test| test.verdict != Verdict::Passed).collect();
    assert!(open.is_empty(), "{open:#?}");
    assert_eq!(report.points(), 100);
}

#[test]
fn the_starter_is_unattempted_with_the_real_driver() {
    let dir = tempfile::tempdir().unwrap();
    let driver = build(dir.path(), &fs::read_to_string(folder().join("src/lab.rs")).unwrap());
    let report = grade_program(&lab(), &driver, &Plan::with_seed(3));
    assert!(report.tests.iter().all(|test| test.verdict == Verdict::Unattempted), "{report:#?}");
}
