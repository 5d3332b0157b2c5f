// SPDX-License-Identifier: Apache-2.0
#include <rakelight/scene/words.h>
#include <rakelight_internal/base/text.h>

#include <algorithm>
#include <set>
#include <utility>

#include "base/format_text.h"

namespace rakelight {

bool same_word(std::string_view a, std::string_view b) { return lower_case(a) == lower_case(b); }

std::size_t spelling_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before = std::exchange(last, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row[b.size()];
}

std::string nearest_word(std::string_view word, const std::vector<std::string_view>& words) {
    constexpr std::size_t longest = 64;  // the time is proportional to both lengths, which come from files
    if (word.size() > longest) return {};
    std::string_view nearest;
    std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string_view other : words) {
        const bool is_begun = word.size() >= 3 && (other.starts_with(word) || word.starts_with(other));
        if (!is_begun && other.size() >= word.size() + least) continue;  // too long to be similar
        const std::size_t distance = is_begun ? 1 : spelling_distance(word, other);
        if (distance < least) least = distance, nearest = other;
    }
    return std::string(nearest);
}

std::string list_of_names(const std::vector<std::string>& names, std::size_t most, std::size_t max_bytes) {
    constexpr std::size_t longest =
        90;  // [bytes] of a list, but for its last name: an error's advice is cut behind 160
    std::string list;
    std::set<std::string_view> known;
    std::size_t shown = 0;
    for (const std::string& name : names) {
        if (!known.insert(name).second || shown == most || list.size() > longest) continue;
        list += (shown > 0 ? ", " : "") + one_line(name, max_bytes);
        ++shown;
    }
    return known.size() > shown ? format_text("{} and {} more", list, known.size() - shown) : list;
}

}  // namespace rakelight
