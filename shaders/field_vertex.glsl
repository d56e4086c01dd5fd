#version 330 core
// A triangle that covers the viewport.
uniform vec2 viewport;

out vec2 pixel; // from the lower left corner of the viewport

void main() {
    vec2 p = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    pixel = p * viewport;
    gl_Position = vec4(2.0 * p - 1.0, 0.0, 1.0);
}
