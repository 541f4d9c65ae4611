#!/usr/bin/env python3
"""Draws street.geojson, the seven plots of the tutorial: a row of six along a gentle bend, with
party walls between them, and a house by itself.

    make_street.py            writes street.geojson beside this script
    make_street.py --check    fails when that file is not what would be written
"""
import json
import math
import sys
from pathlib import Path

OUTPUT = Path(__file__).resolve().with_name("street.geojson")
ORIGIN = (10.0, 50.0)  # longitude, latitude: a field somewhere
RADIUS = 90.0  # of the bend, metres; its middle lies behind the houses, so fronts are longer
DEPTH = 6.4

# Width of the front, height of the eaves, style.
ROW = [
    (7.4, 6.0, "House"),
    (7.0, 6.0, "Shuttered"),
    (8.4, 9.2, "Townhouse"),
    (7.2, 6.0, "House"),
    (7.4, 6.6, "Shuttered"),
    (8.6, 9.2, "Townhouse"),
]
ALONE = (9.0, 7.0, 3.3, "House")  # width, depth, height, style


def main(arguments):
    text = geojson(plots())
    if arguments == ["--check"]:
        return 0 if OUTPUT.read_text(encoding="utf-8") == text else 1
    OUTPUT.write_text(text, encoding="utf-8")
    return 0


def plots():
    """(corners in metres, front edge first, height, style) of each."""
    length = sum(width for width, _, _ in ROW)
    at = -length / 2
    for width, height, style in ROW:
        ring = [on_bend(at, 0), on_bend(at + width, 0), on_bend(at + width, DEPTH), on_bend(at, DEPTH)]
        yield ring, height, style
        at += width
    width, depth, height, style = ALONE
    left, front = length / 2 + 4.0, on_bend(length / 2, 0)[1]
    corners = [(0, 0), (width, 0), (width, depth), (0, depth)]
    yield [(left + x, front + y) for x, y in corners], height, style


def on_bend(along, behind):
    """Metres east and north: `along` the fronts from their middle, `behind` them."""
    angle = along / RADIUS
    radius = RADIUS - behind
    return radius * math.sin(angle), behind + radius * (1 - math.cos(angle))


def geojson(street):
    features = []
    for number, (ring, height, style) in enumerate(street, 1):
        corners = [degrees(*corner) for corner in ring + ring[:1]]
        features.append(json.dumps({
            "type": "Feature",
            "properties": {"id": f"plot{number}", "height": height, "style": style},
            "geometry": {"type": "Polygon", "coordinates": [corners]},
        }))
    return '{"type": "FeatureCollection", "features": [\n' + ",\n".join(features) + "\n]}\n"


def degrees(east, north):
    """Nine decimals of a degree are a tenth of a millimetre."""
    metres = 111_320.0
    longitude = ORIGIN[0] + east / (metres * math.cos(math.radians(ORIGIN[1])))
    return [round(longitude, 9), round(ORIGIN[1] + north / metres, 9)]


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
