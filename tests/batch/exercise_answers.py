"""Answers to the exercise in assets/exercise: the functions that its skeleton leaves open, given the skeleton."""
import math


def answers(own, without=None):
    """Fills in the functions of the skeleton module `own`. `without`: the test of step 8 that is left out."""
    def length(segment):
        return math.dist(own.nodes[segment[0]], own.nodes[segment[1]])

    def take_base():
        deferred = min(segment[2] for segment in own.front)
        shortest = min(length(segment) for segment in own.front if segment[2] == deferred)
        return next(i for i, segment in enumerate(own.front)
                    if segment[2] == deferred and length(segment) <= shortest * (1 + 1e-9))

    def ideal_point(a, b):
        base = math.dist(a, b)
        middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]
        normal = [(a[1] - b[1]) / base, (b[0] - a[0]) / base]

        def clamped(rho):
            return min(max(rho, 0.55 * base), 2 * base)

        def over(rho):
            height = max(math.sqrt(max(0.0, rho ** 2 - base ** 2 / 4)), base / 2)
            return [middle[0] + height * normal[0], middle[1] + height * normal[1]]

        at_middle = own.rho_at(middle)
        rho = clamped((at_middle + own.rho_at(over(clamped(at_middle)))) / 2)
        return rho, over(rho)

    def candidates(base, rho, c, radius):
        a, b = (own.nodes[n] for n in own.front[base][:2])

        def score(p):
            sides = math.dist(a, b) ** 2 + math.dist(b, p) ** 2 + math.dist(p, a) ** 2
            alpha = 2 * math.sqrt(3) * own.cross(a, b, p) / sides
            return alpha * math.prod(min(math.dist(p, q) / rho, rho / math.dist(p, q)) for q in (a, b))

        around = {n for segment in own.front for n in segment[:2]} - set(own.front[base][:2])
        found = [[score(own.nodes[n]), n, own.nodes[n]] for n in around
                 if math.dist(own.nodes[n], c) <= radius * (1 + 1e-9)]
        near = (any(math.dist(own.nodes[n], c) < 0.65 * rho * (1 - 1e-9) for n in around)
                or any(own.distance_to_segment(c, own.nodes[p], own.nodes[q]) < 0.5 * rho * (1 - 1e-9)
                       for i, (p, q, _) in enumerate(own.front) if i != base))
        if not near:
            found.append([score(c), None, c])
        return sorted(found, key=lambda one: (-float(f"{one[0]:.9g}"), math.inf if one[1] is None else one[1]))

    def meets(p, q, a, b):
        return (own.cross(p, q, a) * own.cross(p, q, b) <= 1e-12 and own.cross(a, b, p) * own.cross(a, b, q) <= 1e-12
                and all(min(p[k], q[k]) <= max(a[k], b[k]) and min(a[k], b[k]) <= max(p[k], q[k]) for k in (0, 1)))

    def verdict(base, node, place):
        first, second = own.front[base][:2]
        a, b = own.nodes[first], own.nodes[second]
        if without != "not-left" and own.cross(a, b, place) <= 1e-9:
            return "not-left"
        present = {(p, q) for p, q, _ in own.front}
        open_sides = [(n, p) for n, p, known in ((first, a, (node, first)), (second, b, (second, node)))
                      if known not in present]
        for n, p in open_sides if without != "outside-angle" else ():
            if not own.leaves_inside(n, place) or (node is not None and not own.leaves_inside(node, p)):
                return "outside-angle"
        for n, p in open_sides if without != "crosses-front" else ():
            for i, (u, v, _) in enumerate(own.front):
                if i != base and not {u, v} & {n, node} and meets(p, place, own.nodes[u], own.nodes[v]):
                    return "crosses-front"
        others = {n for segment in own.front for n in segment[:2]} - {first, second, node}
        for n in others if without != "contains-node" else ():
            if all(own.cross(*side, own.nodes[n]) >= -1e-9 for side in ((a, b), (b, place), (place, a))):
                return "contains-node"
        return "accepted"

    def update(base, node):
        first, second = own.front.pop(base)[:2]
        for side in ([first, node], [node, second]):
            for i, segment in enumerate(own.front):
                if segment[:2] == side[::-1]:
                    own.front.pop(i)
                    break
            else:
                own.front.append([*side, 0])

    for function in (take_base, ideal_point, candidates, verdict, update):
        setattr(own, function.__name__, function)
