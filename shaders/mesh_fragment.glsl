#version 330 core
in vec3 corner;
in vec3 wall;
flat in vec3 shades;      // values of the element (three times), of its edges, or of its nodes

uniform vec4 face;        // of elements not coloured by a value
uniform vec4 edge;
uniform float edgeWidth;  // pixels, of the whole edge of a large element
uniform int coloured;     // 1: by value and map
uniform int part;         // that has values: 0 elements, 1 edges, 2 nodes, 3 nodes with contour lines between them
uniform int cyclic;       // 1: the map repeats every eight values
uniform sampler2D map;    // colours, and those of edges over them
uniform vec2 range;       // values at the ends of the map
uniform float denseEdges; // opacity of edges too dense to be distinguished
uniform float badBelow;   // parts below are hatched
uniform float badAbove;   // parts above are hatched
uniform vec4 hatch;
uniform vec2 isolate;     // values shown alone; x > y: all
out vec4 result;

// The value of the element, of the nearest edge (k joins the corners k and k + 1), or of the nearest node.
float valueHere() {
    if (part == 1) {
        return wall.z <= min(wall.x, wall.y) ? shades.x : wall.x <= wall.y ? shades.y : shades.z;
    }
    if (part == 2) {
        return corner.x >= max(corner.y, corner.z) ? shades.x : corner.y >= corner.z ? shades.y : shades.z;
    }
    return part == 3 ? dot(corner, shades) : shades.x;
}

// The opacity of the contour lines, ten over the range of the map.
float contourHere(float t) {
    float at = 10.0 * t;
    float width = fwidth(at);
    float apart = abs(fract(at + 0.5) - 0.5) / max(width, 1e-6);
    float thick = clamp(1.0 / max(12.0 * width, 1e-6), min(0.75, edgeWidth), 1.6 * edgeWidth);
    return part == 3 && width < 0.5 ? 0.75 * clamp(0.5 * thick + 0.5 - apart, 0.0, 1.0) : 0.0;
}

void main() {
    float shade = valueHere();
    bool known = shade > -9e29;
    vec3 rate = fwidth(corner);
    vec3 pixels = wall / max(rate, vec3(1e-9));
    float nearest = min(min(pixels.x, pixels.y), pixels.z);
    // Edges get thinner with their triangles. Those of triangles only a few pixels high fade into an even tone, which
    // covers as much as the edges of somewhat larger ones, so that the finest part never looks empty.
    float height = 1.0 / max(max(rate.x, rate.y), rate.z);
    float width = clamp(height / 12.0, min(0.75, edgeWidth), edgeWidth);
    float line = mix(denseEdges, clamp(0.5 * width + 0.5 - nearest, 0.0, 1.0), smoothstep(2.0, 9.0, height));
    float t = clamp((shade - range.x) / (range.y - range.x), 0.0, 1.0);
    float contour = contourHere((shade - range.x) / (range.y - range.x));
    t = cyclic == 1 ? (mod(shade - 1.0, 8.0) + 0.5) / 8.0 : t;
    int texel = int(t * 255.0 + 0.5); // software rendering gains from texels without filter
    bool mapped = coloured == 1 && known;
    vec4 fill = mapped ? vec4(texelFetch(map, ivec2(texel, 0), 0).rgb, 1.0) : face;
    vec4 ink = mapped && edge.a > 0.0 ? vec4(texelFetch(map, ivec2(texel, 1), 0).rgb, 1.0) : edge;
    fill.rgb = mapped ? mix(fill.rgb, vec3(0.04, 0.06, 0.09), contour) : fill.rgb;
    if (mapped && (shade < badBelow || shade > badAbove)) {
        float stripe = abs(fract((gl_FragCoord.x + gl_FragCoord.y) / 7.0) - 0.5) * 7.0;
        fill = mix(fill, vec4(hatch.rgb, 1.0), hatch.a * clamp(1.75 - stripe, 0.0, 1.0));
    }
    if (isolate.x <= isolate.y && (shade < isolate.x || shade >= isolate.y)) {
        fill.a *= 0.10;
        line *= 0.25;
    }
    float edgeAlpha = ink.a * line;
    float alpha = edgeAlpha + fill.a * (1.0 - edgeAlpha);
    vec3 rgb = alpha > 0.0 ? (ink.rgb * edgeAlpha + fill.rgb * fill.a * (1.0 - edgeAlpha)) / alpha : vec3(0.0);
    result = vec4(rgb, alpha);
}
