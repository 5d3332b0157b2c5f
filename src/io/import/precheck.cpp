// SPDX-License-Identifier: Apache-2.0
#include "io/import/precheck.h"

#include <array>

namespace rakelight::io {

long long open_braces(std::span<const std::byte> text) {
    long long open = 0;
    bool quoted = false;
    for (const std::byte b : text) {
        const char c = char(b);
        if (c == '"' || (quoted && c == '\n')) quoted = c == '"' && !quoted;  // a quote never spans lines
        if (quoted) continue;
        open += c == '{' ? 1 : c == '}' ? -1 : 0;
        if (open < 0) return -1;
    }
    return open;
}

void check_before_import(const std::string& ending, const Suspect& s) {
    static constexpr std::array prechecks{&precheck_3ds,     &ase_precheck, &blend_precheck,
                                          &collada_precheck, &fbx_precheck, &x_precheck};
    if (s.bytes.empty()) throw Error(ErrorCode::bad_file, "the file is empty");
    for (const Precheck* const precheck : prechecks)
        if (precheck->ending == ending) return precheck->check(s);
    throw Error(ErrorCode::bad_file, "no reader for '." + ending + "' files");
}

}  // namespace rakelight::io
