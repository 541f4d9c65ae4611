#!/usr/bin/env python3
"""Keeps what the docs show of the program true: tests/docs/run_consoles.py MANSARD [--update]

In every block ```console of README.md and docs/*.md a line `$ mansard WORDS` is run in the project's
folder, and the lines up to the next `$` must be what it prints. --update writes them anew.
"""
import re
import shlex
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FENCE = re.compile(r"^```console\n(.*?)^```$", re.M | re.S)
PROMPT = "$ mansard "


def printed(mansard, command):
    words = shlex.split(command[len(PROMPT):])
    done = subprocess.run([mansard, *words], cwd=ROOT, capture_output=True, text=True, timeout=60)
    return done.stdout + done.stderr


def rerun(mansard, block):
    """The block with what its commands print now."""
    commands = [line for line in block.splitlines() if line.startswith(PROMPT)]
    return "\n".join(f"{command}\n{printed(mansard, command)}" for command in commands)


def first_difference(shown, now):
    for old, new in zip(shown.splitlines() + [""], now.splitlines() + [""]):
        if old != new:
            return f"  the page: {old}\n  now:      {new}"
    return "  the one is longer than the other"


def main():
    mansard, update = sys.argv[1], "--update" in sys.argv
    blocks, problems = 0, []
    for page in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]:
        text = page.read_text(encoding="utf-8")
        new_text = text
        for match in FENCE.finditer(text):
            blocks += 1
            now = rerun(mansard, match.group(1))
            if now == match.group(1):
                continue
            line = text.count("\n", 0, match.start()) + 2
            problems.append(f"{page.relative_to(ROOT)}:{line}: not what the program prints\n"
                            + first_difference(match.group(1), now))
            new_text = new_text.replace(match.group(0), f"```console\n{now}```")
        if update and new_text != text:
            page.write_text(new_text, encoding="utf-8")
    print("\n".join(problems))
    print(f"consoles: {blocks} blocks, {len(problems)} " + ("written anew" if update else "differ"))
    return 1 if (problems and not update) or blocks == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
