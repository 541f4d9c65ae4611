"""Solids as lists of (material, corners): reliefs, prisms, and whether a solid is sound."""
import math
from itertools import groupby


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
        cells = [
            [self.at((x0 + x1) / 2, (y0 + y1) / 2) for x0, x1 in zip(xs, xs[1:])]
            for y0, y1 in zip(ys, ys[1:])
        ]
        faces = [("frame", rectangle("z", 0, 0, 0, self.width, self.height)[::-1])]
        for (z, material), i0, j0, i1, j1 in merged(cells):
            faces.append((material, rectangle("z", z, xs[i0], ys[j0], xs[i1], ys[j1])))
        faces += list(steps("y", xs, ys, cells))
        return faces + list(steps("x", ys, xs, list(zip(*cells))))

    def at(self, x, y):
        for x0, y0, x1, y1, z, material in reversed(self.fills):
            if x0 < x < x1 and y0 < y < y1:
                return z, material
        raise ValueError(f"nothing at {x}, {y}")


def merged(cells):
    """Rectangles of equal cells: runs along a row, then equal runs of neighbouring rows."""
    growing = {}
    for j, row in enumerate([*cells, []]):
        here = {run: growing.pop(run, j) for run in runs(row)}
        for (cell, i0, i1), since in growing.items():
            yield cell, i0, since, i1, j
        growing = here


def runs(row):
    start = 0
    for cell, group in groupby(row):
        end = start + len(list(group))
        yield cell, start, end
        start = end


def steps(axis, along, across, rows):
    """The faces between neighbouring rows of different depth; there is nothing beyond the sides."""
    void = [(0, None)] * len(rows[0])
    for value, before, after in zip(across, [void, *rows], [*rows, void]):
        for ((a, a_material), (b, b_material)), i0, i1 in runs(zip(before, after)):
            corners = rectangle(axis, value, along[i0], min(a, b), along[i1], max(a, b))
            if a > b:
                yield a_material, corners
            elif b > a:
                yield b_material, corners[::-1]


def rectangle(axis, value, u0, v0, u1, v1):
    """Counter-clockwise seen from the positive end of the axis; v is z for steps."""
    if axis == "z":
        return [(u0, v0, value), (u1, v0, value), (u1, v1, value), (u0, v1, value)]
    if axis == "x":
        return [(value, u0, v0), (value, u1, v0), (value, u1, v1), (value, u0, v1)]
    return [(u0, value, v0), (u0, value, v1), (u1, value, v1), (u1, value, v0)]


def box(x0, y0, z0, x1, y1, z1, material):
    return prism(((z0, y0), (z1, y0), (z1, y1), (z0, y1)), x0, x1, material)


def prism(outline, x0, x1, material, ends=None):
    """An outline (z, y), counter-clockwise seen from the left, from x0 to x1; a concave one says
    what convex pieces its ends are made of."""
    faces = []
    for piece in ends or [outline]:
        faces.append((material, [(x0, y, z) for z, y in piece]))
        faces.append((material, [(x1, y, z) for z, y in reversed(piece)]))
    for a, b in edges(outline):
        corners = [(x0, a[1], a[0]), (x1, a[1], a[0]), (x1, b[1], b[0]), (x0, b[1], b[0])]
        faces.append((material, corners))
    return faces


def edges(corners):
    return list(zip(corners, [*corners[1:], corners[0]]))


def normal(corners):
    """Newell's: right for any planar polygon, unit length."""
    sums = [0.0, 0.0, 0.0]
    for a, b in edges(corners):
        for k in range(3):
            i, j = (k + 1) % 3, (k + 2) % 3
            sums[k] += (a[i] - b[i]) * (a[j] + b[j])
    length = math.hypot(*sums)
    return tuple(v / length for v in sums)


def faults_of(solids):
    for solid in solids:
        if not closed(solid):
            yield "a solid is not closed"
        if volume(solid) <= 0:
            yield "a solid faces inwards"
    faces = [corners for solid in solids for _, corners in solid]
    for i, a in enumerate(faces):
        for b in faces[i + 1 :]:
            if in_one_place(a, b):
                yield f"two faces in one place: {a} and {b}"


def closed(solid):
    """Every stretch of every edge is passed as often one way as the other (T-junctions may be)."""
    lines = {}
    for _, corners in solid:
        for a, b in edges(corners):
            direction = [(q - p) / math.dist(a, b) for p, q in zip(a, b)]
            sign = 1 if max(direction, key=abs) > 0 else -1
            direction = [sign * d for d in direction]
            start, end = dot(a, direction), dot(b, direction)
            foot = [p - start * d for p, d in zip(a, direction)]
            line = lines.setdefault(tuple(round(v, 5) + 0.0 for v in [*direction, *foot]), [])
            line += [(round(start, 6), 1), (round(end, 6), -1)]
    return all(cancels(line) for line in lines.values())


def cancels(line):
    """Each stretch adds its sign where it starts and takes it back where it ends."""
    sums = {}
    for place, sign in line:
        sums[place] = sums.get(place, 0) + sign
    return not any(sums.values())


def volume(solid):
    total = 0.0
    for _, corners in solid:
        for b, c in zip(corners[1:], corners[2:]):
            total += dot(corners[0], cross(b, c)) / 6
    return total


def in_one_place(a, b, tolerance=1e-6):
    """Whether two convex faces look the same way from one plane and overlap (separating axes)."""
    n = normal(a)
    if dot(n, normal(b)) < 1 - tolerance or abs(dot(n, a[0]) - dot(n, b[0])) > tolerance:
        return False
    for face, other in ((a, b), (b, a)):
        for p, q in edges(face):
            outwards = cross([v - u for u, v in zip(p, q)], n)
            if min(dot(c, outwards) for c in other) >= dot(p, outwards) - tolerance * math.dist(
                p, q
            ):
                return False
    return True


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
