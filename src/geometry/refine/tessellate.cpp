// SPDX-License-Identifier: Apache-2.0
#include "geometry/refine/tessellate.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "base/cancel_check.h"
#include "base/hash_key.h"
#include "math/linear.h"

namespace rakelight::geometry {
namespace {

constexpr int max_rounds = 40;  ///< each bisects edges that are too long

double squared_length(dvec3 a, dvec3 b) { return dot(a - b, a - b); }  // bit-identical for (b, a)

/// A mesh during tessellation.
class Cutter {
public:
    Cutter(FineMesh mesh, std::vector<std::uint8_t> on_border, const EdgeRule& is_halved)
        : fine(std::move(mesh)), on_border_(std::move(on_border)), is_halved_(is_halved) {}

    /// Triangles after one more round.
    std::uint64_t count_next(CancelCheck check) const {
        std::uint64_t count = fine.indices.size() / 3;
        for (std::size_t i = 0; i < fine.indices.size(); i += 3) {
            check();
            for (std::size_t k = 0; k < 3; ++k)
                count += std::uint64_t(is_cut(fine.indices[i + k], fine.indices[i + (k + 1) % 3]));
        }
        return count;
    }

    void run_round(CancelCheck check) {
        middles_.clear();
        std::vector<std::uint32_t> indices, sources;
        std::swap(indices, fine.indices);
        std::swap(sources, fine.source_triangle);
        for (std::size_t t = 0; t < sources.size(); ++t) {
            check();
            source_ = sources[t];
            cut({indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]});
        }
    }

    double longest_edge() const {
        double longest = 0;
        for (std::size_t i = 0; i < fine.indices.size(); i += 3)
            for (std::size_t k = 0; k < 3; ++k)
                longest = std::max(longest, squared_length(fine.places[fine.indices[i + k]],
                                                           fine.places[fine.indices[i + (k + 1) % 3]]));
        return std::sqrt(longest);
    }
    bool is_cut_everywhere() const { return on_border_.empty(); }

    /// Pairs of edges of the last round that share a slot.
    std::uint64_t met() const {
        std::uint64_t pairs = 0;
        for (std::size_t b = 0; b < middles_.bucket_count(); ++b)
            if (const std::uint64_t n = middles_.bucket_size(b); n > 1) pairs += n * (n - 1) / 2;
        return pairs;
    }

    FineMesh fine;

private:
    bool is_cut(std::uint32_t a, std::uint32_t b) const {
        if (!on_border_.empty() && !(on_border_[a] && on_border_[b])) return false;
        return is_halved_(fine.places[a], fine.places[b]);
    }

    std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
        const std::uint64_t key = std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
        const auto [entry, is_new] = middles_.try_emplace(key, std::uint32_t(fine.places.size()));
        if (is_new) {
            fine.places.push_back((fine.places[a] + fine.places[b]) * 0.5);
            fine.middle_of.push_back({std::min(a, b), std::max(a, b)});
            if (!on_border_.empty()) on_border_.push_back(1);
        }
        return entry->second;
    }

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        fine.indices.insert(fine.indices.end(), {a, b, c});
        fine.source_triangle.push_back(source_);
    }

    void cut(std::array<std::uint32_t, 3> v) {
        bool is[3];
        for (std::size_t k = 0; k < 3; ++k) is[k] = is_cut(v[k], v[(k + 1) % 3]);
        const int count = int(is[0]) + int(is[1]) + int(is[2]);
        // rotated so that the only split edge, or the only unsplit one, is the first
        std::size_t first = 0;
        while (count == 1 ? !is[first] : count == 2 && is[first]) ++first;
        const std::uint32_t a = v[first], b = v[(first + 1) % 3], c = v[(first + 2) % 3];
        if (count == 0) return add(a, b, c);
        if (count == 1) {
            const std::uint32_t m = middle(a, b);
            add(a, m, c);
            return add(m, b, c);
        }
        const std::uint32_t right = middle(b, c), left = middle(c, a);
        add(left, right, c);
        if (count == 3) {
            const std::uint32_t m = middle(a, b);
            add(a, m, left);
            add(m, b, right);
            return add(m, right, left);
        }
        if (squared_length(fine.places[a], fine.places[right]) <= squared_length(fine.places[b], fine.places[left])) {
            add(a, b, right);
            add(a, right, left);
        } else {
            add(a, b, left);
            add(b, right, left);
        }
    }

    std::vector<std::uint8_t> on_border_;
    const EdgeRule& is_halved_;
    std::uint32_t source_ = 0;
    /// Hash of an edge's two vertices, which come from a file: keyed.
    struct EdgeHash {
        std::size_t operator()(std::uint64_t edge) const {
            const HashKey key = hash_key_of_this_run();
            return std::size_t(folded_product(edge ^ key.a, key.b));
        }
    };
    std::unordered_map<std::uint64_t, std::uint32_t, EdgeHash> middles_;
};

struct Counts {
    std::uint64_t now = 0, after = 0;
};

Counts count_triangles(std::span<const Cutter> cutters, Context& context) {
    std::vector<std::uint64_t> next(cutters.size());
    const CancelCheck check(context);
    context.parallel_for(cutters.size(), [&](std::size_t i) { next[i] = cutters[i].count_next(check); });
    Counts out;
    for (std::size_t i = 0; i < cutters.size(); ++i)
        out.now += cutters[i].fine.indices.size() / 3, out.after += next[i];
    return out;
}

void run_round(std::span<Cutter> cutters, Context& context) {
    const CancelCheck check(context);
    context.parallel_for(cutters.size(), [&](std::size_t i) { cutters[i].run_round(check); });
}

}  // namespace

std::vector<CoarseMesh> coarse_meshes(const PlacedMeshes& placed) {
    std::vector<CoarseMesh> out(placed.input.meshes.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const std::span<const std::uint32_t> indices = placed.input.meshes[i].indices;
        out[i].indices.assign(indices.begin(), indices.end());
        for (std::uint32_t v = placed.input.vertex_base[i]; v < placed.input.vertex_base[i + 1]; ++v) {
            const dvec3 p = placed.position(placed.place[v]);
            out[i].places.push_back({p.x + 0.0, p.y + 0.0, p.z + 0.0});  // -0 becomes 0
        }
    }
    return out;
}

FineMesh uncut(CoarseMesh mesh) {
    FineMesh fine;
    fine.places = std::move(mesh.places);
    fine.indices = std::move(mesh.indices);
    fine.source_triangle.resize(fine.indices.size() / 3);
    std::iota(fine.source_triangle.begin(), fine.source_triangle.end(), 0u);
    return fine;
}

bool halve_edges(std::span<FineMesh> meshes, const EdgeRule& is_halved, std::uint64_t max_triangles, Context& context) {
    std::vector<Cutter> cutters;
    cutters.reserve(meshes.size());
    for (FineMesh& mesh : meshes) cutters.emplace_back(std::move(mesh), std::vector<std::uint8_t>{}, is_halved);
    const bool fits = count_triangles(cutters, context).after <= max_triangles;
    if (fits) run_round(cutters, context);
    for (std::size_t i = 0; i < meshes.size(); ++i) meshes[i] = std::move(cutters[i].fine);
    return fits;
}

Tessellation tessellate(std::span<const CoarseMesh> meshes, double edge, std::uint64_t max_triangles, Context& context,
                        std::uint64_t* met) {
    const double max_squared = edge * edge;
    const EdgeRule is_long = [=](dvec3 a, dvec3 b) { return squared_length(a, b) > max_squared; };
    std::vector<Cutter> cutters;
    cutters.reserve(meshes.size());
    for (const CoarseMesh& mesh : meshes) cutters.emplace_back(uncut(mesh), mesh.on_border, is_long);
    Tessellation out;
    for (int round = 0;; ++round) {
        context.throw_if_cancelled();
        const Counts count = count_triangles(cutters, context);
        if (count.after == count.now) break;
        out.is_complete = count.after <= max_triangles && round < max_rounds;
        if (!out.is_complete) break;
        run_round(cutters, context);
    }
    if (met) *met = 0;
    for (Cutter& cutter : cutters) {
        if (met) *met += cutter.met();
        if (cutter.is_cut_everywhere()) out.longest_edge = std::max(out.longest_edge, cutter.longest_edge());
        out.meshes.push_back(std::move(cutter.fine));
    }
    return out;
}

}  // namespace rakelight::geometry
