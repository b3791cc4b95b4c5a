//! Control flow of one function: instructions, an order that follows it, loops, and what is alive where.

use crate::elf::{Address, Function, Image, Part};
use crate::input::{Missing, Result};
use crate::thumb::decode::decode;
use crate::thumb::{
    Binary, Block, Condition, Instruction, Integer, LR, Offset, Operand, Operation, PC, Place, Register, S0, SP,
};
use Operation::*;
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

/// A set of registers and of the two sets of flags.
pub(super) type Live = u64;
/// The flags of conditions.
pub(super) const FLAGS: Live = 1 << 48;
/// The flags of the floating-point unit.
pub(super) const FLOAT_FLAGS: Live = 1 << 49;

/// What the calling convention preserves: r4 to r11, the stack pointer, and s16 to s31.
pub(super) fn preserved() -> impl Iterator<Item = Register> {
    (4..12).chain([SP]).chain(S0 + 16..S0 + 32)
}

/// An instruction in its function.
#[derive(Debug)]
pub(super) struct Node {
    pub(super) instruction: Instruction,
    /// Addresses that may be next; none for a return.
    pub(super) next: Vec<u32>,
    /// The function that a call enters.
    pub(super) callee: Option<Address>,
    /// Place in an order in which everything comes after what leads to it, but for loops.
    pub(super) order: u32,
    /// The first instructions of the loops around it, the outermost first, by their order.
    pub(super) loops: Vec<u32>,
    /// Everything that may be read from here on, before it is written.
    pub(super) live: Live,
    /// True where several paths meet.
    pub(super) joins: bool,
    /// True where paths meet or part.
    pub(super) begins: bool,
}

/// The control flow of a function.
#[derive(Debug)]
pub(super) struct Flow {
    pub(super) nodes: BTreeMap<u32, Node>,
    pub(super) entry: u32,
    pub(super) section: usize,
}

impl Flow {
    /// Decodes a function, from its first instruction along all branches.
    pub(super) fn new(image: &Image, function: &Function) -> Result<Self> {
        let (section, entry) = (function.start.section, image.absolute(function.start));
        let mut flow = Self { nodes: BTreeMap::new(), entry, section };
        let mut blocks: HashMap<u32, Block> = HashMap::new();
        let mut work = vec![(entry, Block::default())];
        while let Some((address, block)) = work.pop() {
            if flow.nodes.contains_key(&address) {
                if blocks[&address] != block {
                    return Err(Missing::new(format!("{address:#x}"), "a branch into a conditional block"));
                }
                continue;
            }
            let inside = address.wrapping_sub(entry);
            if inside >= function.size {
                return Err(Missing::new(format!("{address:#x}"), "a path that leaves the function"));
            }
            let place = Address { section, offset: function.start.offset + inside };
            let rest = image.constant(place, function.size - inside).unwrap_or_default();
            let Some((instruction, after)) = decode(rest, address, block) else {
                let bytes: Vec<String> = rest.iter().take(4).map(|byte| format!("{byte:02x}")).collect();
                let what = format!("the instruction with the bytes {} is not understood", bytes.join(" "));
                return Err(Missing::new(format!("{address:#x}"), what));
            };
            let (next, callee) = flow.successors(image, function, &instruction)?;
            blocks.insert(address, block);
            for &target in &next {
                let falls = target == address + instruction.size;
                work.push((target, if falls { after } else { Block::default() }));
            }
            let node =
                Node { instruction, next, callee, order: 0, loops: Vec::new(), live: 0, joins: false, begins: false };
            flow.nodes.insert(address, node);
        }
        flow.arrange();
        flow.find_live();
        Ok(flow)
    }

    fn successors(
        &self,
        image: &Image,
        function: &Function,
        instruction: &Instruction,
    ) -> Result<(Vec<u32>, Option<Address>)> {
        let refuse = |what: &str| Missing::new(format!("{:#x}", instruction.address), what);
        let behind = instruction.address + instruction.size;
        let place = Address {
            section: self.section,
            offset: instruction.address.wrapping_sub(self.entry).wrapping_add(function.start.offset),
        };
        let relocation = image.relocation(place);
        let conditional = instruction.condition != Condition::Always;
        let or_behind = |mut targets: Vec<u32>| {
            if conditional && !targets.contains(&behind) {
                targets.push(behind);
            }
            targets
        };
        let listed = |bytes| {
            let inside = |target: u32| target.wrapping_sub(self.entry) < function.size;
            table(image, place, (behind, bytes), self.entries(instruction), inside)
        };
        Ok(match instruction.operation {
            Branch { .. } if relocation.is_some() => return Err(refuse("a branch to another function")),
            Branch { target } => (or_behind(vec![target]), None),
            BranchIf { target, .. } => (vec![target, behind], None),
            Table { base: PC, bytes, .. } => (or_behind(listed(Some(bytes))), None),
            Exchange { register: LR } => (or_behind(Vec::new()), None),
            Transfer { ref registers, load: true, place: to, .. } if registers.contains(&PC) => {
                let by_table = matches!(to.offset, Offset::Register(..));
                let targets = if by_table { listed(None) } else { Vec::new() };
                (or_behind(targets), None)
            }
            Call { target } => match relocation.map(|relocation| (relocation.part, &relocation.target)) {
                Some((Part::Branch, Ok(callee))) => (vec![behind], Some(*callee)),
                Some((_, Err(name))) => return Err(refuse(&format!("a call of {name}, which is elsewhere"))),
                Some(_) => return Err(refuse("a call that the linker changes")),
                None => {
                    let offset = target.wrapping_sub(self.entry).wrapping_add(function.start.offset);
                    (vec![behind], Some(Address { section: self.section, offset }))
                }
            },
            Table { .. } | Exchange { .. } => return Err(refuse("a jump to a computed address")),
            _ => (vec![behind], None),
        })
    }

    /// Returns the entries of a table, by the comparison before its branch.
    fn entries(&self, instruction: &Instruction) -> Option<u32> {
        let index = match instruction.operation {
            Table { index, .. } => index,
            Transfer { place: Place { offset: Offset::Register(index, _), .. }, .. } => index,
            _ => return None,
        };
        let before = self.nodes.range(..instruction.address).rev().take(6);
        before.map(|(_, node)| &node.instruction.operation).find_map(|operation| match *operation {
            Operation::Integer { name: Integer::Sub, to: None, left, right: Operand::Number(last), .. }
                if left == index =>
            {
                Some(last.saturating_add(1).min(1024))
            }
            _ => None,
        })
    }

    /// Finds an order, the loops, and where paths meet.
    fn arrange(&mut self) {
        let mut finished = Vec::new();
        let mut entered: HashSet<u32> = HashSet::from([self.entry]);
        let mut open: HashSet<u32> = HashSet::from([self.entry]);
        let mut back: Vec<(u32, u32)> = Vec::new();
        let mut before: HashMap<u32, BTreeSet<u32>> = HashMap::new();
        let mut path = vec![(self.entry, 0)];
        while let Some((address, at)) = path.last_mut() {
            let (from, taken) = (*address, *at);
            *at += 1;
            let Some(&to) = self.nodes[&from].next.get(taken) else {
                open.remove(&from);
                finished.push(from);
                path.pop();
                continue;
            };
            before.entry(to).or_default().insert(from);
            if open.contains(&to) {
                back.push((from, to));
            }
            if entered.insert(to) {
                open.insert(to);
                path.push((to, 0));
            }
        }
        let parting = self.nodes.values().filter(|node| node.next.len() > 1);
        let parted: HashSet<u32> = parting.flat_map(|node| node.next.iter().copied()).collect();
        for (order, address) in (0..).zip(finished.iter().rev()) {
            if let Some(node) = self.nodes.get_mut(address) {
                node.order = order;
                node.joins = before.get(address).map_or(0, BTreeSet::len) > 1;
                node.begins = node.joins || parted.contains(address);
            }
        }
        let heads: BTreeSet<u32> = back.iter().map(|&(_, head)| head).collect();
        let mut bodies: Vec<(u32, HashSet<u32>)> = Vec::new();
        for head in heads {
            let mut body = HashSet::from([head]);
            let mut work: Vec<u32> = back.iter().filter(|edge| edge.1 == head).map(|edge| edge.0).collect();
            while let Some(address) = work.pop() {
                if body.insert(address) {
                    work.extend(before.get(&address).into_iter().flatten());
                }
            }
            bodies.push((self.nodes[&head].order, body));
        }
        bodies.sort_by_key(|(order, body)| (std::cmp::Reverse(body.len()), *order));
        for (order, body) in bodies {
            for address in body {
                if let Some(node) = self.nodes.get_mut(&address) {
                    node.loops.push(order);
                }
            }
        }
    }

    fn find_live(&mut self) {
        let at_end = preserved().fold(1 | 1 << LR, |set, register| set | 1 << register);
        let mut addresses: Vec<(u32, u32)> = self.nodes.iter().map(|(&address, node)| (node.order, address)).collect();
        addresses.sort_unstable_by(|a, b| b.cmp(a));
        loop {
            let mut changed = false;
            for &(_, address) in &addresses {
                let node = &self.nodes[&address];
                let (reads, writes) = effects(&node.instruction);
                let conditional = node.instruction.condition != Condition::Always;
                let mut after = node.next.iter().fold(0, |set, next| set | self.nodes[next].live);
                if ends(&node.instruction) {
                    after |= at_end;
                }
                // A function that is called may read whatever it likes.
                let called = if node.callee.is_some() { (1 << 48) - 1 } else { 0 };
                let kept = if conditional { after | FLAGS } else { after & !writes };
                let live = reads | called | kept;
                if live != node.live {
                    changed = true;
                    if let Some(node) = self.nodes.get_mut(&address) {
                        node.live = live;
                    }
                }
            }
            if !changed {
                break;
            }
        }
    }
}

/// True for instructions that may return to the caller.
pub(super) fn ends(instruction: &Instruction) -> bool {
    match &instruction.operation {
        Exchange { .. } => true,
        Transfer { load: true, registers, place, .. } => {
            registers.contains(&PC) && !matches!(place.offset, Offset::Register(..))
        }
        _ => false,
    }
}

/// Reads the targets of a table that follows its branch: of offsets, or of addresses. It has as many entries as a comparison
/// says, else it ends where its first target is. What is jumped to in an execution is compared with these.
fn table(
    image: &Image,
    place: Address,
    (behind, bytes): (u32, Option<u8>),
    known: Option<u32>,
    inside: impl Fn(u32) -> bool,
) -> Vec<u32> {
    let mut targets: Vec<u32> = Vec::new();
    let start = if bytes.is_some() { behind } else { behind.wrapping_add(3) & !3 };
    let width = u32::from(bytes.unwrap_or(4));
    for at in 0..known.unwrap_or(1024) {
        let end = start.wrapping_add(at * width);
        let address = Address { offset: place.offset.wrapping_add(4).wrapping_add(end.wrapping_sub(behind)), ..place };
        let target = match bytes {
            Some(bytes) => image.number(address, bytes).map(|distance| behind.wrapping_add(2 * distance)),
            None => image.pointer(address).filter(|to| to.section == place.section).map(|to| image.absolute(to) & !1),
        };
        let passed = known.is_none() && targets.iter().any(|&first| first > behind && end >= first);
        match target.filter(|&target| !passed && inside(target)) {
            Some(target) => targets.push(target),
            None => break,
        }
    }
    targets
}

/// What an instruction reads and what it always writes, if it is executed.
fn effects(instruction: &Instruction) -> (Live, Live) {
    let set = |registers: &[Register]| registers.iter().fold(0, |set: Live, register| set | 1 << register);
    let one = |register: Register| -> Live { 1 << register };
    let operand = |operand| match operand {
        Operand::Number(_) => 0,
        Operand::Register(register, ..) => one(register),
    };
    match instruction.operation {
        Nop | If | Branch { .. } | Call { .. } => (0, 0),
        Operation::Integer { name, flags, to, left, right } => {
            let carry = if matches!(name, Integer::Adc | Integer::Sbc) { FLAGS } else { 0 };
            let copies = matches!(name, Integer::Mov | Integer::Mvn);
            let reads = operand(right) | carry | if copies { 0 } else { one(left) };
            (reads, to.map_or(0, one) | if flags { FLAGS } else { 0 })
        }
        MultiplyAdd { to, factors, sum, .. } => (set(&factors) | one(sum), one(to)),
        Insert { to, from, .. } => (one(to) | from.map_or(0, one), one(to)),
        Extract { to, from, .. } | LeadingZeros { to, from } | Move { to, from } | Unary { to, from, .. } => {
            (one(from), one(to))
        }
        Top { to, .. } => (one(to), one(to)),
        Operation::Address { to, .. } | Constant { to, .. } => (0, one(to)),
        Transfer { load, ref registers, place, .. } => {
            let offset = if let Offset::Register(register, _) = place.offset { one(register) } else { 0 };
            let reads = offset | one(place.base) | if load { 0 } else { set(registers) };
            (reads, if load { set(registers) } else { 0 })
        }
        Operation::Binary { name, to, left, right } => {
            let sums = matches!(name, Binary::MulAdd | Binary::MulSub | Binary::NegMulAdd | Binary::NegMulSub);
            (set(&[left, right]) | if sums { one(to) } else { 0 }, one(to))
        }
        Compare { left, right } => (one(left) | right.map_or(0, one), FLOAT_FLAGS),
        ReadFlags => (FLOAT_FLAGS, FLAGS),
        BranchIf { register, .. } | Exchange { register } => (one(register), 0),
        Table { base, index, .. } => (set(&[base, index]), 0),
    }
}
