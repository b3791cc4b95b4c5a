//! Cores and chips that generated C is compiled for, with the compiler and flags of each.

use crate::verify;
use clap::ValueEnum;
use serde::Serialize;
use std::io;
use std::process::Command;
use std::str::FromStr;

/// A target of generated code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Target {
    /// This machine, by its C compiler.
    #[default]
    Host,
    /// Cortex-M0, without an FPU.
    M0,
    /// Cortex-M3, without an FPU.
    M3,
    /// Cortex-M4, without an FPU.
    M4,
    /// Cortex-M4 with an FPU for single precision.
    M4f,
    /// Cortex-M7 with an FPU for single precision.
    M7,
    /// Cortex-M33 with an FPU for single precision.
    M33,
    /// RISC-V without an FPU.
    Rv32imac,
    /// RISC-V with an FPU for single precision.
    Rv32imafc,
    /// Raspberry Pi Pico: Cortex-M0+.
    Rp2040,
    /// ESP32-C3: RISC-V rv32imc.
    Esp32C3,
    /// Arduino Uno: AVR.
    Atmega328p,
}

impl FromStr for Target {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        ValueEnum::from_str(name, false).map_err(|_| {
            let values = Self::value_variants().iter().filter_map(ValueEnum::to_possible_value);
            let accepted: Vec<String> = values.map(|value| value.get_name().to_owned()).collect();
            format!("the target {name:?}; accepted: {}", accepted.join(", "))
        })
    }
}

const ARM: &str = "arm-none-eabi-gcc";
const RISC_V: &str = "riscv64-unknown-elf-gcc";
const AVR: &str = "avr-gcc";

impl Target {
    /// The targets of a report that names none.
    pub const DEFAULT: [Self; 2] = [Self::M4f, Self::Host];

    /// The name in reports, the compiler, and its flags for the core.
    const fn described(self) -> (&'static str, &'static str, &'static [&'static str]) {
        const SOFT: &str = "-mfloat-abi=soft";
        const HARD: &str = "-mfloat-abi=hard";
        match self {
            Self::Host => ("this machine", "", &[]),
            Self::M0 => ("Cortex-M0", ARM, &["-mcpu=cortex-m0", "-mthumb", SOFT]),
            Self::M3 => ("Cortex-M3", ARM, &["-mcpu=cortex-m3", "-mthumb", SOFT]),
            Self::M4 => ("Cortex-M4", ARM, &["-mcpu=cortex-m4", "-mthumb", SOFT]),
            Self::M4f => ("Cortex-M4F", ARM, &["-mcpu=cortex-m4", "-mthumb", HARD, "-mfpu=fpv4-sp-d16"]),
            Self::M7 => ("Cortex-M7", ARM, &["-mcpu=cortex-m7", "-mthumb", HARD, "-mfpu=fpv5-sp-d16"]),
            Self::M33 => ("Cortex-M33", ARM, &["-mcpu=cortex-m33", "-mthumb", HARD, "-mfpu=fpv5-sp-d16"]),
            Self::Rv32imac => ("RV32IMAC", RISC_V, &["-march=rv32imac", "-mabi=ilp32", "-mcmodel=medany"]),
            Self::Rv32imafc => ("RV32IMAFC", RISC_V, &["-march=rv32imafc", "-mabi=ilp32f", "-mcmodel=medany"]),
            Self::Rp2040 => ("RP2040", ARM, &["-mcpu=cortex-m0plus", "-mthumb", SOFT]),
            Self::Esp32C3 => ("ESP32-C3", RISC_V, &["-march=rv32imc", "-mabi=ilp32", "-mcmodel=medany"]),
            Self::Atmega328p => ("ATmega328P", AVR, &["-mmcu=atmega328p"]),
        }
    }

    /// The name in reports.
    pub fn name(self) -> &'static str {
        self.described().0
    }

    /// The compiler's flags for the core.
    pub const fn flags(self) -> &'static [&'static str] {
        self.described().2
    }

    /// Returns the compiler with the target's flags.
    ///
    /// # Errors
    /// If this machine's compiler, which `CC` may name, is not there.
    pub(super) fn compiler(self) -> io::Result<Command> {
        if self == Self::Host {
            return Ok(verify::c_compiler().map_err(io::Error::other)?.to_command());
        }
        let (_, program, flags) = self.described();
        let mut command = Command::new(program);
        command.args(flags);
        // Debian's compiler for RISC-V comes without a library of C, which picolibc is.
        if program == RISC_V {
            let found = Command::new(program).arg("--print-file-name=picolibc.specs").output();
            if found.is_ok_and(|found| found.stdout.contains(&b'/')) {
                command.arg("--specs=picolibc.specs");
            }
        }
        Ok(command)
    }

    /// The unit of the bound of a decision.
    pub(crate) fn unit(self) -> &'static str {
        if self.described().1 == AVR { "cycles" } else { "instructions" }
    }

    /// True for cores whose linked code has a bound on instructions; of integers also an AVR's, whose cycles are counted.
    pub(super) fn has_bound(self, of_integers: bool) -> bool {
        let program = self.described().1;
        [ARM, RISC_V].contains(&program) || of_integers && program == AVR
    }
}
