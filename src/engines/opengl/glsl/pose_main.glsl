// SPDX-License-Identifier: Apache-2.0
// Vertices in bind pose -> vertices as they stand, caught by transform feedback. The twin of src/geometry/pose/morph.cpp and
// skin.cpp (with kernels/skin_kernel.cpp), whose rules these are.
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in uvec4 a_joints;       // JointInfluence: the strongest four
layout(location = 4) in vec4 a_weights;
layout(location = 5) in uvec4 a_more_joints;  // the next four
layout(location = 6) in vec4 a_more_weights;
out vec3 v_position;
#if RL_HAS_NORMALS
out vec3 v_normal;
#endif
#if RL_HAS_TANGENTS
out vec4 v_tangent;
#endif

uniform highp sampler2D rl_numbers;  // of the moment: a texel a target that counts, four a joint
uniform highp sampler2D rl_offsets;  // of the mesh's targets: blocks of a texel a vertex
uniform ivec4 rl_pose;               // first target in rl_numbers, how many, first joint; vertices

ivec2 fetch_place(int i) { return ivec2(i & (RL_FETCH_WIDTH - 1), i / RL_FETCH_WIDTH); }
vec4 number_at(int i) { return texelFetch(rl_numbers, fetch_place(i), 0); }

// weight * offset of a target's block of positions, normals or tangents; negative: it has none
vec3 offset_of(float weight, float block)
{
    if (block < 0.0) {
        return vec3(0.0);
    }
    return texelFetch(rl_offsets, fetch_place(int(block) * rl_pose.w + gl_VertexID), 0).xyz * weight;
}

float largest_of(vec3 v) { return max(max(abs(v.x), abs(v.y)), abs(v.z)); }

// normalize_or() of <rakelight/math/linear.h>: right for any finite length
vec3 unit_or(vec3 v, vec3 otherwise)
{
    float largest = largest_of(v);
    if (!(largest > 0.0 && largest <= 3.40282347e38)) {
        return otherwise;
    }
    vec3 scaled = v / largest;
    return scaled / sqrt(dot(scaled, scaled));
}

#if RL_IS_SKINNED
struct Columns {
    vec3 x, y, z, w;
};

// weigh() of the kernel: a joint of weight 0 need not be there
void add_joint(inout Columns sum, uint joint, float weight)
{
    if (weight == 0.0) {
        return;
    }
    int at = rl_pose.z + 4 * int(joint);
    sum.x += number_at(at).xyz * weight;
    sum.y += number_at(at + 1).xyz * weight;
    sum.z += number_at(at + 2).xyz * weight;
    sum.w += number_at(at + 3).xyz * weight;
}

void add_joints(inout Columns sum, uvec4 joints, vec4 weights)
{
    add_joint(sum, joints.x, weights.x);
    add_joint(sum, joints.y, weights.y);
    add_joint(sum, joints.z, weights.z);
    add_joint(sum, joints.w, weights.w);
}

// blend() of the kernel: weights as they are, whatever their sum; all 0: the first joint
Columns blended()
{
    Columns sum = Columns(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
    add_joints(sum, a_joints, a_weights);
    bool follows = a_weights != vec4(0.0);
#if RL_HAS_MORE
    add_joints(sum, a_more_joints, a_more_weights);
    follows = follows || a_more_weights != vec4(0.0);
#endif
    if (!follows) {
        add_joint(sum, 0u, 1.0);
    }
    return sum;
}
#endif

void main()
{
    vec3 position = a_position, normal = a_normal, tangent = a_tangent.xyz;
    float side = 1.0;
    // morph_positions(), morph_normals(), morph_tangents(): in the order of the targets; directions become unit only where
    // some target moves them
    bool normal_moves = false, tangent_moves = false;
    for (int t = 0; t < rl_pose.y; ++t) {
        vec4 target = number_at(rl_pose.x + t);
        position += offset_of(target.x, target.y);
        normal += offset_of(target.x, target.z);
        tangent += offset_of(target.x, target.w);
        normal_moves = normal_moves || target.z >= 0.0;
        tangent_moves = tangent_moves || target.w >= 0.0;
    }
    if (normal_moves) {
        normal = unit_or(normal, a_normal);
    }
    if (tangent_moves) {
        tangent = unit_or(tangent, a_tangent.xyz);
    }
#if RL_IS_SKINNED
    // skin_block() of the kernel
    Columns m = blended();
    position = m.x * position.x + m.y * position.y + m.z * position.z + m.w;
    // Directions do not ask for the matrix's scale: cofactors of its numbers over the largest neither over- nor underflow
    // (turn_odd() of skin.cpp has double for that).
    float largest = max(max(largest_of(m.x), largest_of(m.y)), largest_of(m.z));
    float scale = largest > 0.0 ? 1.0 / largest : 0.0;
    vec3 x = m.x * scale, y = m.y * scale, z = m.z * scale, yz = cross(y, z);
    side = dot(x, yz) < 0.0 ? -1.0 : 1.0;  // the cofactor matrix turns normals over where m mirrors
    normal = unit_or((yz * normal.x + cross(z, x) * normal.y + cross(x, y) * normal.z) * side, normal);
    tangent = unit_or(x * tangent.x + y * tangent.y + z * tangent.z, tangent);
#endif
    v_position = position;
#if RL_HAS_NORMALS
    v_normal = normal;
#endif
#if RL_HAS_TANGENTS
    v_tangent = vec4(tangent, a_tangent.w * side);
#endif
    gl_Position = vec4(0.0, 0.0, 0.0, 1.0);  // rasterizes nothing
}
