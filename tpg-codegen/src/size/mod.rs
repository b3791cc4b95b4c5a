//! The size of compiled code, without its self-test: alone, and with the library functions that it calls.

mod linked;
mod object;
mod rust;
mod target;

pub use self::object::{Size, measure};
pub use linked::Linked;
pub use rust::RustForCortexM4;
pub use target::Target;

use crate::emit::Code;
use crate::options::Style;
use std::process::Command;
use std::{fs, io};
use tempfile::TempDir;

/// The size of the compiled C on each target, a line each; if a compiler is missing, its line says so.
pub fn describe_c(code: &Code<'_>) -> Vec<String> {
    [Target::Host, Target::M4f]
        .map(|target| match build_c(code, target).and_then(|built| measure(&built.object)) {
            Ok(size) => format!("size on {} (-Os): {size}", target.name()),
            Err(error) => format!("size on {}: not available: {error}", target.name()),
        })
        .into()
}

/// Generated C, compiled.
#[derive(Debug)]
pub struct Built {
    /// The object file.
    pub object: Vec<u8>,
    folder: TempDir,
    target: Target,
    entry: String,
}

impl Built {
    /// Links the code with the library functions that it calls; not for this machine, and not in GEGELATI's style, whose inputs lie elsewhere.
    ///
    /// # Errors
    /// When the compiler refuses, or a library is missing.
    pub fn link(&self, code: &Code<'_>) -> io::Result<Option<Linked>> {
        let link = || linked::link(self.folder.path(), self.target, &self.entry, &code.program);
        let is_whole = code.program.options.style == Style::Pure;
        (self.target != Target::Host && is_whole).then(link).transpose()
    }
}

/// Compiles generated C for size, without its self-test.
///
/// # Errors
/// When the compiler is missing or refuses.
pub fn build_c(code: &Code<'_>, target: Target) -> io::Result<Built> {
    let Code { program, files } = code;
    let options = &program.options;
    let folder = TempDir::new()?;
    for file in files {
        fs::write(folder.path().join(&file.name), &file.text)?;
    }
    let mut command = target.compiler()?;
    command.current_dir(folder.path()).args(["-std=c99", "-Os"]);
    // What a debugger or an unwinder reads is not the policy.
    command.args(["-g0", "-fno-asynchronous-unwind-tables"]).arg(format!("-D{}_NO_SELFTEST", options.prefix.upper()));
    command.arg("-c").arg(format!("{}.c", options.prefix)).args(["-o", "policy.o"]);
    run(command, "refused", |line| line.contains("error"))?;
    let entry = match options.style {
        Style::Pure => format!("{}_infer", options.prefix),
        Style::Gegelati => "inferenceTPG".to_owned(),
    };
    Ok(Built { object: fs::read(folder.path().join("policy.o"))?, folder, target, entry })
}

/// Runs a compiler; where it fails, the first line that says why is the error.
fn run(mut command: Command, refusal: &str, says_why: fn(&&str) -> bool) -> io::Result<()> {
    let name = command.get_program().to_string_lossy().into_owned();
    let output = command.output().map_err(|error| io::Error::new(error.kind(), format!("{name}: {error}")))?;
    if output.status.success() {
        return Ok(());
    }
    let message = String::from_utf8_lossy(&output.stderr);
    let first = message.lines().find(says_why).unwrap_or("it says nothing");
    Err(io::Error::other(format!("{name} {refusal}: {first}")))
}

/// Returns the flash of a piece of C on a Cortex-M4F, bytes.
///
/// # Errors
/// When the compiler is missing or refuses.
pub fn flash_of_c(code: &Code<'_>) -> io::Result<u64> {
    Ok(measure(&build_c(code, Target::M4f)?.object)?.flash())
}
