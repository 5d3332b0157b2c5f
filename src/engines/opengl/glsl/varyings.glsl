// SPDX-License-Identifier: Apache-2.0
// What the vertex stage hands to the pixels. RL_VARYING is `out` or `in`; RL_ATTRIBUTE how attributes are interpolated,
// RL_PLACE how positions are, RL_CONSTANT: not at all. RL_HAS_...: the mesh has it, and the program reads it.
// Attributes that are linear on the screen are handed on times w: over w, which is linear in space, they are. The driver's
// own `noperspective` fails where it cuts triangles at the sides of the picture.
#if RL_SCREEN_LINEAR
RL_PLACE RL_VARYING float v_w;
#define RL_GIVEN(v) ((v) / v_w)
#else
#define RL_GIVEN(v) (v)
#endif
RL_PLACE RL_VARYING vec3 v_position;  // about the eye, world axes
#if RL_HAS_NORMALS
RL_ATTRIBUTE RL_VARYING vec3 v_normal;  // of unit vectors: not unit
#endif
#if RL_HAS_TANGENTS
RL_ATTRIBUTE RL_VARYING vec4 v_tangent;  // w: handedness in the world
#endif
#if RL_HAS_BITANGENTS
RL_ATTRIBUTE RL_VARYING vec3 v_bitangent;  // an attribute of its own
#endif
#if RL_HAS_TEXCOORDS
#if RL_HAS_SECOND_SET
#define RL_TEXCOORDS vec4  // set 0, set 1
#else
#define RL_TEXCOORDS vec2
#endif
RL_ATTRIBUTE RL_VARYING RL_TEXCOORDS v_texcoords;
#if RL_SAMPLED && !RL_HAS_SAMPLE_MASK
RL_VARYING RL_TEXCOORDS v_center_texcoords;  // at the pixel's center: what lies between centroids is no change from pixel to pixel
#endif
#endif
#if RL_HAS_COLORS
RL_ATTRIBUTE RL_VARYING vec4 v_color;
#endif
#if RL_LIT_AT == RL_AT_VERTICES
// Terms as hand_on() makes them, for normals as they are, and turned round.
#if !RL_PAINTS_LAST
RL_ATTRIBUTE RL_VARYING vec3 v_ambient;
#endif
RL_ATTRIBUTE RL_VARYING vec3 v_diffuse;
RL_ATTRIBUTE RL_VARYING vec3 v_specular;
#if RL_TWO_SIDES
#if !RL_PAINTS_LAST
RL_ATTRIBUTE RL_VARYING vec3 v_turned_ambient;
#endif
RL_ATTRIBUTE RL_VARYING vec3 v_turned_diffuse;
RL_ATTRIBUTE RL_VARYING vec3 v_turned_specular;
#endif
#endif
#if RL_LIT_AT == RL_AT_FACES
RL_CONSTANT RL_VARYING vec3 v_ambient;
RL_CONSTANT RL_VARYING vec3 v_diffuse;
RL_CONSTANT RL_VARYING vec3 v_specular;
#endif
#if RL_FROM_TRIANGLES
RL_CONSTANT RL_VARYING ivec2 v_triangle;  // its number; 1: its normals are on the other side (LitSide::against)
RL_ATTRIBUTE RL_VARYING vec3 v_barycentric;
RL_CONSTANT RL_VARYING vec3 v_face_normal;  // towards the viewer
#endif
#if RL_HAS_CORNER_FRAMES
RL_CONSTANT RL_VARYING vec3 v_corner_position[3];
RL_CONSTANT RL_VARYING vec3 v_corner_normal[3];
RL_CONSTANT RL_VARYING vec3 v_corner_tangent[3];
#if RL_HAS_BITANGENTS
RL_CONSTANT RL_VARYING vec3 v_corner_bitangent[3];
#endif
#endif
