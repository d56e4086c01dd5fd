#include "core/teaching/markup/math.hpp"

#include <cstddef>
#include <utility>

namespace forefront {

namespace {

/// Returns true if a part reads as one thing without brackets.
bool isSimple(const MathNode &node) {
    return node.kind == MathKind::Row ? node.parts.size() == 1 && isSimple(node.parts.front())
                                      : node.kind != MathKind::Fraction;
}

std::string inBrackets(const MathNode &node) {
    const std::string inner = plainMath(node);
    return isSimple(node) ? inner : '(' + inner + ')';
}

/// Returns what is below a root, in brackets unless it is a single symbol.
std::string plainRadicand(const MathNode &node) {
    const std::string inner = plainMath(node);
    const MathNode &only = node.kind == MathKind::Row && node.parts.size() == 1 ? node.parts.front() : node;
    return only.kind == MathKind::Symbol ? inner : '(' + inner + ')';
}

std::string plainRow(const MathNode &row) {
    std::string text;
    MathRole before = MathRole::Opening;
    for (const MathNode &part : row.parts) {
        const MathRole role = roleOf(part);
        const bool sign = isSign(role, before);
        const bool apart = role == MathRole::Relation || (role == MathRole::Binary && !sign);
        const bool named = before == MathRole::Function || before == MathRole::Limit || before == MathRole::Large ||
                           before == MathRole::Integral || before == MathRole::Comma;
        const bool blank = apart || (named && role != MathRole::Opening && part.kind != MathKind::Fence);
        text += blank && !text.empty() && text.back() != ' ' ? " " : "";
        text += plainMath(part);
        text += apart ? " " : "";
        before = sign ? MathRole::Opening : role;
    }
    return text;
}

std::string plainScripts(const MathNode &node) {
    std::string text = inBrackets(node.parts.front());
    if (node.sub) {
        text += '_' + inBrackets(node.parts[1]);
    }
    if (node.super) {
        text += '^' + inBrackets(node.parts.back());
    }
    return text;
}

} // namespace

MathRole roleOf(const MathNode &node) {
    return node.kind == MathKind::Symbol    ? node.role
           : node.kind == MathKind::Scripts ? roleOf(node.parts.front())
                                            : MathRole::Ordinary;
}

bool isSign(MathRole role, MathRole before) {
    return role == MathRole::Binary && before != MathRole::Ordinary && before != MathRole::Closing;
}

std::vector<MathNode> partsOf(const MathNode &formula) {
    return formula.kind == MathKind::Row ? formula.parts : std::vector<MathNode>{formula};
}

std::vector<MathNode> brokenMath(const MathNode &formula) {
    std::vector<MathNode> pieces(1);
    MathRole before = MathRole::Opening;
    int depth = 0;
    for (MathNode &part : partsOf(formula)) {
        const MathRole role = roleOf(part);
        depth += role == MathRole::Opening ? 1 : role == MathRole::Closing ? -1 : 0;
        const bool sign = isSign(role, before);
        const bool breaks = depth <= 0 && (role == MathRole::Relation || (role == MathRole::Binary && !sign));
        pieces.back().parts.push_back(std::move(part));
        if (breaks) {
            pieces.emplace_back();
        }
        before = sign ? MathRole::Opening : role;
    }
    if (pieces.back().parts.empty()) {
        pieces.pop_back();
    }
    return pieces;
}

std::string plainMath(const MathNode &node) {
    switch (node.kind) {
    case MathKind::Symbol:
        return node.text;
    case MathKind::Row:
        return plainRow(node);
    case MathKind::Fraction:
        return inBrackets(node.parts[0]) + '/' + inBrackets(node.parts[1]);
    case MathKind::Root:
        return (node.parts.size() > 1 ? plainMath(node.parts[1]) : std::string()) + "√" + plainRadicand(node.parts[0]);
    case MathKind::Scripts:
        return plainScripts(node);
    case MathKind::Overline:
        return plainMath(node.parts[0]);
    case MathKind::Fence:
        return node.text + plainMath(node.parts[0]) + node.closing;
    case MathKind::Space:
        return " ";
    }
    return {};
}

} // namespace forefront
