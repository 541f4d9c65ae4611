"""The ground of the quarter, and footprints by themselves.

A place is (s, d): metres along the spine, an S-curve of radius 207 m and more, and metres to its
left. Rings are lists of (x, y) in metres without the first corner repeated; the first edge is the
street front.
"""
import math

SWING, WAVE = 0.3, 62.0  # the spine's heading is SWING * cos(s / WAVE) radians
CROSS_WIDTH = 12.0  # of the streets that cross the spine


def heading(s):
    return SWING * math.cos(s / WAVE)


def point(s, d):
    """Metres east and north of the quarter's middle. Simpson's rule along the spine."""
    steps, x, y = 64, 0.0, 0.0
    h = s / steps
    for i in range(steps):
        for at, weight in ((i, 1), (i + 0.5, 4), (i + 1, 1)):
            x += weight * h / 6 * math.cos(heading(at * h))
            y += weight * h / 6 * math.sin(heading(at * h))
    return x - d * math.sin(heading(s)), y + d * math.cos(heading(s))


def along(s, d):
    """Length along the line d metres beside the spine: the integral of 1 - curvature * d."""
    return s - d * (heading(s) - heading(0))


def at_length(length, d):
    low, high = -400.0, 400.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if along(middle, d) < length else (low, middle)
    return low


def before(street, d=0.0):
    """Where a row at d ends before a cross street, its width measured there."""
    return at_length(along(street, d) - CROSS_WIDTH / 2, d)


def after(street, d=0.0):
    return at_length(along(street, d) + CROSS_WIDTH / 2, d)


def rectangle(width, depth):
    return [(0, 0), (width, 0), (width, depth), (0, depth)]


def l_shape(width, depth, missing_width, missing_depth):
    """The far right corner is missing."""
    w, d = width - missing_width, depth - missing_depth
    return [(0, 0), (width, 0), (width, d), (w, d), (w, depth), (0, depth)]


def u_shape(width, depth, wing, court_depth):
    """Two wings towards the street, a court between them."""
    return [
        (0, 0),
        (wing, 0),
        (wing, court_depth),
        (width - wing, court_depth),
        (width - wing, 0),
        (width, 0),
        (width, depth),
        (0, depth),
    ]


def t_shape(width, depth, stem, forward):
    """The middle stands forward of both sides."""
    a, b = (width - stem) / 2, (width + stem) / 2
    return [
        (a, 0),
        (b, 0),
        (b, forward),
        (width, forward),
        (width, depth),
        (0, depth),
        (0, forward),
        (a, forward),
    ]


def mirrored(ring, width):
    flipped = [(width - x, y) for x, y in ring]
    return [flipped[1], flipped[0]] + flipped[:1:-1]


def with_outrigger(ring, at_end, inwards, width=2.9, length=3.6):
    """A kitchen wing behind a terrace house, along the party wall at its end or its start."""
    (a, _), (b, _), (_, back), _ = ring
    out = back + inwards * length
    if at_end:
        return ring[:2] + [(b, out), (b - width, out), (b - width, back), (a, back)]
    return ring[:2] + [(b, back), (a + width, back), (a + width, out), (a, out)]


def counter_clockwise(ring):
    """The same ring, its first edge still first."""
    return ring if area(ring) > 0 else [ring[1], ring[0]] + ring[:1:-1]


def edges_of(ring):
    return list(zip(ring, ring[1:] + ring[:1]))


def area(ring):
    return sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in edges_of(ring)) / 2
