//! Search for what must not be in an image: ways to panic, a heap, doubles in software.

use crate::Failure;
use crate::build;
use object::{Object as _, ObjectSymbol as _};
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

/// Fails where an image could panic, allocate, or compute with doubles.
pub(crate) fn check(image: &Path) -> Result<(), Failure> {
    let bytes = build::read(image)?;
    let file = object::File::parse(&*bytes)?;
    let bad = file.symbols().filter_map(|symbol| {
        let name = symbol.name().ok()?;
        let (_, what) = FORBIDDEN.iter().find(|(part, _)| name.contains(part))?;
        Some(format!("{}: {name} ({what})", image.display()))
    });
    Failure::unless_none(bad.collect())
}
