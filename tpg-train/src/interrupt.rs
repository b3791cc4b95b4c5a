//! Ctrl-C and termination signals: training stops at a point from which it can be resumed.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Returns a flag that is set when the user asks the program to stop. A second request ends the program at once, with
/// exit status 130: the last checkpoint is valid.
pub(crate) fn watch() -> Arc<AtomicBool> {
    let asked = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&asked);
    // Without a handler the system would end the program at once; the last checkpoint would still exist.
    let _ = ctrlc::set_handler(move || {
        if flag.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
        eprintln!("stopping at the end of this step; repeat to stop at once");
    });
    asked
}
