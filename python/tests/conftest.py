"""Skips are loud: each is noted where `cargo xtask` looks for them."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import cloudpickle
import pytest

sys.path.insert(0, str(Path(__file__).parent))
import environments  # noqa: E402

# Workers of any engine get the test's environments with the work.
cloudpickle.register_pickle_by_value(environments)


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    log = os.environ.get("TPG_SKIPPED_LOG")
    if report.skipped and log:
        reason = report.longrepr[2] if isinstance(report.longrepr, tuple) else str(report.longrepr)
        with open(log, "a") as file:
            file.write(f"python: {report.nodeid}: {reason.removeprefix('Skipped: ')}\n")
