// SPDX-License-Identifier: Apache-2.0
// The steps of render_picture(), for interactive programs that reuse results between pictures.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/export.h>
#include <rakelight/picture.h>
#include <rakelight/scene_queries.h>

namespace rakelight {

/// For Look::standard: chooses settings that neither the file nor the request gives: samples, light, shadows, and
/// whether the file's camera and lights are used. The report lists decisions about the file. The request is explicit in
/// these settings afterwards.
/// @param scene  as loaded
RL_API void apply_look(const Scene& scene, PictureRequest& request, Context& context);

/// The second part, which depends on the prepared scene: the background's tone, and the exposure of photometric lights.
/// @param prepared  of with_requested_surfaces()
RL_API void apply_look_exposure(const Scene& prepared, PictureRequest& request, Context& context);

/// A loaded scene with the materials and the environment of a request. Textures named in the request are new in each
/// result: call it again only if PictureRequest::materials or hdri_... changed.
/// @throws Error bad_file: see validate(); not_found, bad_file: a picture of the request
RL_API Scene with_requested_surfaces(Scene scene, const PictureRequest& request, Context& context);

/// For display values: with an exposure or a tone curve the background is composited after tone mapping, so that it
/// keeps its display color.
/// @return the background to composite: argument `behind` of save() and to_srgb8()
RL_API vec4 separate_background(RenderSettings& settings, const ToneSettings& tone);

/// The lights of a picture for a camera of choose_camera(): those of the request, the scene's or the default rig, with
/// light_intensity and light_cutoff applied.
RL_API std::vector<Light> requested_lights(const Scene& scene, const PictureRequest& request, const Camera& camera);

/// As PictureResult::channel_range.
/// @param camera  of choose_camera()
RL_API ChannelRange channel_range_of(const Bounds& bounds, const Camera& camera);

/// A channel of a frame as display values, as in PNG files of channels: [width * height of its window] sRGB codes, R in
/// the low byte.
/// @param channel  one Channel bit @throws Error usage: the frame has no such channel
RL_API std::vector<std::uint32_t> channel_codes(const Frame& frame, std::uint32_t channel, const ChannelRange& range);

/// The words of --channels, in the order of the Channel bits.
RL_API std::vector<std::string> channel_words();

}  // namespace rakelight
