"""Areas by region, as ANUGA sets them: nested regions of maximum areas 1000, 100, 36 and 8, angles of at least 30 degrees."""
import numpy as np

import forefront.compat.triangle as triangle


def box(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


boxes = [box(0, 0, 1000, 800), box(150, 150, 850, 650), box(300, 250, 700, 550), box(420, 330, 580, 470)]
graph = {
    "vertices": np.concatenate(boxes),
    "segments": [(4 * k + i, 4 * k + (i + 1) % 4) for k in range(4) for i in range(4)],
    "regions": [(10, 10, 1, 1000), (160, 160, 2, 100), (310, 260, 3, 36), (430, 340, 4, 8)],
}
result = triangle.triangulate(graph, "pzq30aA")
corner = result["vertices"][result["triangles"]]
u, v = corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]
area = 0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
for x, y, number, limit in graph["regions"]:
    largest = area[result["triangle_attributes"].ravel() == number].max()
    print(f"region {number}: every area is at most {limit}: {bool(largest <= limit)}")
sides = [np.hypot(*(corner[:, k] - corner[:, k - 1]).T) for k in range(3)]
cosines = [(sides[k - 1]**2 + sides[k - 2]**2 - sides[k]**2) / (2*sides[k - 1]*sides[k - 2]) for k in range(3)]
least = np.degrees(np.arccos(np.max(cosines)))
print(f"every angle is at least 30 degrees: {bool(least >= 30)}")
#-> region 1: every area is at most 1000: True
#-> region 2: every area is at most 100: True
#-> region 3: every area is at most 36: True
#-> region 4: every area is at most 8: True
#-> every angle is at least 30 degrees: True
