// The barcode as SVG: by degree, bars that are certified to exist first, the longest first, in bold those that stand apart
// by their length; before each the band in which a bar of that birth may be an artefact. Degree 0 shows what stands apart, the rest is counted.
const barcode_rows = 12, short_share = 0.03;  // rows of a degree; of the longest bar, what is left out when there are many

const escape_text = text => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
const short_number = x => x === Infinity ? '\u221e'
    : x !== 0 && (x < 1e-3 || x >= 1e6) ? x.toExponential(2) : Number(x.toPrecision(4)).toString();
const counted = count => count.toLocaleString('en');
const sub = degree => String.fromCharCode(0x2080 + degree);

// How many of the lengths, which descend, stand apart: those that are infinite, and the others above the largest gap, where
// a length is at least 1.5 times the next one; below the last of at most 8 is a gap, too, as of 2.5.
function count_apart(all) {
    const lengths = all.filter(length => length > 0);
    let apart = lengths.findIndex(Number.isFinite), largest = 1.5;
    if (apart < 0) return lengths.length;
    for (let i = apart, end = Math.min(apart + 12, lengths.length - 1); i < end; ++i) {
        if (!(lengths[i] >= largest * lengths[i + 1])) continue;
        largest = lengths[i] / lengths[i + 1];
        apart = i + 1;
    }
    return lengths.length <= 8 && largest < 2.5 ? lengths.length : apart;
}

// [{ degree, total, exist, apart, shown: [index of a pair] }]; apart: how long a bar is at least that stands apart
function barcode_groups(pairs) {
    const degrees = [...new Set(pairs.map(p => p.degree))].sort((a, b) => a - b);
    const length = i => pairs[i].death - pairs[i].birth;
    return degrees.map(degree => {
        const all = pairs.map((p, i) => i).filter(i => pairs[i].degree === degree);
        const order = (i, j) => length(j) === length(i) ? 0 : length(j) - length(i);
        all.sort(order);
        const lengths = all.map(length), count = count_apart(lengths);
        const apart = count > 0 ? lengths[count - 1] : Infinity;
        const exist = all.filter(i => pairs[i].exists);
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
        shown = [...shown.filter(i => pairs[i].exists), ...shown.filter(i => !pairs[i].exists)];
        return { degree, total: all.length, exist: exist.length, count, apart, shown };
    });
}

// Values from 0 to the last finite one and a little more.
function barcode_end(pairs) {
    const finite = pairs.flatMap(p => [p.birth, p.death]).filter(Number.isFinite);
    return finite.reduce((most, x) => Math.max(most, x), 0) * 1.08 || 1;
}

// As a picture; or as a group of buttons, which arrow keys go through, and narrow where the screen is.
function barcode_svg({ pairs, ratio, has_bounds }, title, { buttons = false, narrow = false } = {}) {
    const [width, left, right, row, bar] = narrow ? [360, 92, 96, 24, 14] : [600, 128, 138, 13, 8];
    const end = barcode_end(pairs), groups = barcode_groups(pairs);
    const x = value => left + Math.max(0, Math.min(value, end)) / end * (width - left - right);
    const parts = [];
    let y = 16, tab = 0;  // of all buttons one is reached by the tabulator
    const as_button = () => buttons ? ` role="button" aria-pressed="false" tabindex="${tab++ === 0 ? 0 : -1}"` : '';
    const rect = (from, to, top, height, fill, more = '') =>
        `<rect x="${from.toFixed(2)}" y="${top.toFixed(2)}" width="${Math.max(.8, to - from).toFixed(2)}" ` +
        `height="${height}" fill="${fill}"${more}/>`;
    const text = (at, base, words, size, more = '') =>
        `<text x="${at}" y="${base}" font-size="${size}"${more}>${escape_text(words)}</text>`;
    for (const { degree, total, exist, count, apart, shown } of groups) {
        const top = y, colour = degree_colours[degree % 6];
        parts.push(text(8, y + 13, 'H' + sub(degree), 17, ' font-weight="bold" fill="#22262b"'),
            text(8, y + 28, `${counted(total)} bar${total === 1 ? '' : 's'}`, 10, ' fill="#5b626a"'));
        const lines = [ratio === 1 ? '' : `${counted(exist)} certified`,
            count === 0 ? '' : `${count} stand${count === 1 ? 's' : ''} apart`,
            shown.length === total ? '' : `${counted(total - shown.length)} not shown`].filter(line => line !== '');
        lines.forEach((line, i) => parts.push(text(8, y + 41 + 13 * i, line, 10, ' fill="#5b626a"')));
        shown.forEach((i, at) => {
            const p = pairs[i], line = y + at * row;
            const doubt = p.after > p.birth
                ? rect(x(p.birth), x(p.after), line, row, '#fbf0d0', ' class="doubt"') : '';
            const arrow = p.death === Infinity ? `<path d="M${x(end)} ${line + row / 2 - 5.5}l10 5.5l-10 5.5z" fill="${colour}"/>` : '';
            const note = p.exists ? text(width - right + 14, line + row / 2 + 3.5, `${short_number(p.birth)} to ${short_number(p.death)}`,
                10, ' fill="#22262b"' + (p.death - p.birth >= apart ? ' font-weight="bold"' : '')) : '';
            const field = buttons ? rect(left, width, line, row, 'none', ' pointer-events="all"') : '';
            parts.push(`<g class="bar" data-pair="${i}"${as_button()}>${field}${doubt}` + rect(x(p.birth), x(p.death),
                line + (row - bar) / 2, bar, colour, p.exists ? '' : ' fill-opacity=".45"') + arrow + note +
                `<title>H${degree}: ${p.birth} to ${p.death === Infinity ? 'infinity' : p.death}` +
                `${p.exists ? ', certified to exist' : ''}</title></g>`);
        });
        y = Math.max(y + shown.length * row, top + 34 + 13 * lines.length) + 12;
    }
    const ticks = [0, .25, .5, .75, 1].map(share => share * end / 1.08);
    parts.unshift(...ticks.map(t => `<path d="M${x(t).toFixed(2)} 8V${y}" stroke="#e3e6e9"/>`));
    parts.push(`<path d="M${left} ${y}H${width - right}" stroke="#22262b"/>`,
        ...ticks.map(t => text(x(t).toFixed(2), y + 15, short_number(Number(t.toPrecision(2))), 10,
            ' text-anchor="middle" fill="#22262b"')), text((left + width - right) / 2, y + 32, 'radius', 11,
            ' text-anchor="middle" fill="#22262b"'));
    const limit = has_bounds ? ' by its bounds' : `: death / birth \u2264 ${short_number(ratio * ratio)}`;
    const legend = ratio === 1 ? '' : rect(left, left + 18, y + 42, 11, '#fbf0d0') +
        text(left + 24, y + 52, `band: too short to be certified${limit}`, 10,
            ' fill="#22262b"');
    const height = y + (legend === '' ? 42 : 62);
    const words = groups.map(g => `degree ${g.degree}: ${g.total} bars` +
        (ratio === 1 ? '' : `, ${g.exist} certified to exist`)).join('; ');
    return { end, left, right, width, svg: `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" ` +
        `viewBox="0 0 ${width} ${height}" role="${buttons ? 'group' : 'img'}" font-family="Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', ` +
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
