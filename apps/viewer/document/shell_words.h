// SPDX-License-Identifier: Apache-2.0
// Words on one line, as shells write them: names with blanks stand in quotes.
#pragma once
#include <string>
#include <vector>

namespace rakelight::viewer {

/// In single quotes where a shell would not take it as one plain word.
std::string quoted(const std::string& word);
/// The words of a line: '...' as it is, "..." with \" and \\, elsewhere \ before any character.
/// @throws Error usage: a quote is not closed
std::vector<std::string> shell_words(const std::string& text);

}  // namespace rakelight::viewer
