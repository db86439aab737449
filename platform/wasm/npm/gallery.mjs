// The gallery of tools/docs/gallery.md in JavaScript: node gallery.mjs [DATA]
// DATA is the folder tests/data of a clone. Writes of each set a line: name, fingerprint and what is seen.
import { readFileSync } from 'node:fs';
import { gunzipSync } from 'node:zlib';
import { load } from 'netmesh';

const data = process.argv[2] ?? new URL('../../../tests/data', import.meta.url).pathname;
const text = name => readFileSync(`${data}/${name}`, 'utf8');
const table = name => text(name).trim().split('\n').slice(1).map(line => line.split(',').map(Number));
const show = (name, diagram, words) => console.log(name.padEnd(12), diagram.fingerprint, words);
const netmesh = await load();

// Bars of one degree, the longest one first.
const longest = (diagram, degree) => [...diagram].filter(bar => bar.degree === degree)
    .sort((a, b) => b.death - b.birth - (a.death - a.birth));

// Atoms of a protein: rings of six atoms die at the length of their bonds, rings of five before that.
const atoms = gunzipSync(readFileSync(`${data}/1A8O.pdb.gz`)).toString().split('\n')
    .filter(line => /^(ATOM|HETATM)/.test(line)).map(line => [30, 38, 46].map(at => Number(line.slice(at, at + 8))));
const protein = netmesh.persist(atoms, { maxDegree: 1 });
const rings = [...protein].filter(bar => bar.degree === 1 && bar.birth < 0.8);
show('protein', protein, `${rings.filter(bar => bar.death > 1.3).length} rings of six atoms, ` +
    `${rings.filter(bar => bar.death < 1.3).length} of five`);

// Earthquakes of a week, in thousands of kilometres from the middle of the Earth, which is the one void.
const earthquakes = netmesh.persist(table('earthquakes.csv').map(row => row.slice(4)));
const [hollow] = longest(earthquakes, 2);
show('earthquakes', earthquakes, `a void from ${(1000 * hollow.birth).toFixed(0)} to ` +
    `${(1000 * hollow.death).toFixed(0)} km`);

// Iris flowers: two groups of the three species.
const iris = netmesh.persist(table('iris.csv').map(row => row.slice(0, 4)));
const [, last, before] = longest(iris, 0);
show('iris', iris, `two groups to ${last.death.toFixed(2)} cm, three to ${before.death.toFixed(2)}`);

// High ground: the long loops are lower ground that it closes in.
const ground = netmesh.persist(table('jacksboro.csv').map(row => row.slice(0, 2)));
const widest = Math.max(...longest(ground, 1).map(bar => bar.death));
show('jacksboro', ground, `low ground with room for a disc of ${widest.toFixed(2)} km`);
