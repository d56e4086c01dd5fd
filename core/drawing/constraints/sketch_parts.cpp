#include "core/drawing/constraints/sketch_parts.hpp"

#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/segment_sizes.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/path_curve.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace forefront {
namespace {

PartForm formOfSegment(const Shape &shape, std::uint32_t k) {
    if (k >= taggedSegments(shape)) {
        return PartForm::None;
    }
    return shape.visit(
        [&](const PathForm &path) {
            if (path.curves.empty() || path.curves[k].kind() == CurveKind::Line) {
                return PartForm::Line;
            }
            return path.curves[k].kind() == CurveKind::Cubic ? PartForm::Cubic
                   : radiusOf(path.curves[k])                ? PartForm::Circle
                                                             : PartForm::None;
        },
        [&](const RectangleForm &) { return k < 4 ? PartForm::Line : PartForm::Rounding; },
        [](const CircleForm &) { return PartForm::Circle; }, [](const PointForm &) { return PartForm::None; },
        [](const EllipseForm &) { return PartForm::Ellipse; },
        [&](const SlotForm &) { return k % 2 == 0 ? PartForm::Line : PartForm::Circle; });
}

bool isPointHandle(const Shape &shape, std::uint32_t k) {
    // The point on a circle keeps its direction from the centre; the side of a slot is no point of its own.
    const bool follows = (shape.is<CircleForm>() && k == 1) || (shape.is<SlotForm>() && k == 2);
    return k < handleCount(shape) && !follows;
}

/// The letters of forms in the patterns below.
constexpr std::string_view kLetters = "-PLCREB";

/// The forms that the parts of a constraint can have, in the order of ConstraintKind, and what to tell a user.
struct AcceptedParts {
    std::string_view patterns;
    std::string_view words;
};

constexpr std::array<AcceptedParts, 20> kAccepted = {{
    {"PP", "two points"},
    {"PL PC PE PB", "a point and a line or curve"},
    {"PL PPP", "a point and a line, or three points"},
    {"L PP", "a line or two points"},
    {"L PP", "a line or two points"},
    {"LL", "two lines"},
    {"LL", "two lines"},
    {"LL", "two lines"},
    {"LC CC LE LCPP CCPP LBPP CBPP BBPP", "two curves, or a line and a curve; a Bézier curve at one of its ends"},
    {"LL CC CR RR", "two lines or two circles"},
    {"CC CE EE", "two circles or ellipses"},
    {"PPL PPP", "two points, and a line or point between them"},
    {"P L C", "a point, line or circle"},
    {"PP", "a straight segment or two points"},
    {"PP PL LL", "points or lines, two in all"},
    {"PP", "two points"},
    {"PP", "two points"},
    {"LL", "two lines"},
    {"C R", "a circle"},
    {"C R", "a circle"},
}};

bool hasPattern(std::string_view patterns, const std::string &pattern) {
    const std::string all = ' ' + std::string(patterns) + ' ';
    return all.find(' ' + pattern + ' ') != std::string::npos;
}

} // namespace

PartForm formOfPart(const Document &document, const SketchPart &part) {
    if (part.kind >= SketchPartKind::Origin) {
        return part.kind == SketchPartKind::Origin ? PartForm::Point : PartForm::Line;
    }
    const Shape *const shape = findShape(document, part.shape);
    if (shape == nullptr) {
        return PartForm::None;
    }
    switch (part.kind) {
    case SketchPartKind::Node:
        return isPointHandle(*shape, part.index) ? PartForm::Point : PartForm::None;
    case SketchPartKind::Segment:
        return formOfSegment(*shape, part.index);
    case SketchPartKind::Centre:
        return isPath(*shape) && formOfSegment(*shape, part.index) == PartForm::Circle ? PartForm::Point
                                                                                       : PartForm::None;
    default:
        return formOfSegment(*shape, part.index) == PartForm::Cubic ? PartForm::Point : PartForm::None;
    }
}

std::optional<Vec2> placeOfPart(const Document &document, const SketchPart &part) {
    if (formOfPart(document, part) != PartForm::Point) {
        return std::nullopt;
    }
    if (part.kind == SketchPartKind::Origin) {
        return Vec2{};
    }
    const Shape &shape = *findShape(document, part.shape);
    if (part.kind == SketchPartKind::Node) {
        return handlesOf(shape)[part.index];
    }
    const std::array<double, 8> n = shape.path().curves[part.index].numbers();
    const std::size_t at = part.kind == SketchPartKind::Centre ? 0 : part.kind == SketchPartKind::StartControl ? 2 : 4;
    return Vec2{n[at], n[at + 1]};
}

std::string partsFault(const Document &document, ConstraintKind kind, std::span<const SketchPart> parts) {
    std::string pattern;
    for (const SketchPart &part : parts) {
        const PartForm form = formOfPart(document, part);
        if (form == PartForm::None) {
            return "no part of the drawing that can be constrained is " + toString(part);
        }
        pattern += kLetters[static_cast<std::size_t>(form)];
    }
    const auto same = [&](std::size_t a, std::size_t b) { return b < parts.size() && parts[a] == parts[b]; };
    if (same(0, 1) || (parts.size() == 3 && (same(0, 2) || same(1, 2)))) {
        return "a part is given twice";
    }
    const AcceptedParts &accepted = kAccepted[static_cast<std::size_t>(kind)];
    return hasPattern(accepted.patterns, pattern) ? std::string() : "expected " + std::string(accepted.words);
}

std::vector<SketchPart> inOrder(const Document &document, std::vector<SketchPart> parts) {
    std::stable_sort(parts.begin(), parts.end(), [&](const SketchPart &a, const SketchPart &b) {
        return formOfPart(document, a) < formOfPart(document, b);
    });
    return parts;
}

} // namespace forefront
