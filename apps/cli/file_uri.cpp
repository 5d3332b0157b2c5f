// SPDX-License-Identifier: Apache-2.0
#include "file_uri.h"

#include <unistd.h>

#include <algorithm>
#include <string_view>

#include <rakelight/base/error.h>
#include <rakelight_internal/base/text.h>

namespace rakelight::cli {
namespace {

/// -1: no hexadecimal digit
int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

bool is_scheme_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '+' || c == '-' ||
           c == '.';
}

/// "file" of "file:///a" and of "file:/a"; empty: it is no address.
std::string scheme_of(const std::string& word) {
    const std::size_t end = word.find(":/");
    if (end == word.npos || !std::all_of(word.begin(), word.begin() + std::ptrdiff_t(end), is_scheme_letter)) return {};
    std::string scheme = lower_case(word.substr(0, end));
    const bool has_host = word.compare(end, 3, "://") == 0;
    return has_host || scheme == "file" ? scheme : std::string();  // "a:/b" is a path like any other
}

bool is_this_machine(std::string_view host) {
    char name[256] = {};
    return host.empty() || host == "localhost" || (gethostname(name, sizeof name - 1) == 0 && host == name);
}

Error wrong(const std::string& word, const std::string& reason) {
    return Error(ErrorCode::usage, "'" + one_line(word, 80) + "' " + reason, {}, "give a path, or file:///PATH");
}

std::string decoded(std::string_view text, const std::string& word) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            out += text[i];
            continue;
        }
        const int high = i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
        const int low = high < 0 ? -1 : hex_digit(text[i + 2]);
        if (low < 0) throw wrong(word, "has a % without two hexadecimal digits");
        if (high == 0 && low == 0) throw wrong(word, "has a zero byte, which no file's name has");
        out += char(high * 16 + low);
        i += 2;
    }
    return out;
}

}  // namespace

bool is_file_uri(const std::string& word) { return scheme_of(word) == "file"; }

std::string path_of_uri(const std::string& word) {
    const std::string scheme = scheme_of(word);
    if (scheme.empty()) return word;
    if (scheme != "file") throw wrong(word, "is no file of this machine");
    std::string_view rest = std::string_view(word).substr(scheme.size() + 1);
    if (!rest.starts_with("//")) return decoded(rest, word);
    rest.remove_prefix(2);
    const std::size_t path = rest.find('/');
    if (path == rest.npos) throw wrong(word, "has no path");
    if (!is_this_machine(rest.substr(0, path))) throw wrong(word, "is no file of this machine");
    return decoded(rest.substr(path), word);
}

}  // namespace rakelight::cli
