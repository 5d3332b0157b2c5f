// SPDX-License-Identifier: Apache-2.0
// What is wrong with the parameters of one thing, as a message.
#pragma once
#include <rakelight/scene/scene.h>

namespace rakelight {

/// The fault of a camera's parameters as a message, or null. Engines require more than scenes: a finite far plane for
/// orthographic projection, and both fields of view.
enum class CameraUse { in_scene, in_engine };
const char* fault_of(const Camera& camera, CameraUse use);
/// The fault of subdivision or relief parameters as a message, or null.
const char* fault_of(const Subdivision& subdivision);
const char* fault_of(const Relief& relief);

}  // namespace rakelight
