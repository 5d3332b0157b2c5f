// SPDX-License-Identifier: Apache-2.0
// Ray casting as the textbook's first program has it: every ray is held against every triangle. The measure of what a tree of boxes is
// worth, and a second opinion on what rays hit.
#pragma once
#include <atomic>
#include <vector>

#include "engines/raytrace/scene/ray_scene.h"

namespace rakelight::raytrace {

class NaiveScan {
public:
    /// @param list, rays  must outlive this; shapes are those of `rays`
    NaiveScan(const shading::DrawList& list, const RayScene& rays, Context& context);

    std::uint64_t triangles() const { return corners_.size() / 3; }
    std::uint64_t surfaces() const { return triangles() + shapes_.size(); }  ///< tests that a ray needs
    /// Of rays with triangles or shapes, so far.
    std::uint64_t tests() const { return tests_; }

    /// As RayScene::first() and is_blocked().
    Meeting first(vec3 origin, vec3 direction, float from, float to, const RayFilter* filter) const;

private:
    const RayScene& rays_;
    std::vector<vec3> corners_;                 ///< [3 * triangles] about RayScene::origin()
    std::vector<std::uint32_t> draws_, first_;  ///< whose triangles begin at first_[i]
    std::vector<std::uint32_t> shapes_;         ///< draws
    MemoryCharge charge_;
    mutable std::atomic<std::uint64_t> tests_{0};
};

}  // namespace rakelight::raytrace
