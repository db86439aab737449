// node browser.mjs PACKAGE GOLDEN PROFILE: the package in headless Chromium, in the page's thread and in a worker,
// from a
// server on this machine.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const [folder, golden, profile] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const page = `<pre id="said"></pre><script type="importmap">{"imports": {"netmesh": "/index.mjs"}}</script>
<script type="module">
import { load, loadWorker } from 'netmesh';
import { compare } from './slice.mjs';
const say = text => fetch('/said', { method: 'POST', body: text });
try {
    const netmesh = await load();
    const { faults, count } = compare(netmesh, await (await fetch('/golden')).text());
    const points = Array.from({ length: 60 }, (_, i) => [Math.cos(i), Math.sin(i)]);
    const worker = await loadWorker();
    const same = (await worker.persist(points)).fingerprint === netmesh.persist(points).fingerprint;
    await say(JSON.stringify({ faults, count, same }));
} catch (error) { await say(JSON.stringify({ faults: [error.stack] })); }
</script>`;
const types = { mjs: 'text/javascript', wasm: 'application/wasm', html: 'text/html' };
let heard;
const said = new Promise(resolve => { heard = resolve; });
const server = createServer((request, response) => {
    if (request.method === 'POST') {
        let text = '';
        request.on('data', part => { text += part; });
        request.on('end', () => { response.end(); heard(JSON.parse(text)); });
        return;
    }
    const name = request.url.slice(1) || 'page.html';
    response.setHeader('content-type', types[name.split('.').pop()] ?? 'text/plain');
    try {
        if (name === 'page.html') response.end(page);
        else if (name === 'golden') response.end(readFileSync(golden));
        else response.end(readFileSync(join(name === 'slice.mjs' ? here : folder, name)));
    } catch {
        response.statusCode = 404;
        response.end();
    }
});
await new Promise(resolve => server.listen(0, '127.0.0.1', resolve));
const browser = spawn('chromium', ['--headless=new', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage',
    `--user-data-dir=${profile}`, `http://127.0.0.1:${server.address().port}/`], { stdio: 'ignore' });
const late = setTimeout(() => heard({ faults: ['nothing heard of the page'] }), 120000);
const { faults, count, same } = await said;
clearTimeout(late);
const gone = new Promise(resolve => browser.on('exit', resolve));
browser.kill();
await gone;
server.close();
server.closeAllConnections();
assert.deepEqual(faults, []);
assert.ok(count > 100 && same);
console.log(`${count} fingerprints equal in Chromium, and the same in a worker`);
