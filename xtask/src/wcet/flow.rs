//! The control flow of one function.

use super::instruction::{Kind, Stack, kind, stack};
use super::listing::{Function, Line, Listing};
use super::refusal::Refusal;
use std::collections::BTreeMap;

/// A function as a graph: its instructions are the nodes.
#[derive(Clone, Debug)]
pub(super) struct Flow {
    /// The instructions that may follow each.
    pub(super) next: Vec<Vec<usize>>,
    /// The function that each calls, a call at the end included: its place in the listing.
    pub(super) calls: Vec<Option<usize>>,
    /// Bytes of stack of the function itself.
    pub(super) frame: u64,
}

impl Flow {
    /// Of a function of a listing.
    pub(super) fn of(listing: &Listing, function: &Function) -> Result<Self, Refusal> {
        let place: BTreeMap<u64, usize> = (function.lines.iter().map(|line| line.address)).zip(0..).collect();
        let mut flow = Self { next: Vec::new(), calls: Vec::new(), frame: 0 };
        for (index, line) in function.lines.iter().enumerate() {
            let (mut next, mut call) = (Vec::new(), None);
            let mut goes_on = true;
            match stack(line) {
                Stack::Same => {}
                Stack::Down(bytes) => flow.frame += bytes,
                Stack::Unknown => {
                    let (address, text) = (line.address, line.text());
                    return Err(Refusal::DynamicStack { function: function.name.clone(), address, text });
                }
            }
            match kind(line) {
                Kind::Plain => {}
                Kind::Branch { conditional } => {
                    goes_on = conditional;
                    match target(listing, function, line)? {
                        To::Here(address) => match place.get(&address) {
                            Some(&to) => next.push(to),
                            None => return Err(astray(function, line)),
                        },
                        To::Function(callee) => call = Some(callee),
                    }
                }
                Kind::Call => {
                    call = match target(listing, function, line)? {
                        To::Function(callee) => Some(callee),
                        To::Here(_) => return Err(astray(function, line)),
                    };
                    // What follows no instruction is never come back to: the callee does not return.
                    goes_on = follower(function, index).is_some();
                }
                Kind::Return { conditional } => goes_on = conditional,
                Kind::Trap => goes_on = false,
                Kind::Indirect => {
                    let (address, text) = (line.address, line.text());
                    return Err(Refusal::Indirect { function: function.name.clone(), address, text });
                }
                Kind::JumpTable => {
                    let (address, text) = (line.address, line.text());
                    return Err(Refusal::JumpTable { function: function.name.clone(), address, text });
                }
            }
            if goes_on {
                next.push(follower(function, index).ok_or_else(|| astray(function, line))?);
            }
            flow.next.push(next);
            flow.calls.push(call);
        }
        Ok(flow)
    }
}

/// The instruction right behind another, without data between them.
fn follower(function: &Function, index: usize) -> Option<usize> {
    let [here, next] = [function.lines.get(index)?, function.lines.get(index + 1)?];
    (next.address - here.address <= 4).then_some(index + 1)
}

enum To {
    /// An address in the function itself.
    Here(u64),
    /// A function's beginning.
    Function(usize),
}

fn target(listing: &Listing, function: &Function, line: &Line) -> Result<To, Refusal> {
    if let Some(symbol) = &line.symbol {
        return listing.named(symbol).map(To::Function).ok_or_else(|| Refusal::NotHere {
            function: function.name.clone(),
            address: line.address,
            callee: symbol.clone(),
        });
    }
    // The last operand is the target: `10 <f+0x8>`.
    let operand = line.operands.rsplit(", ").next().unwrap_or_default();
    let number = operand.split_whitespace().next().unwrap_or_default();
    let address = u64::from_str_radix(number, 16).map_err(|_| astray(function, line))?;
    let inside = function.lines.iter().any(|line| line.address == address);
    match listing.at(&function.section, address) {
        // A branch to the own beginning is a loop, a call of it a recursion.
        Some(callee) if kind(line) == Kind::Call || !inside => Ok(To::Function(callee)),
        _ if inside => Ok(To::Here(address)),
        _ => Err(astray(function, line)),
    }
}

fn astray(function: &Function, line: &Line) -> Refusal {
    Refusal::Astray { function: function.name.clone(), address: line.address, text: line.text() }
}
