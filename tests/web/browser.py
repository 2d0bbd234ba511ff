# SPDX-License-Identifier: MIT
"""A headless Chromium, driven by the DevTools protocol over a pair of pipes, and a server of one folder."""
import base64
import functools
import http.server
import json
import os
import select
import shutil
import subprocess
import tempfile
import threading
import time

# Of Debian and Ubuntu, and of others.
NAMES = ('chromium', 'chromium-browser', 'google-chrome')
# WebGL 2 by Mesa's software OpenGL, which the native pictures have too; nothing is asked of the network.
FLAGS = ('--headless', '--no-sandbox', '--use-gl=angle', '--use-angle=gl-egl', '--ignore-gpu-blocklist',
         '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update',
         '--disable-sync', '--disable-extensions', '--mute-audio', '--remote-debugging-pipe',
         '--enable-precise-memory-info', '--js-flags=--expose-gc')


def find():
    """The path of a Chromium; None where there is none."""
    return next(filter(None, map(shutil.which, NAMES)), None)


class Server:
    """Serves a folder from 127.0.0.1 at a free port, and remembers what was asked for in vain."""

    def __init__(self, folder):
        missing = self.missing = []

        class Handler(http.server.SimpleHTTPRequestHandler):
            def log_message(self, *_):
                pass

            def send_error(self, code, *rest):
                missing.append(self.path)
                super().send_error(code, *rest)

        Handler.extensions_map['.wasm'] = 'application/wasm'
        handler = functools.partial(Handler, directory=folder)
        self._server = http.server.ThreadingHTTPServer(('127.0.0.1', 0), handler)
        self.address = 'http://127.0.0.1:%d/' % self._server.server_port
        threading.Thread(target=self._server.serve_forever, daemon=True).start()

    def close(self):
        self._server.shutdown()


class Browser:
    """One page. Methods of the protocol by call(); what the page says on its console is kept in `console`, the
    addresses that it asks for in `asked`."""

    def __init__(self, width, height, extra=()):
        self.profile = tempfile.mkdtemp(prefix='bolan-chromium-')
        to_it, self.send_end = os.pipe()
        self.read_end, from_it = os.pipe()

        def place_pipes():  # the protocol reads from 3 and writes to 4
            a, b = os.dup(to_it), os.dup(from_it)
            a, b = (os.dup(a), os.dup(b)) if a in (3, 4) or b in (3, 4) else (a, b)
            os.dup2(a, 3)
            os.dup2(b, 4)

        self.process = subprocess.Popen(
            [find(), *FLAGS, *extra, '--user-data-dir=' + self.profile, '--window-size=%d,%d' % (width, height),
             'about:blank'],
            close_fds=False, preexec_fn=place_pipes, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_it)
        os.close(from_it)
        self.buffer, self.number, self.session, self.console, self.asked = b'', 0, None, [], []
        target = self.call('Target.createTarget', url='about:blank')['targetId']
        self.session = self.call('Target.attachToTarget', targetId=target, flatten=True)['sessionId']
        for domain in ('Page', 'Runtime', 'Log', 'Network'):
            self.call(domain + '.enable')
        self.resize(width, height)

    def close(self):
        try:
            self.session = None
            self.call('Browser.close', seconds=10)
            self.process.wait(10)
        except (OSError, TimeoutError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
        os.close(self.send_end)
        os.close(self.read_end)
        shutil.rmtree(self.profile, ignore_errors=True)

    def _message(self, end):
        while b'\0' not in self.buffer:
            if not select.select([self.read_end], [], [], max(end - time.monotonic(), 0))[0]:
                raise TimeoutError('the browser does not answer')
            part = os.read(self.read_end, 1 << 20)
            if not part:
                raise OSError('the browser has ended')
            self.buffer += part
        text, self.buffer = self.buffer.split(b'\0', 1)
        return json.loads(text)

    def _event(self, message):
        kind, said = message.get('method'), message.get('params', {})
        if kind == 'Runtime.consoleAPICalled':
            words = ' '.join(str(a.get('value', a.get('description', ''))) for a in said['args'])
            self.console.append((said['type'], words))
        elif kind == 'Runtime.exceptionThrown':
            detail = said['exceptionDetails']
            self.console.append(('exception', detail.get('exception', {}).get('description', detail['text'])))
        elif kind == 'Log.entryAdded':
            self.console.append((said['entry']['level'], said['entry']['text']))
        elif kind == 'Network.requestWillBeSent':
            self.asked.append(said['request']['url'])

    def call(self, method, seconds=240, **parameters):
        self.number += 1
        message = {'id': self.number, 'method': method, 'params': parameters}
        if self.session:
            message['sessionId'] = self.session
        os.write(self.send_end, json.dumps(message).encode() + b'\0')
        end = time.monotonic() + seconds
        while True:
            answer = self._message(end)
            if answer.get('id') != self.number:
                self._event(answer)
            elif 'error' in answer:
                raise RuntimeError('%s: %s' % (method, answer['error']['message']))
            else:
                return answer['result']

    def run(self, script, seconds=240):
        """The value of an expression of the page, of a promise when it is kept."""
        answer = self.call('Runtime.evaluate', seconds, expression=script, returnByValue=True, awaitPromise=True)
        if 'exceptionDetails' in answer:
            detail = answer['exceptionDetails']
            raise RuntimeError(detail.get('exception', {}).get('description', detail['text']))
        return answer['result'].get('value')

    def wait(self, condition, seconds=120):
        end = time.monotonic() + seconds
        while not self.run('!!(%s)' % condition):
            if time.monotonic() > end:
                raise TimeoutError('still not: %s; the console: %s' % (condition, self.console[-5:]))
            time.sleep(0.05)

    def open(self, address):
        self.call('Page.navigate', url=address)

    def resize(self, width, height, phone=False):
        self.call('Emulation.setDeviceMetricsOverride', width=width, height=height, deviceScaleFactor=1, mobile=phone)

    def screenshot(self, path):
        picture = self.call('Page.captureScreenshot', format='png')
        with open(path, 'wb') as file:
            file.write(base64.b64decode(picture['data']))

    def mouse(self, kind, x, y, button='none', buttons=0):
        self.call('Input.dispatchMouseEvent', type=kind, x=x, y=y, button=button, buttons=buttons,
                  clickCount=0 if kind == 'mouseMoved' else 1)

    def click(self, selector):
        x, y = self.run('(e => (e.scrollIntoView(), e = e.getBoundingClientRect(), [e.x + e.width / 2, '
                        'e.y + e.height / 2]))(document.querySelector(%s))' % json.dumps(selector))
        self.mouse('mousePressed', x, y, 'left', 1)
        self.mouse('mouseReleased', x, y, 'left')

    def drag(self, start, end, steps=4):
        self.mouse('mousePressed', *start, 'left', 1)
        for i in range(1, steps + 1):
            self.mouse('mouseMoved', *(a + (b - a) * i / steps for a, b in zip(start, end)), 'left', 1)
        self.mouse('mouseReleased', *end, 'left')

    def key(self, code, seconds=0.3):
        name = {'Space': ' '}.get(code, code[-1].lower())
        self.call('Input.dispatchKeyEvent', type='keyDown', code=code, key=name)
        time.sleep(seconds)
        self.call('Input.dispatchKeyEvent', type='keyUp', code=code, key=name)
