// Random tables, written in every dialect that is read, come back as they were; and a table is never read as another.
#include <doctest/doctest.h>

#include <random>

#include "tools/io/numbers.hpp"
#include "tools/io/points.hpp"

using namespace netmesh::tool;

namespace {

struct Random {
    std::mt19937_64 bits;
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(bits() % n); }
    bool yes() { return below(2) == 1; }
    template <class T> const T& of(const std::vector<T>& list) { return list[below(list.size())]; }
};

// Digits enough that no number can be one of thousands, or whole where the table is.
double random_number(Random& random, bool whole) {
    const double size = static_cast<double>(static_cast<std::int64_t>(random.below(2000001)) - 1000000);
    if (whole) return size;
    const double places[] = {10, 1e4, 1e7, 1e-12, 1e18};
    return size / places[random.below(5)] + 0.0;
}

struct Dialect {
    std::string delimiter, end, comment, quote;
    bool decimal_comma = false, padded = false, trailing = false, mark = false, last_end = true;
    int header = 0;  // 1: names, 2: names behind a #, 3: of pandas, with an index, 4: of R, one name too few
};

Dialect random_dialect(Random& random) {
    Dialect dialect;
    dialect.decimal_comma = random.below(3) == 0;
    const std::vector<std::string> of_points = {",", ";", "\t", " ", "|", ", ", " ; ", "   ", " | "};
    const std::vector<std::string> of_commas = {";", "\t", "|", "; ", " | "};
    dialect.delimiter = random.of(dialect.decimal_comma ? of_commas : of_points);
    dialect.end = random.of(std::vector<std::string>{"\n", "\r\n", "\r"});
    dialect.quote = random.below(4) == 0 ? "\"" : "";
    dialect.padded = random.yes();
    const bool blanks = dialect.delimiter.find_first_not_of(' ') == std::string::npos;
    dialect.trailing = !blanks && random.below(4) == 0;
    dialect.mark = random.below(4) == 0;
    dialect.last_end = random.yes();
    dialect.header = static_cast<int>(random.below(5));
    if (dialect.header == 3 && blanks) dialect.header = 4;
    if (dialect.trailing && dialect.header >= 3) dialect.trailing = false;
    dialect.comment = random.below(4) == 0 ? "# made by hand, on 2024-01-02; all of it" : "";
    return dialect;
}

std::string number_in(const Dialect& dialect, double number) {
    std::string text = number_text(number);
    if (dialect.decimal_comma && text.find('.') != std::string::npos) text[text.find('.')] = ',';
    return dialect.quote + text + dialect.quote;
}

std::string header_of(const Dialect& dialect, std::size_t columns) {
    if (dialect.header == 0) return "";
    std::string text = dialect.header == 2 ? "# " : "";
    if (dialect.header == 3) text += dialect.quote + dialect.quote + dialect.delimiter;
    for (std::size_t k = 0; k < columns; k++)
        text += (k > 0 ? dialect.delimiter : "") + dialect.quote + "x" + std::to_string(k + 1) + dialect.quote;
    if (dialect.trailing) text += dialect.delimiter;
    return text + dialect.end;
}

std::string table_in(const Dialect& dialect, const std::vector<double>& numbers, std::size_t columns) {
    std::string text = dialect.mark ? "\xEF\xBB\xBF" : "";
    if (!dialect.comment.empty()) text += dialect.comment + dialect.end;
    text += header_of(dialect, columns);
    for (std::size_t i = 0; i < numbers.size(); i++) {
        if (i % columns == 0 && dialect.padded && dialect.delimiter[0] != '\t') text += "  ";
        if (i % columns == 0 && dialect.header >= 3)
            text += dialect.quote + std::to_string(i / columns) + dialect.quote + dialect.delimiter;
        text += number_in(dialect, numbers[i]);
        const bool last = (i + 1) % columns == 0;
        if (!last || dialect.trailing) text += dialect.delimiter;
        if (last && (dialect.last_end || i + 1 < numbers.size())) text += dialect.end;
    }
    return text;
}

}  // namespace

TEST_CASE("random tables in every dialect are read back") {
    for (std::uint64_t seed = 1; seed <= 4000; seed++) {
        Random random{std::mt19937_64(seed)};
        const Dialect dialect = random_dialect(random);
        const std::size_t columns = 2 + random.below(5), rows = 4 + random.below(12);
        const bool whole = !dialect.decimal_comma && random.below(5) == 0;
        std::vector<double> numbers;
        for (std::size_t i = 0; i < rows * columns; i++) numbers.push_back(random_number(random, whole));
        numbers[columns] = 0.5;  // a table of commas has one that is decimal, and no first column counts
        numbers[0] = 2.25;
        const std::string text = table_in(dialect, numbers, columns);
        CAPTURE(seed);
        CAPTURE(text);
        PointCloud cloud;
        cloud.name = "p";
        const Outcome outcome = parse_text_points(text, &cloud);
        REQUIRE(outcome.message == "");
        REQUIRE(cloud.dim == columns);
        REQUIRE(cloud.coordinates == numbers);
        REQUIRE((cloud.note.find("header") != std::string::npos) == (dialect.header != 0 && dialect.header != 2));
        REQUIRE((cloud.note.find("index column") != std::string::npos) == (dialect.header >= 3));
        REQUIRE((cloud.note.find("decimal") != std::string::npos) == dialect.decimal_comma);
    }
}

TEST_CASE("tables with a field that is broken are refused on its line, in every dialect") {
    const std::vector<std::string> faults = {"", "x", "nan", "1.2.3", "1e999", "--1", "0x1"};
    for (std::uint64_t seed = 1; seed <= 2000; seed++) {
        Random random{std::mt19937_64(seed)};
        Dialect dialect = random_dialect(random);
        dialect.trailing = false;
        dialect.quote.clear();
        const std::size_t columns = 3, rows = 6, row = 1 + random.below(5);
        const bool blanks = dialect.delimiter.find_first_not_of(' ') == std::string::npos;
        const std::string fault = blanks ? "x" : random.of(faults);
        std::vector<double> numbers(rows * columns, 0.5);
        for (std::size_t i = 0; i < numbers.size(); i++) numbers[i] = 0.5 + static_cast<double>(i);
        numbers[row * columns + 1] = 777777.25;
        std::string text = table_in(dialect, numbers, columns);
        const std::string broken = number_in(dialect, 777777.25);
        text.replace(text.find(broken), broken.size(), fault);
        const std::size_t line = 1 + row + (dialect.comment.empty() ? 0 : 1) + (dialect.header == 0 ? 0 : 1);
        CAPTURE(seed);
        CAPTURE(text);
        PointCloud cloud;
        cloud.name = "p";
        const Outcome outcome = parse_text_points(text, &cloud);
        CAPTURE(outcome.message);
        REQUIRE(outcome.exit == Exit::data);
        REQUIRE(outcome.message.rfind("p:" + std::to_string(line) + ": ", 0) == 0);
    }
}
