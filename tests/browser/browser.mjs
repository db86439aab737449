// Headless Chromium by the DevTools protocol over a pipe: pages, clicks, keys, pictures. Needs node and nothing else.
import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export const has_chromium = () => spawnSync('chromium', ['--version'], { stdio: 'ignore' }).status === 0;

export async function open_browser(width = 1280, height = 1000) {
    const profile = mkdtempSync(join(tmpdir(), 'chromium-'));
    const child = spawn('chromium', ['--headless=new', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage',
        '--hide-scrollbars', '--remote-debugging-pipe', `--window-size=${width},${height}`,
        `--user-data-dir=${profile}`, 'about:blank'], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
    let rest = '', last = 0;
    const waiting = new Map(), listeners = [];
    child.stdio[4].on('data', data => {
        rest += data;
        for (let end; (end = rest.indexOf('\0')) >= 0; rest = rest.slice(end + 1)) {
            const message = JSON.parse(rest.slice(0, end));
            if (message.id === undefined) { for (const listener of listeners) listener(message); continue; }
            const { resolve, reject } = waiting.get(message.id);
            waiting.delete(message.id);
            message.error ? reject(new Error(message.error.message)) : resolve(message.result);
        }
    });
    const send = (method, params = {}, sessionId = undefined) => new Promise((resolve, reject) => {
        waiting.set(++last, { resolve, reject });
        child.stdio[3].write(JSON.stringify({ id: last, method, params, sessionId }) + '\0');
    });
    const close = async () => {
        const ended = new Promise(resolve => child.once('exit', resolve));
        await Promise.race([send('Browser.close').catch(() => {}), ended]);
        const timer = setTimeout(() => child.kill('SIGKILL'), 5000);
        if (child.exitCode === null && child.signalCode === null) await ended;
        clearTimeout(timer);
        rmSync(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
    };
    return { send, close, listeners, version: async () => (await send('Browser.getVersion')).product };
}

const pause = milliseconds => new Promise(resolve => setTimeout(resolve, milliseconds));

// A page of that address. Errors that nothing catches and errors on the console are collected in `faults`.
export async function open_page(browser, url, { downloads = null, fresh = true } = {}) {
    const context = fresh ? (await browser.send('Target.createBrowserContext')).browserContextId : undefined;
    const { targetId } = await browser.send('Target.createTarget', { url: 'about:blank', browserContextId: context });
    const { sessionId } = await browser.send('Target.attachToTarget', { targetId, flatten: true });
    const send = (method, params) => browser.send(method, params, sessionId);
    const faults = [];
    browser.listeners.push(message => {
        if (message.sessionId !== sessionId) return;
        const { exceptionDetails, entry, type, args } = message.params;
        if (message.method === 'Runtime.exceptionThrown')
            faults.push(exceptionDetails.exception?.description ?? exceptionDetails.text);
        else if (message.method === 'Log.entryAdded' && entry.level === 'error') faults.push(`console: ${entry.text}`);
        else if (message.method === 'Runtime.consoleAPICalled' && type === 'error')
            faults.push(`console: ${args.map(arg => arg.value ?? arg.description).join(' ')}`);
    });
    await send('Log.enable');
    await send('Page.enable');
    await send('Runtime.enable');
    if (downloads !== null)
        await browser.send('Browser.setDownloadBehavior',
            { behavior: 'allow', browserContextId: context, downloadPath: downloads });
    await send('Page.navigate', { url });
    const page = {
        send, faults,
        async run(expression) {
            const { result, exceptionDetails } = await send('Runtime.evaluate',
                { expression, returnByValue: true, awaitPromise: true });
            if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
            return result.value;
        },
        // Until the expression is true; else a fault with the words.
        async until(expression, words, seconds = 60) {
            for (let tries = 0; tries < seconds * 20; ++tries) {
                if (await page.run(`document.readyState === 'complete' && !!(${expression})`)) return;
                await pause(50);
            }
            throw new Error(`${words} does not come within ${seconds} s`);
        },
        // Middle of the element, or a share of the way through it.
        async place(selector, x = 0.5, y = 0.5) {
            const box = await page.run(`(() => {
                const e = document.querySelector(${JSON.stringify(selector)});
                if (e === null) return null;
                e.scrollIntoView({ block: 'center', behavior: 'instant' });
                const b = e.getBoundingClientRect();
                return b.width > 0 && b.height > 0 ? [b.left, b.top, b.width, b.height] : null;
            })()`);
            if (box === null) throw new Error(`nothing to click on: ${selector}`);
            return { x: box[0] + x * box[2], y: box[1] + y * box[3] };
        },
        async mouse(type, at, more = {}) {
            await send('Input.dispatchMouseEvent', { type, ...at, button: 'left', clickCount: 1, ...more });
        },
        async click(selector, x, y) {
            const at = await page.place(selector, x, y);
            await page.mouse('mousePressed', at);
            await page.mouse('mouseReleased', at);
        },
        async drag(selector, from, to) {
            const a = await page.place(selector, ...from), b = await page.place(selector, ...to);
            await page.mouse('mousePressed', a);
            for (let i = 1; i <= 4; ++i)
                await page.mouse('mouseMoved', { x: a.x + (b.x - a.x) * i / 4, y: a.y + (b.y - a.y) * i / 4 },
                    { buttons: 1 });
            await page.mouse('mouseReleased', b);
        },
        async key(name, code, modifiers = 0) {
            const key = { key: name, code: name === ' ' ? 'Space' : name, windowsVirtualKeyCode: code, modifiers };
            const text = { Enter: '\r', ' ': ' ' }[name];
            await send('Input.dispatchKeyEvent', { type: text ? 'keyDown' : 'rawKeyDown', ...key, text });
            await send('Input.dispatchKeyEvent', { type: 'keyUp', ...key });
        },
        // As from a keyboard or the clipboard, at once.
        async type(text) { await send('Input.insertText', { text }); },
        async screenshot(path, whole = false) {
            const { data } = await send('Page.captureScreenshot', { format: 'png', captureBeyondViewport: whole });
            const bytes = Buffer.from(data, 'base64');
            writeFileSync(path, bytes);
            return bytes;
        },
        async close() {
            await browser.send('Target.closeTarget', { targetId });
            if (context === undefined) return;
            await browser.send('Target.disposeBrowserContext', { browserContextId: context });
        },
    };
    return page;
}
