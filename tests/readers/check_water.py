"""Checks the formats of water models: UGRID with SciPy's reader of netCDF, those of TELEMAC, MIKE and ANUGA with small
parsers of their own, since Debian has none of these programs."""
import pathlib
import struct

from scipy.io import netcdf_file

from common import compare, measures, near, same


def check_ugrid(sample, file):
    with netcdf_file(file, mmap=False) as data:
        assert b"UGRID-1.0" in data.Conventions, data.Conventions
        parts = data.variables
        same(parts["mesh2d"].cf_role, b"mesh_topology", "topology")
        places = list(zip(parts["mesh2d_node_x"][:], parts["mesh2d_node_y"][:]))
        same(len(places), sample.nodes, "nodes")
        for kind, values, rows, named in (
                ("regions", "mesh2d_face_region", "mesh2d_face_nodes", sample.regions),
                ("edges", "mesh2d_edge_boundary", "mesh2d_edge_nodes", sample.edges)):
            nodes, tags = parts[rows], parts[values]
            first = int(nodes.start_index)
            found = measures(((int(tag), [places[n - first] for n in row]) for row, tag in zip(nodes[:], tags[:]) if tag),
                             signed=kind == "regions")
            compare(found, named, lambda name, named=named: named[name]["tag"], f"UGRID {kind}")
            same(len(tags.flag_meanings.split()), len(named), f"meanings of {kind}")


def fortran_records(file):
    data, at, records = pathlib.Path(file).read_bytes(), 0, []
    while at < len(data):
        [length] = struct.unpack_from(">i", data, at)
        records.append(data[at + 4:at + 4 + length])
        same(struct.unpack_from(">i", data, at + 4 + length)[0], length, "length after a record")
        at += length + 8
    return records


def integers(record):
    return struct.unpack(f">{len(record) // 4}i", record)


def reals(record):
    return struct.unpack(f">{len(record) // 4}f", record)


def check_selafin(sample, file):
    title, count, name, parameters, sizes, corners, shore, x, y, time, bottom = fortran_records(file)
    same((len(title), title[72:], integers(count), name[:6]), (80, b"SERAFIN ", (1, 0), b"BOTTOM"), "head")
    same(integers(sizes), (sample.elements, sample.nodes, 3, 1), "sizes")
    shift = integers(parameters)[2:4]
    places = [(a + shift[0], b + shift[1]) for a, b in zip(reals(x), reals(y))]
    rows = list(zip(*[iter(integers(corners))] * 3))
    near(measures((0, [places[n - 1] for n in row]) for row in rows)[0][1], sample.area(), 1e-5)
    same((len(reals(bottom)), reals(time)), (sample.nodes, (0.0,)), "values")
    numbers = {number: node for node, number in enumerate(integers(shore), 1) if number}
    conditions = [line.split() for line in pathlib.Path(file).with_suffix(".cli").read_text().splitlines()]
    outer = sum(part["count"] for part in sample.edges.values() if part["tag"] <= 5)
    same((len(conditions), sorted(numbers)), (outer, list(range(1, outer + 1))), "nodes of the boundary")
    for row in conditions:
        same((len(row), row[:3], numbers[int(row[12])]), (13, ["2", "2", "2"], int(row[11])), "condition")


def check_mike(file, nodes, elements, area):
    lines = pathlib.Path(file).read_text().splitlines()
    item, unit, count, projection = lines[0].split()
    same((item, unit, int(count), projection), ("100079", "1000", nodes, "NON-UTM"), "head")
    rows = [line.split() for line in lines[1:1 + nodes]]
    same([int(row[0]) for row in rows], list(range(1, nodes + 1)), "numbers of nodes")
    assert {row[4] for row in rows} <= {"0", "1"}, "codes"
    places = [(float(row[1]), float(row[2])) for row in rows]
    total, width, kind = map(int, lines[1 + nodes].split())
    same((total, {3: 21, 4: 25}[width]), (elements, kind), "elements")
    found = 0.0
    for line in lines[2 + nodes:]:
        corners = [places[int(n) - 1] for n in line.split()[1:] if n != "0"]
        same(len(line.split()), width + 1, "columns")
        found += 0.5 * sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(corners, corners[1:] + corners[:1]))
    near(found, area)


def check_anuga(sample, file):
    lines = iter(pathlib.Path(file).read_text().splitlines())

    def table():
        head = next(lines)
        return [next(lines).split() for _ in range(int(head.split()[0]))]
    places = [(float(row[1]), float(row[2])) for row in table()]
    same(next(lines)[0], "#", "titles")
    rows = table()
    found = measures((row[7], [places[int(n)] for n in row[1:4]]) for row in rows)
    same(sorted(value[0] for value in found.values()), sorted(part["count"] for part in sample.regions.values()), "regions")
    near(sum(value[1] for value in found.values()), sample.area())
    for number, row in enumerate(rows):
        for k in range(3):
            if (beyond := int(row[4 + k])) >= 0:
                shared = {row[1 + (k + 1) % 3], row[1 + (k + 2) % 3]}
                assert shared <= set(rows[beyond][1:4]) and str(number) in rows[beyond][4:7], f"neighbour of {number}"
    segments = table()
    found = measures((row[3], [places[int(n)] for n in row[1:3]]) for row in segments)
    same(sorted(value[0] for value in found.values()), sorted(part["count"] for part in sample.edges.values()), "segments")
    same([table() for _ in range(5)], [[]] * 5, "outline")


def checks(samples, mixed):
    """(name, function) pairs for the meshes of export_sample; `mixed` has quadrilaterals, too."""
    result = []
    for name in ("sample", "twins"):
        sample = samples[name]
        files = sample.files
        result += [(f"UGRID of {name} by SciPy", lambda s=sample, f=files: check_ugrid(s, f["ugrid"])),
                   (f"SELAFIN of {name}", lambda s=sample, f=files: check_selafin(s, f["selafin"])),
                   (f"MIKE of {name}", lambda s=sample, f=files: check_mike(f["mike"], s.nodes, s.elements, s.area())),
                   (f"ANUGA of {name}", lambda s=sample, f=files: check_anuga(s, f["anuga"]))]
    result.append(("MIKE of mixed", lambda: check_mike(mixed.files["mike"], len(mixed.nodes), len(mixed.elements()),
                                                       mixed.area())))
    return result
