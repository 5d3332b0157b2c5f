// SPDX-License-Identifier: Apache-2.0
// Visible form factor from a point to a patch.
#pragma once
#include "engines/raytrace/surface_rays.h"
#include "radiosity/patches.h"

namespace rakelight::radiosity {

/// The receiving point.
struct Receiver {
    dvec3 at, normal;   ///< unit
    dvec3 face_normal;  ///< side on which rays start
};
inline Receiver receiver_of(const Element& e) { return {e.center, e.normal, e.face_normal}; }

class FormFactors {
public:
    /// @param elements elements of the patches
    /// @param gap [m] offset of ray ends from surfaces
    FormFactors(const Elements& elements, const Patches& patches, const raytrace::SurfaceRays& rays, double gap)
        : elements_(elements), patches_(patches), rays_(rays), gap_(gap) {}

    /// Form factor to the patch's front side (closed form nearby, small-area approximation far away) times the
    /// unblocked share of shadow rays.
    /// @param weight importance of the patch's light: its product with the form factor selects 1 to 16 rays
    double operator()(const Receiver& receiver, std::uint32_t patch, double weight) const;

private:
    double unblocked(const Receiver& receiver, const Patch& patch) const;
    double visible_share(const Receiver& receiver, const Patch& patch, int per_side) const;
    bool is_blocked(const Receiver& receiver, const Element& e, dvec3 to) const;

    const Elements& elements_;
    const Patches& patches_;
    const raytrace::SurfaceRays& rays_;
    double gap_;
};

}  // namespace rakelight::radiosity
