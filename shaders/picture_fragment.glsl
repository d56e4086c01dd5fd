#version 330 core
in vec2 place;

uniform sampler2D picture;
uniform float opacity;

out vec4 result;

void main() {
    vec4 colour = texture(picture, place);
    result = vec4(colour.rgb, colour.a * opacity);
}
