#include "tools/io/points.hpp"

#include <algorithm>

#include "platform/files.hpp"
#include "platform/interrupt.hpp"
#include "tools/io/characters.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/point_stream.hpp"
#include "tools/io/unpack.hpp"

namespace netmesh::tool {

std::string PointCloud::place(std::uint64_t row) const {
    if (row < lines.size()) return "line " + std::to_string(lines[row]);
    return "row " + std::to_string(row + 1);
}

std::string PointCloud::where(std::uint64_t row) const {
    if (row < lines.size()) return name + ":" + std::to_string(lines[row]);
    return name + ": row " + std::to_string(row + 1);
}

namespace {

bool is_constant(const PointCloud& cloud, std::size_t k) {
    std::size_t i = k;
    while (i < cloud.coordinates.size() && cloud.coordinates[i] == cloud.coordinates[k]) i += cloud.dim;
    return i >= cloud.coordinates.size();
}

}  // namespace

std::string PointCloud::constant_coordinate() const {
    for (std::size_t k = dim; rows() > 1 && dim > 2 && k-- > 0;) {
        if (is_constant(*this, k))
            return "coordinate " + std::to_string(k + 1) + " is " + number_text(coordinates[k]) +
                   " in all points; without it, by --columns, the same points have an exact diagram";
    }
    return {};
}

std::string PointCloud::leave_out_constant() {
    std::vector<std::size_t> kept;
    std::string said;
    for (std::size_t k = 0; rows() > 1 && k < dim; ++k) {
        if (is_constant(*this, k))
            said += (said.empty() ? "" : ", ") + ("coordinate " + std::to_string(k + 1)) + " is " +
                    number_text(coordinates[k]);
        else
            kept.push_back(k);
    }
    if (said.empty() || kept.size() < dim_min) return {};
    std::size_t end = 0;
    for (std::size_t i = 0; i < coordinates.size(); i += dim)
        for (const std::size_t k : kept) coordinates[end++] = coordinates[i + k];
    coordinates.resize(end);
    dim = static_cast<std::uint32_t>(kept.size());
    return "left out what is the same in all points: " + said;
}

std::string ending_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    const std::size_t dot = path.rfind('.');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return {};
    return lower_case(path.substr(dot));
}

std::string shown_name(const std::string& path) { return path == "-" ? "<stdin>" : path; }

Outcome read_content(const std::string& path, std::string* content, bool* packed) {
    std::string why;
    const bool good = path == "-" ? platform::read_stdin(content, &why) : platform::read_file(path, content, &why);
    const bool gzip = good && content->compare(0, 2, "\x1F\x8B") == 0;
    if (packed != nullptr) *packed = gzip;
    if (gzip) {
        std::string unpacked;
        const std::string complaint = gunzip(*content, &unpacked);
        *content = std::move(unpacked);
        return complaint.empty() ? Outcome{} : file_error(shown_name(path), complaint);
    }
    if (good) return {};
    if (platform::interrupted()) return {Exit::cancelled, "netmesh: cancelled while reading " + shown_name(path)};
    return file_error(shown_name(path), why);
}

namespace {

// A format by what it is called, and the first ending it has.
struct Format {
    const char* ending;
    const char* called;
};

// Formats that are read and have a mark of their own.
Format format_of(std::string_view content) {
    if (starts(content, "\x93NUMPY")) return {".npy", "a NumPy array"};
    if (starts(content, "PK\x03\x04") && content.substr(4, 320).find(".npy") != std::string_view::npos)
        return {".npz", "an archive of NumPy arrays"};
    if (starts(content, "ply\n") || starts(content, "ply\r")) return {".ply", "a PLY file"};
    const std::string_view first = content.substr(0, content.find_first_of(" \r\n\t"));
    if (first.size() <= 8 && first.size() >= 3 && first.substr(first.size() - 3) == "OFF")
        return {".off", "an OFF file"};
    if (is_binary_stl(content) && content.size() > 84) return {".stl", "an STL file"};
    if (starts(content, "solid") && content.substr(0, 1000).find("facet") != std::string_view::npos)
        return {".stl", "an STL file"};
    if (starts(content, "HEADER   ") || starts(content, "ATOM  ") || starts(content, "HETATM"))
        return {".pdb", "a PDB file"};
    return {"", ""};
}

// The first lines of a text.
std::vector<std::string_view> first_lines(std::string_view content, std::size_t most) {
    std::vector<std::string_view> lines;
    LineReader reader(content, false);
    std::string_view line;
    while (lines.size() < most && reader.next(&line)) lines.push_back(line);
    return lines;
}

// A scale alone in line 2, three vectors below it, and how places are meant in line 7, 8 or 9.
bool is_poscar(std::string_view content) {
    const std::vector<std::string_view> lines = first_lines(content, 9);
    double ignored;
    if (lines.size() < 8 || !parse_finite(std::string(lines[1]), &ignored)) return false;
    for (std::size_t i = 2; i < 5; i++)
        if (split_blanks(lines[i]).size() != 3) return false;
    for (std::size_t i = 6; i < lines.size(); i++)
        for (const char* const word : {"direct", "cartesian", "selective dynamics"}) {
            if (starts(lower_case(lines[i]), word)) return true;
        }
    return false;
}

// A number of atoms alone in line 2, and in line 3 an atom in fixed columns, behind number and name of its residue.
bool is_gro(std::string_view content) {
    const std::size_t first = content.find('\n'), second = content.find('\n', first + 1);
    if (second == std::string_view::npos) return false;
    std::uint64_t count, number;
    const std::string_view line = content.substr(second + 1, 44);
    const std::vector<std::string_view> head = split_blanks(content.substr(first + 1, second - first - 1));
    if (head.size() != 1 || !parse_unsigned(std::string(head[0]), &count) || line.size() < 44) return false;
    const std::vector<std::string_view> residue = split_blanks(line.substr(0, 5)),
                                        atom = split_blanks(line.substr(15, 5));
    return residue.size() == 1 && atom.size() == 1 && parse_unsigned(std::string(residue[0]), &number) &&
           parse_unsigned(std::string(atom[0]), &number) && line[24] == '.' && line[32] == '.' && line[40] == '.';
}

// Formats that are not read, and what to do.
std::string foreign(std::string_view content) {
    static constexpr struct {
        std::string_view start;
        const char* what;
    } marks[] = {
        {std::string_view("PK\x03\x04", 4), "a workbook or zip archive, not text; save the table as CSV"},
        {std::string_view("\xD0\xCF\x11\xE0", 4), "an old Excel workbook, not text; save the table as CSV"},
        {"BZh", "compressed by bzip2; unpack it: bunzip2 FILE"},
        {std::string_view("\xFD"
                          "7zXZ",
                          5),
         "compressed by xz; unpack it: unxz FILE"},
        {std::string_view("\x28\xB5\x2F\xFD", 4), "compressed by zstd; unpack it: unzstd FILE"},
        {std::string_view("\x04\x22\x4D\x18", 4), "compressed by lz4; unpack it: unlz4 FILE"},
        {std::string_view("7z\xBC\xAF", 4), "a 7z archive; unpack it"},
        {"Rar!", "a RAR archive; unpack it"},
        {"\x89HDF", "an HDF5 file; write the data set as .npy or .csv"},
        {"MATLAB 5.0", "a MATLAB file; write the matrix by writematrix(A, 'a.csv')"},
        {"CDF\x01", "a NetCDF file; write the variable as .npy or .csv"},
        {"CDF\x02", "a NetCDF file; write the variable as .npy or .csv"},
        {"PAR1", "a Parquet file; write it as CSV: DataFrame.to_csv(..., index=False)"},
        {"ARROW1", "an Arrow file; write it as CSV"},
        {"FEA1", "a Feather file; write it as CSV"},
        {"SQLite format 3", "an SQLite database; write the table as CSV"},
        {"LASF", "a LAS or LAZ file; write its points as text: las2txt, or pdal translate to .csv"},
        {"\x80\x02", "a pickle of Python; write the array by numpy.save"},
        {"\x80\x03", "a pickle of Python; write the array by numpy.save"},
        {"\x80\x04", "a pickle of Python; write the array by numpy.save"},
        {"\x80\x05", "a pickle of Python; write the array by numpy.save"},
        {"\x89PNG", "a picture (PNG), not points"},
        {"\xFF\xD8\xFF", "a picture (JPEG), not points"},
        {"GIF8", "a picture (GIF), not points"},
        {"II*", "a picture (TIFF), not points"},
        {"%PDF", "a PDF document, not points"},
        {"%!PS", "a PostScript document, not points"},
        {"\x7F"
         "ELF",
         "a program, not points"},
        {"RDX", "data of R; write them by write.csv(x, row.names = FALSE)"},
        {"<!DOCTYPE", "a page of HTML, not a table; was a log-in page saved in its place?"},
        {"<!doctype", "a page of HTML, not a table; was a log-in page saved in its place?"},
        {"<html", "a page of HTML, not a table; was a log-in page saved in its place?"},
        {"<?xml", "an XML file; write its points as a table in text"},
        {"<VTKFile", "a VTK file; write its points as .ply or as a table in text"},
        {"# vtk DataFile", "a VTK file; write its points as .ply or as a table in text"},
        {"$MeshFormat", "a mesh of Gmsh; write its vertices as a table in text"},
        {"MeshVersionFormatted", "a mesh of Medit; write its vertices as a table in text"},
        {"# .PCD", "a point cloud of PCL; write it as .ply: pcl_pcd2ply"},
        {"VERSION .7", "a point cloud of PCL; write it as .ply: pcl_pcd2ply"},
        {"{\\rtf", "a document (RTF), not text; save it as plain text"},
        {"{", "JSON, not a table; write rows of numbers"},
        {"[[", "brackets around rows; write plain rows of numbers, as numpy.savetxt does, without brackets"},
        {"data_", "an mmCIF file; write its atoms as .pdb or .xyz"},
        {"ITEM: ", "a dump of LAMMPS; write x, y and z of its atoms as a table in text"},
        {"LAMMPS ", "a data file of LAMMPS; write x, y and z of its atoms as a table in text"},
        {"%%MatrixMarket", "a matrix of MatrixMarket; write it as .npy, or its rows as a table in text"},
        {"@<TRIPOS>", "a MOL2 file; write its atoms as .pdb or .xyz"},
        {"# Name: ", "a MOL2 file; write its atoms as .pdb or .xyz"},
        {"version https://git-lfs", "a pointer of git-lfs, not the file itself: git lfs pull"},
    };
    if (starts(content, "\xEF\xBB\xBF")) content.remove_prefix(3);
    for (const auto& mark : marks)
        if (starts(content, mark.start)) return mark.what;
    const std::string_view top = content.substr(0, 1000);
    if (top.find(" V2000") != std::string_view::npos || top.find(" V3000") != std::string_view::npos)
        return "an SDF or MOL file; write its atoms as .pdb or .xyz";
    if (is_poscar(content)) return "a POSCAR file of VASP; write its atoms as .xyz";
    if (is_gro(content)) return "a GRO file of GROMACS; write its atoms as .pdb";
    return {};
}

bool is_table_ending(const std::string& ending) {
    for (const char* known : {".npy", ".npz", ".off", ".ply", ".node", ".obj", ".stl", ".pdb", ".ent", ".pqr"})
        if (ending == known) return false;
    return true;
}

// A file on its way to points: what it is called, what it holds and how that is read.
struct Source {
    std::string name;    // for messages
    std::string ending;  // behind it no .gz
    std::string array;   // of FILE.npz:NAME
    std::string content;
};

Outcome line_of_byte(const Source& source, std::size_t at, const std::string& complaint) {
    const auto stop = source.content.begin() + static_cast<std::ptrdiff_t>(at);
    return line_error(source.name, 1 + static_cast<std::uint64_t>(std::count(source.content.begin(), stop, '\n')),
                      complaint);
}

// Settles the ending of *source by what it holds.
Outcome settle(bool packed, Source* source) {
    const std::string& content = source->content;
    std::string& ending = source->ending;
    if (ending == ".gz" && !packed)
        return file_error(source->name, "not compressed by gzip (bytes 0 and 1): take .gz off its name");
    if (ending == ".gz") ending = ending_of(source->name.substr(0, source->name.size() - 3));
    const Format found = format_of(content);
    if (*found.ending != 0 && (ending.empty() || ending == ".dat")) ending = found.ending;
    const bool pdb = std::string(found.ending) == ".pdb" && (ending == ".ent" || ending == ".pqr");
    if (*found.ending != 0 && ending != found.ending && !pdb)
        return file_error(source->name, std::string("holds ") + found.called + ", which its ending " + ending +
                                            " does not say: name it " + found.ending);
    if (*found.ending != 0 || content.empty()) return {};
    const std::string other = foreign(content);
    if (!other.empty()) return line_error(source->name, 1, other);
    if (ending == ".npy" || ending == ".npz")
        return file_error(source->name, std::string("not a NumPy ") + (ending == ".npy" ? "array" : "archive") +
                                            " (bytes 0 to 5); if it is text, name it .txt or .csv");
    if (!is_table_ending(ending)) return {};
    const bool wide = starts(content, "\xFF\xFE") || starts(content, "\xFE\xFF");
    const std::size_t zero = wide ? std::string::npos : content.find('\0');
    if (zero == std::string::npos) return {};
    return line_of_byte(*source, zero,
                        "byte " + std::to_string(zero) +
                            " is 0, so this is no text; numbers in binary are read from .npy, wide characters from "
                            "UTF-16 with its byte-order mark");
}

Outcome read_source(const std::string& path, Source* source) {
    std::string file = path;
    const std::size_t colon = path.rfind(".npz:");
    if (colon != std::string::npos) {
        file = path.substr(0, colon + 4);
        source->array = path.substr(colon + 5);
    }
    source->name = shown_name(file);
    bool packed = false;
    const Outcome outcome = read_content(file, &source->content, &packed);
    if (!outcome.good()) return outcome;
    source->ending = file == "-" ? std::string() : ending_of(file);
    return settle(packed, source);
}

// Whether atoms come with radii, which is all that can be had besides places: --radii radius of .pqr, else vdw.
Outcome check_weights(const Source& source, const TableOptions& options, bool are_atoms) {
    if (options.weights.empty()) return {};
    const bool has_own = source.ending == ".pqr";
    const std::string due = has_own ? "radius" : "vdw";
    if (are_atoms && options.are_radii && options.weights == due) return {};
    return usage_error(weights_option(options) + ": " + source.name +
                       (!are_atoms ? " has no such column; a table or array may have one"
                        : has_own  ? " has radii of its own: --radii radius"
                                   : " has elements and no such column: --radii vdw, or a table with a column"));
}

Outcome parse_surface(const Source& source, bool with_radii, PointCloud* cloud) {
    if (source.ending == ".off") return parse_off_points(source.content, cloud);
    if (source.ending == ".ply") return parse_ply_points(source.content, cloud);
    if (source.ending == ".node") return parse_node_points(source.content, cloud);
    if (source.ending == ".obj") return parse_obj_points(source.content, cloud);
    if (source.ending == ".stl") return parse_stl_points(source.content, cloud);
    if (source.ending == ".pqr") return parse_pqr_atoms(source.content, with_radii, cloud);
    if (source.ending == ".pdb" || source.ending == ".ent") return parse_pdb_atoms(source.content, with_radii, cloud);
    return parse_xyz_atoms(source.content, with_radii, cloud);
}

// Options that say how a text is read.
bool is_of_text(const TableOptions& options) {
    return options.delimiter != 0 || options.skip != 0 || options.drop_missing;
}

// A list of atoms where a table could be.
bool has_atoms(const Source& source, const TableOptions& options) {
    return is_table_ending(source.ending) && (source.ending == ".xyz" || source.ending.empty()) &&
           !is_of_text(options) && options.columns.empty() && is_chemical_xyz(source.content);
}

// Tables, whatever their width; everything else becomes one.
Outcome parse_source(const Source& source, const TableOptions& options, Table* table) {
    table->name = source.name;
    const bool array = source.ending == ".npy" || source.ending == ".npz";
    const bool text = is_table_ending(source.ending) && !has_atoms(source, options);
    if (is_of_text(options) && !text)
        return usage_error("--delimiter, --skip and --drop-missing are for tables in text, not for " + source.name);
    if (text) {
        const Outcome outcome = parse_table(source.content, options, table);
        if (outcome.good() && source.ending == ".xyz" && table->width > 3 && options.columns.empty() &&
            table->note.find("coordinates, too") == std::string::npos)
            table->note += (table->note.empty() ? "" : "; ") + std::string("took all ") + std::to_string(table->width) +
                           " columns for coordinates; --columns 1-3 takes x, y, z alone";
        return outcome;
    }
    if (source.ending == ".npy") return parse_npy_table(source.content, options, table);
    if (array) return parse_npz_table(source.content, source.array, options, table);
    if (!options.columns.empty()) return usage_error("--columns is for tables and arrays, not for " + source.name);
    const bool is_surface = source.ending == ".off" || source.ending == ".ply" || source.ending == ".node" ||
                            source.ending == ".obj" || source.ending == ".stl";
    Outcome outcome = check_weights(source, options, !is_surface);
    if (!outcome.good()) return outcome;
    PointCloud cloud;
    cloud.name = source.name;
    outcome = parse_surface(source, !options.weights.empty(), &cloud);
    table->has_weights = !options.weights.empty();
    table->width = cloud.dim + table->has_weights;
    table->values = std::move(cloud.coordinates);
    table->lines = std::move(cloud.lines);
    table->note = std::move(cloud.note);
    if (!cloud.cell.text.empty() && options.lattice.kind == Lattice::none)
        table->note +=
            ", without its periodic cell: atoms near opposite sides are far apart; persist --cell file takes it";
    table->cell = std::move(cloud.cell);
    return outcome;
}

// The lattice that is asked for, with that of the file where it is that.
Outcome take_lattice(const Lattice& asked, PointCloud* cloud) {
    Lattice& lattice = cloud->lattice = asked;
    if (asked.kind == Lattice::none) return {};
    const std::string option = asked.option();
    if (asked.kind == Lattice::file) {
        const FileCell& cell = cloud->cell;
        if (cell.text.empty())
            return usage_error("--cell file: " + cloud->name +
                               " has no periodic cell, Lattice=\"...\" of extended .xyz or CRYST1 of .pdb with sides "
                               "above 1; --cell takes its vectors");
        const std::string complaint = parse_file_cell(cell.text, &lattice);
        if (!complaint.empty()) return line_error(cloud->name, cell.line, "--cell file: " + complaint);
    }
    if (lattice.dim != cloud->dim)
        return usage_error(option + " " + lattice.text + ": is in " + std::to_string(lattice.dim) + " dimensions, " +
                           cloud->name + " in " + std::to_string(cloud->dim) +
                           "; a direction without a period has a dash");
    const std::uint64_t outside = points_outside(lattice, cloud->coordinates);
    if (outside > 0)
        cloud->note += (cloud->note.empty() ? "" : "; ") +
                       counted(outside, "point stands for its copy", "points stand for their copies") + " inside the " +
                       (lattice.kind == Lattice::box ? "box" : "cell");
    if (outside > cloud->rows() / 2) cloud->has_slip = true;  // another box is meant, it may be
    return {};
}

}  // namespace

std::string remedy_for_condensed(std::uint64_t count) {
    std::uint64_t n = 4;
    while (n * (n - 1) / 2 < count && n < 65536) n++;
    if (n * (n - 1) / 2 != count) return {};
    return "; " + grouped_text(count) + " numbers may be the distances of " + grouped_text(n) +
           " points, which persist --distances reads";
}

Outcome read_table(const std::string& path, const TableOptions& options, Table* table) {
    *table = {};
    Source source;
    const Outcome outcome = read_source(path, &source);
    return outcome.good() ? parse_source(source, options, table) : outcome;
}

Outcome read_numbers(const std::string& path, Table* table, std::string* text) {
    *table = {};
    Source source;
    const Outcome outcome = read_source(path, &source);
    table->name = source.name;
    if (!outcome.good()) return outcome;
    TableOptions options;
    options.distances = true;
    if (source.ending == ".npy") return parse_npy_table(source.content, options, table);
    if (source.ending == ".npz") return parse_npz_table(source.content, source.array, options, table);
    if (!is_table_ending(source.ending))
        return file_error(source.name, "distances are read from a table in text, .npy or .npz");
    *text = std::move(source.content);
    return {};
}

Outcome read_points(const std::string& path, const TableOptions& options, PointCloud* cloud,
                    std::uint32_t columns_max) {
    *cloud = {};
    Table table;
    Outcome outcome = read_table(path, options, &table);
    if (outcome.good()) outcome = take_table(std::move(table), cloud, columns_max);
    if (outcome.good() && options.are_radii) outcome = check_radii(*cloud);
    return outcome.good() ? take_lattice(options.lattice, cloud) : outcome;
}

Outcome PointStream::begin(const Table& table) {
    PointCloud cloud;
    const Outcome outcome = take_table(table, &cloud);
    dim_ = cloud.dim;
    return outcome;
}

Outcome open_stream(const std::string& path, const TableOptions& options, std::unique_ptr<PointStream>* stream,
                    std::uint64_t head_bytes) {
    auto file = std::make_unique<platform::InputFile>();
    std::string why;
    if (path == "-" || path.rfind(".npz:") != std::string::npos || !file->open(path, &why)) return {};
    Source source;
    source.name = path;
    source.ending = ending_of(path);
    source.content.resize(static_cast<std::size_t>(std::min(file->bytes(), head_bytes)));
    if (!file->read(0, &source.content[0], source.content.size(), &why)) return {};
    // What is packed, or at odds with its name, is left to the reader of the whole.
    if (source.content.compare(0, 2, "\x1F\x8B") == 0 || !settle(false, &source).good()) return {};
    const bool in_text = is_of_text(options);
    if (source.ending == ".npy" && !in_text)
        return open_npy_stream(source.content, source.name, options, std::move(file), stream);
    if (source.ending == ".ply" && !in_text && options.columns.empty())
        return open_ply_stream(source.content, source.name, std::move(file), stream);
    if (!is_table_ending(source.ending) || has_atoms(source, options)) return {};
    return open_table_stream(source.content, source.name, options, std::move(file), stream);
}

namespace {

// A square of at least three rows with 0 on its diagonal and equal halves, none below 0.
bool looks_like_distances(const Table& table) {
    const std::size_t n = table.width;
    if (table.has_weights || n < 3 || table.rows() != n) return false;
    for (std::size_t i = 0; i < n; i++) {
        if (table.values[i * n + i] != 0) return false;
        for (std::size_t j = 0; j < i; j++)
            if (table.values[i * n + j] != table.values[j * n + i] || table.values[i * n + j] < 0) return false;
    }
    return true;
}

}  // namespace

Outcome take_table(Table table, PointCloud* cloud, std::uint32_t columns_max) {
    cloud->name = table.name;
    const std::size_t width = table.width - table.has_weights;
    const bool of_distances = looks_like_distances(table);
    if (width < dim_min || width > columns_max) {
        const std::string complaint =
            counted(width, "column", "columns") + (table.has_weights ? " besides that of weights" : "") +
            (columns_max > dim_max ? "; points have 2 to 65,536 coordinates here" : "; points have 2 to 6 coordinates");
        if (of_distances)
            return file_error(table.name, complaint +
                                              "; a matrix of distances, as this looks like one, is read by persist "
                                              "--distances");
        if (table.lines.empty())
            return file_error(table.name, complaint + (width == 1 ? remedy_for_condensed(table.rows()) : ""));
        return line_error(table.name, table.lines[0],
                          complaint + (table.columns >= dim_min + table.has_weights && width < dim_min
                                           ? "; --columns chooses more"
                                       : width < dim_min ? "; --delimiter says what stands between them; of a series "
                                                           "delays make points, as the guide says" +
                                                               remedy_for_condensed(table.rows())
                                                         : "; --columns chooses some"));
    }
    cloud->dim = static_cast<std::uint32_t>(width);
    if (table.has_weights) {
        std::vector<double>& values = table.values;
        const std::size_t rows = table.rows();
        cloud->weights.reserve(rows);
        for (std::size_t i = 0; i < rows; i++) {
            cloud->weights.push_back(values[i * table.width + width]);
            for (std::size_t k = 0; k < width; k++) values[i * width + k] = values[i * table.width + k];
        }
        values.resize(rows * width);
    }
    cloud->coordinates = std::move(table.values);
    cloud->lines = std::move(table.lines);
    cloud->cell = std::move(table.cell);
    cloud->note = std::move(table.note);
    cloud->has_slip = table.has_slip;
    if (of_distances) {
        cloud->has_slip = true;
        cloud->note += (cloud->note.empty() ? "" : "; ") +
                       std::string("took a matrix that looks like distances for coordinates; persist --distances "
                                   "takes it for distances");
    }
    return {};
}

Outcome check_radii(const PointCloud& cloud) {
    for (std::size_t i = 0; i < cloud.weights.size(); i++)
        if (cloud.weights[i] < 0)
            return cloud.fault(i, "radius " + number_text(cloud.weights[i]) +
                                      "; radii are 0 or more, --weights takes squares of any sign");
    return {};
}

Outcome parse_text_points(std::string_view content, const TableOptions& options, PointCloud* cloud) {
    Table table;
    table.name = cloud->name;
    const Outcome outcome = parse_table(content, options, &table);
    return outcome.good() ? take_table(std::move(table), cloud) : outcome;
}

}  // namespace netmesh::tool
