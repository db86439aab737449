// netmesh, the command-line tool.
#include <string>
#include <vector>

#include "platform/interrupt.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/output.hpp"
#include "tools/completion.hpp"
#include "tools/manual.hpp"
#include "tools/option_use.hpp"

namespace {

using namespace netmesh::tool;

bool asks_for_text(const Options& options) {
    return options.version || options.help || options.manual || !options.completion.empty();
}

Outcome run(const Options& options) {
    if (asks_for_text(options)) {
        std::string text = options.version ? version_text() : help_text(options.command);
        if (!options.completion.empty()) text = completion_text(options.completion);
        if (options.manual) text = manual_text(options.command);
        const char* const key = options.version  ? nullptr
                                : options.help   ? "help"
                                : options.manual ? "manual"
                                                 : "completion";
        if (options.json) text = json_text(options.command, key, text);
        return write_files({{"", [&](TextWriter& out) { out << text; }}});
    }
    const Outcome used = check_use(options);
    if (!used.good()) return used;
    if (options.command != Command::sample && options.positionals.size() == 1) {
        const Outcome apart = check_apart(options);
        if (!apart.good()) return apart;
    }
    switch (options.command) {
    case Command::homology: return run_homology(options);
    case Command::distance: return run_distance(options);
    case Command::vineyard: return run_vineyard(options);
    case Command::size: return run_size(options);
    case Command::check: return run_check(options);
    case Command::sample: return run_sample(options);
    case Command::pieces: return run_pieces(options);
    default: return options.distances ? run_distances(options) : run_engine_command(options);
    }
}

}  // namespace

int main(int count, char** arguments) {
    Options options;
    const Outcome outcome = without_exceptions([&] {
        const std::vector<std::string> given(arguments + (count > 0), arguments + count);
        const Outcome parsed = parse_options(given, &options);
        if (!parsed.good() || asks_for_text(options)) options.json = asks_for_json(given);
        if (!parsed.good()) return parsed;
        netmesh::platform::catch_interrupts();
        return run(options);
    });
    tell_error(outcome, options.command, options.json);
    return static_cast<int>(outcome.exit);
}
