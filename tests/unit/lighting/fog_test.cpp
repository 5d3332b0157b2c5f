// SPDX-License-Identifier: Apache-2.0
// Fog against the closed forms of the specification.
#include <gtest/gtest.h>

#include "unit/lighting/lighting_items.h"

namespace rakelight::lighting_test {
namespace {

#define RL_NO_FOG 0
#define RL_LINEAR_FOG 1
#define RL_EXPONENTIAL_FOG 2
#define RL_EXPONENTIAL_SQUARED_FOG 3

struct Row {
    int kind;
    float distance, start, end, density, factor;
};
#define RL_FOG(...) Row{__VA_ARGS__},
const std::vector<Row> rows = {
#include "unit/lighting/fog_values.inc"
};

/// The operation of lighting_operations.inc: d = |p|, start, end and density in ka.
float factor(const char* operation, float distance, float start, float end, float density) {
    Items items;
    Item item;
    item.p = {0, 0, distance};
    item.ka = {start, end, density};
    items.push(item);
    const Inputs in = items.inputs();
    Results results(1, in.count);
    for (int i = 0; i < scalar::kernel.operation_count; ++i)
        if (std::string(scalar::kernel.operations[i].name) == operation)
            scalar::kernel.operations[i].run(in, results.out());
    return results[0][0];
}

const char* name_of(int kind) {
    return kind == RL_LINEAR_FOG        ? "linear_fog"
           : kind == RL_EXPONENTIAL_FOG ? "exponential_fog"
                                        : "exponential_squared_fog";
}

TEST(Fog, GivesTheValuesOfTheTable) {
    ASSERT_EQ(rows.size(), 21u);
    for (const Row& r : rows)
        EXPECT_NEAR(factor(name_of(r.kind), r.distance, r.start, r.end, r.density), r.factor, 3e-7)
            << name_of(r.kind) << ' ' << r.distance;
}

TEST(Fog, NeverGivesMoreThanAllNorLessThanNothing) {
    for (const float d : {0.0f, 1e-20f, 3.0f, 1e10f, 3e18f})
        for (const float number : {-1e30f, -2.0f, 0.0f, 1e-30f, 2.0f, 1e30f})
            for (int kind = RL_LINEAR_FOG; kind <= RL_EXPONENTIAL_SQUARED_FOG; ++kind) {
                const float f = factor(name_of(kind), d, number, 2, number);
                EXPECT_GE(f, 0) << name_of(kind) << ' ' << d << ' ' << number;
                EXPECT_LE(f, 1) << name_of(kind) << ' ' << d << ' ' << number;
            }
}

}  // namespace
}  // namespace rakelight::lighting_test
