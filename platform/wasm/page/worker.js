'use strict';
// One job after the other, in a thread of its own; whoever wants to cancel ends the thread.
const OUT_OF_MEMORY = 2, FLAT = 6, PAGE = 65536;
const stages = ['', 'sorting', 'triangulating', 'refining', 'certifying', 'filtering', 'pairing', 'reducing', 'checking',
    'measuring'];
// Where each of them ends in a run, about.
const stage_ends = [0, .03, .25, .5, .6, .7, .8, .95, .97, 1];

// A JavaScript function as one of WebAssembly's, (i32, i32) -> i32, that can stand in a table: a module of 36 bytes that
// hands on what it imports.
const handed_on = f => new WebAssembly.Instance(new WebAssembly.Module(new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0,
    1, 7, 1, 96, 2, 127, 127, 1, 127, 2, 7, 1, 1, 112, 1, 102, 0, 0, 7, 5, 1, 1, 102, 0, 0])), { p: { f } }).exports.f;

// A fresh program with a block of so many bytes behind `count` numbers; null when the browser has no such memory.
function program(module, count, block_bytes) {
    const { exports } = new WebAssembly.Instance(module, {});
    const numbers = exports.heap() >>> 0, block = numbers + Math.ceil(8 * count / 16) * 16;
    const missing = Math.ceil((block + block_bytes - exports.memory.buffer.byteLength) / PAGE);
    try { if (missing > 0) exports.memory.grow(missing); } catch { return null; }
    return { exports, numbers, block };
}

const text_at = ({ memory }, at) => {
    const all = new Uint8Array(memory.buffer);
    let end = at >>> 0;
    while (all[end] !== 0) ++end;
    return new TextDecoder().decode(all.slice(at >>> 0, end));
};

function watch(exports, say) {
    let last = 0;
    const poll = handed_on((user, at) => {
        const now = performance.now();
        if (now - last < 50) return 0;
        last = now;
        const view = new DataView(exports.memory.buffer, at >>> 0, 40);
        const number = offset => Number(view.getBigUint64(offset, true));
        const stage = view.getUint32(4, true), total = number(16), done = total > 0 ? Math.min(1, number(8) / total) : 0;
        const from = stage_ends[Math.max(0, stage - 1)] ?? 0, to = stage_ends[stage] ?? from;
        say({ stage: stages[stage] ?? '', share: from + (to - from) * done, vertices: number(24) });
        return 0;
    });
    const table = exports.__indirect_function_table, index = table.grow(1);
    table.set(index, poll);
    exports.watch(index);
}

// Offsets in the structs of netmesh.h, all of which begin with their size.
function results(exports, dim, asked, periods) {
    const view = () => new DataView(exports.memory.buffer);
    const vertex_count = exports.vertices(), cell_count = exports.cells();
    const places = new Float64Array(vertex_count * dim), values = new Float64Array(vertex_count);
    const markers = new Uint8Array(vertex_count), cells = new Uint32Array(cell_count * (dim + 1));
    let has_values = false, at, data = view();
    for (let i = 0; i < vertex_count && (at = exports.vertex(i) >>> 0) !== 0; ++i) {
        for (let k = 0; k < dim; ++k) places[i * dim + k] = data.getFloat64(at + 8 + 8 * k, true);
        markers[i] = data.getUint32(at + 4, true);
        has_values = data.getUint32(at + 56, true) === 1;
        values[i] = data.getFloat64(at + 64, true);
    }
    for (let i = 0; i < cell_count && (at = exports.cell(i) >>> 0) !== 0; ++i)
        for (let k = 0; k <= dim; ++k) cells[i * (dim + 1) + k] = data.getUint32(at + 4 + 4 * k, true);
    const pairs = [];
    for (let i = 0; (at = exports.pair(i) >>> 0) !== 0; ++i) {
        pairs.push({ degree: data.getUint32(at + 4, true), birth: data.getFloat64(at + 8, true),
            death: data.getFloat64(at + 16, true), exists: null, after: 0, cycle: null, copies: null });
    }
    const ratio = exports.certified_ratio(), from = exports.certified_from();
    pairs.forEach((pair, i) => {
        const bounds = exports.bar_bounds(i) >>> 0;
        // Death from which on a bar of that birth is certified to exist.
        pair.after = bounds !== 0 ? data.getFloat64(bounds + 40, true)
            : ratio === 1 && from === 0 ? pair.birth : pair.birth === 0 ? from : ratio * ratio * Math.max(pair.birth, from);
        pair.exists = bounds !== 0 ? data.getUint32(bounds + 4, true) === 1
            : pair.death > pair.after || ratio === 1 && from === 0;
    });
    if (asked.cycles) longest_cycles(exports, pairs, data, periods);
    const hex = word => (word >>> 0).toString(16).padStart(8, '0');
    return { dim, places, values, markers, cells, has_values, pairs, ratio, from, filter: exports.filter_taken(),
        why: text_at(exports, exports.why()),
        figures: { vertices: vertex_count, inputs: exports.inputs(), cells: cell_count, simplices: exports.simplices(),
            copies: exports.copies(), moved: exports.moved(),
            aspect_ratio: exports.aspect_ratio(), peak_bytes: exports.peak_bytes(),
            fingerprint: hex(exports.fingerprint_high()) + hex(exports.fingerprint_low()),
            version: text_at(exports, exports.version()) } };
}

// Of the 24 longest bars of each degree from 1 on: vertices, and with periods how many of each vector take them to the
// copy that is meant.
function longest_cycles(exports, pairs, data, periods) {
    for (let degree = 1; degree < 6; ++degree) {
        const order = pairs.map((pair, i) => i).filter(i => pairs[i].degree === degree);
        const length = i => pairs[i].death - pairs[i].birth;
        order.sort((i, j) => length(j) === length(i) ? 0 : length(j) - length(i));
        for (const i of order.slice(0, 24)) {
            const count = exports.cycle_length(i);
            const cycle = new Uint32Array(count * (degree + 1)), copies = new Int32Array(cycle.length * periods);
            for (let j = 0; j < count; ++j) {
                const at = exports.cycle_simplex(i, j) >>> 0;
                for (let v = 0; v <= degree; ++v) {
                    const to = j * (degree + 1) + v;
                    cycle[to] = data.getUint32(at + 16 + 4 * v, true);
                    for (let k = 0; k < periods; ++k)
                        copies[to * periods + k] = data.getInt32(at + 144 + 24 * v + 4 * k, true);
                }
            }
            if (count > 0) Object.assign(pairs[i], { cycle, copies });
        }
    }
}

// The vectors by which points repeat, if they do.
function repeat({ exports }, lattice, dim) {
    if (lattice.length === 0) return;
    const at = exports.repeat(lattice.length / dim) >>> 0;
    new Float64Array(exports.memory.buffer, at, lattice.length).set(lattice);
}

function work({ module, points, dim, lattice, asked, limit }) {
    const count = points.length / dim;
    const arguments_of = [asked.filter, asked.k, asked.degree, asked.ratio];
    const planner = program(module, 0, 0);
    repeat(planner, lattice, dim);
    const planned = planner.exports.plan(count, dim, ...arguments_of);
    let bytes = Math.min(limit, Math.max(4 << 20, Math.ceil(1.1 * planned))), reached = 0, again = false;
    for (let chosen = null;;) {
        const made = program(module, points.length, bytes);
        if (made === null && chosen !== null) return chosen;
        if (made === null) return { fault: 'the browser has no more memory', kind: 'memory', bytes, planned };
        const { exports, numbers, block } = made;
        new Float64Array(exports.memory.buffer, numbers, points.length).set(points);
        repeat(made, lattice, dim);
        const start = reached;
        watch(exports, progress => {
            reached = Math.max(reached, start + (1 - start) * .9 * progress.share);
            postMessage({ progress: { ...progress, share: reached, bytes, again } });
        });
        const begin = performance.now();
        const status = exports.run(numbers, count, dim, block, bytes, ...arguments_of, asked.bounds, asked.cycles);
        if (status === 0) {
            chosen = { ...results(exports, dim, asked, lattice.length / dim), milliseconds: performance.now() - begin, bytes, planned };
            // What the engine chooses does not depend on how large the block happens to be.
            if (asked.filter !== 0 || exports.gave_up() === 0 || bytes >= limit) return chosen;
        } else if (status !== OUT_OF_MEMORY) {
            const words = status === FLAT && lattice.length > 0
                ? 'the points and their copies lie on a line: give the other axis a period, too, or add a point beside the line'
                : text_at(exports, exports.message()) || text_at(exports, exports.status_text(status));
            const field = text_at(exports, exports.field()).replace(/^lattice$/, 'box');
            return { fault: field === '' ? words : `${field}: ${words}`, kind: 'input', bytes, planned };
        }
        if (bytes >= limit) return { fault: 'the block is too small', kind: 'memory', bytes, planned };
        bytes = Math.min(limit, 2 * bytes);
        again = true;
    }
}

onmessage = ({ data }) => {
    if (data.fingerprints) {
        const made = program(data.module, 0, 56 << 20);
        postMessage({ fingerprints: text_at(made.exports, made.exports.fingerprints(made.block, 56 << 20)) });
        return;
    }
    try { postMessage({ result: work(data) }); } catch (error) {
        postMessage({ result: { fault: String(error.message ?? error), kind: 'input' } });
    }
};
