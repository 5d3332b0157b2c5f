// SPDX-License-Identifier: Apache-2.0
// What can stand behind an option, for the scripts of completion.h.
#pragma once
#include <string>
#include <vector>

#include "option.h"

namespace rakelight::apps {

struct Answers {
    bool takes_value = false;        ///< something has to follow
    bool is_file = false;            ///< a file or a folder
    std::vector<std::string> words;  ///< one of these; empty: numbers, names, anything
    bool is_list = false;            ///< or several of them, with commas between
    bool operator==(const Answers&) const = default;
};

/// By the option's form, its type ("FILE") and its words; of a setting the words that its key lists where it refuses one.
Answers answers_for(const Option& option);

/// "-o", "--output"; both names where it has two.
std::vector<std::string> spellings(const Option& option);

/// The help in a line: its first clause, cut at a word where it is longer than 72 characters; never in parentheses.
std::string brief(const char* help);

/// With `separator` between.
std::string joined_words(const std::vector<std::string>& words, const char* separator);

}  // namespace rakelight::apps
