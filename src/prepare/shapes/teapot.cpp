// SPDX-License-Identifier: Apache-2.0
// The Utah teapot from Martin Newell's patches of 1975. The data are z up and 3.15 high; here y is up, the height is 1 and
// the pot stands on the plane y = 0 about the y axis, spout to +x.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include <rakelight/base/error.h>

#include "base/format_text.h"
#include "math/linear.h"
#include "prepare/shapes/teapot.h"

namespace rakelight {
namespace {

enum class Part : std::uint8_t { rim, body, handle, spout, lid, bottom };
constexpr const char* part_names[] = {"rim", "body", "handle", "spout", "lid", "bottom"};

struct Patch {
    Part part;
    std::array<std::uint16_t, 16> points;  ///< four rows of four, into `points`
};

#include "teapot_patches.inc"

constexpr double height = 3.15;
constexpr int max_divisions = 256;

/// Bernstein weights of degree 3 at k / n, times n^3: integers, so that k and n - k are exactly mirrored.
std::array<double, 4> bernstein(int k, int n) {
    const double a = n - k, b = k;
    return {a * a * a, 3 * a * a * b, 3 * a * b * b, b * b * b};
}

/// One Bezier curve at k / n. Symmetric: the reversed curve at n - k is bit-identical, so two patches with a common
/// border in opposite directions meet exactly.
dvec3 curve(dvec3 p0, dvec3 p1, dvec3 p2, dvec3 p3, int k, int n) {
    const auto w = bernstein(k, n);
    const dvec3 sum = (p0 * w[0] + p3 * w[3]) + (p1 * w[1] + p2 * w[2]);
    return sum / (double(n) * n * n);
}

/// The patch at row parameter s / n and column parameter t / n. On a border one of the two steps returns control points
/// unchanged, so the result is the border's curve in either direction.
dvec3 surface(const Patch& patch, int s, int t, int n) {
    dvec3 row[4];
    for (std::size_t j = 0; j < 4; ++j)
        row[j] = curve(points[patch.points[j]], points[patch.points[4 + j]], points[patch.points[8 + j]],
                       points[patch.points[12 + j]], s, n);
    return curve(row[0], row[1], row[2], row[3], t, n);
}

vec3 placed(dvec3 p) { return cast<float>(dvec3{p.x, p.z, -p.y} / height); }

struct Arrays {
    std::vector<vec3> positions;
    std::vector<vec2> texcoords;
    std::vector<std::uint32_t> indices;
};

/// The first row of a patch at the lid's tip or the bottom's center is one point.
bool has_pole(const Patch& patch) {
    const auto& p = patch.points;
    return p[0] == p[1] && p[1] == p[2] && p[2] == p[3];
}

/// Seen from outside, columns run to the left, so u = 1 - t: the texture is not mirrored, and (v0, u0) (v1, u0) (v1,
/// u1) is counter-clockwise. A pole has one vertex per column with the u of its middle, and no zero-area triangles.
void add_patch(const Patch& patch, int n, Arrays& out) {
    const auto first = std::uint32_t(out.positions.size());
    const bool pole = has_pole(patch);
    const auto add_vertex = [&](int v, int column, double u) {
        out.positions.push_back(placed(surface(patch, v, n - column, n)));
        out.texcoords.push_back({float(u), float(double(v) / n)});
    };
    const int top_count = pole ? n : n + 1;
    for (int c = 0; c < top_count; ++c) add_vertex(0, c, (c + (pole ? 0.5 : 0.0)) / n);
    for (int v = 1; v <= n; ++v)
        for (int c = 0; c <= n; ++c) add_vertex(v, c, double(c) / n);
    const auto at = [&](int v, int c) { return first + std::uint32_t(v == 0 ? c : top_count + (v - 1) * (n + 1) + c); };
    for (int v = 0; v < n; ++v)
        for (int c = 0; c < n; ++c) {
            out.indices.insert(out.indices.end(), {at(v, c), at(v + 1, c), at(v + 1, c + 1)});
            if (!(pole && v == 0)) out.indices.insert(out.indices.end(), {at(v, c), at(v + 1, c + 1), at(v, c + 1)});
        }
}

/// A control point.
dvec3 at(const Patch& patch, std::size_t row, std::size_t column) { return points[patch.points[4 * row + column]]; }

/// Error bound, times n^2, of a patch with n x n quads of two triangles each, in the data's unit. Filip, Magedson &
/// Markot 1986, "Surface algorithms using bounds on derivatives": on a right triangle with legs of 1 / n in u and v,
/// linear interpolation is off by at most (max |S_uu| + 2 max |S_uv| + max |S_vv|) / (8 n^2). Second derivatives of a
/// bicubic patch are Bezier patches of 6 times the second differences of its control points (S_uv: 9 times the mixed
/// ones) and lie in their convex hulls.
double error_bound(const Patch& patch) {
    double uu = 0, uv = 0, vv = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            if (i < 2) uu = std::max(uu, length(at(patch, i + 2, j) - at(patch, i + 1, j) * 2.0 + at(patch, i, j)));
            if (j < 2) vv = std::max(vv, length(at(patch, i, j + 2) - at(patch, i, j + 1) * 2.0 + at(patch, i, j)));
            if (i < 3 && j < 3)
                uv = std::max(uv, length((at(patch, i + 1, j + 1) - at(patch, i + 1, j)) -
                                         (at(patch, i, j + 1) - at(patch, i, j))));
        }
    return (6 * uu + 2 * 9 * uv + 6 * vv) / 8;
}

/// Size of the arrays of all patches.
std::size_t bytes_of(std::size_t n) {
    constexpr std::size_t vertex = sizeof(vec3) + sizeof(vec2), index = sizeof(std::uint32_t);
    std::size_t bytes = 0;
    for (const Patch& patch : patches) {
        const std::size_t pole = has_pole(patch) ? 1 : 0;
        bytes += ((n + 1) * (n + 1) - pole) * vertex + (6 * n * n - pole * 3 * n) * index;
    }
    return bytes;
}

Material porcelain() {
    Material m;
    m.name = "porcelain";
    m.model = MaterialModel::classical;
    m.base_color = {0.72f, 0.68f, 0.58f, 1};
    m.classical.ambient = m.base_color.xyz();
    m.classical.specular = {0.35f, 0.35f, 0.35f};
    m.classical.shininess = 60;
    m.double_sided = true;  // the surface has no thickness, and its inside is visible at spout and lid
    return m;
}

}  // namespace

int teapot_divisions(double tolerance) {
    double bound = 0;
    for (const Patch& patch : patches) bound = std::max(bound, error_bound(patch) / height);
    const double divisions = std::ceil(std::sqrt(bound / tolerance));
    if (!(divisions <= max_divisions))
        throw Error(ErrorCode::usage, "the tolerance asks for more than 256 divisions of the teapot's patches", {},
                    "say a larger one");
    return std::max(int(divisions), 2);  // with 1 the spout's opening collapses to a line
}

Scene make_teapot(int divisions, MemoryBudget* memory) {
    if (divisions < 1 || divisions > max_divisions)
        throw Error(ErrorCode::usage, format_text("divisions of the teapot must be 1 to 256, not {}", divisions));
    Scene scene;
    scene.source = "builtin:teapot";
    scene.materials.push_back(porcelain());
    MemoryCharge charge;
    if (memory) charge = MemoryCharge(*memory, bytes_of(std::size_t(divisions)), "a shape");
    const auto block = [&](auto&& array) {
        MemoryCharge own = charge.split(array.size() * sizeof(array[0]));
        return Block(std::move(array), std::move(own));
    };
    for (std::size_t part = 0; part < std::size(part_names); ++part) {
        Arrays arrays;
        for (const Patch& patch : patches)
            if (patch.part == Part(part)) add_patch(patch, divisions, arrays);
        Mesh mesh;
        mesh.name = part_names[part];
        mesh.positions = block(std::move(arrays.positions));
        mesh.texcoords.push_back(block(std::move(arrays.texcoords)));
        mesh.indices = block(std::move(arrays.indices));
        mesh.material = 0;
        Node node;
        node.name = part_names[part];
        node.meshes = {std::uint32_t(part)};
        scene.meshes.push_back(std::move(mesh));
        scene.nodes.push_back(std::move(node));
    }
    return scene;
}

}  // namespace rakelight
