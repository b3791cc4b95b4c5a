//! Runs an image in QEMU.

use crate::Failure;
use crate::build::Board;
use crate::line::Line;
use std::path::Path;
use std::process::Command;

/// Longer than any machine needs; a hang must end.
const SECONDS: &str = "600";

/// Runs an image on a board and returns the lines that it prints.
pub(crate) fn run(board: Board, image: &Path) -> Result<Vec<Line>, Failure> {
    let mut qemu = Command::new("timeout");
    qemu.args([
        SECONDS,
        "qemu-system-arm",
        "-machine",
        board.name(),
        "-nographic",
        "-monitor",
        "none",
        "-serial",
        "none",
    ]);
    qemu.args(["-semihosting-config", "enable=on,target=native", "-icount", "shift=10,align=off,sleep=off", "-kernel"]);
    let output = qemu.arg(image).output().map_err(Failure::new)?;
    // SYS_WRITE0 comes out on stderr, SYS_WRITE on stdout.
    let text = [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text).into_owned()).concat();
    let lines: Vec<Line> = text.lines().map(Line::parse).collect();
    if !output.status.success() || !lines.iter().any(|line| line.words == ["done"]) {
        let tail: Vec<&str> = text.lines().rev().take(5).collect();
        return Err(Failure::new(format!("{} on {}: {}: {tail:?}", image.display(), board.name(), output.status)));
    }
    Ok(lines)
}
