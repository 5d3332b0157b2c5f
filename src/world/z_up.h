// SPDX-License-Identifier: Apache-2.0
// Models with Z up, beside formats and scenes with Y up (docs/z-up-scans.md).
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/report.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// The axis that is up in a file.
/// - `y`: the format says so, or its reader turns the model. Also OBJ: most programs with Z up turn what they write.
/// - `z`: STL.
/// - `open`: PLY, OFF and lists of points. They have the coordinates of the program that wrote them, and are shown with
///   Y up.
enum class UpAxis : std::uint8_t { y, z, open };

/// By the ending of the name.
UpAxis up_axis(const std::string& path);

/// Whether Z is up in what load() makes of files: in all of them.
/// @param joined  LoadOptions::joined
bool is_z_up(const std::string& path, std::span<const std::string> joined = {});

/// A file with Z up among files that are not all such: load() turns none of them, so that it lies on its side.
/// @return the first one, if there is one
std::optional<std::string> lying_file(const std::string& path, std::span<const std::string> joined);

/// Warns that an STL file lies on its side, and says how it is turned.
/// @param file, place  where it is named
/// @param why  such as beside_y_up
/// @param settings  those that `why` quotes
void warn_of_lying(const std::string& file, const std::string& place, const std::string& why, Report& report,
                   std::vector<std::string> settings = {});
constexpr const char* beside_y_up = "beside models with Y up";

/// Turns a scene with Z up: X stays, Z becomes Y. Meshes keep their numbers; their nodes, lights and cameras turn. Every number is exact.
Scene with_y_up(Scene scene);

/// The same, and a remark about `file` says so.
Scene with_y_up(Scene scene, const std::string& file, Report& report);

/// Warns that a PLY file keeps the coordinates of a model with Z up. @param file  that is written
void warn_of_z_up(const std::string& file, Report& report);

/// One up axis for two scenes that are laid beside each other. If Z is up in one of them, it counts as up in the other
/// one too if the format of that one leaves the axis open. Beside a scene with Y up, the one with Z up is turned.
/// @param a,b  as loaded
/// @return the axis that is up in both; absent: their axes were the same
std::optional<UpAxis> share_up_axis(Scene& a, Scene& b, Report& report);

}  // namespace rakelight
