// SPDX-License-Identifier: Apache-2.0
// Nuts, columns of few sides, cylinders.
#include "tools/bench/normal_shapes.h"
#include "tools/creases/model_families.h"

namespace rakelight {
namespace {

Solid nut() {
    Solid s;
    s.add_extruded(regular(6, 1), 0, 0.8, {circle({}, 0.55, 24, 'h')});
    return s;
}

Solid flat_column(int sides) {
    Solid s;
    s.add_extruded(regular(sides, 1), 0, 2.5);
    return s;
}

Solid cylinder(int sides, double height = 2) {
    Solid s;
    s.add_extruded(circle({}, 1, sides, 'w'), 0, height);
    return s;
}

/// Walls of four rings of squares.
Solid ringed_cylinder() {
    Solid s;
    s.add_revolved(Path(0, 0).to(1, 0, 'a').to(1, 0.5, 'w').to(1, 1, 'w').to(1, 1.5, 'w').to(1, 2, 'w').to(0, 2, 'b'),
                   16);
    return s;
}

/// Sides of 8 to 31 degrees.
Solid uneven_cylinder() {
    Random random(5);
    std::vector<double> turns, steps;
    double sum = 0;
    for (int i = 0; i < 20; ++i) steps.push_back(random.within(0.4, 1.6)), sum += steps.back();
    double at = 0;
    for (const double step : steps) turns.push_back(at / sum), at += step;
    Solid s;
    s.add_revolved(Path(0, 0).to(1, 0, 'a').to(1, 2, 'b').to(0, 2, 'c'), turns);
    return s;
}

void add_nuts(CreaseModels& to) {
    for (const int digits : {6, 4, 3, 2})
        to.push_back(make_model("hex nut, " + std::to_string(digits) + " decimals", nut(), {.digits = digits}));
    for (const int bits : {14, 12})
        to.push_back(make_model("hex nut, " + std::to_string(bits) + " bits", nut(), {.bits = bits}));
    Solid turned_nut = nut();
    turned_nut.turn(31, 17, 8);
    to.push_back(make_model("hex nut, turned, 4 decimals", turned_nut, {.digits = 4}));
    to.push_back(make_model("hex nut, turned, 14 bits", turned_nut, {.bits = 14}));
}

void add_prisms(CreaseModels& to) {
    add_nuts(to);
    for (const int sides : {3, 4, 5, 6})
        to.push_back(
            make_model("column of " + std::to_string(sides) + " flat sides", flat_column(sides), {.digits = 4}));
    for (const int sides : {7, 8})
        to.push_back(make_model("column of " + std::to_string(sides) + " flat sides", flat_column(sides),
                                {.is_decidable = false}));
    for (const int sides : {6, 8})
        to.push_back(make_model("column of " + std::to_string(sides) + " sides, round", cylinder(sides),
                                {.is_decidable = false}));
    for (const int sides : {10, 12, 24, 48})
        to.push_back(make_model("cylinder of " + std::to_string(sides) + " sides", cylinder(sides), {.digits = 4}));
    to.push_back(make_model("cylinder of 16 sides, 3 decimals", cylinder(16), {.digits = 3}));
    to.push_back(make_model("coin of 32 sides", cylinder(32, 0.15), {.digits = 3}));
    to.push_back(make_model("cylinder of 16 sides and 4 rings", ringed_cylinder(), {.digits = 4}));
    to.push_back(make_model("cylinder of uneven sides", uneven_cylinder(), {.digits = 4}));
}

}  // namespace

constinit const ModelFamily prism_models{.add = add_prisms};

}  // namespace rakelight
