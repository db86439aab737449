// Points that are read some rows at a time: those that the reader of whole files gives, its notes and its faults.
#include "tools/io/point_stream.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "tools/io/points.hpp"
#include <doctest/doctest.h>

namespace netmesh::tool {
namespace {

struct Read {
    bool streamed = false;  // to the end
    Outcome outcome;
    std::vector<double> rows;
    std::uint32_t dim = 0;
    std::string note;
};

Read stream_of(const std::string& path, const TableOptions& options, std::uint64_t head_bytes) {
    Read read;
    std::unique_ptr<PointStream> stream;
    read.outcome = open_stream(path, options, &stream, head_bytes);
    read.streamed = stream != nullptr || !read.outcome.good();
    if (stream == nullptr) return read;
    read.dim = stream->dim();
    for (std::size_t before = SIZE_MAX; read.outcome.good() && before != read.rows.size();) {
        before = read.rows.size();
        read.outcome = stream->read(&read.rows);
        if (stream->gave_up()) read.streamed = false;
        if (stream->gave_up()) return read;
    }
    read.note = stream->note();
    return read;
}

// Whether it was streamed; if so it has to be what the whole is.
bool is_streamed(const std::string& path, const TableOptions& options = {}, std::uint64_t head_bytes = 200) {
    const Read read = stream_of(path, options, head_bytes);
    if (!read.streamed) return false;
    PointCloud cloud;
    const Outcome whole = read_points(path, options, &cloud);
    CHECK(read.outcome.exit == whole.exit);
    // The beginning alone may be no points; the whole is wrong at another place, too, and that is told first.
    if (read.dim != 0) CHECK(read.outcome.message == whole.message);
    if (!whole.good()) return true;
    CHECK(read.dim == cloud.dim);
    CHECK(read.rows == cloud.coordinates);
    CHECK(read.note == cloud.note);
    return true;
}

class Files {
public:
    Files() {
        char name[] = "/tmp/netmesh-test-XXXXXX";
        folder_ = mkdtemp(name);
    }
    ~Files() { std::filesystem::remove_all(folder_); }
    std::string write(const std::string& name, const std::string& content) const {
        const std::string path = folder_ + "/" + name;
        std::ofstream(path, std::ios::binary) << content;
        return path;
    }

private:
    std::string folder_;
};

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int i = 0; i < times; i++) all += text;
    return all;
}

TEST_CASE("streams: tables of plain numbers") {
    const Files files;
    for (const char* line :
         {"1.5,2\n", "1.5, 2\n", "-1e-3;+.5\r\n", "0\t1.25\n", "  1   2.5 \n", "1 2\n# x\n\n%\n// y\n"})
        CHECK(is_streamed(files.write("a.csv", repeated(line, 100))));
    CHECK(is_streamed(files.write("a.csv", "x,y\n" + repeated("1.5,2\n", 100))));
    CHECK(is_streamed(files.write("a.csv", "\xEF\xBB\xBFx y z\n" + repeated("1.5 2 0\n", 100) + "1 2 3")));
    TableOptions two;
    REQUIRE(parse_columns("z,x", &two.columns).empty());
    CHECK(is_streamed(files.write("a.csv", "x,y,z\n" + repeated("1.5,2,7\n", 100)), two));
    std::string index = "id,x,y\n", gap = index, counted = "x y\n";
    for (int i = 0; i < 100; i++) {
        index += std::to_string(3 * i) + ",1.5,2\n";
        gap += std::to_string(i == 80 ? 70 : i) + ",1.5,2\n";
        counted += std::to_string(i) + " 1.5 2\n";
    }
    CHECK(is_streamed(files.write("a.csv", index)));
    CHECK(is_streamed(files.write("a.csv", counted)));
    CHECK(!is_streamed(files.write("a.csv", gap)));
}

TEST_CASE("streams: what hangs on the whole of a table is left to who reads it whole") {
    const Files files;
    const std::string lines = repeated("1.5,2\n", 100);
    for (const char* last :
         {"1.5;2\n", "1.5,2,3\n", "1.5\n", "a,2\n", "nan,1\n", "1e999,1\n", "1e-999,1\n", "1.5,\n", "1.5,\"2\"\n",
          "01,2\n", "1.5, 2\n", "1.5 ,2\n", "1.5,2 # c\n", "1,5,2\n", "1.5,2\r1,2\n", "1.5,2\x1A"})
        CHECK(!is_streamed(files.write("a.csv", lines + last)));
    CHECK(!is_streamed(files.write("a.csv", "0,1,2\n" + repeated("1.5,2.5,3.5\n", 100))));
    CHECK(!is_streamed(files.write("a.csv", std::string(lines) + '\0')));
    CHECK(!is_streamed(files.write("a.csv.gz", "\x1F\x8B" + lines)));
    CHECK(!is_streamed(files.write("a.xyz", "2\nwater\n" + repeated("H 1 2 3\n", 2))));
    CHECK(!is_streamed(files.write("a.obj", repeated("v 1 2 3\n", 100))));
}

// Lines that are alike, but for some.
TEST_CASE("streams: tables at random") {
    const Files files;
    std::mt19937_64 random(11);
    const auto pick = [&](std::initializer_list<const char*> list) {
        return std::string(*(list.begin() + static_cast<std::ptrdiff_t>(random() % list.size())));
    };
    unsigned streamed = 0;
    for (int trial = 0; trial < 3000; trial++) {
        const std::string usual = pick({",", ";", "\t", " ", ", ", "  ", "; ", "|"});
        const unsigned columns = 2 + random() % 3, oddity = random() % 3 == 0 ? 0 : 20 + random() % 400;
        const bool wholes = random() % 4 == 0;
        const auto is_odd = [&] { return oddity != 0 && random() % oddity == 0; };
        std::string text = pick({"", "", "x,y\n", "id,x,y\n", "x y z\n", "# c\n", ",0,1\n", "2019 2020\n", "sep=;\n"});
        for (unsigned row = 0, rows = 1 + random() % 120; row < rows; row++) {
            if (is_odd()) text += pick({"\n", "# c\n", "% c\n", "// c\n", "  \n", "a\n", "\"1\",2\n", ",,\n"});
            for (unsigned k = 0; k < columns + (is_odd() ? 1 : 0); k++) {
                const std::string usual_number =
                    k == 0 && wholes ? std::to_string(row) : pick({"1.5", "2.25", "-3e2", ".5", "7", "0"});
                if (k > 0) text += is_odd() ? pick({",", ";", " ", "\t", ", "}) : usual;
                text += is_odd() ? pick({"", "nan", "1e400", "1e-400", "007", "1,5", "x", "\"3\"", "-0", "1e5"})
                                 : usual_number;
            }
            text += is_odd() ? pick({" \n", "\r\n", ",\n", " # c\n"}) : "\n";
        }
        TableOptions options;
        if (random() % 8 == 0) options.skip = random() % 3;
        if (random() % 8 == 0) options.columns = {"1", "2"};
        if (random() % 16 == 0) options.delimiter = usual[0];
        CAPTURE(text);
        streamed += is_streamed(files.write("t.txt", text), options, 40 + random() % 400);
    }
    CHECK(streamed > 500);
}

std::string npy(const std::string& type, const std::string& order, const std::string& shape, const std::string& data) {
    std::string head = "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': (" + shape + "), }";
    while ((10 + head.size() + 1) % 64 != 0) head += ' ';
    head += '\n';
    return std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(head.size()) + '\0' + head + data;
}

template <class T> std::string bytes_of(const std::vector<T>& numbers) {
    return std::string(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T));
}

TEST_CASE("streams: arrays of NumPy") {
    const Files files;
    std::vector<double> numbers;
    std::vector<float> floats;
    for (int i = 0; i < 600000; i++) {
        numbers.push_back(0.5 * i - 7);
        floats.push_back(static_cast<float>(i) / 8);
    }
    TableOptions two;
    REQUIRE(parse_columns("3,1", &two.columns).empty());
    for (const char* order : {"False", "True"}) {
        const std::string wide = npy("<f8", order, "200000, 3", bytes_of(numbers));
        CHECK(is_streamed(files.write("a.npy", wide), {}, 1000));
        CHECK(is_streamed(files.write("a.npy", wide), two, 1000));
        CHECK(is_streamed(files.write("a.npy", npy("<f4", order, "300000, 2", bytes_of(floats))), {}, 1000));
    }
    CHECK(is_streamed(files.write("a.npy", npy("<f8", "False", "200000, 3", bytes_of(numbers) + "x")), {}, 1000));
    CHECK(is_streamed(files.write("a.npy", npy("<f8", "False", "200001, 3", bytes_of(numbers))), {}, 1000));
    CHECK(is_streamed(files.write("a.npy", npy("<f8", "False", "600000", bytes_of(numbers))), {}, 1000));
    CHECK(is_streamed(files.write("a.npy", npy("<f8", "False", "60000, 10", bytes_of(numbers))), {}, 1000));
    numbers[500001] = HUGE_VAL;
    CHECK(is_streamed(files.write("a.npy", npy("<f8", "False", "200000, 3", bytes_of(numbers))), {}, 1000));
    CHECK(is_streamed(files.write("a.npy", npy("<f8", "True", "200000, 3", bytes_of(numbers))), {}, 1000));
}

TEST_CASE("streams: binary PLY") {
    const Files files;
    const auto ply = [](int vertices, int faces, const std::string& data) {
        return "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(vertices) +
               "\nproperty float x\nproperty uchar red\nproperty float y\nproperty float z\nelement face " +
               std::to_string(faces) + "\nproperty list uchar int vertex_indices\nend_header\n" + data;
    };
    std::string data, more;
    for (int i = 0; i < 100000; i++) {
        const std::vector<float> x = {static_cast<float>(i) / 4, static_cast<float>(i % 7), -1.5f};
        data += bytes_of<float>({x[0]}) + "r" + bytes_of<float>({x[1], x[2]});
    }
    for (int i = 0; i < 60000; i++) more += "\x03" + bytes_of<int>({i, i + 1, i + 2});
    CHECK(is_streamed(files.write("a.ply", ply(100000, 60000, data + more)), {}, 1000));
    CHECK(is_streamed(files.write("a.ply", ply(100000, 0, data + "\n")), {}, 1000));
    CHECK(is_streamed(files.write("a.ply", ply(100000, 60000, data + more + "junk")), {}, 1000));
    CHECK(is_streamed(files.write("a.ply", ply(100001, 0, data)), {}, 1000));
    CHECK(is_streamed(files.write("a.ply", ply(100000, 60001, data + more)), {}, 1000));
    CHECK(is_streamed(files.write("a.ply", ply(60000, 60000, data.substr(0, 60000 * 13) + more)), {}, 1000));
    data.replace(90000 * 13 + 5, 4, bytes_of<float>({HUGE_VALF}));
    CHECK(is_streamed(files.write("a.ply", ply(100000, 0, data)), {}, 1000));
    CHECK(!is_streamed(files.write("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                                            "property float y\nend_header\n1 2\n"),
                       {}, 1000));
}

}  // namespace
}  // namespace netmesh::tool
