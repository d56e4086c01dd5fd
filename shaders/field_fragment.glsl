#version 330 core
// Fills the domain by the node spacing ρ on a logarithmic scale, over one colour. It covers most pixels of the canvas,
// so software rendering gains from texels without filter and a loop of known length.
in vec2 pixel;

uniform sampler2D mask;   // one texel per pixel: coverage of the domain
uniform sampler2D raster; // ln ρ
uniform vec2 rasterCorner; // lower left corner of the raster in pixels
uniform vec2 rasterSize;  // pixels
uniform vec2 range;       // ln ρ at the ends of the map
uniform sampler2D map;    // 256 colours
uniform vec4 plain;
uniform float levels[8];    // ln ρ of the contour lines; unused ones are far from every ρ
uniform float contourWidth; // pixels, at most
uniform float contourGap;   // smallest difference of ln ρ between two contour lines
uniform float opacity;      // of the colours over the plain one

out vec4 result;

// Coverage by the nearest contour line: x of its bright core, y of its dark rim. `slope` is the change of ln ρ per pixel.
// Contour lines are dashed, so that they are not taken for edges of the mesh. Dashes are counted along the axis that a line
// follows more closely, from the corner of the raster, so that they move with the drawing.
vec2 contour(float value, vec2 slope) {
    float change = length(slope);
    float nearest = 1e9;
    for (int i = 0; i < 8; ++i) {
        nearest = min(nearest, abs(value - levels[i]));
    }
    float pixels = change > 1e-7 ? nearest / change : 1e9; // no line where ρ is constant
    // Lines are at most a twelfth of their distance wide.
    float width = clamp(contourGap / max(12.0 * change, 1e-7), min(0.75, contourWidth), contourWidth);
    vec2 place = pixel - rasterCorner;
    float along = abs(slope.y) > abs(slope.x) ? place.x : place.y;
    float dash = step(fract(along / (9.0 * contourWidth)), 0.6);
    return dash * clamp(vec2(0.5, 1.0) * width + 0.5 - pixels, 0.0, 1.0);
}

void main() {
    float inside = texelFetch(mask, ivec2(pixel), 0).r;
    float value = texture(raster, (pixel - rasterCorner) / rasterSize).r;
    vec2 line = contour(value, vec2(dFdx(value), dFdy(value)));
    float span = range.y - range.x;
    float t = clamp((value - range.x) / (abs(span) > 1e-6 ? span : 1e-6), 0.0, 1.0);
    vec3 rgb = texelFetch(map, ivec2(int(t * 255.0 + 0.5), 0), 0).rgb;
    vec3 contoured = mix(mix(rgb, vec3(0.04, 0.06, 0.09), 0.45 * line.y), vec3(1.0), 0.9 * line.x);
    result = vec4(mix(mix(plain.rgb, rgb, opacity), contoured, 0.6 * line.y), plain.a * inside);
}
