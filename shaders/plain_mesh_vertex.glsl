#version 330 core
// Triangles in one colour; otherwise as mesh_vertex.
layout(location = 0) in vec2 place; // relative to the origin of the chunk
layout(location = 4) in float edges; // bit k: edge k, which joins the corners k and k + 1, is drawn

uniform vec2 offset; // pixels from the middle of the viewport to the origin of the chunk
uniform float zoom;
uniform vec2 viewport;

out vec3 wall; // barycentric; beyond reach where the edge opposite is not drawn

void main() {
    int k = gl_VertexID % 3;
    ivec3 drawn = (ivec3(int(edges + 0.5)) >> ivec3(1, 2, 0)) & 1; // of the edges opposite the corners
    wall = vec3(k == 0, k == 1, k == 2) + 2.0 * vec3(1 - drawn);
    gl_Position = vec4(2.0 * (offset + place * zoom) / viewport, 0.0, 1.0);
}
