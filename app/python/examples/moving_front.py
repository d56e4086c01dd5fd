"""A run, advance by advance: the length of the front, and a page that plays the run in a browser."""
from pathlib import Path

import numpy as np

import forefront as ff

run = ff.run([(0, 0), (4, 0), (4, 2), (0, 2)], 1.0, method="classic")
for moment in run:
    if moment.position in (1, 5, 10):
        length = np.hypot(*np.diff(moment.front, axis=1)[:, 0].T).sum()
        print(f"advance {moment.position}: {len(moment.front)} segments, length {length:.0f}")
Path("run.html").write_text(run.page(title="A rectangle"))
print(f"the front is empty: {run.at_end}")
#-> advance 1: 11 segments, length 11
#-> advance 5: 11 segments, length 12
#-> advance 10: 10 segments, length 13
#-> the front is empty: True
