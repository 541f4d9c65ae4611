"""The builders of the quarter: each method puts up one kind of row or house."""
import math
import random

from ground import (
    along,
    at_length,
    counter_clockwise,
    heading,
    l_shape,
    mirrored,
    point,
    rectangle,
    t_shape,
    u_shape,
    with_outrigger,
)


class Town:
    """The buildings drawn so far, and the dice."""

    def __init__(self):
        self.buildings = []
        self.random = random.Random(1874)

    def between(self, low, high):
        return low + (high - low) * self.random.random()

    def step(self, low, high, steps):
        """One of the steps + 1 values from low to high."""
        return round(low + (high - low) * math.floor(self.random.random() * (steps + 1)) / steps, 2)

    def chance(self, probability):
        return self.random.random() < probability

    def add(self, ring, hole=None, **properties):
        ring = counter_clockwise(ring)
        self.buildings.append({"ring": ring, "hole": hole, "properties": properties})

    def place(self, local, s, d, inwards=1, turn=0.0, hole=None, **properties):
        """A rigid footprint: local x runs along the street, seen from it, and y into the plot."""
        x0, y0 = point(s, d)
        angle = heading(s) + (0 if inwards > 0 else math.pi) + turn
        c, n = math.cos(angle), math.sin(angle)
        lay = lambda ring: [(x0 + c * x - n * y, y0 + n * x + c * y) for x, y in ring]
        self.add(lay(local), hole=lay(hole) if hole else None, **properties)

    def terrace(self, s0, s1, front, inwards, levels):
        """Houses of 5.6 to 7.6 m in runs of three to six alike, as builders put them up."""
        for run in self.runs(s0, s1, front):
            floors = levels[0] + (self.random.random() < 0.4) * (levels[1] - levels[0])
            height = round(floors * self.step(2.85, 3.15, 3) + 0.8, 2)
            depth, outriggers = self.step(9.2, 11.2, 4), self.chance(0.5)
            for number, (a, b) in enumerate(run):
                ring = [
                    (a, front),
                    (b, front),
                    (b, front + inwards * depth),
                    (a, front + inwards * depth),
                ]
                if outriggers:
                    ring = with_outrigger(ring, at_end=number % 2 == 0, inwards=inwards)
                shop = self.chance(0.06)
                self.add(
                    [point(*p) for p in ring],
                    building="terrace",
                    use="retail" if shop else "residential",
                    height=height,
                    levels=floors,
                    style=None if self.chance(0.1) else "Terrace",
                )

    def runs(self, s0, s1, front):
        """Cuts the front line from s0 to s1 into houses, grouped by run."""
        length = along(s1, front) - along(s0, front)
        widths, groups = [], []
        while sum(widths) < length - 2.5:
            width, houses = self.step(5.8, 7.4, 4), 3 + math.floor(self.random.random() * 4)
            houses = min(houses, max(1, round((length - sum(widths)) / width)))
            groups.append(houses)
            widths += [width] * houses
        stretch = length / sum(widths)
        cuts = [s0]
        for width in widths:
            cuts.append(at_length(along(cuts[-1], front) + width * stretch, front))
        cuts[-1] = s1
        houses = list(zip(cuts, cuts[1:]))
        for count in groups:
            yield houses[:count]
            houses = houses[count:]

    def corner_shop(self, corner, width, front, depth=10.5, cut=2.4, **properties):
        """At the end of a row, its door in the cut corner; a negative width runs west."""
        inwards, along_front = math.copysign(1, front), math.copysign(1, width)
        back = front + inwards * depth
        ring = [
            (corner + along_front * cut, front),
            (corner + width, front),
            (corner + width, back),
            (corner, back),
            (corner, front + inwards * cut),
        ]
        self.add(
            [point(*p) for p in ring],
            building="retail",
            use="retail",
            height=9.9,
            levels=3,
            style="Terrace",
            **properties,
        )

    def party_row(self, axis, a, b, front, back, houses, shops=False):
        """Town houses from a to b along s or d, the street at `front`, a court at `back`."""
        weights = [self.between(0.85, 1.15) for _ in range(houses)]
        cuts = [a + (b - a) * sum(weights[:i]) / sum(weights) for i in range(houses)] + [b]
        for p, q in zip(cuts, cuts[1:]):
            ring = [(p, front), (q, front), (q, back), (p, back)]
            ring = ring if axis == "s" else [(d, s) for s, d in ring]
            levels = 4 + self.chance(0.4)
            shop = shops or self.chance(0.3)
            self.add(
                [point(*p) for p in ring],
                building="apartments",
                use="retail" if shop else "residential",
                height=round(levels * 3.1 + 0.6, 2),
                levels=levels,
                style="Block",
            )

    def corner_house(self, s, d, width, depth, cut):
        """Fills the corner (s, d) of a block, which is cut off for the door."""
        x, y = math.copysign(cut, width), math.copysign(cut, depth)
        ring = [(s + x, d), (s + width, d), (s + width, d + depth), (s, d + depth), (s, d + y)]
        self.add(
            [point(*p) for p in ring],
            building="apartments",
            use="retail",
            height=16.1,
            levels=5,
            style="Block",
        )

    def pairs(self, s0, s1, front, inwards):
        """Semi-detached houses: two mirrored halves with a party wall, then a side passage."""
        s = s0
        while along(s1, front) - along(s, front) > 15:
            width, depth, height = (
                self.step(6.4, 7.2, 2),
                self.step(8.8, 10, 3),
                self.step(6.5, 7, 2),
            )
            for half in (0, 1):
                self.place(
                    [(half * width + u, v) for u, v in rectangle(width, depth)],
                    s,
                    front,
                    inwards,
                    building="semidetached_house",
                    use="residential",
                    height=height,
                    levels=2,
                    style="Villa" if self.chance(0.8) else None,
                )
            s = at_length(along(s, front) + 2 * width + self.between(4.5, 6.5), front)

    def villas(self, s0, s1, front, inwards):
        """Detached houses on plots of 14 to 19 m, none quite like the next."""
        s = s0
        while True:
            shape, width = self.villa_shape()
            plot = width + self.between(5, 7.5)
            s_next = at_length(along(s, front) + plot, front)
            if s_next > s1 + 2:
                return
            side = self.between(0.35, 0.65) * (plot - width)
            left = at_length(along(s, front) + (side if inwards > 0 else plot - side), front)
            levels = 1 + self.chance(0.85)
            self.place(
                shape,
                left,
                front + inwards * self.between(-1, 1.5),
                inwards,
                turn=math.radians(self.between(-2.5, 2.5)),
                building="detached",
                use="residential",
                height=self.step(6.5, 7.7, 4) if levels == 2 else 4.2,
                levels=levels,
                style=None if self.chance(0.15) else "Villa",
            )
            s = s_next

    def villa_shape(self):
        width, depth, kind = self.step(9, 11.5, 5), self.step(9, 11.5, 5), self.random.random()
        if kind < 0.5:
            return rectangle(width, depth), width
        if kind < 0.78:
            ring = l_shape(width + 1.5, depth + 1, width * 0.45, depth * 0.42)
            return (mirrored(ring, width + 1.5) if self.chance(0.5) else ring), width + 1.5
        if kind < 0.9:
            return t_shape(width + 1, depth, 4.4, 2.2), width + 1
        return u_shape(width + 3.5, depth + 1, 4.2, depth * 0.45), width + 3.5
