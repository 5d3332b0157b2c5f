// SPDX-License-Identifier: Apache-2.0
// What is in a model: objects, materials, textures (not decoded), lights, cameras, and the borders that objects share.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/prepare.h>
#include <rakelight/scene.h>

namespace rakelight {

/// One node that owns meshes.
struct ObjectSummary {
    std::string name;
    std::uint32_t node = none;
    std::uint64_t meshes = 0, triangles = 0, vertices = 0, lines = 0, points = 0;
    /// What its meshes have: yes on all, on some, on none of them.
    enum class Has : std::uint8_t { no, some, yes };
    Has normals = Has::no, tangents = Has::no, texcoords = Has::no, colors = Has::no, smoothing_groups = Has::no,
        skin = Has::no, morph_targets = Has::no;
    std::vector<std::string> materials;  ///< names, each once, in the order of the meshes
};

/// The border of two objects: world positions (compared in double, exactly) that both of them draw.
struct BorderSummary {
    std::uint32_t object_a = 0, object_b = 0;  ///< into Inspection::objects, a < b
    std::uint64_t positions = 0;               ///< how many they share
    double median_deg = 0, largest_deg = 0;    ///< angle between the nearest two of their normals at such a position
};

struct Inspection {
    std::string file;
    std::uint64_t triangles = 0;  ///< instances counted each time
    std::vector<ObjectSummary> objects;
    dvec3 low, high;  ///< world bounding box [m]; meaningful when triangles, lines or points are drawn
    std::uint64_t shared_positions = 0;  ///< world positions that two or more objects draw
    std::vector<BorderSummary> borders;  ///< the largest angle first; at most 1000
    std::uint64_t borders_left_out = 0;
    Scene scene;  ///< as loaded, but without its meshes: materials, textures, lights, cameras, animations
};

struct InspectOptions {
    bool borders = true;     ///< look for shared positions and their seam angles
    PrepareOptions prepare;  ///< whose normals the seam angles are about
};

/// Looks a loaded scene over. Decodes no texture. O(vertices log vertices).
Inspection inspect(const Scene& scene, const InspectOptions& options, Context& context);

/// A table for people, lines ending with line feeds; long lists are cut with "... N more".
std::string to_text(const Inspection& inspection);

/// A row of the program's JSON: what was found, or the error instead.
struct InspectionRow {
    std::string file;
    std::optional<Inspection> inspection;
    std::vector<ReportEntry> remarks;
    std::uint64_t remarks_left_out = 0;
    std::optional<Error> error;
};

/// {"schema": "rakelight.inspect/1", "rows": [...]} with a line feed at its end; UTF-8, foreign bytes replaced.
std::string to_json(std::span<const InspectionRow> rows);

}  // namespace rakelight
