// netmesh for JavaScript: typed arrays in, typed arrays out. Each call runs in an instance of its own, whose memory
// goes with it; a mesh keeps its instance. No dependency.

const OPTIONS = ['dim', 'points', 'format', 'filter', 'values', 'k', 'kLast', 'maxDegree', 'ratio', 'focus', 'from',
    'to', 'tau', 'method', 'finish', 'eps', 'theta', 'seed', 'keepZeroPairs', 'bounds', 'representatives', 'wholeCells',
    'purpose', 'threshold', 'layout', 'degree', 'isLog', 'order', 'error', 'countA', 'countB', 'watched', 'longerThan',
    'byError', 'lipschitz', 'distanceFactor', 'cut', 'verticesAt', 'startsAt', 'entriesAt', 'simplices', 'vertexCount',
    'stepCount', 'byVertex'];
const FACTS = ['source', 'purpose', 'hasEps', 'hasTheta', 'hasGoal', 'hasRepresentatives', 'needsK', 'needsFunction',
    'clipsCells', 'hasValues', 'hasVineyard'];
const STAGES = ['none', 'sort', 'delaunay', 'refine', 'certify', 'filter', 'gradient', 'reduce', 'check', 'analyse'];
const STATUSES = ['ok', 'invalid-argument', 'out-of-memory', 'cancelled', 'not-finite', 'out-of-range', 'flat',
    'too-close', 'no-result', 'check-failed', 'floating-point', 'internal', 'not-a-complex', 'not-built'];
const METHODS = { svr: 0, netmesh: 1, refine: 2 };
const PURPOSES = { mesh: 0, persist: 1, tight: 2 };
const VALUES = { certified: 0, thesis: 1 };
const SOURCE = { mesh: 1, delaunay: 2, scales: 3, points: 4 };
const ARGUMENTS = { dim: 'points', point_count: 'points', max_degree: 'maxDegree', focus_ratio: 'focus',
    focus_from: 'focus', focus_to: 'focus', tight_eps: 'eps', numbers: 'distances', pairs_a: 'a', pairs_b: 'b',
    relative_error: 'error', longer_than: 'longerThan', distance_factor: 'distanceFactor', k_first: 'k', k_last: 'k',
    whole_cells: 'wholeCells', simplex_count: 'simplices', vertices: 'simplices', starts: 'simplices',
    entries: 'values', step_count: 'steps' };
const OF_ROWS = ['not-finite', 'out-of-range', 'too-close', 'not-a-complex'];
const FAULTS = ['', 'no vertices, or more than 32', 'more simplices of its dimension than can be numbered',
    'a vertex twice', 'is there already', 'a face is not there', 'a face enters later'];
const FIT_RATIO = 4, LONGER_THAN = 1.5;
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
const choose = (table, value, argument) => Object.hasOwn(table, value) ? table[value]
    : refuse(argument, `${value} is none of ${Object.keys(table).join(', ')}`);
const positive = (value, argument) => typeof value === 'number' && value > 0 && Number.isFinite(value) ? value
    : refuse(argument, 'must be a finite number above 0');
const finite = (value, argument) => typeof value === 'number' && Number.isFinite(value) ? value
    : refuse(argument, 'must be a finite number');
const whole = (value, argument, least, most) => Number.isInteger(value) && value >= least && value <= most ? value
    : refuse(argument, `must be a whole number from ${least} to ${most}`);

/** Bytes of the module: from a URL, a Response,
    bytes or a compiled module; by default netmesh.wasm beside this file. */
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
    constructor(module, progress) {
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
        this.set({ seed: 1, watched: progress ? 1 : 0, maxDegree: 6, k: 1, threshold: Infinity });
    }
    set(options) {
        const at = new Float64Array(this.memory.buffer, this.exports.options(), OPTIONS.length);
        for (const [name, value] of Object.entries(options)) at[OPTIONS.indexOf(name)] = Number(value);
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
            const isSmall = STATUSES[status] === 'out-of-memory' || (name === 'auto' && made && this.exports.gave_up());
            if (this.failure || !isSmall || memory !== undefined || bytes >= limit) return this.done(status);
            bytes = Math.min(limit, 2 * bytes);
        }
    }
    // A diagram on a mesh may need more memory than the plan had: the mesh is made again in twice as much.
    persist(memory, call = 'persist') {
        const name = this.exports.is_mesh() ? 'mesh' : 'delaunay';
        for (;;) {
            try {
                this.go(call);
                return;
            } catch (error) {
                if (error.status !== 'out-of-memory' || memory !== undefined) throw error;
                this.run(name, 2 * (this.end - this.inputEnd));
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
        let said = this.text(this.exports.message()) || this.text(this.exports.status_text(status));
        const field = this.text(this.exports.field());
        const ofRow = OF_ROWS.includes(kind) || (kind === 'invalid-argument' && field === 'numbers');
        const argument = ofRow && field !== 'numbers' ? (kind === 'not-a-complex' ? 'simplices' : this.rows)
            : kind === 'out-of-memory' ? 'memory' : kind === 'flat' ? 'points'
            : field ? ARGUMENTS[field] ?? field : null;
        const row = ofRow ? this.exports.row() : null;
        if (kind === 'not-a-complex') said = `${FAULTS[this.exports.fault()]}${this.ofStep()}`;
        if (argument === 'steps') said += this.ofStep();
        const place = argument === null ? '' : row === null ? `${argument}: ` : `${argument}, row ${row}: `;
        throw new NetmeshError(kind, place + said, argument, row);
    }
    ofStep() { return this.exports.step() > 0 ? `, at step ${this.exports.step()}` : ''; }
    // Arrays that an export writes behind the block: read([Float64Array, 6], [Uint8Array, 3]), null for none.
    read(name, first, ...wanted) {
        let at = Math.ceil(this.end / 16) * 16;
        const places = wanted.map(want => {
            if (want === null) return 0;
            const here = at;
            at = Math.ceil((at + want[0].BYTES_PER_ELEMENT * want[1]) / 16) * 16;
            return here;
        });
        if (!this.grow(at)) this.outOfMemory();
        this.done(this.exports[name](...first, ...places));
        return wanted.map((want, i) => want && new want[0](this.memory.buffer, places[i], want[1]).slice());
    }
    fingerprint() {
        const half = name => (this.exports[name]() >>> 0).toString(16).padStart(8, '0');
        return half('fingerprint_high') + half('fingerprint_low');
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

function diagramOf(job, filter, options) {
    const starts = [0];
    for (let k = 0; k < job.exports.degrees(); ++k) starts.push(starts[k] + job.exports.pairs(k));
    const count = starts.at(-1);
    const [intervals] = job.read('read_pairs', [count], [Float64Array, 2 * count]);
    const fields = { filter, certifiedRatio: job.exports.certified_ratio(),
        certifiedError: job.exports.certified_error(), fingerprint: job.fingerprint(),
        peakBytes: job.exports.peak_bytes(),
        why: job.text(job.exports.why()), bounds: null, representatives: null };
    if (options.bounds) {
        const [numbers, certain] = job.read('read_bounds', [count], [Float64Array, 5 * count], [Uint8Array, count]);
        fields.bounds = { numbers, certain };
    }
    if (options.representatives) {
        const [begins] = job.read('read_cycle_starts', [count], [BigUint64Array, count + 1]);
        fields.representatives = [];
        for (let k = 0; k + 1 < starts.length; ++k)
            for (let i = starts[k]; i < starts[k + 1]; ++i) {
                const n = Number(begins[i + 1] - begins[i]);
                fields.representatives.push(job.read('read_cycle', [i, k, n], [Int32Array, n * (k + 1)])[0]);
            }
    }
    return new Diagram(fields, intervals, starts);
}

/** Diagrams over a range of k or over the steps of a filtration, and the vines through them: points of vines, sorted by
 * vine and k. Each k's points are that k's diagram. */
export class Vineyard {
    constructor(fields) { Object.assign(this, fields); }
    get length() { return this.vines.length; }
    /** The diagram at one k. */
    diagram(k) {
        whole(k, 'k', ...this.k);
        const at = [...this.ks.keys()].filter(i => this.ks[i] === k), x = this.intervals;
        at.sort((i, j) => this.degrees[i] - this.degrees[j] || x[2 * i] - x[2 * j] || x[2 * i + 1] - x[2 * j + 1]
            || 0);
        const starts = [0];
        for (let degree = 0; degree <= this.maxDegree; ++degree)
            starts.push(starts[degree] + at.filter(i => this.degrees[i] === degree).length);
        return new Diagram({ filter: this.filter, certifiedRatio: this.ratios[k - this.k[0]],
            certifiedError: 0, fingerprint: '', peakBytes: this.peakBytes, why: '',
            bounds: null, representatives: null },
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

function vineyardOf(job, filter) {
    const count = job.exports.vine_points(), fact = job.exports.vine_fact;
    const [vines, degrees, ks, intervals] = job.read('read_vines', [count], [Int32Array, count], [Int32Array, count],
        [Int32Array, count], [Float64Array, 2 * count]);
    const k = [fact(0), fact(1)];
    return new Vineyard({ filter, k, count: job.exports.vines(), maxDegree: fact(2), vines, degrees, ks, intervals,
        ratios: Float64Array.from({ length: k[1] - k[0] + 1 }, (_, i) => job.exports.vine_ratio(k[0] + i)),
        fingerprint: job.fingerprint(), peakBytes: job.exports.peak_bytes() });
}

// With a second coordinate, as the engine's points have two at least.
const planar = read => read.dim > 1 ? read : { ...read, dim: 2,
    array: Float64Array.from({ length: 2 * read.count }, (_, i) => i % 2 ? 0 : read.array[i / 2]) };

const rangeOf = k => {
    if (!Array.isArray(k) || k.length !== 2) refuse('k', '[first, last]');
    return { k: whole(k[0], 'k', 1, 2 ** 28), kLast: whole(k[1], 'k', k[0], 2 ** 28) };
};

// A function of the caller's and what is known of it; sets it in the job.
function setFunction(job, dim, options) {
    if (typeof options.function !== 'function') refuse('function', 'the filter function needs one');
    job.function = options.function;
    job.dim = dim;
    job.set({ lipschitz: finite(options.lipschitz, 'lipschitz'), cut: finite(options.cut, 'cut'),
        distanceFactor: options.distanceFactor === undefined ? 0
            : positive(options.distanceFactor, 'distanceFactor') });
}

// Simplices one after the other, to the input; how many have one vertex.
function putSimplices(job, simplices) {
    if (!Array.isArray(simplices) || !simplices.every(s => typeof s?.length === 'number'))
        refuse('simplices', 'not lists of vertices');
    const starts = new BigUint64Array(simplices.length + 1);
    simplices.forEach((simplex, i) => { starts[i + 1] = starts[i] + BigInt(simplex.length); });
    const vertices = new Uint32Array(Number(starts.at(-1)));
    let at = 0;
    for (const simplex of simplices)
        for (const v of simplex) vertices[at++] = whole(v, 'simplices', 0, 2 ** 32 - 1);
    job.set({ verticesAt: job.put(vertices), startsAt: job.put(starts), simplices: simplices.length,
        vertexCount: vertices.length });
    job.rows = 'simplices';
    return simplices.filter(s => s.length === 1).length;
}
const numbersOf = (values, argument) => {
    if (values instanceof Float64Array) return values;
    if (!Array.isArray(values) || !values.every(v => typeof v === 'number')) refuse(argument, 'not numbers');
    return Float64Array.from(values);
};
const complexDegree = options => options.maxDegree === undefined ? 31 : whole(options.maxDegree, 'maxDegree', 0, 31);

/** A Delaunay triangulation or quality mesh, and the instance that it lives in. */
export class Mesh {
    #job;
    #filters;
    #arrays = {};
    #memory;
    constructor(job, dim, filters, memory) {
        this.#job = job;
        this.#memory = memory;
        this.#filters = filters;
        this.dim = dim;
        this.vertexCount = job.exports.vertices();
        this.inputCount = job.exports.inputs();
        this.cellCount = job.exports.cells();
        this.isMesh = job.exports.is_mesh() !== 0;
        this.aspectRatioMax = job.exports.aspect_ratio();
    }
    get fingerprint() { return this.#job.fingerprint(); }
    /** Float64Array [v, D], inputs first. */
    get vertices() { return this.#array('vertices'); }
    /** Uint8Array [v]: 0 an input, 1 a Steiner point, 2 exempt from quality. */
    get markers() { return this.#array('markers'); }
    /** Int32Array [c, D + 1]. */
    get cells() { return this.#array('cells'); }
    /** Int32Array [c, D + 1]: the cell opposite each vertex, -1 outside. */
    get neighbours() { return this.#array('neighbours'); }
    /** Float64Array [v] after persist on a mesh: of each vertex, a radius. */
    get values() {
        return this.isMesh && this.#job.exports.degrees() > 0
            ? this.#job.read('read_vertices', [this.vertexCount], null, null, [Float64Array, this.vertexCount])[2]
                : null;
    }
    get domain() {
        const at = i => this.#job.exports.domain(i);
        return this.isMesh ? { centre: Float64Array.from({ length: this.dim }, (_, i) => at(i)),
            radius: at(this.dim) } : null;
    }
    #array(name) {
        if (!(name in this.#arrays)) {
            const v = this.vertexCount, c = this.cellCount * (this.dim + 1);
            if (name === 'vertices' || name === 'markers')
                [this.#arrays.vertices, this.#arrays.markers] = this.#job.read('read_vertices', [v],
                    [Float64Array, v * this.dim], [Uint8Array, v], null);
            else
                [this.#arrays.cells, this.#arrays.neighbours] = this.#job.read('read_cells', [this.cellCount],
                    [Int32Array, c], [Int32Array, c]);
        }
        return this.#arrays[name];
    }
    /** The diagram of a filter on this mesh ("complete", "basic", "knn", "kdistance", "tight") or triangulation. */
    persist(options = {}) {
        const name = options.filter ?? (this.isMesh ? 'complete' : 'alpha');
        const filter = choose(this.#filters, name, 'filter');
        if (filter.needsFunction) setFunction(this.#job, this.dim, options);
        this.#job.set({ filter: filter.number, values: choose(VALUES, options.values ?? 'certified', 'values'),
            k: whole(options.k ?? 1, 'k', 1, 2 ** 28), maxDegree: whole(options.maxDegree ?? this.dim - 1,
                'maxDegree', 0, 30),
            keepZeroPairs: options.keepZeroPairs ?? 0, bounds: options.bounds ?? 0,
            representatives: options.representatives ?? 0 });
        this.#job.persist(this.#memory);
        return diagramOf(this.#job, name, options);
    }
    /** The diagrams of "knn" or "kdistance" for k from options.k[0] to options.k[1] on this mesh, and the vines through
     * them. */
    vineyard(options = {}) {
        known('meshVineyard', options);
        const name = options.filter ?? 'knn', filter = choose(this.#filters, name, 'filter');
        if (!filter.hasVineyard || filter.source !== SOURCE.mesh) refuse('filter', `${name} has no vineyard on a mesh`);
        this.#job.set({ filter: filter.number, values: choose(VALUES, options.values ?? 'certified', 'values'),
            maxDegree: whole(options.maxDegree ?? this.dim - 1, 'maxDegree', 0, 30), ...rangeOf(options.k ?? [1, 2]) });
        this.#job.persist(this.#memory, 'vineyard');
        return vineyardOf(this.#job, name);
    }
    /** Checks the mesh anew, exactly, by code that shares nothing with what made it; throws "check-failed". */
    check() { this.#job.go('check'); }
}

const KNOWN = {
    persist: ['filter', 'dim', 'maxDegree', 'k', 'ratio', 'focus', 'eps', 'theta', 'values', 'tau', 'method', 'finish',
        'wholeCells', 'keepZeroPairs', 'bounds', 'representatives', 'seed', 'memory', 'progress', 'function',
        'lipschitz', 'cut', 'error', 'distanceFactor', 'fit', 'longerThan'],
    homology: ['maxDegree', 'keepZeroPairs', 'representatives', 'memory', 'progress'],
    vineyard: ['dim', 'k', 'filter', 'maxDegree', 'values', 'tau', 'seed', 'simplices', 'steps', 'byVertex', 'memory',
        'progress'],
    meshVineyard: ['k', 'filter', 'maxDegree', 'values'],
    mesh: ['dim', 'tau', 'method', 'purpose', 'eps', 'ratio', 'focus', 'wholeCells', 'finish', 'seed', 'memory',
        'progress'],
    delaunay: ['dim', 'purpose', 'seed', 'memory', 'progress'],
    rips: ['dim', 'distances', 'threshold', 'maxDegree', 'keepZeroPairs', 'representatives', 'memory', 'progress'],
    bottleneck: ['degree', 'log'], wasserstein: ['degree', 'order', 'error'],
};
function known(call, options) {
    for (const name of Object.keys(options))
        if (!KNOWN[call].includes(name)) refuse(name, `not an option of ${call}`);
    if (options.progress !== undefined && typeof options.progress !== 'function') refuse('progress', 'not a function');
    if (options.memory !== undefined) whole(options.memory, 'memory', 1, 2 ** 32);
}

// What goes with either filter of "auto"; everything else asks for a mesh.
const OF_EITHER = ['filter', 'dim', 'maxDegree', 'keepZeroPairs', 'bounds', 'representatives', 'seed', 'memory',
    'progress'];

/** The library in this thread. */
export class Netmesh {
    #module;
    #filters = {};
    constructor(module) {
        this.#module = module;
        const job = new Job(module);
        if (job.exports.options_count() !== OPTIONS.length) throw new Error('netmesh.wasm is of another version');
        this.version = job.text(job.exports.version());
        for (let i = 0; job.exports.filter_name(i) !== 0; ++i) {
            const filter = { number: job.exports.filter_number(i) };
            FACTS.forEach((fact, which) => { filter[fact] = job.exports.filter_fact(i, which); });
            this.#filters[job.text(job.exports.filter_name(i))] = filter;
        }
    }
    get filters() { return Object.keys(this.#filters); }

    #job(points, options) {
        const job = new Job(this.#module, options.progress);
        job.put(points.array);
        job.set({ dim: points.dim, points: points.count, format: points.array instanceof Float32Array,
            seed: whole(options.seed ?? 1, 'seed', 0, 2 ** 53) });
        return job;
    }

    persist(points, options = {}) {
        known('persist', options);
        const read = pointsOf(points, options.dim);
        if ((options.filter ?? 'auto') !== 'auto') return this.#persist(read, options, options.filter);
        const isGiven = name => options[name] !== undefined && options[name] !== false;
        if (Object.keys(options).every(name => OF_EITHER.includes(name) || !isGiven(name)))
            return this.#chosen(read, options);
        return this.#persist(read, options, 'complete');
    }
    // By the filter that the engine chooses.
    #chosen(read, options) {
        const job = this.#job(read, options);
        job.set({ maxDegree: whole(options.maxDegree ?? read.dim - 1, 'maxDegree', 0, 30),
            keepZeroPairs: options.keepZeroPairs ?? 0, bounds: options.bounds ?? 0,
            representatives: options.representatives ?? 0 });
        job.run('auto', job.exports.plan_auto(), options.memory);
        const taken = job.exports.filter_taken();
        return diagramOf(job, this.filters.find(name => this.#filters[name].number === taken), options);
    }
    #persist(read, options, name) {
        const filter = choose(this.#filters, name, 'filter');
        const onMesh = filter.source === SOURCE.mesh, byScales = filter.source === SOURCE.scales;
        const reads = { k: filter.needsK, eps: filter.hasEps, theta: filter.hasTheta, values: filter.hasValues,
            ratio: onMesh || byScales, tau: onMesh || byScales, method: onMesh, finish: onMesh, focus: onMesh,
            wholeCells: onMesh, representatives: filter.hasRepresentatives, fit: onMesh, longerThan: onMesh,
            function: filter.needsFunction, lipschitz: filter.needsFunction, cut: filter.needsFunction,
            error: filter.needsFunction, distanceFactor: filter.needsFunction };
        for (const [option, isRead] of Object.entries(reads))
            if (!isRead && options[option] !== undefined && options[option] !== false) refuse(option,
                `not for the filter ${name}`);
        const job = this.#job(read, options);
        const onPoints = filter.source === SOURCE.points;
        const byError = filter.needsFunction && (options.error !== undefined || Boolean(options.fit));
        const values = choose(VALUES, options.values ?? (byError ? 'thesis' : 'certified'), 'values');
        const given = Object.fromEntries(['ratio', 'tau', 'eps', 'theta', 'error'].filter(o => options[o] !== undefined)
            .map(o => [o, positive(options[o], o)]));
        job.set({ filter: filter.number, values, k: whole(options.k ?? 1, 'k', 0, 2 ** 28),
            maxDegree: whole(options.maxDegree ?? (onPoints ? 1 : read.dim - 1), 'maxDegree', 0, 30),
            keepZeroPairs: options.keepZeroPairs ?? 0, bounds: options.bounds ?? 0,
            representatives: options.representatives ?? 0, threshold: options.threshold ?? Infinity, ...given });
        if (filter.needsFunction) setFunction(job, read.dim, options);
        const fits = onMesh || byScales ? this.#settle(job, filter, options, given, values, read.dim) : false;
        if (fits) {
            job.run('fit', 0, options.memory);
        } else if (onMesh) {
            job.run('mesh', job.exports.plan_mesh(), options.memory);
            job.persist(options.memory);
        } else if (byScales) {
            job.run('scales', job.exports.plan_scales(), options.memory);
        } else if (onPoints) {
            job.run('points', job.exports.plan_points(), options.memory);
        } else if (options.representatives) {
            job.set({ purpose: PURPOSES.persist });
            job.run('delaunay', job.exports.plan_delaunay(), options.memory);
            job.persist(options.memory);
        } else {
            job.run('alpha', job.exports.plan_alpha(), options.memory);
        }
        return diagramOf(job, name, { ...options, bounds: options.bounds || options.focus === 'auto' });
    }
    // What was left open, as the command-line tool settles it. Returns whether the best that fits is to be found.
    #settle(job, filter, options, given, values, dim) {
        const { fit = false, focus, longerThan } = options;
        const byMethod = options.method !== undefined || Boolean(options.finish);
        const byScales = filter.source === SOURCE.scales, automatic = focus === 'auto';
        if (fit && options.memory === undefined) refuse('fit', 'needs memory, the size to fit in');
        if (automatic && options.memory === undefined) refuse('focus', '"auto" needs memory, the size to fit in');
        if (automatic && fit) refuse('fit', 'finds the best ratio, focus: "auto" which bars are real');
        if (longerThan !== undefined && !automatic) refuse('longerThan', 'goes with focus: "auto"');
        if (fit && given.error) refuse('error', 'fit finds the least one');
        const fitsError = fit && filter.needsFunction && !byMethod;
        const open = filter.hasEps && !given.eps && !given.ratio && !fit && !byMethod;
        const defaultRatio = Math.sqrt(2 + job.exports.default_tau());
        let ratio = given.ratio;
        if (dim >= 4 && open && values === 0)
            ratio = defaultRatio * (1 + 3 * (filter.hasTheta ? given.theta ?? 1 / 9 : 0));
        const byGoal = filter.hasGoal || (filter.hasEps && ratio !== undefined);
        const refines = !byScales && !byMethod && (fit ? !filter.hasEps && !filter.needsFunction
            : values === 0 && Boolean(byGoal));
        if (ratio !== undefined && !refines && !byScales) refuse('ratio', 'for filters refined by the certificate');
        if (automatic && !(refines && filter.hasGoal)) refuse('focus', '"auto" is for the filter complete');
        if (fit && !refines && !fitsError) refuse('fit', 'for filters on a mesh but tight, without method');
        if (refines) ratio ??= fit ? FIT_RATIO : defaultRatio;
        const numbers = focus === undefined || automatic ? [] : [...focus];
        if (numbers.length > 0 && (!refines || numbers.length !== (fit ? 2 : 3)))
            refuse('focus', '"auto", [ratio, from, to], or with fit [from, to], of a refined filter');
        numbers.forEach(x => finite(x, 'focus'));
        const [from, to] = numbers.slice(-2);
        job.set({ method: choose(METHODS, options.method ?? 'svr', 'method'), finish: options.finish ?? 0,
            ratio: fitsError ? 0 : ratio ?? 0, focus: numbers.length === 3 ? numbers[0] : 0, from: from ?? 0,
            to: to ?? 0, byError: fitsError,
            longerThan: automatic ? positive(longerThan ?? LONGER_THAN, 'longerThan') : 0,
            bounds: automatic || (options.bounds ?? 0), purpose: refines ? PURPOSES.persist : filter.purpose,
            wholeCells: options.wholeCells || !(refines && filter.clipsCells) });
        return fit || automatic;
    }
    mesh(points, options = {}) {
        known('mesh', options);
        const read = pointsOf(points, options.dim);
        const job = this.#job(read, options);
        const numbers = Object.fromEntries(['tau', 'eps', 'ratio'].filter(o => options[o] !== undefined)
            .map(o => [o, positive(options[o], o)]));
        const [focus, from, to] = options.focus ?? [0, 0, 0];
        job.set({ ...numbers, focus, from, to, method: choose(METHODS, options.method ?? 'svr', 'method'),
            purpose: choose(PURPOSES, options.purpose ?? 'mesh', 'purpose'), finish: options.finish ?? 0,
            wholeCells: options.wholeCells ?? 0 });
        job.run('mesh', 1.5 * job.exports.plan_mesh(), options.memory);
        return new Mesh(job, read.dim, this.#filters, options.memory);
    }
    delaunay(points, options = {}) {
        known('delaunay', options);
        const read = pointsOf(points, options.dim);
        const job = this.#job(read, options);
        job.set({ purpose: choose({ mesh: 0, persist: 1 }, options.purpose ?? 'persist', 'purpose') });
        job.run('delaunay', 1.5 * job.exports.plan_delaunay(), options.memory);
        return new Mesh(job, read.dim, this.#filters, options.memory);
    }
    /** The diagram of any filtered complex: lists of vertices, and when each simplex enters. */
    homology(simplices, values, options = {}) {
        known('homology', options);
        const job = new Job(this.#module, options.progress);
        putSimplices(job, simplices);
        const entries = numbersOf(values, 'values');
        if (entries.length !== simplices.length)
            refuse('values', `${entries.length} numbers for ${simplices.length} simplices`);
        job.set({ entriesAt: job.put(entries), maxDegree: complexDegree(options),
            keepZeroPairs: options.keepZeroPairs ?? 0, representatives: options.representatives ?? 0 });
        job.rows = 'values';
        job.run('homology', job.exports.plan_homology(), options.memory);
        return diagramOf(job, '', options);
    }
    /** The diagrams of a filter for every k of a range, or of a complex (`simplices`) at every step of its values, and
     * the vines through them. */
    vineyard(points, options = {}) {
        known('vineyard', options);
        if ((points == null) === (options.simplices === undefined)) refuse('points', 'give points or simplices');
        if (points == null) return this.#filtrations(options);
        const name = options.filter ?? 'knn', filter = choose(this.#filters, name, 'filter');
        if (filter.hasVineyard && filter.source === SOURCE.mesh) {
            const { simplices, steps, byVertex, tau, dim, seed, memory, progress, ...rest } = options;
            const shared = { tau, dim, seed, memory, progress };
            for (const name of Object.keys(shared)) if (shared[name] === undefined) delete shared[name];
            return this.mesh(points, { ...shared, purpose: 'persist' }).vineyard(rest);
        }
        if (filter.source !== SOURCE.points || !filter.needsK) refuse('filter', `${name} has no vineyard`);
        if (options.tau !== undefined) refuse('tau', `not for the filter ${name}`);
        const job = this.#job(pointsOf(points, options.dim), options);
        job.set({ filter: filter.number, values: choose(VALUES, options.values ?? 'certified', 'values'),
            maxDegree: whole(options.maxDegree ?? 1, 'maxDegree', 0, 29), ...rangeOf(options.k ?? [1, 2]) });
        job.run('nested', job.exports.plan_nested(), options.memory);
        return vineyardOf(job, name);
    }
    #filtrations(options) {
        const job = new Job(this.#module, options.progress);
        const vertices = putSimplices(job, options.simplices);
        const due = options.byVertex ? vertices : options.simplices.length;
        if (!Array.isArray(options.steps) || options.steps.length === 0) refuse('steps', 'rows of numbers, one a step');
        const entries = new Float64Array(options.steps.length * due);
        options.steps.forEach((step, i) => {
            const row = numbersOf(step, 'steps');
            if (row.length !== due) refuse('steps', `row ${i} has ${row.length} values, where ${due} are due`);
            entries.set(row, i * due);
        });
        job.set({ entriesAt: job.put(entries), stepCount: options.steps.length, byVertex: options.byVertex ?? 0,
            maxDegree: complexDegree(options) });
        job.rows = 'steps';
        job.run('filtrations', job.exports.plan_filtrations(), options.memory);
        return vineyardOf(job, '');
    }
    rips(points, options = {}) {
        known('rips', options);
        const { distances, threshold = Infinity } = options;
        if ((points == null) === (distances === undefined)) refuse('points', 'give points or distances');
        if (typeof threshold !== 'number') refuse('threshold', 'not a number');
        const common = { maxDegree: whole(options.maxDegree ?? 1, 'maxDegree', 0, 30),
            keepZeroPairs: options.keepZeroPairs ?? 0, representatives: options.representatives ?? 0 };
        const read = distances === undefined ? pointsOf(points, options.dim) : null;
        if (read) return this.#persist(planar(read), options, 'rips');
        const { array, count } = this.#square(distances);
        const job = new Job(this.#module, options.progress);
        job.put(array);
        job.set({ points: count, layout: 0, threshold, ...common });
        job.run('distances', job.exports.plan_distances(), options.memory);
        return diagramOf(job, 'rips', options);
    }
    #square(distances) {
        const array = distances instanceof Float64Array ? distances
            : Array.isArray(distances) ? Float64Array.from(distances.flat()) : refuse('distances',
                'not numbers [n, n]');
        const count = Math.round(Math.sqrt(array.length));
        if (count * count !== array.length || count === 0) refuse('distances', `${array.length} numbers are no [n, n]`);
        return { array, count };
    }

    /** The bottleneck distance of two diagrams, or of bars Float64Array [m, 2]. */
    bottleneck(a, b, options = {}) {
        known('bottleneck', options);
        const [value, exponent] = this.#compare('bottleneck', a, b, { isLog: options.log ?? 0 }, options.degree);
        return options.log && Number.isFinite(value) ? Math.log(value) + exponent * Math.LN2 : value;
    }
    /** The Wasserstein distance, between `lower` and `value`, which is proven; `value` is at most 1 + `error` times
     *  `lower`. Bounds that stay farther apart are an error with status "internal", as that is a defect. */
    wasserstein(a, b, options = {}) {
        known('wasserstein', options);
        const set = { order: whole(options.order ?? 1, 'order', 1, 16), error: positive(options.error ?? 0.001,
            'error') };
        const [value, lower] = this.#compare('wasserstein', a, b, set, options.degree);
        return { value, lower };
    }
    #compare(name, a, b, set, degree) {
        const pairs = [barsOf(a, 'a'), barsOf(b, 'b')];
        const job = new Job(this.#module);
        const bytes = new Uint8Array(PAIR_BYTES * (pairs[0].length + pairs[1].length));
        const view = new DataView(bytes.buffer);
        pairs.flat().forEach((bar, i) => {
            view.setUint32(PAIR_BYTES * i, PAIR_BYTES, true);
            view.setUint32(PAIR_BYTES * i + 4, bar.degree, true);
            view.setFloat64(PAIR_BYTES * i + 8, bar.birth, true);
            view.setFloat64(PAIR_BYTES * i + 16, bar.death, true);
        });
        job.put(bytes);
        job.set({ countA: pairs[0].length, countB: pairs[1].length, ...set,
            degree: degree === undefined ? 2 ** 32 - 1 : whole(degree, 'degree', 0, 1000) });
        job.run(name, Math.max(1, job.exports[`plan_${name}`]()));
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
    bars.forEach(({ birth, death }, i) => {
        if (!Number.isFinite(birth) || !(death >= birth))
            throw new NetmeshError('invalid-argument',
                `${argument}, row ${i}: births are finite, deaths not before them`,
                argument, i);
    });
    return bars;
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
    const call = (name, ...values) => new Promise((resolve, reject) => {
        const id = ++number, options = values.at(-1);
        const { progress, ...rest } = options ?? {};
        if (typeof rest.function === 'function')
            refuse('function', 'functions do not cross to a worker: call load() in it');
        waiting.set(id, { resolve, reject, progress });
        if (inNode) worker.ref();
        const sent = values.slice(0, -1).map(value => value instanceof Diagram ? value.toObject() : value);
        worker.postMessage({ id, name, values: [...sent, rest], watched: Boolean(progress), module });
    });
    return {
        persist: (points, options = {}) => call('persist', points, options),
        rips: (points, options = {}) => call('rips', points, options),
        homology: (simplices, values, options = {}) => call('homology', simplices, values, options),
        vineyard: (points, options = {}) => call('vineyard', points, options),
        mesh: (points, options = {}) => call('mesh', points, options),
        delaunay: (points, options = {}) => call('delaunay', points, options),
        bottleneck: (a, b, options = {}) => call('bottleneck', a, b, options),
        wasserstein: (a, b, options = {}) => call('wasserstein', a, b, options),
        /** Stops what is on its way: it is rejected as "cancelled", and the worker is gone. */
        terminate: () => {
            fail(new NetmeshError('cancelled', 'the worker was stopped'));
            return worker.terminate();
        },
    };
}
