/** Steps of an advance and verdicts on candidates, by their numbers in the record of a run. */
const Step = { base: 2, spacing: 3, ideal: 4, find: 5, score: 6, sort: 7, test: 8, update: 9, finish: 10 };
const Verdict = { notTried: 0, accepted: 1, withdrawn: 2 };
const kAtSort = [2, 8, 9]; // verdicts known once the candidates are sorted: too near, of one colour, a flat corner

/**
 * Returns the mesh and the front of a run at any number of advances done. A two-coloured front makes halves of squares,
 * which are joined where both are there.
 */
const modelOf = (run) => {
  'use strict';
  /** A list of elements in place of an advance: the page has no details of it. */
  const advances = run.advances.map((advance) => Array.isArray(advance) ? { thin: true, elements: advance,
    base: advance.length ? advance.slice(0, 2) : run.front.slice(0, 2), candidates: [], tests: [], cells: [], events: [] } : advance);
  const node = (n) => [run.nodes[2 * n], run.nodes[2 * n + 1]];
  const firstElement = [0], nodesAt = [run.boundaryNodes];
  for (const advance of advances) {
    firstElement.push(firstElement.at(-1) + advance.elements.length / 3);
    nodesAt.push(Math.max(nodesAt.at(-1), ...advance.elements.map((n) => n + 1)));
  }
  const elements = advances.flatMap((advance) => advance.elements);
  // A node that lies on the front twice is a candidate from either side: it is shown once, with its better verdict.
  for (const { candidates } of advances) {
    candidates.forEach((candidate, i) => {
      candidate.hidden = !candidate.sides && candidates.some((other, j) => candidate.node >= 0 && other.node === candidate.node && j !== i &&
        !other.sides && (other.verdict === 1 ? candidate.verdict !== 1 : candidate.verdict !== 1 && j < i));
    });
  }

  // ---- The front ----

  const stride = 128;
  const checkpoints = [new Map()];
  const edgeKey = (a, b) => a * 4294967296 + b;
  const addSide = (front, a, b) => { // a side of an element: a segment of the front leaves it, or its reverse enters
    const key = edgeKey(a, b), count = front.get(key);
    if (count === undefined) {
      front.set(edgeKey(b, a), (front.get(edgeKey(b, a)) || 0) + 1);
    } else if (count > 1) {
      front.set(key, count - 1);
    } else {
      front.delete(key);
    }
  };
  for (let i = 0; i < run.front.length; i += 2) {
    const key = edgeKey(run.front[i], run.front[i + 1]);
    checkpoints[0].set(key, (checkpoints[0].get(key) || 0) + 1);
  }
  const grow = (front, advance) => {
    for (let i = 0; i < advance.elements.length; i += 3) {
      for (let k = 0; k < 3; ++k) {
        addSide(front, advance.elements[i + k], advance.elements[i + (k + 1) % 3]);
      }
    }
  };
  const sizes = [run.front.length / 2]; // of the front after each advance
  {
    const front = new Map(checkpoints[0]);
    advances.forEach((advance, k) => {
      grow(front, advance);
      let size = 0;
      front.forEach((count) => { size += count; });
      sizes.push(size);
      if ((k + 1) % stride === 0) { checkpoints.push(new Map(front)); }
    });
  }
  let cached = { at: -1, front: null };
  const frontAt = (at) => {
    if (cached.at !== at) {
      const from = Math.floor(at / stride);
      const front = new Map(checkpoints[from]);
      for (let k = from * stride; k < at; ++k) { grow(front, advances[k]); }
      cached = { at, front: [...front.keys()].map((key) => [Math.floor(key / 4294967296), key % 4294967296]) };
    }
    return cached.front;
  };

  // ---- Squares ----

  const isColoured = run.colours !== undefined;
  const mates = new Int32Array(elements.length / 3).fill(-1); // by half, the other one
  const squares = Array(elements.length / 3); // by the first half, the corners of the square
  const findMates = () => {
    const lower = (a, b) => edgeKey(Math.min(a, b), Math.max(a, b));
    const kept = new Set(), waiting = new Map(); // waiting: halves by their diagonals, whose ends have one colour
    for (let i = 0; i < run.edges.length; i += 2) { kept.add(lower(run.edges[i], run.edges[i + 1])); }
    for (let e = 0; e < mates.length; ++e) {
      const corners = elements.slice(3 * e, 3 * e + 3);
      const equal = [0, 1, 2].filter((k) => run.colours[corners[k]] === run.colours[corners[(k + 1) % 3]]);
      if (equal.length !== 1) { continue; } // all of one colour: no half of a square
      const [k] = equal, [a, b, c] = [corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]];
      const diagonal = lower(a, b), other = waiting.get(diagonal);
      if (kept.has(diagonal)) { continue; }
      if (!other) { waiting.set(diagonal, { e, c }); continue; }
      mates[e] = other.e;
      mates[other.e] = e;
      squares[other.e] = [b, c, a, other.c];
    }
  };
  if (isColoured) { findMates(); }
  let joined = { at: -1, cells: null };
  /** Returns the elements after a number of advances, by four corners, the last of a triangle being -1. */
  const squaresAt = (at) => {
    if (joined.at !== at) {
      const count = firstElement[at], cells = [];
      for (let e = 0; e < count; ++e) {
        const whole = mates[e] >= 0 && mates[e] < count;
        if (!whole) { cells.push(...elements.slice(3 * e, 3 * e + 3), -1); } else if (e < mates[e]) { cells.push(...squares[e]); }
      }
      joined = { at, cells };
    }
    return joined.cells;
  };
  /** Returns the elements after a number of advances: { list, corners, count }, with `corners` numbers for each. */
  const cellsAt = (at) => {
    if (!isColoured) { return { list: elements, corners: 3, count: firstElement[at] }; }
    const list = squaresAt(at);
    return { list, corners: 4, count: list.length / 4 };
  };

  return { advances, node, elements, nodesAt, sizes, frontAt, cellsAt, isColoured };
};
