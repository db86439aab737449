// .gz around anything, and .npz: packed here, read back by the tool; without zlib refused with what to do.
#include <doctest/doctest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tools/io/npy_writer.hpp"
#include "tools/io/points.hpp"

#ifdef NETMESH_TOOL_ZLIB
#include <zlib.h>
#endif

using namespace netmesh::tool;

namespace {

using Numbers = std::vector<double>;
const Numbers numbers = {1.5, -2.25, 3.125, 4, -0.5, 6.75};
const std::string plain = "1.5,-2.25\n3.125,4\n-0.5,6.75\n";

std::string array_of(const Numbers& values, std::uint64_t columns) {
    TextWriter out;
    write_npy_head(values.size() / columns, columns, out);
    for (const double value : values) write_npy_double(value, out);
    return out.text();
}

class Files {
public:
    Files() {
        char name[] = "/tmp/netmesh-packed-XXXXXX";
        REQUIRE(mkdtemp(name) != nullptr);
        path_ = std::string(name) + "/";
    }
    ~Files() { std::filesystem::remove_all(path_); }
    const std::string& path() const { return path_; }
    // What reading `name` says; `open`, behind a colon, is the array that is asked for.
    Outcome read(const std::string& name, const std::string& content, PointCloud* cloud, const std::string& open = "") {
        std::ofstream(path_ + name, std::ios::binary) << content;
        return read_points(path_ + name + open, cloud);
    }
    void good(const std::string& name, const std::string& content, const std::string& open = "") {
        PointCloud cloud;
        CAPTURE(name);
        CHECK(read(name, content, &cloud, open).message == "");
        CHECK(cloud.coordinates == numbers);
    }
    void bad(const std::string& name, const std::string& content, const std::string& says,
             const std::string& open = "") {
        PointCloud cloud;
        const Outcome outcome = read(name, content, &cloud, open);
        CAPTURE(name);
        CAPTURE(outcome.message);
        CHECK(outcome.exit == Exit::data);
        CHECK(outcome.message.rfind(path_ + name + ":", 0) == 0);
        CHECK(outcome.message.find(says) != std::string::npos);
    }

private:
    std::string path_;
};

std::string little(std::uint64_t number, unsigned bytes) {
    std::string text;
    for (unsigned i = 0; i < bytes; i++) text += static_cast<char>(number >> (8 * i) & 255);
    return text;
}

struct Entry {
    std::string name, whole, packed;
    unsigned method, crc;
};

// As numpy writes it, with the extra fields of zip64 in front of the data.
std::string archive_of(const std::vector<Entry>& entries) {
    std::string text, directory;
    for (const Entry& e : entries) {
        const std::string sizes = little(e.packed.size(), 4) + little(e.whole.size(), 4);
        const std::string common = little(45, 2) + little(0, 2) + little(e.method, 2) + little(0, 4) + little(e.crc, 4);
        directory += "PK\x01\x02" + little(45, 2) + common + sizes + little(e.name.size(), 2) + little(0, 2) +
                     little(0, 2) + little(0, 2) + little(0, 2) + little(0, 4) + little(text.size(), 4) + e.name;
        text += "PK\x03\x04" + common + std::string(8, '\xFF') + little(e.name.size(), 2) + little(20, 2) + e.name +
                little(1, 2) + little(16, 2) + little(e.whole.size(), 8) + little(e.packed.size(), 8) + e.packed;
    }
    return text + directory + "PK\x05\x06" + little(0, 4) + little(entries.size(), 2) + little(entries.size(), 2) +
           little(directory.size(), 4) + little(text.size(), 4) + little(0, 2);
}

}  // namespace

#ifdef NETMESH_TOOL_ZLIB

namespace {

std::string deflated(const std::string& text, int bits) {
    z_stream stream = {};
    REQUIRE(deflateInit2(&stream, 9, Z_DEFLATED, bits, 8, Z_DEFAULT_STRATEGY) == Z_OK);
    std::string packed(deflateBound(&stream, text.size()) + 64, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    stream.avail_in = static_cast<uInt>(text.size());
    stream.next_out = reinterpret_cast<Bytef*>(&packed[0]);
    stream.avail_out = static_cast<uInt>(packed.size());
    REQUIRE(deflate(&stream, Z_FINISH) == Z_STREAM_END);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

std::string gzipped(const std::string& text) { return deflated(text, 15 + 16); }

Entry entry_of(const std::string& name, const std::string& content, bool packed) {
    const auto crc = crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size()));
    return {name, content, packed ? deflated(content, -15) : content, packed ? 8u : 0u, static_cast<unsigned>(crc)};
}

}  // namespace

TEST_CASE("gz of everything: the inner ending says what it is") {
    Files files;
    files.good("p.csv.gz", gzipped(plain));
    files.good("p.txt.gz", gzipped("x;y\n1,5;-2,25\n3,125;4\n-0,5;6,75\n"));
    files.good("p.npy.gz", gzipped(array_of(numbers, 2)));
    files.good("P.CSV.GZ", gzipped(plain));
    files.good("members.csv.gz", gzipped(plain.substr(0, 10)) + gzipped(plain.substr(10)));
    files.good("padded.csv.gz", gzipped(plain) + std::string(512, '\0'));
    files.good("hidden.csv", gzipped(plain));
    std::string large;  // more than a piece
    for (int i = 0; i < 40000; i++) large += std::to_string(i) + ".5 " + std::to_string(i % 77) + ".25\n";
    PointCloud cloud;
    CHECK(files.read("large.txt.gz", gzipped(large), &cloud).message == "");
    CHECK(cloud.rows() == 40000);
    CHECK(cloud.coordinates[2 * 39999] == 39999.5);
}

TEST_CASE("gz of any file that the tool reads") {
    Files files;
    PointCloud cloud;
    CHECK(files.read("k.txt.gz", gzipped("0 0\n1 0\n0 1 1\n"), &cloud).exit == Exit::data);
    std::string content;
    bool packed = false;
    CHECK(read_content(files.path() + "k.txt.gz", &content, &packed).good());
    CHECK(content == "0 0\n1 0\n0 1 1\n");
    CHECK(packed);
}

TEST_CASE("gz that is broken, cut off or none") {
    Files files;
    const std::string packed = gzipped(plain);
    files.bad("cut.csv.gz", packed.substr(0, packed.size() - 4), "cut off");
    files.bad("head.csv.gz", packed.substr(0, 5), "cut off");
    std::string broken = packed;
    broken[packed.size() - 6] = static_cast<char>(broken[packed.size() - 6] ^ 0x55);  // its checksum
    files.bad("broken.csv.gz", broken, "copy the file again");
    files.bad("tail.csv.gz", packed + "tail", "not gzip behind");
    files.bad("inner.npy.gz", gzipped(plain), "if it is text");
    files.bad("lines.csv.gz", gzipped("1,2\n3,x\n"), ":2: \"x\" is not a number");
}

TEST_CASE("npz: the only array, or the one that is named") {
    Files files;
    const std::string array = array_of(numbers, 2), other = array_of({1, 2, 3}, 3);
    files.good("one.npz", archive_of({entry_of("arr_0.npy", array, false)}));
    files.good("packed.npz", archive_of({entry_of("points.npy", array, true)}));
    const std::string two = archive_of({entry_of("b.npy", other, true), entry_of("a.npy", array, true)});
    files.good("two.npz", two, ":a");
    files.bad("two.npz", two, "arrays \"b\", \"a\"; name the one");
    files.bad("two.npz", two, "none of them called \"c\"", ":c");
    files.bad("none.npz", archive_of({entry_of("a.npy.txt", "x", false)}), "archive with arrays \"a.npy.txt\"");
    files.bad("cut.npz", two.substr(0, two.size() - 30), "cut off");
    Entry wrong = entry_of("a.npy", array, true);
    wrong.crc ^= 1;
    files.bad("wrong.npz", archive_of({wrong}), "checksum");
    wrong = entry_of("a.npy", array, true);
    wrong.method = 12;
    files.bad("method.npz", archive_of({wrong}), "packed by method 12; use numpy.savez_compressed");
    wrong = entry_of("a.npy", array, false);
    wrong.packed.resize(wrong.packed.size() - 8);
    files.bad("short.npz", archive_of({wrong}), "checksum");
}

#else

TEST_CASE("without zlib packed files are refused with what to do") {
    Files files;
    files.bad("p.csv.gz", "\x1F\x8B\x08", "gunzip it first");
    const std::string array = array_of(numbers, 2);
    files.good("one.npz", archive_of({{"arr_0.npy", array, array, 0, 0}}));
    files.bad("packed.npz", archive_of({{"arr_0.npy", array, array, 8, 0}}), "write it by numpy.savez");
}

#endif
