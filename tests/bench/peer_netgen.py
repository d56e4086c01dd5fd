"""Meshes one case with Netgen: peer_netgen.py CASE OUT.msh. Prints mesh_cpu=SECONDS of the call that makes the mesh."""

import sys
import time

from netgen.geom2d import SplineGeometry
from netgen.meshing import MeshingParameters

from peer_cases import CASES

# Netgen ignores a requested size unless it is more than 1.2 times finer than the present one. With this factor on the
# spacing, it makes about as many elements as the others.
SCALE = 0.9

case, out = CASES[sys.argv[1]], sys.argv[2]
geometry = SplineGeometry()
points = [geometry.AppendPoint(x, y) for x, y in case.polygon]
for a, b in zip(points, points[1:] + points[:1]):
    geometry.Append(["line", a, b], leftdomain=1, rightdomain=0)
settings = MeshingParameters(maxh=case.maximum, grading=0.3)
if case.graded:
    for x, y, h in case.samples():
        settings.RestrictH(x, y, 0, SCALE * h)
start = time.process_time()
mesh = geometry.GenerateMesh(mp=settings)
print(f"\nmesh_cpu={time.process_time() - start:.6f}")
nodes = mesh.Points()
elements = list(mesh.Elements2D())
with open(out, "w") as file:
    file.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(nodes)}\n")
    file.writelines(f"{i} {p[0]!r} {p[1]!r} 0\n" for i, p in enumerate(nodes, 1))
    file.write(f"$EndNodes\n$Elements\n{len(elements)}\n")
    file.writelines(f"{i} 2 2 1 1 {' '.join(str(v.nr) for v in e.vertices)}\n" for i, e in enumerate(elements, 1))
    file.write("$EndElements\n")
