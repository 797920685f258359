// The report of `gaitway simulate`: plays one trajectory, or two side by side, on a drawn robot, with curves and findings. No network, no
// library; what it shows stands in the element `data`.
'use strict';
(() => {
  const data = JSON.parse(document.getElementById('data').textContent);
  const model = data.model;
  const degrees = 180 / Math.PI;

  // ---- Figures

  function floats(text) {
    const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    return new Float32Array(bytes.buffer);
  }
  const courses = data.played.map((played) => {
    const course = { ...played.course, name: played.source, kind: played.kind, findings: played.findings };
    for (const field of ['angle', 'speed', 'torque', 'base', 'com', 'reference']) if (course[field]) course[field] = floats(course[field]);
    course.zmp = (course.zmp || []).map((zmp) => ({ ...zmp, at: floats(zmp.at), margin: floats(zmp.margin) }));
    return course;
  });
  const duration = Math.max(...courses.map((course) => (course.rows - 1) * course.step_s));
  const start = courses[0].start_s;
  // All run from their own beginnings; the clock is the first one's.
  const rowAt = (course, time) => Math.max(0, Math.min(course.rows - 1, Math.round(time / course.step_s)));
  const colours = ['--one', '--two'];
  const zmpColours = ['--planned', '--masses', '--cells', '--solver'];
  const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

  // ---- The page's elements

  function element(tag, attributes = {}, ...children) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
      if (name.startsWith('on')) made.addEventListener(name.slice(2), value);
      else made.setAttribute(name, value);
    }
    made.append(...children);
    return made;
  }
  const page = document.getElementById('page');

  // A canvas that is as fine as the screen, and is drawn anew with each frame that changes something.
  const pictures = [];
  function picture(height, draw) {
    const canvas = element('canvas', { height, tabindex: 0 });
    canvas.style.height = height + 'px';
    pictures.push(() => {
      const ratio = window.devicePixelRatio || 1;
      const width = canvas.clientWidth;
      if (width === 0) return;
      if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
        canvas.width = Math.round(width * ratio);
        canvas.height = Math.round(height * ratio);
      }
      const pen = canvas.getContext('2d');
      pen.setTransform(ratio, 0, 0, ratio, 0, 0);
      pen.clearRect(0, 0, width, height);
      pen.font = '12px system-ui, sans-serif';
      draw(pen, width, height);
    });
    return canvas;
  }

  // ---- Time

  let now = 0;
  let playing = false;
  let pace = 1;
  let stale = true;
  let last = 0;
  function seek(time) {
    now = Math.max(0, Math.min(duration, time));
    stale = true;
  }
  function frame(stamp) {
    if (playing) {
      now += (Math.min(stamp - last, 100) / 1000) * pace;
      if (now >= duration) now = 0;
      stale = true;
    }
    last = stamp;
    if (stale) {
      stale = false;
      slider.value = now;
      clock.textContent = (start + now).toFixed(3) + ' s';
      for (const draw of pictures) draw();
    }
    requestAnimationFrame(frame);
  }
  function play(on) {
    playing = on;
    playButton.textContent = on ? 'Pause' : 'Play';
  }
  const playButton = element('button', { type: 'button', onclick: () => play(!playing) }, 'Play');
  const slider = element('input', { type: 'range', min: 0, max: duration, step: 0.001, value: 0, 'aria-label': 'Time', oninput: () => seek(+slider.value) });
  const clock = element('span', { class: 'clock' });
  const paces = [0.02, 0.05, 0.1, 0.25, 0.5, 1, 2, 4];
  const paceChoice = element('select', { 'aria-label': 'Speed', onchange: () => { pace = +paceChoice.value; } },
    ...paces.map((value) => element('option', { value, ...(value === 1 ? { selected: '' } : {}) }, value + ' ×')));
  const step = (rows) => { play(false); seek(Math.round(now / courses[0].step_s + rows) * courses[0].step_s); };
  document.addEventListener('keydown', (event) => {
    if (['SELECT', 'INPUT', 'BUTTON'].includes(event.target.tagName) && event.key === ' ') return;
    const keys = { ' ': () => play(!playing), ArrowLeft: () => step(-1), ArrowRight: () => step(1), Home: () => seek(0), End: () => seek(duration) };
    if (!keys[event.key] || event.target.tagName === 'SELECT') return;
    event.preventDefault();
    keys[event.key]();
  });

  // ---- The robot

  // Rotations are rows of nine, poses {r, p}.
  const multiply = (a, b) => a.map((_, i) => { const row = 3 * Math.floor(i / 3), column = i % 3; return a[row] * b[column] + a[row + 1] * b[3 + column] + a[row + 2] * b[6 + column]; });
  const turn = (r, v) => [r[0] * v[0] + r[1] * v[1] + r[2] * v[2], r[3] * v[0] + r[4] * v[1] + r[5] * v[2], r[6] * v[0] + r[7] * v[1] + r[8] * v[2]];
  const move = (pose, v) => turn(pose.r, v).map((x, i) => x + pose.p[i]);
  const poseOf = (m) => ({ r: [m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]], p: [m[3], m[7], m[11]] });
  const compose = (a, b) => ({ r: multiply(a.r, b.r), p: move(a, b.p) });
  function about([x, y, z], angle) {
    const c = Math.cos(angle), s = Math.sin(angle), d = 1 - c;
    return [c + x * x * d, x * y * d - z * s, x * z * d + y * s, y * x * d + z * s, c + y * y * d, y * z * d - x * s, z * x * d - y * s, z * y * d + x * s, c + z * z * d];
  }
  function ofQuaternion(w, x, y, z) {
    return [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x), 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)];
  }
  const joints = model.joints.map((joint) => ({ ...joint, origin: poseOf(joint.origin) }));
  const links = model.links.map((link) => ({ ...link, shapes: link.shapes.map((shape) => ({ ...shape, pose: poseOf(shape.pose) })) }));
  function linkPoses(course, row) {
    const b = course.base.subarray(7 * row, 7 * row + 7);
    const poses = [{ r: ofQuaternion(b[3], b[4], b[5], b[6]), p: [b[0], b[1], b[2]] }];
    joints.forEach((joint, j) => {
      const before = compose(poses[joint.parent], joint.origin);
      poses[joint.child] = { r: multiply(before.r, about(joint.axis, course.angle[row * joints.length + j])), p: before.p };
    });
    return poses;
  }
  const stands = (course, row, side) => 'BLR'.indexOf(course.contact[row]) >= 0 && course.contact[row] !== 'RL'[side];
  const soleCorners = (poses, side) => model.feet[side].corners.map((corner) => move(poses[model.feet[side].link], corner));

  // Andrew's monotone chain.
  function hull(points) {
    const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    const half = (list) => {
      const kept = [];
      for (const p of list) {
        while (kept.length > 1) {
          const [a, b] = kept.slice(-2);
          if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
          kept.pop();
        }
        kept.push(p);
      }
      return kept.slice(0, -1);
    };
    return [...half(sorted), ...half(sorted.reverse())];
  }
  function support(course, row, poses) {
    const corners = [];
    for (const side of [0, 1]) if (stands(course, row, side)) corners.push(...soleCorners(poses, side));
    return corners.length ? hull(corners) : [];
  }

  function outline(pen, points, close) {
    pen.beginPath();
    points.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
    if (close) pen.closePath();
  }
  function dot(pen, [x, y], radius, fill) {
    pen.beginPath();
    pen.arc(x, y, radius, 0, 2 * Math.PI);
    pen.fillStyle = fill;
    pen.fill();
  }

  const camera = { yaw: -0.9, pitch: 0.28, zoom: 1 };
  const height = Math.max(...[0, 1].map(() => courses[0].base[2])) * 2.1 || 1;
  const bad = (course, time, links) => course.findings.filter((f) => f.rule === 'self-collision' && time >= f.from_s - 0.005 && time <= f.to_s + 0.005)
    .some((f) => f.what.split(' in ').includes(links));

  function drawRobot(pen, width, high, course, mine) {
    const row = rowAt(course, now);
    const poses = linkPoses(course, row);
    const scale = (0.8 * high * camera.zoom) / height;
    const centre = [poses[0].p[0], poses[0].p[1], 0.45 * height];
    const [cy, sy, cp, sp] = [Math.cos(camera.yaw), Math.sin(camera.yaw), Math.cos(camera.pitch), Math.sin(camera.pitch)];
    const project = (point) => {
      const [x, y, z] = point.map((value, i) => value - centre[i]);
      const along = cy * x - sy * y;
      const away = sy * x + cy * y;
      return [width / 2 + scale * away, high / 2 - scale * (cp * z - sp * along), along];
    };
    floor(pen, project, poses[0].p);
    const area = support(course, row, poses);
    if (area.length) {
      outline(pen, area.map(([x, y]) => project([x, y, 0])), true);
      pen.globalAlpha = 0.25;
      pen.fillStyle = colour('--good');
      pen.fill();
      pen.globalAlpha = 1;
    }
    const time = course.start_s + row * course.step_s;
    links.forEach((link, l) => {
      const hit = bad(course, time, link.name);
      for (const shape of link.shapes) box(pen, project, compose(poses[l], shape.pose), shape.size, hit ? colour('--bad') : colour(mine));
    });
    pen.lineWidth = 3;
    pen.lineCap = 'round';
    pen.strokeStyle = colour(mine);
    for (const joint of joints) {
      outline(pen, [project(poses[joint.parent].p), project(poses[joint.child].p)]);
      pen.stroke();
    }
    joints.forEach((joint, j) => {
      const angle = course.angle[row * joints.length + j];
      const beyond = angle > joint.upper + 1e-5 || angle < joint.lower - 1e-5;
      dot(pen, project(poses[joint.child].p), beyond ? 5 : 3, beyond ? colour('--bad') : colour('--ink'));
    });
    for (const side of [0, 1]) {
      outline(pen, soleCorners(poses, side).map(project), true);
      pen.lineWidth = stands(course, row, side) ? 3 : 1;
      pen.strokeStyle = stands(course, row, side) ? colour('--good') : colour('--soft');
      pen.stroke();
    }
    for (const zmp of course.zmp) {
      const at = zmp.at.subarray(2 * row, 2 * row + 2);
      if (Number.isFinite(at[0])) dot(pen, project([at[0], at[1], 0]), 5, colour(zmpColours[zmp.place]));
    }
  }
  function floor(pen, project, [x, y]) {
    pen.strokeStyle = colour('--line');
    pen.lineWidth = 1;
    const cell = height > 1.6 ? 0.5 : 0.2;
    const [left, low] = [Math.round(x / cell), Math.round(y / cell)];
    for (let i = -4; i <= 4; ++i) {
      outline(pen, [project([(left + i) * cell, (low - 4) * cell, 0]), project([(left + i) * cell, (low + 4) * cell, 0])]);
      pen.stroke();
      outline(pen, [project([(left - 4) * cell, (low + i) * cell, 0]), project([(left + 4) * cell, (low + i) * cell, 0])]);
      pen.stroke();
    }
  }
  const edges = [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];
  function box(pen, project, pose, size, stroke) {
    const corners = [...Array(8).keys()].map((i) => project(move(pose, [0, 1, 2].map((k) => (i >> (2 - k) & 1 ? 0.5 : -0.5) * size[k]))));
    outline(pen, hull(corners), true);
    pen.globalAlpha = 0.12;
    pen.fillStyle = stroke;
    pen.fill();
    pen.globalAlpha = 0.55;
    pen.strokeStyle = stroke;
    pen.lineWidth = 1;
    for (const [a, b] of edges) {
      outline(pen, [corners[a], corners[b]]);
      pen.stroke();
    }
    pen.globalAlpha = 1;
  }
  function turnable(canvas) {
    let from = null;
    canvas.addEventListener('pointerdown', (event) => { from = [event.clientX, event.clientY]; canvas.setPointerCapture(event.pointerId); });
    canvas.addEventListener('pointermove', (event) => {
      if (!from) return;
      camera.yaw += (event.clientX - from[0]) * 0.01;
      camera.pitch = Math.max(-0.2, Math.min(1.57, camera.pitch + (event.clientY - from[1]) * 0.01));
      from = [event.clientX, event.clientY];
      stale = true;
    });
    canvas.addEventListener('pointerup', () => { from = null; });
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      camera.zoom = Math.max(0.4, Math.min(5, camera.zoom * Math.exp(-event.deltaY * 0.001)));
      stale = true;
    }, { passive: false });
    return canvas;
  }

  // ---- ZMP from above

  function drawAbove(pen, width, high, course) {
    const row = rowAt(course, now);
    const poses = linkPoses(course, row);
    const feet = [0, 1].map((side) => soleCorners(poses, side));
    const all = feet.flat();
    const middle = [0, 1].map((k) => (Math.max(...all.map((c) => c[k])) + Math.min(...all.map((c) => c[k]))) / 2);
    const heading = Math.atan2(poses[0].r[3], poses[0].r[0]);
    const [c, s] = [Math.cos(heading), Math.sin(heading)];
    const scale = Math.min(width, high) / (0.5 * height);
    // Ahead is up, left is left.
    const project = ([x, y]) => {
      const [dx, dy] = [x - middle[0], y - middle[1]];
      return [width / 2 - scale * (-s * dx + c * dy), high / 2 - scale * (c * dx + s * dy)];
    };
    const area = support(course, row, poses);
    if (area.length) {
      outline(pen, area.map(project), true);
      pen.globalAlpha = 0.2;
      pen.fillStyle = colour('--good');
      pen.fill();
      pen.globalAlpha = 1;
      pen.strokeStyle = colour('--good');
      pen.stroke();
    }
    feet.forEach((corners, side) => {
      outline(pen, corners.map(project), true);
      pen.lineWidth = stands(course, row, side) ? 2 : 1;
      pen.strokeStyle = stands(course, row, side) ? colour('--good') : colour('--soft');
      pen.stroke();
    });
    const trail = Math.round(0.5 / course.step_s);
    for (const zmp of course.zmp) {
      pen.strokeStyle = colour(zmpColours[zmp.place]);
      pen.lineWidth = 1.5;
      const way = [];
      for (let i = Math.max(0, row - trail); i <= Math.min(course.rows - 1, row + trail); ++i)
        if (Number.isFinite(zmp.at[2 * i])) way.push(project([zmp.at[2 * i], zmp.at[2 * i + 1]]));
      pen.globalAlpha = 0.5;
      outline(pen, way);
      pen.stroke();
      pen.globalAlpha = 1;
      if (Number.isFinite(zmp.at[2 * row])) dot(pen, project([zmp.at[2 * row], zmp.at[2 * row + 1]]), 5, colour(zmpColours[zmp.place]));
    }
    const com = project(course.com.subarray(3 * row, 3 * row + 2));
    pen.strokeStyle = colour('--ink');
    pen.lineWidth = 1.5;
    outline(pen, [[com[0] - 7, com[1]], [com[0] + 7, com[1]]]);
    pen.stroke();
    outline(pen, [[com[0], com[1] - 7], [com[0], com[1] + 7]]);
    pen.stroke();
    scaleBar(pen, high, scale);
  }
  function scaleBar(pen, high, scale) {
    pen.strokeStyle = pen.fillStyle = colour('--soft');
    outline(pen, [[12, high - 14], [12 + 0.05 * scale, high - 14]]);
    pen.stroke();
    pen.fillText('50 mm', 12, high - 20);
  }

  // ---- Curves

  // `lines`: {course, value(row), colour, dashed}; `limits`: levels.
  // `marks`: {course, time_s, value, fill}. `span`: what fills the picture at least.
  function plot(title, unit, high, span, linesOf, limitsOf, marks = []) {
    let range = null, shown = null;
    const left = 56, right = 12, top = 10, bottom = 24;
    const canvas = picture(high, (pen, width) => {
      const lines = linesOf(), limits = limitsOf();
      if (shown !== title()) {
        range = rangeOf(lines, limits, span);
        shown = title();
      }
      const x = (time) => left + (time / Math.max(duration, 1e-9)) * (width - left - right);
      const y = (value) => top + ((range[1] - value) / (range[1] - range[0])) * (high - top - bottom);
      axes(pen, width, high, x, y, range, unit, { left, right, top, bottom });
      pen.save();
      pen.beginPath();
      pen.rect(left, top, width - left - right, high - top - bottom);
      pen.clip();
      pen.setLineDash([6, 4]);
      pen.strokeStyle = colour('--bad');
      pen.lineWidth = 1;
      for (const level of limits) {
        outline(pen, [[left, y(level)], [width - right, y(level)]]);
        pen.stroke();
      }
      for (const line of lines) curve(pen, line, x, y);
      for (const { course, time_s, value, fill } of marks) dot(pen, [x(time_s - course.start_s), y(value)], 4, colour(fill));
      pen.restore();
      pen.setLineDash([]);
      pen.strokeStyle = colour('--ink');
      outline(pen, [[x(now), top], [x(now), high - bottom]]);
      pen.stroke();
    });
    const jump = (event) => {
      if (event.buttons === 0) return;
      const box = canvas.getBoundingClientRect();
      seek(((event.clientX - box.left - left) / (box.width - left - right)) * duration);
    };
    canvas.addEventListener('pointerdown', jump);
    canvas.addEventListener('pointermove', jump);
    return canvas;
  }
  function curve(pen, { course, value, stroke, dashed }, x, y) {
    pen.setLineDash(dashed ? [3, 3] : []);
    pen.strokeStyle = colour(stroke);
    pen.lineWidth = 1.6;
    pen.beginPath();
    let down = false;
    for (let row = 0; row < course.rows; ++row) {
      const at = value(row);
      if (!Number.isFinite(at)) { down = false; continue; }
      if (down) pen.lineTo(x(row * course.step_s), y(at));
      else pen.moveTo(x(row * course.step_s), y(at));
      down = true;
    }
    pen.stroke();
  }
  function rangeOf(lines, limits, least) {
    let [low, top] = [Infinity, -Infinity];
    for (const { course, value } of lines) {
      for (let row = 0; row < course.rows; ++row) {
        const at = value(row);
        if (Number.isFinite(at)) { low = Math.min(low, at); top = Math.max(top, at); }
      }
    }
    if (low > top) [low, top] = [0, 1];
    const more = Math.max(0, least - (top - low)) / 2;
    low -= more;
    top += more;
    const span = top - low;
    // A limit that is near is shown.
    for (const level of limits) if (level > low - span && level < top + span) { low = Math.min(low, level); top = Math.max(top, level); }
    const edge = 0.06 * Math.max(top - low, 1e-6);
    return [low - edge, top + edge];
  }
  function ticks(low, top, wanted) {
    const raw = (top - low) / wanted, power = 10 ** Math.floor(Math.log10(raw));
    const size = [1, 2, 5, 10].find((factor) => raw <= factor * power) * power;
    const list = [];
    for (let at = Math.ceil(low / size) * size; at <= top + 1e-9; at += size) list.push([at, at.toFixed(Math.max(0, -Math.floor(Math.log10(size) + 1e-9)))]);
    return list;
  }
  function axes(pen, width, high, x, y, range, unit, { left, right, bottom }) {
    pen.strokeStyle = colour('--line');
    pen.fillStyle = colour('--soft');
    pen.lineWidth = 1;
    pen.textAlign = 'right';
    pen.textBaseline = 'middle';
    for (const [at, label] of ticks(range[0], range[1], 4)) {
      outline(pen, [[left, y(at)], [width - right, y(at)]]);
      pen.stroke();
      pen.fillText(label, left - 6, y(at));
    }
    pen.textAlign = 'center';
    for (const [at, label] of ticks(start, start + duration, Math.max(2, width / 110))) pen.fillText(label + ' s', x(at - start), high - bottom + 12);
    pen.textAlign = 'left';
    pen.textBaseline = 'alphabetic';
    pen.fillText(unit, 4, 12);
  }

  // ---- Put together

  const key = (stroke, text) => {
    const mark = element('i');
    mark.style.background = `var(${stroke})`;
    return element('span', { class: 'key' }, mark, text);
  };
  const captioned = (canvas, ...caption) => element('figure', {}, element('figcaption', {}, ...caption), canvas);
  const total = courses.reduce((sum, course) => sum + course.findings.length, 0);
  const headline = data.subject === 'zmp' ? 'ZMP' : 'Trajectory';

  page.append(
    element('h1', {}, `${headline}, without dynamics: ${courses.map((course) => course.name).join(' against ')}`),
    element('p', { class: total ? 'bad' : 'good' }, total ? `${total} finding${total > 1 ? 's' : ''}` : 'No finding'),
    ...data.played.map((played) => element('p', { class: 'soft' }, `${played.source} (${played.kind}, ${data.robot}): ${played.duration_s.toFixed(2)} s, ${played.rows} rows. `,
      ...played.notes.map((note) => note + '. '))),
    element('div', { class: 'bar' }, playButton, element('button', { type: 'button', 'aria-label': 'One row back', onclick: () => step(-1) }, '◀'),
      element('button', { type: 'button', 'aria-label': 'One row on', onclick: () => step(1) }, '▶'), paceChoice, slider, clock));

  const views = element('div', { class: courses.length > 1 ? 'views two' : 'views' });
  courses.forEach((course, i) => views.append(
    captioned(turnable(picture(380, (pen, width, high) => drawRobot(pen, width, high, course, colours[i]))), key(colours[i], course.name), 'drag to turn, wheel to zoom')));
  courses.forEach((course, i) => views.append(
    captioned(picture(380, (pen, width, high) => drawAbove(pen, width, high, course)), key('--good', 'support, from above'),
      ...course.zmp.map((zmp) => key(zmpColours[zmp.place], zmp.name)), courses.length > 1 ? `(${courses[i].name})` : '+ CoM')));
  page.append(views);

  const plots = element('div', { class: 'plots' });
  page.append(plots);
  for (const course of courses) {
    if (!course.zmp.length) continue;
    plots.append(element('h2', {}, `Margin of the ZMP inside the support: ${course.name}`),
      captioned(plot(() => 'margin', 'mm', 190, 20, () => course.zmp.map((zmp) => ({ course, value: (row) => 1000 * zmp.margin[row], stroke: zmpColours[zmp.place] })), () => [0],
        course.zmp.map((zmp) => ({ course, time_s: zmp.least_at_s, value: 1000 * zmp.least_m, fill: zmpColours[zmp.place] }))),
        ...course.zmp.map((zmp) => key(zmpColours[zmp.place], `${zmp.name}: least ${(1000 * zmp.least_m).toFixed(1)} mm at ${zmp.least_at_s.toFixed(3)} s`))));
  }
  // First comes the joint of a finding, or else the one that works hardest.
  const share = (j) => Math.max(...data.played.map((played) => (played.joints ? played.joints[j].torque_share : 0)));
  const found = courses.flatMap((course) => course.findings).map((f) => joints.findIndex((joint) => joint.name === f.what)).find((j) => j >= 0) ?? -1;
  const worst = found >= 0 ? found : joints.reduce((best, _, j) => (share(j) > share(best) ? j : best), 0);
  const choice = element('select', { 'aria-label': 'Joint', onchange: () => { stale = true; } },
    ...joints.map((joint, j) => element('option', { value: j, ...(j === worst ? { selected: '' } : {}) }, joint.name)));
  const chosen = () => +choice.value;
  const linesOf = (field, factor) => () => courses.flatMap((course, i) => {
    const line = (values, dashed) => ({ course, value: (row) => factor * values[row * joints.length + chosen()], stroke: colours[i], dashed });
    return [...(field === 'angle' && course.reference ? [line(course.reference, true)] : []), line(course[field], false)];
  });
  plots.append(element('h2', {}, 'Joint ', choice));
  const legend = () => courses.map((course, i) => key(colours[i], course.name));
  plots.append(
    captioned(plot(() => 'angle' + chosen(), 'deg', 190, 2, linesOf('angle', degrees), () => [joints[chosen()].lower * degrees, joints[chosen()].upper * degrees]), ...legend(), 'angle; dotted: what the servos are given; dashed: stops'),
    captioned(plot(() => 'speed' + chosen(), 'rad/s', 160, 0.2, linesOf('speed', 1), () => [-joints[chosen()].speed, joints[chosen()].speed]), ...legend(), 'speed'),
    captioned(plot(() => 'torque' + chosen(), 'N·m', 160, 0.2, linesOf('torque', 1), () => [-joints[chosen()].torque, joints[chosen()].torque]), ...legend(), 'torque by inverse dynamics; dashed: the motor at standstill'));

  function jumpTo(course, time, joint) {
    play(false);
    if (joint >= 0) choice.value = joint;
    seek(time - course.start_s);
    window.scrollTo({ top: 0, behavior: 'smooth' });
  }
  for (const course of courses) {
    page.append(element('h2', {}, `Findings: ${course.name}`));
    if (!course.findings.length) { page.append(element('p', { class: 'good' }, 'none')); continue; }
    page.append(element('div', { class: 'scroll' }, element('table', {}, element('thead', {}, element('tr', {},
      ...['at s', 'what', 'rule', 'value', 'limit', 'from s', 'to s'].map((name, i) => element('th', i === 1 || i === 2 ? { class: 'text' } : {}, name)))),
    element('tbody', {}, ...course.findings.map((f) => {
      const go = () => jumpTo(course, f.at_s, joints.findIndex((joint) => joint.name === f.what));
      return element('tr', { class: 'jump', tabindex: 0, onclick: go, onkeydown: (event) => { if (event.key === 'Enter') go(); } },
        element('td', {}, f.at_s.toFixed(3)), element('td', { class: 'text' }, f.what), element('td', { class: 'text', title: f.meaning }, f.rule),
        element('td', {}, `${f.value.toPrecision(4)} ${f.unit}`), element('td', {}, `${f.limit.toPrecision(4)} ${f.unit}`),
        element('td', {}, f.from_s.toFixed(3)), element('td', {}, f.to_s.toFixed(3)));
    })))));
  }
  if (data.played.every((played) => played.joints)) {
    for (const played of data.played) {
      page.append(element('h2', {}, `Joints: ${played.source}`), element('div', { class: 'scroll' }, element('table', {}, element('thead', {}, element('tr', {},
        ...['joint', 'from deg', 'to deg', 'fastest rad/s', 'torque N·m', 'of the motor', ...(played.joints[0].largest_step_counts === undefined ? [] : ['counts a point'])].map((name) => element('th', {}, name)))),
      element('tbody', {}, ...played.joints.map((use) => element('tr', {}, element('td', {}, use.name), element('td', {}, (use.lowest_rad * degrees).toFixed(2)), element('td', {}, (use.highest_rad * degrees).toFixed(2)),
        element('td', {}, use.fastest_rad_per_s.toFixed(2)), element('td', {}, use.largest_torque_Nm.toFixed(2)), element('td', {}, (100 * use.torque_share).toFixed(0) + ' %'),
        ...(use.largest_step_counts === undefined ? [] : [element('td', {}, String(use.largest_step_counts))])))))));
    }
  }
  if (data.differences) {
    page.append(element('h2', {}, 'How they differ'), element('div', { class: 'scroll' }, element('table', {}, element('thead', {}, element('tr', {}, ...['joint', 'rms deg', 'largest deg', 'at s'].map((name) => element('th', {}, name)))),
      element('tbody', {}, ...data.differences.map((d) => element('tr', {}, element('td', {}, d.name), element('td', {}, (d.rms_rad * degrees).toFixed(3)), element('td', {}, (d.largest_rad * degrees).toFixed(3)), element('td', {}, d.largest_at_s.toFixed(3))))))));
  }

  // It begins at what is worst: the first finding, or else where a ZMP comes nearest to its support's edge.
  const [first] = courses;
  const leastZmp = first.zmp.reduce((least, zmp) => (least && least.least_m <= zmp.least_m ? least : zmp), null);
  if (first.findings.length) seek(first.findings[0].at_s - first.start_s);
  else if (leastZmp) seek(leastZmp.least_at_s - first.start_s);

  window.addEventListener('resize', () => { stale = true; });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => { stale = true; });
  requestAnimationFrame(frame);
})();
