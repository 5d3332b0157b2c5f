// SPDX-License-Identifier: Apache-2.0
// Memory in pages of 2 MiB where the system grants them: arrays of many megabytes that are read here and there spend
// less time on finding their pages.
#pragma once
#include <cstddef>
#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace rakelight {

inline constexpr std::size_t huge_page = std::size_t(1) << 21;

/// For memory that nothing was written to yet; concerns the whole huge pages in it. A wish: without it all works, more
/// slowly.
inline void advise_huge_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
    const auto first = (reinterpret_cast<std::uintptr_t>(begin) + huge_page - 1) / huge_page * huge_page;
    const auto end = (reinterpret_cast<std::uintptr_t>(begin) + bytes) / huge_page * huge_page;
    if (first < end) (void)madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#endif
}

}  // namespace rakelight
