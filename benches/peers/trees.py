#!/usr/bin/env python3
"""A policy of this project beside decision trees that imitate it, through m2cgen and emlearn.

    cargo build --release -p tpg-codegen
    python3 -m venv peers && peers/bin/pip install m2cgen emlearn scikit-learn
    peers/bin/python benches/peers/trees.py

Everything is compiled by the same compilers: arm-none-eabi-gcc -Os for the bytes of a Cortex-M4F (code and constants of the
object, libraries not counted), gcc -O2 for the time of a decision on this machine (CPU time over the test states, of every
thousand the least of 30 passes; conversion of the state and choice of the highest class included). Trees are fitted to the graph's own actions on
states: half of them drawn uniformly from the declared ranges, half from the fiftieth of them around zero, where errors are
small and decisions are close. They are tested on others, on both kinds by themselves. Prints a table in Markdown.
"""

import json
import random
import shutil
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
GRAPH = ROOT / "generated/widowx-fs/graph.json"
TOOL = ROOT / "target/release/tpg-codegen"
LEAVES = [64, 256]
TRAINING, TEST = 200_000, 100_000
M4 = ["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"]

# What every candidate implements.
DRIVER = r"""
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
int decide(const float *state);
enum { BLOCK = 1000, PASSES = 30 };
static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return t.tv_sec * 1e9 + t.tv_nsec;
}
int main(int argc, char **argv) {
    const long count = atol(argv[2]), length = atol(argv[3]);
    float *states = malloc(sizeof(float) * (size_t)(count * length));
    unsigned char *actions = malloc((size_t)count);
    FILE *in = fopen(argv[1], "rb"), *out;
    double total = 0.0;
    if (argc != 5 || in == NULL || fread(states, sizeof(float), (size_t)(count * length), in) == 0) return 2;
    for (long begin = 0; begin < count; begin += BLOCK) {
        const long end = begin + BLOCK < count ? begin + BLOCK : count;
        double least = 1e300;
        for (int pass = 0; pass < PASSES; pass++) {
            const double start = now();
            for (long i = begin; i < end; i++) actions[i] = (unsigned char)decide(states + i * length);
            const double time = now() - start;
            if (time < least) least = time;
        }
        total += least;
    }
    out = fopen(argv[4], "wb");
    if (out == NULL || fwrite(actions, 1, (size_t)count, out) != (size_t)count) return 2;
    fclose(out);
    printf("%.2f\n", total / (double)count);
    return 0;
}
"""


def skip(reason):
    print(f"SKIPPED: decision trees of m2cgen and emlearn: {reason}", file=sys.stderr)
    sys.exit(0)


def sample(ranges, count, seed):
    """Flat states as f32 bytes, and as rows."""
    draw = random.Random(seed)
    data = b"".join(struct.pack("<f", draw.uniform(low, high)) for _ in range(count) for low, high in ranges)
    values = struct.unpack(f"<{count * len(ranges)}f", data)
    return data, [values[i : i + len(ranges)] for i in range(0, len(values), len(ranges))]


class Candidate:
    """C that decides, in a folder of its own."""

    def __init__(self, work, name, sources, glue, includes=(), flags=()):
        self.name, self.folder = name, work / name.replace(" ", "-").replace(",", "")
        self.folder.mkdir()
        for file, text in sources.items():
            (self.folder / file).write_text(text)
        (self.folder / "glue.c").write_text(glue)
        (self.folder / "driver.c").write_text(DRIVER)
        self.flags = ["-std=c99", "-ffp-contract=off", "-I.", *[f"-I{path}" for path in includes], *flags]

    def flash(self):
        """Bytes of code and constants: the whole object without what only this comparison adds is not to be had for
        header-only code, so the glue counts for all alike."""
        run(["arm-none-eabi-gcc", *M4, *self.flags, "-Os", "-ffunction-sections", "-fdata-sections", "-c", "glue.c"], self.folder)
        kept = {"text": 0, "rodata": 0, "data": 0}
        for line in run(["arm-none-eabi-size", "-A", "glue.o"], self.folder).splitlines():
            words = line.split()
            for kind in kept:
                if words and (words[0] == f".{kind}" or words[0].startswith(f".{kind}.")):
                    kept[kind] += int(words[1])
        return sum(kept.values())

    def decide(self, states, count, length):
        """The actions, and nanoseconds a decision."""
        (self.folder / "states").write_bytes(states)
        gcc = ["gcc", *self.flags, "-D_POSIX_C_SOURCE=199309L", "-O2", "-o", "driver", "driver.c", "glue.c", "-lm"]
        run(gcc, self.folder)
        time = run(["./driver", "states", str(count), str(length), "actions"], self.folder)
        return (self.folder / "actions").read_bytes(), float(time)


def run(command, folder):
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: {done.stderr}")
    return done.stdout


def ours(work, shape, sources):
    prefix = "policy"
    options = ["--style", "gegelati"] if shape == "gegelati" else ["--profile", shape]
    folder = work / f"generated-{shape}"
    run([TOOL, GRAPH, "--lang", "c", "--prefix", prefix, *options, "-o", folder, "--no-verify"], ROOT)
    files = {path.name: path.read_text() for path in folder.iterdir()}
    if shape == "gegelati":
        names = ", ".join(f"*in{i + 1}" for i in range(len(sources)))
        starts = [sum(source["length"] for source in sources[:i]) for i in range(len(sources))]
        sets = " ".join(f"in{i + 1} = (float *)state + {start};" for i, start in enumerate(starts))
        glue = f'#include "{prefix}.c"\nfloat {names};\nint decide(const float *state) {{ {sets} return inferenceTPG(); }}\n'
    else:
        glue = f'#include "{prefix}.c"\nint decide(const float *s) {{ return {prefix}_infer((const {prefix}_state_t *)s); }}\n'
    return Candidate(work, f"this project, {shape}", files, glue, flags=["-DPOLICY_NO_SELFTEST"])


def table(actions):
    """Trees number the actions that occur; this leads back."""
    numbers = ", ".join(str(action) for action in actions)
    return f"static const unsigned char numbered[{len(actions)}] = {{ {numbers} }};"


def m2cgen_tree(work, tree, leaves, length, actions):
    import m2cgen

    classes = len(actions)
    glue = f"""
{table(actions)}
{m2cgen.export_to_c(tree)}
int decide(const float *state) {{
    double input[{length}], output[{classes}];
    int best = 0;
    for (int i = 0; i < {length}; i++) input[i] = state[i];
    score(input, output);
    for (int i = 1; i < {classes}; i++) if (output[i] > output[best]) best = i;
    return numbered[best];
}}
"""
    return Candidate(work, f"m2cgen tree, {leaves} leaves", {}, glue)


def emlearn_tree(work, tree, leaves, length, actions, method, scale):
    import emlearn

    converted = emlearn.convert(tree, method=method, dtype="int16_t")
    path = work / f"emlearn-{leaves}-{method}.h"
    converted.save(file=str(path), name="tree", format="c")
    glue = f"""
#include <math.h>
#include "tree.h"
{table(actions)}
int decide(const float *state) {{
    int16_t features[{length}];
    for (int i = 0; i < {length}; i++) features[i] = (int16_t)lrintf(state[i] * {scale:.1f}F);
    return numbered[tree_predict(features, {length})];
}}
"""
    name = f"emlearn tree ({method}), {leaves} leaves"
    return Candidate(work, name, {"tree.h": path.read_text()}, glue, includes=[emlearn.includedir])


def main():
    try:
        import emlearn  # noqa: F401
        import m2cgen  # noqa: F401
        import numpy
        from sklearn.tree import DecisionTreeClassifier
    except ImportError as error:
        skip(f"{error}; pip install m2cgen emlearn scikit-learn")
    for tool in ["gcc", "arm-none-eabi-gcc"]:
        if shutil.which(tool) is None:
            skip(f"no {tool}")
    global TOOL
    TOOL = Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else TOOL
    if not TOOL.is_file():
        skip(f"no {TOOL}: cargo build --release -p tpg-codegen")

    graph = json.loads(GRAPH.read_text())
    ranges = [pair for source in graph["sources"] for pair in source["ranges"]]
    length = len(ranges)
    scale = 32767.0 / max(abs(end) for pair in ranges for end in pair)
    near = [[low / 50, high / 50] for low, high in ranges]
    halves = [sample(ranges, TRAINING // 2, 1), sample(near, TRAINING // 2, 2)]
    training, training_rows = halves[0][0] + halves[1][0], halves[0][1] + halves[1][1]
    tests = [sample(ranges, TEST, 3)[0], sample(near, TEST, 4)[0]]
    rows = []
    with tempfile.TemporaryDirectory() as temporary:
        work = Path(temporary)
        shapes = [ours(work, shape, graph["sources"]) for shape in ["fast", "small", "constant-time", "gegelati"]]
        labels, _ = shapes[0].decide(training, TRAINING, length)
        expected = [shapes[0].decide(test, TEST, length)[0] for test in tests]
        candidates = list(shapes)
        actions, y = numpy.unique(numpy.frombuffer(labels, dtype=numpy.uint8), return_inverse=True)
        x = numpy.array(training_rows)
        for leaves in LEAVES:
            fit = lambda x: DecisionTreeClassifier(max_leaf_nodes=leaves, random_state=0).fit(x, y)
            candidates.append(m2cgen_tree(work, fit(x), leaves, length, actions))
            # emlearn's features are integers of 16 bits.
            whole = fit(numpy.rint(x * scale))
            for method in ["inline", "loadable"]:
                candidates.append(emlearn_tree(work, whole, leaves, length, actions, method, scale))
        for candidate in candidates:
            results = [candidate.decide(test, TEST, length) for test in tests]
            equal = [sum(map(int.__eq__, found, graphs)) for (found, _), graphs in zip(results, expected)]
            rows.append((candidate.name, candidate.flash(), results[0][1], *(100 * count / TEST for count in equal)))
    print("| | flash, bytes | ns a decision | equal actions, all ranges | near zero |")
    print("| --- | --- | --- | --- | --- |")
    for name, flash, time, everywhere, near_zero in rows:
        print(f"| {name} | {flash:,} | {time:.0f} | {everywhere:.2f} % | {near_zero:.2f} % |")


if __name__ == "__main__":
    main()
