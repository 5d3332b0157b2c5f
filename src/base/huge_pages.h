// SPDX-License-Identifier: Apache-2.0
// Memory in pages of 2 MiB, which reduces TLB misses for large arrays with random access.
#pragma once
#include <cstddef>
#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace rakelight {

inline constexpr std::size_t huge_page = std::size_t(1) << 21;

/// Advises huge pages for untouched memory; applies to the whole huge pages in the range. Only a hint.
inline void advise_huge_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
    const auto first = (reinterpret_cast<std::uintptr_t>(begin) + huge_page - 1) / huge_page * huge_page;
    const auto end = (reinterpret_cast<std::uintptr_t>(begin) + bytes) / huge_page * huge_page;
    if (first < end) (void)madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#endif
}

}  // namespace rakelight
