#!/usr/bin/env python3
"""An advancing front of your own: fill in the five functions that raise NotImplementedError; see README.md.

    python3 front.py start.json mine.json
"""
import json
import math
import sys

nodes = []     # [x, y] by number
front = []     # segments of the front, oldest first: [a, b, times deferred]; the unmeshed part is on the left of a-b
advances = []  # what each advance did, for the trace
element_count = 0


def rho_at(p):
    """The node spacing function at a place; here it is constant."""
    return 1.0


def cross(a, b, p):
    """Twice the area of the triangle abp; positive if p is on the left of ab."""
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def distance_to_segment(p, a, b):
    t = ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / math.dist(a, b) ** 2
    t = min(1.0, max(0.0, t))
    return math.dist(p, (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))


def leaves_inside(n, p):
    """True if a line from node n towards the place p begins in the unmeshed part. A node can be on the front twice."""
    def angle(q):
        return math.atan2(q[1] - nodes[n][1], q[0] - nodes[n][0])
    incoming = [angle(nodes[a]) for a, b, _ in front if b == n]
    for a, b, _ in front:
        if a == n:
            begin = angle(nodes[b])
            width = min((end - begin - 1e-9) % (2 * math.pi) + 1e-9 for end in incoming)
            if 1e-9 < (angle(p) - begin) % (2 * math.pi) < width - 1e-9:
                return True
    return False


def take_base():
    """Step 2: return the number of the next base in the list `front`."""
    raise NotImplementedError


def ideal_point(a, b):
    """Steps 3 and 4: return rho, clamped, and the ideal point C over the base from the place a to the place b."""
    raise NotImplementedError


def candidates(base, rho, c, radius):
    """Steps 5 to 7: return the candidates in the order in which they are tried, as [score, node, place]; node None: C."""
    raise NotImplementedError


def verdict(base, node, place):
    """Step 8: return "accepted", "not-left", "outside-angle", "crosses-front" or "contains-node"."""
    raise NotImplementedError


def update(base, node):
    """Step 9: replace the base by AC and CB in `front`; where the front has CA or BC already, both of the two vanish."""
    raise NotImplementedError


def advance():
    """One advance. Its trace is in `advances` from the start, so that one that fails can be compared as far as it came."""
    global element_count
    base = take_base()
    a, b, deferred = front[base]
    trace = {"base": {"a": nodes[a], "b": nodes[b]}}
    advances.append(trace)
    trace["rho"], trace["c"] = rho, c = ideal_point(nodes[a], nodes[b])
    radius = (1.75 if deferred else 1.2) * rho
    tried = candidates(base, rho, c, radius)
    trace["candidates"] = [{"at": place, "score": score} for score, node, place in tried]
    made = []
    for candidate, (score, node, place) in zip(trace["candidates"], tried):
        candidate["verdict"] = "not-tried" if made else verdict(base, node, place)
        if candidate["verdict"] == "accepted":
            if node is None:
                node = len(nodes)
                nodes.append(place)
            update(base, node)
            made = [[nodes[a], nodes[b], place]]
            element_count += 1
    trace["elements"] = made
    if not made:
        if deferred:
            sys.exit(f"no triangle fits on {nodes[a]}-{nodes[b]}, not even at the second attempt")
        front[base][2] += 1
    trace["front"] = len(front)


if __name__ == "__main__":
    with open(sys.argv[1]) as file:
        boundary = json.load(file)["boundary"]
    nodes += boundary["nodes"]
    front += [[a, b, 0] for a, b in boundary["segments"]]
    try:
        while front and len(advances) < 10000:
            advance()
    finally:  # a run that fails can be compared, too
        with open(sys.argv[2], "w") as file:
            json.dump({"advances": advances}, file, indent=1)
        print(f"{sys.argv[2]}: {len(advances)} advances, {element_count} triangles, {len(nodes)} nodes")
