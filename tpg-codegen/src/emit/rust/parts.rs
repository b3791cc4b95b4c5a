//! The text of a profile.

/// A profile's part of the file.
pub(super) struct Parts {
    /// The statements that decide.
    pub(super) body: String,
    /// The items they call.
    pub(super) items: String,
}
