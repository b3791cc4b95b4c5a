"""Asks bitwuzla about scripts of SMT-LIB, which lines `;` separate, and prints its answers, one a line.

usage: solve.py FILE
"""

import multiprocessing
import pathlib
import re
import sys

import bitwuzla

MILLISECONDS = 30_000


def solve(script):
    options = bitwuzla.Options()
    options.set(bitwuzla.Option.TIME_LIMIT_PER, MILLISECONDS)
    parser = bitwuzla.Parser(bitwuzla.TermManager(), options)
    parser.parse(script, parse_only=True, parse_file=False)
    return str(parser.bitwuzla().check_sat()).rsplit(".")[-1].lower()


def cases(script):
    """Splits a script where conditions choose, and where zeros are added, which spares solvers most of the work."""
    scripts = [script]
    for name in sorted(set(re.findall(r"\(ite (?:\(not )?(n\d+)", script))):
        known = [f"(assert {{0}})\n(define-fun {name} () Bool true)", f"(assert (not {{0}}))\n(define-fun {name} () Bool false)"]
        scripts = split(scripts, rf"\(define-fun {name} \(\) Bool (?P<term>.*)\)", known)
    for zero in re.findall(r"\(define-fun (n\d+) \(\) Float32 \(\(_ to_fp 8 24\) #x00000000\)\)", script):
        for name, x in re.findall(rf"\(define-fun (n\d+) \(\) Float32 \(fp.add RNE (?:{zero} )?(n\d+)(?: {zero})?\)\)", script):
            same, zeros = f"(= {{0}} {x})", f"(and (= {x} (_ -zero 8 24)) (= {{0}} {zero}))"
            kinds = [
                f"(assert {same})\n(define-fun {name} () Float32 {x})",
                f"(assert {zeros})\n(define-fun {name} () Float32 {zero})",
                f"(assert (not (or {same} {zeros})))\n(define-fun {name} () Float32 {{0}})",
            ]
            scripts = split(scripts, rf"\(define-fun {name} \(\) Float32 (?P<term>.*)\)", kinds)
    return scripts


def split(scripts, definition, kinds):
    """Replaces a definition by each of the kinds that there are."""
    return [
        re.sub(definition, lambda found: kind.format(found["term"]), script) for script in scripts for kind in kinds
    ]


def answer(script):
    answers = {solve(case) for case in cases(script)}
    return "unsat" if answers == {"unsat"} else "sat" if "sat" in answers else "unknown"


if __name__ == "__main__":
    scripts = pathlib.Path(sys.argv[1]).read_text().split("\n;\n")
    with multiprocessing.Pool() as pool:
        for text in pool.imap(answer, scripts, chunksize=16):
            print(text)
