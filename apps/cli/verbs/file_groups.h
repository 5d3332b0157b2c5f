// SPDX-License-Identifier: Apache-2.0
// Which inputs are pieces of one model.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <rakelight/tools/smooth_file.h>

#include "../run.h"

namespace rakelight::cli {

/// Inputs that are taken as one model.
struct FileGroup {
    std::vector<std::size_t> members;  ///< ascending, at least one
    std::string title;                 ///< "head.glb + body.glb"
};

std::vector<FileGroup> each_alone(std::span<const std::string> files);
std::vector<FileGroup> all_as_one(std::span<const std::string> files);
/// Those whose open borders fit together (files_cut_apart()). A message names those of which it is not clear which belong
/// together. Where the files cannot be compared, a message says so and each is a group of its own.
/// @throws Error failed: cancelled
std::vector<FileGroup> groups_by_borders(const Run& run, std::span<const std::string> files,
                                         const SmoothFileOptions& options);

}  // namespace rakelight::cli
