// SPDX-License-Identifier: Apache-2.0
// Which pictures `compare` holds against which.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "../run.h"

namespace rakelight::cli {

/// One of two pictures: a file, or a scene that is drawn.
struct ComparedSide {
    std::string name;
    std::optional<InputRequest> scene;
    std::string engine() const { return scene ? scene->picture.engine : std::string(); }
};

struct ComparedPair {
    ComparedSide a, b;
    std::string output;          ///< of the difference picture; empty: none
    std::optional<Error> error;  ///< there is nothing to compare
};

/// The pairs of the command line: two files or scenes, or pictures of equal names in two folders, in the order of their
/// names. With --engines, each scene drawn by the first engine of them and by each other one.
/// @throws Error usage, not_found
std::vector<ComparedPair> compared_pairs(const Run& run);

}  // namespace rakelight::cli
