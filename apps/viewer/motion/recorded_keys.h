// SPDX-License-Identifier: Apache-2.0
// Keys of the camera and of lights that the user records: where they are at a moment. Between them they move as channels of a
// scene's animation do.
#pragma once
#include <vector>

#include "../document/document.h"

namespace rakelight::viewer {

/// Keys nearer than this are one.
inline constexpr double same_moment_s = 1e-3;

/// Stores where the eye is now, and each light of the list that was moved from where the file has it, at a moment; a key that is
/// there already is replaced.
void set_key(Look& look, const Model& model, int width, int height, double time_s);
/// @return false: there was none
bool delete_key(Look& look, double time_s);
/// The times of the keys of the camera and of lights, ascending.
std::vector<double> key_times(const Look& look);

/// A camera in the world's origin whose up is the world's: recorded eyes keep the horizon level.
Camera level_camera(dvec3 world_up);

/// The keys as channels: those of the camera move element 0, those of lights the light of that number.
Animation animation_of_keys(const Look& look);
/// Puts eye and lights where they are at a moment.
void follow_keys(Look& look, double time_s);

}  // namespace rakelight::viewer
