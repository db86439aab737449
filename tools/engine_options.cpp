#include "tools/engine_options.hpp"

#include <cstring>

#include "tools/io/numbers.hpp"

namespace netmesh::tool {

namespace {

struct Row {
    netmesh_option option;
    std::vector<netmesh_option_word> words;
};

const std::vector<Row>& rows() {
    static const std::vector<Row> table = [] {
        std::vector<Row> all;
        for_each_option([&](std::uint32_t index, const netmesh_option& option) {
            all.push_back({option, {}});
            for_each_option_word(index, [&](const netmesh_option_word& word) { all.back().words.push_back(word); });
        });
        return all;
    }();
    return table;
}

const Row& row_of(const std::string& name) {
    std::size_t i = 0;
    while (name != rows()[i].option.name) i++;
    return rows()[i];
}

// Members are read and written as bytes: what they are is for the table to say.
template <class Member> Member get(const netmesh_request& request, const netmesh_option& option) {
    Member value;
    std::memcpy(&value, reinterpret_cast<const unsigned char*>(&request) + option.offset, sizeof value);
    return value;
}
template <class Member> void set(netmesh_request* request, const netmesh_option& option, Member value) {
    std::memcpy(reinterpret_cast<unsigned char*>(request) + option.offset, &value, sizeof value);
}

// What is 0 by default is not asked for.
template <class Member> bool takes(const netmesh_option& option, Member value) {
    return value != 0 || get<Member>(netmesh_default_request(), option) != 0;
}

bool set_number(netmesh_request* request, const netmesh_option& option, const std::string& text) {
    std::uint64_t number;
    double x;
    if (option.type == NETMESH_OPTION_DOUBLE) {
        if (!parse_finite(text, &x) || !takes(option, x)) return false;
        set(request, option, x);
        return true;
    }
    if (!parse_unsigned(text, &number)) return false;
    if (option.type == NETMESH_OPTION_UINT64) {
        set(request, option, number);
        return true;
    }
    const std::uint32_t narrow = static_cast<std::uint32_t>(number);
    if (number >= NETMESH_OPEN || !takes(option, narrow)) return false;
    set(request, option, narrow);
    return true;
}

bool set_words(netmesh_request* request, const Row& row, const std::string& text) {
    const bool is_union = row.option.type == NETMESH_OPTION_NAMES, all = is_union && text == "all";
    std::uint32_t value = 0;
    for (const netmesh_option_word& word : row.words) {
        if (!all && text != word.name) continue;
        if (word.object != nullptr) set(request, row.option, word.object);
        value |= word.value;
        if (word.object == nullptr) set(request, row.option, value);
        if (!all) return true;
    }
    return all;
}

}  // namespace

const netmesh_option& engine_option(const std::string& name) { return row_of(name).option; }

std::vector<std::string> engine_words(const std::string& name) {
    std::vector<std::string> words;
    for (const netmesh_option_word& word : row_of(name).words) words.emplace_back(word.name);
    return words;
}

std::string set_option(netmesh_request* request, const std::string& name, const std::string& text) {
    const Row& row = row_of(name);
    const netmesh_option& option = row.option;
    if (option.type == NETMESH_OPTION_FLAG) {
        option.object != nullptr ? set(request, option, option.object) : set(request, option, std::uint32_t{1});
        return {};
    }
    const bool of_words = option.type == NETMESH_OPTION_NAME || option.type == NETMESH_OPTION_NAMES;
    const bool good = of_words ? set_words(request, row, text) : set_number(request, option, text);
    return good ? "" : "must be " + std::string(of_words || option.range[0] == 'a' ? "" : "a number ") + option.range;
}

std::string option_text(const netmesh_request& request, const std::string& name) {
    const Row& row = row_of(name);
    const netmesh_option& option = row.option;
    switch (option.type) {
    case NETMESH_OPTION_UINT32: return std::to_string(get<std::uint32_t>(request, option));
    case NETMESH_OPTION_UINT64: return std::to_string(get<std::uint64_t>(request, option));
    case NETMESH_OPTION_DOUBLE: return number_text(get<double>(request, option));
    case NETMESH_OPTION_NAME:
        for (const netmesh_option_word& word : row.words)
            if (word.object != nullptr ? get<const void*>(request, option) == word.object
                                       : get<std::uint32_t>(request, option) == word.value)
                return word.name;
        return {};
    default: return {};
    }
}

bool is_given(const netmesh_request& request, const std::string& name) {
    const netmesh_option& option = engine_option(name);
    if (option.type != NETMESH_OPTION_FLAG)
        return option_text(request, name) != option_text(netmesh_default_request(), name);
    return option.object != nullptr ? get<const void*>(request, option) != nullptr
                                    : get<std::uint32_t>(request, option) != 0;
}

}  // namespace netmesh::tool
