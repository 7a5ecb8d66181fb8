'use strict';
// The page: controls that change the state, and one function that shows it.

const byId = id => document.getElementById(id);
let state = stateFrom(location.hash.slice(1), initial);
let explorer = null;
let shownResult = null;
let later = 0;

const places = {count: 45, beyond: 6, columns: 48, rows: 15, fineColumns: 200, fineRows: 60};

/// A slider and a field for one number of the state. A typed number may lie outside of the slider's range.
function slider(home, {label, least, most, step, get, set, place}) {
  const id = `${home.id}-${home.children.length}`;
  const box = document.createElement('div');
  box.className = place ? 'slider place' : 'slider';
  box.innerHTML = `<label for="${id}"></label><input type="range" min="${least}" max="${most}" step="${step}" id="${id}"><input type="number" step="any" aria-label="">`;
  const [name, range, field] = box.children;
  name.textContent = label;
  field.setAttribute('aria-label', label);
  range.addEventListener('input', () => { set(range.value); update(); });
  field.addEventListener('input', () => { if (field.value !== '') { set(field.value); update(); } });
  const refresh = () => {
    const value = get();
    if (document.activeElement !== range) range.value = value;
    if (document.activeElement !== field) field.value = value;
  };
  home.append(box);
  return refresh;
}

const controls = {fixed: [], size: [], friction: [], built: ''};

function buildControls() {
  const form = byId('controls');
  for (const name of ['profile', 'sliding']) {
    for (const radio of form.elements[name]) {
      radio.addEventListener('change', () => {
        state[name] = radio.value;
        if (name === 'profile' && profiles[radio.value].size) state.size = profiles[radio.value].size.value;
        update();
      });
    }
  }
  controls.fixed = [
    slider(byId('load'), {label: 'Load P, in units of E × length', least: 0.01, most: 1, step: 0.01, get: () => state.load, set: v => { state.load = v; }}),
    slider(byId('poisson'), {label: 'Poisson’s ratio ν', least: 0, most: 0.49, step: 0.01, get: () => state.poisson, set: v => { state.poisson = v; }}),
    slider(byId('thickness'), {label: `Thickness h of a layer on a rigid base; ${thickest}: the half-plane`, least: 0.5, most: thickest, step: 0.1, get: () => state.thickness, set: v => { state.thickness = v; }}),
  ];
  byId('add').addEventListener('click', () => {
    const last = Number(state.jumps.at(-1) ?? -profiles[state.profile].support);
    const place = (last + profiles[state.profile].support) / 2;
    state.jumps = [...state.jumps, decimal(place, 3)];
    state.values = [...state.values, state.values.at(-1) === '0.5' ? '0.1' : '0.5'];
    update();
  });
  byId('remove').addEventListener('click', () => {
    state.jumps = state.jumps.slice(0, -1);
    state.values = state.values.slice(0, -1);
    update();
  });
  byId('copy-file').addEventListener('click', () => copy(problemFile(state), 'The problem file is copied. Save it as problem.toml: steadyslide solve problem.toml gives these numbers.'));
  byId('copy-link').addEventListener('click', () => copy(location.href, 'The link is copied.'));
}

const decimal = (value, places) => String(Number(value.toFixed(places)));

async function copy(text, done) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const area = document.createElement('textarea');  // pages from a file may have no clipboard
    area.value = text;
    document.body.append(area);
    area.select();
    document.execCommand('copy');
    area.remove();
  }
  byId('copied').textContent = done;
}

/// Sliders for the sizes of the profile, and for each friction value and jump. They are made again when their number
/// changes.
function refreshControls() {
  const form = byId('controls');
  form.elements.profile.value = state.profile;
  form.elements.sliding.value = state.sliding;
  const built = `${state.profile} ${state.values.length} ${state.jumps.length}`;
  if (built !== controls.built) {
    controls.built = built;
    const {size, support} = profiles[state.profile];
    byId('size').replaceChildren();
    controls.size = size ? [slider(byId('size'), {label: size.label, least: 0.05, most: 1, step: 0.01, get: () => state.size, set: v => { state.size = v; }})] : [];
    byId('friction').replaceChildren();
    controls.friction = [];
    const home = byId('friction');
    state.values.forEach((_, k) => {
      controls.friction.push(slider(home, {label: `f${subscript(k + 1)}`, least: 0, most: 1, step: 0.01, get: () => state.values[k], set: v => { state.values[k] = v; }}));
      if (k < state.jumps.length) {
        controls.friction.push(slider(home, {label: `jump between f${subscript(k + 1)} and f${subscript(k + 2)} at x`, place: true, least: -support, most: support, step: 0.005, get: () => state.jumps[k], set: v => { state.jumps[k] = v; }}));
      }
    });
    byId('add').disabled = state.jumps.length >= mostJumps;
    byId('remove').disabled = state.jumps.length === 0;
    buildHandles();
  }
  for (const refresh of [...controls.fixed, ...controls.size, ...controls.friction]) refresh();
}
const subscript = k => String.fromCharCode(0x2080 + k);

/// Handles of the jumps on the drawing: the user drags them, or moves them by arrow keys. They stay the same elements
/// in all pictures, because one of them may have the focus.
function buildHandles() {
  const handles = byId('handles'), foot = sheet.heights.pressure - margin.bottom;
  handles.replaceChildren();
  state.jumps.forEach((_, k) => {
    const handle = document.createElementNS(handles.namespaceURI, 'g');
    handle.setAttribute('class', 'handle');
    handle.setAttribute('tabindex', '0');
    handle.setAttribute('role', 'slider');
    handle.setAttribute('aria-label', `Jump ${k + 1} of the friction, x`);
    handle.innerHTML = `<line y1="${margin.top}" y2="${foot}"/><rect x="-14" width="28" y="0" height="${foot + 20}"/><circle cy="${foot}" r="8"/>`;
    const moveTo = value => {
      const {support} = profiles[state.profile];
      const low = k > 0 ? Number(state.jumps[k - 1]) : -support, high = k + 1 < state.jumps.length ? Number(state.jumps[k + 1]) : support;
      state.jumps[k] = decimal(Math.min(Math.max(value, low + 0.005), high - 0.005), 3);
      update();
    };
    handle.addEventListener('pointerdown', event => { handle.setPointerCapture(event.pointerId); handle.focus(); event.preventDefault(); });
    handle.addEventListener('pointermove', event => {
      if (!handle.hasPointerCapture(event.pointerId)) return;
      const box = byId('pressure').getBoundingClientRect();
      moveTo(horizontal(profiles[state.profile].support).inverse((event.clientX - box.left) / box.width * sheet.width));
    });
    handle.addEventListener('keydown', event => {
      const step = {ArrowLeft: -0.01, ArrowDown: -0.01, ArrowRight: 0.01, ArrowUp: 0.01, PageDown: -0.1, PageUp: 0.1}[event.key];
      const end = {Home: -profiles[state.profile].support, End: profiles[state.profile].support}[event.key];
      if (step === undefined && end === undefined) return;
      event.preventDefault();
      moveTo(end ?? Number(state.jumps[k]) + step);
    });
    handles.append(handle);
  });
}

function placeHandles(x) {
  const {support} = profiles[state.profile];
  [...byId('handles').children].forEach((handle, k) => {
    handle.setAttribute('transform', `translate(${x(Number(state.jumps[k]) || 0).toFixed(2)} 0)`);
    handle.setAttribute('aria-valuemin', -support);
    handle.setAttribute('aria-valuemax', support);
    handle.setAttribute('aria-valuenow', state.jumps[k]);
  });
}

/// One update: solve, then show. Slower work follows when the user pauses.
function update() {
  if (!explorer) return;
  refreshControls();
  const {support} = profiles[state.profile];
  const x = horizontal(support);
  placeHandles(x);
  clearTimeout(later);
  later = setTimeout(rest, 200);
  const complaint = explorer.solve(problemFile(state));
  shownResult = complaint ? null : explorer.solution();
  const failed = complaint || shownResult.failed_condition;
  byId('complaint').hidden = !failed;
  byId('complaint').textContent = complaint || (failed ? `Not solved in double precision: ${failed}` : '');
  document.querySelector('main').classList.toggle('stale', Boolean(complaint));
  if (complaint) return;
  const beyond = Array.from({length: places.beyond}, (_, k) => 0.002 * 125 ** (k / (places.beyond - 1)) * support);
  const outside = [...beyond.map(d => -support - d).reverse(), ...beyond.map(d => support + d)];
  const samples = explorer.samples(places.count * (1 + state.jumps.length));
  samples.beyond = {x: outside, height: explorer.surface(outside)};
  drawPressure(byId('curves'), samples, shownResult, x);
  drawSurface(byId('surface'), samples, shownResult, state, support, x);
  showStresses(places.columns, places.rows, x);
  showNumbers(shownResult);
}

/// Makes the drawings as wide as the room for them.
function fit() {
  sheet.width = Math.round(Math.max(byId('pressure').getBoundingClientRect().width, 280));
  for (const [id, height] of Object.entries(sheet.heights)) byId(id).setAttribute('viewBox', `0 0 ${sheet.width} ${height}`);
  const canvas = byId('stress'), fine = Math.min(devicePixelRatio, 2);
  canvas.width = sheet.width * fine;
  canvas.height = sheet.heights.stress * fine;
  update();
}

function showStresses(columns, rows, x) {
  const depth = 0.3 * (x.to - x.from);
  drawStress(byId('stress'), explorer.stresses(x.from, x.to, depth, columns, rows), columns, rows, shownResult.resultants.mean_pressure, depth, x);
}

/// Draws finer stresses, sets the sentence for screen readers and the address, and shows if the independent rule
/// agrees.
function rest() {
  history.replaceState(null, '', `#${stateText(state)}`);
  if (!shownResult) return;
  const part = Number(state.thickness) < thickest ? 2 : 1;  // stresses of layers cost more
  showStresses(places.fineColumns / part, places.fineRows / part, horizontal(profiles[state.profile].support));
  byId('summary').innerHTML = sentence(shownResult);
  const check = explorer.residuals();
  const worst = Math.max(check.equation, check.load, check.penetration, check.tension);
  byId('method').textContent = `${shownResult.method === 'closed-form' ? 'A closed form' : 'The Riemann–Hilbert method'}, in double precision. ` +
    `Residuals by a quadrature that no solver uses: at most ${worst.toExponential(1).replace('-', '−')}` + (check.solved ? `. ${shownResult.uniqueness ? `It is the only solution, by the ${shownResult.uniqueness}` : 'No theorem says that it is the only solution'}.` : ', too large for a solution.');
}

/// Describes the picture in one sentence.
function sentence(solution) {
  const ends = solution.contact.map(zone => `from ${shown(zone.left.x, 3)} to ${shown(zone.right.x, 3)}`).join(' and ');
  const jump = solution.singular_points.find(at => at.kind.includes('jump') && at.sign < 0) ?? solution.singular_points.find(at => at.kind.includes('jump'));
  let text = `It slides to the ${state.sliding === '+x' ? 'right' : 'left'} and touches ${ends}. `;
  if (jump && jump.sign < 0) text += `At the jump x = ${shown(jump.x, 3)} the pressure blows up like <span class="whole">|x − c|<sup>${shown(jump.exponent, 3)}</sup></span>. `;
  else if (jump) text += `At the jump x = ${shown(jump.x, 3)} the pressure stays bounded, with a cusp like <span class="whole">|x − c|<sup>${shown(jump.exponent, 3)}</sup></span>. `;
  const [right, left] = bothWays(solution);
  return text + `The effective friction is ${shown(right)} to the right and ${shown(left)} to the left.`;
}

function bothWays(solution) {
  const both = [solution.resultants.effective_friction, solution.other_direction.effective_friction];
  return state.sliding === '+x' ? both : both.reverse();
}

/// Returns "-1/2 - arctan(1/7)/pi" in print; it breaks between its terms.
const exactly = text => text === 'log' ? 'a logarithm' : text.replace(/-/g, '−').replace(/\*/g, ' ').replace(/pi/g, 'π').replace(/ ([+−]) /g, ' $1\u00a0');

function showNumbers(solution) {
  const {resultants, contact} = solution;
  const [right, left] = bothWays(solution);
  const largest = resultants.largest_pressure;
  const rows = [
    ['effective friction →', shown(right, 6)], ['effective friction ←', shown(left, 6)],
    ...contact.map(zone => ['contact', `${shown(zone.left.x, 6)} … ${shown(zone.right.x, 6)}`]),
    ['friction force', shown(resultants.friction_force, 6)], ['centre of pressure', shown(resultants.centre_of_pressure, 6)],
    ['mean pressure', shown(resultants.mean_pressure, 6)], ['largest pressure', `${shown(largest.value, 6)} at ${shown(largest.x, 4)}`],
    ['share of the load', resultants.load_share.map(share => shown(share, 3)).join(', ')],
  ];
  byId('numbers').tBodies[0].innerHTML = rows.map(([name, value]) => `<tr><th scope="row">${name}</th><td>${value}</td></tr>`).join('');
  const digits = sheet.width < 500 ? 4 : 6;
  byId('points').tBodies[0].innerHTML = solution.singular_points.map(at =>
    `<tr><td class="number">${shown(at.x, digits)}</td><td>${at.words}</td><td class="number">${at.exponent === null ? 'log' : shown(at.exponent, digits)}</td>` +
    `<td class="exact">${exactly(at.symbolic)}</td></tr>`).join('');
  byId('scale').textContent = shown(resultants.mean_pressure, 3);
}

/// For tests, and for curious users: all data of the page.
globalThis.explorerPage = {
  ready: steadyslide().then(module => {
    explorer = new module.Explorer();
    buildControls();
    fit();
    rest();
    addEventListener('resize', fit);
  }),
  set: text => { state = stateFrom(text, state); const begin = performance.now(); update(); return performance.now() - begin; },
  state: () => structuredClone(state),
  solution: () => shownResult,
  complaint: () => byId('complaint').textContent,
  file: () => problemFile(state),
  samples: count => explorer.samples(count),
  residuals: () => explorer.residuals(),
  stresses: (...cells) => explorer.stresses(...cells),
};
addEventListener('hashchange', () => { state = stateFrom(location.hash.slice(1), state); update(); });
