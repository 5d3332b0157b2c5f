// SPDX-License-Identifier: Apache-2.0
// What the tests of STL share: a file that is read, and files in both forms.
#pragma once
#include <gtest/gtest.h>
#include <rakelight/base/report.h>
#include <rakelight/scene/validate.h>

#include <algorithm>
#include <bit>
#include <string>

#include "io/stl/read_stl.h"

namespace rakelight::io::stl_test {

struct ReadStl {
    Context context;
    Scene scene;
    std::string error;
    explicit ReadStl(std::string_view bytes, ContextOptions options = {.threads = 2}) : context(options) {
        try {
            scene = stl::read_stl_bytes(bytes, "folder/a.stl", context);
            validate(scene);
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), ErrorCode::bad_file);
            error = e.what();
        }
    }
    const Mesh& mesh(std::size_t i = 0) const { return scene.meshes.at(i); }
    /// Of a triangle's corner.
    vec3 position(std::size_t corner) const { return mesh().positions[mesh().indices[corner]]; }
    vec4 color(std::size_t corner) const { return mesh().colors[mesh().indices[corner]]; }
    std::size_t remarks() { return context.report().entries().size(); }
    bool says(const std::string& part) {
        const auto entries = context.report().entries();
        return std::ranges::any_of(entries,
                                   [&](const ReportEntry& e) { return e.message.find(part) != std::string::npos; });
    }
};

inline std::string bytes_of(std::uint32_t value, int count = 4) {
    std::string out;
    for (int i = 0; i < count; ++i) out += char(value >> 8 * i & 255);
    return out;
}

struct Facet {
    vec3 corners[3];
    std::uint32_t attribute = 0;
};

/// @param promised  the number of facets that the header gives, if not theirs
inline std::string binary_file(const std::vector<Facet>& facets, std::string header = "",
                               std::optional<std::uint32_t> promised = {}) {
    header.resize(80, ' ');
    std::string out = header + bytes_of(promised.value_or(std::uint32_t(facets.size())));
    for (const Facet& f : facets) {
        out += std::string(12, '\0');
        for (const vec3& c : f.corners)
            for (std::size_t k = 0; k < 3; ++k) out += bytes_of(std::bit_cast<std::uint32_t>(c[k]));
        out += bytes_of(f.attribute, 2);
    }
    return out;
}

/// Two triangles that share an edge.
inline std::vector<Facet> square(std::uint32_t first = 0, std::uint32_t second = 0) {
    return {{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}}, first}, {{{0, 0, 0}, {2, 1, 0}, {0, 1, 0}}, second}};
}

}  // namespace rakelight::io::stl_test
