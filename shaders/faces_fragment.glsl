#version 330 core
in vec2 place;

uniform sampler2D faces; // premultiplied, so that texels outside the faces do not darken the edges between

out vec4 result;

void main() {
    vec4 tint = texture(faces, place);
    result = tint.a > 0.0 ? vec4(tint.rgb / tint.a, tint.a) : vec4(0.0);
}
