//! What plotters leaves undone in the SVG text: scale, title, description, role.

/// Attributes of plotters' elements that are lengths.
const LENGTHS: [&str; 14] = [
    "x",
    "y",
    "x1",
    "y1",
    "x2",
    "y2",
    "cx",
    "cy",
    "r",
    "width",
    "height",
    "points",
    "font-size",
    "stroke-width",
];

/// What is the same for every text stands once, at the root.
const INHERITED: &str = "font-family";

/// Attributes that say what holds without them.
const DEFAULTS: [(&str, &str); 3] =
    [("opacity", "1"), ("stroke", "none"), ("text-anchor", "start")];

/// Divides every length by `factor`, drops the fixed size (so that the picture scales; the viewBox
/// stays), centres texts on their capitals, and says nothing twice: a figure is half as large then.
pub(super) fn scaled(drawn: &str, factor: f64) -> String {
    let mut out = String::with_capacity(drawn.len() / 2);
    let mut lines = Lines::default();
    let mut rest = drawn;
    while let Some(start) = rest.find('<') {
        let Some(end) = rest[start..].find('>').map(|end| start + end + 1) else { break };
        // Text between tags: plotters puts it on a line of its own.
        let words = rest[..start].trim();
        let tag = tag(&rest[start..end], factor);
        rest = &rest[end..];
        if lines.takes(&tag) {
            continue;
        }
        lines.end(&mut out);
        // A line of another look.
        if lines.takes(&tag) {
            continue;
        }
        out.push_str(words);
        if words.is_empty() && !out.is_empty() && !tag.starts_with("</text") {
            out.push('\n');
        }
        out.push_str(&tag);
    }
    out.push('\n');
    inherited(&out)
}

/// Lines of one look that follow each other, such as the parts of a dashed one: a single path.
#[derive(Default)]
struct Lines {
    look: String,
    places: Vec<String>,
}

impl Lines {
    /// Whether a tag is a line that goes on with those before; if so, it is taken.
    fn takes(&mut self, tag: &str) -> bool {
        let parts = tag.strip_prefix("<polyline").and_then(|tag| tag.split_once(" points=\""));
        let Some((look, end)) = parts else { return false };
        // Where lines that are not opaque cross, a single path would look different.
        let goes_on = self.places.is_empty() || (self.look == look && !look.contains("opacity"));
        if goes_on {
            self.look = look.to_owned();
            self.places.push(end.trim_end_matches("\"/>").to_owned());
        }
        goes_on
    }

    /// Writes what was taken.
    fn end(&mut self, out: &mut String) {
        match self.places.as_slice() {
            [] => {}
            [only] => *out += &format!("\n<polyline{} points=\"{only}\"/>", self.look),
            several => {
                *out += &format!("\n<path{} d=\"M{}\"/>", self.look, several.join("M"));
            }
        }
        self.places.clear();
    }
}

/// Moves an attribute that all texts share to the root.
fn inherited(drawn: &str) -> String {
    let start = format!(" {INHERITED}=\"");
    let Some(place) = drawn.find(&start) else { return drawn.to_owned() };
    let length = drawn[place + start.len()..].find('"').map_or(0, |end| start.len() + end + 1);
    let attribute = &drawn[place..place + length];
    drawn.replace(attribute, "").replacen("<svg", &format!("<svg{attribute}"), 1)
}

fn tag(tag: &str, factor: f64) -> String {
    let root = tag.starts_with("<svg");
    // A width of no line.
    let unseen = if tag.contains(" stroke=\"none\"") { "stroke-width" } else { "" };
    let mut out = String::with_capacity(tag.len());
    let mut parts = tag.split('"');
    // A tag is: name attribute=" value " attribute=" value " end.
    while let Some(before) = parts.next() {
        let Some(value) = parts.next() else {
            out.push_str(before);
            break;
        };
        let name = before.trim_end_matches('=').rsplit(' ').next().unwrap_or("");
        let size = root && (name == "width" || name == "height");
        let said = name == unseen || (!root && DEFAULTS.contains(&(name, value)));
        if size || said {
            out.push_str(before.trim_end_matches('=').trim_end_matches(name).trim_end());
            continue;
        }
        let value = match name {
            "dy" => "0.35em".to_owned(),
            "viewBox" => numbers(value, factor),
            name if !root && LENGTHS.contains(&name) => numbers(value, factor),
            _ => value.to_owned(),
        };
        out.push_str(before);
        out.push('"');
        out.push_str(&value);
        out.push('"');
    }
    out
}

/// Numbers parted by blanks and commas, each divided.
fn numbers(value: &str, factor: f64) -> String {
    let pair = |pair: &str| {
        let scaled = pair.split(',').map(|number| {
            number.parse::<f64>().map_or(number.to_owned(), |number| {
                // Two decimals are finer than a screen, and end the noise of the division.
                let text = format!("{:.2}", number / factor);
                text.trim_end_matches('0').trim_end_matches('.').to_owned()
            })
        });
        scaled.collect::<Vec<_>>().join(",")
    };
    value.split_whitespace().map(pair).collect::<Vec<_>>().join(" ")
}

/// Gives the picture a title and a description that screen readers read out. The ids carry the
/// figure's name, so that several pictures can stand in one page.
pub(super) fn described(drawn: &str, file: &str, title: &str, description: &str) -> String {
    let name: String =
        file.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
    let head = format!("<svg role=\"img\" aria-labelledby=\"{name}-title {name}-desc\" ",);
    let inner = format!(
        ">\n<title id=\"{name}-title\">{}</title>\n<desc id=\"{name}-desc\">{}</desc>",
        escape(title),
        escape(description)
    );
    only_xml(&drawn.replacen("<svg ", &head, 1).replacen('>', &inner, 1))
}

/// The picture with a mark for each character that XML has no place for, not even escaped: names come from
/// files, and one of them must not make the whole picture unreadable.
fn only_xml(drawn: &str) -> String {
    let has_a_place =
        |c: char| !(c.is_control() || "\u{fffe}\u{ffff}".contains(c)) || "\t\n\r".contains(c);
    drawn.chars().map(|c| if has_a_place(c) { c } else { char::REPLACEMENT_CHARACTER }).collect()
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    const DRAWN: &str = concat!(
        "<svg width=\"100\" height=\"50\" viewBox=\"0 0 100 50\" xmlns=\"x\">\n",
        "<polyline fill=\"none\" opacity=\"1\" stroke=\"#111111\" stroke-width=\"10\" points=\"0,10 40,10 \"/>\n",
        "<polyline fill=\"none\" opacity=\"1\" stroke=\"#111111\" stroke-width=\"10\" points=\"70,10 110,10 \"/>\n",
        "<polyline fill=\"none\" opacity=\"1\" stroke=\"#222222\" stroke-width=\"10\" points=\"0,5 3,5 \"/>\n",
        "<polyline fill=\"none\" opacity=\"0.5\" stroke=\"#222222\" stroke-width=\"10\" points=\"0,5 3,5 \"/>\n",
        "<polyline fill=\"none\" opacity=\"0.5\" stroke=\"#222222\" stroke-width=\"10\" points=\"3,5 4,5 \"/>\n",
        "<circle cx=\"15\" cy=\"20\" r=\"35\" opacity=\"1\" fill=\"#333333\" stroke=\"none\" stroke-width=\"1\"/>\n",
        "<text x=\"5\" y=\"5\" dy=\"0.76em\" text-anchor=\"start\" font-family=\"A, B\" font-size=\"120\" ",
        "opacity=\"1\" fill=\"#444444\">\na &lt; b\n</text>\n",
        "<text x=\"5\" y=\"9\" dy=\"0.76em\" text-anchor=\"end\" font-family=\"A, B\" font-size=\"120\" ",
        "opacity=\"1\" fill=\"#444444\">\nc\n</text>\n</svg>\n",
    );

    #[test]
    fn what_xml_has_no_place_for_is_marked() {
        let drawn =
            described("<svg x=\"1\">\na\u{0}b\u{1b}c\u{fffe}\n</svg>", "f", "t\u{7}", "d\td");
        let texts = "<title id=\"f-title\">t\u{fffd}</title>\n<desc id=\"f-desc\">d\td</desc>";
        assert!(
            drawn.ends_with(&format!("{texts}\na\u{fffd}b\u{fffd}c\u{fffd}\n</svg>")),
            "{drawn}"
        );
    }

    /// Lines of one look become a path, unless they are not opaque; what goes without saying goes.
    #[test]
    fn a_picture_says_nothing_twice_and_looks_the_same() {
        let lines = [
            "<svg font-family=\"A, B\" viewBox=\"0 0 10 5\" xmlns=\"x\">",
            "<path fill=\"none\" stroke=\"#111111\" stroke-width=\"1\" d=\"M0,1 4,1M7,1 11,1\"/>",
            "<polyline fill=\"none\" stroke=\"#222222\" stroke-width=\"1\" points=\"0,0.5 0.3,0.5\"/>",
            "<polyline fill=\"none\" opacity=\"0.5\" stroke=\"#222222\" stroke-width=\"1\" points=\"0,0.5 0.3,0.5\"/>",
            "<polyline fill=\"none\" opacity=\"0.5\" stroke=\"#222222\" stroke-width=\"1\" points=\"0.3,0.5 0.4,0.5\"/>",
            "<circle cx=\"1.5\" cy=\"2\" r=\"3.5\" fill=\"#333333\"/>",
            "<text x=\"0.5\" y=\"0.5\" dy=\"0.35em\" font-size=\"12\" fill=\"#444444\">a &lt; b</text>",
            "<text x=\"0.5\" y=\"0.9\" dy=\"0.35em\" text-anchor=\"end\" font-size=\"12\" fill=\"#444444\">c</text>",
            "</svg>",
        ];
        assert_eq!(scaled(DRAWN, 10.0).trim().lines().collect::<Vec<_>>(), lines);
    }
}
