//! The TypeScript declarations of everything that crosses to JavaScript, written from the Rust
//! types: nobody writes them twice.

use crate::app::{Fault, Frame, RunAnswer, RunCommand, ToolAnswer, ToolCommand};
use std::collections::BTreeMap;
use std::path::Path;
use ts_rs::{Config, TS, TypeVisitor};

const FILE: &str = "www/generated/types.d.ts";

/// Declarations by name.
struct Declarations<'a> {
    config: &'a Config,
    found: BTreeMap<String, String>,
}

impl TypeVisitor for Declarations<'_> {
    fn visit<T: TS + 'static + ?Sized>(&mut self) {
        // Types without a file are TypeScript's own.
        if T::output_path().is_none() {
            return T::visit_generics(self);
        }
        let name = T::ident(self.config);
        if self.found.contains_key(&name) {
            return;
        }
        let docs = T::docs().unwrap_or_default();
        let declaration = format!("{docs}export {}\n", T::decl(self.config));
        self.found.insert(name, declaration);
        T::visit_dependencies(self);
        T::visit_generics(self);
    }
}

#[test]
fn the_types_of_the_page_are_those_of_the_solver() {
    let config = Config::default().with_large_int("number");
    let mut declarations = Declarations {
        config: &config,
        found: BTreeMap::new(),
    };
    declarations.visit::<RunCommand>();
    declarations.visit::<RunAnswer>();
    declarations.visit::<ToolCommand>();
    declarations.visit::<ToolAnswer>();
    declarations.visit::<Frame>();
    declarations.visit::<Fault>();
    let mut text = String::from(
        "// Written by a test from the Rust types (src/web/types.rs); changes here are lost.\n",
    );
    for declaration in declarations.found.values() {
        text.push('\n');
        text.push_str(declaration);
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(FILE);
    if std::fs::read_to_string(&path).unwrap_or_default() != text {
        std::fs::create_dir_all(path.parent().expect("a folder")).expect("made");
        std::fs::write(&path, text).expect("written");
        panic!("{FILE} was out of date and has been written anew: look at it, and commit it");
    }
}
