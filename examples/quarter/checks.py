"""Whether a list of footprints is a town: no footprint is broken, none overlaps another, and rows
stand wall to wall."""
import math

from ground import area, edges_of


def faults_of_town(town):
    faults = [f"q{i:03} {fault}" for i, b in enumerate(town, 1) for fault in faults_of(b)]
    faults += overlaps(town)
    if party_walls(town) < 90:
        faults.append(f"only {party_walls(town)} party walls")
    for metres in (0, 0.1, 3):
        if not overlaps([town[0], moved(town[0], metres)]):
            faults.append(f"the check for overlaps is blind to a copy moved by {metres} m")
    return faults


def moved(building, metres):
    return {**building, "ring": [(x + metres, y + metres) for x, y in building["ring"]]}


def faults_of(building):
    for ring in filter(None, (building["ring"], building["hole"])):
        edges = edges_of(ring)
        if any(crosses(e, f) for i, e in enumerate(edges) for f in edges[i + 1 :]):
            yield "crosses itself"
        if min(math.dist(*edge) for edge in edges) < 1:
            yield "has an edge shorter than a metre"
    if area(building["ring"]) < 20:
        yield "is smaller than 20 square metres, or clockwise"
    if building["hole"] and area(building["hole"]) > 0:
        yield "has a hole that is not clockwise"


def overlaps(town):
    """Pairs whose insides meet: an edge crosses another, or runs 2 cm inside the other's ring."""
    pairs = []
    boxes = [(min(xs), min(ys), max(xs), max(ys)) for xs, ys in (zip(*b["ring"]) for b in town)]
    for i, a in enumerate(town):
        for j in range(i + 1, len(town)):
            p, q = boxes[i], boxes[j]
            if p[0] > q[2] or q[0] > p[2] or p[1] > q[3] or q[1] > p[3]:
                continue
            if overlap(a["ring"], town[j]["ring"]):
                pairs.append(f"q{i + 1:03} and q{j + 1:03} overlap")
    return pairs


def overlap(a, b):
    if any(crosses(e, f) for e in edges_of(a) for f in edges_of(b)):
        return True
    return any(inside(p, b) for p in just_inside(a)) or any(inside(p, a) for p in just_inside(b))


def just_inside(ring, step=0.02):
    for (x0, y0), (x1, y1) in edges_of(ring):
        length = math.hypot(x1 - x0, y1 - y0)
        nx, ny = -(y1 - y0) / length * step, (x1 - x0) / length * step
        for t in (0.02, 0.25, 0.5, 0.75, 0.98):
            yield x0 + t * (x1 - x0) + nx, y0 + t * (y1 - y0) + ny


def inside(p, ring):
    x, y = p
    odd = False
    for (x0, y0), (x1, y1) in edges_of(ring):
        if (y0 > y) != (y1 > y) and x < x0 + (y - y0) / (y1 - y0) * (x1 - x0):
            odd = not odd
    return odd


def crosses(e, f, tolerance=0.002):
    """Whether both ends of each edge lie clearly on different sides of the other."""

    def side(line, p):
        (x0, y0), (x1, y1) = line
        return ((x1 - x0) * (p[1] - y0) - (y1 - y0) * (p[0] - x0)) / math.dist(*line)

    a, b, c, d = side(e, f[0]), side(e, f[1]), side(f, e[0]), side(f, e[1])
    return min(map(abs, (a, b, c, d))) > tolerance and a * b < 0 and c * d < 0


def party_walls(town):
    """Walls of a metre and more that run along a neighbour's within a millimetre."""
    edges = [(i, edge) for i, b in enumerate(town) for edge in edges_of(b["ring"])]
    return sum(i < j and shared_length(e, f) > 1 for i, e in edges for j, f in edges)


def shared_length(e, f, tolerance=0.001):
    (x0, y0), (x1, y1) = e
    length = math.dist(*e)
    ux, uy = (x1 - x0) / length, (y1 - y0) / length
    if any(abs(ux * (y - y0) - uy * (x - x0)) > tolerance for x, y in f):
        return 0
    far, near = (ux * (x - x0) + uy * (y - y0) for x, y in f)  # neighbours run the other way
    return min(far, length) - max(near, 0)
