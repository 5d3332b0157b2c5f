// SPDX-License-Identifier: Apache-2.0
// The one file that sees CLI11, which is slow to compile.
#include "command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <deque>

#include "command_line_errors.h"

namespace rakelight::apps {
namespace {

constexpr std::size_t column_width = 32, page_width = 100;
constexpr const char* switch_type = "[on|off]";

/// CLI11's layout with descriptions wrapped to the page and single blank lines.
class HelpLayout final : public CLI::Formatter {
public:
    explicit HelpLayout(const char* usage) : usage_(usage) { column_width(apps::column_width); }

    std::string make_usage(const CLI::App* app, std::string name) const override {
        if (app->get_parent() != nullptr || !usage_) return Formatter::make_usage(app, name);
        return std::string("Usage: ") + usage_ + "\n       " + name + " SUBCOMMAND [OPTIONS]\n\n";
    }

    std::string make_option_opts(const CLI::Option* option) const override {
        const bool is_switch = option->get_type_name() == switch_type;
        return is_switch ? std::string(" ") + switch_type : Formatter::make_option_opts(option);
    }

    std::string make_option_desc(const CLI::Option* option) const override {
        std::string text = Formatter::make_option_desc(option), out;
        constexpr std::size_t width = page_width - apps::column_width;
        while (text.size() > width) {
            const std::size_t blank = text.rfind(' ', width);
            if (blank == std::string::npos) break;
            out += text.substr(0, blank) + "\n";
            text.erase(0, blank + 1);
        }
        return out + text;
    }

    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
        std::string text = Formatter::make_help(app, name, mode);
        for (std::size_t at = 0; (at = text.find("\n\n\n", at)) != std::string::npos;) text.erase(at, 1);
        return text;
    }

private:
    const char* usage_;
};

/// What CLI11 writes to; it stays where it is.
struct Target {
    const Option* option;
    CLI::Option* read;
    std::string word;
    std::vector<std::string> words;
    bool flag = false;

    WorldValue value() const {
        WorldValue out{.key = option->name};
        if (option->form == Form::flag) out.words = {"on"};
        if (option->form == Form::list) out.words = words;
        if (option->form == Form::on_off)
            out.words = {word == "true" ? "on" : word == "false" ? "off" : word};  // "true": it stands alone
        if (out.words.empty()) out.words = {word};
        return out;
    }
};

void declare(CLI::App& app, const Option& option, Target& to) {
    const std::string letter = option.letter ? std::string("-") + option.letter + "," : "";
    const std::string name = letter + "--" + option.name + (option.also ? std::string(",--") + option.also : "");
    to.option = &option;
    switch (option.form) {
        case Form::value:
            to.read = app.add_option(name, to.word, option.help);
            break;
        case Form::list:
            to.read = app.add_option(name, to.words, option.help)
                          ->expected(1)
                          ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
            break;
        case Form::flag:
            to.read = app.add_flag(name, to.flag, option.help);
            break;
        case Form::on_off:
            to.read = app.add_flag(name, to.word, option.help);
            break;
    }
    to.read->group(option.is_hidden ? "" : option.group)->required(option.is_required);
    if (option.form == Form::on_off) to.read->type_name(switch_type);
    if (option.form == Form::value || option.form == Form::list) to.read->type_name(option.type);
}

/// A command as CLI11 has it.
struct Reader {
    CLI::App* app;
    std::deque<Target> options;
    std::deque<std::string> singles;
    std::vector<std::string> list;

    Reader(CLI::App& program, const Command& command) : app(program.add_subcommand(command.name, command.help)) {
        for (const Positional& p : command.positionals) {
            CLI::Option* const option = p.is_list ? app->add_option(p.name, list, p.help)
                                                  : app->add_option(p.name, singles.emplace_back(), p.help);
            option->type_name("")->required(p.is_required);
        }
        for (const Option& option : command.options) declare(*app, option, options.emplace_back());
        if (command.footer) app->footer(command.footer);
    }

    /// An option that takes one value and was given several; empty: none.
    std::string repeated() const {
        for (const Target& t : options)
            if (t.option->form == Form::value && t.read->count() > 1) return std::string("--") + t.option->name;
        return {};
    }

    Given given() const {
        std::vector<WorldValue> values, settings;
        for (const Target& t : options)
            if (t.read->count() > 0) (t.option->is_setting ? settings : values).push_back(t.value());
        return Given(std::move(values), std::move(settings));
    }

    std::vector<std::string> positionals() const {
        std::vector<std::string> words = list;
        for (const std::string& word : singles)
            if (!word.empty()) words.push_back(word);
        return words;
    }
};

std::string help_of(const CLI::App& app) {
    const std::vector<CLI::App*> subs = app.get_subcommands();
    return subs.empty() ? app.help() : subs.front()->help(app.get_name());
}

/// `rakelight help [COMMAND]` is `rakelight [COMMAND] --help`.
std::vector<std::string> without_help_word(const Program& program, std::vector<std::string> words) {
    if (words.empty() || words[0] != "help") return words;
    if (words.size() > 2)
        throw Error(ErrorCode::usage, "help takes one command", {}, std::string("see ") + program.name + " --help");
    words.erase(words.begin());
    words.emplace_back("--help");
    return words;
}

}  // namespace

CommandLine read_command_line(const Program& program, const std::vector<std::string>& given) {
    std::vector<std::string> words = without_help_word(program, given);
    check_words(program, words);
    CLI::App app(program.help, program.name);
    app.formatter(std::make_shared<HelpLayout>(program.usage));  // before the commands, which inherit it
    app.set_help_flag("-h,--help",
                      std::string("Show this help; ") + program.name + " SUBCOMMAND --help shows that of a subcommand");
    app.set_version_flag("-V,--version", std::string("-"), "Print version, formats, engines and instruction sets");
    app.require_subcommand(1);
    app.footer(program.footer);
    std::deque<Reader> readers;
    for (const Command& command : program.commands) readers.emplace_back(app, command);
    CommandLine line;
    try {
        words = join_switches(program, std::move(words));
        std::reverse(words.begin(), words.end());  // as CLI11 takes them
        app.parse(words);
    } catch (const CLI::CallForHelp&) {
        line.help = help_of(app);
        return line;
    } catch (const CLI::CallForVersion&) {
        line.is_version = true;
        return line;
    } catch (const CLI::ParseError& fault) {
        const auto read = std::ranges::find_if(readers, [](const Reader& r) { return r.app->parsed(); });
        const bool is_read = read != readers.end();
        throw usage_error(program, is_read ? &program.commands[std::size_t(read - readers.begin())] : nullptr,
                          fault.what(), app.remaining(true), is_read ? read->repeated() : "");
    }
    const auto read = std::ranges::find_if(readers, [](const Reader& r) { return r.app->parsed(); });
    line.command = std::size_t(read - readers.begin());
    line.given = read->given();
    line.positionals = read->positionals();
    return line;
}

}  // namespace rakelight::apps
