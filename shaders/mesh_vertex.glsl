#version 330 core
// Triangles without an index: the corner of a vertex is gl_VertexID % 3, which gives barycentric coordinates for free.
layout(location = 0) in vec2 place; // relative to the origin of the chunk
layout(location = 1) in float first; // values of the three corners, valid at the last vertex
layout(location = 2) in float second;
layout(location = 3) in float third;
layout(location = 4) in float edges; // bit k: edge k, which joins the corners k and k + 1, is drawn

uniform vec2 offset; // pixels from the middle of the viewport to the origin of the chunk
uniform float zoom;
uniform vec2 viewport;

out vec3 corner;
out vec3 wall; // as corner; beyond reach where the edge opposite is not drawn
flat out vec3 shades; // of the last vertex

void main() {
    int k = gl_VertexID % 3;
    corner = vec3(k == 0, k == 1, k == 2);
    ivec3 drawn = (ivec3(int(edges + 0.5)) >> ivec3(1, 2, 0)) & 1; // of the edges opposite the corners
    wall = corner + 2.0 * vec3(1 - drawn);
    shades = vec3(first, second, third);
    gl_Position = vec4(2.0 * (offset + place * zoom) / viewport, 0.0, 1.0);
}
