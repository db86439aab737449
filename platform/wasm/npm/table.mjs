// Tables of numbers in text, read as the program netmesh reads them (tools/io/table.hpp has the rules): what it takes
// here is what it takes there. What that one decides by other options is refused here, with the line.
import { foreign } from './foreign.mjs';
import { slipsOf } from './slips.mjs';

const isBlank = c => c === ' ' || c === '\t' || c === '\r' || c === '\v' || c === '\f';
const BLANKS_AROUND = /^[ \t\r\v\f]+|[ \t\r\v\f]+$/g;
const trimmed = text => text.replace(BLANKS_AROUND, '');
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;
const HAS_LETTER = /[A-Za-z\u0080-\uffff]/;
const MISSING = new Set(['', 'na', 'n/a', 'null', 'none', '-', '--', '.', '?', 'missing', '#n/a', 'nan', '-nan']);
const INDEX_NAMES = new Set(['index', 'id', 'idx', 'row', 'rowid', 'row_id', 'no', 'no.', 'nr', 'nr.', 'rownames',
    'row.names', '#', 'point_id', 'pointid', 'fid', 'objectid', '', 'unnamed: 0']);

class TableFault extends Error {
    constructor(line, message) {
        super(`line ${line}: ${message}`);
        this.line = line;
    }
}

// The end of the line that begins at `start`, whose first end is at `end`, with ends of lines in quotes.
function endWithBreaks(text, start, end) {
    const parts = at => ',;|\t'.includes(text[at]);
    let begins = true;
    for (let at = start; at < end; ++at) {
        if (text[at] !== '"' || !begins) {
            begins = parts(at) || (begins && isBlank(text[at]));
            continue;
        }
        begins = false;
        for (at = text.indexOf('"', at + 1); at >= 0 && text[at + 1] === '"';) at = text.indexOf('"', at + 2);
        if (at >= 0 && at < end) continue;
        if (at < 0) return end;
        let next = at + 1;
        while (text[next] === ' ' || text[next] === '\r') ++next;
        if (next < text.length && text[next] !== '\n' && !parts(next)) return end;
        const found = text.indexOf('\n', at);
        end = found < 0 ? text.length : found;
    }
    return end;
}

function withoutComment(line) {
    if (/^[ \t\r\v\f]*(%|\/\/)/.test(line)) return '';
    if (!line.includes('#')) return line;
    let quoted = false;
    for (let i = 0; i < line.length; ++i) {
        if (line[i] === '"') quoted = !quoted;
        if (line[i] !== '#' || quoted) continue;
        const before = trimmed(line.slice(0, i));
        const ofTabs = line[i - 1] === '\t' && line.includes('\t', i);
        // Site #3, in a cell
        const ofWords = !isBlank(line[i + 1] ?? ' ') && /[,;|\t]/.test(line.slice(i)) &&
            HAS_LETTER.test(before.split(/[ \t\r\v\f,;|]/).at(-1)[0] ?? '');
        const isApart = isBlank(line[i - 1]) && !ofTabs && !',;|'.includes(before.at(-1)) && !ofWords;
        if (before === '' || isApart) return line.slice(0, i);
    }
    return line;
}

function linesOf(text, skip) {
    text = text.replace(/^\ufeff/, '').replace(/\x1a$/, '');
    if (!text.includes('\n')) text = text.replaceAll('\r', '\n');
    const lines = [];
    let above = '';
    for (let start = 0, number = 1; start < text.length; ++number) {
        const found = text.indexOf('\n', start), first = found < 0 ? text.length : found;
        const end = number > skip ? endWithBreaks(text, start, first) : first;
        const whole = text.slice(start, end).replace(/\r+$/, ''), own = number;
        number += text.slice(start, end).split('\n').length - 1;
        start = end + 1;
        if (own <= skip) continue;
        const kept = withoutComment(whole), line = kept.replace(kept === whole ? / +$/ : /[ \t\r\v\f]+$/, '');
        if (trimmed(line) !== '') lines.push({ text: line, number: own, comment: whole.slice(kept.length) });
        else if (lines.length === 0) above = whole.replace(/^[#%/ \t\r]+/, '') || above;
    }
    return { lines, above };
}

// Fields { text, quoted } of a line; null where a quotation does not end. '' as delimiter: several together.
function cut(line, delimiter) {
    const fields = [];
    const ends = delimiter === ' ' ? isBlank : delimiter === '' ? c => isBlank(c) || c === ',' || c === ';'
        : c => c === delimiter;
    const byBlanks = delimiter === ' ' || delimiter === '';
    if (byBlanks) line = trimmed(line);
    for (let at = 0, due = true; ;) {
        while (at < line.length && isBlank(line[at]) && line[at] !== delimiter) ++at;
        if (delimiter === ' ') while (at < line.length && isBlank(line[at])) ++at;
        if (at >= line.length) {
            if (due && !(delimiter === ' ') && !(delimiter === '' && fields.length === 0))
                fields.push({ text: '', quoted: false });
            return fields;
        }
        let stop = at, text, quoted = false;
        if (line[at] === '"') {
            stop = at + 1;
            while (stop < line.length && (line[stop] !== '"' || line[stop + 1] === '"'))
                stop += line[stop] === '"' ? 2 : 1;
            if (stop >= line.length) return null;
            let behind = stop + 1;
            while (behind < line.length && !ends(line[behind])) ++behind;
            quoted = trimmed(line.slice(stop + 1, behind)) === '';
            text = trimmed(quoted ? line.slice(at + 1, stop) : line.slice(at, behind));
            stop = behind;
        } else {
            while (stop < line.length && !ends(line[stop])) ++stop;
            text = trimmed(line.slice(at, stop));
        }
        fields.push({ text, quoted });
        at = stop;
        if (delimiter === '') while (at < line.length && isBlank(line[at])) ++at;
        due = at < line.length && (delimiter === '' ? line[at] === ',' || line[at] === ';' : line[at] === delimiter);
        if (due && delimiter !== ' ') ++at;
    }
}

// What a field is: a number, else NaN for a word, Infinity for what is no finite number, null for nothing.
function valueOf({ text }, decimalComma) {
    if (text === '') return null;
    if (decimalComma && text.includes(',')) {
        if (text.includes('.') || !/^[^,]*\d,\d[^,]*$/.test(text)) return NaN;
        text = text.replace(',', '.');
    }
    if (/^[+-]?(nan|inf|infinity)$/i.test(text)) return Infinity;
    return NUMBER.test(text) ? Number(text) : NaN;
}
const isWord = value => Number.isNaN(value);

function isHeader(fields) {
    const areCounted = fields.slice(1).every(({ text }, i) => text === String(i));
    if (fields.length > 2 && fields[0].text === '' && areCounted) return true;
    let word = false;
    for (const field of fields) {
        if (field.text === '') continue;
        if (!isWord(valueOf(field, true)) || /^["\d.+-]/.test(field.text) || !HAS_LETTER.test(field.text)) return false;
        word = true;
    }
    return word;
}

// How the lines look, cut in one way.
function lookAt(lines, delimiter, decimalComma) {
    const look = { consistent: true, even: true, width: 0, commas: false, points: false, thousands: true, digits: false,
        innerBlanks: false, words: false };
    for (const { text } of lines) {
        const fields = cut(text, delimiter);
        if (fields === null) {
            look.consistent = look.even = false;
            continue;
        }
        look.width ||= fields.length;
        look.even &&= fields.length === look.width;
        for (const field of fields) {
            const value = valueOf(field, decimalComma);
            if (value === null) continue;
            if (!isWord(value)) {
                look.points ||= field.text.includes('.');
                if (!decimalComma || !field.text.includes(',')) continue;
                look.commas = true;
                look.thousands &&= /^[+-]?[1-9]\d{0,2},\d{3}$/.test(field.text);
                continue;
            }
            if (HAS_LETTER.test(field.text)) {
                look.words = true;
                continue;
            }
            look.innerBlanks ||= /[ \t]/.test(field.text);
            look.digits ||= /\d \d{3}(?!\d)/.test(field.text);
            look.consistent = false;
        }
    }
    look.consistent &&= look.even;
    look.thousands &&= look.commas;
    return look;
}

// 1.500 beside 300 in a column: every point may group thousands; 0, 0.500, 1.5 or 1500 speak against it.
function pointsMayGroup(lines, delimiter) {
    const columns = [];
    let points = 0;
    for (const { text: line } of lines) {
        const fields = cut(line, delimiter);
        if (!fields) return false;
        for (const [k, { text }] of fields.entries()) {
            if (!NUMBER.test(text)) continue;
            const column = columns[k] ??= {};
            if (text.includes('.')) {
                if (!/^[+-]?[1-9]\d{0,2}\.\d{3}$/.test(text)) return false;
                column.points = true;
                ++points;
                continue;
            }
            const whole = /^[+-]?(\d+)$/.exec(text)?.[1];
            if (!whole) return false;
            if (whole[0] !== '0') column[whole.length < 4 ? 'short' : 'long'] = true;
        }
    }
    return points > 1 && columns.some(column => column?.points && column.short && !column.long);
}

// Which delimiter fits all lines, and whether numbers have decimal commas.
function dialectOf(lines, names, notes) {
    const dialect = delimiterOf(lines, names, notes);
    if (dialect.delimiter !== ',' && !dialect.decimalComma && pointsMayGroup(lines, dialect.delimiter))
        throw new TableFault(lines[0].number, 'points may be decimal or group thousands (1.234), as whole numbers ' +
            'below 1000 stand beside them: say delimiter, which reads them as decimal, or write numbers without ' +
            'signs between thousands');
    return dialect;
}
function delimiterOf(lines, names, notes) {
    const count = lines.length, outside = lines.map(({ text }) => trimmed(text).replace(/(^|[,;|\t ])"[^"]*"/g, '$1"'));
    const holds = mark => outside.filter(line => line.slice(0, -1).includes(mark)).length;
    const marks = { bar: holds('|'), semicolon: holds(';'), comma: holds(','), blank: holds(' '), tab: holds('\t') };
    const refuse = words => { throw new TableFault(lines[0].number, words); };
    const decimal = delimiter => (notes.push('commas read as decimal'), { delimiter, decimalComma: true });
    const both = 'points and commas are both decimal here; write numbers in one way';
    const grouped = 'commas may be decimal or group thousands (1,234): say delimiter, which reads them as decimal';
    const twoWays = 'commas may be decimal or stand between columns: write points in place of decimal commas';
    const by = delimiter => {
        const strict = lookAt(lines, delimiter, true);
        if (strict.digits) refuse('blanks within numbers (1 234): write them without');
        if (strict.thousands) refuse(grouped);
        if (strict.consistent || (!strict.innerBlanks && marks.comma === 0)) {
            if (strict.commas && strict.points) refuse(both);
            return strict.commas ? decimal(delimiter) : { delimiter, decimalComma: false };
        }
        const bare = outside.some(line => /\d,\d/.test(line));
        const mixes = delimiter !== '|' && !bare && lookAt(lines, '', false).consistent;
        return { delimiter: mixes ? '' : delimiter, decimalComma: !mixes && marks.comma > 0 };
    };
    const byCommas = () => {
        const strict = lookAt(lines, ',', true);
        if (strict.thousands) refuse(grouped);
        if (strict.commas) return strict.points ? refuse(both) : decimal(',');
        if (outside.some(line => /,0\d/.test(line)) && lines.every(({ text }) => {
            const fields = cut(text, ',');
            return fields.length % 2 === 0 && fields.every(({ text, quoted }, i) => !quoted &&
                (i % 2 === 0 ? /^[+-]?\d+$/ : /^\+?\d+$/).test(text));
        })) refuse('numbers behind commas begin with zeros, as decimals do: part columns by something else');
        if (marks.blank + marks.tab > 0) {
            const blanks = lookAt(lines, ' ', true);
            if (blanks.consistent && blanks.commas && blanks.width > 1) refuse(twoWays);
        }
        if (outside.every(line => /,[ \t]/.test(line) && /\d,\d/.test(line))) refuse(twoWays);
        const mixed = strict.innerBlanks && names !== strict.width ? lookAt(lines, '', false) : { width: 0 };
        if (!(mixed.width > strict.width && mixed.consistent && !mixed.words))
            return { delimiter: ',', decimalComma: false };
        notes.push(`commas and blanks part columns, ${mixed.width} of them`);
        return { delimiter: '', decimalComma: false };
    };
    if (marks.bar === count) return by('|');
    if (marks.semicolon === count) return by(';');
    const tabs = ({ text }) => text.split('\t').length;
    const leadingTab = lines.every(({ text }) => text[0] === '\t');
    if (marks.tab === count && !leadingTab && (lines.every(line => tabs(line) === tabs(lines[0])) ||
        !lookAt(lines, ' ', false).even)) return by('\t');
    const parts = marks.semicolon === 0 || (lookAt(lines, ',', false).even && !lookAt(lines, '', false).consistent);
    if (marks.comma === count && parts) return byCommas();
    const blanks = lookAt(lines, ' ', true);
    if (marks.comma === 0)
        return { decimalComma: false,
            delimiter: marks.bar > 0 && !blanks.consistent ? '|' : marks.semicolon > 0 ? '' : ' ' };
    if (!blanks.consistent) {
        const plain = outside.some(line => /^[\d.+\-eE \t]+$/.test(line) && /[ \t]/.test(line));
        if (plain && !blanks.points && outside.some(line => /\d,\d/.test(line)))
            refuse('a comma between digits where other lines are parted by blanks: a decimal one, or a delimiter?');
        return { delimiter: '', decimalComma: false };
    }
    if (!blanks.commas) return { delimiter: '', decimalComma: false };
    if (lookAt(lines, '', false).consistent) refuse(twoWays);
    if (blanks.points) return { delimiter: '', decimalComma: false };
    return blanks.thousands ? refuse(grouped) : decimal(' ');
}

const nameOf = ({ text, quoted }) => quoted ? text.replaceAll('""', '"') : text;

// Columns counted from 0 out of numbers from 1, ranges "2-4" and names of the header.
function chooseColumns(wanted, width, names) {
    const chosen = [];
    for (const item of wanted) {
        const named = names.indexOf(String(item)), range = /^(\d+)(?:-(\d+))?$/.exec(String(item));
        if (named >= 0 && names.lastIndexOf(String(item)) !== named)
            throw new Error(`columns: two are called ${item}; numbers from 1 say which are meant`);
        if (named >= 0 && names.length < width)
            throw new Error(`columns: ${item}, where the header names ${names.length} columns and the rows have ` +
                `${width}; numbers from 1 say which are meant`);
        if (named >= 0 && named < width) {
            chosen.push(named);
            continue;
        }
        if (range === null) throw new Error(`columns: there is no column "${item}"`);
        const from = Number(range[1]), to = Number(range[2] ?? range[1]);
        if (from < 1 || to < from || to > width) throw new Error(`columns: there are columns 1 to ${width}`);
        for (let k = from; k <= to; ++k) chosen.push(k - 1);
    }
    if (new Set(chosen).size !== chosen.length) throw new Error('columns: one stands there twice');
    return chosen;
}

// # x,y above the rows, as numpy.savetxt writes names.
function namesAbove(above, dialect, width) {
    for (const delimiter of [dialect.delimiter, '']) {
        const fields = cut(above, delimiter);
        if (fields?.length === width && isHeader(fields)) return fields.map(nameOf);
    }
    return [];
}

/** The rows of numbers of a table in text: { points: Float64Array [count, dim], dim, count, names, lines, notes }.
 * Throws an Error that says which line is wrong and what to do. */
export function parseTable(text, { columns, delimiter, skip = 0, dropMissing = false } = {}) {
    const other = skip > 0 ? '' : foreign(text);
    if (other !== '') throw new Error(other);
    const { lines, above } = linesOf(text, skip), notes = [];
    if (lines.length === 0) {
        const signs = text.split(/[\r\n]+/).filter(line => trimmed(line)[0] === '#').length;
        throw new Error('the table ends without a row' +
            (signs > 1 ? `; ${signs} lines of it begin with #, as comments do: take that sign out` : ''));
    }
    const separator = /^"?sep=(.)"?$/i.exec(trimmed(lines[0].text));
    if (separator !== null) {
        delimiter ??= separator[1];
        notes.push(`skipped line "${trimmed(lines.shift().text)}"`);
    }
    const cutIn = (line, by) => cut(line.text, by) ?? (() => {
        throw new TableFault(line.number, 'a quotation that does not end');
    })();
    const words = by => lines.length > 0 && cut(lines[0].text, by) !== null && isHeader(cut(lines[0].text, by));
    const ofWords = words('') || words(delimiter ?? '') || (lines[0]?.text.includes('|') && words('|'));
    const ofQuotes = lines.length > 1 && lines[0].text.includes('"') && !lines[1].text.includes('"');
    const first = ofWords || ofQuotes ? 1 : 0;
    if (lines.length === first) throw new Error('the table ends without a row');
    const dialect = delimiter !== undefined ? { delimiter, decimalComma: true }
        : dialectOf(lines.slice(first), first > 0 ? cut(lines[0].text, ',')?.length ?? 0 : 0, notes);
    const parts = line => cutIn(line, dialect.delimiter);
    let names = [], header = parts(lines[0]);
    const counts = ofQuotes &&
        header.every(({ text, quoted }, k) => quoted && (text === String(k) || text === String(k + 1)));
    if (isHeader(header) || counts || ofWords) {
        names = header.map(nameOf);
        notes.push(`skipped header "${trimmed(lines[0].text)}"`);
        header = lines.shift();
    }
    let rows = lines.map(line => ({ fields: parts(line), number: line.number }));
    const isEmpty = ({ fields }) => fields.every(({ text }) => text === '');
    const before = rows.length;
    while (rows.length > 1 && isEmpty(rows.at(-1))) rows.pop();
    if (rows.length < before) notes.push(`skipped ${before - rows.length} rows of nothing at the end`);
    const trailing = rows.every(({ fields }) => fields.length > 1 && fields.at(-1).text === '');
    if (trailing) notes.push('skipped an empty last column');
    const dropped = trailing ? 1 : 0, width = rows[0].fields.length - dropped, line = rows[0].number;
    if (trailing && names.length === width + 1 && names.at(-1) === '') names.pop();
    if (names.length > 0 && names.length !== width) {
        const others = cut(header.text, '');
        if (others !== null && others.length === width && isHeader(others)) names = others.map(nameOf);
    }
    const isText = field => !field ? false : isWord(valueOf(field, dialect.decimalComma)) || field.quoted;
    const wordColumn = k => rows.some(({ fields }) => isText(fields[k]) && fields[k].text !== '') &&
        rows.every(({ fields }) => fields[k] && (fields[k].text === '' || isText(fields[k])));
    const count = (k, step, from = 0) => rows.every(({ fields }, i) => i < from ||
        (/^\d+$/.test(fields[k]?.text ?? '') &&
            (i === from || step(Number(fields[k].text), Number(rows[i - 1].fields[k].text)))));
    let chosen = Array.from({ length: width }, (_, k) => k);
    const namesOfAll = names.length > 0 ? names : namesAbove(above, dialect, width);
    if (columns !== undefined) {
        chosen = chooseColumns(columns, width, namesOfAll.length + 1 === width ? ['', ...namesOfAll] : namesOfAll);
    } else {
        const named = names.filter(name => name !== '').length, fields = rows[0].fields;
        const byMark = ![' ', ''].includes(dialect.delimiter), head = fields.map(({ text }) => Number(text));
        if ((byMark || names.every(name => name.length < 3)) && named > 1 && names.length !== width &&
            named !== width && named !== width - 1 &&
            !fields.some(field => isWord(valueOf(field, dialect.decimalComma))))
            throw new TableFault(line, `${width} columns where the header names ${named}`);
        if (names.length === 0 && width > 1 && rows.length > 3 && fields.length === width &&
            fields.every(({ text }) => /^\d+$/.test(text))) {
            const isNode = width > 2 && head[0] === rows.length - 1 && head[1] > 1 && head[1] < width &&
                count(0, (a, b) => a === b + 1, 1);
            if (isNode) throw new TableFault(line, 'is the head of a .node file of Triangle or TetGen: skip it');
            if ((head[0] === rows.length - 1 && head[1] === width) ||
                (width === 2 && head[0] === 2 && head[1] === rows.length - 1))
                throw new TableFault(line, 'may say how many points of how many coordinates there are, or be a point: '
                    + 'skip it');
        }
        if (names.length === 0 && rows.length > 2 && ![' ', ''].includes(dialect.delimiter) && width > 1 &&
            delimiter === undefined && rows[0].fields.every(({ text }, k) => text === String(k)) &&
            rows.slice(1).every(({ fields }) => fields.every(({ text }) => /[.,eE]/.test(text))))
            throw new TableFault(line, 'may be column numbers, as pandas writes them, or a point: skip it');
        const short = names.length > 0 && names.length + 1 === width;
        const called = names.length === width && INDEX_NAMES.has(names[0]?.toLowerCase());
        if (width > 1 && (short || called)) {
            if (!count(0, (a, b) => short ? a === b + 1 : a > b) && !wordColumn(0))
                throw new TableFault(line, 'the header says that the first column is no coordinate, but it does not '
                    + 'count rows: choose columns');
            chosen.shift();
            notes.push('skipped index column 1');
        }
    }
    const lacks = ({ fields }) => fields.length === width + dropped &&
        chosen.some(k => MISSING.has(fields[k].text.toLowerCase()));
    const without = rows.filter(row => !lacks(row));
    if (dropMissing && without.length === 0) throw new TableFault(line, 'every row lacks a value');
    if (dropMissing)
        notes.push(without.length === rows.length ? 'no row lacks a value'
            : `left out ${rows.length - without.length} of ${rows.length} rows, which lack a value`);
    const taken = dropMissing ? without : rows, points = new Float64Array(taken.length * chosen.length);
    taken.forEach((row, i) => {
        const { fields, number } = row;
        chosen.forEach((k, j) => {
            if (k >= fields.length) return;
            const value = valueOf(fields[k], dialect.decimalComma);
            if (Number.isFinite(value) && value !== null) {
                points[i * chosen.length + j] = value + 0;
                return;
            }
            if (fields.length !== width + dropped && value === null) return;
            const words = wordColumn(k) ? chosen.filter(c => !wordColumn(c)).map(c => c + 1) : [];
            const lacking = rows.length - without.length, leaves = 'dropMissing leaves such rows out';
            const remedy = lacks(row) ? '; a row with a missing value has to be left out or filled in' +
                (without.length > 0 ? `: ${leaves}, ${lacking} of ${rows.length}` : '')
                : words.length > 0 ? `; columns ${words.join(', ')} are numbers` : '';
            throw new TableFault(number, (value === null ? `nothing in column ${k + 1}`
                : `"${fields[k].text.slice(0, 40)}" is not a ${isWord(value) ? 'number' : 'finite double'}`) + remedy);
        });
        if (fields.length !== width + dropped)
            throw new TableFault(number,
                `${fields.length} column${fields.length === 1 ? '' : 's'} where line ${line} has ${width + dropped}`);
    });
    if (rows.length > 1 && lines.every(({ comment }) => /^#[^ \t\r\v\f]/.test(comment)))
        notes.push(`left out what stands behind # in every row, "${lines[0].comment}" first; if it is a column, take ` +
            'that sign out');
    notes.push(...slipsOf(points, chosen, namesOfAll.length === width ? chosen.map(k => namesOfAll[k]) : [],
        columns !== undefined));
    names = namesOfAll;
    return { points, dim: chosen.length, count: taken.length, names, lines: taken.map(({ number }) => number), notes };
}
