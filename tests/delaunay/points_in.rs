//! Reading points: plain text, and the points of other formats.

use dcel_kit::io::{ReadOptions, points_from_text, read_points};
use dcel_kit::plane::Point;

#[test]
fn plain_points_in_every_way_to_write_them() {
    let expected = [(0., 0.), (4., 0.5), (-3., 2e3)].map(Point::from);
    for text in [
        "0 0\n4 0.5\n-3 2e3\n",
        "x,y\n0,0\n4,0.5\n-3,2e3",
        "\"lon\";\"lat\"\r\n0;0\r\n4; .5\r\n-3;2e3\r\n",
        "# sites\n3\n\n0\t0 # first\n4, 0.5\n-3 2000\n",
    ] {
        assert_eq!(points_from_text(text.as_bytes(), "t").unwrap().points, expected, "{text:?}");
    }
    assert_eq!(points_from_text(b"# a\nx y\n0 0\n\n1 1\n", "t").unwrap().lines, [3, 5]);
}

#[test]
fn bad_points_are_named_with_their_place() {
    for (text, error) in [
        ("0 0\n4\n", "t:2:2: expected the y of the point"),
        ("0 0\nx y\n", "t:2:1: `x` is not a number"),
        ("0 0 0\n", "t:1:5: expected the end of the line, found `0`"),
        ("0,0\n4,oops\n", "t:2:3: `oops` is not a number"),
        ("nan 1\n", "t:1:1: x is NaN"),
        ("1e300 1\n", "t:1:1: x = 1e300 is outside"),
        ("3\n0 0\n1 1\n", "t:1:1: expected the number of points, 2, found `3`"),
        ("", "t: "),
    ] {
        let found = points_from_text(text.as_bytes(), "t").unwrap_err().to_string();
        assert!(found.starts_with(error), "{text:?}: {found}");
    }
}

#[test]
fn any_format_with_points_gives_them() {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [
        ("a.xy", "0 0\n4 0\n0 3\n"),
        ("a.obj", "v 0 0\nv 4 0\nv 0 3\nf 1 2 3\n"),
        ("a.wkt", "LINESTRING (0 0, 4 0, 0 3)\n"),
        ("a.node", "3 2 0 0\n1 0 0\n2 4 0\n3 0 3\n"),
        ("a.poly", "3 2 0 0\n1 0 0\n2 4 0\n3 0 3\n1 0\n1 1 2\n0\n"),
        ("a.csv", "x,y\n0,0\n4,0\n0,3\n"),
    ] {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        let options = ReadOptions { y_down: true, ..ReadOptions::default() };
        let down = read_points(&path, &options).unwrap();
        let up = read_points(&path, &ReadOptions::default()).unwrap();
        assert_eq!(up.points, [(0., 0.), (4., 0.), (0., 3.)].map(Point::from), "{name}");
        assert_eq!(down.points[2], Point::new(0.0, -3.0), "{name}");
        assert!(up.place(2).contains(name), "{name}");
    }
    let error = read_points(&folder.path().join("none.xy"), &ReadOptions::default()).unwrap_err();
    assert!(error.to_string().contains("none.xy: cannot be read"), "{error}");
}
