#version 330 core
// One instanced quad per segment; places are split doubles (high x, high y, low x, low y).
layout(location = 0) in vec4 a;
layout(location = 1) in vec4 b;
layout(location = 2) in vec4 colour;

uniform vec2 centreHigh;
uniform vec2 centreLow;
uniform float zoom;
uniform vec2 viewport;
uniform float width;
uniform float arrow;

out vec2 local;        // along and across the segment, pixels; positive across is left
flat out float span;   // length of the segment, pixels
flat out vec4 tint;

vec2 toPixels(vec4 p) {
    return ((p.xy - centreHigh) + (p.zw - centreLow)) * zoom;
}

void main() {
    vec2 p = toPixels(a);
    vec2 q = toPixels(b);
    vec2 d = q - p;
    span = length(d);
    vec2 along = span > 1e-6 ? d / span : vec2(1.0, 0.0);
    vec2 left = vec2(-along.y, along.x);
    float margin = 0.5 * width + 1.0;
    float reach = max(margin, arrow > 0.0 && span > 3.0 * arrow ? 0.5 * arrow + 1.0 : 0.0);
    float u = (gl_VertexID & 1) == 0 ? -margin : span + margin;
    float v = (gl_VertexID & 2) == 0 ? -reach : reach;
    local = vec2(u, v);
    tint = colour;
    vec2 pixel = p + along * u + left * v;
    gl_Position = vec4(2.0 * pixel / viewport, 0.0, 1.0);
}
