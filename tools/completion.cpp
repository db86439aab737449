#include "tools/completion.hpp"

#include "tools/option_table.hpp"

namespace netmesh::tool {

namespace {

std::string joined(const std::vector<std::string>& words, const char* between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
    return text;
}

std::string command_names(const char* between) {
    std::vector<std::string> names;
    for (const CommandEntry& command : command_entries()) names.emplace_back(command.name);
    return joined(names, between);
}

template <class Visit> void for_each_entry(Command command, Visit visit) {
    for (const OptionEntry& option : option_entries())
        if ((option.commands & bit(command)) != 0) visit(option);
}

std::string bash_text() {
    std::string values, options;
    for (const CommandEntry& command : command_entries()) {
        const std::string name = command.name;
        std::string own, plain;
        for_each_entry(command.command, [&](const OptionEntry& option) {
            own += std::string(own.empty() ? "" : " ") + option.name;
            const std::vector<std::string> words = words_of(option, command.command);
            const std::string at = name + ":" + option.name;
            if (!words.empty())
                values += "    " + at + ") words='" + joined(words, " ") + "' ;;\n";
            else if (option.value != nullptr && !names_file(option))
                plain += (plain.empty() ? "" : "|") + at;
        });
        if (!plain.empty()) values += "    " + plain + ") return ;;\n";
        options += "    " + name + ") options='" + own + " -q --help' ;;\n";
    }
    return "# Completion of netmesh for bash, made by `netmesh --completion bash`.\n"
           "_netmesh() {\n"
           "    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}\n"
           "    local command= word words= options=\n"
           "    COMPREPLY=()\n"
           "    for word in \"${COMP_WORDS[@]:1:COMP_CWORD - 1}\"; do\n"
           "        case $word in " +
           command_names("|") +
           "|help) command=$word; break ;; esac\n"
           "    done\n"
           "    case $command:$before in\n" +
           values + "    help:*) words='" + command_names(" ") +
           "' ;;\n"
           "    esac\n"
           "    case $command in\n"
           "    '') words='" +
           command_names(" ") + " help --help --version --completion --manual' ;;\n" + options +
           "    esac\n"
           "    if [[ -z $words && $current == -* ]]; then words=$options; fi\n"
           "    if [[ -n $words ]]; then\n"
           "        COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
           "    fi\n"
           "    if [[ ${#COMPREPLY[@]} == 0 && -n $command && $current != -* ]]; then\n"
           "        while IFS= read -r word; do [ -z \"$word\" ] || COMPREPLY+=(\"$word\"); done "
           "<<<\"$(compgen -f -- \"$current\")\"\n"
           "    fi\n"
           "}\n"
           "complete -o filenames -F _netmesh netmesh\n";
}

// Of a help text what _arguments can show: up to the first mark behind which more is explained.
std::string short_help(const std::string& help) {
    std::string text = help.substr(0, help.find_first_of(";:[\n"));
    std::string escaped;
    for (const char c : text) escaped += c == '\'' ? std::string("'\\''") : c == ']' ? "\\]" : std::string(1, c);
    return escaped;
}

std::string zsh_text() {
    std::string cases, commands;
    for (const CommandEntry& command : command_entries()) {
        commands += std::string("        '") + command.name + ":" + short_help(command.summary) + "'\n";
        cases += std::string("    ") + command.name + ")\n        _arguments -S '*:file:_files' \\\n";
        for_each_entry(command.command, [&](const OptionEntry& option) {
            std::string spec = std::string(option.name) + "[" + short_help(option.help) + "]";
            const std::vector<std::string> words = words_of(option, command.command);
            if (option.value != nullptr)
                spec += ":value:" + (!words.empty()       ? "(" + joined(words, " ") + ")"
                                     : names_file(option) ? "_files"
                                                          : " ");
            cases += "            '" + spec + "' \\\n";
        });
        cases += "            '(-h --help)'{-h,--help}'[help]' ;;\n";
    }
    return "#compdef netmesh\n"
           "# Completion of netmesh for zsh, made by `netmesh --completion zsh`.\n"
           "_netmesh() {\n"
           "    local -a commands\n"
           "    commands=(\n" +
           commands +
           "        'help:all options of a command'\n"
           "    )\n"
           "    if (( CURRENT == 2 )); then _describe command commands; return; fi\n"
           "    local command=$words[2]\n"
           "    shift words\n"
           "    (( CURRENT-- ))\n"
           "    case $command in\n" +
           cases +
           "    help) _describe command commands ;;\n"
           "    esac\n"
           "}\n"
           "_netmesh \"$@\"\n";
}

}  // namespace

std::string completion_text(const std::string& shell) { return shell == "bash" ? bash_text() : zsh_text(); }

}  // namespace netmesh::tool
