'use strict';
(() => {
  const run = JSON.parse(document.getElementById('run').textContent);
  const $ = (id) => document.getElementById(id);
  const calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
  const embedded = parent !== window; // in a page of its own, such as that of a lesson
  const canvas = $('canvas');
  const model = modelOf(run), { advances, node, elements, nodesAt, sizes, cellsAt, isColoured } = model;
  const verdictWords = run.verdicts;
  const improvementName = isColoured ? 'Clean-up' : 'Improvement';

  // ---- The position: advances done, and events of the next one ----

  // position.improve: moments of the improvement after the last advance; the last of them is the improved mesh.
  const position = { done: Math.min(run.from, advances.length), event: 0, improve: 0 };
  const last = advances.length, moments = run.improved ? run.improved.moments : 0;
  const isImproved = () => moments > 0 && position.improve === moments;
  const isAtEnd = () => position.done === last && position.improve === moments;
  let values = null; // that colour the ground, for the page around: see picturesOf().values
  let bare = false; // the page around wants the mesh alone, until one moves on
  const goTo = (done, event = 0, improve = 0) => {
    const before = position.done === last ? position.improve : -1;
    position.done = Math.max(0, Math.min(last, done));
    position.event = position.done < last ? Math.max(0, Math.min(event, advances[position.done].events.length - 1)) : 0;
    position.improve = position.done === last ? Math.max(0, Math.min(moments, improve)) : 0;
    findStep(before + 1 === position.improve && before >= 0);
    bare = false;
    values = values && values.tint ? values : null; // ρ is the same all along
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
    const sorts = at ? events.slice(0, seen + 2).filter(([s]) => s === Step.sort) : [];
    const sorted = at ? events.slice(0, seen + 1).some(([s]) => s === Step.sort) : true;
    const judged = advance.candidates.map((candidate) => !at || (sorted && kAtSort.includes(candidate.verdict)));
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
      candidates: at ? at[4] : advance.candidates.length, test: at ? at[2] : -1,
      trying: at && step === Step.test ? at[1] : -1, ranked: sorts.length > 0 ? sorts.at(-1)[1] : 0, updated: step >= Step.update && advance.elements.length > 0,
      caption: at ? run.words[at[6]] : advance.thin ? '' : run.words[advance.outcome] };
  };

  // ---- The improvement ----

  const improved = run.improved ? { nodes: run.improved.nodes, edges: run.improved.edges,
    cells: { list: run.improved.elements, corners: run.improved.corners, count: run.improved.elements.length / run.improved.corners } } : null;
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
    if (isImproved() && !gliding) { return improved; }
    if (!improving) { return null; }
    const left = gliding ? (1 - Math.min(1, Math.max(0, (performance.now() - glideStart) / kGlide))) ** 3 : 0;
    const nodes = left === 0 ? improving.nodes : improving.nodes.map((v, i) => {
      const from = gliding.get(Math.floor(i / 2));
      return from ? v + left * (from[i % 2] - v) : v;
    });
    return { nodes, cells: improving.cells, edges: run.edges, gone: improving.gone };
  };

  // ---- The camera ----

  const camera = { x: 0, y: 0, zoom: 1 }; // of the middle of the canvas; pixels per unit
  let target = null, following = true, chosen = -1;
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (const nodes of improved ? [run.nodes, improved.nodes] : [run.nodes]) {
    for (let i = 0; i < nodes.length; i += 2) {
      box[0] = Math.min(box[0], nodes[i]); box[2] = Math.max(box[2], nodes[i]);
      box[1] = Math.min(box[1], nodes[i + 1]); box[3] = Math.max(box[3], nodes[i + 1]);
    }
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
    const places = [...moved.flatMap(([from, to]) => [from, to]), ...lost.flat(), ...added, ...removed, ...made.flat().filter((n) => n >= 0).map((n) => nodes.slice(2 * n, 2 * n + 2))];
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

  const colours = {};
  let drawn = false;
  const pen = penOf(canvas, camera, colours), { at, line, label } = pen, picture = picturesOf(run, model, pen);
  const readColours = () => {
    const style = getComputedStyle(document.documentElement);
    for (const name of ['canvas', 'domain', 'popup', 'text', 'muted', 'bad', 'boundary', 'mesh', 'element', 'front', 'base', 'core', 'accepted', 'candidate', 'visited', 'accent', 'faint', 'inset', 'warn', 'edge']) {
      colours[name] = style.getPropertyValue('--' + name).trim();
    }
  };
  const draw = () => {
    drawn = true;
    pen.begin();
    pen.polygons({ list: elements, corners: 3, count: elements.length / 3 }, run.nodes, colours.domain, colours.domain);
    const moment = momentNow();
    const mesh = meshNow();
    if (values) { picture.values(values, document.documentElement.classList.contains('light')); }
    pen.polygons(mesh ? mesh.cells : cellsAt(position.done), (mesh || run).nodes, values ? 'transparent' : colours.element, values ? colours.edge : colours.mesh);
    $('values').hidden = !values;
    const { edges, nodes } = mesh || run;
    for (let i = 0; i < edges.length; i += 2) {
      line([0, 1].map((k) => nodes.slice(2 * edges[i + k], 2 * edges[i + k] + 2)), colours.boundary, 1.6);
    }
    if (!mesh && !bare) { picture.front(position.done, moment); }
    if (moment && !bare) { picture.moment(moment, chosen, pressed('cells')); }
    if (improving) { picture.step(improving, gliding ? nodes : improving.nodes); }
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
    const scored = advance.candidates[accepted >= 0 ? accepted : moment.ranked];
    const set = (s, text) => { if (step >= s) { found[s - 1] = text; } };
    if (advance.thin) { return found; }
    set(Step.base, advance.base.join('–'));
    set(Step.spacing, number(advance.rho, 3));
    set(Step.ideal, '(' + advance.c.map((v) => number(v)).join(', ') + ')');
    set(Step.find, moment.candidates + grid);
    set(Step.score, scored ? [scored.alpha, scored.ac, scored.cb].map((v, i) => v.toFixed(i ? 2 : 3)).join(' · ') : '');
    set(Step.test, String(moment.tests));
    set(Step.update, advance.elements.length === 0 ? 'deferred' : isColoured ? (advance.elements.length > 3 ? 'square' : 'half a square') : advance.elements.length > 3 ? advance.elements.length / 3 + ' elements' : '');
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
      [i + 1, candidate.name || (candidate.node < 0 ? 'C' : candidate.node), ...scores].forEach((text) => { row.insertCell().textContent = text; });
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
    const counts = isImproved() ? [improved.cells.count, improved.nodes.length / 2] :
      improving ? [improving.cells.count, improving.nodes.length / 2 - improving.gone.size] : [cellsAt(position.done).count, nodesAt[position.done]];
    const rows = [['Γ, segments of the front', sizes[position.done]], ['Elements', counts[0]], ['Nodes', counts[1]],
      ['Nb, mean of Γ', position.done ? number(mean) : '']];
    const ofMesh = ({ mean: shape, least, irregular }) => irregular === undefined ? [shape, least] : [shape, least, irregular];
    const shapes = position.done < last ? [] : improving && !isImproved() ? run.improved.steps[improving.done - 1].f :
      isImproved() ? ofMesh(run.improved) : run.raw ? ofMesh(run.raw) : [];
    const names = isColoured ? ['Scaled Jacobian, mean', 'Scaled Jacobian, least'] : ['α mean', 'α least'];
    if (shapes.length > 2) { rows.push(['Irregular nodes', shapes[2]]); }
    names.forEach((name, k) => { if (k < shapes.length) { rows.push([name, shapes[k].toFixed(3)]); } });
    $('figures').tBodies[0].replaceChildren(...rows.map(([name, value]) => {
      const row = document.createElement('tr');
      row.insertCell().textContent = name;
      row.insertCell().textContent = value;
      return row;
    }));
  };
  const captionNow = (moment) => {
    if (improving) { return improvementName + ' ' + improving.done + ' of ' + run.improved.total + ': ' + run.improved.steps[improving.done - 1].w; }
    if (isImproved()) { return 'The finished mesh after ' + improvementName.toLowerCase() + (run.improved.total > 1 ? ' in ' + run.improved.total + ' steps' : ''); }
    if (!moment) { return 'Before the first advance: the boundary is the front Γ'; }
    if (moment.advance.thin) { return 'Advance ' + moment.number + ': this page has no details of it'; }
    return 'Advance ' + moment.number + '. Edge ' + moment.advance.base.join('–') + ': ' + moment.caption;
  };
  const drawPlot = () => {
    const plot = $('plot'), ink = plot.getContext('2d');
    pen.fit(plot);
    const width = plot.clientWidth, height = plot.clientHeight, top = Math.max(1, ...sizes);
    ink.clearRect(0, 0, width, height);
    const x = (k) => 6 + (width - 12) * k / (last + moments || 1), y = (size) => height - 3 - (height - 8) * size / top;
    ink.beginPath(); ink.moveTo(x(0), height);
    sizes.forEach((size, k) => ink.lineTo(x(k), y(size)));
    ink.lineTo(x(last), height); ink.closePath();
    ink.globalAlpha = .28; ink.fillStyle = colours.front; ink.fill(); ink.globalAlpha = 1;
    advances.forEach((advance, k) => { if (!advance.elements.length) { ink.fillStyle = colours.warn; ink.fillRect(x(k + 1) - 1, 2, 2, 5); } });
    ink.globalAlpha = .4; ink.fillStyle = colours.accepted; ink.fillRect(x(last), height - 6, x(last + moments) - x(last), 6); ink.globalAlpha = 1;
    ink.fillStyle = colours.text; ink.fillRect(x(position.done + position.improve) - 1, 0, 2, height);
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

  /** { forefront: 'goTo', done, event, improve, follow, box, cells, numbers, bare, values }: box is [x0, y0, x1, y1], or null for the
   *  whole domain; bare: the mesh alone; values: those that colour the ground, or null. */
  const obey = (wish) => {
    pause();
    following = wish.follow;
    press('follow', following);
    press('cells', wish.cells);
    press('numbers', wish.numbers);
    goTo(wish.done, wish.event, wish.improve);
    bare = wish.bare;
    values = wish.values;
    $('values').classList.toggle('tint', Boolean(values && values.tint));
    if (values) { ['name', 'from', 'to'].forEach((part) => { $('values').querySelector('.' + part).textContent = values[part]; }); }
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

  run.lines.forEach((words, i) => {
    const row = document.createElement('li');
    for (const [tag, text] of [['b', i + 1], ['span', words], ['span', '']]) {
      const part = document.createElement(tag);
      part.textContent = text;
      row.append(part);
    }
    $('steps').append(row);
  });
  document.body.classList.toggle('coloured', isColoured);
  if (isColoured) { ['shape', 'δ', 'δ'].forEach((text, k) => { $('candidates').tHead.rows[0].cells[2 + k].textContent = text; }); }
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
