// SPDX-License-Identifier: Apache-2.0
#include "geometry/fast/fast_attributes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include <rakelight/geometry/creases.h>

#include "geometry/creases/crease_rule.h"
#include "geometry/fast/fast_stages.h"
#include "geometry/fits/fit_normals.h"
#include "geometry/general_attributes.h"
#include "math/isa.h"

namespace rakelight::geometry {
namespace {

// For rotation, uniform scale, mirroring and translation, normals and tangents of object space are rotated ones of
// world space.
bool keeps_angles(const dmat4& m) {
    constexpr double slack = 1e-12;
    const dvec3 x = m[0].xyz(), y = m[1].xyz(), z = m[2].xyz();
    const double size = dot(x, x);
    if (!(size > 1e-60 && size < 1e60)) return false;
    const auto near = [&](double a, double b) { return std::fabs(a - b) <= slack * size; };
    return near(dot(y, y), size) && near(dot(z, z), size) && near(dot(x, y), 0) && near(dot(y, z), 0) &&
           near(dot(z, x), 0);
}

// Whether no option needs the general path.
bool is_plain(const AttributeOptions& o) {
    return o.tangent_mode == TangentMode::averaged && o.orthogonalize == Orthogonalize::attribute &&
           !o.measure_orthogonality && !o.fans;
}
bool is_plain(const AttributeMesh& m) {
    return m.locked.empty() && m.position_step == 0 && m.smoothing_hint.empty() &&
           (m.smoothing.empty() || m.group_kind == GroupKind::none);
}

bool has_plain_creases(std::span<const AttributeMesh> meshes, const AttributeOptions& options) {
    const CreaseRange range = crease_range(meshes, options);
    const bool all_follow =
        std::all_of(meshes.begin(), meshes.end(), [&](const AttributeMesh& m) { return follows_rule(m, options); });
    return (!range.has_rule || all_follow) && range.least == range.most && range.least >= least_crease_rad;
}

// The rule of creases calls no edge hard that bends less than this. If all edges do, it is this crease angle.
constexpr double soft_rad = radians(soft_below_deg - thresholds_move_deg);
AttributeOptions without_rule(const AttributeOptions& options) {
    AttributeOptions plain = options;
    if (options.creases == Creasing::automatic) plain.creases = Creasing::angle, plain.crease_angle_rad = soft_rad;
    return plain;
}

// Very many small meshes: each would have its own splits here, beside its result.
bool is_crumbs(std::span<const AttributeMesh> meshes) {
    constexpr std::size_t many = 1u << 12, small = 16;
    std::size_t vertices = 0;
    for (const AttributeMesh& mesh : meshes) vertices += mesh.positions.size();
    return meshes.size() > many && vertices < small * meshes.size();
}

struct Kernels {
    const FastKernels* rows;
    const WeldKernels* weld;
    const LookKernels* looks;
};
Kernels kernels_for(Isa isa) {
    return {RL_BY_ISA(isa, fast_kernels()), RL_BY_ISA(isa, weld_kernels()), RL_BY_ISA(isa, look_kernels())};
}

std::vector<SplitAttributes> without_splits(const FastState& state) {
    std::vector<SplitAttributes> splits(state.input.meshes.size());
    for (std::size_t m = 0; m < splits.size(); ++m) {
        splits[m].degenerate_faces = state.degenerate[m];
        splits[m].isolated_vertices = state.isolated[m];
    }
    return splits;
}

FastState make_state(const AttributeInput& input, const AttributeOptions& options,
                     std::span<const AttributeBuffers> out, FastScratch& scratch, Context& context) {
    const std::span<const AttributeMesh> meshes = input.meshes;
    const bool tangents = options.tangents && std::any_of(meshes.begin(), meshes.end(),
                                                          [](const AttributeMesh& m) { return !m.texcoords.empty(); });
    const std::size_t vertices = input.vertex_count();
    const std::size_t floats = tangents ? tangent_row_floats : normal_row_floats;
    const CreaseRange range = crease_range(meshes, options);
    const bool fits = is_fitted(options.weight), looks = fits || !range.joins_all();
    const std::size_t more = (fits && tangents ? sizeof(LookRow) : 0) + (looks ? sizeof(Duplicate) : 0);
    context.memory().check(vertices * (floats * sizeof(float) + 20 + more), "smoothing normals");
    scratch.rows.reserve(vertices * floats);
    for (LaneScratch& lane : scratch.lanes) {
        lane.hashed.clear();
        lane.counts.clear();
    }
    const Kernels kernels = kernels_for(isa_from_environment());
    return {.input = input,
            .options = options,
            .out = out,
            .is_identity = meshes[0].to_world == dmat4{},
            .partition_bits = weld_partition_bits(input.vertex_count()),
            .scratch = scratch,
            .kernels = *kernels.rows,
            .weld_kernels = *kernels.weld,
            .look_kernels = *kernels.looks,
            .context = context,
            .tangents = tangents,
            .crease_rad = range.least,
            .fits = fits,
            .looks = looks,
            .degenerate = std::vector<std::uint32_t>(meshes.size(), 0),
            .isolated = std::vector<std::uint32_t>(meshes.size(), 0)};
}

// Its memory is not held beside that of the general path.
void forget(FastScratch& scratch) {
    GeneralScratch general = std::move(scratch.general);
    scratch = {};
    scratch.general = std::move(general);
}

// Nothing where the general path is the faster one, or the rule of creases must be asked; the contents of `out` are lost then.
std::optional<std::vector<SplitAttributes>> try_fast(std::span<const AttributeMesh> meshes,
                                                     const AttributeOptions& options,
                                                     std::span<const AttributeBuffers> out, FastScratch& scratch,
                                                     Context& context) {
    const AttributeInput input = number_input(meshes);
    const AttributeOptions plain = without_rule(options);
    FastState state = make_state(input, plain, out, scratch, context);
    if (!scatter_votes(state)) check_indices(input, context);
    weld_rows(state);
    context.throw_if_cancelled();
    std::vector<std::uint32_t> hard = finish_rows(state);
    context.throw_if_cancelled();
    if (state.looks) {
        const std::vector<std::uint32_t> weak = std::move(hard), creased = walk_fans(state, look_at_places(state));
        if (options.creases == Creasing::automatic && !creased.empty()) return std::nullopt;
        hard.clear();
        std::set_union(weak.begin(), weak.end(), creased.begin(), creased.end(), std::back_inserter(hard));
        context.throw_if_cancelled();
    }
    if (hard.size() > input.vertex_count() / 4) return std::nullopt;
    std::vector<SplitAttributes> splits = without_splits(state);
    if (state.fits)
        fit_places(state, hard, out, splits);
    else if (!hard.empty())
        redo_places(state, hard, out, splits);
    return splits;
}

}  // namespace

std::size_t FastScratch::bytes() const {
    std::size_t sum = rows.bytes() + looks.bytes() + records.bytes() + general.bytes();
    for (const auto& some : classes) sum += some.capacity() * sizeof(Duplicate);
    for (const auto& box : outbox) sum += box.capacity();
    for (const LaneScratch& lane : lanes)
        sum += lane.table.bytes() + lane.left.bytes() + lane.hashed.capacity() * sizeof(HashedRange) +
               lane.counts.capacity() * sizeof(std::uint32_t) + lane.duplicates.capacity() * sizeof(Duplicate) +
               lane.parcels.capacity() + lane.odd.capacity() * sizeof(std::uint32_t);
    return sum;
}

bool takes_fast_path(std::span<const AttributeMesh> meshes, const AttributeOptions& options) {
    const bool fits = options.normals && options.scope != Scope::face && options.weld_distance <= 0 &&
                      has_plain_creases(meshes, options);
    if (!fits || !is_plain(options) || meshes.empty() || !keeps_angles(meshes[0].to_world)) return false;
    const bool looks = is_fitted(options.weight) || !crease_range(meshes, options).joins_all();
    if (looks && is_crumbs(meshes)) return false;
    return std::all_of(meshes.begin(), meshes.end(),
                       [&](const AttributeMesh& m) { return m.to_world == meshes[0].to_world && is_plain(m); });
}

std::vector<SplitAttributes> fast_attributes(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                             std::span<const AttributeBuffers> out, FastScratch& scratch,
                                             Context& context) {
    if (std::optional<std::vector<SplitAttributes>> splits = try_fast(meshes, options, out, scratch, context))
        return std::move(*splits);
    forget(scratch);
    return general_attributes_into(meshes, options, out, scratch.general, context);
}

std::vector<MeshAttributes> fast_attributes(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                            Context& context) {
    std::vector<MeshAttributes> results(meshes.size());
    std::vector<AttributeBuffers> out(meshes.size());
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        results[m].normals.resize(meshes[m].positions.size());
        if (options.tangents && !meshes[m].texcoords.empty()) results[m].tangents.resize(meshes[m].positions.size());
        out[m] = {results[m].normals, results[m].tangents};
    }
    FastScratch scratch;
    std::optional<std::vector<SplitAttributes>> made = try_fast(meshes, options, out, scratch, context);
    if (!made) {
        forget(scratch);
        results = {}, out = {};
        return general_attributes(meshes, options, {}, scratch.general, context);
    }
    std::vector<SplitAttributes>& splits = *made;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        MeshAttributes& r = results[m];
        SplitAttributes& s = splits[m];
        r.degenerate_faces = s.degenerate_faces;
        r.isolated_vertices = s.isolated_vertices;
        r.normals.insert(r.normals.end(), s.normals.begin(), s.normals.end());
        r.tangents.insert(r.tangents.end(), s.tangents.begin(), s.tangents.end());
        r.source_vertex = std::move(s.source_vertex);
        if (s.corners.empty()) continue;
        r.indices.assign(meshes[m].indices.begin(), meshes[m].indices.end());
        for (const CornerVertex& c : s.corners) r.indices[c.corner] = c.vertex;
    }
    return results;
}

}  // namespace rakelight::geometry
