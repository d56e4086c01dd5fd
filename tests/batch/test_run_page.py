#!/usr/bin/env python3
"""The page that plays a run, in a real browser. Exit code 77 without one.

    test_run_page.py PROGRAM [NAME OF A TEST...]

FOREFRONT_SCREENSHOTS may name a folder for pictures of the page.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv.pop(1))
DRAWINGS = pathlib.Path(__file__).resolve().parents[2] / "assets/lessons/drawings"
SHOTS = os.environ.get("FOREFRONT_SCREENSHOTS")

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parent))
import browser  # noqa: E402

FOLDER = tempfile.TemporaryDirectory()


def page(drawing, name, *words):
    path = pathlib.Path(FOLDER.name) / name
    subprocess.run([PROGRAM, "film", DRAWINGS / drawing, "-o", path, *words], check=True, stdout=subprocess.DEVNULL)
    return path


class Files(unittest.TestCase):
    def test_a_page_is_small_and_needs_nothing_else(self):
        text = page("plate.json", "plate.html", "--steps", "500").read_text()
        self.assertLess(len(text.encode()), 1_000_000)
        whole = page("plate.json", "whole.html").read_text()  # 769 advances and the improvement
        self.assertGreater(whole.count('{"w":'), 40)
        self.assertLess(len(whole.encode()), 1_000_000)
        outside = re.findall(r"""(?:src|href|url|import|fetch)\s*[=(]\s*["']?\s*(?:https?:)?//""", text)
        self.assertEqual(outside, [])
        self.assertNotIn("http", re.sub(r'<script type="application/json".*?</script>', "", text, flags=re.S))

    def test_a_page_gets_the_title_of_its_drawing_whatever_it_is(self):
        name = pathlib.Path(FOLDER.name) / "a <b> & </script>.json".replace("/", "_")
        name.write_text((DRAWINGS / "ring.json").read_text())
        path = page(name, "odd.html", "--steps", "3")
        window = browser.Browser()
        self.addCleanup(window.close)
        window.open(path)
        self.assertEqual(window.text("#title"), name.stem)
        self.assertEqual(window.complaints, [])

    def test_what_a_page_has_not_is_refused(self):
        def fault(*words):
            done = subprocess.run([PROGRAM, "film", DRAWINGS / "ring.json", "-o", "x.html", *words], capture_output=True,
                                  text=True, cwd=FOLDER.name)
            self.assertIn(done.returncode, (1, 2))
            return done.stderr
        self.assertIn("--layers: a page has no such setting", fault("--layers", "mesh"))
        self.assertIn("--width: a page has no such setting", fault("--width", "300"))
        self.assertIn("the run has only", fault("--from", "5000"))
        self.assertIn("too many for a page", fault("--size", "0.05"))


class Playing(unittest.TestCase):
    """The ring of lesson 1, stepped by keys, buttons, the timeline and links."""

    def setUp(self):
        self.window = browser.Browser()
        self.addCleanup(self.window.close)
        self.path = page("ring.json", "ring.html")
        run = subprocess.run([PROGRAM, "trace", DRAWINGS / "ring.json", "-o", "-"], check=True, capture_output=True)
        self.trace = json.loads(run.stdout)["advances"]

    def figure(self, row):
        return float(self.window.text(f"#figures tr:nth-child({row}) td:last-child"))

    def step(self, number):
        return self.window.text(f"#steps li:nth-child({number}) span:last-child")

    def shown(self):
        return self.window.text("#position")

    def check_advance(self, number):
        """Compares the panels after an advance with its trace."""
        advance = self.trace[number - 1]
        self.assertEqual(self.shown(), f"{number} / {len(self.trace)}")
        self.assertEqual(self.figure(1), advance["front"])
        self.assertEqual(self.figure(2), sum(len(a["elements"]) for a in self.trace[:number]))
        self.assertEqual(self.step(2), "–".join(map(str, advance["base"]["nodes"])))
        self.assertEqual(self.step(8), str(len(advance["tests"])))
        self.assertTrue(self.window.text("#caption").startswith(f"Advance {number}. "))
        accepted = self.window.evaluate("document.querySelectorAll('#candidates td.accepted').length")
        self.assertEqual(accepted, len(advance["elements"]))

    def test_steps_agree_with_the_trace(self):
        self.window.open(self.path)
        self.assertEqual(self.shown(), f"0 / {len(self.trace)}")
        for number in (1, 2, 3):
            self.window.key("ArrowRight")
            self.check_advance(number)
        self.window.key("ArrowLeft")
        self.check_advance(2)
        for number in (17, 70, len(self.trace)):
            self.window.open(self.path, f"#{number}")
            self.check_advance(number)
        self.assertEqual(self.window.complaints, [])

    def test_events_within_an_advance(self):
        self.window.open(self.path, "#12")
        self.window.evaluate("document.getElementById('unit').value = 'event'")
        found = []
        while self.shown() != f"13 / {len(self.trace)}" and len(found) < 40:
            self.window.key("ArrowRight")
            found.append(self.window.evaluate(
                "[...document.querySelectorAll('#steps li')].findIndex((row) => row.className === 'here') + 1"))
        self.assertEqual(found[:6], [3, 4, 5, 6, 7, 8])
        self.assertEqual(found[-1], 9)
        self.assertEqual(sorted(found), found)
        for _ in found:
            self.window.key("ArrowLeft")
        self.assertEqual(self.shown(), f"12 / {len(self.trace)}")
        self.assertEqual(self.window.evaluate("location.hash"), "#12")
        self.assertEqual(self.window.complaints, [])

    def moments(self):
        return self.window.evaluate("JSON.parse(document.getElementById('run').textContent).improved.moments")

    def test_the_improvement_goes_on_after_the_front(self):
        """Steps, captions and meshes are those of pictures of the same moments."""
        self.window.open(self.path, f"#{len(self.trace)}")
        moments = self.moments()
        for number in range(1, moments + 1):
            self.window.key("ArrowRight")
            shown = "improved" if number == moments else f"step {number} / {moments}"
            self.assertEqual(self.shown(), shown)
            done = subprocess.run([PROGRAM, "film", DRAWINGS / "ring.json", "-o", f"{FOLDER.name}/step.svg", "--at",
                                   str(len(self.trace) + number)], check=True, capture_output=True)
            self.assertEqual(done.stderr, b"")
            picture = (pathlib.Path(FOLDER.name) / "step.svg").read_text()
            self.assertEqual(self.figure(2), picture.count("Z\n"))
            if number < moments:
                said = self.window.text("#caption")
                self.assertTrue(said.startswith(f"Improvement {number} of {moments}: "), said)
                words = " ".join(re.findall(r">([^<]+)</text>", picture))
                self.assertIn(words[:60].replace("&lt;", "<"), said)
        self.assertEqual(self.window.evaluate("location.hash"), f"#{len(self.trace)}.improved")
        self.window.open(self.path, f"#{len(self.trace)}.i2")
        self.assertEqual(self.shown(), f"step 2 / {moments}")
        self.window.click("#play")
        self.window.evaluate("new Promise((done) => setTimeout(done, 700))")
        self.window.click("#play")
        self.assertNotEqual(self.shown(), f"step 2 / {moments}")
        self.assertEqual(self.window.complaints, [])

    def test_the_last_step_of_the_improvement_is_the_improved_mesh(self):
        self.window.open(self.path)
        worst = self.window.evaluate(
            "(() => { const run = JSON.parse(document.getElementById('run').textContent), m = run.improved;"
            " const after = improvementOf(m, run.nodes, run.advances.flatMap((a) => a.elements));"
            " const centres = (nodes, elements) => { const list = []; for (let e = 0; e < elements.length; e += 3) {"
            "  list.push([0, 1].map((k) => [0, 1, 2].reduce((s, i) => s + nodes[2 * elements[e + i] + k] / 3, 0))); }"
            "  return list; };"
            " const last = after(m.steps.length), given = centres(last.nodes, last.cells.list), wanted = centres(m.nodes, m.elements);"
            " if (given.length !== wanted.length) { return 1e9; }"
            " return Math.max(...wanted.map((p) => Math.min(...given.map((q) => Math.hypot(p[0] - q[0], p[1] - q[1]))))); })()")
        self.assertLess(worst, 1e-3)

    def test_end_buttons_and_timeline(self):
        self.window.open(self.path)
        self.window.click("#end")
        self.assertEqual(self.shown(), "improved")
        self.assertEqual(self.figure(1), 0)
        alpha = float(self.window.text("#figures tr:last-child td:last-child"))
        moments = self.moments()
        self.assertGreater(moments, 3)
        for number in range(moments - 1, 0, -1):
            self.window.click("#back")
            self.assertEqual(self.shown(), f"step {number} / {moments}")
        self.window.click("#back")
        self.assertEqual(self.shown(), f"{len(self.trace)} / {len(self.trace)}")
        self.assertEqual(self.figure(1), 0)
        self.assertLess(float(self.window.text("#figures tr:last-child td:last-child")), alpha)
        x, y, width, height = self.window.evaluate(
            "(() => { const r = document.getElementById('plot').getBoundingClientRect(); return [r.x, r.y, r.width, r.height]; })()")
        at = x + 6 + (width - 12) * 40 / (len(self.trace) + moments)
        self.window.drag((x + 6, y + height / 2), (at, y + height / 2))
        self.check_advance(40)
        at = x + 6 + (width - 12) * (len(self.trace) + 3) / (len(self.trace) + moments)
        self.window.drag((x + 6, y + height / 2), (at, y + height / 2))
        self.assertEqual(self.shown(), f"step 3 / {moments}")
        self.window.click("#start")
        self.window.click("#play")
        self.window.evaluate("new Promise((done) => setTimeout(done, 900))")
        self.window.click("#play")
        played = int(self.shown().split()[0])
        self.assertGreaterEqual(played, 2)
        self.window.settle()
        self.assertEqual(int(self.shown().split()[0]), played)
        self.assertEqual(self.window.complaints, [])

    def pixel(self, x, y):
        return self.window.evaluate(
            "(() => { const c = document.getElementById('canvas'), k = c.width / c.clientWidth;"
            f" return [...c.getContext('2d').getImageData({x} * k, {y} * k, 1, 1).data].slice(0, 3); }})()")

    def colour(self, name):
        value = self.window.evaluate(f"getComputedStyle(document.documentElement).getPropertyValue('--{name}').trim()")
        return [int(value[k:k + 2], 16) for k in (1, 3, 5)]

    def test_the_canvas_shows_the_mesh_and_moves(self):
        self.window.open(self.path, "#0")
        width, height = self.window.evaluate(
            "(() => { const c = document.getElementById('canvas'); return [c.clientWidth, c.clientHeight]; })()")
        zoom = 0.9 * min(width / 8, height / 6)  # the ring is 8 by 6, its hole in the middle

        def at(x, y):
            return round(width / 2 + (x - 4) * zoom), round(height / 2 - (y - 3) * zoom)
        for theme in ("first", "other"):
            self.assertEqual(self.pixel(*at(1.3, 3.6)), self.colour("domain"), theme)
            self.assertEqual(self.pixel(*at(4, 3)), self.colour("canvas"), theme)
            self.window.key("t")
        self.window.key("End", "End")
        self.window.key("f")
        centre = self.window.evaluate(  # of an element of the improved mesh, away from its edges
            "(() => { const m = JSON.parse(document.getElementById('run').textContent).improved;"
            " const centres = []; for (let e = 0; e < m.elements.length; e += 3) {"
            "  centres.push([0, 1].map((k) => [0, 1, 2].reduce((s, i) => s + m.nodes[2 * m.elements[e + i] + k] / 3, 0))); }"
            " const far = (c) => Math.hypot(c[0] - 2, c[1] - 2); return centres.sort((p, q) => far(p) - far(q))[0]; })()")
        self.assertEqual(self.pixel(*at(*centre)), self.colour("element"))
        self.window.drag((300, 300), (400, 260))
        moved = at(*centre)
        self.assertEqual(self.pixel(moved[0] + 100, moved[1] - 40), self.colour("element"))
        before = self.window.picture()
        self.window.mouse("mouseWheel", 400, 300, deltaX=0, deltaY=-300)
        self.window.settle()
        self.assertNotEqual(self.window.picture(), before)
        self.assertEqual(self.window.complaints, [])

    def test_every_moment_of_both_methods_draws(self):
        for name, words in (("classic.html", []), ("fast.html", ["--method", "fast"])):
            self.window.open(page("blade.json", name, "--steps", "40", *words))
            self.window.evaluate("document.getElementById('unit').value = 'event'")
            self.window.key("g")
            moments = self.window.evaluate(
                "(() => { let n = 0; const next = document.getElementById('next'), shown = () => document.getElementById('position').textContent;"
                " for (let before = ''; before !== shown() && n < 20000; ++n) { before = shown(); next.click(); } return n; })()")
            self.assertGreater(moments, 150)
            self.assertTrue(self.shown().endswith(" / 40"))
            self.assertEqual(self.window.complaints, [])

    @unittest.skipUnless(SHOTS, "FOREFRONT_SCREENSHOTS names no folder")
    def test_pictures(self):
        plate = page("plate.json", "plate.html")
        for name, path, place, size, keys in (
                ("page-ring", self.path, "#12.5", (1280, 800), ""), ("page-ring-dark", self.path, "#69.9", (1280, 800), "t"),
                ("page-plate", plate, "#300", (1280, 800), ""), ("page-plate-cells-dark", plate, "#300", (1280, 800), "tg"),
                ("page-plate-end", plate, "#769.improved", (1440, 900), "t"), ("page-plate-improvement", plate, "#769.i3", (1280, 800), ""),
                ("page-phone", self.path, "#40", (390, 780), "")):
            window = browser.Browser(*size)
            window.open(path, place)
            for key in keys:
                window.key(key)
            (pathlib.Path(SHOTS) / (name + ".png")).write_bytes(window.picture())
            window.close()


class Squares(unittest.TestCase):
    """A run of quadrilaterals: squares, colours and the clean-up."""

    def setUp(self):
        self.window = browser.Browser()
        self.addCleanup(self.window.close)
        self.path = page("tile.json", "tile.html")
        run = subprocess.run([PROGRAM, "trace", DRAWINGS / "tile.json", "-o", "-"], check=True, capture_output=True)
        self.whole = json.loads(run.stdout)
        self.trace = self.whole["advances"]

    def figure(self, name):
        rows = self.window.evaluate(
            "[...document.querySelectorAll('#figures tr')].map((row) => [...row.cells].map((cell) => cell.textContent))")
        return dict(rows).get(name)

    def picture(self, number, drawing="tile.json"):
        """The picture of a moment that `forefront film` makes."""
        path = pathlib.Path(FOLDER.name) / "moment.svg"
        subprocess.run([PROGRAM, "film", DRAWINGS / drawing, "-o", path, "--at", str(number)], check=True, capture_output=True)
        return path.read_text()

    def drawn(self, picture):
        return re.search(r'<path fill="#dbe9f6" d="([^"]*)"', picture)[1].count("Z")

    def test_elements_captions_and_steps_are_those_of_the_program(self):
        self.window.open(self.path)
        self.assertIn("Front of quadrilaterals", self.window.text("#about"))
        self.assertEqual(self.window.text("#steps li:nth-child(2) span:nth-child(2)"), "Take a diagonal, else leg AB")
        self.assertEqual(self.window.text("#candidates th:nth-child(3)"), "shape")
        squares = set()
        for number, advance in enumerate(self.trace, 1):
            self.window.key("ArrowRight")
            self.assertEqual(int(self.figure("Γ, segments of the front")), advance["front"])
            said = self.window.text("#caption")
            self.assertTrue(said.startswith(f"Advance {number}. "), said)
            words = {"row": "row continued", "opening": "row opened", "closing": "gap closed"}.get(advance["square"])
            if words:
                self.assertIn(words, said)
            found = self.window.evaluate("document.querySelectorAll('#candidates td.accepted').length")
            self.assertEqual(found, 1 if advance["elements"] else 0, said)
            squares.add(advance["square"])
            if number % 9 == 0:
                self.assertEqual(int(self.figure("Elements")), self.drawn(self.picture(number)))
        self.assertEqual(squares, {"row", "opening", "closing", "half"})
        self.assertEqual(self.window.complaints, [])

    def test_colours_are_those_of_the_trace_and_alternate_along_legs(self):
        self.window.open(self.path)
        colours = self.window.evaluate("JSON.parse(document.getElementById('run').textContent).colours")
        given = self.whole["boundary"]["colours"]
        self.assertEqual([int(c) for c in colours[:len(given)]], given)
        for advance in self.trace:
            a, b = advance["base"]["nodes"]
            self.assertEqual(advance["diagonal"], colours[a] == colours[b])

    def test_the_clean_up_follows_with_its_figures(self):
        self.window.open(page("washer.json", "washer-end.html"))
        self.window.key("End")
        self.assertEqual(self.window.text("#position"), "improved")
        stats = pathlib.Path(FOLDER.name) / "washer-stats.json"
        subprocess.run([PROGRAM, "mesh", DRAWINGS / "washer.json", "-o", stats.with_suffix(".msh"), "--stats", stats], check=True,
                       capture_output=True)
        self.assertEqual(int(self.figure("Elements")), json.loads(stats.read_text())["elements"])
        moments, last = self.window.evaluate(
            "(() => { const run = JSON.parse(document.getElementById('run').textContent); return [run.improved.moments, run.advances.length]; })()")
        self.assertGreater(moments, 20)
        for number in range(moments - 1, 0, -1):
            self.window.key("ArrowLeft")
            said = self.window.text("#caption")
            self.assertTrue(said.startswith(f"Clean-up {number} of {moments}: "), said)
            irregular = re.search(r"irregular nodes (?:\d+ → )?(\d+)", said)[1]
            self.assertEqual(self.figure("Irregular nodes"), irregular)
            if number % 8 == 1:
                picture = self.picture(last + number, "washer.json")
                words = " ".join(re.findall(r">([^<]+)</text>", picture))
                self.assertEqual(words[:60], said[:60])
                self.assertEqual(int(self.figure("Elements")), self.drawn(picture), said)
        self.assertEqual(self.window.complaints, [])

    def test_every_event_draws_and_a_page_of_500_advances_is_small(self):
        path = page("washer.json", "washer.html", "--size", "0.28", "--steps", "500")
        self.assertLess(path.stat().st_size, 1_000_000)
        self.window.open(page("washer.json", "part.html", "--steps", "60"))
        self.window.evaluate("document.getElementById('unit').value = 'event'")
        self.window.key("g")
        moments = self.window.evaluate(
            "(() => { let n = 0; const next = document.getElementById('next'), shown = () => document.getElementById('position').textContent;"
            " for (let before = ''; before !== shown() && n < 20000; ++n) { before = shown(); next.click(); } return n; })()")
        self.assertGreater(moments, 300)
        self.assertEqual(self.window.text("#position"), "60 / 60")
        self.assertEqual(self.window.complaints, [])

    @unittest.skipUnless(SHOTS, "FOREFRONT_SCREENSHOTS names no folder")
    def test_pictures(self):
        washer = page("washer.json", "washer-whole.html")
        for name, path, place, keys in (
                ("squares-row", self.path, "#3.6", ""), ("squares-refused", washer, "#76.8", "t"), ("squares-front", washer, "#150", "tf"),
                ("squares-clean-up", washer, "#259.i16", ""), ("squares-end", washer, "#259.improved", "f")):
            window = browser.Browser(1280, 800)
            window.open(path, place)
            for key in keys:
                window.key(key)
            window.settle()
            (pathlib.Path(SHOTS) / (name + ".png")).write_bytes(window.picture())
            window.close()


class Lessons(unittest.TestCase):
    """Lessons written as pages: their texts, runs, questions and answers."""

    LESSONS = DRAWINGS.parent

    def write(self, name):
        path = pathlib.Path(FOLDER.name) / (name + ".html")
        subprocess.run([PROGRAM, "lesson", self.LESSONS / (name + ".json"), "-o", path], check=True, stdout=subprocess.DEVNULL)
        return path

    def answer(self, number):
        self.window.evaluate(f"document.getElementById('typed').value = '{number}'")
        self.window.click("#answers button")

    def saved(self):
        """Returns the answers as the page would save them."""
        self.window.evaluate("HTMLAnchorElement.prototype.click = () => {}")
        self.window.evaluate("void (URL.createObjectURL = (blob) => { blob.text().then((text) => { window.saved = text; }); return ''; })")
        self.window.click("#save")
        self.wait("answers", "Boolean(window.saved)")
        return json.loads(self.window.evaluate("window.saved"))

    def wait(self, what, condition):
        for _ in range(200):
            if self.window.evaluate(condition):
                return
            self.window.settle()
        self.fail("no " + what)

    def test_every_lesson_is_a_small_page_that_needs_nothing_else(self):
        for lesson in sorted(self.LESSONS.glob("*.json")):
            text = self.write(lesson.stem).read_text()
            self.assertLess(len(text.encode()), 1_000_000, lesson.stem)
            self.assertNotIn("http", re.sub(r'<script type="application/json".*?</script>', "", text, flags=re.S))

    def test_questions_are_answered(self):
        self.window = browser.Browser()
        self.addCleanup(self.window.close)
        self.window.open(self.write("1-front"))
        self.assertEqual(self.window.text("#heading"), "A domain to fill")
        self.answer("many")
        self.assertIn("Expected a number", self.window.text("#reply"))
        self.answer(33)
        self.assertEqual(self.window.evaluate("document.getElementById('reply').className"), "wrong")
        self.answer(34)
        self.assertIn("starts as the 34 segments", self.window.text("#reply"))
        self.window.click("#following")
        self.window.click("#answers button:nth-child(1)")
        self.assertIn("Count the sides", self.window.text("#reply"))
        self.window.click("#answers button:nth-child(2)")
        self.assertIn("33 segments", self.window.text("#reply"))
        self.window.click("#following")
        self.wait("run", "document.getElementById('player').srcdoc.length > 1000")
        self.assertEqual(self.window.text("#reply"), "")
        self.wait("answer", "document.getElementById('show').click() || document.getElementById('reply').className === 'right'")
        self.assertIn("after 10 advances", self.window.text("#reply"))
        pages = self.saved()["pages"]
        self.assertEqual([answer["right"] for answer in pages[0]["answers"]], [False, True])
        self.assertNotIn("shown", pages[0])
        self.assertEqual((pages[2]["shown"], pages[2]["answers"]), (True, []))  # by Show me, which is no answer
        self.assertEqual(self.window.complaints, [])

    def test_texts_have_formulas_images_and_links_and_a_mesh_its_colours(self):
        folder = pathlib.Path(FOLDER.name)
        shutil.copytree(self.LESSONS / "drawings", folder / "drawings", dirs_exist_ok=True)
        subprocess.run([PROGRAM, "film", DRAWINGS / "ring.json", "-o", folder / "ring.png", "--at", "9"], check=True,
                       stdout=subprocess.DEVNULL)
        question = {"text": "Is $x<y$?", "choices": [{"text": "$\\frac{1}{2}$", "right": True}, {"text": "a < b & c"}], "why": "[back](#1)"}
        pages = [{"title": "One", "text": ["a $\\sqrt{x_1^2}\\le\\value{front}$ [on](#Two)", "![a ring](ring.png width=50%)"],
                  "document": "drawings/coarse.json", "position": "end", "layers": ["mesh", "quality"], "colours": {"error": "x*x"}},
                 {"title": "Two", "text": "t", "question": question}]
        lesson = folder / "texts.json"
        lesson.write_text(json.dumps({"format": "forefront-lesson", "version": 1, "title": "T", "pages": pages}))
        subprocess.run([PROGRAM, "lesson", lesson, "-o", folder / "texts.html"], check=True, stdout=subprocess.DEVNULL)
        self.window = browser.Browser()
        self.addCleanup(self.window.close)
        self.window.open(folder / "texts.html")
        self.assertEqual(self.window.evaluate("document.querySelector('.math').getAttribute('aria-label')"), "√(x_1^2) ≤ 0")
        self.wait("image", "document.querySelector('#text img').naturalWidth > 100")
        size = self.window.evaluate("[document.querySelector('#text img').clientWidth, document.querySelector('#text').clientWidth]")
        self.assertAlmostEqual(size[0] / size[1], 0.5, delta=0.02)
        # The root covers its radicand, and the index hangs below the exponent.
        box = ("(() => { const of = (s) => { const r = document.querySelector(s).getBoundingClientRect(); return [r.left, r.top, r.right, r.bottom]; };"
               " return [of('.mk'), of('.mk .mp'), of('.mk .mp > :first-child'), of('.mk .mp > :last-child')]; })()")
        root, scripts, above, below = self.window.evaluate(box)
        self.assertTrue(root[0] <= scripts[0] and scripts[2] <= root[2] + 1 and root[1] <= scripts[1])
        self.assertLessEqual(above[3], below[1] + 1)
        player = "document.getElementById('player').contentDocument"
        self.wait("colours", f"{player} && {player}.getElementById('values') && !{player}.getElementById('values').hidden")
        self.assertEqual(self.window.evaluate(f"{player}.querySelector('#values .name').textContent"), "estimated error")
        self.window.click("#text a")
        self.assertEqual(self.window.text("#heading"), "Two")
        self.assertIn("a < b & c", self.window.text("#answers button:nth-child(2)"))
        self.window.click("#answers button:nth-child(1)")
        self.assertEqual(self.window.text("#reply"), "back")
        answers = self.saved()
        self.assertEqual(answers["pages"][1]["answers"][0]["answer"], "$\\frac{1}{2}$")
        (folder / "answers.json").write_text(json.dumps(answers))
        checked = subprocess.run([PROGRAM, "lesson", lesson, "--answers", folder / "answers.json"], capture_output=True, text=True)
        self.assertEqual(checked.returncode, 0, checked.stderr)
        self.window.click("#reply a")
        self.assertEqual(self.window.text("#heading"), "One")
        self.assertEqual(self.window.complaints, [])

    def test_the_lesson_on_quadrilaterals_shows_its_run_and_its_tasks(self):
        self.window = browser.Browser()
        self.addCleanup(self.window.close)
        path = self.write("13-quadrilaterals")
        lesson = json.loads(re.search(r'id="lesson">\n(.*?)\n</script>', path.read_text(), flags=re.S)[1])
        self.assertTrue(all("note" not in shown and "note" not in (shown["question"] or {}) for shown in lesson["pages"]))
        self.window.open(path)
        player = "document.getElementById('player').contentDocument"
        tasks = 0
        for shown in lesson["pages"]:
            self.wait("player", f"{player} && {player}.getElementById('caption') && {player}.getElementById('caption').textContent !== ''")
            question = shown["question"]
            if question and question.get("done") and question["show"]:
                self.wait("answer", "document.getElementById('show').click() || document.getElementById('reply').className === 'right'")
                tasks += 1
            self.window.click("#following")
        self.assertGreaterEqual(tasks, 2)
        self.assertEqual(self.window.complaints, [])

    def test_a_candidate_is_chosen_by_a_click(self):
        self.window = browser.Browser()
        self.addCleanup(self.window.close)
        self.window.open(self.write("2-ten-steps"))
        for _ in range(2):
            self.window.click("#following")
        rows = "document.getElementById('player').contentDocument.querySelectorAll('#candidates tbody tr')"
        self.wait("candidates", rows + ".length > 1")
        wrong = self.window.evaluate(f"[...{rows}].findIndex((row) => row.lastChild.className !== 'accepted')")
        self.window.evaluate(f"{rows}[{wrong}].click()")
        self.wait("reply", "document.getElementById('reply').className === 'wrong'")
        for k in range(self.window.evaluate(rows + ".length")):
            self.window.evaluate(f"{rows}[{k}] && {rows}[{k}].click()")
        self.wait("answer", "document.getElementById('reply').className === 'right'")
        self.assertEqual(self.window.complaints, [])


if __name__ == "__main__":
    if browser.program() is None:
        print("no browser found")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *sys.argv[1:]])
