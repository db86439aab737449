// The inputs of tests/determinism/slice.cpp, and their lines of tests/golden/slice.txt, made by the package for
// JavaScript.
const MASK = (1n << 64n) - 1n, POINTS_MAX = 48, RANDOM_POINTS = [0, 0, 30, 14, 9, 8, 9];

class Random {
    constructor(seed) { this.state = BigInt(seed) * 0x9E3779B97F4A7C15n & MASK; }
    step() { return (this.state = (this.state * 6364136223846793005n + 1442695040888963407n) & MASK); }
    bits() {
        const high = this.step() >> 32n;
        return high << 32n | this.step() >> 32n;
    }
    uniform() { return Number(this.bits() >> 11n) * 2 ** -53; }
    below(n) { return Number((this.bits() >> 32n) % BigInt(n)); }
}

const times = (n, make) => Array.from({ length: n }, (_, i) => make(i));
const uniform = (dim, seed, n) => {
    const random = new Random(seed);
    return times(n, () => times(dim, () => random.uniform() - 0.25));
};

function grid(dim, side, count, scale, jitter) {
    const random = new Random(77);
    const place = digits => digits.map(d => (d + jitter * random.uniform()) * scale);
    if (side ** dim <= count) return times(side ** dim, i => place(times(dim, k => Math.floor(i / side ** k) % side)));
    return times(count, i => place(times(dim, k => i <= dim ? Number(k + 1 === i) : random.below(side))));
}

const cross = (dim, radius) => times(2 * dim, i => times(dim, k => k === i >> 1 ? (i & 1 ? radius : -radius) : 0));

function roots(dim, count) {
    const made = [];
    for (let i = 0; i < dim; ++i)
        for (let j = i + 1; j < dim; ++j)
            for (let s = 0; s < 4; ++s)
                made.push(times(dim, k => k === i ? (s & 1 ? 1 : -1) : k === j ? (s & 2 ? 1 : -1) : 0));
    made.length = Math.min(made.length, POINTS_MAX);
    const random = new Random(5);
    for (let i = made.length; i > 1; --i) {
        const j = random.below(i);
        [made[i - 1], made[j]] = [made[j], made[i - 1]];
    }
    return made.slice(0, count);
}

const zoom = (dim, count, step, seed) => {
    const random = new Random(seed);
    return times(count, i => times(dim, () => (2 * random.uniform() - 1) * 0.5 ** (i * step)));
};
const repeated = (points, copies) => {
    const n = points.length, more = times((copies - 1) * n, m => points[(m % n * 7 + 1 + Math.floor(m / n)) % n]);
    return [...points, ...more].slice(0, POINTS_MAX);
};

function input(dim, which) {
    const low = dim < 4, n = RANDOM_POINTS[dim], few = dim + 2, all = dim < 5 ? POINTS_MAX : dim < 6 ? 7 : 6;
    switch (which) {
    case 0: case 1: return [uniform(dim, which + 1, n), all];
    case 2: return [uniform(dim, 3, dim + 1), all];
    case 3: return [uniform(dim, 4, few), all];
    case 4: return [uniform(dim, 5, 1), all];
    case 5: return [grid(dim, 3, low ? 27 : n, 1, 0), all];
    case 6: return [grid(dim, 2, low ? 8 : n, 0.1, 0), all];
    case 7: return [grid(dim, 2, 8, 1, low ? 2 ** -44 : 2 ** -5), low ? 8 : 5];
    case 8: return [grid(dim, 2, dim, 3, 0), all];
    case 9: return [cross(dim, 1), all];
    case 10: return [[times(dim, () => 0), ...cross(dim, 0.3)], all];
    case 11: return [roots(dim, low ? 12 : n), all];
    case 12: return [grid(dim, 2, low ? 8 : few + 1, 2 ** -30, 0), all];
    case 13: return [zoom(dim, few, dim === 2 ? 8 : dim === 3 ? 2 : 1, 6), low ? few : 4];
    case 14: return [zoom(dim, few, dim === 2 ? 24 : 40, 7), dim === 2 ? few : 2];
    case 15: return [zoom(dim, dim + 3, 200, 8), all];
    case 16: return [repeated(uniform(dim, 9, few), 3), all];
    case 17: return [repeated(cross(dim, 1), 2), all];
    case 18: return [repeated(uniform(dim, 10, 1), 4), all];
    default: return [times(low ? few : 2, i => times(dim, k => i * i * 0.25 * (k + 1))), all];
    }
}

const said = make => {
    try {
        return make();
    } catch (error) {
        if (error.status === 'flat') return 'status 6';
        if (error.status === 'too-close') return 'status 7';
        throw error;
    }
};

/** Lines that differ from the golden ones, and how many were compared. */
export function compare(netmesh, golden) {
    const faults = [];
    let count = 0;
    const expect = (due, have) => {
        ++count;
        if (due !== have) faults.push(`- ${due}\n+ ${have}`);
    };
    for (const line of golden.trim().split('\n')) {
        const words = line.split(' '), dim = Number(words[0].slice(1)), which = Number(words[1]);
        if (words[1] === 'calls') {
            const due = Object.fromEntries(words.slice(2).flatMap((w, i, all) => i % 2 === 0 ? [[w, all[i + 1]]] : []));
            const points = uniform(dim, 12, 8);
            for (const filter of ['rips', 'cech'])
                if (filter in due)
                    expect(due[filter], netmesh.persist(points, { filter, maxDegree: 1,
                        representatives: true }).fingerprint);
            for (const filter of ['barycentric-cech', 'barycentric-rips'])
                if (filter in due) expect(due[filter], netmesh.persist(points, { filter, k: 2 }).fingerprint);
            if ('tight' in due) {
                const mesh = netmesh.mesh(uniform(dim, 11, dim < 5 ? dim + 2 : 3), { purpose: 'persist' });
                for (const filter of ['tight', 'kdistance', 'knn'])
                    expect(due[filter], mesh.persist({ filter, ...filter !== 'tight' && { k: 2 } }).fingerprint);
                const slope = x => Math.abs(x[0]) * 0.5 + Math.abs(x[1]) * 0.25;
                expect(due.function, mesh.persist({ filter: 'function', function: slope, lipschitz: 0.75, cut: 2 })
                    .fingerprint);
                expect(due.vineyard, mesh.vineyard({ k: [1, 2] }).fingerprint);
            }
            if ('cages' in due)
                expect(due.cages, netmesh.mesh(zoom(dim, dim < 5 ? 5 : 3, 6, 13), { method: 'netmesh' }).fingerprint);
            for (const kind of ['cech', 'rips'])
                if (`nested-${kind}` in due)
                    expect(due[`nested-${kind}`], netmesh.vineyard(points.slice(0, 6), { k: [1, 3],
                        filter: `barycentric-${kind}` }).fingerprint);
            if ('scales' in due) {
                expect(due.scales, netmesh.persist(zoom(2, 2, 30, 14), { filter: 'scales' }).fingerprint);
                const simplices = [[0], [1], [2], [3], [0, 1], [1, 2], [2, 0], [3, 1], [2, 3], [0, 1, 2]];
                const values = [0, 0.5, 0.25, 0, 1, 2, 1.5, 2, 3, 2.5];
                expect(due.homology, netmesh.homology(simplices, values, { maxDegree: 2, representatives: true })
                    .fingerprint);
            }
            continue;
        }
        if (!/^\d+$/.test(words[1])) continue;
        const [points, meshed] = input(dim, which);
        const some = points.slice(0, meshed);
        const mesh = () => netmesh.mesh(some, { purpose: 'persist' });
        expect(line, [words.slice(0, 3).join(' '), 'delaunay', said(() => netmesh.delaunay(points).fingerprint),
            'alpha',
            said(() => netmesh.delaunay(points).persist({ filter: 'alpha', keepZeroPairs: true }).fingerprint), 'mesh',
            said(() => mesh().fingerprint), 'persist',
                said(() => mesh().persist({ keepZeroPairs: true }).fingerprint)].join(' '));
    }
    return { faults, count };
}
