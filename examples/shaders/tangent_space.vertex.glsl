// Normal mapping in tangent space, first half: the vertex shader takes the vectors to the lights and to the viewer into the
// tangent space of the vertex, by the inverse of the matrix (t, b, n). tangent_space.glsl is the second half.
//
//     rakelight render builtin:teapot --texture-normal MAP.png --engine gl --vertex-shader tangent_space.vertex.glsl
//         --lighting tangent_space.glsl -o picture.png
out vec3 to_light[8];  // of the first eight lights
out vec3 to_viewer_t;

RL_FN void user_vertex(RL_INOUT(Vertex) v)
{
    vec3 n = normal_in_world(v.normal);
    vec3 t = map_tangent(n, tangent_in_world(v.tangent.xyz), RL_ORTHOGONALIZE);
    vec3 b = cross(n, t) * (v.tangent.w * mirror());
    vec3 position = to_eye(v.position);
    int count = min(light_count(), 8);
    for (int i = 0; i < 8; ++i) {
        to_light[i] = i < count ? to_tangent_space(n, t, b, 0, vector_to_light(i, position)) : vec3(0.0f);
    }
    to_viewer_t = to_tangent_space(n, t, b, 0, vector_to_viewer(position));
}
