// SPDX-License-Identifier: Apache-2.0
// Items for the lighting tests: columns that grow, results that are read back.
#pragma once
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "math/isa.h"
#include "math/linear.h"
#include "unit/lighting/lighting_kernel.h"

namespace rakelight::lighting_test {

struct Item {
    vec3 n{0, 0, 1}, l{0, 0, 1}, v{0, 0, 1}, ka{1, 1, 1}, kd{1, 1, 1}, ks{1, 1, 1}, p{0, 0, 0};
    float e = 1, s = 0, t = 0;
};

class Items {
public:
    void push(const Item& i) {
        const vec3 vectors[] = {i.n, i.l, i.v, i.ka, i.kd, i.ks, i.p};
        std::size_t c = 0;
        for (const vec3& x : vectors)
            for (std::size_t k = 0; k < 3; ++k) columns_[c++].push_back(x[k]);
        for (const float x : {i.e, i.s, i.t}) columns_[c++].push_back(x);
        ++size_;
    }
    std::size_t size() const { return size_; }

    /// Filled up to a multiple of 16 with harmless items.
    Inputs inputs() {
        const std::size_t before = size_;
        while (columns_[0].size() % 16 != 0) push({});
        size_ = before;
        Inputs in{};
        for (std::size_t c = 0; c < columns_.size(); ++c) in.column[c] = columns_[c].data();
        in.count = int(columns_[0].size());
        return in;
    }

private:
    std::array<std::vector<float>, 24> columns_;
    std::size_t size_ = 0;
};

/// Columns of results: at [column][item].
class Results {
public:
    Results(int width, int count) : columns_(std::size_t(width), std::vector<float>(std::size_t(count), -77.0f)) {
        for (auto& column : columns_) pointers_.push_back(column.data());
    }
    float* const* out() { return pointers_.data(); }
    const std::vector<float>& operator[](std::size_t column) const { return columns_[column]; }
    std::size_t width() const { return columns_.size(); }
    vec3 vector(std::size_t first, std::size_t item) const {
        return {columns_[first][item], columns_[first + 1][item], columns_[first + 2][item]};
    }

private:
    std::vector<std::vector<float>> columns_;
    std::vector<float*> pointers_;
};

inline Results run(const Kernel& kernel, const std::string& operation, Items& items) {
    const Inputs in = items.inputs();
    for (int i = 0; i < kernel.operation_count; ++i)
        if (kernel.operations[i].name == operation) {
            Results results(kernel.operations[i].width, in.count);
            kernel.operations[i].run(in, results.out());
            return results;
        }
    throw std::runtime_error("no operation " + operation);
}

inline Results terms(const Kernel& kernel, Items& items, Choice choice,
                     const lighting::LightParameters* light = nullptr) {
    const Inputs in = items.inputs();
    Results results(9, in.count);
    kernel.terms(in, light, choice, results.out());
    return results;
}

inline Results material(const Kernel& kernel, Items& items, MaterialChoice choice) {
    const Inputs in = items.inputs();
    Results results(9, in.count);
    kernel.material(in, choice, results.out());
    return results;
}

inline constexpr int oren_nayar = 3, ward = 4, pbr = 5, oren_nayar_full = 6;
inline constexpr MaterialChoice all_materials[] = {{oren_nayar},        {oren_nayar_full},
                                                   {ward, 0},           {ward, 1},
                                                   {ward, 2},           {pbr},
                                                   {pbr, 2, 1},         {pbr, 2, 0, 1},
                                                   {pbr, 2, 0, 0, 1},   {pbr, 2, 0, 0, 0, 1},
                                                   {pbr, 2, 1, 1, 1, 1}};
inline constexpr int lambert = 0, phong = 1, blinn_phong = 2, textbook = 0, normalized = 1;
inline constexpr Choice all_choices[] = {
    {lambert, textbook, 1},        {lambert, normalized, 1},     {phong, textbook, 1},       {phong, textbook, 0},
    {phong, normalized, 1},        {phong, normalized, 0},       {blinn_phong, textbook, 1}, {blinn_phong, textbook, 0},
    {blinn_phong, normalized, 1},  {blinn_phong, normalized, 0}, {phong, textbook, 0, 7},    {phong, normalized, 1, 3},
    {blinn_phong, textbook, 1, 48}};

/// Numbers that are the same on every machine (the distributions of <random> are not).
class Random {
public:
    float unit() { return float(engine_() >> 8) / 16777216.0f; }  ///< 0..1
    float within(float low, float high) { return low + (high - low) * unit(); }
    vec3 vector(float width) { return {within(-width, width), within(-width, width), within(-width, width)}; }
    vec3 color() { return {unit(), unit(), unit()}; }
    vec3 direction() { return normalize_or(vector(1), vec3{0, 0, 1}); }
    std::uint32_t bits() { return std::uint32_t(engine_()); }

private:
    std::mt19937 engine_{4711};
};

inline Item random_item(Random& random) {
    Item item;
    item.n = random.direction(), item.l = random.direction(), item.v = random.direction();
    item.ka = random.color(), item.kd = random.color(), item.ks = random.color();
    item.p = random.vector(4);
    item.e = random.unit() < 0.5f ? random.within(1, 10) : random.within(1, 1000);
    item.s = random.within(-1, 1), item.t = random.within(-1, 1);
    return item;
}

/// 10 000 items with zero, tiny, huge, opposite and equal vectors among the random ones.
inline Items degenerate_items() {
    Random random;
    Items items;
    const vec3 odd[] = {{0, 0, 0},           {-0.0f, 0, 0}, {1e-30f, 0, 0},
                        {1e-20f, 1e-20f, 0}, {1e30f, 0, 0}, {3e38f, 3e38f, 3e38f},
                        {0, 0, 1},           {0, 0, -1},    {1, 0, 0}};
    const float odd_numbers[] = {0, -0.0f, 1, -1, 1e-40f, 1e30f, 3e38f, 1.0000001f, 0.5f, 1000};
    for (int i = 0; i < 10000; ++i) {
        Item item = random_item(random);
        const auto choose = [&](vec3& x) {
            if (random.bits() % 2 == 0) x = odd[random.bits() % 9];
        };
        choose(item.n), choose(item.l), choose(item.v), choose(item.p);
        if (random.bits() % 4 == 0) item.l = -item.v;
        for (float* x : {&item.e, &item.s, &item.t})
            if (random.bits() % 2 == 0) *x = odd_numbers[random.bits() % 10];
        if (random.bits() % 2 == 0) item.ka = {0, 0, 0};
        items.push(item);
    }
    return items;
}

inline std::vector<lighting::LightParameters> one_light_of_each_kind() {
    std::vector<lighting::LightParameters> lights;
    for (const bool is_photometric : {false, true})
        for (const lighting::LightKind kind : {lighting::LightKind::ambient, lighting::LightKind::directional,
                                               lighting::LightKind::point, lighting::LightKind::spot}) {
            if (is_photometric && kind == lighting::LightKind::ambient) continue;
            lighting::LightParameters light;
            light.kind = kind;
            light.is_photometric = is_photometric;
            light.position[0] = 1.5f, light.position[1] = -0.5f, light.position[2] = 2;
            light.direction[0] = -0.6f, light.direction[1] = 0, light.direction[2] = -0.8f;
            light.ambient[0] = 0.1f, light.diffuse[1] = 0.7f, light.specular[2] = 0.4f;
            light.constant_term = 0.5f, light.linear_term = 0.25f, light.quadratic_term = 0.125f;
            light.cos_cutoff = 0.8f, light.exponent = 3;
            light.intensity[0] = 12, light.intensity[1] = 5;
            light.inverse_range = 0.2f;
            lighting::set_cone(light, 0.95f, 0.7f);
            lights.push_back(light);
        }
    return lights;
}

}  // namespace rakelight::lighting_test
