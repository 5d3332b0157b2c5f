// A wave that runs along x through a plane: y = height sin(2 pi (x / wavelength - speed time)), with its own normals.
//
//     rakelight render builtin:plane:divisions=100 --engine gl --vertex-shader waves.vertex.glsl --uniform height=0.1 -o picture.png
//     rakelight builtin:plane:divisions=100 --engine gl --vertex-shader waves.vertex.glsl --turntable 48 --fps 24 -o waves.apng
uniform float height = 0.05;      // [m]
uniform float wavelength = 0.5;   // [m]
uniform float speed = 1.0;        // [waves/s]

RL_FN void user_vertex(RL_INOUT(Vertex) v)
{
    real turns = 6.28318531f / wavelength;
    real phase = turns * v.position.x - 6.28318531f * speed * rl_time;
    v.position.y = v.position.y + height * sin(phase);
    v.normal = vec3(-height * turns * cos(phase), 1.0f, 0.0f);
    v.tangent = vec4(1.0f, height * turns * cos(phase), 0.0f, v.tangent.w);
}
