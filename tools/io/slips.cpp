#include "tools/io/slips.hpp"

#include <algorithm>
#include <cmath>

#include "tools/io/characters.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"

namespace netmesh::tool {

std::string ranges_text(const std::vector<std::size_t>& numbers) {
    std::string text;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t end = i + 1;
        while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) end++;
        if (end - i < 3) end = i + 1;
        text += (i > 0 ? "," : "") + std::to_string(numbers[i]);
        if (end - i > 1) text += "-" + std::to_string(numbers[end - 1]);
        i = end;
    }
    return text;
}

namespace {

// The words of a name in lower case: sampleID, sample_id and "Sample ID" have the same two.
std::vector<std::string> words_of(const std::string& name) {
    std::vector<std::string> words(1);
    for (std::size_t i = 0; i < name.size(); i++) {
        const char c = name[i];
        const bool is_upper = c >= 'A' && c <= 'Z', was_lower = i > 0 && name[i - 1] >= 'a' && name[i - 1] <= 'z';
        if (!is_letter(c) || (is_upper && was_lower)) words.emplace_back();
        if (is_letter(c)) words.back() += is_upper ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return words;
}

bool has_word(const std::string& name, std::initializer_list<const char*> due) {
    const std::vector<std::string> words = words_of(name);
    return std::any_of(due.begin(), due.end(),
                       [&](const char* word) { return std::find(words.begin(), words.end(), word) != words.end(); });
}

bool is_place(const std::string& lower) { return lower == "x" || lower == "y" || lower == "z"; }

// t, u, v, w and x1 to x9 go on where x, y and z end.
bool is_like_place(const std::string& lower) {
    const bool is_letter = lower.size() == 1 && lower.find_first_of("tuvwxyz") == 0;
    return is_letter || (lower.size() == 2 && lower[0] == 'x' && is_digit(lower[1]));
}

bool names_no_coordinate(const std::string& name) {
    return has_word(name, {"id",       "ids",      "uid",    "fid",    "objectid", "pointid",
                           "idx",      "index",    "label",  "labels", "class",    "classification",
                           "cluster",  "category", "target", "flag",   "time",     "timestamp",
                           "datetime", "date",     "year",   "frame",  "intensity"});
}

class Slips {
public:
    Slips(const TakenColumns& taken, const std::vector<double>& values, std::size_t stride)
        : taken_(taken), values_(values), stride_(stride), rows_(stride == 0 ? 0 : values.size() / stride) {}

    std::vector<std::string> find() {
        if (!taken_.chosen) find_other_names();
        if (!taken_.chosen) find_counting_column();
        if (!taken_.chosen) find_times();
        find_degrees();
        find_missing();
        return sentences_;
    }

private:
    std::size_t count() const { return taken_.columns.size(); }
    double at(std::size_t row, std::size_t k) const { return values_[row * stride_ + k]; }
    template <class Fits> bool all_fit(std::size_t k, Fits fits) const {
        for (std::size_t i = 0; i < rows_; i++)
            if (!fits(i, at(i, k))) return false;
        return true;
    }
    std::string called(std::size_t k) const {
        return taken_.names.empty() || taken_.names[k].empty() ? "column " + std::to_string(taken_.columns[k] + 1)
                                                               : quoted(taken_.names[k]);
    }
    bool is_other(std::size_t k) const { return std::find(others_.begin(), others_.end(), k) != others_.end(); }

    // "; --columns 1,2 leaves it out", where two columns are left.
    std::string without(const std::vector<std::size_t>& left_out, bool by_name) const {
        std::vector<std::size_t> numbers;
        std::string names;
        for (std::size_t k = 0; k < count(); k++) {
            if (std::find(left_out.begin(), left_out.end(), k) != left_out.end()) continue;
            numbers.push_back(taken_.columns[k] + 1);
            if (!by_name) continue;
            const std::string& name = taken_.names[k];
            by_name = name.find_first_of(",\"' ") == std::string::npos && !name.empty() &&
                      std::count(taken_.names.begin(), taken_.names.end(), name) == 1;
            names += (names.empty() ? "" : ",") + name;
        }
        if (numbers.size() < 2) return "";
        return "; --columns " + (by_name ? names : ranges_text(numbers)) +
               (left_out.size() == 1 ? " leaves it out" : " leaves them out");
    }

    // x, y, maybe z, and then something else; or a name that says itself that it is something else.
    void find_other_names() {
        if (taken_.names.empty()) return;
        std::vector<std::string> lower;
        for (const std::string& name : taken_.names) lower.push_back(lower_case(name));
        const auto has = [&](const char* name) { return std::find(lower.begin(), lower.end(), name) != lower.end(); };
        const bool has_places = has("x") && has("y");
        std::string called_so;
        for (std::size_t k = 0; k < count(); k++) {
            const bool is_foreign = has_places && !is_place(lower[k]) && !is_like_place(lower[k]);
            if (!is_foreign && !names_no_coordinate(taken_.names[k])) continue;
            others_.push_back(k);
            called_so += (called_so.empty() ? "" : ", ") + called(k);
        }
        if (others_.size() == count()) others_.clear();
        if (!others_.empty())
            sentences_.push_back("took " + called_so + " for " +
                                 (others_.size() == 1 ? "a coordinate" : "coordinates") + ", too" +
                                 without(others_, true));
    }

    // 7, 8, 9, ...
    void find_counting_column() {
        if (count() < 3 || rows_ < 5) return;
        std::vector<std::size_t> found;
        for (std::size_t k = 0; k < count(); k++)
            if (is_count(at(0, k)) &&
                all_fit(k, [&](std::size_t i, double x) { return x == at(0, k) + static_cast<double>(i); }))
                found.push_back(k);
        if (found.size() == 1 && !is_other(found[0]))
            sentences_.push_back("took " + called(found[0]) + ", which counts rows, for a coordinate" +
                                 without(found, !taken_.names.empty()));
    }

    void find_times() {
        if (rows_ < 2) return;
        for (std::size_t k = 0; k < count(); k++) {
            if (is_other(k)) continue;
            const char* what = nullptr;
            constexpr struct {
                double scale;
                const char* what;
            } kinds[] = {{1, "seconds since 1970"},
                         {1e3, "milliseconds since 1970"},
                         {1e6, "microseconds since 1970"},
                         {1e9, "nanoseconds since 1970"}};
            for (const auto& kind : kinds)  // from 2001 to 2037
                if (all_fit(k, [&](std::size_t, double x) { return x >= 1e9 * kind.scale && x < 2.13e9 * kind.scale; }))
                    what = kind.what;
            if (all_fit(k, [](std::size_t, double x) { return is_date(x); })) what = "dates, as 20240131";
            if (what != nullptr)
                sentences_.push_back("took " + called(k) + ", which looks like " + what + ", for a coordinate" +
                                     without({k}, !taken_.names.empty()));
        }
    }
    static bool is_date(double x) {
        if (!(x >= 19000101 && x <= 21001231) || x != std::floor(x)) return false;
        const int day = static_cast<int>(x) % 100, month = static_cast<int>(x) / 100 % 100;
        return day >= 1 && day <= 31 && month >= 1 && month <= 12;
    }

    void find_degrees() {
        std::size_t latitude = count(), longitude = count();
        for (std::size_t k = 0; k < taken_.names.size(); k++) {
            if (has_word(taken_.names[k], {"lat", "latitude"})) latitude = k;
            if (has_word(taken_.names[k], {"lon", "lng", "long", "longitude"})) longitude = k;
        }
        if (latitude == count() || longitude == count() || latitude == longitude) return;
        if (!all_fit(latitude, [](std::size_t, double x) { return std::abs(x) <= 90; }) ||
            !all_fit(longitude, [](std::size_t, double x) { return std::abs(x) <= 360; }))
            return;
        sentences_.push_back(called(latitude) + " and " + called(longitude) +
                             " look like degrees, of which a degree east is shorter than one north: project them to "
                             "metres first");
    }

    // A number by which instruments and models write that there is none, beyond all others of its column.
    void find_missing() {
        constexpr double marks[] = {-99,
                                    -999,
                                    -9999,
                                    -99999,
                                    -999999,
                                    -999.25,
                                    -32768,
                                    -2147483648.0,
                                    9999,
                                    99999,
                                    999999,
                                    32767,
                                    1e20,
                                    -1e20,
                                    1e30,
                                    -1e30,
                                    1e36,
                                    9.969209968386869e36,
                                    -3.4028234663852886e38,
                                    3.4028234663852886e38};
        const auto is_mark = [&](double x) {
            return std::find(std::begin(marks), std::end(marks), x) != std::end(marks);
        };
        for (std::size_t k = 0; k < count(); k++) {
            double low = HUGE_VAL, high = -HUGE_VAL, mark = 0;
            std::size_t others = 0;
            for (std::size_t i = 0; i < rows_; i++) {
                const double x = at(i, k);
                if (is_mark(x)) {
                    mark = x;
                    continue;
                }
                others++;
                low = std::min(low, x);
                high = std::max(high, x);
            }
            const double away = std::max(low - mark, mark - high);
            if (mark == 0 || others < 2 || away < high - low || away < std::abs(mark) / 2) continue;
            sentences_.push_back(called(k) + " holds " + number_text(mark) +
                                 ", far from its other numbers: if it stands for a missing value, take such rows out "
                                 "of the file");
        }
    }

    const TakenColumns& taken_;
    const std::vector<double>& values_;
    const std::size_t stride_, rows_;
    std::vector<std::size_t> others_;  // whose names say that they are something else
    std::vector<std::string> sentences_;
};

}  // namespace

std::vector<std::string> slips_of(const TakenColumns& taken, const std::vector<double>& values, std::size_t stride) {
    return Slips(taken, values, stride).find();
}

}  // namespace netmesh::tool
