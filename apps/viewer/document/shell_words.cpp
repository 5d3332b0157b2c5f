// SPDX-License-Identifier: Apache-2.0
#include "shell_words.h"

#include <algorithm>
#include <string_view>

#include <rakelight/base/error.h>

namespace rakelight::viewer {
namespace {

constexpr std::string_view blanks = " \t\r\n";

/// The text from `at` to the quote that ends it; `at` moves behind that quote.
std::string inside_quotes(const std::string& text, std::size_t& at) {
    const char quote = text[at++];
    std::string inside;
    for (; at < text.size() && text[at] != quote; ++at) {
        const bool is_escape =
            quote == '"' && text[at] == '\\' && at + 1 < text.size() && (text[at + 1] == '"' || text[at + 1] == '\\');
        inside += text[is_escape ? ++at : at];
    }
    if (at == text.size()) throw Error(ErrorCode::usage, "a quote is not closed");
    ++at;
    return inside;
}

}  // namespace

std::string quoted(const std::string& word) {
    const auto is_plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("-_./:,=+@%").find(c) != std::string_view::npos;
    };
    if (!word.empty() && std::ranges::all_of(word, is_plain)) return word;
    std::string out = "'";
    for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

std::vector<std::string> shell_words(const std::string& text) {
    std::vector<std::string> words;
    for (std::size_t at = text.find_first_not_of(blanks); at < text.size(); at = text.find_first_not_of(blanks, at)) {
        std::string& word = words.emplace_back();
        while (at < text.size() && blanks.find(text[at]) == blanks.npos) {
            if (text[at] == '\'' || text[at] == '"') {
                word += inside_quotes(text, at);
            } else {
                if (text[at] == '\\' && at + 1 < text.size()) ++at;
                word += text[at++];
            }
        }
    }
    return words;
}

}  // namespace rakelight::viewer
