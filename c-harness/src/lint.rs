//! clang-tidy, and cppcheck with its MISRA addon, on the firmwares' and the example's own C. What may deviate, and why, is
//! in `misra-deviations.txt`; generated C and the library's header have tests of their own.

use crate::Failure;
use crate::build::{self, BOARD, HOST};
use crate::programs::{CHECKED, CONTROL, EXAMPLE, Program};
use std::path::{Path, PathBuf};
use std::process::Command;
use tpg_testing::library;

/// The files of each program, and whether it is for this machine: rules about a whole program need to see one, and no more.
fn files() -> Vec<(Vec<String>, bool)> {
    let with = |program: &Program, platform: &[&str]| -> Vec<String> {
        std::iter::once(&program.main).chain(platform).map(|&name| name.to_owned()).collect()
    };
    let board = CHECKED.into_iter().chain([&EXAMPLE]).map(|program| (with(program, &BOARD), false));
    board.chain([(with(&CONTROL, &HOST), true)]).collect()
}

/// Two parameters of one type are what coordinates need. A linker script's symbols begin with an underscore. Padding differs
/// from machine to machine.
const TIDY: &str = "-*,bugprone-*,cert-*,clang-analyzer-*,-bugprone-easily-swappable-parameters,\
                    -bugprone-reserved-identifier,-cert-dcl37-c,-cert-dcl51-cpp,-clang-analyzer-optin.performance.Padding";

/// Folders of headers: the example's, generated ones, the library's.
struct Headers([PathBuf; 3]);

impl Headers {
    fn includes(&self) -> Vec<String> {
        let own = Path::new("firmware-c");
        self.0.iter().map(PathBuf::as_path).chain([own]).map(|folder| format!("-I{}", folder.display())).collect()
    }
}

/// Lints every program.
pub(crate) fn check() -> Result<(), Failure> {
    let top = library::top();
    let headers =
        Headers([PathBuf::from("example"), build::generated_c()?, top.join("tpg-runtime-nostd/capi/include")]);
    let what = "clang-tidy on the firmwares' C";
    if tpg_testing::tool("clang-tidy", "clang-tidy", what)
        && tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", &format!("{what}: newlib's headers"))
    {
        let newlib = library::output(Command::new("arm-none-eabi-gcc").arg("-print-file-name=libc.a"))?;
        let folder = Path::new(newlib.trim()).parent().unwrap_or(Path::new("/"));
        let arm = [format!("--target={}", build::TARGET), format!("-I{}/../include", folder.display())];
        for (files, here) in files() {
            let core: &[String] = if here { &[] } else { &arm };
            let options = ["--", "-std=gnu11", "-ffp-contract=off"];
            clean(tidy().args(files).args(options).args(core).args(headers.includes()))?;
        }
        println!("clang-tidy: nothing");
    }
    if tpg_testing::tool("cppcheck", "cppcheck", "cppcheck and its MISRA addon on the firmwares' C") {
        for (files, _) in files() {
            clean(cppcheck(&headers).args(files))?;
        }
        println!("cppcheck and its MISRA addon: nothing but what misra-deviations.txt explains");
    }
    Ok(())
}

fn command(program: &str) -> Command {
    let mut command = Command::new(program);
    command.current_dir(library::top().join("c-harness"));
    command
}

fn tidy() -> Command {
    let mut command = command("clang-tidy");
    command.args(["--quiet", "--warnings-as-errors=*"]).arg(format!("--checks={TIDY}"));
    command
}

fn cppcheck(headers: &Headers) -> Command {
    let mut command = command("cppcheck");
    command.args(["--std=c11", "--enable=all", "--addon=misra", "--quiet", "--error-exitcode=1"]);
    command.args(["--suppressions-list=misra-deviations.txt"]).args(headers.includes());
    let Headers([_, generated, library]) = headers;
    for folder in [generated, library] {
        command.arg(format!("--suppress=*:{}/*", folder.display()));
    }
    command
}

/// Succeeds if a linter finds nothing.
fn clean(command: &mut Command) -> Result<(), Failure> {
    Ok(library::output(command).map(|_| ())?)
}

/// A file that both linters must complain about: what finds nothing anywhere proves nothing.
pub(crate) fn sees_what_is_bad() -> Result<(), Failure> {
    let bad = build::room()?.join("bad.c");
    let text = "int main(void)\n{\n    int *p = 0;\n    return *p + 010;\n}\n";
    build::write(&bad, text)?;
    let path: &Path = &bad;
    let headers = Headers([(); 3].map(|()| PathBuf::from("none")));
    for (program, command) in
        [("clang-tidy", tidy().arg(path).args(["--", "-std=c99"])), ("cppcheck", cppcheck(&headers).arg(path))]
    {
        if tpg_testing::exists(program) && clean(command).is_ok() {
            return Err(Failure::at(path, format!("{program} finds nothing wrong with it")));
        }
    }
    Ok(())
}
