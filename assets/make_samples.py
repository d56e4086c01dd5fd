#!/usr/bin/env python3
"""Writes the sample projects that consist of polygons to samples/, in project format version 1, and the list of all
samples. The samples with curves and parameters are drawn and saved in the editor. The geometry is our own."""
import base64
import json
import math
import struct
from pathlib import Path

HERE = Path(__file__).resolve().parent / "samples"
PITCH = 2.0  # of painted spacing
SPAN = 16  # nodes per side of a tile


def encode_tile(values):
    """Returns 256 floats with runs of equal words packed, as base64 (core/drawing_files/project/tile_code)."""
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
        self.layers = []
        self.circle_tolerance = 0.002

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
                "circleTolerance": self.circle_tolerance, "nextId": len(self.shapes) + 1}
        if self.layers:
            text["layers"] = self.layers
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


def naca_0012(count, chord, angle, x0, y0):
    """Nodes of a NACA 0012 airfoil with a closed trailing edge, clockwise from there; `angle` in radians."""
    nodes = []
    for k in range(2 * count):
        x = 0.5 * (1 - math.cos(math.pi * (count - k) / count))
        y = 0.6 * (0.2969 * math.sqrt(x) - 0.1260 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)
        y = 0 if k == 0 else -y if k <= count else y
        nodes.append((x0 + chord * (math.cos(angle) * x - math.sin(angle) * y),
                      y0 + chord * (math.sin(angle) * x + math.cos(angle) * y)))
    return nodes


def flap():
    """A NACA 0012 airfoil with a flap of the same shape, a gap of 2.5 % apart."""
    p = Project()
    p.boundaries = {1: "far field", 2: "airfoil", 3: "flap"}
    p.regions = {1: "air"}
    p.add("circle", [(0.5, 0), (10.5, 0)], 1, "far field")
    p.add("polygon", naca_0012(80, 1, 0, 0, 0), 2, "airfoil")
    p.add("polygon", naca_0012(48, 0.35, -0.35, 0.98, -0.035), 3, "flap")
    p.spacing.update({"maximum": 1.5, "gradation": 0.2})
    p.source("line", (0, 0), 0.018, 0.22, "chord", b=(1, 0))
    p.source("line", (0.98, -0.035), 0.01, 0.22, "flap", b=(1.31, -0.155))
    p.layers = [{"tag": 2, "first": 2e-5, "growth": 1.2}, {"tag": 3, "first": 2e-5, "growth": 1.2}]
    p.write("flap.json")


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


def arc(cx, cy, radius, start, end, count):
    """Points from angle `start` to `end`, in degrees."""
    return [(cx + radius * math.cos(math.radians(start + (end - start) * k / count)),
             cy + radius * math.sin(math.radians(start + (end - start) * k / count))) for k in range(count + 1)]


def tunnel():
    """A cylinder in a channel; the layers of the walls slide along the inflow and the outflow."""
    p = Project()
    p.boundaries = {1: "wall", 2: "inflow", 3: "outflow", 4: "cylinder"}
    p.regions = {1: "fluid"}
    p.add("polygon", [(0, 0), (22, 0), (22, 4.1), (0, 4.1)], 1, "channel", segment_tags=[1, 3, 1, 2])
    p.add("circle", [(2, 2), (2.5, 2)], 4, "cylinder")
    p.spacing.update({"size": 0.2})
    p.source("circle", (2, 2), 0.04, 0.18, "cylinder", radius=0.55)
    p.source("line", (2.5, 2), 0.1, 0.2, "wake", b=(12, 2.1), radius=0.5)
    p.layers = [{"tag": 1, "first": 0.01, "growth": 1.2, "count": 12},
                {"tag": 4, "first": 0.002, "growth": 1.2, "thickness": 0.12}]
    p.write("tunnel.json")


def dam():
    """Each soil is a region with a maximum area of its own."""
    p = Project()
    p.boundaries = {1: "ground", 2: "upstream face", 3: "crest", 4: "downstream face", 5: "interface"}
    p.regions = {1: "shell", 2: "core", 3: "filter", 4: "foundation"}
    outline = [(-60, -30), (200, -30), (200, 0), (160, 0), (86, 37), (84.5, 37), (83, 37), (77, 37), (74, 37), (0, 0),
               (-60, 0)]
    p.add("polygon", outline, 1, "dam and ground", segment_tags=[1, 1, 1, 4, 3, 3, 3, 3, 2, 1, 1])
    p.add("polyline", [(0, 0), (66, 0), (94, 0), (99, 0), (160, 0)], 5, "base", "constraint")
    p.add("polyline", [(66, 0), (77, 37)], 5, "core, upstream", "constraint")
    p.add("polyline", [(94, 0), (83, 37)], 5, "core, downstream", "constraint")
    p.add("polyline", [(99, 0), (84.5, 37)], 5, "filter", "constraint")
    p.markers = [{"at": [40, 8], "tag": 1, "maxArea": 3}, {"at": [120, 8], "tag": 1, "maxArea": 3},
                 {"at": [80, 10], "tag": 2, "maxArea": 0.6}, {"at": [93, 8], "tag": 3, "maxArea": 0.25},
                 {"at": [70, -15], "tag": 4, "maxArea": 30}]
    p.spacing.update({"size": 9, "gradation": 0.25})
    p.write("dam.json")


def machine():
    """Slots of a stator around a rotor; the expression is finest in the air gap."""
    p = Project()
    p.boundaries = {1: "frame", 2: "shaft", 3: "rotor surface", 4: "bore", 5: "slot"}
    p.regions = {1: "rotor", 2: "air gap", 3: "stator", 4: "winding"}
    p.add("circle", [(0, 0), (60, 0)], 1, "frame")
    p.add("circle", [(0, 0), (9, 0)], 2, "shaft")
    p.add("circle", [(0, 0), (30, 0)], 3, "rotor surface", "constraint")
    p.add("circle", [(0, 0), (31, 0)], 4, "bore", "constraint")
    p.markers = [{"at": [20, 0], "tag": 1}, {"at": [30.5, 0.02], "tag": 2}, {"at": [57, 0], "tag": 3}]
    for k in range(12):
        a = 30 * k + 15
        slot = arc(0, 0, 33.5, a - 6.5, a + 6.5, 6) + arc(0, 0, 49, a + 7.5, a - 7.5, 6)
        p.add("polygon", slot, 5, "", "constraint")
        p.markers.append({"at": [41 * math.cos(math.radians(a)), 41 * math.sin(math.radians(a))], "tag": 4})
    p.spacing.update({"expression": "max(0.6, 0.16*abs(sqrt(x*x + y*y) - 30.5))", "maximum": 3})
    p.write("machine.json")


def snowflake():
    p = Project()
    p.boundaries = {1: "coast"}
    p.regions = {1: "flake"}
    nodes = [(math.cos(math.radians(a)), math.sin(math.radians(a))) for a in (90, 210, 330)]
    for _ in range(4):
        finer = []
        for (ax, ay), (bx, by) in zip(nodes, nodes[1:] + nodes[:1]):
            dx, dy = (bx - ax) / 3, (by - ay) / 3
            finer += [(ax, ay), (ax + dx, ay + dy),
                      (ax + 1.5 * dx + dy * math.sqrt(3) / 2, ay + 1.5 * dy - dx * math.sqrt(3) / 2),
                      (ax + 2 * dx, ay + 2 * dy)]
        nodes = finer
    p.add("polygon", nodes, 1, "flake")
    p.spacing.update({"fromBoundary": True, "gradation": 0.3})
    p.write("snowflake.json")


def spiral():
    p = Project()
    p.boundaries = {1: "inner wall", 2: "outer wall", 3: "inlet", 4: "outlet"}
    p.regions = {1: "fluid"}
    count = 150
    inner, outer = [], []
    for k in range(count + 1):
        a = 6 * math.pi * k / count
        r = 2 + 0.5 * a
        inner.append((r * math.cos(a), r * math.sin(a)))
        outer.append(((r + 1.3) * math.cos(a), (r + 1.3) * math.sin(a)))
    nodes = outer + inner[::-1]
    p.add("polygon", nodes, 1, "channel", segment_tags=[2] * count + [4] + [1] * count + [3])
    p.spacing.update({"size": 0.42})
    p.write("spiral.json")


def sieve():
    p = Project()
    p.boundaries = {1: "rim", 2: "holes"}
    p.regions = {1: "sheet"}
    p.circle_tolerance = 0.02
    p.add("rectangle", [(0, 0), (120, 70)], 1, "sheet")
    for row in range(6):
        for column in range(10 - row % 2):
            x, y = 12 + 10.7 * column + 5.35 * (row % 2), 12 + 9.2 * row
            p.add("circle", [(x, y), (x + 1.6 + 0.14 * column, y)], 2, "")
    p.spacing.update({"expression": "0.6 + 0.012*x"})
    p.write("sieve.json")


def ripples():
    p = Project()
    p.boundaries = {1: "shore"}
    p.regions = {1: "pool"}
    p.add("rectangle", [(-10, -7), (10, 7)], 1, "pool")
    p.spacing.update({"expression": "0.3 + 0.2*cos(2*sqrt((x + 4)*(x + 4) + y*y)) + 0.03*abs(x + 4)",
                      "minimum": 0.12, "maximum": 0.7})
    p.write("ripples.json")


def bay():
    """A bay of 20 km by 15 km with an island and a channel. In km, the depth of its sea bed in m is
    4 + 60·(x/20)^1.5 + 25·exp(-((y - 7.5)/0.9)² - x/9) - 14·exp(-((x - 13)² + (y - 4)²)/3)."""
    p = Project()
    p.boundaries = {1: "coast", 2: "open sea", 3: "island"}
    p.regions = {1: "bay"}
    coast = []
    for k in range(41):
        y = 15.0 - 15.0 * k / 40
        coast.append((1000 * (1.6 + 0.9 * math.cos(2 * math.pi * (y - 7.5) / 9.0 + math.pi)
                              + 0.25 * math.sin(1.9 * y)), 1000 * y))
    p.add("polygon", coast + [(20000, 0), (20000, 15000)], 1, "bay", segment_tags=[1] * 40 + [2] * 3)
    p.add("polygon", [(9000 + 700 * math.cos(a) * (1 + 0.2 * math.sin(3 * a)),
                       11000 + 500 * math.sin(a) * (1 + 0.2 * math.sin(3 * a)))
                      for a in (2 * math.pi * k / 30 for k in range(30))], 3, "island")

    def depth(x, y):
        return (4 + 60 * (max(x, 0) / 20)**1.5 + 25 * math.exp(-((y - 7.5) / 0.9)**2 - x / 9)
                - 14 * math.exp(-((x - 13)**2 + (y - 4)**2) / 3))
    columns, rows, pitch = 51, 39, 400
    values = [round(depth(i * pitch / 1000, k * pitch / 1000), 1) for k in range(rows) for i in range(columns)]
    p.spacing.update({"expression": "min(600/30*sqrt(9.81*max(depth(x,y), 1)), 120 + 0.2*shore(x,y,'coast','island'))",
                      "rasters": {"depth": {"origin": [0, 0], "pitch": [pitch, pitch], "columns": columns,
                                            "values": values}}})
    p.write("bay.json")


if __name__ == "__main__":
    HERE.mkdir(exist_ok=True)
    gallery = [
        ("harbour.json", "Harbour with a pier", "painted spacing, sources, names, a fairway", harbour),
        ("bracket.json", "Mounting bracket", "arcs, a slot and holes, all set by parameters", None),
        ("wing.json", "Airfoil of splines", "sizes on boundary parts, a box around the wake", None),
        ("river.json", "River and lake", "cubic curves, a gradient, fine at the head of a mole", None),
        ("joint.json", "Sealed road joint", "gap and layers set by parameters, regions with their own sizes", None),
        ("plate.json", "Plate with a hole", "a source around the hole", plate),
        ("airfoil.json", "Airfoil", "fine at its edges and wake, coarse far away", airfoil),
        ("lake.json", "Lake with islands", "spacing from the segment lengths of the shore", lake),
        ("bay.json", "Bay with a sea bed", "sizes by depth, for a wave of 10 minutes, and by the distance to the shore", bay),
        ("gear.json", "Gear", "a bore and holes set by parameters, spacing as an expression", None),
        ("crack.json", "Cracked plate", "an inner line, fine at its tips", crack),
        ("letter.json", "Letter A", "an outline with an inner loop", letter),
        ("cylinder.json", "Flow past a cylinder", "all lengths are parameters, sources along walls and wake", None),
        ("flap.json", "Airfoil with a flap", "boundary layers that share a narrow gap", flap),
        ("tunnel.json", "Cylinder in a channel", "boundary layers on walls and around a cylinder", tunnel),
        ("dam.json", "Embankment dam", "soils as regions, each with a maximum area", dam),
        ("machine.json", "Electric machine", "an air gap with a width of 2 % of the radius", machine),
        ("snowflake.json", "Snowflake", "a fractal with 768 corners", snowflake),
        ("spiral.json", "Spiral channel", "a long and narrow domain", spiral),
        ("sieve.json", "Perforated sheet", "57 holes, graded from left to right", sieve),
        ("ripples.json", "Ripples", "spacing in waves around a point", ripples),
    ]
    for _, _, _, make in gallery:
        if make:
            make()
    (HERE / "index.txt").write_text("".join(f"{file} {title} | {about}\n" for file, title, about, _ in gallery))
