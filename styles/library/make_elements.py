#!/usr/bin/env python3
"""Makes the meshes of the shipped elements: windows, doors and a ledge, as OBJ beside this script.

    make_elements.py            writes *.obj and elements.mtl
    make_elements.py --check    fails when they are not what would be written, or when a mesh is
                                not closed, faces inwards, or has two faces in one place

Metres; x to the right, y up, z out of the wall; the origin is the lower left corner at the back.
LOD1 is the finest. Frames and leaves are reliefs: a depth for every cell of a grid, closed to a
solid. Mouldings, sills and handles are prisms that stand on them.
"""
import math
import sys
from pathlib import Path

FOLDER = Path(__file__).resolve().parent

# Diffuse colour in sRGB, specular, shininess.
MATERIALS = {
    "frame": ((0.93, 0.92, 0.88), 0.1, 30),
    "glass": ((0.22, 0.29, 0.34), 0.6, 200),
    "handle": ((0.72, 0.57, 0.27), 0.5, 90),
    "leaf": ((0.13, 0.27, 0.24), 0.2, 40),
    "stone": ((0.74, 0.71, 0.65), 0.05, 10),
}


def main(arguments):
    elements = {name: make() for name, make in ELEMENTS.items()}
    files = {f"{name}.obj": obj(name, mesh) for name, mesh in elements.items()}
    files["elements.mtl"] = mtl()
    if arguments == ["--check"]:
        return check(elements, files)
    if arguments:
        print(__doc__, file=sys.stderr)
        return 2
    for name, text in files.items():
        (FOLDER / name).write_text(text, encoding="utf-8")
    print("\n".join(f"{name}.obj: {len(mesh)} faces" for name, mesh in elements.items()))
    return 0


# ---- The elements; a mesh is a list of (material, corners) --------------------------------------


def casement_window():
    """Two casements of three panes, lipped over the frame, and a sloped bottom rail."""
    relief = Relief(1.0, 1.4).fill(0, 0, 1, 1.4, 0.06, "frame")
    for left, handle in ((0.04, 0.445), (0.5, 0.54)):
        relief.fill(left, 0.05, left + 0.46, 1.36, 0.075, "frame")
        for row in range(3):
            bottom = 0.105 + row * (0.385 + 0.022)
            relief.fill(left + 0.055, bottom, left + 0.405, bottom + 0.385, 0.03, "glass")
    relief.fill(0.495, 0.05, 0.505, 1.36, 0.068, "frame")
    return relief.solid() + sloped_rail(1.0, 0.06) + box(0.46, 0.62, 0.075, 0.478, 0.74, 0.095, "handle")


def casement_window_far():
    relief = Relief(1.0, 1.4).fill(0, 0, 1, 1.4, 0.075, "frame")
    for left in (0.095, 0.555):
        relief.fill(left, 0.105, left + 0.35, 1.305, 0.03, "glass")
    return relief.solid()


def sash_window():
    """A box frame with two sashes of two by two panes, the upper one in front of the lower."""
    relief = Relief(1.0, 1.4).fill(0, 0, 1, 1.4, 0.09, "frame")
    for bottom, top, depth in ((0.045, 0.705, 0.05), (0.705, 1.35, 0.07)):
        relief.fill(0.055, bottom, 0.945, top, depth, "frame")
        width, low = 0.389, bottom + (0.065 if depth == 0.05 else 0.035)
        height = (top - (0.0 if depth == 0.05 else 0.045) - low - 0.022) / 2
        for left in (0.1, 0.511):
            for row in (0, 1):
                y = low + row * (height + 0.022)
                relief.fill(left, y, left + width, y + height, depth - 0.022, "glass")
    return relief.solid() + box(0.47, 0.705, 0.07, 0.53, 0.725, 0.085, "handle")


def sash_window_far():
    relief = Relief(1.0, 1.4).fill(0, 0, 1, 1.4, 0.08, "frame")
    relief.fill(0.1, 0.11, 0.9, 0.69, 0.025, "glass")
    relief.fill(0.1, 0.74, 0.9, 1.305, 0.045, "glass")
    return relief.solid()


def panelled_door():
    """Four fielded panels under a fanlight, a letter plate and a knob."""
    relief = door_frame(light_from=1.86)
    for left in (0.175, 0.525):
        for bottom, top in ((0.2, 0.78), (0.98, 1.66)):
            relief.fill(left, bottom, left + 0.3, top, 0.036, "leaf")
            relief.fill(left + 0.045, bottom + 0.045, left + 0.255, top - 0.045, 0.046, "leaf")
    plate = box(0.39, 0.85, 0.055, 0.61, 0.91, 0.06, "handle")
    return relief.solid() + threshold() + plate + knob(0.86, 0.97, 0.055)


def glazed_door():
    """Two panels below, two by three panes above, and a lever."""
    relief = door_frame(light_from=None)
    for left in (0.175, 0.525):
        relief.fill(left, 0.2, left + 0.3, 0.75, 0.036, "leaf")
        relief.fill(left + 0.045, 0.245, left + 0.255, 0.705, 0.046, "leaf")
    for column in (0, 1):
        for row in (0, 1, 2):
            left, bottom = 0.175 + column * 0.336, 0.95 + row * 0.336
            relief.fill(left, bottom, left + 0.314, bottom + 0.314, 0.03, "glass")
    lever = box(0.85, 1.0, 0.055, 0.88, 1.12, 0.062, "handle")
    lever += box(0.76, 1.055, 0.062, 0.87, 1.075, 0.085, "handle")
    return relief.solid() + threshold() + lever


def glazed_door_far():
    relief = door_frame(light_from=None)
    relief.fill(0.175, 0.95, 0.825, 1.936, 0.03, "glass")
    return relief.solid()


def ledge():
    """A stone sill: a sloped top between two level stools, and a drip groove under the nose."""
    groove = [((0, 0.015), (0.068, 0.015), (0.068, 0.079), (0, 0.1))]
    groove += [((0.068, 0.027), (0.084, 0.027), (0.084, 0.0738), (0.068, 0.079))]
    nose = [((0.084, 0), (0.1, 0), (0.1, 0.0686), (0.084, 0.0738))]
    return prism(groove + nose, 0, 1, "stone")


def ledge_far():
    return prism([((0, 0), (0.1, 0), (0.1, 0.07), (0, 0.1))], 0, 1, "stone")


ELEMENTS = {
    "window1LOD1": casement_window,
    "window1LOD2": casement_window_far,
    "window2LOD1": sash_window,
    "window2LOD2": sash_window_far,
    "door1": panelled_door,
    "door2LOD1": glazed_door,
    "door2LOD2": glazed_door_far,
    "windowLedge1LOD1": ledge,
    "windowLedge1LOD2": ledge_far,
}


def door_frame(light_from):
    """Jambs and head 1.0 m by 2.1 m, a leaf in them, and a fanlight from some height on."""
    relief = Relief(1.0, 2.1).fill(0, 0, 1, 2.1, 0.09, "frame")
    relief.fill(0.06, 0, 0.94, 2.04 if light_from is None else light_from, 0.055, "leaf")
    if light_from is not None:
        for left in (0.06, 0.36, 0.66):
            relief.fill(left, light_from + 0.06, left + 0.28, 2.04, 0.03, "glass")
    return relief


def threshold():
    """A worn stone step's edge between the jambs: level, then sloped to the front."""
    return prism([((0.055, 0), (0.09, 0), (0.09, 0.02), (0.055, 0.035))], 0.06, 0.94, "stone")


def sloped_rail(width, z):
    return prism([((z, 0), (z + 0.03, 0), (z + 0.03, 0.012), (z, 0.035))], 0, width, "frame")


def knob(x, y, z, radius=0.03, reach=0.03):
    """An eight-sided button."""
    ring = [(x + radius * math.cos(a), y + radius * math.sin(a))
            for a in (math.radians(22.5 + 45 * i) for i in range(8))]
    front = [(u, v, z + reach) for u, v in ring]
    back = [(u, v, z) for u, v in ring]
    sides = [[back[i], back[i - 7], front[i - 7], front[i]] for i in range(8)]
    return [("handle", corners) for corners in [front, back[::-1], *sides]]


# ---- Solids --------------------------------------------------------------------------------------


class Relief:
    """Rectangles painted over each other, each with its depth and material; later ones win."""

    def __init__(self, width, height):
        self.width, self.height, self.fills = width, height, []

    def fill(self, x0, y0, x1, y1, z, material):
        self.fills.append(tuple(round(v, 4) for v in (x0, y0, x1, y1, z)) + (material,))
        return self

    def solid(self):
        """Fronts, the steps between them, the four sides and the back."""
        xs = sorted({x for f in self.fills for x in (f[0], f[2])})
        ys = sorted({y for f in self.fills for y in (f[1], f[3])})
        cells = [[self.at((x0 + x1) / 2, (y0 + y1) / 2) for x0, x1 in zip(xs, xs[1:])]
                 for y0, y1 in zip(ys, ys[1:])]
        faces = [("frame", rectangle("z", 0, 0, 0, self.width, self.height)[::-1])]
        for (z, material), i0, j0, i1, j1 in merged(cells):
            faces.append((material, rectangle("z", z, xs[i0], ys[j0], xs[i1], ys[j1])))
        faces += steps("y", xs, ys, cells)
        return faces + steps("x", ys, xs, [list(column) for column in zip(*cells)])

    def at(self, x, y):
        for x0, y0, x1, y1, z, material in reversed(self.fills):
            if x0 < x < x1 and y0 < y < y1:
                return z, material
        raise ValueError(f"nothing at {x}, {y}")


def merged(cells):
    """Rectangles of equal cells: runs along a row, then equal runs of neighbouring rows."""
    open_runs, done = {}, []
    for j, row in enumerate([*cells, []]):
        runs, i = {}, 0
        while i < len(row):
            end = i
            while end < len(row) and row[end] == row[i]:
                end += 1
            key = (row[i], i, end)
            runs[key] = open_runs.pop(key, j)
            i = end
        done += [(cell, i0, since, i1, j) for (cell, i0, i1), since in open_runs.items()]
        open_runs = runs
    return done


def steps(axis, along, across, rows):
    """The faces between rows of different depth; beyond the first and the last row there is none."""
    void = [(0, None)] * len(rows[0])
    for value, before, after in zip(across, [void, *rows], [*rows, void]):
        for ((low, _), (high, _), material, up), i0, _, i1, _ in merged([
            [step_of(a, b) for a, b in zip(before, after)]]):
            if low != high:
                corners = rectangle(axis, value, along[i0], low, along[i1], high)
                yield material, corners if up else corners[::-1]


def step_of(a, b):
    """Lower side, higher side, the higher one's material, and whether the face looks onward."""
    return (a, b, b[1], False) if a[0] < b[0] else (b, a, a[1], True)


def rectangle(axis, value, u0, v0, u1, v1):
    """Counter-clockwise seen from the positive end of the axis; v is z for steps."""
    if axis == "z":
        return [(u0, v0, value), (u1, v0, value), (u1, v1, value), (u0, v1, value)]
    if axis == "x":
        return [(value, u0, v0), (value, u1, v0), (value, u1, v1), (value, u0, v1)]
    return [(u0, value, v0), (u0, value, v1), (u1, value, v1), (u1, value, v0)]


def box(x0, y0, z0, x1, y1, z1, material):
    return prism([((z0, y0), (z1, y0), (z1, y1), (z0, y1))], x0, x1, material)


def prism(profiles, x0, x1, material):
    """Convex profiles (z, y), counter-clockwise seen from the left, which may share edges, from x0 to
    x1."""
    faces = []
    edges = {(a, b) for p in profiles for a, b in zip(p, p[1:] + p[:1])}
    for profile in profiles:
        faces.append((material, [(x0, y, z) for z, y in profile]))
        faces.append((material, [(x1, y, z) for z, y in reversed(profile)]))
        for a, b in zip(profile, profile[1:] + profile[:1]):
            if (b, a) not in edges:
                faces.append((material, [(x0, a[1], a[0]), (x1, a[1], a[0]), (x1, b[1], b[0]),
                                         (x0, b[1], b[0])][::-1]))
    return faces
