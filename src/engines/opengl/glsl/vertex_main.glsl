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
vec3 front_normal(vec3 position[3]) { return safe_normalize(cross(position[1] - position[0], position[2] - position[0]) * rl_object[10].x); }

// All of a plane is seen from one side: that of the eye.
vec3 seen_normal(vec3 position[3])
{
    vec3 n = safe_normalize(cross(position[1] - position[0], position[2] - position[0]));
    vec3 middle = (position[0] + position[1] + position[2]) / 3.0;
    return dot(n, vertex_to_viewer(middle, rl_view_direction, RL_PARALLEL)) < 0.0 ? -n : n;
}
#endif

Vertex this_vertex()
{
    Vertex v;
#if RL_FROM_TRIANGLES
    int corner = rl_first_corner + gl_VertexID;
    int number = corner / 3;
    Vertex all[3];
    vec3 position[3];
    find_triangle(number, all, position);
    v_face_normal = seen_normal(position);
    int k = corner - 3 * number;
    v_barycentric = vec3(float(k == 0), float(k == 1), float(k == 2));
    v = all[k];
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
#if RL_HAS_NORMALS && !RL_MESH_NORMALS
    v_normal = front_normal(position);
#endif
#else
    v.position = a_position;
    v.normal = a_normal;
    v.tangent = a_tangent;
#if RL_HAS_BITANGENTS
    v.bitangent = a_bitangent;
#endif
    v.texcoords = vec4(a_texcoords0, a_texcoords1);
    v.color = a_color;
#endif
    return v;
}

void main()
{
    Vertex v = this_vertex();
    v_position = to_eye(v.position);
    gl_Position = to_clip(v.position);
#if RL_HAS_NORMALS && (RL_MESH_NORMALS || !RL_FROM_TRIANGLES)
    v_normal = normal_in_world(v.normal);
#endif
#if RL_HAS_TANGENTS
    v_tangent = vec4(tangent_in_world(v.tangent.xyz), v.tangent.w * rl_object[10].x);
#endif
#if RL_HAS_BITANGENTS
    v_bitangent = tangent_in_world(v.bitangent);
#endif
#if RL_HAS_TEXCOORDS
    v_texcoords = RL_TEXCOORDS(v.texcoords);
#if RL_SAMPLED && !RL_HAS_SAMPLE_MASK
    v_center_texcoords = RL_TEXCOORDS(v.texcoords);
#endif
#endif
#if RL_HAS_COLORS
    v_color = v.color;
#endif
#if RL_LIT_AT == RL_AT_VERTICES
    vec3 n = normal_in_world(v.normal);
    vec3 ambient, diffuse, specular;
    hand_on(light_of_vertex(v_position, n), ambient, diffuse, specular);
#if !RL_PAINTS_LAST
    v_ambient = ambient;
#endif
    v_diffuse = diffuse;
    v_specular = specular;
#if RL_TWO_SIDES
    hand_on(light_of_vertex(v_position, -n), ambient, diffuse, specular);
#if !RL_PAINTS_LAST
    v_turned_ambient = ambient;
#endif
    v_turned_diffuse = diffuse;
    v_turned_specular = specular;
#endif
#endif
}
