#!/usr/bin/env python3
"""Maps and rasters that the component forefront-gdal reads, made from GeoJSON and text by the programs of GDAL.

    test_maps.py PROGRAM [NAME OF A TEST...]

Exit status 77: GDAL's programs or the component are missing.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv.pop(1))

if not all(map(shutil.which, ("ogr2ogr", "gdal_translate"))):
    print("ogr2ogr or gdal_translate is missing (on Debian gdal-bin)")
    sys.exit(77)


def feature(geometry, coordinates, **properties):
    return {"type": "Feature", "properties": properties, "geometry": {"type": geometry, "coordinates": coordinates}}


def square(x, y, size):
    return [[x, y], [x + size, y], [x + size, y + size], [x, y + size], [x, y]]


# Two neighbours with a common side, a hole in one, and an island of its own; metres in UTM zone 35.
X, Y = 380000.0, 6670000.0
MAP = {"type": "FeatureCollection",
       "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::3067"}},
       "features": [
           feature("Polygon", [square(X, Y, 100), square(X + 40, Y + 40, 20)[::-1]], name="meadow", soil="clay", h=20.0),
           feature("Polygon", [square(X + 100, Y, 100)], name="wood", soil="sand", h=5.0),
           feature("MultiPolygon", [[square(X + 300, Y, 50)]], name="isle", soil="clay", h=12.5)]}


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        (self.path / "map.geojson").write_text(json.dumps(MAP))

    def call(self, *words, code=0, env=None):
        done = subprocess.run([PROGRAM, *map(str, words)], cwd=self.path, capture_output=True, text=True, timeout=120,
                              env={**os.environ, **(env or {})})
        self.assertEqual(done.returncode, code, f"{words}\n{done.stdout}\n{done.stderr}")
        return done

    def mesh(self, *words):
        """The statistics of a mesh."""
        return json.loads(self.call("mesh", *words, "--stats", "-", "-q").stdout)

    def gdal(self, *words):
        done = subprocess.run(list(map(str, words)), cwd=self.path, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def convert(self, name, *words, source="map.geojson"):
        self.gdal("ogr2ogr", *words, name, source)
        return name

    def grid(self, value, name="grid.asc", size=12, cell=50.0, nodata=-9999):
        """An ESRI ASCII grid around the map; value(x, y) at the centre of a cell."""
        x, y = X - 100.0, Y - 100.0
        rows = [" ".join(str(value(x + (c + 0.5) * cell, y + (r + 0.5) * cell)) for c in range(size))
                for r in reversed(range(size))]
        (self.path / name).write_text(f"ncols {size}\nnrows {size}\nxllcorner {x}\nyllcorner {y}\ncellsize {cell}\n"
                                      f"NODATA_value {nodata}\n" + "\n".join(rows) + "\n")
        return name


class Maps(Case):
    def test_every_format_gives_the_mesh_of_geojson(self):
        truth = self.mesh("map.geojson", "--size", 10, "-o", "truth.msh")
        self.assertEqual({part["name"] for part in truth["regions"]}, {"meadow", "wood", "isle"})
        for name in ("map.gpkg", "map.fgb", "map.shp"):  # FlatGeobuf sorts the features, shapefiles turn outlines round
            with self.subTest(name):
                self.convert(name)
                self.convert("back.geojson", source=name)
                found = self.mesh(name, "--size", 10, "-o", "found.msh")
                self.assertEqual(found["hash"], self.mesh("back.geojson", "--size", 10, "-o", "back.msh")["hash"])
                self.assertAlmostEqual(found["area"], truth["area"], places=6)
                self.assertEqual({part["name"] for part in found["regions"]}, {"meadow", "wood", "isle"})
                (self.path / "back.geojson").unlink()
        with open(self.path / "map.gpkg", "rb") as file:
            done = subprocess.run([PROGRAM, "mesh", "-", "--size", "10", "-o", "-", "--format", "msh2", "-q"], stdin=file,
                                  cwd=self.path, capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(b"meadow", done.stdout)

    def test_parts_are_named_in_the_coordinates_of_the_map(self):
        self.convert("ll.gpkg", "-t_srs", "EPSG:4326")
        isle = json.loads(subprocess.run(["ogr2ogr", "-f", "GeoJSON", "/vsistdout/", "ll.gpkg"], cwd=self.path, check=True,
                                         capture_output=True, text=True).stdout)["features"][2]["geometry"]["coordinates"][0][0]
        sea = "sea:{},{};{},{}".format(*isle[0], *isle[1])
        found = self.mesh("ll.gpkg", "--projection", "EPSG:3067", "--size", 10, "-o", "a.nc", "--name", sea)
        lengths = {part["name"]: part["length"] for part in found["boundaries"]}
        self.assertAlmostEqual(lengths["sea"], 50, delta=0.1)
        self.assertAlmostEqual(lengths["isle"], 150, delta=0.3)
        text = (self.path / "a.nc").read_bytes()
        for words in (b"EPSG:3067", b"crs_wkt", b"projected_coordinate_system"):
            self.assertIn(words, text)
        self.mesh("ll.gpkg", "--allow-degrees", "-o", "b.nc")
        self.assertIn(b"wgs84", (self.path / "b.nc").read_bytes())
        self.assertIn("cannot be converted", self.call("mesh", "ll.gpkg", "--projection", "EPSG:3067", "-o", "c.nc", "--name",
                                               f"sea:{X},{Y};{X + 100},{Y}", code=1).stderr)

    def test_hostile_maps_are_refused_or_read(self):
        """GDAL's driver for KML must not get models within collections, and no geometry may end the program."""
        ring = "<coordinates>0,0 1,0 1,1 0,1 0,0</coordinates>"
        area = f"<Polygon><outerBoundaryIs><LinearRing>{ring}</LinearRing></outerBoundaryIs></Polygon>"
        kml = '<kml xmlns="http://www.opengis.net/kml/2.2"><Document><Placemark><name>a</name>{}</Placemark></Document></kml>'
        for inner in ("<Model/>", "<MultiGeometry><Model><Link/></Model></MultiGeometry>"):
            (self.path / "m.kml").write_text(kml.format(f"<MultiGeometry>{area}{inner}</MultiGeometry>"))
            self.assertIn("3D models are left out", self.call("mesh", "m.kml", "--allow-degrees", "-o", "a.msh").stderr)
        for inner in ("<MultiGeometry/>", "<MultiGeometry><Model/></MultiGeometry>", "<Point/>",
                      "<LineString><coordinates>1,nan 2,inf</coordinates></LineString>"):
            (self.path / "m.kml").write_text(kml.format(inner))
            self.call("mesh", "m.kml", "--allow-degrees", "-o", "a.msh", code=1)
        for coordinates in ("[[[0, 0], [1e308, 0], [1e308, 1e308], [0, 0]]]", "[[]]", "[[[0, 0], [1, NaN], [1, 1], [0, 0]]]", "[]"):
            (self.path / "m.geojson").write_text('{"type": "Polygon", "coordinates": %s}' % coordinates)
            self.call("mesh", "m.geojson", "--projection", "EPSG:3067", "-o", "a.msh", code=1)

    def test_degrees_and_projections(self):
        self.convert("map.kml")
        told = self.call("mesh", "map.kml", "-o", "a.msh").stderr
        self.assertIn("longitudes and latitudes in degrees", told)
        for name in ("map.kml", self.convert("ll.gpkg", "-t_srs", "EPSG:4326"),
                     self.convert("ll.geojson", "-t_srs", "EPSG:4326")):
            with self.subTest(name):
                found = self.mesh(name, "--projection", "EPSG:3067", "--size", 10, "-o", "a.msh")
                self.assertAlmostEqual(found["area"], 100 * 100 - 20 * 20 + 100 * 100 + 50 * 50, delta=0.5)
                told = json.loads(self.call("info", "a.msh", "--json").stdout)["bounds"]
                for value, true in zip(told, (X, Y)):
                    self.assertAlmostEqual(value, true, delta=0.01)
        self.assertIn("--projection", self.call("mesh", "map.kml", "--projection", "UTM", "-o", "a.msh", code=2).stderr)
        wrong = self.call("mesh", "map.kml", "--projection", "EPSG:999999", "-o", "a.msh", code=1).stderr
        self.assertIn("EPSG:999999", wrong)
        for other in ("EPSG:4978", "EPSG:5703"):  # from the middle of the earth; heights alone
            wrong = self.call("mesh", "map.kml", "--projection", other, "-o", "a.msh", code=1).stderr
            self.assertIn(f"'{other}' is not for maps", wrong)

    def test_names_and_sizes_come_from_attributes(self):
        self.convert("map.gpkg")
        found = self.mesh("map.gpkg", "--name-property", "soil", "--size-property", "h", "-o", "a.vtu")
        counts = {part["name"]: part["elements"] for part in found["regions"]}
        self.assertEqual(set(counts), {"clay", "sand"})
        named = self.mesh("map.gpkg", "--size-property", "h", "-o", "a.vtu")
        counts = {part["name"]: part["elements"] for part in named["regions"]}
        self.assertGreater(counts["wood"], 4 * counts["meadow"])  # 5 against 20, and graded
        self.assertEqual(named["hash"], self.mesh("map.geojson", "--size-property", "h", "-o", "a.vtu")["hash"])
        for words, text in ((("--size-property", "soil"), "expected a size above 0"),
                            (("--size-property", "depth"), "no feature has a property 'depth'")):
            self.assertIn(text, self.call("mesh", "map.gpkg", *words, "-o", "a.vtu", code=1).stderr)

    def test_layers(self):
        self.convert("two.gpkg", "-nln", "land")
        (self.path / "sea.geojson").write_text(json.dumps(
            {**MAP, "features": [feature("Polygon", [square(X, Y + 500, 100)], name="sea")]}))
        self.gdal("ogr2ogr", "-update", "-nln", "sea", "two.gpkg", "sea.geojson")
        both = self.mesh("two.gpkg", "--layer", "land,sea", "--size", 20, "-o", "a.msh")
        self.assertEqual(len(both["regions"]), 4)
        told = self.call("mesh", "two.gpkg", "--size", 20, "-o", "a.msh").stderr
        self.assertIn("only the layer 'land' is read", told)
        self.assertIn("no layer 'lake'",
                      self.call("mesh", "two.gpkg", "--layer", "lake", "-o", "a.msh", code=1).stderr)

    def test_broken_files_are_refused(self):
        for name in ("map.gpkg", "map.fgb", "map.kml", "map.shp"):
            self.convert(name)
            whole = (self.path / name).read_bytes()
            for part in (0.02, 0.3, 0.6, 0.9):
                broken = bytearray(whole[:max(120, int(part * len(whole)))])
                broken[len(broken) // 2:len(broken) // 2 + 8] = b"\xff" * 8
                (self.path / name).write_bytes(broken)
                done = subprocess.run([PROGRAM, "mesh", name, "--size", "50", "-o", "a.msh"], cwd=self.path,
                                      capture_output=True, text=True, timeout=60)
                self.assertIn(done.returncode, (0, 1), f"{name} {part} {done.stderr}")
                if done.returncode == 1:
                    self.assertIn("error:", done.stderr)

    def test_without_the_component_it_says_what_to_install(self):
        self.convert("map.gpkg")
        nowhere = {"FOREFRONT_COMPONENTS": str(self.path)}
        told = self.call("mesh", "map.gpkg", "-o", "a.msh", code=1, env=nowhere).stderr
        self.assertIn("install the package forefront-gdal", told)
        self.assertIn("libgdal-dev", told)
        self.assertIn("forefront-hdf5",
                      self.call("mesh", "map.geojson", "--size", 50, "-o", "a.xdmf", code=1, env=nowhere).stderr)
        (self.path / "forefront-gdal.so").write_text("not a library")
        self.assertIn("cannot be loaded", self.call("mesh", "map.gpkg", "-o", "a.msh", code=1, env=nowhere).stderr)


class Rasters(Case):
    def test_elevations_and_sizes(self):
        self.grid(lambda x, y: -5.0 - 0.01 * (x - X), "depth.asc")
        self.grid(lambda x, y: 20.0 if x < X + 150 else 8.0, "size.asc")
        for name in ("depth", "size"):
            self.gdal("gdal_translate", "-q", "-a_srs", "EPSG:3067", "-ot", "Float64", f"{name}.asc", f"{name}.tif")
        self.call("mesh", "map.geojson", "--size", 20, "--elevation", "depth.asc", "-o", "a.14", "-q")
        self.call("mesh", "map.geojson", "--size", 20, "--elevation", "depth.tif", "-o", "b.14", "-q")
        self.assertEqual((self.path / "a.14").read_text(), (self.path / "b.14").read_text())
        sizes = [self.mesh("map.geojson", "--spacing-file", f"size.{kind}", "-o", "a.msh")["hash"] for kind in ("asc", "tif")]
        self.assertEqual(*sizes)

    def test_a_raster_in_degrees_is_converted(self):
        self.grid(lambda x, y: -5.0 - 0.01 * (x - X), "depth.asc", size=40, cell=20.0)
        self.gdal("gdal_translate", "-q", "-a_srs", "EPSG:3067", "-ot", "Float64", "depth.asc", "depth.tif")
        self.gdal("gdalwarp", "-q", "-t_srs", "EPSG:4326", "-r", "bilinear", "depth.tif", "ll.tif")
        self.convert("ll.gpkg", "-t_srs", "EPSG:4326")
        self.call("mesh", "ll.gpkg", "--projection", "EPSG:3067", "--size", 20, "--elevation", "ll.tif", "-o", "a.14", "-q")
        lines = (self.path / "a.14").read_text().splitlines()
        count = int(lines[1].split()[1])
        for line in lines[2:2 + count]:
            _, x, _, depth = map(float, line.split())
            self.assertAlmostEqual(depth, 5.0 + 0.01 * (x - X), delta=0.2)
        sized = self.call("mesh", "ll.gpkg", "--projection", "EPSG:3067", "--raster", "bed=ll.tif", "--spacing",
                          "-4*bed(x,y)", "-o", "b.msh").stderr
        self.assertNotIn("used as they are", sized)  # the coordinates were converted

    def test_a_local_projection_says_that_it_converts_no_raster(self):
        self.grid(lambda x, y: -5.0, "depth.asc", size=40, cell=20.0)
        self.gdal("gdal_translate", "-q", "-a_srs", "EPSG:3067", "-ot", "Float64", "depth.asc", "depth.tif")
        self.convert("ll.gpkg", "-t_srs", "EPSG:4326")
        told = self.call("mesh", "ll.gpkg", "--projection", "local", "--size", 20, "--elevation", "depth.tif", "-o", "a.14",
                         code=1).stderr
        self.assertIn("depth.tif is in EPSG:3067 and the map in metres about its middle", told)
        told = self.call("mesh", "ll.gpkg", "--projection", "EPSG:3067", "--size", 20, "--elevation", "depth.tif", "-o",
                         "a.14").stderr
        self.assertNotIn("raster-system", told)

    def test_a_raster_in_another_system_is_told(self):
        self.grid(lambda x, y: -5.0, "depth.asc", size=40, cell=20.0)
        for code in (32634, 3067):
            self.gdal("gdal_translate", "-q", "-a_srs", f"EPSG:{code}", "-ot", "Float64", "depth.asc", f"d{code}.tif")
        self.convert("map.gpkg")
        words = "d32634.tif is in EPSG:32634 and the map in EPSG:3067"
        for options in (("--size", 20, "--elevation"), ("--spacing", "20+0*d(x,y)", "--raster")):
            for code, told in ((32634, True), (3067, False)):
                file = f"d{code}.tif" if options[-1] == "--elevation" else f"d=d{code}.tif"
                said = self.call("mesh", "map.gpkg", *options, file, "-o", "a.msh" if told else "a.14").stderr
                self.assertEqual(words in said, told, said)

    def test_what_a_raster_cannot_be(self):
        self.grid(lambda x, y: -1.0 if x > X + 100 else 2.0, "depth.asc")
        self.gdal("gdal_translate", "-q", "depth.asc", "bad.tif")
        self.assertIn("expected a size above 0, got -1",
                      self.call("mesh", "map.geojson", "--spacing-file", "bad.tif", "-o", "a.msh", code=1).stderr)
        told = self.call("mesh", "map.geojson", "--projection", "EPSG:3067", "--size", 20, "--elevation", "bad.tif", "-o",
                         "a.14", code=1).stderr
        self.assertIn("names no coordinate reference system", told)
        (self.path / "bad.tif").write_bytes((self.path / "bad.tif").read_bytes()[:300])
        self.assertIn("error:", self.call("mesh", "map.geojson", "--spacing-file", "bad.tif", "-o", "a.msh", code=1).stderr)


def component_is_there():
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "a.fgb").write_bytes(b"fgb\x03fgb\x00")
        done = subprocess.run([PROGRAM, "mesh", "a.fgb", "-o", "a.msh"], cwd=folder, capture_output=True, text=True)
        return "missing-component" not in done.stderr


if __name__ == "__main__":
    if not component_is_there():
        print("the component forefront-gdal was not built")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *sys.argv[1:]])
