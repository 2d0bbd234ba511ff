# SPDX-License-Identifier: MIT
"""page.py FOLDER: opens the web page in a headless Chromium, uses it, and compares its pictures with native ones.

BOLAN_TEST_LONG: more scenes. BOLAN_WEB_SHOTS names a folder where pictures of the page are left, of a desktop's size and
a phone's."""
import gzip
import os
import sys
import tempfile
import time

import bolan
import matplotlib.image
import numpy

import browser

SIZE = (320, 180)
LEAST_DB = 35.0
MOST_BYTES = 3_000_000  # of the page, compressed
SETTLED = 16            # frames after which clouds and ground are made
FRAMES = 500            # over which the memory stays
SCENES = [('pond', 'two-triangle'), ('open-sea', 'exp-cosine'), ('open-sea', 'flight-sim')]
LONG = [('island', 'ocean'), ('storm', 'ocean'), ('reef', 'ocean'), ('open-sea', 'nested-grid')]

started = time.monotonic()


def check(fact, sentence):
    print('%5.1f s: %s %s' % (time.monotonic() - started, 'ok' if fact else 'NOT', sentence), flush=True)
    if not fact:
        sys.exit(1)


def decibels(a, b):
    error = ((a.astype(float) - b.astype(float)) ** 2).mean()
    return 99.0 if error == 0 else 10 * numpy.log10(255.0 ** 2 / error)


def shown(page, folder=tempfile.gettempdir()):
    """The picture of the page without the cursor's height, (height, width, 3) uint8."""
    page.run('bolan.cursor = null, bolan.frames = 0')
    page.wait('bolan.frames > 1')
    path = os.path.join(folder, 'bolan-page-%d.png' % os.getpid())
    page.screenshot(path)
    picture = matplotlib.image.imread(path)
    os.remove(path)
    return (picture[..., :3] * 255 + 0.5).astype('u1')


def visit(page, link):
    """Another link of the page that is open; waits until its sea is drawn and settled."""
    page.run('location.hash = %r, bolan.frames = 0' % link)
    page.wait('bolan.drawing && bolan.frames > %d' % SETTLED)


def native(scene, technique, renderer):
    what = bolan.Scene.load(scene)
    what.set_technique(technique)
    picture = renderer.draw(bolan.World(what), SIZE)
    check(picture.std() > 10, '%s by %s is a picture' % (scene, technique))
    return picture


def test_size(folder):
    files = [os.path.join(folder, name) for name in sorted(os.listdir(folder))]
    packed = sum(len(gzip.compress(open(file, 'rb').read(), 9)) for file in files)
    check(packed <= MOST_BYTES, 'the page has %d files of %d bytes, compressed' % (len(files), packed))


def test_pictures(page):
    with bolan.Renderer(quality='medium', backend='cpu', api='es') as renderer:
        for scene, technique in SCENES + (LONG if os.environ.get('BOLAN_TEST_LONG') else []):
            visit(page, '#scene=%s&technique=%s&pause=&scale=1&panel=none' % (scene, technique))
            near = decibels(shown(page), native(scene, technique, renderer))
            check(near >= LEAST_DB, '%s by %s: %.1f dB from the native picture' % (scene, technique, near))


def test_heights(page):
    visit(page, '#scene=storm&pause=12.5&scale=1&panel=none')
    world = bolan.World(bolan.Scene.load('storm'))
    world.settle(12.5)
    places = [[0.0, 0.0], [40.25, -15.5], [-3e5, 2e5]]
    ours = [page.run('bolan.ask.height(%r, %r)' % tuple(p)) for p in places]
    check(ours == [float(h) for h in world.heights(places)], 'heights have the bits of a native query: %s' % ours)
    page.mouse('mouseMoved', SIZE[0] / 2, SIZE[1] * 0.8)
    page.wait("/ m, .* m away$/.test(document.getElementById('asked').textContent)")
    at = page.run('JSON.parse(bolan.ask.ask(0.5, 0.8, %r))' % (SIZE[0] / SIZE[1]))
    camera = world.scene.camera
    eye = numpy.array(camera.position)
    eye[2] = max(eye[2], world.heights([eye[:2]])[0] + 0.3)
    way = numpy.array([at['x'], at['y'], at['height']]) - eye
    heading = numpy.degrees(numpy.arctan2(way[0], way[1])) % 360
    down = camera.pitch_deg - numpy.degrees(numpy.arctan(0.6 * numpy.tan(numpy.radians(camera.fov_deg / 2))))
    pitch = numpy.degrees(numpy.arctan2(way[2], numpy.hypot(way[0], way[1])))
    check(abs(heading - camera.heading_deg % 360) < 0.1 and abs(pitch - down) < 0.1,
          'the cursor asks under itself: %.2f and %.2f degrees' % (heading, pitch))
    check(abs(at['height'] - world.heights([[at['x'], at['y']]])[0]) < 2e-2, 'and hears the height of the place')
    page.mouse('mouseMoved', SIZE[0] / 2, 2)
    page.wait("document.getElementById('asked').textContent === 'sky'")
    check(True, 'over the horizon it says sky')


def test_settings(page):
    visit(page, '#scene=open-sea&sea.wind.speed=14&sea.swell.hs=3&sea.swell.tp=9&pause=5&scale=0.2&panel=none')
    with open(os.path.join(os.environ['BOLAN_SOURCE_DIR'], 'scenes', 'open-sea.yaml'), encoding='utf-8') as file:
        text = file.read()
    for old, new in (('speed: 10', 'speed: 14'), ('hs: 1.8', 'hs: 3'), ('tp: 13', 'tp: 9')):
        assert old in text
        text = text.replace(old, new)
    world = bolan.World(bolan.Scene.parse(text))
    world.settle(5.0)
    places = [[3.5, -7.25], [410.0, 95.0]]
    ours = [page.run('bolan.ask.height(%r, %r)' % tuple(p)) for p in places]
    check(numpy.abs(ours - world.heights(places)).max() < 1e-5, 'settings make the sea of such a scene file: %s' % ours)
    told = {key: page.run('bolan.ask.get(%r)' % key) for key in ('sea.fetch_km', 'sea.swell.from', 'sky.visibility_km')}
    check(told == {'sea.fetch_km': '300', 'sea.swell.from': '300', 'sky.visibility_km': '50'}, 'and are told: %s' % told)


def number(page, key):
    return float(page.run('bolan.ask.get(%r)' % key))


def test_hands(page):
    page.resize(640, 480)
    visit(page, '#scene=open-sea&scale=0.2')
    page.run('showPanel(true)')
    heading, fov = number(page, 'camera.heading'), number(page, 'camera.fov')
    page.drag((100, 200), (160, 200))
    page.wait('bolan.moved')
    turned = heading - number(page, 'camera.heading')
    check(abs(turned - 60 * fov / 480) < 1e-6, 'a drag of 60 pixels turns the view by %.2f degrees' % turned)
    before = page.run("bolan.ask.get('camera.position')")
    page.key('KeyW')
    page.wait("bolan.ask.get('camera.position') !== %r" % before)
    way = numpy.subtract(*[numpy.array(p.split(','), float)
                           for p in (page.run("bolan.ask.get('camera.position')"), before)])
    ahead = numpy.radians(number(page, 'camera.heading'))
    check(way[0] * numpy.sin(ahead) + way[1] * numpy.cos(ahead) > 0.9 * numpy.hypot(*way[:2]) > 0,
          'the key W flies ahead')
    page.click('#pause')
    check(page.run('bolan.paused') is True, 'a click pauses')
    page.run("document.getElementById('water').focus()")
    page.key('Space', 0)
    check(page.run('bolan.paused') is False, 'the space bar goes on')
    time_before = page.run('bolan.time')
    page.wait('bolan.time > %r' % time_before)


def test_touch(page):
    heading = number(page, 'camera.heading')
    touch = lambda kind, *points: page.call('Input.dispatchTouchEvent', type=kind, touchPoints=[  # noqa: E731
        {'x': x, 'y': y, 'id': i} for i, (x, y) in enumerate(points)])
    touch('touchStart', (200, 200))
    touch('touchMove', (230, 200))
    touch('touchEnd')
    page.wait('bolan.ask.get("camera.heading") != %r' % heading)
    check(number(page, 'camera.heading') < heading, 'a finger turns the view')
    before = page.run("bolan.ask.get('camera.position')")
    touch('touchStart', (200, 200), (240, 200))
    touch('touchMove', (180, 200), (260, 200))
    touch('touchEnd')
    page.wait("bolan.ask.get('camera.position') !== %r" % before)
    check(True, 'two fingers fly')


def test_link(page):
    page.run('''(input => { input.value = 17; input.dispatchEvent(new Event('input')); })
                (document.querySelector("input[data-key='sea.wind.speed']"))''')
    page.wait("location.hash.includes('sea.wind.speed=17')", 10)
    page.click('#pause')
    page.run("bolan.ask.set('water.type', '5C')")  # without the link: it must go when the link is opened
    page.run('showLink()')
    link, keys = page.run('location.hash'), ('sea.wind.speed', 'camera.position', 'camera.heading', 'technique')
    want = [page.run('bolan.ask.get(%r)' % key) for key in keys]
    visit(page, '#scene=pond&scale=0.2')
    visit(page, link)
    got = [page.run('bolan.ask.get(%r)' % key) for key in keys]
    check(got == want and page.run("bolan.ask.get('water.type')") == 'IB', 'a link gives the same sea: %s' % got)


def test_memory(page):
    page.resize(64, 36)
    visit(page, '#scene=open-sea&scale=1&panel=none')
    facts = 'gc(), [bolan.core.asm.memory.buffer.byteLength, bolan.ask.memory(), performance.memory.usedJSHeapSize]'
    before = page.run(facts)
    page.run('bolan.frames = 20')
    page.wait('bolan.frames >= %d' % (20 + FRAMES), 240)
    after = page.run(facts)
    check(before[:2] == after[:2] and after[2] - before[2] < 300_000,
          'memory over %d frames: %s, then %s' % (FRAMES, before, after))


def test_context(page):
    page.resize(*SIZE)
    visit(page, '#scene=open-sea&pause=&scale=1&panel=none')
    before = shown(page)
    with bolan.Renderer(quality='medium', backend='cpu', api='es') as renderer:
        near = decibels(before, native('open-sea', 'ocean', renderer))
    check(near >= LEAST_DB, 'open-sea by ocean: %.1f dB from the native picture' % near)
    page.run("window.lose = document.getElementById('water').getContext('webgl2').getExtension('WEBGL_lose_context')")
    page.run('lose.loseContext()')
    page.wait('!bolan.drawing')
    said = page.run("document.getElementById('message').textContent")
    check('comes back' in said, 'a lost context: "%s"' % said)
    page.run('bolan.frames = 0, lose.restoreContext()')
    page.wait('bolan.drawing && bolan.frames > %d' % SETTLED)
    check(page.run("document.getElementById('message').textContent") == '', 'it comes back')
    check(decibels(before, shown(page)) > 45, 'with the same picture: %.1f dB' % decibels(before, shown(page)))


def test_bad_link(page):
    page.console.clear()
    visit(page, '#scene=open-sea&sea.wind.speed=900&no.such=1&scale=0.2')
    said = [text for kind, text in page.console if kind == 'error']
    check(any('0 to 70 m/s' in text for text in said) and any('no.such' in text for text in said),
          'a wrong value is refused in a sentence: %s' % said)
    check(number(page, 'sea.wind.speed') == 10, 'and the scene keeps its own')


def test_without_webgl(page, address):
    page.call('Page.addScriptToEvaluateOnNewDocument', source='HTMLCanvasElement.prototype.getContext = () => null;')
    page.open('about:blank')
    page.console.clear()
    page.open(address)
    page.wait("(m => m && m.textContent.includes('needs WebGL 2'))(document.getElementById('message'))")
    check(not page.console, 'without WebGL 2 the page says so')


def leave_pictures(page, folder):
    for name, size in (('desktop', (1280, 720)), ('phone', (390, 780))):
        page.resize(*size, phone=name == 'phone')
        visit(page, '#scene=island&scale=0.6')
        page.run('showPanel(true)')
        page.mouse('mouseMoved', 180, size[1] * 0.4)
        time.sleep(1.5)
        page.screenshot(os.path.join(folder, 'web-%s.png' % name))


def main():
    folder, shots = sys.argv[1], os.environ.get('BOLAN_WEB_SHOTS')
    server, page = browser.Server(folder), browser.Browser(*SIZE)
    try:
        test_size(folder)
        page.open(server.address + '#scene=open-sea&pause=&scale=1&panel=none')
        page.wait('window.bolan && bolan.frames > 2')
        check(True, 'the first picture came %.1f s after the files' % (page.run('bolan.firstPicture') / 1e3))
        test_pictures(page)
        test_heights(page)
        test_settings(page)
        test_hands(page)
        test_touch(page)
        test_link(page)
        test_memory(page)
        test_context(page)
        if shots:
            leave_pictures(page, shots)
        check(not page.console, 'nothing on the console: %s' % page.console[:5])
        elsewhere = [url for url in page.asked if not url.startswith((server.address, 'data:', 'about:'))]
        check(not elsewhere and not server.missing, 'nothing asked elsewhere or in vain: %s %s'
              % (elsewhere, server.missing))
        test_bad_link(page)
        test_without_webgl(page, server.address)
    finally:
        page.close()
        server.close()


main()
