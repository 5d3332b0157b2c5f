// SPDX-License-Identifier: Apache-2.0
// Corners are joined where position, normal and texture coordinate are equal. Around each joined corner, faces that
// share an edge and turn the texture the same way form a group; its faces' tangents, laid into the plane of the normal
// and made unit, are summed by the angle at the corner. Faces without texture area are not summed; they join the first
// group that reaches them.
//
// Everything is in float with the operation order of the reference code, so that decisions by rounding (weights of
// narrow corners, nearly vanishing sums, opposite tangents) agree. Only values whose squares exceed the float range use
// double.
#include "geometry/tangents/mikktspace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "geometry/input/face_vote.h"
#include "math/functions.h"

namespace rakelight::geometry {
namespace {

constexpr std::uint32_t no_index = 0xffffffffu;
constexpr float smallest = std::numeric_limits<float>::min();  // zero threshold of the reference code
constexpr std::size_t few = 256;

std::uint32_t next(std::uint32_t k) { return k == 2 ? 0 : k + 1; }
std::uint32_t before(std::uint32_t k) { return k == 0 ? 2 : k - 1; }

struct Face {
    std::uint32_t triangle;
    std::array<std::uint32_t, 3> vertex;    // joined
    std::array<std::uint32_t, 3> neighbor;  // face over the edge from corner k to the next
    std::array<bool, 3> done;               // corner k has its group
    bool preserves;                         // texture coordinates run counter-clockwise, as stored
    bool follows;                           // no texture area: takes the orientation of the first group that reaches it
    vec3 s, t;                              // unit dP/du and dP/dv
};

struct Member {
    std::uint32_t face, corner;
    vec3 s, t;  // in the plane of the normal
    float angle;
};

float length_of(vec3 v) {
    const float square = dot(v, v);
    return square > 1e-30f && square < 1e30f ? std::sqrt(square) : float(direction_of(cast<double>(v)).length);
}
vec3 unit_or_zero(vec3 v) {
    const float square = dot(v, v);
    if (square > 1e-30f && square < 1e30f) return v * (1.0f / std::sqrt(square));
    return cast<float>(direction_of(cast<double>(v)).unit);
}

// a * x - b * y; in double, and normalized, if float overflows.
vec3 combine(vec3 a, float x, vec3 b, float y) {
    const vec3 v = a * x - b * y;
    if (is_finite(v)) return v;
    return cast<float>(direction_of(cast<double>(a) * double(x) - cast<double>(b) * double(y)).unit);
}

class Mikktspace {
public:
    explicit Mikktspace(const MikktspaceMesh& mesh) : mesh_(mesh) {}

    std::vector<vec4> run() {
        join_vertices();
        make_faces();
        link_faces();
        tangents_.assign(mesh_.indices.size(), vec4{0, 0, 0, 1});
        for (std::uint32_t f = 0; f < faces_.size(); ++f)
            for (std::uint32_t k = 0; k < 3; ++k)
                if (!faces_[f].follows && !faces_[f].done[k]) {
                    collect(f, k);
                    lay_out(faces_[f].vertex[k]);
                    sum(faces_[f].preserves);
                }
        copy_to_degenerate();
        return std::move(tangents_);
    }

private:
    auto key(std::uint32_t v) const {
        const vec3 p = mesh_.positions[v] + vec3{}, n = mesh_.normals[v] + vec3{};  // -0 becomes 0
        const vec2 q = mesh_.texcoords[v];
        return std::tuple(p.x, p.y, p.z, n.x, n.y, n.z, q.x + 0.0f, q.y + 0.0f);
    }

    // Equal in all eight numbers: the smallest vertex represents them. Non-finite values are never equal.
    void join_vertices() {
        joined_.resize(mesh_.positions.size());
        std::vector<std::uint32_t> order;
        order.reserve(joined_.size());
        for (std::uint32_t v = 0; v < joined_.size(); ++v) {
            joined_[v] = v;
            const vec2 q = mesh_.texcoords[v];
            if (is_finite(mesh_.positions[v]) && is_finite(mesh_.normals[v]) && std::isfinite(q.x) &&
                std::isfinite(q.y))
                order.push_back(v);
        }
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            const auto x = key(a), y = key(b);
            return x != y ? x < y : a < b;
        });
        for (std::size_t i = 1; i < order.size(); ++i)
            if (key(order[i]) == key(order[i - 1])) joined_[order[i]] = joined_[order[i - 1]];
    }

    // Two corners at one place, or a non-finite corner: no face, as in the reference code.
    bool is_face(const std::uint32_t* index) const {
        const vec3 a = mesh_.positions[index[0]], b = mesh_.positions[index[1]], c = mesh_.positions[index[2]];
        return is_finite(a) && is_finite(b) && is_finite(c) && !(a == b) && !(a == c) && !(b == c);
    }

    void make_faces() {
        for (std::uint32_t t = 0; t < mesh_.indices.size() / 3; ++t) {
            const std::uint32_t* index = &mesh_.indices[3 * std::size_t(t)];
            if (!is_face(index)) continue;
            Face face{t, {}, {no_index, no_index, no_index}, {false, false, false}, false, true, {}, {}};
            for (std::size_t k = 0; k < 3; ++k) face.vertex[k] = joined_[index[k]];
            map_texture(face, index);
            faces_.push_back(face);
        }
    }

    void map_texture(Face& face, const std::uint32_t* index) const {
        const vec2 q0 = mesh_.texcoords[index[0]], q1 = mesh_.texcoords[index[1]], q2 = mesh_.texcoords[index[2]];
        const float du1 = q1.x - q0.x, dv1 = q1.y - q0.y, du2 = q2.x - q0.x, dv2 = q2.y - q0.y;
        const float area = du1 * dv2 - dv1 * du2, size = std::fabs(area);
        const vec3 p0 = mesh_.positions[index[0]], e1 = mesh_.positions[index[1]] - p0,
                   e2 = mesh_.positions[index[2]] - p0;
        face.preserves = area > 0;
        if (!(size > smallest)) return;
        const vec3 s = combine(e1, dv2, e2, dv1), t = combine(e2, du1, e1, du2);
        const float s_length = length_of(s), t_length = length_of(t), side = face.preserves ? 1.0f : -1.0f;
        if (s_length > smallest) face.s = s * (side / s_length);
        if (t_length > smallest) face.t = t * (side / t_length);
        face.follows =
            !(s_length / size > smallest && t_length / size > smallest) || !is_finite(face.s) || !is_finite(face.t);
    }

    struct Edge {
        std::uint32_t low, high, face, corner;
        bool rising;  // from low to high
    };

    // At an edge of more than two faces, the n-th face in one direction is paired with the n-th in the other.
    void link_faces() {
        std::vector<Edge> edges;
        edges.reserve(3 * faces_.size());
        for (std::uint32_t f = 0; f < faces_.size(); ++f)
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t a = faces_[f].vertex[k], b = faces_[f].vertex[next(k)];
                edges.push_back({std::min(a, b), std::max(a, b), f, k, a < b});
            }
        std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
            return std::tuple(a.low, a.high, !a.rising, a.face) < std::tuple(b.low, b.high, !b.rising, b.face);
        });
        for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
            std::size_t back = first;
            const auto same = [&](std::size_t i) {
                return i < edges.size() && edges[i].low == edges[first].low && edges[i].high == edges[first].high;
            };
            while (same(back) && edges[back].rising) ++back;
            for (last = back; same(last);) ++last;
            for (std::size_t a = first, b = back; a < back && b < last; ++a, ++b) {
                faces_[edges[a].face].neighbor[edges[a].corner] = edges[b].face;
                faces_[edges[b].face].neighbor[edges[b].corner] = edges[a].face;
            }
        }
    }

    // The group of a corner: faces connected over edges with equal texture orientation.
    void collect(std::uint32_t first, std::uint32_t corner) {
        const std::uint32_t vertex = faces_[first].vertex[corner];
        const bool preserves = faces_[first].preserves;
        members_.clear();
        stack_.assign(1, first);
        while (!stack_.empty()) {
            const std::uint32_t f = stack_.back();
            stack_.pop_back();
            Face& face = faces_[f];
            const std::uint32_t k = face.vertex[0] == vertex ? 0 : face.vertex[1] == vertex ? 1 : 2;
            if (face.done[k]) continue;
            if (face.follows && !face.done[0] && !face.done[1] && !face.done[2]) face.preserves = preserves;
            if (face.preserves != preserves) continue;
            face.done[k] = true;
            members_.push_back({f, k, {}, {}, 0});
            for (const std::uint32_t edge : {before(k), k})
                if (face.neighbor[edge] != no_index) stack_.push_back(face.neighbor[edge]);
        }
        std::sort(members_.begin(), members_.end(), [](const Member& a, const Member& b) { return a.face < b.face; });
    }

    void lay_out(std::uint32_t vertex) {
        const vec3 n = mesh_.normals[vertex];
        const auto across = [&](vec3 v) { return unit_or_zero(v - n * dot(n, v)); };
        const auto position = [&](const Face& face, std::uint32_t k) { return mesh_.positions[face.vertex[k]]; };
        for (Member& m : members_) {
            const Face& face = faces_[m.face];
            m.s = across(face.s);
            m.t = across(face.t);
            const vec3 p = position(face, m.corner);
            const vec3 a = across(position(face, before(m.corner)) - p), b = across(position(face, next(m.corner)) - p);
            m.angle = float(math::acos(double(std::clamp(dot(a, b), -1.0f, 1.0f))));
        }
    }

    // An angular threshold of 180 degrees: all except exactly opposite ones.
    bool meet(const Member& a, const Member& b) const {
        if (a.face == b.face || faces_[a.face].follows || faces_[b.face].follows) return true;
        return dot(a.s, b.s) > -1.0f && dot(a.t, b.t) > -1.0f;
    }

    void sum(bool preserves) {
        const float hand = preserves ? -1.0f : 1.0f;  // v is stored downwards, the bitangent points up
        bool all_meet = true;
        for (std::size_t a = 0; a < members_.size() && members_.size() <= few; ++a)
            for (std::size_t b = a + 1; b < members_.size() && all_meet; ++b) all_meet = meet(members_[a], members_[b]);
        vec3 common;
        if (all_meet) common = sum_for(nullptr);
        for (const Member& m : members_) {
            const vec3 s = all_meet ? common : sum_for(&m);
            tangents_[3 * std::size_t(faces_[m.face].triangle) + m.corner] = {s.x, s.y, s.z, hand};
        }
    }

    vec3 sum_for(const Member* own) const {
        vec3 total;
        for (const Member& m : members_)
            if (!faces_[m.face].follows && (own == nullptr || meet(*own, m))) total += m.s * m.angle;
        return unit_or_zero(total);
    }

    // A face without area takes the tangents of the first face at each of its joined corners.
    void copy_to_degenerate() {
        if (3 * faces_.size() == mesh_.indices.size()) return;
        std::vector<std::uint32_t> source(joined_.size(), no_index);
        for (const Face& face : faces_)
            for (std::uint32_t k = 0; k < 3; ++k)
                if (source[face.vertex[k]] == no_index) source[face.vertex[k]] = 3 * face.triangle + k;
        std::size_t f = 0;
        for (std::uint32_t t = 0; t < mesh_.indices.size() / 3; ++t) {
            if (f < faces_.size() && faces_[f].triangle == t) {
                ++f;
                continue;
            }
            for (std::size_t i = 3 * std::size_t(t); i < 3 * std::size_t(t) + 3; ++i) {
                const std::uint32_t from = source[joined_[mesh_.indices[i]]];
                if (from != no_index) tangents_[i] = tangents_[from];
            }
        }
    }

    const MikktspaceMesh& mesh_;
    std::vector<std::uint32_t> joined_;  // [V]
    std::vector<Face> faces_;
    std::vector<Member> members_;
    std::vector<std::uint32_t> stack_;
    std::vector<vec4> tangents_;  // [3T]
};

}  // namespace

std::vector<vec4> mikktspace_corners(const MikktspaceMesh& mesh) { return Mikktspace(mesh).run(); }

std::uint64_t mikktspace_bytes(std::uint64_t vertices, std::uint64_t triangles) {
    constexpr std::uint64_t edge = 20;
    return vertices * 3 * sizeof(std::uint32_t) + triangles * (2 * sizeof(Face) + 3 * (edge + 2 * sizeof(vec4)));
}

}  // namespace rakelight::geometry
