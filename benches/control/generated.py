"""Generated C of a policy, compiled for this machine and called as a function; its size on a Cortex-M4F."""

from __future__ import annotations

import ctypes
import json
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
CODEGEN = ROOT / "target/release/tpg-codegen"
BOUND = ROOT / "target/release/cortex-bound"
M4 = ["arm-none-eabi-gcc", "-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16", "-Os", "-std=c99"]


@dataclass(frozen=True)
class Footprint:
    """Flash and instructions of code on a Cortex-M4F, compiled with -Os."""

    flash: int
    instructions: int


class Policy:
    """The C of a graph: `policy(observation)` is the action, as Gymnasium takes it."""

    def __init__(self, graph: Path, source: Path, folder: Path) -> None:
        document = json.loads(graph.read_text())
        prefix = source.stem
        length = sum(part["length"] for part in document["sources"])
        library = compiled(source, folder)
        outputs = len(document.get("outputs") or [])
        memory = document.get("memory") or 0
        self._infer = getattr(library, f"{prefix}_infer")
        self._state = (ctypes.c_float * length)()
        self._values = (ctypes.c_float * outputs)() if outputs else None
        self._memory = (ctypes.c_float * memory)() if memory else None
        self._clear = getattr(library, f"{prefix}_reset") if memory else None
        self._infer.restype = None if outputs else ctypes.c_uint16
        failures = getattr(library, f"{prefix}_selftest")()
        if failures != 0:
            raise SystemExit(f"{source}: its self-test counts {failures} failures; accepted: 0")

    def reset(self) -> None:
        """Begins an episode."""
        if self._clear is not None:
            self._clear(ctypes.byref(self._memory))

    def __call__(self, observation: Any) -> Any:
        self._state[:] = np.asarray(observation, dtype=np.float32).tolist()
        given = [ctypes.byref(part) for part in (self._state, self._memory, self._values) if part is not None]
        number = self._infer(*given)
        return int(number) if self._values is None else np.array(self._values, dtype=np.float32)


def compiled(source: Path, folder: Path) -> ctypes.CDLL:
    """Compiles C for this machine."""
    shared = folder / f"{source.stem}.so"
    subprocess.run(
        ["cc", "-std=c99", "-O2", "-fPIC", "-shared", "-ffp-contract=off", str(source), "-o", str(shared), "-lm"],
        check=True,
    )
    return ctypes.CDLL(str(shared))


def built(source: Path, folder: Path, *define: str) -> Path:
    """Compiles C for a Cortex-M4F."""
    thing = folder / f"{source.stem}.o"
    subprocess.run([*M4, *(f"-D{name}" for name in define), "-c", str(source), "-o", str(thing)], check=True)
    return thing


def flash_of(thing: Path) -> int:
    """Returns the bytes of code and constants of an object."""
    told = subprocess.run(["arm-none-eabi-size", "-A", str(thing)], check=True, capture_output=True, text=True).stdout
    return sum(int(line.split()[1]) for line in told.splitlines() if line.startswith((".text", ".rodata", ".data")))


def footprint(source: Path, function: str, folder: Path, *define: str) -> Footprint:
    """Compiles C for a Cortex-M4F: bytes of code and constants, and the most instructions of a decision."""
    thing = built(source, folder, *define)
    bound = subprocess.run([str(BOUND), str(thing), function, "--json"], check=True, capture_output=True, text=True)
    return Footprint(flash_of(thing), json.loads(bound.stdout.splitlines()[0])["instructions"])


def report(graph: Path) -> int:
    """Returns the flash of a graph's C in the profile fast, as `tpg-codegen report` says."""
    told = subprocess.run(
        [str(CODEGEN), "report", str(graph), "--target", "m4f", "--json"],
        check=True,
        capture_output=True,
        text=True,
    )
    sizes = json.loads(told.stdout)["sizes"]
    return next(int(size["flash"]) for size in sizes if size["profile"] == "fast")
