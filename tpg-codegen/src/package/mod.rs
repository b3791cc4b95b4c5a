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
use crate::options::Options;
use crate::program::compile;
use facts::Facts;
use tpg_graph::Graph;

/// A package: the code that it holds, and all of its files by path in the package.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Package<'g> {
    /// The code.
    pub code: Code<'g>,
    /// Paths with `/`, and texts.
    pub files: Vec<(String, String)>,
}

/// Makes the package of a graph. The same graph and options give the same bytes but for the figures in its README, which depend
/// on the compilers that are installed.
pub(crate) fn package<'g>(graph: &'g Graph, options: &Options, ecosystem: Ecosystem, details: &Details) -> Package<'g> {
    let code = Code::of(compile(graph, options, ecosystem.language()));
    let facts = Facts::new(&code, graph, options, details, ecosystem.target());
    let files = layout::files(&facts, ecosystem, &code);
    Package { code, files }
}
