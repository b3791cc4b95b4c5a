//! The cores: what compiles for each, and what runs it.

use super::shipped::Bits;
use crate::emulate;
use Runner::*;
use std::path::Path;
use std::process::Command;
use tpg_codegen::size::Target;

/// A core, on a board that an emulator has.
#[derive(Debug)]
pub(super) struct Core {
    /// The name in tables.
    pub(super) name: &'static str,
    /// The machine, as its emulator names it.
    pub(super) machine: &'static str,
    /// The program that runs its images.
    pub(super) runner: Runner,
    /// The C compiler's words for it.
    pub(super) flags: &'static [&'static str],
    /// The Rust target that its C links with, if any.
    pub(super) target: Option<&'static str>,
    /// Images that the policies in C are spread over: its flash does not hold all at once.
    pub(super) images: usize,
    /// True where figures are kept; another board of the same core only shows that it acts the same.
    pub(super) figures: bool,
}

/// A compiler for a core, and a program that runs its images.
#[derive(Clone, Copy, Debug)]
pub(super) enum Runner {
    /// `qemu-system-arm`; the memories, and the ticks of SysTick in a thousand instructions of 1,024 ns.
    Arm(Memories, u32),
    /// `qemu-system-riscv32`.
    RiscV(Memories),
    /// `simavr`: QEMU 7.2 hangs in libgcc's multiplication of integers.
    Avr,
    /// Node, by WASI.
    Wasm,
    /// This machine.
    Host,
    /// A program of Linux for another machine, by QEMU's emulation of a user's program.
    User,
}

/// Start and size of flash and RAM.
#[derive(Clone, Copy, Debug)]
pub(super) struct Memories([(u32, &'static str); 2]);

/// Those of the MPS2 boards.
const MPS2: Memories = Memories([(0, "4M"), (0x2000_0000, "4M")]);
/// Those of QEMU's `virt`: both in its RAM.
const VIRT: Memories = Memories([(0x8000_0000, "4M"), (0x8040_0000, "4M")]);

/// A Cortex-M, with the words for its core and its floats.
const fn arm(
    name: &'static str,
    machine: &'static str,
    (memories, ticks): (Memories, u32),
    flags: &'static [&'static str],
    target: &'static str,
) -> Core {
    let runner = Arm(memories, ticks);
    Core { name, machine, runner, flags, target: Some(target), images: 1, figures: true }
}

/// A RISC-V on a board of QEMU's.
const fn riscv(
    name: &'static str,
    (machine, memories): (&'static str, Memories),
    flags: &'static [&'static str],
    target: &'static str,
) -> Core {
    Core { name, machine, runner: RiscV(memories), flags, target: Some(target), images: 1, figures: true }
}

/// A core for which no Rust is built.
const fn only_c(name: &'static str, machine: &'static str, runner: Runner, flags: &'static [&'static str]) -> Core {
    Core { name, machine, runner, flags, target: None, images: 1, figures: false }
}

/// Memories and ticks of the boards with a Cortex-M33.
const AN505: (Memories, u32) = (Memories([(0x1000_0000, "4M"), (0x3800_0000, "4M")]), 20_480);

/// Every core.
pub(super) const CORES: [Core; 16] = [
    arm(
        "Cortex-M0",
        "microbit",
        (Memories([(0, "256K"), (0x2000_0000, "16K")]), 16_384),
        Target::M0.flags(),
        "thumbv6m-none-eabi",
    ),
    arm("Cortex-M3", "mps2-an385", (MPS2, 25_600), Target::M3.flags(), "thumbv7m-none-eabi"),
    arm("Cortex-M4F", "mps2-an386", (MPS2, 25_600), Target::M4f.flags(), "thumbv7em-none-eabihf"),
    arm("Cortex-M7", "mps2-an500", (MPS2, 25_600), Target::M7.flags(), "thumbv7em-none-eabihf"),
    arm("Cortex-M33", "mps2-an505", AN505, Target::M33.flags(), "thumbv8m.main-none-eabihf"),
    Core {
        figures: false,
        ..arm(
            "Cortex-M33 without FPU",
            "mps2-an505",
            AN505,
            &["-mcpu=cortex-m33+nofp", "-mthumb", "-mfloat-abi=soft"],
            "thumbv8m.main-none-eabi",
        )
    },
    arm(
        "Cortex-M55",
        "mps3-an547",
        (Memories([(0, "512K"), (0x2000_0000, "512K")]), 32_768),
        &["-mcpu=cortex-m55", "-mthumb", "-mfloat-abi=hard", "-mfpu=auto"],
        "thumbv8m.main-none-eabihf",
    ),
    riscv("RISC-V rv32imac", ("virt", VIRT), Target::Rv32imac.flags(), "riscv32imac-unknown-none-elf"),
    Core {
        figures: false,
        ..riscv(
            "RISC-V rv32imac",
            ("sifive_e", Memories([(0x2040_0000, "4M"), (0x8000_0000, "16K")])),
            Target::Rv32imac.flags(),
            "riscv32imac-unknown-none-elf",
        )
    },
    Core {
        figures: false,
        ..riscv("RISC-V rv32imc", ("virt", VIRT), Target::Esp32C3.flags(), "riscv32imc-unknown-none-elf")
    },
    riscv("RISC-V rv32imafc", ("virt", VIRT), Target::Rv32imafc.flags(), "riscv32imafc-unknown-none-elf"),
    Core {
        images: 2,
        figures: true,
        ..only_c("AVR ATmega328P", "atmega328p", Avr, &["-mmcu=atmega328p", "-DF_CPU=16000000UL"])
    },
    Core { target: Some("wasm32-unknown-unknown"), ..only_c("WebAssembly", "node", Wasm, &["--target=wasm32-wasi"]) },
    only_c("x86-64", "this machine", Host, &[]),
    only_c("x86-64 with fused multiply-add", "this machine", Host, &["-mfma"]),
    only_c("PowerPC, big-endian", "qemu-ppc", User, &["-static"]),
];

impl Core {
    /// Name and machine.
    pub(super) fn title(&self) -> String {
        format!("{} ({})", self.name, self.machine)
    }

    /// The C compiler, and its Debian package.
    pub(super) fn compiler(&self) -> (&'static str, &'static str) {
        match self.runner {
            Arm(..) => ("arm-none-eabi-gcc", "gcc-arm-none-eabi, picolibc-arm-none-eabi"),
            RiscV(_) => ("riscv64-unknown-elf-gcc", "gcc-riscv64-unknown-elf, picolibc-riscv64-unknown-elf"),
            Avr => ("avr-gcc", "gcc-avr, avr-libc"),
            Wasm => ("clang", "clang, lld, wasi-libc, libclang-rt-14-dev-wasm32"),
            Host => ("gcc", "gcc"),
            User => ("powerpc-linux-gnu-gcc", "gcc-powerpc-linux-gnu, libc6-dev-powerpc-cross"),
        }
    }

    /// The program that runs its images, and its Debian package.
    pub(super) fn emulator(&self) -> Option<(&'static str, &'static str)> {
        match self.runner {
            Arm(..) => Some(("qemu-system-arm", "qemu-system-arm")),
            RiscV(_) => Some(("qemu-system-riscv32", "qemu-system-misc")),
            Avr => Some(("simavr", "simavr")),
            Wasm => Some(("node", "nodejs")),
            Host => None,
            User => Some(("qemu-ppc", "qemu-user")),
        }
    }

    /// The file that prints, counts and ends there; the folder `firmware-c` is before it.
    pub(super) fn platform(&self) -> &'static str {
        match self.runner {
            Arm(..) | RiscV(_) => "cores/semihosting.c",
            Avr => "cores/avr.c",
            Wasm | Host | User => "host.c",
        }
    }

    /// Arguments of the linker.
    pub(super) fn link(&self) -> Vec<String> {
        match self.runner {
            Arm(memories, ticks) => [memories.link(), vec![format!("-DTICKS={ticks}U")]].concat(),
            RiscV(memories) => memories.link(),
            Avr | Wasm | Host | User => Vec::new(),
        }
    }

    /// Words of the compiler that every file needs: which C library.
    pub(super) fn specs(&self) -> &'static [&'static str] {
        match self.runner {
            Arm(..) | RiscV(_) => &["--specs=picolibc.specs"],
            _ => &[],
        }
    }

    /// The bits of a third of its states.
    pub(super) fn bits(&self) -> Bits {
        if matches!(self.runner, Avr) { Bits::NeitherTinyNorHuge } else { Bits::Any }
    }

    /// True where instructions, or an AVR's cycles, are counted.
    pub(super) fn counts(&self) -> bool {
        matches!(self.runner, Arm(..) | RiscV(_) | Avr)
    }

    /// The command that runs an image; its last line is `done`.
    pub(super) fn run(&self, image: &Path, wasi: &Path) -> Command {
        let Some((program, _)) = self.emulator() else { return Command::new(image) };
        let mut command = match self.runner {
            Arm(..) | RiscV(_) => emulate::qemu(program, self.machine),
            _ => Command::new(program),
        };
        match self.runner {
            Arm(..) => command.arg(image).args(["-icount", "shift=10,align=off,sleep=off"]),
            RiscV(_) => command.arg(image).args(["-icount", "shift=0,align=off,sleep=off", "-bios", "none"]),
            Avr => command.args(["-m", self.machine, "-f", "16000000"]).arg(image),
            Wasm => command.arg("--no-warnings").arg(wasi).arg(image),
            User | Host => command.arg(image),
        };
        command
    }
}

impl Memories {
    /// Picolibc's start-up code and linker script on these memories.
    fn link(self) -> Vec<String> {
        let Self([(flash, flash_size), (ram, ram_size)]) = self;
        let symbols = [
            format!("__flash={flash:#x}"),
            format!("__flash_size={flash_size}"),
            format!("__ram={ram:#x}"),
            format!("__ram_size={ram_size}"),
            "__stack_size=4K".to_owned(),
        ];
        let words = ["--crt0=semihost", "--oslib=semihost", "-Tpicolibc.ld"].map(str::to_owned);
        words.into_iter().chain(symbols.map(|symbol| format!("-Wl,--defsym={symbol}"))).collect()
    }
}
