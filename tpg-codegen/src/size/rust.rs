//! The size of generated Rust on a Cortex-M4F, if the Rust compiler has that target.

use super::object::{Size, measure_reached};
use crate::emit::Code;
use crate::verify::{self, BuildError};
use std::path::Path;
use std::process::Command;
use std::{fs, io};
use tempfile::TempDir;

const TARGET: &str = "thumbv7em-none-eabihf";

/// The Rust compiler for a Cortex-M4F, with the runtime that generated Rust depends on.
#[derive(Debug)]
pub struct RustForCortexM4 {
    folder: TempDir,
}

impl RustForCortexM4 {
    /// Compiles the runtime's part, at an `opt-level`: `3`, `s` and the like.
    ///
    /// # Errors
    /// If there is no compiler, or it lacks the target.
    pub fn new(level: &str) -> io::Result<Self> {
        let folder = TempDir::new()?;
        // The runtime names the crate libm, a library that is called and not part of a policy: its symbols are enough.
        fs::write(folder.path().join("libm.rs"), libm())?;
        verify::write_runtime(folder.path(), |text| text.replace("extern crate std;\n", ""))?;
        let library = ["--crate-type=rlib", "--crate-name=libm", "libm.rs"];
        compile(folder.path(), level, &library)?;
        let runtime = ["--crate-type=rlib", "--crate-name=tpg_runtime", "--extern=libm=liblibm.rlib", "runtime/lib.rs"];
        compile(folder.path(), level, &runtime)?;
        Ok(Self { folder })
    }

    /// The object file of a policy: one function, `PREFIX_infer`, with C's calling convention, and what it calls. It answers
    /// with the action, or writes the values of the outputs where its second argument says.
    ///
    /// # Errors
    /// When the compiler refuses.
    pub fn object(&self, code: &Code<'_>, level: &str) -> io::Result<Vec<u8>> {
        let (graph, prefix) = (code.program.graph(), &code.program.options.prefix);
        let folder = self.folder.path();
        for file in &code.files {
            fs::write(folder.join(format!("policy_{}", file.name)), &file.text)?;
        }
        let (scalar, length, name) = (graph.scalar().name(), graph.state_length(), prefix.camel());
        let decide = format!("policy::{name}.decide(state)");
        let (import, answer, body) = match graph.outputs().len() {
            0 => ("ActionId, ", ") -> u16".to_owned(), format!("let ActionId(action) = {decide};\n    action")),
            outputs => ("", format!(", action: &mut [{scalar}; {outputs}])"), format!("*action = {decide};")),
        };
        let library = format!(
            "#![no_std]\n#[path = \"policy_{prefix}.rs\"]\nmod policy;\nuse tpg_runtime::policy::{{{import}Policy}};\n\
             #[unsafe(no_mangle)]\npub extern \"C\" fn {prefix}_infer(state: &[{scalar}; {length}]{answer} {{\n    {body}\n}}\n"
        );
        fs::write(folder.join("lib.rs"), library)?;
        let object = ["--crate-type=lib", "--crate-name=policy_object", "--emit=obj", "-o", "policy.o", "-L", "."];
        compile(folder, level, &[&object[..], &["--extern=tpg_runtime=libtpg_runtime.rlib", "lib.rs"]].concat())?;
        fs::read(folder.join("policy.o"))
    }

    /// The bytes of [`object`](Self::object) that a linker keeps: what its function reaches. The compiler leaves functions in the object
    /// that it has also written into their callers.
    ///
    /// # Errors
    /// As [`object`](Self::object).
    pub fn size(&self, code: &Code<'_>, level: &str) -> io::Result<Size> {
        measure_reached(&self.object(code, level)?, &format!("{}_infer", code.program.options.prefix))
    }
}

/// Stubs for the functions of the crate libm that the runtime calls.
fn libm() -> String {
    let stub =
        |scalar: &str, name: &str| format!("#[inline(never)]\npub fn {name}(x: {scalar}) -> {scalar} {{\n    x\n}}\n");
    let of = |(scalar, root)| {
        let functions = ["sin", "cos", "tan", "log", "exp", "atan", "tanh"].map(|name| stub(scalar, name)).concat();
        format!("{}impl Libm<{scalar}> {{\n{functions}}}\n", stub(scalar, root))
    };
    let both = [("f32", "sqrtf"), ("f64", "sqrt")].map(of).concat();
    format!("#![no_std]\npub struct Libm<T>(T);\n{both}")
}

fn compile(folder: &Path, level: &str, arguments: &[&str]) -> io::Result<()> {
    let mut command: Command = verify::rustc(folder);
    command.arg(format!("--target={TARGET}")).args(["-Ctarget-cpu=cortex-m4", "-Coverflow-checks=off"]);
    command.arg(format!("-Copt-level={level}")).args(arguments);
    verify::compile("Rust", command).map_err(|error| match error {
        BuildError::Refused { message, .. } if message.contains("E0463") => {
            io::Error::other(format!("the Rust compiler lacks a target: rustup target add {TARGET}"))
        }
        error => io::Error::other(error),
    })
}

#[cfg(test)]
mod tests {
    use super::RustForCortexM4;
    use crate::emit::Code;
    use crate::options::{Language, Options, Profile};
    use crate::program::compile;
    use tpg_graph::sample::{self, Shape};

    #[test]
    fn policies_with_actions_and_with_outputs_have_a_size() {
        if !tpg_testing::library::rust_target("thumbv7em-none-eabihf", "sizes of Rust on a Cortex-M4F") {
            return;
        }
        let compiler = RustForCortexM4::new("s").expect("the toolchain has the target");
        for shape in [Shape::random(1), Shape::random_with_outputs(1)] {
            let graph = sample::graph(&shape, 1);
            for profile in Profile::ALL {
                let options = Options { profile: Some(profile), ..Options::new("policy".parse().expect("a prefix")) };
                let size = compiler.size(&Code::of(compile(&graph, &options, Language::Rust)), "s");
                assert!(size.expect("it compiles").flash() > 0, "{}", profile.name());
            }
        }
    }
}
