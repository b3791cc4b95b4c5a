//! Output of `objdump -dr`, as functions of instructions.

use std::collections::BTreeMap;
use std::io;
use std::path::Path;
use std::process::Command;

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
}

impl Line {
    /// Returns the text of the instruction.
    pub fn text(&self) -> String {
        format!("{} {}", self.mnemonic, self.operands).trim_end().to_owned()
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
    /// Its instructions.
    pub lines: Vec<Line>,
    /// Bytes of data between the instructions: constants, tables.
    pub data: BTreeMap<u64, u8>,
}

/// All functions of an object.
#[derive(Clone, Debug, Default)]
pub struct Listing {
    functions: Vec<Function>,
    by_name: BTreeMap<String, usize>,
    by_address: BTreeMap<(String, u64), usize>,
}

impl Listing {
    /// Parses the output of objdump.
    pub fn parse(text: &str) -> Self {
        let mut listing = Self::default();
        let mut section = String::new();
        for line in text.lines() {
            if let Some(name) = line.strip_prefix("Disassembly of section ") {
                section = name.trim_end_matches(':').to_owned();
            } else if let Some((address, name)) = header(line) {
                let section = section.clone();
                listing.begin(Function { name, section, address, lines: Vec::new(), data: BTreeMap::new() });
            } else if let Some(function) = listing.functions.last_mut() {
                function.lines.extend(instruction(line));
                function.data.extend(data(line).into_iter().flatten());
            }
        }
        listing
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

    /// Returns the index of a function by its name.
    pub fn named(&self, name: &str) -> Option<usize> {
        self.by_name.get(name).copied()
    }

    /// Returns the index of the function that starts at the address.
    pub fn at(&self, section: &str, address: u64) -> Option<usize> {
        self.by_address.get(&(section.to_owned(), address)).copied()
    }
}

/// Disassembles an object or image.
///
/// # Errors
/// If `arm-none-eabi-objdump` is missing or finds nothing to read.
pub fn disassemble(object: &Path) -> io::Result<Listing> {
    let program = "arm-none-eabi-objdump";
    let output = Command::new(program).args(["-d", "-r", "-z", "--no-show-raw-insn", "-w"]).arg(object).output();
    let output = output.map_err(|error| io::Error::new(error.kind(), format!("{program}: {error}")))?;
    if !output.status.success() {
        return Err(io::Error::other(String::from_utf8_lossy(&output.stderr).trim().to_owned()));
    }
    Ok(Listing::parse(&String::from_utf8_lossy(&output.stdout)))
}

/// Parses `00000010 <name>:`.
fn header(line: &str) -> Option<(u64, String)> {
    let (address, rest) = line.split_once(" <")?;
    let name = rest.strip_suffix(">:")?;
    Some((u64::from_str_radix(address, 16).ok()?, name.to_owned()))
}

/// Parses tab-separated fields: `e:`, `bl`, `0 <g>`, and for a relocation `e: R_ARM_THM_CALL`, `g`. Data (`.word`) is
/// not an instruction.
fn instruction(line: &str) -> Option<Line> {
    let (address, rest) = line.split_once(':')?;
    let address = u64::from_str_radix(address.trim(), 16).ok()?;
    let mut fields = rest.trim_start().split('\t').map(str::trim);
    let mnemonic = fields.next()?;
    let is_code = mnemonic.starts_with(|first: char| first.is_ascii_lowercase());
    let operands = fields.next().unwrap_or_default();
    let operands = operands.split(['@', ';']).next().unwrap_or_default().trim();
    let relocation = fields.find(|field| field.contains(": R_ARM_THM_"));
    let symbol = relocation.and_then(|_| fields.next()).map(str::to_owned);
    is_code.then(|| Line { address, mnemonic: mnemonic.to_owned(), operands: operands.to_owned(), symbol })
}

/// Returns the bytes of a line of data, `12: .short 0x0302` with tabs in between, with their addresses.
fn data(line: &str) -> Option<impl Iterator<Item = (u64, u8)> + use<>> {
    let (address, rest) = line.split_once(':')?;
    let address = u64::from_str_radix(address.trim(), 16).ok()?;
    let mut fields = rest.trim_start().split('\t').map(str::trim);
    let count = match fields.next()? {
        ".byte" => 1,
        ".short" => 2,
        ".word" => 4,
        _ => return None,
    };
    let value = u32::from_str_radix(fields.next()?.strip_prefix("0x")?, 16).ok()?;
    Some((address..).zip(value.to_le_bytes()).take(count))
}
