// Texts that are no tables, told by how they begin (tools/io/points.cpp).

const TABLE = '; write its points as a table in text';
const READ = `${TABLE}, or give the file to the program netmesh, which reads it`;
const FOREIGN = [
    [/^[A-Z0-9]{0,5}OFF\s/, `an OFF file${READ}`],
    [/^ply\r?\n/, `a PLY file${READ}`],
    [/^solid\b[^]{0,1000}?\bfacet\b/, `an STL file${READ}`],
    [/^(ATOM {2}|HETATM|HEADER {3})/, `a PDB file${READ}`],
    [/^\s*\d+[ \t]*\r?\n[^\n]*\n[ \t]*[A-Z][a-z]?([ \t]+[-+.\deE]+){3}/, `atoms in .xyz${READ}`],
    [/^((#|mtllib|o|g)[^\n]*\n|\s)*v +[-+.\d]/, `an OBJ file${READ}`],
    [/^\{/, `JSON, not a table${TABLE}`],
    [/^\[/, 'brackets around rows; write plain rows of numbers, without brackets'],
    [/^<(!doctype|html)/i, 'a page of HTML, not a table; was a log-in page saved in its place?'],
    [/^(<[?]xml|<VTKFile|# vtk DataFile)/, `a VTK or XML file${TABLE}`],
    [/^(ITEM: |LAMMPS )/, `a file of LAMMPS${TABLE}`],
    [/^(# [.]PCD|VERSION [.]7)/, `a point cloud of PCL${TABLE}`],
    [/^(@<TRIPOS>|# Name: |data_)/, `a MOL2 or mmCIF file${TABLE}`],
    [/^%%MatrixMarket/, `a matrix of MatrixMarket${TABLE}`],
    [/^.NUMPY/s, `a NumPy array${READ}`],
    [/^(PK\x03\x04|.HDF|PAR1|%PDF|MATLAB 5|\x1f)|\0/s, 'no text; save the table as CSV'],
];

/** What a text is that is no table, and what to do; empty for others. */
export function foreign(text) {
    const found = FOREIGN.find(([mark]) => mark.test(text.replace(/^\ufeff/, '').slice(0, 4096)));
    return found === undefined ? '' : found[1];
}
