//! Facts about the firmware that the analyser takes for granted, each with its reason: a bound is as good as they are.
//!
//! Functions are named by a part of their name, their loops by their order in the code. A fact about a function that is not
//! there, or that has another number of loops, is a failure.

use tpg_arm::sac::FEATURES;

/// All about one image.
pub(crate) struct Facts {
    /// The function that is one decision.
    pub(crate) roots: &'static str,
    /// The function whose stack is painted.
    pub(crate) stack_roots: &'static str,
    /// A part of a function's name, and the turns of its loops.
    pub(crate) loops: Vec<(&'static str, Vec<u64>)>,
    /// A part of a function's name, and what its calls through registers reach.
    pub(crate) calls: Vec<(&'static str, &'static [&'static str])>,
    /// While one decision runs, the most runs of functions with this part in their name.
    pub(crate) limits: Vec<(&'static str, u64)>,
}

/// The shipped network has 64 columns in its hidden layers: eight a turn.
const COLUMNS: u64 = 64 / 8;
/// And 64 rows: four a block.
const BLOCKS: u64 = 64 / 4;
/// Features as words: four a turn, and one more for the rest.
const FOURS: u64 = FEATURES as u64 / 4 + 1;

/// The facts about the control program.
pub(crate) fn control() -> Facts {
    let blocks = ["6thumb210w16a16_raw", "6thumb29w8a16_raw"].map(|name| (name, vec![COLUMNS]));
    let layers = ["6thumb211w8a16_layer", "6thumb212w16a16_layer"].map(|name| (name, vec![BLOCKS, COLUMNS]));
    let mut loops: Vec<_> = blocks.into_iter().chain(layers).collect();
    loops.extend([
        ("11pair_inputs", vec![FOURS]),
        ("5fixed13quantise_into", vec![FEATURES as u64]),
        // What is cleared or copied has at most 64 words, or 32: four words a turn, but one where it is not aligned, and
        // up to three and four bytes before and behind.
        ("__aeabi_memclr4", vec![16, 4]),
        ("__aeabi_memcpy4", vec![8]),
        ("3mem6memcpy", vec![4, 8, 4, 32]),
        // Two sources at most.
        ("16tpg_runtime_capi11observation4fill", vec![2]),
        // Four joints.
        ("17Decision$LT$T$GT$6decide", vec![4]),
        // Fourteen ways to hold joints.
        ("6hybrid4part10valid_part17", vec![14]),
        // Four parts of the arm, four edges of the base.
        ("9collision10meets_base", vec![4, 4]),
        // Four edges of the base, two sides of a part of the arm.
        ("9clearance7nearest", vec![4, 2]),
        // Two hidden layers, and four outputs: in an order that is the compiler's.
        ("5model5Model5first", vec![4; 2]),
    ]);
    Facts {
        roots: "tpg_hybrid_episode_decide",
        stack_roots: "hybrid_decides",
        loops,
        // The hook calls what the policies of control.c name.
        calls: vec![("6switch17Pair$LT$T$C$P$GT$6decide28_", &["fs_infer", "rs_infer"])],
        limits: vec![
            // Two hidden layers.
            ("tpg_kernels6hidden", 2),
            // A stance is kept while the target stays: at most the four candidates of one.
            ("6stance9candidate", 4),
            // The guard's own test of the graph's move, and of the network's move and its parts the eight that differ in the
            // arm's plane.
            ("6leeway6Leeway4look", 1 + 8),
            // A decision asks the graph once.
            ("6switch17Pair$LT$T$C$P$GT$6decide28_", 1),
        ],
    }
}
