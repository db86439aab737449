#include "tools/plot/text_width.hpp"

#include <cstddef>
#include <cstdint>

namespace netmesh::tool {

namespace {

// Thousandths of the size, of the characters from the blank to ~: those of DejaVu Sans, the widest of the four fonts
// for all characters but @.
constexpr std::uint16_t regular[] = {318,  401, 460, 838, 637, 951, 780, 275, 391, 391, 500, 838, 318, 361, 318, 337,
                                     637,  637, 637, 637, 637, 637, 637, 637, 637, 637, 337, 337, 838, 838, 838, 531,
                                     1015, 685, 687, 699, 771, 632, 576, 775, 752, 295, 295, 656, 558, 863, 749, 788,
                                     604,  788, 695, 635, 611, 732, 685, 989, 686, 611, 686, 391, 337, 391, 838, 500,
                                     500,  613, 635, 550, 635, 616, 353, 635, 634, 278, 278, 580, 278, 975, 634, 612,
                                     635,  635, 412, 521, 393, 634, 592, 818, 592, 592, 525, 637, 337, 637, 838};
constexpr std::uint16_t bold_ones[] = {
    349, 457,  521, 838, 696, 1002, 873, 307, 458, 458, 523, 838, 380, 416,  380, 366, 696, 696,  696,
    696, 696,  696, 696, 696, 696,  696, 400, 400, 838, 838, 838, 611, 1015, 774, 763, 734, 831,  684,
    684, 821,  837, 373, 373, 775,  638, 996, 837, 851, 733, 851, 771, 721,  683, 813, 774, 1104, 771,
    725, 726,  458, 366, 458, 838,  500, 500, 675, 716, 593, 716, 679, 436,  716, 712, 343, 343,  666,
    343, 1042, 712, 688, 716, 716,  494, 596, 479, 712, 652, 924, 646, 652,  583, 712, 366, 712,  838};
constexpr std::uint16_t other = 1100;  // ellipsis, signs of relations, letters of other scripts

bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }

// Superscript and subscript digits, which pictures are full of.
bool is_small_digit(std::string_view text, std::size_t at) {
    const std::string_view two = text.substr(at, 2), three = text.substr(at, 3);
    return two == "\xC2\xB2" || two == "\xC2\xB3" || (three >= "\xE2\x81\xB0" && three <= "\xE2\x82\x89");
}

constexpr const char* ellipsis = "\xE2\x80\xA6";

}  // namespace

double text_width(std::string_view text, double size, bool bold) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < text.size(); i++) {
        const unsigned char c = static_cast<unsigned char>(text[i]);
        if (!begins_character(text[i])) continue;
        if (c >= 32 && c < 127) {
            sum += bold ? bold_ones[c - 32] : regular[c - 32];
        } else {
            sum += is_small_digit(text, i) ? 440 : other;
        }
    }
    return static_cast<double>(sum) * size / 1000;
}

std::string fitted_text(std::string_view text, double size, bool bold, double width) {
    if (text_width(text, size, bold) <= width) return std::string(text);
    std::size_t end = text.size();
    std::string cut;
    do {
        if (end == 0) return "";
        for (end--; end > 0 && !begins_character(text[end]); end--) {
        }
        cut = std::string(text.substr(0, end)) + ellipsis;
    } while (text_width(cut, size, bold) > width);
    return cut;
}

std::vector<std::string> wrapped_text(std::string_view text, double size, bool bold, double width) {
    std::vector<std::string> lines;
    std::string line;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = text.find(' ', at);
        if (end == std::string_view::npos) end = text.size();
        const std::string_view word = text.substr(at, end - at);
        const std::string longer = line.empty() ? std::string(word) : line + " " + std::string(word);
        if (!line.empty() && text_width(longer, size, bold) > width) {
            lines.push_back(fitted_text(line, size, bold, width));
            line = word;
        } else {
            line = longer;
        }
        at = end + 1;
    }
    if (!line.empty()) lines.push_back(fitted_text(line, size, bold, width));
    return lines;
}

}  // namespace netmesh::tool
