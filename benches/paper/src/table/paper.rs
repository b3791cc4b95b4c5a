//! The paper's own figures.

use tpg_problems::arm::targets::Start;

/// A row of the paper's table 2: mean and standard deviation over seeds of distance in mm, success in % and collision in %,
/// recomputed from its artifact's own files.
#[derive(Clone, Copy, Debug)]
pub struct Printed {
    /// The policy.
    pub name: &'static str,
    /// Distance, success and collision.
    pub recomputed: [&'static str; 3],
}

/// Returns the paper's rows.
pub const fn printed(start: Start) -> &'static [Printed] {
    match start {
        Start::Fs => &[
            Printed { name: "SAC, collisions allowed", recomputed: ["25.2", "82.0", "11.2"] },
            Printed { name: "SAC", recomputed: ["25.2 ± 8.0", "82.0 ± 3.2", "11.2 ± 1.9"] },
            Printed { name: "TPG", recomputed: ["28.5 ± 8.9", "56.8 ± 10.2", "15.5 ± 9.8"] },
            Printed { name: "hybrid", recomputed: ["11.3 ± 5.9", "86.9 ± 8.4", "12.2 ± 8.3"] },
        ],
        Start::Rs => &[
            Printed { name: "SAC, collisions allowed", recomputed: ["33.5 ± 5.0", "43.4 ± 3.9", "4.4"] },
            Printed { name: "SAC", recomputed: ["93.5 ± 4.4", "37.4 ± 4.5", "36.8 ± 3.5"] },
            Printed { name: "TPG", recomputed: ["134.0 ± 16.6", "22.2 ± 8.4", "37.2 ± 13.6"] },
            Printed { name: "hybrid", recomputed: ["81.2 ± 22.2", "49.3 ± 11.3", "36.3 ± 11.2"] },
        ],
    }
}
