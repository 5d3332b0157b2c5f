// SPDX-License-Identifier: Apache-2.0
#include "implied_verb.h"

#include <algorithm>
#include <filesystem>

#include <rakelight/base/error.h>
#include <rakelight/io/world.h>
#include <rakelight/tools/compare.h>

#include "file_uri.h"
#include "verbs/view_verb.h"

namespace rakelight::cli {
namespace {

bool names_output(const std::string& word) {
    const bool is_short = word.starts_with('-') && !word.starts_with("--");
    return word == "--output" || word.starts_with("--output=") || (is_short && (word[1] == 'o' || word.ends_with('o')));
}

/// Whether the output that the words name is a model's: "-o a.glb", "-oa.glb", "--output=a.glb".
bool writes_model(const std::vector<std::string>& words) {
    const auto at = std::ranges::find_if(words, names_output);
    if (at == words.end()) return false;
    const bool is_alone = *at == "--output" || at->ends_with('o');
    const std::string& output = is_alone && at + 1 != words.end() ? at[1] : *at;
    return is_scene(output) && !is_world_file(output);
}

bool asks_help(const std::string& word) { return word == "--help" || word == "-h"; }

/// The first word that may be a model; the program's own options come first, and verbs end the search.
const std::string* first_model(std::span<const apps::Command> commands, const std::vector<std::string>& words) {
    const auto is_verb = [&](const std::string& word) {
        return word == "help" || std::ranges::any_of(commands, [&](const auto& c) { return word == c.name; });
    };
    if (words.empty() || is_verb(words[0])) return nullptr;
    if (!words[0].starts_with('-') || words[0] == "-") return is_model_word(words[0]) ? &words[0] : nullptr;
    const bool is_own = asks_help(words[0]) || words[0] == "-V" || words[0] == "--version";
    const auto model = std::ranges::find_if(words, is_model_word);
    if (const auto verb = std::find_if(words.begin(), model, is_verb); !is_own && verb != model && model != words.end())
        throw Error(ErrorCode::usage, "the subcommand '" + *verb + "' must come first", {},
                    "see rakelight " + *verb + " --help");
    return is_own || model == words.end() ? nullptr : &*model;
}

/// A name for the picture of a model, as an example.
std::string picture_name(const std::string& model) {
    const std::string stem = std::filesystem::path(one_line(path_of_uri(model), 80)).filename().stem().string();
    return model == "-" || stem.empty() || has_picture_ending(model) ? "picture.png" : stem + ".png";
}

}  // namespace

bool is_model_word(const std::string& word) {
    std::error_code ignored;
    return word == "-" || is_scene(word) || is_file_uri(word) ||
           (!word.empty() && std::filesystem::exists(word, ignored));
}

std::vector<std::string> with_implied_verb(const apps::Program& program, std::vector<std::string> words) {
    const std::string* const model = first_model(program.commands, words);
    if (!model) return words;
    const bool renders = std::ranges::any_of(words, names_output) || std::ranges::any_of(words, asks_help);
    if (!renders && !can_view()) {
        std::vector<std::string> rendering = {"render", "-o", picture_name(*model)};
        rendering.insert(rendering.end(), words.begin(), words.end());
        apps::read_command_line(program, rendering);  // throws what is wrong with the options
        throw Error(ErrorCode::usage, RL_PROCESSES ? "there is no display to open a window on" : "no output is named",
                    {}, "for a picture write: rakelight " + one_line(*model, 80) + " -o " + picture_name(*model));
    }
    words.insert(words.begin(), writes_model(words) ? "convert" : renders ? "render" : "view");
    return words;
}

}  // namespace rakelight::cli
