"""Headless Chromium, driven through its DevTools pipe: waits on conditions, hears every request and every complaint.

    with Browser(profile) as browser:
        browser.open(path)
        browser.until('document.querySelector("figure.view").dataset.state')
"""
import base64
import json
import os
import select
import shutil
import subprocess
import time

PATIENCE = 90  # seconds for a condition to come true, where machines run many tests at once
SWITCHES = ['--headless', '--no-sandbox', '--no-first-run', '--disable-background-networking', '--disable-component-update',
            '--disable-dev-shm-usage', '--hide-scrollbars', '--remote-debugging-pipe']
SOFTWARE_GL = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader']
# what the software renderer says of itself is no complaint of the page's
GL_REMARK = 'GPU stall due to ReadPixels'


class Browser:
    """One page. complaints: what the console got and what went uncaught; requests: addresses asked for, data: left out"""

    def __init__(self, profile, webgl=True):
        switches = SWITCHES + (SOFTWARE_GL if webgl else ['--disable-3d-apis', '--disable-gpu'])
        to_it, self.to = os.pipe()
        self.back, from_it = os.pipe()
        self.inbox, self.number, self.complaints, self.requests = b'', 0, [], []
        self.events, self.session, self.shown = {}, None, 0
        # it reads at 3 and writes at 4
        line = 'exec 3<&%d 4>&%d; exec "$@"' % (to_it, from_it)
        self.process = subprocess.Popen(['bash', '-c', line, 'bash', 'chromium'] + switches + ['--user-data-dir=' + profile],
                                        pass_fds=(to_it, from_it), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_it)
        os.close(from_it)

    def __enter__(self):
        target = self.call('Target.createTarget', url='about:blank')['targetId']
        self.session = self.call('Target.attachToTarget', targetId=target, flatten=True)['sessionId']
        for name in ('Page', 'Runtime', 'Log', 'Network'):
            self.call(name + '.enable')
        return self

    def __exit__(self, *_):
        os.close(self.to)
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self.back)

    # --- messages

    def receive(self, until):
        while b'\0' not in self.inbox:
            left = until - time.monotonic()
            if left <= 0 or not select.select([self.back], [], [], left)[0]:
                raise TimeoutError('the browser says nothing')
            got = os.read(self.back, 1 << 20)
            if not got:
                raise EOFError('the browser ended')
            self.inbox += got
        one, _, self.inbox = self.inbox.partition(b'\0')
        return json.loads(one)

    def call(self, method, **given):
        self.number += 1
        message = {'id': self.number, 'method': method, 'params': given}
        if self.session:
            message['sessionId'] = self.session
        data = json.dumps(message).encode() + b'\0'
        while data:
            data = data[os.write(self.to, data):]
        until = time.monotonic() + PATIENCE
        while True:
            answer = self.receive(until)
            if answer.get('id') == self.number:
                if 'error' in answer:
                    raise RuntimeError(method + ': ' + answer['error']['message'])
                return answer['result']
            self.hear(answer.get('method'), answer.get('params', {}))

    def hear(self, event, told):
        self.events[event] = told
        if event == 'Network.requestWillBeSent' and not told['request']['url'].startswith('data:'):
            self.requests.append(told['request']['url'])
        elif event == 'Runtime.exceptionThrown':
            self.complaints.append(told['exceptionDetails'].get('exception', {}).get('description', 'uncaught'))
        elif event == 'Runtime.consoleAPICalled' and told['type'] in ('error', 'warning', 'assert'):
            self.complaints.append(' '.join(str(a.get('value', a.get('description'))) for a in told['args']))
        elif event == 'Log.entryAdded' and told['entry']['level'] in ('error', 'warning'):
            if GL_REMARK not in told['entry']['text']:
                self.complaints.append(told['entry']['text'])

    # --- what one does with a page

    def size(self, width, height, phone=False):
        self.call('Emulation.setDeviceMetricsOverride', width=width, height=height, deviceScaleFactor=1, mobile=phone)

    def media(self, kind='', **features):
        self.call('Emulation.setEmulatedMedia', media=kind,
                  features=[{'name': 'prefers-' + k.replace('_', '-'), 'value': v} for k, v in features.items()])

    def open(self, path):
        self.complaints.clear()
        self.requests.clear()
        self.events.clear()
        self.call('Page.navigate', url='file://' + os.path.abspath(path))
        self.until('document.readyState === "complete" && location.protocol === "file:"')
        self.requests.remove(self.requests[0])  # the page itself

    def ask(self, expression):
        answer = self.call('Runtime.evaluate', expression=expression, returnByValue=True, awaitPromise=True)
        if 'exceptionDetails' in answer:
            raise RuntimeError(answer['exceptionDetails'].get('exception', {}).get('description', expression))
        return answer['result'].get('value')

    def until(self, expression):
        until = time.monotonic() + PATIENCE
        while not self.ask(expression):
            if time.monotonic() > until:
                raise TimeoutError('never true: ' + expression)
            time.sleep(0.02)

    def press(self, key, shift=False):
        codes = {'Tab': 9, 'Enter': 13, ' ': 32, 'End': 35, 'Home': 36, 'ArrowLeft': 37, 'ArrowUp': 38, 'ArrowRight': 39,
                 'ArrowDown': 40}
        of = {'key': key, 'windowsVirtualKeyCode': codes.get(key, ord(key[0])), 'modifiers': 8 if shift else 0}
        of.update({'text': {'Enter': '\r'}.get(key, key)} if len(key) == 1 or key == 'Enter' else {})
        self.call('Input.dispatchKeyEvent', type='keyDown', **of)
        self.call('Input.dispatchKeyEvent', type='keyUp', **of)

    def seen(self, selector):
        """what the first such element looks like, as a PNG of half its size"""
        box = self.ask('(({x, y, width, height}) => ({x: x + scrollX, y: y + scrollY, width, height}))'
                       '(document.querySelector(%s).getBoundingClientRect())' % json.dumps(selector))
        return base64.b64decode(self.call('Page.captureScreenshot', format='png', clip=dict(box, scale=0.5))['data'])

    def print(self, path):
        pdf = self.call('Page.printToPDF', printBackground=False)['data']
        with open(path, 'wb') as f:
            f.write(base64.b64decode(pdf))


def there():
    return shutil.which('chromium') is not None
