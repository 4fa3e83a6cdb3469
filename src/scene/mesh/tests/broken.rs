//! Broken files are refused with their place.

use super::*;

#[test]
fn what_is_no_mesh_is_refused() {
    let formats = "allowed: OBJ, PLY (ascii or binary), STL (ascii or binary)";
    for file in ["a.obj", "a.ply", "a.stl", "a"] {
        assert_eq!(refusal(file, []), format!("{file}: the file is empty; {formats}"));
    }
    assert_eq!(refusal("a", "text"), format!("a: the format is unknown; {formats}"));
    let text = crate::scene::mesh::load("no such file.obj").expect_err("it is not there");
    assert!(text.to_string().starts_with("no such file.obj: "), "{text}");
    let none = "allowed: at least one triangle";
    assert_eq!(refusal("a.obj", "v 0 0 0\n"), format!("a.obj: 0 vertices, no face; {none}"));
    assert_eq!(refusal("a.obj", "no mesh"), format!("a.obj: 0 vertices, no face; {none}"));
    assert_eq!(
        refusal("a.stl", "solid\nendsolid\n"),
        format!("a.stl: 0 vertices, no face; {none}")
    );
    let ply = ply_text().replace("face 4", "face 0");
    let ply = &ply[..ply.find("3 0").expect("a face")];
    assert_eq!(refusal("a.ply", ply), format!("a.ply: 4 vertices, no face; {none}"));
}

#[test]
fn indices_out_of_range_are_named() {
    let obj = "v 0 0 0\nv 1 0 0\n\nv 0 1 0\nf 1 2 3\n";
    assert_eq!(
        refusal("a.obj", format!("{obj}f 1 2 4\nf 1 2 3\n")),
        "a.obj, line 6: vertex 4 does not exist; allowed: 1 to 3"
    );
    for word in ["0", "-4", "x", "", "1.5", "99999999999999999999"] {
        let text = refusal("a.obj", format!("{obj}f 1 2 {word}/1\n"));
        let expected = format!("a.obj, line 6: '{word}' is no vertex; allowed: 1 to the number of");
        assert!(text.starts_with(&expected), "{text}");
    }
    let ply = ply_text().replace("3 1 2 3", "3 1 2 4");
    assert_eq!(
        refusal("a.ply", ply),
        "a.ply, line 17, face 2: vertex 4 does not exist; allowed: 0 to 3"
    );
    let mut bytes = ply_binary(false);
    let end = bytes.len();
    bytes[end - 4..].fill(0xff);
    assert_eq!(refusal("a.ply", bytes), "a.ply: face 3: vertex -1 does not exist; allowed: 0 to 3");
}

#[test]
fn numbers_that_f32_cannot_hold_are_named() {
    let allowed = "allowed: numbers from -3.4028235e38 to 3.4028235e38";
    for (word, shown) in [("nan", "NaN"), ("-inf", "-inf"), ("1e39", "1e39"), ("1e999", "inf")] {
        let obj = format!("v 0 0 0\nv 1 0 0\nv 0 {word} 0\nf 1 2 3\n").replace("1e39", "1e39");
        let text = refusal("a.obj", obj);
        let shown = if word == "1e39" { format!("{}", 1e39) } else { shown.to_owned() };
        assert_eq!(text, format!("a.obj, line 3: y is {shown}; {allowed}"));
    }
    let ply = ply_text().replace("0 1 0", "0 1e39 0");
    assert_eq!(refusal("a.ply", ply), format!("a.ply, line 13, vertex 2: y is inf; {allowed}"));
    let ply = refusal("a.ply", ply_text().replace("0 1 0", "0 nan 0"));
    assert!(ply.starts_with("a.ply, line 13, vertex 2: "), "{ply}");
    for (file, mut bytes) in [("b.ply", ply_binary(false)), ("b.stl", stl_binary(""))] {
        // The first number of the first vertex.
        let at = if file == "b.ply" { ply_header("binary_little_endian").len() } else { 96 };
        bytes[at..at + 4].copy_from_slice(&f32::NAN.to_le_bytes());
        let text = refusal(file, bytes);
        assert!(text.ends_with(&format!(" 0: x is NaN; {allowed}")), "{text}");
    }
    let stl = refusal("a.stl", stl_text("").replace("1 0 0", "nan 0 0"));
    assert!(stl.starts_with("a.stl, line 6: "), "{stl}");
}

#[test]
fn what_is_cut_short_is_refused_at_every_byte() {
    for (file, bytes) in files() {
        // Texts may lose what ends the last line, STL even the last word: it need not be whole.
        let needed = match file {
            "a.obj" => obj_text().rfind("\nf").expect("a face"),
            "a.stl" => bytes.len() - " a\n".len(),
            "a.ply" => bytes.len() - 2,
            _ => bytes.len(),
        };
        for length in 0..needed {
            if file == "a.obj" && length > obj_text().find("f 1").expect("a face") {
                // Fewer faces are a mesh, too.
                break;
            }
            let text = refusal(file, &bytes[..length]);
            assert!(text.contains("allowed: "), "{length}: {text}");
        }
    }
    let mut bytes = stl_binary("");
    bytes.pop();
    assert_eq!(
        refusal("b.stl", bytes),
        "b.stl: 283 bytes, but byte 80 announces 4 triangles; allowed: 284 bytes"
    );
    let mut bytes = ply_binary(false);
    bytes.pop();
    let text = refusal("b.ply", bytes);
    assert!(
        text.starts_with("b.ply: face 3: ") && text.ends_with("allowed: 4 whole ones"),
        "{text}"
    );
}

#[test]
fn wrong_counts_are_refused() {
    let more = refusal("a.ply", ply_text().replace("face 4", "face 5"));
    assert!(more.contains("face 4: ") || more.contains("face': 5 announced"), "{more}");
    let fewer = refusal("a.ply", ply_text().replace("face 4", "face 3"));
    assert!(fewer.starts_with("a.ply: 8 bytes behind the last element; allowed"), "{fewer}");
    for count in ["99999999999", "18446744073709551615", "99999999999999999999999"] {
        for text in [ply_text().into_bytes(), ply_binary(true)] {
            let text =
                String::from_utf8_lossy(&text).replace("vertex 4", &format!("vertex {count}"));
            let message = refusal("a.ply", text);
            assert!(message.contains("cut short") || message.contains("line 4"), "{message}");
        }
    }
    let empty = ply_text().replace("end_header", "element nothing 99999999999\nend_header");
    let message = refusal("a.ply", empty);
    assert!(message.contains("'nothing' has no property"), "{message}");
    let mut stl = stl_binary("");
    stl[80..84].fill(0xff);
    assert!(refusal("b.stl", stl).contains("announces 4294967295 triangles"));
}

#[test]
fn headers_without_what_a_mesh_needs_are_refused() {
    let flat = refusal("a.ply", ply_text().replace("property float z\n", ""));
    assert_eq!(flat, "a.ply: element 'vertex'; allowed: with the numbers x, y and z");
    let other = refusal("a.ply", ply_text().replace("vertex_indices", "corners"));
    assert_eq!(other, "a.ply: element 'face'; allowed: with a list 'vertex_indices'");
    let number = refusal("a.ply", ply_text().replace("uchar int vertex", "uchar float vertex"));
    assert!(number.contains("face 0"), "{number}");
    let line = refusal("a.ply", ply_text().replace("comment", "remark"));
    assert!(line.starts_with("a.ply, line 3: "), "{line}");
    let endless = refusal("a.ply", ply_text().replace("end_header", "end"));
    assert!(endless.starts_with("a.ply: no 'end_header'; allowed"), "{endless}");
}

#[test]
fn lines_that_are_no_lines_of_the_format_are_named() {
    for line in ["v 1 2", "v 1 2 x", "v 1 2 3 0", "v 1 2 3 4 5", "v \u{fffd} 2 3"] {
        let text = refusal("a.obj", format!("v 0 0 0\n{line}\nf 1 1 1\n"));
        assert!(text.starts_with("a.obj, line 2: ") && text.contains("; allowed: "), "{text}");
    }
    let text = refusal("a.obj", b"v 0 0 0\nv 1 \xff 1\n");
    assert_eq!(text, "a.obj, line 2: not UTF-8; allowed: UTF-8");
    let stl = stl_text("").replacen("endloop", "end", 2);
    assert!(refusal("a.stl", stl).starts_with("a.stl, line 7: "));
    let late = stl_text("") + "\n" + &stl_text("").replacen("outer", "inner", 1);
    let line = stl_text("").lines().count() + 4;
    let text = refusal("a.stl", late);
    assert!(text.starts_with(&format!("a.stl, line {line}: ")), "{text}");
    let text = refusal("a.stl", stl_text("") + "\nmore\n");
    assert!(text.starts_with("a.stl, line "), "{text}");
    let text = refusal("a.stl", "\n\nfacet\n");
    assert_eq!(text, "a.stl, line 3: allowed: 'solid' and a name, or a binary file");
    let long = format!("v 0 0 0\nf {}", "1 ".repeat(1 << 20));
    assert_eq!(refusal("a.obj", long), "a.obj, line 2: allowed: lines of at most 1048576 bytes");
    let long = format!("solid\nfacet {}", "1 ".repeat(1 << 20));
    let text = refusal("a.stl", long);
    assert!(text.starts_with("a.stl, line 2: the line has more than 1048576 bytes; allowed: "));
}
