"""What a test needs beside the package: loudly skipped without it, and a failure where nothing may be missing."""

from __future__ import annotations

import importlib
import os
import shutil
from typing import Any

import pytest


def module(name: str) -> Any:
    """Returns a module."""
    try:
        return importlib.import_module(name)
    except ImportError:
        _missing(name)


def program(name: str) -> str:
    """Returns the path of a program."""
    path = shutil.which(name)
    if path is None:
        _missing(name)
    return str(path)


def _missing(name: str) -> None:
    message = f"{name} is not installed"
    if os.environ.get("TPG_REQUIRE_EMBEDDED") == "1":
        pytest.fail(message)
    pytest.skip(message)
