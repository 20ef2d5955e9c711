//! Sessions as a whole: random actions, history against the script, links, files and texts that are wrong.

use super::dice::Dice;
use super::scene::Scene;
use super::{Action, Reply, Session, Tone};
use crate::ids::HalfEdgeId;
use crate::plane::Subdivision;
use crate::script::Script;
use crate::topology::{Table, isomorphic};

fn plane(session: &Session) -> Subdivision {
    let kept = session.link();
    let text = super::link::read(&kept).unwrap();
    let (scene, _) = text.rsplit_once('\u{1e}').unwrap();
    Scene::remade(scene).unwrap().subdivision().unwrap().clone()
}

fn script(session: &mut Session, text: &str) -> Reply {
    session.act(&Action::Script { text: text.to_owned() })
}

fn text(reply: &Reply) -> &str {
    reply.message.as_ref().map_or("", |message| &message.text)
}

fn refused(reply: &Reply) -> bool {
    reply.message.as_ref().is_some_and(|message| message.tone == Tone::Refused)
}

fn saved(session: &mut Session, what: &str) -> String {
    let reply = session.act(&Action::Export { what: what.to_owned() });
    reply.file.unwrap_or_else(|| panic!("{what}: {:?}", reply.message)).text
}

/// An action of any kind, now and then a foolish one.
fn random(dice: &mut Dice) -> Action {
    let id = |dice: &mut Dice| format!("{}{}", ["v", "h", "e", "f"][dice.below(4)], dice.below(16));
    let half_edge = |dice: &mut Dice| format!("h{}", dice.below(16));
    let place = |dice: &mut Dice| [dice.below(800) as f64, dice.below(600) as f64];
    let [x, y] = place(dice);
    match dice.below(40) {
        0 => Action::Resize { width: [300.0, 830.0, f64::NAN][dice.below(3)], height: 500.0 },
        1 => {
            let starts = ["rectangle", "torus", "points", "cube", "dodecahedron", "nonsense"];
            Action::Start { what: starts[dice.below(6)].to_owned() }
        }
        2 => Action::Polygon { places: (0..dice.below(6)).map(|_| place(dice)).collect() },
        3..=5 => Action::Click { x, y, reach: 20.0 },
        6 => Action::Hover { x, y, reach: -1.0 },
        7..=10 => Action::Pick { id: id(dice) },
        11 => Action::Leave,
        12..=14 => {
            Action::Follow { link: ["next", "twin", "prev", "origin", "face", "outgoing"][dice.below(6)].to_owned() }
        }
        15 => Action::Walk { path: format!("{}.next.twin", half_edge(dice)) },
        16..=19 => {
            let words =
                ["split_face", "split_in_half", "flip_edge", "remove_edge", "join_edges", "set_hole", "insert_vertex"];
            Action::Edit { word: words[dice.below(7)].to_owned() }
        }
        20..=24 => {
            let lines = [
                format!("split_face {} {}", half_edge(dice), half_edge(dice)),
                format!("split_in_half {}", half_edge(dice)),
                format!("let door = split_in_half {}", half_edge(dice)),
                format!("split_edge {}", half_edge(dice)),
                format!("split_vertex {} {}", half_edge(dice), half_edge(dice)),
                "walk_face h0".to_owned(),
                format!("let a{} = h0.next", dice.below(9)),
                "join_edges a1.next\nnonsense".to_owned(),
            ];
            Action::Script { text: lines[dice.below(8)].clone() }
        }
        25 => Action::Drag { id: id(dice), x, y },
        26 | 27 => Action::Drop { id: format!("v{}", dice.below(10)), x, y },
        28 => Action::Nudge { id: format!("v{}", dice.below(10)), x: 1.0, y: -1.0 },
        29..=31 => Action::Undo,
        32 => Action::Redo,
        33 => {
            let pointers = ["next", "prev", "twin", "face", "origin", "outgoing", "half_edge"];
            Action::Break {
                id: id(dice),
                pointer: pointers[dice.below(7)].to_owned(),
                to: [id(dice), "none".to_owned()][dice.below(2)].clone(),
            }
        }
        34 => Action::Mend,
        35 => Action::Over { what: ["delaunay", "circles", "voronoi"][dice.below(3)].to_owned() },
        36 => Action::Keep,
        37 => Action::Export { what: ["svg", "dcel", "script", "play"][dice.below(4)].to_owned() },
        38 => match dice.below(4) {
            0 => Action::Quit,
            1 => Action::Next,
            2 => Action::Answer {
                answer: [half_edge(dice), "2".to_owned(), format!("{}.next", half_edge(dice))][dice.below(3)].clone(),
            },
            _ => {
                let kinds = ["where_am_i", "make_drawing", "find_fault", "predict"];
                Action::Quiz {
                    what: kinds[dice.below(4)].to_owned(),
                    level: dice.below(5) as u32,
                    seed: dice.below(99) as u64,
                }
            }
        },
        _ => Action::Outline { places: (0..dice.below(4)).map(|_| place(dice)).collect() },
    }
}

#[test]
fn random_actions_never_panic_and_what_is_kept_is_valid_and_comes_back() {
    for seed in 0..16 {
        let mut dice = Dice::new(seed, 1);
        let mut session = Session::new();
        session.act(&Action::Show);
        for step in 0..120 {
            let action = random(&mut dice);
            let before = session.link();
            let reply = session.act(&action);
            let what = format!("seed {seed}, step {step}, {action:?}: {:?}", reply.message);
            if refused(&reply) && !matches!(action, Action::Answer { .. } | Action::Quiz { .. }) {
                assert_eq!(session.link(), before, "refused, but changed: {what}");
            }
            if !before.is_empty() && reply.status.as_ref().is_none_or(|status| status.scene != "broken") {
                assert!(
                    session.broken.is_some() || session.violations().is_empty(),
                    "{what}: {:?}",
                    session.violations()
                );
            }
            if step % 10 == 0 {
                let link = session.link();
                let mut other = Session::new();
                let opened = other.act(&Action::Link { text: link.clone() });
                assert!(!refused(&opened), "{what}: {:?}", opened.message);
                assert_eq!(other.link(), link, "{what}");
            }
        }
    }
}

#[test]
fn undo_leads_through_the_states_of_the_script_and_redo_back() {
    for seed in 0..8 {
        let mut dice = Dice::new(seed, 2);
        let mut session = Session::new();
        let mut states = vec![plane(&session)];
        let mut scripts = vec![saved(&mut session, "script")];
        for _ in 0..100 {
            let half_edges: Vec<HalfEdgeId> = states.last().unwrap().half_edges().collect();
            let [a, b] = [0, 1].map(|_| *dice.pick(&half_edges).unwrap());
            let few = half_edges.len() < 12;
            let line = match if few { 0 } else { dice.below(8) } {
                0 | 1 => format!("split_in_half {a}"),
                2 => format!("flip_edge {a}"),
                3 => format!("remove_edge {}", a.edge()),
                4 => format!("join_edges {a}"),
                5 => format!("let n{} = split_in_half {a}", states.len()),
                _ => format!("split_face {a} {b}"),
            };
            let reply = script(&mut session, &line);
            if !refused(&reply) {
                states.push(plane(&session));
                scripts.push(saved(&mut session, "script"));
            }
        }
        assert!(states.len() > 20, "seed {seed}: {} edits", states.len());
        for (state, text) in states.iter().zip(&scripts) {
            let run = Script::parse(text, "saved").unwrap_or_else(|error| panic!("seed {seed}: {error}\n{text}")).run();
            assert!(run.steps.iter().all(|step| !step.outcome.is_refused()), "seed {seed}:\n{text}");
            assert_eq!(Table::from_planar_view(&run.end), Table::from_planar_view(state), "seed {seed}:\n{text}");
        }
        for (state, text) in states.iter().zip(&scripts).rev().skip(1) {
            session.act(&Action::Undo);
            assert_eq!(&plane(&session), state, "seed {seed}");
            assert_eq!(&saved(&mut session, "script"), text, "seed {seed}");
        }
        assert!(refused(&session.act(&Action::Undo)), "nothing is left");
        for (state, text) in states.iter().zip(&scripts).skip(1) {
            session.act(&Action::Redo);
            assert_eq!(&plane(&session), state, "seed {seed}");
            assert_eq!(&saved(&mut session, "script"), text, "seed {seed}");
        }
        assert!(refused(&session.act(&Action::Redo)), "nothing is left");
    }
}

#[test]
fn two_corners_are_joined_or_refused_in_the_words_of_the_library() {
    let mut session = Session::new();
    let pick = |session: &mut Session, id: &str| session.act(&Action::Pick { id: id.to_owned() });
    pick(&mut session, "v1");
    assert_eq!(text(&pick(&mut session, "v4")), "split_face h2 h8 returned h12, f2");
    session.act(&Action::Leave);
    pick(&mut session, "v0");
    let again = pick(&mut session, "v1");
    assert!(refused(&again), "{:?}", again.message);
    let library = plane(&session).can_split_face(HalfEdgeId::new(0), HalfEdgeId::new(2)).unwrap_err();
    // The refusal is that of some pair of half-edges at the two corners.
    assert!(again.message.unwrap().elements.iter().any(|name| library.to_string().contains(name)));
    session.act(&Action::Leave);
    pick(&mut session, "v0");
    let far = pick(&mut session, "v3");
    assert_eq!(text(&far), "h0 bounds f2, but h6 bounds f1: choose two half-edges of the same face");
    // Along a side, the half-edges within the face are meant, and the vertex between them is named.
    session.act(&Action::Leave);
    pick(&mut session, "v0");
    let along = pick(&mut session, "v2");
    assert!(refused(&along) && along.message.as_ref().unwrap().elements.contains(&"v1".to_owned()), "{along:?}");
}

#[test]
fn clicks_hit_what_is_drawn_there() {
    let mut session = Session::new();
    session.act(&Action::Resize { width: 830.0, height: 620.0 });
    let s = plane(&session);
    let places: Vec<_> = s.vertices().map(|v| (v.to_string(), session.canvas.place(s.point(v)).unwrap())).collect();
    for (name, at) in places {
        let hover = Action::Hover { x: at.x + 3.0, y: at.y - 2.0, reach: 10.0 };
        assert_eq!(session.act(&hover).hover, Some(name));
    }
    for h in s.half_edges() {
        let [a, b] = [s.origin(h), s.destination(h)].map(|v| session.canvas.place(s.point(v)).unwrap());
        // Four pixels to the left of the middle: y points down.
        let along = b - a;
        let middle = (a + b) * 0.5;
        let (x, y) = (middle.x + 4.0 * along.y / along.length(), middle.y - 4.0 * along.x / along.length());
        assert_eq!(session.act(&Action::Hover { x, y, reach: 10.0 }).hover, Some(h.to_string()));
    }
    let middle = session.canvas.place(crate::plane::Point::new(10.0, 20.0)).unwrap();
    assert_eq!(session.act(&Action::Hover { x: middle.x, y: middle.y, reach: 10.0 }).hover, Some("f1".to_owned()));
}

#[test]
fn other_room_changes_the_picture_alone() {
    let mut session = Session::new();
    let room = |width| Action::Resize { width, height: 620.0 };
    session.act(&room(700.0));
    script(&mut session, "split_face h2 h8");
    session.act(&Action::Pick { id: "h12".to_owned() });
    assert_eq!(session.act(&room(700.0)), Reply::default(), "the same room");
    let reply = session.act(&room(500.0));
    assert!(reply.svg.as_ref().unwrap().contains("viewBox=\"0 0 500 "), "{reply:?}");
    assert_eq!(Reply { svg: None, ..reply }, Reply::default());
    // Where half-edges are not drawn, what was refused is marked anew, until something else is done.
    let corners = (0..61 * 61).map(|i| format!("v {} {} 0\n", i % 61, i / 61));
    let squares =
        (0..60 * 60).map(|i| i % 60 + i / 60 * 61 + 1).map(|a| format!("f {a} {} {} {}\n", a + 1, a + 62, a + 61));
    let text: String = corners.chain(squares).collect();
    assert!(!refused(&session.open("grid.obj", text.as_bytes())));
    let marked = |reply: &Reply| reply.over.as_ref().unwrap().matches("mark bad").count();
    let no = script(&mut session, "split_face h0 h9");
    let moved = session.act(&room(650.0));
    assert!(refused(&no) && marked(&no) > 2 && no.over != moved.over);
    assert_eq!(marked(&moved), marked(&no));
    session.act(&Action::Pick { id: "v3".to_owned() });
    let over = session.act(&room(600.0)).over.unwrap();
    assert!(over.contains("class=\"mark\"") && !over.contains("bad"));
}

#[test]
fn a_dragged_corner_moves_while_that_is_legal() {
    let mut session = Session::new();
    session.act(&Action::Resize { width: 830.0, height: 620.0 });
    script(&mut session, "split_face h2 h8");
    let at = |session: &Session, x, y| session.canvas.place(crate::plane::Point::new(x, y)).unwrap();
    let near = at(&session, -200.0, -100.0);
    let held = session.act(&Action::Drag { id: "v0".to_owned(), x: near.x, y: near.y });
    assert!(!refused(&held) && held.over.unwrap().contains("class=\"drag\""));
    let across = at(&session, 100.0, 0.0);
    let held = session.act(&Action::Drag { id: "v0".to_owned(), x: across.x, y: across.y });
    assert!(refused(&held) && held.over.as_ref().unwrap().contains("drag bad"), "{held:?}");
    let before = session.link();
    assert!(refused(&session.act(&Action::Drop { id: "v0".to_owned(), x: across.x, y: across.y })));
    assert_eq!(session.link(), before);
    let moved = session.act(&Action::Drop { id: "v0".to_owned(), x: near.x, y: near.y });
    assert!(text(&moved).starts_with("set_point v0 -200 -100"), "{}", text(&moved));
}

#[test]
fn a_wrong_line_is_named_and_nothing_is_done() {
    let mut session = Session::new();
    script(&mut session, "split_in_half h0");
    let before = session.link();
    let whole = script(&mut session, "rectangle\nsplit_face h2 h8\n\n\n# a comment\n\nsplit_fase h0 h4\n");
    assert!(text(&whole).starts_with("script:7:1: "), "{}", text(&whole));
    let lines = script(&mut session, "split_in_half h2\nsplit_in_half h4\nsplit_in_half h999\n");
    assert!(text(&lines).contains("line 3") && text(&lines).contains("nothing was done"), "{}", text(&lines));
    assert_eq!(session.link(), before);
    for line in [
        "split_face h2",
        "let = 3",
        "let split_face = h0",
        "split_face h0 h1.nxt",
        "caption",
        "#",
        "",
        "let h7 = split_in_half h0",
    ] {
        let reply = script(&mut session, line);
        assert!(refused(&reply) || line.is_empty() || line == "#", "{line}: {reply:?}");
        assert_eq!(session.link(), before, "{line}");
    }
    let named = script(&mut session, "let door = split_face h2 h8");
    assert!(!refused(&named), "{named:?}");
    assert!(!refused(&script(&mut session, "split_in_half door")));
    assert!(refused(&script(&mut session, "let door = split_in_half h4")), "the name is taken");
    let saved = saved(&mut session, "script");
    assert!(saved.contains("let door = split_face h2 h8") && saved.contains("split_in_half door"), "{saved}");
}

#[test]
fn files_that_are_no_drawings_leave_the_scene() {
    let mut session = Session::new();
    let before = session.link();
    let files: [(&str, &[u8]); 6] = [
        ("photo.jpg", b"\xff\xd8\xff\xe0\x00\x10JFIF"),
        ("bad.obj", b"v 0 0\nv 1 x\n"),
        ("empty.dcel", b""),
        ("broken.dcel", b"dcel 1\nv0 0 0 out h0\nv1 1 0 out h1\nh0 origin v0 twin h1 next h0 prev h1 face f0\nh1 origin v1 twin h0 next h0 prev h0 face f0\nf0 outer half_edge h0 inner none\n"),
        ("half.geojson", b"{\"type\": \"Polygon\", \"coordinates\": [[[0,0],[1"),
        ("large.obj", &[b' '; 6 << 20]),
    ];
    for (name, bytes) in files {
        let reply = session.open(name, bytes);
        assert!(refused(&reply), "{name}: {:?}", reply.message);
        assert_eq!(session.link(), before, "{name}");
    }
    assert!(text(&session.open("bad.obj", b"v 0 0\nv 1 x\n")).starts_with("bad.obj:2:5: `x` is not a number"));
    let good = session.open("square.obj", b"v 0 0\nv 4 0\nv 4 4\nv 0 4\nf 1 2 3\nf 1 3 4\n");
    assert!(!refused(&good), "{good:?}");
    assert_eq!(plane(&session).face_count(), 3);
    // What is opened is edited, linked and saved like everything else.
    script(&mut session, "split_in_half h0");
    let mut other = Session::new();
    other.act(&Action::Link { text: session.link() });
    assert_eq!(plane(&other), plane(&session));
    let saved = saved(&mut session, "dcel");
    let mut third = Session::new();
    assert!(!refused(&third.open("again.dcel", saved.as_bytes())));
    assert!(isomorphic(&plane(&third), &plane(&session)).is_ok());
}

#[test]
fn a_pointer_that_is_led_elsewhere_breaks_invariants_until_it_is_mended() {
    let mut session = Session::new();
    let sound = session.link();
    let reply = session.act(&Action::Break { id: "h2".to_owned(), pointer: "next".to_owned(), to: "h8".to_owned() });
    let faults = reply.status.unwrap().violations;
    let mut table = Table::from_planar_view(&Subdivision::lab_rectangle());
    table.half_edges[2].as_mut().unwrap().next = Some(HalfEdgeId::new(8));
    let expected: Vec<String> = crate::topology::violations(&table).iter().map(ToString::to_string).collect();
    assert_eq!(faults.iter().map(|fault| fault.text.clone()).collect::<Vec<_>>(), expected);
    assert!(faults.iter().any(|fault| fault.elements.contains(&"h2".to_owned())));
    assert!(refused(&script(&mut session, "split_face h2 h8")), "no edit on a broken structure");
    let mut other = Session::new();
    assert!(!refused(&other.act(&Action::Link { text: session.link() })));
    assert_eq!(other.violations(), expected);
    session.act(&Action::Mend);
    assert_eq!(session.link(), sound);
    session.act(&Action::Break { id: "f1".to_owned(), pointer: "half_edge".to_owned(), to: "none".to_owned() });
    session.act(&Action::Undo);
    assert_eq!(session.link(), sound);
}

#[test]
fn points_keep_their_triangulation_and_become_a_structure() {
    let mut session = Session::new();
    session.act(&Action::Start { what: "points".to_owned() });
    session.act(&Action::Over { what: "voronoi".to_owned() });
    let s = plane(&session);
    assert_eq!(s.non_delaunay_edges(|_| false).count(), 0);
    let held = session.act(&Action::Drag { id: "v5".to_owned(), x: 400.0, y: 300.0 });
    assert!(held.svg.is_some() && held.over.unwrap().contains("voronoi"));
    assert_eq!(plane(&session), s, "a point that is held is not moved yet");
    session.act(&Action::Drop { id: "v5".to_owned(), x: 400.0, y: 300.0 });
    assert_eq!(plane(&session).non_delaunay_edges(|_| false).count(), 0);
    session.act(&Action::Undo);
    assert_eq!(plane(&session), s);
    session.act(&Action::Keep);
    assert!(!refused(&script(&mut session, "split_in_half h0")));
}

#[test]
fn a_torus_is_drawn_and_edited_without_places() {
    let mut session = Session::new();
    let begun = session.act(&Action::Start { what: "torus".to_owned() });
    assert!(begun.svg.unwrap().contains("id=\"play-0-h0\""));
    assert!(begun.status.unwrap().euler.ends_with("genus 1"));
    session.act(&Action::Pick { id: "h0".to_owned() });
    assert!(!refused(&session.act(&Action::Edit { word: "split_edge".to_owned() })));
    assert!(saved(&mut session, "script").starts_with("torus\nlet a1 = split_edge h0"));
    assert!(saved(&mut session, "play").contains("<svg"));
}

#[test]
fn a_script_of_any_start_begins_a_scene() {
    let starts = [
        ("polygon 0 0 4 0 0 4", "plane"),
        ("# a pyramid\nmesh 0 0 0 1 0 0 0 1 0 0 0 1 / 0 2 1 / 0 1 3 / 1 2 3 / 0 3 2", "plane"),
        ("solid cube", "plane"),
        ("ring 5", "kernel"),
    ];
    for (text, scene) in starts {
        let mut session = Session::new();
        let reply = script(&mut session, text);
        assert!(!refused(&reply), "{text}: {:?}", reply.message);
        assert_eq!(reply.status.unwrap().scene, scene, "{text}");
    }
}
