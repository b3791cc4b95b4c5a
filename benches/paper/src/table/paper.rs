//! The results that the paper's own files give.

/// Policy; distance in mm, success and collision in % from a fixed start, and from a random start: recomputed from the artifact's files.
pub(super) const PRINTED: [(&str, [&str; 3], [&str; 3]); 3] = [
    ("SAC", ["25.2 ± 8.0", "82.0 ± 3.2", "11.2 ± 1.9"], ["93.5 ± 4.4", "37.4 ± 4.5", "36.8 ± 3.5"]),
    ("TPG", ["28.5 ± 8.9", "56.8 ± 10.2", "15.5 ± 9.8"], ["134.0 ± 16.6", "22.2 ± 8.4", "37.2 ± 13.6"]),
    ("hybrid", ["11.3 ± 5.9", "86.9 ± 8.4", "12.2 ± 8.3"], ["81.2 ± 22.2", "49.3 ± 11.3", "36.3 ± 11.2"]),
];
