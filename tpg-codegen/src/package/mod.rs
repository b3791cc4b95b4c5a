//! A policy as a package of an ecosystem: manifest, sources, an example that compiles, licence, README.
//!
//! | module | subject |
//! | --- | --- |
//! | `facts` | what templates say about a policy |
//! | `layout` | the files of each ecosystem |

mod details;
mod facts;
mod layout;

pub(crate) use details::{Details, Ecosystem, License};

use crate::emit::Code;
use crate::options::{Language, Options};
use facts::Facts;
use tpg_graph::Graph;
use tpg_graph::error::InputError;

/// A package: the code that it holds, and all of its files by path in the package.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Package<'g> {
    /// The code.
    pub code: Code<'g>,
    /// Paths with `/`, and texts.
    pub files: Vec<(String, String)>,
}

/// Makes the package of a graph. The same graph and options give the same bytes but for the figures in its README, which depend
/// on the compilers that are installed. A graph of counts is compiled to integers.
///
/// # Errors
/// If a value of a graph of counts is not known to be whole; `file` is its name in messages.
pub(crate) fn package<'g>(
    file: &str,
    graph: &'g Graph,
    options: &Options,
    ecosystem: Ecosystem,
    details: &Details,
) -> Result<Package<'g>, InputError> {
    let code = Code::of_graph(file, graph, options, ecosystem.language())?;
    let c = Code::of_graph(file, graph, options, Language::C)?;
    let facts = Facts::new(&code, &c, graph, options, details, ecosystem.target());
    let files = layout::files(&facts, ecosystem, &code);
    Ok(Package { code, files })
}
