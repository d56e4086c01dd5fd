"""Meshes a .poly file with Gmsh's front2d and joins the triangles to quadrilaterals alone, by Blossom:
quad_gmsh.py IN.poly OUT.msh SIZE [SPACING]. Prints the CPU seconds of the call that does both."""

import sys
import time

import gmsh

lines = open(sys.argv[1], encoding="ascii").read().split("\n")
out, size, spacing = sys.argv[2], float(sys.argv[3]), sys.argv[4] if len(sys.argv) > 4 else ""
count = int(lines[0].split()[0])
places = [tuple(map(float, line.split()[1:3])) for line in lines[1:1 + count]]
segments = [tuple(map(int, line.split()[1:4])) for line in lines[2 + count:2 + count + int(lines[1 + count].split()[0])]]

gmsh.initialize()
for name, value in (("General.Terminal", 0), ("General.NumThreads", 1), ("Mesh.Algorithm", 6),
                    ("Mesh.MeshSizeExtendFromBoundary", 0), ("Mesh.MeshSizeFromPoints", 0),
                    ("Mesh.MeshSizeFromCurvature", 0), ("Mesh.MshFileVersion", 2.2), ("Mesh.RecombineAll", 1),
                    ("Mesh.RecombinationAlgorithm", 3), ("Mesh.MeshSizeMin", size),
                    ("Mesh.MeshSizeMax", 6 if spacing else size)):
    gmsh.option.setNumber(name, value)
points = [gmsh.model.geo.addPoint(x, y, 0) for x, y in places]
loops = {}
for a, b, tag in segments:
    loops.setdefault(tag, []).append(gmsh.model.geo.addLine(points[a], points[b]))
surface = gmsh.model.geo.addPlaneSurface([gmsh.model.geo.addCurveLoop(lines) for lines in loops.values()])
gmsh.model.geo.synchronize()
gmsh.model.addPhysicalGroup(2, [surface])
if spacing:
    field = gmsh.model.mesh.field.add("MathEval")
    gmsh.model.mesh.field.setString(field, "F", spacing)
    gmsh.model.mesh.field.setAsBackgroundMesh(field)
start = time.process_time()  # the full-quad method chooses the nodes of the curves itself
gmsh.model.mesh.generate(2)
print(time.process_time() - start)
gmsh.write(out)
