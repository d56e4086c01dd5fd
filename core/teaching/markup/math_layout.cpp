#include "core/teaching/markup/math_layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

namespace forefront {

namespace {

// Measures in ems, after those of TeX.
constexpr double kThickness = 0.06; ///< of strokes
constexpr double kBinaryRoom = 0.22, kRelationRoom = 0.28, kThinRoom = 0.17;
constexpr double kClearance = 0.12; ///< between a stroke and what it belongs to
constexpr double kSidePad = 0.08;   ///< beside the bar of a fraction
constexpr double kLargeScale = 1.5; ///< of ∑, ∏ and ∫

/// Adds a layout to another, moved.
void add(MathLayout &to, MathLayout part, Vec2 by) {
    for (MathText &text : part.texts) {
        text.at = text.at + by;
        to.texts.push_back(std::move(text));
    }
    for (MathStroke &stroke : part.strokes) {
        for (Vec2 &point : stroke.points) {
            point = point + by;
        }
        to.strokes.push_back(std::move(stroke));
    }
    to.extent.ascent = std::max(to.extent.ascent, part.extent.ascent - by.y);
    to.extent.descent = std::max(to.extent.descent, part.extent.descent + by.y);
}

bool isLimited(MathRole role) {
    return role == MathRole::Large || role == MathRole::Limit;
}

/// Sets the parts of a formula at a level.
class MathSetter {
  public:
    explicit MathSetter(const MathFont &font) : font_(font) {}

    MathLayout set(const MathNode &node, int level, bool display) const {
        switch (node.kind) {
        case MathKind::Symbol:
            return symbol(node, level);
        case MathKind::Row:
            return row(node, level, display);
        case MathKind::Fraction:
            return fraction(node, level, display);
        case MathKind::Root:
            return root(node, level, display);
        case MathKind::Scripts:
            return isLimited(roleOf(node)) ? limits(node, level) : scripts(node, level, display);
        case MathKind::Overline:
            return overline(node, level, display);
        case MathKind::Fence:
            return fence(node, level, display);
        case MathKind::Space:
            break;
        }
        MathLayout space;
        space.extent.width = node.room * font_.em(level);
        return space;
    }

    double thickness() const { return std::max(1.0, kThickness * font_.em(0)); }

  private:
    /// Returns the height of the axis, in the middle of +, above the baseline.
    double axis(int level) const {
        const MathExtent plus = font_.extentOf("+", false, level);
        return 0.5 * (plus.ascent - plus.descent);
    }

    double clearance(int level) const { return kClearance * font_.em(level) + 0.5 * thickness(); }

    MathLayout symbol(const MathNode &node, int level) const {
        const bool large = node.role == MathRole::Large || node.role == MathRole::Integral;
        const double scale = large ? kLargeScale : 1.0;
        MathExtent extent = font_.extentOf(node.text, node.italic, level);
        extent = {scale * extent.width, scale * extent.ascent, scale * extent.descent};
        // Large operators are centred on the axis.
        const double down = large ? 0.5 * (extent.ascent - extent.descent) - axis(level) : 0.0;
        MathLayout set;
        set.texts.push_back({Vec2{0.0, down}, node.text, node.italic, level, scale, extent});
        set.extent = {extent.width, extent.ascent - down, extent.descent + down};
        return set;
    }

    /// Returns the room between neighbours, in ems.
    static double roomBetween(MathRole left, MathRole right, int level) {
        using enum MathRole;
        const auto isNamed = [](MathRole role) { return role == Function || role == Large || role == Limit; };
        const double shrink = level == 0 ? 1.0 : 0.35;
        if (left == Relation && right == Relation) {
            return 0.0; // such as :=
        }
        if (left == Relation || right == Relation) {
            return shrink * kRelationRoom;
        }
        if (left == Binary || right == Binary) {
            return shrink * kBinaryRoom;
        }
        if (left == Comma) {
            return shrink * kThinRoom;
        }
        if (isNamed(left) || left == Integral) {
            return right == Opening || right == Closing ? 0.0 : kThinRoom;
        }
        return (isNamed(right) || right == Integral) && left != Opening ? kThinRoom : 0.0;
    }

    MathLayout row(const MathNode &node, int level, bool display) const {
        MathLayout set;
        set.extent = {0.0, -1e30, -1e30};
        MathRole before = MathRole::Opening;
        for (std::size_t k = 0; k < node.parts.size(); ++k) {
            const MathNode &part = node.parts[k];
            MathRole role = roleOf(part);
            const bool sign = isSign(role, before);
            role = sign ? MathRole::Ordinary : role;
            set.extent.width += k == 0 ? 0.0 : roomBetween(before, role, level) * font_.em(level);
            MathLayout part_ = this->set(part, level, display);
            const double width = part_.extent.width;
            add(set, std::move(part_), Vec2{set.extent.width, 0.0});
            set.extent.width += width;
            // Nothing comes between a sign and what it belongs to, as after an opening bracket.
            before = sign ? MathRole::Opening : role;
        }
        return set.extent.ascent < -1e29 ? MathLayout() : set;
    }

    MathLayout fraction(const MathNode &node, int level, bool display) const {
        const int inner = display ? level : 1;
        MathLayout above = set(node.parts[0], inner, false), below = set(node.parts[1], inner, false);
        const double em = font_.em(level), width = std::max(above.extent.width, below.extent.width) + 0.3 * em;
        const double bar = -axis(level), left = kSidePad * em;
        MathLayout set;
        set.extent = {width + 2.0 * left, -bar, bar};
        set.strokes.push_back({{Vec2{left, bar}, Vec2{left + width, bar}}});
        const Vec2 up{left + 0.5 * (width - above.extent.width), bar - clearance(inner) - above.extent.descent};
        const Vec2 down{left + 0.5 * (width - below.extent.width), bar + clearance(inner) + below.extent.ascent};
        add(set, std::move(above), up);
        add(set, std::move(below), down);
        return set;
    }

    MathLayout overline(const MathNode &node, int level, bool display) const {
        MathLayout set = this->set(node.parts[0], level, display);
        const double line = -set.extent.ascent - clearance(level);
        set.strokes.push_back({{Vec2{0.0, line}, Vec2{set.extent.width, line}}});
        set.extent.ascent = -line + 0.5 * thickness();
        return set;
    }

    MathLayout root(const MathNode &node, int level, bool display) const {
        MathLayout below = set(node.parts[0], level, display);
        const double em = font_.em(level), line = -below.extent.ascent - clearance(level);
        const double foot = below.extent.descent + 0.5 * thickness(), height = foot - line;
        MathLayout set;
        double left = 0.0;
        if (node.parts.size() > 1) {
            MathLayout degree = this->set(node.parts[1], 1, false);
            left = std::max(0.0, degree.extent.width - 0.2 * em);
            const double up = foot - 0.55 * height - degree.extent.descent - 0.5 * thickness();
            add(set, std::move(degree), Vec2{0.0, up});
        }
        const double hook = foot - std::min(0.45 * height, 0.45 * em), body = left + 0.62 * em;
        const double width = below.extent.width + 0.1 * em;
        set.strokes.push_back({{Vec2{left + 0.04 * em, hook + 0.06 * em}, Vec2{left + 0.14 * em, hook},
                                Vec2{left + 0.32 * em, foot}, Vec2{body - 0.06 * em, line}, Vec2{body + width, line}}});
        set.extent.ascent = std::max(set.extent.ascent, -line + 0.5 * thickness());
        set.extent.descent = std::max(set.extent.descent, foot + 0.5 * thickness());
        set.extent.width = body + width + 0.04 * em;
        add(set, std::move(below), Vec2{body, 0.0});
        return set;
    }

    /// Sets an index below and an exponent above the right end of their base.
    MathLayout scripts(const MathNode &node, int level, bool display) const {
        MathLayout base = set(node.parts[0], level, display);
        const double em = font_.em(level);
        const MathExtent around = base.extent;
        const double x = around.width + 0.04 * em;
        MathLayout set = std::move(base);
        double below = 1e30; // where an index begins
        if (node.sub) {
            MathLayout sub = this->set(node.parts[1], 1, false);
            const double down = std::max({0.2 * em, around.descent + 0.1 * em, sub.extent.ascent - 0.36 * em});
            below = down - sub.extent.ascent;
            set.extent.width = x + sub.extent.width;
            add(set, std::move(sub), Vec2{x, down});
        }
        if (node.super) {
            MathLayout super = this->set(node.parts.back(), 1, false);
            double up = std::max({0.36 * em, around.ascent - 0.42 * em, super.extent.descent + 0.3 * em});
            up = std::max(up, super.extent.descent + thickness() - std::min(below, 1e6));
            set.extent.width = std::max(set.extent.width, x + super.extent.width);
            add(set, std::move(super), Vec2{x, -up});
        }
        set.extent.width += 0.06 * em; // so that a comma after them is not part of them
        return set;
    }

    /// Sets limits below and above the middle of their operator.
    MathLayout limits(const MathNode &node, int level) const {
        MathLayout base = set(node.parts[0], level, false);
        const MathExtent around = base.extent;
        const double gap = kClearance * font_.em(level);
        double width = around.width;
        std::array<MathLayout, 2> scripts; // below and above
        for (std::size_t k = 0; k < 2; ++k) {
            if (k == 0 ? node.sub : node.super) {
                scripts[k] = set(k == 0 ? node.parts[1] : node.parts.back(), 1, false);
                width = std::max(width, scripts[k].extent.width);
            }
        }
        MathLayout set;
        set.extent = {width, around.ascent, around.descent};
        add(set, std::move(base), Vec2{0.5 * (width - around.width), 0.0});
        const auto middle = [&](const MathLayout &part) { return 0.5 * (width - part.extent.width); };
        if (node.sub) {
            const Vec2 at{middle(scripts[0]), around.descent + gap + scripts[0].extent.ascent};
            add(set, std::move(scripts[0]), at);
        }
        if (node.super) {
            const Vec2 at{middle(scripts[1]), -around.ascent - gap - scripts[1].extent.descent};
            add(set, std::move(scripts[1]), at);
        }
        return set;
    }

    /// Sets brackets as high as what is between them.
    MathLayout fence(const MathNode &node, int level, bool display) const {
        MathLayout inner = set(node.parts[0], level, display);
        const double em = font_.em(level), pad = 0.06 * em;
        const MathExtent bracket = font_.extentOf("(", false, level);
        // As far above the axis as below it.
        const double middle = axis(level), half = std::max({inner.extent.ascent - middle, inner.extent.descent + middle,
                                                            bracket.ascent - middle, bracket.descent + middle});
        const double width = 0.34 * em, body = node.text.empty() ? 0.0 : width + pad;
        MathLayout set;
        set.extent = {body + inner.extent.width, middle + half, half - middle};
        side(set, node.text, 0.0, width, -middle, half);
        add(set, std::move(inner), Vec2{body, 0.0});
        if (!node.closing.empty()) {
            side(set, node.closing, set.extent.width + pad, width, -middle, half);
            set.extent.width += pad + width;
        }
        return set;
    }

    /// Draws a bracket from `x` on, `half` above and below `middle`.
    static void side(MathLayout &to, const std::string &bracket, double x, double width, double middle, double half) {
        const double top = middle - half, foot = middle + half;
        const double left = x + 0.25 * width, right = x + 0.75 * width;
        if (bracket == "|") {
            to.strokes.push_back({{Vec2{x + 0.5 * width, top}, Vec2{x + 0.5 * width, foot}}});
        } else if (bracket == "[") {
            to.strokes.push_back({{Vec2{right, top}, Vec2{left, top}, Vec2{left, foot}, Vec2{right, foot}}});
        } else if (bracket == "]") {
            to.strokes.push_back({{Vec2{left, top}, Vec2{right, top}, Vec2{right, foot}, Vec2{left, foot}}});
        } else if (!bracket.empty()) {
            constexpr int kPieces = 12;
            const bool opens = bracket == "(";
            MathStroke arc;
            for (int k = 0; k <= kPieces; ++k) {
                const double t = 2.0 * k / kPieces - 1.0, bulge = (1.0 - t * t) * (right - left);
                arc.points.push_back({opens ? right - bulge : left + bulge, middle + t * half});
            }
            to.strokes.push_back(std::move(arc));
        }
    }

    const MathFont &font_;
};

} // namespace

MathLayout layoutMath(const MathNode &formula, const MathFont &font, bool display) {
    const MathSetter setter(font);
    MathLayout set = setter.set(formula, 0, display);
    set.thickness = setter.thickness();
    return set;
}

} // namespace forefront
