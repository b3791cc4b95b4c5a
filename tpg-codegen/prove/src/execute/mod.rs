//! Executes machine code over terms: one function and what it calls, for a Cortex-M with single-precision VFP.
//!
//! Assumed: the default floating-point environment (round to nearest, no flush to zero, no default NaN), that the state,
//! the memory and the outputs do not overlap each other or the stack, and that nothing else writes to them meanwhile.

mod flow;
mod memory;
mod step;
mod value;

use crate::elf::{Address, Error, Function, Image};
use crate::input::{Missing, Result};
use crate::machine::{Interface, Machine, Step};
use crate::term::{Bool, Terms, Width, Word};
use crate::thumb::{Instruction, PC, REGISTERS, Register, SP};
use Value::*;
use flow::{FLAGS, FLOAT_FLAGS, Flow};
use std::collections::{BTreeMap, HashMap};
use std::rc::Rc;
use value::{Cell, Flags, Region::*, Unknowns, Value, restricted};

/// So many instructions are executed at most between two points.
const LIMIT: usize = 200_000;

/// A place in machine code, with everything that is alive there.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Point {
    address: u32,
    registers: [Option<Value>; REGISTERS],
    flags: Flags,
    float_flags: Flags,
    memory: BTreeMap<Cell, Value>,
    /// The function that is executed, and the callers with the addresses of their next instructions.
    function: Address,
    callers: Vec<(Address, u32)>,
}

/// A point on its way, with the condition under which it is reached.
#[derive(Clone)]
struct MachineState {
    point: Point,
    guard: Bool,
    /// Its place in an order in which everything comes after what leads to it: for each call, the iterations of the
    /// loops and the instruction's own place.
    position: Vec<u32>,
}

/// An instruction that is executed, and where.
struct Here<'a> {
    object: &'a Object,
    terms: &'a Terms,
    point: &'a mut Point,
    at: &'a Instruction,
}

/// A state behind an instruction.
enum Next {
    /// At the next instruction.
    At(MachineState),
    /// Behind a call, where all paths through the function that was called meet.
    Behind(MachineState),
    /// At the end of the function.
    Return(MachineState),
}

/// Machine code that is executed.
#[derive(Debug)]
pub struct Object {
    image: Image,
    interface: Interface,
    function: Function,
    flows: HashMap<Address, Rc<Flow>>,
    unknowns: Unknowns,
}

impl Object {
    /// Prepares the execution of a function.
    ///
    /// # Errors
    /// If the file is no object for ARM, or has no such function in Thumb code.
    pub fn new(file: &[u8], symbol: &str, interface: Interface) -> std::result::Result<Self, Error> {
        let image = Image::read(file)?;
        let function = image.function(symbol)?.clone();
        Ok(Self { image, interface, function, flows: HashMap::new(), unknowns: Unknowns::default() })
    }

    fn flow(&mut self, function: Address) -> Result<Rc<Flow>> {
        if let Some(flow) = self.flows.get(&function) {
            return Ok(flow.clone());
        }
        let place = format!("{:#x}", self.image.absolute(function));
        let function = self.image.function_at(function).ok_or_else(|| Missing::new(place, "a call to no function"))?;
        let flow = Rc::new(Flow::new(&self.image, &function)?);
        self.flows.insert(function.start, flow.clone());
        Ok(flow)
    }

    /// Joins two states at the same place.
    fn joined(&mut self, terms: &Terms, a: &MachineState, b: &MachineState) -> MachineState {
        let guard = terms.or(a.guard, b.guard);
        let condition = distinguishing(terms, a.guard, b.guard);
        MachineState { point: self.merged(terms, condition, &a.point, &b.point), guard, position: a.position.clone() }
    }

    /// Returns a point that is the first where the condition holds, else the second.
    fn merged(&mut self, terms: &Terms, condition: Bool, a: &Point, b: &Point) -> Point {
        let mut point = a.clone();
        for (register, value) in point.registers.iter_mut().enumerate() {
            let both = a.registers[register].zip(b.registers[register]);
            *value = both.map(|(a, b)| self.unknowns.merged(terms, condition, a, b));
        }
        point.memory = BTreeMap::new();
        for (&cell, &value) in &a.memory {
            if let Some(&other) = b.memory.get(&cell) {
                point.memory.insert(cell, self.unknowns.merged(terms, condition, value, other));
            }
        }
        point.flags = Flags::merged(condition, &a.flags, &b.flags);
        point.float_flags = Flags::merged(condition, &a.float_flags, &b.float_flags);
        point
    }

    /// Forgets what is not read any more, and the choices that the guard decides.
    fn tidied(&mut self, terms: &Terms, state: &mut MachineState) -> Result<()> {
        let facts = terms.parts(state.guard);
        let point = &mut state.point;
        let mut live = self.flow(point.function)?.nodes[&point.address].live;
        for &(function, address) in &point.callers {
            live |= self.flow(function)?.nodes[&address].live;
        }
        for (register, value) in point.registers.iter_mut().enumerate() {
            let is_live = live >> register & 1 == 1;
            *value = value.filter(|_| is_live).map(|value| restricted(terms, value, &facts));
        }
        if live & FLAGS == 0 {
            point.flags = Flags::Unknown;
        }
        if live & FLOAT_FLAGS == 0 {
            point.float_flags = Flags::Unknown;
        }
        let top = match point.registers[SP as usize] {
            Some(Pointer(Stack, offset)) => terms.number_of(offset),
            _ => None,
        };
        // What is below the stack pointer is lost; offsets are negative.
        let lost = |region, offset| region == Stack && top.is_some_and(|top| (offset as i32) < top as u32 as i32);
        point.memory.retain(|&(region, offset, _), _| !lost(region, offset));
        for value in point.memory.values_mut() {
            *value = restricted(terms, *value, &facts);
        }
        Ok(())
    }

    /// Splits a state where the next piece begins: integers become constants. None if the piece goes on.
    fn cut(&mut self, terms: &Terms, state: &MachineState) -> Result<Option<Vec<(Bool, Point)>>> {
        let point = &state.point;
        let flow = self.flow(point.function)?;
        let node = &flow.nodes[&point.address];
        if !point.callers.is_empty() || !node.begins {
            return Ok(None);
        }
        let mut cases = vec![(state.guard, point.clone())];
        let mut words = Vec::new();
        for value in point.registers.iter().flatten().chain(point.memory.values()) {
            if let Value::Word(word) | Pointer(_, word) = value
                && terms.number_of(*word).is_none()
                && !words.contains(word)
            {
                words.push(*word);
            }
        }
        for word in words {
            let Some(numbers) = terms.numbers(word) else { return Ok(None) };
            let mut split = Vec::new();
            for number in numbers {
                let constant = terms.number(number);
                let same = terms.same(Width::W32, word, constant);
                for (guard, point) in &cases {
                    let guard = terms.and(*guard, same);
                    if guard != Terms::FALSE {
                        split.push((guard, point.with(word, constant)));
                    }
                }
            }
            cases = split;
        }
        Ok(Some(cases))
    }

    /// Moves a state to another instruction of its function.
    fn moved(&mut self, state: &mut MachineState, to: u32) -> Result<()> {
        let from = state.point.address;
        let flow = self.flow(state.point.function)?;
        let (Some(before), Some(after)) = (flow.nodes.get(&from), flow.nodes.get(&to)) else {
            return Err(Missing::new(format!("{from:#x}"), "a path that leaves the function"));
        };
        let own = state.position.len() - 1 - 2 * before.loops.len();
        let mut position = state.position[..own].to_vec();
        for (depth, &head) in after.loops.iter().enumerate() {
            let inside = before.loops.get(depth) == Some(&head) && before.loops[..depth] == after.loops[..depth];
            let iteration = if inside { state.position[own + 2 * depth + 1] } else { 0 };
            let again = inside && after.order == head;
            position.extend([head, iteration + u32::from(again)]);
            if again {
                break;
            }
        }
        position.push(after.order);
        state.position = position;
        state.point.address = to;
        Ok(())
    }
}

/// Returns a condition that tells two guards apart: without what they share.
fn distinguishing(terms: &Terms, a: Bool, b: Bool) -> Bool {
    let (first, second) = (terms.parts(a), terms.parts(b));
    if let Some(&fact) = first.iter().find(|&&fact| second.contains(&!fact)) {
        return fact;
    }
    let own: Vec<Bool> = first.into_iter().filter(|fact| !second.contains(fact)).collect();
    if own.is_empty() { a } else { terms.all(own) }
}

impl Point {
    /// Replaces a word wherever it is.
    fn with(&self, word: Word, number: Word) -> Self {
        let mut point = self.clone();
        for place in point.registers.iter_mut().flatten().chain(point.memory.values_mut()) {
            match place {
                Value::Word(found) | Pointer(_, found) if *found == word => *found = number,
                _ => {}
            }
        }
        point
    }
}

impl Machine for Object {
    type Point = Point;

    fn entry(&mut self, terms: &Terms) -> Result<Point> {
        let function = self.function.start;
        let mut registers: [Option<Value>; REGISTERS] =
            std::array::from_fn(|register| Some(Initial(register as Register)));
        let zero = terms.number(0);
        let mut arguments = vec![State];
        arguments.extend((!self.interface.memory.is_empty()).then_some(Memory));
        arguments.extend((!self.interface.outputs.is_empty()).then_some(Outputs));
        for (register, region) in registers.iter_mut().zip(arguments) {
            *register = Some(Pointer(region, zero));
        }
        registers[SP as usize] = Some(Pointer(Stack, zero));
        registers[PC as usize] = None;
        let address = self.flow(function)?.entry;
        // The memory's values follow those of the state.
        let mut memory = BTreeMap::new();
        for (index, _) in (0..).zip(&self.interface.memory) {
            memory.insert((Memory, 4 * index, 4), Float(terms.source(self.interface.state_length() + index)));
        }
        Ok(Point {
            address,
            registers,
            flags: Flags::Unknown,
            float_flags: Flags::Unknown,
            memory,
            function,
            callers: Vec::new(),
        })
    }

    fn run(&mut self, terms: &Terms, from: &Point) -> Result<Vec<(Bool, Step<Point>)>> {
        let flow = self.flow(from.function)?;
        let mut waiting: BTreeMap<Vec<u32>, MachineState> = BTreeMap::new();
        let node = &flow.nodes[&from.address];
        let mut position: Vec<u32> = node.loops.iter().flat_map(|&head| [head, 0]).collect();
        position.push(node.order);
        let mut pieces: Vec<(Bool, Step<Point>)> = Vec::new();
        let mut first = Some(MachineState { point: from.clone(), guard: Terms::TRUE, position });
        let mut count = 0;
        while let Some(mut state) = first.take().or_else(|| waiting.pop_first().map(|(_, state)| state)) {
            if count > 0 {
                self.tidied(terms, &mut state)?;
                if let Some(cases) = self.cut(terms, &state)? {
                    pieces.extend(cases.into_iter().map(|(guard, point)| (guard, Step::To(point))));
                    continue;
                }
            }
            loop {
                count += 1;
                if count > LIMIT {
                    return Err(Missing::new(self.place(&state.point), "more instructions than can be looked at"));
                }
                let address = state.point.address;
                let mut followers = self.step(terms, state)?;
                terms.complete(|| format!("{address:#x}"))?;
                if let [Next::At(next)] = &followers[..]
                    && !self.flow(next.point.function)?.nodes[&next.point.address].begins
                    && let Some(Next::At(next)) = followers.pop()
                {
                    state = next;
                    continue;
                }
                for next in followers {
                    let next = match next {
                        Next::Return(mut next) => {
                            let flow = self.flow(next.point.function)?;
                            let at = &flow.nodes[&next.point.address].instruction;
                            let answer = self.here(terms, &mut next.point, at).answer()?;
                            pieces.push((next.guard, Step::Return(answer)));
                            continue;
                        }
                        Next::At(next) | Next::Behind(next) => next,
                    };
                    let next = match waiting.remove(&next.position) {
                        Some(other) => self.joined(terms, &next, &other),
                        None => next,
                    };
                    waiting.insert(next.position.clone(), next);
                }
                break;
            }
        }
        Ok(pieces)
    }

    fn place(&self, point: &Point) -> String {
        format!("{:#x}", point.address)
    }
}
