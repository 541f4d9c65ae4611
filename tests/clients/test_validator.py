#!/usr/bin/env python3
"""Khronos's validator has nothing to say of what Mansard writes: tests/clients/test_validator.py MANSARD

Every example and library style as .glb, some as .gltf, instanced and compressed. Skipped (77) where
node or the validator is missing; scripts/setup installs the validator into build/npm. A folder of
modules of one's own: MANSARD_NODE_MODULES.
"""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RUN = re.compile(r"^// run: mansard (derive .*)$", re.M)
# The validator knows neither extension and says so, and that nothing it knows reads these accessors.
GPU = {"UNSUPPORTED_EXTENSION", "UNUSED_OBJECT"}
DRACO = {"UNSUPPORTED_EXTENSION", "UNUSED_OBJECT"}


def modules():
    for folder in (os.environ.get("MANSARD_NODE_MODULES"), ROOT / "build" / "npm" / "node_modules"):
        if folder and (Path(folder) / "gltf-validator").is_dir():
            return Path(folder).parent
    return None


def models(folder):
    """(file, words for mansard, codes that the validator may say) of every model."""
    for script in sorted((ROOT / "examples").rglob("*.style")):
        commands = RUN.findall(script.read_text(encoding="utf-8"))
        for number, command in enumerate(commands):
            words = command.split()
            at = words.index("-o") + 1
            file = folder / f"{script.stem}_{number}.glb"
            yield file, words[:at] + [file] + words[at + 1:], set()
    for script in sorted((ROOT / "styles" / "library").glob("*.style")):
        if script.stem in ("building", "roofs"):
            continue  # derived by the others
        for plot in ("rect:12x10", "L:16x14x7x6"):
            file = folder / f"{script.stem}_{plot[0]}.glb"
            yield file, ["derive", script, plot, "--attr", "height=12", "-o", file], set()
    quarter = ["derive", ROOT / "examples/quarter/quarter.style",
               ROOT / "examples/quarter/footprints.geojson", "--limit", "20", "-o"]
    for name, flags, codes in (("text.gltf", [], set()),
                               ("copies.glb", ["--instancing", "none"], set()),
                               ("gpu.glb", ["--instancing", "gpu"], GPU),
                               ("draco.glb", ["--compress", "draco"], DRACO),
                               ("both.gltf", ["--instancing", "gpu", "--compress", "draco"],
                                GPU | DRACO),
                               ("far_lod1.glb", ["--lod", "1"], set())):
        yield folder / name, [*quarter, folder / name, *flags], codes


def derive(mansard, words):
    done = subprocess.run([mansard, *words, "--quiet"], cwd=ROOT, capture_output=True, text=True,
                          timeout=120)
    return "" if done.returncode == 0 else f"{' '.join(map(str, words))}: {done.stderr}"


def main():
    mansard = Path(sys.argv[1]).resolve()
    found = modules()
    if not shutil.which("node") or not found:
        print("skipped: node or gltf-validator is missing; scripts/setup installs the validator "
              "where there is npm")
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        all_models = list(models(folder))
        with ThreadPoolExecutor(2) as pool:
            problems = [p for p in pool.map(lambda m: derive(mansard, m[1]), all_models) if p]
        files = [str(file) for file, _, _ in all_models if file.exists()]
        done = subprocess.run(["node", Path(__file__).with_name("validate.mjs"), found, *files],
                              capture_output=True, text=True, timeout=300)
        if done.returncode != 0:
            problems.append(done.stderr)
        allowed = {str(file): codes for file, _, codes in all_models}
        reports = [json.loads(line) for line in done.stdout.splitlines()]
        for report in reports:
            problems += [f"{Path(report['file']).name}: {m['code']}: {m['message']} ({m.get('pointer', m.get('offset'))})"
                         for m in report["messages"] if m["code"] not in allowed[report["file"]]]
    if len(reports) != len(all_models) or not reports:
        problems.append(f"{len(reports)} of {len(all_models)} models were validated")
    triangles = sum(report.get("info", {}).get("totalTriangleCount", 0) for report in reports)
    print("\n".join(problems[:50]) or
          f"{len(reports)} models, {triangles} triangles: no message of any severity")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
