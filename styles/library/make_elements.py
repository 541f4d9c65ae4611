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
from itertools import groupby
from pathlib import Path

sys.dont_write_bytecode = True  # no folder of caches in the shipped library
from solids import Relief, box, faults_of, normal, prism

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
    files = {f"{name}.obj": obj(name, solids) for name, solids in elements.items()}
    files["elements.mtl"] = mtl()
    if arguments == ["--check"]:
        return check(elements, files)
    if arguments:
        print(__doc__, file=sys.stderr)
        return 2
    for name, text in files.items():
        (FOLDER / name).write_text(text, encoding="utf-8")
    for name, solids in elements.items():
        print(f"{name}.obj: {sum(map(len, solids))} faces")
    return 0


def check(elements, files):
    faults = [
        f"{name} is not what this script makes"
        for name, text in files.items()
        if not (FOLDER / name).exists() or (FOLDER / name).read_text("utf-8") != text
    ]
    for name, solids in elements.items():
        faults += [f"{name}: {fault}" for fault in faults_of(solids)]
    cube = box(0, 0, 0, 1, 1, 1, "stone")
    inside_out = [(material, corners[::-1]) for material, corners in cube]
    for spoilt in ([cube[1:]], [inside_out], [cube, box(0.5, 0.5, 0.5, 2, 2, 1, "stone")]):
        if not list(faults_of(spoilt)):
            faults.append("the check is blind")
    print("\n".join(faults) or f"{len(elements)} elements are fresh, closed and face outwards")
    return 1 if faults else 0


def casement_window():
    """Two casements of three panes, lipped over the frame, and a sloped bottom rail."""
    relief = Relief(1.0, 1.4).fill(0, 0, 1, 1.4, 0.06, "frame")
    for left in (0.04, 0.5):
        relief.fill(left, 0.05, left + 0.46, 1.36, 0.075, "frame")
        for row in range(3):
            bottom = 0.105 + row * (0.385 + 0.022)
            relief.fill(left + 0.055, bottom, left + 0.405, bottom + 0.385, 0.03, "glass")
    relief.fill(0.495, 0.05, 0.505, 1.36, 0.068, "frame")
    handle = box(0.46, 0.62, 0.075, 0.478, 0.74, 0.095, "handle")
    return [relief.solid(), sloped_rail(0, 1, 0.06), handle]


def casement_window_far():
    relief = Relief(1.0, 1.4).fill(0, 0, 1, 1.4, 0.075, "frame")
    for left in (0.095, 0.555):
        relief.fill(left, 0.105, left + 0.35, 1.305, 0.03, "glass")
    return [relief.solid()]


def sash_window():
    """A box frame with two sashes of two by two panes, the upper one in front of the lower."""
    relief = Relief(1.0, 1.4).fill(0, 0, 1, 1.4, 0.09, "frame")
    relief.fill(0.055, 0, 0.945, 0.045, 0.06, "frame")
    for bottom, top, depth, panes in ((0.045, 0.705, 0.05, 0.11), (0.705, 1.35, 0.07, 0.74)):
        relief.fill(0.055, bottom, 0.945, top, depth, "frame")
        height = (min(top, 1.305) - panes - 0.022) / 2
        for left in (0.1, 0.511):
            for y in (panes, panes + height + 0.022):
                relief.fill(left, y, left + 0.389, y + height, depth - 0.022, "glass")
    return [relief.solid(), sloped_rail(0.055, 0.945, 0.06)]


def sash_window_far():
    relief = Relief(1.0, 1.4).fill(0, 0, 1, 1.4, 0.08, "frame")
    relief.fill(0.1, 0.11, 0.9, 0.69, 0.025, "glass")
    relief.fill(0.1, 0.74, 0.9, 1.305, 0.045, "glass")
    return [relief.solid()]


def panelled_door():
    """Four fielded panels under a fanlight, a letter plate and a knob."""
    relief = door_frame(light_from=1.86)
    for left in (0.175, 0.525):
        for bottom, top in ((0.2, 0.78), (0.98, 1.66)):
            relief.fill(left, bottom, left + 0.3, top, 0.036, "leaf")
            relief.fill(left + 0.045, bottom + 0.045, left + 0.255, top - 0.045, 0.046, "leaf")
    plate = box(0.39, 0.85, 0.055, 0.61, 0.91, 0.06, "handle")
    return [relief.solid(), threshold(), plate, knob(0.86, 0.97, 0.055)]


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
    plate = box(0.85, 1.0, 0.055, 0.88, 1.12, 0.062, "handle")
    lever = box(0.79, 1.055, 0.062, 0.87, 1.075, 0.085, "handle")
    return [relief.solid(), threshold(), plate, lever]


def glazed_door_far():
    relief = door_frame(light_from=None)
    relief.fill(0.175, 0.95, 0.825, 1.936, 0.03, "glass")
    return [relief.solid()]


def ledge():
    """A stone sill: a sloped top between two level stools, and a drip groove under the nose."""
    outline = ((0, 0.015), (0.068, 0.015), (0.068, 0.027), (0.084, 0.027), (0.084, 0), (0.1, 0))
    outline += ((0.1, 0.07), (0, 0.1))
    ends = [
        ((0, 0.015), (0.068, 0.015), (0.068, 0.0796), (0, 0.1)),
        ((0.068, 0.027), (0.084, 0.027), (0.084, 0.0748), (0.068, 0.0796)),
        ((0.084, 0), (0.1, 0), (0.1, 0.07), (0.084, 0.0748)),
    ]
    stool = ((0, 0.1), (0.1, 0.07), (0.1, 0.1))
    return [
        prism(outline, 0, 1, "stone", ends),
        prism(stool, 0, 0.06, "stone"),
        prism(stool, 0.94, 1, "stone"),
    ]


def ledge_far():
    return [prism(((0, 0), (0.1, 0), (0.1, 0.07), (0, 0.1)), 0, 1, "stone")]


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
    return prism(((0.055, 0), (0.09, 0), (0.09, 0.02), (0.055, 0.035)), 0.06, 0.94, "stone")


def sloped_rail(x0, x1, z):
    return prism(((z, 0), (z + 0.03, 0), (z + 0.03, 0.012), (z, 0.035)), x0, x1, "frame")


def knob(x, y, z, radius=0.03, reach=0.03):
    """An eight-sided button."""
    ring = [
        (x + radius * math.cos(a), y + radius * math.sin(a))
        for a in (math.radians(22.5 + 45 * i) for i in range(8))
    ]
    front = [(u, v, z + reach) for u, v in ring]
    back = [(u, v, z) for u, v in ring]
    sides = [[back[i - 1], back[i], front[i], front[i - 1]] for i in range(8)]
    return [("handle", corners) for corners in [front, back[::-1], *sides]]


def obj(name, solids):
    """Flat normals, faces grouped by material."""
    points, normals, lines = {}, {}, []
    faces = sorted((face for solid in solids for face in solid), key=lambda face: face[0])
    for material, group in groupby(faces, key=lambda face: face[0]):
        lines.append(f"usemtl {material}")
        for _, corners in group:
            n = normals.setdefault(triple(normal(corners)), len(normals) + 1)
            indices = [points.setdefault(triple(c), len(points) + 1) for c in corners]
            lines.append("f " + " ".join(f"{p}//{n}" for p in indices))
    head = ["# Made by make_elements.py.", "mtllib elements.mtl", f"o {name}"]
    head += [f"v {p}" for p in points] + [f"vn {n}" for n in normals]
    return "\n".join(head + lines) + "\n"


def triple(vector):
    return " ".join(f"{round(v, 6) + 0.0:g}" for v in vector)


def mtl():
    lines = ["# Made by make_elements.py."]
    for name, (colour, specular, shininess) in MATERIALS.items():
        lines += [f"newmtl {name}", "Kd %g %g %g" % colour, "Ks %g %g %g" % ((specular,) * 3)]
        lines += [f"Ns {shininess}"]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
