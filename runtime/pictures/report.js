"use strict";
// The page of a report: the way of the tool, curves, and a cursor that ties them to the lines.
const report = JSON.parse(document.getElementById("rob-report").textContent);
const motion = JSON.parse(document.getElementById("rob-motion").textContent);
const byId = (id) => document.getElementById(id);
const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const rows = motion.t.length;
const duration = rows ? motion.t[rows - 1] : 0;
const state = { row: 0, turn: -0.7, tilt: 0.6, zoom: 1, side: "free", playing: false };

// The last row at or before a time, by bisection.
function rowAt(time) {
  let low = 0, high = rows - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (motion.t[middle] <= time) low = middle; else high = middle - 1;
  }
  return Math.max(0, low);
}

// A canvas in the pixels of the screen.
function pen(canvas) {
  const share = window.devicePixelRatio || 1;
  const width = canvas.clientWidth, height = canvas.clientHeight;
  if (canvas.width !== Math.round(width * share) || canvas.height !== Math.round(height * share)) {
    canvas.width = Math.round(width * share);
    canvas.height = Math.round(height * share);
  }
  const ctx = canvas.getContext("2d");
  ctx.setTransform(share, 0, 0, share, 0, 0);
  ctx.clearRect(0, 0, width, height);
  return { ctx, width, height };
}

// ---- The way of the tool ----

const scene = (() => {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  const take = (point) => point.forEach((v, i) => {
    low[i] = Math.min(low[i], v);
    high[i] = Math.max(high[i], v);
  });
  for (let i = 0; i < rows; ++i) take([motion.tool[0][i], motion.tool[1][i], motion.tool[2][i]]);
  for (const segments of motion.shapes)
    for (let i = 0; i < segments.length; i += 3) take(segments.slice(i, i + 3));
  if (!Number.isFinite(low[0])) { low.fill(0); high.fill(1); }
  const centre = low.map((v, i) => (v + high[i]) / 2);
  const radius = Math.max(1, Math.hypot(...low.map((v, i) => high[i] - v)) / 2);
  return { centre, radius };
})();

// From the world, mm, to the canvas.
function projection(width, height) {
  const size = (Math.min(width, height) / 2 / scene.radius) * 0.92 * state.zoom;
  const [cx, cy, cz] = scene.centre;
  const flat = { xy: [0, 1], xz: [0, 2], yz: [1, 2] }[state.side];
  if (flat)
    return (p) => [width / 2 + (p[flat[0]] - scene.centre[flat[0]]) * size,
                   height / 2 - (p[flat[1]] - scene.centre[flat[1]]) * size];
  const ct = Math.cos(state.turn), st = Math.sin(state.turn);
  const ci = Math.cos(state.tilt), si = Math.sin(state.tilt);
  return (p) => {
    const x = p[0] - cx, y = p[1] - cy, z = p[2] - cz;
    const right = ct * x - st * y, far = st * x + ct * y;
    return [width / 2 + right * size, height / 2 - (ci * z + si * far) * size];
  };
}

function polyline(ctx, project, count, point, style, line) {
  ctx.strokeStyle = style;
  ctx.lineWidth = line;
  ctx.beginPath();
  for (let i = 0; i < count; ++i) {
    const [x, y] = project(point(i));
    if (i) ctx.lineTo(x, y); else ctx.moveTo(x, y);
  }
  ctx.stroke();
}

function drawSegments(ctx, project, segments, radii, scale, style) {
  ctx.strokeStyle = style;
  ctx.lineCap = "round";
  for (let i = 0; i * 6 < segments.length; ++i) {
    const [x0, y0] = project(segments.slice(6 * i, 6 * i + 3));
    const [x1, y1] = project(segments.slice(6 * i + 3, 6 * i + 6));
    ctx.lineWidth = Math.max(2, 2 * (radii[i] || 0) * scale);
    ctx.beginPath();
    ctx.moveTo(x0, y0);
    ctx.lineTo(x1, y1);
    ctx.stroke();
  }
}

// The ground as a grid, and the axes of the world.
function drawGround(ctx, project) {
  const step = Math.pow(10, Math.floor(Math.log10(scene.radius)));
  const reach = Math.ceil(scene.radius / step) * step;
  const [cx, cy] = scene.centre.map((v) => Math.round(v / step) * step);
  for (let v = -reach; v <= reach; v += step) {
    polyline(ctx, project, 2, (i) => [cx + v, cy + (i ? reach : -reach), 0], colour("--line"), 1);
    polyline(ctx, project, 2, (i) => [cx + (i ? reach : -reach), cy + v, 0], colour("--line"), 1);
  }
  const names = ["x", "y", "z"], colours = ["#c0392b", "#27803b", "#2c6fbb"];
  names.forEach((name, axis) => {
    const tip = [0, 0, 0];
    tip[axis] = scene.radius / 4;
    polyline(ctx, project, 2, (i) => (i ? tip : [0, 0, 0]), colours[axis], 2);
    const [x, y] = project(tip);
    ctx.fillStyle = colours[axis];
    ctx.fillText(name, x + 3, y - 3);
  });
}

function drawSpace() {
  const { ctx, width, height } = pen(byId("view3d"));
  ctx.font = "12px system-ui, sans-serif";
  const project = projection(width, height);
  const scale = (Math.min(width, height) / 2 / scene.radius) * 0.92 * state.zoom;
  drawGround(ctx, project);
  for (const thing of motion.obstacles)
    drawSegments(ctx, project, thing.segments, thing.radii, scale, colour("--faint"));
  if (motion.shapes.length) {
    const time = motion.t[state.row];
    let shape = 0;
    while (shape + 1 < motion.shape_t.length && motion.shape_t[shape + 1] <= time) ++shape;
    ctx.globalAlpha = 0.55;
    drawSegments(ctx, project, motion.shapes[shape], motion.radii, scale, colour("--body"));
    ctx.globalAlpha = 1;
  }
  const way = (from) => (i) => [from[0][i], from[1][i], from[2][i]];
  polyline(ctx, project, rows, way(motion.measured), colour("--measured"), 1);
  polyline(ctx, project, rows, way(motion.tool), colour("--plan"), 1.8);
  if (!rows) return;
  const [x, y] = project(way(motion.tool)(state.row));
  ctx.fillStyle = colour("--ink");
  ctx.beginPath();
  ctx.arc(x, y, 4.5, 0, 2 * Math.PI);
  ctx.fill();
}

// ---- Curves ----

const palette = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#b8860b", "#7a5cc0", "#7f7f7f"];

function axisCurves(values, limit, what) {
  const units = [...new Set(motion.axes.map((axis) => axis.unit))];
  return units.map((unit) => {
    const of = motion.axes.map((axis, i) => ({ axis, i })).filter(({ axis }) => axis.unit === unit);
    return {
      title: `${what}, ${unit}${limit === "v_max" ? "/s" : limit === "a_max" ? "/s²" : ""}`,
      lines: of.map(({ axis, i }) => ({ name: axis.name, values: values[i], colour: palette[i % 8] })),
      limits: limit ? [...new Set(of.map(({ axis }) => axis[limit]))] : [],
    };
  });
}

function allCurves() {
  const curves = [{ title: "speed of the flange, mm/s",
                    lines: [{ name: "speed", values: motion.speed, colour: palette[0] }], limits: [] }];
  curves.push(...axisCurves(motion.q, null, "position"));
  curves.push(...axisCurves(motion.qd, "v_max", "speed of the axes"));
  curves.push(...axisCurves(motion.qdd, "a_max", "acceleration of the axes"));
  if (motion.force)
    curves.push({ title: "force, N", limits: [],
                  lines: ["x", "y", "z"].map((name, i) => ({ name, values: motion.force[i], colour: palette[i] })) });
  if (report.clock === "system")
    curves.push({ title: "lateness of the cycle, µs", limits: [],
                  lines: [{ name: "late", values: motion.late_us, colour: palette[1] }] });
  return curves;
}

function extent(curve) {
  let low = Infinity, high = -Infinity;
  for (const line of curve.lines)
    for (const value of line.values) { low = Math.min(low, value); high = Math.max(high, value); }
  if (!(low <= high)) return [0, 1];
  const room = Math.max(1e-9, (high - low) * 0.08);
  return [low - room, high + room];
}

const shown = (value) => Number(value.toPrecision(4)).toString();

function drawCurve(curve) {
  const { ctx, width, height } = pen(curve.canvas);
  const [low, high] = curve.extent;
  const left = 8, right = width - 8, top = 36, bottom = height - 8;
  const x = (time) => left + (duration ? time / duration : 0) * (right - left);
  const y = (value) => bottom - ((value - low) / (high - low)) * (bottom - top);
  ctx.font = "12px system-ui, sans-serif";
  ctx.fillStyle = colour("--faint");
  ctx.fillText(curve.title, left, 14);
  ctx.save();
  ctx.beginPath();
  ctx.rect(left, top, right - left, bottom - top);
  ctx.clip();
  ctx.setLineDash([4, 4]);
  for (const limit of curve.limits) for (const value of [limit, -limit]) {
    ctx.strokeStyle = colour("--bad");
    ctx.beginPath();
    ctx.moveTo(left, y(value));
    ctx.lineTo(right, y(value));
    ctx.stroke();
  }
  ctx.setLineDash([]);
  ctx.lineWidth = 1.3;
  for (const line of curve.lines) {
    ctx.strokeStyle = line.colour;
    ctx.beginPath();
    for (let i = 0; i < rows; ++i)
      if (i) ctx.lineTo(x(motion.t[i]), y(line.values[i])); else ctx.moveTo(x(motion.t[i]), y(line.values[i]));
    ctx.stroke();
  }
  ctx.restore();
  if (!rows) return;
  const now = x(motion.t[state.row]);
  ctx.strokeStyle = colour("--ink");
  ctx.lineWidth = 1;
  ctx.beginPath();
  ctx.moveTo(now, top);
  ctx.lineTo(now, bottom);
  ctx.stroke();
  let at = left;
  for (const line of curve.lines) {
    const text = `${line.name} ${shown(line.values[state.row])}`;
    ctx.fillStyle = line.colour;
    ctx.fillText(text, at, 30);
    at += ctx.measureText(text).width + 12;
  }
}

const curves = allCurves();
for (const curve of curves) {
  curve.canvas = document.createElement("canvas");
  curve.canvas.className = "curve";
  curve.canvas.setAttribute("role", "img");
  curve.canvas.setAttribute("aria-label", curve.title);
  curve.extent = extent(curve);
  byId("curves").append(curve.canvas);
  const point = (event) => {
    if (event.type === "pointermove" && !event.buttons && event.pointerType !== "mouse") return;
    const box = curve.canvas.getBoundingClientRect();
    const share = (event.clientX - box.left - 8) / (box.width - 16);
    moveTo(Math.min(1, Math.max(0, share)) * duration);
  };
  curve.canvas.addEventListener("pointermove", point);
  curve.canvas.addEventListener("pointerdown", point);
}

// ---- The cursor ----

const lineRows = new Map();
for (const row of document.querySelectorAll("#lines tr[data-line]")) lineRows.set(row.dataset.line, row);
let marked = null;

function draw() {
  drawSpace();
  curves.forEach(drawCurve);
}

function moveTo(time) {
  if (!rows) return draw();
  state.row = rowAt(time);
  const at = motion.t[state.row];
  const line = motion.line_names[motion.line[state.row]];
  byId("cursor").value = duration ? (1000 * at) / duration : 0;
  byId("now").textContent = `${at.toFixed(2)} s${line && line !== "0" ? `, line ${line}` : ""}`;
  const row = lineRows.get(line);
  if (row !== marked) {
    if (marked) marked.classList.remove("now");
    if (row) row.classList.add("now");
    marked = row || null;
  }
  draw();
}

byId("cursor").addEventListener("input", (event) => moveTo((event.target.value / 1000) * duration));
byId("side").addEventListener("change", (event) => { state.side = event.target.value; draw(); });
byId("play").addEventListener("click", () => {
  state.playing = !state.playing;
  byId("play").textContent = state.playing ? "Pause" : "Play";
  if (!state.playing || !rows) return;
  const from = state.row >= rows - 1 ? 0 : motion.t[state.row];
  let begun = null;
  const step = (now) => {
    if (!state.playing) return;
    begun = begun === null ? now : begun;
    const time = from + (now - begun) / 1000;
    moveTo(time);
    if (time < duration) return requestAnimationFrame(step);
    state.playing = false;
    byId("play").textContent = "Play";
  };
  requestAnimationFrame(step);
});
for (const [name, row] of lineRows)
  row.addEventListener("click", () => {
    const first = motion.line.findIndex((index) => motion.line_names[index] === name);
    if (first >= 0) moveTo(motion.t[first]);
  });

// ---- Turning and zooming ----

const canvas = byId("view3d");
let drag = null;
canvas.addEventListener("pointerdown", (event) => {
  drag = { x: event.clientX, y: event.clientY, turn: state.turn, tilt: state.tilt };
  canvas.setPointerCapture(event.pointerId);
});
canvas.addEventListener("pointermove", (event) => {
  if (!drag) return;
  state.turn = drag.turn + (event.clientX - drag.x) / 150;
  state.tilt = Math.min(1.57, Math.max(-1.57, drag.tilt + (event.clientY - drag.y) / 150));
  drawSpace();
});
for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, () => { drag = null; });
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  state.zoom = Math.min(50, Math.max(0.2, state.zoom * Math.exp(-event.deltaY / 400)));
  drawSpace();
}, { passive: false });
canvas.addEventListener("keydown", (event) => {
  const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
  const zooms = { "+": 1.2, "=": 1.2, "-": 1 / 1.2 };
  if (turns[event.key]) {
    state.turn += turns[event.key][0];
    state.tilt = Math.min(1.57, Math.max(-1.57, state.tilt + turns[event.key][1]));
  } else if (zooms[event.key]) {
    state.zoom = Math.min(50, Math.max(0.2, state.zoom * zooms[event.key]));
  } else {
    return;
  }
  event.preventDefault();
  drawSpace();
});

// ---- Signals, output, events ----

function list(where, items, none) {
  if (!items.length) {
    where.textContent = none;
    where.className = "note";
    return;
  }
  const ul = document.createElement("ul");
  for (const item of items.slice(0, 1000)) {
    const li = document.createElement("li");
    li.textContent = item;
    ul.append(li);
  }
  where.append(ul);
}
const valueText = (value) => (value === true ? "ON" : value === false ? "OFF" : value);
list(byId("signals"), (report.signals || []).map((s) =>
  `${s.t.toFixed(3)} s, line ${s.line}: ${s.name} = ${valueText(s.value)}${s.unit ? " " + s.unit : ""}`),
  "No output was set.");
list(byId("events"), [...(report.output || []),
  ...(report.events || []).map((e) => `${e.t.toFixed(3)} s, line ${e.line}: ${e.kind}: ${e.text}`)],
  "Nothing was printed, and nothing happened.");

byId("plan-key").style.background = colour("--plan");
byId("measured-key").style.background = colour("--measured");
window.addEventListener("resize", draw);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
moveTo(0);
