"""The cases on which the meshers are compared: a polygon and the node spacing, in the syntax of each program."""

import math

RECTANGLE = [(0, 0), (60, 0), (60, 40), (0, 40)]
SLOPE = 0.232  # growth of the graded node spacing per unit of distance from the circle


class Case:
    """Spacing max(minimum, SLOPE | |p - (30, 20)| - 12 |) if graded, else minimum everywhere."""

    def __init__(self, polygon, minimum, graded):
        self.polygon = polygon
        self.minimum = minimum
        self.graded = graded
        self.maximum = 6 if graded else minimum  # an upper bound of the node spacing in the polygon

    @property
    def spacing(self):
        """The spacing as an expression for Forefront."""
        return f"max({self.minimum!r}, {self.off_circle})" if self.graded else repr(self.minimum)

    @property
    def off_circle(self):
        return f"{SLOPE}*abs(sqrt((x-30)^2+(y-20)^2)-12)"

    def rho(self, x, y):
        return max(self.minimum, SLOPE * abs(math.hypot(x - 30, y - 20) - 12)) if self.graded else self.minimum

    def samples(self):
        """Yields (x, y, rho) at the centres of cells no wider than half the smallest rho in them."""
        xs, ys = [p[0] for p in self.polygon], [p[1] for p in self.polygon]
        stack = [(min(xs), min(ys), max(max(xs) - min(xs), max(ys) - min(ys)))]
        while stack:
            x, y, width = stack.pop()
            half = width / 2
            rho = self.rho(x + half, y + half)
            if width > 0.5 * max(rho - SLOPE * math.sqrt(2) * half, self.minimum):
                stack += [(x, y, half), (x + half, y, half), (x, y + half, half), (x + half, y + half, half)]
            elif x + half <= max(xs) and y + half <= max(ys):
                yield x + half, y + half, rho

    def poly(self):
        """Returns the text of a Triangle .poly file."""
        count = len(self.polygon)
        lines = [f"{count} 2 0 0", *(f"{i} {x!r} {y!r}" for i, (x, y) in enumerate(self.polygon, 1)), f"{count} 1",
                 *(f"{i} {i} {i % count + 1} 1" for i in range(1, count + 1)), "0"]
        return "\n".join(lines) + "\n"


def disc(elements):
    """Returns the unit disc with a spacing that gives about that many equilateral triangles."""
    size = math.sqrt(math.pi / (math.sqrt(3) / 4 * elements))
    count = round(2 * math.pi / size)
    return Case([(math.cos(2 * math.pi * i / count), math.sin(2 * math.pi * i / count)) for i in range(count)], size,
                False)


CASES = {**{f"graded-{r}": Case(RECTANGLE, r, True) for r in (0.1, 0.05, 0.02, 0.005)}, "disc": disc(100000)}
