// SPDX-License-Identifier: Apache-2.0
// Height fields with known ray intersections. Included by the flavours of the test kernel (C headers only).
#pragma once

namespace rakelight::lighting_test {

/// Heights in 0..1 over u, v.
enum ReliefField : int {
    field_constant,  ///< 0.4
    field_ramp,      ///< 0.2 + 0.6 u
    field_step,      ///< 0.2, from u = 0.5 on 0.8
    field_cap,       ///< 0.25, and about the middle a sphere's cap (stretched three times) up to 0.85: rim at r = 0.4
};

enum ReliefMarch : int { march_plain, march_limited, march_steep, march_occlusion };

struct ReliefCase {
    int field, march;
    float depth, level;
    int min_steps, max_steps, refinements;
};

}  // namespace rakelight::lighting_test
