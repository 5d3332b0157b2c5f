// SPDX-License-Identifier: Apache-2.0
// Checks a file before the import helper gets it: truncation, impossible sizes, entities. Assimp silently accepts many
// such files, or allocates gigabytes first.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include <rakelight/base/context.h>

namespace rakelight::io {

/// What the checks need. `path` is for remarks. All functions: O(size), no allocation that the content decides.
/// @throws Error bad_file, without the file's name.
struct Suspect {
    std::span<const std::byte> bytes;
    const std::string& path;
    Report& report;
};

/// The check of a format, which the source of the check defines.
struct Precheck {
    std::string_view ending;  ///< of the file's name, lower case, no dot
    void (*check)(const Suspect& s);
};
extern const Precheck precheck_3ds, ase_precheck, blend_precheck, collada_precheck, fbx_precheck, x_precheck;

/// The check of the format that `ending` (lower case, no dot) names. @throws Error bad_file for an unknown one too.
void check_before_import(const std::string& ending, const Suspect& s);

/// Size of a block-structured text: how deep braces stand open at the end, those in quotes not counted; -1 when one is closed
/// that was never opened. Works for UTF-16 too.
long long open_braces(std::span<const std::byte> text);

}  // namespace rakelight::io
