// SPDX-License-Identifier: Apache-2.0
// A picture on the screen: linear light, premultiplied, through a tone curve (image/tone.glsl) to sRGB codes; or codes as
// they are.
uniform sampler2D rl_picture;
uniform vec4 rl_show;        // [px] of the viewport's corner, 1 / its size
uniform float rl_gain;       // 2^exposure
uniform vec4 rl_behind;      // linear color that lies behind the picture, and its alpha
out vec4 o_color;

// IEC 61966-2-1.
float srgb_of(float c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * pow(c, 1.0 / 2.4) - 0.055; }

void main()
{
    vec2 uv = (gl_FragCoord.xy - rl_show.xy) * rl_show.zw;
    uv.y = 1.0 - uv.y;
    vec4 texel = texture(rl_picture, uv);
#if RL_SHOWS_CODES
    o_color = vec4(texel.xyz * texel.w, 1.0);
#else
    Maps maps;
    maps.unused = 0.0;
    vec3 c = clamp(tone_curve(maps, RL_TONE, texel.xyz / max(texel.w, 1e-6), rl_gain), 0.0, 1.0);
    float under = rl_behind.w * (1.0 - texel.w);
    float alpha = texel.w + under;
    vec3 s = (c * texel.w + rl_behind.xyz * under) / max(alpha, 1e-6);
    o_color = vec4(vec3(srgb_of(s.x), srgb_of(s.y), srgb_of(s.z)) * alpha, 1.0);
#endif
}
