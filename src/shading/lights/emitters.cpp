// SPDX-License-Identifier: Apache-2.0
#include "shading/lights/emitters.h"

#include <algorithm>
#include <cmath>

#include "math/linear.h"
#include "shading/lights/luminance.h"
#include "shading/lights/mean_map.h"

namespace rakelight::shading {
namespace {

constexpr std::size_t triangles_per_task = 16384;

/// The area of a triangle in the world as a vector along its normal, by the order of its corners.
dvec3 area_of(const dmat3& linear, const Mesh& mesh, std::uint32_t triangle) {
    const std::uint32_t* const index = mesh.indices.data() + 3 * std::size_t(triangle);
    const dvec3 a = cast<double>(mesh.positions[index[0]]);
    const dvec3 u = linear * (cast<double>(mesh.positions[index[1]]) - a);
    const dvec3 v = linear * (cast<double>(mesh.positions[index[2]]) - a);
    return cross(u, v) * 0.5;
}

/// Mean emission of the triangles of one draw.
class Emission {
public:
    Emission(const DrawList& list, const TextureCache& textures, const Draw& draw)
        : mesh_(list.scene.meshes[draw.mesh]) {
        const DrawMaterial& drawn = list.material(draw);
        const float* const e = drawn.factors.emission;
        factor_ = {double(e[0]), double(e[1]), double(e[2])};
        if (!drawn.maps[role_emission]) return;
        const TextureUse& use = list.scene_material(drawn).emission_texture;
        const LoadedTexture* const texture = textures.find(key_of(list, drawn, texture_roles()[role_emission]));
        if (!texture || !texture->means) return;
        means_ = &*texture->means;
        sampler_ = list.scene.textures[use.texture].sampler;
        transform_ = uv_transform(use);
        if (has_coordinates(mesh_, use.texcoord_set)) uvs_ = &mesh_.texcoords[use.texcoord_set];
    }

    double luminance(std::uint32_t triangle) const {
        if (!means_) return luminance_of(factor_);
        return luminance_of(factor_ * means_->mean(box_of(triangle), sampler_.wrap_u, sampler_.wrap_v));
    }

private:
    vec2 corner(std::uint32_t vertex) const {
        const vec2 uv = uvs_ ? (*uvs_)[vertex] : vec2{0, 0};  // as kernels read meshes without coordinates
        const UvTransform& t = transform_;
        return {t.uu * uv.x + t.uv * uv.y + t.u0, t.vu * uv.x + t.vv * uv.y + t.v0};
    }
    UvBox box_of(std::uint32_t triangle) const {
        const std::uint32_t* const index = mesh_.indices.data() + 3 * std::size_t(triangle);
        const vec2 a = corner(index[0]), b = corner(index[1]), c = corner(index[2]);
        return {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
                {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}};
    }

    const Mesh& mesh_;
    dvec3 factor_;
    const MeanMap* means_ = nullptr;
    Sampler sampler_;
    UvTransform transform_{};
    const Block<vec2>* uvs_ = nullptr;
};

}  // namespace

bool emits(const DrawMaterial& material) {
    const float* const e = material.factors.emission;
    return luminance_of(vec3{e[0], e[1], e[2]}) > 0;
}

Emitters::Emitters(const DrawList& list, const TextureCache& textures, FrontFace front_face, Context& context)
    : list_(&list), clockwise_(front_face == FrontFace::clockwise) {
    add_parts(list, context);
    if (parts_.empty()) return;
    weigh(textures, context);
}

void Emitters::add_parts(const DrawList& list, Context& context) {
    std::uint64_t count = 0, parts = 0;
    const auto triangles_of = [&](std::size_t d) -> std::uint64_t {
        const Draw& draw = list.draws[d];
        if (!emits(list.material(draw))) return 0;
        return list.scene.meshes[draw.mesh].triangle_count();
    };
    for (std::size_t d = 0; d < list.draws.size(); ++d)
        if (const std::uint64_t n = triangles_of(d)) count += n, ++parts;
    if (parts == 0) return;
    if (count >= no_index) throw Error(ErrorCode::bad_file, "more than 2^32 triangles emit light");
    charge_ = MemoryCharge(context.memory(),
                           AliasTable::bytes_for(count) + count * sizeof(float) + (parts + 1) * sizeof(Part) +
                               list.draws.size() * sizeof(std::uint32_t),
                           "triangles that emit light");
    parts_.reserve(parts + 1);
    first_of_draw_.assign(list.draws.size(), no_index);
    pdf_area_.resize(count);
    std::uint32_t first = 0;
    for (std::size_t d = 0; d < list.draws.size(); ++d)
        if (const std::uint64_t n = triangles_of(d)) {
            parts_.push_back({std::uint32_t(d), first});
            first_of_draw_[d] = first;
            first += std::uint32_t(n);
        }
    parts_.push_back({no_index, first});
}

void Emitters::weigh(const TextureCache& textures, Context& context) {
    const std::size_t count = pdf_area_.size();
    const MemoryCharge moment(context.memory(), AliasTable::bytes_to_make(count) + count * sizeof(double),
                              "triangles that emit light");
    std::vector<double> weights(count);
    for_parts(context, [&](const Part& part, std::uint32_t begin, std::uint32_t end) {
        const Draw& draw = list_->draws[part.draw];
        const Emission emission(*list_, textures, draw);
        const double sides = list_->material(draw).two_sided ? 2 : 1;
        const dmat3 linear = upper_left(draw.to_world);
        for (std::uint32_t i = begin; i < end; ++i) {
            const dvec3 area = area_of(linear, list_->scene.meshes[draw.mesh], i - part.first);
            const double size = std::sqrt(dot(area, area));
            const double light = sides * emission.luminance(i - part.first), weight = size * light;
            weights[i] = std::isfinite(weight) ? weight : 0;
            pdf_area_[i] = weights[i] > 0 ? float(std::min(light, 1e38)) : 0;
        }
    });
    triangles_ = AliasTable(weights);
    if (triangles_.empty()) {
        *this = Emitters();
        return;
    }
    double sum = 0;
    for (const double weight : weights) sum += weight;
    for (float& light : pdf_area_) light = float(double(light) / sum);  // (size * light / sum) / size
    power_ = pi * sum;
}

/// Calls work(part, begin, end) for runs of triangles of one part, on all threads.
template <class Work>
void Emitters::for_parts(Context& context, const Work& work) const {
    const std::size_t count = pdf_area_.size();
    context.parallel_for((count + triangles_per_task - 1) / triangles_per_task, [&](std::size_t task) {
        auto begin = std::uint32_t(task * triangles_per_task);
        const auto end = std::uint32_t(std::min((task + 1) * triangles_per_task, count));
        for (const Part* part = &part_of(begin); begin < end; ++part) {
            const std::uint32_t stop = std::min(part[1].first, end);
            work(*part, begin, stop);
            begin = stop;
        }
    });
}

const Emitters::Part& Emitters::part_of(std::uint32_t index) const {
    const auto behind = std::upper_bound(parts_.begin(), parts_.end(), index,
                                         [](std::uint32_t i, const Part& part) { return i < part.first; });
    return *(behind - 1);
}

EmitterSample Emitters::sample(double choice, vec2 u, dvec3 origin) const noexcept {
    EmitterSample out;
    if (empty()) return out;
    const std::uint32_t index = triangles_.sample(choice).index;
    const Part& part = part_of(index);
    const Draw& draw = list_->draws[part.draw];
    const Mesh& mesh = list_->scene.meshes[draw.mesh];
    out.draw = part.draw;
    out.triangle = index - part.first;
    out.pdf_area = pdf_area_[index];
    out.shines_back = shines_back(part.draw);
    const double root = std::sqrt(double(u.x));
    const double weight[3] = {1 - root, root * (1 - double(u.y)), root * double(u.y)};
    const std::uint32_t* const corner = mesh.indices.data() + 3 * std::size_t(out.triangle);
    const dmat3 linear = upper_left(draw.to_world);
    const dvec3 move = draw.to_world[3].xyz() - origin;
    dvec3 at{};
    for (std::size_t k = 0; k < 3; ++k) {
        const dvec3 place = cast<double>(mesh.positions[corner[k]]);
        at += place * weight[k];
        out.weight[k] = float(weight[k]);
        for (std::size_t c = 0; c < 3; ++c) out.size = std::max(out.size, float(std::fabs((linear * place + move)[c])));
    }
    out.position = cast<float>(linear * at + move);
    out.normal = cast<float>(normalize_or(area_of(linear, mesh, out.triangle) * front_sign(draw), dvec3{0, 0, 1}));
    return out;
}

}  // namespace rakelight::shading
