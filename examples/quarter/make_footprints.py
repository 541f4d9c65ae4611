#!/usr/bin/env python3
"""Draws footprints.geojson: an invented town quarter of about 150 plots.

    make_footprints.py                 writes footprints.geojson beside this script
    make_footprints.py --check         fails when that file is not what would be written, or is no
                                       town: overlapping, crossing or empty footprints
    make_footprints.py --plan FILE     draws the plan as SVG

The quarter lies along a spine, Bow Street. North Street and South Lane run parallel to it, Mill
Street and Bridge Street across it. Neighbours in a row share their corners, so that party walls are
the same two points in both footprints. Places are (s, d) of ground.py: metres along the spine and
metres to its left.
"""
import json
import math
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # no folder of caches beside the example
from builders import Town
from checks import faults_of_town, party_walls
from ground import after, along, at_length, before, l_shape, rectangle, u_shape

OUTPUT = Path(__file__).resolve().with_name("footprints.geojson")
ORIGIN = (10.0, 50.0)  # longitude, latitude: a field somewhere, no town of ours

MILL_STREET, BRIDGE_STREET = -62.0, 80.0  # where they cross the spine
WEST_END, EAST_END = -168.0, 168.0
NORTH_STREET, SOUTH_LANE = 57.0, -60.0  # d of the parallel streets; both are 10 m wide


def main(arguments):
    town = draw_town()
    text = geojson(town)
    if arguments == ["--check"]:
        return check(town, text)
    if arguments[:1] == ["--plan"] and len(arguments) == 2:
        Path(arguments[1]).write_text(plan(town), encoding="utf-8")
    elif not arguments:
        OUTPUT.write_text(text, encoding="utf-8")
        print(f"{OUTPUT}: {len(town)} footprints")
    else:
        print(__doc__, file=sys.stderr)
        return 2
    return 0


def check(town, text):
    faults = faults_of_town(town)
    if OUTPUT.read_text(encoding="utf-8") != text:
        faults.append("footprints.geojson is not what this script draws")
    print(
        "\n".join(faults) or f"{len(town)} footprints, {party_walls(town)} party walls, no overlap"
    )
    return 1 if faults else 0


def draw_town():
    town = Town()
    bow_street(town)
    market_block(town)
    market_square(town)
    court_and_school(town)
    north_street(town)
    south_lane(town)
    return town.buildings


def bow_street(town):
    """Terraces on both sides, on the back of the pavement; a corner shop at either crossing."""
    west, middle, east = (
        (WEST_END, before(MILL_STREET)),
        (after(MILL_STREET), before(BRIDGE_STREET)),
        (after(BRIDGE_STREET), EAST_END),
    )
    town.terrace(*west, front=6, inwards=1, levels=(2, 3))
    town.terrace(*west, front=-6, inwards=-1, levels=(2, 3))
    town.corner_shop(after(MILL_STREET), 9.5, front=-6, name="Mill Street Stores")
    town.terrace(middle[0] + 9.5, middle[1] - 9, front=-6, inwards=-1, levels=(3, 4))
    town.corner_shop(before(BRIDGE_STREET), -9, front=-6, name="Bridge Street Bakery")
    town.terrace(*east, front=-6, inwards=-1, levels=(2, 3))


def market_block(town):
    """Town houses around a court, wall to wall: four rows, a house on every corner."""
    w, e, s, n, depth = after(MILL_STREET), -2.0, 6.0, 52.0, 11.0
    town.party_row("s", w + depth, e - depth, s, s + depth, houses=4)
    town.party_row("d", s + depth, n - depth, e, e - depth, houses=3, shops=True)
    town.party_row("s", e - depth, w + depth, n, n - depth, houses=4)
    town.party_row("d", n - depth, s + depth, w, w + depth, houses=3)
    for x, y, right, up in ((w, s, 1, 1), (e, s, -1, 1), (e, n, -1, -1), (w, n, 1, -1)):
        town.corner_house(x, y, right * depth, up * depth, cut=2.6)


def market_square(town):
    """The square opens to Bow Street; the hall closes it to the north, the tower to the east."""
    nave, aisle, apse = 29.0, 13.0, 4.5
    hall = [
        (0, 0),
        (8, 0),
        (8, -3.5),
        (14, -3.5),
        (14, 0),
        (nave, 0),
        (nave + apse, 4),
        (nave + apse, 9),
        (nave, aisle),
        (14, aisle),
        (14, aisle + 3.5),
        (8, aisle + 3.5),
        (8, aisle),
        (0, aisle),
    ]
    town.place(
        hall, 12, 30.5, building="church", use="civic", height=14, levels=1, name="St Anne's Hall"
    )
    pavilion = [
        (3.6 * math.cos(math.radians(45 * i - 112.5)), 3.6 * math.sin(math.radians(45 * i - 112.5)))
        for i in range(8)
    ]
    town.place(
        pavilion,
        21,
        17,
        building="retail",
        use="retail",
        height=4,
        levels=1,
        name="Market pavilion",
    )
    town.place(
        rectangle(15, 15),
        before(BRIDGE_STREET) - 15.5,
        8,
        building="office",
        use="office",
        height=60,
        levels=17,
        style="Block",
        name="Bridge Tower",
    )
    town.place(
        l_shape(15, 18, 7, 9),
        before(BRIDGE_STREET) - 15.5,
        31.5,
        building="public",
        use="civic",
        height=9.6,
        levels=2,
        style="Block",
        name="Library",
    )


def court_and_school(town):
    """One building about its own courtyard, then a school that opens to the street."""
    s = after(BRIDGE_STREET)
    width, depth, wing = 38.0, 40.0, 11.0
    court = [(wing, wing), (wing, depth - wing), (width - wing, depth - wing), (width - wing, wing)]
    town.place(
        rectangle(width, depth),
        s + 1.5,
        8.5,
        hole=court,
        building="apartments",
        use="residential",
        height=15.6,
        levels=5,
        style="Block",
        name="Bridge Court",
    )
    town.place(
        u_shape(31, 27, 9.5, 12),
        s + 46,
        14,
        building="school",
        use="civic",
        height=10.8,
        levels=3,
        style="Block",
        name="Bow Street School",
    )


def north_street(town):
    """South side: terraces back to back with Bow Street's. North side: pairs, slabs and villas."""
    near, far = NORTH_STREET - 5, NORTH_STREET + 9
    town.terrace(WEST_END, before(MILL_STREET), front=near, inwards=-1, levels=(2, 2))
    town.pairs(WEST_END, before(MILL_STREET, far), front=far, inwards=1)
    for place in (0, 1, 2):
        s = at_length(along(after(MILL_STREET, far), far) + 2 + 40 * place, far)
        town.place(
            rectangle(29, 12.4),
            s,
            far + 2,
            building="apartments",
            use="residential",
            height=town.step(12.4, 15.4, 3),
            levels=4,
            style="Block",
        )
    town.villas(after(BRIDGE_STREET, far), EAST_END, front=far, inwards=1)


def south_lane(town):
    """Detached houses with front gardens on both sides, a few of them L- and U-shaped."""
    for front, inwards in ((SOUTH_LANE + 9, 1), (SOUTH_LANE - 9, -1)):
        town.villas(WEST_END, before(MILL_STREET, front), front, inwards)
        town.villas(after(MILL_STREET, front), before(BRIDGE_STREET, front), front, inwards)
        town.villas(after(BRIDGE_STREET, front), EAST_END, front, inwards)


def geojson(town):
    """One feature a line. Nine decimals of a degree are a tenth of a millimetre."""
    lines = []
    for number, building in enumerate(town, 1):
        known = building["properties"]
        properties = {"id": f"q{number:03}"}
        for name, value in (
            ("name", known.get("name")),
            ("building", known["building"]),
            ("use", known["use"]),
            ("height", known["height"]),
            ("building:levels", known["levels"]),
            ("style", known.get("style")),
        ):
            if value is not None:
                properties[name] = value
        rings = [lon_lat(building["ring"])] + (
            [lon_lat(building["hole"])] if building["hole"] else []
        )
        lines.append(
            '{"type": "Feature", "properties": %s, "geometry":'
            ' {"type": "Polygon", "coordinates": [%s]}}'
            % (json.dumps(properties), ", ".join(rings))
        )
    return (
        '{"type": "FeatureCollection", "name": "quarter", "features": [\n'
        + ",\n".join(lines)
        + "\n]}\n"
    )


def lon_lat(ring):
    """Metres to degrees by the radii of curvature of the WGS 84 ellipsoid at the origin."""
    a, e2, latitude = 6378137.0, 0.00669437999014, math.radians(ORIGIN[1])
    w = math.sqrt(1 - e2 * math.sin(latitude) ** 2)
    east, north = a / w * math.cos(latitude), a * (1 - e2) / w**3
    corners = [
        "[%.9f, %.9f]" % (ORIGIN[0] + math.degrees(x / east), ORIGIN[1] + math.degrees(y / north))
        for x, y in ring
    ]
    return "[" + ", ".join(corners + corners[:1]) + "]"


def plan(town):
    """North up, five pixels a metre; the bold edge is the first one, the street front."""
    colours = {
        "residential": "#d9b99b",
        "retail": "#d98b6a",
        "office": "#8fa6b8",
        "civic": "#b59ac0",
    }
    path = lambda ring: "M" + " L".join("%.2f,%.2f" % (x, -y) for x, y in ring) + " Z"
    shapes = []
    for number, building in enumerate(town, 1):
        ring, hole = building["ring"], building["hole"]
        shapes.append(
            '<path d="%s%s" fill="%s" fill-rule="evenodd" stroke="#333" stroke-width="0.15"/>'
            % (path(ring), path(hole) if hole else "", colours[building["properties"]["use"]])
        )
        shapes.append(
            '<path d="M%.2f,%.2f L%.2f,%.2f" stroke="#000" stroke-width="0.5"/>'
            % (ring[0][0], -ring[0][1], ring[1][0], -ring[1][1])
        )
        x, y = (sum(c) / len(ring) for c in zip(*ring))
        shapes.append(
            f'<text x="{x:.1f}" y="{-y:.1f}" font-size="2.4" text-anchor="middle">{number}</text>'
        )
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="-190 -120 380 240" '
        'width="1900" height="1200">'
        '<rect x="-190" y="-120" width="380" height="240" fill="#f4f1ea"/>\n'
        + "\n".join(shapes)
        + "\n</svg>\n"
    )


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
