"""Reads exported meshes with QGIS, by its library MDAL, whose packages are some 600 MB on the disc, so that the ordinary tests
leave it out.

    check_qgis.py EXPORT_SAMPLE RESULT [PICTURE|- [FILE.nc=EPSG:n...]]      (needs the Debian package python3-qgis)

EXPORT_SAMPLE is the helper that writes the files. The outcome is printed and written to RESULT; PICTURE (.png) gets the
first FILE.nc, or else the first mesh, as QGIS draws it: coloured by the elevations of its nodes, with thin lines. Each FILE.nc, a mesh of a map in UGRID, must have that reference system. Exit status 77: QGIS is missing.
"""
import datetime
import math
import os
import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True  # keeps the source tree clean
os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
from check_cells import Cells
from common import Samples, measures, near, same

try:
    from qgis.core import (QgsApplication, QgsColorRampShader, QgsGradientColorRamp, QgsMapRendererParallelJob,
                           QgsMapSettings, QgsMesh, QgsMeshLayer, QgsMeshRendererMeshSettings,
                           QgsMeshRendererScalarSettings, QgsProviderRegistry)
    from qgis.PyQt.QtCore import QSize
    from qgis.PyQt.QtGui import QColor
except ImportError as problem:
    print("QGIS is missing:", problem)
    sys.exit(77)


def read_layer(file):
    layer = QgsMeshLayer(file, "mesh", "mdal")
    assert layer.isValid(), f"QGIS cannot read {file}"
    mesh = QgsMesh()
    layer.dataProvider().populateMesh(mesh)
    return layer, mesh


def check_mesh(sample, file, tolerance):
    _, mesh = read_layer(file)
    same((mesh.vertexCount(), mesh.faceCount()), (sample.nodes, sample.elements), "nodes and elements")
    places = [mesh.vertex(n) for n in range(mesh.vertexCount())]
    found = measures((0, [(places[n].x(), places[n].y()) for n in mesh.face(k)]) for k in range(mesh.faceCount()))
    near(found[0][1], sample.area(), tolerance)


def polygon_area(corners):
    return 0.5 * sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(corners, corners[1:] + corners[:1]))


def check_cells(cells, file, corners):
    """The same faces by their numbers of corners, and the same area where edges are straight. Triangles of 6 nodes are polygons
    through all of them."""
    _, mesh = read_layer(file)
    same(mesh.vertexCount(), len(cells.nodes), "nodes")
    places = [(mesh.vertex(n).x(), mesh.vertex(n).y()) for n in range(mesh.vertexCount())]
    faces = [[places[n] for n in mesh.face(k)] for k in range(mesh.faceCount())]
    same(sorted(map(len, faces)), sorted(len(nodes) for *_, nodes in cells.elements()), "corners of faces")
    same(set(map(len, faces)), corners, "numbers of corners")
    if max(corners) <= 4:
        near(math.fsum(map(polygon_area, faces)), cells.area())


def check_refused(file):
    """MDAL knows no quadrilaterals of second order; FORMATS.md says so."""
    assert not QgsMeshLayer(file, "mesh", "mdal").isValid(), "QGIS reads them now: say so"


def check_values(file, name):
    layer, _ = read_layer(file)
    data = layer.dataProvider()
    groups = [data.datasetGroupMetadata(k).name() for k in range(data.datasetGroupCount())]
    assert any(group.split()[0] == name for group in groups), f"no values {name} among {groups}"


def check_xdmf_is_no_mesh(sample):
    """MDAL takes XDMF for values of a mesh in another file, and those only as time series."""
    registry = QgsProviderRegistry.instance()
    assert "xdmf" not in registry.fileMeshFilters().lower(), "QGIS reads meshes from XDMF now: let it read ours"
    assert "xdmf" in registry.fileMeshDatasetFilters().lower()
    layer, _ = read_layer(sample.files["2dm"])
    assert not layer.dataProvider().addDataset(sample.files["xdmf"]), "QGIS reads our values from XDMF now: say so"


def check_system(file, expected):
    """The reference system of a UGRID file, made by `forefront mesh` from a map."""
    layer, _ = read_layer(file)
    found = layer.crs().authid() or layer.crs().toProj()
    assert expected in found, f"expected {expected}, found {found}"


def colour_by_elevation(layer, settings):
    """Colours the values of the first group, the bed, from dark blue to white, if there are some."""
    data = layer.dataProvider()
    if data.datasetGroupCount() == 0:
        return
    bed = data.datasetGroupMetadata(0)
    low, high = bed.minimum(), bed.maximum()
    ramp = QgsGradientColorRamp(QColor(20, 60, 120), QColor(235, 245, 250))
    shader = QgsColorRampShader(low, high, ramp)
    shader.classifyColorRamp(16)
    colours = QgsMeshRendererScalarSettings()
    colours.setClassificationMinimumMaximum(low, high)
    colours.setColorRampShader(shader)
    settings.setScalarSettings(0, colours)
    settings.setActiveScalarDatasetGroup(0)


def draw(file, picture):
    layer, _ = read_layer(file)
    settings = layer.rendererSettings()
    lines = QgsMeshRendererMeshSettings()
    lines.setEnabled(True)
    lines.setColor(QColor(40, 50, 70, 90))
    lines.setLineWidth(0.1)
    settings.setNativeMeshSettings(lines)
    colour_by_elevation(layer, settings)
    layer.setRendererSettings(settings)
    view = QgsMapSettings()
    view.setLayers([layer])
    view.setOutputSize(QSize(1000, 600))
    view.setBackgroundColor(QColor(255, 255, 255))
    box = layer.extent()
    box.scale(1.05)
    view.setExtent(box)
    job = QgsMapRendererParallelJob(view)
    job.start()
    job.waitForFinished()
    assert job.renderedImage().save(picture), f"cannot write {picture}"


def main():
    program, result = sys.argv[1:3]
    QgsApplication.setPrefixPath("/usr", True)
    application = QgsApplication([], False)
    application.initQgis()
    samples = Samples(program)
    checks = []
    for name in ("sample", "twins"):
        sample = samples[name]
        for kind, tolerance in (("2dm", 1e-9), ("ugrid", 1e-9), ("selafin", 1e-5)):
            checks.append((f"{kind} of {name} by QGIS",
                           lambda s=sample, k=kind, t=tolerance: check_mesh(s, s.files[k], t)))
    mixed = Cells(samples.folder, "mixed")
    checks += [(f"{kind} of triangles and quadrilaterals by QGIS", lambda k=kind: check_cells(mixed, mixed.files[k], {3, 4}))
               for kind in ("2dm", "ugrid")]
    curved = Cells(samples.folder, "curved6")
    checks.append(("2dm of curved6 by QGIS", lambda: check_cells(curved, curved.files["2dm"], {6})))
    checks += [(f"2dm of {name} is refused by QGIS", lambda n=name: check_refused(Cells(samples.folder, n).files["2dm"]))
               for name in ("curved8", "curved9")]
    checks.append(("values of SELAFIN by QGIS", lambda: check_values(samples["sample"].files["selafin"], "bottom")))
    checks.append(("XDMF is no mesh for QGIS", lambda: check_xdmf_is_no_mesh(samples["sample"])))
    checks += [(f"{os.path.basename(file)} by QGIS", lambda f=file, s=system: check_system(f, s))
               for file, system in (pair.split("=", 1) for pair in sys.argv[4:])]
    if len(sys.argv) > 3 and sys.argv[3] != "-":
        shown = sys.argv[4].split("=", 1)[0] if len(sys.argv) > 4 else samples["sample"].files["2dm"]
        checks.append(("picture by QGIS", lambda: draw(shown, sys.argv[3])))
    lines, passed = samples.run(checks)
    version = subprocess.run(["dpkg-query", "-W", "-f", "${Package} ${Version}\\n", "python3-qgis"], capture_output=True,
                             text=True)
    pathlib.Path(result).write_text("\n".join([f"Last run: {datetime.date.today()}", version.stdout, *lines]) + "\n")
    sys.stdout.flush()
    application.exitQgis()
    sys.exit(0 if passed else 1)


main()
