#!/usr/bin/env python3
"""forefront trace: what it writes, what it finds, and the exercise that it is made for.

    test_trace.py PROGRAM [NAME OF A TEST...]
"""

import importlib.util
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv.pop(1))
ROOT = pathlib.Path(__file__).resolve().parents[2]
DRAWINGS = ROOT / "assets/lessons/drawings"
RING = DRAWINGS / "ring.json"

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import exercise_answers  # noqa: E402


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def call(self, *words, code=0):
        done = subprocess.run([PROGRAM, "trace", *map(str, words)], cwd=self.path, capture_output=True, text=True,
                              timeout=300)
        self.assertEqual(done.returncode, code, f"{words}\n{done.stdout}\n{done.stderr}")
        return done

    def trace(self, drawing, *words):
        self.call(drawing, "-o", "run.json", "--method", "classic", *words)
        return json.loads((self.path / "run.json").read_text())


class Tracing(Case):
    def differs(self, change, words=()):
        """Returns what a comparison with a changed trace of the ring prints."""
        run = self.trace(RING)
        change(run["advances"])
        (self.path / "mine.json").write_text(json.dumps(run, indent=1))
        return self.call(RING, "--method", "classic", "--compare", "mine.json", *words, code=1).stdout

    def test_a_trace_of_quadrilaterals_tells_squares_colours_and_halves(self):
        drawing = DRAWINGS / "washer.json"
        run = self.trace(drawing)
        self.assertEqual(run["elements"], "quads")
        self.assertEqual(len(run["boundary"]["colours"]), len(run["boundary"]["nodes"]))
        verdicts = set()
        for advance in run["advances"]:
            squares = [c for c in advance["candidates"] if "square" in c]
            made = [c["square"] for c in squares if c["verdict"] == "accepted"]
            self.assertEqual(made, [] if advance["square"] == "half" else [advance["square"]])
            self.assertEqual(len(advance["elements"]), 2 if made else 1 if advance["elements"] else 0)
            self.assertTrue(all(("second" in c) == (c["square"] != "row") for c in squares))
            verdicts |= {c["verdict"] for c in advance["candidates"]}
        self.assertEqual(run["advances"][-1]["front"], 0)
        self.assertTrue({"bad-shape", "one-colour", "withdrawn"} & verdicts)
        area = sum(((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2
                   for advance in run["advances"] for a, b, c in advance["elements"])
        nodes = run["boundary"]["nodes"]
        self.assertAlmostEqual(area, sum((nodes[a][0] * nodes[b][1] - nodes[b][0] * nodes[a][1]) / 2
                                         for a, b in run["boundary"]["segments"]), 9)
        self.assertIn("the traces agree", self.call(drawing, "--compare", "run.json").stdout)
        row = next(k for k, advance in enumerate(run["advances"]) if advance["square"] == "row")
        run["advances"][row]["candidates"][-1]["at"] = [0.123, 0.456]
        (self.path / "mine.json").write_text(json.dumps(run))
        self.assertIn("the square that continues the row, with a corner at",
                      self.call(drawing, "--compare", "mine.json", code=1).stdout)

    def test_a_trace_tells_every_advance(self):
        run = self.trace(RING)
        self.assertEqual((run["format"], run["version"], run["method"]), ("forefront-trace", 1, "classic"))
        segments, nodes = run["boundary"]["segments"], run["boundary"]["nodes"]
        self.assertEqual(len(segments), 34)
        self.assertTrue(all(abs(math.dist(nodes[a], nodes[b]) - 1) < 1e-12 for a, b in segments))
        length = len(segments)
        for number, advance in enumerate(run["advances"], 1):
            self.assertEqual(advance["advance"], number)
            a, b = advance["base"]["a"], advance["base"]["b"]
            self.assertAlmostEqual(math.dist(a, advance["c"]), math.dist(b, advance["c"]), 9)
            self.assertLessEqual(advance["front"], length + 1)
            length = advance["front"]
            accepted = [c["at"] for c in advance["candidates"] if c["verdict"] == "accepted"]
            self.assertEqual(len(accepted), len(advance["elements"]))
            if accepted:
                self.assertEqual(advance["elements"], [[a, b, accepted[0]]])
            for candidate in advance["candidates"]:
                score = candidate["alpha"] * candidate["delta-ac"] * candidate["delta-cb"]
                self.assertAlmostEqual(candidate["score"], score, 12)
        self.assertEqual(length, 0)
        area = sum(((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2
                   for advance in run["advances"] for a, b, c in advance["elements"])
        self.assertAlmostEqual(area, 8 * 6 - 2 * 1, 9)

    def test_every_method_and_grid_agrees_with_its_own_trace(self):
        for words in (["--method", "classic"], ["--method", "fast"], ["--method", "fast", "--grid", "none"]):
            self.call(DRAWINGS / "plate.json", "-o", "own.json", *words)
            done = self.call(DRAWINGS / "plate.json", "--compare", "own.json", *words)
            self.assertIn("the traces agree: ", done.stdout)

    def test_a_part_of_a_run(self):
        self.assertEqual(self.trace(RING, "--steps", "0")["advances"], [])
        self.assertEqual(len(self.trace(RING, "--steps", "7")["advances"]), 7)
        done = self.call(RING, "--method", "classic", "--compare", "run.json", "--steps", "7")
        self.assertEqual(done.stdout, "the traces agree: 7 advances\n")
        done = self.call(RING, "--method", "classic", "--compare", "run.json", code=1)
        self.assertEqual(done.stdout, "advance 8: your trace ends, but the front still has segments\n")

    def test_the_first_difference_is_named(self):
        def moved(advances):
            advances[11]["c"][0] += 1e-3
        self.assertRegex(self.differs(moved), r"^mine\.json:\d+: advance 12: C is \(.*\); yours is \(")

        def scored(advances):
            advances[6]["candidates"][0]["score"] *= 1.001
        self.assertRegex(self.differs(scored), r"advance 7: the score of .* is .*; yours is ")

        def turned(advances):
            base = advances[2]["base"]
            base["a"], base["b"] = base["b"], base["a"]
        self.assertIn("advance 3: the base", self.differs(turned))
        self.assertIn("on the left of AB", self.differs(turned))

        def exchanged(advances):
            advances[0], advances[1] = advances[1], advances[0]
        self.assertIn("Of segments that are equally short the oldest is taken", self.differs(exchanged))

        def counted(advances):
            advances[4]["front"] += 1
        self.assertRegex(self.differs(counted), r"advance 5: the front has \d+ segments afterwards; yours has \d+")

        def lacking(advances):
            advances[20]["candidates"].pop(0)
        self.assertRegex(self.differs(lacking), r"advance 21: .* is a candidate, with score .*; yours lacks it")

        def deferring(advances):
            advances[9]["elements"] = []
        self.assertRegex(self.differs(deferring), r"advance 10: made: .*; yours: deferred")

        def clockwise(advances):
            advances[9]["elements"][0].reverse()
        self.assertRegex(self.differs(clockwise), r"advance 10: made: .*; yours is the same, but clockwise: .*\. The corners")

        def longer(advances):
            advances.append(advances[-1])
        self.assertIn("your trace goes on", self.differs(longer))

    def test_only_what_a_trace_tells_is_compared(self):
        run = self.trace(RING)
        bare = {"advances": [{"base": {"a": a["base"]["a"], "b": a["base"]["b"]}} for a in run["advances"]]}
        (self.path / "mine.json").write_text(json.dumps(bare))
        self.call(RING, "--method", "classic", "--compare", "mine.json")
        done = self.call(RING, "--method", "fast", "--compare", "mine.json", code=1)
        self.assertIn("add --method classic", done.stdout)

    def test_wrong_traces_are_refused_with_their_place(self):
        for text, message in (('{"advances": [{"rho": 1}]}', 'mine.json:1:'), ('{"steps": []}', "not a trace"),
                              ('{"advances": [{"base": {"a": [0, 0], "b": [1, 0]}, "c": "up"}]}', "mine.json:1:"),
                              ('{"advances": [{"base": {"a": [0, 0], "b": [1, 0]}, "elements": [[[0, 0]]]}]}',
                               "an element has 3 corners, not 1"), ('{"advances": [', "mine.json:1:")):
            (self.path / "mine.json").write_text(text)
            self.assertIn(message, self.call(RING, "--compare", "mine.json", code=1).stderr)

    def test_wrong_use(self):
        self.assertIn("one of --output and --compare", self.call(RING, code=2).stderr)
        self.assertIn("exclude each other", self.call(RING, "-o", "a.json", "--compare", "b.json", code=2).stderr)
        self.assertIn("nothing to compare", self.call(RING, "--compare", "b.json", "--steps", "0", code=2).stderr)
        self.call(RING, "-o", "nowhere/run.json", code=1)


class Exercise(Case):
    """The skeleton with its answers agrees with the program, advance by advance."""

    def solve(self, drawing, rho_at=None, without=None, code=0):
        """Runs the skeleton with its answers, without a test of step 8, and returns what the comparison prints."""
        spec = importlib.util.spec_from_file_location("front", ROOT / "assets/exercise/front.py")
        own = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(own)
        for function in (own.take_base, lambda: own.ideal_point(None, None), lambda: own.verdict(0, None, None)):
            self.assertRaises(NotImplementedError, function)
        exercise_answers.answers(own, without)
        own.rho_at = rho_at or own.rho_at
        boundary = self.trace(drawing, "--steps", "0")["boundary"]
        own.nodes += boundary["nodes"]
        own.front += [[a, b, 0] for a, b in boundary["segments"]]
        while own.front and len(own.advances) < (2000 if code == 0 else 60):  # a wrong one may go on for ever
            own.advance()
        self.assertTrue(code > 0 or own.front == [])
        (self.path / "mine.json").write_text(json.dumps({"advances": own.advances}, indent=1))
        return self.call(drawing, "--method", "classic", "--compare", "mine.json", code=code).stdout

    def test_the_ring(self):
        self.assertRegex(self.solve(RING), r"^the traces agree: \d+ advances\n$")

    def test_the_plate(self):
        def rho_at(p):
            return min(2.0, 0.35 + 0.2 * max(0.0, math.dist(p, (10, 7)) - 2.5))
        self.assertRegex(self.solve(DRAWINGS / "plate.json", rho_at), r"^the traces agree: \d+ advances\n$")

    def test_the_rooms_need_each_test_of_step_8(self):
        def rho_at(_):
            return 3.0
        rooms = DRAWINGS / "rooms.json"
        self.assertRegex(self.solve(rooms, rho_at), r"^the traces agree: \d+ advances\n$")
        for test in ("not-left", "crosses-front", "contains-node"):
            self.assertRegex(self.solve(rooms, rho_at, test, 1), rf"advance \d+: .* is {test}.*; yours is accepted\n$")
        # Whatever leaves along the meshed side meets the front or holds a node: the mesh is the same without this test.
        self.assertRegex(self.solve(rooms, rho_at, "outside-angle"),
                         r"^the traces agree: \d+ advances\nnote: another test than ours rejects \d+ candidates, first "
                         r"in advance \d+: .* is outside-angle.*; yours is crosses-front\n$")

    def run_own(self, changes=""):
        """Runs the skeleton as a program, with statements before its loop; returns what it and the comparison print."""
        text = (ROOT / "assets/exercise/front.py").read_text().replace("if __name__ ==", changes + "\nif __name__ ==")
        (self.path / "front.py").write_text(text)
        self.call(RING, "-o", "start.json", "--steps", "0")
        (self.path / "mine.json").write_text("of another run")
        done = subprocess.run([sys.executable, "front.py", "start.json", "mine.json"], cwd=self.path, text=True,
                              capture_output=True, timeout=60,
                              env=os.environ | {"PYTHONPATH": str(pathlib.Path(__file__).parent)})
        return done, self.call(RING, "--compare", "mine.json", code=0 if done.returncode == 0 else 1).stdout

    def test_a_run_that_fails_writes_what_it_has(self):
        done, compared = self.run_own()
        self.assertIn("NotImplementedError", done.stderr)
        self.assertIn("mine.json: 0 advances", done.stdout)
        self.assertEqual(compared, "advance 1: your trace ends, but the front still has segments\n")
        solved = "import exercise_answers\nexercise_answers.answers(sys.modules[__name__])\n"
        done, compared = self.run_own(solved)
        self.assertEqual((done.stderr, compared), ("", "the traces agree: 100 advances\n"))
        # Only steps 2 to 4 are written: these are compared.
        first = "def candidates(*_):\n    raise NotImplementedError\n"
        self.assertEqual(self.run_own(solved + first)[1], "advance 2: your trace ends, but the front still has segments\n")
        # C on the wrong side: no triangle fits.
        wrong = ("over = ideal_point\ndef ideal_point(a, b):\n    rho, c = over(b, a)\n    return rho, c\n")
        done, compared = self.run_own(solved + wrong)
        self.assertIn("no triangle fits", done.stderr)
        self.assertRegex(compared, r"^mine\.json:\d+: advance 1: C is \(.*; yours is \(")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[1:]])
