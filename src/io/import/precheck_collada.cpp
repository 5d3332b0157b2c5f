// SPDX-License-Identifier: Apache-2.0
// Collada: well-formed XML to its end without a document type, and whole numbers as indices.
#include <algorithm>
#include <string_view>

#include "io/import/precheck.h"
#include "io/import/xml_events.h"

namespace rakelight::io {
namespace {

constexpr std::string_view blanks = " \t\r\n";

/// Lists of indices hold whole numbers: at anything else Assimp appends zeros until memory ends.
class IndexCheck final : public XmlHandler {
public:
    void start(std::string_view element, const XmlAttributes&) override {
        is_index_ = element == "p";
        word_.clear();
    }
    void end(std::string_view) override { is_index_ = false; }

    void text(std::string_view part, std::uint64_t line) override {
        if (!is_index_) return;
        const std::size_t bad = part.find_first_not_of("0123456789+- \t\r\n");
        if (bad != std::string_view::npos) refuse(part, bad, line);
        const std::size_t blank = part.find_last_of(blanks);  // the last word may continue in the next part
        if (blank != std::string_view::npos) word_.clear(), part.remove_prefix(blank + 1);
        word_.append(part.substr(0, 40 - std::min<std::size_t>(word_.size(), 40)));
    }

private:
    [[noreturn]] void refuse(std::string_view part, std::size_t bad, std::uint64_t line) const {
        const std::size_t word = part.find_last_of(blanks, bad) + 1;  // 0 where there is none
        const std::string written = (word == 0 ? word_ : std::string()) +
                                    std::string(part.substr(word, part.find_first_of(blanks, bad) - word));
        const auto feeds = std::count(part.begin(), part.begin() + std::ptrdiff_t(bad), '\n');
        throw Error(ErrorCode::bad_file,
                    "the indices <p> hold '" + one_line(written, 40) + "', which is not a whole number",
                    "line " + std::to_string(line + std::uint64_t(feeds)));
    }

    bool is_index_ = false;
    std::string word_;
};

void check_collada(const Suspect& s) {
    IndexCheck check;
    read_xml(s.bytes, check);
}

}  // namespace

constinit const Precheck collada_precheck = {"dae", check_collada};

}  // namespace rakelight::io
