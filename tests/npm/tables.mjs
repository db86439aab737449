// node tables.mjs NETMESH: the tables of tests/tools/parts/odd_files.cpp and random ones, read by JavaScript as by the
// program: the same points, or a refusal by both.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseTable } from '../../platform/wasm/npm/table.mjs';

const program = process.argv[2], folder = mkdtempSync(join(tmpdir(), 'tables-'));

// Of notes about columns that may be no coordinates, what both readers say in the same words.
const slipsIn = text => text.match(new RegExp('took [^;\\n]*, too|took [^;\\n]*looks like[^;\\n]*, for|' +
    '[^;:\\n]* look like degrees|[^;:\\n]*, far from its|what stands behind # in every row|' +
    'took [^;\\n]*counts rows', 'g'))?.map(slip => slip.trim()) ?? [];

// { points } or { refused }; of points that have no triangulation nothing but that they were read.
function byProgram(content, options) {
    const path = join(folder, 'p.txt'), out = join(folder, 'p.node');
    writeFileSync(path, content);
    const words = [options.columns && ['--columns', options.columns.join(',')], options.delimiter &&
        ['--delimiter', options.delimiter === ' ' ? 'blank' : options.delimiter === '\t' ? 'tab' : options.delimiter],
        options.skip && ['--skip', String(options.skip)], options.dropMissing && ['--drop-missing']]
        .filter(Boolean).flat();
    const { status, stderr } = spawnSync(program, ['delaunay', path, '-o', out, ...words], { encoding: 'utf8' });
    if (status === 5) return {};
    if (status !== 0) return { refused: stderr };
    const rows = readFileSync(out, 'utf8').trim().split('\n').filter(line => !line.startsWith('#'));
    const [count, dim] = rows[0].split(' ').map(Number);
    return { points: rows.slice(1, 1 + count).flatMap(row => row.split(' ').slice(1, 1 + dim).map(Number)),
        slips: slipsIn(stderr) };
}
function byReader(content, options) {
    try {
        const { points, dim, notes } = parseTable(content, options);
        return dim < 2 || dim > 6 ? { refused: `${dim} columns` }
            : { points: [...points], slips: slipsIn(notes.join('; ')) };
    } catch (error) {
        return { refused: error.message };
    }
}
const seen = { same: 0, refused: 0 };
function compare(name, content, options = {}) {
    const due = byProgram(content, options), found = byReader(content, options);
    const words = `${name}: ${JSON.stringify(content)} ${JSON.stringify(options)}: ${JSON.stringify([due, found])}`;
    assert.equal('refused' in found, 'refused' in due, words);
    ++seen['refused' in due ? 'refused' : 'same'];
    if ('points' in due) assert.deepEqual(found, due, words);
}

// Cases that are one literal, without options or with them.
const source = readFileSync(new URL('../tools/parts/odd_files.cpp', import.meta.url), 'utf8');
const tables = source.slice(source.indexOf('std::vector<OddFile> tables()'),
    source.indexOf('std::vector<OddFile> formats()'));
const literal = '"((?:[^"\\\\]|\\\\[nrt"\\\\])*)"';
const behind = `(?:\\), ${literal}(?:, ${literal})?(?:, (\\d+))?\\))?,\\n`;  // of with(...): columns, delimiter, skip
const cases = new RegExp(`(with\\()?(?:good|bad)\\("([^"]+)",\\s*${literal}(?=[,)])[^\\n]*?${behind}`, 'g');
const plain = text => JSON.parse(`"${text}"`);
for (const [, isWith, name, content, columns, delimiter, skip] of tables.matchAll(cases)) {
    if (name.endsWith('.xyz') || name.endsWith('.off') || name.endsWith('.ply') || name.endsWith('.pdb')) continue;
    if (isWith && columns === undefined && delimiter === undefined) continue;
    const options = {};
    if (columns) options.columns = plain(columns).split(/,(?=(?:[^"]*"[^"]*")*[^"]*$)/);
    if (delimiter) options.delimiter = plain(delimiter) === 'blank' ? ' ' : plain(delimiter);
    if (skip) options.skip = Number(skip);
    if (columns?.includes('\\"')) continue;  // quotes of the command line
    compare(name, plain(content), options);
}
assert.ok(seen.same + seen.refused > 100, JSON.stringify(seen));

// What is no table, named and not read as one.
for (const [content, what] of [['OFF\n3 0 0\n1 2 3\n4 5 6\n7 8 8\n', /an OFF file.*program netmesh/],
    ['ply\nformat ascii 1.0\n', /a PLY file/], ['solid a\nfacet normal 0 0 1\n', /an STL file/],
    ['v 1 2 3\nv 1 2 4\n', /an OBJ file/], ['ATOM      1  N   ALA A   1       1.500\n', /a PDB file/],
    ['3\nwater\nO 0 0 1\nH 0 1 0\nH 1 0 0\n', /atoms in .xyz/], ['{"points": []}', /JSON/],
    ['[[1, 2], [3, 4]]', /without brackets/], ['<!doctype html>\n', /HTML/], ['ITEM: TIMESTEP\n0\n', /LAMMPS/],
    ['1\0\t\x002\0', /no text/]])
    assert.throws(() => parseTable(content), what, content);

// Random ones, in every dialect, whole or with a field that is broken.
let state = 7;
const below = n => Math.floor((state = (state * 48271) % 2147483647) / 2147483647 * n);
const of = list => list[below(list.length)];
for (let i = 0; i < 300; ++i) {
    const decimal = below(3) === 0, dim = 2 + below(3), rows = 5 + below(6);
    const delimiter = of(decimal ? [';', '\t', '|', '; ', ' | ']
        : [',', ';', '\t', ' ', '|', ', ', ' ; ', '   ', ' | ']);
    const end = of(['\n', '\r\n']), word = below(3) === 0 && delimiter.trim() !== '';
    const written = x => decimal ? String(x).replace('.', ',') : String(x);
    const lines = Array.from({ length: rows }, () => [...word ? [of(['a', 'Lab A', '"b"', ''])] : [],
        ...Array.from({ length: dim }, () => written((below(2000001) - 1000000) / 10 ** of([1, 4, 7])))]);
    if (below(3) === 0)
        lines[1 + below(rows - 1)][lines[0].length - 1 - below(dim)] = of(['NA', '', '-', 'x', '1.2.3', 'nan']);
    const names = [...word ? ['name'] : [], ...Array.from({ length: dim }, (_, k) => `x${k}`)];
    const header = below(2) === 0 || word ? [names] : [];
    const options = { ...word ? { columns: names.slice(1) } : {}, ...below(2) ? { dropMissing: true } : {} };
    compare(`random ${i}`, [...header, ...lines].map(row => row.join(delimiter)).join(end) + end, options);
}
rmSync(folder, { recursive: true, force: true });
console.log(`${seen.same} tables are the same, ${seen.refused} refused by both`);
