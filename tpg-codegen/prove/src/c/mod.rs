//! C as generated code uses it: read, compiled and executed by this crate alone.
//!
//! The subset: integers of 8 to 64 bits, `float`, structures, arrays, pointers, enumerations, functions (inlined from their text), `if`, `switch`, `for` with a constant number of rounds, `goto`, `memcpy` of scalars. Anything else is named as missing.

mod code;
mod compile;
mod condition;
mod execute;
mod token;
mod value;

pub use execute::Code;

use crate::input::{Missing, Result};
use crate::machine::Interface;
use crate::term::{Float, Terms};
use compile::Compiler;
use std::path::Path;

/// Reads the function of a policy from a file of C. Files that it includes by names in quotes are read from its folder.
///
/// # Errors
/// What is not of the subset.
pub fn read(path: &Path, text: &str, function: Option<&str>, interface: &Interface) -> Result<Code> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let file = path.file_name().map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned());
    read_with(&file, text, &|name| std::fs::read_to_string(folder.join(name)).ok(), function, interface)
}

/// Reads the function of a policy from a text, and what it includes by a function of names.
///
/// # Errors
/// What is not of the subset.
pub fn read_with(
    file: &str,
    text: &str,
    include: &dyn Fn(&str) -> Option<String>,
    function: Option<&str>,
    interface: &Interface,
) -> Result<Code> {
    let compiler = Compiler::read(
        file,
        token::tokens(file, text, include, interface.counts.is_empty())?,
        !interface.counts.is_empty(),
    )?;
    let name = match function {
        Some(name) => name.to_owned(),
        None => {
            let mut names =
                compiler.functions.iter().map(|function| &function.name).filter(|name| name.ends_with("_infer"));
            match (names.next(), names.next()) {
                (Some(name), None) => name.clone(),
                _ => return Err(Missing::new(file, "the name of the function: no or several end in `_infer`")),
            }
        }
    };
    Ok(Code::new(file, compiler.policy(&name, interface)?, interface))
}

/// Executes a function of one float from a text that defines what it means.
pub(crate) fn definition(file: &str, text: &str, name: &str, terms: &Terms, argument: Float) -> Result<Float> {
    let compiler = Compiler::read(file, token::tokens(file, text, &|_| None, false)?, false)?;
    let (sources, outputs) = (vec![("x".to_owned(), 1)], vec!["y".to_owned()]);
    let interface = Interface { sources, outputs, ..Interface::default() };
    Code::new(file, compiler.policy(name, &interface)?, &interface).of_float(terms, argument)
}
