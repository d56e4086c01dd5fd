#version 330 core
// A rectangle, which may be turned, drawn as a strip of two triangles.
uniform vec2 origin; // lower left corner in pixels from the middle of the viewport, y up
uniform vec2 right;  // from there to the lower right corner
uniform vec2 up;     // and to the upper left one
uniform vec2 viewport;

out vec2 place; // in the picture, from its upper left corner

void main() {
    vec2 corner = vec2(gl_VertexID & 1, (gl_VertexID >> 1) & 1);
    place = vec2(corner.x, 1.0 - corner.y);
    gl_Position = vec4(2.0 * (origin + corner.x * right + corner.y * up) / viewport, 0.0, 1.0);
}
