#version 330 core
// Fills the domain with one colour, or by the node spacing ρ on a logarithmic scale.
in vec2 pixel;

uniform vec2 viewport;
uniform sampler2D mask;   // one texel per pixel: coverage of the domain
uniform sampler2D raster; // ln ρ
uniform vec2 rasterCorner; // lower left corner of the raster in pixels
uniform vec2 rasterSize;  // pixels
uniform vec2 range;       // ln ρ at the ends of the map
uniform sampler2D map;
uniform vec4 plain;
uniform int tinted; // 1: coloured by ρ, 0: plain

out vec4 result;

void main() {
    float inside = texture(mask, pixel / viewport).r;
    vec3 rgb = plain.rgb;
    if (tinted == 1) {
        float value = texture(raster, (pixel - rasterCorner) / rasterSize).r;
        float span = range.y - range.x;
        float t = clamp((value - range.x) / (abs(span) > 1e-6 ? span : 1e-6), 0.0, 1.0);
        rgb = texture(map, vec2(t * (255.0 / 256.0) + 0.5 / 256.0, 0.5)).rgb;
    }
    result = vec4(rgb, plain.a * inside);
}
