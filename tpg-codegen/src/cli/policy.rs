//! `tpg-codegen policy`: a quantised network as C and Rust.

use super::code::LanguageArg;
use crate::options::Prefix;
use crate::policy::{QuantisedPolicy, to_c, to_rust};
use clap::Args;
use std::path::PathBuf;
use tpg_graph::command::{self, CommandError, Verdict};
use tpg_graph::{files, output};

/// Write a quantised network as constants of C and Rust.
#[derive(Clone, Debug, Args)]
pub(super) struct PolicyArgs {
    /// A policy.q.json
    policy: PathBuf,
    /// The language to write
    #[arg(long, value_enum, default_value_t = LanguageArg::All)]
    lang: LanguageArg,
    /// The name of the C array and of the files [default: from the file's name]
    #[arg(long, value_name = "NAME")]
    prefix: Option<Prefix>,
    /// The output folder, created if it does not exist
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    output: PathBuf,
}

impl PolicyArgs {
    pub(super) fn run(&self) -> Result<Verdict, CommandError> {
        let name = self.policy.display().to_string();
        let text = files::read_text(&self.policy, "a policy.q.json that can be read")?;
        let policy = QuantisedPolicy::from_json(&name, &text)?;
        let prefix = self.prefix.clone().unwrap_or_else(|| Prefix::of_file(&self.policy.with_extension("")));
        let mut files = Vec::new();
        if self.lang != LanguageArg::Rust {
            files.extend(to_c(&policy, &prefix)?.into_iter().map(|file| (self.output.join(file.name), file.text)));
        }
        if self.lang != LanguageArg::C {
            files.push((self.output.join(format!("{prefix}.rs")), to_rust(&policy)?));
        }
        output::write_folder(&self.output, &files)?;
        if !command::is_quiet() {
            let paths: String = files.iter().map(|(path, _)| format!("{}\n", path.display())).collect();
            command::print(paths)?;
        }
        Ok(Verdict::Good)
    }
}
