//! Control flow of a function with all that it calls: instructions in an order that follows it, and what is alive where.

use crate::code::{Computed, Expression};
use crate::elf::{Address, Function, Image, Part};
use crate::input::{Missing, Result};
use crate::thumb::decode::decode;
use crate::thumb::{Block, Exit, Instruction, LR, Place, Register, S0, SP};
use std::collections::{HashMap, HashSet};

/// A set of registers.
type Live = u64;
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
    /// Places that may be next: that behind, if it may be, then those that it jumps to
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
        let Some((instruction, after)) = decode(rest, image, *address, block) else {
            let bytes: Vec<String> = rest.iter().take(4).map(|byte| format!("{byte:02x}")).collect();
            return Err(missing(&format!("the instruction with the bytes {} is not understood", bytes.join(" "))));
        };
        let behind = address.offset.wrapping_add(instruction.size);
        let mut next = Vec::new();
        let mut go = |callers: &[Caller], function: Function, offset: Address, block: Block| {
            let location = (callers.to_vec(), offset);
            next.push(location.clone());
            work.push((location, function, block));
        };
        if instruction.condition.is_some() || instruction.jump.is_none() {
            go(callers, function, address.at(behind), after);
        }
        let relocation = image.relocation(*address);
        match &instruction.jump {
            None => {}
            Some(Exit::Call(target)) => {
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
            Some(Exit::Computed(_, None)) => {
                if let Some((&(caller, call), callers)) = callers.split_last() {
                    go(callers, caller, call.at(call.offset.wrapping_add(4)), Block::default());
                }
            }
            Some(_) if relocation.is_some() => return Err(missing("a branch to another function")),
            Some(Exit::To(target)) => go(callers, function, address.at(*target), Block::default()),
            Some(Exit::Computed(_, Some(bytes))) => {
                let inside = |target: u32| (function.start.offset..end).contains(&target);
                for offset in table(image, *address, behind, *bytes, inside) {
                    go(callers, function, address.at(offset), Block::default());
                }
            }
        }
        nodes.insert(location, (instruction, block, next));
    }
    Ok(arranged(nodes, start))
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
            let Instruction { condition, sets, jump, .. } = &node.instruction;
            let returns = matches!(jump, Some(Exit::Computed(_, None)));
            let mut live = node.next.iter().fold(if returns { at_end } else { 0 }, |set, &next| set | flow[next].live);
            let target = if let Some(Exit::Computed(target, _)) = jump { reads(target) } else { 0 };
            let mut read = target | condition.as_ref().map_or(0, reads);
            for (place, value) in sets {
                read |= reads(value);
                match place {
                    Place::Register(register) if condition.is_none() => live &= !(1 << register),
                    Place::Register(_) => {}
                    Place::Memory(address, _) => read |= reads(address),
                }
            }
            changed |= live | read != node.live;
            flow[at].live = live | read;
        }
    }
}

/// Reads the targets of a table that follows its branch: of offsets, or of addresses. It ends where its first target is. What is
/// jumped to in an execution is compared with these.
fn table(image: &Image, branch: Address, behind: u32, bytes: u8, inside: impl Fn(u32) -> bool) -> Vec<u32> {
    let mut targets: Vec<u32> = Vec::new();
    let mut entry = branch.at(if bytes < 4 { behind } else { behind.wrapping_add(3) & !3 });
    while !targets.iter().any(|&target| target > behind && target <= entry.offset) {
        let target = if bytes < 4 {
            // what leads nowhere fills the table up
            let ahead = image.number(entry, bytes).filter(|&ahead| ahead > 0);
            ahead.map(|ahead| behind.wrapping_add(2 * ahead))
        } else {
            image.pointer(entry).filter(|to| to.section == branch.section).map(|to| to.offset & !1)
        };
        let Some(target) = target.filter(|&target| inside(target)) else { break };
        targets.push(target);
        entry.offset = entry.offset.wrapping_add(bytes.into());
    }
    targets
}

/// The registers that an expression reads.
fn reads(expression: &Expression) -> Live {
    match expression {
        Expression::Of(Computed::Register(register), _) => 1 << register,
        Expression::Of(_, parts) => parts.iter().fold(0, |set, part| set | reads(part)),
        _ => 0,
    }
}
