// SPDX-License-Identifier: Apache-2.0
#include "tools/text_table.h"

#include <algorithm>

#include "base/assert.h"

namespace rakelight {
namespace {

/// Characters, not bytes, so that names in any script line up (except for wide ones).
std::size_t width_of(const std::string& utf8) {
    return std::size_t(
        std::count_if(utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace

TextTable::TextTable(std::vector<std::string> head) {
    for (std::string& cell : head) {
        to_the_right_.push_back(cell.starts_with('>'));
        if (to_the_right_.back()) cell.erase(0, 1);
    }
    rows_.push_back(std::move(head));
}

void TextTable::add(std::vector<std::string> cells) {
    RL_ASSERT(cells.size() == to_the_right_.size(), "a row and the head have different numbers of cells");
    rows_.push_back(std::move(cells));
}

std::string TextTable::text(const std::string& indent) const {
    std::vector<std::size_t> widths(to_the_right_.size(), 0);
    for (const auto& row : rows_)
        for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], width_of(row[c]));
    std::string out;
    for (const auto& row : rows_) {
        std::string line = indent;
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string gap(widths[c] - width_of(row[c]), ' ');
            line += to_the_right_[c] ? gap + row[c] : row[c] + gap;
            if (c + 1 < row.size()) line += "  ";
        }
        line.erase(line.find_last_not_of(' ') + 1);
        out += line + "\n";
    }
    return out;
}

}  // namespace rakelight
