//! What plotters leaves undone in the SVG text: scale, title, description, role.

/// Attributes of plotters' elements that are lengths.
const LENGTHS: [&str; 11] =
    ["x", "y", "x1", "y1", "x2", "y2", "width", "height", "points", "font-size", "stroke-width"];

/// Divides every length by `factor`, drops the fixed size (so that the picture scales; the viewBox
/// stays) and centres texts on their capitals.
pub(super) fn scaled(drawn: &str, factor: f64) -> String {
    let mut out = String::with_capacity(drawn.len());
    let mut rest = drawn;
    while let Some(start) = rest.find('<') {
        let Some(end) = rest[start..].find('>').map(|end| start + end + 1) else { break };
        // Text between tags: plotters puts it on a line of its own.
        out.push_str(rest[..start].trim());
        if rest[..start].trim().is_empty()
            && !out.is_empty()
            && !rest[start..].starts_with("</text")
        {
            out.push('\n');
        }
        out.push_str(&tag(&rest[start..end], factor));
        rest = &rest[end..];
    }
    out.push('\n');
    out
}

fn tag(tag: &str, factor: f64) -> String {
    let root = tag.starts_with("<svg");
    let mut out = String::with_capacity(tag.len());
    let mut parts = tag.split('"');
    // A tag is: name attribute=" value " attribute=" value " end.
    while let Some(before) = parts.next() {
        let Some(value) = parts.next() else {
            out.push_str(before);
            break;
        };
        let name = before.trim_end_matches('=').rsplit(' ').next().unwrap_or("");
        if root && (name == "width" || name == "height") {
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
    drawn.replacen("<svg ", &head, 1).replacen('>', &inner, 1)
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
