//! What a figure calls what is stored.

use super::figure::Figure;

impl Figure {
    /// The words shown for a stored value. Parts of it whose words are none are left out.
    pub fn label(&self, value: &str) -> String {
        self.labels.get(value).cloned().unwrap_or_else(|| {
            let parts = value.split(" · ");
            let shown = parts.map(|part| self.labels.get(part).map_or(part, String::as_str));
            shown.filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" · ")
        })
    }
}
