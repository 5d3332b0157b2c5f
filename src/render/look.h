// SPDX-License-Identifier: Apache-2.0
// The default look: values for settings that are not given. docs/default-look.md has the numbers.
#pragma once
#include <initializer_list>
#include <string_view>

#include <rakelight/render/session.h>

namespace rakelight {

/// Whether the setting is given: then the look leaves its topic alone. Of several: one of them.
bool names(const PictureRequest& request, std::string_view key);
bool names(const PictureRequest& request, std::initializer_list<std::string_view> keys);

/// The rest of the look, which needs a small picture first: the size of points, the background's tone, and the exposure if
/// the file's lights are in physical units.
/// @param session  shows the scene of the shot
void adjust_to_picture(PictureRequest& request, Session& session, const Shot& shot, Context& context);

/// Of the surface (by triangles' areas; of the vertices where there are none), how much lies inside a camera's picture: 0..1.
double seen_share(const Scene& scene, const Camera& camera, double aspect);

}  // namespace rakelight
