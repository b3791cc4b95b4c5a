//! The size of compiled code, without its self-test and the libraries it calls.

mod estimate;
pub(crate) mod least;
mod rust;
mod stack;

pub use estimate::flash as estimated_flash;
pub use rust::RustForCortexM4;
pub use stack::Stack;

use crate::emit::Code;
use crate::options::{Language, Options, Style};
use crate::program::compile;
use crate::verify;
use object::{Object as _, ObjectSection, ObjectSymbol as _, RelocationTarget, SectionKind};
use serde::Serialize;
use std::collections::BTreeSet;
use std::fmt;
use std::fs;
use std::io;
use std::process::Command;
use tempfile::TempDir;
use tpg_graph::Graph;

/// A target of generated code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, clap::ValueEnum)]
pub enum Target {
    /// On a Cortex-M4 with FPU, built by `arm-none-eabi-gcc`.
    #[value(name = "thumbv7em")]
    #[serde(rename = "thumbv7em")]
    CortexM4,
    /// On this machine, built by its C compiler.
    #[serde(rename = "host")]
    Host,
}

impl Target {
    /// Every target.
    pub const ALL: [Self; 2] = [Self::CortexM4, Self::Host];

    /// The name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Host => "this machine",
            Self::CortexM4 => "Cortex-M4F",
        }
    }
}

/// Bytes of an object file that end up on the device.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Size {
    /// Instructions, and constants that the compiler puts between them.
    pub code: u64,
    /// Constant tables.
    pub constants: u64,
    /// Initialised variables, which take flash and RAM.
    pub data: u64,
    /// Variables that start as zero, which take RAM.
    pub bss: u64,
}

impl Size {
    /// Bytes of flash.
    pub fn flash(self) -> u64 {
        self.code + self.constants + self.data
    }

    /// Bytes of RAM, without the stack.
    pub fn ram(self) -> u64 {
        self.data + self.bss
    }

    fn add<'data>(&mut self, section: &impl ObjectSection<'data>) {
        let bytes = match section.kind() {
            SectionKind::Text => &mut self.code,
            SectionKind::ReadOnlyData | SectionKind::ReadOnlyString | SectionKind::ReadOnlyDataWithRel => {
                &mut self.constants
            }
            SectionKind::Data => &mut self.data,
            SectionKind::UninitializedData => &mut self.bss,
            _ => return,
        };
        *bytes += section.size();
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { code, constants, data, bss } = self;
        write!(f, "{code} bytes of code, {constants} of constants, {data} of data, {bss} of bss")
    }
}

/// The size of the compiled C on each target, a line each; if a compiler is missing, its line says so.
pub fn describe_c(code: &Code<'_>) -> Vec<String> {
    [Target::Host, Target::CortexM4]
        .map(|target| match build_c(code, target).and_then(|built| measure(&built.object)) {
            Ok(size) => format!("size on {} (-Os): {size}", target.name()),
            Err(error) => format!("size on {}: not available: {error}", target.name()),
        })
        .into()
}

/// Generates C and compiles it for size, without its self-test, and returns the object file.
///
/// # Errors
/// When the compiler is missing or refuses.
pub fn compile_c(graph: &Graph, options: &Options, target: Target) -> io::Result<Vec<u8>> {
    Ok(build_c(&Code::of(compile(graph, options, Language::C)), target)?.object)
}

/// Generated C, compiled.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Built {
    /// The object file.
    pub object: Vec<u8>,
    /// The stack that a decision needs; only GCC reports it.
    pub stack: Option<Stack>,
}

/// Compiles generated C for size, without its self-test, and asks the compiler for the stack.
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
    let (mut command, writes_call_graph) = match target {
        Target::Host => {
            let tool = verify::c_compiler().map_err(io::Error::other)?;
            (tool.to_command(), tool.is_like_gnu())
        }
        Target::CortexM4 => {
            let mut command = Command::new("arm-none-eabi-gcc");
            command.args(["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"]);
            (command, true)
        }
    };
    command.current_dir(folder.path()).args(["-std=c99", "-Os"]);
    // What a debugger or an unwinder reads is not the policy.
    command.args(["-g0", "-fno-asynchronous-unwind-tables"]).arg(format!("-D{}_NO_SELFTEST", options.prefix.upper()));
    if writes_call_graph {
        command.arg("-fcallgraph-info=su");
    }
    command.arg("-c").arg(format!("{}.c", options.prefix)).args(["-o", "policy.o"]);
    let name = command.get_program().to_string_lossy().into_owned();
    let output = command.output().map_err(|error| io::Error::new(error.kind(), format!("{name}: {error}")))?;
    if !output.status.success() {
        let message = String::from_utf8_lossy(&output.stderr);
        let first = message.lines().find(|line| line.contains("error")).unwrap_or("it says nothing");
        return Err(io::Error::other(format!("{name} refused: {first}")));
    }
    let entry = match options.style {
        Style::Pure => format!("{}_infer", options.prefix),
        Style::Gegelati => "inferenceTPG".to_owned(),
    };
    let call_graph = fs::read_to_string(folder.path().join("policy.ci")).ok();
    let stack = call_graph.and_then(|text| stack::deepest(&text, &entry));
    Ok(Built { object: fs::read(folder.path().join("policy.o"))?, stack })
}

/// Returns the flash of a piece of C on a Cortex-M4F, bytes, and true if no compiler for it is there and the number is an
/// estimate.
pub fn flash_of_c(code: &Code<'_>) -> (u64, bool) {
    match build_c(code, Target::CortexM4).and_then(|built| measure(&built.object)) {
        Ok(size) => (size.flash(), false),
        Err(_) => (estimated_flash(&code.program), true),
    }
}

/// Sums the sections of an object file.
///
/// # Errors
/// If it is not an object file.
pub fn measure(object: &[u8]) -> io::Result<Size> {
    let file = object::File::parse(object).map_err(io::Error::other)?;
    let mut size = Size::default();
    file.sections().for_each(|section| size.add(&section));
    Ok(size)
}

/// Sums the sections of an object file that a symbol's section reaches.
///
/// # Errors
/// If it is not an object file, or defines no such symbol.
fn measure_reached(object: &[u8], symbol: &str) -> io::Result<Size> {
    let file = object::File::parse(object).map_err(io::Error::other)?;
    let start = file.symbol_by_name(symbol).and_then(|symbol| symbol.section_index());
    let mut waiting = vec![start.ok_or_else(|| io::Error::other(format!("the object file defines no {symbol}")))?];
    let (mut reached, mut size) = (BTreeSet::new(), Size::default());
    while let Some(index) = waiting.pop() {
        if !reached.insert(index.0) {
            continue;
        }
        let section = file.section_by_index(index).map_err(io::Error::other)?;
        size.add(&section);
        waiting.extend(section.relocations().filter_map(|(_, relocation)| match relocation.target() {
            RelocationTarget::Symbol(symbol) => file.symbol_by_index(symbol).ok()?.section_index(),
            RelocationTarget::Section(section) => Some(section),
            _ => None,
        }));
    }
    Ok(size)
}
