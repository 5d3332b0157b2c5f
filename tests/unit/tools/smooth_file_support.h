// SPDX-License-Identifier: Apache-2.0
// What the tests of smoothed files share: files of a folder of their own, and scenes compared number by number.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <nlohmann/json.hpp>

#include <rakelight/rakelight.h>

#include "support/temporary_folder.h"

namespace rakelight::test {

namespace fs = std::filesystem;

inline std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

/// The helper that this build made; false in a build without it.
inline bool use_import_helper() {
#if defined(RL_IMPORT_HELPER)
    setenv("RAKELIGHT_IMPORT", RL_IMPORT_HELPER, 1);
    return true;
#else
    return false;
#endif
}

/// All normals are made, whatever the file has.
inline const SmoothFileOptions anew{.authored = AuthoredNormals::replaced};

inline bool is_said(Context& context, Remark remark, const std::string& part) {
    const std::vector<ReportEntry> entries = context.report().entries();
    return std::any_of(entries.begin(), entries.end(), [&](const ReportEntry& e) {
        return e.remark == remark && e.message.find(part) != std::string::npos;
    });
}

/// Equal numbers (zeros of both signs are).
template <class T>
void expect_same(const Block<T>& a, const Block<T>& b, const char* what) {
    EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end())) << what;
}

inline void expect_attributes(const Scene& wanted, const Scene& got) {
    ASSERT_EQ(wanted.nodes.size(), got.nodes.size());
    for (std::size_t n = 0; n < wanted.nodes.size(); ++n) {
        ASSERT_EQ(wanted.nodes[n].meshes.size(), got.nodes[n].meshes.size());
        for (std::size_t slot = 0; slot < wanted.nodes[n].meshes.size(); ++slot) {
            const Mesh &a = wanted.meshes[wanted.nodes[n].meshes[slot]], &b = got.meshes[got.nodes[n].meshes[slot]];
            expect_same(a.positions, b.positions, "positions");
            expect_same(a.indices, b.indices, "indices");
            expect_same(a.normals, b.normals, "normals");
            expect_same(a.tangents, b.tangents, "tangents");
            ASSERT_EQ(a.influences.size(), b.influences.size());
            ASSERT_EQ(a.targets.size(), b.targets.size());
            for (std::size_t t = 0; t < a.targets.size(); ++t)
                expect_same(a.targets[t].positions, b.targets[t].positions, "morph target");
            for (std::size_t set = 0; set < std::min(a.texcoords.size(), b.texcoords.size()); ++set)
                expect_same(a.texcoords[set], b.texcoords[set], "texture coordinates");
        }
    }
}

}  // namespace rakelight::test
