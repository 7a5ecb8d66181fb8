// Controls Chromium without npm packages: uses its debugging protocol over two pipes.

import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

export class Browser {
  static async open(file, { width = 1300, height = 1000 } = {}) {
    const browser = new Browser();
    browser.folder = mkdtempSync(join(tmpdir(), 'explorer-'));
    browser.process = spawn('chromium', ['--headless=new', '--no-sandbox', '--disable-gpu', '--no-first-run', '--disable-extensions',
      '--disable-dev-shm-usage', `--user-data-dir=${browser.folder}`, `--window-size=${width},${height}`, '--remote-debugging-pipe', 'about:blank'],
      { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    browser.#listen();
    const { targetInfos } = await browser.#send('Target.getTargets');
    const { sessionId } = await browser.#send('Target.attachToTarget', { targetId: targetInfos.find(t => t.type === 'page').targetId, flatten: true });
    browser.session = sessionId;
    await browser.#send('Runtime.enable');
    await browser.#send('Page.enable');
    await browser.#send('Log.enable');
    await browser.#send('Performance.enable', { timeDomain: 'threadTicks' });
    await browser.size(width, height);
    await browser.#send('Page.navigate', { url: pathToFileURL(file).href });
    while (await browser.run('document.readyState') !== 'complete') await new Promise(done => setTimeout(done, 100));
    return browser;
  }

  process;
  folder;
  session;
  problems = [];  ///< errors and warnings on the console
  #next = 1;
  #waiting = new Map();

  #listen() {
    let rest = '';
    this.process.stdio[4].setEncoding('utf8').on('data', data => {
      const messages = (rest + data).split('\0');
      rest = messages.pop();
      for (const text of messages) {
        const message = JSON.parse(text);
        if (message.id) {
          const { resolve, reject } = this.#waiting.get(message.id);
          this.#waiting.delete(message.id);
          message.error ? reject(new Error(message.error.message)) : resolve(message.result);
        } else if (message.method === 'Runtime.exceptionThrown') {
          this.problems.push(message.params.exceptionDetails.exception?.description ?? message.params.exceptionDetails.text);
        } else if (message.method === 'Runtime.consoleAPICalled' && ['error', 'warning'].includes(message.params.type)) {
          this.problems.push(message.params.args.map(arg => arg.value).join(' '));
        } else if (message.method === 'Log.entryAdded') {
          this.problems.push(message.params.entry.text);
        }
      }
    });
  }

  #send(method, params = {}) {
    const id = this.#next++;
    this.process.stdio[3].write(JSON.stringify({ id, method, params, sessionId: this.session }) + '\0');
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject }));
  }

  size(width, height) {
    return this.#send('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: width < 500 });
  }

  /// Returns the value of an expression in the page; waits for it if it is a promise.
  async run(expression) {
    const { result, exceptionDetails } = await this.#send('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  /// Returns the processor time in seconds that the page's main thread has used. It does not depend on the load of the
  /// machine.
  async processorTime() {
    const { metrics } = await this.#send('Performance.getMetrics');
    return metrics.find(metric => metric.name === 'TaskDuration').value;
  }

  key(key) {
    return this.#send('Input.dispatchKeyEvent', { type: 'keyDown', key }).then(() => this.#send('Input.dispatchKeyEvent', { type: 'keyUp', key }));
  }

  mouse(type, x, y) {
    return this.#send('Input.dispatchMouseEvent', { type, x, y, button: 'left', buttons: type === 'mouseReleased' ? 0 : 1, clickCount: 1 });
  }

  async picture() {
    const { data } = await this.#send('Page.captureScreenshot', { format: 'png', captureBeyondViewport: true });
    return Buffer.from(data, 'base64');
  }

  async close() {
    const gone = new Promise(done => this.process.on('exit', done));
    this.process.kill();
    await gone;
    rmSync(this.folder, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  }
}
