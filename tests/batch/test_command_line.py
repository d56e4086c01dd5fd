#!/usr/bin/env python3
"""Several inputs, files of options, completion and the manual page: what scripts and shells use of the batch program.

    test_command_line.py PROGRAM [NAME OF A TEST...]
"""

import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv.pop(1))
SAMPLES = pathlib.Path(__file__).parents[2] / "assets" / "samples"
SQUARE = "4 2 0 0\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n4 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n0\n"


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        for name in ("a.poly", "b.poly"):
            self.write(name, SQUARE)

    def write(self, name, text):
        path = self.path / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)

    def call(self, *words, code=0):
        done = subprocess.run([PROGRAM, *map(str, words)], cwd=self.path, capture_output=True, text=True, timeout=300,
                              stdin=subprocess.DEVNULL)
        self.assertEqual(done.returncode, code, f"{words}\n{done.stdout}\n{done.stderr}")
        return done

    def names(self):
        return {path.name for path in self.path.iterdir()}


class SeveralInputs(Case):
    def test_each_input_has_its_outputs(self):
        done = self.call("mesh", "a.poly", "b.poly", "-o", "{}.vtu", "-o", "{}-2.msh", "--stats", "{}.json", "--size", "1")
        self.assertIn("a.poly:\nwrote a.vtu\nwrote a-2.msh\n", done.stdout)
        self.assertIn("\nb.poly:\nwrote b.vtu\nwrote b-2.msh\n", done.stdout)
        self.assertEqual(json.loads((self.path / "a.json").read_text())["hash"],
                         json.loads((self.path / "b.json").read_text())["hash"])
        self.call("convert", "a.vtu", "b.vtu", "-o", "{}.su2")
        self.assertLess({"a.su2", "b.su2", "a-2.msh", "b-2.msh"}, self.names())
        self.call("mesh", "a.poly", "-o", "only-{}.vtu", "-q")
        self.assertIn("only-a.vtu", self.names())

    def test_the_worst_exit_code_counts_and_the_others_are_done(self):
        self.write("bad.poly", "nonsense\n")
        done = self.call("mesh", "bad.poly", "a.poly", "missing.poly", "b.poly", "-o", "{}.vtu", code=1)
        self.assertIn("bad.poly:1:", done.stderr)
        self.assertIn("missing.poly: error: cannot read", done.stderr)
        self.assertIn("2 of 4 inputs refused: bad.poly, missing.poly\n", done.stderr)
        self.assertLess({"a.vtu", "b.vtu"}, self.names())

    def test_names_that_meet_are_refused_before_anything_is_written(self):
        self.write("inner/a.poly", SQUARE)
        before = self.names()
        self.assertIn("two outputs to one file",
                      self.call("mesh", "a.poly", "inner/a.poly", "-o", "{}.vtu", code=1).stderr)
        self.assertIn("put {}", self.call("mesh", "a.poly", "b.poly", "-o", "x.vtu", code=2).stderr)
        self.assertIn("put {}", self.call("mesh", "a.poly", "b.poly", "-o", "{}.vtu", "--stats", "s.json", code=2).stderr)
        self.assertIn("standard input", self.call("mesh", "-", "a.poly", "-o", "{}.vtu", code=2).stderr)
        self.assertIn("has no name", self.call("convert", "-", "-o", "{}.vtu", code=2).stderr)
        self.assertEqual(self.names(), before)


class ConfigFiles(Case):
    def hash(self, *words):
        return json.loads(self.call("mesh", "a.poly", "--stats", "-", *words).stdout)["hash"]

    def test_a_file_sets_options_and_the_command_line_wins(self):
        self.write("inner/a.toml", 'size = 0.5\nverify = true\nquiet = false\noutput = ["c.vtu", "c.msh"]\n'
                                   '[mesh]\nimprove = "none"\n[convert]\ntriangles = true\n')
        done = self.call("mesh", "a.poly", "--config", "inner/a.toml")
        self.assertIn("wrote inner/c.vtu\nwrote inner/c.msh\n", done.stdout)
        expected = self.hash("--size", "0.5", "--improve", "none")
        self.assertEqual(self.hash("--config=inner/a.toml"), expected)
        self.assertEqual(self.hash("--size", "1", "--config", "inner/a.toml"), self.hash("--size", "1", "--improve", "none"))
        self.assertEqual(self.hash("--config", "inner/a.toml", "--spacing", "1"),  # replaces size, which excludes it
                         self.hash("--improve", "none", "--spacing", "1"))
        self.assertNotEqual(self.hash("--improve", "default", "--config", "inner/a.toml"), expected)

    def test_parameters_are_a_table(self):
        self.write("r.toml", "[set]\nr = 6\nd = '2*15'\n")
        bracket = SAMPLES / "bracket.json"
        by_file = self.call("mesh", bracket, "--stats", "-", "--config", "r.toml")
        by_words = self.call("mesh", bracket, "--stats", "-", "--set", "r=6", "--set", "d=30")
        self.assertEqual(json.loads(by_file.stdout)["hash"], json.loads(by_words.stdout)["hash"])

    def test_faults_have_their_line_and_a_suggestion(self):
        for text, expected in (("\nsze = 1\n", "c.toml:2:1: error: unknown option 'sze' of forefront mesh; did you mean size?"),
                               ("config = 'x'", "unknown option 'config'"),
                               ("[mehs]\nsize = 1", "did you mean mesh?"),
                               ("mesh = 1", "expected a table"),
                               ("verify = 1", "c.toml:1:10: error: verify: expected true or false"),
                               ("size = [1, 2]", "size: expected a number or a text"),
                               ("size = 2020-01-01", "size: expected a number or a text"),
                               ("size = -1", "c.toml:1: --size: expected a positive number, got '-1'"),
                               ("[mesh]\nmethod = 'fats'", "c.toml:2: --method: expected one of fast, classic, got 'fats'; "
                                                           "did you mean fast?"),
                               ("size = \n", "c.toml:1:8: error: "),
                               ("size = 1\nsize = 2\n", "[toml-syntax]")):
            self.write("c.toml", text)
            self.assertIn(expected, self.call("mesh", "a.poly", "-o", "a.vtu", "--config", "c.toml", code=2).stderr, text)
        self.assertIn("none.toml: error: cannot read", self.call("mesh", "a.poly", "--config", "none.toml", code=2).stderr)
        self.assertNotIn("a.vtu", self.names())


class DryRuns(Case):
    def test_estimates_are_near_the_meshes(self):
        for sample in (SAMPLES / f"{name}.json" for name in ("spiral", "wing", "flap", "lake", "snowflake", "bracket")):
            with self.subTest(sample.stem):
                told = json.loads(self.call("mesh", sample, "--dry-run", "--json", "-q").stdout)
                made = json.loads(self.call("mesh", sample, "--stats", "-", "-q").stdout)
                self.assertLess(abs(told["elements"] / made["elements"] - 1), 0.15)
                self.assertLess(abs(told["nodes"] / made["nodes"] - 1), 0.15)

    def test_nothing_is_written_and_faults_are_told(self):
        before = self.names()
        done = self.call("mesh", "a.poly", "b.poly", "-o", "{}.vtu", "--size", "0.1", "--dry-run")
        self.assertRegex(done.stdout, r"^a.poly:\nabout \S+ elements, \S+ nodes, 140 boundary edges\nabout \S+ MB of memory, ")
        self.assertIn("[too-many-elements]", self.call("mesh", "a.poly", "--dry-run", "--size", "1e-6", code=1).stderr)
        self.call("mesh", "a.poly", "--json", "-o", "a.vtu", code=2)
        self.assertEqual(self.names(), before)


class Telling(Case):
    def test_statistics_name_program_input_and_bounds(self):
        made = json.loads(self.call("mesh", "a.poly", "-o", "a.msh", "--stats", "-", "--size", "1").stdout)
        self.assertEqual((made["input"], made["bounds"]), ("a.poly", [0, 0, 4, 3]))
        checked = json.loads(self.call("check", "a.msh", "--stats", "-").stdout)
        for key in ("version", "bounds", "boundaries", "regions", "area"):
            self.assertEqual(made[key], checked[key])

    def test_the_program_starts_within_15_ms(self):
        def seconds():
            used = resource.getrusage(resource.RUSAGE_CHILDREN)
            return used.ru_utime + used.ru_stime

        times = []
        for _ in range(10):
            before = seconds()
            self.call("--version")
            times.append(seconds() - before)
        self.assertLess(min(times), 0.015)

    def test_mistyped_names_get_a_suggestion(self):
        for words, code, expected in (
                (("mesh", "a.poly", "-o", "a.msh", "--format", "msh3"), 2, "did you mean msh2?"),
                (("mesh", "a.poly", "-o", "a.vut"), 2, "did you mean .vtu?"),
                (("mesh", "a.poly", "-o", "a.vtu", "--input-format", "ploy"), 2, "did you mean poly?"),
                (("mesh", "a.poly", "-o", "a.vtu", "--grid", "unifrom"), 2, "did you mean uniform?"),
                (("mesh", "a.poly", "-o", "a.vtu", "--layers", "boundary1:first=0.1,count=2"), 1,
                 "did you mean boundary_1?"),
                (("mesh", "a.poly", "-o", "a.vtu", "--layers", "boundary_1:frist=0.1"), 2, "did you mean first?"),
                (("mesh", "a.poly", "-o", "a.14", "--open", "bundary_1"), 1, "did you mean boundary_1?")):
            self.assertIn(expected, self.call(*words, code=code).stderr)


class Shells(Case):
    def completed(self, *words):
        """The words that bash offers for the last one."""
        self.write("completion", self.call("completion", "bash").stdout)
        script = ('source ./completion; compopt() { :; }; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _forefront; '
                  'printf "%s\\n" "${COMPREPLY[@]}"')
        done = subprocess.run(["bash", "-c", script, "bash", *words], cwd=self.path, capture_output=True, text=True,
                              check=True, timeout=60)
        self.assertEqual(done.stderr, "")
        return done.stdout.split()

    def test_bash_completes_commands_options_and_values(self):
        self.assertEqual(self.completed("forefront", "me"), ["mesh"])
        self.assertEqual(self.completed("forefront", "vi"), ["view"])
        self.assertEqual(self.completed("forefront", "mesh", "--imp"), ["--improve"])
        self.assertEqual(self.completed("forefront", "mesh", "--method", ""), ["fast", "classic"])
        self.assertEqual(self.completed("forefront", "mesh", "--method", "=", "c"), ["classic"])
        self.assertEqual(self.completed("forefront", "convert", "--format", "msh4"), ["msh41", "msh41-binary"])
        self.assertEqual(self.completed("forefront", "completion", ""), ["bash", "zsh", "fish"])
        self.assertEqual(self.completed("forefront", "mesh", "a"), [])  # a file: bash finds it

    def test_every_option_of_the_help_is_completed(self):
        for command in ("mesh", "check", "film"):
            listed = set(self.completed("forefront", command, "--"))
            for line in self.call("help", command).stdout.splitlines():
                for word in re.findall(r"--[a-z-]+", (line[2:].split("  ")[0]) if line.startswith("  -") else ""):
                    self.assertIn(word, listed)

    def test_other_shells_accept_their_scripts(self):
        self.assertIn("-l method", self.call("completion", "fish").stdout)
        self.assertTrue(self.call("completion", "zsh").stdout.startswith("#compdef forefront\n"))
        for shell in ("zsh", "fish"):
            if shutil.which(shell):
                self.write("script", self.call("completion", shell).stdout)
                done = subprocess.run([shell, "-n", "script"], cwd=self.path, capture_output=True, text=True, timeout=60)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("expected one of bash, zsh, fish", self.call("completion", "tcsh", code=2).stderr)

    def test_the_manual_page_has_every_command_and_is_well_formed(self):
        page = self.call("help", "--man").stdout
        for command in ("mesh", "check", "adapt", "convert", "info", "film", "completion"):
            self.assertIn(f"\n.SS {command}\n", page)
        self.assertIn("\\fB\\-\\-keep\\-boundary\\fR", page)
        self.write("forefront.1", page)
        if shutil.which("man"):
            done = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "forefront.1"], cwd=self.path,
                                  capture_output=True, text=True, timeout=60)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
        if shutil.which("mandoc"):
            done = subprocess.run(["mandoc", "-T", "lint", "-W", "error", "forefront.1"], cwd=self.path,
                                  capture_output=True, text=True, timeout=60)
            self.assertEqual((done.returncode, done.stdout), (0, ""))

    def test_help_prints_the_help_of_a_command(self):
        self.assertEqual(self.call("help", "mesh").stdout, self.call("mesh", "--help").stdout)
        self.assertEqual(self.call("help").stdout, self.call("--help").stdout)
        self.assertIn("did you mean mesh?", self.call("help", "mehs", code=2).stderr)


if __name__ == "__main__":
    unittest.main()
