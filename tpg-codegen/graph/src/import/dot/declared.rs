//! The nodes that a file declares, in any part of the file.

use super::Fault;
use super::statement::{Located, Node, ProgramLine, Statement};
use crate::error::InputError;
use std::collections::BTreeMap;

/// Nodes of one kind, in file order and indexed by number.
#[derive(Debug)]
pub(super) struct Table<T> {
    items: Vec<T>,
    places: BTreeMap<u32, usize>,
}

impl<T> Default for Table<T> {
    fn default() -> Self {
        Self { items: Vec::new(), places: BTreeMap::new() }
    }
}

impl<T> Table<T> {
    /// Returns all nodes in file order.
    pub(super) fn items(&self) -> &[T] {
        &self.items
    }

    /// Returns the index in [`items`](Self::items) of the node with the given number.
    pub(super) fn place(&self, number: u32) -> Option<usize> {
        self.places.get(&number).copied()
    }

    /// Returns the node with the given number.
    pub(super) fn get(&self, number: u32) -> Option<&T> {
        self.place(number).map(|place| &self.items[place])
    }

    fn get_mut(&mut self, number: u32) -> Option<&mut T> {
        self.place(number).map(|place| &mut self.items[place])
    }

    fn insert(&mut self, letter: char, number: u32, item: T) -> Result<(), Fault> {
        if self.places.insert(number, self.items.len()).is_some() {
            let accepted = format!("a number that no other {letter} has");
            return Err(Fault::new(format!("{letter}{number} a second time"), accepted));
        }
        self.items.push(item);
        Ok(())
    }
}

/// Node of a team.
#[derive(Debug)]
pub(super) struct Team {
    pub(super) number: u32,
    pub(super) line: usize,
}

/// Node of a program.
#[derive(Debug)]
pub(super) struct Program<'s> {
    pub(super) number: u32,
    pub(super) line: usize,
    pub(super) constants: &'s [f64],
}

/// Node that holds a program's lines.
#[derive(Debug)]
pub(super) struct Lines<'s> {
    pub(super) line: usize,
    pub(super) lines: &'s [ProgramLine],
    pub(super) constants: &'s [f64],
}

/// Node of an action.
#[derive(Debug)]
pub(super) struct Action<'s> {
    pub(super) node: u32,
    pub(super) line: usize,
    pub(super) labels: &'s [u32],
    /// Its programs, in the order of the labels.
    pub(super) programs: Vec<u32>,
}

/// The statement that names the roots.
#[derive(Debug)]
pub(super) struct Rank<'s> {
    pub(super) line: usize,
    pub(super) roots: &'s [Node],
}

/// Everything that a file declares.
#[derive(Debug, Default)]
pub(super) struct Declared<'s> {
    pub(super) exporter: Option<(&'s str, &'s str)>,
    pub(super) teams: Table<Team>,
    pub(super) programs: Table<Program<'s>>,
    pub(super) lines: Table<Lines<'s>>,
    pub(super) actions: Table<Action<'s>>,
    pub(super) rank: Option<Rank<'s>>,
    /// Line of the closing brace.
    pub(super) close: usize,
}

impl<'s> Declared<'s> {
    /// Collects the nodes of a file; a duplicate number is an error.
    pub(super) fn collect(file: &str, statements: &'s [Located]) -> Result<Self, InputError> {
        let mut declared = Self::default();
        for Located { line, statement } in statements {
            declared.add(*line, statement).map_err(|fault| fault.on(file, *line))?;
        }
        Ok(declared)
    }

    fn add(&mut self, line: usize, statement: &'s Statement) -> Result<(), Fault> {
        match statement {
            Statement::Exporter { tool, version } => self.exporter = Some((tool, version)),
            Statement::Team { team } => self.teams.insert('T', *team, Team { number: *team, line })?,
            Statement::Program { program, constants } => {
                self.programs.insert('P', *program, Program { number: *program, line, constants })?;
            }
            Statement::Lines { program, lines, constants } => {
                self.lines.insert('I', *program, Lines { line, lines, constants })?;
            }
            // GEGELATI 2 repeats an action's node before each edge to it.
            Statement::Action { node, labels } => match self.actions.get(*node) {
                Some(known) if known.labels == labels => {}
                _ => self.actions.insert('A', *node, Action { node: *node, line, labels, programs: Vec::new() })?,
            },
            Statement::ActionProgram { node, program } => {
                let accepted = || Fault::new(format!("A{node}, which no line before declares"), "an action's node");
                self.actions.get_mut(*node).ok_or_else(accepted)?.programs.push(*program);
            }
            Statement::Rank { roots } => {
                if self.rank.replace(Rank { line, roots }).is_some() {
                    return Err(Fault::new("the roots a second time", "one line `{ rank= same … }`"));
                }
            }
            Statement::Close => self.close = line,
            Statement::Link { .. } | Statement::Edge { .. } => {}
        }
        Ok(())
    }
}
