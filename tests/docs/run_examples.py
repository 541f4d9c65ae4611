#!/usr/bin/env python3
"""Runs the scripts that people read: tests/docs/run_examples.py MANSARD docs|examples|format

docs: every block ```style of README.md and docs/*.md, but of the tutorial, which has a test of its
own, is checked and derived on rect:10x8; an error fails. A block that holds a style stands alone.
Any other is a fragment: blocks (`Tile { ... }`) or bare rules; it is put into a style whose
FOOTPRINT, unless the fragment has its own, is a mass of 6 m with the symbols FACADE and ROOF, so a
fragment has rules for one of these three.

examples: every script in examples/, but for the tutorial's, is run by the command that its comments
give after `run:`.

format: every script in examples/ and styles/library/ stands as `mansard format` lays it out, but for
the listings, which are kept as they were given.
"""
import re
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FENCE = re.compile(r"^```style\n(.*?)^```$", re.M | re.S)
HEAD = re.compile(r"\b(FOOTPRINT|FACADE|ROOF)\b[^|{}]*?->", re.S)
FACE_COUNT = re.compile(r"(\d+) polygons")


def blocks():
    """(where, text) of every block."""
    pages = sorted(set((ROOT / "docs").glob("*.md")) - {ROOT / "docs" / "tutorial.md"})
    for page in [ROOT / "README.md", *pages]:
        text = page.read_text(encoding="utf-8")
        for match in FENCE.finditer(text):
            line = text.count("\n", 0, match.start()) + 2
            yield f"{page.relative_to(ROOT)}:{line}", match.group(1)


def without_comments(text):
    return re.sub(r"//[^\n]*", "", text)


def script_of(text):
    bare = without_comments(text)
    if re.search(r"^\s*(final\s+)?(style|class)\s", bare, re.M):
        return text
    heads = {m.group(1) for m in HEAD.finditer(bare)}
    if not heads:
        raise ValueError("a fragment needs a rule of FOOTPRINT, FACADE or ROOF")
    is_blocks = re.match(r"\s*(Elements|Materials|\w+)\s*\{", bare)
    start = ("" if "FOOTPRINT" in heads else
             "Start { FOOTPRINT -> extrude(6) comp { side : FACADE | top : ROOF } }\n")
    body = text if is_blocks else "Rules {\n" + text + "}\n"
    return "style Example {\n" + start + body + "}\n"


def run(mansard, words, where):
    """The problem, or None."""
    done = subprocess.run([mansard, *words], cwd=ROOT, capture_output=True, text=True, timeout=60)
    drawn = FACE_COUNT.search(done.stderr)
    if done.returncode == 0 and drawn and drawn.group(1) == "0":
        return f"{where}: nothing was drawn\n{done.stderr}"
    if done.returncode == 0:
        return None
    return f"{where}: mansard {shlex.join(words)} exits with {done.returncode}\n{done.stderr}{done.stdout}"


def run_docs(mansard, folder):
    def one(numbered):
        number, (where, text) = numbered
        path = folder / f"block_{number}.style"
        try:
            path.write_text(script_of(text), encoding="utf-8")
        except ValueError as problem:
            return f"{where}: {problem}"
        model = str(folder / f"block_{number}.obj")
        return (run(mansard, ["check", str(path)], where)
                or run(mansard, ["derive", str(path), "rect:10x8", "-o", model], where))

    with ThreadPoolExecutor(2) as pool:
        return list(pool.map(one, enumerate(blocks())))


def run_examples(mansard, folder):
    def one(path):
        where = path.relative_to(ROOT)
        command = re.search(r"run:\s*mansard (.*)", path.read_text(encoding="utf-8"))
        if not command:
            return f"{where}: no comment says how to run it (// run: mansard derive ...)"
        words = shlex.split(command.group(1))
        if "-o" in words:
            out = words.index("-o") + 1
            words[out] = str(folder / Path(words[out]).name)
        return run(mansard, ["check", str(where)], where) or run(mansard, words, where)

    with ThreadPoolExecutor(2) as pool:
        tutorial = ROOT / "examples" / "tutorial"
        scripts = set((ROOT / "examples").rglob("*.style")) - set(tutorial.glob("*.style"))
        return list(pool.map(one, sorted(scripts)))


def check_format(mansard, _):
    scripts = [path for folder in ("examples", "styles/library")
               for path in sorted((ROOT / folder).rglob("*.style")) if path.name != "listings.style"]

    def one(path):
        return run(mansard, ["format", "--check", "--diff", str(path)], path.relative_to(ROOT))

    return [one(path) for path in scripts]


def main():
    mansard, what = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        results = {"docs": run_docs, "examples": run_examples, "format": check_format}[what](mansard, Path(folder))
    problems = [p for p in results if p]
    print("\n".join(problems))
    print(f"{what}: {len(results)} scripts, {len(problems)} fail")
    return 1 if problems or not results else 0


if __name__ == "__main__":
    sys.exit(main())
