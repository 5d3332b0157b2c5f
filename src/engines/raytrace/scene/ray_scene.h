// SPDX-License-Identifier: Apache-2.0
// The surfaces of a draw list as Embree meets rays with: a scene for each mesh, placed by instances in one above; what did not
// change from one scene to the next is kept. Small meshes, of which there may be many, lie together in one geometry beside the instances;
// surfaces given by their formulas in another, met by our own arithmetic (shapes.h).
#pragma once
#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <rakelight/base/context.h>

#include "engines/raytrace/scene/embree_library.h"
#include "engines/raytrace/scene/shapes.h"
#include "math/isa.h"
#include "shading/draw_list.h"

namespace rakelight::raytrace {

/// Where a ray hits a surface first.
struct Meeting {
    std::uint32_t draw = no_index;  ///< into DrawList::draws; no_index: nowhere
    std::uint32_t triangle = 0;     ///< of shapes: ShapeFaceNumber
    float t = 0;
    /// The ray goes against the normal that the order of the corners gives, in the world. Known to filters alone.
    bool is_against = false;
    float part = 0;  ///< of lines: from one end to the other
};

/// Which meetings count.
class RayFilter {
public:
    virtual ~RayFilter() = default;
    virtual bool counts(const Meeting& meeting) const = 0;
};

/// A shape at its place.
struct PlacedShape {
    ExactShape shape;
    std::uint32_t draw = 0;
    dmat4 to_object;  ///< of places about RayScene::origin()
    dmat4 to_rays;
    bool is_mirrored = false;
};

/// The nearest meeting with a shape that counts; as RayScene::first().
Meeting first_on_shape(const PlacedShape& placed, vec3 origin, vec3 direction, float from, float to,
                       const RayFilter* filter);

/// [bytes] of Embree's tree a triangle or point, about: measured on meshes of 1 to 10 million triangles.
inline constexpr std::uint64_t tree_bytes = 100;

inline RTCRay ray_of(vec3 origin, vec3 direction, float from, float to) {
    return {origin.x, origin.y, origin.z, from, direction.x, direction.y, direction.z, 0, to, ~0u, 0, 0};
}

class RayScene {
public:
    explicit RayScene(Isa isa);
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    /// @throws Error bad_file: over the memory budget; failed: cancelled. Then nothing is met
    void set(const shading::DrawList& list, Context& context);

    /// Nothing is met.
    void clear();

    /// Of the world, where Embree's coordinates are 0.
    dvec3 origin() const { return origin_; }

    RTCDevice device() const { return device_; }
    /// Builds another scene of the device. @throws Error bad_file, failed
    void commit(RTCScene scene, Context& context) const;

    /// Null: the draw is its triangles.
    const PlacedShape* shape_of(std::uint32_t draw) const;
    /// That Embree has taken for its trees.
    std::uint64_t tree_bytes_used() const { return std::uint64_t(std::max<std::int64_t>(bytes_, 0)); }

    /// @param origin     about origin()
    /// @param direction  not 0; `from` and `to` count in it
    /// @param filter     null: all count
    Meeting first(vec3 origin, vec3 direction, float from, float to, const RayFilter* filter) const;
    bool is_blocked(vec3 origin, vec3 direction, float from, float to, const RayFilter* filter) const;

private:
    /// What of a draw rays know.
    struct Placement {
        Block<vec3> positions;  ///< keep the blocks: what has their identity is them
        Block<std::uint32_t> indices;
        dmat4 to_world;
        std::optional<ExactShape> shape;
        bool operator==(const Placement& other) const;
    };
    struct Part;
    struct Key;
    struct Crowd;
    class Building;
    void add_instance(RTCScene top, const shading::DrawList& list, std::uint32_t draw, Building& building,
                      Context& context);
    void add_crowd(RTCScene top, const shading::DrawList& list, const std::vector<std::uint32_t>& draws,
                   Context& context);
    void add_shapes(RTCScene top, Context& context);
    bool place_shape(const shading::DrawList& list, std::uint32_t draw);
    static Key key_of(const Mesh& mesh);
    static void filter(const RTCFilterFunctionNArguments* args);
    static void find_bounds(const RTCBoundsFunctionArguments* args);
    static void meet_nearest(const RTCIntersectFunctionNArguments* args);
    static void meet_any(const RTCOccludedFunctionNArguments* args);
    Meeting find_on_shape(const RTCRay& ray, const RTCIntersectContext* context, std::uint32_t shape) const;
    Meeting meeting_of(const RTCHit& hit, const RTCRay& ray) const;
    const Part& part_of(const Mesh& mesh, Building& building, Context& context);
    std::unique_ptr<Part> make_part(const Mesh& mesh, Building& building, Context& context);

    RTCDevice device_ = nullptr;
    RTCScene top_ = nullptr;
    std::vector<Placement> placements_;
    std::map<Key, std::unique_ptr<Part>> parts_;
    std::vector<bool> mirrored_;  ///< [draws]
    std::unique_ptr<Crowd> crowd_;
    std::vector<PlacedShape> shapes_;
    std::vector<std::uint32_t> shape_numbers_;  ///< [draws] into shapes_, or no_index; empty: there are none
    MemoryCharge shapes_charge_;
    std::atomic<std::int64_t> bytes_{0};
    dvec3 origin_{};
};

}  // namespace rakelight::raytrace
