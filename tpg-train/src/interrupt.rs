//! Ctrl-C, and the signals that ask a program to end: training stops where it can be resumed.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A flag that is set when the user wants the program to stop. Asked a second time, it ends at once, with exit status 130:
/// the last checkpoint is good.
pub fn watch() -> Arc<AtomicBool> {
    let asked = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&asked);
    // Without a handler the system would end the program at once; the last checkpoint would still be there.
    let _ = ctrlc::set_handler(move || {
        if flag.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
        eprintln!("stopping at the end of this step; once more to stop at once");
    });
    asked
}
