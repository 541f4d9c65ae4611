#!/usr/bin/env python3
"""Blender and three.js see what Mansard wrote: tests/clients/test_clients.py MANSARD

Some .glb files are opened in Blender without a window and in three.js in Chromium without one. The
nodes, meshes, materials and triangles that each finds are those in the file, and the triangles those
of Mansard's report. Their silhouettes are that of `mansard render` of the file, and this one that of
an .obj: what a writer turned about, all would see alike.

What is missing is skipped, the whole test (77) where neither is there: Blender and Chromium are large
and installed by hand (apt-get install blender chromium), three.js by scripts/setup into build/npm.
A folder of modules of one's own: MANSARD_NODE_MODULES.
"""
import base64
import json
import math
import os
import queue
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

from glb import Glb
from masks import agreement, channel_of, mask

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SIZE = (1200, 800)
LEAST = 0.995  # of two silhouettes: what a sixth of a pixel along their borders leaves

QUARTER = ["examples/quarter/quarter.style", "examples/quarter/footprints.geojson", "--limit", "20"]
ARMS = ["tests/clients/arms.style", "WKT:POLYGON((0 0, 9 2, 10 9, 4 7, 0 0))"]
# name: words for `mansard derive`, and whose silhouette it has where not every program can read it
MODELS = {
    "quarter": (QUARTER, None),
    "both": ([*QUARTER, "--instancing", "gpu", "--compress", "draco"], "quarter"),
    "elements": (ARMS, None),
    "gpu": ([*ARMS, "--instancing", "gpu"], "elements"),
    "draco": ([*ARMS, "--compress", "draco"], "elements"),
    "library": (["styles/library/haussmann.style", "L:16x14x7x6"], None),
    "stains": (["examples/weathered.style", "rect:9.6x8"], None),
}


def modules():
    for folder in (os.environ.get("MANSARD_NODE_MODULES"), ROOT / "build" / "npm" / "node_modules"):
        if folder and (Path(folder) / "three").is_dir():
            return Path(folder)
    return None


def camera_for(low, high):
    """From the south-east, as near as shows all of the box, and from just below the ground, so that
    nothing but sky lies behind the model in `mansard render`: whose lens this is. Metres, y up."""
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    box = [[(low, high)[k >> i & 1][i] for i in range(3)] for k in range(8)]
    away = math.dist(low, high) / 2
    while True:
        eye = [middle[0] + 0.5 * away, low[1] - 0.02, middle[2] + 0.85 * away]
        camera = {"eye": eye, "target": middle, "degrees": 35, "far": 10 * away, "size": SIZE}
        if all(is_in_picture(camera, corner) for corner in box):
            return camera
        away *= 1.02


def is_in_picture(camera, point):
    tangent = 0.97 * math.tan(math.radians(camera["degrees"] / 2))
    forward = [b - a for a, b in zip(camera["eye"], camera["target"])]
    right = [-forward[2], 0, forward[0]]
    up = [-right[2] * forward[1], right[2] * forward[0] - right[0] * forward[2], right[0] * forward[1]]
    ray = [b - a for a, b in zip(camera["eye"], point)]
    along, across, above = (dot(ray, axis) / math.hypot(*axis) for axis in (forward, right, up))
    width, height = camera["size"]
    return abs(above) < tangent * along and abs(across) < tangent * along * width / height


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


class Model:
    """A file, and what it and Mansard say of it."""

    def __init__(self, mansard, folder, name):
        words, self.twin = MODELS[name]
        self.name, self.path = name, folder / f"{name}.glb"
        report = folder / f"{name}.json"
        run([mansard, "derive", *words, "-o", self.path, "--report", report, "--quiet"])
        self.glb, self.report = Glb(self.path), json.loads(report.read_text())

    def draw(self, mansard, folder):
        """Silhouettes by `mansard render`, of copies without colours: .glb and .obj."""
        self.camera = camera_for(*self.glb.bounds())
        black, obj = folder / f"{self.name}_black.glb", folder / f"{self.name}.obj"
        self.glb.write_black(black)
        run([mansard, "derive", *MODELS[self.name][0], "-o", obj, "--quiet"])
        obj.write_text(re.sub("^usemtl .*", "usemtl black", obj.read_text(), flags=re.M))
        obj.with_suffix(".mtl").write_text("newmtl black\nKd 0 0 0\n")
        self.mask, self.mask_of_obj = (self._drawn(mansard, model) for model in (black, obj))

    def _drawn(self, mansard, model):
        picture = model.with_suffix(".png")
        view = ",".join(repr(v) for v in self.camera["eye"] + self.camera["target"])
        run([mansard, "render", model, f"--camera={view}", "--size", "%dx%d" % SIZE, "-o", picture,
             "--quiet"])
        # Ink is drawn half a pixel beyond the border: a pixel is the model's where most is dark.
        return mask(channel_of(picture.read_bytes(), 2)[1], lambda blue: blue < 130)

    def job(self, model, picture=None):
        return {"model": str(model), "picture": str(picture), "camera": self.camera}


def run(words, environment=None):
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, timeout=120, env=environment)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, words))}: {done.stderr}{done.stdout[-2000:]}")
    return done.stdout


def in_blender(models, folder):
    """(counts, silhouette) of each model."""
    pictures = [folder / f"{model.name}_blender.png" for model in models]
    jobs = folder / "blender.json"
    jobs.write_text(json.dumps([m.job(m.path, p) for m, p in zip(models, pictures)]))
    # Its Python takes its modules from beside the first python3 of the PATH: Debian's, not another.
    debian = os.environ | {"PATH": "/usr/bin:" + os.environ["PATH"]}
    said = run(["blender", "-b", "--python-exit-code", "1", "--python", HERE / "in_blender.py", "--", jobs],
               debian)
    counts = [json.loads(line[6:]) for line in said.splitlines() if line.startswith("COUNTS")]
    shapes = [mask(channel_of(p.read_bytes(), 3)[1], lambda opacity: opacity > 127) for p in pictures]
    return list(zip(counts, shapes, strict=True))


class Page(SimpleHTTPRequestHandler):
    """Serves the page, three.js, the models and the jobs, and takes the answers."""

    def __init__(self, folder, found, jobs, answers, *rest):
        self.folder, self.found, self.jobs, self.answers = folder, found, jobs, answers
        super().__init__(*rest)

    def translate_path(self, path):
        first, _, rest = path.lstrip("/").partition("/")
        folders = {"modules": self.found, "models": self.folder}
        return str(folders[first] / rest if first in folders else HERE / "in_three.html")

    def do_GET(self):
        if self.path != "/jobs.json":
            return super().do_GET()
        self.answer(json.dumps(self.jobs).encode())

    def do_POST(self):
        self.answers.put(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
        self.answer(b"")

    def answer(self, body):
        self.send_response(200)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_):
        pass


def in_three(models, folder):
    """(counts, silhouette) of each model."""
    answers = queue.Queue()
    jobs = [model.job(f"/models/{model.path.name}") for model in models]
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Page, folder, modules(), jobs, answers))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    browser = subprocess.Popen(
        ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--use-angle=swiftshader",
         "--enable-unsafe-swiftshader", "--no-first-run", "--disable-background-networking",
         f"--user-data-dir={folder / 'chromium'}", f"http://127.0.0.1:{server.server_port}/"],
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    try:
        found = [answers.get(timeout=120) for _ in models]
    finally:
        os.killpg(browser.pid, signal.SIGKILL)
        browser.wait()
        server.shutdown()
        server.server_close()
    for model, answer in zip(models, found):
        if "problem" in answer:
            raise RuntimeError(f"{model.name} in three.js: {answer['problem']}")
    return [(a["counts"], mask(channel_of(base64.b64decode(a["picture"]), 0)[1], lambda red: red > 127))
            for a in found]


def compare(program, models, found):
    """Prints a line a model; returns what does not agree."""
    problems = []
    for model, (counts, shape) in zip(models, found, strict=True):
        wanted = model.glb.counts()
        alike = agreement(shape, model.mask)
        print(f"{program:8} {model.name:9} " + " ".join(f"{n} {k}," for k, n in counts.items()) +
              f" silhouette {alike:.4f}", flush=True)
        if counts != wanted:
            problems.append(f"{model.name} in {program}: {counts}, and the file has {wanted}")
        if alike < LEAST:
            problems.append(f"{model.name} in {program}: the silhouette agrees by {alike:.4f} only")
    return problems


def compare_with_obj(model):
    alike = agreement(model.mask, model.mask_of_obj)
    print(f"Mansard  {model.name:9} .glb and .obj, silhouette {alike:.4f}", flush=True)
    return [] if alike >= LEAST else [f"{model.name}: .glb and .obj agree by {alike:.4f} only"]


def compare_with_report(model):
    """Each polygon of n corners is n - 2 triangles, each building a root of the scene."""
    said = {"triangles": model.report["vertices"] - 2 * model.report["polygons"],
            "buildings": model.report["buildings"]}
    held = {"triangles": model.glb.counts()["triangles"], "buildings": len(model.glb.roots())}
    return [] if said == held else [f"{model.name}: the file has {held}, and the report says {said}"]


def main():
    mansard = Path(sys.argv[1]).resolve()
    has_blender = shutil.which("blender")
    has_three = shutil.which("chromium") and modules()
    if not has_blender:
        print("without Blender: apt-get install blender")
    if not has_three:
        print("without three.js: apt-get install chromium npm, then scripts/setup")
    if not has_blender and not has_three:
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        models = {name: Model(mansard, folder, name) for name in MODELS}
        plain = [model for model in models.values() if model.twin is None]
        for model in plain:
            model.draw(mansard, folder)
        problems = [p for model in plain for p in compare_with_obj(model)]
        for model in models.values():
            if model.twin:
                model.camera, model.mask = models[model.twin].camera, models[model.twin].mask
        problems += [p for model in models.values() for p in compare_with_report(model)]
        if has_blender:  # 3.4 refuses the extension for instances, and Debian builds it without Draco
            problems += compare("Blender", plain, in_blender(plain, folder))
        if has_three:
            everything = list(models.values())
            problems += compare("three.js", everything, in_three(everything, folder))
    print("\n".join(problems) or "all agree")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
