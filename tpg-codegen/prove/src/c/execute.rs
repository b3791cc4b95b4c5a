//! Executes operations over terms. Paths that meet become one; integers that decide where control goes are constants.

use super::code::{Operation, Program};
use super::value::{Here, chosen};
use crate::input::{Missing, Result};
use crate::machine::{Answer, Interface, Machine, Step};
use crate::term::{Bool, Float, Node, Terms, Width, Word};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::rc::Rc;

/// Operations in one piece.
const LONGEST: u64 = 4_000_000;

/// What a cell holds, if that is defined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Cell {
    Float(Float),
    Word(Word),
}

/// A place in the code and the cells that are not as they are at first.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Point {
    at: usize,
    cells: Rc<[(u32, Option<Cell>)]>,
}

/// Where execution is, and under which condition.
#[derive(Clone)]
struct CState {
    guard: Bool,
    cells: Vec<Option<Cell>>,
    /// No float that is a variable of its own differed where paths met
    agreed: bool,
}

/// The floats of points that were reached at a place with the same integers.
type Reached = HashMap<(usize, Vec<(u32, Option<Cell>)>), BTreeMap<u32, Float>>;

/// Called with every return: its place in the code, and the state there.
type Returned<'a> = dyn FnMut(&Code, &Terms, usize, &CState) -> Result<()> + 'a;

/// A function of C, ready to be executed.
#[derive(Debug)]
pub struct Code {
    file: String,
    pub(super) program: Program,
    interface: Interface,
    /// Where jumps go, and where execution may be cut
    joins: BTreeSet<usize>,
    /// The cells at first
    first: Vec<Option<Cell>>,
    /// The points that were reached at a place with the same integers
    reached: Reached,
    /// This text defines what functions mean: that its indices are in bounds is known
    pub(super) defines: bool,
}

impl Code {
    pub(super) fn new(file: &str, program: Program, interface: &Interface) -> Self {
        let targets = program.operations.iter().filter_map(|(_, operation)| match operation {
            Operation::Branch(_, to) | Operation::Jump(to, _) => Some(*to),
            _ => None,
        });
        let joins = targets.chain(program.heads.keys().copied()).collect();
        let first = vec![None; program.cells as usize];
        Self {
            file: file.to_owned(),
            program,
            interface: interface.clone(),
            joins,
            first,
            reached: HashMap::new(),
            defines: false,
        }
    }

    /// Code that defines a function.
    pub(super) fn definition(file: &str, program: Program) -> Self {
        Self { defines: true, ..Self::new(file, program, &Interface::default()) }
    }

    pub(super) fn missing(&self, at: usize, what: impl Into<String>) -> Missing {
        let line = self.program.operations.get(at).map_or(0, |&(line, _)| line);
        Missing::new(format!("{}:{line}", self.file), what)
    }

    /// The result for a float in cell 0.
    pub(super) fn of_float(&mut self, terms: &Terms, argument: Float) -> Result<Float> {
        self.first[0] = Some(Cell::Float(argument));
        let start = Point { at: 0, cells: Rc::new([]) };
        let mut results = Vec::new();
        self.pieces(terms, &start, &mut |execution, terms, at, state| {
            let result = execution.result(at)?;
            results.push((state.guard, execution.here(terms, at, state).read_float(result.into())?));
            Ok(())
        })?;
        let mut result = None;
        for (guard, value) in results {
            result = Some(result.map_or(value, |other| terms.choose_float(guard, value, other)));
        }
        result.ok_or_else(|| self.missing(0, "a result"))
    }

    /// The cell of the result.
    fn result(&self, at: usize) -> Result<u32> {
        self.program.result.ok_or_else(|| self.missing(at, "a result"))
    }

    fn here<'a>(&'a self, terms: &'a Terms, at: usize, state: &'a CState) -> Here<'a> {
        Here { code: self, terms, at, cells: &state.cells }
    }

    /// Executes from a point; every return is reported, and every point where execution is cut.
    fn pieces(&mut self, terms: &Terms, from: &Point, returned: &mut Returned<'_>) -> Result<Vec<(Bool, Point)>> {
        let mut cells = self.first.clone();
        for &(address, cell) in from.cells.iter() {
            cells[address as usize] = cell;
        }
        let mut pending = BTreeMap::new();
        pending.insert((0, from.at), CState { guard: Terms::TRUE, cells, agreed: true });
        let (mut cuts, mut steps, mut begun) = (Vec::new(), 0, false);
        while let Some(((round, at), state)) = pending.pop_first() {
            if begun && self.is_cut(at, &state) {
                self.cut(terms, at, state, &mut cuts)?;
                continue;
            }
            begun = true;
            self.straight(terms, (round, at), CState { agreed: true, ..state }, &mut pending, returned, &mut steps)?;
        }
        Ok(cuts)
    }

    /// Executes until paths part or meet.
    fn straight(
        &self,
        terms: &Terms,
        (round, mut at): (u64, usize),
        mut state: CState,
        pending: &mut BTreeMap<(u64, usize), CState>,
        returned: &mut Returned<'_>,
        steps: &mut u64,
    ) -> Result<()> {
        let start = at;
        loop {
            if at != start && self.joins.contains(&at) {
                return self.arrive(terms, (round, at), state, pending);
            }
            *steps += 1;
            if *steps > LONGEST {
                return Err(self.missing(at, "a loop that ends soon"));
            }
            terms.complete(|| self.missing(at, "").place)?;
            match &self.program.operations[at].1 {
                Operation::Set(address, value) => {
                    let here = self.here(terms, at, &state);
                    let (address, cell) = (here.word(address)?, here.value(value)?);
                    *self.target(at, terms.number_of(address), &mut state.cells)? = Some(cell);
                }
                Operation::Copy(to, from, count) => {
                    let here = self.here(terms, at, &state);
                    let (to, from) = (here.range(to, *count)?, here.range(from, *count)?);
                    let copied: Vec<_> = (from..).take(*count as usize).map(|address| here.cell(address)).collect();
                    for (to, cell) in (to..).zip(copied) {
                        *self.target(at, Some(to), &mut state.cells)? = Some(cell?);
                    }
                }
                Operation::Leave(scope) => self.leave(*scope, &mut state.cells),
                Operation::Branch(condition, otherwise) => {
                    let condition = self.here(terms, at, &state).condition(condition)?;
                    let other = terms.and(state.guard, !condition);
                    state.guard = terms.and(state.guard, condition);
                    if other != Terms::FALSE {
                        let round = round + u64::from(*otherwise <= at);
                        let state = CState { guard: other, ..state.clone() };
                        self.arrive(terms, (round, *otherwise), state, pending)?;
                    }
                    if state.guard == Terms::FALSE {
                        return Ok(());
                    }
                }
                Operation::Jump(to, left) => {
                    for &scope in left {
                        self.leave(scope, &mut state.cells);
                    }
                    let round = round + u64::from(*to <= at);
                    return self.arrive(terms, (round, *to), state, pending);
                }
                Operation::Return => return returned(self, terms, at, &state),
            }
            at += 1;
        }
    }

    fn target<'c>(
        &self,
        at: usize,
        address: Option<u64>,
        cells: &'c mut [Option<Cell>],
    ) -> Result<&'c mut Option<Cell>> {
        let cell = address.and_then(|address| cells.get_mut(usize::try_from(address).ok()?));
        cell.ok_or_else(|| self.missing(at, "a place to write to that is a constant"))
    }

    fn leave(&self, scope: usize, cells: &mut [Option<Cell>]) {
        let (start, end) = self.program.scopes[scope];
        cells[start as usize..end as usize].fill(None);
    }

    /// Lets a path wait where it may meet others.
    fn arrive(
        &self,
        terms: &Terms,
        place: (u64, usize),
        mut state: CState,
        pending: &mut BTreeMap<(u64, usize), CState>,
    ) -> Result<()> {
        if let Some(other) = pending.remove(&place) {
            state = self.met(terms, place.1, state, other)?;
        }
        pending.insert(place, state);
        Ok(())
    }

    /// Makes one state of two. Their conditions exclude each other: what both ask for decides nothing.
    fn met(&self, terms: &Terms, at: usize, a: CState, b: CState) -> Result<CState> {
        let (first, second) = (terms.parts(a.guard), terms.parts(b.guard));
        let (shared, only): (Vec<_>, Vec<_>) = first.into_iter().partition(|part| second.contains(part));
        let rest: Vec<_> = second.into_iter().filter(|part| !shared.contains(part)).collect();
        let (only, rest) = (terms.all(only), terms.all(rest));
        let guard = terms.all(shared.into_iter().chain([terms.or(only, rest)]));
        let mut agreed = a.agreed && b.agreed;
        let mut cells = a.cells;
        for (address, (cell, other)) in cells.iter_mut().zip(b.cells).enumerate() {
            if *cell == other {
                continue;
            }
            let (Some(x), Some(y)) = (*cell, other) else {
                *cell = None;
                continue;
            };
            agreed &= matches!(x, Cell::Word(_)) || self.program.is_array(address as u32);
            *cell =
                Some(chosen(terms, only, x, y).ok_or_else(|| self.missing(at, "one kind of value where paths meet"))?);
        }
        Ok(CState { guard, cells, agreed })
    }

    /// Tests whether execution is cut here: where nothing is being computed, or at a label that all paths reach with the same floats.
    fn is_cut(&self, at: usize, state: &CState) -> bool {
        match self.program.heads.get(&at) {
            None => false,
            Some(true) if state.agreed => true,
            Some(_) => {
                let mut alive =
                    state.cells.iter().zip(&self.first).enumerate().filter(|(_, (cell, first))| cell != first);
                !alive.any(|(address, (cell, _))| {
                    matches!(cell, Some(Cell::Float(_))) && !self.program.is_array(address as u32)
                })
            }
        }
    }

    /// Cuts execution: a point for each choice of integers.
    fn cut(&mut self, terms: &Terms, at: usize, state: CState, cuts: &mut Vec<(Bool, Point)>) -> Result<()> {
        if state.guard == Terms::FALSE {
            return Ok(());
        }
        let choice = state.cells.iter().find_map(|&cell| match cell {
            Some(Cell::Word(word)) if matches!(terms.of_word(word), Node::WordIf(..)) => Some(word),
            _ => None,
        });
        if let Some(word) = choice
            && let Some(numbers) = terms.numbers(word)
        {
            for number in numbers {
                let constant = terms.number(number);
                let guard = terms.and(state.guard, terms.same(Width::W32, word, constant));
                let cells = (state.cells.iter())
                    .map(|&cell| if cell == Some(Cell::Word(word)) { Some(Cell::Word(constant)) } else { cell })
                    .collect();
                self.cut(terms, at, CState { guard, cells, ..state }, cuts)?;
            }
            return Ok(());
        }
        let changed = (0..).zip(state.cells.iter().zip(&self.first)).filter(|(_, (cell, first))| cell != first);
        let cells: Vec<(u32, Option<Cell>)> = changed.map(|(address, (&cell, _))| (address, cell)).collect();
        let words = cells.iter().copied().filter(|(_, cell)| !matches!(cell, Some(Cell::Float(_)))).collect();
        // floats of arrays that differ from what was there at another time may be anything
        let floats = self.reached.entry((at, words)).or_default();
        let mut widened = Vec::new();
        for (address, cell) in cells {
            widened.push(match cell {
                Some(Cell::Float(float)) if self.program.is_array(address) => {
                    let known = floats.entry(address).or_insert(float);
                    if *known != float && !matches!(terms.of_float(*known), Node::Unknown(_)) {
                        *known = terms.unknown();
                    }
                    (address, Some(Cell::Float(*known)))
                }
                cell => (address, cell),
            });
        }
        let point = Point { at, cells: widened.into() };
        match cuts.iter_mut().find(|(_, other)| *other == point) {
            Some((guard, _)) => *guard = terms.or(*guard, state.guard),
            None => cuts.push((state.guard, point)),
        }
        Ok(())
    }
}

impl Machine for Code {
    type Point = Point;

    fn entry(&mut self, terms: &Terms) -> Result<Point> {
        let sources = (0..self.interface.state_length()).map(|index| (self.program.state + index, index));
        let memory = (self.interface.state_length()..).zip(&self.interface.memory);
        let remembered = memory
            .map(|(index, _)| (self.program.memory.unwrap_or_default() + index - self.interface.state_length(), index));
        for (address, index) in sources.chain(remembered) {
            self.first[address as usize] = Some(Cell::Float(terms.source(index)));
        }
        Ok(Point { at: 0, cells: Rc::new([]) })
    }

    fn run(&mut self, terms: &Terms, from: &Point) -> Result<Vec<(Bool, Step<Point>)>> {
        let mut ends = Vec::new();
        let cuts = self.pieces(terms, from, &mut |code, terms, at, state| {
            let answer = match code.program.action {
                None => Answer::Action(code.here(terms, at, state).read_word(code.result(at)?.into())?),
                Some(action) => {
                    let outputs = (action..).zip(&code.interface.outputs).map(|(address, _)| address);
                    let memory = (code.program.memory.unwrap_or_default()..).zip(&code.interface.memory);
                    let all = outputs.chain(memory.map(|(address, _)| address));
                    let values = all.map(|address| code.here(terms, at, state).read_float(address.into()));
                    Answer::Values(values.collect::<Result<_>>()?)
                }
            };
            ends.push((state.guard, Step::Return(answer)));
            Ok(())
        })?;
        ends.extend(cuts.into_iter().map(|(guard, point)| (guard, Step::To(point))));
        Ok(ends)
    }

    fn place(&self, point: &Point) -> String {
        format!("{}:{}", self.file, self.program.operations.get(point.at).map_or(0, |&(line, _)| line))
    }
}
