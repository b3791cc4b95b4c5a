//! The data of the template.

/// The bids of a team that may lead without having been computed.
pub(super) struct LateTeamView {
    pub(super) label: u32,
    pub(super) bids: Vec<LateView>,
    pub(super) reads_state: bool,
}

/// Some teams, one after another.
pub(super) struct FunctionView {
    /// Variables for values that several teams read.
    pub(super) shared: Vec<String>,
    /// Entry points for calls from other functions; empty if there is only one function.
    pub(super) entries: Vec<EntryView>,
    pub(super) teams: Vec<TeamView>,
    /// The number after its last team's.
    pub(super) end: usize,
    pub(super) reads_state: bool,
}

pub(super) struct EntryView {
    pub(super) number: String,
    pub(super) label: u32,
}

pub(super) struct TeamView {
    pub(super) label: u32,
    /// Some `goto` leads here: not to the root.
    pub(super) is_entered: bool,
    /// The variable that holds the winner: the way it goes, or its place.
    pub(super) winner: &'static str,
    pub(super) nobody: String,
    /// The first bid, where it is a number: it leads without a test.
    pub(super) first: Option<EagerView>,
    /// The leader is a variable that functions change.
    pub(super) is_compact: bool,
    /// Bids that are computed unless an infinite one leads, where the code is compact.
    pub(super) steps_before: Vec<StepView>,
    pub(super) steps_lazy: Vec<StepView>,
    /// The first test: a bid's condition for infinity, and its rank.
    pub(super) infinite: Option<InfiniteView>,
    /// The bids in order, where the code is compact; the next three are empty then.
    pub(super) steps: Vec<StepView>,
    pub(super) eager: Vec<EagerView>,
    pub(super) eager_before: Vec<EagerView>,
    pub(super) lazy: Vec<LazyView>,
    /// The edges' destinations; the last is taken if no bid wins.
    pub(super) ways: Vec<WayView>,
}

pub(super) struct WayView {
    pub(super) condition: String,
    /// The vertex to return, if control leaves the function.
    pub(super) vertex: Option<String>,
    pub(super) label: String,
}

pub(super) struct InfiniteView {
    pub(super) statements: Vec<String>,
    pub(super) condition: String,
    pub(super) rank: String,
}

pub(super) struct EagerView {
    pub(super) statements: Vec<String>,
    pub(super) value: String,
    pub(super) rank: String,
    pub(super) ascending: bool,
    /// The last bid of its team: `best` is dead after it.
    pub(super) last: bool,
}

/// A bid of a team whose leader is a variable that functions change.
pub(super) struct StepView {
    pub(super) before: Vec<String>,
    /// The condition for evaluating even the bound.
    pub(super) considered: Option<String>,
    pub(super) bound: Vec<String>,
    pub(super) guard: Option<String>,
    /// The guard is that of the bid before, which stands in the same braces: nothing that could lead there is above it, and the leader is
    /// known.
    pub(super) continues: bool,
    /// A number bounds it.
    pub(super) is_bounded: bool,
    /// The next one continues.
    pub(super) goes_on: bool,
    /// Statements without braces around them.
    pub(super) outside: Vec<String>,
    pub(super) statements: Vec<String>,
    /// The leader may not have been computed yet.
    pub(super) is_late: bool,
    pub(super) value: String,
    /// The function that lets it lead.
    pub(super) take: &'static str,
    pub(super) rank: String,
}

/// A bid that may lead without having been computed.
pub(super) struct LateView {
    pub(super) rank: String,
    pub(super) statements: Vec<String>,
    pub(super) value: String,
}

pub(super) struct LazyView {
    pub(super) before: Vec<String>,
    /// The condition for evaluating even the bound.
    pub(super) considered: Option<String>,
    pub(super) bound_statements: Vec<String>,
    /// The ends of what it can be, where it need not be computed to win.
    pub(super) ends: Option<(String, String)>,
    /// Certain to win.
    pub(super) sure: String,
    /// The variable that holds the leader's upper bound.
    pub(super) top: &'static str,
    /// The leader may not have been computed yet.
    pub(super) pending: bool,
    /// The first bid of its team that can win without being computed.
    pub(super) first: bool,
    /// None if the bid must be evaluated whatever the others bid.
    pub(super) guard: Option<String>,
    pub(super) statements: Vec<String>,
    pub(super) value: String,
    pub(super) rank: String,
    pub(super) wins: String,
    pub(super) last: bool,
}
