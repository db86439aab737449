// Points out of text, as the program reads them (npm/table.mjs). Throws with the line that is wrong.
function parse_points(text, { columns = '', drop_missing = false } = {}) {
    const chosen = columns.trim() === '' ? undefined
        : columns.match(/"(?:[^"]|"")*"|[^,]+/g).map(item => item.trim().replace(/^"(.*)"$/, '$1').replaceAll('""', '"'));
    const { points, dim, count, notes } = parseTable(text, { columns: chosen, dropMissing: drop_missing });
    if (dim < 2 || dim > 6) throw new Error(`${dim} column${dim === 1 ? '' : 's'}; points have 2 to 6 coordinates: choose columns`);
    return { dim, count, points, notes };
}

// Samples by fixed formulas.
const samples = {
    'figure eight, 2D': random => each(120, i => {
        const t = i / 60 * 2 * Math.PI, side = i < 60 ? 1 : -1;
        return [side * (1 - Math.cos(t)) + .08 * random(), Math.sin(t) + .08 * random()];
    }),
    'noisy circle, 2D': random => each(80, i => {
        const t = i / 80 * 2 * Math.PI;
        return [Math.cos(t) + .2 * random(), Math.sin(t) + .2 * random()];
    }),
    'three clusters, 2D': random => each(90, i => [[0, 0], [3, .5], [1.2, 2.6]][i % 3].map(x => x + .6 * random())),
    'circle in a periodic box, 2D': random => each(60, i => {
        const t = i / 60 * 2 * Math.PI;
        return [.3 * Math.cos(t) + .03 * random(), .3 * Math.sin(t) + .03 * random()].map(x => x - Math.floor(x));
    }),
    'sphere, 3D': random => each(200, i => {
        const z = 2 * (i + .5) / 200 - 1, t = 2.399963 * i, r = Math.sqrt(1 - z * z);
        return [r * Math.cos(t), r * Math.sin(t), z].map(x => x + .04 * random());
    }),
    'torus, 3D': random => each(600, () => {
        const s = 2 * Math.PI * random(), t = 2 * Math.PI * random();
        return [(1 + .4 * Math.cos(t)) * Math.cos(s), (1 + .4 * Math.cos(t)) * Math.sin(s), .4 * Math.sin(t)];
    }),
    'Clifford torus, 4D': () => each(300, i => {
        const t = i / 300 * 2 * Math.PI;
        return [Math.cos(t), Math.sin(t), Math.cos(10 * t), Math.sin(10 * t)];
    }),
    'two circles, 5D': random => each(120, i => {
        const t = i / 60 * 2 * Math.PI;
        const x = i < 60 ? [Math.cos(t), Math.sin(t), 0, 0, 0] : [0, 0, Math.cos(t), Math.sin(t), 3];
        return x.map(c => c + .02 * random());
    }),
};
const sample_boxes = { 'circle in a periodic box, 2D': '0:1,0:1' };
function each(count, place) { return Array.from({ length: count }, (_, i) => place(i)); }
function sample_text(name) {
    let state = 7;
    const random = () => (state = (state * 1103515245 + 12345) % 2147483648) / 2147483648 - 0.5;
    return samples[name](random).map(row => row.map(x => Number(x.toFixed(6))).join(', ')).join('\n');
}
