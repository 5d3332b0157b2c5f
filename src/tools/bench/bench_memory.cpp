// SPDX-License-Identifier: Apache-2.0
// Linux: /proc/self/status has the resident set (VmRSS) and its peak (VmHWM); "5" written to /proc/self/clear_refs
// lowers the peak to what is resident now (proc(5)).
#include "tools/bench/bench_memory.h"

#include <fstream>
#include <string>

namespace rakelight {
namespace {

std::uint64_t status_bytes(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        if (word != key) continue;
        std::uint64_t kib = 0;
        status >> kib;
        return kib * 1024;
    }
    return 0;
}

}  // namespace

MemoryPeak::MemoryPeak() {
    std::ofstream("/proc/self/clear_refs") << "5";
    start_ = status_bytes("VmRSS:");
}

std::uint64_t MemoryPeak::bytes() const {
    const std::uint64_t peak = status_bytes("VmHWM:");
    return peak > start_ ? peak - start_ : 0;
}

}  // namespace rakelight
