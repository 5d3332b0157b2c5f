// SPDX-License-Identifier: Apache-2.0
// The terms of explained pixels as products: name and value of each factor.
#pragma once
#include <array>
#include <optional>

#include "engines/raster/inspect/traced_pixel.h"
#include "tools/explain/explain_values.h"
#include "tools/report_json.h"

namespace rakelight {

using Rgb = std::array<float, 3>;

inline bool is_black(const float (&v)[3]) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

/// The product of the factors, rounded like the engine's floats.
Rgb product_of(const raster::TracedPart& part);

/// The light's term, where this part alone comes to it.
std::optional<Rgb> term_of(const raster::TracedParts& parts, int part, const raster::TracedLight& light);

/// A row for each factor, and one for their product; for a term of one part that row is `term`. If no light arrives
/// for a part, only that row.
void add_factors(Values& values, const raster::TracedPart& part, const std::optional<Rgb>& term);

/// [{"term": "diffuse", "layer": "base", "factors": [{"factor": "k_diffuse", "value": [...]}, ...], "value": [...]},
/// ...]
Json parts_json(const raster::TracedParts& parts);

}  // namespace rakelight
