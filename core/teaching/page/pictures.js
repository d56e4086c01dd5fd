/**
 * Returns what draws the parts of a run: its front, the moment of an advance, and a step of the improvement. `model`: of the
 * run, see modelOf(); `pen`: see penOf().
 */
const picturesOf = (run, model, pen) => {
  'use strict';
  const { node, frontAt, isColoured } = model;
  const { paint, at, path, line, label, canvas, camera, colours } = pen;
  const drawFront = (done, moment) => {
    const segments = frontAt(done).map(([a, b]) => [node(a), node(b)]);
    const middle = moment ? moment.advance.base.map(node).reduce((p, q) => [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2]) : null;
    const far = (s) => middle ? Math.hypot((s[0][0] + s[1][0]) / 2 - middle[0], (s[0][1] + s[1][1]) / 2 - middle[1]) : 0;
    const near = new Set(middle ? [...segments].sort((p, q) => far(p) - far(q)).slice(0, 12) : segments);
    for (const s of segments) { paint.globalAlpha = near.has(s) ? 1 : .5; line(s, colours.front, 2.2); }
    paint.globalAlpha = 1;
    if (middle) { near.forEach((s) => pen.arrow(s[0], s[1], colours.front)); }
    if (isColoured) { drawColours(frontAt(done)); }
  };
  /** Draws the two colours of the nodes of the front: discs and rings, where its segments have room for them. */
  const drawColours = (segments) => {
    for (const [a, b] of segments) {
      const [p, q] = [node(a), node(b)], [x, y] = at(p);
      const wide = Math.hypot(p[0] - q[0], p[1] - q[1]) * camera.zoom > 14;
      if (!wide || x < 0 || y < 0 || x > canvas.clientWidth || y > canvas.clientHeight) { continue; }
      pen.disc(p, 4, run.colours[a] === '1' ? colours.front : colours.domain);
      pen.ring(p, 4, colours.front, 1.5);
    }
  };
  const drawCandidate = (moment, candidate, i, chosen) => {
    const tested = moment.judged[i] && candidate.verdict !== Verdict.notTried, good = tested && candidate.verdict === Verdict.accepted;
    const colour = good ? colours.accepted : tested ? colours.bad : colours.candidate;
    const alpha = chosen >= 0 && chosen !== i ? .45 : 1;
    paint.globalAlpha = alpha;
    if (candidate.sides && (moment.trying === i || (tested && !good))) { line(placesOf(candidate), colour, 1.5, [6, 4]); }
    for (const place of cornersOf(candidate)) {
      const [x, y] = at(place);
      pen.disc(place, good ? 7.5 : 6.5, good ? colour : colours.domain);
      pen.ring(place, good ? 7.5 : 6.5, colour, 1.75);
      paint.beginPath(); paint.strokeStyle = good ? colours.canvas : colour;
      if (good) { paint.moveTo(x - 3.5, y); paint.lineTo(x - 1, y + 3); paint.lineTo(x + 3.5, y - 3); } else if (tested) { paint.moveTo(x - 3, y - 3); paint.lineTo(x + 3, y + 3); paint.moveTo(x + 3, y - 3); paint.lineTo(x - 3, y + 3); }
      paint.stroke();
    }
    paint.globalAlpha = 1;
    return colour;
  };
  /** Returns the places along the new sides of a square. */
  const placesOf = ({ sides }) => sides.reduce((places, v, i) => (i % 2 ? places.at(-1).push(v) : places.push([v]), places), []);
  /** Returns the corners that a candidate would add: one, or two of a square that opens a row. */
  const cornersOf = (candidate) => candidate.sides && candidate.sides.length === 8 ? placesOf(candidate).slice(1, 3) : [placeOf(candidate)];
  const placeOf = (candidate) => candidate.node >= 0 ? node(candidate.node) : candidate.at;
  /** Draws the triangles of an advance, without the side that the two halves of a square share. */
  const drawMade = (made) => {
    const sides = [];
    for (let i = 0; i < made.length; i += 3) {
      const corners = made.slice(i, i + 3);
      path(corners.map(node), true);
      paint.globalAlpha = .28; paint.fillStyle = colours.accepted; paint.fill(); paint.globalAlpha = 1;
      sides.push(...corners.map((a, k) => [a, corners[(k + 1) % 3]]));
    }
    for (const [a, b] of sides) {
      const inner = isColoured && sides.some(([c, d]) => c === b && d === a);
      if (!inner) { line([node(a), node(b)], colours.accepted, 2); }
    }
  };
  /** `chosen`: the candidate pointed at, or -1; `withCells`: the cells that the search visited are shown. */
  const drawMoment = (moment, chosen, withCells) => {
    const { advance, step } = moment, [a, b] = advance.base.map(node);
    const pixels = Math.hypot(a[0] - b[0], a[1] - b[1]) * camera.zoom;
    if (withCells) {
      paint.strokeStyle = colours.visited; paint.lineWidth = 1.25;
      for (let i = 0; i < 4 * moment.cells; i += 4) {
        const [x0, y1] = at(advance.cells.slice(i, i + 2)), [x1, y0] = at(advance.cells.slice(i + 2, i + 4));
        paint.globalAlpha = .12; paint.fillStyle = colours.visited; paint.fillRect(x0, y0, x1 - x0, y1 - y0);
        paint.globalAlpha = .8; paint.strokeRect(x0, y0, x1 - x0, y1 - y0);
      }
      paint.globalAlpha = 1;
    }
    if (moment.updated) {
      drawMade(advance.elements);
    }
    if (advance.thin) { return; }
    if (step >= Step.find && !moment.updated) { pen.ring(advance.c, advance.radius * camera.zoom, colours.candidate, 1.25, [5, 4]); }
    const shownTest = moment.test >= 0 ? advance.tests[moment.test] : null;
    advance.tests.slice(0, moment.tests).forEach((test) => {
      if (shownTest ? test === shownTest : test[9]) {
        line([test.slice(1, 3), test.slice(3, 5)], test[9] ? colours.bad : colours.accepted, 2, [6, 4]);
        line([test.slice(5, 7), test.slice(7, 9)], test[9] ? colours.bad : colours.accepted, 3.5);
      }
    });
    line([a, b], colours.base, 5); line([a, b], colours.core, 1.4);
    for (const p of [a, b]) { pen.disc(p, 4.5, colours.base); }
    if (pixels < 14) { pen.ring([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], 13, colours.base, 2); return; }
    const shown = step >= Step.find ? advance.candidates.slice(0, moment.candidates) : [];
    const isAccepted = (i) => moment.judged[i] && shown[i].verdict === Verdict.accepted;
    const order = shown.map((_, i) => i).filter((i) => !shown[i].hidden).sort((i, j) => isAccepted(i) - isAccepted(j) || j - i);
    const inks = [];
    order.forEach((i) => { inks[i] = drawCandidate(moment, shown[i], i, chosen); });
    if (step >= Step.ideal) {
      const [x, y] = at(advance.c);
      paint.beginPath(); paint.moveTo(x - 4.5, y - 4.5); paint.lineTo(x + 4.5, y + 4.5); paint.moveTo(x + 4.5, y - 4.5); paint.lineTo(x - 4.5, y + 4.5);
      paint.strokeStyle = colours.base; paint.lineWidth = 1.75; paint.stroke();
    }
    if (pixels > 46) {
      const u = [(b[0] - a[0]) * camera.zoom / pixels, (b[1] - a[1]) * camera.zoom / pixels]; // along AB; y points up
      label(a, 16 * u[1] - 14 * u[0] - 9, 16 * u[0] + 14 * u[1] - 8, 'A ' + advance.base[0], colours.base);
      label(b, 16 * u[1] + 14 * u[0] - 9, 16 * u[0] - 14 * u[1] - 8, 'B ' + advance.base[1], colours.base);
      if (step >= Step.ideal) { label(advance.c, -8, -26, 'C', colours.base); }
      order.reverse().slice(0, 7).forEach((i) => {
        const candidate = shown[i];
        if (chosen >= 0 && chosen !== i) { return; }
        const words = [String(i + 1)];
        if (candidate.does) { words.push(candidate.does); } else if (step >= Step.score) { words.push('score ' + candidate.score.toFixed(2)); }
        if (moment.judged[i] && candidate.verdict !== Verdict.notTried) { words.push(run.verdicts[candidate.verdict]); }
        label(placeOf(candidate), 11, -8, words.join('  '), inks[i], true);
      });
    }
  };
  const kMap = [[68, 1, 84], [65, 68, 135], [42, 120, 142], [34, 168, 132], [122, 209, 81], [253, 231, 37]]; // viridis
  /** Returns the colour of a value in [0, 1], so opaque over the domain. */
  const mapped = (t, opacity) => {
    const at = Math.min(Math.max(t, 0), 1) * (kMap.length - 1), k = Math.min(Math.floor(at), kMap.length - 2);
    const ground = [1, 3, 5].map((i) => parseInt(colours.domain.slice(i, i + 2), 16));
    const rgb = kMap[k].map((v, i) => v + (at - k) * (kMap[k + 1][i] - v));
    return 'rgb(' + rgb.map((v, i) => Math.round(ground[i] + opacity * (v - ground[i]))).join(',') + ')';
  };
  /** Fills triangles by their values, in thousandths: one for each of them, or one for each node; then each is divided. */
  const drawValues = ({ nodes, elements, values, tint }, light) => {
    const colour = (t) => (tint ? mapped(1 - .75 * t / 1000, light ? .45 : .35) : mapped(t / 1000, 1));
    const fill = (corners, value) => {
      path(corners, true);
      paint.fillStyle = paint.strokeStyle = colour(value);
      paint.lineWidth = .6; paint.fill(); paint.stroke();
    };
    const ofElements = values.length === elements.length / 3 && values.length !== nodes.length / 2, parts = tint ? 2 : 6;
    for (let i = 0; i < elements.length; i += 3) {
      const [a, b, c] = elements.slice(i, i + 3).map((n) => [nodes[2 * n], nodes[2 * n + 1], ofElements ? values[i / 3] : values[n]]);
      const mix = (s, t) => a.map((v, k) => v + (s * (b[k] - v) + t * (c[k] - v)) / (ofElements ? 1 : parts));
      const one = (...corners) => fill(corners, (corners[0][2] + corners[1][2] + corners[2][2]) / 3);
      for (let s = 0; s < (ofElements ? 1 : parts); ++s) {
        for (let t = 0; s + t < (ofElements ? 1 : parts); ++t) {
          one(mix(s, t), mix(s + 1, t), mix(s, t + 1));
          if (!ofElements && s + t + 1 < parts) { one(mix(s + 1, t), mix(s + 1, t + 1), mix(s, t + 1)); }
        }
      }
    }
  };
  /** Draws what a step of the improvement has changed. `nodes`: their places, which may be on their way. */
  const drawStep = ({ made, lost, moved, added, removed }, nodes) => {
    if (made.length > 0 && made.length <= 400) {
      const cells = { list: made.flat(), corners: run.improved.corners, count: made.length };
      paint.globalAlpha = .28; pen.polygons(cells, nodes, colours.accepted, colours.accepted); paint.globalAlpha = 1;
    }
    for (const side of lost) { line(side, colours.bad, 1.8, [6, 4]); }
    for (const [from, to] of moved) {
      if (Math.hypot(to[0] - from[0], to[1] - from[1]) * camera.zoom >= 1) { line([from, to], colours.accepted, 1.8); }
    }
    for (const [places, colour] of [[added, colours.accepted], [removed, colours.bad]]) {
      for (const p of places) { pen.ring(p, 6, colour, 2); }
    }
  };
  return { front: drawFront, moment: drawMoment, step: drawStep, values: drawValues };
};
