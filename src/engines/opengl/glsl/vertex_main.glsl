// SPDX-License-Identifier: Apache-2.0
// The vertex stage of surfaces.
invariant gl_Position;

#if RL_FROM_TRIANGLES
// The whole triangle: what its three vertices find alike.
void find_triangle(int number, out Vertex corner[3], out vec3 position[3])
{
    for (int k = 0; k < 3; ++k) {
        corner[k] = fetch_corner(3 * number + k);
        position[k] = to_eye(corner[k].position);
    }
    v_triangle = ivec2(number, is_against(number));
}

// Of the plane, on its front: DrawFrame::corners().
vec3 front_normal(vec3 position[3]) { return safe_normalize(cross(position[1] - position[0], position[2] - position[0]) * mirror()); }

// All of a plane is seen from one side: that of the eye.
vec3 seen_normal(vec3 position[3])
{
    vec3 n = safe_normalize(cross(position[1] - position[0], position[2] - position[0]));
    vec3 middle = (position[0] + position[1] + position[2]) / 3.0;
    return dot(n, vertex_to_viewer(middle, rl_view_direction, RL_PARALLEL)) < 0.0 ? -n : n;
}
#endif

#if RL_FROM_TRIANGLES
// What is the same at all of a triangle's vertices.
void hand_on_triangle(Vertex all[3], vec3 position[3])
{
    v_face_normal = seen_normal(position);
#if RL_HAS_CORNER_FRAMES
    for (int i = 0; i < 3; ++i) {
        v_corner_position[i] = position[i];
        v_corner_normal[i] = RL_MESH_NORMALS != 0 ? normal_in_world(all[i].normal) : front_normal(position);
        v_corner_tangent[i] = tangent_in_world(all[i].tangent.xyz);
#if RL_HAS_BITANGENTS
        v_corner_bitangent[i] = tangent_in_world(all[i].bitangent);
#endif
    }
#endif
#if RL_LIT_AT == RL_AT_FACES
    vec3 ambient, diffuse, specular;
    hand_on(light_of_vertex((position[0] + position[1] + position[2]) / 3.0, v_face_normal), ambient, diffuse, specular);
    v_ambient = ambient;
    v_diffuse = diffuse;
    v_specular = specular;
#endif
}
#else
Vertex this_vertex()
{
    Vertex v;
    v.position = a_position;
    v.normal = a_normal;
    v.tangent = a_tangent;
    v.bitangent = vec3(0.0);
#if RL_HAS_BITANGENTS
    v.bitangent = a_bitangent;
#endif
    v.texcoords = vec4(a_texcoords0, a_texcoords1);
    v.color = a_color;
#if RL_HAS_VERTEX_SHADER
    user_vertex(v);
#endif
    return v;
}
#endif

#if RL_CUTS
// Triangles that reach out of the clip volume are cut as raster/geometry/clip.cpp cuts them: a value that is linear on the
// screen bends at the same edges.
uniform vec4 rl_cut[2];  // near, far, guard band in x and y; clip space -> that of the whole picture: scale x, offset x, likewise y

// Of what is left of a triangle: weights of its corners; x, y and w.
struct CutCorner {
    vec3 weights;
    vec3 place;
};

float inside_by(vec3 place, int plane)
{
    float guard = (plane < 4 ? rl_cut[0].z : rl_cut[0].w) * place.z;
    float at = plane < 4 ? place.x : place.y;
    return plane == 0 ? place.z - rl_cut[0].x : plane == 1 ? rl_cut[0].y - place.z : (plane & 1) == 0 ? guard + at : guard - at;
}

CutCorner cut(CutCorner inner, CutCorner outer, float inner_by, float outer_by)
{
    float t = inner_by / (inner_by - outer_by);
    return CutCorner(mix(inner.weights, outer.weights, t), mix(inner.place, outer.place, t));
}

// Sutherland and Hodgman 1974; the number of corners.
int cut_triangle(inout CutCorner c[RL_PIECES + 2])
{
    int count = 3;
    for (int plane = 0; plane < 6; ++plane) {
        CutCorner from[RL_PIECES + 2] = c;
        int n = count;
        count = 0;
        for (int i = 0; i < n; ++i) {
            CutCorner a = from[i];
            CutCorner b = from[i + 1 < n ? i + 1 : 0];
            float a_by = inside_by(a.place, plane);
            float b_by = inside_by(b.place, plane);
            if (a_by >= 0.0 && count < RL_PIECES + 2) {
                c[count++] = a;
            }
            if ((a_by >= 0.0) != (b_by >= 0.0) && count < RL_PIECES + 2) {
                if (a_by >= 0.0) {
                    c[count++] = cut(a, b, a_by, b_by);
                } else {
                    c[count++] = cut(b, a, b_by, a_by);
                }
            }
        }
    }
    return count;
}

// The weights of corner `k` of piece `piece`; 0: there is no such piece.
vec3 cut_weights(Vertex corner[3], int piece, int k)
{
    CutCorner c[RL_PIECES + 2];
    for (int i = 0; i < 3; ++i) {
        vec4 clip = to_clip(corner[i].position);
        c[i].weights = vec3(float(i == 0), float(i == 1), float(i == 2));
        c[i].place = vec3(clip.xy * rl_cut[1].xz + clip.ww * rl_cut[1].yw, clip.w);
    }
    int count = cut_triangle(c);
    return piece + 2 < count ? c[k == 0 ? 0 : piece + k].weights : vec3(0.0);
}
#define RL_PUT(to, value) to = own.x == 1.0 ? (value) * weight : to + (value) * weight
#elif RL_SCREEN_LINEAR
#define RL_PUT(to, value) to = (value) * weight
#else
#define RL_PUT(to, value) to = value
#endif

// Attributes of a vertex, times `weight` where they are linear on the screen, added up where triangles are cut.
// `own`: its barycentrics.
void hand_on_vertex(Vertex v, vec3 own, float weight)
{
#if RL_HAS_NORMALS && (RL_MESH_NORMALS || !RL_FROM_TRIANGLES)
    RL_PUT(v_normal, normal_in_world(v.normal));
#endif
#if RL_HAS_TANGENTS
    RL_PUT(v_tangent, vec4(tangent_in_world(v.tangent.xyz), v.tangent.w * mirror()));
#endif
#if RL_HAS_BITANGENTS
    RL_PUT(v_bitangent, tangent_in_world(v.bitangent));
#endif
#if RL_HAS_TEXCOORDS
    RL_PUT(v_texcoords, RL_TEXCOORDS(v.texcoords));
#if RL_SAMPLED && !RL_HAS_SAMPLE_MASK
    RL_PUT(v_center_texcoords, RL_TEXCOORDS(v.texcoords));
#endif
#endif
#if RL_HAS_COLORS
    RL_PUT(v_color, v.color);
#endif
#if RL_FROM_TRIANGLES
    RL_PUT(v_barycentric, own);
#endif
#if RL_LIT_AT == RL_AT_VERTICES
    vec3 position = to_eye(v.position);
    vec3 n = normal_in_world(v.normal);
    vec3 ambient, diffuse, specular;
    hand_on(light_of_vertex(position, n), ambient, diffuse, specular);
#if !RL_PAINTS_LAST
    RL_PUT(v_ambient, ambient);
#endif
    RL_PUT(v_diffuse, diffuse);
    RL_PUT(v_specular, specular);
#if RL_TWO_SIDES
    hand_on(light_of_vertex(position, -n), ambient, diffuse, specular);
#if !RL_PAINTS_LAST
    RL_PUT(v_turned_ambient, ambient);
#endif
    RL_PUT(v_turned_diffuse, diffuse);
    RL_PUT(v_turned_specular, specular);
#endif
#endif
}

void main()
{
    float weight = 1.0;
#if RL_FROM_TRIANGLES
    int place = rl_first_corner + gl_VertexID;
#if RL_CUTS
    int number = rl_first_corner / 3 + gl_VertexID / (3 * RL_PIECES);
#else
    int number = place / 3;
#endif
    int k = place % 3;
    Vertex all[3];
    vec3 position[3];
    find_triangle(number, all, position);
    hand_on_triangle(all, position);
    Vertex v = all[k];
#if RL_HAS_VERTEX_SHADER && !RL_CUTS
    v = fetch_corner(place);  // again: what it hands on is of this corner
#endif
#else
    int k = 0;
    Vertex v = this_vertex();
#endif
#if RL_CUTS
    vec3 weights = cut_weights(all, gl_VertexID / 3 % RL_PIECES, k);
    v_position = position[0] * weights.x + position[1] * weights.y + position[2] * weights.z;
    gl_Position = to_clip(all[0].position) * weights.x + to_clip(all[1].position) * weights.y + to_clip(all[2].position) * weights.z;
    v_w = gl_Position.w;
    for (int i = 0; i < 3; ++i) {
#if RL_HAS_VERTEX_SHADER
        fetch_corner(3 * number + i);  // again: what it hands on is of this corner
        add_passed(i == 0, weights[i]);
#endif
        hand_on_vertex(all[i], vec3(float(i == 0), float(i == 1), float(i == 2)), weights[i] * v_w);
    }
#if RL_HAS_VERTEX_SHADER
    hand_on_passed();
#endif
    weight = v_w;
#else
    v_position = to_eye(v.position);
    gl_Position = to_clip(v.position);
#if RL_SCREEN_LINEAR
    v_w = gl_Position.w;
    weight = v_w;
#endif
    hand_on_vertex(v, vec3(float(k == 0), float(k == 1), float(k == 2)), weight);
#endif
#if RL_HAS_NORMALS && RL_FROM_TRIANGLES && !RL_MESH_NORMALS
    v_normal = front_normal(position) * weight;
#endif
#if RL_CUTS
    if (weights == vec3(0.0)) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    }
#endif
}
