//! Executes machine code over terms: one function and what it calls, for a Cortex-M with single-precision VFP.
//!
//! Assumed: the default floating-point environment (round to nearest, no flush to zero, no default NaN), that the state,
//! the memory and the outputs do not overlap each other or the stack, and that nothing else writes to them meanwhile.

mod compute;
mod flow;
mod memory;

use crate::elf::{Address, Function, Image};
use crate::input::{Missing, Result};
use crate::machine::{Cells, Followers, Interface, Machine, State, Step, Value, merged};
use crate::term::{Bool, Node as Term, Operator, Terms, Width, Word as TermWord};
use crate::thumb::{LR, Offset, Operation, PC, REGISTERS, Register, SP};
use Operation::*;
use Region::Stack;
use Value::{Float, Truth, Word};
use compute::FLAG_COUNT;
use flow::{FLAGS, FLOAT_FLAGS, Flow, Node, behind_call};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// Something with an address that is not known. What is in memory overlaps nothing else.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Region {
    /// The values of the state, which are only read
    State,
    /// The values of the memory
    Memory,
    /// The outputs
    Outputs,
    /// The stack below the place where the function began
    Stack,
    /// A section of the image
    Section(usize),
    /// The code behind a call
    Behind(Address),
    /// The lower half of an address alone
    Half(Address),
}

/// A register, what flags say, or a place in memory with its bytes; places do not overlap.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Cell {
    /// A register of integers or floats
    Register(Register),
    /// A condition by its number; with `true`, as floats were compared before those flags are read
    Flag(bool, u8),
    /// Bytes in a part of memory
    Memory(Region, u32, u8),
}

/// A place in machine code, with everything that is alive there.
pub type Point = crate::machine::Point<Cell>;

/// An instruction that is executed, and where.
struct Here<'a> {
    object: &'a Object,
    terms: &'a Terms,
    node: &'a Node,
    cells: &'a mut Cells<Cell>,
}

/// The target of a jump: an address, or the caller of the function.
type Target = Option<Address>;

/// Machine code that is executed.
#[derive(Debug)]
pub struct Object {
    image: Image,
    interface: Interface,
    function: Function,
    flow: Rc<Flow>,
    /// The contents of cells when the function begins
    first: Cells<Cell>,
    /// The symbols of the regions' addresses
    bases: RefCell<BTreeMap<Region, TermWord>>,
}

impl Object {
    /// Prepares the execution of a function.
    ///
    /// # Errors
    /// If the file is no object for ARM, or has no such function in Thumb code.
    pub fn new(file: &[u8], symbol: &str, interface: Interface) -> std::result::Result<Self, String> {
        let image = Image::read(file)?;
        let function = image.function(symbol)?;
        Ok(Self { image, interface, function, flow: Rc::default(), first: Cells::new(), bases: RefCell::default() })
    }

    fn here<'a>(&'a self, terms: &'a Terms, node: &'a Node, cells: &'a mut Cells<Cell>) -> Here<'a> {
        Here { object: self, terms, node, cells }
    }

    /// The symbol of a region's address.
    fn base(&self, terms: &Terms, region: Region) -> TermWord {
        *self.bases.borrow_mut().entry(region).or_insert_with(|| terms.bits(terms.unknown()))
    }

    /// The region of an address, and the bytes from its base on.
    fn located(&self, terms: &Terms, address: TermWord) -> Option<(Region, u32)> {
        let (base, offset) = match terms.of_word(address) {
            Term::Apply(Operator::Add, Width::W32, base, offset) => (base, terms.number_of(offset)?),
            _ => (address, 0),
        };
        let bases = self.bases.borrow();
        bases.iter().find(|(_, known)| **known == base).map(|(&region, _)| (region, offset as u32))
    }

    /// Finds the place of an address that control may go to.
    fn next(&self, node: &Node, target: Address) -> Result<usize> {
        let found = node.next.iter().find(|&&next| self.flow[next].address == target);
        found.copied().ok_or_else(|| Missing::new(format!("{:#x}", node.address.offset), "a jump outside its table"))
    }
}

impl Machine for Object {
    type Cell = Cell;

    fn entry(&mut self, terms: &Terms) -> Result<Point> {
        if self.flow.is_empty() {
            self.flow = Rc::new(flow::flow(&self.image, &self.function)?);
            let anything = || terms.bits(terms.unknown());
            let mut cells = Cells::new();
            for register in (0..REGISTERS).filter(|&register| register != PC) {
                cells.insert(Cell::Register(register), Word(anything()));
            }
            for number in 0..FLAG_COUNT {
                cells.insert(Cell::Flag(false, number), Truth(anything()));
                cells.insert(Cell::Flag(true, number), Truth(anything()));
            }
            let mut arguments = vec![Region::State];
            arguments.extend((!self.interface.memory.is_empty()).then_some(Region::Memory));
            arguments.extend((!self.interface.outputs.is_empty()).then_some(Region::Outputs));
            for (register, region) in (0..).zip(arguments).chain([(SP, Stack)]) {
                cells.insert(Cell::Register(register), Word(self.base(terms, region)));
            }
            // The memory's values follow those of the state.
            for (index, _) in (0..).zip(&self.interface.memory) {
                let source = terms.source(self.interface.state_length() + index);
                cells.insert(Cell::Memory(Region::Memory, 4 * index, 4), Float(source));
            }
            self.first = cells;
        }
        Ok(Point { at: 0, cells: self.first.clone() })
    }

    fn step(&mut self, terms: &Terms, at: usize, mut state: State<Cell>) -> Result<Followers<Cell>> {
        let flow = self.flow.clone();
        let node = &flow[at];
        let operation = &node.instruction.operation;
        let behind = node.address.at(node.instruction.behind());
        let condition = self.here(terms, node, &mut state.cells).condition()?;
        if operation.leaves() {
            let mut ways = Vec::new();
            if let Some(other) = state.under(terms, !condition) {
                ways.push((other, Step::To(self.next(node, behind)?)));
            }
            let Some(mut taken) = state.under(terms, condition) else { return Ok(ways) };
            for (held, target) in self.here(terms, node, &mut taken.cells).targets()? {
                if let Some(mut state) = taken.under(terms, held) {
                    let step = match target {
                        Some(target) => Step::To(self.next(node, target)?),
                        None => Step::Return(self.here(terms, node, &mut state.cells).answer()?),
                    };
                    ways.push((state, step));
                }
            }
            return Ok(ways);
        }
        if condition == Terms::TRUE {
            self.here(terms, node, &mut state.cells).execute()?;
        } else if condition != Terms::FALSE {
            let mut changed = state.cells.clone();
            self.here(terms, node, &mut changed).execute()?;
            state.cells = merged(terms, condition, &changed, &state.cells);
        }
        Ok(vec![(state, Step::To(self.next(node, behind)?))])
    }

    fn meets(&self, at: usize) -> bool {
        self.flow[at].begins
    }

    /// Cuts outside of calls, where no integer is a choice of others than constants.
    fn cut(&mut self, terms: &Terms, at: usize, state: &mut State<Cell>) -> Option<Vec<(Bool, Point)>> {
        let live = self.flow[at].live;
        let top = match state.cells.get(&Cell::Register(SP)) {
            Some(&Word(top)) => self.located(terms, top).filter(|(region, _)| *region == Stack),
            _ => None,
        };
        // What is not read any more is forgotten, as is what is below the stack pointer; offsets are negative.
        state.cells.retain(|cell, _| match *cell {
            Cell::Register(register) => live >> register & 1 == 1,
            Cell::Flag(floats, _) => live & if floats { FLOAT_FLAGS } else { FLAGS } != 0,
            Cell::Memory(Stack, offset, _) => top.is_none_or(|(_, top)| offset as i32 >= top as i32),
            Cell::Memory(..) => true,
        });
        let known = |value: &Value| match *value {
            Word(word) => !matches!(terms.of_word(word), Term::WordIf(..)) || terms.numbers(word).is_some(),
            _ => true,
        };
        let cuts = self.flow[at].callers.is_empty() && self.flow[at].begins && state.cells.values().all(known);
        cuts.then(|| state.points(terms, at))
    }

    fn place(&self, at: usize) -> String {
        format!("{:#x}", self.flow[at].address.offset)
    }
}

impl Here<'_> {
    /// Returns what holds where the instruction is executed.
    fn condition(&self) -> Result<Bool> {
        match self.node.instruction.operation {
            BranchIf { register, zero, .. } => {
                let same = self.terms.same(Width::W32, self.word(register)?, self.terms.number(0));
                Ok(if zero { same } else { !same })
            }
            _ => self.flag(self.node.instruction.condition),
        }
    }

    /// Executes a branch, call or return: where it goes, and what must hold for that.
    fn targets(&mut self) -> Result<Vec<(Bool, Target)>> {
        let place = self.node.address;
        let by_table = |index, table: &dyn Fn(TermWord) -> Option<Address>| {
            let targets = self.terms.word_cases(index, |_| false).into_iter().map(|(held, index)| {
                let target = table(index).ok_or_else(|| self.refusal("a jump by an unknown table"))?;
                Ok((held, Some(target)))
            });
            targets.collect()
        };
        match self.node.instruction.operation {
            Branch { target } | BranchIf { target, .. } => Ok(vec![(Terms::TRUE, Some(place.at(target)))]),
            Call { .. } => {
                let callee = self.node.next.last().map(|&next| self.object.flow[next].address);
                let back = self.object.base(self.terms, Region::Behind(place));
                self.cells.insert(Cell::Register(LR), Word(back));
                Ok(vec![(Terms::TRUE, callee)])
            }
            Exchange { register } => self.returned(self.register(register)?),
            Transfer { place: at, .. } if matches!(at.offset, Offset::Register(..)) => {
                by_table(self.addresses(at)?.0, &|entry| {
                    let (Region::Section(section), offset) = self.object.located(self.terms, entry)? else {
                        return None;
                    };
                    let target = self.object.image.pointer(Address { section, offset })?;
                    Some(target.at(target.offset & !1))
                })
            }
            Transfer { .. } => {
                self.execute()?;
                let target = self.register(PC)?;
                self.cells.remove(&Cell::Register(PC));
                self.returned(target)
            }
            Table { index, bytes, .. } => {
                let behind = self.node.instruction.behind();
                by_table(self.word(index)?, &|index| {
                    let index = self.terms.number_of(index)? as u32;
                    let entry = place.at(behind.wrapping_add(index.wrapping_mul(bytes.into())));
                    Some(place.at(behind.wrapping_add(2 * self.object.image.number(entry, bytes)?)))
                })
            }
            _ => self.refuse("no branch"),
        }
    }

    /// Returns to the caller, if an address is the one behind the call.
    fn returned(&self, to: Value) -> Result<Vec<(Bool, Target)>> {
        let caller = self.node.callers.last();
        let expected = match caller {
            Some(&(_, call)) => Word(self.object.base(self.terms, Region::Behind(call))),
            None => self.object.first[&Cell::Register(LR)],
        };
        if to != expected {
            return self.refuse("returns to another address");
        }
        Ok(vec![(Terms::TRUE, caller.map(|&(_, call)| behind_call(call)))])
    }
}
