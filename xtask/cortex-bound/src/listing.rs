//! Output of `objdump -dr`, as functions of instructions.

use super::flow::continues_at;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;
use std::{fmt, fs, io};

/// An instruction as printed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    /// Address in its section.
    pub address: u64,
    /// The mnemonic, with condition and width: `bne.n`.
    pub mnemonic: String,
    /// The operands, without comments.
    pub operands: String,
    /// The symbol to be inserted by the linker, for a relocation.
    pub symbol: Option<String>,
    /// The address that the instruction computes or reads, if the code says so.
    pub refers_to: Option<u64>,
}

impl Line {
    /// Returns the text of the instruction.
    pub fn text(&self) -> String {
        format!("{} {}", self.mnemonic, self.operands).trim_end().to_owned()
    }
}

/// An instruction of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Site {
    /// The function.
    pub function: String,
    /// The instruction's address.
    pub address: u64,
    /// The instruction.
    pub text: String,
}

impl fmt::Display for Site {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} at {:#x} ({})", self.function, self.address, self.text)
    }
}

/// A function: its instructions in order, and data between them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Function {
    /// Its name.
    pub name: String,
    /// Section of the function.
    pub section: String,
    /// Start address.
    pub address: u64,
    /// Its instructions; after them those of functions that it continues in, as hand-written code does.
    pub lines: Vec<Line>,
    /// Bytes of data between the instructions: constants, tables.
    pub data: BTreeMap<u64, u8>,
}

impl Function {
    /// Returns one of its instructions as a place.
    pub(crate) fn site(&self, line: &Line) -> Site {
        Site { function: self.name.clone(), address: line.address, text: line.text() }
    }

    /// Tests if it begins by saving the register that holds the return address.
    pub(crate) fn saves_return(&self) -> bool {
        self.lines.first().is_some_and(|line| line.mnemonic.starts_with("push") && line.operands.contains("lr"))
    }
}

/// All functions of an object.
#[derive(Clone, Debug, Default)]
pub struct Listing {
    functions: Vec<Function>,
    by_name: BTreeMap<String, usize>,
    by_address: BTreeMap<(String, u64), usize>,
    /// The words of a linked image, by their addresses: tables of jumps are among them.
    words: BTreeMap<u64, u32>,
    /// It is code of an AVR, whose cycles are counted.
    pub(crate) is_avr: bool,
}

impl Listing {
    /// Parses the output of objdump.
    pub fn parse(text: &str) -> Self {
        let mut listing = Self::default();
        let mut section = String::new();
        let mut is_data = false;
        for line in text.lines() {
            if let Some(name) = line.strip_prefix("Contents of section ") {
                is_data = [".text", ".rodata", ".data"].iter().any(|section| name.starts_with(section));
            } else if let Some(name) = line.strip_prefix("Disassembly of section ") {
                section = name.trim_end_matches(':').to_owned();
                is_data = false;
            } else if is_data {
                listing.words.extend(words(line));
            } else if let Some((address, name)) = header(line) {
                let section = section.clone();
                listing.begin(Function { name, section, address, lines: Vec::new(), data: BTreeMap::new() });
            } else if let Some(function) = listing.functions.last_mut() {
                function.lines.extend(instruction(line));
                function.data.extend(data(line).into_iter().flatten());
            }
        }
        listing.join();
        listing
    }

    /// Appends to each function those whose middle it branches to, or that it runs into.
    fn join(&mut self) {
        let alone = self.functions.clone();
        let starts: BTreeMap<(&str, u64), usize> = alone
            .iter()
            .zip(0..)
            .map(|(function, place)| ((function.section.as_str(), function.address), place))
            .collect();
        let around = |section: &str, address: u64| {
            let (&(other, _), &place) = starts.range(..=(section, address)).next_back()?;
            let lines = &alone[place].lines;
            let is_inside = lines.binary_search_by_key(&address, |line| line.address).is_ok();
            (other == section && is_inside).then_some(place)
        };
        for (place, function) in self.functions.iter_mut().enumerate() {
            let mut joined = BTreeSet::from([place]);
            let mut open = vec![place];
            while let Some(place) = open.pop() {
                let part = &alone[place];
                let others = continues_at(part).into_iter().filter_map(|address| around(&part.section, address));
                for other in others.collect::<Vec<_>>() {
                    if joined.insert(other) {
                        function.lines.extend(alone[other].lines.iter().cloned());
                        function.data.extend(&alone[other].data);
                        open.push(other);
                    }
                }
            }
        }
    }

    fn begin(&mut self, function: Function) {
        let place = self.functions.len();
        self.by_name.entry(function.name.clone()).or_insert(place);
        self.by_address.insert((function.section.clone(), function.address), place);
        self.functions.push(function);
    }

    /// Returns all functions, in the order of the listing.
    pub fn functions(&self) -> &[Function] {
        &self.functions
    }

    /// Returns the unit of bounds.
    pub fn unit(&self) -> &'static str {
        if self.is_avr { "cycles" } else { "instructions" }
    }

    /// Returns the index of a function by its name.
    pub fn named(&self, name: &str) -> Option<usize> {
        self.by_name.get(name).copied()
    }

    /// Returns the words from an address on.
    pub(crate) fn words_from(&self, address: u64) -> impl Iterator<Item = u32> {
        (address..).step_by(4).map_while(|address| self.words.get(&address).copied())
    }

    /// Returns the index of the function that starts at the address.
    pub fn at(&self, section: &str, address: u64) -> Option<usize> {
        self.by_address.get(&(section.to_owned(), address)).copied()
    }
}

/// The place of `e_type` in an ELF file, and its value for an object that is not linked.
const TYPE: (usize, [u8; 2]) = (16, [1, 0]);
/// The place of `e_machine`, and its values for RISC-V and AVR.
const RISC_V: (usize, [u8; 2]) = (18, [243, 0]);
const AVR: (usize, [u8; 2]) = (18, [83, 0]);

/// Disassembles an object or image for a Cortex-M, or an image for a RISC-V or an AVR.
///
/// # Errors
/// If `arm-none-eabi-objdump`, `riscv64-unknown-elf-objdump` or `avr-objdump` is missing or finds nothing to read; an object for a
/// RISC-V or an AVR, whose calls are known only when it is linked.
pub fn disassemble(object: &Path) -> io::Result<Listing> {
    let bytes = fs::read(object)?;
    let says = |(at, value): (usize, [u8; 2])| bytes.get(at..at + 2) == Some(&value[..]);
    let is_linked = !says(TYPE);
    let (program, core) = match (says(RISC_V), says(AVR)) {
        (true, _) => ("riscv64-unknown-elf-objdump", "a RISC-V"),
        (_, true) => ("avr-objdump", "an AVR"),
        _ => ("arm-none-eabi-objdump", ""),
    };
    if !is_linked && !core.is_empty() {
        return Err(io::Error::other(format!("an object for {core}; accepted: a linked image")));
    }
    let contents = is_linked.then_some("-s");
    let arguments = ["-d", "-r", "-z", "--no-show-raw-insn", "-w"].into_iter().chain(contents);
    let output = Command::new(program).args(arguments).arg(object).output();
    let output = output.map_err(|error| io::Error::new(error.kind(), format!("{program}: {error}")))?;
    if !output.status.success() {
        return Err(io::Error::other(String::from_utf8_lossy(&output.stderr).trim().to_owned()));
    }
    Ok(Listing { is_avr: says(AVR), ..Listing::parse(&String::from_utf8_lossy(&output.stdout)) })
}

/// Parses `00000010 <name>:`, unless it is a label within a function of an AVR's library.
fn header(line: &str) -> Option<(u64, String)> {
    let (address, rest) = line.split_once(" <")?;
    let name = rest.strip_suffix(">:")?;
    if name.starts_with("__udivmod") && (name.ends_with("_loop") || name.ends_with("_ep")) {
        return None;
    }
    Some((u64::from_str_radix(address, 16).ok()?, name.to_owned()))
}

/// Returns the address before a colon, and the tab-separated fields behind it.
fn fields(line: &str) -> Option<(u64, impl Iterator<Item = &str>)> {
    let (address, rest) = line.split_once(':')?;
    Some((u64::from_str_radix(address.trim(), 16).ok()?, rest.trim_start().split('\t').map(str::trim)))
}

/// Parses tab-separated fields: `e:`, `bl`, `0 <g>`, and for a relocation `e: R_ARM_THM_CALL`, `g`. Data (`.word`) is
/// not an instruction.
fn instruction(line: &str) -> Option<Line> {
    let (address, mut fields) = fields(line)?;
    let mnemonic = fields.next()?;
    let is_code = mnemonic.starts_with(|first: char| first.is_ascii_lowercase());
    let operands = fields.next().unwrap_or_default();
    let operands = operands.split(['@', ';']).next().unwrap_or_default();
    let operands = operands.split(" # ").next().unwrap_or_default().trim();
    // An AVR branches by a distance, `.-12`; by none to push the address that follows.
    let distance =
        operands.strip_prefix('.').and_then(|distance| distance.parse().ok()).filter(|&distance| distance != 0);
    let target = distance.map(|distance: i64| format!("{:x}", (address + 2).wrapping_add_signed(distance)));
    let operands = target.as_deref().unwrap_or(operands);
    // A comment: `@ (85e8 <f+0x10>)`, `# 1000085c <table>`.
    let comment = line.rsplit_once(['@', '#']).and_then(|(_, comment)| comment.split_once(" <"));
    let refers_to = comment.and_then(|(text, _)| u64::from_str_radix(text.rsplit([' ', '(']).next()?, 16).ok());
    let relocation = fields.find(|field| field.contains(": R_ARM_THM_"));
    let symbol = relocation.and_then(|_| fields.next()).map(str::to_owned);
    is_code.then(|| Line { address, mnemonic: mnemonic.to_owned(), operands: operands.to_owned(), symbol, refers_to })
}

/// Returns the words of a line of a section's contents: an address, up to four groups of bytes, and their characters.
fn words(line: &str) -> impl Iterator<Item = (u64, u32)> + '_ {
    let mut fields = line.split_whitespace();
    let address = fields.next().and_then(|address| u64::from_str_radix(address, 16).ok());
    let words = fields.take(4).filter(|group| group.len() == 8).filter_map(|group| u32::from_str_radix(group, 16).ok());
    address.into_iter().flat_map(|address| (address..).step_by(4)).zip(words.map(u32::swap_bytes))
}

/// Returns the bytes of a line of data, `12: .short 0x0302` with tabs in between, with their addresses.
fn data(line: &str) -> Option<impl Iterator<Item = (u64, u8)> + use<>> {
    let (address, mut fields) = fields(line)?;
    let count = match fields.next()? {
        ".byte" => 1,
        ".short" => 2,
        ".word" => 4,
        _ => return None,
    };
    let value = u32::from_str_radix(fields.next()?.strip_prefix("0x")?, 16).ok()?;
    Some((address..).zip(value.to_le_bytes()).take(count))
}
