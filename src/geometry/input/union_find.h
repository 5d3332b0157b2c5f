// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <numeric>
#include <vector>

namespace rakelight::geometry {

/// Disjoint sets of 0..n-1. The root is the smallest member, for any order of joining. Path halving.
class UnionFind {
public:
    void reset(std::size_t count) {
        parent_.resize(count);
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    /// False if both were already in one set.
    bool join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        if (a < b) parent_[b] = a;
        if (b < a) parent_[a] = b;
        return a != b;
    }

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace rakelight::geometry
