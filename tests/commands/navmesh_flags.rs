//! `dcel navmesh`: flags that can do nothing with a file, and axes that cannot be meant.

use crate::shell::Folder;

/// What can do nothing with a grid map is refused, whether its name or its first line tells what it is.
#[test]
fn flags_that_mean_nothing_on_a_grid_map_are_refused() {
    let folder = Folder::new();
    folder.dcel("sample rooms.map").fine();
    folder.dcel("convert rooms.map rooms.dcel").fine();
    for command in [
        "info MAP",
        "path MAP 1 1 22 12",
        "distances MAP 1 1",
        "locate MAP 1 1",
        "random MAP",
        "neighbours MAP f1",
        "raycast MAP 1 1 9 1",
    ] {
        for (flags, why, help) in [
            (
                "--orient",
                "--orient cannot be used on a grid map: cells always run counter-clockwise",
                "leave --orient out",
            ),
            (
                "--up z",
                "--up cannot be used on a grid map: cells lie in the plane and have no heights",
                "leave --up out",
            ),
            ("--up y --layer 0", "--up cannot be used on a grid map", "leave --up and --layer out"),
            ("--up y --max-slope 45", "--up cannot be used on a grid map", "leave --up and --max-slope out"),
            ("--mend", "--mend cannot be used on a grid map: cells always fit together", "leave --mend out"),
            ("--weld 1", "--weld cannot be used on a grid map: cells always fit together", "leave --weld out"),
        ] {
            for more in ["", " --triangles"] {
                let call = format!("navmesh {} {flags}{more}", command.replace("MAP", "rooms.map"));
                folder.dcel(&call).fails(2, why, help);
            }
        }
        for (flags, flag) in [("--orient", "--orient"), ("--up z", "--up"), ("--weld 1", "--weld")] {
            let call = format!("navmesh {} {flags}", command.replace("MAP", "rooms.dcel"));
            let why = format!("rooms.dcel: {flag} cannot be used on dcel: it is for polygons");
            folder.dcel(&call).fails(2, &why, &format!("leave {flag} out"));
        }
    }
    let map = folder.read("rooms.map");
    for flags in ["--orient", "--up z", "--mend", "--weld 1"] {
        let told = folder.dcel_with(&map, &format!("navmesh info - {flags}"));
        let flag = flags.split(' ').next().unwrap_or_default();
        told.fails(2, &format!("<stdin>: {flag} cannot be used on a grid map"), &format!("leave {flag} out"));
    }
}

/// With an axis along which all faces stand upright there is nothing to stand on: the one along which they lie is named.
#[test]
fn where_all_faces_stand_upright_the_axis_along_which_they_lie_is_named() {
    let folder = Folder::new();
    folder.dcel("sample house.obj").fine();
    for (command, up) in [("path", "y"), ("distances", "y")] {
        let ends = if command == "path" { "1 1 0 1 1 9" } else { "1 1 0" };
        folder.dcel(&format!("navmesh {command} house.obj --up {up} {ends}")).fails(
            2,
            "the start (1, 1, 0) is not on the surface",
            &format!("with --up {up} all faces stand upright, and there is nothing to stand on: try --up z"),
        );
    }
    folder.dcel("navmesh path house.obj --up z 1 1 0 1 1 9").fine();
    // Beside the floor, the nearest place is told.
    folder.dcel("navmesh path house.obj --up z 1 -1 0 1 1 9").fails(2, "is not on the surface", "--snap 1");
}
