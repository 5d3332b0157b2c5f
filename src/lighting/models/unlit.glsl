// SPDX-License-Identifier: Apache-2.0
// Source: KHR_materials_unlit: the base color is the radiance, independent of lights. Also "own color" shading.
RL_FN vec3 unlit(vec3 base_color, vec3 emission)
{
    return base_color + emission;
}
