// SPDX-License-Identifier: Apache-2.0
// Collada: well-formed to its end, no document type (entities could name files or grow without bound), valid UTF-8.
#include <cstdint>
#include <string_view>
#include <vector>

#include "io/import/precheck.h"

namespace rakelight::io {
namespace {

constexpr std::size_t deepest = 512;

[[noreturn]] void bad_xml(const std::string& what, std::string_view text, std::size_t at) {
    throw Error(ErrorCode::bad_file, what, line_of(text, at));
}

/// Position of the first byte that is no UTF-8 (RFC 3629), or npos.
std::size_t first_bad_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto c = static_cast<unsigned char>(text[i]);
        const std::size_t more = c < 0x80                ? 0
                                 : c >= 0xC2 && c < 0xE0 ? 1
                                 : c >= 0xE0 && c < 0xF0 ? 2
                                 : c >= 0xF0 && c < 0xF5 ? 3
                                                         : 4;
        if (more == 4 || more >= text.size() - i) return i;
        for (std::size_t k = 1; k <= more; ++k)
            if ((static_cast<unsigned char>(text[i + k]) & 0xC0) != 0x80) return i;
        const bool control = c < 32 && c != '\t' && c != '\r' && c != '\n';  // not allowed in XML 1.0
        if (control) return i;
        i += more + 1;
    }
    return std::string_view::npos;
}

/// End of the markup that begins at `at` (a '<'): the position after it, npos when it has none. Quoted '>' do not count.
std::size_t end_of_tag(std::string_view text, std::size_t at) {
    char quote = 0;
    for (std::size_t i = at + 1; i < text.size(); ++i) {
        const char c = text[i];
        if (quote != 0)
            quote = c == quote ? 0 : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        else if (c == '>')
            return i + 1;
        else if (c == '<')
            return std::string_view::npos;
    }
    return std::string_view::npos;
}

std::size_t skip_past(std::string_view text, std::size_t at, std::string_view end) {
    const std::size_t found = text.find(end, at);
    if (found == std::string_view::npos)
        bad_xml("a comment or section has no end; the file is cut short or damaged", text, at);
    return found + end.size();
}

std::string_view tag_name(std::string_view tag) {  // "<name ...>" or "</name>"
    tag.remove_prefix(tag.starts_with("</") ? 2 : 1);
    return tag.substr(0, tag.find_first_of(" \t\r\n/>"));
}

/// By its XML declaration; without one it is. What follows the word may lie behind the bytes that are looked at, or be
/// missing.
bool is_said_to_be_utf8(std::string_view text) {
    constexpr std::string_view word = "encoding=";
    const std::size_t at = text.substr(0, 200).find(word);
    if (at == std::string_view::npos) return true;
    std::string_view name = text.substr(at + word.size());
    if (name.starts_with('"') || name.starts_with('\'')) name.remove_prefix(1);
    return name.starts_with("utf") || name.starts_with("UTF");
}

/// Lists of indices hold whole numbers: at anything else Assimp appends zeros until memory ends.
void check_indices(std::string_view text, std::size_t begin) {
    const std::string_view list = text.substr(begin, text.find('<', begin) - begin);
    const std::size_t bad = list.find_first_not_of("0123456789+- \t\r\n");
    if (bad == std::string_view::npos) return;
    const std::size_t word = list.find_last_of(" \t\r\n", bad) + 1;  // 0 where there is none
    const std::string written(list.substr(word, list.find_first_of(" \t\r\n", bad) - word));
    bad_xml("the indices <p> hold '" + one_line(written, 40) + "', which is no whole number", text, begin + bad);
}

}  // namespace

void check_collada(const Suspect& s) {
    const std::string_view text(reinterpret_cast<const char*>(s.bytes.data()), s.bytes.size());
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return;  // UTF-16: the helper converts it
    const std::size_t bad = is_said_to_be_utf8(text) ? first_bad_utf8(text) : std::string_view::npos;
    if (bad != std::string_view::npos) bad_xml("not valid UTF-8 text", text, bad);
    std::vector<std::string_view> open;
    bool any = false;
    for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at)) {
        const std::string_view rest = text.substr(at);
        if (rest.starts_with("<!--")) {
            at = skip_past(text, at, "-->");
            continue;
        }
        if (rest.starts_with("<![CDATA[")) {
            at = skip_past(text, at, "]]>");
            continue;
        }
        if (rest.starts_with("<?")) {
            at = skip_past(text, at, "?>");
            continue;
        }
        if (rest.starts_with("<!")) bad_xml("a document type or entity declaration, which is refused", text, at);
        const std::size_t end = end_of_tag(text, at);
        if (end == std::string_view::npos)
            bad_xml("an element's tag has no end; the file is cut short or damaged", text, at);
        const std::string_view tag = text.substr(at, end - at), name = tag_name(tag);
        if (tag.starts_with("</")) {
            if (open.empty() || open.back() != name)
                bad_xml("the element that ends is not the one that began", text, at);
            open.pop_back();
        } else if (!tag.ends_with("/>")) {
            if (open.empty() && any) bad_xml("a second root element", text, at);
            if (name == "p") check_indices(text, end);
            if (open.size() >= deepest) bad_xml("elements are nested more than 512 deep", text, at);
            open.push_back(name);
            any = true;
        }
        at = end;
    }
    if (!any) throw Error(ErrorCode::bad_file, "not a Collada file (no XML element)");
    if (!open.empty())
        bad_xml("element <" + one_line(std::string(open.back()), 60) + "> has no end; the file is cut short or damaged",
                text, text.size());
}

}  // namespace rakelight::io
