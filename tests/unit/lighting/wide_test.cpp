// SPDX-License-Identifier: Apache-2.0
// The lighting text gives the bits of the scalar flavour in every flavour, and no NaN, whatever goes in.
#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <set>
#include <string>

#include "math/flush_denormals.h"
#include "unit/lighting/lighting_items.h"
#include "unit/lighting/sphere_bins.h"

namespace rakelight::lighting_test {
namespace {

struct Flavour {
    Isa isa;
    Kernel kernel;
};

/// The wide ones that this processor has.
std::vector<Flavour> flavours() {
    std::vector<Flavour> all;
    for (const Isa isa : {Isa::sse2, Isa::avx2, Isa::avx512})
        if (is_available(isa)) all.push_back({isa, RL_BY_ISA(isa, kernel)});
    return all;
}

/// 100 000 items; in the second half 32 neighbors at a time share n and l, so that whole registers lie in shadow.
Items random_items() {
    Random random;
    Items items;
    Item shared;
    for (int i = 0; i < 100000; ++i) {
        Item item = random_item(random);
        if (i >= 50000) {
            if (i % 32 == 16) shared = item;
            item.n = shared.n, item.l = shared.l, item.p = shared.p;
        }
        items.push(item);
    }
    return items;
}

std::uint32_t bits(float x) { return std::isnan(x) ? 0x7fc00000u : std::bit_cast<std::uint32_t>(x); }

void expect_equal(const Results& got, const Results& expected, const std::string& what) {
    for (std::size_t c = 0; c < got.width(); ++c)
        for (std::size_t i = 0; i < got[c].size(); ++i)
            if (bits(got[c][i]) != bits(expected[c][i])) {
                ADD_FAILURE() << what << " column " << c << " item " << i << ": " << got[c][i] << ", scalar "
                              << expected[c][i];
                return;
            }
}

void expect_all_flavours_equal(Items& items) {
    for (int o = 0; o < scalar::kernel.operation_count; ++o) {
        const std::string operation = scalar::kernel.operations[o].name;
        const Results expected = run(scalar::kernel, operation, items);
        for (const Flavour& f : flavours())
            expect_equal(run(f.kernel, operation, items), expected, operation + " in " + name(f.isa));
    }
    for (const MaterialChoice choice : all_materials) {
        const Results expected = material(scalar::kernel, items, choice);
        for (const Flavour& f : flavours())
            expect_equal(material(f.kernel, items, choice), expected,
                         "material model " + std::to_string(choice.model) + " in " + name(f.isa));
    }
    for (const PathCase& c : path_cases()) {
        const Results expected = paths(scalar::kernel, items, c.surface);
        for (const Flavour& f : flavours())
            expect_equal(paths(f.kernel, items, c.surface), expected,
                         std::string("path surface ") + c.surface.name + " in " + name(f.isa));
    }
    const auto lights = one_light_of_each_kind();
    for (const Choice choice : all_choices)
        for (std::size_t i = 0; i <= lights.size(); ++i) {
            const auto* light = i < lights.size() ? &lights[i] : nullptr;
            const Results expected = terms(scalar::kernel, items, choice, light);
            for (const Flavour& f : flavours())
                expect_equal(terms(f.kernel, items, choice, light), expected,
                             "model " + std::to_string(choice.model) + " form " + std::to_string(choice.form) +
                                 " light " + std::to_string(i) + " in " + name(f.isa));
        }
}

TEST(WideLighting, EveryFunctionGivesTheBitsOfTheScalarFlavour) {
    Items items = random_items();
    expect_all_flavours_equal(items);
}

TEST(WideLighting, DegenerateInputGivesTheBitsOfTheScalarFlavourWithDenormalsFlushed) {
    const FlushDenormals guard;
    Items items = degenerate_items();
    expect_all_flavours_equal(items);
}

TEST(WideLighting, SumsOverLightsHashToTheNumberOfEveryOtherMachine) {
    // A changed number means changed pictures: say so in the changelog.
    Items items = random_items();
    const auto lights = one_light_of_each_kind();
    const Inputs in = items.inputs();
    std::uint64_t hash = 1469598103934665603ull;
    for (const Choice choice : all_choices) {
        Results results(3, in.count);
        scalar::kernel.sum(in, lights.data(), int(lights.size()), choice, results.out());
        for (std::size_t c = 0; c < 3; ++c)
            for (const float x : results[c]) hash = (hash ^ bits(x)) * 1099511628211ull;
    }
    EXPECT_EQ(hash, 2592978450703975911u);
}

TEST(WideLighting, NothingThatGoesInGivesNaN) {
    Items items = degenerate_items();
    const auto lights = one_light_of_each_kind();
    for (const Choice choice : all_choices)
        for (std::size_t light = 0; light < lights.size(); ++light) {
            const Results results = terms(scalar::kernel, items, choice, &lights[light]);
            for (std::size_t c = 0; c < 9; ++c)
                for (std::size_t i = 0; i < items.size(); ++i)
                    ASSERT_FALSE(std::isnan(results[c][i]))
                        << "light " << light << " model " << choice.model << " column " << c << " item " << i;
        }
    for (const MaterialChoice choice : all_materials) {
        const Results results = material(scalar::kernel, items, choice);
        for (std::size_t c = 0; c < 9; ++c)
            for (std::size_t i = 0; i < items.size(); ++i)
                ASSERT_FALSE(std::isnan(results[c][i])) << "model " << choice.model << " column " << c << " item " << i;
    }
    const Inputs in = items.inputs();
    // Directions are unit, and widths bounded: of all rows only those below take what is huge.
    const auto is_in_range = [&in](std::size_t item) {
        for (const std::size_t c : {0u, 1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u, 21u, 22u, 23u})
            if (!(std::abs(in.column[c][item]) < 1e18f)) return false;
        return true;
    };
    for (const PathCase& c : path_cases()) {
        const Results results = paths(scalar::kernel, items, c.surface);
        for (std::size_t column = 0; column < results.width(); ++column)
            for (std::size_t i = 0; i < items.size(); ++i)
                ASSERT_FALSE(is_in_range(i) && std::isnan(results[column][i]))
                    << "path surface " << c.surface.name << " column " << column << " item " << i;
    }
    const std::set<std::string> of_any_size = {
        "orthogonal_tangent",    "perturb_normal", "blinn_phong_lobe_of_vectors", "phong_lobe",      "blinn_phong_lobe",
        "classical_attenuation", "classical_spot", "photometric_attenuation",     "photometric_spot"};
    for (int o = 0; o < scalar::kernel.operation_count; ++o) {
        const std::string name = scalar::kernel.operations[o].name;
        const Results results = run(scalar::kernel, name, items);
        for (std::size_t c = 0; c < results.width(); ++c)
            for (std::size_t i = 0; i < items.size(); ++i) {
                if (!of_any_size.contains(name) && !is_in_range(i)) continue;
                EXPECT_FALSE(std::isnan(results[c][i])) << name << " item " << i;
                if (std::isnan(results[c][i])) break;
            }
    }
}

}  // namespace
}  // namespace rakelight::lighting_test
