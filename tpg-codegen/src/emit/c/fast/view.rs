//! What the template is told.

/// The bids of a team that may lead without having been computed.
pub(super) struct LateTeamView {
    pub(super) label: u32,
    pub(super) bids: Vec<LateView>,
    pub(super) reads_state: bool,
}

/// Some teams, one after another.
pub(super) struct FunctionView {
    /// Variables for what several teams read.
    pub(super) shared: Vec<String>,
    /// How to come to a team from another function; none where there is only one.
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
    /// Whether control comes to it from elsewhere: not to the root.
    pub(super) is_entered: bool,
    /// The variable that holds the winner: the way it goes, or its place.
    pub(super) winner: &'static str,
    pub(super) nobody: String,
    /// What is asked first: the condition under which a bid is infinite, and its rank.
    pub(super) infinite: Option<InfiniteView>,
    pub(super) eager: Vec<EagerView>,
    pub(super) eager_before: Vec<EagerView>,
    pub(super) lazy: Vec<LazyView>,
    /// Where the edges lead; the last is where nobody's win leads.
    pub(super) ways: Vec<WayView>,
}

pub(super) struct WayView {
    pub(super) condition: String,
    /// What is decided, where control leaves the function.
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
    pub(super) in_turn: bool,
    /// Whether no bid follows: then, what is best does not matter any more.
    pub(super) last: bool,
}

/// A bid that may lead without having been computed.
pub(super) struct LateView {
    pub(super) rank: String,
    pub(super) statements: Vec<String>,
    pub(super) value: String,
}

pub(super) struct LazyView {
    pub(super) before: Vec<String>,
    /// Whether to look at it at all.
    pub(super) considered: Option<String>,
    pub(super) bound_statements: Vec<String>,
    /// The ends of what it can be, where it need not be computed to win.
    pub(super) ends: Option<(String, String)>,
    /// Certain to win.
    pub(super) sure: String,
    /// What is the highest that the leader can bid.
    pub(super) top: &'static str,
    /// Whether the leader may not have been computed yet.
    pub(super) pending: bool,
    /// Whether this is the first that can win without being computed.
    pub(super) first: bool,
    /// None where it must be looked at whatever the others bid.
    pub(super) guard: Option<String>,
    pub(super) statements: Vec<String>,
    pub(super) value: String,
    pub(super) rank: String,
    pub(super) wins: String,
    pub(super) last: bool,
}
