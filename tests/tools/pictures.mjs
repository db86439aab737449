// node pictures.mjs NETMESH [FOLDER]: a picture of each kind as Chromium draws it: no two texts touch by the widths of
// its font, none leaves the page, each has a title and a description, and there is ink. The PNG stay in FOLDER.
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { has_chromium, open_browser, open_page } from '../browser/browser.mjs';

if (!has_chromium()) { console.log('SKIPPED: there is no chromium'); process.exit(0); }
const program = resolve(process.argv[2]);
const folder = process.argv[3] ? resolve(process.argv[3]) : mkdtempSync(join(tmpdir(), 'pictures-'));
mkdirSync(folder, { recursive: true });

const run = line => {
    const { status, stderr } = spawnSync(program, line.split(' '), { cwd: folder, encoding: 'utf8' });
    if (status !== 0) throw new Error(`netmesh ${line}: ${stderr}`);
};
run('sample circle -n 60 --noise 0.05 -o circle.txt');
run('sample clusters -n 80 -o clusters.txt');
run('sample torus -n 400 -o torus.txt');
run('sample sphere -n 120 -o sphere.txt');
run('sample annulus -n 150 -o annulus.txt');
writeFileSync(join(folder, 'complex.txt'), '0 -3\n1 -2.5\n2 -1\n0 1 0\n1 2 0.5\n0 2 1\n0 1 2 2.25\n');

const kinds = {
    'diagram': 'persist circle.txt -o d.pers --svg',
    'diagram-bounds': 'persist annulus.txt --bounds -o d.pers --svg',
    'diagram-linear': 'persist torus.txt --axis linear -o d.pers --svg',
    'diagram-alpha': 'persist torus.txt --filter alpha -o d.pers --svg',
    'diagram-clusters': 'persist clusters.txt --filter alpha -o d.pers --svg',
    'diagram-function': 'persist circle.txt --filter function --function x*x+y*y-.5 --lipschitz 3 --cut 0.2 --bounds '
        + '-o d.pers --svg',
    'diagram-negative': 'homology complex.txt -o d.pers --svg',
    'vineyard': 'vineyard circle.txt --k 1..6 -o v.vines --svg',
    'mesh': 'mesh circle.txt -o m.node --svg',
    'mesh-cages': 'mesh clusters.txt --method netmesh -o m.node --svg',
    'voronoi': 'mesh circle.txt -o m.node --voronoi --svg',
    'voronoi-fine': 'mesh circle.txt --eps .4 -o m.node --voronoi --svg',
    'delaunay': 'delaunay annulus.txt -o m.node --svg',
    'cut': 'mesh sphere.txt -o m.node --svg',
    'cut-delaunay': 'delaunay sphere.txt -o m.node --svg',
    'cycles': 'persist torus.txt --filter alpha -o d.pers --representatives',
    'cycles-plane': 'persist annulus.txt -o d.pers --representatives',
};
let failed = 0, texts = 0;
const browser = await open_browser(1280, 1120);
try {
    for (const [name, line] of Object.entries(kinds)) {
        run(`${line} ${name}.svg --quiet`);
        const svg = readFileSync(join(folder, `${name}.svg`), 'utf8');
        const html = `<!DOCTYPE html><meta charset="utf-8"><body style="margin:0">${svg}`;
        writeFileSync(join(folder, 'page.html'), html);
        const page = await open_page(browser, 'file://' + join(folder, 'page.html'));
        await page.until("document.querySelector('svg') !== null", 'the picture');
        const found = await page.run(`(() => {
            const svg = document.querySelector('svg'), page = svg.getBoundingClientRect(), faults = [];
            const texts = [...svg.querySelectorAll('text')].map(t => [t.textContent, t.getBoundingClientRect()]);
            texts.forEach(([a, p], i) => {
                if (p.left < 0 || p.top < 0 || p.right > page.right || p.bottom > page.bottom)
                    faults.push('outside: ' + a);
                texts.slice(0, i).forEach(([b, q]) => {
                    if (p.left < q.right && q.left < p.right && p.top < q.bottom && q.top < p.bottom)
                        faults.push(a + ' | ' + b);
                });
            });
            for (const part of ['title', 'desc'])
                if (!svg.querySelector(part)?.textContent) faults.push('no ' + part);
            return { faults, texts: texts.length };
        })()`);
        const png = await page.screenshot(join(folder, `${name}.png`), true);
        if (png.length < 10000) found.faults.push(`a PNG of ${png.length} bytes`);
        for (const fault of found.faults) console.log(`FAULT ${name}: ${fault}`);
        failed += found.faults.length;
        texts += found.texts;
        await page.close();
    }
} finally {
    await browser.close();
    if (!process.argv[3]) rmSync(folder, { recursive: true });
}
console.log(`${Object.keys(kinds).length} pictures, ${texts} texts, ${failed} faults`);
process.exit(failed === 0 ? 0 : 1);
