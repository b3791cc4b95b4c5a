//! `tpg-codegen package`: a policy as a package of an ecosystem.

use super::numbers::{Chosen, NumbersArgs};
use super::verify::checked;
use crate::options::{Options, Prefix, Profile};
use crate::package::{Details, Ecosystem, License, package};
use clap::Args;
use std::path::PathBuf;
use tpg_graph::ScalarType;
use tpg_graph::command::{CommandError, Verdict};
use tpg_graph::error::{InputError, Place};
use tpg_graph::{files, output};

/// Write a package: manifest, sources, an example that compiles, licence, README with the policy's figures.
#[derive(Clone, Debug, Args)]
pub(super) struct PackageArgs {
    #[command(flatten)]
    numbers: NumbersArgs,
    /// The ecosystem
    #[arg(long = "for", value_enum, value_name = "ECOSYSTEM")]
    ecosystem: Ecosystem,
    /// The package's folder, created if it does not exist; all of its files are written, or none
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// The name of the package and the prefix of every generated name [default: from the file's name]
    #[arg(long, value_name = "NAME")]
    prefix: Option<Prefix>,
    /// The goal of the optimisation [default: fast in C, constant-time in Rust]
    #[arg(long, value_enum)]
    profile: Option<Profile>,
    /// The package's version
    #[arg(long, value_name = "X.Y.Z", default_value = "0.1.0", value_parser = version)]
    package_version: String,
    /// The author in the manifest
    #[arg(long, value_name = "NAME", default_value = "anonymous", value_parser = line)]
    author: String,
    /// The URL in the manifest; Arduino's Library Manager requires one
    #[arg(long, value_parser = line)]
    url: Option<String>,
    /// The licence as an SPDX expression [default: MIT OR Apache-2.0, with both texts]
    #[arg(long, value_name = "SPDX", requires = "license_file", value_parser = line)]
    license: Option<String>,
    /// The text of that licence
    #[arg(long, value_name = "FILE", requires = "license")]
    license_file: Option<PathBuf>,
    /// Do not compile the code and compare it with the interpreter
    #[arg(long)]
    no_verify: bool,
}

impl PackageArgs {
    pub(super) fn run(&self) -> Result<Verdict, CommandError> {
        let Chosen { graph, conversion, whole } = self.numbers.load()?;
        let (file, graph) = (&self.numbers.graph, whole.unwrap_or(graph));
        if self.ecosystem == Ecosystem::Arduino && graph.scalar() == ScalarType::F64 && !graph.has_counts() {
            let found = "a graph that computes in f64, which an AVR's double is not";
            return Err(InputError::new(file.name(), Place::Whole, found, "--scalar f32, or another --for").into());
        }
        let prefix = self.prefix.clone().unwrap_or_else(|| Prefix::of_file(&file.graph));
        let options = Options { profile: self.profile, conversion, ..Options::new(prefix) };
        let details = Details {
            version: self.package_version.clone(),
            author: self.author.clone(),
            url: self.url.clone(),
            license: self.license()?,
        };
        let made = package(&file.name(), &graph, &options, self.ecosystem, &details)?;
        let files: Vec<(PathBuf, &str)> =
            made.files.iter().map(|(path, text)| (self.output.join(path), text.as_str())).collect();
        output::write_folder(&self.output, &files)?;
        for (path, _) in &files {
            println!("wrote {}", path.display());
        }
        if self.no_verify {
            return Ok(Verdict::Good);
        }
        let (sentences, verdict) = checked(&[made.code])?;
        print!("{sentences}");
        Ok(verdict)
    }

    fn license(&self) -> Result<License, InputError> {
        let (Some(spdx), Some(path)) = (&self.license, &self.license_file) else { return Ok(License::default()) };
        let text = files::read_text(path, "the text of the licence, in UTF-8")?;
        Ok(License { spdx: spdx.clone(), files: vec![("LICENSE".to_owned(), text)] })
    }
}

/// Three numbers without leading zeros.
fn version(text: &str) -> Result<String, String> {
    let number = |part: &str| part.parse::<u32>().is_ok_and(|number| number.to_string() == part);
    let good = text.split('.').count() == 3 && text.split('.').all(number);
    good.then(|| text.to_owned()).ok_or_else(|| "accepted: three numbers, as in 1.0.2".to_owned())
}

/// A text that no manifest needs to quote.
fn line(text: &str) -> Result<String, String> {
    let good = !text.trim().is_empty() && !text.chars().any(|c| c.is_control() || c == '"' || c == '\\');
    good.then(|| text.to_owned()).ok_or_else(|| "accepted: one line without quotation marks and backslashes".to_owned())
}
