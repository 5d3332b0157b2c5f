// SPDX-License-Identifier: Apache-2.0
// decide() of shot.h for single pictures.
#pragma once
#include <functional>

#include <rakelight/render/shot.h>

namespace rakelight {

/// A step between loading and preparing, for the scene as it was requested. Empty: none.
using ChangeScene = std::function<Scene(Scene)>;

/// decide() for a single picture, at the moment of the request: see Session::set_single().
Shot decide_single(Session& session, Scene loaded, PictureRequest& request, const ChangeScene& change,
                   const ShotOptions& options, Context& context);

/// The same for a scene at its moment and a request that apply_look() has completed.
/// @param asked    what the scene is changed by: the request before choices that belong to the picture alone
Shot decide_moment(Session& session, Scene moment, PictureRequest asked, PictureRequest& request,
                   const ShotOptions& options, Context& context);

/// The last part of decide(), for a scene that the session shows: look and coloring of the request are complete.
Shot decide_shown(Session& session, const Scene& shown, PictureRequest& request, const CameraOf& camera,
                  const ShotOptions& options, Context& context);

}  // namespace rakelight
