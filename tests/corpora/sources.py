"""Fetches the public files of the corpora and converts them to formats that Forefront reads.

Nothing of this is committed: the repositories are cloned, or read from clones given with --repositories, and the files
are written to a folder outside the repository.
"""

import fnmatch
import hashlib
import json
import math
import pathlib
import re
import subprocess
import tempfile
import xml.etree.ElementTree as xml

import areas

# repository, licence
SOURCES = {
    "logos": ("simple-icons/simple-icons", "CC0"),
    "earcut": ("mapbox/earcut", "ISC"),
    "cdt": ("artem-ogre/CDT", "MPL-2.0"),
    "geos": ("libgeos/geos", "LGPL-2.1"),
    "jts": ("locationtech/jts", "EPL-2.0 or EDL-1.0"),
    "maps": ("martynafford/natural-earth-geojson", "CC0, data public domain"),
    "countries": ("johan/world.geo.json", "Unlicense"),
}

SAMPLE_SIZE = 150  # maximum number of files taken from each of the following
# repository, licence, patterns
SAMPLES = {
    "bootstrap": ("twbs/icons", "MIT", ["icons/*.svg"]),
    "breeze": ("KDE/breeze-icons", "LGPL-3.0", ["icons/*.svg"]),
    "circles": ("numixproject/numix-icon-theme-circle", "GPL-3.0", ["*/48/apps/*.svg"]),
    "cards": ("htdebeer/SVG-cards", "LGPL-2.1", ["*.svg"]),
    "devicon": ("devicons/devicon", "MIT", ["icons/*-original.svg", "icons/*-plain.svg"]),
    "emoji": ("mozilla/fxemoji", "CC-BY-4.0", ["svgs/FirefoxEmoji/*.svg"]),
    "flags": ("hampusborgos/country-flags", "public domain", ["svg/*.svg"]),
    "flags-4x3": ("lipis/flag-icons", "MIT", ["flags/4x3/*.svg"]),
    "games": ("game-icons/icons", "CC-BY-3.0", ["*.svg"]),
    "health": ("resolvetosavelives/healthicons", "MIT", ["public/icons/svg/*.svg"]),
    "logos-in-colour": ("gilbarbara/logos", "CC0", ["logos/*.svg"]),
    "lucide": ("lucide-icons/lucide", "ISC", ["icons/*.svg"]),
    "material": ("PKief/vscode-material-icon-theme", "MIT", ["icons/*.svg"]),
    "noto": ("googlefonts/noto-emoji", "OFL-1.1", ["svg/*.svg"]),
    "octicons": ("primer/octicons", "MIT", ["icons/*.svg"]),
    "paper": ("snwh/paper-icon-theme", "CC-BY-SA-4.0", ["*/48x48/apps/*.svg", "*/scalable/*.svg"]),
    "phosphor": ("phosphor-icons/core", "MIT", ["raw/*.svg"]),
    "svg-maps": ("VictorCazanave/svg-maps", "MIT", ["packages/*.svg"]),
    "tiny": ("edent/SuperTinyIcons", "MIT", ["images/svg/*.svg"]),
    "vscode": ("vscode-icons/vscode-icons", "MIT", ["icons/*.svg"]),
    "cities": ("codeforgermany/click_that_hood", "MIT", ["public/data/*.geojson"]),
    "france": ("gregoiredavid/france-geojson", "Licence Ouverte", ["*.geojson"]),
    "germany": ("isellsoap/deutschlandGeoJSON", "Unlicense", ["*.json"]),
    "india": ("datameet/maps", "MIT", ["*.geojson", "*.json"]),
    "italy": ("openpolis/geojson-italy", "CC-BY-4.0", ["geojson/*.geojson", "topojson/*.json"]),
    "korea": ("southkorea/southkorea-maps", "various", ["*/json/*.json"]),
    "neighbourhoods": ("blackmad/neighborhoods", "not stated", ["*.geojson"]),
    "topojson": ("deldersveld/topojson", "MIT", ["*.json"]),
    "uk": ("martinjc/UK-GeoJSON", "Open Government Licence", ["json/*.json"]),
}


MAX_NAME = 120  # characters
SYMBOLIC_LINK = "120000"  # git's mode


class Repository:
    """A git directory whose newest commit is read without a work tree."""

    def __init__(self, directory):
        self.git = ["git", f"--git-dir={directory}"]
        listing = subprocess.run(self.git + ["ls-tree", "-r", "-z", "HEAD"], check=True, capture_output=True).stdout
        self.objects = {}
        for line in listing.decode().split("\0"):
            if line:
                about, path = line.split("\t", 1)
                mode, _, name = about.split()
                if mode != SYMBOLIC_LINK:
                    self.objects[path] = name

    def paths(self, *patterns):
        """Returns the paths that match a pattern."""
        return sorted(p for p in self.objects if any(fnmatch.fnmatch(p, pattern) for pattern in patterns))

    def files(self, *patterns):
        """Yields path and content of each file that matches a pattern and is present."""
        yield from self.read(self.paths(*patterns))

    def read(self, wanted):
        """Yields path and content of each of these files that is present."""
        with subprocess.Popen(self.git + ["cat-file", "--batch"], stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE) as batch:
            for path in wanted:
                batch.stdin.write(self.objects[path].encode() + b"\n")
                batch.stdin.flush()
                answer = batch.stdout.readline().split()
                if answer[-1] != b"missing":
                    content = batch.stdout.read(int(answer[2]))
                    batch.stdout.read(1)
                    yield path, content
            batch.stdin.close()


def open_repository(name, clones, folder):
    """Finds OWNER+NAME in the folder of clones, or clones it from GitHub."""
    local = (clones / name.replace("/", "+")) if clones else None
    for candidate in ([local, local / ".git", local / "repo", local / "repo/.git"] if local else []):
        if (candidate / "HEAD").is_file():
            return Repository(candidate)
    target = pathlib.Path(folder) / name.replace("/", "+")
    subprocess.run(["git", "clone", "--quiet", "--bare", "--depth", "1", f"https://github.com/{name}", str(target)],
                   check=True)
    return Repository(target)


def polygon_features(polygons):
    """Returns GeoJSON text with one feature per polygon, a list of rings each."""
    return json.dumps({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": rings}}
        for rings in polygons]})


def closed(ring):
    return ring if ring[:1] == ring[-1:] else ring + ring[:1]


def fetch_logos(repository, folder):
    for path, content in repository.files("icons/*.svg"):
        (folder / path.split("/")[-1]).write_bytes(content)


def fetch_earcut(repository, folder):
    """Writes each fixture, a list of an outline and its holes, as a polygon."""
    for path, content in repository.files("test/fixtures/*.json"):
        rings = [closed([point[:2] for point in ring]) for ring in json.loads(content)]
        name = pathlib.PurePosixPath(path).stem
        (folder / f"{name}.geojson").write_text(polygon_features([rings]))


def fetch_cdt(repository, folder):
    """Writes the edges of each input as lines of a drawing; points without edges have no domain and are left out."""
    for path, content in repository.files("CDT/tests/inputs/*.txt"):
        words = content.split()
        nodes, edges = int(words[0]), int(words[1])
        places = [(float(words[2 + 2 * i]), float(words[3 + 2 * i])) for i in range(nodes)]
        ends = [(int(words[2 + 2 * nodes + 2 * i]), int(words[3 + 2 * nodes + 2 * i])) for i in range(edges)]
        if not ends:
            continue
        lines = "".join(f'<path d="M{places[a][0]!r},{places[a][1]!r}L{places[b][0]!r},{places[b][1]!r}"/>\n'
                        for a, b in ends)
        name = pathlib.PurePosixPath(path).stem.replace(" ", "-")
        (folder / f"{name}.svg").write_text(areas.DRAWING_OF_LINES + lines + "</g></svg>\n")


def polygons_of(geometry):
    """Returns the polygons of a shapely geometry as lists of rings."""
    if geometry.geom_type == "Polygon":
        rings = [geometry.exterior, *geometry.interiors]
        return [[[list(c[:2]) for c in ring.coords] for ring in rings]] if not geometry.is_empty else []
    return [p for part in getattr(geometry, "geoms", []) for p in polygons_of(part)]


def fetch_overlays(repository, folder, pattern):
    """Writes the polygons of each test case of GEOS or JTS, those of a and b together, as a map."""
    import shapely.errors  # pylint: disable=import-outside-toplevel
    from shapely import wkb, wkt  # pylint: disable=import-outside-toplevel

    for path, content in repository.files(pattern):
        try:
            root = xml.fromstring(content)
        except xml.ParseError:
            continue
        stem = pathlib.PurePosixPath(path).stem
        for number, case in enumerate(root.iter("case")):
            polygons = []
            for text in (" ".join((case.findtext(tag) or "").split()) for tag in ("a", "b")):
                is_polygon = re.search(r"\bPOLYGON|MULTIPOLYGON", text.upper()) and "CURVE" not in text.upper()
                if not is_polygon and text[:2] not in ("00", "01"):
                    continue
                try:
                    geometry = wkb.loads(text.replace(" ", ""), hex=True) if text[:2] in ("00", "01") else wkt.loads(text)
                    polygons += [p for p in polygons_of(geometry)
                                 if all(math.isfinite(x) for ring in p for place in ring for x in place)]
                except (shapely.errors.ReadingError, shapely.errors.ShapelyError, ValueError):
                    continue
            if polygons:
                (folder / f"{stem}-{number}.geojson").write_text(polygon_features(polygons))


def has_polygons(content):
    return b'"Polygon"' in content or b'"MultiPolygon"' in content


def fetch_maps(repository, folder):
    """Writes the polygon layers of Natural Earth. Large ones are missing in some clones, but not their archives."""
    for path, content in repository.files("*/*.json"):
        if has_polygons(content):
            (folder / (pathlib.PurePosixPath(path).stem + ".geojson")).write_bytes(content)
    for path, content in repository.files("*/*.7z"):
        target = folder / (pathlib.PurePosixPath(path).stem + ".geojson")
        if target.exists():
            continue
        with tempfile.NamedTemporaryFile(suffix=".7z") as archive:
            archive.write(content)
            archive.flush()
            text = subprocess.run(["7zz", "e", "-so", archive.name], check=True, capture_output=True).stdout
        if has_polygons(text):
            target.write_bytes(text)


def fetch_countries(repository, folder):
    """Writes countries and states, one a file, and the map of all countries."""
    for path, content in repository.files("countries/???.geo.json", "countries/USA/??.geo.json", "countries.geo.json"):
        if has_polygons(content):
            name = path.replace("countries/", "").replace("/", "-").replace(".geo.json", "")
            (folder / f"{name}.geojson").write_bytes(content)


def fetch_sample(repository, folder, patterns):
    """Writes files in an order that depends on their paths alone, without copies of the same content."""
    paths = sorted(repository.paths(*patterns), key=lambda path: hashlib.sha256(path.encode()).digest())
    distinct = {repository.objects[path]: path for path in reversed(paths)}
    for path, content in repository.read([p for p in paths if distinct[repository.objects[p]] == p][:SAMPLE_SIZE]):
        (folder / path.replace("/", "-")[-MAX_NAME:]).write_bytes(content)


FETCHERS = {
    "logos": fetch_logos,
    "earcut": fetch_earcut,
    "cdt": fetch_cdt,
    "geos": lambda repository, folder: fetch_overlays(repository, folder, "tests/xmltester/tests/*.xml"),
    "jts": lambda repository, folder: fetch_overlays(repository, folder, "modules/tests/src/test/resources/testxml/*"),
    "maps": fetch_maps,
    "countries": fetch_countries,
}


def fetch(names, folder, clones):
    """Writes the corpora of these names below a folder."""
    with tempfile.TemporaryDirectory() as scratch:
        for name in names:
            target = folder / name
            target.mkdir(parents=True, exist_ok=True)
            origin, licence = (SAMPLES[name][:2] if name in SAMPLES else SOURCES[name])
            repository = open_repository(origin, clones, scratch)
            if name in SAMPLES:
                fetch_sample(repository, target, SAMPLES[name][2])
            else:
                FETCHERS[name](repository, target)
            print(f"{name}: {sum(1 for _ in target.iterdir())} files from github.com/{origin} ({licence})", flush=True)
