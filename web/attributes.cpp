// SPDX-License-Identifier: Apache-2.0
// The attributes for JavaScript (npm/attributes.js): parts are copied in, a function runs over all, results are copied out.
#include <cstdint>
#include <cstring>
#include <deque>
#include <new>
#include <string>
#include <vector>

#include <emscripten.h>

#include <rakelight/geometry/attributes.h>
#include <rakelight/geometry/seams.h>

using namespace rakelight;

namespace {

/// A part as JavaScript gives it.
struct Part {
    std::vector<vec3> positions, normals;
    std::vector<vec2> texcoords;
    std::vector<std::uint32_t> indices, smoothing;
    double to_world[16], object, position_step, crease_angle_rad;  ///< to_world by columns
    MeshAttributes made;
    MeshSeams seams;
};

struct Work {
    std::deque<Part> parts;
    SeamReport report;
    std::string error;
};

Work& work() {
    static Work all;
    return all;
}

dmat4 matrix_of(const double (&elements)[16]) {
    dmat4 matrix;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) matrix[column][row] = elements[4 * column + row];
    return matrix;
}

std::vector<AttributeMesh> meshes() {
    std::vector<AttributeMesh> all;
    for (const Part& part : work().parts)
        all.push_back({.object = std::uint32_t(part.object),
                       .positions = part.positions,
                       .indices = part.indices,
                       .texcoords = part.texcoords,
                       .normals = part.normals,
                       .smoothing = part.smoothing,
                       .group_kind = part.smoothing.empty() ? GroupKind::none : GroupKind::numbers,
                       .to_world = matrix_of(part.to_world),
                       .position_step = part.position_step,
                       .crease_angle_rad = part.crease_angle_rad});
    return all;
}

/// @returns 0, or 1 with the text of the error
template <class Run>
int said(const Run& run) {
    try {
        run();
        return 0;
    } catch (const Error& error) {
        work().error = error.what();
    } catch (const std::bad_alloc&) {
        work().error = "not enough memory";
    }
    return 1;
}

template <class T>
void* sized(std::vector<T>& array, double count) {
    array.resize(std::size_t(count));
    return array.data();
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* rl_error() { return work().error.c_str(); }

EMSCRIPTEN_KEEPALIVE void rl_clear() { work() = {}; }

/// The next part. @returns where its 19 numbers go: the matrix by columns, object, step of quantization, crease angle (< 0: none)
EMSCRIPTEN_KEEPALIVE double* rl_add_part() {
    static_assert(offsetof(Part, crease_angle_rad) == offsetof(Part, to_world) + 18 * sizeof(double));
    return work().parts.emplace_back().to_world;
}

/// Memory for an array of the last part: 0 positions, 1 normals, 2 texture coordinates, 3 indices, 4 smoothing groups.
/// @param count  of vectors or numbers @returns null: there is no memory
EMSCRIPTEN_KEEPALIVE void* rl_array(int what, double count) {
    Part& part = work().parts.back();
    void* memory = nullptr;
    said([&] {
        memory = what == 0   ? sized(part.positions, count)
                 : what == 1 ? sized(part.normals, count)
                 : what == 2 ? sized(part.texcoords, count)
                 : what == 3 ? sized(part.indices, count)
                             : sized(part.smoothing, count);
    });
    return memory;
}

EMSCRIPTEN_KEEPALIVE int rl_compute_attributes(int scope, int weight, int creases, double crease_angle_rad,
                                               double weld_distance, int tangents, int tangent_mode, int keeps_normals,
                                               int groups_across) {
    return said([&] {
        AttributeOptions options;
        options.scope = Scope(scope);
        options.weight = CornerWeight(weight);
        options.creases = Creasing(creases);
        options.crease_angle_rad = crease_angle_rad;
        options.weld_distance = weld_distance;
        options.tangents = tangents != 0;
        options.tangent_mode = TangentMode(tangent_mode);
        options.normals = keeps_normals == 0;
        options.groups_across = groups_across != 0;
        Context context({.threads = 1});
        std::vector<MeshAttributes> made = compute_attributes(meshes(), options, context);
        for (std::size_t i = 0; i < made.size(); ++i) work().parts[i].made = std::move(made[i]);
    });
}

EMSCRIPTEN_KEEPALIVE int rl_join_seams(int creases, double crease_angle_rad, double weld_distance) {
    return said([&] {
        Context context({.threads = 1});
        std::vector<MeshSeams> joined =
            join_seams(meshes(), {crease_angle_rad, Creasing(creases), weld_distance}, work().report, context);
        for (std::size_t i = 0; i < joined.size(); ++i) work().parts[i].seams = std::move(joined[i]);
    });
}

/// Of join_seams(): 0 normals, 1 turned, 2 the largest and 3 the mean angle [degrees], 4 unusable.
EMSCRIPTEN_KEEPALIVE double rl_report(int what) {
    const SeamReport& report = work().report;
    return what == 0   ? double(report.normals)
           : what == 1 ? double(report.turned)
           : what == 2 ? report.max_deg
           : what == 3 ? report.mean_deg
                       : double(report.unusable);
}

}  // extern "C"

namespace {

struct Bytes {
    const void* data;
    std::size_t count;
};

template <class T>
Bytes bytes_of(const std::vector<T>& array) {
    return {array.data(), array.size()};
}

/// Arrays of results: 0 normals, 1 tangents, 2 bitangents, 3 indices, 4 source vertices; 5 vertices whose authored normals turned,
/// 6 their normals.
Bytes result(int part, int what) {
    const Part& of = work().parts[std::size_t(part)];
    switch (what) {
        case 0:
            return bytes_of(of.made.normals);
        case 1:
            return bytes_of(of.made.tangents);
        case 2:
            return bytes_of(of.made.bitangents);
        case 3:
            return bytes_of(of.made.indices);
        case 4:
            return bytes_of(of.made.source_vertex);
        case 5:
            return bytes_of(of.seams.vertices);
        default:
            return bytes_of(of.seams.normals);
    }
}

}  // namespace

extern "C" {
EMSCRIPTEN_KEEPALIVE const void* rl_result(int part, int what) { return result(part, what).data; }
EMSCRIPTEN_KEEPALIVE double rl_result_count(int part, int what) { return double(result(part, what).count); }
}
