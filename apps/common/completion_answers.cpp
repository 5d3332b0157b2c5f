// SPDX-License-Identifier: Apache-2.0
#include "completion_answers.h"

#include <algorithm>
#include <span>
#include <string_view>

#include <rakelight/base/error.h>
#include <rakelight/world/render_keys.h>
#include <rakelight/world/request.h>
#include <rakelight/world/values.h>

namespace rakelight::apps {
namespace {

constexpr std::string_view list_begins = "use one of: ";

bool is_plain(std::string_view word) {
    return !word.empty() && std::ranges::all_of(word, [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.';
    });
}

/// The parts between commas, if all of them are words.
std::vector<std::string> plain_parts(std::string_view list) {
    std::vector<std::string> words;
    for (std::string_view part : values::split(list, ',')) {
        while (part.starts_with(' ')) part.remove_prefix(1);
        if (!is_plain(part)) return {};
        words.emplace_back(part);
    }
    return words;
}

/// What a key of [render] lists when it is given a word that it cannot have.
std::vector<std::string> words_of_key(const RenderKey& key) {
    if (key.kind == RenderKey::Kind::file || key.kind == RenderKey::Kind::flag) return {};
    PictureRequest request;
    const std::string nonsense = "?";
    try {
        key.read(request, {&nonsense, 1});
    } catch (const Error& error) {
        const std::string_view text = error.what();
        const std::size_t at = text.find(list_begins);
        if (at != text.npos) return plain_parts(text.substr(at + list_begins.size()));
    }
    return {};
}

}  // namespace

Answers answers_for(const Option& option) {
    if (option.form == Form::flag) return {};
    if (option.form == Form::on_off)
        return {.takes_value = false, .is_file = false, .words = {"on", "off"}, .is_list = false};
    Answers answers{.takes_value = true, .is_file = false, .words = {}, .is_list = false};
    const std::string_view type = option.type;
    const RenderKey* const key = option.is_setting ? find_render_key(option.name) : nullptr;
    for (const std::string_view word : {"FILE", "DIR", "PICTURE", "PLACE"}) answers.is_file |= type == word;
    answers.is_file |= key && key->kind == RenderKey::Kind::file;
    if (option.words)
        answers.words = option.words();
    else if (key)
        answers.words = words_of_key(*key);
    answers.is_list = option.takes_several_words;
    return answers;
}

std::vector<std::string> spellings(const Option& option) {
    std::vector<std::string> names{std::string("--") + option.name};
    if (option.also) names.push_back(std::string("--") + option.also);
    if (option.letter) names.push_back(std::string("-") + option.letter);
    return names;
}

std::string brief(const char* help) {
    constexpr std::size_t longest = 72;
    const std::string_view text = help;
    std::size_t blank = 0;  // the last one outside of parentheses
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (i > longest) return std::string(text.substr(0, blank)) + " ...";
        if (text[i] == '(') ++depth;
        if (text[i] == ')') --depth;
        if (depth > 0) continue;
        const std::string_view end = text.substr(i, 2);
        if (end == ": " || end == "; " || end == ". ") return std::string(text.substr(0, i));
        if (text[i] == ' ') blank = i;
    }
    return std::string(text);
}

std::string joined_words(const std::vector<std::string>& words, const char* separator) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
    return text;
}

}  // namespace rakelight::apps
