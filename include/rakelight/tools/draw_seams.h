// SPDX-License-Identifier: Apache-2.0
// The heat map of an inspection (<rakelight/tools/inspect.h>): a picture of the seams of a model.
#pragma once
#include <cstdint>

#include <rakelight/base/export.h>
#include <rakelight/render/picture.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

struct Inspection;
struct InspectOptions;

/// Annotations of a heat map.
enum class SeamMarks : std::uint8_t {
    none,
    /// A color bar, the angle and the objects of the largest seam, and a ring around this seam. Only in pictures of at
    /// least 240 x 180 pixels.
    legend
};

/// Draws the model in plain gray with the normals of `before`. Its seams are lines in the colors of heat_color(), with
/// a width of 0.6 % of the picture's height. Ignores lights and textures of the scene. Needs Inspection::seam_lines.
/// @throws Error usage: an invalid camera; bad_file "nothing to draw"
RL_API Frame draw_seams(const Scene& scene, const Inspection& inspection, const InspectOptions& options,
                        const ViewRequest& view, const RenderSettings& settings, Context& context,
                        SeamMarks marks = SeamMarks::none);

/// The color of a seam angle, linear RGB: dark blue for 0.01 degrees, violet for 1, red for 5, orange for 20, light
/// yellow for 60 and more. Linearly interpolated in between.
RL_API vec3 heat_color(double seam_deg);

}  // namespace rakelight
