// SPDX-License-Identifier: Apache-2.0
#include "typescript.h"

#include "completion_answers.h"

namespace rakelight::apps {
namespace {

/// "max-seam" -> "maxSeam"; a capital as its first letter, too, where it is a type's name.
std::string camel_case(std::string_view name, bool is_type = false) {
    std::string out;
    bool is_upper = is_type;
    for (const char c : name) {
        if (c == '-') {
            is_upper = true;
            continue;
        }
        out += is_upper && c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
        is_upper = false;
    }
    return out;
}

std::string type_of(const Option& option) {
    if (option.form == Form::flag || option.form == Form::on_off) return "boolean";
    const Answers answers = answers_for(option);
    if (answers.is_file) return "string";
    if (answers.words.empty()) return "OptionValue";
    const std::string words = "'" + joined_words(answers.words, "' | '") + "'";
    return answers.is_list ? "OptionValue | readonly (" + words + ")[]" : words;
}

/// Text of a comment, which must not end in it.
std::string comment(std::string text) {
    for (std::size_t at = 0; (at = text.find("*/", at)) != text.npos;) text.replace(at, 2, "* /");
    return text;
}

}  // namespace

std::string typescript_options(const Program& program) {
    std::string out =
        "// The options of the program, made of the tables that its command line is read by.\n\n"
        "/** A word, a number, or several with commas between. */\n"
        "export type OptionValue = string | number | readonly (string | number)[];\n";
    for (const Command& command : program.commands) {
        out += "\n/** " + comment(command.help) + ". */\nexport interface " + camel_case(command.name, true) +
               "Options {\n";
        for (const Option& option : command.options)
            if (!option.is_hidden)
                out += "    /** " + comment(option.help) + " */\n    " + camel_case(option.name) +
                       "?: " + type_of(option) + ";\n";
        out += "}\n";
    }
    return out;
}

}  // namespace rakelight::apps
