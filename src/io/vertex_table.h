// SPDX-License-Identifier: Apache-2.0
// The vertex data of point clouds and PLY files: columns of numbers by name, assembled into the arrays of a mesh.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "io/color_columns.h"

namespace rakelight::io {

/// Where the numbers of one column go: value -> *(base + row * stride).
struct ColumnTarget {
    float* floats = nullptr;
    double* doubles = nullptr;  ///< instead of `floats`
    std::size_t stride = 1;
    bool is_dropped() const { return !floats && !doubles; }
    void set(std::uint64_t row, double value) const {
        if (doubles)
            doubles[row * stride] = value;
        else if (floats)
            floats[row * stride] = float(value);
    }
};

struct ColumnKind {
    bool is_real = true;        ///< written as float, double or text
    bool needs_double = false;  ///< more digits than a float holds may be there: double, int, text
    ColorScale color = ColorScale::by_value;
};

/// Vertices while they are read. Names are those that writers of scans use; case does not matter, and all others are
/// arrays:
/// - x y z; nx ny nz, normal_x ...
/// - red green blue alpha, diffuse_red ..., r g b a, rgb and rgba (packed 0xaarrggbb, as PCL writes them), f_dc_0 ...
///   (Gaussian splats)
/// - s t, u v, texture_u texture_v
class VertexTable {
public:
    VertexTable(std::uint64_t count, Context& context);

    /// Makes place for a column of that name, and says where its numbers go. A name that comes twice counts the first time.
    /// @throws Error bad_file: over the memory limit
    ColumnTarget column(std::string_view name, ColumnKind kind);
    std::uint64_t count() const { return count_; }
    bool has_positions() const { return has_axis_[0] && has_axis_[1] && has_axis_[2]; }
    bool has_colors() const { return !colors_.empty() || !packed_.empty() || !harmonics_.empty(); }
    /// [count] The place of a vertex, NaN where it is none.
    dvec3 position(std::uint64_t vertex) const;

    /// Positions, normals, colors, texture coordinates (v down) and arrays, [count], into a mesh; the table is empty then.
    /// Says what was guessed or left out.
    void move_to(Mesh& mesh, const std::string& path);

private:
    ColumnTarget position_column(std::size_t axis, ColumnKind kind);
    template <class T>
    float* part_of(std::vector<T>& array, std::size_t component, T filled_with);
    void finish_positions(Mesh& mesh, const std::string& path);
    void finish_normals(Mesh& mesh, const std::string& path);
    void finish_colors(Mesh& mesh, const std::string& path);
    void unpack_colors();
    template <class T>
    Block<T> block_of(std::vector<T>& array);

    std::uint64_t count_;
    Context& context_;
    MemoryCharge charge_;
    bool has_axis_[3] = {false, false, false};
    std::vector<vec3> positions_;
    std::vector<dvec3> exact_;  ///< instead of `positions_`
    std::vector<vec3> normals_, harmonics_;
    std::vector<vec4> colors_;
    ColorColumns color_columns_;
    std::vector<double> packed_;
    bool is_packed_real_ = false, has_packed_alpha_ = false;
    std::vector<vec2> texcoords_;
    std::vector<std::pair<std::string, std::vector<float>>> arrays_;
};

}  // namespace rakelight::io
