'use strict';
(() => {
  const run = JSON.parse(document.getElementById('run').textContent);
  /** A list of elements in place of an advance: the page has no details of it. */
  const advances = run.advances.map((advance) => Array.isArray(advance) ? { thin: true, elements: advance,
    base: advance.length ? advance.slice(0, 2) : run.front.slice(0, 2), candidates: [], tests: [], cells: [], events: [] } : advance);
  const $ = (id) => document.getElementById(id);
  const calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
  const embedded = parent !== window; // in a page of its own, such as that of a lesson
  const canvas = $('canvas'), paint = canvas.getContext('2d');
  const Step = { base: 2, spacing: 3, ideal: 4, find: 5, score: 6, sort: 7, test: 8, update: 9, finish: 10 };
  const Verdict = { notTried: 0, accepted: 1, withdrawn: 2 };
  const verdictWords = ['not tried', 'accepted', 'too near', 'not left', 'outside', 'crosses', 'encloses'];
  const stepWords = ['Boundary becomes front Γ', 'Take base segment AB', 'Evaluate ρ', 'Place ideal point C', 'Find candidate nodes',
    'Score α · δ(AC) · δ(CB)', 'Sort; drop C if too near', 'Test AC, CB against Γ', 'Store ABC, update Γ', 'Stop when Γ = ∅'];

  // ---- The run: nodes, elements and the front at any position ----

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
      candidate.hidden = candidates.some((other, j) => candidate.node >= 0 && other.node === candidate.node && j !== i &&
        (other.verdict === 1 ? candidate.verdict !== 1 : candidate.verdict !== 1 && j < i));
    });
  }

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

  // ---- The position: advances done, and events of the next one ----

  // position.improve: moments of the improvement after the last advance; the last of them is the improved mesh.
  const position = { done: Math.min(run.from, advances.length), event: 0, improve: 0 };
  const last = advances.length, moments = run.improved ? run.improved.moments : 0;
  const isImproved = () => moments > 0 && position.improve === moments;
  const isAtEnd = () => position.done === last && position.improve === moments;
  let bare = false; // the page around wants the mesh alone, until one moves on
  const goTo = (done, event = 0, improve = 0) => {
    const before = position.done === last ? position.improve : -1;
    position.done = Math.max(0, Math.min(last, done));
    position.event = position.done < last ? Math.max(0, Math.min(event, advances[position.done].events.length - 1)) : 0;
    position.improve = position.done === last ? Math.max(0, Math.min(moments, improve)) : 0;
    findStep(before + 1 === position.improve && before >= 0);
    bare = false;
    follow();
    show();
  };
  /** Goes to a place on the timeline: advances, then moments of the improvement. */
  const goAlong = (place) => goTo(place, 0, place - last);
  const stepForward = (unit) => {
    if (position.done === last) { goTo(last, 0, position.improve + 1); return !isAtEnd(); }
    const events = advances[position.done].events.length;
    if (unit === 'event' && position.event + 1 < events) { goTo(position.done, position.event + 1); } else { goTo(position.done + 1); }
    return true;
  };
  const stepBack = (unit) => {
    if (position.improve > 0) { goTo(last, 0, position.improve - 1); } else if (unit === 'event' && position.event > 0) { goTo(position.done, position.event - 1); } else if (unit === 'event' && position.done > 0) {
      goTo(position.done - 1, advances[position.done - 1].events.length - 1);
    } else { goTo(position.event > 0 ? position.done : position.done - 1); }
  };

  /** What is known of the advance in view: the one under way, or the last one done. */
  const momentNow = () => {
    if (position.improve > 0) { return null; }
    const underWay = position.event > 0;
    const advance = underWay ? advances[position.done] : advances[position.done - 1];
    if (!advance) { return null; }
    const events = advance.events;
    const seen = underWay ? position.event : events.length;
    const at = underWay ? events[seen] : null;
    const step = at ? at[0] : Step.update;
    const judged = advance.candidates.map((candidate) => !at || (candidate.verdict === Verdict.withdrawn && step >= Step.sort));
    let tests = at ? 0 : advance.tests.length, cells = at ? 0 : advance.cells.length / 4, returned = at || advance.thin ? 0 : events.at(-1)[5];
    for (let i = 0; at && i <= seen; ++i) {
      const [eventStep, candidate, test, cellsSeen, , delivered] = events[i];
      tests = Math.max(tests, test + 1);
      cells = Math.max(cells, cellsSeen);
      returned = Math.max(returned, delivered);
      if (eventStep === Step.test && candidate >= 0 && i < seen) {
        judged[candidate] = events[i + 1][0] !== Step.test || events[i + 1][1] !== candidate;
      }
    }
    return { advance, number: underWay ? position.done + 1 : position.done, step, judged, tests, cells, returned,
      candidates: at ? at[4] : advance.candidates.length, test: at ? at[2] : -1, updated: step >= Step.update && advance.elements.length > 0,
      caption: at ? run.words[at[6]] : advance.thin ? '' : run.words[advance.outcome] };
  };

  // ---- The improvement ----

  const recorded = run.improved ? run.improved.steps.length : 0; // steps; if some are left out, the last moment follows them all
  const meshAfter = recorded > 0 ? improvementOf(run.improved, run.nodes, elements) : null;
  let improving = null; // the step of the improvement, that led to the moment shown; null: none, or not recorded
  let gliding = null; // by node, where it comes from
  const kGlide = 180; // milliseconds
  let glideStart = 0;
  /** Finds the step that led to the moment shown. `glides`: its nodes are seen moving. */
  const findStep = (glides = false) => {
    const at = position.improve;
    // At the end it is shown only if one has stepped there; else the mesh is the point.
    improving = at === 0 || at > recorded || (at === moments && !glides) ? null : improving && improving.done === at ? improving : meshAfter(at);
    gliding = glides && improving && !calm && improving.moved.length > 0 ? new Map(improving.moved.map(([from, , n]) => [n, from])) : null;
    glideStart = performance.now();
    if (gliding) { requestAnimationFrame(glideOn); }
  };
  const glideOn = (now) => {
    if (!gliding) { return; }
    if (now - glideStart >= kGlide) { gliding = null; } else { requestAnimationFrame(glideOn); }
    draw();
  };
  /** Returns the mesh of the moment shown: of a step, whose nodes may be on their way, or improved; null: that of the front. */
  const meshNow = () => {
    if (isImproved() && !gliding) { return run.improved; }
    if (!improving) { return null; }
    const left = gliding ? (1 - Math.min(1, Math.max(0, (performance.now() - glideStart) / kGlide))) ** 3 : 0;
    const nodes = left === 0 ? improving.nodes : improving.nodes.map((v, i) => {
      const from = gliding.get(Math.floor(i / 2));
      return from ? v + left * (from[i % 2] - v) : v;
    });
    return { nodes, elements: improving.elements, edges: run.edges, gone: improving.gone };
  };

  // ---- The camera ----

  const camera = { x: 0, y: 0, zoom: 1 }; // of the middle of the canvas; pixels per unit
  let target = null, following = true, chosen = -1;
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < run.nodes.length; i += 2) {
    box[0] = Math.min(box[0], run.nodes[i]); box[2] = Math.max(box[2], run.nodes[i]);
    box[1] = Math.min(box[1], run.nodes[i + 1]); box[3] = Math.max(box[3], run.nodes[i + 1]);
  }
  const whole = () => ({ x: (box[0] + box[2]) / 2, y: (box[1] + box[3]) / 2,
    zoom: 0.9 * Math.min(canvas.clientWidth / (box[2] - box[0] || 1), canvas.clientHeight / (box[3] - box[1] || 1)) });
  const moveTo = (there) => {
    if (calm || !drawn) { Object.assign(camera, there); target = null; draw(); } else { target = { from: { ...camera }, to: there, start: performance.now() }; requestAnimationFrame(moveOn); }
  };
  const moveOn = (now) => {
    if (!target) { return; }
    const t = Math.min(1, Math.max(0, (now - target.start) / 160)), s = 1 - (1 - t) ** 3;
    camera.x = target.from.x + s * (target.to.x - target.from.x);
    camera.y = target.from.y + s * (target.to.y - target.from.y);
    camera.zoom = target.from.zoom * (target.to.zoom / target.from.zoom) ** s;
    if (t === 1) { target = null; } else { requestAnimationFrame(moveOn); }
    draw();
  };
  /** The view of what a step of the improvement changes; null if that is a large part of the mesh. */
  const aroundStep = () => {
    const { moved, lost, added, removed, made, nodes } = improving;
    const places = [...moved.flatMap(([from, to]) => [from, to]), ...lost.flat(), ...added, ...removed, ...made.flat().map((n) => nodes.slice(2 * n, 2 * n + 2))];
    if (places.length === 0 || places.length > 400) { return null; }
    const [x, y] = [0, 1].map((k) => places.map((p) => p[k])).map((values) => [Math.min(...values), Math.max(...values)]);
    const size = Math.max(x[1] - x[0], y[1] - y[0]), all = whole();
    if (size > 0.3 * Math.max(box[2] - box[0], box[3] - box[1])) { return null; }
    return { x: (x[0] + x[1]) / 2, y: (y[0] + y[1]) / 2, zoom: Math.max(all.zoom, Math.min(6 * all.zoom, 0.3 * canvas.clientHeight / (size || 1))) };
  };
  /** Keeps AB in view and 60 to 120 pixels long. */
  const follow = () => {
    const moment = momentNow();
    if (!following) { return; }
    if (!moment) { moveTo((improving && aroundStep()) || whole()); return; }
    const [a, b] = moment.advance.base.map(node);
    const there = { x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2 };
    const length = Math.hypot(a[0] - b[0], a[1] - b[1]);
    const now = target ? target.to : camera;
    const pixels = length * now.zoom;
    there.zoom = pixels >= 60 && pixels <= 120 ? now.zoom : 90 / length;
    const off = Math.max(Math.abs(there.x - now.x) * there.zoom / canvas.clientWidth, Math.abs(there.y - now.y) * there.zoom / canvas.clientHeight);
    if (there.zoom !== now.zoom || off > 0.3) { moveTo(there); }
  };

  // ---- Drawing ----

  let colours = {}, drawn = false;
  const readColours = () => {
    const style = getComputedStyle(document.documentElement);
    for (const name of ['canvas', 'domain', 'popup', 'text', 'muted', 'bad', 'boundary', 'mesh', 'element', 'front', 'base', 'core', 'accepted', 'candidate', 'visited', 'accent', 'faint', 'inset', 'warn']) {
      colours[name] = style.getPropertyValue('--' + name).trim();
    }
  };
  const at = ([x, y]) => [canvas.clientWidth / 2 + (x - camera.x) * camera.zoom, canvas.clientHeight / 2 - (y - camera.y) * camera.zoom];
  const fitCanvas = (c) => {
    const ratio = devicePixelRatio || 1, width = Math.round(c.clientWidth * ratio), height = Math.round(c.clientHeight * ratio);
    if (c.width !== width || c.height !== height) { c.width = width; c.height = height; }
    c.getContext('2d').setTransform(ratio, 0, 0, ratio, 0, 0);
  };
  const path = (points, closed) => {
    paint.beginPath();
    points.forEach((p, i) => { const [x, y] = at(p); if (i) { paint.lineTo(x, y); } else { paint.moveTo(x, y); } });
    if (closed) { paint.closePath(); }
  };
  const line = (points, colour, width, dash = []) => {
    path(points, false); paint.setLineDash(dash); paint.strokeStyle = colour; paint.lineWidth = width; paint.stroke(); paint.setLineDash([]);
  };
  const label = (p, dx, dy, text, colour) => {
    const [x, y] = at(p);
    paint.font = '12px ' + getComputedStyle(document.body).fontFamily;
    const width = paint.measureText(text).width;
    const left = Math.min(Math.max(x + dx, 2), canvas.clientWidth - width - 10), top = Math.min(Math.max(y + dy, 2), canvas.clientHeight - 18);
    if (taken.some((r) => left < r[2] && left + width + 8 > r[0] && top < r[3] && top + 16 > r[1])) { return; }
    taken.push([left, top, left + width + 8, top + 16]);
    paint.globalAlpha = .88; paint.fillStyle = colours.popup; paint.fillRect(left, top, width + 8, 16); paint.globalAlpha = 1;
    paint.fillStyle = colour; paint.textBaseline = 'middle'; paint.fillText(text, left + 4, top + 8.5);
  };
  let taken = [];
  const tri = (list, coords, i) => [0, 1, 2].map((k) => [coords[2 * list[i + k]], coords[2 * list[i + k] + 1]]);
  const triangles = (list, coords, count, fill, stroke) => {
    paint.beginPath();
    for (let i = 0; i < 3 * count; i += 3) {
      const [a, b, c] = tri(list, coords, i).map(at);
      paint.moveTo(a[0], a[1]); paint.lineTo(b[0], b[1]); paint.lineTo(c[0], c[1]); paint.closePath();
    }
    paint.fillStyle = fill; paint.fill();
    paint.strokeStyle = stroke; paint.lineWidth = stroke === fill ? 1 : .9; paint.lineJoin = 'round'; paint.stroke();
  };
  const arrow = (a, b, colour) => {
    const [p, q] = [at(a), at(b)], length = Math.hypot(q[0] - p[0], q[1] - p[1]);
    if (length < 16) { return; }
    const u = [(q[0] - p[0]) / length, (q[1] - p[1]) / length], m = [(p[0] + q[0]) / 2 + 4 * u[0], (p[1] + q[1]) / 2 + 4 * u[1]];
    paint.beginPath(); paint.moveTo(m[0], m[1]); paint.lineTo(m[0] - 8 * u[0] - 4 * u[1], m[1] - 8 * u[1] + 4 * u[0]);
    paint.lineTo(m[0] - 8 * u[0] + 4 * u[1], m[1] - 8 * u[1] - 4 * u[0]); paint.closePath(); paint.fillStyle = colour; paint.fill();
  };
  const drawFront = (moment) => {
    const segments = frontAt(position.done).map(([a, b]) => [node(a), node(b)]);
    const middle = moment ? moment.advance.base.map(node).reduce((p, q) => [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2]) : null;
    const far = (s) => middle ? Math.hypot((s[0][0] + s[1][0]) / 2 - middle[0], (s[0][1] + s[1][1]) / 2 - middle[1]) : 0;
    const near = new Set(middle ? [...segments].sort((p, q) => far(p) - far(q)).slice(0, 12) : segments);
    for (const s of segments) { paint.globalAlpha = near.has(s) ? 1 : .5; line(s, colours.front, 2.2); }
    paint.globalAlpha = 1;
    if (middle) { near.forEach((s) => arrow(s[0], s[1], colours.front)); }
  };
  const drawCandidate = (moment, candidate, i) => {
    const place = placeOf(candidate), [x, y] = at(place);
    const tested = moment.judged[i] && candidate.verdict !== Verdict.notTried, good = tested && candidate.verdict === Verdict.accepted;
    const colour = good ? colours.accepted : tested ? colours.bad : colours.candidate;
    paint.globalAlpha = chosen >= 0 && chosen !== i ? .45 : 1;
    paint.beginPath(); paint.arc(x, y, good ? 7.5 : 6.5, 0, 2 * Math.PI); paint.fillStyle = good ? colour : colours.domain; paint.fill();
    paint.lineWidth = 1.75; paint.strokeStyle = colour; paint.stroke();
    paint.beginPath(); paint.strokeStyle = good ? colours.canvas : colour;
    if (good) { paint.moveTo(x - 3.5, y); paint.lineTo(x - 1, y + 3); paint.lineTo(x + 3.5, y - 3); } else if (tested) { paint.moveTo(x - 3, y - 3); paint.lineTo(x + 3, y + 3); paint.moveTo(x + 3, y - 3); paint.lineTo(x - 3, y + 3); }
    paint.stroke(); paint.globalAlpha = 1;
    return colour;
  };
  const placeOf = (candidate) => candidate.node >= 0 ? node(candidate.node) : candidate.at;
  const drawMoment = (moment) => {
    const { advance, step } = moment, [a, b] = advance.base.map(node);
    const pixels = Math.hypot(a[0] - b[0], a[1] - b[1]) * camera.zoom;
    if (pressed('cells')) {
      paint.strokeStyle = colours.visited; paint.lineWidth = 1.25;
      for (let i = 0; i < 4 * moment.cells; i += 4) {
        const [x0, y1] = at(advance.cells.slice(i, i + 2)), [x1, y0] = at(advance.cells.slice(i + 2, i + 4));
        paint.globalAlpha = .12; paint.fillStyle = colours.visited; paint.fillRect(x0, y0, x1 - x0, y1 - y0);
        paint.globalAlpha = .8; paint.strokeRect(x0, y0, x1 - x0, y1 - y0);
      }
      paint.globalAlpha = 1;
    }
    if (moment.updated) {
      for (let i = 0; i < advance.elements.length; i += 3) {
        path(tri(advance.elements, run.nodes, i), true);
        paint.globalAlpha = .28; paint.fillStyle = colours.accepted; paint.fill(); paint.globalAlpha = 1;
        paint.strokeStyle = colours.accepted; paint.lineWidth = 2; paint.stroke();
      }
    }
    if (advance.thin) { return; }
    if (step >= Step.find && !moment.updated) {
      const [x, y] = at(advance.c);
      paint.beginPath(); paint.setLineDash([5, 4]); paint.arc(x, y, advance.radius * camera.zoom, 0, 2 * Math.PI);
      paint.strokeStyle = colours.candidate; paint.lineWidth = 1.25; paint.stroke(); paint.setLineDash([]);
    }
    const shownTest = moment.test >= 0 ? advance.tests[moment.test] : null;
    advance.tests.slice(0, moment.tests).forEach((test) => {
      if (shownTest ? test === shownTest : test[9]) {
        line([test.slice(1, 3), test.slice(3, 5)], test[9] ? colours.bad : colours.accepted, 2, [6, 4]);
        line([test.slice(5, 7), test.slice(7, 9)], test[9] ? colours.bad : colours.accepted, 3.5);
      }
    });
    line([a, b], colours.base, 5); line([a, b], colours.core, 1.4);
    for (const p of [a, b]) { const [x, y] = at(p); paint.beginPath(); paint.arc(x, y, 4.5, 0, 2 * Math.PI); paint.fillStyle = colours.base; paint.fill(); }
    if (pixels < 14) { const [x, y] = at([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]); paint.beginPath(); paint.arc(x, y, 13, 0, 2 * Math.PI); paint.strokeStyle = colours.base; paint.lineWidth = 2; paint.stroke(); return; }
    const shown = step >= Step.find ? advance.candidates.slice(0, moment.candidates) : [];
    const isAccepted = (i) => moment.judged[i] && shown[i].verdict === Verdict.accepted;
    const order = shown.map((_, i) => i).filter((i) => !shown[i].hidden).sort((i, j) => isAccepted(i) - isAccepted(j) || j - i);
    const inks = [];
    order.forEach((i) => { inks[i] = drawCandidate(moment, shown[i], i); });
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
        if (step >= Step.score) { words.push('score ' + candidate.score.toFixed(2)); }
        if (moment.judged[i] && candidate.verdict !== Verdict.notTried) { words.push(verdictWords[candidate.verdict]); }
        label(placeOf(candidate), 11, -8, words.join('  '), inks[i]);
      });
    }
  };
  /** Draws what a step of the improvement has changed. */
  const drawStep = (nodes) => {
    const { made, lost, moved, added, removed } = improving;
    if (made.length > 0 && made.length <= 400) {
      paint.globalAlpha = .28; triangles(made.flat(), nodes, made.length, colours.accepted, colours.accepted); paint.globalAlpha = 1;
    }
    for (const side of lost) { line(side, colours.bad, 1.8, [6, 4]); }
    for (const [from, to] of moved) {
      if (Math.hypot(to[0] - from[0], to[1] - from[1]) * camera.zoom >= 1) { line([from, to], colours.accepted, 1.8); }
    }
    for (const [places, colour] of [[added, colours.accepted], [removed, colours.bad]]) {
      for (const p of places) {
        const [x, y] = at(p);
        paint.beginPath(); paint.arc(x, y, 6, 0, 2 * Math.PI); paint.strokeStyle = colour; paint.lineWidth = 2; paint.stroke();
      }
    }
  };
  const draw = () => {
    drawn = true;
    fitCanvas(canvas);
    taken = [];
    paint.fillStyle = colours.canvas; paint.fillRect(0, 0, canvas.clientWidth, canvas.clientHeight);
    triangles(elements, run.nodes, elements.length / 3, colours.domain, colours.domain);
    const moment = momentNow();
    const mesh = meshNow();
    if (mesh) { triangles(mesh.elements, mesh.nodes, mesh.elements.length / 3, colours.element, colours.mesh); } else { triangles(elements, run.nodes, firstElement[position.done], colours.element, colours.mesh); }
    const { edges, nodes } = mesh || run;
    for (let i = 0; i < edges.length; i += 2) {
      line([0, 1].map((k) => nodes.slice(2 * edges[i + k], 2 * edges[i + k] + 2)), colours.boundary, 1.6);
    }
    if (!mesh && !bare) { drawFront(moment); }
    if (moment && !bare) { drawMoment(moment); }
    if (improving) { drawStep(gliding ? nodes : improving.nodes); }
    if (pressed('numbers')) {
      const count = mesh ? nodes.length / 2 : nodesAt[position.done];
      for (let n = 0; n < count; ++n) {
        const p = nodes.slice(2 * n, 2 * n + 2), [x, y] = at(p);
        const seen = x > 0 && y > 0 && x < canvas.clientWidth && y < canvas.clientHeight && !(mesh && mesh.gone && mesh.gone.has(n));
        if (seen) { label(p, 5, 3, String(n), colours.muted); }
      }
    }
  };

  // ---- The panels ----

  const number = (value, digits = 4) => String(Number(value.toPrecision(digits)));
  const findings = (moment) => {
    const found = Array(10).fill('');
    if (!moment) { return found; }
    const { advance, step } = moment;
    const grid = moment.returned ? ' of ' + moment.returned + ' in ' + moment.cells + (moment.cells === 1 ? ' cell' : ' cells') : '';
    const accepted = advance.candidates.findIndex((c, i) => moment.judged[i] && c.verdict === Verdict.accepted);
    const scored = advance.candidates[Math.max(0, accepted)];
    const set = (s, text) => { if (step >= s) { found[s - 1] = text; } };
    if (advance.thin) { return found; }
    set(Step.base, advance.base.join('–'));
    set(Step.spacing, number(advance.rho, 3));
    set(Step.ideal, '(' + advance.c.map((v) => number(v)).join(', ') + ')');
    set(Step.find, moment.candidates + grid);
    set(Step.score, scored ? [scored.alpha, scored.ac, scored.cb].map((v, i) => v.toFixed(i ? 2 : 3)).join(' · ') : '');
    set(Step.test, String(moment.tests));
    set(Step.update, advance.elements.length === 0 ? 'deferred' : advance.elements.length > 3 ? advance.elements.length / 3 + ' elements' : '');
    return found;
  };
  const showSteps = (moment) => {
    const here = moment ? moment.step : position.done === 0 ? 1 : 10, found = findings(moment);
    [...$('steps').children].forEach((row, i) => {
      row.classList.toggle('here', i + 1 === here);
      row.lastChild.textContent = found[i];
    });
  };
  const showCandidates = (moment) => {
    const body = $('candidates').tBodies[0];
    body.replaceChildren();
    (moment && moment.step >= Step.find ? moment.advance.candidates.slice(0, moment.candidates) : []).forEach((candidate, i) => {
      if (candidate.hidden) { return; }
      const row = body.insertRow();
      const scores = moment.step >= Step.score ? [candidate.alpha, candidate.ac, candidate.cb, candidate.score].map((v) => v.toFixed(3)) : ['', '', '', ''];
      [i + 1, candidate.node < 0 ? 'C' : candidate.node, ...scores].forEach((text) => { row.insertCell().textContent = text; });
      const verdict = row.insertCell();
      verdict.textContent = moment.judged[i] ? verdictWords[candidate.verdict] : '';
      verdict.className = candidate.verdict === Verdict.accepted ? 'accepted' : candidate.verdict > Verdict.withdrawn ? 'rejected' : 'other';
      row.classList.toggle('chosen', i === chosen);
      row.onpointerenter = () => { chosen = i; draw(); };
      row.onpointerleave = () => { chosen = -1; draw(); };
      row.onclick = () => tell(i);
    });
  };
  const showFigures = () => {
    const mean = sizes.slice(0, position.done).reduce((sum, size) => sum + size, 0) / (position.done || 1);
    const counts = isImproved() ? [run.improved.elements.length / 3, run.improved.nodes.length / 2] :
      improving ? [improving.elements.length / 3, improving.nodes.length / 2 - improving.gone.size] : [firstElement[position.done], nodesAt[position.done]];
    const rows = [['Γ, segments of the front', sizes[position.done]], ['Elements', counts[0]], ['Nodes', counts[1]],
      ['Nb, mean of Γ', position.done ? number(mean) : '']];
    if (position.done === last) {
      const [alpha, least] = improving && !isImproved() ? run.improved.steps[improving.done - 1].f : isImproved() ? [run.improved.mean, run.improved.least] : [run.raw.mean, run.raw.least];
      rows.push(['α mean', alpha.toFixed(3)], ['α least', least.toFixed(3)]);
    }
    $('figures').tBodies[0].replaceChildren(...rows.map(([name, value]) => {
      const row = document.createElement('tr');
      row.insertCell().textContent = name;
      row.insertCell().textContent = value;
      return row;
    }));
  };
  const captionNow = (moment) => {
    if (improving) { return 'Improvement ' + improving.done + ' of ' + run.improved.total + ': ' + run.improved.steps[improving.done - 1].w; }
    if (isImproved()) { return 'The finished mesh after improvement' + (run.improved.total > 1 ? ' in ' + run.improved.total + ' steps' : ''); }
    if (!moment) { return 'Before the first advance: the boundary is the front Γ'; }
    if (moment.advance.thin) { return 'Advance ' + moment.number + ': this page has no details of it'; }
    return 'Advance ' + moment.number + '. Edge ' + moment.advance.base.join('–') + ': ' + moment.caption;
  };
  const drawPlot = () => {
    const plot = $('plot'), pen = plot.getContext('2d');
    fitCanvas(plot);
    const width = plot.clientWidth, height = plot.clientHeight, top = Math.max(...sizes);
    pen.clearRect(0, 0, width, height);
    const x = (k) => 6 + (width - 12) * k / (last + moments || 1), y = (size) => height - 3 - (height - 8) * size / top;
    pen.beginPath(); pen.moveTo(x(0), height);
    sizes.forEach((size, k) => pen.lineTo(x(k), y(size)));
    pen.lineTo(x(last), height); pen.closePath();
    pen.globalAlpha = .28; pen.fillStyle = colours.front; pen.fill(); pen.globalAlpha = 1;
    advances.forEach((advance, k) => { if (!advance.elements.length) { pen.fillStyle = colours.warn; pen.fillRect(x(k + 1) - 1, 2, 2, 5); } });
    pen.globalAlpha = .4; pen.fillStyle = colours.accepted; pen.fillRect(x(last), height - 6, x(last + moments) - x(last), 6); pen.globalAlpha = 1;
    pen.fillStyle = colours.text; pen.fillRect(x(position.done + position.improve) - 1, 0, 2, height);
  };
  /** Tells the page around the player, if there is one, what is shown. `place`: advances and steps of the improvement done;
   *  `picked`: the candidate clicked, or -1. */
  const tell = (picked = -1) => {
    if (embedded) { parent.postMessage({ forefront: 'moment', done: position.done, inner: position.event > 0, improve: position.improve, place: position.done + (isImproved() ? run.improved.total : position.improve), picked }, '*'); }
  };
  /** Puts the position into the address, so that it can be passed on. Browsers allow this only a few times a second. */
  const link = () => embedded || history.replaceState(null, '', '#' + position.done + (position.event ? '.' + position.event : '') + (isImproved() ? '.improved' : position.improve ? '.i' + position.improve : ''));
  let linked = 0;
  const show = () => {
    const moment = momentNow();
    chosen = -1;
    document.body.classList.toggle('improving', position.improve > 0);
    showSteps(moment); showCandidates(moment); showFigures(); drawPlot();
    $('caption').textContent = captionNow(moment);
    $('caption').title = captionNow(moment);
    $('position').textContent = isImproved() ? 'improved' : position.improve ? 'step ' + position.improve + ' / ' + moments : position.done + (position.event ? '+' + position.event : '') + ' / ' + last;
    const plot = $('plot');
    plot.setAttribute('aria-valuemin', 0); plot.setAttribute('aria-valuemax', last + moments); plot.setAttribute('aria-valuenow', position.done + position.improve);
    $('start').disabled = $('back').disabled = position.done === 0 && position.event === 0;
    clearTimeout(linked);
    linked = setTimeout(link, 250);
    draw();
    tell();
  };

  // ---- Controls ----

  const pressed = (id) => $(id).getAttribute('aria-pressed') === 'true';
  const press = (id, on) => $(id).setAttribute('aria-pressed', on);
  const speeds = [1, 2, 4, 8, 16, 32, 64]; // steps per second
  let timer = 0;
  const playing = () => timer !== 0;
  const pause = () => { clearTimeout(timer); timer = 0; shape(); };
  const tick = () => { timer = setTimeout(() => { if (stepForward($('unit').value)) { tick(); } else { pause(); } }, 1000 / speeds[$('speed').value]); };
  const shape = () => {
    $('play').querySelector('path').setAttribute('d', playing() ? 'M6 4h3v12H6zM12 4h3v12h-3z' : 'M6 4l10 6-10 6z');
    $('play').setAttribute('aria-label', playing() ? 'Pause' : 'Play');
  };
  const togglePlay = () => {
    if (playing()) { pause(); return; }
    if (isAtEnd()) { goTo(0); }
    tick(); shape();
  };
  const setFollowing = (on) => { following = on; press('follow', on); if (on) { follow(); draw(); } };
  const fit = () => { setFollowing(false); moveTo(whole()); };
  const toggle = (id) => { press(id, !pressed(id)); draw(); };
  const setTheme = (light) => { document.documentElement.classList.toggle('light', light); readColours(); drawPlot(); draw(); };
  const commands = {
    start: () => goTo(0), end: () => goTo(last, 0, moments), back: () => stepBack($('unit').value), next: () => stepForward($('unit').value),
    play: togglePlay, fit, follow: () => setFollowing(!following), cells: () => toggle('cells'), numbers: () => toggle('numbers'),
    theme: () => setTheme(!document.documentElement.classList.contains('light')) };
  for (const [id, command] of Object.entries(commands)) {
    $(id).onclick = () => { if (id !== 'play') { pause(); } command(); };
  }
  const keys = { ArrowRight: 'next', ArrowLeft: 'back', Home: 'start', End: 'end', ' ': 'play', f: 'fit', b: 'follow', g: 'cells', n: 'numbers', t: 'theme' };
  addEventListener('keydown', (event) => {
    const name = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    const field = event.target.tagName;
    if (!name || event.ctrlKey || event.altKey || event.metaKey || field === 'SELECT' || field === 'INPUT' || (field === 'BUTTON' && event.key === ' ')) { return; }
    event.preventDefault();
    if (name !== 'play') { pause(); }
    if (event.shiftKey && name === 'next') { stepForward('advance'); } else if (event.shiftKey && name === 'back') { stepBack('advance'); } else { commands[name](); }
  });

  const pointers = new Map();
  const spread = () => { const [p, q] = [...pointers.values()]; return { x: (p.x + q.x) / 2, y: (p.y + q.y) / 2, d: Math.hypot(p.x - q.x, p.y - q.y) }; };
  const zoomAt = (x, y, factor) => {
    const dx = x - canvas.clientWidth / 2, dy = canvas.clientHeight / 2 - y, wide = whole().zoom;
    const zoom = Math.min(Math.max(camera.zoom * factor, 0.2 * wide), 1e5 * wide);
    camera.x += dx / camera.zoom - dx / zoom;
    camera.y += dy / camera.zoom - dy / zoom;
    camera.zoom = zoom;
  };
  const free = () => { target = null; if (following) { following = false; press('follow', false); } };
  canvas.onpointerdown = (event) => { canvas.setPointerCapture(event.pointerId); pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY }); };
  canvas.onpointermove = (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) { return; }
    const pinch = pointers.size === 2 ? spread() : null;
    pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    if (event.offsetX === before.x && event.offsetY === before.y) { return; }
    free();
    if (pinch) {
      const now = spread();
      camera.x -= (now.x - pinch.x) / camera.zoom; camera.y += (now.y - pinch.y) / camera.zoom;
      zoomAt(now.x, now.y, now.d / (pinch.d || 1));
    } else if (pointers.size === 1) {
      camera.x -= (event.offsetX - before.x) / camera.zoom; camera.y += (event.offsetY - before.y) / camera.zoom;
    }
    draw();
  };
  canvas.onpointerup = canvas.onpointercancel = (event) => pointers.delete(event.pointerId);
  canvas.addEventListener('wheel', (event) => { event.preventDefault(); free(); zoomAt(event.offsetX, event.offsetY, Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015))); draw(); }, { passive: false });

  const plot = $('plot');
  const seek = (event) => { pause(); goAlong(Math.round(Math.min(1, Math.max(0, (event.offsetX - 6) / (plot.clientWidth - 12))) * (last + moments))); };
  plot.onpointerdown = (event) => { plot.setPointerCapture(event.pointerId); seek(event); };
  plot.onpointermove = (event) => { if (plot.hasPointerCapture(event.pointerId)) { seek(event); } };

  // ---- The page around ----

  /** { forefront: 'goTo', done, event, improve, follow, box, cells, numbers, bare }: box is [x0, y0, x1, y1], or null for the whole
   *  domain; bare: the mesh alone. */
  const obey = (wish) => {
    pause();
    following = wish.follow;
    press('follow', following);
    press('cells', wish.cells);
    press('numbers', wish.numbers);
    goTo(wish.done, wish.event, wish.improve);
    bare = wish.bare;
    draw();
    if (!following) {
      const [x0, y0, x1, y1] = wish.box || [0, 0, 0, 0];
      moveTo(wish.box ? { x: (x0 + x1) / 2, y: (y0 + y1) / 2, zoom: Math.min(canvas.clientWidth / (x1 - x0), canvas.clientHeight / (y1 - y0)) } : whole());
    }
  };
  if (embedded) {
    document.body.classList.add('embedded');
    addEventListener('message', (event) => {
      if (event.source === parent && event.data && event.data.forefront === 'goTo') { obey(event.data); }
      if (event.source === parent && event.data && event.data.forefront === 'theme') { setTheme(event.data.light); }
    });
  }

  // ---- Start ----

  stepWords.forEach((words, i) => {
    const row = document.createElement('li');
    for (const [tag, text] of [['b', i + 1], ['span', words], ['span', '']]) {
      const part = document.createElement(tag);
      part.textContent = text;
      row.append(part);
    }
    $('steps').append(row);
  });
  document.title = run.title;
  $('title').textContent = run.title;
  $('about').textContent = run.about;
  const place = /^#(\d+)(?:\.(\d+))?(\.improved|\.i\d+)?$/.exec(location.hash);
  if (place) {
    const done = Math.min(Number(place[1]), last), events = done < last ? advances[done].events.length : 1;
    Object.assign(position, { done, event: Math.max(0, Math.min(Number(place[2] || 0), events - 1)), improve: !place[3] || done < last ? 0 : Math.min(moments, place[3] === '.improved' ? moments : Number(place[3].slice(2))) });
    findStep();
  }
  document.documentElement.classList.toggle('light', matchMedia('(prefers-color-scheme: light)').matches);
  readColours();
  Object.assign(camera, whole());
  follow();
  show();
  new ResizeObserver(() => { drawPlot(); draw(); }).observe(canvas);
  if (embedded) { parent.postMessage({ forefront: 'ready' }, '*'); }
})();
