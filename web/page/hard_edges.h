// SPDX-License-Identifier: Apache-2.0
// The creases of a prepared scene as lines: what the rule of creases, or an angle, decided at edges that bend.
#pragma once
#include <vector>

#include <rakelight/engines/line.h>
#include <rakelight/scene/scene.h>

namespace rakelight::web {

/// Edges of two faces of one object; at most `most`. Orange: hard, the normals differ. Blue: smooth, though the faces bend by
/// 30 degrees or more.
std::vector<Line> hard_edge_lines(const Scene& prepared, std::size_t most = 100'000);

}  // namespace rakelight::web
