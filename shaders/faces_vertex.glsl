#version 330 core
// A triangle that covers the viewport.
uniform vec2 extent; // part of the texture in view, around its middle

out vec2 place; // in the texture

void main() {
    vec2 p = 2.0 * vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) - 1.0;
    place = 0.5 + 0.5 * extent * p;
    gl_Position = vec4(p, 0.0, 1.0);
}
