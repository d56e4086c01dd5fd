#include "ui/panels/geometry_rows.hpp"

#include "core/drawing/commands/typed_size.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/drawing/formulas/place_formulas.hpp"
#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/part_lengths.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/geometry/path_curve.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/number_field.hpp"
#include "ui/workspace/typed_command.hpp"

#include <imgui.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace forefront {
namespace {

/// Returns the address of a number of a shape.
NumberAddress addressOf(const Shape &shape, Quantity what, std::uint32_t handle = 0) {
    return {NumberOwner::ofShape(shape.id), what, handle};
}

form::PairAddress pairAddress(const Shape &shape, Quantity first, Quantity second) {
    return {addressOf(shape, first), addressOf(shape, second)};
}

SketchPart nodeOf(const Shape &shape, std::uint32_t node) {
    return {shape.id, SketchPartKind::Node, node};
}

SketchPart segmentOf(const Shape &shape, std::uint32_t segment) {
    return {shape.id, SketchPartKind::Segment, segment};
}

TypedSize widthOf(const Shape &rectangle, double width) {
    return {ConstraintKind::HorizontalDistance, {nodeOf(rectangle, 0), nodeOf(rectangle, 1)}, width, "width"};
}

TypedSize heightOf(const Shape &rectangle, double height) {
    return {ConstraintKind::VerticalDistance, {nodeOf(rectangle, 1), nodeOf(rectangle, 2)}, height, "height"};
}

/// Sets the width or the height of a rectangle by one of its sides.
void putSide(Shell &context, const Shape &rectangle, SegmentRef side, double size) {
    const bool across = side.segment % 2 == 0;
    applyTypedSize(context, setSegmentLength(*context.document.current(), side, size),
                   across ? widthOf(rectangle, size) : heightOf(rectangle, size), "Change length");
}

void drawRectangle(Shell &context, const Shape &shape) {
    const auto put = [&](const Shape &next, const char *label) {
        applyTyped(context, replaceShape(*context.document.current(), next), label);
    };
    Shape next = shape;
    const Box2 box = boundsOf(shape);
    Vec2 corner = box.min, size = box.size();
    if (form::pair(context, "inspector/corner", "Corner", corner,
                   pairAddress(shape, Quantity::Left, Quantity::Bottom))) {
        placeBox(next, corner, corner + size);
        put(next, "Move rectangle");
    }
    if (form::pair(context, "inspector/size", "Size", size, pairAddress(shape, Quantity::Width, Quantity::Height))) {
        placeBox(next, corner, corner + size);
        std::vector<TypedSize> sizes;
        if (size.x != box.size().x) {
            sizes.push_back(widthOf(shape, size.x));
        }
        if (size.y != box.size().y) {
            sizes.push_back(heightOf(shape, size.y));
        }
        applyTypedSizes(context, replaceShape(*context.document.current(), next), sizes, "Resize rectangle");
    }
    double radius = shape.as<RectangleForm>().radius;
    if (form::number(context, "inspector/cornerradius", "Corner radius", radius, addressOf(shape, Quantity::Radius))) {
        constexpr std::uint32_t kRounding = 4; // the segments of the corners come after those of the sides
        next.as<RectangleForm>().radius = radius;
        applyTypedSize(context, replaceShape(*context.document.current(), next),
                       {ConstraintKind::Radius, {segmentOf(shape, kRounding)}, radius, "corner radius"},
                       "Round corners");
    }
}

/// Returns the expression of a diameter of which a formula takes the half; empty for other formulas.
std::string diameterIn(std::string_view radius) {
    constexpr std::string_view kHalf = ")/2";
    if (!radius.starts_with('(') || !radius.ends_with(kHalf)) {
        return {};
    }
    const std::string_view inner = radius.substr(1, radius.size() - 1 - kHalf.size());
    int open = 0; // parentheses; "(a)+(b)" is not one expression in parentheses
    for (const char c : inner) {
        open += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (open < 0) {
            return {};
        }
    }
    return std::string(inner);
}

void diameterField(Shell &context, const Shape &circle) {
    const Document &document = *context.document.current();
    const NumberAddress address = addressOf(circle, Quantity::Radius);
    const auto given = document.formulas.find(address);
    std::string formula = given != document.formulas.end() ? diameterIn(given->second) : std::string();
    double diameter = 2.0 * circleRadius(circle);
    ImGui::SameLine(0, context.px(6));
    if (ui::inputExpression(context, "inspector/diameter", diameter, formula, -1.0F, document.unit)) {
        Result<Document> next = setRadius(document, circle.id, 0.5 * diameter);
        if (next) {
            next = setFormula(*std::move(next), address, formula.empty() ? formula : '(' + formula + ")/2");
        }
        applyTypedSize(context, next, {ConstraintKind::Diameter, {segmentOf(circle, 0)}, diameter, "diameter"},
                       "Resize circle", false);
    }
    ui::tooltip(context, "Diameter");
}

void drawCircle(Shell &context, const Shape &shape) {
    const Document &document = *context.document.current();
    Vec2 centre = shape.nodes[0];
    double radius = circleRadius(shape);
    if (form::pair(context, "inspector/centre", "Centre", centre, handleAddress(shape, 0))) {
        applyTyped(context, setHandle(document, {shape.id, 0}, centre), "Move circle", false);
    }
    form::label(context, "Radius, \xe2\x88\x85");
    if (ui::inputNumber(context, "inspector/radius", radius, form::halfWidth(context),
                        addressOf(shape, Quantity::Radius))) {
        applyTypedSize(context, setRadius(document, shape.id, radius),
                       {ConstraintKind::Radius, {segmentOf(shape, 0)}, radius, "radius"}, "Resize circle", false);
    }
    diameterField(context, shape);
}

void drawPoint(Shell &context, const Shape &shape) {
    Vec2 at = shape.nodes[0];
    if (form::pair(context, "inspector/at", "Position", at, handleAddress(shape, 0))) {
        if (applyTyped(context, setHandle(*context.document.current(), {shape.id, 0}, at), "Move point")) {
            context.view.reveal(boxOf(at, at));
        }
    }
}

void drawEllipse(Shell &context, const Shape &shape) {
    const Document &document = *context.document.current();
    Vec2 centre = shape.nodes[0];
    const Vec2 u = shape.nodes[1] - centre, v = shape.nodes[2] - centre;
    if (form::pair(context, "inspector/centre", "Centre", centre, handleAddress(shape, 0))) {
        applyTyped(context, setHandle(document, {shape.id, 0}, centre), "Move ellipse", false);
    }
    Vec2 radii{length(u), length(v)};
    if (form::pair(context, "inspector/radii", "Radii", radii, pairAddress(shape, Quantity::Rx, Quantity::Ry)) &&
        ui::checkPositive(context, "inspector/radii/x", radii.x) &&
        ui::checkPositive(context, "inspector/radii/y", radii.y)) {
        Shape next = shape;
        next.nodes[1] = centre + (radii.x / length(u)) * u;
        next.nodes[2] = centre + (radii.y / length(v)) * v;
        std::vector<TypedSize> sizes;
        for (const auto &[node, typed, now] :
             {std::tuple(1U, radii.x, length(u)), std::tuple(2U, radii.y, length(v))}) {
            if (typed != now) {
                sizes.push_back({ConstraintKind::Distance, {nodeOf(shape, 0), nodeOf(shape, node)}, typed, "radius"});
            }
        }
        applyTypedSizes(context, replaceShape(document, std::move(next)), sizes, "Resize ellipse", false);
    }
}

void drawSlot(Shell &context, const Shape &shape) {
    const Document &document = *context.document.current();
    for (const std::uint32_t k : {0U, 1U}) {
        Vec2 centre = shape.nodes[k];
        if (form::pair(context, k == 0 ? "inspector/centre" : "inspector/centre2", k == 0 ? "Centre 1" : "Centre 2",
                       centre, handleAddress(shape, k))) {
            applyTyped(context, setHandle(document, {shape.id, k}, centre), "Move end of slot", false);
        }
    }
    double size = distance(shape.nodes[0], shape.nodes[1]);
    if (form::number(context, "inspector/slotlength", "Distance", size, addressOf(shape, Quantity::Length)) &&
        ui::checkPositive(context, "inspector/slotlength", size)) {
        applyTypedSize(context, setSegmentLength(document, {shape.id, 0}, size),
                       {ConstraintKind::Distance, {nodeOf(shape, 0), nodeOf(shape, 1)}, size, "distance"},
                       "Change length of slot", false);
    }
    ui::rowTooltip(context, "Distance between the centres of the two ends");
    slotWidthRow(context, shape);
}

/// Shows the formulas that an end of a segment follows, as when its length was typed as an expression.
void drawFollowing(Shell &context, const Shape &shape, std::uint32_t node) {
    const form::PairAddress address = handleAddress(shape, node);
    std::string text;
    for (const auto &[name, place] : {std::pair("x", address.x), std::pair("y", address.y)}) {
        const auto &formulas = context.document.current()->formulas;
        if (const auto found = formulas.find(*place); found != formulas.end()) {
            text += (text.empty() ? "" : ", ") + std::string(name) + " = " + found->second;
        }
    }
    if (!text.empty()) {
        ui::small(context, "Node " + std::to_string(node + 1) + " follows " + text, true);
        ui::mark(context, "inspector/follows");
    }
}

} // namespace

form::PairAddress handleAddress(const Shape &shape, std::uint32_t handle) {
    return {addressOf(shape, Quantity::X, handle), addressOf(shape, Quantity::Y, handle)};
}

void slotWidthRow(Shell &context, const Shape &slot) {
    double width = 2.0 * slot.as<SlotForm>().radius;
    if (form::number(context, "inspector/slotwidth", "Width", width, addressOf(slot, Quantity::Width)) &&
        ui::checkPositive(context, "inspector/slotwidth", width)) {
        Shape next = slot;
        next.as<SlotForm>().radius = 0.5 * width;
        next.cuts.clear();
        constexpr std::uint32_t kEnd = 1; // a round segment
        applyTypedSize(context, replaceShape(*context.document.current(), std::move(next)),
                       {ConstraintKind::Diameter, {segmentOf(slot, kEnd)}, width, "width"}, "Change width of slot",
                       false);
    }
}

void geometryRows(Shell &context, const Shape &shape) {
    shape.visit(
        [&](const PathForm &) { ui::field(context, "Nodes", ui::count(shape.nodes.size()), form::kLabel); },
        [&](const RectangleForm &) { drawRectangle(context, shape); },
        [&](const CircleForm &) { drawCircle(context, shape); }, [&](const PointForm &) { drawPoint(context, shape); },
        [&](const EllipseForm &) { drawEllipse(context, shape); }, [&](const SlotForm &) { drawSlot(context, shape); });
}

void extentRows(Shell &context, const Shape &shape) {
    if (shape.is<PointForm>()) {
        return;
    }
    const std::string unit = unitSuffix(context.document.current()->unit);
    ui::field(context, "Length", ui::grouped(lengthOf(shape)) + unit, form::kLabel);
    if (isClosed(shape)) {
        ui::field(context, "Area", ui::grouped(areaOf(shape)) + (unit.empty() ? "" : unit + "\xc2\xb2"), form::kLabel);
    }
}

namespace {

/// Draws the length of a straight part or of an arc of a rectangle with rounded corners, and the number that sets it.
void roundedSegmentRows(Shell &context, const Shape &shape, SegmentRef ref) {
    const std::string unit = unitSuffix(context.document.current()->unit);
    ui::field(context, "Length", ui::grouped(partLengths(shape)[ref.segment].length) + unit, form::kLabel);
    if (isRoundedCorner(shape, ref.segment)) {
        ui::field(context, "Radius", ui::grouped(shape.as<RectangleForm>().radius) + unit, form::kLabel);
        return;
    }
    const bool across = ref.segment % 2 == 0;
    const Vec2 extent = boundsOf(shape).size();
    double side = across ? extent.x : extent.y;
    if (form::number(context, "inspector/length", across ? "Width" : "Height", side,
                     addressOf(shape, across ? Quantity::Width : Quantity::Height))) {
        putSide(context, shape, ref, side);
    }
}

} // namespace

void segmentRows(Shell &context, const Shape &shape, SegmentRef ref) {
    const Document &document = *context.document.current();
    const Outline outline = outlineOf(shape);
    const bool rectangle = shape.is<RectangleForm>();
    if (rectangle && outline.segmentCount() > 4) {
        roundedSegmentRows(context, shape, ref);
        return;
    }
    if (!rectangle && outline.isCurved(ref.segment)) {
        const Curve curve = outline.curve(ref.segment);
        const std::optional<double> bend = isPath(shape) ? radiusOf(curve) : std::nullopt;
        double radius = bend.value_or(0.0);
        if (bend && form::number(context, "inspector/arcradius", "Radius", radius,
                                 addressOf(shape, Quantity::ArcRadius, ref.segment))) {
            applyTypedSize(context, setArcRadius(document, ref, radius),
                           {ConstraintKind::Radius, {segmentOf(shape, ref.segment)}, radius, "radius"}, "Change radius",
                           false);
        }
        ui::field(context, "Length", ui::grouped(curve.length()) + unitSuffix(document.unit), form::kLabel);
        return;
    }
    const std::vector<Vec2> handles = handlesOf(shape);
    double size = rectangle ? distance(handles[ref.segment], handles[(ref.segment + 1) % handles.size()])
                            : outline.curve(ref.segment).length();
    if (!isPath(shape)) {
        const Quantity number = !rectangle             ? Quantity::Length
                                : ref.segment % 2 == 0 ? Quantity::Width
                                                       : Quantity::Height;
        if (!form::number(context, "inspector/length", "Length", size, addressOf(shape, number))) {
            return;
        }
        if (rectangle) {
            putSide(context, shape, ref, size);
        } else {
            applyTypedSize(context, setSegmentLength(document, ref, size),
                           {ConstraintKind::Distance, {nodeOf(shape, 0), nodeOf(shape, 1)}, size, "length"},
                           "Change length");
        }
        return;
    }
    form::label(context, "Length");
    std::string formula;
    if (ui::inputExpression(context, "inspector/length", size, formula, -1.0F, document.unit)) {
        Result<Document> next = setSegmentLength(document, ref, size);
        if (next) {
            next = followLength(*std::move(next), ref, formula);
        }
        applyTypedSize(context, next,
                       {ConstraintKind::Length,
                        {segmentOf(shape, ref.segment)},
                        size,
                        "length",
                        [&](Document held) { return followLength(std::move(held), ref, formula); }},
                       "Change length");
        return;
    }
    drawFollowing(context, shape, static_cast<std::uint32_t>((ref.segment + 1) % handles.size()));
}

} // namespace forefront
