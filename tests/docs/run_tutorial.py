#!/usr/bin/env python3
"""Does what docs/tutorial.md tells its readers: tests/docs/run_tutorial.py MANSARD

Every step names its finished script at its end. What the step shows must stand in that script, and
what is new in the script since the step before must be shown. The script must be free of errors and
warnings. Every command is run with it as house.style; one that imports the script of the step before
is mine.style beside that. Output that is shown must be what comes out
(a comment `<!-- script: FILE -->` before it says that another script makes it). Pictures must be
there.
"""
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import textwrap
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "tutorial.md"
SCRIPTS = ROOT / "examples" / "tutorial"
STEP = re.compile(r"^## \d+\. (.*?)$(.*?)(?=^## )", re.M | re.S)
LINK = re.compile(r"^\[(examples/tutorial/\w+\.style)\]\(\.\./\1\)$", re.M)
SHOWN = re.compile(r"^```style\n(.*?)^```$", re.M | re.S)
PICTURE = re.compile(r"!\[.*?\]\((.*?)\)")
COMMAND = re.compile(
    r"^    (mansard [^\n]*)$(?:\s*(?:<!-- script: (\S+) -->\n)?```text\n(.*?)^```$)?", re.M | re.S)


def main():
    mansard = Path(sys.argv[1]).resolve()
    problems, commands, before, last = [], 0, "", ""
    steps = STEP.findall(PAGE.read_text(encoding="utf-8"))
    used = {ROOT / name for name in re.findall(r"<!-- script: (\S+) -->", PAGE.read_text())}
    for title, text in steps:
        links = LINK.findall(text)
        if len(links) != 1 or not (ROOT / links[0]).is_file():
            problems.append(f"{title}: names no script at its end")
            continue
        script = ROOT / links[0]
        used.add(script)
        now = script.read_text(encoding="utf-8")
        own = f'import "{last}"' in now
        now = now.replace(f'import "{last}"', 'import "house.style"')
        name, last = "mine.style" if own else "house.style", script.name
        problems += [f"{title}: {p}" for p in difference(SHOWN.findall(text), now, before)]
        problems += [f"{title}: there is no {p}" for p in PICTURE.findall(text)
                     if not (PAGE.parent / p).is_file()]
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(SCRIPTS / "street.geojson", folder)
            (Path(folder) / "house.style").write_text(before, encoding="utf-8")
            for command, other, output in COMMAND.findall(text):
                commands += 1
                text = (ROOT / other).read_text(encoding="utf-8") if other else now
                (Path(folder) / name).write_text(text, encoding="utf-8")
                problems += [f"{title}: {p}" for p in run(mansard, command, output, folder)]
            (Path(folder) / name).write_text(now, encoding="utf-8")
            problems += [f"{title}: {p}" for p in
                         run(mansard, f"mansard check {name}", f"{name}: no errors\n", folder)]
        before = now
    problems += [f"{p.name} is in no step" for p in set(SCRIPTS.glob("*.style")) - used]
    print("\n".join(problems))
    print(f"tutorial: {len(steps)} steps, {commands} commands, {len(problems)} problems")
    return 1 if problems or len(steps) < 10 or commands < 15 else 0


def difference(shown, now, before):
    """What is shown but not there, and what is new but not shown."""
    lines = now.splitlines()
    for block in shown:
        wanted = textwrap.dedent(block)
        count = len(block.splitlines())
        windows = ("\n".join(lines[i:i + count]) + "\n" for i in range(len(lines)))
        if not any(textwrap.dedent(window) == wanted for window in windows):
            yield f"shows what is not in its script:\n{block}"
    told = {line.strip() for block in shown for line in block.splitlines()}
    known = {line.strip() for line in before.splitlines()}
    for line in lines:
        if line.strip() and line.strip() not in known | told:
            yield f"does not show its new line:\n{line}"


def run(mansard, command, output, folder):
    words = shlex.split(command)[1:]
    if words[0] in ("render", "vary"):
        words += ["--size", "48x32"]
    done = subprocess.run([mansard, *words], cwd=folder, capture_output=True,
                          encoding="utf-8", timeout=60)
    said = done.stdout + done.stderr
    if done.returncode != (1 if "error:" in output else 0):
        yield f"{command} exits with {done.returncode}\n{said}"
    elif output and said != output:
        yield f"{command} says\n{said}and not\n{output}"
    elif "warning" in said:
        yield f"{command} warns\n{said}"
    if "-o" in words and not (Path(folder) / words[words.index("-o") + 1]).is_file():
        yield f"{command} writes nothing"


if __name__ == "__main__":
    sys.exit(main())
