"""Checks that the editor starts threads only in ui/background, so that each worker is in the BackgroundList of its window,
which knows from it when it is at rest. Usage: test_threads.py ROOT"""
import re
import sys
from pathlib import Path

THREAD = re.compile(r"\bstd::(jthread|thread|async|packaged_task)\b|\bLeavableThread\(|make_unique<LeavableThread>|\bpthread_create\b")
# The others, and why they need no place in the list.
OTHERS = {
    "ui/platform/x11_clipboard.hpp": "answers other programs; the window awaits nothing of it",
    "ui/platform/x11_clipboard.cpp": "the same",
    "ui/dialogs/open_mesh.cpp": "computes the outline beside the figures, within a background task",
}


def main():
    root = Path(sys.argv[1])
    faults, allowed = [], set()
    for path in sorted((root / "ui").rglob("*.[ch]pp")):
        name = path.relative_to(root).as_posix()
        if name.startswith("ui/background/"):
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if THREAD.search(line.partition("//")[0]):
                allowed.add(name)
                if name not in OTHERS:
                    faults.append(f"{name}:{number}: starts a thread of its own; use Latest or BackgroundTask of ui/background")
    faults += [f"{name} starts no thread; remove it from this test" for name in sorted(OTHERS.keys() - allowed)]
    print("\n".join(faults) if faults else "threads start only in ui/background")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
