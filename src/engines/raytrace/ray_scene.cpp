// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/ray_scene.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <utility>

#include "math/linear.h"

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
    const std::vector<bool>* mirrored;
};

void filter_meeting(const RTCFilterFunctionNArguments* args) {
    const RayContext& context = *reinterpret_cast<const RayContext*>(args->context);
    if (args->valid[0] == 0) return;
    const RTCHit& hit = *reinterpret_cast<const RTCHit*>(args->hit);
    const RTCRay& ray = *reinterpret_cast<const RTCRay*>(args->ray);
    const std::uint32_t draw = hit.instID[0];
    // Both are in the mesh's own space here.
    const bool is_against = hit.Ng_x * ray.dir_x + hit.Ng_y * ray.dir_y + hit.Ng_z * ray.dir_z < 0;
    if (!context.filter->counts({draw, hit.primID, ray.tfar}, is_against != (*context.mirrored)[draw]))
        args->valid[0] = 0;
}

RayContext context_of(const RayFilter* filter, const std::vector<bool>& mirrored) {
    RayContext context{{}, filter, &mirrored};
    rtcInitIntersectContext(&context.embree);
    if (filter) context.embree.filter = filter_meeting;
    return context;
}

/// [bytes] of Embree's tree a triangle, about: measured on meshes of 1 to 10 million.
constexpr std::uint64_t tree_bytes = 100;

RTCRay ray_of(vec3 origin, vec3 direction, float from, float to) {
    return {origin.x, origin.y, origin.z, from, direction.x, direction.y, direction.z, 0, to, ~0u, 0, 0};
}

}  // namespace

/// Blocks that a part is made of: the same blocks, the same part.
struct RayScene::Key {
    const void *positions, *indices;
    auto operator<=>(const Key&) const = default;
};

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

RayScene::RayScene(Isa isa) {
    device_ = embree().NewDevice(config_of(isa).c_str());
    if (!device_) throw Error(ErrorCode::failed, "Embree cannot be used on this processor");
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
                        : "Embree cannot build the scene (error " + std::to_string(int(error)) + ")");
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

float reach_of(const Bounds& bounds) {
    const dvec3 half = (bounds.high - bounds.low) * 0.5;
    return float(std::max({half.x, half.y, half.z, 0.0}));
}

}  // namespace

void RayScene::set(const shading::DrawList& list, Context& context) {
    if (top_) embree().ReleaseScene(std::exchange(top_, nullptr));
    for (auto& [key, part] : parts_) part->is_used = false;
    origin_ = list.bounds.empty() ? dvec3{} : list.bounds.center();
    reach_ = list.bounds.empty() ? 0 : reach_of(list.bounds);
    mirrored_.assign(list.draws.size(), false);
    Building building(device_, context);
    RTCScene top = embree().NewScene(device_);
    try {
        embree().SetSceneFlags(top, scene_flags);
        for (std::uint32_t d = 0; d < list.draws.size(); ++d) {
            const shading::Draw& draw = list.draws[d];
            mirrored_[d] = draw.mirrored;
            const Part& part = part_of(list.scene.meshes[draw.mesh], building, context);
            RTCGeometry instance = embree().NewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
            embree().SetGeometryInstancedScene(instance, part.scene);
            embree().SetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                                          columns_of(translation(-origin_) * draw.to_world).data());
            embree().CommitGeometry(instance);
            embree().AttachGeometryByID(top, instance, d);
            embree().ReleaseGeometry(instance);
        }
        building.commit(top);
    } catch (...) {
        embree().ReleaseScene(top);
        throw;
    }
    top_ = top;
    std::erase_if(parts_, [](const auto& known) { return !known.second->is_used; });
}

/// Made where it is not known yet.
const RayScene::Part& RayScene::part_of(const Mesh& mesh, Building& building, Context& context) {
    std::unique_ptr<Part>& known = parts_[{mesh.positions.identity(), mesh.indices.identity()}];
    if (!known) known = make_part(mesh, building, context);
    known->is_used = true;
    return *known;
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
    RTCGeometry geometry = embree().NewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    embree().SetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, part->padded.data(), 0, 12,
                                     vertices);
    embree().SetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.indices.data(), 0, 12,
                                     triangles);
    embree().CommitGeometry(geometry);
    embree().AttachGeometry(part->scene, geometry);
    embree().ReleaseGeometry(geometry);
    building.commit(part->scene);
    return part;
}

Meeting RayScene::first(vec3 origin, vec3 direction, float from, float to, const RayFilter* filter) const {
    if (!top_) return {};
    RayContext context = context_of(filter, mirrored_);
    RTCRayHit meeting{ray_of(origin, direction, from, to), {}};
    meeting.hit.geomID = meeting.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree().Intersect1(top_, &context.embree, &meeting);
    if (meeting.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
    return {meeting.hit.instID[0], meeting.hit.primID, meeting.ray.tfar};
}

bool RayScene::is_blocked(vec3 origin, vec3 direction, float from, float to, const RayFilter* filter) const {
    if (!top_) return false;
    RayContext context = context_of(filter, mirrored_);
    RTCRay ray = ray_of(origin, direction, from, to);
    embree().Occluded1(top_, &context.embree, &ray);
    return ray.tfar < 0;
}

}  // namespace rakelight::raytrace
