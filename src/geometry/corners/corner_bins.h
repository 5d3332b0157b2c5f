// SPDX-License-Identifier: Apache-2.0
// Sorts corners by key in linear time: one partition by ranges of keys, then each range within the cache.
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/input/attribute_input.h"
#include "geometry/input/block_array.h"

namespace rakelight::geometry {

/// Bin k holds corners[begin[k] .. begin[k + 1]), ascending.
struct CornerBins {
    std::vector<std::uint32_t> begin;  ///< [keys + 1]
    BlockArray<std::uint32_t> corners;

    std::uint32_t size(std::uint32_t key) const { return begin[key + 1] - begin[key]; }
    std::span<const std::uint32_t> operator[](std::uint32_t key) const {
        return {corners.data() + begin[key], size(key)};
    }
};

/// Sorts corners by key; the result is equal for any number of threads. Temporary memory: 6 bytes per corner.
class CornerSort {
public:
    static constexpr std::uint32_t no_bin = 0xffffffffu;  ///< the corner is in no bin

    /// @param bins, scratch reused memory; contents are ignored
    CornerSort(const AttributeInput& input, std::uint32_t keys, CornerBins bins, BlockArray<std::uint16_t>& scratch,
               Context& context)
        : input_(input),
          context_(context),
          keys_(keys),
          parts_(keys / keys_per_part + 1),
          chunks_(make_chunks(input.triangle_base, triangles_per_chunk)),
          bins_(std::move(bins)),
          local_(scratch) {}

    /// @param key_of mesh -> (global corner -> bin < keys, or no_bin); called twice per corner, from any thread
    template <class Key>
    CornerBins run(const Key& key_of) {
        std::vector<std::uint32_t> cursor(chunks_.size() * parts_, 0);
        context_.parallel_for(chunks_.size(), [&](std::size_t c) {
            std::vector<std::uint32_t> counts(parts_, 0);
            for_each_key(c, key_of, [&](std::uint32_t, std::uint32_t key) { ++counts[key >> part_bits]; });
            std::copy(counts.begin(), counts.end(), cursor.begin() + std::ptrdiff_t(c * parts_));
        });
        const std::vector<std::uint32_t> part_begin = add_up(cursor);
        bins_.corners.reserve(part_begin.back());
        local_.reserve(part_begin.back());
        context_.parallel_for(chunks_.size(), [&](std::size_t c) {
            const auto from = cursor.begin() + std::ptrdiff_t(c * parts_);
            std::vector<std::uint32_t> at(from, from + parts_);
            std::uint32_t* const corners = bins_.corners.data();
            std::uint16_t* const local = local_.data();
            for_each_key(c, key_of, [&](std::uint32_t corner, std::uint32_t key) {
                const std::uint32_t to = at[key >> part_bits]++;
                corners[to] = corner;
                local[to] = std::uint16_t(key & (keys_per_part - 1));
            });
        });
        bins_.begin.resize(std::size_t(keys_) + 1);
        context_.parallel_for(parts_,
                              [&](std::size_t p) { sort_part(std::uint32_t(p), part_begin[p], part_begin[p + 1]); });
        bins_.begin[keys_] = part_begin.back();
        return std::move(bins_);
    }

private:
    static constexpr std::uint32_t part_bits = 15, keys_per_part = 1u << part_bits;

    template <class Key, class Body>
    void for_each_key(std::size_t chunk, const Key& key_of, const Body& body) const {
        for_each_range(chunks_[chunk], input_.triangle_base,
                       [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
                           const std::uint32_t base = 3 * input_.triangle_base[m];
                           const auto key_in_mesh = key_of(m);
                           for (std::uint32_t corner = base + 3 * first; corner != base + 3 * last; ++corner)
                               if (const std::uint32_t key = key_in_mesh(corner); key != no_bin) body(corner, key);
                       });
    }

    std::vector<std::uint32_t> add_up(std::vector<std::uint32_t>& cursor) const;
    void sort_part(std::uint32_t part, std::uint32_t begin, std::uint32_t end);

    const AttributeInput& input_;
    Context& context_;
    std::uint32_t keys_, parts_;
    std::vector<Chunk> chunks_;
    CornerBins bins_;
    BlockArray<std::uint16_t>& local_;  // [binned corners] key inside its part
};

}  // namespace rakelight::geometry
