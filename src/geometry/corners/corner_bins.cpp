// SPDX-License-Identifier: Apache-2.0
#include "geometry/corners/corner_bins.h"

namespace rakelight::geometry {

// Prefix sums of the counts, by part and then by chunk, so that corners ascend.
std::vector<std::uint32_t> CornerSort::add_up(std::vector<std::uint32_t>& cursor) const {
    std::vector<std::uint32_t> begin(std::size_t(parts_) + 1);
    std::uint32_t sum = 0;
    for (std::uint32_t p = 0; p < parts_; ++p) {
        begin[p] = sum;
        for (std::size_t c = 0; c < chunks_.size(); ++c) {
            const std::uint32_t count = cursor[c * parts_ + p];
            cursor[c * parts_ + p] = sum;
            sum += count;
        }
    }
    begin[parts_] = sum;
    return begin;
}

// Counting sort of one part; it keeps the order of equal keys.
void CornerSort::sort_part(std::uint32_t part, std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t first_key = part << part_bits, keys = std::min(keys_ - first_key, keys_per_part);
    std::uint32_t* const at = bins_.begin.data() + first_key;
    std::fill_n(at, keys, 0u);
    for (std::uint32_t i = begin; i != end; ++i) ++at[local_[i]];
    std::uint32_t sum = begin;
    for (std::uint32_t k = 0; k < keys; ++k) {
        const std::uint32_t count = at[k];
        at[k] = sum;
        sum += count;
    }
    std::uint32_t* const corners = bins_.corners.data();
    const std::vector<std::uint32_t> unsorted(corners + begin, corners + end);
    for (std::uint32_t i = begin; i != end; ++i) corners[at[local_[i]]++] = unsorted[i - begin];
    for (std::uint32_t k = keys; k-- > 1;) at[k] = at[k - 1];  // each has advanced to its end, the begin of the next
    if (keys != 0) at[0] = begin;
}

}  // namespace rakelight::geometry
