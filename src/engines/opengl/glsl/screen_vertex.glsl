// SPDX-License-Identifier: Apache-2.0
// One triangle over all pixels, behind everything.
void main()
{
    vec2 p = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    gl_Position = vec4(p * 4.0 - 1.0, 0.0, 1.0);
}
