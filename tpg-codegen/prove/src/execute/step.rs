//! Meanings of instructions.

use super::memory::moved;
use super::value::{Flags, Region, Value, restricted, word};
use super::{Here, MachineState, Next, Object, Point};
use crate::elf::{Address, Part};
use crate::input::{Missing, Result};
use crate::term::{Bool, Operator, Terms, Width, Word};
use crate::thumb::{
    Binary, Condition, Instruction, Integer, LR, Offset, Operand, Operation, PC, Register, Shift, Unary,
};
use Operation::*;
use Operator::*;
use Value::*;

const W: Width = Width::W32;

impl Object {
    /// Executes an instruction.
    pub(super) fn step(&mut self, terms: &Terms, mut state: MachineState) -> Result<Vec<Next>> {
        let flow = self.flow(state.point.function)?;
        let node = &flow.nodes[&state.point.address];
        let at = &node.instruction;
        let behind = at.address + at.size;
        let here = self.here(terms, &mut state.point, at);
        let condition = match at.operation {
            BranchIf { register, zero, .. } => {
                let (value, none) = (here.word(register)?, here.terms.number(0));
                let same = here.terms.same(W, value, none);
                if zero { same } else { !same }
            }
            _ => {
                let condition = here.point.flags.condition(here.terms, at.condition);
                condition.ok_or_else(|| here.refusal(format_args!("the flags do not say {:?}", at.condition)))?
            }
        };
        let mut followers = Vec::new();
        let leaves =
            matches!(at.operation, Branch { .. } | BranchIf { .. } | Table { .. } | Exchange { .. } | Call { .. })
                || matches!(&at.operation, Transfer { load: true, registers, .. } if registers.contains(&PC));
        if leaves {
            if let Some(mut other) = under(terms, &state, !condition) {
                self.moved(&mut other, behind)?;
                followers.push(Next::At(other));
            }
            if let Some(state) = under(terms, &state, condition) {
                self.leave(terms, state, at, node.callee, &mut followers)?;
            }
            return Ok(followers);
        }
        if condition != Terms::FALSE {
            let before = (condition != Terms::TRUE).then(|| state.point.clone());
            if before.is_some() {
                restrict(terms, &mut state.point, condition);
            }
            self.here(terms, &mut state.point, at).execute()?;
            if let Some(before) = before {
                state.point = self.merged(terms, condition, &state.point, &before);
            }
        }
        self.moved(&mut state, behind)?;
        Ok(vec![Next::At(state)])
    }

    /// Executes a branch, call or return that is taken.
    fn leave(
        &mut self,
        terms: &Terms,
        mut state: MachineState,
        at: &Instruction,
        callee: Option<Address>,
        followers: &mut Vec<Next>,
    ) -> Result<()> {
        let mut here = self.here(terms, &mut state.point, at);
        match at.operation {
            Branch { target } | BranchIf { target, .. } => {
                self.moved(&mut state, target)?;
                followers.push(Next::At(state));
            }
            Call { .. } => {
                let Some(callee) = callee else { return here.refuse("a call of nothing") };
                let point = &mut *here.point;
                if point.function == callee || point.callers.iter().any(|caller| caller.0 == callee) {
                    return here.refuse("recursion");
                }
                point.callers.push((point.function, at.address));
                point.registers[usize::from(LR)] = Some(return_to(here.terms, point.callers.last().copied()));
                let flow = self.flow(callee)?;
                (state.point.function, state.point.address) = (callee, flow.entry);
                let node = &flow.nodes[&flow.entry];
                state.position.extend(node.loops.iter().flat_map(|&head| [head, 0]));
                state.position.push(node.order);
                followers.push(Next::At(state));
            }
            Exchange { register } => {
                let target = here.register(register)?;
                followers.push(self.returned(terms, state, at, target)?);
            }
            Transfer { place, .. } => {
                if !matches!(place.offset, Offset::Register(..)) {
                    here.execute()?;
                    let target = here.register(PC)?;
                    here.point.registers[usize::from(PC)] = None;
                    followers.push(self.returned(terms, state, at, target)?);
                    return Ok(());
                }
                let (Pointer(Region::Section(section), offsets), None) = here.addresses(place)? else {
                    return here.refuse("a jump by an unknown table");
                };
                for number in here.numbers(offsets)? {
                    let entry = self.image.pointer(Address { section, offset: number as u32 });
                    let target = entry.map(|entry| self.image.absolute(entry) & !1);
                    self.jump(terms, &state, (offsets, number, target), followers)?;
                }
            }
            Table { index, bytes, .. } => {
                let index = here.word(index)?;
                let behind = at.address + at.size;
                for number in here.numbers(index)? {
                    let mut place = self.code(&state.point, behind);
                    place.offset = place.offset.wrapping_add(number as u32 * u32::from(bytes));
                    let distance = self.image.number(place, bytes);
                    let target = distance.map(|distance| behind.wrapping_add(2 * distance));
                    self.jump(terms, &state, (index, number, target), followers)?;
                }
            }
            _ => return here.refuse("no branch"),
        }
        Ok(())
    }

    /// Goes to an address if a word is a number.
    fn jump(
        &mut self,
        terms: &Terms,
        state: &MachineState,
        (word, number, target): (Word, u64, Option<u32>),
        followers: &mut Vec<Next>,
    ) -> Result<()> {
        let same = terms.same(W, word, terms.number(number));
        if let Some(mut state) = under(terms, state, same) {
            let from = state.point.address;
            let flow = self.flow(state.point.function)?;
            let target = target.filter(|target| flow.nodes[&from].next.contains(target));
            let target = target.ok_or_else(|| Missing::new(format!("{from:#x}"), "a jump outside its table"))?;
            self.moved(&mut state, target)?;
            followers.push(Next::At(state));
        }
        Ok(())
    }

    /// Returns from a function.
    fn returned(&mut self, terms: &Terms, mut state: MachineState, at: &Instruction, target: Value) -> Result<Next> {
        if target != return_to(terms, state.point.callers.last().copied()) {
            return self.here(terms, &mut state.point, at).refuse("returns to another address");
        }
        let Some((caller, address)) = state.point.callers.pop() else { return Ok(Next::Return(state)) };
        let flow = self.flow(state.point.function)?;
        let own = 1 + 2 * flow.nodes[&at.address].loops.len();
        state.position.truncate(state.position.len() - own);
        (state.point.function, state.point.address) = (caller, address);
        let behind = address + 4;
        self.moved(&mut state, behind)?;
        Ok(Next::Behind(state))
    }
}

impl Here<'_> {
    /// Executes an instruction that goes on with the next.
    fn execute(&mut self) -> Result<()> {
        let at = self.at;
        let (to, value) = match at.operation {
            Nop | Operation::If => return Ok(()),
            Operation::Integer { name, flags, to, left, right } => {
                let value = self.integer(name, flags, left, right)?;
                match to {
                    Some(to) => (to, value),
                    None => return Ok(()),
                }
            }
            MultiplyAdd { to, factors: [a, b], sum, subtract } => {
                let (a, b, sum) = (self.word(a)?, self.word(b)?, self.word(sum)?);
                let product = self.terms.apply(Multiply, W, a, b);
                let operator = if subtract { Subtract } else { Add };
                (to, Word(self.terms.apply(operator, W, sum, product)))
            }
            Extract { to, from, low, width, signed } => {
                let value = self.word(from)?;
                if low == 0 && !signed {
                    (to, Word(self.with(And, value, (1 << width) - 1)))
                } else {
                    let left = self.with(ShiftLeft, value, (32 - low - width).into());
                    let shift = if signed { ShiftArithmetic } else { ShiftRight };
                    (to, Word(self.with(shift, left, (32 - width).into())))
                }
            }
            Insert { to, from, low, width } => {
                let mask = ((1u64 << width) - 1) << low;
                let kept = self.with(And, self.word(to)?, !mask & 0xffff_ffff);
                let new = from.map(|from| self.word(from)).transpose()?.unwrap_or_else(|| self.terms.number(0));
                (to, Word(self.terms.apply(Or, W, kept, self.with(And, self.with(ShiftLeft, new, low.into()), mask))))
            }
            LeadingZeros { to, from } => {
                let value = self.word(from)?;
                // The smallest number of bits in which the value fits.
                let mut zeros = self.terms.number(0);
                for bits in (0..32).rev() {
                    zeros = self.terms.choose_word(
                        self.terms.below(false, W, value, self.terms.number(1 << bits)),
                        self.terms.number(32 - bits),
                        zeros,
                    );
                }
                (to, Word(zeros))
            }
            Top { to, number } => match (self.inserted(Part::High), self.register(to)?) {
                (Some(address), Half(half)) if address == half => (to, self.section(address)),
                (None, _) => (to, Word(self.with(Or, self.with(And, self.word(to)?, 0xffff), u64::from(number) << 16))),
                _ => return self.refuse("half of another address"),
            },
            Operation::Address { to, address } => {
                let address = self.object.code(self.point, address);
                (to, self.section(address))
            }
            Transfer { load, width, ref registers, place } => return self.transfer(load, width, registers, place),
            Move { to, from } => (to, self.register(from)?),
            Operation::Constant { to, bits } => (to, Word(self.terms.number(bits.into()))),
            Operation::Binary { name, to, left, right } => {
                let (mut a, mut b) = (self.float(left)?, self.float(right)?);
                use Binary::*;
                if !matches!(name, Add | Sub | Div) {
                    b = self.terms.multiply(a, b);
                    a = if matches!(name, Mul | NegMul) { b } else { self.float(to)? };
                }
                if matches!(name, NegMul | MulSub | NegMulAdd) {
                    b = self.terms.negate(b);
                }
                if matches!(name, NegMulAdd | NegMulSub) {
                    a = self.terms.negate(a);
                }
                let value = match name {
                    Mul | NegMul => b,
                    Sub => self.terms.subtract(a, b),
                    Div => self.terms.divide(a, b),
                    _ => self.terms.add(a, b),
                };
                (to, Float(value))
            }
            Operation::Unary { name: Unary::FromInteger { signed }, to, from } => {
                (to, Float(self.terms.of_integer(signed, self.word(from)?)))
            }
            Operation::Unary { name, to, from } => {
                let float = self.float(from)?;
                let value = match name {
                    Unary::Neg => Float(self.terms.negate(float)),
                    Unary::Abs => Float(self.terms.magnitude(float)),
                    Unary::ToInteger { signed: true } => Word(self.terms.truncated(float)),
                    _ => return self.refuse("terms have no such operation"),
                };
                (to, value)
            }
            Compare { left, right } => {
                let a = self.float(left)?;
                let zero = self.terms.constant(0.0);
                let b = right.map_or(Ok(zero), |right| self.float(right))?;
                self.point.float_flags = Flags::Floats(a, b);
                return Ok(());
            }
            ReadFlags => {
                self.point.flags = self.point.float_flags.clone();
                return Ok(());
            }
            _ => return self.refuse("a branch"),
        };
        if matches!(value, Half(_)) && to >= PC || to == PC {
            return self.refuse("a computed jump");
        }
        self.point.registers[usize::from(to)] = Some(value);
        Ok(())
    }

    /// Computes with integers, and sets the flags.
    fn integer(&mut self, name: Integer, flags: bool, left: Register, right: Operand) -> Result<Value> {
        if let (Integer::Mov, Operand::Number(_)) = (name, right)
            && let Some(relocation) = self.object.image.relocation(self.object.code(self.point, self.at.address))
        {
            return match (relocation.part, &relocation.target) {
                (Part::Low, Ok(address)) if !flags => Ok(Half(*address)),
                _ => self.refuse("a constant that the linker changes"),
            };
        }
        let b = match right {
            Operand::Number(number) => Word(self.terms.number(number.into())),
            Operand::Register(register, _, 0) => self.register(register)?,
            Operand::Register(register, shift, amount) => {
                Word(self.shifted(self.word(register)?, shift, amount.into()))
            }
        };
        if name == Integer::Mov && !flags {
            return Ok(b);
        }
        let copies = matches!(name, Integer::Mov | Integer::Mvn);
        let a = if copies { Word(self.terms.number(0)) } else { self.register(left)? };
        if let (Integer::Sub, Pointer(first, a), Pointer(second, b)) = (name, a, b)
            && first == second
        {
            let distance = self.terms.apply(Subtract, W, a, b);
            if flags {
                self.point.flags = Flags::Result(distance);
            }
            return Ok(Word(distance));
        }
        // Addresses are moved, and nothing else is done with them; their bits set no flags.
        if let Integer::Add | Integer::Sub = name
            && (matches!(a, Pointer(..)) || matches!(b, Pointer(..)))
        {
            let (address, distance) = if matches!(a, Pointer(..)) { (a, b) } else { (b, a) };
            let mut distance = self.number(distance)?;
            if name == Integer::Sub {
                if address != a {
                    return self.refuse("subtracts an address");
                }
                distance = self.terms.apply(Subtract, W, self.terms.number(0), distance);
            }
            if flags {
                self.point.flags = Flags::Unknown;
            }
            return moved(self.terms, address, distance).map_or_else(|| self.refuse("not an address"), Ok);
        }
        let (a, b) = (self.number(a)?, self.number(b)?);
        // The right operand as it is computed with.
        let right = match name {
            Integer::Mvn | Integer::Bic | Integer::Orn | Integer::Sbc => self.with(Xor, b, 0xffff_ffff),
            _ => b,
        };
        let operator = match name {
            Integer::Mov | Integer::Mvn | Integer::Orr | Integer::Orn => Or,
            Integer::Add | Integer::Adc | Integer::Sbc => Add,
            Integer::Sub | Integer::Rsb => Subtract,
            Integer::And | Integer::Bic => And,
            Integer::Eor => Xor,
            Integer::Mul | Integer::Shift(_) => Multiply,
        };
        let value = match name {
            Integer::Mov | Integer::Mvn => right,
            Integer::Rsb => self.terms.apply(operator, W, b, a),
            Integer::Adc | Integer::Sbc => {
                let carry = self.point.flags.condition(self.terms, Condition::Cs);
                let Some(carry) = carry else { return self.refuse("the carry is not known") };
                self.terms.apply(operator, W, self.terms.apply(operator, W, a, right), self.terms.word_of(carry))
            }
            Integer::Shift(shift) => {
                // By the lowest byte; only constants.
                let Some(amount) = self.terms.number_of(b) else { return self.refuse("shifts by an unknown number") };
                self.shifted(a, shift, amount & 255)
            }
            _ => self.terms.apply(operator, W, a, right),
        };
        if flags {
            let opposite = self.terms.number_of(b).filter(|&b| b != 0 && b != 0x8000_0000);
            self.point.flags = match (name, opposite) {
                (Integer::Sub, _) => Flags::Difference(a, b),
                (Integer::Rsb, _) => Flags::Difference(b, a),
                // The flags of a sum with such a constant are those of the difference from its opposite.
                (Integer::Add, Some(b)) => Flags::Difference(a, self.terms.number(b.wrapping_neg() & 0xffff_ffff)),
                (Integer::Add, None) => Flags::Sum(a, b),
                _ => Flags::Result(value),
            };
        }
        Ok(Word(value))
    }

    /// Returns the bits of a value that is no address.
    fn number(&self, value: Value) -> Result<Word> {
        word(self.terms, value).map_or_else(|| self.refuse("computes with no number"), Ok)
    }

    /// Returns the numbers that a word can be.
    fn numbers(&self, word: Word) -> Result<Vec<u64>> {
        let numbers = self.terms.numbers(word).map(|numbers| numbers.into_iter().collect());
        numbers.map_or_else(|| self.refuse("a jump by an unknown number"), Ok)
    }

    fn section(&self, address: Address) -> Value {
        Pointer(Region::Section(address.section), self.terms.number(address.offset.into()))
    }

    /// Applies an operator to a word and a constant.
    pub(super) fn with(&self, operator: Operator, word: Word, number: u64) -> Word {
        self.terms.apply(operator, W, word, self.terms.number(number))
    }

    /// Shifts a word by a constant.
    fn shifted(&self, word: Word, shift: Shift, amount: u64) -> Word {
        match shift {
            Shift::Left => self.with(ShiftLeft, word, amount),
            Shift::Right => self.with(ShiftRight, word, amount),
            Shift::Arithmetic => self.with(ShiftArithmetic, word, amount),
            Shift::Rotate if amount.is_multiple_of(32) => word,
            Shift::Rotate => self.terms.apply(
                Or,
                W,
                self.with(ShiftRight, word, amount % 32),
                self.with(ShiftLeft, word, 32 - amount % 32),
            ),
        }
    }
}

/// Returns the address behind a call; that of no call is what the function began with.
fn return_to(terms: &Terms, call: Option<(Address, u32)>) -> Value {
    let Some((function, address)) = call else { return Initial(LR) };
    Pointer(Region::Return, terms.number((function.section as u64) << 32 | u64::from(address)))
}

/// Returns a state where a condition holds, too; none if it cannot.
fn under(terms: &Terms, state: &MachineState, condition: Bool) -> Option<MachineState> {
    let guard = terms.and(state.guard, condition);
    if guard == Terms::FALSE {
        return None;
    }
    let mut state = state.clone();
    if guard != state.guard {
        state.guard = guard;
        restrict(terms, &mut state.point, condition);
    }
    Some(state)
}

/// Resolves the choices that a condition decides.
fn restrict(terms: &Terms, point: &mut Point, condition: Bool) {
    let facts = terms.parts(condition);
    for value in point.registers.iter_mut().flatten().chain(point.memory.values_mut()) {
        *value = restricted(terms, *value, &facts);
    }
    point.flags = point.flags.restricted(&facts).clone();
    point.float_flags = point.float_flags.restricted(&facts).clone();
}
