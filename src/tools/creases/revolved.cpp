// SPDX-License-Identifier: Apache-2.0
// Cones, shafts, vessels and domes: profiles turned around an axis.
#include "math/functions.h"
#include "tools/creases/model_families.h"

namespace rakelight {
namespace {

Solid revolved(const Path& profile, int sides) {
    Solid s;
    s.add_revolved(profile, sides);
    return s;
}

Solid cone(int sides, double height) { return revolved(Path(0, 0).to(1, 0, 'a').to(0, height, 'b'), sides); }

/// A chamfer below, steps, and a chamfer of another angle above.
Solid stepped_shaft(int sides) {
    return revolved(Path(0, 0)
                        .to(0.9, 0, 'a')
                        .to(1, 0.1, 'b')
                        .to(1, 1, 'c')
                        .to(0.6, 1, 'd')
                        .to(0.6, 2, 'e')
                        .to(0.5, 2.2, 'f')
                        .to(0, 2.2, 'g'),
                    sides);
}

/// @param deg  between the chamfer and the wall
Solid chamfered_shaft(int sides, double deg, double width) {
    const double in = width * math::sin(radians(deg)), down = width * math::cos(radians(deg));
    return revolved(Path(0, 0).to(1, 0, 'a').to(1, 2 - down, 'b').to(1 - in, 2, 'c').to(0, 2, 'd'), sides);
}

Solid pipe(int sides) { return revolved(Path(0.7, 0).to(1, 0, 'a').to(1, 2, 'b').to(0.7, 2, 'c').close('d'), sides); }

Solid dome(int sides, int rows) {
    Path p(0, 0);
    p.to(1, 0, 'a').to(1, 1, 'b').arc({0, 1}, 1, 0, 90.0 * (rows - 1) / rows, rows - 1, 'b');
    return revolved(p.to(0, 2, 'b'), sides);
}

Solid capsule(int sides, int rows) {
    Path p(0, -1.6);
    p.arc({0, -0.6}, 1, -90, 0, rows, 'a').to(1, 0.6, 'a').arc({0, 0.6}, 1, 0, 90.0 * (rows - 1) / rows, rows - 1, 'a');
    return revolved(p.to(0, 1.6, 'a'), sides);
}

/// A ball on a hard shoulder.
Solid hard_dome() {
    Path p(0, 0);
    p.to(1, 0, 'a').to(1, 0.8, 'b').to(0.7, 0.8, 'c').arc({0, 0.8}, 0.7, 0, 75, 5, 'd');
    return revolved(p.to(0, 1.5, 'd'), 20);
}

/// Round shoulder and neck, hard foot, bead and mouth.
Solid bottle() {
    Path p(0, 0);
    p.to(0.75, 0, 'a')
        .to(0.8, 0.05, 'b')
        .to(0.8, 1.8, 'c')
        .arc({0.4, 1.8}, 0.4, 0, 60, 4, 'c')
        .arc({0.8, 2.493}, 0.4, 240, 180, 4, 'c');
    p.to(0.4, 2.9, 'c')
        .to(0.45, 2.9, 'd')
        .to(0.45, 3.05, 'e')
        .to(0.4, 3.05, 'f')
        .to(0.4, 3.2, 'g')
        .to(0.33, 3.2, 'h')
        .to(0.33, 2.7, 'i');
    return revolved(p.to(0, 2.7, 'j'), 24);
}

/// Foot and rim are hard, the bowl is round inside and outside.
Solid bowl() {
    Path p(0, 0);
    p.to(0.5, 0, 'a').to(0.5, 0.1, 'b').arc({0, 1.1}, 1.118, -63.4, 0, 5, 'c').to(1.03, 1.1, 'd');
    p.arc({0, 1.1}, 1.03, 0, -75, 5, 'e');
    return revolved(p.to(0, 0.07, 'e'), 24);
}

Solid washer() {
    return revolved(Path(0.5, 0).to(1, 0, 'a').to(1, 0.12, 'b').to(0.95, 0.15, 'c').to(0.5, 0.15, 'd').close('e'), 30);
}

Solid flat_cap() {  // a cone of 20 degrees on a wall
    return revolved(Path(0, 0).to(1, 0, 'a').to(1, 0.6, 'b').to(0, 0.964, 'c'), 24);
}

void add_revolved(CreaseModels& to) {
    to.push_back(make_model("cone of 16 sides", cone(16, 2)));
    to.push_back(make_model("cone of 8 sides", cone(8, 2), {.is_decidable = false}));
    to.push_back(make_model("cone of 12 sides, 3 decimals", cone(12, 1.2), {.digits = 3}));
    to.push_back(make_model("flat cone of 16 sides, rim of 30 degrees", cone(16, 0.577)));
    to.push_back(make_model("truncated cone", revolved(Path(0, 0).to(1, 0, 'a').to(0.6, 1.5, 'b').to(0, 1.5, 'c'), 20),
                            {.digits = 4}));
    for (const int sides : {12, 24})
        to.push_back(
            make_model("stepped shaft of " + std::to_string(sides) + " sides", stepped_shaft(sides), {.digits = 5}));
    to.push_back(make_model("shaft, chamfer of 30 degrees", chamfered_shaft(32, 30, 0.2), {.digits = 5}));
    to.push_back(make_model("shaft, chamfer of 45 degrees", chamfered_shaft(24, 45, 0.1), {.digits = 4}));
    to.push_back(make_model("shaft, chamfer of 60 degrees", chamfered_shaft(24, 60, 0.3), {.digits = 4}));
    to.push_back(make_model("shaft, chamfer of 15 degrees", chamfered_shaft(48, 15, 0.4), {.digits = 4}));
    to.push_back(make_model("pipe", pipe(24), {.digits = 4}));
    to.push_back(make_model("pipe, 12 bits", pipe(16), {.bits = 12}));
    to.push_back(make_model("cylinder with a dome, 16 x 4", dome(16, 4), {.digits = 4}));
    to.push_back(make_model("cylinder with a dome, 32 x 8", dome(32, 8), {.digits = 4}));
    to.push_back(make_model("capsule, 16 x 4", capsule(16, 4), {.digits = 4}));
    to.push_back(make_model("capsule, 10 x 3", capsule(10, 3), {.digits = 4}));
    to.push_back(make_model("dome on a shoulder", hard_dome(), {.digits = 4}));
    to.push_back(make_model("bottle", bottle(), {.digits = 4}));
    to.push_back(make_model("bowl", bowl(), {.digits = 4}));
    to.push_back(make_model("washer", washer(), {.digits = 4}));
    to.push_back(make_model("cap of 20 degrees on a wall", flat_cap(), {.digits = 4}));
}

}  // namespace

constinit const ModelFamily revolved_models{.add = add_revolved};

}  // namespace rakelight
