#version 330 core
// Fills the domain with one colour; see field_fragment for colours of the node spacing.
in vec2 pixel;

uniform sampler2D mask; // one texel per pixel: coverage of the domain
uniform vec4 plain;

out vec4 result;

void main() {
    result = vec4(plain.rgb, plain.a * texelFetch(mask, ivec2(pixel), 0).r);
}
