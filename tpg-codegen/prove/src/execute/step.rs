//! Meanings of instructions.

use super::memory::{moved, refuse};
use super::value::{Flags, Region, Value, restricted, word};
use super::{MachineState, Next, Object, Point};
use crate::elf::{Address, Part};
use crate::input::Missing;
use crate::term::{Bool, Operator, Terms, Width, Word};
use crate::thumb::{
    Binary, Condition, Instruction, Integer, LR, Offset, Operand, Operation, PC, Register, Shift, Unary,
};
use Operation::*;
use Operator::*;
use Value::*;

type Result<T> = std::result::Result<T, Missing>;
const W: Width = Width::W32;

impl Object {
    /// Executes an instruction.
    pub(super) fn step(&mut self, terms: &mut Terms, mut state: MachineState) -> Result<Vec<Next>> {
        let flow = self.flow(state.point.function)?;
        let node = &flow.nodes[&state.point.address];
        let at = &node.instruction;
        let behind = at.address + at.size;
        let condition = match at.operation {
            BranchIf { register, zero, .. } => {
                let (value, none) = (self.word(terms, &state.point, at, register)?, terms.number(0));
                let same = terms.same(W, value, none);
                if zero { same } else { !same }
            }
            _ => state
                .point
                .flags
                .condition(terms, at.condition)
                .ok_or_else(|| refuse(at, format_args!("the flags do not say {:?}", at.condition)))?,
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
            self.execute(terms, &mut state, at)?;
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
        terms: &mut Terms,
        mut state: MachineState,
        at: &Instruction,
        callee: Option<Address>,
        followers: &mut Vec<Next>,
    ) -> Result<()> {
        match at.operation {
            Branch { target } | BranchIf { target, .. } => {
                self.moved(&mut state, target)?;
                followers.push(Next::At(state));
            }
            Call { .. } => {
                let callee = callee.ok_or_else(|| refuse(at, "a call of nothing"))?;
                let flow = self.flow(callee)?;
                let point = &mut state.point;
                if point.function == callee || point.callers.iter().any(|caller| caller.0 == callee) {
                    return Err(refuse(at, "recursion"));
                }
                point.callers.push((point.function, at.address));
                (point.function, point.address) = (callee, flow.entry);
                point.registers[usize::from(LR)] = Some(return_to(terms, point.callers.last().copied()));
                let node = &flow.nodes[&flow.entry];
                state.position.extend(node.loops.iter().flat_map(|&head| [head, 0]));
                state.position.push(node.order);
                followers.push(Next::At(state));
            }
            Exchange { register } => {
                let target = self.register(&state.point, at, register)?;
                followers.push(self.returned(terms, state, at, target)?);
            }
            Transfer { load, width, ref registers, place } => {
                if !matches!(place.offset, Offset::Register(..)) {
                    self.transfer(terms, &mut state, at, (load, width, registers, place))?;
                    let target = self.register(&state.point, at, PC)?;
                    state.point.registers[usize::from(PC)] = None;
                    followers.push(self.returned(terms, state, at, target)?);
                    return Ok(());
                }
                let (Pointer(Region::Section(section), offsets), None) =
                    self.addresses(terms, &state.point, at, place)?
                else {
                    return Err(refuse(at, "a jump by an unknown table"));
                };
                for number in terms.numbers(offsets).ok_or_else(|| refuse(at, "a jump by an unknown number"))? {
                    let entry = self.image.pointer(Address { section, offset: number as u32 });
                    let target = entry.map(|entry| self.image.absolute(entry) & !1);
                    self.jump(terms, &state, (offsets, number, target), followers)?;
                }
            }
            Table { index, bytes, .. } => {
                let index = self.word(terms, &state.point, at, index)?;
                let behind = at.address + at.size;
                for number in terms.numbers(index).ok_or_else(|| refuse(at, "a jump by an unknown number"))? {
                    let mut place = self.code(&state.point, behind);
                    place.offset = place.offset.wrapping_add(number as u32 * u32::from(bytes));
                    let distance = self.image.number(place, bytes);
                    let target = distance.map(|distance| behind.wrapping_add(2 * distance));
                    self.jump(terms, &state, (index, number, target), followers)?;
                }
            }
            _ => return Err(refuse(at, "no branch")),
        }
        Ok(())
    }

    /// Goes to an address if a word is a number.
    fn jump(
        &mut self,
        terms: &mut Terms,
        state: &MachineState,
        (word, number, target): (Word, u64, Option<u32>),
        followers: &mut Vec<Next>,
    ) -> Result<()> {
        let number = terms.number(number);
        let same = terms.same(W, word, number);
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
    fn returned(
        &mut self,
        terms: &mut Terms,
        mut state: MachineState,
        at: &Instruction,
        target: Value,
    ) -> Result<Next> {
        if target != return_to(terms, state.point.callers.last().copied()) {
            return Err(refuse(at, "returns to another address"));
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

    /// Executes an instruction that goes on with the next.
    fn execute(&mut self, terms: &mut Terms, state: &mut MachineState, at: &Instruction) -> Result<()> {
        let point = &mut state.point;
        let (to, value) = match at.operation {
            Nop | Operation::If => return Ok(()),
            Operation::Integer { name, flags, to, left, right } => {
                let value = self.integer(terms, point, at, (name, flags, left, right))?;
                match to {
                    Some(to) => (to, value),
                    None => return Ok(()),
                }
            }
            MultiplyAdd { to, factors, sum, subtract } => {
                let [a, b, sum] = [factors[0], factors[1], sum].map(|register| self.word(terms, point, at, register));
                let product = terms.apply(Multiply, W, a?, b?);
                let operator = if subtract { Subtract } else { Add };
                (to, Value::Word(terms.apply(operator, W, sum?, product)))
            }
            Extract { to, from, low, width, signed } => {
                let value = self.word(terms, point, at, from)?;
                let left = shifted(terms, value, Shift::Left, (32 - low - width).into());
                let shift = if signed { Shift::Arithmetic } else { Shift::Right };
                let mask = (1 << width) - 1;
                (
                    to,
                    Value::Word(match (low, signed) {
                        (0, false) => with(terms, And, value, mask),
                        _ => shifted(terms, left, shift, (32 - width).into()),
                    }),
                )
            }
            Insert { to, from, low, width } => {
                let mask = ((1u64 << width) - 1) << low;
                let old = self.word(terms, point, at, to)?;
                let kept = with(terms, And, old, !mask & 0xffff_ffff);
                let new = match from {
                    Some(from) => self.word(terms, point, at, from)?,
                    None => terms.number(0),
                };
                let new = shifted(terms, new, Shift::Left, (low).into());
                let new = with(terms, And, new, mask);
                (to, Value::Word(terms.apply(Or, W, kept, new)))
            }
            LeadingZeros { to, from } => {
                let value = self.word(terms, point, at, from)?;
                // The smallest number of bits in which the value fits.
                let mut zeros = terms.number(0);
                for bits in (0..32).rev() {
                    let (limit, count) = (terms.number(1 << bits), terms.number(32 - bits));
                    let fits = terms.below(false, W, value, limit);
                    zeros = terms.choose_word(fits, count, zeros);
                }
                (to, Value::Word(zeros))
            }
            Top { to, number } => match (self.inserted(point, at, Part::High), self.register(point, at, to)?) {
                (Some(address), Half(half)) if address == half => (to, section(terms, address)),
                (None, _) => {
                    let low = self.word(terms, point, at, to)?;
                    let low = with(terms, And, low, 0xffff);
                    (to, Value::Word(with(terms, Or, low, u64::from(number) << 16)))
                }
                _ => return Err(refuse(at, "half of another address")),
            },
            Operation::Address { to, address } => (to, section(terms, self.code(point, address))),
            Transfer { load, width, ref registers, place } => {
                return self.transfer(terms, state, at, (load, width, registers, place));
            }
            Move { to, from } => (to, self.register(point, at, from)?),
            Operation::Constant { to, bits } => (to, Value::Word(terms.number((bits).into()))),
            Operation::Binary { name, to, left, right } => {
                let [a, b] = [left, right].map(|register| self.float(terms, point, at, register));
                let (a, b) = (a?, b?);
                let value = match name {
                    Binary::Add => terms.add(a, b),
                    Binary::Sub => terms.subtract(a, b),
                    Binary::Div => terms.divide(a, b),
                    _ => {
                        let product = terms.multiply(a, b);
                        let negative = terms.negate(product);
                        match name {
                            Binary::Mul => product,
                            Binary::NegMul => negative,
                            _ => {
                                let sum = self.float(terms, point, at, to)?;
                                let negated = terms.negate(sum);
                                match name {
                                    Binary::MulAdd => terms.add(sum, product),
                                    Binary::MulSub => terms.add(sum, negative),
                                    Binary::NegMulAdd => terms.add(negated, negative),
                                    _ => terms.add(negated, product),
                                }
                            }
                        }
                    }
                };
                (to, Float(value))
            }
            Operation::Unary { name, to, from } => (
                to,
                match name {
                    Unary::Neg | Unary::Abs | Unary::ToInteger { signed: true } => {
                        let float = self.float(terms, point, at, from)?;
                        match name {
                            Unary::Neg => Float(terms.negate(float)),
                            Unary::Abs => Float(terms.magnitude(float)),
                            _ => Value::Word(terms.truncated(float)),
                        }
                    }
                    Unary::FromInteger { signed } => {
                        let word = self.word(terms, point, at, from)?;
                        Float(terms.of_integer(signed, word))
                    }
                    _ => return Err(refuse(at, "terms have no such operation")),
                },
            ),
            Compare { left, right } => {
                let a = self.float(terms, point, at, left)?;
                let b = match right {
                    Some(right) => self.float(terms, point, at, right)?,
                    None => terms.constant(0.0),
                };
                point.float_flags = Flags::Floats(a, b);
                return Ok(());
            }
            ReadFlags => {
                point.flags = point.float_flags.clone();
                return Ok(());
            }
            _ => return Err(refuse(at, "a branch")),
        };
        if matches!(value, Half(_)) && to >= PC || to == PC {
            return Err(refuse(at, "a computed jump"));
        }
        point.registers[usize::from(to)] = Some(value);
        Ok(())
    }

    /// Computes with integers, and sets the flags.
    fn integer(
        &self,
        terms: &mut Terms,
        point: &mut Point,
        at: &Instruction,
        (name, flags, left, right): (Integer, bool, Register, Operand),
    ) -> Result<Value> {
        if let (Integer::Mov, Operand::Number(_)) = (name, right)
            && let Some(relocation) = self.image.relocation(self.code(point, at.address))
        {
            return match (relocation.part, &relocation.target) {
                (Part::Low, Ok(address)) if !flags => Ok(Half(*address)),
                _ => Err(refuse(at, "a constant that the linker changes")),
            };
        }
        let b = match right {
            Operand::Number(number) => Value::Word(terms.number(number.into())),
            Operand::Register(register, _, 0) => self.register(point, at, register)?,
            Operand::Register(register, shift, amount) => {
                let value = self.word(terms, point, at, register)?;
                Value::Word(shifted(terms, value, shift, amount.into()))
            }
        };
        if name == Integer::Mov && !flags {
            return Ok(b);
        }
        let number = |terms: &mut Terms, value| word(terms, value).ok_or_else(|| refuse(at, "computes with no number"));
        let copies = matches!(name, Integer::Mov | Integer::Mvn);
        let a = if copies { Value::Word(terms.number(0)) } else { self.register(point, at, left)? };
        if let (Integer::Sub, Pointer(first, a), Pointer(second, b)) = (name, a, b)
            && first == second
        {
            let distance = terms.apply(Subtract, W, a, b);
            if flags {
                point.flags = Flags::Result(distance);
            }
            return Ok(Value::Word(distance));
        }
        // Addresses are moved, and nothing else is done with them; their bits set no flags.
        if let Integer::Add | Integer::Sub = name
            && (matches!(a, Pointer(..)) || matches!(b, Pointer(..)))
        {
            let (address, distance) = if matches!(a, Pointer(..)) { (a, b) } else { (b, a) };
            let distance = number(terms, distance)?;
            let distance = match name {
                Integer::Add => distance,
                _ if address == a => negated(terms, distance),
                _ => return Err(refuse(at, "subtracts an address")),
            };
            if flags {
                point.flags = Flags::Unknown;
            }
            return moved(terms, address, distance).ok_or_else(|| refuse(at, "not an address"));
        }
        let (a, b) = (number(terms, a)?, number(terms, b)?);
        let ones = terms.number(0xffff_ffff);
        let operators = [
            (Integer::Add, Add),
            (Integer::Sub, Subtract),
            (Integer::And, And),
            (Integer::Orr, Or),
            (Integer::Eor, Xor),
            (Integer::Mul, Multiply),
        ];
        let value = match name {
            Integer::Mov => b,
            Integer::Mvn => terms.apply(Xor, W, b, ones),
            Integer::Rsb => terms.apply(Subtract, W, b, a),
            Integer::Bic | Integer::Orn => {
                let inverted = terms.apply(Xor, W, b, ones);
                let operator = if name == Integer::Bic { And } else { Or };
                terms.apply(operator, W, a, inverted)
            }
            Integer::Adc | Integer::Sbc => {
                let carry = point.flags.condition(terms, Condition::Cs);
                let carry = carry.ok_or_else(|| refuse(at, "the carry is not known"))?;
                let carry = terms.word_of(carry);
                let b = if name == Integer::Adc { b } else { terms.apply(Xor, W, b, ones) };
                let sum = terms.apply(Add, W, a, b);
                terms.apply(Add, W, sum, carry)
            }
            Integer::Shift(shift) => {
                // By the lowest byte; only constants.
                let amount = terms.number_of(b).ok_or_else(|| refuse(at, "shifts by an unknown number"))?;
                shifted(terms, a, shift, amount & 255)
            }
            _ => {
                let operator = operators.iter().find(|known| known.0 == name).map(|known| known.1);
                terms.apply(operator.ok_or_else(|| refuse(at, "not understood"))?, W, a, b)
            }
        };
        if flags {
            let opposite = terms.number_of(b).filter(|&b| b != 0 && b != 0x8000_0000);
            point.flags = match (name, opposite) {
                (Integer::Sub, _) => Flags::Difference(a, b),
                (Integer::Rsb, _) => Flags::Difference(b, a),
                // The flags of a sum with such a constant are those of the difference from its opposite.
                (Integer::Add, Some(b)) => Flags::Difference(a, terms.number(b.wrapping_neg() & 0xffff_ffff)),
                (Integer::Add, None) => Flags::Sum(a, b),
                _ => Flags::Result(value),
            };
        }
        Ok(Value::Word(value))
    }
}

/// Returns the address behind a call; that of no call is what the function began with.
fn return_to(terms: &mut Terms, call: Option<(Address, u32)>) -> Value {
    let Some((function, address)) = call else { return Initial(LR) };
    Pointer(Region::Return, terms.number((function.section as u64) << 32 | u64::from(address)))
}

fn section(terms: &mut Terms, address: Address) -> Value {
    Pointer(Region::Section(address.section), terms.number(address.offset.into()))
}

/// Applies an operator to a word and a constant.
fn with(terms: &mut Terms, operator: Operator, word: Word, number: u64) -> Word {
    let number = terms.number(number);
    terms.apply(operator, W, word, number)
}

fn negated(terms: &mut Terms, word: Word) -> Word {
    let zero = terms.number(0);
    terms.apply(Subtract, W, zero, word)
}

/// Shifts a word by a constant.
fn shifted(terms: &mut Terms, word: Word, shift: Shift, amount: u64) -> Word {
    match shift {
        Shift::Left => with(terms, ShiftLeft, word, amount),
        Shift::Right => with(terms, ShiftRight, word, amount),
        Shift::Arithmetic => with(terms, ShiftArithmetic, word, amount),
        Shift::Rotate if amount.is_multiple_of(32) => word,
        Shift::Rotate => {
            let low = with(terms, ShiftRight, word, amount % 32);
            let high = with(terms, ShiftLeft, word, 32 - amount % 32);
            terms.apply(Or, W, low, high)
        }
    }
}

/// Returns a state where a condition holds, too; none if it cannot.
fn under(terms: &mut Terms, state: &MachineState, condition: Bool) -> Option<MachineState> {
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
