"""What a .glb says of itself: a reader for tests that shares nothing with Mansard's writer."""
import json
import struct
from pathlib import Path

GPU = "EXT_mesh_gpu_instancing"


class Glb:
    def __init__(self, path):
        data = Path(path).read_bytes()
        magic, version, length = struct.unpack_from("<4sII", data)
        if (magic, version, length) != (b"glTF", 2, len(data)):
            raise ValueError(f"{path} is no .glb of version 2, or is cut off")
        (size,) = struct.unpack_from("<I", data, 12)
        self.document = json.loads(data[20:20 + size])
        self.rest = data[20 + size:]

    def counts(self):
        """Of nodes, meshes, materials, and triangles as often as they are drawn."""
        lists = {name: len(self.document.get(name, [])) for name in ("nodes", "meshes", "materials")}
        return lists | {"triangles": sum(self._triangles(node) for node in self.document["nodes"])}

    def roots(self):
        return self.document["scenes"][0]["nodes"]

    def bounds(self):
        """(low, high) of all that is drawn; not of what is instanced by the extension."""
        points = [p for root in self.roots() for p in self._corners(root)]
        return tuple([f(p[i] for p in points) for i in range(3)] for f in (min, max))

    def write_black(self, path):
        """The same geometry, byte by byte, with all its materials black and matt."""
        matt = {"baseColorFactor": [0, 0, 0, 1], "metallicFactor": 0, "roughnessFactor": 1}
        materials = [{"name": f"black{i}", "pbrMetallicRoughness": matt}
                     for i in range(len(self.document["materials"]))]
        text = json.dumps(self.document | {"materials": materials}).encode()
        text += b" " * (-len(text) % 4)
        head = struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(self.rest), len(text),
                           0x4E4F534A)
        Path(path).write_bytes(head + text + self.rest)

    def _triangles(self, node):
        if "mesh" not in node:
            return 0
        accessors = self.document["accessors"]
        places = node.get("extensions", {}).get(GPU, {}).get("attributes", {})
        times = accessors[places["TRANSLATION"]]["count"] if places else 1
        primitives = self.document["meshes"][node["mesh"]]["primitives"]
        return times * sum(accessors[p["indices"]]["count"] // 3 for p in primitives)

    def _corners(self, number):
        """Of the boxes around the node's mesh and its children's, in the frame of its parent."""
        node = self.document["nodes"][number]
        points = [p for child in node.get("children", []) for p in self._corners(child)]
        if "mesh" in node:
            for primitive in self.document["meshes"][node["mesh"]]["primitives"]:
                box = self.document["accessors"][primitive["attributes"]["POSITION"]]
                points += [(x, y, z) for x, y, z in
                           ([box["max" if k >> i & 1 else "min"][i] for i in range(3)] for k in range(8))]
        return [placed(node, p) for p in points]


def placed(node, point):
    """The point where the node's scale, rotation and translation bring it."""
    x, y, z, w = node.get("rotation", (0, 0, 0, 1))
    p = [a * b for a, b in zip(point, node.get("scale", (1, 1, 1)))]
    t = [2 * (y * p[2] - z * p[1]), 2 * (z * p[0] - x * p[2]), 2 * (x * p[1] - y * p[0])]
    turned = [p[0] + w * t[0] + y * t[2] - z * t[1], p[1] + w * t[1] + z * t[0] - x * t[2],
              p[2] + w * t[2] + x * t[1] - y * t[0]]
    return tuple(a + b for a, b in zip(turned, node.get("translation", (0, 0, 0))))
