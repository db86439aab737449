// Points out of text: one a line, numbers between commas, semicolons, blanks or tabs, in quotes or not. A first line of
// names, empty lines and lines that start with # are skipped. Commas are decimal where another separator parts the
// numbers and no number has a point. Throws with the line that is wrong.
function parse_points(text) {
    const lines = text.split(/\r?\n/).map((line, i) => ({ line: line.trim(), number: i + 1 }))
        .filter(({ line }) => line !== '' && !line.startsWith('#'));
    if (lines.length === 0) throw new Error('there are no points');
    const semicolons = lines.filter(({ line }) => line.includes(';')).length > lines.length / 2;
    const decimal_comma = lines.every(({ line }) => !/\d\.\d/.test(line)) &&
        lines.some(({ line }) => /\d,\d/.test(line)) &&
        (semicolons || lines.filter(({ line }) => /\d,\d+\s+-?\d+,\d/.test(line)).length > lines.length / 2);
    const split = line => {
        const parts = decimal_comma ? line.replaceAll(',', '.').split(semicolons ? ';' : /\s+/)
            : line.split(semicolons ? ';' : /\s*,\s*|\s+/);
        while (parts.length > 1 && parts.at(-1).trim() === '') parts.pop();
        return parts.map(part => part.trim().replace(/^"(.*)"$/, '$1'));
    };
    const notes = [], rows = [];
    if (decimal_comma) notes.push('commas are decimal');
    lines.forEach(({ line, number }, i) => {
        const row = split(line).map(part => part === '' ? NaN : Number(part));
        if (row.some(x => !Number.isFinite(x))) {
            if (i > 0) throw new Error(`line ${number} is not a row of numbers: ${line.slice(0, 40)}`);
            notes.push(`line ${number} skipped as names`);
            return;
        }
        if (rows.length > 0 && row.length !== rows[0].length)
            throw new Error(`line ${number} has ${row.length} numbers, the first point has ${rows[0].length}`);
        rows.push(row);
    });
    if (rows.length === 0) throw new Error('there are no points');
    const dim = rows[0].length;
    if (dim < 2 || dim > 6) throw new Error(`points have ${dim} coordinates; 2 to 6 are possible`);
    if (rows.length > 2 && rows.every((row, i) => row[0] === rows[0][0] + i))
        notes.push('the first column counts up: is it an index?');
    return { dim, count: rows.length, points: Float64Array.from(rows.flat()), notes };
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
function each(count, place) { return Array.from({ length: count }, (_, i) => place(i)); }
function sample_text(name) {
    let state = 7;
    const random = () => (state = (state * 1103515245 + 12345) % 2147483648) / 2147483648 - 0.5;
    return samples[name](random).map(row => row.map(x => Number(x.toFixed(6))).join(', ')).join('\n');
}
