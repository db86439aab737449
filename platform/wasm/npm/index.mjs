// netmesh for JavaScript: typed arrays in, typed arrays out. Each call runs in an instance of its own, whose memory
// goes with it; a mesh keeps its instance. No dependency.

export { parseTable } from './table.mjs';

const STAGES = ['none', 'sort', 'delaunay', 'refine', 'certify', 'filter', 'gradient', 'reduce', 'check', 'analyse'];
const STATUSES = ['ok', 'invalid-argument', 'out-of-memory', 'cancelled', 'not-finite', 'out-of-range', 'flat',
    'too-close', 'no-result', 'check-failed', 'floating-point', 'internal', 'not-a-complex', 'not-built'];
// What an error is about where it has another name here than in the engine.
const ARGUMENTS = { dim: 'points', point_count: 'points', focus_ratio: 'focus', focus_from: 'focus', focus_to: 'focus',
    cycles: 'representatives', numbers: 'distances', pairs_a: 'a', pairs_b: 'b', relative_error: 'error', k_last: 'k',
    simplex_count: 'simplices', vertices: 'simplices', starts: 'simplices', entries: 'values', step_count: 'steps' };
const OF_ROWS = ['not-finite', 'out-of-range', 'too-close', 'not-a-complex'];
const FAULTS = ['', 'no vertices, or more than 32', 'more simplices of its dimension than can be numbered',
    'a vertex twice', 'is there already', 'a face is not there', 'a face enters later'];
const LONGER_THAN = 1.5;  // of focus: "auto"
const PAGE = 65536, PAIR_BYTES = 24, LARGEST_PAGES = 65536;

/** Anything that is refused or cannot be done. `status` says what, `argument` and `row` what it is about. */
export class NetmeshError extends Error {
    constructor(status, message, argument = null, row = null) {
        super(message);
        this.name = 'NetmeshError';
        this.status = status;
        this.argument = argument;
        this.row = row;
    }
}

const refuse = (argument, why) => { throw new NetmeshError('invalid-argument', `${argument}: ${why}`, argument); };
const choose = (words, value, argument) => words.has(value) ? words.get(value)
    : refuse(argument, `${value} is none of ${[...words.keys()].join(', ')}`);
const whole = (value, argument, least, most) => Number.isInteger(value) && value >= least && value <= most ? value
    : refuse(argument, `must be a whole number from ${least} to ${most}`);
const PURPOSES = new Map([['mesh', null], ['persist', 'complete'], ['tight', 'tight']]);  // filters of meshes
const isGiven = value => value !== undefined && value !== null && value !== false;
const inEngine = name => name === 'representatives' ? 'cycles' : name.replace(/[A-Z]/g, c => `_${c.toLowerCase()}`);

/** The module: from a URL, a Response, bytes or a compiled module; by default netmesh.wasm beside this file. */
async function compiled(source) {
    source = await (source ?? new URL('./netmesh.wasm', import.meta.url));
    if (source instanceof WebAssembly.Module) return source;
    if (typeof source === 'string') source = new URL(source, globalThis.location?.href ?? import.meta.url);
    if (source instanceof URL && source.protocol === 'file:' && globalThis.process?.versions?.node) {
        const { readFile } = await import('node:fs/promises');
        source = await readFile(source);
    } else if (source instanceof URL) {
        source = await fetch(source);
    }
    if (typeof Response !== 'undefined' && source instanceof Response) source = await source.arrayBuffer();
    return WebAssembly.compile(source);
}

// An instance of the module and one job in it.
class Job {
    constructor({ module, table }, progress) {
        this.table = table;
        this.progress = progress;
        this.failure = null;
        const poll = (stage, done, total, vertices, cells) => {
            const now = performance.now();
            if (now < this.next) return 0;
            this.next = now + 100;
            try {
                return this.progress({ stage: STAGES[stage], done, total, vertices, cells }) === true ? 1 : 0;
            } catch (error) {
                this.failure = { error };
                return 1;
            }
        };
        // A function of the caller's; what it throws ends the job.
        const evaluate = at => {
            if (this.failure) return NaN;
            const x = new Float64Array(this.memory.buffer, at, this.dim).slice();
            try {
                const value = this.function(x);
                if (typeof value !== 'number') refuse('function', 'has returned something that is not a number');
                if (!Number.isFinite(value))
                    throw new NetmeshError('not-finite', `function: ${value} at ${[...x].join(', ')}`, 'function');
                return value;
            } catch (error) {
                this.failure = { error };
                return NaN;
            }
        };
        this.next = 0;
        this.rows = 'points';
        this.exports = new WebAssembly.Instance(module, { netmesh: { poll, evaluate } }).exports;
        this.memory = this.exports.memory;
        this.inputEnd = this.exports.input();
    }
    // A request with these options, in place of the last one; what is none of the table's is for others.
    ask(options, names = {}) {
        const at = this.exports.fresh(this.progress ? 1 : 0);
        this.names = { ...names };
        for (const [name, value] of Object.entries(options)) {
            const row = this.table[inEngine(name)];
            if (!row || !isGiven(value)) continue;
            if (!(row.name in ARGUMENTS)) this.names[row.name] ??= name;
            row.put(new DataView(this.memory.buffer, at + row.offset), value, this.argument(row.name));
        }
    }
    // The rows of one of the engine's tables, as words of 32 bits.
    rowsOf(name, ...of) {
        const rows = [];
        for (let at; (at = this.exports[name](...of, rows.length)) !== 0;)
            rows.push(new Uint32Array(this.memory.buffer, at, 10).slice());
        return rows;
    }
    // Figures of the last job by their paths; those that say nothing are left out.
    report() {
        const figures = {};
        for (const [, type, path, at, isArray, count, applies, , , text] of this.rowsOf('figure')) {
            if (!applies) continue;
            const view = new DataView(this.memory.buffer);
            const values = Array.from({ length: count }, (_, i) => type <= 2 ? view.getUint32(at + 4 * i, true)
                : type === 4 ? view.getFloat64(at + 8 * i, true) : view.getBigUint64(at + 8 * i, true));
            figures[this.text(path)] = type === 6 ? this.text(text)
                : type === 5 ? values[0].toString(16).padStart(16, '0')
                : isArray ? values.map(Number) : Number(values[0]);
        }
        return figures;
    }
    text(at) {
        const all = new Uint8Array(this.memory.buffer);
        return new TextDecoder().decode(all.slice(at, all.indexOf(0, at)));
    }
    // Room for so many bytes up to `end`.
    grow(end) {
        const missing = Math.ceil((end - this.memory.buffer.byteLength) / PAGE);
        if (missing <= 0) return true;
        if (end > LARGEST_PAGES * PAGE) return false;
        try {
            this.memory.grow(missing);
            return true;
        } catch {
            return false;
        }
    }
    // A typed array goes to the input, behind what is there; returns where it is.
    put(array) {
        const at = this.inputEnd;
        if (!this.grow(at + array.byteLength + 16)) this.outOfMemory();
        new array.constructor(this.memory.buffer, at, array.length).set(array);
        this.inputEnd = Math.ceil((at + array.byteLength) / 16) * 16;
        return at;
    }
    outOfMemory() {
        throw new NetmeshError('out-of-memory', 'memory: more than a module can have, or the browser gives', 'memory');
    }
    // Runs a job in all memory behind the input, which grows until it is enough. `memory`: bytes, and no more.
    run(name, plan, memory) {
        const begin = Math.ceil(this.inputEnd / 16) * 16;
        const limit = LARGEST_PAGES * PAGE - begin - PAGE;
        let bytes = memory ?? Math.min(limit, Math.max(PAGE, Math.ceil((plan > 0 ? plan : 0) * 1.05)));
        for (let made = false;;) {
            if (!this.grow(begin + bytes)) return made ? undefined : this.outOfMemory();
            const status = this.exports[name](begin, bytes);
            this.end = begin + bytes;
            made = status === 0;
            // "auto" does not choose by how large the block happens to be.
            const isSmall = made ? this.report()['diagram.why'] === 'memory' : STATUSES[status] === 'out-of-memory';
            if (this.failure || !isSmall || memory !== undefined || bytes >= limit) return this.done(status);
            bytes = Math.min(limit, 2 * bytes);
        }
    }
    // A diagram of the mesh that is there may need more memory: the mesh is made again in twice as much.
    persist(memory) {
        for (;;) {
            try {
                return this.go('persist_here');
            } catch (error) {
                if (error.status !== 'out-of-memory' || memory !== undefined) throw error;
                this.run('mesh_again', 2 * (this.end - this.inputEnd));
            }
        }
    }
    // On what the context holds.
    go(name) { this.done(this.exports[name]()); }
    done(status) {
        if (this.failure) {
            const { error } = this.failure;
            this.failure = null;
            throw error;
        }
        if (status === 0) return;
        const kind = STATUSES[status] ?? 'internal';
        const view = new DataView(this.memory.buffer, this.exports.detail());
        const message = view.getUint32(40, true), step = Number(view.getBigUint64(48, true));
        const about = view.getUint32(8, true), option = Object.values(this.table).find(row => row.field === about);
        const field = option?.name ?? (about && this.text(this.exports.netmesh_field_text(about)));
        let said = message ? this.text(message) : this.text(this.exports.netmesh_status_text(status));
        const ofStep = step > 0 ? `, at step ${step}` : '';
        const argument = kind === 'not-a-complex' ? 'simplices' : OF_ROWS.includes(kind) ? this.rows
            : kind === 'out-of-memory' ? 'memory' : kind === 'flat' ? 'points' : field ? this.argument(field) : null;
        const row = OF_ROWS.includes(kind) || field === 'numbers' ? Number(view.getBigUint64(16, true)) : null;
        if (kind === 'not-a-complex') said = FAULTS[view.getUint32(12, true)] + ofStep;
        if (argument === 'steps') said += ofStep;
        const place = argument === null ? '' : row === null ? `${argument}: ` : `${argument}, row ${row}: `;
        throw new NetmeshError(kind, place + said, argument, row);
    }
    // What a field of the engine's is called by the caller.
    argument(field) {
        return this.names?.[field] ?? ARGUMENTS[field] ?? field.replace(/_(.)/g, (_, c) => c.toUpperCase());
    }
    // Arrays that a call of arrays.h writes behind the block: read(name, its numbers, [Float64Array, 6]), null: none.
    read(name, first, ...wanted) {
        let at = Math.ceil(this.end / 16) * 16;
        const places = wanted.map(want => {
            if (want === null) return 0;
            const here = at;
            at = Math.ceil((at + want[0].BYTES_PER_ELEMENT * want[1]) / 16) * 16;
            return here;
        });
        if (!this.grow(at)) this.outOfMemory();
        this.done(this.exports[`netmesh_array_${name}`](this.exports.context(), ...first, ...places));
        return wanted.map((want, i) => want && new want[0](this.memory.buffer, places[i], want[1]).slice());
    }
}

// Points as { array, count, dim }.
function pointsOf(points, dim) {
    if (points instanceof Float64Array || points instanceof Float32Array) {
        if (dim === undefined) refuse('dim', 'a typed array of coordinates needs it');
        whole(dim, 'dim', 1, 65536);
        if (points.length % dim !== 0) refuse('points', `${points.length} coordinates are no rows of ${dim}`);
        return { array: points, count: points.length / dim, dim };
    }
    if (!Array.isArray(points) || points.length === 0 || typeof points[0]?.length !== 'number')
        refuse('points', 'neither a Float64Array, a Float32Array nor rows of numbers');
    const width = points[0].length, array = new Float64Array(points.length * width);
    points.forEach((row, i) => {
        if (row?.length !== width) refuse('points', `row ${i} has another length than row 0`);
        for (let j = 0; j < width; ++j)
            array[i * width + j] = typeof row[j] === 'number' ? row[j] : refuse('points', `row ${i} is not of numbers`);
    });
    return { array, count: points.length, dim: width };
}

// Without coordinates that are the same in all points, where two others are left: an isometric copy.
function withoutConstant(read) {
    const { array, count, dim } = read, kept = [];
    for (let k = 0; k < dim && count > 1; ++k) {
        let i = k;
        while (i < array.length && array[i] === array[k]) i += dim;
        if (i < array.length) kept.push(k);
    }
    if (kept.length < 2 || kept.length === dim) return read;
    const copy = new array.constructor(count * kept.length);
    for (let i = 0; i < count; ++i) kept.forEach((k, j) => { copy[i * kept.length + j] = array[i * dim + k]; });
    return { array: copy, count, dim: kept.length };
}

// A square of at least three rows, 0 on its diagonal, with equal halves, none below 0.
function looksLikeDistances({ array, count, dim }) {
    if (count < 3 || dim !== count) return false;
    for (let i = 0; i < count; ++i)
        for (let j = 0; j <= i; ++j) {
            const there = array[i * count + j];
            if (i === j ? there !== 0 : there !== array[j * count + i] || !(there >= 0)) return false;
        }
    return true;
}

// What is given of balls about points; undefined: nothing.
function ballsOf({ radii, weights }, count) {
    if (!isGiven(radii) && !isGiven(weights)) return undefined;
    if (isGiven(radii) && isGiven(weights)) refuse('weights', 'give radii or weights');
    const argument = isGiven(radii) ? 'radii' : 'weights', numbers = numbersOf(radii ?? weights, argument);
    if (numbers.length !== count) refuse(argument, `${numbers.length} numbers, where there are ${count} points`);
    return { argument, numbers };
}

// The vectors by which points repeat, one behind the other; undefined: they do not.
function latticeOf({ lattice }, dim) {
    if (!isGiven(lattice)) return undefined;
    if (!Array.isArray(lattice) || lattice.length === 0) refuse('lattice', `a list of vectors of ${dim} numbers`);
    const numbers = new Float64Array(lattice.length * dim);
    lattice.forEach((vector, i) => {
        const row = numbersOf(vector, 'lattice');
        if (row.length !== dim) refuse('lattice', `vector ${i} has ${row.length} numbers, where points have ${dim}`);
        numbers.set(row, i * dim);
    });
    return { numbers, count: lattice.length };
}

/** A persistence diagram: bars by degree, births and deaths are radii, the death of what never dies is Infinity. */
export class Diagram {
    #intervals;
    #starts;
    constructor(fields, intervals, starts) {
        Object.assign(this, fields);
        this.#intervals = intervals;
        this.#starts = starts;
    }
    get length() { return this.#intervals.length / 2; }
    get maxDegree() { return this.#starts.length - 2; }
    /** Float64Array [m, 2] of one degree: birth, death, birth, death ...; not a copy. */
    intervals(degree) {
        whole(degree, 'degree', 0, this.maxDegree);
        return this.#intervals.subarray(2 * this.#starts[degree], 2 * this.#starts[degree + 1]);
    }
    /** The longest bars of a degree, the longest first: Float64Array [at most count, 2]. What never dies is longest. */
    longest(degree = 1, count = 1) {
        const bars = this.intervals(degree), length = i => bars[2 * i + 1] - bars[2 * i];
        const order = Array.from({ length: bars.length / 2 }, (_, i) => i);
        order.sort((i, j) => length(j) === length(i) ? i - j : length(j) - length(i));
        const chosen = order.slice(0, whole(count, 'count', 1, 2 ** 32));
        return Float64Array.from(chosen.flatMap(i => [bars[2 * i], bars[2 * i + 1]]));
    }
    /** Numbers of the first bar of a degree and of the first one behind it, in bounds and representatives. */
    rows(degree) {
        this.intervals(degree);
        return [this.#starts[degree], this.#starts[degree + 1]];
    }
    *[Symbol.iterator]() {
        for (let degree = 0; degree <= this.maxDegree; ++degree) {
            const bars = this.intervals(degree);
            for (let i = 0; i < bars.length; i += 2) yield { degree, birth: bars[i], death: bars[i + 1] };
        }
    }
    /** What crosses to another thread, and back by Diagram.from. */
    toObject() { return { fields: { ...this }, intervals: this.#intervals, starts: this.#starts }; }
    static from({ fields, intervals, starts }) { return new Diagram(fields, intervals, starts); }
}

function diagramOf(job) {
    const report = job.report(), starts = [0];
    for (const pairs of report['diagram.pairs']) starts.push(starts.at(-1) + pairs);
    const count = starts.at(-1);
    const [intervals] = job.read('pairs', [BigInt(count)], [Float64Array, 2 * count], null);
    const fields = { filter: filterOf(report['diagram.filter']), certifiedRatio: report['diagram.certified_ratio'] ?? 0,
        certifiedError: report['diagram.certified_error'] ?? 0, fingerprint: report.fingerprint,
        peakBytes: report['memory.peak_bytes'], why: job.text(job.exports.why()), bounds: null,
        representatives: null, translations: null, copies: report['input.copies'] ?? 0,
        moved: report['input.moved'] ?? 0 };
    if (report['diagram.certain']) {
        const [numbers, certain] = job.read('bounds', [BigInt(count)], [Float64Array, 5 * count], [Uint8Array, count]);
        fields.bounds = { numbers, certain };
    }
    if (report['diagram.representatives']) {
        const [begins] = job.read('cycle_starts', [BigInt(count)], [BigUint64Array, count + 1]);
        const axes = report['input.periods'] ?? 0;
        fields.representatives = [];
        fields.translations = axes > 0 ? [] : null;
        for (let k = 0; k + 1 < starts.length; ++k)
            for (let i = starts[k]; i < starts[k + 1]; ++i) {
                const n = begins[i + 1] - begins[i], places = Number(n) * (k + 1);
                fields.representatives.push(job.read('cycle', [BigInt(i), k, n], [Int32Array, places], null)[0]);
                if (axes > 0)
                    fields.translations.push(
                        job.read('cycle_translations', [BigInt(i), k, n, axes], [Int32Array, places * axes])[0]);
            }
    }
    return new Diagram(fields, intervals, starts);
}
const filterOf = name => name === 'none' ? '' : name;

/** Diagrams over a range of k or over the steps of a filtration, and the vines through them: points of vines, sorted by
 * vine and k. Each k's points are that k's diagram. */
export class Vineyard {
    constructor(fields) { Object.assign(this, fields); }
    get length() { return this.vines.length; }
    /** The diagram at one k. */
    diagram(k) {
        whole(k, 'k', ...this.k);
        const at = [...this.ks.keys()].filter(i => this.ks[i] === k), x = this.intervals;
        at.sort((i, j) => this.degrees[i] - this.degrees[j] || x[2 * i] - x[2 * j] || x[2 * i + 1] - x[2 * j + 1] || 0);
        const starts = [0];
        for (let degree = 0; degree <= this.maxDegree; ++degree)
            starts.push(starts[degree] + at.filter(i => this.degrees[i] === degree).length);
        return new Diagram({ filter: this.filter, certifiedRatio: this.ratios[k - this.k[0]], certifiedError: 0,
            fingerprint: '', peakBytes: this.peakBytes, why: '', bounds: null, representatives: null,
            copies: 0, moved: 0 },
        Float64Array.from(at.flatMap(i => [x[2 * i], x[2 * i + 1]])), starts);
    }
    /** The path of one vine: { ks, intervals }. */
    vine(number) {
        whole(number, 'number', 0, Math.max(0, this.count - 1));
        const first = this.vines.indexOf(number), last = this.vines.lastIndexOf(number) + 1;
        return { ks: this.ks.slice(first, last), intervals: this.intervals.slice(2 * first, 2 * last) };
    }
    /** What crosses to another thread, and back by Vineyard.from. */
    toObject() { return { ...this }; }
    static from(fields) { return new Vineyard(fields); }
}

function vineyardOf(job) {
    const report = job.report(), of = name => report[`vineyard.${name}`], count = of('points');
    const [vines, degrees, ks, intervals] = job.read('vines', [BigInt(count)], [Int32Array, count], [Int32Array, count],
        [Int32Array, count], [Float64Array, 2 * count]);
    const k = [of('k_first'), of('k_last')];
    return new Vineyard({ filter: filterOf(of('filter')), k, count: of('vines'), maxDegree: of('max_degree'), vines,
        degrees, ks, intervals,
        ratios: Float64Array.from({ length: k[1] - k[0] + 1 }, (_, i) => job.exports.vine_ratio(k[0] + i)),
        fingerprint: report.fingerprint, peakBytes: report['memory.peak_bytes'] });
}

// With a second coordinate, as the engine's points have two at least.
const planar = read => read.dim > 1 ? read : { ...read, dim: 2,
    array: Float64Array.from({ length: 2 * read.count }, (_, i) => i % 2 ? 0 : read.array[i / 2]) };

const rangeOf = (k = [1, 2]) => k.length === 2 ? { k: k[0], k_last: k[1] } : refuse('k', '[first, last]');

// The request's function of x[dim], where one of these is given: what is missing the engine says.
const OF_FUNCTION = ['function', 'lipschitz', 'cut', 'distanceFactor'];
function putFunction(job, dim, options) {
    if (!OF_FUNCTION.some(name => isGiven(options[name]))) return;
    const { function: f, lipschitz = NaN, cut = NaN, distanceFactor = 0 } = options;
    if (isGiven(f) && typeof f !== 'function') refuse('function', 'not a function');
    job.function = f;
    job.dim = dim;
    job.exports.set_function(isGiven(f) ? 1 : 0, lipschitz, distanceFactor, cut);
}
// The numbers of a focus by their names in the engine.
function focusOf({ focus, fit, longerThan }) {
    if (!isGiven(focus)) return {};
    if (focus === 'auto') return { fit: true, bounds: true, longer_than: longerThan ?? LONGER_THAN };
    const names = fit ? ['focus_from', 'focus_to'] : ['focus_ratio', 'focus_from', 'focus_to'];
    if (!Array.isArray(focus) || focus.length !== names.length)
        refuse('focus', '"auto" for a diagram, [ratio, from, to], or with fit [from, to]');
    return Object.fromEntries(names.map((name, i) => [name, focus[i]]));
}

// Simplices one after the other, to the input: what the engine is told of them.
function putSimplices(job, simplices) {
    if (!Array.isArray(simplices) || !simplices.every(s => typeof s?.length === 'number'))
        refuse('simplices', 'not lists of vertices');
    const starts = new BigUint64Array(simplices.length + 1);
    simplices.forEach((simplex, i) => { starts[i + 1] = starts[i] + BigInt(simplex.length); });
    const vertices = new Uint32Array(Number(starts.at(-1)));
    let at = 0;
    for (const simplex of simplices)
        for (const v of simplex) vertices[at++] = whole(v, 'simplices', 0, 2 ** 32 - 1);
    job.rows = 'simplices';
    return { at: [job.put(vertices), job.put(starts)], counts: [simplices.length, vertices.length] };
}
const numbersOf = (values, argument) => {
    if (values instanceof Float64Array) return values;
    const isList = Array.isArray(values) && values.every(v => typeof v === 'number');
    if (!isList && !(values instanceof Float32Array)) refuse(argument, 'not numbers');
    return Float64Array.from(values);
};

/** A Delaunay triangulation or quality mesh, and the instance that it lives in. */
export class Mesh {
    #job;
    #arrays = {};
    #memory;
    constructor(job, dim, memory) {
        const report = job.report();
        this.#job = job;
        this.#memory = memory;
        this.dim = dim;
        this.vertexCount = report['mesh.vertices'];
        this.inputCount = report['mesh.inputs'];
        this.cellCount = report['mesh.cells'];
        this.isMesh = 'mesh.domain' in report;
        this.aspectRatioMax = report['mesh.aspect_ratio_max'] ?? 0;
    }
    get fingerprint() { return this.#job.report().fingerprint; }
    /** Float64Array [v, D], inputs first. */
    get vertices() { return this.#ofVertices()[0]; }
    /** Uint8Array [v]: 0 an input, 1 a Steiner point, 2 exempt from quality. */
    get markers() { return this.#ofVertices()[1]; }
    /** Int32Array [c, D + 1]. */
    get cells() { return this.#ofCells()[0]; }
    /** Int32Array [c, D + 1]: the cell opposite each vertex, -1 outside. */
    get neighbours() { return this.#ofCells()[1]; }
    /** Float64Array [v] after persist on a mesh: of each vertex, a radius. */
    get values() {
        const made = this.isMesh && 'diagram.pairs' in this.#job.report(), v = this.vertexCount;
        return made ? this.#job.read('vertices', [this.dim, BigInt(v)], null, null, [Float64Array, v])[2] : null;
    }
    get domain() {
        const domain = this.#job.report()['mesh.domain'];
        return domain ? { centre: Float64Array.from(domain.slice(0, this.dim)), radius: domain[this.dim] } : null;
    }
    #ofVertices() {
        const v = this.vertexCount;
        return this.#arrays.vertices ??= this.#job.read('vertices', [this.dim, BigInt(v)], [Float64Array, v * this.dim],
            [Uint8Array, v], null);
    }
    #ofCells() {
        const c = this.cellCount, array = [Int32Array, c * (this.dim + 1)];
        return this.#arrays.cells ??= this.#job.read('cells', [this.dim, BigInt(c)], array, array);
    }
    /** The diagram of a filter on this mesh ("complete", "basic", "knn", "kdistance", "tight") or triangulation. */
    persist(options = {}) {
        this.#job.ask({ filter: this.isMesh ? 'complete' : 'alpha',
            ...known('meshPersist', options, this.#job.table) });
        putFunction(this.#job, this.dim, options);
        this.#job.persist(this.#memory);
        return diagramOf(this.#job);
    }
    /** The diagrams of "knn" or "kdistance" for k from options.k[0] to options.k[1] on this mesh, and the vines through
     * them. */
    vineyard(options = {}) {
        const given = known('meshVineyard', options, this.#job.table);
        this.#job.ask({ filter: 'knn', ...given, ...rangeOf(given.k), vines: true });
        this.#job.persist(this.#memory);
        return vineyardOf(this.#job);
    }
    /** Checks the mesh anew, exactly, by code that shares nothing with what made it; throws "check-failed". */
    check() { this.#job.go('check'); }
}

// What the calls take beside members of the engine's request, and which of these they do not take.
const TAKEN = {
    persist: ['dim', 'focus', 'radii', 'weights', 'lattice', ...OF_FUNCTION], meshPersist: OF_FUNCTION, homology: [],
    vineyard: ['dim', 'simplices', 'steps', 'byVertex'], meshVineyard: [], mesh: ['dim', 'purpose', 'focus'],
    delaunay: ['dim', 'purpose', 'seed'], rips: ['dim', 'distances'],
    bottleneck: ['degree', 'log'], wasserstein: ['degree', 'order', 'error'],
};
const OF_VINES = ['k_last', 'vines'], OF_POINTS = ['weighting', 'squares', 'periods'];
const NOT_TAKEN = { persist: ['weighting', 'periods'], meshPersist: OF_POINTS, vineyard: [...OF_VINES, ...OF_POINTS],
    meshVineyard: [...OF_VINES, ...OF_POINTS], rips: ['filter', ...OF_POINTS],
    homology: ['filter', 'vines', ...OF_POINTS],
    mesh: ['k', ...OF_VINES, ...OF_POINTS, 'max_degree', 'keep_zero_pairs', 'bounds', 'cycles', 'fit', 'keep_mesh'] };
const RUN = ['memory', 'progress'], NO_REQUEST = ['delaunay', 'bottleneck', 'wasserstein'];
// What is given of a call's options.
function known(call, options, table) {
    const isOfRequest = name => !NO_REQUEST.includes(call) && name in table && !NOT_TAKEN[call]?.includes(name);
    for (const name of Object.keys(options))
        if (!TAKEN[call].includes(name) && !RUN.includes(name) && !isOfRequest(inEngine(name)))
            refuse(name, `not an option of ${call}`);
    if (options.progress !== undefined && typeof options.progress !== 'function') refuse('progress', 'not a function');
    if (options.memory !== undefined) whole(options.memory, 'memory', 1, 2 ** 32);
    return Object.fromEntries(Object.entries(options).filter(([, value]) => isGiven(value)));
}

// The engine's table of options: { name: { name, field, offset, put(view, value, argument) } }.
function tableOf(job) {
    const table = {}, request = job.exports.fresh(0);
    job.rowsOf('option').forEach(([, type, field, offset, name, rangeAt, , , object], i) => {
        const words = new Map(job.rowsOf('option_word', i).map(([, value, word, of]) => [job.text(word), of || value]));
        const range = job.text(rangeAt), by = new DataView(job.memory.buffer, request + offset);
        const isOpenAt0 = type === 2 ? by.getUint32(0) === 0 : type === 4 && by.getFloat64(0, true) === 0;
        const put = (view, value, argument) => {
            // 0 would say that nothing is asked for.
            if (value === 0 && isOpenAt0 && !range.startsWith('0')) refuse(argument, `must be ${range}`);
            if (type === 3) return view.setBigUint64(0, BigInt(whole(value, argument, 0, 2 ** 53)), true);
            if (type === 4 && typeof value !== 'number') refuse(argument, 'not a number');
            if (type === 4) return view.setFloat64(0, value, true);
            view.setUint32(0, type === 1 ? (value ? object || 1 : 0)
                : type === 2 ? whole(value, argument, 0, 2 ** 32 - 2)
                : [value].flat().reduce((all, word) => all | choose(words, word, argument), 0), true);
        };
        table[job.text(name)] = { name: job.text(name), field, offset, put };
    });
    return table;
}

/** The library in this thread. */
export class Netmesh {
    #library;
    #onMeshes = new Set();
    constructor(module) {
        const job = new Job({ module });
        this.#library = { module, table: tableOf(job) };
        this.version = job.text(job.exports.netmesh_version_text());
        this.filters = [];
        for (const [, , , isOnMesh, , , , name] of job.rowsOf('filter')) {
            this.filters.push(job.text(name));
            if (isOnMesh) this.#onMeshes.add(job.text(name));
        }
    }
    #job(points, options) {
        const job = new Job(this.#library, options.progress), balls = ballsOf(options, points.count);
        const lattice = latticeOf(options, points.dim);
        const array = balls ? Float64Array.from(points.array) : points.array;
        const at = job.put(array), isFloat = array instanceof Float32Array ? 1 : 0;
        const weights = balls ? job.put(balls.numbers) : 0, vectors = lattice ? job.put(lattice.numbers) : 0;
        job.askOfPoints = (asked, names = {}) => {
            const { argument } = balls ?? {};
            job.ask({ ...asked, ...balls && { weighting: argument }, ...lattice && { periods: true } },
                { ...names, ...balls && { weights: argument, weighting: argument },
                    ...lattice && { lattice_count: 'lattice', periods: 'lattice' } });
            job.exports.set_points(at, points.count, points.dim, isFloat);
            if (balls) job.exports.set_weights(weights);
            if (lattice) job.exports.set_lattice(vectors, lattice.count);
        };
        return job;
    }

    persist(points, options = {}) {
        const given = known('persist', options, this.#library.table);
        if ('k' in given && (given.filter ?? 'auto') === 'auto')
            refuse('k', "of the distance to the k-th nearest point: filter: 'knn' or 'kdistance'");
        // An alpha complex is intrinsic, and flat points have none in more dimensions than they need.
        const read = pointsOf(points, given.dim), { filter = 'auto', lattice } = given;
        const isIntrinsic = ['auto', 'alpha'].includes(filter) && !isGiven(lattice);
        return this.#persist(isIntrinsic ? withoutConstant(read) : read, { ...given, ...focusOf(given) });
    }
    #persist(read, given) {
        const job = this.#job(read, given), { filter = 'auto' } = given;
        const ask = filter => {
            job.askOfPoints({ ...given, filter });
            putFunction(job, read.dim, given);
        };
        ask(filter);
        // What "auto" does not read is of a mesh.
        if (filter === 'auto' && ('values' in given || job.exports.settle() !== 0)) ask('complete');
        if (given.fit && given.memory === undefined)
            refuse(given.focus === 'auto' ? 'focus' : 'fit', 'needs memory, the size to fit in');
        job.run('persist', job.exports.plan(), given.memory);
        return given.vines ? vineyardOf(job) : diagramOf(job);
    }
    mesh(points, options = {}) {
        const given = known('mesh', options, this.#library.table), { purpose, eps } = given;
        const read = pointsOf(points, given.dim), job = this.#job(read, given);
        const asked = { method: 'ratio' in given ? 'certificate' : 'svr', ...given, ...focusOf(given) };
        if (purpose !== undefined) asked.filter = choose(PURPOSES, purpose, 'purpose');
        const ofSizes = eps !== undefined && asked.filter !== 'tight';
        if (ofSizes) Object.assign(asked, { eps: null, size_eps: eps });
        job.askOfPoints(asked, ofSizes ? { size_eps: 'eps' } : {});
        return this.#made(job, read.dim, given);
    }
    delaunay(points, options = {}) {
        const given = known('delaunay', options), { seed, purpose = 'persist' } = given;
        const read = pointsOf(points, given.dim), job = this.#job(read, given);
        const filter = choose(new Map([['persist', 'alpha'], ['mesh', null]]), purpose, 'purpose');
        job.askOfPoints({ seed, filter, method: 'delaunay' });
        return this.#made(job, read.dim, given);
    }
    #made(job, dim, { memory }) {
        job.run('mesh', 1.5 * job.exports.plan_mesh(), memory);
        return new Mesh(job, dim, memory);
    }
    /** The diagram of any filtered complex: lists of vertices, and when each simplex enters. */
    homology(simplices, values, options = {}) {
        const given = known('homology', options, this.#library.table);
        return diagramOf(this.#complex(simplices, [values], 'values', given));
    }
    #complex(simplices, rows, argument, given) {
        const job = new Job(this.#library, given.progress), { at, counts } = putSimplices(job, simplices);
        const due = given.byVertex ? simplices.filter(s => s.length === 1).length : simplices.length;
        const entries = new Float64Array(rows.length * due);
        rows.forEach((row, i) => {
            const numbers = numbersOf(row, argument);
            if (numbers.length !== due) refuse(argument, `row ${i} has ${numbers.length} numbers, ${due} are due`);
            entries.set(numbers, i * due);
        });
        job.rows = argument;
        job.ask({ ...given, filter: 'simplices' });
        job.exports.set_simplices(...at, job.put(entries), ...counts, given.vines ? rows.length : 0,
            given.byVertex ? 1 : 0);
        job.run('persist', job.exports.plan(), given.memory);
        return job;
    }
    /** The diagrams of a filter for every k of a range, or of a complex (`simplices`) at every step of its values, and
     * the vines through them. */
    vineyard(points, options = {}) {
        const given = known('vineyard', options, this.#library.table), { simplices, steps } = given;
        if ((points == null) === (simplices === undefined)) refuse('points', 'give points or simplices');
        if (points == null) {
            if (!Array.isArray(steps) || steps.length === 0) refuse('steps', 'rows of numbers, one a step');
            return vineyardOf(this.#complex(simplices, steps, 'steps', { ...given, vines: true }));
        }
        const asked = { filter: 'knn', ...given, ...rangeOf(given.k), vines: true };
        if (this.#onMeshes.has(asked.filter) && !('ratio' in asked)) asked.method ??= 'svr';
        return this.#persist(pointsOf(points, given.dim), asked);
    }
    rips(points, options = {}) {
        const given = { ...known('rips', options, this.#library.table), filter: 'rips' }, { distances } = given;
        if ((points == null) === (distances === undefined)) refuse('points', 'give points or distances');
        if (distances === undefined) {
            const read = pointsOf(points, given.dim);
            if (looksLikeDistances(read))
                refuse('points', 'a square with 0 on its diagonal and equal halves looks like distances: '
                    + "rips(null, { distances }); persist(points, { filter: 'rips' }) takes it for points");
            return this.#persist(planar(read), given);
        }
        const array = numbersOf(Array.isArray(distances) ? distances.flat() : distances, 'distances');
        const count = Math.round(Math.sqrt(array.length));
        if (count * count !== array.length) refuse('distances', `${array.length} numbers are no [n, n]`);
        const job = new Job(this.#library, given.progress);
        job.ask(given);
        job.exports.set_distances(job.put(array), count);
        job.run('persist', job.exports.plan(), given.memory);
        return diagramOf(job);
    }

    /** The bottleneck distance of two diagrams, or of bars Float64Array [m, 2]. */
    bottleneck(a, b, options = {}) {
        known('bottleneck', options);
        const [value, exponent] = this.#compare('bottleneck', a, b, options.degree, options.log ? 1 : 0);
        return options.log && Number.isFinite(value) ? Math.log(value) + exponent * Math.LN2 : value;
    }
    /** The Wasserstein distance, between `lower` and `value`, which is proven; `value` is at most 1 + `error` times
     *  `lower`. Bounds that stay farther apart are an error with status "internal", as that is a defect. */
    wasserstein(a, b, options = {}) {
        known('wasserstein', options);
        const { degree, order = 1, error = 0.001 } = options;
        if (typeof error !== 'number') refuse('error', 'not a number');
        const [value, lower] = this.#compare('wasserstein', a, b, degree, whole(order, 'order', 0, 2 ** 32 - 1), error);
        return { value, lower };
    }
    #compare(name, a, b, degree, ...how) {
        const pairs = [barsOf(a, 'a'), barsOf(b, 'b')], job = new Job(this.#library);
        const bytes = new Uint8Array(PAIR_BYTES * (pairs[0].length + pairs[1].length));
        const view = new DataView(bytes.buffer);
        pairs.flat().forEach((bar, i) => {
            view.setUint32(PAIR_BYTES * i, PAIR_BYTES, true);
            view.setUint32(PAIR_BYTES * i + 4, bar.degree, true);
            view.setFloat64(PAIR_BYTES * i + 8, bar.birth, true);
            view.setFloat64(PAIR_BYTES * i + 16, bar.death, true);
        });
        const which = degree === undefined ? 2 ** 32 - 1 : whole(degree, 'degree', 0, 2 ** 32 - 2);
        const plan = job.exports[`plan_${name}`](job.put(bytes), pairs[0].length, pairs[1].length, which, ...how);
        job.run(name, Math.max(1, plan));
        return new Float64Array(job.memory.buffer, job.exports.results(), 2).slice();
    }
}

function barsOf(diagram, argument) {
    const bars = diagram instanceof Diagram ? [...diagram] : [];
    if (diagram instanceof Float64Array) {
        if (diagram.length % 2 !== 0) refuse(argument, 'not bars [m, 2]');
        for (let i = 0; i < diagram.length; i += 2) bars.push({ degree: 0, birth: diagram[i], death: diagram[i + 1] });
    } else if (!(diagram instanceof Diagram)) {
        refuse(argument, 'neither a Diagram nor a Float64Array [m, 2]');
    }
    const row = bars.findIndex(({ birth, death }) => !Number.isFinite(birth) || !(death >= birth));
    if (row < 0) return bars;
    throw new NetmeshError('invalid-argument', `${argument}, row ${row}: a birth is not finite, or a death before it`,
        argument, row);
}

/** Loads the library into this thread. */
export async function load(source) { return new Netmesh(await compiled(source)); }

/** Loads the library into a worker: the same calls, as promises, while this thread goes on. */
export async function loadWorker(source) {
    const module = await compiled(source);
    const url = new URL('./worker.mjs', import.meta.url);
    const inNode = Boolean(globalThis.process?.versions?.node);
    const worker = inNode ? new (await import('node:worker_threads')).Worker(url) : new Worker(url, { type: 'module' });
    const waiting = new Map();
    let number = 0;
    const fail = error => {
        for (const { reject } of waiting.values()) reject(error);
        waiting.clear();
    };
    const take = ({ id, result, error, progress }) => {
        const call = waiting.get(id);
        if (progress) return void call?.progress?.(progress);
        waiting.delete(id);
        if (inNode && waiting.size === 0) worker.unref();
        if (!call) return;
        if (error) call.reject(error.status ? new NetmeshError(error.status, error.message, error.argument, error.row)
            : new Error(error.message));
        else call.resolve(result?.vines ? Vineyard.from(result) : result?.intervals ? Diagram.from(result) : result);
    };
    if (inNode) {
        worker.on('message', take);
        worker.on('error', fail);
    } else {
        worker.onmessage = event => take(event.data);
        worker.onerror = event => fail(new Error(event.message));
    }
    const call = (name, values, options) => new Promise((resolve, reject) => {
        const id = ++number, { progress, ...rest } = options;
        if (typeof rest.function === 'function')
            refuse('function', 'functions do not cross to a worker: call load() in it');
        waiting.set(id, { resolve, reject, progress });
        if (inNode) worker.ref();
        const sent = values.map(value => value instanceof Diagram ? value.toObject() : value);
        worker.postMessage({ id, name, values: [...sent, rest], watched: Boolean(progress), module });
    });
    const arities = { persist: 1, rips: 1, homology: 2, vineyard: 1, mesh: 1, delaunay: 1, bottleneck: 2,
        wasserstein: 2 };
    return {
        ...Object.fromEntries(Object.entries(arities).map(([name, count]) => [name,
            (...values) => call(name, values.slice(0, count), values[count] ?? {})])),
        /** Stops what is on its way: it is rejected as "cancelled", and the worker is gone. */
        terminate: () => {
            fail(new NetmeshError('cancelled', 'the worker was stopped'));
            return worker.terminate();
        },
    };
}
