// SPDX-License-Identifier: Apache-2.0
#include "manual.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "typescript.h"

namespace rakelight::apps {
namespace {

/// "-o, --output FILE"; "--shadows [on|off]".
std::string written(const Option& option) {
    std::string text = option.letter ? std::string("-") + option.letter + ", " : "";
    text += std::string("--") + option.name;
    if (option.also) text += std::string(", --") + option.also;
    if (option.form == Form::on_off) return text + " [on|off]";
    return *option.type ? text + " " + option.type : text;
}

/// The remark after the help.
std::string remark(const Option& option) { return option.is_required ? " (required)" : ""; }

/// "rakelight render MODEL... [OPTIONS]"
std::string usage(const Program& program, const Command& command) {
    std::string text = std::string(program.name) + " " + command.name;
    for (const Positional& p : command.positionals) {
        const std::string word = std::string(p.name) + (p.is_list ? "..." : "");
        text += p.is_required ? " " + word : " [" + word + "]";
    }
    return text + " [OPTIONS]";
}

/// Calls title(group) and row(option): groups in the order in which they begin, with all that is theirs.
void walk(const Command& command, const std::function<void(const char*)>& title,
          const std::function<void(const Option&)>& row) {
    std::vector<std::string> groups;
    for (const Option& option : command.options)
        if (!option.is_hidden && std::ranges::find(groups, option.group) == groups.end())
            groups.emplace_back(option.group);
    for (const std::string& group : groups) {
        title(group.c_str());
        for (const Option& option : command.options)
            if (!option.is_hidden && group == option.group) row(option);
    }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

/// Text for man(7): backslashes and hyphens as they are, no control line by chance.
std::string roff(const std::string& text) {
    std::string out = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
    for (const char* const mark : {"\n.", "\n'"}) out = replaced(out, mark, std::string("\n\\&") + mark[1]);
    return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

std::string roff_block(const std::string& text) { return ".nf\n" + roff(text) + "\n.fi\n"; }

std::string roff_item(const std::string& head, const std::string& text) {
    return ".TP\n.B " + roff(replaced(head, "\"", "")) + "\n" + roff(text) + "\n";
}

/// Text in a cell of a table in Markdown.
std::string cell(const std::string& text) {
    return replaced(replaced(replaced(text, "|", "\\|"), "<", "&lt;"), "*", "\\*");
}

/// Rows of commands before, and the first command that has each.
using Shown = std::map<std::string, std::string>;

/// Options that an earlier command has alike, by command: names of whole groups, then of single options.
struct Alike {
    std::vector<std::string> groups, options;
};

/// Links to them: "As in render: all of Camera, Materials; --threads, --json".
std::string markdown_links(const std::map<std::string, Alike>& alike) {
    std::string out;
    for (const auto& [command, names] : alike) {
        std::string groups, options;
        for (const std::string& name : names.groups) groups += (groups.empty() ? "all of " : ", ") + name;
        for (const std::string& name : names.options) options += (options.empty() ? "" : ", ") + ("`--" + name + "`");
        out += "\n**As in [" + command + "](#" + command + ")**: " + groups +
               (groups.empty() || options.empty() ? "" : "; ") + options + "\n";
    }
    return out;
}

/// The options of a command in a group that are not hidden.
std::size_t count_in_group(const Command& command, std::string_view group) {
    return std::size_t(std::ranges::count_if(
        command.options, [group](const Option& option) { return !option.is_hidden && option.group == group; }));
}

/// The rows of one group that no command before has; the others go to `alike`.
std::string markdown_group(const Program& program, const Command& command, const std::string& group, Shown& shown,
                           std::map<std::string, Alike>& alike) {
    std::string out;
    std::map<std::string, std::vector<std::string>> known;  // command -> its options
    for (const Option& option : command.options) {
        if (option.is_hidden || group != option.group) continue;
        const std::string row =
            "| `" + replaced(written(option), "|", "\\|") + "` | " + cell(option.help + remark(option)) + " |\n";
        const auto [first, is_new] = shown.emplace(row, command.name);
        if (is_new)
            out += row;
        else
            known[first->second].push_back(option.name);
    }
    for (const auto& [name, options] : known) {
        const auto other = std::ranges::find(program.commands, name, &Command::name);
        const bool is_whole = count_in_group(*other, group) == options.size();
        auto& to = is_whole ? alike[name].groups : alike[name].options;
        if (is_whole)
            to.push_back(group);
        else
            to.insert(to.end(), options.begin(), options.end());
    }
    return out;
}

/// An option is described once: commands after the first one that has it name it alone.
std::string markdown_rows(const Program& program, const Command& command, Shown& shown) {
    std::string out;
    std::map<std::string, Alike> alike;
    walk(
        command,
        [&](const char* group) {
            const std::string rows = markdown_group(program, command, group, shown, alike);
            if (!rows.empty())
                out += "\n**" + std::string(group) + "**\n\n| option | meaning |\n| --- | --- |\n" + rows;
        },
        [](const Option&) {});
    return out + markdown_links(alike);
}

}  // namespace

std::string man_page(const Program& program) {
    std::string upper = program.name;
    for (char& c : upper) c = c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
    std::string out =
        ".TH " + upper + " 1\n.SH NAME\n" + program.name + " \\- " + roff(program.help) + "\n.SH SYNOPSIS\n";
    if (program.usage) out += ".B " + roff(program.usage) + "\n.br\n";
    for (const Command& command : program.commands) out += ".B " + roff(usage(program, command)) + "\n.br\n";
    out += ".SH DESCRIPTION\n" + roff_block(program.footer);
    for (const Command& command : program.commands) {
        out += ".SH " + roff(std::string(program.name) + " " + command.name) + "\n" + roff(command.help) + ".\n";
        for (const Positional& p : command.positionals) out += roff_item(p.name, p.help);
        walk(
            command, [&](const char* group) { out += ".SS " + roff(group) + "\n"; },
            [&](const Option& option) { out += roff_item(written(option), option.help + remark(option)); });
        if (command.footer) out += ".SS Notes\n" + roff_block(command.footer);
    }
    return out;
}

std::string markdown_page(const Program& program) {
    std::string out = "# The command line\n\n" + std::string(program.help) + " `" + program.name +
                      " --markdown` prints this page; `--help` and the man page have the same text. An option is "
                      "described once: commands below name it alone.\n";
    out += "\n```\n" + std::string(program.footer) + "\n```\n";
    Shown shown;
    for (const Command& command : program.commands) {
        out += "\n## " + std::string(command.name) + "\n\n" + command.help + ": `" + usage(program, command) + "`\n";
        if (!command.positionals.empty()) out += "\n";
        for (const Positional& p : command.positionals)
            out += "- `" + std::string(p.name) + "`: " + replaced(p.help, "*", "\\*") + "\n";
        out += markdown_rows(program, command, shown);
        if (command.footer) out += "\n```\n" + std::string(command.footer) + "\n```\n";
    }
    return out;
}

std::string manual_for(const Program& program, const std::vector<std::string>& words) {
    if (words.size() != 1) return {};
    if (words[0] == "--typescript") return typescript_options(program);
    return words[0] == "--man" ? man_page(program) : words[0] == "--markdown" ? markdown_page(program) : "";
}

}  // namespace rakelight::apps
