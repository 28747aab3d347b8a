//! Dependencies between the folders of `src` point one way:
//! `mesh ← geometry ← operator ← energy ← remesh ← flow ← app ← web`,
//! with `io`, `linalg` and `viewer` beside, knowing no flow.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// What each module of the crate may name of the others, besides itself. Tests at the
/// foot of a file (`#[cfg(test)]`) are free.
const ALLOWED: &[(&str, &[&str])] = &[
    ("bibliography", &[]),
    ("arrays", &[]),
    ("deferred", &[]),
    ("message", &[]),
    ("order", &[]),
    ("soup", &["order"]),
    ("interrupt", &[]),
    ("linalg", &["interrupt", "message", "order"]),
    ("io", &["interrupt", "message", "order", "soup"]),
    ("mesh", &["interrupt", "message", "order", "soup"]),
    ("viewer", &["message", "soup"]),
    ("geometry", &["interrupt", "order", "mesh"]),
    ("operator", &["interrupt", "mesh", "geometry", "linalg"]),
    (
        "energy",
        &["interrupt", "mesh", "geometry", "operator", "linalg"],
    ),
    (
        "flow",
        &[
            "interrupt",
            "message",
            "order",
            "mesh",
            "geometry",
            "operator",
            "energy",
            "remesh",
            "linalg",
        ],
    ),
    (
        "remesh",
        &[
            "interrupt",
            "message",
            "order",
            "soup",
            "mesh",
            "geometry",
            "operator",
            "energy",
            "linalg",
        ],
    ),
    (
        "app",
        &[
            "interrupt",
            "message",
            "order",
            "soup",
            "arrays",
            "io",
            "mesh",
            "geometry",
            "operator",
            "energy",
            "flow",
            "remesh",
            "linalg",
        ],
    ),
    (
        "web",
        &[
            "interrupt",
            "message",
            "app",
            "deferred",
            "viewer",
            "io",
            "mesh",
            "energy",
            "flow",
            "linalg",
        ],
    ),
];

/// Lines of code, without comments, blanks and the tests at the foot, beyond which a file
/// is no longer one idea.
const MAX_LINES: usize = 400;

#[test]
fn modules_use_only_what_stands_below_them() {
    let mut wrong = Vec::new();
    for file in sources() {
        let module = module_of(&file);
        if module == "lib" || module == "bin" {
            continue;
        }
        let Some((_, allowed)) = ALLOWED.iter().find(|(name, _)| *name == module) else {
            panic!(
                "{} is in no layer: add `{module}` to ALLOWED",
                file.display()
            );
        };
        let text = read(&file);
        for used in crate_modules(&text) {
            if used != module && !allowed.contains(&used.as_str()) {
                wrong.push(format!(
                    "{}: `{module}` may not use `{used}`",
                    file.display()
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn no_files_use_each_other_in_a_circle() {
    let mut uses: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let files: BTreeMap<String, PathBuf> = sources()
        .into_iter()
        .map(|file| (path_of(&file), file))
        .collect();
    for (name, file) in &files {
        let own: Vec<&str> = name.split("::").filter(|part| !part.is_empty()).collect();
        // A folder's `mod.rs` gathers its files: neither uses the other.
        let gathers = |a: &str, b: &str| a.is_empty() || b.starts_with(&format!("{a}::"));
        let found = used_paths(&read(file), &own)
            .into_iter()
            .filter_map(|path| longest_file(&path, &files))
            .filter(|used| used != name && !gathers(used, name) && !gathers(name, used));
        uses.insert(name.clone(), found.collect());
    }
    let circles: Vec<&String> = uses
        .keys()
        .filter(|name| reaches(name, name, &uses))
        .collect();
    assert!(circles.is_empty(), "in a circle: {circles:?}");
}

/// Whether a file uses another, by way of others or not.
fn reaches(from: &str, to: &str, uses: &BTreeMap<String, BTreeSet<String>>) -> bool {
    let mut seen = BTreeSet::new();
    let mut open = vec![from];
    while let Some(name) = open.pop() {
        for used in uses.get(name).into_iter().flatten() {
            if used == to {
                return true;
            }
            if seen.insert(used) {
                open.push(used);
            }
        }
    }
    false
}

/// The file that a path leads to.
fn longest_file(path: &[String], files: &BTreeMap<String, PathBuf>) -> Option<String> {
    (1..=path.len())
        .rev()
        .map(|n| path[..n].join("::"))
        .find(|name| files.contains_key(name))
}

/// The path of a file's module, empty for the crate's root.
fn path_of(file: &Path) -> String {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let inside = file.strip_prefix(source).expect("file is below src");
    let inside = inside.with_extension("");
    let parts = inside
        .iter()
        .map(|part| part.to_string_lossy().into_owned());
    let parts: Vec<String> = parts
        .filter(|part| part != "mod" && part != "lib")
        .collect();
    parts.join("::")
}

/// Paths from the crate's root that the code of the module `own` names.
fn used_paths(text: &str, own: &[&str]) -> Vec<Vec<String>> {
    let code = code(text).collect::<Vec<_>>().join("\n");
    let mut found = Vec::new();
    for (start, found_at) in code.match_indices("crate::") {
        expand(&code[start + found_at.len()..], &[], &mut found);
    }
    let mut after = 0;
    for (start, _) in code.match_indices("super::") {
        // Of `super::super::x` the first only.
        if start < after {
            continue;
        }
        let (mut rest, mut base) = (&code[start..], own);
        while let Some(next) = rest.strip_prefix("super::") {
            base = &base[..base.len().saturating_sub(1)];
            rest = next;
        }
        after = code.len() - rest.len();
        let base: Vec<String> = base.iter().map(|part| (*part).to_owned()).collect();
        expand(rest, &base, &mut found);
    }
    found
}

/// Appends a path, and the groups in it, to `base`.
fn expand(path: &str, base: &[String], found: &mut Vec<Vec<String>>) {
    if let Some(group) = path.strip_prefix('{') {
        for item in items(group) {
            expand(item.trim(), base, found);
        }
        return;
    }
    let name = identifier(path);
    let mut whole = base.to_vec();
    if !name.is_empty() && name != "self" {
        whole.push(name.clone());
    }
    match path[name.len()..].strip_prefix("::") {
        Some(rest) if !name.is_empty() => expand(rest, &whole, found),
        _ => found.push(whole),
    }
}

#[test]
fn files_are_short() {
    let long: Vec<String> = sources()
        .into_iter()
        .map(|file| (code_lines(&read(&file)), file))
        .filter(|(lines, _)| *lines > MAX_LINES)
        .map(|(lines, file)| format!("{}: {lines} lines", file.display()))
        .collect();
    assert!(
        long.is_empty(),
        "over {MAX_LINES} lines of code:\n{}",
        long.join("\n")
    );
}

#[test]
fn uses_are_found_however_they_are_written() {
    let text = "
use crate::mesh::Halfedge;
use crate::{energy::circle::{self, Star}, flow, web::x as y};
//! [`crate::app`] is only named
let x = crate::io::read(&bytes); // and crate::viewer is a comment
pub(crate) fn f() {}
#[cfg(test)]
mod tests { use crate::remesh; }
";
    let found: Vec<String> = crate_modules(text).into_iter().collect();
    assert_eq!(found, ["energy", "flow", "io", "mesh", "web"]);
}

/// Every Rust file below `src`.
fn sources() -> Vec<PathBuf> {
    let mut files = Vec::new();
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("src")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("src is readable") {
            let path = entry.expect("src is readable").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                files.push(path);
            }
        }
    }
    assert!(files.len() > 20, "found only {} files", files.len());
    files.sort();
    files
}

fn read(file: &Path) -> String {
    fs::read_to_string(file).expect("source is readable")
}

/// Name of the crate's top-level module that a file belongs to.
fn module_of(file: &Path) -> String {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let inside = file.strip_prefix(source).expect("file is below src");
    let first = inside
        .iter()
        .next()
        .expect("file has a name")
        .to_string_lossy();
    first.trim_end_matches(".rs").to_owned()
}

/// The lines of code before the tests at the foot, without comments.
fn code(text: &str) -> impl Iterator<Item = &str> {
    text.lines()
        .take_while(|line| line.trim() != "#[cfg(test)]")
        .map(|line| line.split("//").next().unwrap_or_default())
}

fn code_lines(text: &str) -> usize {
    code(text).filter(|line| !line.trim().is_empty()).count()
}

/// Top-level modules named by paths that begin with `crate::`.
fn crate_modules(text: &str) -> BTreeSet<String> {
    let code = code(text).collect::<Vec<_>>().join("\n");
    code.split("crate::")
        .skip(1)
        .flat_map(|path| match path.strip_prefix('{') {
            Some(group) => first_level(group),
            None => vec![identifier(path)],
        })
        .collect()
}

/// First identifiers of the items of a `{…}` group, whose opening brace is gone.
fn first_level(group: &str) -> Vec<String> {
    items(group)
        .iter()
        .map(|item| identifier(item))
        .filter(|name| !name.is_empty())
        .collect()
}

/// The items of a `{…}` group, whose opening brace is gone.
fn items(group: &str) -> Vec<String> {
    let mut depth = 1;
    let mut items = vec![String::new()];
    for c in group.chars() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 1 => items.push(String::new()),
            _ => {}
        }
        if depth == 0 {
            break;
        }
        if let Some(item) = items.last_mut() {
            item.push(c);
        }
    }
    items
        .iter()
        .map(|item| item.trim_start_matches([',', ' ', '\n']).to_owned())
        .collect()
}

/// The identifier that a text begins with.
fn identifier(text: &str) -> String {
    text.chars()
        .take_while(|c| c.is_ascii_alphanumeric() || *c == '_')
        .collect()
}
