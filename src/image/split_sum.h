// SPDX-License-Identifier: Apache-2.0
// How much of even light a glossy surface mirrors.
#pragma once
#include <vector>

namespace rakelight {

/// Directional albedo of a GGX surface with Schlick's Fresnel term, f0 times `scale` plus `bias`: Karis 2013, "Real
/// Shading in Unreal Engine 4", with the height-correlated Smith term (Heitz 2014, eq. 99), by 256 visible normals
/// (Heitz 2018, "Sampling the GGX Distribution of Visible Normals", listing 1); error under 0.004.
struct AlbedoOfGloss {
    float scale = 0, bias = 0;
};
AlbedoOfGloss albedo_of_gloss(double n_dot_v, double roughness);

/// [size][size][2] scale and bias, by roughness in rows and n.v in columns, both i / (size - 1).
/// The same bits on every machine; 32 x 32 take about 10 ms.
std::vector<float> split_sum_table(int size);

}  // namespace rakelight
