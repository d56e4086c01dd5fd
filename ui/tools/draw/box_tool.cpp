#include "ui/tools/draw/box_tool.hpp"

#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/base/number_text.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/parts/shell.hpp"
#include "ui/tools/common/tool_options.hpp"
#include "ui/widgets/parse_number.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/relation_options.hpp"

#include <array>
#include <cmath>

namespace forefront {

namespace {

/// The differences between the shapes.
struct BoxKind {
    const char *id, *name, *icon;
    int key;
    const char *label; ///< of the edit
};

const BoxKind &kindOf(ShapeKind shape) {
    static constexpr BoxKind kRectangle{"rectangle", "Rectangle", icon::kRectangle, 'R', "Draw rectangle"};
    static constexpr BoxKind kCircle{"circle", "Circle", icon::kCircle, 'C', "Draw circle"};
    static constexpr BoxKind kEllipse{"ellipse", "Ellipse", icon::kEllipse, 'K', "Draw ellipse"};
    return shape == ShapeKind::Rectangle ? kRectangle : shape == ShapeKind::Ellipse ? kEllipse : kCircle;
}

} // namespace

const char *BoxTool::id() const {
    return kindOf(kind_).id;
}

const char *BoxTool::name() const {
    return kindOf(kind_).name;
}

const char *BoxTool::icon() const {
    return kindOf(kind_).icon;
}

int BoxTool::key() const {
    return kindOf(kind_).key;
}

void BoxTool::forget(Shell &context) {
    DrawingTool::forget(context);
    radius_ = 0.0;
    radiusFormula_.clear();
}

Vec2 BoxTool::corner(Vec2 at) const {
    return isBox() && first_ ? cornerOfBox(*first_, at) : at;
}

std::span<const EntryField> BoxTool::entryFields() const {
    static constexpr std::array kSize{EntryField::Width, EntryField::Height};
    static constexpr std::array kRadius{EntryField::Radius};
    if (!first_) {
        return DrawingTool::entryFields();
    }
    return isBox() ? std::span<const EntryField>(kSize) : std::span<const EntryField>(kRadius);
}

Vec2 BoxTool::typedPlace(const TypedPair &pair) const {
    // A pair typed after the first corner is width and height; for a circle it is a point in absolute coordinates.
    return first_ && (pair.relative || isBox()) ? *first_ + pair.value : pair.value;
}

void BoxTool::place(Vec2 at, Shell &context) {
    if (!first_) {
        first_ = at;
        return;
    }
    const std::optional<double> radius = entry_.value(EntryField::Radius);
    const bool typed = kind_ == ShapeKind::Circle && radius;
    // The nodes of a circle begin at its second point: of a typed one not where the pointer happens to be.
    const Vec2 second = typed ? *first_ + Vec2{*radius, 0.0} : corner(at);
    if (*first_ == second) {
        return; // second click of a double-click
    }
    commitShape(context, shapeTo(second), kindOf(kind_).label);
    first_.reset();
}

std::string_view BoxTool::goal() const {
    if (first_) {
        return kind_ == ShapeKind::Circle    ? "draw the circle"
               : kind_ == ShapeKind::Ellipse ? "draw the ellipse"
                                             : "draw the rectangle";
    }
    return kind_ == ShapeKind::Circle ? "place the centre" : "place the first corner";
}

std::string BoxTool::typedSize(bool across) const {
    const std::optional<TypedPair> pair = entry_.pair();
    const EntryField field = across ? EntryField::Width : EntryField::Height;
    const std::string text = pair ? (across ? pair->xText : pair->yText) : entry_.expression(field);
    // Plain numbers need no formula. A negative one was typed to go to the left or down.
    if (text.empty() || parseNumber(text)) {
        return {};
    }
    const double value = pair ? (across ? pair->value.x : pair->value.y) : entry_.value(field).value_or(0.0);
    return value < 0.0 ? "-(" + text + ")" : text;
}

PlaceFormula BoxTool::typedFormula(Vec2 at) const {
    return first_ && isBox() ? PlaceFormula{} : DrawingTool::typedFormula(at); // see cornerFormula()
}

PlaceFormula BoxTool::cornerFormula() const {
    if (const std::optional<TypedPair> pair = entry_.pair()) {
        const PlaceFormula from = formulaOf(*first_);
        return {sumFormula(from.x, pair->xText), sumFormula(from.y, pair->yText)};
    }
    const auto place = [&](EntryField coordinate, EntryField extent, const std::string &from) {
        const std::string typed = entry_.expression(coordinate), size = entry_.expression(extent);
        return typed.empty() && !size.empty() ? sumFormula(from, size) : typed;
    };
    const PlaceFormula from = formulaOf(*first_);
    return {place(EntryField::X, EntryField::Width, from.x), place(EntryField::Y, EntryField::Height, from.y)};
}

BoxTool::Side BoxTool::sideOf(bool across, Vec2 second) const {
    const auto part = [across](Vec2 p) { return across ? p.x : p.y; };
    const auto partOf = [across](const PlaceFormula &place) { return across ? place.x : place.y; };
    Side side{part(*first_),           part(second),      partOf(formulaOf(*first_)),
              partOf(cornerFormula()), typedSize(across), false};
    side.placed = side.size.empty() && usesNames(entry_.expression(across ? EntryField::X : EntryField::Y));
    if (side.toText.empty()) {
        side.toText = sumFormula(side.fromText, exactText(side.to - side.from));
    }
    return side;
}

void BoxTool::keepFormulas(const Shape &drawn, const Keep &keep) const {
    if (!isBox()) {
        DrawingTool::keepFormulas(drawn, keep);
        keep(Quantity::Radius, 0, entry_.expression(EntryField::Radius));
        return;
    }
    const Vec2 second = kind_ == ShapeKind::Ellipse ? 2.0 * drawn.nodes[0] - *first_ : drawn.nodes[1];
    const auto named = [](const std::string &text) { return usesNames(text) ? text : std::string(); };
    for (const bool across : {true, false}) {
        const Side side = sideOf(across, second);
        const bool back = side.to < side.from;
        const std::string &low = back ? side.toText : side.fromText, &high = back ? side.fromText : side.toText;
        const std::string size = side.placed ? named(differenceFormula(high, low)) : side.size;
        if (kind_ == ShapeKind::Rectangle) {
            keep(across ? Quantity::Left : Quantity::Bottom, 0, named(low));
            keep(across ? Quantity::Width : Quantity::Height, 0, size);
            continue;
        }
        keep(across ? Quantity::Rx : Quantity::Ry, 0, size.empty() ? size : "(" + size + ")/2");
        // Without expressions for its corners, an ellipse grows about its centre.
        if (side.placed || usesNames(side.fromText)) {
            keep(across ? Quantity::X : Quantity::Y, 0, "(" + sumFormula(low, high) + ")/2");
        }
    }
    keep(Quantity::Radius, 0, kind_ == ShapeKind::Rectangle ? radiusFormula_ : std::string());
}

Shape BoxTool::shapeTo(Vec2 second) const {
    Shape shape;
    shape.form = formOf(kind_);
    shape.nodes = {*first_, second};
    if (kind_ == ShapeKind::Ellipse) {
        const Vec2 centre = midpoint(*first_, second), half = boxOf(*first_, second).max - centre;
        shape.nodes = {centre, centre + Vec2{half.x, 0.0}, centre + Vec2{0.0, half.y}};
    } else if (kind_ == ShapeKind::Rectangle) {
        shape.as<RectangleForm>().radius = radius_;
    }
    return shape;
}

void BoxTool::drawSketch(CanvasPainter &painter, Shell &context) {
    const Theme &theme = context.theme;
    if (!first_) {
        drawMeasure(painter, context, {});
        return;
    }
    const Vec2 second = corner(pointer_.at);
    painter.handle(*first_, 3.0, theme.canvas, theme.selection);
    if (isBox()) {
        if (kind_ == ShapeKind::Ellipse) {
            painter.dashed({first_->x, second.y}, second, fade(theme.selection, 0.4), 1.0);
            painter.dashed({second.x, first_->y}, second, fade(theme.selection, 0.4), 1.0);
        }
        painter.outline(outlineOf(shapeTo(second)), theme.selection, 2.0);
        const Vec2 size{std::abs(second.x - first_->x), std::abs(second.y - first_->y)};
        drawMeasure(painter, context, ui::number(size.x) + " \xc3\x97 " + ui::number(size.y));
    } else {
        const double radius = distance(*first_, second);
        painter.circle(*first_, radius, theme.selection, 2.0);
        painter.dashed(*first_, second, fade(theme.selection, 0.6), 1.0);
        drawMeasure(painter, context, "r = " + ui::number(radius));
    }
}

void BoxTool::drawOptions(Shell &context, ui::Flow &flow) {
    drawTagOption(context, flow, *state_, ShapeUse::Boundary, "Tag of the next boundary");
    if (kind_ == ShapeKind::Rectangle) {
        drawFormulaOption(context, flow, "options/cornerradius", "Corner radius", radius_, radiusFormula_,
                          "Radius of the corners of the next rectangle; 0: sharp corners", true,
                          context.document.current()->unit);
    }
    state_->drawSnapOptions(context, flow);
    drawRelationOptions(context, flow);
}

std::string BoxTool::statusText(const Shell &) const {
    if (kind_ == ShapeKind::Ellipse) {
        return first_ ? "Click the opposite corner of its box, or type width, Tab, height, Enter. Shift: circle. "
                        "Negative: left, down. Position of the corner: x4,3"
                      : "Click or drag from a corner of its box, or type x, Tab, y, Enter. Inside another shape it "
                        "becomes a hole";
    }
    if (isBox()) {
        return first_ ? "Click the opposite corner, or type width, Tab, height, Enter. Shift: square. "
                        "Negative: left, down. Position of the corner: x4,3"
                      : "Click or drag from a corner, or type x, Tab, y, Enter. Inside another shape it becomes a hole";
    }
    return first_ ? "Click a point on the circle, or type the radius, Enter, or D, the diameter, Enter"
                  : "Click or drag from the centre, or type x, Tab, y, Enter. Inside another shape it becomes a hole";
}

} // namespace forefront
