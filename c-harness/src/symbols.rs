//! Search for what must not be in an image: ways to panic, a heap, doubles in software.

use crate::Failure;
use object::{Object as _, ObjectSymbol as _};
use std::fs;
use std::path::Path;

/// Parts of names, and what they mean.
const FORBIDDEN: [(&str, &str); 8] = [
    ("panicking", "a way to panic"),
    ("panic_bounds_check", "a way to panic"),
    ("unwrap_failed", "a way to panic"),
    ("__aeabi_d", "a double in software"),
    ("__adddf3", "a double in software"),
    ("__muldf3", "a double in software"),
    ("malloc", "a heap"),
    ("__rust_alloc", "a heap"),
];

/// Finds forbidden symbols in an image: each with its reason.
pub(crate) fn forbidden(image: &[u8]) -> Result<Vec<String>, Failure> {
    let file = object::File::parse(image).map_err(Failure::new)?;
    let names = file.symbols().filter_map(|symbol| symbol.name().ok().map(str::to_owned));
    let bad = names.filter_map(|name| {
        let (_, what) = FORBIDDEN.iter().find(|(part, _)| name.contains(part))?;
        Some(format!("{name} ({what})"))
    });
    Ok(bad.collect())
}

/// Fails where an image could panic, allocate, or compute with doubles.
pub(crate) fn check(image: &Path) -> Result<(), Failure> {
    let bytes = fs::read(image).map_err(|error| Failure::at(image, error))?;
    let bad = forbidden(&bytes)?;
    if bad.is_empty() { Ok(()) } else { Err(Failure::at(image, bad.join(", "))) }
}
