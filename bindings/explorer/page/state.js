'use strict';
// The state of the page: decimals as texts, so that the problem file has exactly the numbers of the sliders.

const profiles = {
  punch: {support: 1, size: null, pieces: () => ['profile = "0"']},
  parabola: {support: 1, size: {label: 'k in ψ = k x²', value: '0.5'}, pieces: k => [`profile = "${k}*x^2"`]},
  wedge: {support: 1, size: {label: 'k in ψ = k |x|', value: '0.4'},
          pieces: k => ['pieces = [', `  {to = "0", profile = "-${k}*x"},`, `  {to = "1", profile = "${k}*x"},`, ']']},
  bumps: {support: 2, size: {label: 'k in ψ = k (x² − 1)²', value: '0.25'}, pieces: k => [`profile = "${k}*(x^2-1)^2"`]},
};
const mostJumps = 6;
/// A layer of this thickness, or thicker, is shown as the half-plane.
const thickest = 5;

const initial = {profile: 'punch', size: '0.5', load: '0.2', poisson: '0.3', thickness: `${thickest}`, sliding: '+x', values: ['0.1', '0.5'], jumps: ['0']};

/// Returns the problem file of the state, for `steadyslide solve`.
function problemFile(state) {
  const quoted = list => `[${list.map(number => `"${number}"`).join(', ')}]`;
  const {support, pieces} = profiles[state.profile];
  const body = Number(state.thickness) >= thickest ? [`poisson = "${state.poisson}"`] :
    ['base = "rigid"', `layers = [ {thickness = "${state.thickness}", young = "1", poisson = "${state.poisson}"} ]`];
  return [`load = "${state.load}"`, `sliding = "${state.sliding}"`, '', '[half_space]', ...body, '',
          '[friction]', `values = ${quoted(state.values)}`, `jumps = ${quoted(state.jumps)}`, '',
          '[indenter]', `support = ["-${support}", "${support}"]`, ...pieces(state.size), ''].join('\n');
}

/// Returns "profile=punch&load=0.2&...", the text behind # in the address.
function stateText(state) {
  return Object.entries(state).map(([key, value]) => `${key}=${Array.isArray(value) ? value.join(',') : value}`).join('&');
}

/// A missing entry keeps its value. The model refuses a text that is not a number.
function stateFrom(text, state) {
  const result = structuredClone(state);
  for (const part of text.split('&')) {
    const [key, given] = part.split('=');
    if (!(key in result) || given === undefined) continue;
    const value = decodeURIComponent(given).replace(/["\\\n]/g, '');
    if (Array.isArray(result[key])) result[key] = value === '' ? [] : value.split(',').slice(0, mostJumps + 1);
    else if (key !== 'profile' || value in profiles) result[key] = value;
  }
  return result;
}
