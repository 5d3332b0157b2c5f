// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/scene/ray_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include "base/format_text.h"
#include "math/linear.h"
#include "shading/lights/emitters.h"

namespace rakelight::raytrace {
namespace {

const RTCSceneFlags scene_flags = RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;

/// Scalar kernels go with SSE2, the least that Embree has: its own choice of triangles is not ours to the bit anyway.
std::string config_of(Isa isa) {
    const char* const word = isa == Isa::avx512 ? "avx512" : isa == Isa::avx2 ? "avx2" : "sse2";
    return std::string("isa=") + word + ",set_affinity=0,verbose=0";
}

/// What a ray carries through Embree.
struct RayContext {
    RTCIntersectContext embree;  // first: Embree hands a pointer to it
    const RayFilter* filter;
    const RayScene* scene;
};

/// Meshes with at most this many triangles, over all their placements, go into the shared scene: an Embree scene for
/// each would cost more.
constexpr std::uint64_t most_in_crowd = 4096;
/// Meshes with a single placement go into it too, up to this total: rays through one tree are up to a third faster
/// than through instances, and it is built in less than a second.
constexpr std::uint64_t most_single_in_crowd = 1'000'000;

}  // namespace

/// Blocks that a part is made of: the same blocks, the same part.
struct RayScene::Key {
    const void *positions, *indices;
    auto operator<=>(const Key&) const = default;
};

namespace {

/// What shines is its triangles, from which paths choose places.
std::optional<ExactShape> formula_of(const shading::DrawList& list, const shading::Draw& draw) {
    return shading::emits(list.material(draw)) ? std::nullopt : list.scene.meshes[draw.mesh].shape;
}

}  // namespace

bool RayScene::Placement::operator==(const Placement& other) const {
    return positions.identity() == other.positions.identity() && indices.identity() == other.indices.identity() &&
           to_world == other.to_world && shape == other.shape;
}

/// The surface of a mesh.
struct RayScene::Part {
    Block<vec3> positions;  ///< keep the blocks
    Block<std::uint32_t> indices;
    std::vector<float> padded;  ///< the positions, with room behind them: Embree reads four numbers at once
    RTCScene scene = nullptr;
    MemoryCharge charge;
    bool is_used = true;
    ~Part() {
        if (scene) embree().ReleaseScene(scene);
    }
};

/// Small meshes at their places, one after the other.
struct RayScene::Crowd {
    std::vector<float> positions;  ///< about the origin, with room behind them
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> draws, first;  ///< whose triangles begin at first[i]
    MemoryCharge charge;

    Meeting meeting(std::uint32_t triangle, float t, bool is_against) const {
        const auto next = std::ranges::upper_bound(first, triangle);
        const auto i = std::size_t(next - first.begin()) - 1;
        return {draws[i], triangle - first[i], t, is_against};
    }
    void add(std::uint32_t draw, const Mesh& mesh, const dmat4& to_rays) {
        const auto vertices = std::uint32_t(positions.size() / 3);
        draws.push_back(draw), first.push_back(std::uint32_t(indices.size() / 3));
        for (const vec3& p : mesh.positions) {
            const dvec3 at = transform_point(to_rays, cast<double>(p));
            for (std::size_t c = 0; c < 3; ++c) positions.push_back(float(at[c]));
        }
        for (const std::uint32_t i : mesh.indices) indices.push_back(vertices + i);
    }
};

Meeting RayScene::meeting_of(const RTCHit& hit, const RTCRay& ray) const {
    // Of instances both are in the mesh's own space while they are filtered, of the crowd in the world.
    const bool is_against = hit.Ng_x * ray.dir_x + hit.Ng_y * ray.dir_y + hit.Ng_z * ray.dir_z < 0;
    if (hit.instID[0] != RTC_INVALID_GEOMETRY_ID)
        return {hit.instID[0], hit.primID, ray.tfar, is_against != mirrored_[hit.instID[0]]};
    if (hit.geomID == mirrored_.size()) return crowd_->meeting(hit.primID, ray.tfar, is_against);
    return {shapes_[hit.primID].draw, std::uint32_t(hit.u), ray.tfar, is_against};
}

void RayScene::filter(const RTCFilterFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const RayContext& context = *reinterpret_cast<const RayContext*>(args->context);
    const RTCHit& hit = *reinterpret_cast<const RTCHit*>(args->hit);
    const RTCRay& ray = *reinterpret_cast<const RTCRay*>(args->ray);
    if (!context.filter->counts(context.scene->meeting_of(hit, ray))) args->valid[0] = 0;
}

RayScene::RayScene(Isa isa) {
    device_ = embree().NewDevice(config_of(isa).c_str());
    if (!device_) throw Error(ErrorCode::failed, "Embree cannot be used on this processor");
    const auto count = [](void* bytes, ssize_t change, bool) {
        static_cast<std::atomic<std::int64_t>*>(bytes)->fetch_add(std::int64_t(change));
        return true;
    };
    embree().SetDeviceMemoryMonitorFunction(device_, count, &bytes_);
}

RayScene::~RayScene() {
    if (top_) embree().ReleaseScene(top_);
    parts_.clear();
    embree().ReleaseDevice(device_);
}

/// What Embree tells while it builds.
class RayScene::Building {
public:
    Building(RTCDevice device, Context& context) : device_(device), context_(context) {}

    void commit(RTCScene scene) {
        embree().SetSceneProgressMonitorFunction(scene, go_on, &context_);
        embree().CommitScene(scene);
        embree().SetSceneProgressMonitorFunction(scene, nullptr, nullptr);
        check();
    }
    void check() const {
        context_.throw_if_cancelled();
        const RTCError error = embree().GetDeviceError(device_);
        if (error == RTC_ERROR_NONE) return;
        throw Error(error == RTC_ERROR_OUT_OF_MEMORY ? ErrorCode::bad_file : ErrorCode::failed,
                    error == RTC_ERROR_OUT_OF_MEMORY
                        ? "there is not enough memory to trace rays through the scene"
                        : format_text("Embree cannot build the scene (error {})", int(error)));
    }

private:
    static bool go_on(void* context, double) { return !static_cast<Context*>(context)->cancelled(); }
    RTCDevice device_;
    Context& context_;
};

namespace {

/// Rows of three, columns after each other: what RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR is.
std::array<float, 12> columns_of(const dmat4& m) {
    std::array<float, 12> out{};
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t r = 0; r < 3; ++r) out[3 * c + r] = float(m[c][r]);
    return out;
}

/// Numbers and indices stay where they are.
RTCGeometry triangles_of(RTCDevice device, const float* positions, std::uint64_t vertices, const std::uint32_t* indices,
                         std::uint64_t triangles) {
    RTCGeometry geometry = embree().NewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    embree().SetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions, 0, 12,
                                     vertices);
    embree().SetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, indices, 0, 12, triangles);
    embree().CommitGeometry(geometry);
    return geometry;
}

}  // namespace

void RayScene::commit(RTCScene scene, Context& context) const { Building(device_, context).commit(scene); }

void RayScene::clear() {
    if (top_) embree().ReleaseScene(std::exchange(top_, nullptr));
    crowd_.reset();
    placements_.clear();
    shapes_.clear(), shape_numbers_.clear(), shapes_charge_ = {};
}

void RayScene::set(const shading::DrawList& list, Context& context) {
    std::vector<Placement> placements;
    placements.reserve(list.draws.size());
    for (const shading::Draw& draw : list.draws) {
        const Mesh& mesh = list.scene.meshes[draw.mesh];
        placements.push_back({mesh.positions, mesh.indices, draw.to_world, formula_of(list, draw)});
    }
    if (top_ && placements_ == placements) return;
    clear();
    for (auto& [key, part] : parts_) part->is_used = false;
    origin_ = list.bounds.empty() ? dvec3{} : list.bounds.center();
    mirrored_.assign(list.draws.size(), false);
    std::map<Key, std::uint64_t> triangles;  // in all places
    const auto mesh_of = [&](const shading::Draw& draw) -> const Mesh& { return list.scene.meshes[draw.mesh]; };
    std::map<Key, std::uint64_t> places;
    for (const shading::Draw& draw : list.draws) {
        triangles[key_of(mesh_of(draw))] += mesh_of(draw).triangle_count();
        ++places[key_of(mesh_of(draw))];
    }
    std::uint64_t single = 0;
    for (const auto& [key, count] : triangles)
        if (places[key] == 1) single += count;
    const auto is_small = [&](const Key& key) {
        return triangles[key] <= most_in_crowd || (places[key] == 1 && single <= most_single_in_crowd);
    };
    Building building(device_, context);
    RTCScene top = embree().NewScene(device_);
    try {
        embree().SetSceneFlags(top, scene_flags);
        std::vector<std::uint32_t> small;
        for (std::uint32_t d = 0; d < list.draws.size(); ++d) {
            mirrored_[d] = list.draws[d].mirrored;
            if (place_shape(list, d)) continue;
            if (is_small(key_of(mesh_of(list.draws[d]))))
                small.push_back(d);
            else
                add_instance(top, list, d, building, context);
        }
        if (!small.empty()) add_crowd(top, list, small, context);
        if (!shapes_.empty()) add_shapes(top, context);
        building.commit(top);
    } catch (...) {
        embree().ReleaseScene(top);
        throw;
    }
    top_ = top;
    placements_ = std::move(placements);
    std::erase_if(parts_, [](const auto& known) { return !known.second->is_used; });
}

RayScene::Key RayScene::key_of(const Mesh& mesh) { return {mesh.positions.identity(), mesh.indices.identity()}; }

void RayScene::add_instance(RTCScene top, const shading::DrawList& list, std::uint32_t number, Building& building,
                            Context& context) {
    const shading::Draw& draw = list.draws[number];
    const Part& part = part_of(list.scene.meshes[draw.mesh], building, context);
    RTCGeometry instance = embree().NewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
    embree().SetGeometryInstancedScene(instance, part.scene);
    embree().SetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                                  columns_of(translation(-origin_) * draw.to_world).data());
    embree().CommitGeometry(instance);
    embree().AttachGeometryByID(top, instance, number);
    embree().ReleaseGeometry(instance);
}

void RayScene::add_crowd(RTCScene top, const shading::DrawList& list, const std::vector<std::uint32_t>& draws,
                         Context& context) {
    auto crowd = std::make_unique<Crowd>();
    std::uint64_t vertices = 0, triangles = 0;
    for (const std::uint32_t d : draws) {
        const Mesh& mesh = list.scene.meshes[list.draws[d].mesh];
        vertices += mesh.positions.size(), triangles += mesh.triangle_count();
    }
    if (vertices > 0xffffffffu || triangles > 0xffffffffu)
        throw Error(ErrorCode::bad_file, "more small surfaces than rays can distinguish").with_file(list.scene.source);
    crowd->charge =
        MemoryCharge(context.memory(), 12 * (vertices + 1) + (12 + tree_bytes) * triangles + 8 * draws.size(), "rays");
    crowd->positions.reserve(3 * vertices + 1), crowd->indices.reserve(3 * triangles);
    for (const std::uint32_t d : draws)
        crowd->add(d, list.scene.meshes[list.draws[d].mesh], translation(-origin_) * list.draws[d].to_world);
    crowd->positions.push_back(0);
    RTCGeometry geometry = triangles_of(device_, crowd->positions.data(), vertices, crowd->indices.data(), triangles);
    embree().AttachGeometryByID(top, geometry, std::uint32_t(list.draws.size()));
    embree().ReleaseGeometry(geometry);
    crowd_ = std::move(crowd);
}

bool RayScene::place_shape(const shading::DrawList& list, std::uint32_t draw) {
    const shading::Draw& at = list.draws[draw];
    const std::optional<ExactShape> shape = formula_of(list, at);
    if (!shape) return false;
    PlacedShape placed{*shape, draw, {}, translation(-origin_) * at.to_world, at.mirrored};
    if (!inverse_affine(placed.to_rays, placed.to_object)) return false;
    shape_numbers_.resize(list.draws.size(), no_index);
    shape_numbers_[draw] = std::uint32_t(shapes_.size());
    shapes_.push_back(placed);
    return true;
}

const PlacedShape* RayScene::shape_of(std::uint32_t draw) const {
    if (shape_numbers_.empty() || shape_numbers_[draw] == no_index) return nullptr;
    return &shapes_[shape_numbers_[draw]];
}

void RayScene::add_shapes(RTCScene top, Context& context) {
    shapes_charge_ = MemoryCharge(context.memory(), (sizeof(PlacedShape) + tree_bytes) * shapes_.size(), "rays");
    RTCGeometry geometry = embree().NewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    embree().SetGeometryUserPrimitiveCount(geometry, unsigned(shapes_.size()));
    embree().SetGeometryUserData(geometry, this);
    embree().SetGeometryBoundsFunction(geometry, find_bounds, nullptr);
    embree().SetGeometryIntersectFunction(geometry, meet_nearest);
    embree().SetGeometryOccludedFunction(geometry, meet_any);
    embree().CommitGeometry(geometry);
    embree().AttachGeometryByID(top, geometry, std::uint32_t(mirrored_.size() + 1));
    embree().ReleaseGeometry(geometry);
}

void RayScene::find_bounds(const RTCBoundsFunctionArguments* args) {
    const PlacedShape& placed = static_cast<const RayScene*>(args->geometryUserPtr)->shapes_[args->primID];
    const Bounds own = bounds_of(placed.shape);
    dvec3 low{1e300, 1e300, 1e300}, high = -low;
    for (int i = 0; i < 8; ++i) {
        const dvec3 corner = transform_point(placed.to_rays, own.corner(i));
        low = min(low, corner), high = max(high, corner);
    }
    // Floats on the outer side, and planes get some thickness.
    const double slack = 1e-6 * (length(high - low) + length(high) + length(low));
    RTCBounds& out = *args->bounds_o;
    out.lower_x = float(low.x - slack), out.lower_y = float(low.y - slack), out.lower_z = float(low.z - slack);
    out.upper_x = float(high.x + slack), out.upper_y = float(high.y + slack), out.upper_z = float(high.z + slack);
}

Meeting first_on_shape(const PlacedShape& placed, vec3 from_place, vec3 along, float from, float to,
                       const RayFilter* wanted) {
    const dvec3 origin = transform_point(placed.to_object, cast<double>(from_place));
    const dvec3 direction = transform_direction(placed.to_object, cast<double>(along));
    const ShapeHits hits = meet(placed.shape, origin, direction);
    for (int i = 0; i < hits.count; ++i) {
        const ShapeHit& hit = hits.at[std::size_t(i)];
        const auto t = float(hit.t);
        if (!(t > from && t < to)) continue;
        const dvec3 normal = outward(placed.shape, hit.face, origin + direction * hit.t);
        const Meeting meeting{placed.draw, hit.face, t, (dot(normal, direction) < 0) != placed.is_mirrored};
        if (!wanted || wanted->counts(meeting)) return meeting;
    }
    return {};
}

Meeting RayScene::find_on_shape(const RTCRay& ray, const RTCIntersectContext* context, std::uint32_t number) const {
    const PlacedShape& placed = shapes_[number];
    return first_on_shape(placed, {ray.org_x, ray.org_y, ray.org_z}, {ray.dir_x, ray.dir_y, ray.dir_z}, ray.tnear,
                          ray.tfar, reinterpret_cast<const RayContext*>(context)->filter);
}

void RayScene::meet_nearest(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    auto& both = *reinterpret_cast<RTCRayHit*>(args->rayhit);
    const auto& scene = *static_cast<const RayScene*>(args->geometryUserPtr);
    const Meeting meeting = scene.find_on_shape(both.ray, args->context, args->primID);
    if (meeting.draw == no_index) return;
    both.ray.tfar = meeting.t;
    both.hit.u = float(meeting.triangle), both.hit.v = 0;
    // Ng only tells which side is hit.
    const float sign = meeting.is_against ? -1.0f : 1.0f;
    both.hit.Ng_x = sign * both.ray.dir_x, both.hit.Ng_y = sign * both.ray.dir_y, both.hit.Ng_z = sign * both.ray.dir_z;
    both.hit.geomID = args->geomID, both.hit.primID = args->primID;
    both.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
}

void RayScene::meet_any(const RTCOccludedFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    auto& ray = *reinterpret_cast<RTCRay*>(args->ray);
    const auto& scene = *static_cast<const RayScene*>(args->geometryUserPtr);
    if (scene.find_on_shape(ray, args->context, args->primID).draw != no_index)
        ray.tfar = -std::numeric_limits<float>::infinity();
}

/// Made where it is not known yet.
const RayScene::Part& RayScene::part_of(const Mesh& mesh, Building& building, Context& context) {
    auto known = parts_.find(key_of(mesh));
    if (known == parts_.end()) known = parts_.emplace(key_of(mesh), make_part(mesh, building, context)).first;
    known->second->is_used = true;
    return *known->second;
}

std::unique_ptr<RayScene::Part> RayScene::make_part(const Mesh& mesh, Building& building, Context& context) {
    auto part = std::make_unique<Part>();
    const std::size_t vertices = mesh.positions.size(), triangles = mesh.indices.size() / 3;
    part->charge = MemoryCharge(context.memory(), 12 * (vertices + 1) + tree_bytes * triangles, "rays");
    part->positions = mesh.positions, part->indices = mesh.indices;
    part->padded.resize(3 * vertices + 1);
    std::memcpy(part->padded.data(), mesh.positions.data(), 12 * vertices);
    part->scene = embree().NewScene(device_);
    embree().SetSceneFlags(part->scene, scene_flags);
    RTCGeometry geometry = triangles_of(device_, part->padded.data(), vertices, mesh.indices.data(), triangles);
    embree().AttachGeometry(part->scene, geometry);
    embree().ReleaseGeometry(geometry);
    building.commit(part->scene);
    return part;
}

namespace {

/// What Embree takes, whose assertions would end the program. Numbers beyond that come of places that no picture shows.
bool can_be_cast(vec3 origin, vec3 direction, float from) {
    constexpr float most = 1e18f;
    for (std::size_t c = 0; c < 3; ++c)
        if (!(std::fabs(origin[c]) < most) || !(std::fabs(direction[c]) < most)) return false;
    return from >= 0;
}

}  // namespace

Meeting RayScene::first(vec3 origin, vec3 direction, float from, float to, const RayFilter* wanted) const {
    if (!top_ || !can_be_cast(origin, direction, from)) return {};
    RayContext context{{}, wanted, this};
    rtcInitIntersectContext(&context.embree);
    if (wanted) context.embree.filter = filter;
    RTCRayHit meeting{ray_of(origin, direction, from, to), {}};
    meeting.hit.geomID = meeting.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree().Intersect1(top_, &context.embree, &meeting);
    if (meeting.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return meeting_of(meeting.hit, meeting.ray);
}

bool RayScene::is_blocked(vec3 origin, vec3 direction, float from, float to, const RayFilter* wanted) const {
    if (!top_ || !can_be_cast(origin, direction, from)) return false;
    RayContext context{{}, wanted, this};
    rtcInitIntersectContext(&context.embree);
    if (wanted) context.embree.filter = filter;
    RTCRay ray = ray_of(origin, direction, from, to);
    embree().Occluded1(top_, &context.embree, &ray);
    return ray.tfar < 0;
}

}  // namespace rakelight::raytrace
