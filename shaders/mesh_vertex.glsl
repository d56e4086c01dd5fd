#version 330 core
// Triangles without an index: the corner of a vertex is gl_VertexID % 3, which gives barycentric coordinates for free.
layout(location = 0) in vec2 place; // relative to the origin of the chunk
layout(location = 1) in float value;

uniform vec2 offset; // pixels from the middle of the viewport to the origin of the chunk
uniform float zoom;
uniform vec2 viewport;

out vec3 corner;
flat out float shade;

void main() {
    int k = gl_VertexID % 3;
    corner = vec3(k == 0, k == 1, k == 2);
    shade = value;
    gl_Position = vec4(2.0 * (offset + place * zoom) / viewport, 0.0, 1.0);
}
