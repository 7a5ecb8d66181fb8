'use strict';
// Draws solved problems. This file places things on the page; it computes no number of the solution.

const margin = {left: 46, right: 12, top: 22, bottom: 34};

/// Sizes of all drawings in CSS pixels, so that letters have one size on every screen.
const sheet = {width: 720, heights: {pressure: 300, surface: 180, stress: 272}};

/// Returns a number for readers: a few digits, and a real minus sign.
function shown(value, digits = 4) {
  if (value === null || Number.isNaN(value)) return '–';
  if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
  if (Math.abs(value) < 1e-14) return '0';
  const size = Math.abs(value);
  const text = size < 1e-3 || size >= 1e5 ? value.toExponential(digits - 1) : String(Number(value.toPrecision(digits)));
  return text.replace(/-/g, '−');
}

/// Returns about `count` round numbers between two.
function ticks(from, to, count) {
  const rough = (to - from) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map(k => k * power).find(k => k >= rough);
  const result = [];
  for (let k = Math.ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; ++k) result.push(k * step);
  return result;
}

/// Returns a linear scale from [from, to] to pixels.
function scale(from, to, low, high) {
  const at = value => low + (value - from) / (to - from) * (high - low);
  at.inverse = pixel => from + (pixel - low) / (high - low) * (to - from);
  at.from = from;
  at.to = to;
  return at;
}

function horizontal(support) { return scale(-1.25 * support, 1.25 * support, margin.left, sheet.width - margin.right); }

const tick = value => shown(Number(value.toPrecision(6)), 6);
const acrossTicks = x => ticks(x.from, x.to, sheet.width / 80);

function axes(x, y, top, bottom, unit) {
  const left = margin.left, right = sheet.width - margin.right;
  const across = acrossTicks(x).map(v =>
    `<line class="axis" x1="${x(v)}" x2="${x(v)}" y1="${bottom}" y2="${bottom + 5}"/><text x="${x(v)}" y="${bottom + 20}" text-anchor="middle">${tick(v)}</text>`);
  const up = y ? ticks(y.from, y.to, 4).map(v =>
    `<line class="grid" x1="${left}" x2="${right}" y1="${y(v)}" y2="${y(v)}"/><text x="${left - 6}" y="${y(v) + 4}" text-anchor="end">${tick(v)}</text>`) : [];
  return up.join('') + `<path class="axis" d="M${left} ${top}V${bottom}H${right}"/>` + across.join('') +
    `<text x="${right}" y="${bottom - 6}" text-anchor="end">x</text><text x="${left + 6}" y="${top - 6}">${unit}</text>`;
}

const point = (x, y) => `${x.toFixed(2)} ${y.toFixed(2)}`;

/// Draws pressure and friction, which are zero off the contact. An unbounded curve ends at the upper edge.
function drawPressure(home, samples, solution, x) {
  const mean = solution.resultants.mean_pressure;
  let highest = 1.25 * mean;
  for (const t of samples.traction) if (Number.isFinite(t)) highest = Math.max(highest, -1.08 * t);
  highest = Math.min(highest, 3.6 * mean);
  const top = margin.top, bottom = sheet.heights.pressure - margin.bottom;
  const y = scale(0, highest, bottom, top);
  const height = value => Math.max(y(Math.min(Math.abs(value), 3 * highest)), -1000);
  const lines = {pressure: '', shear: ''};
  for (const zone of solution.contact) {
    const inside = [];
    samples.x.forEach((place, i) => { if (place >= zone.left.x && place <= zone.right.x) inside.push(i); });
    if (inside.length === 0) continue;
    const curve = column => inside.map(i => point(x(samples.x[i]), height(samples[column][i]))).join('L');
    const begin = x(zone.left.x).toFixed(2), end = x(zone.right.x).toFixed(2);
    // At an end with unbounded pressure the curve leaves the picture.
    const from = `M${begin} ${bottom}` + (zone.left.sign < 0 ? `V${-bottom}` : ''), to = (zone.right.sign < 0 ? `L${end} ${-bottom}` : '') + `L${end} ${bottom}`;
    lines.pressure += `${from}L${curve('traction')}${to}`;
    lines.shear += `M${begin} ${bottom}L${curve('shear')}L${end} ${bottom}`;
  }
  const labels = solution.singular_points.filter(at => at.exponent === null || Math.abs(at.exponent) > 1e-12);
  let last = -Infinity, row = 0;
  const texts = labels.map(at => {
    const place = x(at.x);
    row = place - last < 62 ? row + 1 : 0;
    last = place;
    return `<text class="exponent" x="${place.toFixed(1)}" y="${top + 14 + 20 * (row % 4)}" text-anchor="middle">${at.exponent === null ? 'log' : shown(at.exponent, 3)}</text>`;
  });
  home.innerHTML = `<clipPath id="plot"><rect x="${margin.left}" y="${top}" width="${sheet.width - margin.left - margin.right}" height="${bottom - top + 1}"/></clipPath>` +
    axes(x, y, top, bottom, 'p, |t<tspan dy="3" font-size="9">t</tspan><tspan dy="-3">|</tspan>') +
    `<g clip-path="url(#plot)"><path class="pressure" d="${lines.pressure}"/><path class="shear" d="${lines.shear}"/></g>` + texts.join('');
}

/// Draws the indenter with its coatings above, and the body below.
function drawSurface(svg, samples, solution, state, support, x) {
  const top = 30, bottom = sheet.heights.surface - margin.bottom;
  const heights = Array.from(samples.profile);
  const surface = heights.map((psi, i) => psi - samples.gap[i]);
  const beyond = Array.from(samples.beyond.height);
  const all = heights.concat(surface, beyond).filter(Number.isFinite);
  const low = Math.min(...all), high = Math.max(...all);
  const room = Math.max(high - low, 1e-9);
  const y = scale(low - 0.5 * room, high + 0.35 * room, bottom, top);
  const indenter = heights.map((h, i) => point(x(samples.x[i]), y(h))).join('L');
  const known = samples.beyond.x.length / 2;
  const outside = (from, to) => beyond.slice(from, to).map((h, i) => point(x(samples.beyond.x[from + i]), y(h)));
  const body = [...outside(0, known), ...surface.map((h, i) => point(x(samples.x[i]), y(h))), ...outside(known, 2 * known)];
  const values = state.values.map(Number), largest = Math.max(...values, 1e-9);
  const bounds = [-support, ...state.jumps.map(Number), support].map(x);
  const wide = values.map((_, k) => Math.max(bounds[k + 1] - bounds[k], 0));
  const coats = values.map((f, k) => `<clipPath id="coating-${k}"><rect x="${bounds[k].toFixed(2)}" y="0" width="${wide[k].toFixed(2)}" height="${bottom}"/></clipPath>` +
    `<path d="M${indenter}" clip-path="url(#coating-${k})" fill="none" stroke="hsl(28 60% ${Math.round(84 - 44 * f / largest)}%)" stroke-width="18"/>`);
  const names = values.map((f, k) => wide[k] < 34 ? '' : `<text x="${(bounds[k] + wide[k] / 2).toFixed(2)}" y="12" text-anchor="middle">${wide[k] < 64 ? '' : 'f = '}${shown(f)}</text>`);
  const shape = `M${x(-support).toFixed(2)} 0L${indenter}L${x(support).toFixed(2)} 0Z`, arrow = state.sliding === '+x' ? 1 : -1;
  svg.innerHTML = `<clipPath id="indenter"><path d="${shape}"/></clipPath>` +
    `<path d="M${margin.left} ${bottom}L${body.join('L')}L${sheet.width - margin.right} ${bottom}Z" fill="#dfeaf3"/>` +
    `<path d="${shape}" fill="#d3d8de"/><g clip-path="url(#indenter)">${coats.join('')}</g>` +
    `<path d="M${indenter}" fill="none" stroke="#3c4650" stroke-width="1.5"/>` + names.join('') +
    `<path d="M${x(0) - 26 * arrow} 23h${52 * arrow}m${-9 * arrow} -5l${9 * arrow} 5l${-9 * arrow} 5" fill="none" stroke="#1b1f24" stroke-width="2"/>` +
    axes(x, null, bottom, bottom, '');
}

/// White without stress, dark under stress, so that it is readable in grey. t goes from 0 to 1.
function shade(t) {
  const stops = [[255, 255, 255], [197, 220, 236], [102, 163, 201], [44, 104, 150], [64, 36, 92], [33, 12, 40]];
  const at = Math.min(Math.max(t, 0), 1) * (stops.length - 1), k = Math.min(Math.floor(at), stops.length - 2);
  return stops[k].map((c, i) => c + (at - k) * (stops[k + 1][i] - c));
}

/// The stress of the darkest shade, in mean pressures.
const darkest = 1.5;

/// Draws the stresses, and a scale bar below them. A rigid base is grey.
function drawStress(canvas, stresses, columns, rows, mean, depth, x) {
  const small = new OffscreenCanvas(columns, rows), image = new ImageData(columns, rows);
  for (let i = 0; i < stresses.length; ++i) {
    image.data.set(Number.isNaN(stresses[i]) ? [150, 150, 150] : shade(stresses[i] / mean / darkest), 4 * i);
    image.data[4 * i + 3] = 255;
  }
  small.getContext('2d').putImageData(image, 0, 0);
  const context = canvas.getContext('2d'), bottom = sheet.heights.stress - margin.bottom - 42, left = margin.left, right = sheet.width - margin.right;
  const {width, heights: {stress: height}} = sheet;
  context.setTransform(canvas.width / width, 0, 0, canvas.height / height, 0, 0);
  context.clearRect(0, 0, width, height);
  context.imageSmoothingQuality = 'high';
  context.drawImage(small, left, 2, right - left, bottom - 2);
  const y = scale(0, depth, 2, bottom);
  context.strokeStyle = '#6b7480';
  context.strokeRect(left, 2, right - left, bottom - 2);
  context.fillStyle = '#1b1f24';
  context.font = '12px system-ui, "DejaVu Sans", sans-serif';
  context.textAlign = 'center';
  for (const v of acrossTicks(x)) context.fillText(tick(v), x(v), bottom + 20);
  context.textAlign = 'right';
  for (const v of ticks(0, depth, 3)) context.fillText(tick(v), left - 6, Math.max(y(v) + 4, 12));
  const bar = {left, top: bottom + 34, width: Math.min(260, right - left - 40), height: 12};
  for (let k = 0; k < bar.width; ++k) {
    context.fillStyle = `rgb(${shade((k + 0.5) / bar.width).join(' ')})`;
    context.fillRect(bar.left + k, bar.top, 1.5, bar.height);
  }
  context.strokeRect(bar.left, bar.top, bar.width, bar.height);
  context.fillStyle = '#1b1f24';
  context.textAlign = 'center';
  for (const v of [0, 0.5, 1, 1.5]) context.fillText(shown(v * mean, 3), bar.left + v / darkest * bar.width, bar.top + bar.height + 15);
}
