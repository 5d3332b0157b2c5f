// SPDX-License-Identifier: Apache-2.0
// The creases of a prepared scene as lines: what the rule of creases, or an angle, decided.
#pragma once
#include <vector>

#include <rakelight/engines/line.h>
#include <rakelight/scene/scene.h>

namespace rakelight::web {

/// Edges of two faces of one object whose normals differ; at most `most`.
std::vector<Line> hard_edge_lines(const Scene& prepared, std::size_t most = 100'000);

}  // namespace rakelight::web
