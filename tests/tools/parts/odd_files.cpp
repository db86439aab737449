// Files as exporters, spreadsheets and people leave them, good and bad: each gives the right points, or is refused with
// its line and what to do, and none is read as something else.
#include <doctest/doctest.h>

#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>

#include "tools/io/points.hpp"

using namespace netmesh::tool;

namespace {

using Numbers = std::vector<double>;
using namespace std::string_literals;

struct OddFile {
    std::string name, content;
    Numbers points;          // none: it is refused
    std::uint64_t line = 0;  // of the refusal; 0: it has no lines
    std::string says;        // a piece of the refusal that tells what to do, or of the note
    std::string columns, delimiter;
    std::uint64_t skip = 0;
};

const Numbers three = {1.5, -2.25, 3.125, 4, -0.5, 6.75};  // points of the plane
const Numbers space = {1.5, -2.25, 7, 3.125, 4, 8, -0.5, 6.75, 9};

OddFile good(std::string name, std::string content, std::string note = "", Numbers points = three) {
    return {std::move(name), std::move(content), std::move(points), 0, std::move(note), "", "", 0};
}
OddFile bad(std::string name, std::string content, std::uint64_t line, std::string says) {
    return {std::move(name), std::move(content), {}, line, std::move(says), "", "", 0};
}
OddFile with(OddFile file, std::string columns, std::string delimiter = "", std::uint64_t skip = 0) {
    file.columns = std::move(columns);
    file.delimiter = std::move(delimiter);
    file.skip = skip;
    return file;
}

std::string utf16(const std::string& text, bool big) {
    std::string wide = big ? "\xFE\xFF" : "\xFF\xFE";
    for (const char c : text) wide += big ? "\0"s + c : c + "\0"s;
    return wide;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

const std::string plain = "1.5,-2.25\n3.125,4\n-0.5,6.75\n";
const std::string decimal_commas = "1,5;-2,25\n3,125;4\n-0,5;6,75\n";
const std::string lab = "time,site,x,y\n2024-03-01 10:00:00,\"Lab A, bench\",1.5,-2.25\n2024-03-01 10:01:00,\"Lab A, "
                        "bench\",3.125,4\n2024-03-01 10:02:00,\"Lab B, bench\",-0.5,6.75\n";

std::string triangle(const std::string& a, const std::string& b, const std::string& c) {
    return "facet normal 0 0 1\n outer loop\n  vertex " + a + "\n  vertex " + b + "\n  vertex " + c +
           "\n endloop\nendfacet\n";
}

std::string binary_stl(std::uint32_t count, std::uint32_t triangles) {
    std::string bytes = "solid of a binary exporter";
    bytes.resize(80, ' ');
    bytes.append(reinterpret_cast<const char*>(&count), 4);
    for (std::uint32_t i = 0; i < triangles; i++) {
        const float numbers[12] = {0, 0, 1, 1.5f, -2.25f, 7, 3.125f, 4, 8, -0.5f, 6.75f, 9};
        bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
        bytes.append(2, '\0');
    }
    return bytes;
}

const char* const atom_1 = "ATOM      1  N   ALA A   1       1.500  -2.250   7.000  1.00  0.00           N\n";
const char* const atom_2 = "HETATM    2  CA  ALA A   1       3.125   4.000   8.000  1.00  0.00           C\n";
const char* const atom_3 = "ATOM      3  C   ALA A   1      -0.500   6.750   9.000  1.00  0.00           C\n";
const char* const other_3 = "ATOM      4  C  BALA A   1      -0.600   6.850   9.100  0.40  0.00           C\n";
const std::string first_3 = replaced(atom_3, "C   ALA", "C  AALA");

std::vector<OddFile> tables() {
    const std::string tabs = replaced(plain, ",", "\t"), blanks = replaced(plain, ",", " ");
    const std::string semicolons = replaced(plain, ",", ";");
    return {
        // delimiters
        good("comma.csv", plain),
        good("semicolon.csv", semicolons),
        good("tab.tsv", tabs),
        good("blank.txt", blanks),
        good("bar.txt", replaced(plain, ",", "|")),
        good("bar_and_blanks.txt", replaced(plain, ",", " | ")),
        good("comma_and_blank.csv", replaced(plain, ",", ", ")),
        good("whole_comma_and_blank.csv", "1, 2\n3, 4\n5, 7\n", "", {1, 2, 3, 4, 5, 7}),
        good("aligned.dat", "   1.5    -2.25\n   3.125   4.00\n  -0.5     6.75\n"),
        good("aligned_by_tabs.txt", "1.5\t\t-2.25\n3.125\t4\n-0.5\t\t6.75\n"),
        good("indented_by_tabs.txt", "\t1.5\t-2.25\n\t3.125\t4\n\t-0.5\t6.75\n"),
        with(good("colon.txt", replaced(plain, ",", ":")), "", ":"),
        bad("colon_untold.txt", replaced(plain, ",", ":"), 1, "--delimiter ':'"),
        good("mixed.txt", "1.5, -2.25\n3.125 4\n-0.5\t6.75\n"),
        good("excel_sep.csv", "sep=;\r\n" + replaced(decimal_commas, "\n", "\r\n"), "skipped line \"sep=;\""),
        good("excel_sep_comma.csv", "sep=,\n" + plain, "skipped line \"sep=,\""),
        // decimal commas
        good("european.csv", decimal_commas, "commas read as decimal"),
        good("european_tabs.txt", replaced(decimal_commas, ";", "\t"), "commas read as decimal"),
        good("european_bars.txt", replaced(decimal_commas, ";", " | "), "commas read as decimal"),
        good("european_header.csv", "x;y\n" + decimal_commas, "skipped header \"x;y\""),
        good("european_long.csv", "1,002515;-0,002642\n0,998;0,01\n", "decimal", {1.002515, -0.002642, 0.998, 0.01}),
        good("european_quoted.csv", "\"1,5\";\"-2,25\"\n\"3,125\";\"4\"\n\"-0,5\";\"6,75\"\n", "decimal"),
        good("quoted_in_commas.csv", "\"1,5\",\"-2,25\"\n\"3,125\",\"4\"\n\"-0,5\",\"6,75\"\n", "decimal"),
        good("european_exponent.csv", "1,5E0;-2,25E+00\n3,125e0;4,0\n-5,0E-1;6,75\n", "decimal"),
        bad("european_blanks.txt", replaced(decimal_commas, ";", " "), 1, "--delimiter blank"),
        with(good("european_blanks_told.txt", replaced(decimal_commas, ";", " ")), "", "blank"),
        bad("european_comma_blank.csv", "0,5, 1,5\n2,5, 3,5\n", 1, "write points in place of decimal commas"),
        bad("european_commas_alone.csv", "1,002515,-0,002642\n0,998,0,01\n", 1, "decimal"),
        bad("thousands_or_decimal.csv", "1,234;5,678\n2,345;6,789\n", 1, "--delimiter ';' reads them as decimal"),
        with(good("thousands_told.csv", "1,234;5,678\n", "", {1.234, 5.678}), "", ";"),
        bad("thousands_of_excel.txt", "1,234\t5,678\n12,345\t6,789\n", 1, "--delimiter tab"),
        bad("thousands_quoted.csv", "\"1,234\",\"5,678\"\n\"12,345\",\"6,789\"\n", 1, "group thousands"),
        bad("thousands_and_points.csv", "\"1,234.5\",\"2.5\"\n3.5,4.5\n", 1, "without signs between thousands"),
        bad("thousands_european.csv", "1.234,56;7.890,12\n3,5;4,5\n", 1, "without signs between thousands"),
        bad("thousands_german.csv", "x;y\n1.500;2.400\n300;600\n800;1.950\n2.100;1.500\n1.200;650\n", 2,
            "--delimiter ';' reads them as decimal"),
        bad("thousands_german.txt", "1.500 -2.400\n300 600\n", 1, "--delimiter blank reads them as decimal"),
        bad("thousands_german.tsv", "site\tx\ty\na\t1.500\t2.400\nb\t300\t600\n", 2, "group thousands (1.234)"),
        bad("thousands_german_quoted.csv", "\"1.500\";\"2.400\"\n\"300\";\"600\"\n", 1, "without signs between"),
        with(good("thousands_german_told.csv", "1.500;2.400\n300;600\n2;7\n", "", {1.5, 2.4, 300, 600, 2, 7}), "", ";"),
        good("three_decimals.txt", "1.500 2.400\n3.125 4.000\n2.100 1.500\n", "", {1.5, 2.4, 3.125, 4, 2.1, 1.5}),
        good("three_decimals_counted.txt", "7 1.500 2.400\n4 3.125 4.000\n8 2.100 1.500\n", "",
             {7, 1.5, 2.4, 4, 3.125, 4, 8, 2.1, 1.5}),
        good("three_decimals_and_zero.txt", "0 0\n1.500 2.400\n3.125 4.000\n", "", {0, 0, 1.5, 2.4, 3.125, 4}),
        good("three_decimals_below_one.txt", "1.500 2\n0.125 4.000\n3 1.500\n", "", {1.5, 2, 0.125, 4, 3, 1.5}),
        good("three_decimals_and_four_digits.txt", "1.500 1250\n300 1.125\n2 4.250\n1000 3\n", "",
             {1.5, 1250, 300, 1.125, 2, 4.25, 1000, 3}),
        good("three_decimals_of_commas.csv", "1.500,2\n3,4.000\n3.125,1.500\n", "", {1.5, 2, 3, 4, 3.125, 1.5}),
        bad("thousands_twice.csv", "1,234,567;2,5\n1,5;2,5\n", 1, "without signs between thousands"),
        bad("thousands_by_blanks.csv", "1 234,5;2 345,6\n1 234,7;2 345,8\n", 1, "write them without"),
        bad("thousands_by_blanks.tsv", "1 234.5\t2 345.6\n1 234.7\t2 345.8\n", 1, "write them without"),
        bad("thousands_swiss.csv", "1'234.5,2.5\n3.5,4.5\n", 1, "without signs between thousands"),
        bad("thousands_hard_blank.csv",
            "1\xC2\xA0"
            "234.5,2.5\n3.5,4.5\n",
            1, "a blank that does not break"),
        bad("both_decimal.csv", "1,5;2.5\n3,25;4.5\n", 1, "write numbers in one way"),
        // headers, index columns
        good("header.csv", "x,y\n" + plain, "skipped header \"x,y\""),
        good("header_quoted.csv", "\"x\",\"y\"\n" + plain, "skipped header"),
        good("header_blanks.txt", "x y\n" + blanks, "skipped header \"x y\""),
        good("header_units.csv", "x [mm],y [mm]\n" + plain, "skipped header \"x [mm],y [mm]\""),
        good("header_latin1.csv", "Abst\xE4nde,H\xF6he\n" + plain, "skipped header"),
        good("header_other_mark.csv", "x y\n" + plain, "skipped header \"x y\""),
        good("header_hash.txt", "# x y\n" + blanks),
        good("header_percent.txt", "% x y\n" + blanks),
        good("header_slashes.txt", "// x y\n" + blanks),
        good("pandas.csv", ",x,y\n0,1.5,-2.25\n1,3.125,4\n2,-0.5,6.75\n", "skipped index column 1"),
        good("pandas_numbers.csv", ",0,1\n0,1.5,-2.25\n1,3.125,4.0\n2,-0.5,6.75\n", "skipped header \",0,1\""),
        good("pandas_filtered.csv", ",x,y\n3,1.5,-2.25\n7,3.125,4\n12,-0.5,6.75\n", "skipped index column 1"),
        good("pandas_tabs.tsv", "\tx\ty\n0\t1.5\t-2.25\n1\t3.125\t4\n2\t-0.5\t6.75\n", "skipped index column 1"),
        good("pandas_european.csv", ";x;y\n0;1,5;-2,25\n1;3,125;4\n2;-0,5;6,75\n", "skipped index column 1"),
        good("pandas_saved_twice.csv", "Unnamed: 0,x,y\n0,1.5,-2.25\n1,3.125,4\n2,-0.5,6.75\n", "index column 1"),
        good("pandas_words.csv", ",x,y\na,1.5,-2.25\nb,3.125,4\nc,-0.5,6.75\n", "skipped index column 1"),
        bad("pandas_shuffled.csv", ",x,y\n5,1.5,-2.25\n1,3.125,4\n", 2, "--columns 2-3 leaves it out"),
        bad("pandas_no_index.csv", "0,1\n1.5,-2.25\n3.125,4.0\n-0.5,6.75\n", 1, "--skip 1 leaves it out"),
        with(good("pandas_no_index_told.csv", "0,1\n1.5,-2.25\n3.125,4.0\n-0.5,6.75\n"), "", "", 1),
        good("r_csv.csv", "\"\",\"V1\",\"V2\"\n\"1\",1.5,-2.25\n\"2\",3.125,4\n\"3\",-0.5,6.75\n", "index column 1"),
        good("r_table.txt", "\"V1\" \"V2\"\n\"1\" 1.5 -2.25\n\"2\" 3.125 4\n\"3\" -0.5 6.75\n", "index column 1"),
        good("r_csv2.csv", "\"\";\"V1\";\"V2\"\n\"1\";1,5;-2,25\n\"2\";3,125;4\n\"3\";-0,5;6,75\n", "index column 1"),
        good("r_names.csv", "\"\",\"x\",\"y\"\n\"a\",1.5,-2.25\n\"b\",3.125,4\n\"c\",-0.5,6.75\n", "index column 1"),
        good("id.csv", "id,x,y\n1,1.5,-2.25\n2,3.125,4\n3,-0.5,6.75\n", "skipped index column 1"),
        good("fid_of_gis.csv", "FID,X,Y\n10,1.5,-2.25\n20,3.125,4\n30,-0.5,6.75\n", "skipped index column 1"),
        bad("id_shuffled.csv", "id,x,y\n9,1.5,-2.25\n2,3.125,4\n", 2, "--columns 2-3 leaves it out"),
        bad("header_years.csv", "place,2019,2020\n1.5,-2.25,7\n3.125,4,8\n", 1, "--skip 1"),
        bad("two_headers.csv", "x,y\nmm,mm\n" + plain, 2, "--skip 2"),
        with(good("two_headers_told.csv", "x,y\nmm,mm\n" + plain), "", "", 2),
        bad("title.csv", "Run 5 of 2024-01-02\n" + plain, 1, "--skip 1"),
        with(good("title_told.csv", "Run 5 of 2024-01-02\n" + plain), "", "", 1),
        bad("count_above.txt", "3\n" + blanks, 2, "--skip 1 leaves that line out"),
        with(good("count_above_told.txt", "3\n" + blanks), "", "", 1),
        bad("qhull.txt", "2\n3\n" + blanks, 3, "2 columns where line 1 has 1"),
        bad("field_missing.txt", "0 1\n2,5\n0 0\n3 3\n", 2, "--delimiter"),
        bad("field_missing.tsv", "0\t1\t2\n2,5\t3\n0\t0\t1\n", 2, "2 columns where line 1 has 3"),
        // columns
        bad("labels_first.csv", "a,1.5,-2.25\nb,3.125,4\n", 1, "--columns 2,3"),
        bad("labels_last.csv", "1.5,-2.25,setosa\n3.125,4,setosa\n", 1, "--columns 1,2"),
        with(good("labels_told.csv", "1.5,-2.25,setosa\n3.125,4,setosa\n-0.5,6.75,virginica\n"), "1,2"),
        with(good("labels_european.csv", "setosa;1,5;-2,25\nsetosa;3,125;4\nsetosa;-0,5;6,75\n"), "2-3"),
        with(good("by_name.csv", "t,x,name,y\n0,1.5,a,-2.25\n1,3.125,b,4\n2,-0.5,c,6.75\n"), "x,y"),
        with(good("swapped.csv", "-2.25,1.5\n4,3.125\n6.75,-0.5\n"), "2,1"),
        with(bad("no_such_column.csv", "x,y\n" + plain, 2, "no column \"z\""), "x,z"),
        with(bad("beyond.csv", plain, 1, "there are columns 1 to 2"), "1-3"),
        bad("dates.csv", "2024-01-02,1.5,-2.25\n2024-01-03,3.125,4\n", 1, "--columns 2,3"),
        bad("times.csv", "12:30:00,1.5,-2.25\n12:31:00,3.125,4\n", 1, "--columns 2,3"),
        bad("seven.csv", "1,2,3,4,5,6,7\n1,2,3,4,5,6,8\n", 1, "--columns chooses some"),
        bad("one.csv", "1.5\n2.5\n", 1, "--delimiter says"),
        // ends of lines, marks, encodings
        good("dos.csv", replaced(plain, "\n", "\r\n")),
        good("old_mac.csv", replaced(plain, "\n", "\r")),
        good("doubled_returns.csv", replaced(plain, "\n", "\r\r\n")),
        bad("returns_within.csv", "1.5,-2.25\r3.125,4\n-0.5,6.75\n", 1, "one kind of line ends"),
        good("no_last_end.csv", plain.substr(0, plain.size() - 1)),
        good("byte_order_mark.csv", "\xEF\xBB\xBF" + plain),
        good("byte_order_mark_header.csv", "\xEF\xBB\xBFx,y\n" + plain, "skipped header \"x,y\""),
        good("utf16.txt", utf16(tabs, false)),
        good("utf16_big.csv", utf16("x;y\n" + decimal_commas, true), "commas read as decimal"),
        bad("utf16_without_mark.txt", utf16(tabs, false).substr(2), 1, "UTF-16 with its byte-order mark"),
        good("end_of_dos.csv", plain + "\x1A"),
        good("blank_lines.csv", "\n\n" + replaced(plain, "\n", "\n\n")),
        good("comments_behind.txt", replaced(blanks, "\n", " # a\n")),
        good("comments_behind_tabs.txt", replaced(tabs, "\n", "\t# a\n")),
        good("numpy_savetxt.txt", "1.500000000000000000e+00 -2.250000000000000000e+00\n"
                                  "3.125000000000000000e+00 4.000000000000000000e+00\n"
                                  "-5.000000000000000000e-01 6.750000000000000000e+00\n"),
        good("matlab.txt", "   1.5000000e+00  -2.2500000e+00\n   3.1250000e+00   4.0000000e+00\n"
                           "  -5.0000000e-01   6.7500000e+00\n"),
        good("octave.txt", "# Created by Octave\n# name: a\n# type: matrix\n# rows: 3\n# columns: 2\n" + blanks),
        good("gnuplot.dat", "# x y\n1.5 -2.25\n\n\n3.125 4\n-0.5 6.75\n"),
        good("plus_signs.csv", "+1.5,-2.25\n+3.125,+4\n-0.5,+6.75\n"),
        good("short_decimals.csv", "1.5,-2.25\n3.125,4.\n-.5,6.75\n"),
        good("all_quoted.csv", "\"1.5\",\"-2.25\"\n\"3.125\",\"4\"\n\"-0.5\",\"6.75\"\n"),
        good("some_quoted.csv", "1.5,\"-2.25\"\n3.125,\"4\"\n-0.5,6.75\n"),
        good("quoted_header_comma.csv", "\"x, in mm\",\"y, in mm\"\n" + plain, "skipped header"),
        // empty fields
        good("trailing_comma.csv", replaced(plain, "\n", ",\n"), "skipped an empty last column"),
        good("trailing_comma_header.csv", "x,y,\n" + replaced(plain, "\n", ",\n"), "skipped an empty last column"),
        good("trailing_semicolon.csv", replaced(decimal_commas, "\n", ";\n"), "skipped an empty last column"),
        good("trailing_tab.tsv", replaced(tabs, "\n", "\t\n"), "skipped an empty last column"),
        good("empty_rows.csv", plain + ",\n,\n", "skipped 2 rows of nothing at the end"),
        bad("trailing_comma_once.csv", "1.5,-2.25\n3.125,4,\n", 2, "nothing after the last ','"),
        bad("missing.csv", "1.5,-2.25,7\n3.125,,8\n", 2, "nothing before a ','"),
        bad("missing_first.csv", "1.5,-2.25,7\n,4,8\n", 2, "nothing before a ','"),
        bad("missing.tsv", "1.5\t-2.25\t7\n3.125\t\t8\n-0.5\t6.75\t9\n", 2, "nothing in column 2"),
        bad("missing_here_and_there.tsv", "1.5\t\t7\n\t4\t8\n-0.5\t6.75\t\n", 1, "left out or filled in"),
        bad("missing_quoted.csv", "1.5,\"\"\n3.125,4\n", 1, "left out or filled in"),
        bad("na.csv", "1.5,NA\n3.125,4\n", 1, "left out or filled in"),
        bad("nan.csv", "1.5,nan\n3.125,4\n", 1, "left out or filled in"),
        bad("null.csv", "1.5,4\n3.125,NULL\n", 2, "left out or filled in"),
        bad("dash.csv", "1.5,4\n3.125,-\n", 2, "left out or filled in"),
        bad("question.csv", "1.5,4\n3.125,?\n", 2, "left out or filled in"),
        bad("excel_na.csv", "1.5,4\n3.125,\"#N/A\"\n", 2, "left out or filled in"),
        bad("infinite.csv", "1.5,inf\n3.125,4\n", 1, "no option leaves it out"),
        bad("too_large.csv", "1.5,1e999\n3.125,4\n", 1, "no option leaves it out"),
        // what is no number
        bad("fortran.txt", "1.5D+00 -2.25D+00\n3.1D0 4D0\n", 1, "write e in place of Fortran's d"),
        bad("unicode_minus.csv",
            "1.5,\xE2\x88\x92"
            "2.25\n3.125,4\n",
            1, "its minus is not the sign"),
        bad("brackets.txt", "[1.5, -2.25]\n[3.125, 4]\n", 1, "without brackets"),
        bad("brackets_twice.txt", "[[1.5 -2.25]\n [3.125 4]]\n", 1, "without brackets"),
        bad("tuples.txt", "(1.5, -2.25)\n(3.125, 4)\n", 1, "without brackets"),
        bad("json.json", "{\"points\": [[1.5, -2.25]]}\n", 1, "JSON"),
        bad("units.csv", "1.5mm,-2.25mm\n3.125mm,4mm\n", 1, "is not a number"),
        bad("per_cent.csv", "1.5%,2.25%\n3.125%,4%\n", 1, "is not a number"),
        bad("hexadecimal.txt", "0x1p3 0x2\n1 2\n", 1, "--skip 1"),
        bad("underscores.txt", "1 2\n1_000 2\n", 2, "is not a number"),
        bad("truth.csv", "TRUE,FALSE,1\nTRUE,TRUE,2\n", 1, "is not a number"),
        bad("footer.csv", plain + "sum,4.1\n", 4, "is not a number"),
        bad("merge_conflict.csv", "1.5,-2.25\n<<<<<<< HEAD\n3.125,4\n", 2, "is not a number"),
        bad("two_dots.csv", "1.5,2.2.5\n3.125,4\n", 1, "--skip 1"),
        // advice that would not help is not given
        bad("currency.csv", "$1.5,$2.25\n$3.125,$4\n$2,$3\n", 1, "without units, signs of currency"),
        bad("currency_and_header.csv", "x,y\n$1.5,$2.25\n$3.125,$4\n$2,$3\n", 2, "without units, signs of currency"),
        bad("quotes_of_one_stroke.csv", "'1.5','2.25'\n'3.125','4'\n", 1, "without signs between thousands"),
        with(bad("delimiter_misfit.csv", "4,528;2,71\n1,5;2,5\n", 1,
                 "--delimiter ',' does not fit: a ; stands in every line"),
             "", ","),
        with(bad("delimiter_misfit.txt", "4.528,2.71\n1.5,2.5\n", 1,
                 "--delimiter tab does not fit: a , stands in every line"),
             "", "\t"),
        // diagrams
        bad("diagram.csv", "degree,birth,death\n0,0,1.5\n0,0,inf\n", 1, "this is a persistence diagram, not points"),
        bad("diagram.txt", "# netmesh diagram 1: degree birth death\n# version 1.0\n0 0 inf\n", 1,
            "a persistence diagram"),
        with(good("diagram_chosen.csv", "degree,birth,death\n0,1.5,-2.25\n0,3.125,4\n1,-0.5,6.75\n"), "birth,death"),
        bad("condensed.txt", "3\n5\n4\n4\n5\n3\n", 1,
            "6 numbers may be the distances of 4 points, which persist --dist"),
        bad("ellipsis.txt", "1.5 -2.25\n...\n3.125 4\n", 2, "is not a number"),
        bad("open_quote.csv", "1.5,\"-2.25\n3.125,4\n", 1, "quotation that does not end"),
        // numbers that are no doubles
        good("too_small.csv", "1.5,-1e-400\n3.125,4\n1e-999,6.75\n", "read 2 numbers below 4.9e-324 as 0",
             {1.5, 0, 3.125, 4, 0, 6.75}),
        good("zeros.csv", "1.5,-0.0\n3.125,0e-400\n-0.5,6.75\n", "", {1.5, 0, 3.125, 0, -0.5, 6.75}),
        good("subnormal.csv", "1.5,5e-324\n3.125,4\n", "", {1.5, 5e-324, 3.125, 4}),
        // names that are numbers
        good("years.txt", "2019 2020\n1.5 -2.25\n3.125 4.0\n", "read \"2019 2020\" of line 1 as a point; if it names",
             {2019, 2020, 1.5, -2.25, 3.125, 4}),
        with(good("years_told.txt", "2019 2020\n" + replaced(blanks, " 4\n", " 4.0\n")), "", "", 1),
        good("origin_first.txt", "0 0\n1.5 -2.25\n3.125 4.0\n", "", {0, 0, 1.5, -2.25, 3.125, 4}),
        // counts, names and signs that are no coordinates
        bad("count_line.txt", "3 2\n" + blanks, 1, "--skip 1 leaves it out, --columns 1-2 reads it as a point"),
        bad("count_line.csv", "3,2\n" + plain, 1, "--skip 1"),
        with(good("count_line_told.txt", "3 2\n" + blanks), "", "", 1),
        with(good("count_line_taken.txt", "3 2\n" + blanks, "", {3, 2, 1.5, -2.25, 3.125, 4, -0.5, 6.75}), "1-2"),
        good("another_count.txt", "4 2\n1.5 -2.25\n3.125 4\n", "", {4, 2, 1.5, -2.25, 3.125, 4}),
        good("named_id.csv", "x,y,id\n1.5,-2.25,7\n3.125,4,8\n-0.5,6.75,9\n",
             "took \"id\" for a coordinate, too; --columns x,y leaves it out", space),
        good("named_two.csv", "X,Y,z,class\n1,2,3,4\n5,6,7,8\n9,1,2,3\n", "--columns X,Y,z leaves it out",
             {1, 2, 3, 4, 5, 6, 7, 8, 9, 1, 2, 3}),
        good("intensity.xyz", "1 2 3 40\n5 6 7 80\n9 1 2 30\n", "--columns 1-3 takes x, y, z alone",
             {1, 2, 3, 40, 5, 6, 7, 80, 9, 1, 2, 30}),
        with(bad("more_names.csv", "x,y,z\n1,2\n3,4\n5,7\n", 2, "the header names 3 columns, the rows have 2"), "x,z"),
        bad("more_names_untold.csv", "x,y,z\n1,2\n3,4\n5,7\n", 2, "2 columns where the header names 3"),
        with(good("more_names_taken.csv", "x,y,z\n" + plain), "1,2"),
        good("blanks_in_names.txt", "x (m) y (m)\n" + blanks, "skipped header"),
        bad("sign_of_number.csv", "x,y,id,z\n0,0,#12,0\n1,0,#13,0\n", 2, "--columns 1,2,4 leaves such columns out"),
        with(good("sign_left_out.csv", "x,id,y\n1.5,#1,-2.25\n3.125, #2,4\n-0.5,#3,6.75\n"), "x,y"),
        with(good("sign_in_tabs.tsv", "x\tid\ty\n1.5\t#1\t-2.25\n3.125\t#2\t4\n-0.5\t#3\t6.75\n"), "x,y"),
        bad("sign_in_words.csv", "x,y,id,z\n0,0,Site #3,0\n1,0,Site #4,0\n", 2, "\"Site #3\" is not a number"),
        // counts and heads in other orders and forms
        bad("count_turned.txt", "2 3\n1.5 -2.25\n3.125 4\n-0.5 6.75\n", 1, "--skip 1 leaves it out"),
        bad("count_in_space.txt", "3 3 0\n1.5 -2.25 7\n3.125 4 8\n-0.5 6.75 9\n", 1, "--columns 1-3 reads it"),
        bad("count_mark.txt",
            "\xEF\xBB\xBF"
            "3;2\r\n1.5;-2.25\r\n3.125;4\r\n-0.5;6.75\r\n",
            1, "--skip 1"),
        bad("count_below_comment.txt", "# points\n3\t2\n1.5\t-2.25\n3.125\t4\n-0.5\t6.75\n", 2, "--skip 2"),
        bad("node_named_text.txt", "3 2 0 1\n1 1.5 -2.25 0\n2 3.125 4 0\n3 -0.5 6.75 0\n", 1, "name the file .node"),
        bad("node_from_zero.csv", "3,2,0,1\n0,1.5,-2.25,0\n1,3.125,4,0\n2,-0.5,6.75,0\n", 1, "name the file .node"),
        bad("node_in_space.txt", "3 3 0 0\n1 1.5 -2.25 7\n2 3.125 4 8\n3 -0.5 6.75 9\n", 1, "name the file .node"),
        // headers that contradict the rows
        bad("few_names.csv", "a,b\n1.5,-2.25,7,1\n3.125,4,8,2\n-0.5,6.75,9,3\n", 2, "header names 2; --columns with"),
        with(bad("few_names_taken.csv", "a,b\n1.5,-2.25,7,1\n3.125,4,8,2\n", 2, "numbers from 1 say which"), "a,b"),
        with(good("few_names_by_number.csv", "a,b\n1.5,-2.25,7,1\n3.125,4,8,2\n-0.5,6.75,9,3\n"), "1,2"),
        bad("more_names_blank.txt", "x y z\n1.5 -2.25\n3.125 4\n-0.5 6.75\n", 2, "2 columns where the header names 3"),
        bad("more_names_tabs.tsv", "x\ty\tz\n1.5\t-2.25\n3.125\t4\n-0.5\t6.75\n", 2, "the header names 3"),
        bad("more_names_quoted.csv", "\"x\";\"y\";\"z\"\n1,5;-2,25\n3,125;4\n-0,5;6,75\n", 2, "the header names 3"),
        bad("more_names_bars.txt", "x | y | z\n1.5 | -2.25\n3.125 | 4\n-0.5 | 6.75\n", 2, "the header names 3"),
        with(bad("name_twice.csv", "x,x,y\n1.5,-2.25,7\n3.125,4,8\n", 2, "two columns are called so"), "x,y"),
        with(good("name_once.csv", "x,x,y\n1.5,7,-2.25\n3.125,8,4\n-0.5,9,6.75\n"), "1,y"),
        with(good("names_in_comment.csv", "# id,x,y\n7,1.5,-2.25\n4,3.125,4\n8,-0.5,6.75\n"), "x,y"),
        with(good("names_in_percent.txt", "% t x y\n7 1.5 -2.25\n4 3.125 4\n8 -0.5 6.75\n"), "x,y"),
        with(bad("names_of_comment.txt", "# x y z\n1.5 -2.25\n3.125 4\n", 2, "no column \"x\""), "x,z"),
        // hints that work
        bad("units_below.csv", "x,y\n(m),(m)\n1.5,-2.25\n3.125,4\n", 2, "\"(m)\" is not a number; --skip 2 leaves"),
        bad("units_in_brackets.csv", "x;y\n[mm];[mm]\n1,5;-2,25\n3,125;4\n", 2, "--skip 2 leaves the lines"),
        bad("one_of_numbers.csv", "name,x\na,1.5\nb,3.125\n", 2, "of the columns that are taken 2 alone holds"),
        bad("none_of_numbers.csv", "id,name\n1,a\n2,b\n", 2, "no column that is taken holds numbers"),
        with(bad("word_chosen.csv", "a,1.5,-2.25\nb,3.125,4\n", 1, "no column that is taken holds numbers"), "1"),
        with(bad("one_chosen.csv", "x,y\n1.5,-2.25\n3.125,4\n", 2, "1 column; points have 2 to 6 coordinates; --col"),
             "x"),
        with(bad("other_case.csv", "x [mm],y [mm]\n1.5,-2.25\n3.125,4\n", 2, "the header names \"x [mm]\", \"y [mm]\""),
             "X,Y"),
        // # in cells
        with(good("sign_behind_word.csv", "site,x,y\nSite #3,1.5,-2.25\nSite #4,3.125,4\nSite #5,-0.5,6.75\n"), "x,y"),
        with(good("sign_behind_word.tsv", "site\tx\ty\nSite #3\t1.5\t-2.25\nSite #4\t3.125\t4\nSite #5\t-0.5\t6.75\n"),
             "x,y"),
        with(good("sign_behind_word.txt", "site;x;y\nLab A #3;1,5;-2,25\nLab A #4;3,125;4\nLab B #5;-0,5;6,75\n"),
             "x,y"),
        bad("sign_behind_word_untold.csv", "site,x,y\nSite #3,1.5,-2.25\nSite #4,3.125,4\n", 2, "--columns 2,3 leaves"),
        good("comment_behind_number.csv", "1.5,-2.25 #first, of three\n3.125,4\n-0.5,6.75\n"),
        good("sign_in_blanks.txt", "1.5 -2.25 #12 7\n3.125 4 #13 8\n-0.5 6.75 #14 9\n",
             "left out what stands behind # in every row, \"#12 7\" first"),
        bad("signs_in_front.csv", "id,x,y\n#1,1.5,-2.25\n#2,3.125,4\n", 3, "2 lines of it begin with #"),
        bad("colours.csv", "x,y,colour\n1.5,-2.25,#ff0000\n3.125,4,#00ff00\n", 2, "--columns 1,2 leaves"),
        // what is taken for a coordinate by mistake
        good("degrees.csv", "lat,lon\n1.5,-2.25\n3.125,4\n-0.5,6.75\n", "\"lat\" and \"lon\" look like degrees"),
        good("degrees.tsv", "Longitude (deg)\tLatitude (deg)\n1.5\t-2.25\n3.125\t4\n-0.5\t6.75\n", "project them"),
        good("degrees_of_three.csv", "lng;LAT;depth\n1,5;-2,25;7\n3,125;4;8\n-0,5;6,75;9\n", "look like degrees",
             space),
        good("no_degrees.csv", "lat,lon\n1500,-2.25\n3.125,4\n", "skipped header \"lat,lon\"", {1500, -2.25, 3.125, 4}),
        good("mark_of_missing.csv", "1,2\n3,5\n-999,4\n4,4\n", "column 1 holds -999, far from its other numbers",
             {1, 2, 3, 5, -999, 4, 4, 4}),
        good("mark_of_missing.txt", "x y\n1 2\n3 9999\n4 4\n6 1\n", "\"y\" holds 9999", {1, 2, 3, 9999, 4, 4, 6, 1}),
        good("mark_of_netcdf.csv", "1.5,2\n9.969209968386869e+36,5\n4,4\n", "holds 9.969209968386869e+36",
             {1.5, 2, 9.969209968386869e36, 5, 4, 4}),
        good("no_mark.csv", "-999,2\n-998,5\n-500.5,4\n", "", {-999, 2, -998, 5, -500.5, 4}),
        good("seconds.csv", "1700000000.5,1,2\n1700000060.5,3,5\n1700000120,4,4\n",
             "took column 1, which looks like seconds since 1970, for a coordinate; --columns 2,3 leaves it out",
             {1700000000.5, 1, 2, 1700000060.5, 3, 5, 1700000120, 4, 4}),
        good("milliseconds.csv", "x;t;y\n1,5;1700000000123;2\n3;1700000060123;5\n4;1700000120123;4\n",
             "\"t\", which looks like milliseconds since 1970, for a coordinate; --columns x,y",
             {1.5, 1700000000123, 2, 3, 1700000060123, 5, 4, 1700000120123, 4}),
        good("dates_of_digits.tsv", "20240101\t1.5\t2\n20240230\t3\t5\n20241231\t4\t4\n",
             "looks like dates, as 20240131", {20240101, 1.5, 2, 20240230, 3, 5, 20241231, 4, 4}),
        good("no_dates.csv", "20240101,1.5\n20249901,3\n", "", {20240101, 1.5, 20249901, 3}),
        good("name_of_sample.csv", "sampleID,x [mm],y [mm]\n7,1.5,-2.25\n4,3.125,4\n",
             "took \"sampleID\" for a coordinate, too; --columns 2,3 leaves it out", {7, 1.5, -2.25, 4, 3.125, 4}),
        good("name_of_target.csv", "length,width,target\n1.5,-2.25,0\n3.125,4,1\n",
             "took \"target\" for a coordinate, too; --columns length,width", {1.5, -2.25, 0, 3.125, 4, 1}),
        good("name_in_front.csv", "frame,x,y\n7,1.5,-2.25\n4,3.125,4\n", "took \"frame\"",
             {7, 1.5, -2.25, 4, 3.125, 4}),
        good("names_of_two.csv", "time,u,v,label\n7,1.5,-2.25,0\n4,3.125,4,1\n",
             "took \"time\", \"label\" for coordinates, too; --columns u,v leaves them out",
             {7, 1.5, -2.25, 0, 4, 3.125, 4, 1}),
        good("names_all_alike.csv", "time,class\n7,1.5\n4,3.125\n", "skipped header \"time,class\"",
             {7, 1.5, 4, 3.125}),
        good("centroids.csv", "centroid_x,centroid_y\n1.5,-2.25\n3.125,4\n-0.5,6.75\n", "skipped header"),
        good("name_in_comment.txt", "# id x y\n7 1.5 -2.25\n4 3.125 4\n", "took \"id\"", {7, 1.5, -2.25, 4, 3.125, 4}),
        good("counting_last.csv", "1,2,7\n3,5,8\n4,4,9\n4,1,10\n1,1,11\n",
             "took column 3, which counts rows, for a coordinate; --columns 1,2 leaves it out",
             {1, 2, 7, 3, 5, 8, 4, 4, 9, 4, 1, 10, 1, 1, 11}),
        good("counting_as_double.csv", "1.0,2,7\n2.0,5,1\n3.0,4,9\n4.0,1,5\n5.0,1,2\n", "took column 1, which counts",
             {1, 2, 7, 2, 5, 1, 3, 4, 9, 4, 1, 5, 5, 1, 2}),
        // cells with blanks, delimiters and ends of lines, as RFC 4180 has them
        bad("cells.csv", lab, 2, "\"2024-03-01 10:00:00\" is not a number; --columns 3,4 leaves such columns out"),
        with(good("cells_by_name.csv", lab), "x,y"),
        with(good("cells_by_number.csv", lab), "3-4"),
        with(good("cells_semicolon.csv", replaced(lab, "Lab A", "Lab; A")), "x,y"),
        with(good("cells_of_two_words.csv", "place,x,y\nLab A,1.5,-2.25\nLab B,3.125,4\n,-0.5,6.75\n"), "x,y"),
        bad("cells_empty.csv", "place,x,y\nLab A,1.5,-2.25\nLab B,3.125,4\n,-0.5,6.75\n", 2, "--columns 2,3 leaves"),
        with(good("numbers_with_blanks.csv", "day,x,y\n2024 1,1.5,-2.25\n2024 2,3.125,4\n2024 3,-0.5,6.75\n"), "x,y"),
        good("numbers_in_cells.csv", "1.5,-2.25 7\n3.125,4 8\n-0.5,6.75 9\n",
             "commas and blanks part columns, 3 of them; --delimiter ',' takes commas alone", space),
        with(good("units_by_name.csv", "x [mm],y [mm]\n" + plain), "x [mm],y [mm]"),
        with(good("commas_in_names.csv", "\"x, raw\",\"y \"\"top\"\"\"\n" + plain), "\"x, raw\",\"y \"\"top\"\"\""),
        with(good("lines_in_cells.csv",
                  "a,x,y\r\n\"Lab\r\nA, \"\"north\"\"\",1.5,-2.25\r\nb,3.125,4\r\n\"c\n\",-0.5,6.75\r\n",
                  "2 rows have ends of lines in quotes"),
             "x,y"),
        with(bad("line_behind_cells.csv", "a,x,y\n\"Lab\nA\",1.5,-2.25\nb,?,4\n", 4, "left out or filled in"), "x,y"),
        with(good("inches.csv", "a,x,y\n5\",1.5,-2.25\n6\",3.125,4\n7\",-0.5,6.75\n"), "x,y"),
        with(bad("one_quote.csv", "a,x,y\nb,1.5,-2.25\n\"c,3.125,4\nd,-0.5,6.75\n", 3, "quotation that does not end"),
             "x,y"),
        good("comment_behind_comma.csv", "1.5,-2.25 # the first, at 9:00\n3.125,4\n-0.5,6.75\n"),
        // rows of other lengths
        bad("ragged.csv", "1.5,-2.25\n3.125,4,8\n-0.5,6.75\n", 2, "3 columns where line 1 has 2"),
        bad("cut_off.csv", "1.5,-2.25\n3.125,4\n-0.5", 3, "1 column where line 1 has 2"),
        bad("empty.csv", "", 1, "ends without a point"),
        bad("comments_only.txt", "# nothing\n#\n", 2, "ends without a point"),
        bad("header_only.csv", "x,y\n", 1, "ends without a point"),
    };
}

// As the programs that are named write them.
std::vector<OddFile> exports() {
    const std::string tabs = replaced(plain, ",", "\t"), blanks = replaced(plain, ",", " ");
    const std::string dos = replaced(plain, "\n", "\r\n");
    return {
        good("excel_utf8.csv", "\xEF\xBB\xBF" + replaced("x;y\n" + decimal_commas, "\n", "\r\n"), "skipped header"),
        good("excel_unicode_text.txt", utf16(replaced("x\ty\n" + tabs, "\n", "\r\n"), false), "skipped header"),
        good("excel_empty_rows.csv", "x,y\r\n" + dos + ",\r\n,\r\n,\r\n", "skipped 3 rows of nothing"),
        bad("excel_error.csv", "x,y\r\n1.5,-2.25\r\n3.125,#DIV/0!\r\n", 3,
            "\"#DIV/0!\" is not a number; a spreadsheet"),
        bad("excel_currency.csv", "$1.50,$2.25\n$3.125,$4\n", 1, "is not a number"),
        bad("excel_date_turned.csv", "1.5,02. Mrz\n3.125,4\n", 1, "is not a number"),
        good("libreoffice.csv", "\"x\",\"y\"\n" + plain, "skipped header"),
        bad("numbers_of_mac.csv", "Table 1,\nx,y\n1.5,-2.25\n3.125,4\n", 2, "--skip 2"),
        good("r_write_table.txt", "\"x\" \"y\"\n\"1\" 1.5 -2.25\n\"2\" 3.125 4\n\"3\" -0.5 6.75\n", "index column 1"),
        good("r_write_csv_plain.csv", "\"x\",\"y\"\n" + plain, "skipped header"),
        bad("r_na.csv", "\"\",\"x\",\"y\"\n\"1\",1.5,NA\n\"2\",3.125,4\n", 2, "left out or filled in"),
        good("r_print.txt", "        x     y\n1   1.500 -2.25\n2   3.125  4.00\n3  -0.500  6.75\n", "index column 1"),
        good("pandas_to_string.txt", "       x     y\n0  1.500 -2.25\n1  3.125  4.00\n2 -0.500  6.75\n",
             "index column 1"),
        good("pandas_named_index.csv", "index,x,y\n0,1.5,-2.25\n1,3.125,4.0\n2,-0.5,6.75\n", "index column 1"),
        bad("pandas_nan.csv", ",x,y\n0,1.5,\n1,3.125,4.0\n", 2, "nothing after the last ','"),
        good("polars.csv", "x,y\n" + plain, "skipped header"),
        good("matlab_writematrix.csv", plain),
        good("matlab_save_ascii.txt", "   1.5000000e+00  -2.2500000e+00\n   3.1250000e+00   4.0000000e+00\n"
                                      "  -5.0000000e-01   6.7500000e+00\n"),
        good("octave_csvwrite.csv", "1.5000000000000000,-2.2500000000000000\n3.1250000000000000,4\n"
                                    "-0.50000000000000000,6.7500000000000000\n"),
        good("julia_writedlm.txt", tabs),
        good("mathematica.csv", "1.5,-2.25\n3.125,4.\n-0.5,6.75\n"),
        bad("mathematica_power.txt", "1.5\t-2.25\n3.1*^2\t4\n", 2, "is not a number"),
        good("maple.txt", "1.5 -2.25\n3.125 4.\n-.5 6.75\n"),
        bad("fortran_list.txt", "  1.50000000D+00  -2.25000000D+00\n", 1, "write e in place of Fortran's d"),
        good("fortran_e.txt", "  0.150000E+01 -0.225000E+01\n  0.312500E+01  0.400000E+01\n"
                              " -0.500000E+00  0.675000E+01\n"),
        bad("fortran_overflow.txt", "  1.5000  -2.2500\n  ******   4.0000\n", 2, "is not a number"),
        bad("fortran_touching.txt", " 1.5000-2.2500\n 3.1250 4.0000\n", 1, "is not a number"),
        bad("gephi_nodes.csv", "Id,Label,X,Y\n0,a,1.5,-2.25\n1,b,3.125,4\n2,c,-0.5,6.75\n", 2, "--columns 3,4"),
        with(good("gephi_told.csv", "Id,Label,X,Y\n0,a,1.5,-2.25\n1,b,3.125,4\n2,c,-0.5,6.75\n"), "3,4"),
        good("qgis.csv", "X,Y\n" + plain, "skipped header"),
        good("qgis_fid.csv", "fid,X,Y\n1,1.5,-2.25\n2,3.125,4\n3,-0.5,6.75\n", "skipped index column 1"),
        good("cloudcompare.txt",
             "//X Y Z\n1.50000000 -2.25000000 7.00000000\n3.12500000 4.00000000 8.00000000\n"
             "-0.50000000 6.75000000 9.00000000\n",
             "", space),
        bad("cloudcompare_count.txt", "3\n1.5 -2.25 7\n3.125 4 8\n-0.5 6.75 9\n", 2, "--skip 1"),
        with(good("cloudcompare_colours.asc", "1.5 -2.25 7 255 0 0\n3.125 4 8 0 255 0\n-0.5 6.75 9 0 0 255\n", "",
                  space),
             "1-3"),
        good("meshlab.xyz", "1.5 -2.25 7\n3.125 4 8\n-0.5 6.75 9\n", "", space),
        bad("leica.pts", "3\n1.5 -2.25 7 -1 0 0 0\n3.125 4 8 -1 0 0 0\n-0.5 6.75 9 -1 0 0 0\n", 2, "--skip 1"),
        good("paraview.csv", "\"Points:0\",\"Points:1\",\"Points:2\"\n1.5,-2.25,7\n3.125,4,8\n-0.5,6.75,9\n",
             "skipped header", space),
        good("gaussian.xyz",
             "3\n\n C      1.500000     -2.250000      7.000000\n H      3.125000      4.000000      8.000000\n"
             " O     -0.500000      6.750000      9.000000\n",
             "atoms", space),
        bad("gaussian.gjf", "%chk=a.chk\n# HF/STO-3G\n\ntitle\n\n0 1\nC 1.5 -2.25 7.0\nH 3.125 4.0 8.0\n", 6,
            "--skip 6"),
        bad("gaussian.log", " Entering Gaussian System, Link 0=g09\n Initial command:\n", 1, "is not a number"),
        good("pymol.pdb", std::string(atom_1) + atom_2 + atom_3 + "CONECT    1    2\nEND\n", "atoms", space),
        good("pymol_anisotropic.pdb",
             std::string(atom_1) + "ANISOU    1  N   ALA A   1     1000   1000   1000\n" + atom_2 + atom_3 + "END\n",
             "atoms", space),
        good("vmd.xyz",
             "3\n generated by VMD\n  C         1.500000       -2.250000        7.000000\n"
             "  H         3.125000        4.000000        8.000000\n"
             "  O        -0.500000        6.750000        9.000000\n",
             "atoms", space),
        good("apbs.pqr",
             "ATOM      1  N   ALA     1       1.500  -2.250   7.000 -0.3000 1.8500\n"
             "ATOM      2  CA  ALA     1       3.125   4.000   8.000  0.2000 2.0000\n"
             "ATOM      3  C   ALA     1      -0.500   6.750   9.000  0.1000 2.0000\n",
             "atoms", space),
        bad("charmm.crd", "* TITLE\n    3\n    1    1 ALA  N      1.50000  -2.25000   7.00000\n", 1, "is not a number"),
        bad("vasp.poscar", "Si\n1.0\n5.43 0.0 0.0\n0.0 5.43 0.0\n", 3, "3 columns where line 2 has 1"),
        bad("sdf.mol", "\n  RDKit          2D\n\n  3  2  0  0\n    1.5   -2.25    7.0 C\n", 2, "is not a number"),
        good("gnuplot_table.dat", "# Curve 0 of 1, 3 points\n# x y type\n1.5 -2.25\n3.125 4\n-0.5 6.75\n\n"),
        with(good("gnuplot_type.dat", "# x y type\n1.5 -2.25 i\n3.125 4 i\n-0.5 6.75 o\n"), "1,2"),
        good("origin.dat", "X\tY\n\t\n" + tabs, "skipped header"),
        bad("labview.lvm", "LabVIEW Measurement\t\nWriter_Version\t2\n", 2, "is not a number"),
        good("sas.csv", "x,y\r\n" + dos, "skipped header"),
        bad("sas_missing.csv", "x,y\n1.5,.\n3.125,4\n", 2, "left out or filled in"),
        good("spss.dat", "x\ty\n" + tabs, "skipped header"),
        bad("stata_missing.csv", "x,y\n1.5,.\n3.125,4\n", 2, "left out or filled in"),
        good("weka_free.arff", "% relation\n" + plain),
        bad("weka.arff", "@RELATION a\n@ATTRIBUTE x NUMERIC\n@DATA\n" + plain, 2, "--skip 2"),
        good("sql_dump.txt", " x     | y\n" + replaced(plain, ",", " | "), "skipped header"),
        bad("psql.txt", "   x   |   y\n-------+-------\n   1.5 | -2.25\n 3.125 |     4\n", 2, "--skip 2"),
        bad("markdown.md", "| x | y |\n|---|---|\n| 1.5 | -2.25 |\n", 2, "--skip"),
        bad("latex.tex", "1.5 & -2.25 \\\\\n3.125 & 4 \\\\\n", 1, "is not a number"),
        good("garmin.csv", "lat,lon\n" + plain, "skipped header"),
        bad("gps_degrees.csv",
            "lat,lon\n48\xC2\xB0"
            "08'N,11\xC2\xB0"
            "34'E\n",
            2, "is not a number"),
        bad("usgs.csv", "time,latitude,longitude\n2024-01-01T00:00:00Z,1.5,-2.25\n2024-01-02T00:00:00Z,3.125,4\n", 2,
            "--columns 2,3"),
        with(good("usgs_told.csv", "time,latitude,longitude\n2024-01-01T00:00:00Z,1.5,-2.25\n"
                                   "2024-01-02T00:00:00Z,3.125,4\n2024-01-03T00:00:00Z,-0.5,6.75\n"),
             "latitude,longitude"),
        bad("opencv.yml", "%YAML:1.0\n---\na: !!opencv-matrix\n   rows: 3\n", 2, "is not a number"),
        bad("svm_light.txt", "1 1:1.5 2:-2.25\n-1 1:3.125 2:4\n", 1, "is not a number"),
        bad("matrix_market.mtx", "%%MatrixMarket matrix array real general\n3 2\n1.5\n3.125\n-0.5\n", 1, ".npy"),
        bad("geojson.json", "{\"type\":\"FeatureCollection\"}\n", 1, "JSON"),
        bad("wkt.csv", "POINT (1.5 -2.25)\nPOINT (3.125 4)\n", 1, "is not a number"),
        bad("kml.kml", "<?xml version=\"1.0\"?>\n<kml>\n", 1, "XML"),
        bad("blender_colours.ply",
            "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
            "property float z\nend_header\n1 2 3\n",
            8, "ends after 1 of 2"),
        bad("format_twice.ply", "ply\nformat ascii 1.0\nformat binary_little_endian 1.0\n", 3, "a second format line"),
        bad("list_length.ply", "ply\nformat ascii 1.0\nelement a 1\nproperty list float int q\n", 4,
            "lengths are whole numbers"),
        bad("vertex_twice.ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nelement vertex 1\n", 6,
            "a second element vertex"),
        bad("property_twice.ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float x\n", 6,
            "a second property \"x\""),
        bad("meshlab_count.off", "OFF\n2 1 0\n1 2 3\n4 5 6\n7 8 9\n3 0 1 2\n", 5, "a vertex too many?"),
        bad("geomview_colours.off", "COFF\n1 0 0\n1 2 3\n", 3, "a vertex of 3 numbers"),
    };
}

std::vector<OddFile> formats() {
    const std::string ascii_stl = "solid a\n" + triangle("1.5 -2.25 7", "3.125 4 8", "-0.5 6.75 9") +
                                  triangle("1.5 -2.25 7", "-0.5 6.75 9", "3.125 4 8") + "endsolid a\n";
    const std::string obj = "# Blender\nmtllib a.mtl\no a\nv 1.5 -2.25 7\nv 3.125 4 8\nv -0.5 6.75 9\nvn 0 0 1\n"
                            "vt 0 0\nf 1//1 2//1 3//1\n";
    const std::string xyz = "3\nmade by hand\nC 1.5 -2.25 7\nH 3.125 4 8\nO -0.5 6.75 9\n";
    const std::string pqr = "REMARK   1\nATOM 1 N ALA 1 1.5 -2.25 7 -0.3 1.85\nATOM 2 CA ALA 1 3.125 4 8 0.2 2.0\n"
                            "HETATM 3 C ALA A 1 -0.5 6.75 9 0.1 2.0\nTER\nEND\n";
    return {
        good("atoms.xyz", xyz, "atoms", space),
        good("atoms_by_number.xyz", replaced(replaced(replaced(xyz, "C ", "6 "), "H ", "1 "), "O ", "8 "), "atoms",
             space),
        good("atoms_extended.xyz", replaced(xyz, "9\n", "9 0.1 0.2\n"), "atoms", space),
        good("atoms_without_comment.xyz", replaced(xyz, "made by hand", ""), "atoms", space),
        good("points.xyz", "1.5 -2.25 7\n3.125 4 8\n-0.5 6.75 9\n", "", space),
        bad("frames.xyz", xyz + xyz, 6, "head -n 5"),
        bad("atoms_cut.xyz", replaced(xyz, "3\n", "4\n"), 5, "line 1 has to say how many"),
        bad("atoms_bad.xyz", replaced(xyz, "3.125", "3,125"), 4, "is not a number"),
        good("protein.pdb", std::string("HEADER    A\nREMARK 1\n") + atom_1 + atom_2 + atom_3 + "TER\nEND\n", "atoms",
             space),
        good("models.pdb",
             std::string("MODEL 1\n") + atom_1 + atom_2 + atom_3 + "ENDMDL\nMODEL 2\n" + atom_1 + "ENDMDL\nEND\n",
             "first of its 2 models", space),
        good("alternates.ent", std::string(atom_1) + atom_2 + first_3 + other_3, "without 1 at alternate places",
             space),
        bad("short.pdb", "ATOM 1 N ALA 1 1.5 -2.25 7\n", 1, ".pqr"),
        bad("no_atom.pdb", "REMARK nothing\n", 1, "a table is named"),
        bad("bad_number.pdb", replaced(atom_1, "-2.250", "-2.2x0"), 1, "is not a number"),
        good("charges.pqr", pqr, "atoms", space),
        bad("charges_short.pqr", "ATOM 1 N 1.5\n", 1, "charge and radius"),
        bad("charges_no_radius.pqr", "ATOM 1 N ALA 1 0 0 0 0.4\n", 1, "charge and radius"),
        bad("charges_chain_no_radius.pqr", "ATOM 1 N ALA A 1 0 0 0 0.4\n", 1, "charge and radius"),
        bad("charges_touch.pqr", "ATOM 1 N ALA 1 0.5 0.2 0.1-0.4 1.8\n", 1, "charge and radius"),
        bad("forces.xyz", "1\nProperties=species:S:1:forces:R:3:pos:R:3\nC 9 8 7 0 0 0\n", 2, "columns 2 to 4"),
        good("cell.xyz", replaced(xyz, "made by hand", "Lattice=\"9 0 0 0 9 0 0 0 9\" pbc=\"T T T\""),
             "without its periodic cell", space),
        good("crystal.pdb",
             std::string("CRYST1   52.000   58.600   61.900  90.00  90.00  90.00 P 21 21 21    8\n") + atom_1 + atom_2 +
                 atom_3,
             "without its periodic cell", space),
        good("no_crystal.pdb",
             std::string("CRYST1    1.000    1.000    1.000  90.00  90.00  90.00 P 1           1\n") + atom_1 + atom_2 +
                 atom_3,
             "read as atoms of .pdb", space),
        good("properties.xyz", replaced(xyz, "made by hand", "Lattice=\"9 0 0\" Properties=species:S:1:pos:R:3 pbc=T"),
             "atoms", space),
        good("properties_more.xyz",
             replaced(replaced(xyz, "made by hand", "Properties=species:S:1:pos:R:3:q:R:1"), "9\n", "9 1\n"), "atoms",
             space),
        good("properties_word.xyz",
             replaced(xyz, "made by hand", "c=\"properties of a\" Properties=species:S:1:pos:R:3"), "atoms", space),
        bad("properties_word_alone.xyz", replaced(xyz, "made by hand", "properties of a"), 2,
            "take the line's text out"),
        bad("properties_blanks.xyz", "1\nProperties = species:S:1:forces:R:3:pos:R:3\nC 9 8 7 0 0 0\n", 2,
            "without blanks"),
        bad("properties_numbers.xyz", "1\nProperties = id:I:1:Z:I:1:pos:R:3\n1 6 0 0 0\n", 2, "without blanks"),
        bad("properties_quoted.xyz", "1\n\"Properties\"=species:S:1:forces:R:3:pos:R:3\nC 9 8 7 0 0 0\n", 2,
            "take the line's text out"),
        bad("properties_small.xyz", "1\nproperties=species:S:1:forces:R:3:pos:R:3\nC 9 8 7 0 0 0\n", 2,
            "without blanks"),
        bad("properties_many.xyz", "1\nProperties=species:S:1:pos:R:30\nC 9 8 7 0 0 0\n", 2, "columns 2 to 4"),
        bad("properties_twice.xyz",
            "1\nProperties=species:S:1:pos:R:3 Properties=species:S:1:forces:R:3:pos:R:3\nC 9 8 7 0 0 0\n", 2,
            "columns 2 to 4"),
        bad("decimal_commas.obj", "v 0,5 0,25 0,75\n", 1, "parted by blanks"),
        good("blender.obj", obj, "vertices", space),
        good("colours.obj", replaced(replaced(obj, " 7\n", " 7 1 0 0\n"), " 8\n", " 8 1\n"), "vertices", space),
        bad("weights.obj", replaced(obj, " 8\n", " 8 0.5\n"), 5, "write x y z alone"),
        bad("flat.obj", replaced(obj, " 8\n", "\n"), 5, "2 numbers where 3 are due"),
        bad("no_vertex.obj", "# nothing\n", 1, "a table is named"),
        good("ascii.stl", ascii_stl, "3 different corners of 2 triangles", space),
        good("binary.stl", binary_stl(2, 2), "3 different corners of 2 triangles", space),
        bad("cut_off.stl", replaced(ascii_stl, "endsolid a\n", ""), 15, "copy it again"),
        bad("cut_off_within.stl", ascii_stl.substr(0, 200), 13, "was the file cut off?"),
        bad("binary_cut_off.stl", binary_stl(3, 2), 0, "was it cut off?"),
        bad("binary_nan.stl", replaced(binary_stl(1, 1), "\0\0\xC0\x3F"s, "\0\0\xC0\x7F"s), 0, "finite double"),
        // names that say something else
        bad("array.txt", "\x93NUMPY\x01\0v\0{"s, 0, "name it .npy"),
        bad("surface.txt", "OFF\n1 0 0\n1 2 3\n", 0, "name it .off"),
        bad("surface.csv", "ply\nformat ascii 1.0\n", 0, "name it .ply"),
        bad("triangles.txt", ascii_stl, 0, "name it .stl"),
        bad("triangles_binary.dat.txt", binary_stl(1, 1), 0, "name it .stl"),
        bad("protein.txt", std::string(atom_1) + atom_2, 0, "name it .pdb"),
        bad("text.npy", plain, 0, "if it is text"),
        bad("text.npz", plain, 0, "if it is text"),
        bad("text.off", plain, 1, "an OFF file starts with"),
        bad("text.ply", plain, 1, "a PLY file starts with"),
        bad("text.stl", plain, 0, "starts with solid"),
        bad("text.csv.gz", plain, 0, "take .gz off its name"),
        good("triangles_without_ending", ascii_stl, "corners", space),
        good("surface.dat", "OFF\n3 0 0\n1.5 -2.25 7\n3.125 4 8\n-0.5 6.75 9\n", "", space),
        // what is no list of points at all
        bad("workbook.csv", "PK\x03\x04\x14\0\x06\0 xl/worksheets"s, 1, "save the table as CSV"),
        bad("workbook.xls", "\xD0\xCF\x11\xE0\xA1\xB1"s, 1, "save the table as CSV"),
        bad("page.csv", "<!DOCTYPE html>\n<html>\n", 1, "HTML"),
        bad("page_2.csv", "<html><body>404</body></html>\n", 1, "HTML"),
        bad("document.txt", "%PDF-1.4\n", 1, "PDF"),
        bad("letter.txt", "{\\rtf1 1 2}\n", 1, "plain text"),
        bad("picture.txt", "\x89PNG\r\n\x1A\n"s, 1, "not points"),
        bad("packed.csv", "BZh91AY"s, 1, "bunzip2"),
        bad("packed_2.csv",
            "\xFD"
            "7zXZ\0"s,
            1, "unxz"),
        bad("packed_3.csv", "\x28\xB5\x2F\xFD"s, 1, "unzstd"),
        bad("hdf.h5", "\x89HDF\r\n\x1A\n"s, 1, ".npy or .csv"),
        bad("matrix.mat", "MATLAB 5.0 MAT-file, Platform"s, 1, "writematrix"),
        bad("pickle.pkl", "\x80\x04\x95"s, 1, "numpy.save"),
        bad("frame.parquet", "PAR1\x15"s, 1, "to_csv"),
        bad("lidar.las", "LASF\0\0"s, 1, "las2txt"),
        bad("cloud.pcd", "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\n", 1, "pcl_pcd2ply"),
        bad("grid.vtu", "<?xml version=\"1.0\"?>\n<VTKFile>\n", 1, "as a table in text"),
        bad("grid.vtk", "# vtk DataFile Version 3.0\n", 1, "as a table in text"),
        bad("gmsh.msh", "$MeshFormat\n2.2 0 8\n", 1, "as a table in text"),
        bad("protein.cif", "data_1ABC\n_atom_site.id\n", 1, ".pdb or .xyz"),
        bad("dump.lammpstrj", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\n", 1, "dump of LAMMPS"),
        bad("data.lmp", "LAMMPS data file via write_data\n\n2 atoms\n", 1, "data file of LAMMPS"),
        bad("matrix.mtx", "%%MatrixMarket matrix array real general\n2 2\n1\n2\n3\n4\n", 1, "MatrixMarket"),
        bad("ligand.mol2", "@<TRIPOS>MOLECULE\nbenzene\n", 1, "MOL2"),
        bad("ligand.sdf", "benzene\n  made\n\n  2  1  0  0  0  0            999 V2000\n    1.0 2.0 3.0 C\n", 1, "SDF"),
        bad("POSCAR", "Si\n 5.43\n 1 0 0\n 0 1 0\n 0 0 1\nSi\n2\nDirect\n 0 0 0\n .25 .25 .25\n", 1, "POSCAR"),
        bad("POSCAR_of_old", "Si\n 5.43\n 1 0 0\n 0 1 0\n 0 0 1\n2\nSelective dynamics\nCartesian\n 0 0 0 T T T\n", 1,
            "POSCAR"),
        bad("water.gro",
            "water\n 2\n    1WATER  OW1    1   0.126   1.624   1.679\n    1WATER  HW2    2   0.190   1.661   "
            "1.747\n   1.8 1.8 1.8\n",
            1, "GRO"),
        bad("pointer.csv", "version https://git-lfs.github.com/spec/v1\noid sha256:1\n", 1, "git lfs pull"),
        bad("database.csv", "SQLite format 3\0"s, 1, "as CSV"),
        bad("raw.bin", "\x01\0\0\0\x02\0\0\0"s, 1, "numbers in binary are read from .npy"),
        bad("zeros_behind.csv", plain + "\0\0"s, 4, "so this is no text"),
    };
}

TableOptions options_of(const OddFile& file) {
    TableOptions options;
    if (!file.columns.empty()) CHECK(parse_columns(file.columns, &options.columns) == "");
    if (!file.delimiter.empty()) options.delimiter = file.delimiter == "blank" ? ' ' : file.delimiter[0];
    options.skip = file.skip;
    return options;
}

void check(const OddFile& file, const std::string& folder) {
    CAPTURE(file.name);
    CAPTURE(file.content);
    std::ofstream(folder + file.name, std::ios::binary) << file.content;
    PointCloud cloud;
    const Outcome outcome = read_points(folder + file.name, options_of(file), &cloud);
    CAPTURE(outcome.message);
    if (!file.points.empty()) {
        CHECK(outcome.good());
        CHECK(cloud.coordinates == file.points);
        if (file.points == three || file.points == space) CHECK(cloud.dim == (file.points == space ? 3 : 2));
        CHECK(file.points.size() % cloud.dim == 0);
        CAPTURE(cloud.note);
        if (file.says.empty() && file.columns.empty() && file.skip == 0 && file.delimiter.empty())
            CHECK(cloud.note == "");
        CHECK(cloud.note.find(file.says) != std::string::npos);
        return;
    }
    CHECK(outcome.exit == Exit::data);
    const std::string place = file.line == 0 ? ": " : ":" + std::to_string(file.line) + ": ";
    CHECK(outcome.message.rfind(folder + file.name + place, 0) == 0);
    CHECK(outcome.message.find(file.says) != std::string::npos);
    for (const char c : outcome.message) CHECK(static_cast<unsigned char>(c) >= 0x20);
}

}  // namespace

TEST_CASE("odd files: the right points, or a refusal with line and remedy") {
    char name[] = "/tmp/netmesh-odd-XXXXXX";
    REQUIRE(mkdtemp(name) != nullptr);
    const std::string folder = std::string(name) + "/";
    std::vector<OddFile> files = tables();
    for (OddFile& file : exports()) files.push_back(std::move(file));
    for (OddFile& file : formats()) files.push_back(std::move(file));
    std::set<std::string> names;
    for (const OddFile& file : files) {
        CHECK(names.insert(file.name).second);
        check(file, folder);
    }
    CHECK(files.size() >= 150);
    std::filesystem::remove_all(folder);
}
