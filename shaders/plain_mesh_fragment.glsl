#version 330 core
// Triangles in one colour, with the edges of mesh_fragment. A program of its own, since software rendering computes values,
// colours and contour lines of that one for every pixel, even where they are not used.
in vec3 wall;

uniform vec4 face;
uniform vec4 edge;
uniform float edgeWidth;  // pixels, of the whole edge of a large element
uniform float denseEdges; // opacity of edges too dense to be distinguished
out vec4 result;

void main() {
    vec3 rate = fwidth(wall);
    vec3 pixels = wall / max(rate, vec3(1e-9));
    float nearest = min(min(pixels.x, pixels.y), pixels.z);
    float height = 1.0 / max(max(rate.x, rate.y), rate.z);
    float width = clamp(height / 12.0, min(0.75, edgeWidth), edgeWidth);
    float line = mix(denseEdges, clamp(0.5 * width + 0.5 - nearest, 0.0, 1.0), smoothstep(2.0, 9.0, height));
    float edgeAlpha = edge.a * line;
    float alpha = edgeAlpha + face.a * (1.0 - edgeAlpha);
    vec3 rgb = alpha > 0.0 ? (edge.rgb * edgeAlpha + face.rgb * face.a * (1.0 - edgeAlpha)) / alpha : vec3(0.0);
    result = vec4(rgb, alpha);
}
