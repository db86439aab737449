// node check.mjs GOLDEN: the package as it is installed as "netmesh" beside this file: fingerprints, results by hand,
// errors, a worker. Exits 1 with a word for each fault.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { load, loadWorker, Diagram, NetmeshError, Vineyard } from 'netmesh';
import { compare } from './slice.mjs';

const netmesh = await load();
const { faults, count } = compare(netmesh, readFileSync(process.argv[2], 'utf8'));
assert.deepEqual(faults, []);
assert.ok(count > 100);

// A circle of 60 points: a hole from sin(pi / 60) to 1.
const circle = Array.from({ length: 60 }, (_, i) => [Math.cos(i * Math.PI / 30), Math.sin(i * Math.PI / 30)]);
const diagram = netmesh.persist(circle, { representatives: true, bounds: true });
const close = (a, b) => assert.ok(Math.abs(a - b) < 1e-12, `${a} where ${b} is due`);
close(diagram.intervals(1)[0], Math.sin(Math.PI / 60));
close(diagram.intervals(1)[1], 1);
assert.equal(diagram.length, 61);
assert.equal([...diagram].filter(bar => bar.death === Infinity).length, 1);
const cycle = diagram.representatives[diagram.rows(1)[0]];
const ends = new Map();
for (const v of cycle) ends.set(v, (ends.get(v) ?? 0) + 1);
assert.ok(cycle.length >= 6 && [...ends.values()].every(n => n % 2 === 0));
assert.equal(diagram.bounds.certain.length, 61);
assert.equal(diagram.certifiedRatio, 1);

// Typed arrays, packed floats and rows are the same points.
const packed = Float32Array.from(circle.flat());
const rows = Array.from({ length: 60 }, (_, i) => packed.subarray(2 * i, 2 * i + 2));
assert.equal(netmesh.persist(packed, { dim: 2 }).fingerprint, netmesh.persist(rows).fingerprint);
assert.equal(netmesh.persist(Float64Array.from(packed), { dim: 2 }).fingerprint, netmesh.persist(rows).fingerprint);

// Filters, bounds and memory.
const proven = netmesh.persist(circle, { filter: 'complete', ratio: 1.8, bounds: true });
assert.ok(proven.certifiedRatio <= 1.8);
const [first, last] = proven.rows(1);
const sure = [...proven.bounds.certain.subarray(first, last)].flatMap((c, i) => c ? [first + i] : []);
assert.equal(sure.length, 1);
const bounds = proven.bounds.numbers.subarray(5 * sure[0], 5 * sure[0] + 4);
assert.ok(bounds[0] <= Math.sin(Math.PI / 60) && bounds[1] >= Math.sin(Math.PI / 60) && bounds[2] <= 1
    && bounds[3] >= 1);
assert.ok(netmesh.persist(circle, { filter: 'tight', ratio: 1.8 }).certifiedRatio <= 1.8);
assert.equal(netmesh.persist(circle, { memory: 1 << 20 }).fingerprint, netmesh.persist(circle).fingerprint);
const mesh = netmesh.mesh(circle, { tau: 2.5 });
mesh.check();
assert.ok(mesh.aspectRatioMax <= 2.5 && mesh.values === null);
assert.deepEqual([...mesh.vertices.subarray(0, 120)], circle.flat());
assert.equal(mesh.cells.length, 3 * mesh.cellCount);
assert.ok(mesh.neighbours.includes(-1) && mesh.markers[60] > 0 && Math.abs(mesh.domain.radius - 1) < 1e-9);
mesh.persist({ filter: 'knn', k: 2 });
assert.equal(mesh.values.length, mesh.vertexCount);

// The longest bars.
const eight = netmesh.persist([...circle, ...circle.map(([x, y]) => [3 + x / 2, y / 2])]);
close(eight.longest(1)[1], 1);
assert.deepEqual([eight.longest(1, 2).length, eight.longest(0).length, eight.longest(0)[1]], [4, 2, Infinity]);
close(eight.longest(1, 2)[3], 0.5);
assert.equal(eight.longest(1, 1000).length, eight.intervals(1).length);
assert.throws(() => eight.longest(1, 0), { status: 'invalid-argument', argument: 'count' });

// Rips of points, by a threshold, and of distances.
const distances = circle.map(p => circle.map(q => Math.hypot(p[0] - q[0], p[1] - q[1])));
for (const made of [netmesh.rips(circle), netmesh.rips(circle, { threshold: 2 }), netmesh.rips(null, { distances })]) {
    close(made.intervals(1)[0], Math.sin(Math.PI / 60));
    close(made.intervals(1)[1], Math.sqrt(3) / 2);
}
assert.equal(netmesh.rips(circle, { threshold: 0.5 }).intervals(1)[1], Infinity);
assert.throws(() => netmesh.rips(distances), { status: 'invalid-argument', argument: 'points', message: /rips\(null/ });
assert.equal(netmesh.persist(distances, { filter: 'rips' }).intervals(0).length, 120);
assert.throws(() => netmesh.persist(circle, { k: 3 }), { status: 'invalid-argument', argument: 'k', message: /knn/ });
assert.equal(netmesh.rips([[0], [1], [3]]).intervals(0).length, 6);

// Distances by hand.
assert.equal(netmesh.bottleneck(Float64Array.of(0, 8), Float64Array.of(1, 8)), 1);
assert.ok(Math.abs(netmesh.bottleneck(Float64Array.of(1, 8), Float64Array.of(2, 8), { log: true }) - Math.LN2) < 1e-15);
const transport = netmesh.wasserstein(Float64Array.of(0, 8, 0, 2), Float64Array.of(1, 8));
assert.ok(transport.lower <= 2 && transport.value >= 2 && transport.value <= 1.001 * transport.lower);
assert.equal(netmesh.bottleneck(diagram, diagram), 0);

// "auto" is the engine's own choice. Of the circle and of a lattice it is the exact complex. The Delaunay triangulation
// of this curve in space joins any two of its points, so there it is the mesh. What asks for a mesh takes the mesh.
const lattice = Array.from({ length: 3000 }, (_, i) => [i % 15, Math.floor(i / 15) % 15, Math.floor(i / 225)]);
assert.equal(netmesh.persist(lattice).filter, 'alpha');
const curve = Array.from({ length: 1000 }, (_, i) => [i / 1000, (i / 1000) ** 2, (i / 1000) ** 3]);
const cheap = netmesh.persist(curve);
assert.equal(cheap.filter, 'complete');
assert.equal(cheap.why, 'the exact alpha complex would take more work than a mesh');
assert.equal(cheap.fingerprint, netmesh.persist(curve, { filter: 'complete' }).fingerprint);
assert.equal(diagram.filter, 'alpha');
assert.equal(netmesh.persist(circle, { ratio: 2, bounds: false }).filter, 'complete');
for (const filter of ['auto', 'alpha']) {
    for (const [points, dim] of [[[[0, 0, 5], [1, 0, 5], [1, 1, 5], [0, 1, 5]]],
        [new Float32Array([7, 0, 5, 0, 7, 1, 5, 0, 7, 1, 5, 1, 7, 0, 5, 1]), 4]]) {
        const bar = netmesh.persist(points, { filter, dim }).intervals(1);
        assert.deepEqual([...bar], [0.5, Math.SQRT1_2]);
    }
}
assert.equal(netmesh.persist([[0, 5, 5], [1, 5, 5], [2, 5, 5]]).filter, 'complete');
const line = [[0, 0], [1, 0], [3, 0]];
const flat = netmesh.persist(line, { bounds: true, representatives: true });
assert.equal(flat.filter, 'complete');
assert.ok(flat.bounds.certain.length === flat.length && flat.representatives.length === flat.length);

// A function: the height of two pits, the second one of which joins the first at the saddle between them.
const pits = x => Math.min(Math.hypot(x[0] + 0.5, x[1]), Math.hypot(x[0] - 0.5, x[1]) + 0.25);
const heights = { filter: 'function', function: pits, lipschitz: 1, cut: 1 };
const corners = [[-2, 0], [2, 0], [0, 2], [0, -2]];
const valleys = netmesh.persist(corners, { ...heights, error: 0.05, bounds: true });
assert.ok(valleys.certifiedError <= 0.05 && valleys.bounds.certain.length === valleys.length);
const [low, never, second, saddle] = [...valleys.intervals(0)].slice(0, 4);
assert.ok(Math.abs(low) <= 0.05 && never === Infinity && Math.abs(second - 0.25) <= 0.05
    && Math.abs(saddle - 0.625) <= 0.05);
const fitted = netmesh.persist(corners, { ...heights, fit: true, memory: 1 << 20 });
assert.ok(fitted.certifiedError < 0.5 && netmesh.persist(corners, { ...heights, fit: true, memory: 1 << 22 })
    .certifiedError < fitted.certifiedError);

// The best that fits: more memory, a better ratio; and scales of interest.
const small = netmesh.persist(circle, { filter: 'complete', fit: true, memory: 1 << 17 });
const large = netmesh.persist(circle, { filter: 'complete', fit: true, memory: 1 << 23 });
assert.ok(large.certifiedRatio < small.certifiedRatio && large.peakBytes <= 1 << 23);
const focused = netmesh.persist(circle, { filter: 'complete', ratio: 3, focus: [1.5, 0.5, 1.5], bounds: true });
const rough = netmesh.persist(circle, { filter: 'complete', ratio: 3, bounds: true });
const width = of => {
    const [begin, end] = of.rows(1), n = of.bounds.numbers;
    const longest = Array.from({ length: end - begin }, (_, i) => 5 * (begin + i)).sort((i, j) => n[j + 4] - n[i + 4])
        .at(-1);
    return n[longest + 3] / n[longest + 2];
};
assert.ok(width(focused) < width(rough), `${width(focused)} ${width(rough)}`);
const decided = netmesh.persist(circle, { focus: 'auto', longerThan: 2, memory: 1 << 24 });
assert.ok(decided.bounds.certain.subarray(...decided.rows(1)).filter(Boolean).length === 1);

// A complex by its simplices: a hollow triangle, filled at 3.
const triangle = [[0], [1], [2], [0, 1], [1, 2], [0, 2], [0, 1, 2]];
const filled = netmesh.homology(triangle, [0, 0, 0, 1, 1, 2, 3], { representatives: true });
assert.deepEqual([...filled.intervals(1)], [2, 3]);
assert.deepEqual([...filled.intervals(0)], [0, 1, 0, 1, 0, Infinity]);
assert.equal(filled.representatives[filled.rows(1)[0]].length, 6);

// Vineyards: in k on a mesh, in k on the points, and of values; each k is that k's diagram.
const inK = netmesh.vineyard(circle, { k: [1, 3] });
assert.deepEqual(inK.k, [1, 3]);
const meshed = netmesh.mesh(circle, { purpose: 'persist' });
for (const k of [1, 2, 3]) {
    const alone = meshed.persist({ filter: 'knn', k });
    assert.deepEqual([...inK.diagram(k).intervals(1)], [...alone.intervals(1)]);
    assert.equal(inK.ratios[k - 1], alone.certifiedRatio);
}
const nested = netmesh.vineyard(circle.slice(0, 8), { k: [1, 2], filter: 'barycentric-cech' });
assert.deepEqual([...nested.diagram(2).intervals(0)],
    [...netmesh.persist(circle.slice(0, 8), { filter: 'barycentric-cech', k: 2 }).intervals(0)]);
const moved = netmesh.vineyard(null, { simplices: triangle, steps: [[0, 0, 0, 1, 1, 2, 3], [0, 0, 0, 1, 1, 2, 5]] });
const loop = Array.from({ length: moved.count }, (_, i) => moved.vine(i)).find(v => v.intervals[0] === 2);
assert.deepEqual([[...loop.ks], [...loop.intervals]], [[1, 2], [2, 3, 2, 5]]);
const byVertex = netmesh.vineyard(null, { simplices: triangle, steps: [[0, 1, 2]], byVertex: true });
assert.deepEqual([...byVertex.diagram(1).intervals(0)], [0, Infinity]);

// Points that repeat: a square and a cubic lattice, and what goes with them.
const births = (made, degree) => [...made.intervals(degree)].filter((_, i) => i % 2 === 0);
const square = netmesh.persist([[0.25, 0.75]], { lattice: [[1, 0], [0, 1]] });
assert.deepEqual([0, 1, 2].map(degree => births(square, degree)), [[0], [0.5, 0.5], [Math.SQRT1_2]]);
assert.ok(square.copies > 0 && square.moved === 0 && diagram.copies === 0);
assert.ok(netmesh.persist([[1 / 3, 0.1]], { lattice: [[1 / 3, 0], [0, 0.7]] }).moved > 0);
const sides = [[1, 0, 0], [0, 1, 0], Float64Array.of(0, 0, 1)];
{
    // Its two loops go to the next copy along either axis; by a basis that is not short as well.
    const around = (points, lattice) => {
        const d = netmesh.persist(points, { lattice, representatives: true });
        const [first, end] = d.rows(1);
        return d.translations.slice(first, end).map(t => Array.from(t)).sort();
    };
    assert.deepEqual(around([[0.25, 0.75]], [[1, 0], [0, 1]]), [[0, 0, 0, 1], [0, 0, 1, 0]]);
    assert.deepEqual(around([[0.25, 0.75]], [[1, 0], [5, 1]]).map(t => t.map(Math.abs)), [[0, 0, 1, 0], [0, 0, 5, 1]]);
    const corner = netmesh.persist([[0, 0], [1, 0], [0, 1]], { filter: 'alpha', representatives: true });
    assert.equal(corner.translations, null);
}
const cubic = netmesh.persist(new Float32Array(3), { dim: 3, lattice: sides });
assert.deepEqual(births(cubic, 3), [Math.sqrt(3) / 2]);
assert.deepEqual(births(netmesh.persist([[0, 0]], { lattice: [[1, 0], [0, 1]], radii: [0.25], squares: true }), 1),
    [0.1875, 0.1875]);

// Errors name argument and row.
const refused = (make, status, argument, row = null) => {
    try {
        make();
    } catch (error) {
        assert.ok(error instanceof NetmeshError && error.message.length > 0, error.stack);
        assert.deepEqual([error.status, error.argument, error.row], [status, argument, row]);
        return;
    }
    assert.fail(`not refused: ${make}`);
};
const spoiled = circle.map((p, i) => i === 17 ? [NaN, 0] : p);
refused(() => netmesh.persist(spoiled), 'not-finite', 'points', 17);
refused(() => netmesh.rips(spoiled, { threshold: 1 }), 'not-finite', 'points', 17);
refused(() => netmesh.delaunay([[0, 0], [1, 1]]), 'flat', 'points');
refused(() => netmesh.mesh([[1, 0], [1 + 2 ** -52, 0]]), 'too-close', 'points', 0);
refused(() => netmesh.mesh([[1e200, 0], [1, 0]]), 'out-of-range', 'points', 0);
refused(() => netmesh.persist(circle, { memory: 1000 }), 'out-of-memory', 'memory');
refused(() => netmesh.persist(circle, { filter: 'knn', k: 61 }), 'invalid-argument', 'k');
refused(() => netmesh.persist(circle, { filter: 'complete', ratio: 1.2 }), 'invalid-argument', 'ratio');
refused(() => netmesh.rips(null, { distances: [[0, 1], [2, 0]] }), 'invalid-argument', 'distances', 1);
for (const [argument, options] of Object.entries({ filter: { filter: 'x' }, k: { k: 2 }, colour: { colour: 1 },
    maxDegree: { maxDegree: -1 }, tau: { filter: 'complete', tau: 'x' }, seed: { seed: 0.5 },
        progress: { progress: 1 } }))
    refused(() => netmesh.persist(circle, options), 'invalid-argument', argument);
for (const points of [null, 3, [], [[1, 2], [3]], [['a', 'b']], [[1]], new Float64Array(3)])
    refused(() => netmesh.persist(points, points instanceof Float64Array ? { dim: 2 } : {}), 'invalid-argument',
        'points');
refused(() => netmesh.homology([[0], [0, 1]], [0, 1]), 'not-a-complex', 'simplices', 1);
refused(() => netmesh.homology([[0], [1]], [0, NaN]), 'not-finite', 'values', 1);
refused(() => netmesh.homology([[0], [1]], [0]), 'invalid-argument', 'values');
refused(() => netmesh.homology([[0.5]], [0]), 'invalid-argument', 'simplices');
refused(() => netmesh.vineyard(null, { simplices: [[0], [1], [0, 1]], steps: [[0, 0, 1], [0, 2, 1]] }), 'not-a-complex',
    'simplices', 2);
refused(() => netmesh.vineyard(null, { simplices: [[0]], steps: [[1, 2]] }), 'invalid-argument', 'steps');
refused(() => netmesh.vineyard(circle, { k: [2, 1] }), 'invalid-argument', 'k');
refused(() => netmesh.vineyard(circle, { k: [1, 61] }), 'invalid-argument', 'k');
refused(() => netmesh.vineyard(circle, { filter: 'alpha' }), 'invalid-argument', 'k');
refused(() => netmesh.persist(circle, { filter: 'function' }), 'invalid-argument', 'function');
refused(() => netmesh.persist(circle, { ...heights, cut: undefined }), 'invalid-argument', 'cut');
refused(() => netmesh.persist(circle, { ...heights, function: () => 'x' }), 'invalid-argument', 'function');
refused(() => netmesh.persist(circle, { ...heights, function: () => NaN }), 'not-finite', 'function');
refused(() => netmesh.persist(circle, { filter: 'alpha', function: pits }), 'invalid-argument', 'function');
refused(() => netmesh.persist(circle, { filter: 'complete', fit: true }), 'invalid-argument', 'fit');
refused(() => netmesh.persist(circle, { filter: 'complete', fit: true, memory: 1 << 14 }), 'out-of-memory', 'memory');
refused(() => netmesh.persist(circle, { focus: 'auto' }), 'invalid-argument', 'focus');
refused(() => netmesh.persist(circle, { focus: [1, 2] }), 'invalid-argument', 'focus');
refused(() => netmesh.persist(circle, { longerThan: 2 }), 'invalid-argument', 'longerThan');
assert.throws(() => netmesh.persist(circle, { ...heights, function: () => { throw new RangeError('mine'); } }),
    RangeError);
for (const lattice of [3, [], [1, 2], [[1, 0, 0]], [['a', 0]], [[1, 0], [2, 0]], [[NaN, 0]], [[1, 0], [0, 1], [1, 1]]])
    refused(() => netmesh.persist(circle, { lattice }), 'invalid-argument', 'lattice');
refused(() => netmesh.persist(circle, { filter: 'rips', lattice: [[9, 0]] }), 'invalid-argument', 'lattice');
refused(() => netmesh.persist(circle, { periods: true }), 'invalid-argument', 'periods');
refused(() => netmesh.bottleneck(Float64Array.of(2, 1), diagram), 'invalid-argument', 'a', 0);
refused(() => netmesh.mesh(circle, { tau: 1.5 }), 'invalid-argument', 'tau');
refused(() => diagram.intervals(2), 'invalid-argument', 'degree');

// Options that have the names of the engine's table; 0 is not "not given".
assert.ok(Math.abs(netmesh.mesh(circle, { domain_factor: 2 }).domain.radius - 2) < 1e-9);
assert.equal(netmesh.mesh(circle, { size_eps: 0.25 }).fingerprint, netmesh.mesh(circle, { eps: 0.25 }).fingerprint);
refused(() => netmesh.mesh(circle, { domain_factor: 9 }), 'invalid-argument', 'domain_factor');
refused(() => netmesh.mesh(circle, { eps: -1 }), 'invalid-argument', 'eps');
refused(() => netmesh.mesh(circle, { bounds: true }), 'invalid-argument', 'bounds');
refused(() => netmesh.persist(circle, { ratio: 0 }), 'invalid-argument', 'ratio');
refused(() => netmesh.persist(circle, { filter: 'knn', k: 0 }), 'invalid-argument', 'k');
assert.ok(netmesh.rips(circle, { threshold: 0 }).intervals(0).length === 120);

// Progress, and stopping by it.
const many = Float64Array.from({ length: 30000 }, (_, i) => Math.sin(i * i) * 1000 % 1);
const seen = [];
netmesh.persist(many, { dim: 3, progress: now => { seen.push(now); } });
assert.ok(seen.length > 0 && seen.every(now => typeof now.stage === 'string' && now.done >= 0));
refused(() => netmesh.persist(many, { dim: 3, progress: () => true }), 'cancelled', null);
assert.throws(() => netmesh.persist(many, { dim: 3, progress: () => { throw new RangeError('mine'); } }), RangeError);

// A worker: the same results and errors; stopped at once.
const worker = await loadWorker();
const fromWorker = await worker.persist(circle, { representatives: true });
assert.ok(fromWorker instanceof Diagram && fromWorker.fingerprint === netmesh.persist(circle, { representatives: true })
    .fingerprint);
assert.equal(await worker.bottleneck(fromWorker, diagram), 0);
const grown = await worker.vineyard(circle, { k: [1, 3] });
assert.ok(grown instanceof Vineyard && grown.fingerprint === inK.fingerprint && grown.diagram(2).length > 0);
assert.deepEqual([...(await worker.homology(triangle, [0, 0, 0, 1, 1, 2, 3])).intervals(1)], [2, 3]);
await assert.rejects(worker.persist(circle, heights), error => error.argument === 'function');
assert.equal((await worker.mesh(circle)).fingerprint, netmesh.mesh(circle).fingerprint);
await assert.rejects(worker.persist(spoiled), error => error instanceof NetmeshError && error.row === 17);
let told = 0;
await worker.persist(many, { dim: 3, progress: () => { ++told; } });
assert.ok(told > 0);
const stopped = assert.rejects(worker.persist(Float64Array.from({ length: 300000 }, Math.random), { dim: 3 }),
    error => error.status === 'cancelled');
setTimeout(() => worker.terminate(), 100);
const begin = performance.now();
await stopped;
assert.ok(performance.now() - begin < 1000);
console.log(`${count} fingerprints equal in node ${process.versions.node}`);
