"""Reads exported meshes with QGIS, by its library MDAL, whose packages are some 600 MB on the disc, so that the ordinary tests
leave it out.

    check_qgis.py EXPORT_SAMPLE RESULT [PICTURE]      (needs the Debian package python3-qgis)

EXPORT_SAMPLE is the helper that writes the files. The outcome is printed and written to RESULT; PICTURE (.png) gets the
first mesh as QGIS draws it. Exit status 77: QGIS is missing.
"""
import datetime
import os
import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True  # keeps the source tree clean
os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
from common import Samples, measures, near, same

try:
    from qgis.core import (QgsApplication, QgsMapRendererParallelJob, QgsMapSettings, QgsMesh, QgsMeshLayer,
                           QgsMeshRendererMeshSettings)
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


def check_values(file, name):
    layer, _ = read_layer(file)
    data = layer.dataProvider()
    groups = [data.datasetGroupMetadata(k).name() for k in range(data.datasetGroupCount())]
    assert any(group.split()[0] == name for group in groups), f"no values {name} among {groups}"


def draw(file, picture):
    layer, _ = read_layer(file)
    settings = layer.rendererSettings()
    lines = QgsMeshRendererMeshSettings()
    lines.setEnabled(True)
    lines.setColor(QColor(30, 60, 110))
    settings.setNativeMeshSettings(lines)
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
    checks.append(("values of SELAFIN by QGIS", lambda: check_values(samples["sample"].files["selafin"], "bottom")))
    if len(sys.argv) > 3:
        checks.append(("picture by QGIS", lambda: draw(samples["sample"].files["2dm"], sys.argv[3])))
    lines, passed = samples.run(checks)
    version = subprocess.run(["dpkg-query", "-W", "-f", "${Package} ${Version}\\n", "python3-qgis"], capture_output=True,
                             text=True)
    pathlib.Path(result).write_text("\n".join([f"Last run: {datetime.date.today()}", version.stdout, *lines]) + "\n")
    sys.stdout.flush()
    application.exitQgis()
    sys.exit(0 if passed else 1)


main()
