"""Meshes one case with Gmsh: peer_gmsh.py CASE OUT.msh. Prints mesh_cpu=SECONDS of the call that makes the triangles.

Uses algorithm 6, "front2d", which is also Gmsh's default."""

import sys
import time

import gmsh

from peer_cases import CASES

case, out = CASES[sys.argv[1]], sys.argv[2]
gmsh.initialize()
for name, value in (("General.Terminal", 0), ("General.NumThreads", 1), ("Mesh.Algorithm", 6),
                    ("Mesh.MeshSizeExtendFromBoundary", 0), ("Mesh.MeshSizeFromPoints", 0),
                    ("Mesh.MeshSizeFromCurvature", 0), ("Mesh.MshFileVersion", 2.2),
                    ("Mesh.MeshSizeMax", case.maximum)):
    gmsh.option.setNumber(name, value)
points = [gmsh.model.geo.addPoint(x, y, 0) for x, y in case.polygon]
lines = [gmsh.model.geo.addLine(a, b) for a, b in zip(points, points[1:] + points[:1])]
surface = gmsh.model.geo.addPlaneSurface([gmsh.model.geo.addCurveLoop(lines)])
gmsh.model.geo.synchronize()
gmsh.model.addPhysicalGroup(2, [surface])
if case.graded:
    # MeshSizeMin gives the same mesh as the maximum of two formulas, with one formula less to evaluate.
    field = gmsh.model.mesh.field.add("MathEval")
    gmsh.model.mesh.field.setString(field, "F", case.off_circle.replace("abs", "Fabs").replace("sqrt", "Sqrt"))
    gmsh.model.mesh.field.setAsBackgroundMesh(field)
    gmsh.option.setNumber("Mesh.MeshSizeMin", case.minimum)
gmsh.model.mesh.generate(1)
start = time.process_time()
gmsh.model.mesh.generate(2)
print(f"mesh_cpu={time.process_time() - start:.6f}")
gmsh.write(out)
