// node explorer_test.mjs explorer.html steadyslide [pictures]: compares the page in headless Chromium with the command
// line.

import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Browser } from './browser.mjs';
import { answer, differences, random, randomState } from './comparison.mjs';

const [html, program, pictures] = process.argv.slice(2);
const seed = 17, wanted = 50, samples = 12;
const mostBytes = 3 * 2 ** 20;
const folder = mkdtempSync(join(tmpdir(), 'explorer-test-'));
const page = await Browser.open(html);

/// Returns the page's numbers for a state, with stresses in the middles of 4 x 2 cells of [-1, 1] x [0, 1].
async function shown(state) {
  await page.run(`explorerPage.set(${JSON.stringify(state)})`);
  return page.run(`(() => {
    const list = samples => Object.fromEntries(Object.entries(samples).map(([key, column]) =>
      [key, Array.from(column, x => Number.isNaN(x) ? null : Number.isFinite(x) ? x : String(x))]));
    const p = explorerPage, complaint = p.complaint();
    return complaint ? { complaint } : { file: p.file(), solution: p.solution(), residuals: p.residuals(),
      samples: list(p.samples(${samples})), stresses: Array.from(p.stresses(-1, 1, 1, 4, 2)) };
  })()`);
}
const places = [0, 1].flatMap(row => [0, 1, 2, 3].map(k => [-1 + 0.5 * (k + 0.5), 0.5 * (row + 0.5)]));
const numeric = shown => ({ ...shown, samples: Object.fromEntries(Object.entries(shown.samples).map(([key, list]) => [key, list.map(x => typeof x === 'string' ? Number(x) : x)])) });

async function numbersAreTheProgrammes() {
  const next = random(seed);
  let compared = 0, drawn = 0, control = null;
  const methods = {};
  while (compared < wanted) {
    const state = randomState(next);
    assert.ok(++drawn <= 3 * wanted, `only ${compared} of ${drawn} states are solved in double`);
    const page = await shown(state);
    if (page.complaint || !page.residuals.solved) continue;
    const command = answer(program, folder, page.file, samples, places);
    const wrong = differences(numeric(page), command);
    assert.deepEqual(wrong, [], `state ${state}`);
    ++compared;
    methods[page.solution.method] = (methods[page.solution.method] ?? 0) + 1;
    control ??= { page, command };
  }
  // Controls: one number of the problem changed, and one result changed in its last digits.
  const other = answer(program, folder, control.page.file.replace(/load = ".*"/, 'load = "0.7654321"'), samples, places);
  assert.ok(differences(numeric(control.page), other).length > 5, 'another load went unnoticed');
  control.command.resultants.effective_friction = String(Number(control.command.resultants.effective_friction?.value ?? control.command.resultants.effective_friction) + 1e-11);
  assert.deepEqual(differences(numeric(control.page), control.command).length, 1, 'a friction off by 1e-11 went unnoticed');
  console.log(`${compared} states of ${drawn} with seed ${seed} agree to 1e-12:`, methods);
}

/// Moves jumps as if dragged. Measures the processor time of an update on the page's main thread, with drawing, and the
/// elapsed time.
async function updatesAreFast() {
  const ways = [
    ['closed-form', 200, 16, k => `profile=punch&values=0.1,0.5,0.3&jumps=${(-0.5 + 0.002 * k).toFixed(3)},0.2&sliding=+x&load=0.3&thickness=5`],
    ['riemann-hilbert', 200, 50, k => `profile=wedge&size=0.4&values=0.1,0.5&jumps=${(-0.2 + 0.002 * k).toFixed(3)}&sliding=+x&load=0.3&thickness=5`],
    ['riemann-hilbert', 10, 2000, k => `profile=parabola&size=0.5&values=0.1,0.5&jumps=0&sliding=+x&load=0.3&thickness=${1 + 0.1 * k}`],
  ];
  for (const [method, count, most, state] of ways) {
    const costs = [], times = [];
    for (let k = 0; k < count; ++k) {
      const before = await page.processorTime();
      times.push(await page.run(`explorerPage.set('${state(k)}')`));
      costs.push(1000 * (await page.processorTime() - before));
    }
    assert.equal(await page.run('explorerPage.solution().method'), method);
    const middle = count / 2;
    const words = list => { list.sort((a, b) => a - b); return `${list[middle].toFixed(1)} ms (median of ${count}), at worst ${list.at(-1).toFixed(1)} ms`; };
    console.log(`${method}: an update takes ${words(costs)}; by the clock of this machine ${words(times)}`);
    assert.ok(costs[middle] <= most, `${method}: ${costs[middle]} ms`);
  }
  await page.run(`explorerPage.set('thickness=5')`);
}

async function complaintsAreTheModels() {
  await page.run(`explorerPage.set('profile=punch&values=0.1,0.5,0.2&jumps=0.4,0.1')`);
  assert.match(await page.run('explorerPage.complaint()'), /; .*; /);
  await page.run(`explorerPage.set('profile=punch&values=0.1,-0.5&jumps=0')`);
  assert.match(await page.run('explorerPage.complaint()'), /; .*; .*-0\.5/);
  await page.run(`explorerPage.set('profile=punch&values=0.1,0.5&jumps=0')`);
  assert.equal(await page.run('explorerPage.complaint()'), '');
}

async function jumpsMoveByKeysAndPointer() {
  await page.run(`explorerPage.set('profile=punch&values=0.1,0.5&jumps=0'); document.querySelector('.handle').focus()`);
  await page.key('ArrowRight');
  assert.equal(await page.run('explorerPage.state().jumps[0]'), '0.01');
  assert.equal(await page.run(`document.activeElement.getAttribute('aria-valuenow')`), '0.01');
  const { x, y, wide } = await page.run(`(() => { document.querySelector('#pressure').scrollIntoView();
    const box = document.querySelector('.handle circle').getBoundingClientRect();
    return { x: box.x + box.width / 2, y: box.y + box.height / 2, wide: document.querySelector('#pressure').getBoundingClientRect().width }; })()`);
  await page.mouse('mousePressed', x, y);
  await page.mouse('mouseMoved', x + wide / 10, y);
  await page.mouse('mouseReleased', x + wide / 10, y);
  const moved = Number(await page.run('explorerPage.state().jumps[0]'));
  assert.ok(moved > 0.2 && moved < 0.35, `dragged to ${moved}`);
  await new Promise(done => setTimeout(done, 600));
  assert.match(await page.run('location.hash'), /jumps=0\.\d+/);
  await page.run(`document.querySelector('#copy-file').click()`);
  assert.match(await page.run(`new Promise(done => setTimeout(() => done(document.querySelector('#copied').textContent), 200))`), /copied/);
  assert.match(await page.run(`document.querySelector('#summary').textContent`), /blows up like .*effective friction/);
}

/// The coatings are on the indenter, with their friction values, and below the stresses is a bar from white to black.
async function coatingsAndScaleAreDrawn() {
  await page.run(`explorerPage.set('profile=parabola&size=0.5&values=0.1,0.5,0.3&jumps=-0.5,0.4&sliding=+x&load=0.3')`);
  const drawn = await page.run(`(() => {
    const svg = document.querySelector('#surface'), canvas = document.querySelector('#stress'), fine = canvas.width / sheet.width;
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', { willReadFrequently: true });
    copy.drawImage(canvas, 0, 0);
    const shadeAt = x => [...copy.getImageData(x * fine, (sheet.heights.stress - 34) * fine, 1, 1).data.slice(0, 3)];
    return { texts: [...svg.querySelectorAll('text')].map(text => text.textContent), coatings: svg.querySelectorAll('[clip-path="url(#indenter)"] > path').length,
      bar: [shadeAt(margin.left + 2), shadeAt(margin.left + 258)] };
  })()`);
  for (const text of ['f = 0.1', 'f = 0.5', 'f = 0.3']) assert.ok(drawn.texts.includes(text), `${text} is not on the indenter`);
  assert.equal(drawn.coatings, 3);
  const [white, black] = drawn.bar;
  assert.ok(Math.min(...white) > 240 && Math.max(...black) < 60, `the bar goes from ${white} to ${black}`);
}

async function takePictures() {
  for (const [width, height] of [[1300, 1150], [390, 2600]]) {
    await page.size(width, height);
    for (const [name, state] of [['punch', 'profile=punch&values=0.1,0.5&jumps=0&load=0.2&sliding=+x'], ['bumps', 'profile=bumps&size=0.25&values=0.1,0.7,0.3&jumps=-1,0.9&load=0.1&sliding=-x'],
      ['bad', 'profile=punch&values=0.1,0.5,0.2&jumps=0.4,0.1'], ['wedge', 'profile=wedge&size=0.4&values=0.1,0.5&jumps=0&load=0.2'], ['layer', 'profile=parabola&size=0.5&values=0.1,0.5&jumps=0&load=0.3&thickness=1']]) {
      await page.run(`explorerPage.set(${JSON.stringify(state)})`);
      await new Promise(done => setTimeout(done, 700));
      writeFileSync(join(pictures, `${name}-${width}.png`), await page.picture());
    }
  }
}

let status = 1;
try {
  assert.ok(statSync(html).size <= mostBytes, `${statSync(html).size} bytes`);
  console.log(`${statSync(html).size} bytes`);
  await page.run('explorerPage.ready');
  await numbersAreTheProgrammes();
  await updatesAreFast();
  await complaintsAreTheModels();
  await jumpsMoveByKeysAndPointer();
  await coatingsAndScaleAreDrawn();
  if (pictures) await takePictures();
  assert.deepEqual(page.problems, []);
  status = 0;
} catch (error) {
  console.error(error.message ?? error);
} finally {
  await page.close();
  rmSync(folder, { recursive: true });
}
process.exit(status);
