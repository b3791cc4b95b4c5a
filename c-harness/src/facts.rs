//! What the analyser is told about the firmwares, each with its reason: whoever signs a bound signs these.
//!
//! Functions are named by a part of their name, loops by their order in the code. A fact about a function that is not
//! there, or that has another number of loops, is a failure; and `cargo xtask qemu` watches every loop and every limit
//! while the firmware runs.

use tpg_generated::widowx_fs_fast::WidowxFsFast;
use tpg_generated::widowx_rs_fast::WidowxRsFast;

/// A part of a function's name, the turns of its loops in order, and why.
type Loops = (&'static str, &'static [u64], &'static str);

/// A part of a function's name, what its calls through registers reach, and why.
type Calls = (&'static str, &'static [&'static str], &'static str);

/// While the first function runs once, the second runs no more than so many times, and why.
type Limits = (&'static str, &'static str, u64, &'static str);

/// All about one image.
pub(crate) struct Facts {
    /// What one decision is.
    pub(crate) roots: &'static str,
    /// What the painted stack is that of.
    pub(crate) stack_roots: &'static str,
    pub(crate) loops: Vec<Loops>,
    pub(crate) calls: Vec<Calls>,
    pub(crate) limits: Vec<Limits>,
}

/// An inference looks at its loop once a team, and once more to leave it.
const FS: &[u64] = &[WidowxFsFast::DEPTH as u64 + 1];
const RS: &[u64] = &[WidowxRsFast::DEPTH as u64 + 1];

/// The facts about a language's control program.
pub(crate) fn of(language: &str) -> Facts {
    let (loops, limits) = (Vec::new(), Vec::new());
    match language {
        "C" => Facts {
            roots: "tpg_hybrid_episode_decide",
            stack_roots: "hybrid_decides",
            loops: [&loops[..], &[("widowx_fs_infer", FS, "teams"), ("widowx_rs_infer", RS, "teams")]].concat(),
            calls: vec![("6hybrid23Hybrid", &["fs_infer", "rs_infer"], "the policies of control.c")],
            limits,
        },
        _ => Facts { roots: "hybrid_decide", stack_roots: "hybrid_decide", loops, calls: vec![], limits },
    }
}
