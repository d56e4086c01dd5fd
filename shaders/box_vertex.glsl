#version 330 core
// One instanced box each; the corners are split doubles (high x, high y, low x, low y).
layout(location = 0) in vec4 lower;
layout(location = 1) in vec4 upper;
layout(location = 2) in vec4 fill;
layout(location = 3) in vec4 frame;

uniform vec2 centreHigh;
uniform vec2 centreLow;
uniform float zoom;
uniform vec2 viewport;

out vec2 inside;     // pixels from the lower left corner
flat out vec2 size;  // pixels
flat out vec4 fillTint;
flat out vec4 frameTint;

vec2 toPixels(vec4 p) {
    return ((p.xy - centreHigh) + (p.zw - centreLow)) * zoom;
}

void main() {
    vec2 p = toPixels(lower);
    vec2 q = toPixels(upper);
    vec2 corner = vec2(gl_VertexID & 1, (gl_VertexID >> 1) & 1);
    size = q - p;
    inside = corner * size;
    fillTint = fill;
    frameTint = frame;
    gl_Position = vec4(2.0 * mix(p, q, corner) / viewport, 0.0, 1.0);
}
