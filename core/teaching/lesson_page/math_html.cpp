#include "core/teaching/lesson_page/math_html.hpp"

#include <cstddef>

namespace forefront {

namespace {

std::string set(const MathNode &node);

std::string span(const char *style, const std::string &inner) {
    return std::string("<span class=\"") + style + "\">" + inner + "</span>";
}

/// Returns a line drawing that stretches over its box, of 10 by 20.
std::string drawing(const char *style, const char *path) {
    return std::string("<svg class=\"") + style + "\" viewBox=\"0 0 10 20\" preserveAspectRatio=\"none\"><path d=\"" +
           path + "\"/></svg>";
}

std::string symbol(const MathNode &node, bool sign) {
    const std::string text = escapedHtml(node.text);
    if (node.italic) {
        return "<i>" + text + "</i>";
    }
    switch (node.role) {
    case MathRole::Binary:
        return sign ? text : span("mb", text);
    case MathRole::Relation:
        return span("mr", text);
    case MathRole::Comma:
        return span("mc", text);
    case MathRole::Large:
    case MathRole::Integral:
        return span("mo", text);
    default:
        return text;
    }
}

bool isNamed(MathRole role) {
    return role == MathRole::Function || role == MathRole::Limit || role == MathRole::Large ||
           role == MathRole::Integral;
}

std::string row(const MathNode &node) {
    std::string html;
    MathRole before = MathRole::Opening;
    for (const MathNode &part : node.parts) {
        const MathRole role = roleOf(part);
        const bool sign = isSign(role, before);
        const bool brackets = role == MathRole::Opening || role == MathRole::Closing || part.kind == MathKind::Fence;
        const bool joins = role == MathRole::Relation || (role == MathRole::Binary && !sign);
        const bool apart = (isNamed(before) && !brackets && !joins) ||
                           (isNamed(role) && (before == MathRole::Ordinary || before == MathRole::Closing));
        html += apart ? "<span class=\"mt\"></span>" : "";
        html += part.kind == MathKind::Symbol ? symbol(part, sign) : set(part);
        before = sign ? MathRole::Opening : role;
    }
    return html;
}

std::string root(const MathNode &node) {
    const std::string degree = node.parts.size() > 1 ? span("md", set(node.parts[1])) : std::string();
    return degree +
           span("mq", drawing("left", "M.6 12.4L2.3 11.2 5.2 19.4 9.4 .6H10") + span("mk", set(node.parts[0])));
}

std::string fence(const MathNode &node) {
    const auto side = [](const std::string &bracket, const char *style) {
        const char *const path = bracket == "("   ? "M7.5 .5Q2.5 10 7.5 19.5"
                                 : bracket == ")" ? "M2.5 .5Q7.5 10 2.5 19.5"
                                 : bracket == "[" ? "M7.5 .5H3V19.5H7.5"
                                 : bracket == "]" ? "M2.5 .5H7V19.5H2.5"
                                                  : "M5 .5V19.5";
        return bracket.empty() ? std::string() : drawing(style, path);
    };
    const char *const style = node.text.empty() ? "mh right" : node.closing.empty() ? "mh left" : "mh left right";
    return span(style, side(node.text, "left") + set(node.parts[0]) + side(node.closing, "right"));
}

std::string scripts(const MathNode &node) {
    const std::string base = set(node.parts.front());
    const std::string sub = node.sub ? set(node.parts[1]) : std::string(),
                      super = node.super ? set(node.parts.back()) : std::string();
    const MathRole role = roleOf(node);
    if (role == MathRole::Large || role == MathRole::Limit) {
        return span("ml", span("ms", super) + span("mn", base) + span("ms", sub));
    }
    if (node.sub && node.super) {
        return base + span("mp", span("ms", super) + span("ms", sub));
    }
    return base + (node.sub ? "<sub class=\"ms\">" + sub + "</sub>" : "<sup class=\"ms\">" + super + "</sup>");
}

std::string set(const MathNode &node) {
    switch (node.kind) {
    case MathKind::Symbol:
        return symbol(node, false);
    case MathKind::Row:
        return row(node);
    case MathKind::Fraction:
        return span("mf", span("ma", set(node.parts[0])) + span("me", set(node.parts[1])));
    case MathKind::Root:
        return root(node);
    case MathKind::Scripts:
        return scripts(node);
    case MathKind::Overline:
        return span("mv", set(node.parts[0]));
    case MathKind::Fence:
        return fence(node);
    case MathKind::Space:
        return node.room < 0.2   ? "<span class=\"mt\"></span>"
               : node.room < 0.5 ? "<span class=\"mt\"></span><span class=\"mt\"></span>"
                                 : "<span class=\"mw\"></span>";
    }
    return {};
}

} // namespace

std::string escapedHtml(std::string_view text) {
    std::string html;
    for (const char c : text) {
        html += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
    }
    return html;
}

std::string mathHtml(const MathNode &formula, bool display) {
    std::string pieces;
    for (const MathNode &piece : brokenMath(formula)) {
        pieces += (pieces.empty() ? "" : "<wbr>") + span("mx", set(piece));
    }
    return std::string("<span class=\"math") + (display ? " display" : "") + "\" role=\"math\" aria-label=\"" +
           escapedHtml(plainMath(formula)) + "\">" + pieces + "</span>";
}

} // namespace forefront
