#include "tools/io/lattice.hpp"

#include <algorithm>
#include <cmath>

#include "netmesh.h"
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

constexpr std::string_view no_period = "-";
constexpr const char* no_period_at_all = "has no period; write a length or a vector for one of the dashes";

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::size_t from = 0;
    for (std::size_t to; (to = text.find(at, from)) != std::string::npos; from = to + 1)
        parts.push_back(text.substr(from, to - from));
    parts.push_back(text.substr(from));
    return parts;
}

template <class Words> bool parse_all(const Words& words, std::vector<double>* values) {
    values->clear();
    for (const auto& word : words) {
        values->push_back(0);
        if (!parse_finite(std::string(word), &values->back())) return false;
    }
    return true;
}

// "4,0,0/-/0,0,5" of vectors that may be empty, which are left out of the lattice.
void take_vectors(const std::vector<std::vector<double>>& rows, Lattice* lattice) {
    lattice->kind = Lattice::cell;
    lattice->dim = static_cast<std::uint32_t>(rows.size());
    for (const std::vector<double>& row : rows) {
        std::string text = row.empty() ? std::string(no_period) : "";
        for (const double x : row) text += (text.empty() ? "" : ",") + number_text(x);
        lattice->text += (lattice->text.empty() ? "" : "/") + text;
        lattice->vectors.insert(lattice->vectors.end(), row.begin(), row.end());
    }
}

// libm's values of these angles are not exact.
double cosine(double degrees) {
    if (degrees == 90) return 0;
    if (degrees == 60 || degrees == 120) return degrees == 60 ? 0.5 : -0.5;
    return std::cos(degrees * (3.14159265358979323846 / 180));
}
double sine(double degrees) { return degrees == 90 ? 1 : std::sin(degrees * (3.14159265358979323846 / 180)); }

std::string take_sides_and_angles(const std::vector<double>& of, Lattice* lattice) {
    for (std::size_t i = 0; i < 6; i++)
        if (!(of[i] > 0 && (i < 3 || of[i] < 180)))
            return i < 3 ? "side " + number_text(of[i]) + " has to be above 0"
                         : "angle " + number_text(of[i]) + " has to be above 0 and below 180 degrees";
    const double in_b = cosine(of[5]), across_b = sine(of[5]);
    const double x = cosine(of[4]), y = (cosine(of[3]) - x * in_b) / across_b, z2 = 1 - x * x - y * y;
    const double sum = of[3] + of[4] + of[5];
    if (!(2 * std::max({of[3], of[4], of[5]}) < sum && sum < 360 && z2 > 0))
        return "no cell has these angles: each is less than the sum of the two others, and all are less than 360";
    take_vectors({{of[0], 0, 0}, {of[1] * in_b, of[1] * across_b, 0}, {of[2] * x, of[2] * y, of[2] * std::sqrt(z2)}},
                 lattice);
    return {};
}

// An entry of a box, which is one of `axis`, counted from 1.
std::string parse_range(const std::string& entry, std::size_t axis, double* low, double* high) {
    const std::size_t colon = entry.find(':');
    const bool is_range = colon != std::string::npos;
    const std::string name = "entry " + std::to_string(axis) + ", " + quoted(entry) + ", ";
    *low = 0;
    if ((is_range && !parse_finite(entry.substr(0, colon), low)) ||
        !parse_finite(is_range ? entry.substr(colon + 1) : entry, high))
        return name + "is no LO:HI of two finite numbers, no length and no dash";
    if (!(*high > *low)) return name + (is_range ? "has to end above where it begins" : "has to be a length above 0");
    return std::isfinite(*high - *low) ? "" : name + "is longer than the largest double";
}

}  // namespace

std::string parse_box(const std::string& text, Lattice* lattice) {
    *lattice = {};
    const std::vector<std::string> entries = split(text, ',');
    if (entries.size() < dim_min || entries.size() > dim_max)
        return "must have an entry for each axis, LO:HI, a length or a dash where there is no period: 0:10,5,-";
    lattice->kind = Lattice::box;
    lattice->dim = static_cast<std::uint32_t>(entries.size());
    for (std::size_t k = 0; k < entries.size(); k++) {
        const bool repeats = entries[k] != no_period;
        double low = -HUGE_VAL, high = HUGE_VAL;
        const std::string complaint = repeats ? parse_range(entries[k], k + 1, &low, &high) : "";
        if (!complaint.empty()) return complaint;
        lattice->low.push_back(low);
        lattice->high.push_back(high);
        lattice->text += (k > 0 ? "," : "") + (repeats ? number_text(low) + ":" + number_text(high) : entries[k]);
        if (!repeats) continue;
        std::vector<double> vector(entries.size());
        vector[k] = high - low;
        lattice->vectors.insert(lattice->vectors.end(), vector.begin(), vector.end());
    }
    return lattice->count() > 0 ? "" : no_period_at_all;
}

std::string parse_cell(const std::string& text, Lattice* lattice) {
    *lattice = {};
    if (text == "file") {
        lattice->kind = Lattice::file;
        return {};
    }
    const std::vector<std::string> rows = split(text, '/');
    std::vector<double> numbers;
    if (rows.size() == 1 && parse_all(split(text, ','), &numbers) && numbers.size() == 6)
        return take_sides_and_angles(numbers, lattice);
    if (rows.size() < dim_min || rows.size() > dim_max)
        return "must be as many vectors as there are coordinates, 4,0,0/1,4,0/0,0,5, with a dash for one without a "
               "period; or three sides and three angles, 4,4,5,90,90,120; or file";
    std::vector<std::vector<double>> vectors(rows.size());
    for (std::size_t i = 0; i < rows.size(); i++) {
        if (rows[i] == no_period) continue;
        if (!parse_all(split(rows[i], ','), &vectors[i]) || vectors[i].size() != rows.size())
            return "vector " + std::to_string(i + 1) + ", " + quoted(rows[i]) + ", has to be " +
                   std::to_string(rows.size()) + " finite numbers, as many as there are vectors, or a dash";
    }
    take_vectors(vectors, lattice);
    return lattice->count() > 0 ? "" : no_period_at_all;
}

namespace {

// What stands behind `key`= in a line of words, in quotes or up to a blank; *found says whether there is any.
std::string_view value_of(std::string_view line, std::string_view key, bool* found) {
    std::size_t at = line.find(key);
    while (at != std::string_view::npos && at > 0 && line[at - 1] != ' ' && line[at - 1] != '\t')
        at = line.find(key, at + 1);
    *found = at != std::string_view::npos;
    if (!*found) return {};
    std::string_view value = line.substr(at + key.size());
    const char quote = value.empty() ? ' ' : value.front();
    if (quote != '"' && quote != '\'') return value.substr(0, value.find_first_of(" \t"));
    value.remove_prefix(1);
    return value.substr(0, value.find(quote));
}

std::string parse_lattice_of_xyz(std::string_view line, Lattice* lattice) {
    bool found;
    std::vector<double> numbers;
    const std::vector<std::string_view> words = split_blanks(value_of(line, "Lattice=", &found));
    if (!parse_all(words, &numbers) || numbers.size() != 9)
        return "Lattice= has to be nine finite numbers in quotes, three for each vector";
    const std::vector<std::string_view> periods = split_blanks(value_of(line, "pbc=", &found));
    if (found && periods.size() != 1 && periods.size() != 3) return "pbc= has to be T or F for each vector: \"T T F\"";
    std::vector<std::vector<double>> rows(3);
    for (std::size_t i = 0; i < 3; i++) {
        const std::string_view word = !found ? "T" : periods[periods.size() == 3 ? i : 0];
        const bool repeats = word == "T" || word == "True" || word == "true" || word == "1";
        if (!repeats && word != "F" && word != "False" && word != "false" && word != "0")
            return "pbc= has to be T or F for each vector: \"T T F\"";
        if (repeats) rows[i].assign(numbers.begin() + 3 * i, numbers.begin() + 3 * i + 3);
    }
    take_vectors(rows, lattice);
    return lattice->count() > 0 ? "" : "pbc= says that no vector is a period";
}

std::string parse_cell_of_pdb(std::string_view line, Lattice* lattice) {
    static constexpr std::size_t ends[] = {6, 15, 24, 33, 40, 47, 54};  // of columns
    std::vector<std::string_view> fields;
    for (std::size_t i = 0; i < 6 && line.size() > ends[i]; i++)
        for (const std::string_view word : split_blanks(line.substr(ends[i], ends[i + 1] - ends[i])))
            fields.push_back(word);
    std::vector<double> numbers;
    if (!parse_all(fields, &numbers) || numbers.size() != 6)
        return "CRYST1 has to have three sides and three angles in columns 7 to 54";
    return take_sides_and_angles(numbers, lattice);
}

// Coordinates of places by vectors, as far as places are in their span: b_j = sum of along_[i][j] axes_[i], i <= j, the
// axes orthonormal.
class Fractions {
public:
    explicit Fractions(const Lattice& lattice) : dim_(lattice.dim) {
        for (std::uint32_t j = 0; j < lattice.count(); j++) {
            std::vector<double> rest(lattice.vectors.begin() + j * dim_, lattice.vectors.begin() + (j + 1) * dim_);
            std::vector<double> along;
            for (const std::vector<double>& axis : axes_) {
                along.push_back(dot(axis, rest.data()));
                for (std::size_t k = 0; k < dim_; k++) rest[k] -= along.back() * axis[k];
            }
            along.push_back(std::sqrt(dot(rest, rest.data())));
            for (double& x : rest) x /= along.back();
            axes_.push_back(std::move(rest));
            along_.push_back(std::move(along));
        }
    }
    bool is_inside(const double* place) const {
        constexpr double near = 0x1p-40;
        std::vector<double> f(axes_.size());
        for (std::size_t i = axes_.size(); i-- > 0;) {
            f[i] = dot(axes_[i], place);
            for (std::size_t j = i + 1; j < axes_.size(); j++) f[i] -= along_[j][i] * f[j];
            f[i] /= along_[i][i];
        }
        return std::all_of(f.begin(), f.end(), [](double x) { return !(x < -near || x >= 1 - near); });
    }

private:
    double dot(const std::vector<double>& a, const double* b) const {
        double sum = 0;
        for (std::size_t k = 0; k < dim_; k++) sum += a[k] * b[k];
        return sum;
    }

    std::size_t dim_;
    std::vector<std::vector<double>> axes_, along_;
};

}  // namespace

std::string parse_file_cell(std::string_view text, Lattice* lattice) {
    *lattice = {};
    return text.substr(0, 6) == "CRYST1" ? parse_cell_of_pdb(text, lattice) : parse_lattice_of_xyz(text, lattice);
}

std::uint64_t points_outside(const Lattice& lattice, const std::vector<double>& coordinates) {
    const Fractions fractions(lattice);
    std::uint64_t outside = 0;
    for (std::size_t at = 0; at < coordinates.size(); at += lattice.dim) {
        bool inside = true;
        for (std::size_t k = 0; k < lattice.low.size(); k++)
            inside = inside && coordinates[at + k] >= lattice.low[k] && coordinates[at + k] < lattice.high[k];
        outside += !(lattice.low.empty() ? fractions.is_inside(&coordinates[at]) : inside);
    }
    return outside;
}

}  // namespace netmesh::tool
