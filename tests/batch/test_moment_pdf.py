#!/usr/bin/env python3
"""PDF pages of moments, read by poppler: text stays text, and the page looks as the PNG does. Exit code 77 without it.

    test_moment_pdf.py PROGRAM [NAME OF A TEST...]
"""

import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
import zlib

PROGRAM = os.path.abspath(sys.argv.pop(1))
DRAWINGS = pathlib.Path(__file__).resolve().parents[2] / "assets/lessons/drawings"
READERS = ["pdfinfo", "pdftotext", "pdftoppm"]


def read_ppm(data):
    """Returns width, height and the bytes of red, green and blue of a binary PPM."""
    width, height, _ = map(int, data.split(maxsplit=4)[1:4])
    return width, height, data[-3 * width * height:]


def read_png(data):
    """The same of a PNG of this program: a palette of 8 bits, rows without filters."""
    width, height, depth, kind = struct.unpack(">IIBB", data[16:26])
    assert (depth, kind) == (8, 3)
    parts, at = {}, 8
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at:at + 8])
        parts[name] = parts.get(name, b"") + data[at + 8:at + 8 + length]
        at += 12 + length
    rows, palette = zlib.decompress(parts[b"IDAT"]), parts[b"PLTE"]
    colours = []
    for y in range(height):
        row = rows[y * (width + 1):(y + 1) * (width + 1)]
        assert row[0] == 0
        colours.append(b"".join(palette[3 * k:3 * k + 3] for k in row[1:]))
    return width, height, b"".join(colours)


class Pages(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def film(self, name, *words):
        subprocess.run([PROGRAM, "film", DRAWINGS / "ring.json", "-o", self.path / name, "--method", "classic", *words],
                       check=True, stdout=subprocess.DEVNULL)
        return self.path / name

    def read(self, program, *words):
        done = subprocess.run([program, *words], capture_output=True, check=True)
        self.assertEqual(done.stderr, b"", program)  # it warns of what is not as it should be
        return done.stdout

    def words(self, page):
        """Returns the words of a page with their boxes, in points from the upper left corner."""
        text = self.read("pdftotext", "-bbox", page, "-").decode()
        text = text[text.index("<page"):text.index("</doc>")]
        root = ElementTree.fromstring(text)
        box = {key: float(value) for key, value in root.attrib.items()}
        return box, [(word.text, *(float(word.get(key)) for key in ("xMin", "yMin", "xMax", "yMax"))) for word in root]

    def test_the_page_has_the_size_of_the_picture(self):
        for width in (400, 800, 1234):
            page = self.film("m.pdf", "--at", "12", "--labels", "--width", str(width))
            height = int(re.search(r'<svg [^>]*height="(\d+)"', self.film("m.svg", "--at", "12", "--labels",
                                                                              "--width", str(width)).read_text())[1])
            said = self.read("pdfinfo", page).decode()
            self.assertEqual(int(re.search(r"Pages: *(\d+)", said)[1]), 1)
            found = re.search(r"Page size: *([\d.]+) x ([\d.]+) pts", said)
            self.assertAlmostEqual(float(found[1]), 0.75 * width, delta=0.01)  # 96 pixels per inch
            self.assertAlmostEqual(float(found[2]), 0.75 * height, delta=0.01)

    def test_labels_and_caption_stay_text_at_their_places(self):
        page = self.film("m.pdf", "--at", "12", "--labels")
        drawing = self.film("m.svg", "--at", "12", "--labels").read_text()
        box, words = self.words(page)
        labels = re.findall(r'<text x="([\d.]+)" y="([\d.]+)"[^>]* data-x="[^"]*"[^>]*>([^<]+)</text>', drawing)
        self.assertGreaterEqual(len(labels), 4)
        for x, y, text in labels:
            x, y, first = 0.75 * float(x), 0.75 * float(y), text.split()[0]
            near = [word for word in words if word[0] == first and abs(word[1] - x) < 1 and word[2] < y < word[4] + 1]
            self.assertEqual(len(near), 1, text)
            self.assertLessEqual(near[0][3], box["width"])
        caption = " ".join(re.findall(r'font-size="13"[^>]*>([^<]+)</text>', re.sub(r"<text[^>]*data-x.*", "", drawing)))
        read = " ".join(self.read("pdftotext", "-raw", page, "-").decode().split())
        self.assertIn("Advance 12, ", read)
        self.assertIn(" ".join(caption.split())[:40], read)

    def test_greek_letters_and_arrows_are_read_as_such(self):
        advances = 0
        page = self.film("raw.pdf")  # of the improved mesh
        self.assertRegex(self.read("pdftotext", page, "-").decode(), r"Improvement (\d+) of \1: ")
        while "Improvement 1 of " not in (text := self.read("pdftotext", "-raw", page, "-").decode()):
            advances += 1
            self.assertLess(advances, 200)
            page = self.film("step.pdf", "--at", str(80 + advances))
        text = " ".join(text.split())
        self.assertRegex(text, r"mean α 0\.\d+ → 0\.\d+, minimum angle \d+\.\d°")

    def test_it_looks_as_the_png_does(self):
        page = self.film("m.pdf", "--at", "40", "--layers", "mesh,boundary,front,candidates")
        width, height, wanted = read_png(self.film("m.png", "--at", "40", "--layers",
                                                   "mesh,boundary,front,candidates").read_bytes())
        data = self.read("pdftoppm", "-r", "96", page)
        self.assertEqual(read_ppm(data)[:2], (width, height))
        found = read_ppm(data)[2]
        pixels = range(0, len(wanted), 3)
        far = sum(1 for k in pixels if max(abs(found[k + i] - wanted[k + i]) for i in range(3)) > 60)
        self.assertLess(far, 0.01 * width * height)  # along the edges of lines
        for ink in ((217, 95, 2), (117, 40, 140), (219, 233, 246)):  # front, base, elements
            def count(colours, ink=bytes(ink)):
                return sum(1 for k in pixels if colours[k:k + 3] == ink)
            self.assertGreater(count(found), 20)
            self.assertLess(abs(count(found) - count(wanted)), 0.4 * count(wanted) + 50)


if __name__ == "__main__":
    if not all(map(shutil.which, READERS)):
        print("poppler's programs are not here")
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *sys.argv[1:]])
