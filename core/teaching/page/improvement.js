/**
 * Follows the improvement that `improved` records, from a finished front with these nodes and triangles. Returns a function
 * that gives the mesh after a number of steps and what the last of them has changed: { nodes, cells: its elements as { list,
 * corners, count }, gone: nodes that are in the list but not in the mesh, moved: [from, to, number], made: elements, lost:
 * edges, added, removed: places of nodes }.
 */
const improvementOf = (improved, startNodes, triangles) => {
  'use strict';
  const { unit, steps, corners: width } = improved;
  const edge = (a, b) => Math.min(a, b) + ',' + Math.max(a, b);
  const sidesOf = (element) => element.filter((n) => n >= 0).map((a, k, all) => [a, all[(k + 1) % all.length]]);
  const padded = () => {
    const list = [];
    for (let i = 0; i < triangles.length; i += 3) { list.push(...triangles.slice(i, i + 3), -1); }
    return list;
  };
  const first = improved.start || (width === 4 ? padded() : triangles); // elements
  const begin = () => ({ done: 0, units: startNodes.map((v) => Math.round(v / unit)), list: first.slice(), gone: new Set() });
  let state = begin();

  /** Takes the next step. Returns what it changes. */
  const advance = () => {
    const { m = [], n = [], r = [], c = [] } = steps[state.done++];
    const { units, list, gone } = state;
    const place = (i) => [units[2 * i] * unit, units[2 * i + 1] * unit];
    const before = [], made = [];
    for (let i = 0; i < c.length; i += width + 1) {
      const was = list.slice(width * c[i], width * c[i] + width), is = c.slice(i + 1, i + width + 1);
      if (was.length > 0 && was[0] >= 0) { before.push(was); }
      if (is[0] >= 0) { made.push(is); }
    }
    const kept = new Set(made.flatMap(sidesOf).map(([a, b]) => edge(a, b))), lost = new Map();
    for (const [a, b] of before.flatMap(sidesOf)) {
      if (!kept.has(edge(a, b))) { lost.set(edge(a, b), [place(a), place(b)]); }
    }
    const removed = r.map(place), moved = [], added = [];
    for (let i = 0; i < m.length; i += 3) {
      const from = place(m[i]);
      units[2 * m[i]] += m[i + 1];
      units[2 * m[i] + 1] += m[i + 2];
      moved.push([from, place(m[i]), m[i]]);
    }
    for (let i = 0; i < n.length; i += 2) {
      units.push(n[i], n[i + 1]);
      added.push(place(units.length / 2 - 1));
    }
    r.forEach((i) => gone.add(i));
    for (let i = 0; i < c.length; i += width + 1) {
      for (let k = 0; k < width; ++k) { list[width * c[i] + k] = c[i + 1 + k]; }
    }
    return { moved, made, lost: [...lost.values()], added, removed };
  };

  return (done) => {
    if (state.done >= done) { state = begin(); } // what the last step changes is found on the way
    let change = null;
    while (state.done < done) { change = advance(); }
    const { units, list, gone } = state;
    const alive = list.filter((_, i) => list[i - i % width] >= 0);
    const cells = { list: alive, corners: width, count: alive.length / width };
    return { done, nodes: units.map((v) => v * unit), cells, gone: new Set(gone), ...change };
  };
};
