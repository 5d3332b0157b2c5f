// SPDX-License-Identifier: Apache-2.0
// The part of a file's name that says its format.
#pragma once
#include <string>
#include <string_view>

#include <rakelight/base/export.h>

namespace rakelight {

/// The characters after the last dot of the file's name, ASCII letters in lower case: "gltf" for "a.b/C.GLTF". Empty without
/// such a dot, and for a name that only begins with one (".png"). Whatever decides by a name's ending asks this function.
RL_API std::string file_ending(std::string_view path);

}  // namespace rakelight
