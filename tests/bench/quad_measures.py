"""Measures meshes of quadrilaterals for quad_table.py, apart from the program that made them."""

import numpy as np

CORNERS = {2: 3, 3: 4, 9: 3, 16: 4, 10: 4}  # by the numbers of Gmsh's kinds of elements
NODES = {2: 3, 3: 4, 9: 6, 16: 8, 10: 9}


def read_msh2(path):
    """Returns the nodes (n, 2) of an MSH 2.2 file and its faces, by kind."""
    text = path.read_text()

    def section(name):
        start = text.index(f"${name}\n") + len(name) + 2
        return text[start:text.index(f"$End{name}", start)].split("\n", 1)[1]

    table = np.array(section("Nodes").split(), dtype=float).reshape(-1, 4)
    order = np.full(int(table[:, 0].max()) + 1, -1)
    order[table[:, 0].astype(int)] = np.arange(len(table))
    found = {}
    for line in section("Elements").splitlines():
        words = line.split()
        kind = int(words[1]) if len(words) > 2 else 0
        if kind in NODES:
            first = 3 + int(words[2])
            found.setdefault(kind, []).append(words[first:first + NODES[kind]])
    return table[:, 1:3], {kind: order[np.array(rows, dtype=int)] for kind, rows in found.items()}


def cross(u, v):
    return u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]


def corner_products(places):
    """Returns the cross product of the two edges at each corner, and the product of their lengths."""
    ahead = np.roll(places, -1, axis=1) - places
    back = -np.roll(ahead, 1, axis=1)
    length = np.linalg.norm(ahead, axis=2)
    return cross(ahead, back), length * np.roll(length, 1, axis=1)


def judge(nodes, faces, rho=None):
    """Returns a dict: quads, tris, inverted (quadrilaterals with a corner of 180 degrees or more), scaled Jacobians of
    quadrilaterals (mean, least), irregular (% of the inner nodes without four edges), delta (mean conformity of edges).
    rho: the spacing, a function of x and y."""
    corners = [(faces[kind][:, :CORNERS[kind]]) for kind in faces]
    quads = [c for c in corners if c.shape[1] == 4]
    quads = np.concatenate(quads) if quads else np.zeros((0, 4), dtype=int)
    tris = [c for c in corners if c.shape[1] == 3]
    tris = np.concatenate(tris) if tris else np.zeros((0, 3), dtype=int)
    places = nodes[quads]
    clockwise = cross(places[:, 2] - places[:, 0], places[:, 3] - places[:, 1]) < 0
    places[clockwise] = places[clockwise][:, ::-1]
    products, lengths = corner_products(places)
    shapes = (products / np.maximum(lengths, 1e-300)).min(axis=1)
    ends = np.concatenate([np.stack([c, np.roll(c, -1, axis=1)], axis=2).reshape(-1, 2) for c in (quads, tris)])
    ends = np.sort(ends, axis=1)
    edges, count = np.unique(ends, axis=0, return_counts=True)
    used = np.unique(ends)
    valence = np.bincount(edges.ravel(), minlength=len(nodes))
    inner = np.zeros(len(nodes), dtype=bool)
    inner[used] = True
    inner[edges[count == 1].ravel()] = False
    found = {"quads": len(quads), "tris": len(tris), "inverted": int((products <= 0).any(axis=1).sum()),
             "nonconforming": int((count > 2).sum()),
             "mean": float(shapes.mean()), "least": float(shapes.min()),
             "irregular": 100.0 * float((valence[inner] != 4).mean())}
    if rho is not None:
        size = rho(nodes[:, 0], nodes[:, 1])
        ratio = np.linalg.norm(nodes[edges[:, 0]] - nodes[edges[:, 1]], axis=1) / (0.5 * size[edges].sum(axis=1))
        found["delta"] = float(np.minimum(ratio, 1.0 / ratio).mean())
    return found


def gradients(kind, steps):
    """Returns the derivatives of the shape functions at a grid of places of the reference element."""
    if CORNERS[kind] == 3:
        r, s = np.array([(a, b) for a in steps for b in steps if a + b < 1.0 + 1e-12]).T
        rest, zero = 1.0 - r - s, 0.0 * r
        along_r = [1 - 4 * rest, 4 * r - 1, zero, 4 * (rest - r), 4 * s, -4 * s]
        along_s = [1 - 4 * rest, zero, 4 * s - 1, -4 * r, 4 * r, 4 * (rest - s)]
        return np.stack(along_r, 1), np.stack(along_s, 1)
    r, s = 2.0 * np.array([(a, b) for a in steps for b in steps]).T - 1.0
    corners, middles = [(-1, -1), (1, -1), (1, 1), (-1, 1)], [(0, -1), (1, 0), (0, 1), (-1, 0)]
    if kind == 10:
        def line(t, at):
            return {-1: (0.5 * t * (t - 1), t - 0.5), 0: (1 - t * t, -2 * t), 1: (0.5 * t * (t + 1), t + 0.5)}[at]
        nodes = [*corners, *middles, (0, 0)]
        return (np.stack([line(r, a)[1] * line(s, b)[0] for a, b in nodes], 1),
                np.stack([line(r, a)[0] * line(s, b)[1] for a, b in nodes], 1))
    along_r = [0.25 * a * (1 + b * s) * (2 * a * r + b * s) for a, b in corners]
    along_s = [0.25 * b * (1 + a * r) * (2 * b * s + a * r) for a, b in corners]
    along_r += [-r * (1 + b * s) if a == 0 else 0.5 * a * (1 - s * s) for a, b in middles]
    along_s += [0.5 * b * (1 - r * r) if a == 0 else -s * (1 + a * r) for a, b in middles]
    return np.stack(along_r, 1), np.stack(along_s, 1)


def least_uniformity(nodes, faces, samples=31):
    """Returns the least ratio of the smallest Jacobian determinant to the largest of all elements of second order,
    sampled at samples² places of each."""
    least = 1.0
    for kind, elements in faces.items():
        along_r, along_s = gradients(kind, np.linspace(0.0, 1.0, samples))
        for part in np.array_split(elements, 1 + len(elements) // 20000):
            values = cross(np.einsum("gk,ekx->egx", along_r, nodes[part]), np.einsum("gk,ekx->egx", along_s, nodes[part]))
            least = min(least, float((values.min(axis=1) / values.max(axis=1)).min()))
    return least
