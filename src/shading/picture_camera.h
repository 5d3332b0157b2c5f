// SPDX-License-Identifier: Apache-2.0
// A camera made ready for one picture: everything in double, about the eye, so that a model a thousand kilometers from
// the origin looks like one at it.
#pragma once
#include <rakelight/engines/engine.h>
#include <rakelight/scene/scene_queries.h>

#include "math/linear.h"
#include "scene/placement.h"

namespace rakelight::shading {

/// A vertex before the division. Perspective: w is the distance along the view axis; orthographic: w = 1.
struct ClipVertex {
    float x = 0, y = 0;  ///< inside the picture where -w <= x, y <= w
    float w = 1;
    float distance = 0;  ///< [m] along the view axis, from the eye
};

struct PictureCamera {
    dmat4 world_to_eye;     ///< translation only: world axes about the eye
    dmat4 world_to_camera;  ///< camera axes: looks along -Z
    dmat4 camera_to_world;
    bool orthographic = false;
    double scale_x = 1, scale_y = 1;    ///< camera x, y -> clip x, y
    double z_near = 0.1, z_far = 1000;  ///< far may be infinity
    int width = 0, height = 0;          ///< [px] of the whole picture

    /// [px] of a vertex with w > 0; (0, 0) is the outer corner of the top left pixel.
    dvec2 screen(const ClipVertex& v) const {
        return {(double(v.x) / double(v.w) * 0.5 + 0.5) * width, (0.5 - double(v.y) / double(v.w) * 0.5) * height};
    }
    /// [m] distance along the view axis of a depth key; infinity where it says that nothing is there.
    double distance_of(double key) const;
    /// [m] where the ray through a place on the screen (px) meets a depth key; world axes.
    dvec3 place(double x, double y, double key) const;
};

/// Where pixels' rays lead, world axes: change per pixel in x and y, and at the center of a first pixel. Perspective: times
/// the distance along the view axis it is the position about the eye; parallel: the position where that distance is 0.
struct PixelRays {
    dvec3 along_x, along_y, first;
    /// [px] from the first pixel's center
    dvec3 at(double x, double y) const { return along_x * x + along_y * y + first; }
};
PixelRays pixel_rays(const PictureCamera& view, int first_x, int first_y);

/// @param camera, settings  that passed their checks (engines/check_settings.h)
/// @throws Error usage: the placement is singular or not finite
PictureCamera make_picture_camera(const Camera& camera, const dmat4& camera_to_world, const RenderSettings& settings);

struct DrawList;
/// What camera and settings are for, both checked. Formats of the textbook's depth keep the camera's own range, which
/// they are there to show.
PictureCamera picture_camera_of(const DrawList& list, const Camera& camera, const RenderSettings& settings);

/// Moves near and far in towards the scene where they are so far apart that float depth keys could not distinguish its
/// surfaces. In perspective that is a near below 1e-30 of the farthest distance (what lies between is lost). In
/// parallel views it is a range above 256 times the scene's diagonal (nothing is lost).
/// @param drawn  of everything that is drawn, in the world
void narrow_depths(PictureCamera& view, const Bounds& drawn);

}  // namespace rakelight::shading
