// SPDX-License-Identifier: Apache-2.0
// Places of rows that are still undecided. Decided ones are skipped at once, however many lie in a row.
#pragma once
#include <cstdint>
#include <numeric>
#include <vector>

namespace rakelight {

class OpenPlaces {
public:
    explicit OpenPlaces(std::size_t count) : next_(count + 1), open_(count) {
        std::iota(next_.begin(), next_.end(), 0u);
    }
    /// The first open place from `i` on, or the number of places. Nearly constant time (Tarjan 1975).
    std::size_t from(std::size_t i) {
        while (next_[i] != i) i = next_[i] = next_[next_[i]];
        return i;
    }
    /// @param i an open place
    void close(std::size_t i) { ++next_[i], --open_; }
    bool empty() const { return open_ == 0; }
    std::size_t closed() const { return next_.size() - 1 - open_; }

private:
    std::vector<std::uint32_t> next_;  ///< [places + 1] itself if open, else a later place
    std::size_t open_;
};

}  // namespace rakelight
