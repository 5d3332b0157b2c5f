// SPDX-License-Identifier: Apache-2.0
// Where the tests find models: data/ of the repository always, and the large sets of assets and hostile files beside the
// repository (../shared, or RAKELIGHT_SHARED) where they are there; a test that needs them is skipped without.
#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace rakelight::test {

/// The folder of the repository.
std::filesystem::path source_dir();

inline std::filesystem::path shared_dir() {
    const char* named = std::getenv("RAKELIGHT_SHARED");
    return named ? std::filesystem::path(named) : source_dir().parent_path() / "shared";
}

inline bool has_shared(const std::string& part) { return std::filesystem::exists(shared_dir() / part); }

}  // namespace rakelight::test

/// First line of a test that uses ../shared: skips it where the set is not there.
#define RL_NEEDS_SHARED(part) \
    if (!rakelight::test::has_shared(part)) GTEST_SKIP() << "../shared/" << part << " is not there"
