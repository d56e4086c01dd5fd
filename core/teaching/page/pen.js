/**
 * Returns what draws on a canvas: lines, polygons, arrows and labels at places of the plane. `camera`: { x, y, zoom }, the
 * middle of the canvas and pixels per unit; `colours`: by name.
 */
const penOf = (canvas, camera, colours) => {
  'use strict';
  const paint = canvas.getContext('2d');
  let taken = []; // rectangles of labels
  const at = ([x, y]) => [canvas.clientWidth / 2 + (x - camera.x) * camera.zoom, canvas.clientHeight / 2 - (y - camera.y) * camera.zoom];
  /** Gives a canvas as many pixels as it has on the screen. */
  const fit = (c) => {
    const ratio = devicePixelRatio || 1, width = Math.round(c.clientWidth * ratio), height = Math.round(c.clientHeight * ratio);
    if (c.width !== width || c.height !== height) { c.width = width; c.height = height; }
    c.getContext('2d').setTransform(ratio, 0, 0, ratio, 0, 0);
  };
  /** Begins a picture. */
  const begin = () => {
    fit(canvas);
    taken = [];
    paint.fillStyle = colours.canvas; paint.fillRect(0, 0, canvas.clientWidth, canvas.clientHeight);
  };
  const path = (points, closed) => {
    paint.beginPath();
    points.forEach((p, i) => { const [x, y] = at(p); if (i) { paint.lineTo(x, y); } else { paint.moveTo(x, y); } });
    if (closed) { paint.closePath(); }
  };
  const line = (points, colour, width, dash = []) => {
    path(points, false); paint.setLineDash(dash); paint.strokeStyle = colour; paint.lineWidth = width; paint.stroke(); paint.setLineDash([]);
  };
  const disc = (p, radius, fill) => { const [x, y] = at(p); paint.beginPath(); paint.arc(x, y, radius, 0, 2 * Math.PI); paint.fillStyle = fill; paint.fill(); };
  const ring = (p, radius, colour, width, dash = []) => {
    const [x, y] = at(p);
    paint.beginPath(); paint.setLineDash(dash); paint.arc(x, y, radius, 0, 2 * Math.PI); paint.strokeStyle = colour; paint.lineWidth = width; paint.stroke(); paint.setLineDash([]);
  };
  /** Draws a text on a plate, unless it would cover another one. `around`: then it may be elsewhere around its place. */
  const label = (p, dx, dy, text, colour, around = false) => {
    const [x, y] = at(p);
    paint.font = '12px ' + getComputedStyle(document.body).fontFamily;
    const width = paint.measureText(text).width, before = -dx - width - 8;
    const places = [[dx, dy], [before, dy], [dx, dy - 17], [dx, dy + 17], [before, dy - 17], [before, dy + 17]];
    const found = places.slice(0, around ? places.length : 1)
      .map(([a, b]) => [Math.min(Math.max(x + a, 2), canvas.clientWidth - width - 10), Math.min(Math.max(y + b, 2), canvas.clientHeight - 18)])
      .find(([left, top]) => !taken.some((r) => left < r[2] && left + width + 8 > r[0] && top < r[3] && top + 16 > r[1]));
    if (!found) { return; }
    const [left, top] = found;
    taken.push([left, top, left + width + 8, top + 16]);
    paint.globalAlpha = .88; paint.fillStyle = colours.popup; paint.fillRect(left, top, width + 8, 16); paint.globalAlpha = 1;
    paint.fillStyle = colour; paint.textBaseline = 'middle'; paint.fillText(text, left + 4, top + 8.5);
  };
  /** Draws elements: { list, corners, count }, with `corners` numbers of nodes for each, of which -1 is none. */
  const polygons = ({ list, corners, count }, coords, fill, stroke) => {
    paint.beginPath();
    for (let i = 0; i < corners * count; i += corners) {
      for (let k = 0; k < corners && list[i + k] >= 0; ++k) {
        const [x, y] = at([coords[2 * list[i + k]], coords[2 * list[i + k] + 1]]);
        if (k) { paint.lineTo(x, y); } else { paint.moveTo(x, y); }
      }
      paint.closePath();
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
  return { canvas, camera, colours, paint, at, fit, begin, path, line, disc, ring, label, polygons, arrow };
};
