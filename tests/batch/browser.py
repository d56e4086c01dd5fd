"""A headless Chromium driven over its debugging pipe, with nothing but the standard library."""

import base64
import json
import os
import pathlib
import select
import shutil
import subprocess
import tempfile
import time

NAMES = ["chromium", "chromium-browser", "google-chrome"]


def program():
    return next((path for path in map(shutil.which, NAMES) if path), None)


class Browser:
    """A page of fixed size. Messages of its console and errors of its scripts are in `complaints`."""

    def __init__(self, width=1280, height=800, scale=1.0):
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        to_browser, self.output = os.pipe()
        self.input, from_browser = os.pipe()
        os.set_inheritable(to_browser, True)
        os.set_inheritable(from_browser, True)

        def give_pipes():
            os.dup2(to_browser, 93)
            os.dup2(from_browser, 94)
            os.dup2(93, 3)
            os.dup2(94, 4)
        self.process = subprocess.Popen(
            [program(), "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--remote-debugging-pipe",
             "--disable-dev-shm-usage", "--no-first-run", "--disable-extensions", "--disable-background-networking",
             f"--user-data-dir={self.folder.name}", f"--window-size={width},{height}",
             f"--force-device-scale-factor={scale}", "about:blank"],
            preexec_fn=give_pipes, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.buffer, self.last, self.complaints, self.loaded, self.opened = b"", 0, [], 0, 0
        target = next(t for t in self.send("Target.getTargets")["targetInfos"] if t["type"] == "page")
        attached = self.send("Target.attachToTarget", targetId=target["targetId"], flatten=True)
        self.session = attached["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.send(domain + ".enable")
        self.send("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=scale, mobile=False)

    def close(self):
        self.process.kill()
        self.process.wait()
        os.close(self.output)
        os.close(self.input)
        self.folder.cleanup()

    def read(self, seconds):
        deadline = time.monotonic() + seconds
        while b"\0" not in self.buffer:
            if not select.select([self.input], [], [], max(0.0, deadline - time.monotonic()))[0]:
                raise TimeoutError("the browser does not answer")
            data = os.read(self.input, 1 << 16)
            if not data:
                raise ConnectionError("the browser has ended")
            self.buffer += data
        text, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(text)

    def send(self, method, **parameters):
        self.last += 1
        message = {"id": self.last, "method": method, "params": parameters}
        if getattr(self, "session", None):
            message["sessionId"] = self.session
        os.write(self.output, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.read(60)
            if answer.get("id") == self.last:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]
            self.notice(answer)

    def notice(self, event):
        parameters = event.get("params", {})
        if event.get("method") == "Runtime.exceptionThrown":
            details = parameters["exceptionDetails"]
            self.complaints.append(details.get("exception", {}).get("description", details["text"]))
        elif event.get("method") == "Runtime.consoleAPICalled":
            self.complaints.append("console: " + " ".join(str(a.get("value")) for a in parameters["args"]))
        elif event.get("method") == "Log.entryAdded" and "readback" not in parameters["entry"]["text"]:  # by the tests
            self.complaints.append("log: " + parameters["entry"]["text"])
        elif event.get("method") == "Page.loadEventFired":
            self.loaded += 1

    def open(self, path, fragment=""):
        """Loads a page. The query makes each address new: another fragment alone would not load it again."""
        before = self.loaded
        self.opened += 1
        self.send("Page.navigate", url=f"{pathlib.Path(path).resolve().as_uri()}?{self.opened}{fragment}")
        deadline = time.monotonic() + 60
        while self.loaded == before:
            if time.monotonic() > deadline:
                raise TimeoutError(f"{path} does not load")
            self.evaluate("new Promise((done) => setTimeout(done, 20))")
        self.settle()

    def evaluate(self, script):
        result = self.send("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(result["exceptionDetails"])
        return result["result"].get("value")

    def settle(self):
        """Waits until nothing moves: longer than the longest motion of the page, and for a frame."""
        self.evaluate("new Promise((done) => setTimeout(() => requestAnimationFrame(() => done(1)), 300))")

    def text(self, selector):
        return self.evaluate(f"document.querySelector({json.dumps(selector)}).textContent")

    def key(self, key, code=None, shift=False):
        for kind in ("keyDown", "keyUp"):
            self.send("Input.dispatchKeyEvent", type=kind, key=key, code=code or key, modifiers=8 if shift else 0,
                      **({"text": key} if kind == "keyDown" and len(key) == 1 else {}))
        self.settle()

    def mouse(self, kind, x, y, **more):
        self.send("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def click(self, selector):
        x, y = self.evaluate(f"(() => {{ const r = document.querySelector({json.dumps(selector)}).getBoundingClientRect();"
                             " return [r.x + r.width / 2, r.y + r.height / 2]; })()")
        for kind in ("mousePressed", "mouseReleased"):
            self.mouse(kind, x, y, button="left", clickCount=1)
        self.settle()

    def drag(self, start, end):
        self.mouse("mousePressed", *start, button="left", clickCount=1)
        for k in range(1, 6):
            self.mouse("mouseMoved", *(s + (e - s) * k / 5 for s, e in zip(start, end)), button="left", buttons=1)
        self.mouse("mouseReleased", *end, button="left", clickCount=1)
        self.settle()

    def picture(self):
        """Returns the window as PNG bytes."""
        return base64.b64decode(self.send("Page.captureScreenshot", format="png")["data"])
