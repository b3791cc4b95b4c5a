//! Control flow of a function with all that it calls: instructions in an order that follows it, and what is alive where.

use crate::elf::{Address, Function, Image, Part};
use crate::input::{Missing, Result};
use crate::thumb::decode::decode;
use crate::thumb::{ALWAYS, Block, Computed, Instruction, LR, Offset, Operand, Operation, PC, Register, S0, SP};
use Operation::*;
use std::collections::{HashMap, HashSet};

/// A set of registers and of the two sets of flags.
type Live = u64;
/// The flags of conditions.
pub(super) const FLAGS: Live = 1 << 48;
/// The flags of the floating-point unit.
pub(super) const FLOAT_FLAGS: Live = 1 << 49;
/// So many instructions are looked at.
const LONGEST: usize = 50_000;

/// What the calling convention preserves: r4 to r11, the stack pointer, and s16 to s31.
pub(super) fn preserved() -> impl Iterator<Item = Register> {
    (4..12).chain([SP]).chain(S0 + 16..S0 + 32)
}

/// A call: the function that is called from, and the place of the instruction.
type Caller = (Function, Address);

/// A place in code: the calls that lead there, and an address.
type Location = (Vec<Caller>, Address);

/// An instruction of a function that is called in one way.
#[derive(Debug)]
pub(super) struct Node {
    pub(super) instruction: Instruction,
    /// Its place
    pub(super) address: Address,
    /// The calls that led here
    pub(super) callers: Vec<Caller>,
    /// Places that may be next; none for the last return
    pub(super) next: Vec<usize>,
    /// Everything that may be read from here on, before it is written
    pub(super) live: Live,
    /// True where paths meet or part
    pub(super) begins: bool,
}

/// Instructions: each comes after all that lead to it, but for loops.
pub(super) type Flow = Vec<Node>;

/// The control flow from a function's first instruction along all branches.
pub(super) fn flow(image: &Image, function: &Function) -> Result<Flow> {
    let start: Location = (Vec::new(), function.start);
    let mut nodes: HashMap<Location, (Instruction, Block, Vec<Location>)> = HashMap::new();
    let mut work = vec![(start.clone(), *function, Block::default())];
    while let Some((location, function, block)) = work.pop() {
        let (callers, address) = &location;
        let missing = |what: &str| Missing::new(format!("{:#x}", address.offset), what);
        if let Some((_, known, _)) = nodes.get(&location) {
            if *known != block {
                return Err(missing("a branch into a conditional block"));
            }
            continue;
        }
        let end = function.start.offset.wrapping_add(function.size);
        if !(function.start.offset..end).contains(&address.offset) {
            return Err(missing("a path that leaves the function"));
        }
        if nodes.len() > LONGEST {
            return Err(missing("a shorter function"));
        }
        let rest = image.constant(*address, end - address.offset).unwrap_or_default();
        let Some((instruction, after)) = decode(rest, address.offset, block) else {
            let bytes: Vec<String> = rest.iter().take(4).map(|byte| format!("{byte:02x}")).collect();
            return Err(missing(&format!("the instruction with the bytes {} is not understood", bytes.join(" "))));
        };
        let behind = instruction.behind();
        let mut next = Vec::new();
        let mut go = |callers: &[Caller], function: Function, offset: Address, block: Block| {
            let location = (callers.to_vec(), offset);
            next.push(location.clone());
            work.push((location, function, block));
        };
        let conditional = instruction.condition != ALWAYS || matches!(instruction.operation, BranchIf { .. });
        if conditional || !instruction.operation.leaves() {
            go(callers, function, address.at(behind), after);
        }
        let relocation = image.relocation(*address);
        match &instruction.operation {
            Call { target } => {
                let callee = match relocation.map(|relocation| (relocation.part, &relocation.target)) {
                    Some((Part::Branch, Ok(callee))) => *callee,
                    Some((_, Err(name))) => return Err(missing(&format!("a call of {name}, which is elsewhere"))),
                    Some(_) => return Err(missing("a call that the linker changes")),
                    None => address.at(*target),
                };
                let callee = image.function_at(callee).ok_or_else(|| missing("a call to no function"))?;
                let callers = [&callers[..], &[(function, *address)]].concat();
                if callers.iter().any(|&(caller, _)| caller == callee) {
                    return Err(missing("recursion"));
                }
                go(&callers, callee, callee.start, Block::default());
            }
            operation if ends(operation) => {
                if let Some((&(caller, call), callers)) = callers.split_last() {
                    go(callers, caller, behind_call(call), Block::default());
                }
            }
            operation => {
                if relocation.is_some() && operation.leaves() {
                    return Err(missing("a branch to another function"));
                }

                let inside = |target: u32| (function.start.offset..end).contains(&target);
                let targets = match *operation {
                    Branch { target } | BranchIf { target, .. } => vec![target],
                    Table { base: PC, bytes, .. } => table(image, *address, behind, Some(bytes), inside),
                    Transfer { load: true, ref registers, .. } if registers.contains(&PC) => {
                        table(image, *address, behind, None, inside)
                    }
                    Table { .. } | Exchange { .. } => return Err(missing("a jump to a computed address")),
                    _ => Vec::new(),
                };
                for offset in targets {
                    go(callers, function, address.at(offset), Block::default());
                }
            }
        }
        nodes.insert(location, (instruction, block, next));
    }
    Ok(arranged(nodes, start))
}

/// Returns the address behind a call.
pub(super) fn behind_call(call: Address) -> Address {
    call.at(call.offset.wrapping_add(4))
}

/// Puts instructions in order, and finds where paths meet and what is alive.
fn arranged(nodes: HashMap<Location, (Instruction, Block, Vec<Location>)>, start: Location) -> Flow {
    let mut finished = Vec::new();
    let mut entered = HashSet::from([&start]);
    let mut path = vec![(&start, 0)];
    while let Some((location, next)) = path.last_mut() {
        let (location, taken) = (*location, *next);
        *next += 1;
        match nodes[location].2.get(taken) {
            Some(to) if entered.insert(to) => path.push((to, 0)),
            Some(_) => {}
            None => finished.extend(path.pop().map(|(location, _)| location)),
        }
    }
    finished.reverse();
    let places: HashMap<&Location, usize> = finished.iter().enumerate().map(|(at, &location)| (location, at)).collect();
    let mut flow: Flow = (finished.iter())
        .map(|&location| {
            let (instruction, _, next) = &nodes[location];
            let next = next.iter().map(|to| places[to]).collect();
            let (callers, address) = location.clone();
            Node { instruction: instruction.clone(), address, callers, next, live: 0, begins: false }
        })
        .collect();
    let mut before = vec![0; flow.len()];
    for at in 0..flow.len() {
        let next = flow[at].next.clone();
        for &to in &next {
            before[to] += 1;
            flow[to].begins |= next.len() > 1 || before[to] > 1;
        }
    }
    find_live(&mut flow);
    flow
}

fn find_live(flow: &mut Flow) {
    let at_end = preserved().fold(1 | 1 << LR, |set, register| set | 1 << register);
    let mut changed = true;
    while std::mem::take(&mut changed) {
        for at in (0..flow.len()).rev() {
            let node = &flow[at];
            let (reads, writes) = effects(&node.instruction.operation);
            let after = node.next.iter().fold(0, |set, &next| set | flow[next].live);
            let after = if ends(&node.instruction.operation) { after | at_end } else { after };
            let kept = if node.instruction.condition == ALWAYS { after & !writes } else { after | FLAGS };
            changed |= reads | kept != node.live;
            flow[at].live = reads | kept;
        }
    }
}

/// True for instructions that may return to the caller.
pub(super) fn ends(operation: &Operation) -> bool {
    match operation {
        Exchange { register } => *register == LR,
        Transfer { load: true, registers, place, .. } => {
            registers.contains(&PC) && !matches!(place.offset, Offset::Register(..))
        }
        _ => false,
    }
}

/// Reads the targets of a table that follows its branch: of offsets, or of addresses. It ends where its first target is. What is
/// jumped to in an execution is compared with these.
fn table(image: &Image, branch: Address, behind: u32, bytes: Option<u8>, inside: impl Fn(u32) -> bool) -> Vec<u32> {
    let mut targets: Vec<u32> = Vec::new();
    let mut entry = branch.at(if bytes.is_some() { behind } else { behind.wrapping_add(3) & !3 });
    while !targets.iter().any(|&target| target > behind && target <= entry.offset) {
        let target = match bytes {
            // what leads nowhere fills the table up
            Some(bytes) => {
                image.number(entry, bytes).filter(|&ahead| ahead > 0).map(|ahead| behind.wrapping_add(2 * ahead))
            }
            None => image.pointer(entry).filter(|to| to.section == branch.section).map(|to| to.offset & !1),
        };
        let Some(target) = target.filter(|&target| inside(target)) else { break };
        targets.push(target);
        entry.offset = entry.offset.wrapping_add(bytes.unwrap_or(4).into());
    }
    targets
}

/// What an instruction reads and what it always writes, if it is executed.
fn effects(operation: &Operation) -> (Live, Live) {
    let set = |registers: &[Register]| registers.iter().fold(0, |set: Live, register| set | 1 << register);
    let one = |register: Register| -> Live { 1 << register };
    match *operation {
        Nop | If | Branch { .. } => (0, 0),
        Call { .. } => (0, one(LR)),
        Compute { name, flags, to, ref from, .. } => {
            let carry = if name == Computed::WithCarry { FLAGS } else { 0 };
            let reads = from.iter().fold(carry, |set, operand| match *operand {
                Operand::Number(_) => set,
                Operand::Register(register, ..) => set | one(register),
            });
            (reads, to.map_or(0, one) | if flags { FLAGS } else { 0 })
        }
        Transfer { load, ref registers, place, .. } => {
            let offset = if let Offset::Register(register, _) = place.offset { one(register) } else { 0 };
            let reads = offset | one(place.base) | if load { 0 } else { set(registers) };
            (reads, if load { set(registers) } else { 0 })
        }
        Compare { left, right } => (one(left) | right.map_or(0, one), FLOAT_FLAGS),
        ReadFlags => (FLOAT_FLAGS, FLAGS),
        BranchIf { register, .. } | Exchange { register } => (one(register), 0),
        Table { base, index, .. } => (set(&[base, index]), 0),
    }
}
