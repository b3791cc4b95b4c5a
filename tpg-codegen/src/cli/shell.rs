//! Completions for shells, and manual pages: made of the same definitions as `--help`.

use clap::{Args, Command};
use clap_complete::Shell;
use tpg_graph::command::{CommandError, Verdict, print};

/// Returns the examples of a program and of each of its commands, for tests.
///
/// # Panics
/// If a command has no example.
pub fn examples(program: &Command) -> Vec<String> {
    let name = program.get_name();
    let of = |command: &Command| {
        let text = command.get_after_help().map(ToString::to_string).unwrap_or_default();
        let lines = text.lines().filter_map(|line| line.strip_prefix("  ").filter(|line| line.starts_with(name)));
        let lines: Vec<String> = lines.map(str::to_owned).collect();
        assert!(!lines.is_empty(), "{} has no example", command.get_name());
        lines
    };
    std::iter::once(program).chain(program.get_subcommands()).flat_map(of).collect()
}

/// Print completions for a shell.
#[derive(Clone, Debug, Args)]
pub struct CompletionsArgs {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

/// Print a manual page.
#[derive(Clone, Debug, Args)]
pub struct ManArgs {
    /// A command of the program; the program itself by default
    command: Option<String>,
}

impl CompletionsArgs {
    /// Prints them for a program.
    ///
    /// # Errors
    /// If standard output cannot be written.
    pub fn run(&self, mut program: Command) -> Result<Verdict, CommandError> {
        let (mut text, name) = (Vec::new(), program.get_name().to_owned());
        clap_complete::generate(self.shell, &mut program, name, &mut text);
        print(text)?;
        Ok(Verdict::Good)
    }
}

impl ManArgs {
    /// Prints the page of a program or of one of its commands.
    ///
    /// # Errors
    /// An unknown command, or standard output that cannot be written.
    pub fn run(&self, program: Command) -> Result<Verdict, CommandError> {
        let name = program.get_name().to_owned();
        let page = match &self.command {
            None => program,
            Some(wanted) => {
                let known: Vec<&str> = program.get_subcommands().map(Command::get_name).collect();
                let found = program.find_subcommand(wanted).cloned();
                let refusal =
                    || CommandError::Other(format!("man {wanted}: no such command; accepted: {}", known.join(", ")));
                found.ok_or_else(refusal)?.display_name(format!("{name}-{wanted}"))
            }
        };
        let mut text = Vec::new();
        clap_mangen::Man::new(page).render(&mut text).map_err(CommandError::other)?;
        print(text)?;
        Ok(Verdict::Good)
    }
}
