// node clicks.mjs netmesh.html GOLDEN FOLDER [NETMESH]: the page as people use it, in headless Chromium, with real
// clicks, keys, drops, drags and touches. A screenshot of each path stays in FOLDER. With the program NETMESH the saved
// diagram is compared with the program's own. With NETMESH_AXE=.../axe.min.js, of the npm package axe-core, that
// checker of accessibility goes over the page in each state.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { has_chromium, open_browser, open_page } from '../../tests/browser/browser.mjs';

if (!has_chromium()) { console.log('SKIPPED: there is no chromium'); process.exit(0); }
const [html, golden, folder] = process.argv.slice(2, 5).map(path => resolve(path)), program = process.argv[5];
const url = 'file://' + html;
mkdirSync(folder, { recursive: true });
const files = mkdtempSync(join(tmpdir(), 'clicks-'));

const check = (holds, words) => { if (!holds) throw new Error(words); };
const equal = (a, b, words) => check(a === b, `${words}: ${JSON.stringify(a)} and not ${JSON.stringify(b)}`);
const status = page => page.run("document.querySelector('#status').textContent");
const text = (page, selector) => page.run(`document.querySelector('${selector}').textContent`);
const done = page => page.until("document.querySelector('#status').textContent.includes('done in')", 'a result');
const bad = page => page.until("document.querySelector('#status').className === 'bad'", 'a fault');
const bars = (page, degree) => page.run(`last.result.pairs.filter(p => p.degree === ${degree}).length`);
const ink = page => page.run("document.querySelector('#view').toDataURL()");
// A list has no popup without a screen: as the keyboard does it.
async function choose(page, selector, value) {
    await page.run(`(() => {
        const select = document.querySelector('${selector}');
        select.focus();
        select.value = ${JSON.stringify(value)};
        if (select.value !== ${JSON.stringify(value)}) throw new Error('no such entry');
        select.dispatchEvent(new Event('change', { bubbles: true }));
    })()`);
}
async function type(page, selector, words) {
    await page.click(selector);
    await page.run(`document.querySelector('${selector}').select()`);
    await page.type(words);
}
// Uniform points of the cube, by a fixed formula.
function cube(count, dim) {
    let state = 1;
    const next = () => (state = (state * 48271) % 2147483647) / 2147483647;
    return Array.from({ length: count }, () => Array.from({ length: dim }, next).join(',')).join('\n');
}
// Bars as the program writes them, and the shade of a place of the plane in the picture, 0 to 255.
const saved_bars = lines => lines.trim().split('\n').filter(line => !line.startsWith('#')).join('\n');
const drawn_bars = async page => saved_bars(await page.run("pers_text(last.result, '')"));
const shade = (page, x, y) => page.run(`(() => {
    const at = [${x}, ${y}].map((place, axis) => Math.round(view.pixel(place, axis)));
    const [red, , , alpha] = view.canvas.getContext('2d').getImageData(...at, 1, 1).data;
    return Math.round(255 + (red - 255) * alpha / 255);  // on white
})()`);
// What has the keyboard: the element's id, or of a bar its pair.
const focused = page => page.run("document.activeElement.id || document.activeElement.dataset.pair || ''");
async function tab_to(page, id) {
    for (let keys = 0; keys < 40; ++keys) {
        if (await focused(page) === id) return;
        await page.key('Tab', 9);
    }
    throw new Error(`no way by the tabulator to ${id}`);
}
async function as_phone(page) {
    await page.send('Emulation.setDeviceMetricsOverride',
        { width: 360, height: 740, deviceScaleFactor: 2, mobile: true });
    await page.send('Emulation.setTouchEmulationEnabled', { enabled: true });
}
async function touch(page, from, to) {
    const at = share => ({ x: from.x + (to.x - from.x) * share, y: from.y + (to.y - from.y) * share });
    const send = (type, ...touchPoints) => page.send('Input.dispatchTouchEvent', { type, touchPoints });
    await send('touchStart', at(0));
    for (let i = 1; i <= 8; ++i) await send('touchMove', at(i / 8));
    await send('touchEnd');
}
// The states that a page can be in, for what goes over all of them.
const states = {
    async 'at first'() {},
    async 'a fault'(page) {
        await page.run("document.querySelector('#text').value = '1 2\\n3 x', compute()");
        await bad(page);
    },
    async 'a diagram'(page) {
        await choose(page, '#sample', 'torus, 3D');
        await done(page);
    },
    async 'bounds and a chosen bar'(page) {
        await page.run("document.querySelector('#bounds').checked = true");
        await choose(page, '#filter', '1');
        await choose(page, '#sample', 'noisy circle, 2D');
        await done(page);
        await page.click('#barcode .bar rect');
    },
    async 'a box'(page) {
        await choose(page, '#filter', '0');
        await choose(page, '#sample', 'circle in a periodic box, 2D');
        await done(page);
    },
    async 'a computation'(page) {
        await page.run("set_box('-,-', 'extent')");
        await page.run(`document.querySelector('#text').value = ${JSON.stringify(cube(20000, 3))}`);
        await choose(page, '#filter', '1');
        await choose(page, '#memory', '1024');
        await page.click('#run');
        await page.until("/vertices, in a block/.test(document.querySelector('#status').textContent)", 'progress');
    },
    async 'advice'(page) {
        await page.run('stop()');
        await page.run(`document.querySelector('#text').value = ${JSON.stringify(cube(3000, 4))}`);
        await choose(page, '#filter', '3');
        await choose(page, '#memory', '16');
        await page.click('#run');
        await bad(page);
    },
};
const ring = Array.from({ length: 24 }, (_, i) =>
    `${Math.cos(i * Math.PI / 12).toFixed(6)}, ${Math.sin(i * Math.PI / 12).toFixed(6)}`).join('\n');

const paths = {
    async 'fingerprints'(page) {
        const lines = await page.run(`new Promise(resolve => {
            const worker = new Worker(worker_url);
            worker.onmessage = ({ data }) => { worker.terminate(); resolve(data.fingerprints); };
            worker.postMessage({ module, fingerprints: true });
        })`);
        equal(lines, readFileSync(golden, 'utf8'), 'fingerprints');
    },
    async 'sample'(page) {
        await choose(page, '#sample', 'figure eight, 2D');
        await done(page);
        check((await status(page)).includes('120 points in 2 dimensions'), await status(page));
        check((await status(page)).includes('auto: the exact alpha complex is affordable'), await status(page));
        check((await text(page, '#barcode-note')).startsWith('exact'), 'the certificate');
        const long = "last.result.pairs.filter(p => p.degree === 1 && p.death > 3 * p.birth).length";
        equal(await page.run(long), 2, 'holes');
    },
    async 'typed points'(page) {
        await type(page, '#text', ring);
        await page.click('#run');
        await done(page);
        equal(await bars(page, 0), 24, 'components');
        equal(await bars(page, 1), 1, 'holes');
        check((await text(page, '#read')).includes('24 points in 2 dimensions'), 'what was read');
    },
    async 'pasted points'(page) {
        await page.click('#text');
        await page.run(`(() => {
            const carried = new DataTransfer();
            carried.setData('text/plain', ${JSON.stringify(ring)});
            const field = document.querySelector('#text');
            const paste = { clipboardData: carried, bubbles: true, cancelable: true };
            if (field.dispatchEvent(new ClipboardEvent('paste', paste)))
                document.execCommand('insertText', false, ${JSON.stringify(ring)});
        })()`);
        await done(page);
        equal(await bars(page, 1), 1, 'holes');
    },
    async 'dropped file'(page) {
        const path = join(files, 'ring.csv');
        writeFileSync(path, 'x;y\n' + ring.replaceAll(', ', ';').replaceAll('.', ',') + '\n');
        const at = { x: 300, y: 300 }, data = { items: [], files: [path], dragOperationsMask: 1 };
        for (const kind of ['dragEnter', 'dragOver', 'drop'])
            await page.send('Input.dispatchDragEvent', { type: kind, ...at, data });
        await done(page);
        equal(await bars(page, 1), 1, 'holes');
        const read = await text(page, '#read');
        check(read.includes('commas read as decimal') && read.includes('skipped header "x;y"'), read);
    },
    async 'chosen file'(page) {
        const path = join(files, 'cube.txt');
        writeFileSync(path, cube(60, 3).replaceAll(',', ' '));
        const { root } = await page.send('DOM.getDocument');
        const { nodeId } = await page.send('DOM.querySelector', { nodeId: root.nodeId, selector: '#file' });
        await page.send('DOM.setFileInputFiles', { nodeId, files: [path] });
        await done(page);
        check((await status(page)).includes('60 points in 3 dimensions'), await status(page));
    },
    async 'wrong line'(page) {
        await type(page, '#text', '1 2\n3 4\n5 six\n');
        await page.click('#run');
        await bad(page);
        check((await status(page)).startsWith('line 3: "six" is not a number'), await status(page));
        await type(page, '#text', '1 2\n3 4 5\n');
        await page.click('#run');
        await bad(page);
        check((await status(page)).includes('line 2: 3 columns where line 1 has 2'), await status(page));
        equal(await text(page, '#read'), '', 'no count of points that are gone');
    },
    async 'columns of a table'(page) {
        const rows = ring.replaceAll(' ', '').split('\n')
            .map((row, i) => `2024-03-01 10:0${i % 10}:00,"Lab A, bench",${row}`);
        rows[5] = '2024-03-01 10:05:00,"Lab B",,NA';
        rows.push(rows[0]);
        const table = 'time,site,x,y\n' + rows.join('\n');
        await page.run(`document.querySelector('#text').value = ${JSON.stringify(table)}`);
        await page.click('#run');
        await bad(page);
        check((await status(page)).includes('columns 3, 4 are numbers'), await status(page));
        await page.run(`document.querySelector('#columns').value = 'x,y'`);
        await page.click('#run');
        await bad(page);
        check((await status(page)).includes('has to be left out'), await status(page));
        await page.click('#missing');
        await done(page);
        const read = await text(page, '#read');
        check(read.includes('left out 1 of 25 rows') && read.includes('1 duplicate merged'), read);
        equal(await bars(page, 1), 1, 'holes');
    },
    async 'certified band'(page) {
        await type(page, '#text', ring);
        await choose(page, '#filter', '1');
        await type(page, '#ratio', '1.8');
        await page.click('#run');
        await done(page);
        const ratio = await page.run('last.result.ratio');
        check(ratio > 1 && ratio <= 1.8, `ratio ${ratio}`);
        equal(await page.run("document.querySelectorAll('#barcode .doubt').length > 0"), true, 'a band');
        check((await text(page, '#barcode')).includes('too short to be certified: death'), 'its legend');
        check((await text(page, '#figures')).includes('worst aspect ratio'), 'figures of the mesh');
        await page.click('#bounds');
        await page.click('#run');
        await page.until("last.wanted.asked.bounds === 1 && !document.querySelector('#run').disabled", 'bounds');
        equal(await page.run("last.result.pairs.find(p => p.degree === 1).exists"), true, 'the hole exists');
        check((await text(page, '#barcode')).includes('certified by its bounds'), 'the legend of bounds');
    },
    async 'what the engine chooses'(page) {
        const curve = Array.from({ length: 1000 }, (_, i) => [i / 1000, (i / 1000) ** 2, (i / 1000) ** 3]);
        await page.run(`document.querySelector('#text').value = ${JSON.stringify(curve.map(p => p.join(' '))
            .join('\n'))}`);
        await page.click('#run');
        await done(page);
        equal(await page.run('last.result.filter'), 1, 'the filter');
        const words = await status(page);
        check(words.includes('filter complete') && words.includes('would take more work than a mesh'), words);
        const print = await page.run('last.result.figures.fingerprint');
        await choose(page, '#filter', '1');
        await page.run('last = null');
        await page.click('#run');
        await page.until("last !== null && !document.querySelector('#run').disabled", 'the mesh that was asked for');
        equal(await page.run('last.result.figures.fingerprint'), print, 'fingerprint');
        await choose(page, '#filter', '0');
        await type(page, '#text', ring);
        await type(page, '#ratio', '1.8');
        await page.run('last = null');
        await page.click('#run');
        await page.until("last !== null && !document.querySelector('#run').disabled", 'a ratio');
        check((await status(page)).includes('as a ratio is asked for'), await status(page));
    },
    // The reader's text of as many points would be slow to type: they come as a file does.
    async 'many points in space'(page) {
        await page.run(`document.querySelector('#text').value = ${JSON.stringify(cube(40000, 3))}`);
        await choose(page, '#memory', '1024');
        await page.run(`window.shares = [];
            new MutationObserver(() => shares.push(document.querySelector('#progress').value))
                .observe(document.querySelector('#progress'), { attributes: true });`);
        await page.click('#run');
        await page.until("document.querySelector('#status').textContent.includes('done in')", 'a result', 120);
        check((await page.run('last.result.pairs.length')) > 100000, 'bars');
        const note = await text(page, '#view-note');
        check(note.includes('too large to draw more of it'), note);
        check(Number(await page.run("document.querySelector('#radius').value")) > 0, 'the slider');
        const shares = await page.run('shares');
        check(shares.length > 3 && shares.every((x, i) => i === 0 || x >= shares[i - 1]), `progress ${shares}`);
        await page.click('#radius', .5, .5);
        check((await text(page, '#betti')).includes('H'), 'holes at the radius');
    },
    async 'a million bars'(page) {
        await choose(page, '#sample', 'noisy circle, 2D');
        await done(page);
        await page.run(`(() => {
            const { result, cloud, wanted } = last, pairs = [];
            for (let i = 0; i < 1000000; ++i)
                pairs.push({ degree: i % 2, birth: i % 2, death: i % 2 + 1 / (1 + i), exists: true, after: 0,
                    cycle: null });
            take_result({ ...result, pairs }, cloud, wanted);
        })()`);
        check((await status(page)).includes('done in'), await status(page));
        check((await text(page, '#barcode')).includes('500,000 bars'), 'the barcode');
        check((await page.run("pers_text(last.result, '').length")) > 1e7, 'the file');
    },
    async 'neighbours'(page) {
        await type(page, '#text', ring);
        equal(await page.run("document.querySelector('#k-label').hidden"), true, 'k hidden');
        await choose(page, '#filter', '4');
        equal(await page.run("document.querySelector('#k-label').hidden"), false, 'k shown');
        await type(page, '#k', '99');
        await page.click('#run');
        await bad(page);
        await type(page, '#k', '2');
        await page.click('#run');
        await done(page);
        await choose(page, '#filter', '9');
        await page.click('#run');
        await page.until('last.result.filter === 9', 'Rips');
        equal(await bars(page, 0), 24, 'components of Rips');
        check(!(await text(page, '#read')).includes('merged'), 'no duplicates');
    },
    async 'cancel'(page) {
        await states['a computation'](page);
        equal(await page.run("document.querySelector('#progress').hidden"), false, 'a bar of progress');
        await page.click('#cancel');
        equal(await status(page), 'cancelled', 'status');
        equal(await page.run("document.querySelector('#progress').hidden"), true, 'no bar of progress');
        await type(page, '#text', ring);
        await page.click('#run');
        await done(page);
    },
    async 'short of memory'(page) {
        await states['advice'](page);
        equal(await page.run("document.querySelector('#advice').hidden"), false, 'advice');
        check((await text(page, '#advice')).includes('were not enough'), 'what was not enough');
        check((await text(page, '#advice button')).includes('try again with 64 MiB'), 'the first advice');
        await page.click('#advice button');
        await done(page);
        check((await page.run('last.result.bytes')) > 16 << 20, 'a larger block');
        equal(await page.run("document.querySelector('#advice').hidden"), true, 'no advice any more');
    },
    async 'slider'(page) {
        await choose(page, '#sample', 'noisy circle, 2D');
        await done(page);
        const state = "[view.counts.edges, view.counts.triangles, Number(document.querySelector('#radius').value)]";
        await page.drag('#radius', [.02, .5], [.9, .5]);
        const far = await page.run(state);
        const far_betti = await text(page, '#betti');
        await page.drag('#radius', [far[2] / 1000, .5], [.01, .5]);
        const near = await page.run(state);
        check(near[2] < 100 && far[2] > 800, `the slider goes from ${near[2]} to ${far[2]}`);
        check(near[0] < far[0] && near[1] < far[1], 'the complex grows');
        check(/H₀ 1,/.test(far_betti) && !/H₀ 1,/.test(await text(page, '#betti')), 'components');
        // All triangles are there at last: V - E + F = 1.
        await page.run("document.querySelector('#radius').value = 1000, show_radius()");
        const [edges, triangles] = await page.run('[view.counts.edges, view.counts.triangles]');
        equal(80 - edges + triangles, 1, 'the Euler characteristic of a disc');
    },
    async 'union of balls'(page) {
        await choose(page, '#sample', 'three clusters, 2D');
        await done(page);
        const complex = await ink(page);
        await choose(page, '#show', 'balls');
        check(await ink(page) !== complex, 'balls look different');
        check(!(await text(page, '#view-note')).includes('edges'), 'no edges');
        await page.click('#radius', .8, .5);
        const larger = await ink(page);
        await page.click('#radius', .1, .5);
        check(await ink(page) !== larger, 'balls shrink');
    },
    async 'turn'(page) {
        await choose(page, '#sample', 'torus, 3D');
        await done(page);
        const before = await ink(page);
        await page.drag('#view', [.4, .5], [.7, .6]);
        const after = await ink(page);
        check(before !== after, 'a drag turns it');
        await page.key('ArrowLeft', 37);
        check(await ink(page) !== after, 'an arrow key turns it');
        const long = "last.result.pairs.filter(p => p.degree === 2 && p.death > 1.25 * p.birth).length";
        equal(await page.run(long), 1, 'voids');
    },
    async 'a bar and its cycle'(page) {
        await choose(page, '#sample', 'two circles, 5D');
        await done(page);
        const longest = await page.run("barcode_groups(last.result.pairs).find(g => g.degree === 1).shown[0]");
        await page.click(`#barcode .bar[data-pair="${longest}"] rect:not(.doubt)`);
        check((await text(page, '#barcode-note')).includes('a cycle of'), await text(page, '#barcode-note'));
        equal(await page.run("document.querySelectorAll('#barcode .chosen').length"), 1, 'one bar is chosen');
        await page.screenshot(join(folder, 'cycle.png'));
        // Each vertex of a closed curve is on two of its edges.
        equal(await page.run(`(() => {
            const ends = new Map();
            for (const v of last.result.pairs[${longest}].cycle) ends.set(v, (ends.get(v) ?? 0) + 1);
            return [...ends.values()].every(n => n % 2 === 0);
        })()`), true, 'the cycle is closed');
        await page.click(`#barcode .bar[data-pair="${longest}"] rect:not(.doubt)`);
        equal(await page.run('chosen'), null, 'none is chosen any more');
    },
    async 'a box with periods'(page) {
        await page.run("last = null");
        await type(page, '#text', '0.1 0.5\n');
        await page.click('#period-x');
        await bad(page);
        check((await status(page)).includes('all points have x = 0.1'), await status(page));
        await page.click('#period-y');
        await type(page, '#box', '0:1,0:1');
        await page.click('#run');
        await done(page);
        equal(await drawn_bars(page), '0 0 inf\n1 0.5 inf\n1 0.5 inf\n2 0.7071067811865476 inf', 'a square lattice');
        equal(await page.run("document.querySelectorAll('#barcode .bar path').length"), 4, 'arrows of bars that last');
        check((await status(page)).includes('box 0:1,0:1: done'), await status(page));
        check((await text(page, '#view-note')).includes('0 edges, 0 triangles at this radius'), 'the complex at first');
        await choose(page, '#show', 'balls');
        await page.run(`document.querySelector('#radius').value = 300 / last.barcode.end, show_radius()`);
        // Right of the box's middle nothing; the copy's ball comes in from the right side, pale outside.
        const white = 255, copy = await shade(page, .95, .5), outside = await shade(page, 1.05, .5);
        check(copy < outside && outside < white, `the ball of a copy: ${copy} in the box, ${outside} outside`);
        equal(await shade(page, .6, .5), white, 'between the balls');
        equal(await shade(page, .05, .5), copy, 'the ball of the point');
        for (const [x, y] of [[.1, 1.5], [1.1, -.5], [1.1, .5], [1.1, 1.5], [.1, -.5]])
            check(await shade(page, x, y) < outside, `the copy at ${x}, ${y}`);
        check((await text(page, '#betti')).endsWith('H₀ 1, H₁ 0, H₂ 0'), await text(page, '#betti'));
        await page.run("document.querySelector('#radius').value = 1000, show_radius()");
        check((await text(page, '#betti')).endsWith('H₀ 1, H₁ 2, H₂ 1'), await text(page, '#betti'));
        // Its two loops go round the torus: by edges from the point to its own copies.
        const loops = await page.run('last.result.pairs.flatMap((p, i) => p.degree === 1 ? [i] : [])');
        const places = [];
        for (const i of loops) {
            await page.click(`#barcode .bar[data-pair="${i}"] rect`);
            places.push([await shade(page, .6, .5), await shade(page, .1, .9)].map(drawn => drawn === 213).join());
        }
        check(places[0] !== places[1] && !places.includes('false,false'), `loops at ${places.join(' and ')}`);
        await choose(page, '#show', 'complex');
        await page.run("document.querySelector('#radius').value = 1000, show_radius()");
        equal(await page.run('[view.counts.edges, view.counts.triangles].join()'), '3,2', 'a torus of one vertex');
        await page.screenshot(join(folder, 'one-point.png'));
        await page.click('#period-y');
        await bad(page);
        check((await status(page)).includes('lie on a line: give the other axis a period'), await status(page));
        await type(page, '#text', '0.1 0.5\n0.1 3.5\n');
        await page.run('last = null');
        await page.click('#run');
        await page.until("last !== null && !document.querySelector('#run').disabled", 'a strip');
        equal(await page.run("document.querySelector('#box').value"), '0:1,-', 'no period along y');
        equal(await drawn_bars(page), '0 0 1.5\n0 0 inf\n1 0.5 1.5811388300841898\n1 0.5 inf', 'two rows of points');
        await page.run(`document.querySelector('#radius').value = 300 / last.barcode.end, show_radius()`);
        equal(await shade(page, .1, 1.5), white, 'no copy above');
        check(await shade(page, 1.1, .5) < outside, 'a copy to the right');
        equal(await page.run("document.querySelector('#show-label').hidden"), true, 'no complex to show');
        check((await text(page, '#view-note')).includes('Edges and triangles are not drawn'), 'what is not drawn');
    },
    async 'points across a box'(page) {
        const ticks = "[...document.querySelectorAll('#periods input[type=checkbox]')].map(box => box.checked).join()";
        await choose(page, '#sample', 'circle in a periodic box, 2D');
        await done(page);
        equal(await page.run("document.querySelector('#box').value"), '0:1,0:1', 'the box of the sample');
        const holes = 'last.result.pairs.filter(p => p.degree === 1 && p.death < Infinity && p.death > 3 * p.birth)';
        equal(await page.run(`${holes}.length`), 1, 'the hole across the sides');
        check((await text(page, '#betti')).endsWith('H₀ 1, H₁ 1, H₂ 0'), 'the radius at first');
        // The complex modulo the periods has the Euler characteristic of the classes that are alive, at every radius.
        equal(await page.run(`Array.from({ length: 101 }, (_, i) => {
            document.querySelector('#radius').value = 10 * i;
            show_radius();
            const classes = document.querySelector('#betti').textContent.match(/\\d+(?=,|$)/g).map(Number);
            return 60 - view.counts.edges + view.counts.triangles === classes[0] - classes[1] + classes[2];
        }).every(x => x)`), true, 'Euler characteristics');
        equal(await page.run('[view.counts.edges, view.counts.triangles].join()'), '180,120', 'the whole torus');
        const hole = await page.run(`last.result.pairs.indexOf(${holes}[0])`);
        await page.click(`#barcode .bar[data-pair="${hole}"] rect`);
        check((await text(page, '#barcode-note')).includes('a cycle of'), await text(page, '#barcode-note'));
        equal(await page.run(`(() => {
            const { cycle } = last.result.pairs[${hole}], ends = new Map();
            for (const v of cycle) ends.set(v, (ends.get(v) ?? 0) + 1);
            const lengths = view.shown.cycle.places, edges = cycle.length / 2;
            const longest = Math.max(...Array.from({ length: edges }, (_, i) =>
                Math.hypot(lengths[4 * i] - lengths[4 * i + 2], lengths[4 * i + 1] - lengths[4 * i + 3])));
            return [edges > 20, [...ends.values()].every(n => n % 2 === 0),
                longest <= 2 * last.result.pairs[${hole}].birth * (1 + 1e-9)].join();
        })()`), 'true,true,true', 'many edges, closed, none longer than the diameter of a ball');
        await page.screenshot(join(folder, 'periodic-cycle.png'));
        const bars = await drawn_bars(page), print = await page.run('last.result.figures.fingerprint');
        if (program) {
            writeFileSync(join(files, 'box.txt'), await page.run("document.querySelector('#text').value"));
            const line = ['persist', 'box.txt', '--box', '0:1,0:1', '--quiet'];
            const ended = spawnSync(resolve(program), line, { cwd: files, encoding: 'utf8' });
            equal(saved_bars(ended.stdout), bars, 'the diagram of the program');
        }
        await page.click('#link');
        await page.until("document.querySelector('#link-note').textContent.includes('address')", 'a link');
        const address = await page.run('location.href');
        await page.send('Page.navigate', { url: 'about:blank' });
        await page.until("location.href === 'about:blank'", 'another page');
        await page.send('Page.navigate', { url: address });
        await page.until("typeof last !== 'undefined' && last !== null", 'the result of a link');
        equal(await page.run('last.result.figures.fingerprint'), print, 'fingerprint');
        // Any copy of a point does.
        await page.run(`last = null, document.querySelector('#text').value = document.querySelector('#text').value
            .split('\\n').map((row, i) => row.split(', ').map((x, k) => i % 5 === 2 * k ? Number(x) + 2 : x).join(', '))
            .join('\\n')`);
        await page.click('#run');
        await page.until("last !== null && !document.querySelector('#run').disabled", 'other copies');
        check((await text(page, '#read')).includes('outside of the box'), await text(page, '#read'));
        const nine_digits = lines => lines.split('\n').map(line => line.split(' ').map(word =>
            word === 'inf' ? word : Number(word).toPrecision(9)).join(' ')).join('\n');
        equal(nine_digits(await drawn_bars(page)), nine_digits(bars), 'bars of other copies');
        await choose(page, '#sample', 'noisy circle, 2D');
        await page.until("last.box === null && !document.querySelector('#run').disabled", 'no periods');
        equal(await page.run(ticks), 'false,false', 'periods of another sample');
        equal(await page.run("document.querySelector('#show-label').hidden"), false, 'the complex is drawn again');
        await page.click('#period-x');
        await page.until("last.box !== null && !document.querySelector('#run').disabled", 'a period');
        const extent = await page.run(`[Math.min, Math.max].map(end => end(...document.querySelector('#text').value
            .split('\\n').map(row => Number(row.split(',')[0])))).join(':') + ',-'`);
        equal(await page.run("document.querySelector('#box').value"), extent, 'the extent of the points');
    },
    async 'boxes that are none'(page) {
        await type(page, '#text', ring);
        await page.click('#period-x');
        await done(page);
        for (const [box, words] of [['10:0,0:1', 'x ends at 0, which is below its start 10: write 0:10'],
            ['0:1,2:2', 'y has length 0: write an end above 2'], ['0:wide,-', '"wide", which is no finite number'],
            ['0:1e999,-', '"1e999", which is no finite number'], ['-,-2', 'write a length above 0, as 2'],
            ['0:1', 'has 1 entry where x and y take one each'], ['0:1:2,-', 'write two numbers'],
            ['-1e308:1e308,-', 'longer than the largest double'], ['0:1e-200,-', 'outside the range']]) {
            await page.run("say('')");
            await type(page, '#box', box);
            await page.click('#run');
            await bad(page);
            check((await status(page)).includes(words), `${box}: ${await status(page)}`);
        }
        await page.run("say('')");
        await type(page, '#box', '-2:2,-2:2');
        await choose(page, '#filter', '1');
        await done(page);
        await page.click('#run');
        await bad(page);
        equal(await status(page), 'periods: of the filter alpha alone; leave out periods', 'what the engine says');
        await choose(page, '#filter', '0');
        await page.run(`document.querySelector('#text').value = ${JSON.stringify(cube(20, 3))}`);
        await page.click('#run');
        await page.until("document.querySelector('#status').textContent.includes('3 coordinates')", 'not in the plane');
        check((await status(page)).includes('choose two columns'), await status(page));
        await page.run("last = null, document.querySelector('#columns').value = '1,3'");
        await page.click('#run');
        await page.until('last !== null', 'two of three columns');
        equal(await page.run('last.cloud.dim'), 2, 'columns');
        equal(await page.run("last.result.pairs.filter(p => p.death === Infinity).length"), 4, 'classes of the torus');
    },
    async 'save'(page, downloads) {
        await choose(page, '#sample', 'sphere, 3D');
        await done(page);
        const saved = async name => {
            const path = join(downloads, name);
            for (let tries = 0; tries < 200 && !existsSync(path); ++tries) await new Promise(r => setTimeout(r, 50));
            return readFileSync(path, 'utf8');
        };
        await page.click('#save-pers');
        const pers = await saved('netmesh.pers');
        const lines = pers.trim().split('\n').filter(line => !line.startsWith('#'));
        equal(lines.length, await page.run('last.result.pairs.length'), 'bars saved');
        check(lines.some(line => /^0 0 inf$/.test(line)), 'the component that never dies');
        await page.click('#save-svg');
        const svg = await saved('netmesh.svg');
        equal(await page.run(`new DOMParser().parseFromString(${JSON.stringify(svg)}, 'image/svg+xml')
            .querySelector('parsererror') === null`), true, 'the SVG is one');
        check(svg.includes('<title>Barcode:'), 'its title');
        if (!program) return;
        writeFileSync(join(files, 'points.txt'), await page.run("document.querySelector('#text').value"));
        const run = (...line) => {
            const ended = spawnSync(resolve(program), line, { cwd: files, encoding: 'utf8' });
            check(ended.status === 0, ended.stderr);
            return ended.stdout;
        };
        writeFileSync(join(files, 'page.pers'), pers);
        run('persist', 'points.txt', '--filter', 'alpha', '--quiet', '-o', 'own.pers');
        const all = readFileSync(join(files, 'own.pers'), 'utf8').trim().split('\n');
        const own = all.filter(line => !line.startsWith('#'));
        equal(own.join('\n'), lines.join('\n'), 'the diagram of the program');
    },
    async 'link'(page) {
        await type(page, '#text', ring);
        await choose(page, '#filter', '1');
        await page.click('#run');
        await done(page);
        await page.click('#link');
        await page.until("document.querySelector('#link-note').textContent.includes('address')", 'a link');
        const address = await page.run('location.href'), print = await page.run('last.result.figures.fingerprint');
        await page.send('Page.navigate', { url: 'about:blank' });
        await page.until("location.href === 'about:blank'", 'another page');
        await page.send('Page.navigate', { url: address });
        await page.until("typeof last !== 'undefined' && last !== null", 'the result of a link');
        equal(await page.run('last.result.figures.fingerprint'), print, 'fingerprint');
        equal(await page.run("document.querySelector('#filter').value"), '1', 'filter');
        await page.send('Page.navigate', { url: 'about:blank' });
        await page.until("location.href === 'about:blank'", 'another page');
        await page.send('Page.navigate', { url: url + '#rubbish' });
        await page.until("document.querySelector('#status')?.className === 'bad'", 'a fault');
        equal(await status(page), 'this link cannot be read', 'a link that is none');
    },
};

// Without a mouse: choose a sample, compute, go through the bars, move the radius, turn.
paths['keyboard'] = async page => {
    await tab_to(page, 'sample');
    await page.key('ArrowDown', 40);
    await done(page);
    check((await status(page)).includes('120 points in 2 dimensions'), await status(page));
    equal(await page.run("document.querySelector('#view').tabIndex"), -1, 'nothing to turn in the plane');
    await tab_to(page, 'run');
    await page.run('last = null');
    await page.key('Enter', 13);
    await page.until("last !== null && !document.querySelector('#run').disabled", 'a result by Enter');
    await page.run("document.querySelector('#sample').focus()");
    for (let i = 0; i < 4; ++i) await page.key('ArrowDown', 40);
    await page.until("document.querySelector('#status').textContent.includes('200 points in 3 dimensions: done')",
        'a sphere');
    await tab_to(page, 'view');
    const before = await ink(page);
    await page.key('ArrowLeft', 37);
    check(await ink(page) !== before, 'an arrow key turns it');
    await page.key('Tab', 9);
    const all = await page.run("bars_shown().map(bar => bar.dataset.pair)");
    equal(await focused(page), all[0], 'the first bar');
    await page.key('ArrowUp', 38);
    equal(await focused(page), all[0], 'nothing above it');
    await page.key('End', 35);
    equal(await focused(page), all[all.length - 1], 'the last bar');
    await page.key('Home', 36);
    await page.key('ArrowDown', 40);
    equal(await focused(page), all[1], 'the second bar');
    await page.key('Enter', 13);
    equal(await page.run('String(chosen)'), all[1], 'the chosen bar');
    equal(await page.run("document.activeElement.getAttribute('aria-pressed')"), 'true', 'pressed');
    await page.key(' ', 32);
    equal(await page.run('chosen'), null, 'chosen no more');
    await page.key('Tab', 9);
    equal(await focused(page), 'radius', 'behind all bars');
    const radius = await page.run("document.querySelector('#radius').value");
    await page.key('ArrowRight', 39);
    check(await page.run("document.querySelector('#radius').value") !== radius, 'the slider');
    await page.key('Tab', 9, 8);
    equal(await focused(page), all[1], 'back to the bar of before');
};
// On a screen of 360 by 740, by fingers.
paths['phone'] = async page => {
    await as_phone(page);
    for (const sample of ['noisy circle, 2D', 'torus, 3D']) {
        await page.run('last = null');
        await choose(page, '#sample', sample);
        await page.until("last !== null && !document.querySelector('#run').disabled", 'a result');
        equal(await page.run('document.documentElement.scrollWidth <= innerWidth'), true, 'nothing beside the screen');
        const scale = "document.querySelector('#barcode svg').getBoundingClientRect().width / last.barcode.width";
        const least = await page.run(`Math.min(...[...document.querySelectorAll('#barcode text')].map(text =>
            text.getAttribute('font-size') * ${scale}))`);
        check(least >= 8, `text of ${least} pixels`);
        const low = await page.run("Math.min(...bars_shown().map(bar => bar.getBoundingClientRect().height))");
        check(low >= 20, `bars of ${low} pixels`);
        // A finger that goes up over the picture scrolls the page.
        const from = await page.place('#view', .5, .5), scroll = await page.run('scrollY'), drawn = await ink(page);
        await touch(page, from, { x: from.x, y: from.y - 150 });
        await page.until(`scrollY > ${scroll} + 50`, 'scrolling over the picture');
        check(await ink(page) === drawn, 'the picture turns then');
    }
    const left = await page.place('#view', .2, .5), right = await page.place('#view', .7, .5), drawn = await ink(page);
    await touch(page, left, right);
    check(await ink(page) !== drawn, 'a finger to the side turns it');
    const bar = await page.place('#barcode .bar:nth-of-type(2)');
    await touch(page, bar, bar);
    await page.until('chosen !== null', 'a bar by a touch');
};
// What a screen reader is told.
paths['screen reader'] = async page => {
    for (const [name, lead] of Object.entries(states)) {
        await lead(page);
        const { nodes } = await page.send('Accessibility.getFullAXTree');
        const spoken = ['button', 'combobox', 'textbox', 'spinbutton', 'checkbox', 'slider', 'img', 'image',
            'progressbar', 'progressIndicator', 'region'];
        const named = nodes.filter(node => !node.ignored && spoken.includes(node.role?.value));
        check(named.length > 12, `${name}: ${named.length} elements`);
        for (const { role, name: { value } } of named)
            check(value?.trim().length > 0, `${name}: a ${role.value} without a name`);
    }
    await page.run("stop(), set_box('-,-', 'extent')");
    await choose(page, '#memory', '256');
    await choose(page, '#filter', '0');
    await choose(page, '#sample', 'noisy circle, 2D');
    await done(page);
    const { nodes } = await page.send('Accessibility.getFullAXTree');
    const names = role => nodes.filter(node => !node.ignored && node.role?.value === role).map(node => node.name.value);
    check(names('button').some(words => /^H1: 0\.\d+ to 0\.\d+, certified to exist$/.test(words)),
        `a bar's name: ${names('button').join('; ')}`);
    const pictures = [...names('img'), ...names('image')];
    check(pictures.some(words => /^Picture at radius .*: 80 points, \d+ edges/.test(words)), 'the picture');
    equal(await page.run("document.querySelector('#radius').getAttribute('aria-valuetext')"),
        await text(page, '#radius-value'), 'the radius in words');
    equal(await page.run("document.querySelector('#status').getAttribute('aria-busy')"), 'false', 'not busy');
    equal(await page.run("document.querySelector('#figures th').scope"), 'row', 'heads of rows');
};
if (process.env.NETMESH_AXE !== undefined) {
    const axe = readFileSync(process.env.NETMESH_AXE, 'utf8');
    for (const phone of [false, true]) for (const [name, lead] of Object.entries(states)) {
        paths[`axe${phone ? ' on a phone' : ''}, ${name}`] = async page => {
            if (phone) await as_phone(page);
            await lead(page);
            await page.run(axe);
            const found = await page.run(`axe.run().then(({ violations, passes }) => ({ passes: passes.length,
                violations: violations.map(({ id, help, nodes }) =>
                    [id, help, nodes[0].html.slice(0, 200)].join(', ')) }))`);
            equal(found.violations.join('\n'), '', 'violations');
            check(found.passes > 20, `${found.passes} rules`);
        };
    }
}

let failed = 0;
const wanted = process.env.NETMESH_PATHS?.split(',') ?? Object.keys(paths);
const browser = await open_browser(1200, 1300);
try {
    for (const name of wanted) {
        const downloads = mkdtempSync(join(files, 'saved-'));
        const page = await open_page(browser, url, { downloads });
        await page.until("typeof compute === 'function'", 'the page');
        try { await paths[name](page, downloads); } catch (error) {
            console.log(`FAULT ${name}: ${error.message}; the page says "${await status(page).catch(() => '')}"`);
            ++failed;
        }
        for (const fault of page.faults) { console.log(`FAULT ${name}: ${fault}`); ++failed; }
        const shot = await page.screenshot(join(folder, name.replaceAll(' ', '-') + '.png'));
        if (shot.length < 5000) { console.log(`FAULT ${name}: a screenshot of ${shot.length} bytes`); ++failed; }
        await page.close();
    }
    console.log(`${wanted.length} paths by clicks in ${await browser.version()}, ${failed} faults`);
} finally {
    await browser.close();
    rmSync(files, { recursive: true, force: true });
}
process.exit(failed === 0 ? 0 : 1);
