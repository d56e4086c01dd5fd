#version 330 core
in vec2 local;
flat in float span;
flat in vec4 tint;

uniform float width;
uniform float arrow;

out vec4 result;

void main() {
    float beyond = max(max(-local.x, local.x - span), 0.0);
    float distance = length(vec2(beyond, local.y));
    float cover = clamp(0.5 * width + 0.5 - distance, 0.0, 1.0);
    if (arrow > 0.0 && span > 3.0 * arrow) {
        float u = local.x - 0.5 * span + 0.5 * arrow; // 0 at the base of the head, arrow at its tip
        float halfHeight = 0.5 * (arrow - u);
        float head = clamp(halfHeight - abs(local.y) + 0.5, 0.0, 1.0) * clamp(u + 0.5, 0.0, 1.0);
        cover = max(cover, head);
    }
    result = vec4(tint.rgb, tint.a * cover);
}
