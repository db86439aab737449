#include "mesh_file.hpp"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace referee {
namespace {

bool numbers_of(const std::string& text, std::vector<double>* numbers) {
    numbers->clear();
    const char* at = text.c_str();
    while (true) {
        while (*at == ' ' || *at == '\t' || *at == '\r') at++;
        if (*at == 0) return true;
        char* end = nullptr;
        const double x = std::strtod(at, &end);
        if (end == at || !std::isfinite(x)) return false;
        numbers->push_back(x);
        at = end;
    }
}

bool is_index(double x, std::size_t limit) { return x >= 0 && x < static_cast<double>(limit) && std::floor(x) == x; }

std::string keep_remark(const std::string& line, Mesh* mesh, std::vector<double>* domain) {
    std::istringstream words(line.substr(1));
    std::string name, rest;
    words >> name;
    std::getline(words, rest);
    std::vector<double> numbers;
    if (name == "cages") {
        mesh->thesis_cages = true;
        return rest == " thesis" ? "" : "cages of an unknown kind: " + line;
    }
    if (name == "clipped") {
        mesh->clipped = true;
        return rest.empty() && mesh->ratio > 0 ? "" : "clipped, and not behind a ratio: " + line;
    }
    if (name != "domain" && name != "tau" && name != "ratio" && name != "eps" && name != "cell-size" &&
        name != "cage" && name != "boundary-net")
        return {};
    if (!numbers_of(rest, &numbers) || numbers.empty()) return "a remark without numbers: " + line;
    if (name == "domain") {
        *domain = numbers;
    } else if (name == "cage") {
        if (numbers.size() != 2 || !is_index(numbers[0], outside)) return "a cage that is none: " + line;
        mesh->cages.push_back({static_cast<std::uint32_t>(numbers[0]), numbers[1]});
    } else if (name == "cell-size") {
        if (numbers.size() != 2) return "a cell-size that is none: " + line;
        mesh->least_size = numbers[0];
        mesh->growth = numbers[1];
    } else {
        (name == "tau"     ? mesh->tau
         : name == "ratio" ? mesh->ratio
         : name == "eps"   ? mesh->eps
                           : mesh->net) = numbers[0];
    }
    return {};
}

std::string read_node(const std::string& path, Mesh* mesh) {
    std::ifstream file(path);
    if (!file) return "cannot read " + path;
    std::string line;
    std::vector<double> numbers, domain;
    std::size_t count = 0, attributes = 0, marked = 0;
    bool headed = false;
    while (std::getline(file, line)) {
        if (line.empty()) continue;
        if (line[0] == '#') {
            const std::string fault = keep_remark(line, mesh, &domain);
            if (!fault.empty()) return fault;
            continue;
        }
        if (!numbers_of(line, &numbers)) return "not numbers: " + line;
        if (!headed) {
            if (numbers.size() != 4 || numbers[1] < 2 || numbers[1] > dim_max) return "a header of .node: " + line;
            headed = true;
            count = static_cast<std::size_t>(numbers[0]);
            mesh->dim = static_cast<int>(numbers[1]);
            attributes = static_cast<std::size_t>(numbers[2]);
            marked = static_cast<std::size_t>(numbers[3]);
            if (attributes > 1 || marked != 1) return "one attribute at most and a marker are due";
            continue;
        }
        if (numbers.size() != 2 + static_cast<std::size_t>(mesh->dim) + attributes) return "a row of .node: " + line;
        if (numbers[0] != static_cast<double>(mesh->count())) return "an id out of order: " + line;
        Point x = {};
        for (int k = 0; k < mesh->dim; k++) x[k] = numbers[1 + k];
        mesh->vertices.push_back(x);
        if (attributes == 1) mesh->values.push_back(numbers[numbers.size() - 2]);
        if (!is_index(numbers.back(), 3)) return "a marker that is none: " + line;
        mesh->markers.push_back(static_cast<int>(numbers.back()));
    }
    if (!headed || mesh->count() != count) return path + " has not as many vertices as it says";
    if (domain.empty()) return {};
    if (domain.size() != static_cast<std::size_t>(mesh->dim) + 1) return "a domain of another dimension";
    mesh->has_domain = true;
    for (int k = 0; k < mesh->dim; k++) mesh->centre[k] = domain[k];
    mesh->radius = domain.back();
    return {};
}

std::string read_table(const std::string& path, int columns, std::size_t limit, bool may_be_outside,
                       std::vector<Entries>* rows) {
    std::ifstream file(path);
    if (!file) return "cannot read " + path;
    std::string line;
    std::vector<double> numbers;
    std::size_t count = 0;
    bool headed = false;
    while (std::getline(file, line)) {
        if (line.empty() || line[0] == '#') continue;
        if (!numbers_of(line, &numbers)) return "not numbers: " + line;
        if (!headed) {
            if (numbers.size() < 2 || numbers[1] != columns) return path + ": header " + line;
            count = static_cast<std::size_t>(numbers[0]);
            if (may_be_outside) limit = count;
            headed = true;
            continue;
        }
        if (numbers.size() != static_cast<std::size_t>(columns) + 1 || numbers[0] != static_cast<double>(rows->size()))
            return path + ": row " + line;
        Entries row = {};
        for (int k = 0; k < columns; k++) {
            const double x = numbers[1 + k];
            if (may_be_outside && x == -1) {
                row[k] = outside;
            } else if (is_index(x, limit)) {
                row[k] = static_cast<std::uint32_t>(x);
            } else {
                return path + ": an index that does not exist: " + line;
            }
        }
        rows->push_back(row);
    }
    return headed && rows->size() == count ? "" : path + " has not as many rows as it says";
}

void write_table(const std::string& path, const std::vector<Entries>& rows, int columns, const char* end) {
    std::ofstream out(path);
    out << rows.size() << ' ' << columns << end << '\n';
    for (std::size_t i = 0; i < rows.size(); i++) {
        out << i;
        for (int k = 0; k < columns; k++) {
            rows[i][k] == outside ? out << " -1" : out << ' ' << rows[i][k];
        }
        out << '\n';
    }
}

}  // namespace

std::string read_mesh(const std::string& stem, Mesh* mesh) {
    *mesh = {};
    std::string fault = read_node(stem + ".node", mesh);
    if (fault.empty()) fault = read_table(stem + ".ele", mesh->dim + 1, mesh->count(), false, &mesh->cells);
    if (fault.empty()) fault = read_table(stem + ".neigh", mesh->dim + 1, 0, true, &mesh->neighbours);
    if (fault.empty() && mesh->neighbours.size() != mesh->cells.size()) fault = "another number of neighbours";
    return fault;
}

void write_mesh(const std::string& stem, const Mesh& mesh) {
    std::ofstream out(stem + ".node");
    out.precision(17);
    if (mesh.has_domain) {
        out << "# domain";
        for (int k = 0; k < mesh.dim; k++) out << ' ' << mesh.centre[k];
        out << ' ' << mesh.radius << '\n';
        if (mesh.tau > 0) out << "# tau " << mesh.tau << '\n';
        if (mesh.ratio > 0) out << "# ratio " << mesh.ratio << '\n';
        if (mesh.clipped) out << "# clipped\n";
        if (mesh.eps > 0) out << "# eps " << mesh.eps << '\n';
        if (mesh.least_size > 0) out << "# cell-size " << mesh.least_size << ' ' << mesh.growth << '\n';
        if (mesh.net > 0) out << "# boundary-net " << mesh.net << '\n';
        if (mesh.thesis_cages) out << "# cages thesis\n";
        for (const CageLine& cage : mesh.cages) out << "# cage " << cage.centre << ' ' << cage.radius << '\n';
    }
    const bool valued = !mesh.values.empty();
    out << mesh.count() << ' ' << mesh.dim << (valued ? " 1 1\n" : " 0 1\n");
    for (std::size_t v = 0; v < mesh.count(); v++) {
        out << v;
        for (int k = 0; k < mesh.dim; k++) out << ' ' << mesh.vertices[v][k];
        if (valued) out << ' ' << mesh.values[v];
        out << ' ' << mesh.markers[v] << '\n';
    }
    write_table(stem + ".ele", mesh.cells, mesh.dim + 1, " 0");
    write_table(stem + ".neigh", mesh.neighbours, mesh.dim + 1, "");
}

void write_points(const std::string& path, const std::vector<Point>& points, int dim) {
    std::ofstream out(path);
    out.precision(17);
    for (const Point& p : points)
        for (int k = 0; k < dim; k++) out << p[k] << (k + 1 < dim ? ' ' : '\n');
}

}  // namespace referee
