// SPDX-License-Identifier: Apache-2.0
#include "watch.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace rakelight::cli {
namespace {

constexpr auto pause = std::chrono::milliseconds(100);

/// Of a file that is not there: no time at all. Editors write a new file in place of the old one.
std::filesystem::file_time_type time_of(const std::string& file) {
    std::error_code fault;
    const auto time = std::filesystem::last_write_time(file, fault);
    return fault ? std::filesystem::file_time_type{} : time;
}

}  // namespace

void WatchedInputs::add(const std::vector<std::string>& files, Time began) {
    for (const std::string& file : files) known_.emplace(file, std::min(time_of(file), began));
}

void WatchedInputs::wait() {
    for (bool has_changed = false;;) {
        bool is_changing = false;
        for (auto& [file, known] : known_) {
            const auto now = time_of(file);
            if (now == known || now == Time{}) continue;
            known = now;
            is_changing = true;
        }
        if (has_changed && !is_changing) return;
        has_changed |= is_changing;
        std::this_thread::sleep_for(pause);
    }
}

}  // namespace rakelight::cli
