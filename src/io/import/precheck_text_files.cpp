// SPDX-License-Identifier: Apache-2.0
// ASE and X: texts whose blocks stand in braces.
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string_view>

#include "base/format_text.h"
#include "io/import/precheck.h"

namespace rakelight::io {
namespace {

/// "line 12", by the line feeds before the byte at `at`.
std::string line_of(std::string_view text, std::size_t at) {
    return "line " + std::to_string(1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n'));
}

/// The counts in front of lists ("*MESH_NUMVERTEX 8"): Assimp allocates this much before it reads the list.
void check_ase_counts(std::string_view text) {
    constexpr std::uint64_t least = 4;  // bytes of an entry: "*X 0"
    for (std::size_t at = text.find('*'); at != text.npos; at = text.find('*', at + 1)) {
        const std::size_t before = text.find_last_not_of(" \t", at == 0 ? 0 : at - 1);
        const bool begins_line = at == 0 || before == text.npos || text[before] == '\n' || text[before] == '\r';
        const std::string_view word = text.substr(at, text.find_first_of(" \t\r\n", at) - at);
        if (!begins_line || (word.find("NUM") == word.npos && !word.ends_with("COUNT"))) continue;
        const std::size_t digits = std::min(text.find_first_not_of(" \t", at + word.size()), text.size());
        std::uint64_t count = 0;
        const auto [end, problem] = std::from_chars(text.data() + digits, text.data() + text.size(), count);
        if (problem != std::errc::result_out_of_range && count <= text.size() / least) continue;
        const std::string written(text.substr(digits, std::size_t(end - text.data()) - digits));
        throw Error(ErrorCode::bad_file,
                    format_text("{} promises {} entries, but the file has {} bytes", one_line(std::string(word), 40),
                                one_line(written, 40), text.size()),
                    line_of(text, at));
    }
}

void check_ase(const Suspect& s) {
    const std::string_view text(reinterpret_cast<const char*>(s.bytes.data()), s.bytes.size());
    const bool utf16 = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
    const std::size_t begin = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (!utf16 && (begin == std::string_view::npos || text[begin] != '*'))
        throw Error(ErrorCode::bad_file, "not an ASE file (it does not begin with '*')");
    if (utf16) s.report.add(Remark::note, s.path, {}, "UTF-16 text was read as UTF-8");
    if (!utf16) check_ase_counts(text);
    const long long open = open_braces(s.bytes);
    if (open > 0) s.report.add(Remark::warning, s.path, {}, "the file ends inside a block; it is probably cut short");
    if (open < 0)
        s.report.add(Remark::warning, s.path, {},
                     "a block is closed that was never opened; the file is probably damaged");
    for (const std::byte b : s.bytes) {
        const auto c = std::to_integer<unsigned>(b);
        if (utf16 || c >= 32 || c == '\t' || c == '\r' || c == '\n' || c == 26 || c == 12)
            continue;  // 26 ends old DOS files
        s.report.add(Remark::warning, s.path, {}, "the text holds control characters; the file is probably damaged");
        break;
    }
}

void check_x(const Suspect& s) {
    const std::string_view text(reinterpret_cast<const char*>(s.bytes.data()), s.bytes.size());
    if (!text.starts_with("xof ") || text.size() < 16)
        throw Error(ErrorCode::bad_file, "not a DirectX file (it does not begin with 'xof ')");
    const std::string_view kind = text.substr(8, 4);
    if (kind == "txt " && open_braces(s.bytes) != 0)
        throw Error(ErrorCode::bad_file, "the file ends inside a block; it is cut short or damaged");
}

}  // namespace

constinit const Precheck ase_precheck = {"ase", check_ase};
constinit const Precheck x_precheck = {"x", check_x};

}  // namespace rakelight::io
