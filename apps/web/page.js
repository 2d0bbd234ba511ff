// SPDX-License-Identifier: MIT
// The page: panel, pointer, keys, clock, and the link that holds the state. apps/web/main.c does the rest.
'use strict';

const SECTIONS = [
  ['Wind and swell', ['sea.wind.speed', 'sea.wind.from', 'sea.fetch_km', 'sea.swell.hs', 'sea.swell.tp',
                      'sea.swell.from']],
  ['Light', ['sky.sun.elevation', 'sky.sun.azimuth', 'sky.clouds.cover', 'sky.visibility_km', 'exposure']],
  ['Water', ['water.type', 'water.foam']],
];
const CAMERA = ['camera.position', 'camera.heading', 'camera.pitch', 'camera.fov'];
const QUALITIES = ['low', 'medium', 'high', 'ultra'];
const FIRST_SCENE = 'island';
const LONGEST_TICK = 0.1;   // [s] of the sea in a frame, so that a stall does not jump
const LINK_DELAY = 300;     // [ms] from a change until the address shows it
const MOST_DENSITY = 2;     // canvas pixels a CSS pixel, at most

const find = id => document.getElementById(id);
const canvas = find('water'), panel = find('panel');
const state = {
  core: null, ask: {}, drawing: false, scene: '', changed: new Map(), quality: 1, paused: false, scale: 0,
  time: 0, last: 0, frames: 0, moved: false, look: [0, 0], push: [0, 0, 0], keys: new Set(), pointers: new Map(),
  cursor: null, linkTimer: 0, problem: '', frameMs: 0, loaded: 0, firstPicture: 0, entered: false, lost: false,
  request: 0,
};
window.bolan = state; // for tests, and for the curious

function say(sentence) { find('message').textContent = sentence; }

// ---- the link: #scene=island&sea.wind.speed=12 ... -------------------------------------------------------------------

function link() {
  const parts = [['scene', state.scene], ...state.changed];
  if (state.moved) for (const key of CAMERA) parts.push([key, state.ask.get(key)]);
  if (state.quality !== 1) parts.push(['quality', QUALITIES[state.quality]]);
  if (state.scale > 0) parts.push(['scale', state.scale]);
  if (document.body.classList.contains('bare')) parts.push(['panel', 'none']);
  if (state.paused) parts.push(['pause', state.time.toFixed(3)]);
  return '#' + parts.map(([key, value]) => key + '=' + encodeURIComponent(value).replace(/%2C/g, ',')).join('&');
}

function showLink() {
  history.replaceState(null, '', link());
}

function linkSoon() {
  clearTimeout(state.linkTimer);
  state.linkTimer = setTimeout(showLink, LINK_DELAY);
}

function decoded(text) {
  try { return decodeURIComponent(text); } catch { return text; } // a link that was cut
}

// ---- scenes and settings ---------------------------------------------------------------------------------------------

function sceneNames() {
  const names = [];
  for (let i = 0, name; (name = state.ask.sceneName(i)); i++) names.push(name);
  return names;
}

function set(key, value) {
  if (!state.ask.set(key, value)) return false;
  state.changed.set(key, value);
  return true;
}

// Takes scene and settings from the address. What it names and does not exist is said, and left out.
function readLink() {
  const given = new Map(location.hash.slice(1).split('&').filter(Boolean).map(part => {
    const at = part.indexOf('=');
    return at < 0 ? [decoded(part), ''] : [decoded(part.slice(0, at)), decoded(part.slice(at + 1))];
  }));
  const take = key => { const value = given.get(key); given.delete(key); return value; };
  state.scene = take('scene') || FIRST_SCENE;
  if (!state.ask.choose(state.scene)) state.ask.choose(state.scene = FIRST_SCENE);
  state.changed.clear();
  state.quality = Math.max(QUALITIES.indexOf(take('quality') || 'medium'), 0);
  state.scale = Math.min(Math.max(Number(take('scale')) || 0, 0), 1);
  document.body.classList.toggle('bare', take('panel') === 'none');
  if (document.body.classList.contains('bare')) showPanel(false);
  const pause = take('pause');
  state.paused = pause !== undefined;
  state.moved = CAMERA.some(key => given.has(key));
  for (const [key, value] of given)
    if (CAMERA.includes(key)) state.ask.set(key, value);
    else set(key, value);
  if (state.paused && pause !== '') state.ask.set('time', pause);
}

function enter() {
  say('Making ' + state.scene + ' …');
  // The sentence reaches the screen before the wait.
  requestAnimationFrame(() => setTimeout(() => {
    const made = state.ask.enter();
    state.time = Number(state.ask.get('time'));
    state.frames = 0;
    fillPanel();
    if (made) say(state.problem);
    state.entered ||= made;
    start();
  }));
}

function onLink() {
  const quality = state.quality;
  state.drawing = false;
  readLink();
  if (state.quality !== quality) renewCanvas();
  enter();
}

function openScene(name) {
  state.drawing = false;
  state.problem = '';
  state.ask.choose(state.scene = name);
  state.changed.clear();
  state.moved = false;
  linkSoon();
  enter();
}

// ---- the panel -------------------------------------------------------------------------------------------------------

// A slider runs in steps of the digits shown; a logarithmic one in 1000 steps of equal ratio.
function slider(row) {
  const input = document.createElement('input');
  input.type = 'range';
  const log = row.logarithmic && row.low > 0;
  input.min = log ? 0 : row.low;
  input.max = log ? 1000 : row.high;
  input.step = log ? 1 : 10 ** -row.digits;
  const span = Math.log(row.high / row.low);
  return {
    input,
    show: value => { input.value = log ? Math.log(value / row.low) / span * 1000 : value; },
    value: () => log ? (row.low * Math.exp(input.value / 1000 * span)).toPrecision(3) : input.value,
  };
}

function chooser(names, change) {
  const select = document.createElement('select');
  for (const name of names) select.add(new Option(name));
  select.addEventListener('change', () => change(select.value));
  return select;
}

function labelled(text, help, ...elements) {
  const label = document.createElement('label');
  label.title = help;
  label.append(text, ...elements);
  return label;
}

function capital(text) { return text[0].toUpperCase() + text.slice(1); }

function choice(text, help, names, value, change) {
  const select = chooser(names, change);
  select.value = value;
  const label = labelled(text, help, select);
  label.className = 'choice';
  return label;
}

function edit(key, value) {
  state.problem = '';
  say('');
  set(key, value);
  linkSoon();
}

function setting(key) {
  const row = JSON.parse(state.ask.describe(key)), name = capital(row.label.replace(/_/g, ' '));
  const value = state.ask.get(key);
  if (row.names) return choice(name, row.help, row.names, value, chosen => edit(key, chosen));
  const { input, show, value: read } = slider(row), shown = document.createElement('output');
  const unit = row.unit === 'degrees' ? '°' : row.unit ? ' ' + row.unit : '';
  const print = number => { shown.textContent = Number(number).toFixed(row.digits) + unit; };
  input.dataset.key = key;
  show(value);
  print(value);
  input.addEventListener('input', () => { edit(key, read()); print(read()); });
  return labelled(name, row.help, input, shown);
}

function fillPanel() {
  const technique = JSON.parse(state.ask.describe('technique'));
  const parts = [
    choice('Scene', state.ask.description(), sceneNames(), state.scene, openScene),
    choice('Technique', technique.help, technique.names, state.ask.get('technique'), name => edit('technique', name)),
    choice('Quality', 'how much a picture may cost', QUALITIES, QUALITIES[state.quality], chooseQuality),
  ];
  for (const [title, keys] of SECTIONS) {
    const heading = document.createElement('h2');
    heading.textContent = title;
    parts.push(heading, ...keys.map(setting));
  }
  find('choices').replaceChildren(...parts);
  showPause();
}

function chooseQuality(name) {
  state.quality = QUALITIES.indexOf(name);
  renewCanvas();
  linkSoon();
}

function showPanel(on) {
  panel.hidden = !on;
  find('open').setAttribute('aria-expanded', String(on));
}

function showPause() {
  find('pause').textContent = state.paused ? 'Go on' : 'Pause';
  find('pause').setAttribute('aria-pressed', String(state.paused));
}

function pause() {
  state.paused = !state.paused;
  showPause();
  linkSoon();
}

async function share() {
  showLink();
  try {
    await navigator.clipboard.writeText(location.href);
    say('The link to this sea is copied.');
  } catch {
    say('Copy the address of this page: it is the link to this sea.');
  }
}

// ---- pointer and keys ------------------------------------------------------------------------------------------------

const WAYS = { // key code -> forward, right, up
  KeyW: [1, 0, 0], ArrowUp: [1, 0, 0], KeyS: [-1, 0, 0], ArrowDown: [-1, 0, 0], KeyD: [0, 1, 0], ArrowRight: [0, 1, 0],
  KeyA: [0, -1, 0], ArrowLeft: [0, -1, 0], KeyE: [0, 0, 1], KeyQ: [0, 0, -1],
};

function degreesPerPixel() { return Number(state.ask.get('camera.fov')) / Math.max(canvas.clientHeight, 1); }

// Two fingers: apart is forward, and their middle moves sideways and up. Pixels since the last event.
function twoFingers(event) {
  const [a, b] = state.pointers.values();
  const before = [Math.hypot(a.x - b.x, a.y - b.y), (a.x + b.x) / 2, (a.y + b.y) / 2];
  state.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  const [c, d] = state.pointers.values();
  state.push[0] += (Math.hypot(c.x - d.x, c.y - d.y) - before[0]) / 60;
  state.push[1] -= ((c.x + d.x) / 2 - before[1]) / 60;
  state.push[2] += ((c.y + d.y) / 2 - before[2]) / 60;
}

function onPointerMove(event) {
  state.cursor = [event.clientX / canvas.clientWidth, event.clientY / canvas.clientHeight];
  const from = state.pointers.get(event.pointerId);
  if (!from) return;
  if (state.pointers.size === 2) {
    twoFingers(event);
    return;
  }
  const scale = degreesPerPixel();
  state.look[0] -= (event.clientX - from.x) * scale; // the sea follows the finger
  state.look[1] += (event.clientY - from.y) * scale;
  state.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
}

function listenPointer() {
  canvas.addEventListener('pointerdown', event => {
    canvas.setPointerCapture(event.pointerId);
    canvas.focus();
    state.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    state.cursor = [event.clientX / canvas.clientWidth, event.clientY / canvas.clientHeight];
  });
  canvas.addEventListener('pointermove', onPointerMove);
  for (const end of ['pointerup', 'pointercancel'])
    canvas.addEventListener(end, event => state.pointers.delete(event.pointerId));
  canvas.addEventListener('pointerleave', () => { state.cursor = null; });
  canvas.addEventListener('wheel', event => {
    event.preventDefault();
    if (!state.core) return;
    const fov = Number(state.ask.get('camera.fov')) * Math.exp(event.deltaY * 0.001);
    state.ask.set('camera.fov', String(Math.min(Math.max(fov, 5), 110)));
    state.moved = true;
    linkSoon();
  }, { passive: false });
}

function listenKeys() {
  window.addEventListener('keydown', event => {
    if (event.target.closest('input, select, button') || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.code === 'Space') { pause(); event.preventDefault(); }
    if (event.code === 'KeyH') showPanel(panel.hidden);
    if (WAYS[event.code]) event.preventDefault();
    state.keys.add(event.code);
  });
  window.addEventListener('keyup', event => state.keys.delete(event.code));
  window.addEventListener('blur', () => state.keys.clear());
}

function fly(seconds) {
  const way = [0, 0, 0];
  for (const code of state.keys) (WAYS[code] || []).forEach((part, i) => { way[i] += part; });
  const shift = state.keys.has('ShiftLeft') || state.keys.has('ShiftRight');
  const moving = way.some(Boolean) || state.look.some(Boolean) || state.push.some(Boolean);
  if (!moving) return;
  const time = Math.max(seconds, 1e-3);
  way.forEach((part, i) => { way[i] = part + state.push[i] / time; });
  state.core._web_fly(time, way[0], way[1], way[2], state.look[0], state.look[1], shift ? 5 : 1);
  state.look = [0, 0];
  state.push = [0, 0, 0];
  state.moved = true;
  linkSoon();
}

// ---- frames ----------------------------------------------------------------------------------------------------------

function fitCanvas(scale) {
  const density = Math.min(window.devicePixelRatio || 1, MOST_DENSITY) * scale;
  const width = Math.max(Math.round(canvas.clientWidth * density), 1);
  const height = Math.max(Math.round(canvas.clientHeight * density), 1);
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
}

function showHeight() {
  let text = '';
  if (state.cursor) {
    const at = JSON.parse(state.ask.ask(state.cursor[0], state.cursor[1], canvas.width / canvas.height));
    if (at.height !== undefined) {
      const far = at.distance < 10 ? at.distance.toFixed(1) : at.distance.toFixed(0);
      text = `${at.height < 0 ? '−' : '+'}${Math.abs(at.height).toFixed(2)} m, ${far} m away`;
    } else {
      text = at.land ? 'land' : 'sky';
    }
  }
  if (find('asked').textContent !== text) find('asked').textContent = text;
}

function frame(now) {
  if (!state.drawing) return;
  state.request = requestAnimationFrame(frame);
  const ms = now - state.last;
  state.last = now;
  const scale = state.scale || state.core._web_pace(state.frames > 1 ? ms : 0);
  state.frameMs += 0.1 * (ms - state.frameMs);
  fly(Math.min(ms / 1e3, LONGEST_TICK));
  if (!state.paused) state.time += Math.min(ms / 1e3, LONGEST_TICK);
  fitCanvas(scale);
  state.core._web_draw(state.time, canvas.width, canvas.height);
  showHeight();
  if (state.frames++ === 1 && state.firstPicture === 0) state.firstPicture = now - state.loaded;
  if (state.frames % 30 === 0)
    find('facts').textContent = `${(1e3 / state.frameMs).toFixed(0)} frames a second of ${canvas.width} × ` +
      `${canvas.height}, ${state.time.toFixed(0)} s`;
}

// One loop at a time; none without a sea or a context.
function start() {
  cancelAnimationFrame(state.request);
  state.drawing = state.entered && !state.lost;
  state.request = requestAnimationFrame(now => { state.last = now; frame(now); });
}

// ---- from start to end -----------------------------------------------------------------------------------------------

const NO_WEBGL = 'This page needs WebGL 2, and this browser does not give it: it is too old, or its graphics ' +
  'acceleration is switched off.';

function openCanvas() {
  const result = state.ask.open('#water', state.quality);
  if (result === 1) say(NO_WEBGL);
  if (result === 2) say('The sea cannot be drawn here. ' + state.problem);
  return result === 0;
}

function renewCanvas() {
  if (state.lost) return; // it is made when the context is back
  state.ask.close();
  openCanvas();
}

function listenContext() {
  canvas.addEventListener('webglcontextlost', event => {
    event.preventDefault(); // asks for it back
    state.lost = true;
    state.drawing = false;
    state.ask.close();
    say('The browser took the graphics away. The sea comes back when it gives them again.');
  });
  canvas.addEventListener('webglcontextrestored', () => {
    if (!openCanvas()) return;
    state.lost = false;
    say('');
    start();
  });
}

function onLog(level, sentence) {
  if (level === 0) state.problem = sentence;
  if (level === 0) say(sentence);
  console[['error', 'warn', 'info'][level]](sentence);
}

function wrap(core) {
  const make = (name, result, ...types) => core.cwrap('web_' + name, result, types);
  state.core = core;
  state.ask = {
    open: make('open', 'number', 'string', 'number'), close: make('close', null),
    sceneName: make('scene_name', 'string', 'number'), description: make('description', 'string'),
    set: make('set', 'number', 'string', 'string'), get: make('get', 'string', 'string'),
    describe: make('describe', 'string', 'string'), choose: make('choose', 'number', 'string'),
    enter: make('enter', 'number'), ask: make('ask', 'string', 'number', 'number', 'number'),
    height: make('height', 'number', 'number', 'number'), memory: make('memory', 'number'),
  };
}

async function begin() {
  if (!window.WebAssembly || !document.createElement('canvas').getContext('webgl2')) {
    say(NO_WEBGL);
    return;
  }
  try {
    wrap(await createBolan({ onBolanLog: onLog, printErr: text => console.error(text) }));
  } catch (problem) {
    say('The page could not load its program: ' + problem.message + '. Serve the folder by HTTP.');
    return;
  }
  state.loaded = performance.now();
  readLink();
  if (!openCanvas()) return;
  listenContext();
  listenPointer();
  listenKeys();
  find('open').addEventListener('click', () => showPanel(panel.hidden));
  find('pause').addEventListener('click', pause);
  find('home').addEventListener('click', () => openScene(state.scene));
  find('share').addEventListener('click', share);
  window.addEventListener('hashchange', onLink);
  document.addEventListener('visibilitychange', () => { state.last = performance.now(); }); // a rest is no slow frame
  showPanel(!document.body.classList.contains('bare') && window.innerWidth > 600);
  enter();
}

begin();
