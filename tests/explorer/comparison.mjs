// Compares the numbers of the page with those of `steadyslide solve` for the same problem file.

import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';

export const tolerance = 1e-12;

/// Random numbers in [0, 1[ that depend only on the seed.
export function random(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/// A random state of the page, in the form of its address.
export function randomState(next) {
  const hundredths = (from, to) => (from + Math.floor(next() * (to - from + 1))) / 100;
  const profile = ['punch', 'parabola', 'wedge', 'bumps'][Math.floor(next() * 4)];
  const support = profile === 'bumps' ? 200 : 100;
  const jumps = new Set(Array.from({ length: Math.floor(next() * 4) }, () => hundredths(1 - support, support - 1)));
  const values = Array.from({ length: jumps.size + 1 }, () => hundredths(0, 90));
  const state = { profile, size: hundredths(10, 90), load: hundredths(5, 60), poisson: hundredths(0, 45), thickness: next() < 0.6 ? '5' : hundredths(80, 400), sliding: next() < 0.5 ? '+x' : '-x',
    values: values.join(','), jumps: [...jumps].sort((a, b) => a - b).join(',') };
  return Object.entries(state).map(([key, value]) => `${key}=${value}`).join('&');
}

/// Returns the answer of the command line, with stresses at places [x, z].
export function answer(program, folder, file, samples, places) {
  const problem = join(folder, 'problem.toml'), points = join(folder, 'points.csv');
  writeFileSync(problem, file);
  writeFileSync(points, `x,z\n${places.map(place => place.join(',')).join('\n')}\n`);
  const solved = (...options) => JSON.parse(execFileSync(program, ['solve', problem, '--format', 'json', ...options], { encoding: 'utf8', maxBuffer: 2 ** 26 }));
  return { ...solved('--both-directions'), ...solved('--samples', `${samples}`, '--stress-at', points) };
}

const asNumber = value => {
  const text = value !== null && typeof value === 'object' && 'value' in value ? value.value : value;
  if (text === null || text === undefined || text === 'log') return null;
  return Number(text);
};

/// Returns a line for each difference above the tolerance, in units of the size beside it.
export function differences(page, command) {
  const found = [];
  const compare = (name, ours, theirs, size) => {
    const a = ours === undefined ? null : ours, b = asNumber(theirs);
    const same = a === b || (a !== null && b !== null && Math.abs(a - b) <= tolerance * Math.max(Math.abs(b), size));
    if (!same) found.push(`${name}: ${a}, the command line says ${b}`);
  };
  const words = (name, ours, theirs) => { if (ours !== theirs) found.push(`${name}: ${ours}, the command line says ${theirs}`); };
  const { solution, samples, stresses } = page;
  const length = command.problem.indenter.support[1] - command.problem.indenter.support[0];
  const load = Number(command.problem.load), mean = asNumber(command.resultants.mean_pressure);
  words('method', solution.method, command.method);

  const known = quantities => Object.keys(quantities).filter(key => quantities[key] !== null).join(', ');
  words('quantities', known(solution.resultants), known(command.resultants));
  const sizes = { normal: load, friction_force: load, mean_pressure: mean, largest_pressure: mean, effective_friction: 1, load_share: 1, tilt: 1 };
  for (const [key, theirs] of Object.entries(command.resultants)) {
    const ours = solution.resultants[key], size = sizes[key] ?? length;
    if (key === 'load_share') theirs.forEach((share, k) => compare(`load_share[${k}]`, ours[k], share, size));
    else if (key === 'largest_pressure' || key === 'core') {
      for (const part of Object.keys(theirs)) {
        if (Number.isNaN(asNumber(theirs[part]))) continue; // infinite: the page shows no number
        // Two bumps without friction have two largest pressures; rounding selects one of them.
        const side = key === 'largest_pressure' && part === 'x' && asNumber(command.resultants.friction_force) === 0 ? Math.abs : x => x;
        compare(`${key}.${part}`, side(ours?.[part]), side(asNumber(theirs[part])), part === 'value' ? size : length);
      }
    } else compare(key, ours, theirs, size);
  }
  compare('other_direction', solution.other_direction.effective_friction, command.other_direction.resultants.effective_friction, 1);

  words('components', solution.contact.length, command.contact.length);
  command.contact.forEach((zone, k) => {
    for (const side of ['left', 'right']) {
      const ours = solution.contact[k]?.[side] ?? {};
      compare(`contact[${k}].${side}.x`, ours.x, zone[side].x, length);
      compare(`contact[${k}].${side}.exponent`, ours.exponent, zone[side].exponent, 1);
      compare(`contact[${k}].${side}.intensity`, ours.intensity, zone[side].intensity, mean);
    }
    compare(`contact[${k}].load`, solution.contact[k]?.load, zone.load, load);
  });
  words('singular points', solution.singular_points.length, command.singular_points.length);
  command.singular_points.forEach((point, k) => {
    const ours = solution.singular_points[k] ?? {};
    compare(`singular_points[${k}].x`, ours.x, point.x, length);
    words(`singular_points[${k}].kind`, ours.kind, point.kind);
    words(`singular_points[${k}].symbolic`, ours.symbolic, point.symbolic);
    if (point.symbolic !== 'log') compare(`singular_points[${k}].exponent`, ours.exponent, point.exponent, 1);
    compare(`singular_points[${k}].intensity`, ours.intensity, point.intensity, mean);
    compare(`singular_points[${k}].constant`, ours.constant, point.constant, mean);
  });

  words('samples', samples.x.length, command.samples.length);
  command.samples.forEach((sample, k) => {
    const { traction, shear } = sample;
    const sides = traction?.left !== undefined ? traction : { left: traction, right: traction };
    const left = asNumber(sides.left) < asNumber(sides.right);
    const side = left ? 'left' : 'right';
    compare(`samples[${k}].x`, samples.x[k], sample.x, length);
    compare(`samples[${k}].traction`, samples.traction[k], sides[side], mean);
    compare(`samples[${k}].shear`, samples.shear[k], shear?.left !== undefined ? shear[side] : shear, mean);
    compare(`samples[${k}].gap`, samples.gap[k], sample.gap, length);
  });
  command.stresses.forEach((stress, k) => compare(`stresses[${k}]`, stresses[k], stress.von_mises, mean));
  return found;
}
