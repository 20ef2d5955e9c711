//! The answers against the library: every seed of a range, every level, every answer that can be given.

use super::find_fault::FindFault;
use super::make_drawing::MakeDrawing;
use super::predict::Predict;
use super::structures::random;
use super::*;
use crate::edits::Call;
use crate::ids::HalfEdgeId;
use crate::plane::PlaneJournal;
use crate::script::Script;
use crate::topology::{View, violations};

#[test]
fn structures_are_the_same_for_a_seed_and_sound() {
    for seed in 0..200 {
        let make = || random(&mut Dice::new(seed, 3), 6);
        let s = make();
        assert_eq!(s, make(), "seed {seed}");
        assert!(s.geometry_violations().is_empty() && violations(&s).is_empty(), "seed {seed}");
        assert!(s.face_count() > 3, "seed {seed}: {} faces", s.face_count());
    }
    let differ = (0..50).filter(|&seed| random(&mut Dice::new(seed, 3), 6) != random(&mut Dice::new(seed + 50, 3), 6));
    assert!(differ.count() > 45);
}

#[test]
fn where_am_i_takes_the_half_edge_that_the_links_lead_to_and_no_other() {
    for (seed, level) in (0..60).flat_map(|seed| [(seed, 1), (seed, 2), (seed, 3)]) {
        let round = Round::new("where_am_i", level, seed).unwrap();
        let table = round.table().unwrap().clone();
        let text = round.question().text;
        // The way as the sentence tells it, followed by the pointers of the table alone.
        let words: Vec<&str> = text.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).collect();
        let mut at: HalfEdgeId = words[3].parse().unwrap();
        let mut links = 0;
        for word in &words[4..] {
            at = match *word {
                "next" => table.next(at),
                "twin" => table.twin(at),
                "prev" => table.prev(at),
                _ => continue,
            }
            .unwrap();
            links += 1;
        }
        assert!(links >= 2 * level as usize, "{text}");
        for h in (0..table.half_edge_bound() as u32).map(HalfEdgeId::new) {
            let verdict = round.clone().answer(&h.to_string(), None).unwrap();
            assert_eq!(verdict.right, h == at, "seed {seed}, level {level}: {text} {h}");
        }
    }
}

#[test]
fn find_fault_takes_every_pointer_that_alone_mends_the_structure() {
    for (seed, level) in (0..12).flat_map(|seed| [(seed, 1), (seed, 2), (seed, 3)]) {
        let fault = FindFault::new(&mut Dice::new(seed, 4), level);
        assert!(!violations(&fault.table).is_empty(), "seed {seed}, level {level}");
        assert!(fault.answer(&fault.planted()).unwrap().right, "seed {seed}, level {level}: {}", fault.planted());
        // By brute force on the rows, not by the words of the answer.
        for h in (0..fault.table.half_edge_bound()).filter(|_| level < 3) {
            let mends = (0..fault.table.half_edge_bound() as u32).any(|to| {
                let mut table = fault.table.clone();
                table.half_edges[h].as_mut().unwrap().next = Some(HalfEdgeId::new(to));
                violations(&table).is_empty()
            });
            assert_eq!(fault.answer(&format!("h{h}.next")).unwrap().right, mends, "seed {seed}, level {level}, h{h}");
        }
    }
    assert!(FindFault::new(&mut Dice::new(1, 4), 1).answer("h0.colour").is_err());
    assert!(FindFault::new(&mut Dice::new(1, 4), 1).answer("h0").is_err());
}

#[test]
fn predict_has_one_call_that_the_library_refuses_and_its_reason() {
    let mut kinds = std::collections::BTreeSet::new();
    for (seed, level) in (0..60).flat_map(|seed| [(seed, 1), (seed, 2), (seed, 3)]) {
        let quiz = Predict::new(&mut Dice::new(seed, 5), level);
        let (refused, why, calls) = quiz.solution();
        let s = Subdivision::from_table(&quiz.table).unwrap();
        let mut reason = String::new();
        for (i, call) in calls.iter().enumerate() {
            let call: Call<Subdivision> = call.parse().unwrap();
            match call.apply(&mut s.clone(), &mut PlaneJournal::new()) {
                Ok(_) => assert_ne!(i, refused, "seed {seed}, level {level}: {call}"),
                Err(error) => {
                    assert_eq!(i, refused, "seed {seed}, level {level}: {call}: {error}");
                    reason = error.to_string();
                }
            }
        }
        let mut asked = quiz.clone();
        for wrong in (0..4).filter(|&i| i != refused) {
            assert!(!quiz.clone().answer(&wrong.to_string()).unwrap().right);
        }
        assert!(!asked.answer(&refused.to_string()).unwrap().over, "then the reason is asked for");
        let reasons = asked.choices();
        assert_eq!((reasons.len(), &reasons[why]), (3, &reason), "seed {seed}, level {level}: {calls:?}");
        for (i, said) in reasons.iter().enumerate() {
            assert_eq!(asked.clone().answer(&i.to_string()).unwrap().right, *said == reason, "seed {seed}: {said}");
        }
        kinds.insert(reason.chars().filter(char::is_ascii_alphabetic).collect::<String>());
    }
    assert!(kinds.len() >= 5, "{kinds:?}");
}

#[test]
fn each_drawing_can_be_made_and_the_fewest_moves_are_its_edges() {
    let rectangle = Subdivision::lab_rectangle();
    let mut fewest = Vec::new();
    for (level, number) in [(1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (3, 0)] {
        let drawing = MakeDrawing::new(level, number);
        let target = drawing.target();
        assert!(target.edge_count() > rectangle.edge_count(), "{}", drawing.text());
        assert!(drawing.judge(target).unwrap().right && drawing.judge(&rectangle).is_err());
        fewest.push(drawing.fewest());
    }
    assert_eq!(fewest, [1, 2, 5, 6, 6, 27]);
    // The ship, as lab 04 makes it; the others, by moves of a person.
    let ship = concat!(env!("CARGO_MANIFEST_DIR"), "/src/lab/courses/half_edge/drawing.dcels");
    let ship = std::fs::read_to_string(ship).unwrap();
    let made = [
        ((1, 0), "rectangle\nsplit_face h2 h8"),
        ((1, 1), "rectangle\nlet a = split_face h0 h8\nsplit_face h4 a.twin"),
        (
            (1, 2),
            "rectangle\nlet a = split_face h2 h8\nlet b = split_in_half a\nsplit_in_half b\nlet c = split_in_half h4\nsplit_face c a.twin",
        ),
        ((3, 0), ship.as_str()),
    ];
    for ((level, number), text) in made {
        let run = Script::parse(text, "moves").unwrap().run();
        let drawing = MakeDrawing::new(level, number);
        assert!(
            drawing.judge(&run.end).is_ok(),
            "{}: {:?} {:?}",
            drawing.text(),
            drawing.judge(&run.end),
            run.steps.last()
        );
        assert!(run.steps.iter().all(|step| !step.outcome.is_refused()), "{:?}", run.steps);
        assert_eq!(run.edits().len(), drawing.fewest(), "{}", drawing.text());
    }
}

#[test]
fn a_round_counts_and_its_code_tells_every_slip() {
    let mut round = Round::new("predict", 2, 1234).unwrap();
    for number in 0..5 {
        assert!(round.next().is_err(), "first the answer");
        while !round.answered {
            let right = match &round.task {
                Task::Predict(task) => {
                    let (call, why, _) = task.solution();
                    if task.choices().len() == 4 { call } else { why }
                }
                _ => unreachable!(),
            };
            let given = if number == 3 { (right + 1) % 3 } else { right };
            round.answer(&given.to_string(), None).unwrap();
        }
        assert!(round.answer("0", None).is_err(), "once");
        assert_eq!(round.next().is_ok(), number < 4);
    }
    let code = round.question().code;
    assert!(code.starts_with("predict-2-1234-4of5-"), "{code}");
    assert_eq!(read_code(&code).unwrap(), "Predict the verdict Level 2, seed 1234: 4 of 5 right.");
    let slips = code.char_indices().filter(|(_, c)| c.is_ascii_digit()).map(|(i, c)| {
        let other = if c == '9' { '8' } else { '9' };
        format!("{}{other}{}", &code[..i], &code[i + 1..])
    });
    for slip in slips {
        assert!(read_code(&slip).is_err(), "{slip}");
    }
}
