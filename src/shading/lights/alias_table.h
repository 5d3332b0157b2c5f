// SPDX-License-Identifier: Apache-2.0
// Choosing one of many in constant time, with given probabilities.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rakelight::shading {

/// Vose 1991, "A Linear Algorithm for Generating Random Numbers with a Given Distribution", after Walker 1974: as many cells of
/// equal size as elements, each shared by at most two. Immutable, thread-safe; the same bits on every machine.
class AliasTable {
public:
    AliasTable() = default;
    /// O(n). Negative and non-finite weights count as 0; an element of weight 0 is never chosen. Without any weight the table is
    /// empty. Who makes it charges bytes_for() and, for a moment, bytes_to_make().
    /// @param weights  fewer than 2^32
    explicit AliasTable(std::span<const double> weights);

    struct Sample {
        std::uint32_t index;
        float probability;  ///< > 0
        double rest;        ///< [0, 1) what the choice leaves of u, uniform and independent of it
    };
    /// @param u  0..1, 1 excluded. It should have about 10 bits more than `size` has: floats are too coarse for large tables
    /// The table must not be empty.
    Sample sample(double u) const noexcept;

    float probability(std::uint32_t index) const noexcept { return cells_[index].probability; }  ///< index < size()
    std::size_t size() const noexcept { return cells_.size(); }
    bool empty() const noexcept { return cells_.empty(); }

    static std::uint64_t bytes_for(std::uint64_t count) { return count * sizeof(Cell); }
    /// Beside bytes_for() and the weights.
    static std::uint64_t bytes_to_make(std::uint64_t count) { return count * (sizeof(double) + sizeof(std::uint32_t)); }

private:
    struct Cell {
        float own;            ///< share of the cell that is its own element's, the rest is `other`'s; 1: nothing is
        std::uint32_t other;  ///< an element
        float probability;    ///< of its own element, both shares
    };
    void share_out(std::vector<double>& scaled);

    std::vector<Cell> cells_;
};

}  // namespace rakelight::shading
