#!/usr/bin/env python3
"""The batch program as its users meet it: exit codes, messages, figures, files.

    test_batch.py PROGRAM [NAME OF A TEST...]

FOREFRONT_DATA may name a folder of real domains (*.poly); each is then meshed and checked. Classes named Slow... are labelled
slow: the sanitizer builds leave them out.
"""

import errno
import json
import math
import os
import pathlib
import pty
import re
import resource
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib
from unittest import mock

PROGRAM = os.path.abspath(sys.argv.pop(1))
SAMPLES = pathlib.Path(__file__).parents[2] / "assets" / "samples"
STATS = ["nodes", "elements", "area", "alpha_mean", "alpha_geometric_mean", "alpha_min", "delta_mean", "delta_area_mean",
         "edge_length_min", "edge_length_max", "min_angle_deg",
         "max_angle_deg", "front_mean", "neighbours_mean", "considered_mean", "tests_mean", "cells_mean",
         "candidates_mean", "forced_mean", "flat_elements", "seconds_mesh", "seconds_improve",
         "improve", "sharp_corners", "narrow_places", "min_angle_elsewhere_deg", "peak_bytes", "hash"]

SQUARE = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]
HOLE = [(1.0, 1.0), (1.0, 2.0), (2.0, 2.0), (2.0, 1.0)]
PROJECT = """{"format": "forefront", "version": 1, "spacing": {"size": 0.3}, "shapes": [{"id": 1, "kind": "polygon",
    "use": "boundary", "tag": 1, "nodes": [[0, 0], [4, 0], [4, 3], [0, 3]]}]}"""
BOW = [(0.0, 0.0), (4.0, 3.0), (4.0, 0.0), (0.0, 3.0)]


def poly(loops, holes=()):
    """Triangle .poly text of closed loops, each with its own tag."""
    nodes = [p for loop in loops for p in loop]
    lines = [f"{len(nodes)} 2 0 0"] + [f"{i} {x!r} {y!r}" for i, (x, y) in enumerate(nodes, 1)]
    lines.append(f"{len(nodes)} 1")
    first = 1
    for tag, loop in enumerate(loops, 1):
        lines += [f"{first + i} {first + i} {first + (i + 1) % len(loop)} {tag}" for i in range(len(loop))]
        first += len(loop)
    lines.append(str(len(holes)))
    lines += [f"{i} {x!r} {y!r}" for i, (x, y) in enumerate(holes, 1)]
    return "\n".join(lines) + "\n"


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.write("plate.poly", poly([SQUARE, HOLE], [(1.5, 1.5)]))

    def write(self, name, text):
        (self.path / name).write_text(text)

    def read(self, name):
        return (self.path / name).read_text()

    def call(self, *words, code=0):
        done = subprocess.run([PROGRAM, *map(str, words)], cwd=self.path, capture_output=True, text=True, timeout=300)
        self.assertEqual(done.returncode, code, f"{words}\n{done.stdout}\n{done.stderr}")
        return done

    def picture(self, name, grey):
        """Writes a PNG file of 4 x 2 pixels with one grey value."""
        def chunk(kind, content):
            return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
        rows = 2 * (b"\0" + bytes([grey] * 4))
        (self.path / name).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 4, 2, 8, 0, 0, 0, 0))
                                       + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))

    def stats(self, *words):
        self.call("mesh", *words, "--stats", "stats.json")
        return json.loads(self.read("stats.json"))


class Meshing(Case):
    def test_meshes_and_checks(self):
        done = self.call("mesh", "plate.poly", "-o", "plate.msh", "--size", "0.25")
        self.assertEqual(done.stderr, "")
        lines = done.stdout.splitlines()
        self.assertRegex(lines[-1], r"^\d+\.\d+ s for the mesh .* peak [\d.]+ MB$")
        self.assertIn("wrote plate.msh", lines)
        self.assertRegex(done.stdout, r"\d+ nodes, \d+ elements, hash [0-9a-f]{16}")
        self.assertIn("valid for the domain", self.call("check", "plate.msh", "--domain", "plate.poly").stdout)
        self.assertIn("valid:", self.call("check", "plate.msh").stdout)

    def test_statistics_have_every_key_and_agree_with_the_mesh(self):
        stats = self.stats("plate.poly", "-o", "plate.msh", "--size", "0.2")
        for key in STATS:
            self.assertIn(key, stats)
        expected = 11 * 4 / (math.sqrt(3) * 0.2 ** 2)  # area 11 in equilateral triangles
        self.assertLess(abs(stats["elements"] / expected - 1), 0.12)
        self.assertGreater(stats["alpha_geometric_mean"], 0.93)
        self.assertGreaterEqual(stats["alpha_mean"], stats["alpha_geometric_mean"])
        self.assertGreater(stats["delta_mean"], 0.85)
        self.assertGreater(stats["delta_area_mean"], 0.85)
        self.assertGreater(stats["min_angle_deg"], 20)
        self.assertLess(stats["max_angle_deg"], 130)
        self.assertGreater(stats["front_mean"], 1)
        self.assertGreater(stats["peak_bytes"], 1_000_000)
        checked = self.call("check", "plate.msh").stdout
        self.assertIn(f"{stats['nodes']} nodes, {stats['elements']} elements, hash {stats['hash']}", checked)
        self.assertEqual((stats["parts"], stats["holes"]), (1, 1))
        self.assertIn("area 11, 1 part, 1 hole\n", checked)
        self.assertEqual(sum(region["elements"] for region in stats["regions"]), stats["elements"])
        self.assertAlmostEqual(sum(region["area"] for region in stats["regions"]), stats["area"])

    def test_quadrilaterals_fill_the_domain_and_say_how(self):
        stats = self.stats("plate.poly", "-o", "quads.msh", "--size", "0.2", "--elements", "quads", "--verify")
        quads = stats["quadrilaterals"]
        self.assertEqual(stats["elements_by_kind"], {"quadrilateral4": stats["elements"]})
        self.assertEqual((quads["triangles_left"], quads["odd_edges"], quads["not_convex"]), (0, 0, 0))
        self.assertLess(quads["irregular_nodes"], 0.2 * quads["interior_nodes"])
        self.assertLess(abs(stats["elements"] * 0.2 ** 2 / 11 - 1), 0.15)
        self.assertIn("valid for the domain", self.call("check", "quads.msh", "--domain", "plate.poly").stdout)
        done = self.call("mesh", "plate.poly", "-o", "quads.msh", "--elements", "quads", "--method", "classic")
        self.assertIn("note: --method has no effect", done.stderr)
        self.assertIn("% of the interior nodes irregular", done.stdout)
        self.assertIn("quadrilaterals", self.stats("plate.poly", "-o", "mixed.msh", "--elements", "mixed"))

    def test_strips_and_elements_of_regions(self):
        self.write("dam.json", json.dumps({
            "format": "forefront", "version": 1, "nextId": 4, "regionMarkers": [{"at": [7, 1], "tag": 2}],
            "boundaryNames": {"3": "joint"}, "regionNames": {"2": "soil"},
            "shapes": [{"id": 1, "kind": "polygon", "use": "boundary", "tag": 1, "name": "",
                        "nodes": [[0, 0], [5, 0], [8, 0], [8, 4], [5, 4], [0, 4]]},
                       {"id": 2, "kind": "polyline", "use": "constraint", "tag": 2, "name": "", "nodes": [[5, 0], [5, 4]]},
                       {"id": 3, "kind": "polyline", "use": "constraint", "tag": 3, "name": "",
                        "nodes": [[1, 1], [3, 2], [4, 2]]}]}))
        words = ["dam.json", "-o", "dam.msh", "--size", "0.4", "--verify"]
        strip = "joint:width=0.2,rows=2"
        stats = self.stats(*words, "--strip", strip, "--elements", "triangles", "--elements", "quads:soil")
        regions = {region["name"]: region for region in stats["regions"]}
        self.assertIn("joint", regions)
        self.assertEqual(regions["joint"]["elements"] % 2, 0)
        self.assertEqual(set(stats["elements_by_kind"]), {"triangle3", "quadrilateral4"})
        self.assertEqual(stats["elements_by_kind"]["quadrilateral4"],
                         regions["joint"]["elements"] + regions["soil"]["elements"])
        checked = self.call("check", "dam.msh", "--domain", "dam.json", "--strip", strip)
        self.assertIn("valid for the domain", checked.stdout)
        self.call("check", "dam.msh", "--domain", "dam.json", code=1)
        for word, code, expected in (
                ("joint:width=0.2", 2, "rows is missing"), ("joint:width=0,rows=1", 2, "width above 0"),
                ("joint:width=nan,rows=1", 2, "width above 0"), ("joint:width=0.1,rows=2.5", 2, "whole number"),
                ("joint:width=0.1,rows=1,type=hexes", 2, "unknown type"), ("joint:wdth=0.1,rows=1", 2, "did you mean width?"),
                ("joint:width=0.1,rows=1,rows=2", 2, "given twice"), ("wall:width=0.1,rows=1", 1, "unknown-boundary"),
                ("joint:width=3,rows=2", 1, "strip joint")):
            self.assertIn(expected, self.call("mesh", *words, "--strip", word, code=code).stderr)
        for given, code, expected in ((["hexes"], 2, "unknown shapes 'hexes'"), (["quads", "mixed"], 2, "given twice"),
                                      (["quads:soli"], 1, "unknown-region")):
            options = [option for word in given for option in ("--elements", word)]
            self.assertIn(expected, self.call("mesh", *words, *options, code=code).stderr)

    def test_a_least_angle_is_kept_but_at_sharp_corners(self):
        self.write("wedge.poly", "4 2 0 0\n1 0 0\n2 10 0\n3 10 0.9\n4 5 4\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n")
        stats = self.stats("wedge.poly", "-o", "wedge.msh", "--min-angle", "30", "--verify")
        angles = stats["least_angle"]
        self.assertGreaterEqual(angles["reached"], 30.0)
        self.assertEqual(angles["asked"], 30.0)
        self.assertEqual([place["by"] for place in angles["forced"]], ["corner"] * len(angles["forced"]))
        done = self.call("mesh", "wedge.poly", "-o", "wedge.msh", "--min-angle", "30")
        self.assertIn("least angle: 3", done.stdout)
        few = self.stats("wedge.poly", "--min-angle", "30", "--size-from-boundary", "--gradation", "0.7")
        self.assertGreaterEqual(few["least_angle"]["reached"], 30.0)
        self.assertLess(4 * few["elements"], stats["elements"])
        refused = self.call("mesh", "wedge.poly", "-o", "wedge.msh", "--min-angle", "40", code=1)
        self.assertIn("expected above 0 and at most 33", refused.stderr)
        refused = self.call("mesh", "wedge.poly", "-o", "wedge.msh", "--min-angle", "20", "--elements", "quads", code=1)
        self.assertIn("for triangles only", refused.stderr)

    def test_elements_of_second_order_follow_curves(self):
        self.write("disc.json", """{"format": "forefront", "version": 2,
            "shapes": [{"id": 1, "kind": "circle", "nodes": [[0, 0], [2, 0]]}]}""")
        for words, kind in (((), "triangle6"), (("--elements", "quads"), "quadrilateral8"),
                            (("--elements", "quads", "--quad-nodes", "9"), "quadrilateral9")):
            stats = self.stats("disc.json", "-o", "disc.msh", "-o", "disc.vtu", "--order", "2", "--verify", *words)
            self.assertEqual(stats["elements_by_kind"], {kind: stats["elements"]})
            self.assertLess(abs(stats["area"] / (4 * math.pi) - 1), 2e-6)  # with chords: 4e-3
            self.assertGreater(stats["second_order"]["curved_edges"], 20)
            self.assertEqual(stats["second_order"]["straight_edges"], [])
            for name in ("disc.msh", "disc.vtu"):
                self.assertIn(stats["hash"], self.call("check", name).stdout)
                self.assertIn("valid for the domain", self.call("check", name, "--domain", "disc.json").stdout)
        self.assertNotIn("second_order", self.stats("disc.json"))
        self.assertIn("--quad-nodes has no effect", self.call("mesh", "disc.json", "-o", "a.msh", "--quad-nodes", "9").stderr)
        refused = self.call("mesh", "disc.json", "-o", "disc.su2", "--order", "2", code=1).stderr
        self.assertRegex(refused, r"SU2 files hold no .*triangles of 6 nodes")
        self.call("mesh", "disc.json", "-o", "a.msh", "--order", "3", code=2)

    def test_a_project_keeps_the_shapes_and_the_order_of_its_elements(self):
        self.write("disc.json", """{"format": "forefront", "version": 2,
            "shapes": [{"id": 1, "kind": "circle", "nodes": [[0, 0], [2, 0]]}],
            "options": {"elements": "quads", "order": 2, "quadNodes": 9}}""")
        stats = self.stats("disc.json")
        self.assertEqual(stats["elements_by_kind"], {"quadrilateral9": stats["elements"]})
        triangles = self.stats("disc.json", "--elements", "triangles", "--order", "1")
        self.assertNotIn("elements_by_kind", triangles)
        self.call("film", "disc.json", "-o", "a.gif", "--frames", "5", "--width", "120")
        self.assertEqual((self.path / "a.gif").read_bytes()[:6], b"GIF89a")
        self.call("film", "disc.json", "-o", "a.svg", "--at", "1")
        self.assertRegex(self.read("a.svg"), r"d=\"M[^MZ]*L[^MZ]*L[^MZ]*L[^MZ]*Z\n")  # a square, whole
        text = self.read("disc.json")
        for wrong in (("quads", "hexagons"), ("2, \"quad", "3, \"quad"), ("9}", "7}")):
            self.write("wrong.json", text.replace(*wrong))
            self.call("mesh", "wrong.json", "-o", "a.msh", code=1)

    def test_edges_that_stay_straight_are_reported(self):
        self.write("hole.json", """{"format": "forefront", "version": 2, "spacing": {"size": 1}, "shapes": [
            {"id": 1, "kind": "rectangle", "nodes": [[-1.2, -1.2], [1.2, 1.2]]},
            {"id": 2, "kind": "circle", "nodes": [[0, 0], [1, 0]], "tag": 2}],
            "elementCounts": [{"tag": 2, "elements": 3}]}""")
        done = self.call("mesh", "hole.json", "-o", "hole.msh", "--order", "2", "--verify")
        stats = self.stats("hole.json", "--order", "2")
        straight = stats["second_order"]["straight_edges"]
        self.assertEqual(len(straight), 3)
        self.assertEqual({edge["reason"] for edge in straight}, {"folded"})
        self.assertIn("note: 3 edges along curves are straight, since an element would fold", done.stderr)
        self.assertIn("valid for the domain", self.call("check", "hole.msh", "--domain", "hole.json").stdout)

    def test_the_spacing_is_the_one_asked_for(self):
        coarse = self.stats("plate.poly", "--size", "0.4")["elements"]
        fine = self.stats("plate.poly", "--size", "0.2")["elements"]
        self.assertLess(abs(fine / coarse / 4 - 1), 0.25)
        steep = self.stats("plate.poly", "--spacing", "0.02 + 0.9*max(0, x + y - 0.2)")
        graded = self.stats("plate.poly", "--spacing", "0.02 + 0.9*max(0, x + y - 0.2)", "--gradation", "0.1")
        self.assertGreater(graded["elements"], 2 * steep["elements"])

    def test_a_target_scales_the_sizes_until_the_mesh_has_that_number_of_elements(self):
        for target, options in ((300, []), (3000, []), (900, ["--spacing", "0.02 + 0.4*x"]),
                                (700, ["--size", "0.5", "--elements", "quads"])):
            elements = self.stats("plate.poly", "--target-elements", str(target), *options)["elements"]
            self.assertLess(abs(elements / target - 1), 0.05)
        self.write("least.json", PROJECT.replace('{"size": 0.3}', '{"size": 0.3, "minimum": 0.3}'))
        self.assertIn("the minimum spacing 0.3", self.call("mesh", "least.json", "--stats", "-", "--target-elements",
                                                           "50000").stderr)
        self.assertIn("[bad-target]", self.call("mesh", "plate.poly", "--stats", "-", "--target-elements", "2000",
                                                "--max-elements", "1000", code=1).stderr)
        self.call("mesh", "plate.poly", "--stats", "-", "--target-elements", "0", code=2)

    def test_more_elements_than_the_limit_are_refused_with_a_size_that_fits(self):
        refusal = self.call("mesh", "plate.poly", "--size", "0.01", "--max-elements", "1e3", "--stats", "-", code=1)
        self.assertIn("[too-many-elements]", refusal.stderr)
        self.assertIn("expected at most 1000", refusal.stderr)
        self.assertIn("raise --max-elements", refusal.stderr)
        size = re.search(r"choose a --size of at least ([\d.]+)", refusal.stderr)[1]
        self.assertLess(self.stats("plate.poly", "--size", size, "--max-elements", "1000")["elements"], 1250)
        self.write("few.json", PROJECT.replace('"shapes"', '"options": {"maxElements": 50}, "shapes"'))
        self.assertIn("expected at most 50", self.call("mesh", "few.json", "--stats", "-", code=1).stderr)
        self.call("mesh", "few.json", "--stats", "-", "--max-elements", "5000")
        self.call("film", "few.json", "-o", "few.svg", code=1)
        self.call("mesh", "plate.poly", "--stats", "-", "--max-elements", "0", code=2)

    def test_lessons_are_checked_and_written_as_pages(self):
        self.write("square.json", PROJECT)
        lesson = {"format": "forefront-lesson", "version": 1, "title": "L", "pages": [
            {"title": "P", "text": "{front}", "document": "square.json", "position": 2,
             "question": {"text": "q", "number": "front"}}]}

        def check(code=0, *words):
            self.write("lesson.json", json.dumps(lesson, indent=1))
            return self.call("lesson", "lesson.json", *words, code=code)
        self.assertIn("1 page, 1 question; no faults", check().stdout)
        self.assertIn("wrote page.html", check(0, "-o", "page.html").stdout)
        self.assertIn("FILE.html", check(2, "-o", "page.txt").stderr)
        pages = lesson["pages"]
        pages[0]["question"] = {"text": "q", "until": {"value": "improve-step", "is": 1}, "hint": "{front}"}
        written = check(0, "-o", "page.html")
        self.assertIn("no faults", written.stdout)
        self.assertEqual(written.stderr, "")  # the page has the steps of the improvement
        self.assertRegex((self.path / "page.html").read_text(), r'"done":\[\[\d+,0,1,-1,')
        pages[0]["question"] = {"text": "q", "until": {"value": "advance", "is": 2}}
        self.assertIn("no errors, 1 warning", check().stdout)
        pages[0]["question"] = {"text": "q", "number": "front"}
        pages[0]["random"] = {"n": [1, 8]}
        pages[0]["question"]["text"] = "After {n}?"
        lesson["pages"][0]["position"] = "n"
        self.assertIn("no faults", check().stdout)
        texts = [(check(0, "--seed", str(seed), "-o", "page.html"), (self.path / "page.html").read_text())[1] for seed in (1, 2)]
        self.assertNotEqual(*texts)
        answers = {"format": "forefront-answers", "version": 1, "lesson": "L", "seed": 2, "pages": [
            {"title": "P", "question": "q", "answers": [{"answer": "0.5", "right": False}]}]}
        self.write("a.json", json.dumps(answers))
        self.assertIn("0 of 1 question right", check(0, "--answers", "a.json").stdout)
        answers["pages"][0]["answers"][0]["right"] = True
        self.write("a.json", json.dumps(answers))
        self.assertIn("[false-claim]", check(1, "--answers", "a.json").stderr)
        self.assertIn("--answers", check(2, "--answers", "a.json", "--seed", "3").stderr)
        del pages[0]["random"]
        pages[0]["question"]["text"] = "q"
        lesson["pages"][0]["position"] = 100000
        self.assertRegex(check(1).stderr, r"lesson\.json:\d+:\d+: error: page 'P': position 100000 is beyond the end")
        self.assertIn("[lesson-position]", check(1, "-o", "none.html").stderr)
        self.assertFalse((self.path / "none.html").exists())
        lesson["pages"][0].update(position=2, question={"text": "q", "until": {"value": "elements", "is": 1e6}})
        self.assertIn("no position of the run fulfils the task", check(1).stderr)
        lesson["pages"][0]["question"] = {"text": "q", "choices": [{"text": "a", "rigth": True}, {"text": "b"}]}
        self.assertIn("unknown member 'rigth'", check(1).stderr)

    def test_long_kept_segments_give_no_flat_elements(self):
        steps = [(x, 0.0) for x in range(10)] + [(10.0, y) for y in range(6)] + [(x, 6.0) for x in range(10, 0, -1)] + [
            (0.0, y) for y in range(6, 0, -1)]
        self.write("steps.poly", poly([steps]))
        for method in ["fast", "classic"]:
            stats = self.stats("steps.poly", "-o", "steps.msh", "--keep-boundary", "--size", "0.1", "--no-improve",
                               "--method", method)
            self.assertEqual(stats["flat_elements"], 0)
            self.assertGreater(stats["min_angle_deg"], 0.001)
            self.assertEqual(self.call("check", "steps.msh").stderr, "")

    def test_curves_are_divided_by_their_bend(self):
        (self.path / "disc.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20 20">'
                                            '<circle cx="10" cy="10" r="5"/></svg>')
        edges = {}
        for turn in ("0", "100", "200"):
            mesh = self.stats("disc.svg", "--size", "5", "--segments-per-turn", turn)
            edges[turn] = 2 * mesh["nodes"] - 2 - mesh["elements"]  # by Euler's formula
        self.assertLess(edges["0"], 80)
        self.assertTrue(98 <= edges["100"] <= 110, edges)
        self.assertTrue(196 <= edges["200"] <= 220, edges)
        # A CAD drawing with few, long arcs, and the sizes of an automatic spacing beside them.
        arcs = [f"0\nARC\n8\nA\n10\n0\n20\n0\n40\n3\n50\n{180 * k}\n51\n{180 * (k + 1)}\n" for k in range(2)]
        self.write("disc.dxf", "0\nSECTION\n2\nENTITIES\n" + "".join(arcs) + "0\nENDSEC\n0\nEOF\n")
        for turn in (100, 400, 1000):
            [rim] = self.stats("disc.dxf", "--segments-per-turn", str(turn))["boundaries"]
            self.assertAlmostEqual(rim["edges"] / turn, 1, delta=0.02)

    def test_narrow_places_get_the_number_of_elements_across(self):
        self.write("channel.poly", poly([[(0, 0), (20, 0), (20, 1), (0, 1)]], []))
        for words, code in ((("--size", "5"), 1), (("--size", "5", "--elements-across", "4"), 0),
                            (("--elements-across", "4"), 0)):
            self.call("mesh", "channel.poly", "-o", "channel.msh", *words)
            self.call("check", "channel.msh", "--min-across", "4", code=code)
        self.assertIn("--elements-across: expected a number of at least 0, got '-1'", self.call(
            "mesh", "channel.poly", "-o", "a.msh", "--elements-across", "-1", code=2).stderr)

    def test_every_grid_and_number_of_threads_gives_the_same_mesh(self):
        choices = ([], ["--grid", "none"], ["--grid", "uniform"], ["--grid", "uniform:7x5"],
                   ["--grid", "hierarchical"], ["--threads", "2"])
        self.assertEqual(len({self.stats("plate.poly", "--size", "0.1", *c)["hash"] for c in choices}), 1)

    def test_keep_boundary_keeps_the_segments_as_given(self):
        kept = self.stats("plate.poly", "-o", "kept.msh", "--keep-boundary", "--size", "0.2")
        self.assertLess(kept["nodes"], self.stats("plate.poly", "--size", "0.2")["nodes"])
        self.call("check", "kept.msh", "--domain", "plate.poly")

    def test_segments_too_long_for_the_size_are_kept_with_a_warning(self):
        side = [(x, 0) for x in range(0, 10, 2)] + [(10, y) for y in range(0, 10, 2)]
        self.write("long.poly", poly([side + [(10 - x, 10 - y) for x, y in side]], []))
        done = self.call("mesh", "long.poly", "-o", "long.msh", "--keep-boundary", "--size", "0.1")
        self.assertIn("given segments are up to 20 times longer than the size asked for, and are kept", done.stderr)
        self.assertIn("leave out --keep-boundary", done.stderr)
        self.assertNotIn("long-segments", self.call("mesh", "long.poly", "-o", "long.msh", "--size", "0.1").stderr)

    def test_the_curve_tolerance_is_a_length_or_a_percentage(self):
        self.write("disc.json", """{"format": "forefront", "version": 2, "spacing": {"size": 20},
            "shapes": [{"id": 1, "kind": "circle", "nodes": [[0, 0], [30, 0]]}]}""")
        coarse, fine, same = (self.stats("disc.json", "--curve-tolerance", tolerance)["boundaries"][0]["edges"]
                              for tolerance in ("2", "0.02", "0.0235702%"))
        self.assertGreater(fine, 3 * coarse)
        self.assertEqual(fine, same)
        for value in "0", "-1", "x", "%", "nan", "inf%":
            self.assertIn(f"--curve-tolerance: expected a positive length or percentage, got '{value}'",
                          self.call("mesh", "disc.json", "-o", "a.msh", "--curve-tolerance", value, code=2).stderr)

    def test_options_without_an_effect_are_noted(self):
        def notes(*words):
            return re.findall(r"note: (.*) \[no-effect\]", self.call("mesh", *words, "-o", "a.msh").stderr)

        self.write("disc.json", """{"format": "forefront", "version": 2, "spacing": {"size": 20},
            "shapes": [{"id": 1, "kind": "circle", "nodes": [[0, 0], [30, 0]]}]}""")
        self.assertEqual(notes("plate.poly", "--size", "0.5", "--gradation", "0.1"),
                         ["--gradation has no effect: the size is the same everywhere"])
        self.assertEqual(notes("plate.poly", "--spacing", "0.3+0.1*x", "--gradation", "0.1"), [])
        self.assertEqual(notes("plate.poly", "--curve-tolerance", "0.1"),
                         ["--curve-tolerance has no effect: the domain has no curves"])
        self.assertEqual(notes("disc.json", "--curve-tolerance", "0.1", "--keep-boundary"),
                         ["--curve-tolerance has no effect: the given segments are kept"])
        self.assertEqual(notes("disc.json", "--curve-tolerance", "0.1"), [])
        self.call("mesh", "plate.poly", "-o", "plate.msh")
        self.assertIn("--triangles has no effect", self.call("convert", "plate.msh", "-o", "b.vtu", "--triangles").stderr)
        self.assertEqual(self.call("convert", "plate.msh", "-o", "b.vtu").stderr, "")

    def test_what_options_replace_in_a_project_is_noted(self):
        self.write("parts.json", PROJECT.replace('"size": 0.3', """"partSizes": [{"tag": 1, "size": 0.2}], "gradation": 0.3,
            "sources": [{"shape": "point", "a": [1, 1], "size": 0.1}]"""))
        for command, out in (("mesh", "a.msh"), ("film", "a.svg")):
            replaced = self.call(command, "parts.json", "-o", out, "--size", "0.5").stderr
            self.assertIn("note: --size replaces the spacing of the project, with 1 size source, the sizes of 1 boundary "
                          "part, the gradation [replaced-spacing]\n", replaced)
        self.write("plain.json", PROJECT)
        self.assertEqual(self.call("mesh", "plain.json", "-o", "a.msh", "--size", "0.5").stderr, "")
        self.assertIn("only the drawing of the project is used",
                      self.call("adapt", "a.msh", "--expression", "x*y", "--error", "0.5", "--domain", "plain.json",
                                "-o", "b.msh").stderr)

    def test_violated_limits_of_a_project_are_warned_of(self):
        self.write("strict.json", PROJECT.replace('"version": 1,', '"version": 1, "limits": {"minAngle": 59.9},'))
        self.assertRegex(self.call("mesh", "strict.json", "-o", "a.msh").stderr,
                         r"^warning: the mesh violates a limit: minimum angle 59.9°: violated by \d+ of ")
        self.write("kind.json", PROJECT.replace('"version": 1,', '"version": 1, "limits": {"minAngle": 5},'))
        self.assertEqual(self.call("mesh", "kind.json", "-o", "a.msh").stderr, "")
        self.assertIn("note: the limits of the project are not checked [limits]; add --limits",
                      self.call("check", "a.msh", "--domain", "kind.json").stderr)
        self.assertEqual(self.call("check", "a.msh", "--domain", "kind.json", "--limits", "kind.json").stderr, "")

    def test_fix_changes_settings_until_limits_are_met(self):
        options = ["plate.poly", "-o", "a.msh", "--spacing", "max(0.05,0.6*hypot(x,y))", "--gradation", "0.6"]
        limits = ["--limit", "max-growth=2.2"]
        worse = self.call("mesh", *options, *limits)
        self.assertRegex(worse.stderr, r"warning: the mesh violates a limit: .*violated by \d+ of ")
        few = re.search(r", (\d+) elements", worse.stdout)[1]
        checked = self.call("check", "a.msh", "--max-growth", "2.2", "--max-valence", "20", code=1).stderr
        self.assertIn("add to it: --limit max-growth=2.2 --limit max-valence=20 --fix", checked)
        self.assertNotIn("add to it", self.call("check", "a.msh", "--min-island-area", "2", code=1).stderr)
        done = self.call("mesh", *options, *limits, "--fix")
        fixed = done.stderr
        self.assertRegex(fixed, r"note: fix: gradation 0.6 → 0.\d+.*: \d+ violations, then \d+")
        before, after = (int(n) for n in re.search(r": (\d+) violations, then (\d+), ", fixed).groups())
        self.assertLess(after, before)
        self.assertIn(f", {few} elements, then ", fixed)
        many = re.findall(r"elements, then (\d+) \[fixed\]", fixed)[-1]  # of the last round that was kept
        self.assertIn(f", {many} elements", done.stdout)
        self.assertEqual("violates a limit" in fixed, "no setting mends" in fixed)
        island = self.call("mesh", *options[:3], "--limit", "min-island-area=2", "--fix").stderr
        self.assertIn("remove the small ones from the drawing", island)
        for words, message in ((["--fix"], "--fix: there are no limits"), (["--limit", "beauty=1"], "unknown limit 'beauty'"),
                               (["--limit", "max-growth"], "expected NAME=VALUE"),
                               (["--limit", "min-angle=100"], "expected a number from 0 to 90")):
            self.assertIn(message, self.call("mesh", "plate.poly", "-o", "a.msh", *words, code=2).stderr)

    def test_no_improve_leaves_out_the_improvement(self):
        raw = self.stats("plate.poly", "--size", "0.1", "--no-improve")
        improved = self.stats("plate.poly", "--size", "0.1")
        self.assertEqual(raw["seconds_improve"], 0)
        self.assertEqual((raw["improve"], improved["improve"]), ("none", "default"))
        self.assertEqual(raw["hash"], self.stats("plate.poly", "--size", "0.1", "--improve", "none")["hash"])
        self.assertEqual(improved["hash"], self.stats("plate.poly", "--size", "0.1", "--improve", "default")["hash"])
        # The front takes more care where nodes are to move: it is not the same mesh before.
        self.assertLess(abs(raw["elements"] / improved["elements"] - 1), 0.05)
        self.assertGreaterEqual(improved["alpha_min"], raw["alpha_min"])
        self.assertNotEqual(raw["hash"], improved["hash"])

    def test_corners_that_force_small_angles_are_named(self):
        self.assertEqual(self.stats("plate.poly", "--size", "0.2")["sharp_corners"], [])
        self.write("needle.poly", poly([[(1.0, 2.0), (5.0, 2.0), (5.0, 3.0)]]))
        done = self.call("mesh", "needle.poly", "--size", "0.25", "--stats", "stats.json")
        [corner] = json.loads(self.read("stats.json"))["sharp_corners"]
        self.assertEqual((corner["x"], corner["y"]), (1, 2))
        self.assertAlmostEqual(corner["angle_deg"], math.degrees(math.atan(1 / 4)))
        self.assertIn("1 corner of the domain below 20 degrees", done.stdout)
        self.assertIn("14.0 degrees at (1, 2)", done.stdout)

    def test_several_outputs_and_formats(self):
        self.call("mesh", "plate.poly", "-o", "a.out", "-o", "b.msh", "-o", "c.vtu", "-o", "d.svg", "--format", "msh41",
                  "--size", "0.5")
        self.assertIn("4.1", self.read("a.out")[:40])
        self.assertIn("2.2", self.read("b.msh")[:40])
        self.assertIn("<svg", self.read("d.svg")[:400])
        for name in ("b.msh", "c.vtu"):
            self.call("check", name, "--domain", "plate.poly")

    def test_a_binary_mesh_is_the_same_mesh(self):
        self.call("mesh", "plate.poly", "-o", "a.msh", "-o", "b.msh", "--format", "msh2", "--format", "msh41-binary",
                  "--size", "0.2")
        self.assertTrue((self.path / "b.msh").read_bytes().startswith(b"$MeshFormat\n4.1 1 8\n\x01\0\0\0\n"))
        text, binary = (self.call("check", name, "--domain", "plate.poly").stdout for name in ("a.msh", "b.msh"))
        self.assertIn("hash", text)
        self.assertEqual(text, binary)

    def write_inner_edges(self):
        """Writes a domain with a constraint of the tag 9."""
        inner = poly([SQUARE]).replace("4 2 0 0", "6 2 0 0").replace("4 1\n", "5 1 1\n6 2 2\n5 1\n", 1)
        self.write("inner.poly", inner.replace("\n0\n", "\n5 5 6 9\n0\n"))

    def test_su2_gets_no_inner_edges_unless_they_are_asked_for(self):
        self.write_inner_edges()
        markers = lambda name: re.findall("MARKER_TAG= (.*)", self.read(name))
        done = self.call("mesh", "inner.poly", "-o", "inner.su2", "-o", "inner.msh", "--size", "0.5")
        self.assertRegex(done.stderr, r"inner.su2: note: left out \d+ tagged edges? inside the domain.* \[inner-edges\]")
        self.assertEqual(done.stderr.count("[inner-edges]"), 1)
        self.assertEqual(markers("inner.su2"), ["boundary_1"])
        self.assertIn('1 9 "', self.read("inner.msh"))
        for word, names in (("keep", ["boundary_1", "boundary_9"]), ("drop", ["boundary_1"])):
            done = self.call("mesh", "inner.poly", "-o", "inner.su2", "--inner-edges", word)
            self.assertNotIn("[inner-edges]", done.stderr)
            self.assertEqual(markers("inner.su2"), names)
        self.assertNotIn("[inner-edges]", self.call("mesh", "plate.poly", "-o", "plate.su2").stderr)
        piped = self.call("mesh", "inner.poly", "-o", "-", "--format", "su2")
        self.assertIn("[inner-edges]", piped.stderr)
        self.assertNotIn("boundary_9", piped.stdout)

    def test_clockwise_meshes_are_turned_and_folded_ones_refused_where_it_matters(self):
        grid = "g\n{}\n" + "".join(f"{n} {x} {y} 1\n" for n, x, y in ((1, 0, 0), (2, 1, 0), (3, 1, 1), (4, 0, 1))) + "{}0\n0\n0\n0\n"
        both = "1 3 1 3 2\n2 3 1 4 3\n"
        (self.path / "cw.14").write_text(grid.format("2 4", both))
        (self.path / "folded.14").write_text(grid.format("2 4", "1 3 1 2 3\n2 3 1 4 3\n"))
        said = self.call("convert", "cw.14", "-o", "a.14", "-o", "a.foam", "-o", "a.vtu").stderr
        self.assertIn("all elements are clockwise; they are written turned", said)
        lines = (self.path / "a.14").read_text().splitlines()
        self.assertEqual([line.split()[2:] for line in lines[6:8]], [["1", "2", "3"], ["1", "3", "4"]])
        self.assertIn(" 20", "\n".join(lines[8:]))  # land, not an island
        for name in ("b.14", "b.gr3", "b.foam", "b.slf", "b.nc", "b.tsh"):
            said = self.call("convert", "folded.14", "-o", name, code=1).stderr
            self.assertIn("1 of 2 elements are clockwise", said)
            self.assertNotIn("--triangles", said)
            self.assertFalse((self.path / name).exists())
        self.call("convert", "folded.14", "-o", "b.vtu")  # to look at it
        self.assertIn("inside out", self.call("convert", "folded.14", "-o", "c.vtu", "--extrude", 1, code=1).stderr)

    def test_names_of_outputs_stay_as_given(self):
        self.call("mesh", SAMPLES / "lake.json", "-o", "LAKE.SLF", "-o", "case.foam/", "-q")
        self.assertTrue((self.path / "LAKE.SLF").is_file() and not (self.path / "LAKE.slf").exists())
        self.assertTrue((self.path / "case.foam" / "constant" / "polyMesh" / "faces").is_file())

    def test_single_precision_of_selafin_is_small_against_the_elements(self):
        (self.path / "s.poly").write_text("4 2 0 0\n1 90000 5000\n2 90001 5000\n3 90001 5001\n4 90000 5001\n"
                                          "4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n")
        said = self.call("mesh", "s.poly", "--size", 0.02, "-o", "s.slf").stderr
        self.assertIn("single precision from the origin (90000, 5000)", said)

    def test_units_of_ugrid(self):
        for unit, word in (("mm", b"mm"), ("ft", b"foot"), (None, b"m")):
            self.call("mesh", SAMPLES / "lake.json", "-o", "u.nc", "-q", *(("--unit", unit) if unit else ()))
            data = (self.path / "u.nc").read_bytes()
            at = data.index(b"units", data.index(b"mesh2d_node_x", data.index(b"projection_x_coordinate") - 200))
            length = int.from_bytes(data[at + 12:at + 16], "big")
            self.assertEqual(data[at + 16:at + 16 + length], word)

    def test_a_crack_is_no_island(self):
        self.call("mesh", SAMPLES / "crack.json", "-o", "k.msh", "-q")
        self.call("check", "k.msh", "--min-island-area", 10)

    def test_open_names_the_open_boundaries_of_grids(self):
        square = poly([SQUARE])
        self.write("bay.poly", square)
        part = re.search(r"expected one of '(\w+)'", self.call("mesh", "bay.poly", "-o", "a.14", "--size", "1", "--open",
                                                               "sea", code=1).stderr)[1]
        self.assertFalse((self.path / "a.14").exists())
        done = self.call("mesh", "bay.poly", "-o", "a.14", "-o", "a.msh", "--size", "1", "--open", part)
        self.assertIn("a.14: note: all nodes have the depth 0", done.stderr)
        self.assertNotIn("[no-open-boundary]", done.stderr)
        self.call("convert", "a.msh", "-o", "b.14", "--open", part, "--numbering", "rcm")
        self.assertEqual(self.read("b.14"), self.read("a.14"))
        self.assertIn("unknown boundary part 'sea'",
                      self.call("convert", "a.msh", "-o", "c.14", "--open", "sea", code=1).stderr)
        self.assertIn("a.gr3: note: all of the boundary is land; --open NAME opens a part",
                      self.call("convert", "a.msh", "-o", "a.gr3").stderr)
        self.assertNotEqual(self.read("a.gr3").splitlines()[1:], self.read("a.14").splitlines()[1:])
        self.assertIn("--open: no output tells open boundaries from land; add -o OUT with one of .14, .gr3",
                      self.call("mesh", "bay.poly", "-o", "a.msh", "--size", "1", "--open", part, code=2).stderr)
        checked = self.call("check", "a.14", "--domain", "bay.poly")
        self.assertIn("valid for the domain", checked.stdout)
        self.assertEqual([part["name"] for part in json.loads(self.call("info", "a.14", "--json").stdout)["boundaries"]],
                         ["open_1"])

    BAY = {"format": "forefront", "version": 2, "spacing": {"size": 0.5}, "boundaryNames": {"2": "sea"}, "openBoundaries": [2],
           "elevation": "-4-0.5*x", "shapes": [{"id": 1, "kind": "polygon", "use": "boundary", "tag": 1,
                                                "segmentTags": [1, 2, 1, 1], "nodes": [[0, 0], [4, 0], [4, 3], [0, 3]]}]}

    def test_a_project_has_its_open_parts_and_its_elevation(self):
        self.write("bay.json", json.dumps(self.BAY))
        done = self.call("mesh", "bay.json", "-o", "a.14", "-o", "a.su2", "--verify")
        self.assertNotIn("[no-open-boundary]", done.stderr)
        self.assertNotIn("depth 0", done.stderr)
        self.call("mesh", "bay.json", "-o", "b.14", "--open", "sea", "--elevation=-4-0.5*x")
        self.assertEqual(self.read("a.14"), self.read("b.14"))
        self.assertIn("4 3 6\n", self.read("a.14"))  # depth at the corner (4, 3)
        self.assertIn("a.14: note: all of the boundary is land", self.call(
            "run", self.script('{"command": "open", "file": "bay.json"}', '{"command": "mesh"}',
                               '{"command": "export", "file": "a.14", "open": []}')).stderr)
        self.assertNotIn("depth 0", self.call(
            "run", self.script('{"command": "open", "file": "bay.json"}', '{"command": "mesh"}',
                               '{"command": "export", "file": "c.14"}', '{"command": "export", "file": "c.msh"}')).stderr)
        self.assertEqual(self.read("c.14"), self.read("b.14"))
        self.write("bay.json", json.dumps(self.BAY | {"elevation": "-depth(x,y)"}))
        self.assertIn("expression", self.call("mesh", "bay.json", "-o", "d.14", code=2).stderr)

    def script(self, *commands):
        self.write("script.jsonl", "\n".join(commands) + "\n")
        return "script.jsonl"

    COAST = {"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"name": "coast"}, "geometry": {"type": "Polygon", "coordinates": [
            [[25.0, 60.0], [25.4, 60.0], [25.4, 60.2], [25.3, 60.15], [25.2, 60.22], [25.0, 60.2], [25.0, 60.0]]]}}]}
    SEA = "sea:25.01,60.19;25.39,60.01"

    def test_a_part_of_a_ring_is_named_and_opened(self):
        self.write("coast.geojson", json.dumps(self.COAST))
        for options in ([], ["--projection", "local"]):
            unnamed = self.call("mesh", "coast.geojson", *options, "-o", "a.14", "--open", "sea", code=1).stderr
            self.assertIn("expected one of 'coast'", unnamed)
            self.assertIn('--name "sea:X1,Y1;X2,Y2"', unnamed)
            done = self.call("mesh", "coast.geojson", *options, "-o", "a.14", "-o", "a.msh", "--open", "sea", "--name", self.SEA)
            self.assertIn("'sea' is named: 2 segments", done.stderr)
            parts = json.loads(self.call("info", "a.msh", "--json").stdout)["boundaries"]
            self.assertEqual({part["name"] for part in parts}, {"coast", "sea"})
            parts = json.loads(self.call("info", "a.14", "--json").stdout)["boundaries"]
            self.assertEqual({part["name"] for part in parts}, {"open_1", "land"})
            self.call("check", "a.msh", "--domain", "coast.geojson", *options, "--name", self.SEA)
        coast = json.loads(json.dumps(self.COAST))
        coast["features"].append({"type": "Feature", "properties": {"name": "sea"}, "geometry": {
            "type": "LineString", "coordinates": [[25.0, 60.2], [25.0, 60.0], [25.4, 60.0]]}})
        self.write("line.geojson", json.dumps(coast))
        self.call("mesh", "line.geojson", "--allow-degrees", "-o", "b.msh", "--open", "sea", "-o", "b.14")
        self.call("mesh", "coast.geojson", "--allow-degrees", "-o", "c.14", "--open", "sea", "--name", self.SEA)
        self.assertEqual(self.read("b.14"), self.read("c.14"))

    def test_depths_with_the_wrong_sign_and_open_shores_are_warned_of(self):
        self.write("bay.poly", "4 2 0 1\n1 0 0 1\n2 9 0 1\n3 9 9 1\n4 0 9 1\n4 1\n1 1 2 1\n2 2 3 2\n3 3 4 1\n4 4 1 1\n0\n")
        self.write("bed.asc", "ncols 12\nnrows 12\nxllcorner -1\nyllcorner -1\ncellsize 1\n" + "-5 " * 144)
        rule = "wavelength:{}=bed,period=1,elements=5,max=2"
        for key, warned in (("depth", True), ("elevation", False)):
            done = self.call("mesh", "bay.poly", "-o", "a.14", "--raster", "bed=bed.asc", "--size-preset", rule.format(key),
                             "--elevation", "bed.asc")
            self.assertEqual("[dry-domain]" in done.stderr, warned, done.stderr)
            self.assertEqual("write elevation=bed" in done.stderr, warned, done.stderr)
            self.assertNotIn("[dry-elevations]", done.stderr)
        done = self.call("mesh", "bay.poly", "-o", "a.14", "--size", "3", "--elevation", "5+x/100")
        self.assertIn("[dry-elevations]", done.stderr)
        done = self.call("mesh", "bay.poly", "-o", "a.msh", "--size", "3", "--elevation", "5+x/100")
        self.assertNotIn("[dry-elevations]", done.stderr)  # not a file of depths
        for part, warned in (("", True), (",part=boundary_1", False)):
            done = self.call("mesh", "bay.poly", "-o", "a.14", "--open", "boundary_2", "--size-preset",
                             "shore:size=1,growth=0.2" + part)
            self.assertEqual("[open-shore]" in done.stderr, warned, done.stderr)

    def test_names_that_cannot_be_placed_are_refused(self):
        self.write("coast.geojson", json.dumps(self.COAST))
        for value, code, message in (("sea", 2, "expected NAME:X1,Y1;X2,Y2"), ("sea:1,2;3", 2, "expected NAME:X1,Y1;X2,Y2"),
                                     (":1,2;3,4", 2, "expected NAME:X1,Y1;X2,Y2"),
                                     ("sea:384000,6670000;25.4,60", 1, "far outside the domain"),
                                     ("sea:25.4,60;25.39,60", 1, "both nearest to the node")):
            self.assertIn(message, self.call("mesh", "coast.geojson", "-o", "a.msh", "--name", value, code=code).stderr)
        self.write("plate.json", PROJECT)
        self.assertIn("--name: the parts of a Forefront project keep names of their own",
                      self.call("mesh", "plate.json", "-o", "a.msh", "--name", "sea:0,0;4,0", code=2).stderr)
        self.call("mesh", "plate.poly", "-o", "a.msh", "--name", "inlet:0,0;0,0")
        self.assertIn("inlet", self.read("a.msh"))

    def test_check_accepts_su2_as_it_is_written_by_default(self):
        self.write_inner_edges()
        self.call("mesh", "inner.poly", "-o", "inner.su2", "-o", "inner.msh", "--size", "0.5")
        done = self.call("check", "inner.su2", "--domain", "inner.poly")
        self.assertIn("valid for the domain", done.stdout)
        self.assertIn("[inner-edges]", done.stderr)
        self.assertIn("valid for the domain", self.call("check", "inner.su2", "--domain", "inner.msh").stdout)
        # A constraint must still be edges of the mesh.
        self.write("other.poly", self.read("inner.poly").replace("5 1 1", "5 1 1.25"))
        self.assertIn("segment", self.call("check", "inner.su2", "--domain", "other.poly", code=1).stderr)
        self.call("mesh", "inner.poly", "-o", "inner.su2", "--inner-edges", "keep")
        self.assertNotIn("[inner-edges]", self.call("check", "inner.su2", "--domain", "inner.poly").stderr)

    def test_inner_edges_can_be_left_out(self):
        self.write_inner_edges()
        for command in (["mesh", "inner.poly"],
                        ["adapt", "base.msh", "--domain", "inner.poly", "--expression", "x*x", "--error", "0.3"]):
            if command[0] == "adapt":
                self.call("mesh", "inner.poly", "-o", "base.msh")
            self.call(*command, "-o", "keep.msh", "--inner-edges", "keep")
            self.call(*command, "-o", "drop.msh", "--inner-edges", "drop")
            self.assertIn('1 9 "', self.read("keep.msh"))
            self.assertNotIn('1 9 "', self.read("drop.msh"))
            self.assertIn('1 1 "boundary_1"', self.read("drop.msh"))
            triangles = [re.findall(r"^\d+ 2 2 .*", self.read(name), re.M) for name in ("keep.msh", "drop.msh")]
            self.assertEqual(*map(len, triangles))
            self.assertGreater(len(triangles[0]), 0)
        self.assertIn("keep, drop", self.call("mesh", "inner.poly", "-o", "a.msh", "--inner-edges", "no", code=2).stderr)

    def msh_bandwidth(self, name):
        """Returns the greatest difference between two node numbers of one triangle."""
        rows = [list(map(int, row.split()[-3:])) for row in re.findall(r"^\d+ 2 2 .*", self.read(name), re.M)]
        self.assertGreater(len(rows), 0)
        return max(max(row) - min(row) for row in rows)

    def test_nodes_are_numbered_for_a_small_bandwidth(self):
        lake = pathlib.Path(__file__).parents[2] / "assets" / "samples" / "lake.json"
        hashes = set()
        for word in ("rcm", "creation", None):
            self.call("mesh", lake, "-o", "lake.msh", *(["--numbering", word] if word else []))
            hashes.add(re.search(r"hash (\S+)", self.call("check", "lake.msh").stdout)[1])
            (self.assertGreater if word == "creation" else self.assertLessEqual)(self.msh_bandwidth("lake.msh"), 60)
        self.assertEqual(len(hashes), 1)
        self.call("mesh", lake.with_name("plate.json"), "-o", "large.msh", "--size", "0.5", "-q")  # of 87,150 nodes
        self.assertLessEqual(self.msh_bandwidth("large.msh"), 400)
        # Triangle's readers expect the nodes of the input first; convert keeps the numbers that it reads.
        first = lambda name: [tuple(map(float, row.split()[1:3])) for row in self.read(name).split("\n")[1:9]]
        self.call("mesh", "plate.poly", "-o", "plate.node", "--size", "0.2")
        self.assertEqual(first("plate.node"), SQUARE + HOLE)
        self.call("mesh", "plate.poly", "-o", "rcm.node", "--size", "0.2", "--numbering", "rcm")
        self.assertNotEqual(first("rcm.node"), SQUARE + HOLE)
        self.call("convert", "plate.node", "-o", "plate.msh")
        wide = self.msh_bandwidth("plate.msh")
        self.call("convert", "plate.node", "-o", "plate.msh", "--numbering", "rcm")
        self.assertLess(3 * self.msh_bandwidth("plate.msh"), wide)
        self.assertIn("--numbering: no mesh is written",
                      self.call("mesh", "plate.poly", "--stats", "-", "--numbering", "rcm", code=2).stderr)

    def test_names_that_a_format_changes_are_reported(self):
        self.write("named.poly", poly([SQUARE]) + '# boundary 1 "4th wall"\n')
        done = self.call("mesh", "named.poly", "-o", "named.inp", "-o", "named.vtu")
        self.assertRegex(done.stderr, r"^named.inp: note: .*'4th wall' is n_4th_wall.* \[changed-names\]\n")
        self.assertNotIn("named.vtu", done.stderr)
        self.assertEqual(self.call("mesh", "named.poly", "-q", "-o", "named.inp").stderr, "")

    def test_quiet_prints_nothing(self):
        done = self.call("mesh", "plate.poly", "-o", "plate.msh", "--quiet")
        self.assertEqual((done.stdout, done.stderr), ("", ""))
        adapt = self.call("adapt", "plate.msh", "--expression", "x*x", "--error", "0.3", "-o", "new.msh", "-q")
        self.assertEqual((adapt.stdout, adapt.stderr), ("", ""))
        self.write("bow.poly", poly([BOW]))
        repaired = self.call("mesh", "bow.poly", "-o", "bow.msh", "--repair", "-q")
        self.assertEqual((repaired.stdout, repaired.stderr), ("", ""))

    def test_statistics_can_be_printed_for_a_script_to_read(self):
        for more in ([], ["-q"]):
            printed = json.loads(self.call("mesh", "plate.poly", "-o", "plate.msh", "--stats", "-", *more).stdout)
            self.assertGreater(printed["seconds_mesh"], 0)
        self.assertIn(f"hash {printed['hash']}", self.call("check", "plate.msh").stdout)
        self.assertFalse((self.path / "-").exists())

    def test_an_extension_that_contradicts_the_format_is_refused(self):
        for words in (["-o", "a.vtu", "--format", "msh41"], ["-o", "a.geojson", "--format", "msh2"],
                      ["-o", "a.vtu", "-o", "a.msh", "--format", "msh41"]):
            errors = self.call("mesh", "plate.poly", *words, code=2).stderr
            for part in (words[1], words[-1], "(.msh)"):
                self.assertIn(part, errors)
        self.assertIn("project", self.call("mesh", "plate.poly", "-o", "a.forefront", "--format", "msh2", code=2).stderr)
        self.assertEqual([p.name for p in self.path.iterdir()], ["plate.poly"])
        self.call("mesh", "plate.poly", "-o", "a.MSH", "--format", "msh41")
        self.call("mesh", "plate.poly", "-o", "b.ele", "-o", "c.ele", "--format", "triangle")
        self.assertEqual(self.read("b.ele"), self.read("c.ele"))

    def test_a_spacing_file_elsewhere_is_refused_and_a_partial_one_is_noted(self):
        grid = "ncols 2\nnrows 1\nxllcorner %s\nyllcorner 1\ncellsize 1\n0.2 %s\n"
        self.write("outside.asc", grid % (200, 0.4))
        fault = self.call("mesh", "plate.poly", "--spacing-file", "outside.asc", "--stats", "s.json", code=1).stderr
        self.assertIn("does not meet the domain: the mesh lies from (200, 1) to (202, 2), the domain from (0, 0) to (4, 3)",
                      fault)
        self.write("partial.asc", grid % (2, 0.2))
        done = self.call("mesh", "plate.poly", "--spacing-file", "partial.asc", "--stats", "s.json")
        self.assertRegex(done.stderr, r"note: the background mesh covers about 1\d % of the domain")
        self.assertNotIn("note", self.call("mesh", "plate.poly", "--spacing-file", "partial.asc", "--stats", "s.json",
                                           "-q").stderr)

    def test_a_layer_between_the_segments_of_a_poly_file_is_a_narrow_place(self):
        nodes = [(0, 0), (10, 0), (10, 2), (10, 2.2), (10, 5), (0, 5), (0, 2.2), (0, 2)]
        edges = [(1, 2), (2, 3), (3, 4), (4, 5), (5, 6), (6, 7), (7, 8), (8, 1), (8, 3), (7, 4)]
        self.write("layer.poly", "8 2 0 0\n" + "".join(f"{i} {x} {y}\n" for i, (x, y) in enumerate(nodes, 1)) +
                   "10 1\n" + "".join(f"{i} {a} {b} {i}\n" for i, (a, b) in enumerate(edges, 1)) +
                   "0\n3\n1 5 1 1\n2 5 2.1 2\n3 5 4 3\n")
        self.call("mesh", "layer.poly", "-o", "layer.msh", "--size", "1", "--elements-across", "4")
        self.call("check", "layer.msh", "--min-across", "4")
        self.call("mesh", "layer.poly", "-o", "coarse.msh", "--size", "1")
        self.assertIn("violated", self.call("check", "coarse.msh", "--min-across", "2", code=1).stdout)

    def test_a_steep_spacing_is_limited_with_a_note(self):
        steep = ("mesh", "plate.poly", "--stats", "s.json", "--spacing", "max(0.02, 2*dist(3, 1))")
        note = self.call(*steep).stderr
        self.assertIn("note: the spacing expression changes by more than 0.5 per unit of distance, which elements cannot "
                      "follow; limited to 0.5", note)
        self.assertIn("add --gradation G for another limit", note)
        self.assertEqual("", self.call(*steep, "--gradation", "0.3").stderr)

    def test_a_spacing_may_vanish_in_a_hole(self):
        self.call("mesh", "plate.poly", "--spacing", "0.2*dist(1.5, 1.5)", "-o", "a.msh")
        self.assertIn("violated", self.call("check", "a.msh", "--spacing", "0.2*dist(1.5, 1.5)", "--min-delta", "0.99",
                                            code=1).stdout)
        fault = self.call("mesh", "plate.poly", "--spacing", "0.2*dist(2.5, 1.5)", "--stats", "s.json", code=1).stderr
        self.assertIn("the spacing expression gives zero; expected a number above 0 at (2.5, 1.5)", fault)

    def test_a_grid_of_sizes_is_a_spacing(self):
        header = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 2\n"
        self.write("even.asc", header + "0.4 0.4\n0.4 0.4\n")
        self.write("finer.asc", header + "0.4 0.4\n0.15 0.4\n")
        even = self.stats("plate.poly", "--spacing-file", "even.asc")["elements"]
        self.assertLess(1.2 * even, self.stats("plate.poly", "--spacing-file", "finer.asc")["elements"])
        self.write("bad.asc", header + "0.1 0.1\n0 0.1\n")
        fault = self.call("mesh", "plate.poly", "--spacing-file", "bad.asc", "--stats", "s.json", code=1).stderr
        self.assertIn("bad.asc:7:1: error: expected a size above 0, got 0 [bad-values]", fault)

    def test_a_picture_is_a_spacing(self):
        self.picture("grey.png", 51)
        grey, options = ("--spacing-file", "grey.png"), ("--picture-sizes", "0.1:0.6")
        place = ("--picture-box", "-9,-9,9,9")
        self.assertEqual(self.stats("plate.poly", *grey, *options, *place)["hash"],
                         self.stats("plate.poly", *grey, "--picture-sizes", "0.2:0.2", *place)["hash"])
        self.assertEqual(self.stats("plate.poly", *grey, *options)["hash"],  # covers the 4 x 3 plate
                         self.stats("plate.poly", *grey, *options, "--picture-box", "-1,0,5,3")["hash"])
        self.assertNotEqual(self.stats("plate.poly", *grey, *options)["hash"],
                            self.stats("plate.poly", *grey, *options, "--picture-box", "0,0,1,1")["hash"])
        for words, part in (((), "add --picture-sizes BLACK:WHITE"),
                            (("--picture-sizes", "0.1"), "expected two positive numbers such as 0.1:2, got '0.1'"),
                            (("--picture-sizes", "0:1"), "got '0:1'"),
                            (("--picture-sizes", "1:2:3"), "got '1:2:3'"),
                            ((*options, "--picture-box", "0,0,0,1"), "such as 0,0,20,10, got '0,0,0,1'")):
            self.assertIn(part, self.call("mesh", "plate.poly", "-o", "a.msh", *grey, *words, code=2).stderr)
        self.assertIn("plate.poly is not a picture; expected a PNG file", self.call(
            "mesh", "plate.poly", "-o", "a.msh", "--spacing-file", "plate.poly", *options, code=2).stderr)
        self.assertIn("add --spacing-file FILE.png", self.call("mesh", "plate.poly", "-o", "a.msh", *options, code=2).stderr)
        (self.path / "cut.png").write_bytes((self.path / "grey.png").read_bytes()[:50])
        fault = self.call("mesh", "plate.poly", "--spacing-file", "cut.png", *options, "--stats", "s.json", code=1).stderr
        self.assertIn("error: cannot decode the picture: the file ends early [bad-picture]", fault)

    def test_a_background_picture_as_spacing_stays_in_its_place(self):
        self.picture("grey.png", 0)
        shape = '{"id": 1, "kind": "rectangle", "nodes": [[0, 0], [4, 2]], "tag": 1}'
        self.write("plate.json", '{"format": "forefront", "version": 2, "shapes": [' + shape + '], "picture": '
                   '{"file": "grey.png", "at": [0, 0], "size": [1, 2]}}')
        words = ("--spacing-file", "grey.png", "--picture-sizes", "0.05:1")
        self.assertEqual(self.stats("plate.json", *words)["hash"],
                         self.stats("plate.json", *words, "--picture-box", "0,0,1,2")["hash"])

    def test_a_project_keeps_its_spacing_under_any_name(self):
        self.write("plate.json", PROJECT)
        expected = self.stats("plate.json")["hash"]
        self.assertNotEqual(expected, self.stats("plate.json", "--size", "1")["hash"])
        for name in ("PLATE.JSON", "plate", "plate.txt"):
            self.write(name, PROJECT)
            self.assertEqual(self.stats(name)["hash"], expected, name)
        os.mkfifo(self.path / "pipe.json")
        process = subprocess.Popen([PROGRAM, "mesh", "pipe.json", "--stats", "-"], cwd=self.path,
                                   stdout=subprocess.PIPE, text=True)
        (self.path / "pipe.json").write_text(PROJECT)
        self.assertEqual(json.loads(process.communicate(timeout=60)[0])["hash"], expected)

    def test_parameters_of_a_project_can_be_set(self):
        self.write("disc.json", """{"format": "forefront", "version": 2, "spacing": {"size": 0.2},
            "shapes": [{"id": 1, "kind": "circle", "nodes": [[0, 0], [2, 0]]}],
            "parameters": {"d": "2*r", "r": "1"}, "formulas": {"shape/1/radius": "d"}}""")
        for setting, radius in ([], 2.0), (["--set", "r=1.5"], 3.0), (["--set", "r=3", "--set", "d=r-1"], 2.0), \
                (["--set", " r = 1.5 "], 3.0):
            self.call("mesh", "disc.json", "-o", "disc.vtu", "--stats", "disc-stats.json", *setting)
            area = json.loads(self.read("disc-stats.json"))["area"]
            self.assertAlmostEqual(area, math.pi * radius * radius, delta=0.02 * area)
        self.write("slot.json", """{"format": "forefront", "version": 2, "spacing": {"size": 0.3},
            "shapes": [{"id": 1, "kind": "slot", "nodes": [[0, 0], [3, 4]], "radius": 1}],
            "parameters": {"w": "2", "L": "5"}, "formulas": {"shape/1/width": "w", "shape/1/length": "L"}}""")
        for setting, width, length in ([], 2.0, 5.0), (["--set", "w=3", "--set", "L=7"], 3.0, 7.0):
            self.call("mesh", "slot.json", "-o", "slot.vtu", "--stats", "slot-stats.json", *setting)
            area = json.loads(self.read("slot-stats.json"))["area"]
            self.assertAlmostEqual(area, width * length + 0.25 * math.pi * width * width, delta=0.02 * area)
        line = self.call("mesh", "disc.json", "-o", "disc.vtu", "--set", "q=1", code=1).stderr
        self.assertIn("unknown parameter 'q'; expected d, r", line)
        self.assertIn("depends on itself", self.call("mesh", "disc.json", "-o", "disc.vtu", "--set", "r=d", code=1).stderr)
        self.call("mesh", "disc.json", "-o", "disc.vtu", "--set", "r", code=2)
        self.call("mesh", "plate.poly", "-o", "plate.vtu", "--set", "r=1", code=2)

    def test_faults_of_the_expression_in_a_project_have_their_place(self):
        self.write("plate.json", PROJECT.replace('"size": 0.3', '\n  "expression": "0.1*("'))
        start = "plate.json:2:17: error: expression, column 6: "
        for command in (["mesh", "plate.json", "-o", "a.vtu"], ["film", "plate.json", "-o", "a.gif"]):
            self.assertTrue(self.call(*command, code=1).stderr.startswith(start), command)
        self.call("mesh", "plate.poly", "-o", "a.vtu", "--spacing-file", "plate.json", code=1)
        mistyped = self.call("mesh", "plate.json", "-o", "a.vtu", "--spacing", "0.1*(", code=2).stderr
        self.assertNotIn("plate.json", mistyped)

    def test_devices_without_an_end_are_refused(self):
        for name in ("/dev/zero", "-"):
            with open("/dev/zero", "rb") as zero:
                done = subprocess.run([PROGRAM, "mesh", name, "-o", "a.msh", "--input-format", "poly"], cwd=self.path,
                                      stdin=zero, capture_output=True, text=True, timeout=60)
            self.assertEqual(done.returncode, 1)
            self.assertIn("it is a device, not a file", done.stderr)
        self.assertIn("empty", self.call("mesh", "/dev/null", "-o", "a.msh", code=1).stderr)

    def test_sizes_of_regions_can_be_set(self):
        self.write("halves.json", """{"format": "forefront", "version": 2, "spacing": {"size": 0.2},
            "shapes": [{"id": 1, "kind": "polygon", "nodes": [[0, 0], [1, 0], [2, 0], [2, 1], [1, 1], [0, 1]]},
                       {"id": 2, "kind": "polyline", "use": "constraint", "tag": 2, "nodes": [[1, 0], [1, 1]]}],
            "regionMarkers": [{"at": [0.5, 0.5], "tag": 2, "size": 0.1, "growth": 0.5}],
            "parameters": {"h": "0.1"}, "formulas": {"region/0/size": "h"}}""")
        counts = []
        for setting in [], ["--set", "h=0.05"], ["--set", "h=0.02"]:
            self.call("mesh", "halves.json", "-o", "halves.vtu", "--stats", "halves-stats.json", *setting)
            counts.append(json.loads(self.read("halves-stats.json"))["elements"])
        self.assertGreater(counts[1], 2 * counts[0])
        self.assertGreater(counts[2], 4 * counts[1])
        refused = self.call("mesh", "halves.json", "-o", "halves.vtu", "--set", "h=0", code=1).stderr
        self.assertIn("invalid size 0 of a region; expected a number above 0", refused)

    def test_the_number_of_elements_stays_when_a_parameter_changes_the_length(self):
        self.write("hole.json", """{"format": "forefront", "version": 2, "spacing": {"size": 20, "segmentsPerTurn": 0},
            "shapes": [{"id": 1, "kind": "rectangle", "nodes": [[-99, -99], [99, 99]]},
                       {"id": 2, "kind": "circle", "nodes": [[0, 0], [8, 0]], "tag": 2}],
            "elementCounts": [{"tag": 2, "elements": 24}],
            "parameters": {"d": "16"}, "formulas": {"shape/2/radius": "d/2"}}""")
        for setting in [], ["--set", "d=20"], ["--set", "d=11.3"]:
            self.call("mesh", "hole.json", "-o", "hole.su2", *setting)
            self.assertIn("MARKER_TAG= boundary_2\nMARKER_ELEMS= 24\n", self.read("hole.su2"), setting)
        self.call("mesh", "hole.json", "-o", "hole.su2", "--size", "1")  # replaces the spacing of the project
        self.assertNotIn("MARKER_ELEMS= 24\n", self.read("hole.su2"))

    def test_parameters_move_what_is_joined(self):
        rooms = """{"format": "forefront", "version": 2, "spacing": {"size": 1},
            "shapes": [{"id": 1, "kind": "polygon", "nodes": [[0, 0], [4, 0], [8, 0], [8, 3], [4, 3], [0, 3]]},
                       {"id": 2, "kind": "polyline", "use": "constraint", "tag": 2, "nodes": [[4, 0], [4, 3]]}],
            "regionMarkers": [{"at": [1, 1], "tag": 2}, {"at": [7, 1], "tag": 3}],
            "parameters": {"w": "4"}, "formulas": {"shape/1/x/1": "w", "shape/1/x/4": "w"}}"""
        self.write("rooms.json", rooms)
        for setting, width in ([], 4.0), (["--set", "w=5"], 5.0), (["--set", "w=2.5"], 2.5):
            self.call("mesh", "rooms.json", "-o", "rooms.vtu", "--stats", "rooms-stats.json", *setting)
            areas = [region["area"] for region in json.loads(self.read("rooms-stats.json"))["regions"]]
            self.assertAlmostEqual(areas[0], 3.0 * width, delta=1e-9)  # the wall between them follows
            self.assertAlmostEqual(areas[1], 3.0 * (8.0 - width), delta=1e-9)
        self.write("locked.json", rooms.replace('"kind": "polyline",', '"kind": "polyline", "locked": true,'))
        refused = self.call("mesh", "locked.json", "-o", "rooms.vtu", "--set", "w=5", code=1).stderr
        self.assertIn("the joint of polygon 1 and polyline 2 at (4, 0) cannot hold", refused)

    def test_a_conflict_of_a_sample_names_few_constraints(self):
        bracket = pathlib.Path(__file__).parents[2] / "assets" / "samples" / "bracket.json"
        refused = self.call("mesh", str(bracket), "-o", "bracket.vtu", "--set", "d=300", code=1).stderr
        self.assertIn("Upper arm", refused)
        self.assertLess(refused.count(","), 12, refused)  # of 31 constraints

    def test_parameters_drive_the_dimensions_of_a_sketch(self):
        self.write("part.json", """{"format": "forefront", "version": 2, "spacing": {"size": 4},
            "shapes": [{"id": 1, "kind": "polygon", "nodes": [[0, 0], [40, 0], [40, 30], [0, 30]]},
                       {"id": 2, "kind": "circle", "nodes": [[20, 15], [25, 15]], "tag": 2}],
            "constraints": [
                {"id": 3, "kind": "horizontal", "name": "Bottom", "of": ["shape/1/segment/0"]},
                {"id": 4, "kind": "horizontal", "name": "Top", "of": ["shape/1/segment/2"]},
                {"id": 5, "kind": "vertical", "name": "Right", "of": ["shape/1/segment/1"]},
                {"id": 6, "kind": "vertical", "name": "Left", "of": ["shape/1/segment/3"]},
                {"id": 7, "kind": "length", "name": "Width", "of": ["shape/1/node/0", "shape/1/node/1"], "value": 40},
                {"id": 8, "kind": "length", "name": "Height", "of": ["shape/1/node/1", "shape/1/node/2"], "value": 30},
                {"id": 9, "kind": "distance", "name": "Diagonal", "of": ["shape/1/node/0", "shape/1/node/2"], "value": 50},
                {"id": 10, "kind": "fixed", "name": "Corner", "of": ["shape/1/node/0"]},
                {"id": 11, "kind": "diameter", "name": "Hole", "of": ["shape/2/segment/0"], "value": 10},
                {"id": 12, "kind": "midpoint", "name": "Centred",
                 "of": ["shape/2/node/0", "shape/1/node/0", "shape/1/node/2"]}],
            "parameters": {"s": "1", "h": "30", "d": "10"},
            "formulas": {"constraint/7/value": "40*s", "constraint/8/value": "h*s", "constraint/9/value": "50*s",
                         "constraint/11/value": "d"}}""")
        for setting, width, height, d in ([], 40, 30, 10), (["--set", "d=20"], 40, 30, 20), \
                (["--set", "s=2", "--set", "d=6"], 80, 60, 6):
            self.call("mesh", "part.json", "-o", "part.vtu", "--stats", "part-stats.json", *setting)
            area = json.loads(self.read("part-stats.json"))["area"]
            self.assertAlmostEqual(area, width * height - 0.25 * math.pi * d * d, delta=0.005 * area)
        refused = self.call("mesh", "part.json", "-o", "part.vtu", "--set", "h=31", code=1).stderr
        self.assertIn("error: constraints Bottom, Right, Width, Height and Diagonal cannot hold together [constraint-conflict]",
                      refused)
        self.call("film", "part.json", "-o", "part.svg", "--set", "d=12")
        self.call("mesh", "part.json", "-o", "part.msh", "--set", "d=20")
        self.call("check", "part.msh", "--domain", "part.json", code=1)
        self.call("check", "part.msh", "--domain", "part.json", "--set", "d=20")

    def test_film_and_check_set_parameters_too(self):
        self.write("disc.json", """{"format": "forefront", "version": 2, "spacing": {"size": 0.1},
            "shapes": [{"id": 1, "kind": "circle", "nodes": [[0, 0], [1, 0]]}],
            "parameters": {"r": "1"}, "formulas": {"shape/1/radius": "r"}}""")
        self.call("mesh", "disc.json", "-o", "disc.msh", "--set", "r=2")
        self.call("check", "disc.msh", "--domain", "disc.json", code=1)
        self.assertIn("valid for the domain", self.call("check", "disc.msh", "--domain", "disc.json", "--set", "r=2").stdout)
        self.assertIn("add --domain or --limits", self.call("check", "disc.msh", "--set", "r=2", code=2).stderr)
        self.assertIn("only projects", self.call("check", "disc.msh", "--domain", "plate.poly", "--set", "r=2", code=2).stderr)
        self.call("film", "disc.json", "-o", "small.svg")
        self.call("film", "disc.json", "-o", "large.svg", "--set", "r=2")
        self.assertGreater(len(self.read("large.svg")), 1.2 * len(self.read("small.svg")))  # more elements
        self.assertIn("unknown parameter", self.call("film", "disc.json", "-o", "x.svg", "--set", "q=2", code=1).stderr)
        self.call("film", "plate.poly", "-o", "x.svg", "--set", "r=2", code=2)

    def on_terminal(self, *words):
        """Returns the exit code of a run and what it wrote to a terminal."""
        try:
            leader, follower = pty.openpty()
        except OSError as error:
            self.skipTest(f"no terminal to be had here: {error}")
        process = subprocess.Popen([PROGRAM, *words], cwd=self.path, stdout=follower, stderr=follower)
        os.close(follower)
        shown = b""
        try:
            while piece := os.read(leader, 4096):
                shown += piece
        except OSError:  # the end, on Linux
            pass
        os.close(leader)
        return process.wait(timeout=60), shown

    def test_progress_bar_shows_on_a_terminal(self):
        code, shown = self.on_terminal("mesh", "plate.poly", "-o", "a.msh", "--size", "0.01", "--stats", "a.json")
        self.assertEqual(code, 0)
        self.assertRegex(shown, rb"\[#*\.*\]\s+\d+ %")

    def test_nothing_is_printed_on_the_line_of_the_progress_bar(self):
        ring = "[[10, 50], [11, 50], [11, 51], [10, 50]]"
        self.write("map.geojson", '{"type": "Polygon", "coordinates": [' + ring + ']}')
        self.call("mesh", "plate.poly", "-o", "plate.msh")
        runs = ((0, ("mesh", "map.geojson", "-o", "a.vtu")), (1, ("mesh", "missing.poly", "-o", "a.vtu")),
                (0, ("convert", "plate.msh", "-o", "a.vtu")), (1, ("convert", "missing.msh", "-o", "a.vtu")),
                (0, ("adapt", "plate.msh", "--expression", "x*x", "--error", "0.1", "-o", "b.msh")),
                (1, ("adapt", "missing.msh", "--expression", "x*x", "--error", "0.1", "-o", "b.msh")))
        for expected, words in runs:
            with self.subTest(words=words):
                code, shown = self.on_terminal(*words)
                self.assertEqual(code, expected)
                lines = [line.rpartition(b"\x1b[K")[2] for line in shown.split(b"\n")]
                self.assertEqual([line for line in lines if b" % " in line and line.startswith(b"[")], [])
                self.assertGreater(len(lines), 1)  # something was printed

    def test_interrupt_cancels_and_leaves_nothing(self):
        process = subprocess.Popen([PROGRAM, "mesh", "plate.poly", "-o", "big.msh", "--size", "0.0004",
                                    "--max-elements", "7e8"], cwd=self.path,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        time.sleep(1.0)
        self.assertIsNone(process.poll(), "finished before it could be cancelled")
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 3, errors)
        self.assertEqual([p.name for p in self.path.iterdir()], ["plate.poly"])


class Streams(Case):
    def pipe(self, *words, text, code=0):
        done = subprocess.run([PROGRAM, *words], cwd=self.path, input=text.encode(), capture_output=True, timeout=300)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stdout, done.stderr.decode()

    def test_standard_input_and_output_stand_for_files(self):
        self.call("mesh", "plate.poly", "-o", "plate.msh", "--size", "0.3")
        domain = self.read("plate.poly")
        out, messages = self.pipe("mesh", "-", "--input-format", "poly", "-o", "-", "--format", "msh2", "--size", "0.3",
                                  text=domain)
        self.assertEqual(out, (self.path / "plate.msh").read_bytes())
        self.assertRegex(messages, r"\d+ nodes, \d+ elements, hash [0-9a-f]{16}")
        out, messages = self.pipe("mesh", "-", "--input-format", "poly", "-o", "-", "--format", "msh41-binary", "-q",
                                  text=domain)
        self.assertTrue(out.startswith(b"$MeshFormat\n4.1 1 8\n"))
        self.assertEqual(messages, "")
        out, _ = self.pipe("check", "-", "--domain", "plate.poly", text=self.read("plate.msh"))
        self.assertIn(b"valid for the domain", out)
        out, _ = self.pipe("check", "plate.msh", "--domain", "-", text=self.read("plate.msh"))
        self.assertIn(b"valid for the domain", out)
        out, _ = self.pipe("mesh", "-", "--stats", "-", text=PROJECT)
        self.assertGreater(json.loads(out)["elements"], 100)
        out, messages = self.pipe("adapt", "-", "--expression", "x*x", "--error", "0.3", "-o", "-", "--format", "vtu",
                                  text=self.read("plate.msh"))
        self.assertTrue(out.startswith(b"<?xml"))
        self.assertIn("mesh 0:", messages)
        self.assertEqual({p.name for p in self.path.iterdir()}, {"plate.poly", "plate.msh"})

    def test_faults_of_standard_input_are_located(self):
        _, messages = self.pipe("mesh", "-", "--input-format", "poly", "-o", "a.msh", text=poly([BOW]), code=1)
        self.assertRegex(messages, r"^standard input:\d+: error: two segments cross")
        _, messages = self.pipe("mesh", "-", "-o", "a.msh", text="nothing", code=1)
        self.assertIn("standard input: error: cannot detect the format from the content [unknown-format]; "
                      "add --input-format with one of project, geojson", messages)
        _, messages = self.pipe("check", "plate.poly", "--domain", "-", text="nothing", code=1)
        self.assertNotIn("--input-format", messages)

    def test_wrong_use_of_streams_is_refused(self):
        for words, message in ((["mesh", "plate.poly", "-o", "-"], "--format"),
                               (["mesh", "plate.poly", "-o", "-", "--format", "triangle"], "several files"),
                               (["mesh", "plate.poly", "-o", "-", "--format", "vtu", "--stats", "-"], "--stats"),
                               (["mesh", "-", "--input-format", "step", "-o", "a.msh"], "unknown format 'step'"),
                               (["check", "-", "--domain", "-"], "only once"),
                               (["mesh", "plate.poly", "-o", "-", "-o", "-", "--format", "vtu", "--format", "vtu"],
                                "given twice")):
            self.assertIn(message, self.call(*words, code=2).stderr)


class Imports(Case):
    MSH = ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 1 \"inlet\"\n$EndPhysicalNames\n"
           "$Nodes\n4\n1 0 0 0\n2 4 0 0\n3 4 4 0\n4 0 4 0\n$EndNodes\n"
           "$Elements\n3\n1 1 2 1 1 1 2\n2 2 2 1 1 1 2 3\n3 2 2 1 1 1 3 4\n$EndElements\n")

    @staticmethod
    def lengths(text):
        """Length of the boundary by physical name in an ASCII MSH 2.2 file, read without the program."""
        names = {int(t): n for d, t, n in re.findall(r'^(\d) (\d+) "(.*)"$', text, re.M) if d == "1"}
        nodes = {int(line.split()[0]): tuple(map(float, line.split()[1:3]))
                 for line in text.split("$Nodes\n")[1].split("$EndNodes")[0].splitlines()[1:]}
        sums = {}
        for tag, a, b in re.findall(r"^\d+ 1 2 (\d+) \d+ (\d+) (\d+)$", text, re.M):
            name = names[int(tag)]
            sums[name] = sums.get(name, 0) + math.dist(nodes[int(a)], nodes[int(b)])
        return sums

    def test_a_part_of_lines_and_arcs_keeps_area_layers_and_curves(self):
        def entity(kind, layer, **groups):
            return [("0", kind), ("8", layer), *((code[1:], value) for code, value in groups.items())]
        part = [[("0", "SECTION"), ("2", "HEADER"), ("9", "$INSUNITS"), ("70", 4), ("0", "ENDSEC"), ("0", "SECTION"),
                 ("2", "ENTITIES")]]
        corners = [(105, 0), (0, 0), (0, 100), (30, 100), (30, 50)]
        lines = [*zip(corners, corners[1:]), ((50, 30), (105, 30))]
        part += [entity("LINE", "FIXED" if k == 1 else "EDGE", _10=a[0], _20=a[1], _11=b[0], _21=b[1])
                 for k, (a, b) in enumerate(lines)]
        part += [entity("ARC", "EDGE", _10=50, _20=50, _40=20, _50=180, _51=270),
                 entity("ARC", "EDGE", _10=105, _20=15, _40=15, _50=270, _51=90),
                 entity("CIRCLE", "PIN", _10=105, _20=15, _40=8), [("0", "ENDSEC"), ("0", "EOF")]]
        self.write("part.dxf", "".join(f"{code}\n{value}\n" for groups in part for code, value in groups))
        stats = self.stats("part.dxf", "-o", "part.msh", "--segments-per-turn", "400")
        area = 3000 + 2250 + 0.5 * math.pi * 15**2 + (1 - 0.25 * math.pi) * 20**2 - math.pi * 8**2
        self.assertAlmostEqual(stats["area"], area, delta=0.05)  # chords: 1e-4 of the areas of the arcs
        self.assertEqual({boundary["name"] for boundary in stats["boundaries"]}, {"FIXED", "EDGE", "PIN"})
        blocks = re.findall(r"\$(\w+)\n(.*?)\$End", self.read("part.msh"), re.S)
        rows = {name: [line.split() for line in text.splitlines()] for name, text in blocks}
        [pin] = [row[1] for row in rows["PhysicalNames"] if row[-1] == '"PIN"']
        nodes = {row[0]: (float(row[1]), float(row[2])) for row in rows["Nodes"][1:]}
        edges = [row for row in rows["Elements"][1:] if row[1] == "1" and row[3] == pin]
        self.assertGreater(len(edges), 300)
        for row in edges:
            for node in row[-2:]:
                self.assertAlmostEqual(math.dist(nodes[node], (105, 15)), 8, delta=1e-9)

    def test_an_inlet_of_one_edge_stays_one_edge(self):
        self.write("part.msh", self.MSH)
        self.call("mesh", "part.msh", "-o", "out.msh", "--size", "1")
        sums = self.lengths(self.read("out.msh"))
        self.assertEqual(len(sums), 2)
        self.assertAlmostEqual(sums["inlet"], 4)
        self.assertAlmostEqual(sum(sums.values()), 16)
        self.call("check", "out.msh", "--domain", "part.msh")

    def test_what_is_not_used_is_reported_unless_quiet(self):
        self.write("a.geojson", '{"type": "Feature", "properties": {"depth": 3}, "geometry": {"type": "Polygon", '
                   '"coordinates": [[[0,0,1],[4,0,1],[4,3,1],[0,3,1],[0,0,1]]]}}')
        notes = self.call("mesh", "a.geojson", "-o", "a.msh").stderr.splitlines()
        self.assertEqual(notes, [
            "a.geojson:1:98: note: third coordinates are ignored: the domain is planar (5 times) [height]",
            'a.geojson:1:36: note: properties other than "name" and "tag" are ignored: \'depth\' [properties]'])
        self.assertEqual(self.call("mesh", "a.geojson", "-o", "a.msh", "-q").stderr, "")

    def test_a_ring_that_is_not_closed_is_reported(self):
        self.write("a.geojson", '{"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,3],[0,3]]]}')
        self.assertEqual(self.call("mesh", "a.geojson", "-o", "a.msh").stderr,
                         "a.geojson:1:37: note: rings that do not end where they begin are closed [open-ring]\n")

    def test_units_of_drawings_are_named_in_words(self):
        self.write("a.svg", '<svg width="2in" height="1in" viewBox="0 0 192 96"><rect width="192" height="96"/></svg>')
        self.assertIn("coordinates are in inches, the unit of the document's size",
                      self.call("mesh", "a.svg", "-o", "a.msh").stderr)

    def test_lines_that_close_are_an_outline(self):
        self.write("a.geojson", '{"type": "LineString", "coordinates": [[0,0],[4,0],[4,3],[0,3],[0,0]]}')
        self.assertIn("[lines-as-outline]", self.call("mesh", "a.geojson", "-o", "a.msh").stderr)
        self.call("check", "a.msh", "--domain", "a.geojson")

    def test_drawings_and_maps_are_arranged_and_every_change_is_reported(self):
        polygon = ('{"type": "Feature", "properties": {"name": "%s"}, "geometry": {"type": "Polygon", "coordinates": '
                   '[[[%g,0],[%g,0],[%g,1],[%g,1],[%g,0]]]}}')
        pair = [polygon % ("A", 0, 1, 1, 0, 0), polygon % ("B", 0.99, 2, 2, 0.99, 0.99)]
        self.write("map.geojson", '{"type": "FeatureCollection", "features": [%s]}' % ", ".join(pair))
        output = self.call("mesh", "map.geojson", "-o", "map.msh").stderr
        self.assertRegex(output, r"map\.geojson:\d+:\d+: note: resolved 1 overlap of features, 0\.01 in area, between A and B at \(")
        self.call("check", "map.msh", "--domain", "map.geojson")
        self.call("mesh", "map.geojson", "-o", "map.msh", "--strict", code=1)
        self.assertIn("moved 2 nodes onto others, at most 0.01 away",
                      self.call("mesh", "map.geojson", "-o", "map.msh", "--weld", "0.02").stderr)
        self.call("check", "map.msh", "--domain", "map.geojson", "--weld", "0.02")
        other = self.call("check", "map.msh", "--domain", "map.geojson", code=1).stderr
        self.assertIn("note: the domain was read with the default options [default-options]; repeat those", other)
        self.assertEqual(self.call("mesh", "map.geojson", "-o", "map.msh", "-q", "--overlap", "smaller").stderr, "")
        self.assertIn("expected a number of at least 0, got '-1'",
                      self.call("mesh", "map.geojson", "-o", "map.msh", "--weld", "-1", code=2).stderr)

    def test_maps_in_degrees_are_reported_and_can_be_projected(self):
        cell = '{"type": "Polygon", "coordinates": [[[24, 60], [25, 60], [25, 61], [24, 61], [24, 60]]]}'
        self.write("lake.geojson", cell)
        warned = self.call("mesh", "lake.geojson", "-o", "a.msh", "-q").stderr
        self.assertEqual(warned, "lake.geojson:1:1: warning: longitudes and latitudes in degrees are taken for coordinates in "
                                 "the plane: at latitude 60.5, lengths from west to east are 2.031 times too long; "
                                 "--projection local converts them to metres, --allow-degrees accepts them [degrees]\n")
        self.assertEqual(self.call("mesh", "lake.geojson", "-o", "b.msh", "--allow-degrees").stderr, "")
        self.assertEqual(self.read("a.msh"), self.read("b.msh"))
        self.assertIn("[degrees]; --projection", self.call("mesh", "lake.geojson", "-o", "a.msh", "--strict", code=1).stderr)
        done = self.call("mesh", "lake.geojson", "-o", "c.msh", "--projection", "local")
        self.assertIn("projected to metres about longitude 24.5, latitude 60.5 [projected]", done.stderr)
        area = float(re.search(r"area ([\d.e+]+),", done.stdout)[1])
        self.assertAlmostEqual(area / 6.088e9, 1, delta=1e-3)
        self.call("check", "c.msh", "--domain", "lake.geojson", "--projection", "local")
        self.assertIn("--projection", self.call("check", "c.msh", "--domain", "lake.geojson", code=1).stderr)
        self.call("film", "lake.geojson", "-o", "a.svg", "--projection", "local")
        self.call("adapt", "c.msh", "--expression", "x", "--error", "0.5", "--domain", "lake.geojson", "--projection",
                  "local", "-o", "d.msh")
        self.assertIn("only GeoJSON, TopoJSON, ESRI shapefile, GeoPackage, KML and FlatGeobuf files have longitudes and "
                      "latitudes",
                      self.call("mesh", "plate.poly", "-o", "a.msh", "--projection", "local", code=2).stderr)

    def test_adapting_takes_the_method_of_the_front(self):
        coarse = pathlib.Path(__file__).resolve().parents[2] / "assets/lessons/drawings/coarse.json"
        self.call("mesh", coarse, "-o", "c.msh", "-q")
        adapt = ("adapt", "c.msh", "--expression", "atan(2*(hypot(x-10,y-7)-4))", "--error", "0.2", "-o", "b.msh")
        rounds = [re.findall(r"(\d+) elements", self.call(*adapt, *method).stdout)
                  for method in ((), ("--method", "fast"), ("--method", "classic"))]
        self.assertEqual(rounds[0], rounds[1])
        self.assertEqual(rounds[2], ["154", "430", "754", "1144"])  # as lesson 9 and the Adapt panel say

    def test_options_without_effect_are_refused(self):
        self.write("a.svg", '<svg viewBox="0 0 4 3"><rect width="4" height="3"/></svg>')
        self.write("plate.json", PROJECT)
        self.write("disc.dxf", "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\nA\n10\n5\n20\n1\n40\n0.7\n0\nENDSEC\n0\nEOF\n")
        self.call("mesh", "plate.poly", "-o", "a.msh", "-q")
        for command, file, options in (
                ("mesh", "plate.poly", ["--overlap", "later"]), ("mesh", "a.svg", ["--overlap", "smaller"]),
                ("mesh", "plate.poly", ["--drop-lines"]), ("mesh", "plate.json", ["--drop-lines"]),
                ("mesh", "disc.dxf", ["--drop-lines"]),
                ("mesh", "plate.poly", ["--beyond-page"]), ("mesh", "plate.poly", ["--stroke-areas"]),
                ("mesh", "plate.poly", ["--shape-regions"]), ("mesh", "a.svg", ["--allow-degrees"]),
                ("film", "plate.poly", ["--layer", "x"])):
            output = "a.gif" if command == "film" else "b.msh"
            self.assertIn(f"{options[0]}: ", self.call(command, file, "-o", output, *options, code=2).stderr)
        for options in (["--repair"], ["--weld", "1"], ["--projection", "local"], ["--drop-lines"]):
            self.assertIn(f"{options[0]}: tells how to read the domain; add --domain",
                          self.call("check", "a.msh", *options, code=2).stderr)
        adapt = ["adapt", "a.msh", "-o", "b.msh", "--error", "0.1"]
        self.assertIn("--rounds: ", self.call(*adapt, "--field", "t", "--rounds", "3", code=2).stderr)
        self.assertIn("--layer: tells how", self.call(*adapt, "--expression", "x", "--layer", "a", code=2).stderr)
        self.assertIn("--inner-edges: no mesh is written",
                      self.call("mesh", "plate.poly", "--stats", "-", "--inner-edges", "drop", code=2).stderr)
        self.assertIn("--size: given 2 times; expected once",
                      self.call("mesh", "plate.poly", "-o", "b.msh", "--size", "1", "--size", "2", code=2).stderr)
        self.assertIn("parameter 'r' is set twice",
                      self.call("mesh", "plate.json", "-o", "b.msh", "--set", "r=1", "--set", "r=2", code=2).stderr)

    def test_a_layer_of_a_map_can_be_selected(self):
        self.write("atlas.json", '''{"type": "Topology", "arcs": [[[0, 0], [4, 0], [4, 3], [0, 0]], [[6, 0], [8, 0], [8, 1], [6, 0]]],
            "objects": {"counties": {"type": "Polygon", "arcs": [[0]], "properties": {"name": "A"}},
                        "nation": {"type": "Polygon", "arcs": [[1]], "properties": {"name": "B"}}}}''')
        self.assertIn("note: of several layers, only 'counties' is read, not 'nation'; --layer selects another [layers]",
                      self.call("mesh", "atlas.json", "-o", "a.msh").stderr)
        stats = self.stats("atlas.json", "-o", "b.msh", "--layer", "nation")
        self.assertEqual([(region["name"], round(region["area"], 9)) for region in stats["regions"]], [("B", 1)])
        self.call("check", "b.msh", "--domain", "atlas.json", "--layer", "nation")
        self.call("check", "b.msh", "--domain", "atlas.json", code=1)
        self.assertEqual(self.call("mesh", "atlas.json", "-o", "c.msh", "--layer", "states", code=1).stderr,
                         "atlas.json:2:24: error: unknown layer 'states' [unknown-layer]; expected one of 'counties', "
                         "'nation'\n")
        self.assertIn("--layer: only TopoJSON, GeoPackage, KML and DXF drawing files have layers",
                      self.call("mesh", "plate.poly", "-o", "c.msh", "--layer", "a", code=2).stderr)

    def test_names_of_a_map_can_come_from_any_property(self):
        polygon = ('{"type": "Feature", "properties": {"NAME_0": "Swiss", "NAME_1": "%s", "id": %d}, "geometry": '
                   '{"type": "Polygon", "coordinates": [[[%d,0],[%d,0],[%d,1],[%d,1],[%d,0]]]}}')
        pair = [polygon % ("Zürich", 261, 0, 1, 1, 0, 0), polygon % ("Bern", 351, 1, 2, 2, 1, 1)]
        self.write("map.geojson", '{"type": "FeatureCollection", "features": [%s]}' % ", ".join(pair))
        for names, options in ((["Zürich", "Bern"], []), (["261", "351"], ["--name-property", "id"]),
                               (["Swiss"], ["--name-property", "NAME_0"])):
            stats = self.stats("map.geojson", "-o", "map.msh", "-o", "map.vtu", *options)
            self.assertEqual([region["name"] for region in stats["regions"]], names)
            for name in names:
                self.assertIn(f'"{name}', self.read("map.msh"))
            self.call("check", "map.msh", "--domain", "map.geojson", *options)
        self.assertEqual(self.call("mesh", "map.geojson", "-o", "a.msh", "--name-property", "nom", code=1).stderr,
                         "map.geojson:1:1: error: no feature has a property 'nom' with text or a number "
                         "[unknown-property]; expected one of 'NAME_0', 'NAME_1', 'id'\n")
        self.assertIn("--name-property: only the features of GeoJSON, TopoJSON, ESRI shapefile, GeoPackage, KML and FlatGeobuf files "
                      "have properties",
                      self.call("mesh", "plate.poly", "-o", "a.msh", "--name-property", "id", code=2).stderr)

    def test_a_drawing_ends_at_its_page_unless_asked_otherwise(self):
        self.write("wide.svg", '<svg viewBox="0 0 10 10">\n<rect x="-5" width="9" height="6"/></svg>')
        self.assertIn("wide.svg:1:2: note: shapes are cut off at the page (the view box)",
                      self.call("mesh", "wide.svg", "-o", "cut.msh").stderr)
        self.call("check", "cut.msh", "--domain", "wide.svg")
        self.assertEqual(self.call("mesh", "wide.svg", "-o", "whole.msh", "-q", "--beyond-page").stderr, "")
        self.call("check", "whole.msh", "--domain", "wide.svg", "--beyond-page")
        self.call("check", "whole.msh", "--domain", "wide.svg", code=1)

    def test_lines_of_a_drawing_or_map_can_be_left_out(self):
        self.write("inked.svg", '<svg viewBox="0 0 10 10"><rect width="9" height="6"/>\n'
                                '<path fill="none" stroke="red" d="M1 1H8V5Z"/></svg>')
        self.write("plain.svg", '<svg viewBox="0 0 10 10"><rect width="9" height="6"/></svg>')
        line = '{"type": "LineString", "coordinates": [[1, 1], [3, 3]]}'
        square = '{"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]]}'
        self.write("roads.geojson", '{"type": "GeometryCollection", "geometries": [%s, %s]}' % (square, line))
        self.write("land.geojson", square)
        for lined, plain in (("inked.svg", "plain.svg"), ("roads.geojson", "land.geojson")):
            hashes = []
            for name, options in ((lined, []), (lined, ["--drop-lines"]), (plain, [])):
                done = self.call("mesh", name, "-o", "m.msh", *options)
                hashes.append(re.search(r"hash (\w+)", done.stdout)[1])
                self.assertEqual("lines are left out [dropped-lines]" in done.stderr, bool(options), done.stderr)
                self.call("check", "m.msh", "--domain", name, *options)
            self.assertEqual(hashes[1], hashes[2])
            self.assertNotEqual(hashes[0], hashes[1])
        self.write("line.geojson", '{"type": "LineString", "coordinates": [[0, 0], [4, 0], [4, 4], [0, 0]]}')
        self.call("mesh", "line.geojson", "-o", "m.msh", "--drop-lines")  # it bounds the domain

    def test_what_strokes_paint_can_be_meshed(self):
        self.write("bar.svg", '<svg viewBox="0 0 10 10"><path stroke="red" stroke-width="2" d="M1 5H8"/></svg>')
        self.assertIn("--stroke-areas", self.call("mesh", "bar.svg", "-o", "m.msh", code=1).stderr)
        self.assertAlmostEqual(self.stats("bar.svg", "-o", "m.msh", "--stroke-areas")["area"], 14)
        self.call("check", "m.msh", "--domain", "bar.svg", "--stroke-areas")

    def test_filled_shapes_can_be_regions(self):
        self.write("two.svg", '<svg viewBox="0 0 20 10"><rect id="steel" width="12" height="10"/>'
                              '<rect id="copper" x="10" width="10" height="10"/></svg>')
        self.assertIn("--shape-regions", self.call("mesh", "two.svg", "-o", "m.msh").stderr)
        regions = self.stats("two.svg", "-o", "m.msh", "--shape-regions")["regions"]
        self.assertEqual([(region["name"], round(region["area"], 9)) for region in regions],
                         [("steel", 100), ("copper", 100)])
        self.call("check", "m.msh", "--domain", "two.svg", "--shape-regions")

    def test_the_maximum_area_of_a_region_is_kept(self):
        text = poly([SQUARE]).rstrip() + "\n1\n1 2 1 1 "
        counts = []
        for area in (0.05, 0.005):
            self.write("area.poly", text + f"{area}\n")
            counts.append(self.stats("area.poly")["elements"])
        self.assertGreater(counts[0], 0.9 * 12 / 0.05)
        self.assertGreater(counts[1], 0.9 * 12 / 0.005)


class Refusing(Case):
    def test_faults_are_printed_with_their_place_one_per_line(self):
        self.write("bow.poly", poly([BOW]))
        done = self.call("mesh", "bow.poly", "-o", "bow.msh", code=1)
        self.assertFalse((self.path / "bow.msh").exists())
        self.assertEqual(done.stdout, "")
        lines = done.stderr.splitlines()
        self.assertTrue(all("error: " in line or "note: " in line for line in lines), done.stderr)
        crossing = [line for line in lines if "crossing-segments" in line]
        self.assertEqual(len(crossing), 1, done.stderr)
        self.call("mesh", "plate.poly", "-o", "plate.msh")
        checked = self.call("check", "plate.msh", "--domain", "bow.poly", code=1).stderr
        self.assertEqual(checked, done.stderr)
        self.assertIn("at (2, 1.5)", crossing[0])

    def faults(self, name, text, code, *options):
        """Lines of stderr with that code, for a domain file that is refused."""
        self.write(name, text)
        errors = self.call("mesh", name, "-o", "a.msh", *options, code=1).stderr
        found = [line for line in errors.splitlines() if f"[{code}]" in line]
        self.assertTrue(found, errors)
        self.assertTrue(all(line.startswith(name + ":") for line in errors.splitlines()), errors)
        return found

    def test_faults_of_a_domain_name_file_line_and_number_there(self):
        # Numbered from 10 and with comments: neither index nor number is the line.
        nodes = "# four corners\n4 2\n10 0 0\n11 4 3\n\n12 4 0\n13 0 3\n"
        [line] = self.faults("bow.poly", nodes + "4\n7 10 11\n8 11 12\n9 12 13 # crosses\n20 13 10\n0\n",
                             "crossing-segments")
        self.assertTrue(line.startswith("bow.poly:9: error: two segments cross at (2, 1.5): "
                                        "segment 7 (line 9) and segment 9 (line 11) [crossing-segments]; "), line)
        ends = self.faults("open.poly", nodes + "3\n7 10 12\n8 12 11\n9 11 13\n0\n", "open-chain")
        self.assertIn("node 10 (line 3)", ends[0])
        self.assertIn("node 13 (line 7)", ends[1])
        square = "4 2\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n4\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n1\n5 9 9\n"
        [line] = self.faults("hole.poly", square, "hole-outside")
        self.assertIn("hole marker 5 (line 12)", line)
        [line] = self.faults("hole.poly", square, "hole-outside", "--repair")
        self.assertIn("hole marker 5 (line 12)", line)
        self.write("apart.node", "4 2\n10 0 0\n11 4 3\n12 4 0\n13 0 3\n")
        [line] = self.faults("apart.poly", "0 2\n4\n7 10 11\n8 11 12\n9 12 13\n20 13 10\n0\n",
                             "crossing-segments")
        self.assertIn("segment 7 (line 3) and segment 9 (line 5)", line)
        [line] = self.faults("bow.geojson", '{"type": "Polygon", "coordinates": [\n'
                             '[[0, 0], [4, 3],\n  [4, 0], [0, 3], [0, 0]]]}', "crossing-segments", "--strict")
        self.assertEqual(line, "bow.geojson:2:2: error: the input would be changed: added a node where segments cross "
                         "at (2, 1.5) [crossing-segments]; correct the file, or leave out --strict")
        [line] = self.faults("bow.svg", '<svg viewBox="0 0 9 9">\n<line x1="3.5" y1="1.5" x2="3.8" y2="1.5"/>\n'
                             '<path d="M0 0 4 3 4 0 0 3z"/></svg>', "crossing-segments", "--strict")
        self.assertTrue(line.startswith("bow.svg:3:2: error: "), line)

    def test_advice_names_the_options_of_a_repair(self):
        [line] = self.faults("bow.poly", poly([BOW]), "crossing-segments")
        self.assertTrue(line.endswith("; move a node, or add --repair to split both where they cross"), line)

    def test_a_gap_is_reported_with_its_width_and_how_to_weld_it(self):
        nodes = "5 2\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n5 0 %s\n4\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n0\n"
        ends = self.faults("gap.poly", nodes % 0.01, "open-chain")
        self.assertEqual(len(ends), 2)
        for line, place in zip(ends, ("(0, 0): node 1 (line 2)", "(0, 0.01): node 5 (line 6)")):
            self.assertIn("the boundary ends at a node, 0.01 from the nearest other end; expected a closed loop at " +
                          place, line)
            self.assertIn("; close the loop, add --repair --weld 0.011, or ", line)
        self.call("mesh", "gap.poly", "-o", "a.msh", "--repair", "--weld", "0.011")
        repaired = self.call("mesh", "gap.poly", "-o", "a.msh", "--repair", code=1).stderr
        self.assertIn("gap.poly:2: error: the boundary ends at a node", repaired)
        self.assertIn("node 5 (line 6)", repaired)
        for line in self.faults("gap.poly", nodes % 2.5, "open-chain"):
            self.assertIn(", 2.5 from the nearest other end", line)
            self.assertNotIn("--weld", line)
        self.write("gap.svg", '<svg viewBox="0 0 9 9"><path fill="none" stroke="red" d="M0 0H4V3H0V.01"/></svg>')
        [line] = [line for line in self.call("mesh", "gap.svg", "-o", "a.msh", code=1).stderr.splitlines()
                  if "empty-domain" in line]
        self.assertIn("no boundary; a line ends, 0.01 from the nearest other end", line)
        self.assertIn("add --repair --weld 0.011", line)
        self.call("mesh", "gap.svg", "-o", "a.msh", "--weld", "0.011")

    def test_faults_left_by_a_repair_name_the_file_and_no_segments_that_it_does_not_have(self):
        self.write("bow.geojson", '{"type": "Polygon", "coordinates": [[[0, 0], [4, 3], [4, 0], [0, 3], [0, 0]]]}')
        self.assertIn("bow.geojson:1:38: note: ", self.call("mesh", "bow.geojson", "-o", "a.msh", "--repair").stderr)
        self.write("open.poly", poly([BOW]).replace("4 4 1 1\n", "").replace("\n4 1\n", "\n3 1\n"))
        output = self.call("mesh", "open.poly", "-o", "a.msh", "--repair", code=1).stderr.splitlines()
        notes = [line for line in output if "note: " in line]
        self.assertTrue(any("(line 7)" in line for line in notes), output)
        left = [line for line in output if line not in notes]
        self.assertTrue(left)
        for line in left:
            self.assertRegex(line, r"^open\.poly:[25]: error: .*: node [14] \(line [25]\) \[open-chain\]")

    def test_a_silent_pipe_can_be_interrupted(self):
        os.mkfifo(self.path / "pipe.poly")
        for command in (["mesh", "pipe.poly"], ["mesh", "plate.poly", "--spacing-file", "pipe.poly"],
                        ["adapt", "pipe.poly", "--expression", "x", "--error", "0.1"]):
            process = subprocess.Popen([PROGRAM, *command, "-o", "a.msh"], cwd=self.path, stderr=subprocess.PIPE,
                                       text=True)
            with open(self.path / "pipe.poly", "w"):  # returns once the program reads
                process.send_signal(signal.SIGINT)
                _, errors = process.communicate(timeout=60)
            self.assertEqual((process.returncode, errors), (3, "cancelled\n"))

    def test_repair_splits_crossings_and_reports_it(self):
        self.write("bow.poly", poly([BOW]))
        done = self.call("mesh", "bow.poly", "-o", "bow.msh", "--repair")
        self.assertEqual(done.stderr, "bow.poly:7: note: added a node where segments cross at (2, 1.5): "
                                      "segment 1 (line 7) [crossing-segments]\n")
        self.call("check", "bow.msh")
        self.call("check", "bow.msh", "--domain", "bow.poly", "--repair")
        self.call("check", "bow.msh", "--domain", "bow.poly", code=1)

    def test_check_expects_the_boundary_parts_that_a_repair_leaves(self):
        nodes = [(0, 0), (1, 0), (1, 1), (0, 1), (1, 0), (2, 0), (2, 1), (1, 1)]  # two squares, not joined
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "1", '1 1 "wall"', "$EndPhysicalNames",
                 "$Nodes", str(len(nodes))] + [f"{i} {x} {y} 0" for i, (x, y) in enumerate(nodes, 1)]
        lines += ["$EndNodes", "$Elements", "12"]
        for i in range(8):
            lines.append(f"{i + 1} 1 2 1 1 {i + 1} {i + 2 if i % 4 < 3 else i - 2}")
        for i, (a, b, c) in enumerate([(1, 2, 3), (1, 3, 4), (5, 6, 7), (5, 7, 8)], 9):
            lines.append(f"{i} 2 2 1 1 {a} {b} {c}")
        self.write("domain.msh", "\n".join(lines + ["$EndElements"]) + "\n")
        self.call("mesh", "domain.msh", "-o", "a.msh", "--repair")
        self.call("check", "a.msh", "--domain", "domain.msh", "--repair")
        self.call("check", "a.msh", "--domain", "domain.msh", code=1)

    def test_repair_closes_gaps_within_the_weld_tolerance_and_only_then(self):
        self.write("gap.poly", "5 2\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n5 0 0.01\n4\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n0\n")
        self.call("mesh", "gap.poly", "-o", "gap.msh", "--repair", code=1)
        done = self.call("mesh", "gap.poly", "-o", "gap.msh", "--repair", "--weld", "0.02")
        self.assertIn("note: moved 1 node onto another, at most 0.01 away at (0, 0.01)", done.stderr)
        self.call("check", "gap.msh")
        self.assertIn("--weld: Triangle domain files are read unchanged; add --repair",
                      self.call("mesh", "gap.poly", "-o", "gap.msh", "--weld", "0.02", code=2).stderr)
        self.assertIn("add --repair",
                      self.call("check", "gap.msh", "--domain", "gap.poly", "--weld", "0.02", code=2).stderr)

    def test_strict_accepts_an_exact_file_that_needs_no_change_and_refuses_one_that_does(self):
        self.call("mesh", "plate.poly", "-o", "plate.msh", "--strict")
        self.write("bow.poly", poly([BOW]))
        self.call("mesh", "bow.poly", "-o", "bow.msh", "--strict", code=1)
        self.call("mesh", "plate.poly", "-o", "plate.msh", "--strict", "--repair", code=2)

    def test_files_that_cannot_be_read_are_refused(self):
        self.call("mesh", "missing.poly", "-o", "a.msh", code=1)
        self.write("broken.poly", "12 2 0 0\n1 0 0\n")
        self.assertIn("broken.poly", self.call("mesh", "broken.poly", "-o", "a.msh", code=1).stderr)
        self.write("nan.poly", poly([[(0.0, 0.0), (1.0, 0.0), (math.nan, 1.0)]]))
        self.call("mesh", "nan.poly", "-o", "a.msh", code=1)
        self.call("check", "missing.msh", code=1)

    def test_outputs_that_cannot_be_written_are_reported(self):
        self.call("mesh", "plate.poly", "-o", "plate.msh")
        (self.path / "folder.msh").mkdir()
        for command in (["mesh", "missing.poly"], ["adapt", "missing.msh", "--expression", "x", "--error", "0.1"]):
            for path, why in (("no/such/folder/a.msh", "folder no/such/folder not found"), ("folder.msh", "it is a folder")):
                [line] = self.call(*command, "-o", path, code=1).stderr.splitlines()  # before the input is read
                self.assertTrue(line.startswith(f"{path}: error: ") and why in line, line)
        self.assertIn("folder gone not found", self.call("mesh", "plate.poly", "--stats", "gone/s.json", code=1).stderr)
        tables = self.call("tables", "--rows", "1A", "--svg", "gone/t.svg", code=1)
        self.assertIn("folder gone not found", tables.stderr)
        self.assertEqual(tables.stdout, "")

    def test_outputs_replace_earlier_files_together_or_not_at_all(self):
        before = {}
        for name in ("a.node", "a.ele", "a.edge", "a.msh", "a.json"):
            self.write(name, "old")
            before[name] = "old"

        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)  # writing then fails, as on a full disc
            resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, 50_000))

        done = subprocess.run([PROGRAM, "mesh", "plate.poly", "--size", "0.12", "-o", "a.node", "-o", "a.msh", "--stats",
                               "a.json", "-q"], cwd=self.path, capture_output=True, text=True, preexec_fn=limit,
                              restore_signals=False)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("File too large; the other files that belong to it were not replaced either", done.stderr)
        self.assertEqual({name: self.read(name) for name in before}, before)
        self.assertEqual(len(os.listdir(self.path)), 1 + len(before))
        self.call("mesh", "plate.poly", "--size", "0.12", "-o", "a.node", "-o", "a.msh", "--stats", "a.json", "-q")
        self.call("check", "a.node", "--domain", "plate.poly")
        self.call("mesh", "plate.poly", "--size", "0.5", "-o", "b.node", "-q")
        os.replace(self.path / "b.ele", self.path / "a.ele")
        self.assertIn("[mixed-files]", self.call("check", "a.node", code=1).stderr)

    def test_links_are_followed_and_write_protected_files_refused(self):
        os.symlink("target.msh", self.path / "link.msh")
        self.call("mesh", "plate.poly", "-o", "link.msh", "-q")
        self.assertTrue((self.path / "link.msh").is_symlink())
        self.call("check", "target.msh", "--domain", "plate.poly")
        self.write("kept.msh", "mine")
        os.chmod(self.path / "kept.msh", 0o444)
        for words in (["-o", "kept.msh"], ["--stats", "kept.msh"], ["-o", "a.msh", "-o", "kept.msh"]):
            self.assertEqual(self.call("mesh", "plate.poly", *words, code=1).stderr,
                             "kept.msh: error: cannot write the file: it is write-protected [cannot-write]; allow writing "
                             "with chmod u+w, or choose another name\n")
        self.assertEqual(self.read("kept.msh"), "mine")
        self.assertFalse((self.path / "a.msh").exists())

    def test_two_outputs_do_not_go_to_one_file(self):
        for words in (["-o", "a.msh", "-o", "./a.msh"], ["-o", "a.msh", "--stats", "a.msh"]):
            self.assertIn("two outputs", self.call("mesh", "plate.poly", *words, code=1).stderr)
        self.assertIn("has no file name", self.call("mesh", "plate.poly", "--stats", "", code=1).stderr)
        self.call("mesh", "plate.poly", "-o", "/dev/null", "-o", "/dev/null", "--format", "msh2", "--format", "msh2")

    def test_inputs_are_not_overwritten(self):
        self.call("mesh", "plate.poly", "-o", "plate.msh")
        self.call("mesh", "plate.poly", "-o", "plate.node")
        before = {name: self.read(name) for name in ("plate.poly", "plate.msh", "plate.node", "plate.ele")}
        for words in (["mesh", "plate.msh", "-o", "./plate.msh"], ["mesh", "plate.node", "-o", "plate.ele"],
                      ["mesh", "plate.poly", "-o", "a.msh", "--spacing-file", "plate.msh", "--stats", "plate.msh"],
                      ["adapt", "plate.msh", "--expression", "x", "--error", "0.1", "-o", "plate.msh"]):
            self.assertIn("it is an input", self.call(*words, code=1).stderr)
        # Triangle's files are side by side however they are named, and a .poly without nodes takes them from one.
        for words in (["plate.node", "-o", "plate.ELE"], ["plate.node", "-o", "plate", "--format", "triangle"]):
            self.assertIn("it is an input", self.call("mesh", *words, code=1).stderr)
        lines = self.read("plate.poly").splitlines()
        count = int(lines[0].split()[0])
        self.write("apart.node", "\n".join(lines[:count + 1]) + "\n")
        self.write("apart.poly", "0 2 0 0\n" + "\n".join(lines[count + 1:]) + "\n")
        self.call("mesh", "apart.poly", "-o", "apart.msh")
        self.assertIn("it is an input", self.call("mesh", "apart.poly", "-o", "apart.node", code=1).stderr)
        self.assertIn("two outputs to one file", self.call("mesh", "plate.poly", "-o", "z", "-o", "z.ele", "--format",
                                                           "triangle", "--format", "triangle", code=1).stderr)
        self.assertEqual(before, {name: self.read(name) for name in before})
        self.call("mesh", "plate.poly", "-o", "plate.node")

    def test_files_may_begin_with_a_byte_order_mark(self):
        (self.path / "marked.poly").write_bytes(b"\xef\xbb\xbf" + self.read("plate.poly").encode())
        self.assertEqual(self.stats("marked.poly")["hash"], self.stats("plate.poly")["hash"])

    def test_check_finds_what_is_wrong(self):
        self.call("mesh", "plate.poly", "-o", "plate.msh", "--size", "0.5")
        self.write("other.poly", poly([SQUARE]))
        done = self.call("check", "plate.msh", "--domain", "other.poly", code=1)
        self.assertRegex(done.stderr, r"at \([-0-9.e]+, [-0-9.e]+\)")
        self.write("moved.poly", poly([SQUARE[:2] + [(5.0, 3.0), (0.0, 3.0)]]))
        moved = self.call("check", "plate.msh", "--domain", "moved.poly", code=1).stderr.splitlines()
        self.assertTrue(any(line.startswith("moved.poly:8: error: an end of a segment of the domain with tag 1 is not a "
                                            "boundary node of the mesh at (5, 3): segment 2 (line 8) [missing-node]")
                            for line in moved), moved)
        text = self.read("plate.msh")
        triangles = list(re.finditer(r"^(\d+ 2 2 \d+ \d+) (\d+) (\d+) (\d+)$", text, re.M))
        self.assertTrue(triangles)
        t = triangles[len(triangles) // 2]
        self.write("turned.msh", text[:t.start()] + f"{t[1]} {t[3]} {t[2]} {t[4]}" + text[t.end():])
        self.assertIn("[inverted-element]", self.call("check", "turned.msh", code=1).stderr)
        for command in (["check", "turned.msh"], ["adapt", "turned.msh", "--expression", "x", "--error", "0.1",
                                                  "-o", "new.msh"]):
            for line in self.call(*command, code=1).stderr.splitlines():
                self.assertTrue(line.startswith("turned.msh: error: "), line)
        self.write("bow.poly", poly([BOW]))
        self.assertIn("expression", self.call("adapt", "plate.msh", "--domain", "bow.poly", "--expression", "1+*x",
                                              "--error", "0.1", "-o", "new.msh", code=2).stderr)

    def test_check_accepts_meshes_of_other_programs(self):
        nodes = "$Nodes\n6\n1 9 9 0\n11 0 0 0\n12 1 0 0\n13 1 1 0\n14 0 1 0\n20 8 8 0\n$EndNodes\n"
        head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + nodes
        elements = lambda *rows: "$Elements\n%d\n%s\n$EndElements\n" % (len(rows), "\n".join(rows))
        self.write("lone.msh", head + elements("7 2 2 1 1 11 12 13", "9 2 2 1 1 11 13 14"))
        done = self.call("check", "lone.msh")
        self.assertEqual(done.stderr.splitlines(), [
            "lone.msh: note: 2 nodes belong to no element, the first is node 1 at (9, 9) [unreferenced-node]"])
        self.assertIn("valid: 6 nodes, 2 elements, hash", done.stdout)
        self.assertIn("angles 45.0 to 90.0 degrees", done.stdout)
        # One that is turned the other way is said to be so, and nothing else; its figures are those of its shapes.
        self.write("clockwise.vtu", """<VTKFile type="UnstructuredGrid"><UnstructuredGrid>
            <Piece NumberOfPoints="4" NumberOfCells="2"><Points><DataArray type="Float64" NumberOfComponents="3">
            0 0 0 1 0 0 1 1 0 0 1 0</DataArray></Points><Cells>
            <DataArray type="Int32" Name="connectivity">0 2 1 0 3 2</DataArray>
            <DataArray type="Int32" Name="offsets">3 6</DataArray>
            <DataArray type="UInt8" Name="types">5 5</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>""")
        self.write("unit.poly", poly([[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]]))
        for words in ([], ["--domain", "unit.poly"]):
            done = self.call("check", "clockwise.vtu", *words)
            self.assertRegex(done.stderr, r"^clockwise.vtu: warning: the mesh is turned the other way: its 2 elements are "
                                          r"all clockwise; expected counter-clockwise \[clockwise\].*\n$")
            self.assertIn("area 1, 1 part, 0 holes", done.stdout)
            self.assertIn("angles 45.0 to 90.0 degrees", done.stdout)
        self.assertIn("[clockwise]", self.call("adapt", "clockwise.vtu", "--expression", "x*x", "--error", "0.3",
                                               "-o", "new.msh").stderr)
        # What is wrong is refused, with the numbers of the file and the figures.
        self.write("turned.msh", head + elements("7 2 2 1 1 11 12 13", "9 2 2 1 1 11 14 13"))
        done = self.call("check", "turned.msh", code=1)
        self.assertIn("element 9 is clockwise", done.stderr)
        self.assertIn("edge 11-13 has two elements on the same side", done.stderr)
        self.assertIn("invalid: 6 nodes, 2 elements, hash", done.stdout)
        self.assertIn("shape factor", done.stdout)
        done = self.call("check", "lone.msh", "--min-angle", "50", "--max-length", "1.2", code=1)
        self.assertIn("lone.msh: error: element 7: min", done.stderr)
        self.assertIn("lone.msh: error: edge 11-13: ", done.stderr)

    def test_check_accepts_a_mesh_with_few_tagged_edges_as_its_own_domain(self):
        self.call("mesh", "plate.poly", "-o", "plate.msh", "--size", "0.3")
        lines = self.read("plate.msh").splitlines()
        count = lines.index("$Elements") + 1
        tagged = [line for line in lines if re.fullmatch(r"\d+ 1 2 1 .*", line)]
        kept = [line for line in lines if line not in tagged[1:]]
        kept[count] = str(int(lines[count]) - len(tagged) + 1)
        self.write("few.msh", "\n".join(kept) + "\n")
        self.assertGreater(len(tagged), 4)
        self.call("check", "few.msh", "--domain", "few.msh")
        self.call("mesh", "few.msh", "-o", "again.msh", "--verify")
        self.call("check", "few.msh", "--domain", "plate.poly", code=1)  # there, all edges have tags

    def test_check_writes_statistics(self):
        # Sums of both are equal bit for bit if the file keeps the order of elements.
        given = self.stats("plate.poly", "-o", "plate.msh", "--size", "0.5", "--numbering", "creation")
        self.call("check", "plate.msh", "--stats", "check.json")
        checked = json.loads(self.read("check.json"))
        self.assertTrue(checked.pop("valid"))
        self.assertEqual(checked.pop("limits"), [])
        self.assertIsNone(checked["delta_mean"])  # no spacing is given
        self.assertIsNone(checked["delta_area_mean"])
        del checked["delta_mean"], checked["delta_area_mean"]
        run = {"front_mean", "neighbours_mean", "considered_mean", "tests_mean", "cells_mean", "candidates_mean", "forced_mean", "improve",
               "seconds_prepare", "seconds_mesh", "seconds_improve", "peak_bytes", "input"}
        self.assertEqual(set(given) - set(checked), run | {"delta_mean", "delta_area_mean"})
        self.assertEqual(checked, {key: given[key] for key in checked})
        for key in ("nodes", "regions", "boundaries", "alpha_min", "min_angle_deg", "hash"):
            self.assertIn(key, checked)
        self.assertEqual([(part["tag"], part["name"]) for part in checked["boundaries"]], [(1, "boundary_1"), (2, "boundary_2")])
        self.assertAlmostEqual(checked["boundaries"][0]["length"], 14.0)
        done = self.call("check", "plate.msh", "--stats", "-", "--min-angle", "59", code=1)
        printed = json.loads(done.stdout)
        self.assertTrue(printed["valid"])
        self.assertEqual(printed["limits"][0]["limit"], "min-angle")
        self.assertFalse(printed["limits"][0]["met"])
        self.assertIn("--measures", self.call("check", "plate.msh", "--stats", "-", "--measures", code=2).stderr)
        self.assertIn("error", self.call("check", "plate.msh", "--stats", "plate.msh", code=1).stderr)

    def test_statistics_of_other_elements_have_their_numbers_and_their_scaled_jacobian(self):
        self.write("mixed.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0.5 0\nf 1 2 3 4\nf 2 5 3\n")
        figures = json.loads(self.call("check", "mixed.obj", "--stats", "-").stdout)
        self.assertEqual(figures["elements_by_kind"], {"triangle3": 1, "quadrilateral4": 1})
        self.assertGreater(figures["scaled_jacobian_min"], 0.9)
        self.assertIn("\n1 triangle, 1 quadrilateral; scaled Jacobian: minimum 0.9", self.call("check", "mixed.obj").stdout)
        self.write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n")
        self.assertNotIn("elements_by_kind", json.loads(self.call("check", "triangle.obj", "--stats", "-").stdout))

    def test_check_judges_by_limits(self):
        self.call("mesh", "plate.poly", "-o", "plate.msh", "--size", "0.25")
        kept = self.call("check", "plate.msh", "--min-angle", "1", "--max-growth", "50", "--min-length", "0.01")
        self.assertEqual(kept.stderr, "")
        self.assertRegex(kept.stdout, r"\nminimum angle 1°: met, worst [\d.]+°\nmaximum growth 50: met, worst ")
        broken = self.call("check", "plate.msh", "--min-angle", "59.9", "--min-alpha", "0.1", code=1)
        self.assertRegex(broken.stdout, r"\nminimum angle 59.9°: violated by \d+ of \d+ elements, worst [\d.]+° at \(")
        self.assertIn("\nminimum α 0.1: met", broken.stdout)
        *places, advice = broken.stderr.splitlines()
        self.assertIn("--limit min-angle=59.9 --limit min-alpha=0.1 --fix", advice)
        self.assertEqual(len(places), 5)
        for place in places:
            self.assertRegex(place, r"^plate.msh: error: element \d+: min ∠ [\d.]+° violates the limit 59.9° at \(.*"
                                    r"\[min-angle\]$")
        worst, least = (float(re.search(pattern, broken.stdout).group(1))
                        for pattern in (r"worst ([\d.]+)°", r"angles ([\d.]+) to"))
        self.assertAlmostEqual(worst, least, delta=0.051)
        self.call("check", "plate.msh", "--min-delta", "0.01", "--size", "0.25")
        self.assertIn("--min-delta needs a spacing", self.call("check", "plate.msh", "--min-delta", "0.1", code=2).stderr)
        for option, value in (("--min-angle", "91"), ("--max-growth", "0.5"), ("--max-length", "0")):
            self.assertIn(f"{option}: expected a ", self.call("check", "plate.msh", option, value, code=2).stderr)

    def test_check_takes_the_limits_of_a_project(self):
        limits = PROJECT.replace('"version": 1,', '"version": 1, "limits": {"minAngle": 59.9, "maxValence": 20},')
        self.write("plate.json", limits)
        self.call("mesh", "plate.json", "-o", "plate.msh")
        done = self.call("check", "plate.msh", "--limits", "plate.json", code=1)
        self.assertIn("minimum angle 59.9°: violated", done.stdout)
        self.assertIn("maximum valence 20: met", done.stdout)
        done = self.call("check", "plate.msh", "--limits", "plate.json", "--min-angle", "5")
        self.assertIn("minimum angle 5°: met", done.stdout)
        self.write("delta.json", limits.replace('"minAngle": 59.9', '"minDelta": 0.01'))
        done = self.call("check", "plate.msh", "--limits", "delta.json")  # by the spacing of the project
        self.assertRegex(done.stdout, r"\nminimum δ 0.01: met, worst ")
        self.write("named.json", limits.replace('"version": 1,', '"version": 2, "parameters": {"r": "1"},'))
        self.write("outline.poly", poly([SQUARE]))
        for domain in ([], ["--domain", "outline.poly"]):  # the parameters are those of the project with the limits
            done = self.call("check", "plate.msh", "--limits", "named.json", "--min-angle", "5", "--set", "r=2", *domain)
            self.assertIn("minimum angle 5°: met", done.stdout)
        # Kept segments raise the size that their elements are judged by.
        self.write("kept.json", PROJECT.replace('"size": 0.3', '"size": 0.1').replace(
            '"version": 1,', '"version": 2, "options": {"keepBoundary": true}, "limits": {"minDelta": 0.1},'))
        self.call("mesh", "kept.json", "-o", "kept.msh")
        self.call("check", "kept.msh", "--limits", "kept.json")
        self.call("check", "kept.msh", "--size", "0.1", "--min-delta", "0.1", code=1)
        self.write("none.json", PROJECT)
        self.assertIn("[no-limits]", self.call("check", "plate.msh", "--limits", "none.json", code=1).stderr)

    def test_check_prints_the_distribution_of_measures(self):
        self.call("mesh", "plate.poly", "-o", "plate.msh", "--size", "0.25")
        lines = self.call("check", "plate.msh", "--measures").stdout.splitlines()
        head = next(i for i, line in enumerate(lines) if line.startswith("measure "))
        self.assertEqual(lines[head].split()[1:],
                         ["minimum", "1%", "5%", "25%", "50%", "75%", "95%", "99%", "maximum", "mean"])
        table = {line[:22].strip(): [float(v) for v in line[22:].split()] for line in lines[head + 1:]}
        self.assertEqual(list(table), ["Shape factor", "Scaled Jacobian", "Minimum angle", "Maximum angle", "Aspect ratio", "Area", "Area ratio",
                                       "Edge length", "Elements across", "Island area", "Valence"])
        for name, numbers in table.items():
            self.assertEqual(len(numbers), 10, name)
            self.assertEqual(sorted(numbers[:9]), numbers[:9], name)
        self.assertIn("Spacing conformity", self.call("check", "plate.msh", "--measures", "--size", "1").stdout)

    def test_check_reports_how_well_a_spacing_is_kept(self):
        def kept(*words):
            found = re.search(r"^spacing conformity: mean ([\d.]+) at edges, ([\d.]+) over the area$",
                              self.call("check", *words).stdout, re.M)
            return float(found[1]) if found else None

        made = self.stats("plate.poly", "-o", "plate.msh", "--spacing", "0.1+0.1*x")["delta_mean"]
        self.assertAlmostEqual(kept("plate.msh", "--spacing", "0.1+0.1*x"), made, delta=1e-4)
        self.assertLess(kept("plate.msh", "--spacing", "0.2+0.2*x"), made - 0.2)  # edges half as long as requested
        self.assertIsNone(kept("plate.msh"))
        # Two right triangles; of their five edges four are 1 long and the diagonal is the square root of 2.
        self.write("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n")
        self.assertAlmostEqual(kept("square.obj", "--size", "1"), (4 + 1 / math.sqrt(2)) / 5, delta=1e-4)
        # Over the area, the sizes inside the elements count. Limited to a change of 0.5 per unit of distance, they are
        # 0.0075 + distance/2 around the centre, and the mean distance to the centre of a unit square is known.
        mean_distance, element_size = (math.sqrt(2) + math.log(1 + math.sqrt(2))) / 6, math.sqrt(2 / math.sqrt(3))
        ignored = ["--spacing", "max(0.01, 2*dist(0.5, 0.5))", "--stats", "-"]
        figures = json.loads(self.call("check", "square.obj", *ignored).stdout)
        self.assertAlmostEqual(figures["delta_area_mean"], (0.0075 + mean_distance / 2) / element_size, delta=0.005)
        self.call("check", "plate.msh", "--size", "1", "--spacing", "x", code=2)
        self.call("check", "plate.msh", "--size", "-1", code=2)
        self.call("check", "plate.msh", "--spacing", "1+*x", code=2)

    def test_wrong_usage(self):
        mesh = ["mesh", "plate.poly", "-o", "a.msh"]
        for words in (["mesh"], ["mesh", "plate.poly"], ["mesh", "plate.poly", "-o", "a.unknown"],
                      [*mesh, "--format", "nonsense"], [*mesh, "--size", "-1"], [*mesh, "--size", "1", "--spacing", "x"],
                      [*mesh, "--grid", "hexagonal"], [*mesh, "--grid", "uniform:0x4"], [*mesh, "--grid", "uniform:4"],
                      [*mesh, "--threads", "0"], [*mesh, "--spacing", "1+*x"], [*mesh, "--no-such-option"], ["check"],
                      [*mesh, "--improve", "better"], [*mesh, "--improve", "best", "--no-improve"]):
            self.assertNotEqual(self.call(*words, code=2).stderr, "", words)
        self.assertEqual([p.name for p in self.path.iterdir()], ["plate.poly"])

    def test_invalid_numbers_are_reported_on_one_line(self):
        mesh, check = ["mesh", "plate.poly", "-o", "a.msh"], ["check", "plate.poly"]
        adapt = ["adapt", "plate.msh", "--expression", "x", "-o", "a.msh"]
        options = [(mesh, "--size", "a positive number"), (mesh, "--gradation", "a positive number"),
                   (mesh, "--threads", "a whole number from 1 to 256"), (check, "--size", "a positive number"),
                   (adapt, "--error", "a number from 1e-09 to 1"), (adapt, "--rounds", "a whole number from 1 to 100"),
                   (adapt, "--size-min", "a positive number"), (adapt, "--size-max", "a positive number"),
                   (adapt, "--gradation", "a positive number")]
        for command, option, expected in options:
            for value in ("abc", "0", "inf", "nan", "-1", "1e400", "", "1x", "0x10", "1,5", "+-1"):
                line, hint = self.call(*command, option, value, code=2).stderr.splitlines()
                self.assertEqual(line, f"forefront {command[0]}: {option}: expected {expected}, got '{value}'")
                self.assertIn("--help", hint)
        self.call(*mesh, "--size", "+.5e0")
        self.call(*mesh, "--threads", "+2")
        for octal in ("010", "08", "+002"):
            self.assertIn(f"got '{octal}'", self.call(*mesh, "--threads", octal, code=2).stderr)

    def test_options_that_exclude_each_other_are_named(self):
        both = self.call("mesh", "plate.poly", "-o", "a.msh", "--size", "1", "--spacing", "x", code=2).stderr
        self.assertEqual(both.splitlines()[0], "forefront mesh: only one of --size, --spacing, --size-preset, --spacing-file, "
                         "--size-from-boundary can be given, got --size, --spacing")
        neither = self.call("adapt", "plate.msh", "--error", "0.1", "-o", "a.msh", code=2).stderr
        self.assertEqual(neither.splitlines()[0],
                         "forefront adapt: missing option; add one of --field, --expression")
        self.assertEqual(self.call("mesh", "plate.poly", "-o", "a.msh", "--size", code=2).stderr.splitlines()[0],
                         "forefront mesh: --size: missing value")

    def test_a_full_device_is_given_as_the_reason(self):
        for words in (["-o", "-", "--format", "vtu", "-q"], ["-o", "/dev/full", "--format", "vtu", "-q"],
                      ["--stats", "-"]):
            with open("/dev/full", "w") as full:
                done = subprocess.run([PROGRAM, "mesh", "plate.poly", *words], cwd=self.path, stdout=full,
                                      stderr=subprocess.PIPE, text=True, timeout=300)
            self.assertEqual(done.returncode, 1)
            self.assertIn(os.strerror(errno.ENOSPC), done.stderr)

    def test_an_unknown_command_is_named(self):
        errors = self.call("mash", "plate.poly", code=2).stderr
        self.assertIn("unknown command or file 'mash'", errors)
        self.assertIn("did you mean mesh?", errors)
        self.assertNotIn("did you mean", self.call("quadrilate", code=2).stderr)

    def test_a_mistyped_option_gets_a_suggestion(self):
        for wrong, meant in (("--sise", "--size"), ("--improv", "--improve"), ("--spcaing", "--spacing")):
            errors = self.call("mesh", "plate.poly", "-o", "a.msh", f"{wrong}=1", code=2).stderr
            self.assertIn(f"did you mean {meant}?", errors)
        self.assertNotIn("did you mean", self.call("mesh", "plate.poly", "--zzzzzz", code=2).stderr)

    def test_unknown_options_are_listed_in_the_order_given(self):
        errors = self.call("mesh", "plate.poly", "-o", "a.msh", "--first", "--second", "third", code=2).stderr
        self.assertEqual(errors.splitlines()[0], "forefront mesh: unknown option '--first', '--second'")
        errors = self.call("check", "plate.poly", "one", "two", code=2).stderr
        self.assertEqual(errors.splitlines()[0], "forefront check: unexpected argument 'one', 'two'")

    def test_an_unknown_extension_of_an_output_is_refused_with_the_known_ones(self):
        for words in (["mesh", "plate.poly", "-o", "pic.abc"],
                      ["adapt", "plate.poly", "--expression", "x", "--error", "0.1", "-o", "pic.abc"]):
            line = self.call(*words, code=2).stderr.splitlines()[0]
            self.assertEqual(line, f"forefront {words[0]}: -o pic.abc: unknown extension '.abc'; expected one of .svg, "
                             ".dxf, .msh, .vtu, .vtk, .xdmf, .mesh, .inp, .su2, .unv, .bdf, .foam, .2dm, .14, .gr3, .slf, .nc, .tsh, "
                             ".node, .obj, .ply, .stl, .off")
        self.assertEqual([p.name for p in self.path.iterdir()], ["plate.poly"])

    def test_help_and_version(self):
        self.assertRegex(self.call("--version").stdout, r"^forefront \d+\.\d+\.\d+\n$")
        for words in (["--help"], ["mesh", "--help"], ["check", "--help"]):
            self.assertIn("Examples:", self.call(*words).stdout)
        self.assertIn("4 no window", self.call("--help").stdout)
        meshes = ".msh, .vtu, .vtk, .xdmf, .xmf, .mesh, .inp, .su2, .unv, .bdf, .nas, .2dm, .14, .gr3, .node, .ele, .vol, .obj"
        for command in ("check", "convert", "adapt"):
            self.assertIn("mesh file: " + meshes, " ".join(self.call(command, "--help").stdout.split()))
        text = " ".join(self.call("mesh", "--help").stdout.split())
        self.assertIn("project (.json, .forefront) or domain (.geojson, .json, .topojson, .wkt, .shp, .gpkg, .kml, "
                      ".fgb, .poly, .fem, .fee, .feh, .fec, .csv, .xy, .dat, .svg, .dxf, " + meshes, text)
        self.assertIn("a background mesh (.msh), a grid of sizes (.asc, .tif, .tiff) or a picture (.png)", text)


class Films(Case):
    def frames(self, name):
        """Returns the sizes of the frames of a GIF and the delay of the first, by walking over its blocks."""
        data = (self.path / name).read_bytes()
        self.assertEqual(data[:6], b"GIF89a")
        at, sizes, delays = 13 + 3 * 256, [], []
        while data[at] != 0x3B:
            if data[at] == 0x21:
                if data[at + 1] == 0xF9:
                    delays.append(int.from_bytes(data[at + 4:at + 6], "little"))
                at += 2
            else:
                self.assertEqual(data[at], 0x2C)
                sizes.append((int.from_bytes(data[at + 5:at + 7], "little"), int.from_bytes(data[at + 7:at + 9], "little")))
                at += 11
            while data[at]:
                at += data[at] + 1
            at += 1
        return sizes, delays[0]

    def test_a_gif_has_a_frame_for_each_step(self):
        done = self.call("film", "plate.poly", "-o", "run.gif", "--method", "classic", "--size", "1", "--steps", "5", "--speed",
                         "5", "--width", "200")
        self.assertIn("wrote run.gif: 6 frames", done.stdout)
        sizes, delay = self.frames("run.gif")
        self.assertEqual(len(sizes), 6)
        self.assertEqual(sizes[0], (200, 276))
        self.assertTrue(all(width * height < 200 * 276 for width, height in sizes[1:])) # only what changed
        self.assertEqual((self.path / "run.gif").stat().st_mode, (self.path / "plate.poly").stat().st_mode)
        self.assertEqual(delay, 20)

    def test_drawings_follow_the_run(self):
        self.call("film", "plate.poly", "-o", "f-%d.svg", "--method", "classic", "--size", "1", "--frames", "4")
        drawings = [self.read(f"f-{k}.svg") for k in range(1, 5)]
        self.assertFalse((self.path / "f-5.svg").exists())
        triangles = [drawing.count("Z\n") for drawing in drawings]
        self.assertEqual(triangles[0], 0)
        self.assertEqual(triangles, sorted(triangles))
        self.assertEqual(triangles[-1], self.stats("plate.poly", "-o", "p.msh", "--method", "classic", "--size", "1")["elements"])
        self.assertIn("Advance 0, ", drawings[0])

    def test_a_film_goes_on_through_the_improvement(self):
        film = ["film", "plate.poly", "--method", "classic", "--size", "1"]
        self.call(*film, "-o", "f-%d.svg", "--frames", "20")
        said = [" ".join(re.findall(r">([^<]+)</text>", self.read(f"f-{k}.svg"))) for k in range(1, 21)]
        steps = [text for text in said if text.startswith("Improvement ")]
        front = [text for text in said if text.startswith("Advance ")]
        self.assertEqual(said, front + steps)
        self.assertGreaterEqual(len(steps), 4)  # a quarter, without the first frame
        total = int(re.match(r"Improvement (\d+) of \1: ", said[-1])[1])
        advances = int(re.match(r"Advance (\d+), 0 segments", front[-1])[1])
        self.assertGreaterEqual(total, len(steps))
        self.call(*film, "-o", "m.svg", "--at", str(advances + 1))
        self.assertIn(f">Improvement 1 of {total}: ", self.read("m.svg"))
        self.assertIn("#1b9e77", self.read("m.svg"))
        self.call(*film, "-o", "m.svg", "--at", str(advances + 1), "--layers", "mesh,caption")
        self.assertNotIn("#1b9e77", self.read("m.svg"))
        self.call(*film, "-o", "m.svg", "--at", str(advances))
        self.assertIn(f">Advance {advances}, 0 segments", self.read("m.svg"))
        events = self.call(*film, "-o", "e-%d.svg", "--from", str(advances), "--events").stdout
        self.assertIn(f": {total + 1} frames", events)
        beyond = self.call(*film, "-o", "m.svg", "--at", str(advances + total + 1), code=1).stderr
        self.assertIn(f"only {advances} advances and {total} steps of the improvement", beyond)
        note = self.call(*film, "-o", "run.gif", "--width", "100", "--frames", "3", "--steps", "1000").stderr
        self.assertIn(f"ends at advance {advances} and {total} steps of the improvement, before --steps 1000", note)

    def test_tall_domains_get_room_beside_them(self):
        self.write("tall.poly", poly([[(0.0, 0.0), (1.0, 0.0), (1.0, 1000.0), (0.0, 1000.0)]]))
        self.call("film", "tall.poly", "-o", "tall.gif", "--size", "20", "--steps", "1", "--width", "200")
        sizes, _ = self.frames("tall.gif")
        self.assertEqual({width for width, height in sizes}, {200})
        self.assertLess(max(height for width, height in sizes), 450)

    def test_the_labels_of_a_moment_are_where_the_trace_says(self):
        run = ["plate.poly", "--method", "classic", "--size", "1"]
        self.call("trace", *run, "-o", "run.json", "--steps", "3")
        advance = json.loads(self.read("run.json"))["advances"][2]
        self.call("film", *run, "-o", "moment.svg", "--at", "3", "--labels")
        for name, place in ("A", advance["base"]["a"]), ("B", advance["base"]["b"]), ("C", advance["c"]):
            found = re.findall(rf'data-x="([^"]*)" data-y="([^"]*)">{name}</text>', self.read("moment.svg"))
            self.assertEqual([[float(x), float(y)] for x, y in found], [place])
        self.call("film", *run, "-o", "moment.pdf", "--at", "3", "--labels")
        self.assertTrue((self.path / "moment.pdf").read_bytes().startswith(b"%PDF-1.4"))
        self.assertIn("no labels", self.call("film", *run, "-o", "start.svg", "--at", "0", "--labels").stderr)
        self.assertIn("only to a single picture", self.call("film", *run, "-o", "a.gif", "--at", "3", code=2).stderr)
        self.call("film", *run, "-o", "a.svg", "--at", "3", "--from", "2", code=2)

    def test_a_film_zooms_follows_and_steps_by_events(self):
        film = ["film", "plate.poly", "--method", "classic", "--size", "1"]
        self.call(*film, "-o", "whole.svg", "--at", "9")
        self.call(*film, "-o", "part.svg", "--at", "9", "--view", "0,0,2,2")
        self.call(*film, "-o", "near.svg", "--at", "9", "--follow", "--labels")
        counts = {name: (self.path / f"{name}.svg").read_text().count("Z\n") for name in ("whole", "part", "near")}
        self.assertGreater(counts["whole"], counts["part"])
        self.assertGreater(counts["whole"], counts["near"])
        self.assertIn(">A</text>", (self.path / "near.svg").read_text())
        events = self.call(*film, "-o", "e-%d.svg", "--from", "8", "--steps", "1", "--events", "--labels").stdout
        frames = int(re.search(r": (\d+) frames", events)[1])
        self.assertGreater(frames, 5)
        texts = [(self.path / f"e-{k}.svg").read_text() for k in range(1, frames + 1)]
        self.assertIn("Advance 8,", texts[0])
        self.assertIn("Advance 9,", texts[-1])
        self.assertGreater(len(set(texts)), frames / 2)  # an event that only looks into cells leaves the picture as it is
        gif = self.call(*film, "-o", "e.gif", "--steps", "3", "--events", "--follow", "--width", "200").stdout
        self.assertGreater(int(re.search(r": (\d+) frames", gif)[1]), 15)
        self.assertIn("expected the lower left", self.call(*film, "-o", "a.svg", "--view", "3,0,2,2", code=2).stderr)
        self.call(*film, "-o", "a.svg", "--at", "3", "--events", code=2)
        self.call(*film, "-o", "a.html", "--follow", code=2)

    def test_a_video_goes_through_the_encoder(self):
        film = ["film", "plate.poly", "--method", "classic", "--size", "1", "--steps", "3", "--width", "201"]
        tools = self.path / "tools"
        tools.mkdir()
        with mock.patch.dict(os.environ, PATH=str(tools)):
            missing = self.call(*film, "-o", "run.mp4", code=1).stderr
            self.assertIn("no-encoder", missing)
            self.assertIn("install the package ffmpeg", missing)
            encoder = tools / "ffmpeg"  # keeps what it is given: its words, and the raw frames as its output
            encoder.write_text('#!/bin/sh\nfor last; do :; done\necho "$*" > words\n/bin/cat > "${last#file:}"\n')
            encoder.chmod(0o755)
            self.call(*film, "-o", "run.mp4", "--speed", "5")
            words = self.read("words")
            width, height = map(int, re.search(r"-video_size (\d+)x(\d+)", words).groups())
            self.assertEqual(width, 201)
            self.assertIn("-framerate 5 ", words)
            self.assertEqual((self.path / "run.mp4").stat().st_size, 4 * 3 * width * height)
            encoder.write_text('#!/bin/sh\necho "no room for frames" >&2\nexit 1\n')
            self.assertIn("no room for frames", self.call(*film, "-o", "other.webm", code=1).stderr)
        self.assertFalse(list(self.path.glob("other*")))
        self.assertFalse(list(self.path.glob("*.part")))

    def test_a_film_that_is_shorter_than_asked_for_says_so(self):
        film = ["film", "plate.poly", "-o", "run.gif", "--size", "1", "--width", "100"]
        self.assertIn("before --steps 1000000 are shown", self.call(*film, "--steps", "1000000").stderr)
        self.assertEqual(self.call(*film, "--steps", "3").stderr, "")
        self.assertIn("no background grid to show",
                      self.call(*film, "--grid", "none", "--layers", "mesh,grid", code=2).stderr)
        self.call(*film, "--grid", "hierarchical", "--layers", "mesh,grid")

    def test_a_moment_shows_the_layers_asked_for(self):
        words = ("film", "plate.poly", "-o", "m.svg", "--method", "classic", "--size", "1", "--from", "3", "--steps", "1")
        self.call(*words, "--layers", "mesh,caption")
        self.assertIn(">Advance 4, ", self.read("m.svg"))
        self.assertNotIn("#d95f02\" stroke-width", self.read("m.svg"))
        self.call(*words, "--layers", "front")
        self.assertIn("#d95f02\" stroke-width", self.read("m.svg"))
        self.assertNotIn("<text", self.read("m.svg"))

    def test_wrong_usage_is_refused(self):
        for words, part in ((("-o", "run.avi"), "expected .gif, .mp4, .webm, .html, .png, .svg or .pdf"), (("-o", "f-%d.gif"), "leave out %d"),
                            (("-o", "m.svg", "--layers", "sky"), "sky"), (("-o", "m.svg", "--frames", "0"), "--frames"),
                            (("-o", "m.svg", "--frames", "3"), "one frame"), (("-o", "m.svg", "--from", "3"), "--steps"),
                            (("-o", "m-%d.png", "--speed", "3"), "only to an animation")):
            self.assertIn(part, self.call("film", "plate.poly", *words, code=2).stderr)
        self.assertIn("bad-range", self.call("film", "plate.poly", "-o", "m.gif", "--size", "1", "--from", "99999", code=1).stderr)
        self.assertIn("cannot-write", self.call("film", "plate.poly", "-o", "gone/m.svg", "--size", "1", code=1).stderr)
        self.write("bow.poly", poly([BOW]))
        self.assertIn("cross", self.call("film", "bow.poly", "-o", "m.svg", code=1).stderr)


class Tables(Case):
    def test_rows_are_run_and_written(self):
        done = self.call("tables", "--rows", "1a,2A", "--grids", "60x40,hierarchical", "--csv", "t.csv", "--svg",
                         "t.svg")
        self.assertEqual(done.stderr, "")
        for words in ("30384", "44937", "Growth of the cost", "alpha higher by 0.03 or more", "\nNotes\n"):
            self.assertIn(words, done.stdout)
        head, *lines = [line.split(",") for line in self.read("t.csv").splitlines()]
        rows = [dict(zip(head, line)) for line in lines]
        self.assertEqual([(r["row"], r["grid"], r["source"]) for r in rows],
                         [("1A", "60x40", "Lo"), ("1A", "60x40", "ours"), ("1A", "hierarchical", "ours"),
                          ("2A", "60x40", "Lo"), ("2A", "60x40", "ours"), ("2A", "hierarchical", "ours")])
        for published, uniform, hierarchical in (rows[:3], rows[3:]):
            self.assertEqual(uniform["hash"], hierarchical["hash"])
            self.assertEqual(uniform["Ne"], hierarchical["Ne"])
            self.assertGreater(float(uniform["alpha"]), float(published["alpha"]) + 0.03)
            self.assertGreater(float(uniform["delta"]), float(published["delta"]))
            self.assertLess(float(uniform["Ns"]), float(published["Ns"]))
            self.assertLess(float(hierarchical["Nc"]), float(uniform["Nc"]))
        self.assertIn("hierarchical", self.read("t.svg"))

    def test_wrong_rows_and_grids_are_refused(self):
        self.assertIn("3* or 4*", self.call("tables", "--rows", "9Z", code=2).stderr)
        for words in (["--rows", "9Z"], ["--grids", "hexagonal"], ["--grids", "none,none"], ["--rows"]):
            self.assertNotEqual(self.call("tables", *words, code=2).stderr, "", words)
        self.assertIn("Examples:", self.call("tables", "--help").stdout)

    def test_interrupt_cancels(self):
        process = subprocess.Popen([PROGRAM, "tables", "--rows", "2E", "--grids", "none"], cwd=self.path,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        time.sleep(1.0)
        self.assertIsNone(process.poll(), "finished before it could be cancelled")
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 3)


class SlowTables(Case):
    def test_adaptive_rows_are_marked_as_our_own(self):
        done = self.call("tables", "--rows", "3*,4", "--grids", "60x40,hierarchical", "--csv", "t.csv")
        self.assertEqual(done.stderr, "")
        for words in ("132424", "311282", "\n3* ", "\n4* ", "domain and field are our own", "\nNotes\n"):
            self.assertIn(words, done.stdout)
        head, *lines = [line.split(",") for line in self.read("t.csv").splitlines()]
        rows = [dict(zip(head, line)) for line in lines]
        self.assertEqual([(r["row"], r["grid"], r["source"]) for r in rows],
                         [(row, grid, source) for row in "34" for grid, source in
                          (("60x40", "Lo"), ("60x40", "own case"), ("hierarchical", "own case"))])
        for published, uniform, hierarchical in (rows[:3], rows[3:]):
            self.assertEqual(uniform["hash"], hierarchical["hash"])
            boundary = 2 * int(uniform["Nn"]) - int(uniform["Ne"]) - 2 + (2 if uniform["row"] == "4" else 0)
            expected = 2 * int(published["Nn"]) - int(published["Ne"]) - 2
            self.assertLess(abs(boundary - expected), 0.03 * expected)
            self.assertLess(abs(int(uniform["Ne"]) - int(published["Ne"])), 0.05 * int(published["Ne"]))


class Adapting(Case):
    FORMULA = "atan(20*(hypot(x-2,y-1.5)-1.2))"

    def test_an_expression_is_met_and_the_domain_kept(self):
        self.call("mesh", "plate.poly", "-o", "plate.msh", "--size", "0.4")
        done = self.call("adapt", "plate.msh", "--expression", self.FORMULA, "--error", "0.1", "-o", "new.vtu",
                         "--size-max", "0.5")
        self.assertEqual(done.stderr, "")
        errors = [float(word) for word in re.findall(r"estimated error ([0-9.]+)", done.stdout)]
        self.assertGreater(errors[0], 0.1)
        self.assertLessEqual(errors[-1], 0.1)
        self.call("check", "new.vtu", "--domain", "plate.poly")

    def test_interrupt_cancels_within_a_round(self):
        self.call("mesh", "plate.poly", "-o", "plate.msh", "--size", "0.01", "-q")
        process = subprocess.Popen([PROGRAM, "adapt", "plate.msh", "--expression", self.FORMULA, "--error", "0.0005",
                                    "-o", "new.msh"], cwd=self.path, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True)
        time.sleep(0.7)
        self.assertIsNone(process.poll(), "finished before it could be cancelled")
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
        self.assertEqual((process.returncode, errors), (3, "cancelled\n"))
        self.assertFalse((self.path / "new.msh").exists())

    def test_a_field_of_a_file_gives_one_finer_mesh(self):
        self.call("mesh", "plate.poly", "-o", "plate.vtk", "--size", "0.3")
        text = self.read("plate.vtk")
        count = int(re.search(r"^POINTS (\d+)", text, re.M)[1])
        numbers = text.split("POINTS")[1].split()[2:2 + 3 * count]
        places = [(float(numbers[3 * i]), float(numbers[3 * i + 1])) for i in range(count)]
        values = [math.atan(10 * (math.hypot(x - 2, y - 1.5) - 1.2)) for x, y in places]
        self.write("solved.vtk", text + f"POINT_DATA {count}\nSCALARS heat double 1\nLOOKUP_TABLE default\n" +
                   "\n".join(map(repr, values)) + "\n")
        done = self.call("adapt", "solved.vtk", "--field", "heat", "--error", "0.1", "-o", "new.msh")
        self.assertIn("solve on the new mesh", done.stdout)
        elements = [int(word) for word in re.findall(r"(\d+) elements", done.stdout)]
        self.assertEqual(len(elements), 2)
        self.assertGreater(elements[1], elements[0])
        self.call("check", "new.msh", "--domain", "plate.poly")
        self.assertIn("'heat'", self.call("adapt", "solved.vtk", "--field", "cold", "--error", "0.1", "-o", "new.msh",
                                          code=1).stderr)

    def test_wrong_usage_is_refused(self):
        self.call("mesh", "plate.poly", "-o", "plate.msh")
        adapt = ["adapt", "plate.msh", "-o", "new.msh", "--error", "0.1"]
        for words in (adapt, [*adapt, "--expression", "x", "--field", "u"], [*adapt[:4], "--expression", "x"],
                      [*adapt, "--expression", "1+*x"], [*adapt, "--expression", "x", "-o", "new.unknown"]):
            self.assertNotEqual(self.call(*words, code=2).stderr, "", words)
        self.call("adapt", "missing.msh", "--expression", "x", "--error", "0.1", "-o", "new.msh", code=1)
        self.assertIn("Examples:", self.call("adapt", "--help").stdout)


class Scripts(Case):
    PLATE = """{"command": "parameter", "name": "r", "expression": "0.5"}
{"command": "add", "shapes": [{"kind": "rectangle", "nodes": [[0, 0], [4, 2]]}]}
{"command": "add", "shapes": [{"kind": "circle", "tag": 2, "nodes": [[2, 1], [2.4, 1]]}]}
{"command": "constrain", "kind": "radius", "parts": ["shape/2/segment/0"], "value": "r"}
{"command": "name", "boundary": 2, "name": "hole"}
{"command": "size", "size": 0.25}
{"command": "move", "shapes": [2], "by": [0.5, 0]}
{"command": "mesh"}
{"command": "check"}
{"command": "export", "file": "plate.msh"}
{"command": "save", "file": "plate.json"}
"""

    def run_script(self, *commands, code=0, words=()):
        self.write("script.jsonl", "\n".join(commands) + "\n")
        return self.call("run", "script.jsonl", *words, code=code)

    def test_a_plate_with_a_hole_is_drawn_meshed_checked_and_written(self):
        printed = self.run_script(self.PLATE).stdout
        self.assertIn("line 9: the mesh fits its domain", printed)
        hash = re.search(r"line 8: mesh of \d+ elements and \d+ nodes, hash (\w+)", printed)[1]
        stats = self.stats("plate.json", "-o", "again.msh")
        self.assertEqual(stats["hash"], hash)
        self.assertAlmostEqual(stats["area"], 8 - math.pi / 4, delta=0.03)
        self.assertEqual(self.read("again.msh"), self.read("plate.msh"))
        self.assertIn("valid for the domain", self.call("check", "plate.msh", "--domain", "plate.json").stdout)
        project = json.loads(self.read("plate.json"))
        self.assertEqual(project["boundaryNames"], {"2": "hole"})
        wider = self.PLATE.replace('"0.5"', '"0.75"').replace("plate.", "wide.")
        self.assertNotIn(hash, self.run_script(wider).stdout)
        self.assertLess(self.stats("wide.json", "-o", "again.msh")["area"], stats["area"] - 0.5)
        same = self.PLATE.replace('"mesh"', f'"mesh", "hash": "{hash}"')
        self.assertIn(hash, self.run_script(same).stdout)
        other = same.replace('"size": 0.25', '"size": 0.5')
        self.assertIn("script.jsonl:8:1: error: mesh: the mesh has the hash", self.run_script(other, code=1).stderr)

    def test_paths_are_relative_to_the_script(self):
        (self.path / "inner").mkdir()
        self.write("inner/a.jsonl", '{"command": "open", "file": "../plate.poly"}\n{"command": "mesh"}\n'
                                    '{"command": "export", "file": "a.vtu"}\n')
        self.call("run", "inner/a.jsonl")
        self.assertTrue((self.path / "inner" / "a.vtu").exists())

    def test_standard_input_and_quiet(self):
        done = subprocess.run([PROGRAM, "run", "-", "-q"], cwd=self.path, capture_output=True, text=True, timeout=300,
                              input=self.PLATE)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        self.assertTrue((self.path / "plate.msh").exists())

    def test_faults_have_their_place(self):
        mesh = '{"command": "mesh"}'
        for commands, expected in ((["nonsense"], "script.jsonl:1:1: error: "),
                                   ([""], "expected a value, found the end of the file"),
                                   (['{"command": "new"}', '{"command": "mesh", "hsah": 1}'],
                                    "script.jsonl:2:21: error: unknown member 'hsah'"),
                                   (['{"command": "check"}'], "script.jsonl:1:1: error: check: the document has no mesh"),
                                   ([mesh], "script.jsonl:1:1: error: mesh: "),
                                   (['{"command": "export"}'], "script.jsonl:1:1: error: "),
                                   (['{"command": "save", "file": "-"}'], "expected the name of a file"),
                                   (['{"command": "save", "file": "script.jsonl"}'], "it is an input"),
                                   (['{"command": "open", "file": "plate.poly"}', mesh,
                                     '{"command": "export", "file": "a.unknown"}'], "script.jsonl:3:1: error: export: ")):
            self.assertIn(expected, self.run_script(*commands, code=1).stderr, commands)
        self.call("run", code=2)
        self.call("run", "missing.jsonl", code=1)

    def test_faults_of_another_file_keep_their_place(self):
        self.write("bad.json", PROJECT.replace('"polygon"', '"polyhedron"'))
        for file, place in (("bad.json", "bad.json:1:"), ("missing.json", "missing.json: error: ")):
            lines = self.run_script('{"command": "new"}', f'{{"command": "open", "file": "{file}"}}',
                                    code=1).stderr.splitlines()
            self.assertTrue(lines[0].startswith(place), lines)
            self.assertEqual(lines[-1], "script.jsonl:2:1: note: the command open failed [failed-command]")

    def test_notes_and_warnings_are_printed(self):
        self.write("kind.json", PROJECT.replace('"version": 1', '"version": 1, "colour": "red"'))
        opened = '{"command": "open", "file": "kind.json"}'
        self.assertIn("kind.json:1:39: note: unknown member 'colour' is ignored", self.run_script(opened).stderr)
        self.assertEqual(self.run_script(opened, words=["-q"]).stderr, "")
        limited = '{"command": "change", "members": {"limits": {"minAngle": 59}}}'
        refused = self.run_script(opened, limited, '{"command": "mesh"}', '{"command": "check"}', code=1).stderr
        self.assertIn("script.jsonl:4:1: error: check: minimum angle 59°: violated", refused)


    def test_a_map_is_projected_and_exported_with_open_parts_and_elevations(self):
        self.write("coast.geojson", json.dumps(Meshing.COAST))
        opened = '{"command": "open", "file": "coast.geojson", "projection": "local"}'
        name = '{"command": "name", "segments": ["shape/1/segment/0", "shape/1/segment/5"], "name": "sea"}'
        export = '{"command": "export", "file": "%s", "open": ["sea"], "elevation": "-5-x/100000"}'
        self.run_script(opened, name, '{"command": "mesh"}', export % "a.14",
                        '{"command": "export", "file": "a.nc", "elevation": "-5"}')
        told = json.loads(self.call("info", "a.14", "--json").stdout)
        self.assertEqual({part["name"] for part in told["boundaries"]}, {"open_1", "land"})
        self.assertEqual(told["node_values"], ["elevation"])
        self.assertGreater(told["bounds"][2], 10000)  # metres
        self.assertIn(b"azimuthal_equidistant", (self.path / "a.nc").read_bytes())
        for command, message in (('{"command": "open", "file": "coast.geojson", "projection": "UTM"}', "expected local or a code"),
                                 ('{"command": "open", "file": "plate.poly", "projection": "local"}', "--projection: only"),
                                 ('{"command": "open", "file": "coast.geojson", "layers": "a"}', "expected file, projection, layer")):
            self.assertIn(message, self.run_script(command, code=1).stderr)
        self.assertIn("unknown boundary part 'see'",
                      self.run_script(opened, '{"command": "mesh"}', export.replace("sea", "see") % "b.14", code=1).stderr)


class Telling(Case):
    def info(self, *arguments):
        return json.loads(self.call("info", *arguments, "--json").stdout)

    def test_info_tells_what_a_mesh_holds(self):
        self.call("mesh", "plate.poly", "-o", "plate.msh", "--size", "0.5")
        told = self.info("plate.msh")
        self.assertEqual((told["kind"], told["format"], told["valid"]), ("mesh", "msh2", True))
        self.assertEqual(told["bounds"], [0, 0, 4, 3])
        self.assertAlmostEqual(told["area"], 11.0)
        self.assertEqual((told["parts"], told["holes"]), (1, 1))
        self.assertEqual([(part["name"], round(part["length"], 9)) for part in told["boundaries"]],
                         [("boundary_1", 14.0), ("boundary_2", 4.0)])
        checked = self.call("check", "plate.msh").stdout
        self.assertIn(told["hash"], checked)
        text = self.call("info", "plate.msh").stdout
        self.assertIn(f"elements: {told['elements']}\n", text)
        self.assertIn("boundary_2: ", text)
        groups = "0 SECTION 2 ENTITIES 0 CIRCLE 8 A 10 5 20 1 40 0.7 0 ENDSEC 0 EOF"
        (self.path / "disc.dxf").write_text(groups.replace(" ", "\n") + "\n")
        for found, expected in zip(self.info("disc.dxf")["bounds"], (4.3, 0.3, 5.7, 1.7)):  # of the curve, not its chords
            self.assertAlmostEqual(found, expected, 12)

    def test_info_tells_what_domains_and_projects_hold(self):
        told = self.info("plate.poly")
        self.assertEqual((told["kind"], told["segments"], told["hole_markers"]), ("domain", 8, 1))
        self.assertEqual([part["length"] for part in told["boundaries"]], [14.0, 4.0])
        bracket = pathlib.Path(__file__).parents[2] / "assets" / "samples" / "bracket.json"
        told = self.info(bracket)
        self.assertEqual(told["format"], "project")
        self.assertGreater(told["parameters"]["r"]["value"], 0)
        self.assertIn("parameters:\n", self.call("info", bracket).stdout)

    def test_the_unit_of_a_drawing_goes_from_file_to_file(self):
        self.call("mesh", "plate.poly", "-o", "plate.dxf", "-o", "plate.svg", "-o", "plate.inp", "--unit", "cm")
        self.assertIn("$INSUNITS\n70\n5\n", self.read("plate.dxf"))
        self.assertIn("** Unit of the coordinates: cm\n", self.read("plate.inp"))
        self.assertRegex(self.read("plate.svg"), r' width="40\.8mm" ')
        self.assertEqual(self.info("plate.dxf")["unit"], "cm")
        self.assertIn("unit: cm\n", self.call("info", "plate.dxf").stdout)
        self.call("mesh", "plate.dxf", "-o", "again.msh", "--size", "1")
        self.assertTrue(self.read("again.msh").endswith("Unit of the coordinates: cm\n$EndComments\n"))
        self.call("convert", "again.msh", "-o", "feet.inp", "--unit", "ft")
        self.assertIn("coordinates: ft\n", self.read("feet.inp"))
        adapt = ["adapt", "again.msh", "--expression", "x*x", "--error", "0.5", "-o", "adapted.inp"]
        self.call(*adapt, "--domain", "plate.dxf")
        self.assertIn("coordinates: cm\n", self.read("adapted.inp"))
        self.call(*adapt, "--unit", "m")
        self.assertIn("coordinates: m\n", self.read("adapted.inp"))
        self.call(*adapt)
        self.assertNotIn("Unit of", self.read("adapted.inp"))
        self.assertIn("no output names a unit", self.call(*adapt[:-1], "a.vtu", "--unit", "m", code=2).stderr)
        self.assertNotIn("unit", self.info("plate.poly"))
        self.assertIn("no output names a unit", self.call("mesh", "plate.poly", "-o", "a.vtu", "--unit", "m", code=2).stderr)
        self.assertIn("--unit", self.call("mesh", "plate.poly", "-o", "a.dxf", "--unit", "ell", code=2).stderr)

    def test_samples_are_driven_by_their_parameters(self):
        samples = pathlib.Path(__file__).parents[2] / "assets" / "samples"
        for name, settings, span in (("cylinder", ["L=30", "H=6", "D=1.5"], (30.0, 6.0)),
                                     ("joint", ["W=200", "h=80", "t=15", "gap=14"], (200.0, 80.0)),
                                     ("gear", ["bore=30", "ring=25", "hole=5"], None)):
            options = [word for setting in settings for word in ("--set", setting)]
            self.call("mesh", samples / f"{name}.json", "-o", f"{name}.msh", *options)
            told = self.info(f"{name}.msh")
            self.assertTrue(told["valid"])
            if span:
                left, bottom, right, top = told["bounds"]
                self.assertAlmostEqual(right - left, span[0])
                self.assertAlmostEqual(top - bottom, span[1])
        bore = next(part for part in self.info("gear.msh")["boundaries"] if part["name"] == "bore")
        self.assertAlmostEqual(bore["length"], math.pi * 30, delta=0.2)
        refused = self.call("mesh", samples / "joint.json", "-o", "none.msh", "--set", "t=20", "--set", "h=80", code=1)
        self.assertIn("would have no length", refused.stderr)

    def test_sizes_follow_rasters_and_the_distance_to_the_shore(self):
        bay = pathlib.Path(__file__).parents[2] / "assets" / "samples" / "bay.json"
        self.call("mesh", bay, "-o", "bay.msh")
        told = self.info("bay.msh")
        self.assertTrue(told["valid"])
        self.assertEqual({part["name"] for part in told["boundaries"]}, {"coast", "open sea", "island"})
        # A square of 20 x 20 over a bed that falls from 1 m at the left to 21 m at the right.
        self.write("square.poly", "4 2 0 0\n1 0 0\n2 20 0\n3 20 20\n4 0 20\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n")
        rows = [" ".join(str(1 + i) for i in range(21))] * 21
        head = "ncols 21\nnrows 21\nxllcenter 0\nyllcenter 0\ncellsize 1\nNODATA_value -9999\n"
        self.write("bed.asc", head + "\n".join(rows) + "\n")
        self.call("mesh", "square.poly", "-o", "byformula.msh", "--spacing", "0.1*(1+x)")
        for option in ("--spacing=0.1*bed(x,y)", "--spacing=0.1*(1+x)*bed_x(x,y)"):
            self.call("mesh", "square.poly", "-o", "byraster.msh", "--raster", "bed=bed.asc", option)
            counts = [self.info(f"{name}.msh")["elements"] for name in ("byformula", "byraster")]
            self.assertLess(abs(counts[0] - counts[1]), 0.05 * counts[0])
        self.call("mesh", "square.poly", "-o", "rule.msh", "--raster", "bed=bed.asc",
                  "--size-preset", "wavelength:depth=bed,period=10,elements=20", "--size-preset", "shore:size=1,growth=0.2")
        self.assertTrue(self.info("rule.msh")["valid"])
        self.call("check", "byraster.msh", "--raster", "bed=bed.asc", "--spacing", "0.1*bed(x,y)")
        rows[10] = rows[11] = rows[12] = rows[13] = rows[9] = " ".join(["-9999"] * 21)
        rows[8] = rows[14] = rows[9]
        self.write("gap.asc", head + "\n".join(rows) + "\n")
        refused = self.call("mesh", "square.poly", "-o", "none.msh", "--raster", "bed=gap.asc",
                            "--spacing", "max(1, bed(x,y))", code=1)
        self.assertIn("the raster 'bed' has no value in or near a part of the domain", refused.stderr)
        for options, message in ((["--raster", "bed"], "expected NAME=FILE"), (["--raster", "sin=bed.asc"], "another meaning"),
                                 (["--size-preset", "tide:elements=3"], "unknown rule"),
                                 (["--raster", "bed=bed.asc", "--spacing", "bet(x,y)"], "unknown name 'bet'")):
            refused = self.call("mesh", "square.poly", "-o", "none.msh", *options, code=2)
            self.assertIn(message, refused.stderr)

    def test_info_refuses_what_holds_neither(self):
        self.write("broken.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\nx\n")
        self.assertIn("broken.msh:", self.call("info", "broken.msh", code=1).stderr)
        self.write("grid.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 1\n1 1\n")
        self.assertIn("--spacing-file", self.call("info", "grid.asc", code=1).stderr)
        self.call("info", "none.msh", code=1)

    def test_info_describes_an_invalid_mesh_without_areas(self):
        self.write("bow.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 1 1 0\n"
                              "$EndNodes\n$Elements\n2\n1 2 2 1 1 1 2 3\n2 2 2 1 1 1 2 4\n$EndElements\n")
        told = self.info("bow.msh")
        self.assertEqual((told["valid"], told["elements"]), (False, 2))
        self.assertNotIn("area", told)
        self.assertIn("forefront check", self.call("info", "bow.msh").stdout)

    def test_formats_lists_what_the_options_accept(self):
        listed = json.loads(self.call("formats", "--json").stdout)["formats"]
        table = self.call("formats").stdout
        for entry in listed:
            self.assertRegex(table, rf"(?m)^{entry['id']} ")
        writable = {entry["id"] for entry in listed if entry["writes_mesh"]}
        refused = self.call("mesh", "plate.poly", "-o", "a.msh", "--format", "none", code=2).stderr
        for name in writable:
            self.assertIn(name, refused)
        self.assertIn("quadrilateral9", next(e for e in listed if e["id"] == "vtu")["elements"])
        rows = [line for line in table.splitlines() if line and not line.startswith(" ")]
        column = rows[0].index("name")
        for row, entry in zip(rows[1:], listed):
            self.assertEqual(row[column:], entry["name"])
        for word, named in (("abaqus", "inp"), ("CalculiX", "inp"), ("msh3", "msh2")):
            refused = self.call("mesh", "plate.poly", "-o", "a.msh", "--format", word, code=2).stderr
            self.assertIn(f"; did you mean {named}?", refused)

    def test_an_outline_that_does_not_close_is_warned_of_also_when_quiet(self):
        self.write("open.wkt", "MULTILINESTRING((0 0,10 0,10 5,0 5,0 0.01),(3 2,6 2,6 3,3 3,3 2))\n")
        warned = self.call("mesh", "open.wkt", "-q", "-o", "a.msh").stderr
        self.assertRegex(warned, r"^open.wkt:1:\d+: warning: the outline does not close at \(0, 0(\.01)?\) by 0.01, so the area "
                                 r"within it is not meshed; --weld 0.0105 closes it \[open-outline\]\n$")
        self.assertEqual(self.call("mesh", "open.wkt", "-q", "-o", "a.msh", "--weld", "0.0105").stderr, "")


class Convert(Case):
    CELLS = ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 5 \"in let\"\n2 3 \"plate\"\n$EndPhysicalNames\n"
             "$Nodes\n5\n1 0 0 0\n2 2 0 0\n3 2 2 0\n4 0 2 0\n5 3 1 0\n$EndNodes\n$Elements\n3\n1 1 2 5 5 1 2\n"
             "2 2 2 3 3 2 5 3\n3 3 2 4 4 1 2 3 4\n$EndElements\n")
    CURVED = ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n1 0 0 0\n2 2 0 0\n3 2 2 0\n4 0 2 0\n5 1 -0.2 0\n"
              "6 2 1 0\n7 1 2 0\n8 0 1 0\n$EndNodes\n$Elements\n2\n1 8 2 5 5 1 2 5\n2 16 2 3 3 1 2 3 4 5 6 7 8\n"
              "$EndElements\n")

    def setUp(self):
        super().setUp()
        self.write("cells.msh", self.CELLS)
        self.write("curved.msh", self.CURVED)

    def test_a_mesh_keeps_nodes_elements_tags_and_names_in_other_formats(self):
        done = self.call("convert", "cells.msh", "-o", "a.vtu", "-o", "b.inp", "-o", "c.su2")
        self.assertEqual(done.stdout, "5 nodes, 1 triangle, 1 quadrilateral\nwrote a.vtu\nwrote b.inp\nwrote c.su2\n")
        self.call("convert", "a.vtu", "-o", "again.msh", "-q")
        for name in ("cells.msh", "a.vtu", "b.inp", "again.msh"):
            line = self.call("check", name).stdout.splitlines()[0]
            self.assertIn("5 nodes, 2 elements", line)
        hashes = {self.call("check", name).stdout.split("hash ")[1].split()[0] for name in
                  ("cells.msh", "a.vtu", "again.msh")}
        self.assertEqual(len(hashes), 1)
        self.assertIn('"in let"', self.read("again.msh"))
        self.assertIn('"plate"', self.read("again.msh"))
        piped = subprocess.run([PROGRAM, "convert", "-", "-o", "-", "--format", "msh2", "-q"], input=self.CELLS,
                               capture_output=True, text=True, timeout=300)
        self.assertEqual(piped.returncode, 0, piped.stderr)
        self.assertEqual(piped.stdout, self.read("again.msh"))

    def test_numbers_and_names_of_groups_are_told_apart_or_kept(self):
        self.write("same.msh", self.CELLS.replace('2 3 "plate"', '2 5 "in let"').replace("2 2 2 3 3 2", "2 2 2 5 5 2"))
        for name, words, number, label in (("apart", [], 1005, "in let_region"), ("keep", ["--tags", "keep"], 5, "in let")):
            for form in ("msh2", "msh41"):
                told = self.call("convert", "same.msh", "-o", f"{name}.msh", "--format", form, *words).stderr
                text = self.read(f"{name}.msh")
                self.assertIn(f'2 {number} "{label}"\n', text)
                self.assertIn('1 5 "in let"\n', text)
                self.assertEqual("changed-names" in told, name == "apart")
                self.assertEqual("$Comments" in text, name == "apart")
                self.assertEqual(self.call("check", f"{name}.msh").stdout, self.call("check", "same.msh").stdout)
        for words, error in ((["-o", "a.vtu"], "no output numbers tags apart"),
                             (["-o", "a.msh", "--extrude", "1"], "extruded meshes have faces and volumes")):
            self.assertIn(error, self.call("convert", "same.msh", "--tags", "keep", *words, code=2).stderr)

    def test_what_a_format_cannot_hold_is_refused_before_anything_is_written(self):
        for name, words in (("a.su2", "SU2 files hold no"), ("a.obj", "files hold no"), ("a.node", "files hold no")):
            refused = self.call("convert", "curved.msh", "-o", "good.vtu", "-o", name, code=1).stderr
            self.assertIn("[unsupported-elements]", refused)
            self.assertIn(words, refused)
            self.assertIn("or split the elements with --triangles", refused)
            self.assertFalse((self.path / "good.vtu").exists() or (self.path / name).exists())

    def test_elements_can_be_split_into_triangles(self):
        done = self.call("convert", "curved.msh", "-o", "a.su2", "--triangles")
        self.assertIn("8 nodes, 6 triangles\n", done.stdout)
        self.assertIn("valid: 8 nodes, 6 elements", self.call("check", "a.su2").stdout)
        self.assertIn("MARKER_ELEMS= 2", self.read("a.su2"))  # one edge of 3 nodes
        self.call("mesh", "plate.poly", "-o", "plate.msh", "--size", "0.5")
        self.call("convert", "plate.msh", "-o", "same.msh", "--triangles", "-q")
        self.assertEqual(self.read("plate.msh"), self.read("same.msh"))

    def test_elements_can_get_nodes_in_the_middles_of_their_edges(self):
        for name, kind in (("second.msh", 8), ("second.vtu", 9)):
            done = self.call("convert", "cells.msh", "-o", name, "--order", "2", "--quad-nodes", str(kind))
            self.assertIn(f"{kind + 3} nodes, 1 triangle of 6 nodes, 1 quadrilateral of {kind} nodes\n", done.stdout)
            self.assertIn(f"valid: {kind + 3} nodes, 2 elements", self.call("check", name).stdout)
        again = self.call("convert", "second.msh", "-o", "third.msh", "--order", "2").stderr
        self.assertIn("--order has no effect", again)
        self.call("convert", "cells.msh", "-o", "a.msh", "--order", "1", code=2)
        self.call("convert", "cells.msh", "-o", "a.msh", "--quad-nodes", "9", code=2)
        refused = self.call("convert", "cells.msh", "-o", "a.su2", "--order", "2", code=1).stderr
        self.assertIn("[unsupported-elements]", refused)

    def test_extrusion_makes_prisms_and_hexahedra(self):
        self.call("convert", "cells.msh", "-o", "a.foam", "-o", "a.msh", "-o", "a.inp", "--extrude", "0.5:2", "-q")
        self.assertIn("\n7 6 2 3 3 4 13 7 5 14 8\n8 6 2 3 3 5 14 8 6 15 9\n", self.read("a.msh"))  # prisms, after the faces
        self.assertIn('2 6 "back"\n2 7 "front"\n', self.read("a.msh"))
        self.assertIn("TYPE=C3D8", self.read("a.inp"))
        self.assertIn("front\n", self.read("a.foam/constant/polyMesh/boundary"))
        self.assertNotIn("empty", self.read("a.foam/constant/polyMesh/boundary"))
        noted = self.call("convert", "cells.msh", "-o", "a.foam").stderr  # replaces the mesh in the folder
        self.assertIn("a.foam: note: the mesh is one cell thick, 1.581 as the elements are wide", noted)
        self.assertIn("in_let\n", self.read("a.foam/constant/polyMesh/boundary"))
        self.assertIn("frontAndBack\n", self.read("a.foam/constant/polyMesh/boundary"))
        self.assertTrue((self.path / "a.foam/case.foam").exists())
        for wrong in ("0", "-1", "1:0", "1:2:3", "x", "1:1e9", "nan"):
            self.assertIn("expected a height above 0",
                          self.call("convert", "cells.msh", "-o", "b.msh", "--extrude", wrong, code=2).stderr)
        self.assertIn("SU2 files hold no prisms and hexahedra; write one of msh2",
                      self.call("convert", "cells.msh", "-o", "b.su2", "--extrude", "1", code=2).stderr)
        self.assertIn("second order", self.call("mesh", "plate.poly", "-o", "b.foam", "--order", "2", code=2).stderr)
        self.assertIn("[unsupported-extrusion]",
                      self.call("convert", "curved.msh", "-o", "b.msh", "--extrude", "1", code=1).stderr)
        self.assertFalse((self.path / "b.foam").exists() or (self.path / "b.msh").exists())

    def test_elevations_come_from_expressions_and_rasters_and_are_carried_on(self):
        self.call("convert", "cells.msh", "-o", "a.2dm", "-o", "a.vtu", "--elevation=-1-x", "-q")
        self.assertIn("ND 5 3 1 -4\n", self.read("a.2dm"))
        for name in ("a.2dm", "a.vtu"):
            done = self.call("convert", name, "-o", "b.gr3", "-o", "b.msh", "-o", "b.su2")
            self.assertIn("b.su2: note: the format holds no elevations of nodes; they are left out", done.stderr)
            self.assertNotIn("dropped-fields", done.stderr)
            self.assertIn("\n5 3 1 4\n", self.read("b.gr3"))
            self.assertIn('"elevation"', self.read("b.msh"))
        self.call("convert", "a.2dm", "-o", "c.2dm", "--order", "2", "-q")
        self.assertIn(" 1 0 -2\n", self.read("c.2dm"))  # in the middle of (0, 0) and (2, 0)
        self.write("bed.asc", "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 2\nNODATA_value 9\n-1 -3\n")
        self.call("convert", "cells.msh", "-o", "d.2dm", "--elevation", "bed.asc", "-q")
        self.assertIn("ND 2 2 0 -2\n", self.read("d.2dm"))
        self.write("bed.asc", "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 2\nNODATA_value 9\n-1 9\n")
        refused = self.call("convert", "cells.msh", "-o", "e.2dm", "--elevation", "bed.asc", code=1).stderr
        self.assertIn("bed.asc: error: no elevation at 3 nodes of 5", refused)
        self.assertIn("at (2, 0) [no-elevation]", refused)
        self.assertFalse((self.path / "e.2dm").exists())
        for wrong, words in (("1/(", "unexpected end"), ("none.asc", "file none.asc not found"),
                             ("-depth(x,y)", "unknown name 'depth'")):
            self.assertIn(words, self.call("mesh", "plate.poly", "-o", "f.2dm", "--elevation", wrong, code=2).stderr)
        self.assertIn("no output holds elevations",
                      self.call("convert", "cells.msh", "-o", "f.su2", "--elevation", "1", code=2).stderr)

    def test_elevations_call_the_rasters_of_the_project_and_of_the_command(self):
        bay = pathlib.Path(__file__).parents[2] / "assets" / "samples" / "bay.json"
        self.call("mesh", bay, "-o", "bay.2dm", "--elevation", "-depth(x,y)", "-q")
        self.assertLess(max(float(line.split()[4]) for line in self.read("bay.2dm").splitlines() if line.startswith("ND ")), 0)
        self.write("bed.asc", "ncols 2\nnrows 2\nxllcorner -5\nyllcorner -5\ncellsize 30\n-1 -3\n-1 -3\n")
        done = self.call("mesh", "plate.poly", "-o", "p.14", "--raster", "bed=bed.asc", "--elevation", "2*bed(x,y)")
        self.assertNotIn("no effect", done.stderr)
        self.assertLess(0, min(float(line.split()[3]) for line in self.read("p.14").splitlines()[2:6]))
        self.write("bed.asc", "ncols 2\nnrows 2\nxllcorner -5\nyllcorner -5\ncellsize 1\n-1 -3\n-1 -3\n")
        self.assertIn("--elevation: the raster 'bed' has no value in or near a part of the domain",
                      self.call("mesh", "plate.poly", "-o", "q.14", "--raster", "bed=bed.asc", "--elevation", "bed(x,y)",
                                code=1).stderr)
        self.write("run.jsonl", '{"command": "open", "file": "%s"}\n{"command": "mesh"}\n'
                   '{"command": "export", "file": "s.2dm", "elevation": "-depth(x,y)"}\n' % bay)
        self.call("run", "run.jsonl", "-q")
        self.assertEqual(self.read("s.2dm"), self.read("bay.2dm"))
        self.assertIn("unknown name 'depth'", self.call("convert", "bay.2dm", "-o", "c.2dm", "--elevation", "-depth(x,y)",
                                                        code=2).stderr)

    def test_values_are_left_out_with_a_note(self):
        self.write("flux.msh", self.CELLS + "$ElementData\n1\n\"flux\"\n1\n0\n3\n0\n1\n1\n3 1.5\n$EndElementData\n"
                   "$NodeData\n1\n\"heat\"\n1\n0\n3\n0\n1\n1\n1 1.5\n$EndNodeData\n")
        noted = self.call("convert", "flux.msh", "-o", "a.vtk").stderr
        self.assertIn("note: values of nodes and elements are left out: 'heat', 'flux' [dropped-fields]", noted)
        self.assertEqual(self.call("convert", "flux.msh", "-o", "a.vtk", "-q").stderr, "")

    def test_wrong_usage_and_bad_files_are_refused(self):
        self.call("convert", "cells.msh", code=2)
        self.call("convert", "-o", "a.vtu", code=2)
        self.call("convert", "cells.msh", "-o", "a.unknown", code=2)
        self.call("convert", "cells.msh", "-o", "a.vtu", "--format", "msh2", code=2)
        self.assertIn("it is an input", self.call("convert", "cells.msh", "-o", "cells.msh", code=1).stderr)
        self.assertIn("cannot-read", self.call("convert", "missing.msh", "-o", "a.vtu", code=1).stderr)
        self.write("lines.msh", self.CELLS.replace("$Elements\n3\n1 1 2 5 5 1 2\n2 2 2 3 3 2 5 3\n3 3 2 4 4 1 2 3 4\n",
                                                   "$Elements\n1\n1 1 2 5 5 1 2\n"))
        self.assertIn("[empty-mesh]", self.call("convert", "lines.msh", "-o", "a.vtu", code=1).stderr)
        self.assertIn("Examples:", self.call("convert", "--help").stdout)


class AnyElements(Case):
    def test_check_and_adapt_take_meshes_of_any_elements(self):
        self.write("cells.msh", Convert.CELLS)
        self.write("curved.msh", Convert.CURVED)
        self.assertIn("valid: 5 nodes, 2 elements", self.call("check", "cells.msh", "--measures").stdout)
        self.write("whole.msh", Convert.CURVED.replace("$Elements\n2\n", "$Elements\n5\n3 8 2 6 6 2 3 6\n4 8 2 6 6 3 4 7\n"
                                                       "5 8 2 6 6 4 1 8\n"))
        self.assertIn("valid for the domain: 8 nodes", self.call("check", "whole.msh", "--domain", "whole.msh").stdout)
        self.assertEqual(json.loads(self.call("check", "curved.msh", "--stats", "-").stdout)["elements"], 1)
        for name in ("cells.msh", "curved.msh", "whole.msh"):
            self.call("adapt", name, "--expression", "x*x", "--error", "0.1", "-o", "new.msh", "-q")
            self.assertIn("valid", self.call("check", "new.msh").stdout)
            self.call("mesh", name, "-o", "meshed.msh", "--size", "0.3", "-q")
            self.call("check", "meshed.msh", "--domain", name)
        heat = "$NodeData\n1\n\"heat\"\n1\n0\n3\n0\n1\n5\n1 0.1\n2 1\n3 0.5\n4 0.2\n5 2\n$EndNodeData\n"
        self.write("heat.msh", Convert.CELLS + heat)
        self.call("adapt", "heat.msh", "--field", "heat", "--error", "0.2", "-o", "new.msh", "-q")
        self.call("mesh", "cells.msh", "-o", "spaced.msh", "--spacing-file", "heat.msh", "-q")


class RealDomains(Case):
    def test_every_file_meshes_by_default_and_with_its_boundary_kept(self):
        data = os.environ.get("FOREFRONT_DATA")
        if not data:
            self.skipTest("FOREFRONT_DATA is not set")
        files = sorted(pathlib.Path(data).glob("*.poly"))
        self.assertTrue(files, f"no .poly files in {data}")
        for file in files:
            for more in ([], ["--keep-boundary"]):
                with self.subTest(file=file.name, options=more):
                    stats = self.stats(file, "-o", "real.msh", *more)
                    self.call("check", "real.msh", "--domain", file)
                    print(f"{file.name} {' '.join(more)}: {stats['elements']} elements, geometric mean of alpha "
                          f"{stats['alpha_geometric_mean']:.4f}, minimum {stats['alpha_min']:.4f}")
                    if not more:
                        self.assertGreaterEqual(stats["alpha_geometric_mean"], 0.93)


if __name__ == "__main__":
    unittest.main()
