#!/usr/bin/env python3
"""Writes the sample projects to samples/; the geometry is our own. Project format version 1."""
import base64
import json
import math
import struct
from pathlib import Path

HERE = Path(__file__).resolve().parent / "samples"
PITCH = 2.0  # of painted spacing
SPAN = 16  # nodes per side of a tile


def encode_tile(values):
    """Returns 256 floats with runs of equal words packed, as base64 (core/io/project/tile_code)."""
    words = [struct.pack("<f", v) for v in values]
    packed = bytearray()
    at = 0
    while at < len(words):
        run = 1
        while at + run < len(words) and words[at + run] == words[at] and run < 129:
            run += 1
        if run >= 2:
            packed.append(run + 126)
            packed += words[at]
            at += run
            continue
        start = at
        while at < len(words) and at - start < 128 and (at + 1 >= len(words) or words[at + 1] != words[at]):
            at += 1
        packed.append(at - start - 1)
        packed += b"".join(words[start:at])
    return base64.b64encode(bytes(packed)).decode()


def paint(discs, pitch=PITCH):
    """Paints discs (x, y, radius, spacing); where they overlap, the smaller spacing wins."""
    nodes = {}
    for x, y, radius, rho in discs:
        for j in range(math.floor((y - radius) / pitch), math.ceil((y + radius) / pitch) + 1):
            for i in range(math.floor((x - radius) / pitch), math.ceil((x + radius) / pitch) + 1):
                if math.hypot(i * pitch - x, j * pitch - y) <= radius:
                    nodes[i, j] = min(nodes.get((i, j), rho), rho)
    tiles = {}
    for (i, j), rho in nodes.items():
        tile = tiles.setdefault((i // SPAN, j // SPAN), [0.0] * (SPAN * SPAN))
        tile[(j % SPAN) * SPAN + i % SPAN] = rho
    return {"origin": [0, 0], "pitch": pitch,
            "tiles": [[i, j, encode_tile(values)] for (i, j), values in sorted(tiles.items())]}


class Project:
    def __init__(self):
        self.shapes, self.markers, self.boundaries, self.regions = [], [], {}, {}
        self.spacing = {"fromBoundary": False}

    def add(self, kind, nodes, tag, name="", use="boundary", segment_tags=None):
        shape = {"id": len(self.shapes) + 1, "kind": kind, "use": use, "tag": tag, "name": name,
                 "nodes": [[round(x, 6), round(y, 6)] for x, y in nodes]}
        if segment_tags:
            shape["segmentTags"] = segment_tags
        self.shapes.append(shape)

    def source(self, shape, a, size, growth, name, b=(0, 0), radius=0):
        self.spacing.setdefault("sources", []).append(
            {"shape": shape, "a": list(a), "b": list(b), "radius": radius, "size": size, "growth": growth, "name": name})

    def write(self, file):
        text = {"format": "forefront", "version": 1, "shapes": self.shapes, "regionMarkers": self.markers,
                "boundaryNames": {str(k): v for k, v in self.boundaries.items()},
                "regionNames": {str(k): v for k, v in self.regions.items()}, "spacing": self.spacing,
                "options": {"grid": "hierarchical", "gridColumns": 0, "gridRows": 0, "keepBoundary": False,
                            "improve": "default", "threads": 1},
                "circleTolerance": 0.002, "nextId": len(self.shapes) + 1}
        lines = []
        for key, value in text.items():
            if key == "shapes":
                body = ",\n    ".join(json.dumps(shape) for shape in value)
                lines.append(f'  "shapes": [\n    {body}\n  ]')
            else:
                lines.append(f"  {json.dumps(key)}: {json.dumps(value)}")
        (HERE / file).write_text("{\n" + ",\n".join(lines) + "\n}\n")


def harbour():
    p = Project()
    p.boundaries = {1: "quay", 2: "pier", 3: "breakwater", 4: "beach", 5: "open sea", 6: "islet", 7: "dolphin",
                    8: "fairway", 9: "pocket edge"}
    p.regions = {1: "basin", 2: "berth pocket"}
    outline = [((0, 0), 1), ((88, 0), 2), ((88, 92), 2), ((92, 98), 2), ((100, 98), 2), ((104, 92), 2), ((104, 0), 1),
               ((168, 0), 1), ((186, 20), 1), ((244, 20), 4), ((280, 9), 4), ((330, 3), 4), ((376, 8), 4),
               ((420, 4), 5), ((420, 258), 4), ((370, 266), 4), ((322, 259), 4), ((276, 262), 3), ((262, 206), 3),
               ((244, 160), 3), ((226, 134), 3), ((217, 132), 3), ((214, 141), 3), ((229, 168), 3), ((243, 208), 3),
               ((250, 246), 1), ((64, 246), 1), ((0, 190), 1)]
    p.add("polygon", [at for at, _ in outline], 1, "harbour", segment_tags=[tag for _, tag in outline])
    islet = []
    for k in range(22):
        a = 2 * math.pi * k / 22
        r = 24 + 4.0 * math.sin(2 * a + 0.6) + 2.6 * math.sin(3 * a + 2.0)
        islet.append((338 + 1.25 * r * math.cos(a), 176 + 0.85 * r * math.sin(a)))
    p.add("polygon", islet, 6, "islet")
    p.add("circle", [(182, 72), (189, 72)], 7, "dolphin")
    p.add("polyline", [(404, 96), (330, 84), (262, 92), (204, 104), (148, 150), (128, 196)], 8, "fairway", "constraint")
    p.add("polygon", [(16, 22), (70, 22), (70, 78), (16, 78)], 9, "berth pocket", "constraint")
    p.markers = [{"at": [40, 50], "tag": 2}]
    p.spacing.update({"size": 15, "gradation": 0.22,
                      "paint": paint([(96, 112, 26, 2.6), (118, 120, 16, 2.6)])})
    p.source("point", (219, 134), 3.2, 0.18, "breakwater head")
    p.source("circle", (182, 72), 3.0, 0.2, "dolphin", radius=8)
    p.write("harbour.json")


def plate():
    p = Project()
    p.boundaries = {1: "free edge", 2: "clamped", 3: "loaded", 4: "hole"}
    p.regions = {1: "plate"}
    p.add("polygon", [(0, 0), (200, 0), (200, 100), (0, 100)], 1, "plate", segment_tags=[1, 3, 1, 2])
    p.add("circle", [(100, 50), (120, 50)], 4, "hole")
    p.spacing.update({"size": 9})
    p.source("circle", (100, 50), 2.2, 0.16, "edge of the hole", radius=20)
    p.write("plate.json")


def airfoil():
    """A NACA 2412 airfoil with a closed trailing edge in a round far field."""
    p = Project()
    p.boundaries = {1: "far field", 2: "upper side", 3: "lower side"}
    p.regions = {1: "air"}
    m, pos, t = 0.02, 0.4, 0.12
    upper, lower = [], []
    count = 44
    for k in range(count + 1):
        x = 0.5 * (1 - math.cos(math.pi * k / count))
        y = 5 * t * (0.2969 * math.sqrt(x) - 0.1260 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)
        camber = m / pos**2 * (2 * pos * x - x * x) if x < pos else m / (1 - pos)**2 * (1 - 2 * pos + 2 * pos * x - x * x)
        slope = 2 * m / pos**2 * (pos - x) if x < pos else 2 * m / (1 - pos)**2 * (pos - x)
        a = math.atan(slope)
        upper.append((x - y * math.sin(a), camber + y * math.cos(a)))
        lower.append((x + y * math.sin(a), camber - y * math.cos(a)))
    nodes = lower[:-1] + [(1.0, 0.0)] + upper[-2:0:-1]
    tags = [3] * count + [2] * count
    p.add("circle", [(0.5, 0), (3.5, 0)], 1, "far field")
    p.add("polygon", nodes, 2, "airfoil", segment_tags=tags)
    p.spacing.update({"maximum": 0.35})
    p.source("point", (0, 0), 0.006, 0.14, "leading edge")
    p.source("point", (1, 0), 0.008, 0.14, "trailing edge")
    p.source("line", (0, 0.01), 0.025, 0.14, "chord", b=(1, 0))
    p.source("line", (1, 0), 0.03, 0.16, "wake", b=(2.6, 0.1))
    p.write("airfoil.json")


def ring(cx, cy, radius, seed, count, squash=1.0, rough=0.12):
    nodes = []
    for k in range(count):
        a = 2 * math.pi * k / count
        r = radius * (1 + rough * (math.sin(2 * a + seed) + 0.6 * math.sin(3 * a + 2.1 * seed) +
                                   0.35 * math.sin(5 * a + 3.7 * seed) + 0.2 * math.sin(8 * a + 5.3 * seed)))
        nodes.append((cx + r * math.cos(a), cy + squash * r * math.sin(a)))
    return nodes


def lake():
    p = Project()
    p.boundaries = {1: "shore", 2: "island", 3: "pond"}
    p.regions = {1: "lake", 2: "pond"}
    p.add("polygon", ring(0, 0, 1000, 0.7, 96, 0.62, 0.13), 1, "shore")
    p.add("polygon", ring(-420, 60, 190, 2.2, 40, 0.8), 2, "great island")
    p.add("polygon", ring(-430, 70, 70, 4.1, 20, 0.8), 3, "pond")
    p.add("polygon", ring(250, -110, 110, 1.3, 26, 0.7), 2, "heron island")
    p.add("polygon", ring(480, 120, 60, 3.3, 18, 0.9), 2, "reed island")
    p.add("polygon", ring(60, 190, 42, 5.0, 14, 0.9), 2, "rock")
    p.markers = [{"at": [-430, 70], "tag": 2}]
    p.spacing.update({"fromBoundary": True, "gradation": 0.18})
    p.write("lake.json")


def gear():
    p = Project()
    p.boundaries = {1: "teeth", 2: "bore", 3: "lightening hole"}
    p.regions = {1: "steel"}
    teeth, root, tip = 18, 42.0, 50.0
    nodes = []
    for k in range(teeth):
        for part, radius in ((-0.30, root), (-0.20, 0.5 * (root + tip) + 1), (-0.12, tip), (0.12, tip),
                             (0.20, 0.5 * (root + tip) + 1), (0.30, root)):
            a = 2 * math.pi * (k + part) / teeth
            nodes.append((radius * math.cos(a), radius * math.sin(a)))
    p.add("polygon", nodes, 1, "rim")
    p.add("circle", [(0, 0), (11, 0)], 2, "bore")
    for k in range(6):
        a = 2 * math.pi * (k + 0.5) / 6
        centre = (26 * math.cos(a), 26 * math.sin(a))
        p.add("circle", [centre, (centre[0] + 6.5, centre[1])], 3, "")
    p.spacing.update({"expression": "max(1.1, 0.16*(51 - sqrt(x*x + y*y)))", "maximum": 3.2})
    p.write("gear.json")


def crack():
    p = Project()
    p.boundaries = {1: "free edge", 2: "pulled", 3: "crack"}
    p.regions = {1: "plate"}
    p.add("polygon", [(-50, -50), (50, -50), (50, 50), (-50, 50)], 1, "plate", segment_tags=[2, 1, 2, 1])
    p.add("polyline", [(-16, -5), (-6, -2), (4, 1), (16, 6)], 3, "crack", "constraint")
    p.spacing.update({"size": 6})
    p.source("point", (-16, -5), 0.25, 0.16, "crack tip")
    p.source("point", (16, 6), 0.25, 0.16, "crack tip")
    p.write("crack.json")


def letter():
    p = Project()
    p.boundaries = {1: "outline", 2: "counter"}
    p.regions = {1: "ink"}
    p.add("polygon", [(0, 0), (16, 0), (27, 30), (73, 30), (84, 0), (100, 0), (58, 110), (42, 110)], 1, "outline")
    p.add("polygon", [(32, 44), (68, 44), (50, 93)], 2, "counter")
    p.spacing.update({"expression": "1.2 + 0.02*abs(y - 37)"})
    p.write("letter.json")


if __name__ == "__main__":
    HERE.mkdir(exist_ok=True)
    gallery = [("harbour.json", "Harbour with a pier", harbour), ("plate.json", "Plate with a hole", plate),
               ("airfoil.json", "Airfoil", airfoil), ("lake.json", "Lake with islands", lake),
               ("gear.json", "Gear", gear), ("crack.json", "Cracked plate", crack), ("letter.json", "Letter A", letter)]
    for _, _, make in gallery:
        make()
    (HERE / "index.txt").write_text("".join(f"{file} {title}\n" for file, title, _ in gallery))
