// SPDX-License-Identifier: Apache-2.0
// What the user's commands do to a look.
#pragma once
#include <string>

#include "document.h"
#include "keys.h"

namespace rakelight::viewer {

/// Another way of following rays. Paths have a number of samples of their own.
void choose_method(RayMethod method, Look& look);

/// Another engine, by its plain method. Rays have shadows by nature, as where `engine` is said; another engine then has those of before.
void choose_engine(const std::string& name, Look& look);

/// Applies a command to a look; false: it is not about looks. @throws Error usage
bool apply(Command command, Look& look, const Model& model, int width, int height);

/// A light of the list follows the camera from now on, or stays where it is. @return what was done, for people
std::string toggle_follows_camera(Look& look, const Model& model, int width, int height, std::size_t light);

}  // namespace rakelight::viewer
