//! Reads a picture back: tags, and where each text lies.

/// A text and the rectangle that it takes.
#[derive(Debug)]
pub struct TextBox {
    pub words: String,
    pub left: f64,
    pub right: f64,
    pub top: f64,
    pub bottom: f64,
}

impl TextBox {
    fn overlaps(&self, other: &TextBox) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }
}

/// Everything that holds for every picture.
pub fn check(svg: &str) {
    balanced(svg);
    assert!(svg.starts_with("<svg role=\"img\" aria-labelledby="), "{}", &svg[..60]);
    for part in ["<title id=", "<desc id=", "viewBox=\"0 0 ", "font-family=\"Inter, "] {
        assert!(svg.contains(part), "no {part}");
    }
    for bad in ["NaN", "inf\"", "inf ", "inf,"] {
        assert!(!svg.contains(bad), "{bad} in the picture");
    }
    let root = &svg[..svg.find('>').unwrap()];
    assert!(!root.contains("width=") && !root.contains("height="), "fixed size: {root}");
    let view: Vec<f64> =
        attribute(root, "viewBox").unwrap().split(' ').map(|n| n.parse().unwrap()).collect();
    let boxes = texts(svg);
    assert!(!boxes.is_empty());
    for (index, one) in boxes.iter().enumerate() {
        assert!(
            one.left >= 0.0 && one.top >= 0.0 && one.right <= view[2] && one.bottom <= view[3],
            "{one:?} is cut off by {view:?}"
        );
        for other in &boxes[index + 1..] {
            assert!(!one.overlaps(other), "{one:?} lies over {other:?}");
        }
    }
}

/// Every tag is closed by its own name, in the right order.
fn balanced(svg: &str) {
    let mut open: Vec<&str> = Vec::new();
    for tag in svg.split('<').skip(1) {
        let (tag, text) = tag.split_once('>').expect("a tag without an end");
        assert!(!text.contains('>'));
        assert_eq!(tag.matches('"').count() % 2, 0, "{tag}");
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name));
        } else if !tag.ends_with('/') {
            open.push(tag.split(' ').next().unwrap());
        }
    }
    assert_eq!(open, [""; 0]);
}

/// The texts with their estimated boxes: 0.58 em a character, one em high.
pub fn texts(svg: &str) -> Vec<TextBox> {
    svg.split("<text ")
        .skip(1)
        .map(|part| {
            let (tag, rest) = part.split_once('>').unwrap();
            let tag = format!("<text {tag}");
            let words = rest.split('<').next().unwrap().trim();
            let words = words
                .replace("&apos;", "'")
                .replace("&lt;", "<")
                .replace("&gt;", ">")
                .replace("&amp;", "&");
            let number = |name| attribute(&tag, name).unwrap().parse::<f64>().unwrap();
            let (x, y, size) = (number("x"), number("y"), number("font-size"));
            let (width, half) = (0.58 * size * words.chars().count() as f64, size / 2.0);
            let left = match attribute(&tag, "text-anchor").unwrap_or("start") {
                "start" => x,
                "middle" => x - width / 2.0,
                "end" => x - width,
                other => panic!("anchor {other}"),
            };
            // Upright text would need its box turned; no figure has any.
            assert!(!tag.contains("transform"));
            TextBox { words, left, right: left + width, top: y - half, bottom: y + half }
        })
        .collect()
}

/// An attribute's value.
pub fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let start = tag.find(&format!(" {name}=\""))? + name.len() + 3;
    tag[start..].split('"').next()
}

/// The checks above find what they look for.
#[test]
fn overlapping_and_cut_off_texts_are_found() {
    let figure = super::figure("file = \"f\"\nkind = \"counts\"\nquestion = \"Why?\"");
    let drawn = |places: &[(f64, f64)]| {
        let mut frame = crate::chart::frame::Frame::new(&figure, 400.0);
        let style = crate::chart::canvas::Type::new(12.0, crate::chart::palette::INK);
        places.iter().for_each(|at| frame.canvas.text(*at, "words", style));
        let svg = frame.close(&figure, 200.0, &[], "").unwrap();
        std::panic::catch_unwind(|| check(&svg)).is_ok()
    };
    assert!(drawn(&[(50.0, 100.0), (50.0, 113.0), (90.0, 100.0)]));
    assert!(!drawn(&[(50.0, 100.0), (50.0, 110.0)]));
    assert!(!drawn(&[(50.0, 100.0), (80.0, 100.0)]));
    assert!(!drawn(&[(380.0, 100.0)]));
}
