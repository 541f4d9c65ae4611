#!/usr/bin/env python3
"""Memory does not grow with the number of buildings: ten times as many take a tenth more at most.

    test_flat_memory.py MANSARD ROOT
"""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

FEW, MANY = 4_000, 40_000
MOST = 1.15  # 1.05 is usual


def town(path, count):
    """Houses in terraces, in metres of a projection, as GeoJSON."""
    with open(path, "w", encoding="ascii") as out:
        out.write('{"type":"FeatureCollection","crs":{"type":"name","properties":'
                  '{"name":"urn:ogc:def:crs:EPSG::25832"}},"features":[\n')
        for i in range(count):
            x, y = 600_000 + 8 * (i % 200), 5_200_000 + 30 * (i // 200)
            corners = [(0, 0), (8, 0), (8, 9), (6, 9), (6, 12), (2, 12), (2, 9), (0, 9), (0, 0)]
            ring = ",".join(f"[{x + u},{y + v}]" for u, v in corners)
            out.write(("," if i else "") + f'{{"type":"Feature","properties":{{"name":"house number {i}",'
                      f'"levels":{2 + i % 4}}},"geometry":{{"type":"Polygon","coordinates":[[{ring}]]}}}}\n')
        out.write("]}\n")


def peak(program, style, footprints, model):
    """Kilobytes."""
    child = subprocess.Popen([program, "derive", style, footprints, "--lod", "1", "--quiet", "-o", model],
                             stderr=subprocess.PIPE)
    said = child.stderr.read().decode()
    _, status, usage = os.wait4(child.pid, 0)
    if status != 0:
        sys.exit(f"derive failed:\n{said}")
    return usage.ru_maxrss


def main():
    program, root = sys.argv[1], Path(sys.argv[2])
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        few, many = f"{folder}/few.geojson", f"{folder}/many.geojson"
        town(few, FEW)
        town(many, MANY)
        for model in ("town.obj", "town.glb"):
            peaks = [peak(program, root / "bench/facade_box.style", path, f"{folder}/{model}")
                     for path in (few, many)]
            ratio = peaks[1] / peaks[0]
            print(f"{model}: {FEW} buildings {peaks[0]} kB, {MANY} buildings {peaks[1]} kB: {ratio:.2f} times")
            failed = failed or ratio > MOST
    sys.exit("memory grows with the number of buildings" if failed else 0)


main()
