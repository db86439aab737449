"""Files that are no tables in text, told by how they begin (tools/io/points.cpp)."""
import re

_READ = "; write its points as a table in text, or give the file to the program netmesh, which reads it"
_TABLE = "; write its points as a table in text"
_FOREIGN = [(re.compile(mark), what) for mark, what in (
    (b"\x93NUMPY", "a NumPy array: numpy.load reads it"),
    (b"PK\x03\x04", "an archive or a workbook: numpy.load reads .npz, a workbook has to be saved as CSV"),
    (b"[A-Z0-9]{0,5}OFF\\s", "an OFF file" + _READ),
    (b"ply\r?\n", "a PLY file" + _READ),
    (b"solid\\b[^\0]{0,1000}?\\bfacet\\b", "an STL file" + _READ),
    (b"ATOM  |HETATM|HEADER   ", "a PDB file" + _READ),
    (b"\\s*[0-9]+[ \t]*\r?\n[^\n]*\n[ \t]*[A-Z][a-z]?([ \t]+[-+.0-9eE]+){3}", "atoms in .xyz" + _READ),
    (b"((#|mtllib|o|g)[^\n]*\n|\\s)*v +[-+.0-9]", "an OBJ file" + _READ),
    (b"[{]", "JSON, not a table" + _TABLE),
    (b"\\[", "brackets around rows; write plain rows of numbers, as numpy.savetxt does, without brackets"),
    (b"<(!DOCTYPE|!doctype|html)", "a page of HTML, not a table; was a log-in page saved in its place?"),
    (b"<[?]xml|<VTKFile|# vtk DataFile", "a VTK or XML file" + _TABLE),
    (b"ITEM: |LAMMPS ", "a file of LAMMPS" + _TABLE),
    (b"# [.]PCD|VERSION [.]7", "a point cloud of PCL" + _TABLE),
    (b"@<TRIPOS>|# Name: |data_", "a MOL2 or mmCIF file" + _TABLE),
    (b"%%MatrixMarket", "a matrix of MatrixMarket" + _TABLE),
    (b"\x89HDF|PAR1|\x80[\x02-\x05]|\xd0\xcf\x11\xe0|%PDF|MATLAB 5", "no text; save the table as CSV"),
)]


def foreign(content):
    """What the bytes are that are no table, and what to do; empty for others."""
    content = content[3:] if content[:3] == b"\xef\xbb\xbf" else content
    for mark, what in _FOREIGN:
        if mark.match(content):
            return what
    if b"\0" in content and content[:2] not in (b"\xff\xfe", b"\xfe\xff"):
        return "byte %d is 0, so this is no text; wide characters are read from UTF-16 with its byte-order mark" % (
            content.index(b"\0"))
    return ""
