// What people take for coordinates by mistake, told by names and numbers of columns (tools/io/slips.cpp).

const OTHER = new Set(['id', 'ids', 'uid', 'fid', 'objectid', 'pointid', 'idx', 'index', 'label', 'labels', 'class',
    'classification', 'cluster', 'category', 'target', 'flag', 'time', 'timestamp', 'datetime', 'date', 'year', 'frame',
    'intensity']);
const MARKS = new Set([-99, -999, -9999, -99999, -999999, -999.25, -32768, -2147483648, 9999, 99999, 999999, 32767,
    1e20, -1e20, 1e30, -1e30, 1e36, 9.969209968386869e36, -3.4028234663852886e38, 3.4028234663852886e38]);
const SINCE = [['seconds', 1], ['milliseconds', 1e3], ['microseconds', 1e6], ['nanoseconds', 1e9]];

const lowerCase = text => text.replace(/[A-Z]/g, c => c.toLowerCase());
const wordsOf = name => lowerCase(name.replace(/([a-z])(?=[A-Z])/g, '$1 ')).match(/[a-z\u0080-\uffff]+/g) ?? [];
const isDate = x => Number.isInteger(x) && x >= 19000101 && x <= 21001231 && x % 100 >= 1 && x % 100 <= 31 &&
    Math.floor(x / 100) % 100 >= 1 && Math.floor(x / 100) % 100 <= 12;

/** Sentences about columns (from 0, of the file) that may be no coordinates; names are theirs, or none. */
export function slipsOf(points, columns, names, isChosen) {
    const dim = columns.length, rows = dim === 0 ? 0 : points.length / dim, notes = [];
    const fits = (k, test) => {
        for (let i = 0; i < rows; ++i) if (!test(points[i * dim + k], i)) return false;
        return true;
    };
    const called = k => names[k] ? `"${names[k]}"` : `column ${columns[k] + 1}`;
    const without = leftOut => {
        const left = columns.map((column, k) => names[k] && names.filter(name => name === names[k]).length === 1
            ? names[k] : column + 1).filter((_, k) => !leftOut.includes(k));
        return left.length < 2 ? '' : `; columns ${left.join(', ')} leave ${leftOut.length === 1 ? 'it' : 'them'} out`;
    };
    let others = [];
    if (!isChosen) {
        const lower = names.map(lowerCase), hasPlaces = lower.includes('x') && lower.includes('y');
        others = lower.flatMap((name, k) => wordsOf(names[k]).some(word => OTHER.has(word)) ||
            (hasPlaces && !/^([t-z]|x\d)$/.test(name)) ? [k] : []);
        if (others.length === dim) others = [];
        if (others.length > 0)
            notes.push(`took ${others.map(called).join(', ')} for ` +
                `${others.length === 1 ? 'a coordinate' : 'coordinates'}, too${without(others)}`);
        const counting = columns.flatMap((_, k) => Number.isInteger(points[k]) && points[k] >= 0 &&
            fits(k, (x, i) => x === points[k] + i) ? [k] : []);
        if (dim > 2 && rows > 4 && counting.length === 1 && !others.includes(counting[0]))
            notes.push(`took ${called(counting[0])}, which counts rows, for a coordinate${without(counting)}`);
        for (let k = 0; k < dim && rows > 1; ++k) {
            const since = SINCE.find(([, scale]) => fits(k, x => x >= 1e9 * scale && x < 2.13e9 * scale));
            const what = fits(k, isDate) ? 'dates, as 20240131' : since && `${since[0]} since 1970`;
            if (what && !others.includes(k))
                notes.push(`took ${called(k)}, which looks like ${what}, for a coordinate${without([k])}`);
        }
    }
    const last = due => names.findLastIndex(name => wordsOf(name).some(word => due.includes(word)));
    const latitude = last(['lat', 'latitude']), longitude = last(['lon', 'lng', 'long', 'longitude']);
    if (latitude >= 0 && longitude >= 0 && latitude !== longitude && fits(latitude, x => Math.abs(x) <= 90) &&
        fits(longitude, x => Math.abs(x) <= 360))
        notes.push(`${called(latitude)} and ${called(longitude)} look like degrees, of which a degree east is ` +
            'shorter than one north: project them to metres first');
    for (let k = 0; k < dim; ++k) {
        let mark, low = Infinity, high = -Infinity, count = 0;
        for (let i = 0; i < rows; ++i) {
            const x = points[i * dim + k];
            if (MARKS.has(x)) {
                mark = x;
                continue;
            }
            ++count;
            low = Math.min(low, x);
            high = Math.max(high, x);
        }
        const away = Math.max(low - mark, mark - high);
        if (mark !== undefined && count > 1 && away >= high - low && away >= Math.abs(mark) / 2)
            notes.push(`${called(k)} holds ${mark}, far from its other numbers: if it stands for a missing value, ` +
                'leave such rows out');
    }
    return notes;
}
