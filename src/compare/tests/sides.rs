//! Files and folders.

use super::*;
use crate::table::write_json;
use std::fs;

/// A folder of its own, removed when the test ends.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path =
            std::env::temp_dir().join(format!("ray_test-side-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Folder(path)
    }

    fn write(&self, experiment: &str, rows: Vec<Row>) {
        fs::create_dir_all(self.0.join(experiment)).unwrap();
        let run = &side(rows).sources[0].run;
        write_json(&self.0.join(experiment).join("rows.json"), run).unwrap();
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        fs::remove_dir_all(&self.0).ok();
    }
}

#[test]
fn a_file_a_folder_and_a_folder_of_folders() {
    let folder = Folder::new("read");
    folder.write("b", rows());
    folder.write("a", vec![Row { experiment: "a".into(), ..rows().remove(0) }]);
    let whole = Side::read(&folder.0).unwrap();
    assert_eq!(whole.rows().count(), 7);
    assert!(whole.sources[0].path.ends_with("a/rows.json"));
    for path in ["b", "b/rows.json"] {
        assert_eq!(Side::read(&folder.0.join(path)).unwrap().rows().count(), 6);
    }
    assert_eq!(at_3_percent(&base(), &whole).added.len(), 1);
    let ids = ["b".to_owned(), "c".to_owned()];
    assert_eq!(Side::read_experiments(&folder.0, &ids).unwrap().sources.len(), 1);
    assert_eq!(whole.unfinished().count(), 0);
}

#[test]
fn what_is_no_result_is_told() {
    let folder = Folder::new("none");
    let message = |path: &std::path::Path| Side::read(path).unwrap_err().to_string();
    assert!(message(&folder.0).contains("no rows.json"));
    assert!(message(&folder.0.join("missing")).contains("missing"));
    folder.write("empty", vec![]);
    assert!(message(&folder.0).contains("no rows; allowed"));
    let file = folder.0.join("rows.json");
    fs::write(&file, "not json").unwrap();
    assert!(message(&folder.0).contains("line 1"));
    let text = serde_json::to_string(&RunFile {
        schema_version: "2.0".into(),
        ..base().sources[0].run.clone()
    });
    fs::write(&file, text.unwrap()).unwrap();
    assert!(message(&file).contains("schema_version '2.0'"));
}
