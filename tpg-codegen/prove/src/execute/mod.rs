//! Executes machine code over terms: one function and what it calls, for a Cortex-M with single-precision VFP.
//!
//! Assumed: the default floating-point environment (round to nearest, no flush to zero, no default NaN), that the state,
//! the memory and the outputs do not overlap each other or the stack, and that nothing else writes to them meanwhile.

mod flow;
mod memory;

use crate::code::{self, Computed, Expression, Found, holds};
use crate::elf::{Address, Function, Image};
use crate::input::{Missing, Result};
use crate::machine::{Cell, Cells, Followers, Interface, Machine, Point, Region, State, Step, Value, merged};
use crate::term::{Bool, Node as Term, Operator, Terms, Width, Word as TermWord};
use crate::thumb::{Exit, FLAGS, LR, PC, Place, REGISTERS, SP};
use Region::Stack;
use Value::{Float, Word};
use flow::{Flow, Node};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// An instruction that is executed, and where.
struct Here<'a> {
    object: &'a Object,
    terms: &'a Terms,
    node: &'a Node,
}

/// Machine code that is executed.
#[derive(Debug)]
pub struct Object {
    image: Image,
    interface: Interface,
    function: Function,
    flow: Rc<Flow>,
    /// The contents of cells when the function begins
    first: Cells,
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
}

impl Machine for Object {
    fn entry(&mut self, terms: &Terms) -> Result<Point> {
        if !self.interface.counts.is_empty() {
            return Err(Missing::new("the object", "a graph in binary32: machine code in integers is not read yet"));
        }
        if self.flow.is_empty() {
            self.flow = Rc::new(flow::flow(&self.image, &self.function)?);
            let anything = || terms.bits(terms.unknown());
            let mut cells = Cells::new();
            for register in (0..REGISTERS).filter(|&register| register != PC) {
                cells.insert(Cell::Register(register), Word(anything()));
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

    fn step(&mut self, terms: &Terms, at: usize, state: State) -> Result<Followers> {
        let flow = self.flow.clone();
        let here = Here { object: self, terms, node: &flow[at] };
        here.step(state).map_err(|what| Missing::new(self.place(at), what))
    }

    fn meets(&self, at: usize) -> bool {
        self.flow[at].begins
    }

    /// Cuts outside of calls, where no integer is a choice of others than constants.
    fn cut(&mut self, terms: &Terms, at: usize, state: &mut State) -> Option<Vec<(Bool, Point)>> {
        let live = self.flow[at].live;
        let top = match state.cells.get(&Cell::Register(SP)) {
            Some(&Word(top)) => self.located(terms, top).filter(|(region, _)| *region == Stack),
            _ => None,
        };
        // What is not read any more is forgotten, as is what is below the stack pointer; offsets are negative.
        state.cells.retain(|cell, _| match *cell {
            Cell::Register(register) => live >> register & 1 == 1,
            Cell::Memory(Stack, offset, _) => top.is_none_or(|(_, top)| offset as i32 >= top as i32),
            _ => true,
        });
        let known = |(cell, value): (&Cell, &Value)| match (cell, *value) {
            (Cell::Register(..FLAGS) | Cell::Memory(..), Word(word)) => {
                !matches!(terms.of_word(word), Term::WordIf(..)) || terms.numbers(word).is_some()
            }
            _ => true,
        };
        let cuts = self.flow[at].callers.is_empty() && self.flow[at].begins && state.cells.iter().all(known);
        cuts.then(|| state.points(terms, at))
    }

    fn place(&self, at: usize) -> String {
        format!("{:#x}", self.flow[at].address.offset)
    }
}

impl Here<'_> {
    fn step(&self, mut state: State) -> Found<Followers> {
        let (terms, next) = (self.terms, &self.node.next);
        let condition = match &self.node.instruction.condition {
            Some(condition) => holds(terms, self.value(condition, &state.cells)?),
            None => Terms::TRUE,
        };
        let Some(jump) = &self.node.instruction.jump else {
            if condition == Terms::TRUE {
                self.execute(&mut state.cells)?;
            } else if condition != Terms::FALSE {
                let mut changed = state.cells.clone();
                self.execute(&mut changed)?;
                state.cells = merged(terms, condition, &changed, &state.cells);
            }
            return Ok(vec![(state, Step::To(next[0]))]);
        };
        let mut ways = Vec::new();
        if let Some(other) = state.under(terms, !condition) {
            ways.push((other, Step::To(next[0])));
        }
        let Some(mut taken) = state.under(terms, condition) else { return Ok(ways) };
        let targets = match jump {
            Exit::Computed(target, _) => {
                let target = self.value(target, &taken.cells)?.bits(terms);
                terms.word_cases(target).into_iter().map(|(held, target)| (held, Some(target))).collect()
            }
            _ => vec![(Terms::TRUE, None)],
        };
        self.execute(&mut taken.cells)?;
        for (held, target) in targets {
            let Some(state) = taken.under(terms, held) else { continue };
            let step = match (target, jump) {
                (Some(target), Exit::Computed(_, None)) => self.returned(target, &state.cells)?,
                (Some(target), _) => Step::To(self.found(target)?),
                (None, _) => Step::To(next[next.len() - 1]),
            };
            ways.push((state, step));
        }
        Ok(ways)
    }

    /// The place of an address from a table.
    fn found(&self, target: TermWord) -> Found<usize> {
        let Some((Region::Section(section), offset)) = self.object.located(self.terms, target) else {
            return Err("a jump by a table that is known");
        };
        let address = Address { section, offset: offset & !1 };
        let found = self.node.next.iter().find(|&&next| self.object.flow[next].address == address);
        found.copied().ok_or("a jump inside its table")
    }

    /// Returns to the caller, if an address is the one behind the call.
    fn returned(&self, target: TermWord, cells: &Cells) -> Found<Step<usize>> {
        let caller = self.node.callers.last();
        let expected = match caller {
            Some(&(_, call)) => Word(self.object.base(self.terms, Region::Behind(call))),
            None => self.object.first[&Cell::Register(LR)],
        };
        if Word(target) != expected {
            return Err("a return to the caller");
        }
        Ok(match caller {
            Some(_) => Step::To(self.node.next[self.node.next.len() - 1]),
            None => Step::Return(self.answer(cells)?),
        })
    }

    /// Sets what the instruction sets.
    fn execute(&self, cells: &mut Cells) -> Found<()> {
        let mut values = Vec::new();
        for (place, expression) in &self.node.instruction.sets {
            let value = match *place {
                // what is not read or not known of flags is forgotten
                Place::Register(flag @ FLAGS..) => {
                    let is_read = |&next: &usize| self.object.flow[next].live >> flag & 1 == 1;
                    let is_read = self.node.next.iter().any(is_read);
                    if is_read { self.value(expression, cells).ok() } else { None }
                }
                _ => Some(self.value(expression, cells)?),
            };
            let address = match place {
                Place::Memory(address, _) => Some(self.value(address, cells)?.bits(self.terms)),
                Place::Register(_) => None,
            };
            values.push((place, address, value));
        }
        for (place, address, value) in values {
            match (place, address, value) {
                (&Place::Memory(_, bytes), Some(address), Some(value)) => self.store(cells, address, bytes, value)?,
                (&Place::Register(register), _, Some(value)) => {
                    cells.insert(Cell::Register(register), value);
                }
                (&Place::Register(register), ..) => {
                    cells.remove(&Cell::Register(register));
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn value(&self, expression: &Expression, cells: &Cells) -> Found<Value> {
        code::value(self.terms, expression, &[], &|name, values| match (name, values) {
            (Computed::Register(register), _) => {
                cells.get(&Cell::Register(register)).copied().ok_or("a register that is known")
            }
            (Computed::Base(region), _) => Ok(Word(self.object.base(self.terms, region))),
            (Computed::Loaded(bytes), &[address]) => code::loaded(self.terms, address.bits(self.terms), &|address| {
                let place = self.object.located(self.terms, address);
                let value = place.and_then(|(region, offset)| self.load_at(region, offset, bytes, cells));
                value.ok_or("a place to load from that is known")
            }),
            (Computed::Completed(address), &[lower])
                if lower == Word(self.object.base(self.terms, Region::Half(address))) =>
            {
                Ok(self.section(address))
            }
            _ => Err("a value that is known"),
        })
    }

    fn section(&self, Address { section, offset }: Address) -> Value {
        let base = self.object.base(self.terms, Region::Section(section));
        Word(self.terms.apply(Operator::Add, Width::W32, base, self.terms.number(offset.into())))
    }
}
