//! Functions on a Cortex-M4F under QEMU, on random and special operands.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;
use tpg_prove::term::is_nan_bits;

/// Operands that random numbers rarely hit.
const SPECIAL: [u32; 20] = [
    0,
    0x8000_0000,
    1,
    0x8000_0001,
    0x7f80_0000,
    0xff80_0000,
    0x7fc0_0000,
    0x3f80_0000,
    0xbf80_0000,
    0x7f7f_ffff,
    0xff7f_ffff,
    0x0080_0000,
    0x007f_ffff,
    0x7fff_ffff,
    0xffff_ffff,
    0x4f00_0000,
    0xcf00_0000,
    0x4b80_0001,
    31,
    32,
];

/// The operands that QEMU sees, too.
pub(crate) struct Operands(pub(crate) u32);

impl Operands {
    fn number(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    pub(crate) fn next(&mut self) -> u32 {
        let (kind, bits) = (self.number(), self.number());
        canonical(match kind % 4 {
            0 => bits,
            1 => SPECIAL[bits as usize % SPECIAL.len()],
            2 => (0x3f80_0000 + bits % 0x200_0000 - 0x100_0000).wrapping_add(bits & 0x8000_0000),
            _ => bits % 64,
        })
    }
}

fn canonical(bits: u32) -> u32 {
    if is_nan_bits(bits) { 0x7fc0_0000 } else { bits }
}

/// Runs a program and returns what it prints.
pub(crate) fn run(folder: &Path, program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).current_dir(folder).args(arguments).output().expect("it starts");
    let text = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
    assert!(output.status.success(), "{program} {arguments:?}: {text}");
    text
}

/// What runs under QEMU.
#[derive(Clone, Copy)]
pub(crate) struct Forms<'a> {
    /// Objects with the functions `form_0` and so on
    pub(crate) objects: &'a [&'a str],
    /// The number of functions
    pub(crate) count: usize,
    /// Values that a function reads
    pub(crate) operands: usize,
    /// Values that it writes
    pub(crate) results: usize,
    /// How often each is called
    pub(crate) states: usize,
}

/// True if the tools are there.
pub(crate) fn tools(what: &str) -> bool {
    let tools = [("arm-none-eabi-gcc", "gcc-arm-none-eabi"), ("qemu-system-arm", "qemu-system-arm")];
    tools.into_iter().all(|(tool, package)| tpg_testing::tool(tool, package, what))
}

impl Forms<'_> {
    /// A hash of the results of each function, or all results of one.
    pub(crate) fn emulated(&self, folder: &Path, one: Option<usize>) -> Vec<u32> {
        let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/fixtures/cortex-m4");
        for file in ["image.s", "image.ld"] {
            std::fs::copy(fixtures.join(file), folder.join(file)).expect("the folder can be written");
        }
        let mut table = ".section .rodata\n.balign 4\n.global special\nspecial:\n".to_owned();
        for number in SPECIAL {
            let _ = writeln!(table, ".word {number}");
        }
        table += ".global forms\nforms:\n";
        for number in 0..self.count {
            let _ = writeln!(table, ".word form_{number}");
        }
        for (file, text) in [("states", "none"), ("table.s", &table), ("forms.c", include_str!("fixtures/forms.c"))] {
            std::fs::write(folder.join(file), text).expect("the folder can be written");
        }
        let counts = [
            ("FORMS", self.count),
            ("STATES", self.states),
            ("SPECIAL", SPECIAL.len()),
            ("OPERANDS", self.operands),
            ("RESULTS", self.results),
        ];
        let mut defines = counts.map(|(name, value)| format!("-D{name}={value}U")).to_vec();
        defines.extend(one.map(|one| format!("-DONE={one}U")));
        let defines: Vec<&str> = defines.iter().map(String::as_str).collect();
        let core = ["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16", "-O2", "-ffreestanding"];
        let sources = ["forms.c", "table.s", "image.s", "-nostartfiles", "-T", "image.ld", "-o", "image.elf"];
        run(folder, "arm-none-eabi-gcc", &[&core[..], &defines, self.objects, &sources].concat());
        let machine = ["-machine", "mps2-an386", "-nographic", "-monitor", "none", "-serial", "none"];
        let printed = ["-semihosting-config", "enable=on,target=native", "-kernel", "image.elf"];
        let text = run(folder, "qemu-system-arm", &[&machine[..], &printed].concat());
        text.lines().filter_map(|line| line.trim().parse().ok()).collect()
    }
}
