// SPDX-License-Identifier: Apache-2.0
// The parts of render_picture() for programs that show pictures as they change: what is the same for many pictures is made once.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/export.h>
#include <rakelight/picture.h>
#include <rakelight/scene_queries.h>
#include <rakelight/session.h>

namespace rakelight {

/// All that render_picture() does to a loaded scene before it is prepared: clips at their moments, take_look(), colors by numbers of
/// vertices, with_asked_surfaces(), and points as the look has them. The request is plain in what was taken.
/// @throws Error bad_file: see validate(); usage: no such clip or array; not_found: a picture of the request
RL_API Scene with_asked_look(Scene scene, PictureRequest& request, Context& context);

/// take_look_of_picture() by a session that has the scene already, so that nothing is prepared twice.
/// @param camera  of choose_camera()
RL_API void take_look_of_picture(Session& session, const Camera& camera, PictureRequest& request, Context& context);

/// Fills in, where the request's look is the default one, what neither the file nor the request names: samples, light, shadows, and
/// whether the file's camera and lights are taken. Says what it decided about the file's. The request is plain in these then.
/// @param scene  as loaded
RL_API void take_look(const Scene& scene, PictureRequest& request, Context& context);

/// The rest of it, that the model's picture decides: the background's tone, and the exposure of lights in physical units.
/// @param asked  of with_asked_surfaces()
RL_API void take_look_of_picture(const Scene& asked, PictureRequest& request, Context& context);

/// A loaded scene with the materials and the environment that a request asks for. Textures that the request names are new
/// in each result: call it again only where PictureRequest::materials or hdri_... changed.
/// @throws Error bad_file: see validate(); not_found, bad_file: a picture of the request
RL_API Scene with_asked_surfaces(Scene scene, const PictureRequest& request, Context& context);

/// For pictures that are shown or written as codes: where there is an exposure or a tone curve, the background is laid behind the picture
/// after them, so that it stays the color that was named. @return what is to be laid behind the picture of these settings: save(),
/// to_srgb8()
RL_API vec4 keep_background(RenderSettings& settings, const ToneSettings& tone);

/// The lights of a picture seen by a camera of choose_camera(): those that were asked for, the scene's or the default rig,
/// with light_intensity and light_cutoff.
RL_API std::vector<Light> asked_lights(const Scene& scene, const PictureRequest& request, const Camera& camera);

/// As PictureResult::view_range. @param camera  of choose_camera()
RL_API ViewRange view_range_of(const Bounds& bounds, const Camera& camera);

/// A channel of a frame for the eye, as PNG files of channels are: [width * height of its window] sRGB codes, R in the low byte.
/// @param channel  one Channel bit @throws Error usage: the frame has no such channel
RL_API std::vector<std::uint32_t> channel_codes(const Frame& frame, std::uint32_t channel, const ViewRange& range);

/// The words of --channels, in the order of the Channel bits.
RL_API std::vector<std::string> channel_words();

}  // namespace rakelight
