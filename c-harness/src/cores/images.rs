//! The images of a core, and the library in Rust that one of them holds.

use super::core::{Core, Runner};
use super::shipped::{self, ImageKind, Shipped};
use crate::Failure;
use crate::build::{self, generated_c, room};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;
use tpg_codegen::emit::File;
use tpg_codegen::size;
use tpg_graph::files::make_folder;
use tpg_testing::library;

/// Episodes of the hybrid on a core, from each start.
pub(super) const EPISODES: usize = 10;

/// The folders of everything.
#[derive(Debug)]
pub(super) struct Place {
    /// The C of the policies, and `policies.c`.
    generated: PathBuf,
    /// The firmwares' C.
    firmware: PathBuf,
    /// The folders of the cores.
    room: PathBuf,
    /// The sources of the hybrid's firmware.
    hybrid: PathBuf,
}

impl Place {
    /// Writes the C of the policies.
    pub(super) fn new(shipped: &[Shipped], integers: &[Shipped]) -> Result<Self, Failure> {
        let room = room()?.join("cores");
        let generated = room.join("generated");
        make_folder(&generated)?;
        let asking = [(shipped, ImageKind::C), (integers, ImageKind::Integers), (shipped, ImageKind::Rust)];
        let asking = asking.into_iter().map(|(policies, kind)| Ok(vec![shipped::policies_c(policies, kind)?]));
        let code = shipped.iter().chain(integers).map(Shipped::c).chain(asking);
        for File { name, text } in code.collect::<Result<Vec<_>, Failure>>()?.into_iter().flatten() {
            let path = generated.join(name);
            build::write(&path, text)?;
        }
        let firmware = library::top().join("c-harness/firmware-c");
        Ok(Self { generated, firmware, room, hybrid: generated_c()? })
    }

    /// The program that runs WebAssembly.
    pub(super) fn wasi(&self) -> PathBuf {
        self.firmware.join("cores/wasi.mjs")
    }

    fn folder(&self, core: &Core) -> Result<PathBuf, Failure> {
        let name: String = core.title().chars().filter(|c| c.is_ascii_alphanumeric()).collect();
        let folder = self.room.join(name);
        make_folder(&folder)?;
        Ok(folder)
    }

    /// A compiler's command for a core, as a user's project calls it: GNU C, for size, without a word about contraction.
    fn compiler(&self, core: &Core, folder: &Path) -> Command {
        let mut command = Command::new(core.compiler().0);
        command.current_dir(folder).args(core.specs()).args(core.flags).args(["-std=gnu11", "-Os", "-Wall", "-Wextra"]);
        // GCC 5 for AVR warns of what it assumes of sums whose bounds are proven.
        command.arg("-Wno-strict-overflow");
        command.args(["-Werror", "-g0", "-fno-asynchronous-unwind-tables", "-ffunction-sections", "-fdata-sections"]);
        let example = library::top().join("c-harness/example");
        for include in [&self.generated, &self.firmware.join("cores"), &example] {
            command.arg(format!("-I{}", include.display()));
        }
        command
    }

    /// Compiles the policies for a core; the bytes of flash of each, by name.
    pub(super) fn policies(&self, core: &Core, shipped: &[Shipped]) -> Result<Vec<(String, u64)>, Failure> {
        let folder = self.folder(core)?;
        let mut compiler = self.compiler(core, &folder);
        for one in shipped {
            compiler.arg(format!("-D{}_NO_SELFTEST", one.prefix.upper()));
            compiler.arg(self.generated.join(format!("{}.c", one.prefix)));
        }
        run(compiler.arg("-c"))?;
        let flash = |one: &Shipped| {
            let path = folder.join(format!("{}.o", one.prefix));
            let object = build::read(&path)?;
            let size = size::measure(&object).map_err(|error| Failure::at(&path, error))?;
            Ok((one.prefix.to_string(), size.flash()))
        };
        // No ELF.
        if matches!(core.runner, Runner::Wasm) { Ok(Vec::new()) } else { shipped.iter().map(flash).collect() }
    }

    /// The images of the policies in C, compiled before.
    pub(super) fn in_c(&self, core: &Core, kind: ImageKind, shipped: &[Shipped]) -> Result<Vec<PathBuf>, Failure> {
        // Of integers there are two for each policy.
        let images = if kind == ImageKind::Integers { 2 * core.images } else { core.images };
        let image = |image: usize| {
            let policies = (image..shipped.len()).step_by(images);
            let chosen = policies.clone().fold(0, |chosen, index| chosen | 1 << index);
            let objects = policies.map(|index| OsString::from(format!("{}.o", shipped[index].prefix))).collect();
            self.link(core, &format!("{}-{image}", kind.file()), kind, chosen, objects)
        };
        (0..images).map(image).collect()
    }

    /// The images of the policies in Rust and of the networks; `None` where there is no such target, or it is not installed.
    pub(super) fn in_rust(&self, core: &Core) -> Result<Option<[PathBuf; 2]>, Failure> {
        let Some(target) = core.target else { return Ok(None) };
        if !library::rust_target(target, &format!("the generated Rust on {}", core.title())) {
            return Ok(None);
        }
        let package = ["build", "--quiet", "--package", "tpg-cores", "--lib"];
        run(library::cargo(&package).args(["--profile", "firmware", "--target", target]))?;
        let archive = OsString::from(library::target_folder().join(target).join("firmware/libtpg_cores.a"));
        let folder = self.folder(core)?;
        let mut compiler = self.compiler(core, &folder);
        compiler.arg(self.firmware.join("cores/layers.c"));
        let layers = self.finish(core, compiler, std::slice::from_ref(&archive), folder.join("layers"))?;
        let policies = self.link(core, "states-rust", ImageKind::Rust, u32::MAX, vec![archive])?;
        Ok(Some([policies, layers]))
    }

    /// An image of those policies whose bit is set in `chosen`.
    fn link(
        &self,
        core: &Core,
        name: &str,
        policies: ImageKind,
        chosen: u32,
        objects: Vec<OsString>,
    ) -> Result<PathBuf, Failure> {
        let folder = self.folder(core)?;
        let mut compiler = self.compiler(core, &folder);
        compiler
            .arg(format!("-DSTATES={}U", core.bits().states(policies == ImageKind::Integers)))
            .arg(self.firmware.join("cores/states.c"));
        compiler.arg(format!("-DIN_IMAGE={chosen:#x}U")).arg(self.generated.join(policies.file()));
        self.finish(core, compiler, &objects, folder.join(name))
    }

    /// The image of the hybrid; `None` where the library is not built for the core.
    pub(super) fn hybrid(&self, core: &Core) -> Result<Option<PathBuf>, Failure> {
        let Some(target) = core.target.filter(|target| library::TARGETS.contains(target)) else { return Ok(None) };
        let Some(archive) = library::make(target, &library::dist())? else { return Ok(None) };
        let folder = self.folder(core)?;
        let mut compiler = self.compiler(core, &folder);
        compiler.arg(format!("-I{}", self.hybrid.display()));
        compiler.arg(format!("-I{}", library::dist().join("include").display()));
        compiler.arg(format!("-DPROBLEMS={EPISODES}U")).arg("-DPARTS=1U").arg(self.firmware.join("control.c"));
        compiler.args(["widowx_fs.c", "widowx_rs.c", "widowx_sac.c"].map(|name| self.hybrid.join(name)));
        self.finish(core, compiler, &[archive.into()], folder.join("hybrid")).map(Some)
    }

    /// Adds the platform and links.
    fn finish(
        &self,
        core: &Core,
        mut compiler: Command,
        objects: &[OsString],
        image: PathBuf,
    ) -> Result<PathBuf, Failure> {
        compiler.arg(self.firmware.join(core.platform())).arg(library::top().join("c-harness/example/report.c"));
        compiler.args(objects).arg("-Wl,--gc-sections").args(core.link());
        run(compiler.arg("-o").arg(&image))?;
        Ok(image)
    }
}

fn run(command: &mut Command) -> Result<(), Failure> {
    Ok(library::output(command).map(|_| ())?)
}
