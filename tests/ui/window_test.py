#!/usr/bin/env python3
"""Drives the real window as a user would, with xdotool under Xvfb: draws a square with a hole, copies and pastes, paints,
meshes, steps back three times, exports, and checks the exported file. It never sleeps for a fixed time, but waits for the
state that the program writes after each frame. Usage: window_test.py FOREFRONT. Exit code 77: a tool is missing."""
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

TIMEOUT = 500.0  # seconds; below CTest's limit, so that a hang is reported with the state
SKIPPED = 77


class Failure(Exception):
    pass


class Window:
    def __init__(self, program, folder):
        self.folder = Path(folder)
        self.state_file = self.folder / "state.json"
        read, write = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x800x24", "-nolisten", "tcp"],
                                       pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            display = pipe.readline().strip()
        if not display:
            raise Failure("Xvfb does not start")
        self.env = dict(os.environ, DISPLAY=":" + display, HOME=str(folder), XDG_CONFIG_HOME=str(self.folder / "config"),
                        XDG_STATE_HOME=str(self.folder / "state"), LIBGL_ALWAYS_SOFTWARE="1")
        self.program = subprocess.Popen([program, "--state-file", str(self.state_file)], env=self.env, cwd=folder)
        self.seen = -1
        self.wait("the first frames", lambda s: s["frame"] >= 3 and s["settled"])
        self.xdotool("search", "--sync", "--name", "Forefront", "windowfocus")

    def close(self):
        for process in (self.program, self.server):
            if process.poll() is None:
                process.terminate()
                try:
                    process.wait(20)
                except subprocess.TimeoutExpired:
                    process.kill()

    def xdotool(self, *words):
        subprocess.run(["xdotool", *map(str, words)], env=self.env, check=True, timeout=TIMEOUT, stdout=subprocess.DEVNULL)

    def state(self):
        try:
            return json.loads(self.state_file.read_text())
        except (OSError, ValueError):
            return None

    def wait(self, what, condition):
        end = time.monotonic() + TIMEOUT
        while time.monotonic() < end:
            if self.program.poll() is not None:
                raise Failure(f"the program ended with {self.program.returncode} while waiting for {what}")
            state = self.state()
            if state is not None and condition(state):
                return state
            time.sleep(0.01)
        raise Failure(f"timeout while waiting for {what}; state {json.dumps(self.state())[:3000]}")

    def widget(self, name):
        """Returns the middle of a widget once its rectangle no longer moves."""
        last = {}

        def still(state):
            rect = state["widgets"].get(name)
            before = last.get("rect")
            last["rect"] = rect
            return rect is not None and rect == before and rect[4] == 1 and state["settled"]

        x, y, width, height, _ = self.wait(f"widget {name}", still)["widgets"][name]
        return x + width // 2, y + height // 2

    def number(self):
        found = subprocess.run(["xdotool", "search", "--name", "Forefront"], env=self.env, check=True, timeout=TIMEOUT,
                               capture_output=True, text=True)
        return found.stdout.split()[-1]

    def geometry(self):
        """Returns x, y, width and height on the screen."""
        shown = subprocess.run(["xdotool", "getwindowgeometry", "--shell", self.number()], env=self.env, check=True,
                               timeout=TIMEOUT, capture_output=True, text=True)
        values = dict(line.split("=") for line in shown.stdout.split())
        return tuple(int(values[key]) for key in ("X", "Y", "WIDTH", "HEIGHT"))

    def wait_geometry(self, expected):
        end = time.monotonic() + TIMEOUT
        while self.geometry() != expected:
            if time.monotonic() > end:
                raise Failure(f"the window is at {self.geometry()}, not at {expected}")
            time.sleep(0.02)

    def click(self, name):
        self.xdotool("mousemove", *self.widget(name), "click", 1)

    def key(self, name):
        self.xdotool("key", name)

    def clipboard(self, form):
        """Returns what is on the clipboard in a form, or nothing."""
        taken = subprocess.run(["xclip", "-selection", "clipboard", "-target", form, "-out"], env=self.env, check=False,
                               timeout=TIMEOUT, capture_output=True, text=True)
        return taken.stdout

    def offer(self, form, text):
        """Puts a text on the clipboard as another program would, in one form."""
        subprocess.run(["xclip", "-selection", "clipboard", "-target", form, "-in"], env=self.env, check=True,
                       timeout=TIMEOUT, input=text, text=True, stdout=subprocess.DEVNULL)

    def drag(self, start, end):
        self.xdotool("mousemove", *start, "mousedown", 1)
        for part in range(1, 6):
            self.xdotool("mousemove", *(round(a + (b - a) * part / 5) for a, b in zip(start, end)))
        self.xdotool("mouseup", 1)


def position(state):
    """Returns the position on the timeline: advances, then steps of the improvement."""
    return state["run"]["advance"] + state["run"]["improveStep"]


def run(program, folder):
    window = Window(program, folder)
    try:
        print("creating a new document")
        window.key("ctrl+n")
        window.wait("an empty document", lambda s: s["shapes"] == 0)
        x, y, width, height, _ = window.state()["widgets"]["canvas"]
        middle = (x + width // 2, y + height // 2)

        def around(size):
            return (middle[0] - size, middle[1] - size), (middle[0] + size, middle[1] + size)

        print("drawing a square with a hole")
        window.key("r")
        window.wait("the rectangle tool", lambda s: s["tool"] == "rectangle")
        window.drag(*around(220))
        window.wait("one shape", lambda s: s["shapes"] == 1)
        window.drag(*around(60))
        window.wait("two shapes", lambda s: s["shapes"] == 2)

        print("copying a drawing to another program, and from it")
        window.key("ctrl+a")
        window.key("ctrl+c")
        end = time.monotonic() + TIMEOUT
        while "<path" not in (copied := window.clipboard("image/svg+xml")) and time.monotonic() < end:
            time.sleep(0.02)
        if copied.count("<path") != 2 or window.clipboard("UTF8_STRING") != copied:
            raise Failure(f"the clipboard holds {copied[:300]!r}")
        drawn = window.state()["revision"]
        window.offer("image/svg+xml", '<svg xmlns="http://www.w3.org/2000/svg"><rect width="2" height="1"/></svg>')
        window.key("ctrl+v")
        window.wait("the shape of the other program", lambda s: s["shapes"] == 3)
        window.key("ctrl+z")
        window.wait("its removal", lambda s: s["revision"] == drawn and s["shapes"] == 2)

        print("typing a size and undoing it")
        window.key("ctrl+2")
        window.wait("the workspace Size", lambda s: s["workspace"] == "size")
        drawn = window.state()["revision"]
        window.click("spacing/size")
        window.xdotool("type", "--delay", "15", "0.9")
        window.key("Tab")
        window.wait("the size to be taken", lambda s: s["revision"] != drawn)
        window.key("ctrl+z")
        window.wait("the size to be taken back", lambda s: s["revision"] == drawn and s["shapes"] == 2)

        print("painting")
        window.key("b")
        window.wait("the brush", lambda s: s["tool"] == "brush")
        window.drag((middle[0] - 150, middle[1] - 120), (middle[0] - 60, middle[1] - 120))
        window.wait("paint", lambda s: s["paintedTiles"] > 0)

        print("meshing")
        live = window.wait("the live mesh", lambda s: s["run"]["state"] == "finished" and s["settled"])["run"]["number"]
        window.key("2")
        done = window.wait("the mesh", lambda s: s["run"]["number"] > live and s["run"]["state"] == "finished")
        if done["run"]["elements"] < 20:
            raise Failure(f"only {done['run']['elements']} elements")

        print("stepping back three times")
        for _ in range(3):
            before = position(window.state())
            window.key("comma")
            window.wait("a step back", lambda s: position(s) == before - 1)
        back = window.state()["run"]
        if back["advance"] + back["improveStep"] != back["known"] + back["improveSteps"] - 3:
            raise Failure(f"not three steps before the end: {back}")

        print("exporting")
        target = Path(folder) / "square.msh"
        window.key("ctrl+e")
        window.wait("the dialog", lambda s: s["dialog"] == "export")
        window.click("dialog/export/name")
        window.key("ctrl+a")
        window.xdotool("type", "--delay", "15", str(target))
        window.click("dialog/export/ok")
        end = time.monotonic() + TIMEOUT
        while not target.exists() and time.monotonic() < end:
            time.sleep(0.01)
        if not target.exists():
            raise Failure(f"no file was exported; state {json.dumps(window.state())[:3000]}")
        window.wait("the dialog to close", lambda s: s["dialog"] == "")
        text = target.read_text()
        if "$Elements" not in text:
            raise Failure("the exported file is not an MSH file")
        check = subprocess.run([program, "check", str(target)], capture_output=True, text=True, timeout=TIMEOUT, check=False)
        print(check.stdout + check.stderr, end="")
        if check.returncode != 0:
            raise Failure(f"forefront check exits with {check.returncode}")

        print("quitting")
        window.key("ctrl+q")
        window.wait("the question about unsaved changes", lambda s: s["dialog"] != "")
    finally:
        window.close()


def remember_place(program, folder):
    """The window reopens with the position and size it was closed with, and has a minimum size."""
    place = (90, 40, 1010, 640)
    window = Window(program, folder)
    try:
        print("moving and resizing the window")
        window.key("ctrl+n")
        window.wait("an empty document", lambda s: s["shapes"] == 0)
        window.xdotool("windowsize", window.number(), *place[2:])
        window.xdotool("windowmove", window.number(), *place[:2])
        window.wait_geometry(place)
        window.wait("the canvas to follow", lambda s: s["settled"] and s["widgets"]["canvas"][2] < place[2])
        hints = subprocess.run(["xprop", "-id", window.number(), "WM_NORMAL_HINTS"], env=window.env, check=True,
                               timeout=TIMEOUT, capture_output=True, text=True).stdout
        if "program specified minimum size: 800 by 500" not in hints:
            raise Failure(f"no minimum size: {hints}")
        window.key("ctrl+q")
        window.program.wait(TIMEOUT)
    finally:
        window.close()
    print("opening it again")
    window = Window(program, folder)
    try:
        window.wait_geometry(place)
    finally:
        window.close()


def main():
    for tool in ("Xvfb", "xdotool", "xclip", "xprop"):
        if shutil.which(tool) is None:
            print(f"skipped: {tool} is not installed")
            return SKIPPED
    try:
        with tempfile.TemporaryDirectory() as folder:
            program = str(Path(sys.argv[1]).resolve(strict=True))
            run(program, folder)
        with tempfile.TemporaryDirectory() as folder:
            remember_place(program, folder)
    except (Failure, OSError, subprocess.SubprocessError) as failure:
        print(f"FAILED: {failure}")
        return 1
    print("passed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
