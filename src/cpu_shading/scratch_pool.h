// SPDX-License-Identifier: Apache-2.0
// Working memory of tiles, handed from one to the next.
#pragma once
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace rakelight::cpu_shading {

template <class Scratch>
class ScratchPool {
public:
    std::unique_ptr<Scratch> take() {
        const std::lock_guard lock(mutex_);
        if (free_.empty()) return std::make_unique<Scratch>();
        auto scratch = std::move(free_.back());
        free_.pop_back();
        return scratch;
    }
    void give_back(std::unique_ptr<Scratch> scratch) {
        const std::lock_guard lock(mutex_);
        free_.push_back(std::move(scratch));
    }
    /// All of them; when none is out.
    template <class Use>
    void for_each(const Use& use) {
        for (const auto& scratch : free_) use(*scratch);
    }

private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<Scratch>> free_;
};

}  // namespace rakelight::cpu_shading
