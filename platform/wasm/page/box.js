// Periods of points in the plane: a box as the program's --box has it, 0:10,0:10, for each axis LO:HI, a length, which
// begins at 0, or a dash where there is no period.
const axes = ['x', 'y'];
const box_entries = text => text.split(',').map(entry => entry.trim());

// An entry for each axis: where there is none yet, the extent of the points, and a dash for axes that do not repeat.
function box_text(text, repeats, { points, dim, count }) {
    const entries = box_entries(text), is_pair = entries.length === axes.length;
    if (!is_pair && text.trim() !== '') return text;
    return axes.map((_, k) => {
        if (!repeats[k]) return '-';
        if (is_pair && entries[k] !== '' && entries[k] !== '-') return entries[k];
        let low = Infinity, high = -Infinity;
        for (let i = 0; i < count; ++i) {
            low = Math.min(low, points[i * dim + k]);
            high = Math.max(high, points[i * dim + k]);
        }
        return `${low}:${high}`;
    }).join(',');
}

// { low: [2], high: [2], lattice: [its vectors one behind the other], text }; without a period low and high are
// infinite. Throws a sentence that says what to write.
function parse_box(text, is_extent) {
    const entries = box_entries(text);
    if (entries.length !== axes.length)
        throw new Error(`box: "${text}" has ${entries.length === 1 ? '1 entry' : `${entries.length} entries`} where ` +
            'x and y take one each: write from where to where, a length, or a dash for no period, as 0:10,0:10');
    const box = { low: [], high: [], lattice: [] };
    box.text = entries.map((entry, k) => {
        const [low, high] = entry === '-' ? [-Infinity, Infinity] : parse_period(entry, axes[k], is_extent);
        box.low.push(low);
        box.high.push(high);
        if (entry === '-') return entry;
        box.lattice.push(...axes.map((_, i) => i === k ? high - low : 0));
        return `${low}:${high}`;
    }).join(',');
    return box;
}
function parse_period(entry, axis, is_extent) {
    const ends = entry.split(':').map(end => end.trim()), values = ends.map(Number);
    const wrong = ends.findIndex((end, i) => !NUMBER.test(end) || !Number.isFinite(values[i]));
    if (ends.length > 2)
        throw new Error(`box: ${axis} has "${entry}": write two numbers, from where to where, as 0:10`);
    if (wrong >= 0)
        throw new Error(`box: ${axis} has "${ends[wrong]}", which is no finite number: write from where to where, as ` +
            '0:10, or a dash for no period');
    const [low, high] = values.length === 1 ? [0, values[0]] : values;
    if (low === high && is_extent)
        throw new Error(`box: all points have ${axis} = ${low}, so their extent is no period: write where the period ` +
            `begins and ends, as ${low}:${low + 1}`);
    if (low === high)
        throw new Error(`box: ${axis} has length 0: write an end above ${low}, as ${low}:${low + 1}, or a ` +
            'dash for no period');
    if (low > high)
        throw new Error(values.length === 1
            ? `box: the length of ${axis} is ${high}: write a length above 0, as ${-high}`
            : `box: ${axis} ends at ${high}, which is below its start ${low}: write ${high}:${low}`);
    if (!Number.isFinite(high - low))
        throw new Error(`box: ${axis} is longer than the largest double: write ends that are nearer to each other`);
    return [low, high];
}

// Rows of the points as the engine counts them, each once; null: what is equal modulo the periods is not told here by
// doubles, as it is by the engine.
function distinct_rows(places, { dim, count }, inputs) {
    const seen = new Set(), rows = [];
    for (let i = 0; i < count; ++i) {
        const key = places.subarray(i * dim, (i + 1) * dim).join(' ');
        if (!seen.has(key)) rows.push(i);
        seen.add(key);
    }
    return rows.length === inputs ? rows : null;
}

// The simplices of a cycle as places [simplex][vertex][2].
function cycle_places({ cycle, copies }, { points }, { lattice }, rows) {
    const periods = lattice.length / 2, places = new Float64Array(2 * cycle.length);
    cycle.forEach((v, i) => {
        for (let k = 0; k < 2; ++k) {
            places[2 * i + k] = points[2 * rows[v] + k];
            for (let j = 0; j < periods; ++j) places[2 * i + k] += copies[i * periods + j] * lattice[2 * j + k];
        }
    });
    return places;
}

// The alpha complex modulo two periods, of the class of degree 2 that lasts, whose cycle is each triangle once: edges
// and triangles as of complex_of, but with places [vertex][2] of one copy of each. null: there is no such cycle, as with
// one period or of degrees below 2.
function box_complex({ pairs, figures }, cloud, box, rows) {
    const torus = pairs.find(p => p.degree === 2 && p.death === Infinity && p.cycle !== null);
    if (torus === undefined || rows === null || torus.cycle.length !== 6 * figures.inputs) return null;
    const { cycle, copies } = torus, places = cycle_places(torus, cloud, box, rows), triangles = [], found = new Map();
    for (let t = 0; t < cycle.length; t += 3) {
        const own = places.subarray(2 * t, 2 * t + 6), at = c => own.subarray(2 * c, 2 * c + 2);
        const value = Math.sqrt(sphere_through([0, 1, 2], own, 2).square);
        triangles.push({ places: own, value });
        for (let c = 0; c < 3; ++c) {
            let a = (c + 1) % 3, b = (c + 2) % 3;
            const step = (from, to) => [0, 1].map(k => copies[2 * (t + to) + k] - copies[2 * (t + from) + k]);
            const [across, up] = step(a, b);
            const order = cycle[t + b] - cycle[t + a] || across || up;  // one direction for each edge
            if (order < 0) [a, b] = [b, a];
            const key = [cycle[t + a], cycle[t + b], ...step(a, b)].join(' ');
            const [from, to, other] = [at(a), at(b), at(c)];
            const half = Math.hypot(to[0] - from[0], to[1] - from[1]) / 2;
            const edge = found.get(key) ?? { places: Float64Array.of(...from, ...to), value: half, least: value };
            edge.least = Math.min(edge.least, value);
            edge.is_attached ||= Math.hypot(other[0] - (from[0] + to[0]) / 2, other[1] - (from[1] + to[1]) / 2) < half;
            found.set(key, edge);
        }
    }
    const sorted = list => list.sort((a, b) => a.value - b.value);
    const edges = [...found.values()].map(({ places, value, least, is_attached }) =>
        ({ places, value: is_attached ? least : value }));
    return { edges: sorted(edges), triangles: sorted(triangles) };
}

// The picture's points: the copy of each that is in the box. Of points on its upper sides nobody says that they are
// outside, as all extents have some.
function points_in_box({ points, dim, count }, { low, high }) {
    const places = Float64Array.from(points);
    let outside = 0;
    for (let i = 0; i < count; ++i) {
        let is_outside = false;
        for (let k = 0; k < dim; ++k) {
            if (!Number.isFinite(low[k])) continue;
            const x = points[i * dim + k], length = high[k] - low[k];
            is_outside ||= x < low[k] || x > high[k];
            const inside = x - Math.floor((x - low[k]) / length) * length;
            places[i * dim + k] = inside < high[k] ? Math.max(inside, low[k]) : low[k];
        }
        outside += is_outside ? 1 : 0;
    }
    return { places, outside };
}
