// SPDX-License-Identifier: Apache-2.0
// How much of a patch's light comes to a point.
#pragma once
#include "engines/raytrace/surface_rays.h"
#include "radiosity/patches.h"

namespace rakelight::radiosity {

/// Where light is received.
struct Receiver {
    dvec3 at, normal;   ///< unit
    dvec3 face_normal;  ///< rays begin on its side
};
inline Receiver receiver_of(const Element& e) { return {e.center, e.normal, e.face_normal}; }

class FormFactors {
public:
    /// @param elements  that the patches are made of
    /// @param gap       [m] by which rays begin and end over surfaces
    FormFactors(const Elements& elements, const Patches& patches, const raytrace::SurfaceRays& rays, double gap)
        : elements_(elements), patches_(patches), rays_(rays), gap_(gap) {}

    /// Share of the hemisphere over the receiver, by the cosine law, that the patch's front takes: in closed form near it, as
    /// of a small area far away; times the share of rays to it that nothing blocks.
    /// @param weight  how much the patch's light counts: the product with the form factor decides how many rays
    ///                there are, 1 to 16
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
