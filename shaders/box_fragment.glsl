#version 330 core
in vec2 inside;
flat in vec2 size;
flat in vec4 fillTint;
flat in vec4 frameTint;

uniform float frameWidth;

out vec4 result;

void main() {
    vec2 edge = min(inside, size - inside);
    float border = clamp(frameWidth + 0.5 - min(edge.x, edge.y), 0.0, 1.0);
    // Fade the frames of boxes only a few pixels wide; they would hide everything else.
    border *= smoothstep(3.0, 9.0, min(size.x, size.y));
    vec4 over = vec4(frameTint.rgb, frameTint.a * border);
    float alpha = over.a + fillTint.a * (1.0 - over.a);
    vec3 rgb = alpha > 0.0 ? (over.rgb * over.a + fillTint.rgb * fillTint.a * (1.0 - over.a)) / alpha : vec3(0.0);
    result = vec4(rgb, alpha);
}
