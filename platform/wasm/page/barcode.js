// The barcode as SVG: by degree, bars that surely are real first, the longest first; before each the band in which a bar
// of that birth may be an artefact. Degree 0 shows what stands apart, the rest is counted.
const barcode_rows = 12, short_share = 0.03;  // rows of a degree; of the longest bar, what is left out when there are many

const escape_text = text => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
const short_number = x => x === Infinity ? '\u221e'
    : x !== 0 && (x < 1e-3 || x >= 1e6) ? x.toExponential(2) : Number(x.toPrecision(4)).toString();
const sub = degree => String.fromCharCode(0x2080 + degree);

// [{ degree, total, real, shown: [index of a pair] }]
function barcode_groups(pairs) {
    const degrees = [...new Set(pairs.map(p => p.degree))].sort((a, b) => a - b);
    const length = i => pairs[i].death - pairs[i].birth;
    return degrees.map(degree => {
        const all = pairs.map((p, i) => i).filter(i => pairs[i].degree === degree);
        const order = (i, j) => length(j) === length(i) ? 0 : length(j) - length(i);
        all.sort(order);
        const real = all.filter(i => pairs[i].real);
        let shown = all.slice(0, barcode_rows);
        const longest = all.map(length).find(Number.isFinite) ?? 0;
        if (shown.length < all.length) shown = shown.filter(i => length(i) > short_share * longest);
        if (degree === 0 && all.length > 8) {  // those above the largest gap between deaths
            let apart = all.filter(i => length(i) === Infinity).length, largest = 1.5;
            for (let i = apart; i < Math.min(12, all.length - 1); ++i) {
                const ratio = pairs[all[i]].death / pairs[all[i + 1]].death;
                if (ratio > largest) { largest = ratio; apart = i + 1; }
            }
            shown = all.slice(0, apart);
        }
        shown = [...shown.filter(i => pairs[i].real), ...shown.filter(i => !pairs[i].real)];
        return { degree, total: all.length, real: real.length, shown };
    });
}

// Values from 0 to the last finite one and a little more.
function barcode_end(pairs) {
    const finite = pairs.flatMap(p => [p.birth, p.death]).filter(Number.isFinite);
    return finite.reduce((most, x) => Math.max(most, x), 0) * 1.08 || 1;
}

function barcode_svg({ pairs, ratio, has_bounds }, title) {
    const width = 560, left = 96, right = 130, row = 13, bar = 8;
    const end = barcode_end(pairs), groups = barcode_groups(pairs);
    const x = value => left + Math.max(0, Math.min(value, end)) / end * (width - left - right);
    const parts = [];
    let y = 16;
    const rect = (from, to, top, height, fill, more = '') =>
        `<rect x="${from.toFixed(2)}" y="${top.toFixed(2)}" width="${Math.max(.8, to - from).toFixed(2)}" ` +
        `height="${height}" fill="${fill}"${more}/>`;
    const text = (at, base, words, size, more = '') =>
        `<text x="${at}" y="${base}" font-size="${size}"${more}>${escape_text(words)}</text>`;
    for (const { degree, total, real, shown } of groups) {
        const top = y, colour = degree_colours[degree % 6];
        parts.push(text(8, y + 13, 'H' + sub(degree), 17, ` font-weight="bold" fill="${colour}"`),
            text(8, y + 28, `${total} bar${total === 1 ? '' : 's'}`, 10, ' fill="#5b626a"'),
            text(8, y + 41, `${real} surely real`, 10, ' fill="#5b626a"'));
        if (shown.length < total) parts.push(text(8, y + 54, `${total - shown.length} not shown`, 10, ' fill="#5b626a"'));
        shown.forEach((i, at) => {
            const p = pairs[i], line = y + at * row;
            const doubt = p.after > p.birth
                ? rect(x(p.birth), x(p.after), line, row, '#fbf0d0', ' class="doubt"') : '';
            const arrow = p.death === Infinity ? `<path d="M${x(end)} ${line + 1}l10 5.5l-10 5.5z" fill="${colour}"/>` : '';
            const note = p.real ? text(width - right + 14, line + 10, `${short_number(p.birth)} to ${short_number(p.death)}`,
                10, ' fill="#22262b"') : '';
            parts.push(`<g class="bar" data-pair="${i}">${doubt}` + rect(x(p.birth), x(p.death), line + 2.5, bar, colour,
                p.real ? '' : ' fill-opacity=".45"') + arrow + note +
                `<title>H${degree}: ${p.birth} to ${p.death === Infinity ? 'infinity' : p.death}` +
                `${p.real ? ', surely real' : ''}</title></g>`);
        });
        y = Math.max(y + shown.length * row, top + 60) + 12;
    }
    const ticks = [0, .25, .5, .75, 1].map(share => share * end / 1.08);
    parts.unshift(...ticks.map(t => `<path d="M${x(t).toFixed(2)} 8V${y}" stroke="#e3e6e9"/>`));
    parts.push(`<path d="M${left} ${y}H${width - right}" stroke="#22262b"/>`,
        ...ticks.map(t => text(x(t).toFixed(2), y + 15, short_number(Number(t.toPrecision(2))), 10,
            ' text-anchor="middle" fill="#22262b"')), text((left + width - right) / 2, y + 32, 'radius', 11,
            ' text-anchor="middle" fill="#22262b"'));
    const limit = has_bounds ? ' by its bounds' : `: death / birth \u2264 ${short_number(ratio * ratio)}`;
    const legend = ratio === 1 ? '' : rect(left, left + 18, y + 42, 11, '#fbf0d0') +
        text(left + 24, y + 52, `band: too short to be surely real${limit}`, 10,
            ' fill="#22262b"');
    const height = y + (legend === '' ? 42 : 62);
    const words = groups.map(g => `degree ${g.degree}: ${g.total} bars, ${g.real} surely real`).join('; ');
    return { end, left, right, width, svg: `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" ` +
        `viewBox="0 0 ${width} ${height}" role="img" font-family="Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', ` +
        `sans-serif"><title>${escape_text(title)}</title><desc>${escape_text(words)}</desc>` +
        `<rect width="${width}" height="${height}" fill="#ffffff"/>${parts.join('\n')}${legend}` +
        `<path class="radius" d="M${left} 6V${y}" stroke="#d5590e" stroke-width="1.5" stroke-dasharray="4 3"/></svg>` };
}

// The lines of a .pers file.
function pers_text(result, described) {
    const number = x => x === Infinity ? 'inf' : String(x);
    const order = (p, q) => p.degree - q.degree || p.birth - q.birth || (p.death === q.death ? 0 : p.death - q.death);
    const lines = [...result.pairs].sort(order).map(p => `${p.degree} ${number(p.birth)} ${number(p.death)}`);
    return [`# netmesh ${result.figures.version}, made by the page: ${described}`,
        `# certified ratio ${result.ratio}`, ...lines, ''].join('\n');
}
