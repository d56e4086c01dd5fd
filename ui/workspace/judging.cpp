#include "ui/workspace/judging.hpp"

#include "core/engine/geometry/polygon.hpp"
#include "ui/canvas/canvas_painter.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/number_field.hpp"
#include "ui/workspace/workspace.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace forefront {

namespace {

/// The measure whose colours and linear scale fields use; it has no good or bad end.
constexpr Measure kFieldScale = Measure::Birth;

} // namespace

JudgeRequest judgeRequest(const Workspace &context) {
    const SessionSnapshot &shown = context.run.now();
    JudgeRequest request;
    if (shown.mesh && !shown.mesh->mesh.elements.empty()) {
        request.mesh = shown.mesh;
    }
    // A mesh opened from a file is compared with the spacing of the drawing.
    request.spacing = shown.spacing || !context.run.showsFile() ? shown.spacing : context.preview->spacing;
    request.measure = context.view.measure;
    if (context.view.formula.any() && request.mesh && !request.mesh->whole) {
        request.measure = kFieldScale;
        request.formula = context.view.formula;
        request.field = context.view.formula.name;
        request.fieldPart = context.view.formula.ofError ? MeshPart::Elements : MeshPart::Nodes;
    } else if (const auto fields = context.run.fields(); fields && !context.view.field.empty()) {
        if (const auto *const values = fields->find(context.view.fieldPart, context.view.field)) {
            request.measure = kFieldScale;
            request.field = context.view.field;
            request.fieldPart = context.view.fieldPart;
            request.fieldValues = {fields, values};
        }
    }
    request.limits = context.document.current()->limits;
    request.verify = context.run.showsFile();
    request.parts = context.probe.active || context.probe.chosen.has_value();
    return request;
}

ColourRange measureRange(const Workspace &context) {
    const Judgement &judgement = *context.judgement;
    const bool current = judgement.of.field.empty() ? judgement.of.measure == context.view.measure
                                                    : judgement.of.field == context.view.field &&
                                                          judgement.of.fieldPart == context.view.fieldPart;
    if (current && context.view.measureRange) {
        return *context.view.measureRange;
    }
    const std::optional<ColourRange> fixed =
        judgement.of.fieldValues || context.view.fitRange ? std::nullopt : fixedRange(judgement.of.measure);
    return fixed.value_or(judgement.fitted);
}

ColourMap measureMap(const Workspace &context) {
    return mapOf(context.judgement->of.measure, context.view.scale, context.theme.kind);
}

std::optional<MeshLimit> limitOf(Measure measure) {
    for (const MeshLimit limit : valuesOf<MeshLimit>()) {
        if (limitInfo(limit).measure == measure) {
            return limit;
        }
    }
    return std::nullopt;
}

MeasureBounds measureBounds(const Workspace &context) {
    const JudgeRequest &of = context.judgement->of;
    MeasureBounds bounds;
    if (of.fieldValues) {
        return bounds;
    }
    for (const MeshLimit limit : valuesOf<MeshLimit>()) {
        const LimitInfo &info = limitInfo(limit);
        const bool dragged = context.view.draggedLimit && context.view.draggedLimit->limit == limit;
        const std::optional<double> value =
            dragged ? std::optional(context.view.draggedLimit->value) : context.document.current()->limits[limit];
        if (info.measure == of.measure && limitOf(info.measure) == limit && value) {
            (info.isMinimum ? bounds.minimum : bounds.maximum) = value;
        }
    }
    constexpr double kBadShape = 0.5;
    if (of.measure == Measure::ShapeFactor && !bounds.minimum) {
        bounds.minimum = kBadShape;
    }
    return bounds;
}

double limitPosition(Measure measure, const ColourRange &range, const MeasureBounds &bounds) {
    const std::optional<MeshLimit> limit = limitOf(measure);
    const bool isMinimum = limit && limitInfo(*limit).isMinimum;
    const std::optional<double> bound = isMinimum ? bounds.minimum : bounds.maximum;
    return bound ? std::clamp(mapPosition(measure, range, *bound), 0.0, 1.0) : isMinimum ? 0.0 : 1.0;
}

void setLimit(Workspace &context, MeshLimit limit, std::optional<double> value) {
    if (value) {
        if (const std::string fault = limitFault(limit, *value); !fault.empty()) {
            ui::refuseCommand(context, {{.severity = Severity::Warning,
                                         .code = "bad-limit",
                                         .message = std::string(limitInfo(limit).name) + ": " + fault}});
            return;
        }
    }
    Document next = *context.document.current();
    next.limits[limit] = value;
    context.document.apply(std::move(next), value ? std::string("Set ") + limitInfo(limit).name
                                                  : std::string("Remove ") + limitInfo(limit).name);
}

void fitMeasureRange(Workspace &context) {
    context.view.measureRange.reset();
    context.view.fitRange = true;
    context.animate();
}

void chooseMeasure(Workspace &context, Measure measure) {
    if (context.view.measure != measure || !context.view.field.empty() || context.view.formula.any()) {
        context.view.measure = measure;
        context.view.field.clear();
        context.view.formula = {};
        context.view.measureRange.reset();
        context.view.isolatedBin.reset();
        context.probe.rank.reset();
        context.animate();
    }
}

void chooseFormula(Workspace &context, const LessonColours &formula) {
    if (!(context.view.formula == formula)) {
        context.view.formula = formula;
        context.view.field.clear();
        context.view.measureRange.reset();
        context.view.isolatedBin.reset();
        context.probe.rank.reset();
        context.animate();
    }
}

void chooseField(Workspace &context, MeshPart part, const std::string &name) {
    context.view.formula = {};
    context.view.field = name;
    context.view.fieldPart = part;
    context.view.measureRange.reset();
    context.view.isolatedBin.reset();
    context.probe.rank.reset();
    context.animate();
}

std::string valueText(const Judgement &judgement, double value, int digits) {
    return judgement.of.fieldValues ? ui::number(value, digits) : measureText(judgement.of.measure, value, digits);
}

void goToPart(Workspace &context, const MeshPick &pick) {
    const Judgement &judgement = *context.judgement;
    if (!judgement.of.mesh || (pick.part == MeshPart::Edges && !judgement.edges)) {
        return;
    }
    context.probe.follow(judgement.of.mesh->version);
    context.probe.chosen = pick;
    const MeshView mesh = judgement.of.mesh->view();
    Box2 box;
    if (pick.part == MeshPart::Elements) {
        for (const NodeId node : mesh.nodesOf(pick.index)) {
            box.add(mesh.nodes[index(node)]);
        }
    } else if (pick.part == MeshPart::Edges) {
        const MeshEdge &edge = judgement.edges->edges[pick.index];
        box = boxOf(mesh.nodes[index(edge.a)], mesh.nodes[index(edge.b)]);
    }
    View &view = context.view;
    view.goTo(placeOf(judgement, pick.part, pick.index), context.platform.now());
    constexpr double kShare = 0.15; // of the canvas that the part takes up
    const double extent = box.diagonal();
    if (extent > 0.0) {
        const double zoom = kShare * std::min(view.open.width, view.camera.viewport.height) / extent;
        view.camera.zoom = std::clamp(zoom, view.camera.minZoom, view.camera.maxZoom);
    }
    // In the middle of what a column over the canvas leaves.
    view.camera.centre.x -= view.camera.length(view.open.centre().x - view.camera.viewport.centre().x);
    context.animate();
}

void goToRank(Workspace &context, std::size_t rank) {
    const Judgement &judgement = *context.judgement;
    if (rank < judgement.worst.size()) {
        goToPart(context, {infoOf(judgement.of.measure).part, judgement.worst[rank]});
        context.probe.rank = rank;
    }
}

void walkRanks(Workspace &context, bool forward) {
    const std::size_t count = context.judgement->worst.size();
    if (count == 0) {
        return;
    }
    std::size_t rank = 0;
    if (context.probe.chosen && context.probe.rank) {
        const std::size_t now = *context.probe.rank;
        rank = forward ? std::min(now + 1, count - 1) : std::max<std::size_t>(now, 1) - 1;
    }
    goToRank(context, rank);
    context.animate();
}

bool walkByKey(Workspace &context, int code) {
    const std::size_t count = context.judgement->worst.size();
    switch (code) {
    case key::kUp:
    case key::kDown:
        walkRanks(context, code == key::kDown);
        return true;
    case key::kHome:
    case key::kEnd:
        if (count > 0) {
            goToRank(context, code == key::kHome ? 0 : count - 1);
            context.animate();
        }
        return true;
    default:
        return false;
    }
}

namespace {

/// Returns the element that contains a place; the lowest number if elements overlap there.
std::uint32_t elementAt(const Judgement &judgement, Vec2 place) {
    const MeshSnapshot &shown = *judgement.of.mesh;
    const TriMesh &mesh = shown.mesh;
    std::uint32_t found = kNoIndex;
    judgement.tree->query(boxAround(place, 0.0), [&](std::uint32_t number) {
        const Element &n = mesh.elements[number];
        const Vec2 a = mesh.nodes[index(n[0])], b = mesh.nodes[index(n[1])], c = mesh.nodes[index(n[2])];
        const double turn = cross(b - a, c - a) < 0.0 ? -1.0 : 1.0;
        const bool inside = turn * cross(b - a, place - a) >= 0.0 && turn * cross(c - b, place - b) >= 0.0 &&
                            turn * cross(a - c, place - c) >= 0.0;
        found = inside ? std::min(found, static_cast<std::uint32_t>(shown.element(number))) : found;
    });
    return found;
}

/// Returns the nodes of a part in the order of a line along it: round an element, or from end to end of an edge.
std::vector<Vec2> nodesOf(const Judgement &judgement, const MeshPick &pick) {
    const MeshView mesh = judgement.of.mesh->view();
    const auto at = [&](NodeId node) { return mesh.nodes[index(node)]; };
    std::vector<Vec2> line;
    if (pick.part == MeshPart::Elements && pick.index < mesh.elementCount()) {
        const std::span<const NodeId> nodes = mesh.nodesOf(pick.index);
        const std::size_t corners = mesh.cornersOf(pick.index).size();
        for (std::size_t k = 0; k < corners; ++k) {
            line.push_back(at(nodes[k]));
            if (nodes.size() > corners) {
                line.push_back(at(nodes[corners + k]));
            }
        }
        return line;
    }
    if (pick.part == MeshPart::Edges && judgement.edges && pick.index < judgement.edges->edges.size()) {
        const MeshEdge &edge = judgement.edges->edges[pick.index];
        line = {at(edge.a), at(edge.b)};
        if (edge.middle != kNoNode) {
            line.insert(line.begin() + 1, at(edge.middle));
        }
        return line;
    }
    return pick.part == MeshPart::Nodes && pick.index < mesh.nodes.size() ? std::vector<Vec2>{mesh.nodes[pick.index]}
                                                                          : std::vector<Vec2>();
}

} // namespace

std::optional<MeshPick> partAt(const Judgement &judgement, Vec2 place, double reach) {
    if (!judgement.tree || !judgement.edges) {
        return std::nullopt;
    }
    const std::uint32_t element = elementAt(judgement, place);
    if (element == kNoIndex) {
        return std::nullopt;
    }
    const MeshView mesh = judgement.of.mesh->view();
    const std::vector<Vec2> line = nodesOf(judgement, {MeshPart::Elements, element});
    constexpr double kShare = 0.22; // of its shortest side: the middle of a small element is the element itself
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < line.size(); ++k) {
        shortest = std::min(shortest, distance(line[k], line[(k + 1) % line.size()]));
    }
    const double near = std::min(reach, kShare * shortest);
    for (const NodeId node : mesh.nodesOf(element)) {
        if (distance(place, mesh.nodes[index(node)]) <= near) {
            return MeshPick{MeshPart::Nodes, static_cast<std::uint32_t>(index(node))};
        }
    }
    const std::size_t perEdge = line.size() / mesh.cornersOf(element).size();
    for (std::size_t k = 0; k < line.size(); ++k) {
        if (distanceToSegment(line[k], line[(k + 1) % line.size()], place) <= 0.5 * near) {
            return MeshPick{MeshPart::Edges, judgement.edges->of(element, k / perEdge)};
        }
    }
    return MeshPick{MeshPart::Elements, element};
}

namespace {

/// Two lines of text beside a part of the mesh, one below the other.
struct PartPlate {
    std::string value; ///< empty: there is only the second line
    std::string where;
    ImFont *strong, *small; ///< the fonts of the lines

    static constexpr double kLine = 24.0; ///< from the first line to the second, design pixels
    double second() const { return value.empty() ? 0.0 : kLine; }
};

/// Returns the rectangles of the lines of a plate at an offset from a place, in pixels.
std::array<PixelRect, 2> rectsOf(const CanvasPainter &painter, const PartPlate &plate, Vec2 at, Pixel offset) {
    const PixelRect where = painter.labelRect(at, offset + Pixel(0.0, plate.second()), plate.where, plate.small);
    return {plate.value.empty() ? where : painter.labelRect(at, offset, plate.value, plate.strong), where};
}

/// Returns true if the corners of a rectangle are all on elements or all off them: it covers no outline.
bool isEven(const Judgement &judgement, const Camera &camera, const PixelRect &rect) {
    const auto meshed = [&](double x, double y) { return elementAt(judgement, camera.toPlane({x, y})) != kNoIndex; };
    if (!judgement.tree) {
        return true; // not known yet
    }
    const double right = rect.x + rect.width, below = rect.y + rect.height;
    const bool first = meshed(rect.x, rect.y);
    return meshed(right, rect.y) == first && meshed(rect.x, below) == first && meshed(right, below) == first &&
           meshed(rect.centre().x, rect.centre().y) == first;
}

/// Returns the offset of a plate beside a part, in design pixels: on a side with room for it, where it covers neither
/// the part nor an outline, if there is one; none if there is no room on any side.
std::optional<Pixel> offsetBeside(const CanvasPainter &painter, const PixelRect &open, const Judgement &judgement,
                                  const PartPlate &plate, Vec2 at, std::span<const Vec2> nodes) {
    constexpr double kGap = 10.0; // design pixels
    const Camera &camera = painter.camera();
    const double scale = painter.scale();
    Box2 part;
    for (const Vec2 node : nodes) {
        const Pixel p = (camera.toPixel(node) - camera.toPixel(at)) / scale;
        part.add(Vec2{p.x, p.y});
    }
    const auto [value, where] = rectsOf(painter, plate, at, {});
    const Pixel pad = Pixel(camera.toPixel(at).x - value.x, camera.toPixel(at).y - value.y) / scale;
    const double width = std::max(value.width, where.width) / scale, height = plate.second() + where.height / scale;
    const Vec2 middle = part.centre();
    const Pixel corners[] = {
        {part.max.x + kGap, middle.y - 0.5 * height},         {part.min.x - kGap - width, middle.y - 0.5 * height},
        {middle.x - 0.5 * width, part.min.y - kGap - height}, {middle.x - 0.5 * width, part.max.y + kGap},
        {part.max.x + kGap, part.min.y - kGap - height},      {part.min.x - kGap - width, part.min.y - kGap - height}};
    std::optional<Pixel> found;
    for (const Pixel corner : corners) {
        const Pixel offset = corner + pad, below = offset + Pixel(0.0, plate.second());
        const auto rects = rectsOf(painter, plate, at, offset);
        const auto inside = [&open](const PixelRect &rect) {
            return open.contains({rect.x, rect.y}) && open.contains({rect.x + rect.width, rect.y + rect.height});
        };
        if (!inside(rects[0]) || !inside(rects[1]) ||
            !painter.freeOffset(at, std::span(&below, 1), plate.where, plate.small) ||
            (!plate.value.empty() && !painter.freeOffset(at, std::span(&offset, 1), plate.value, plate.strong))) {
            continue;
        }
        if (isEven(judgement, camera, rects[0]) && isEven(judgement, camera, rects[1])) {
            return offset;
        }
        found = found.value_or(offset);
    }
    return found;
}

/// Says beside a part what the measure is there, its number and its place; in full even for large coordinates.
void drawPlate(CanvasPainter &painter, const Workspace &context, const Judgement &judgement, const MeshPick &pick) {
    const bool measured = judgement.info.part == pick.part && pick.index < judgement.values.size();
    if (pick.part == MeshPart::Edges && !judgement.edges) {
        return;
    }
    constexpr std::array<const char *, 3> kParts{"element", "edge", "node"};
    const Vec2 at = placeOf(judgement, pick.part, pick.index);
    const int decimals =
        std::clamp(static_cast<int>(std::ceil(1.0 - std::log10(context.view.camera.length(1.0)))), 0, 12);
    const PartPlate plate{measured ? judgement.name + ' ' + valueText(judgement, judgement.values[pick.index], 4)
                                   : std::string(),
                          std::string(kParts[static_cast<std::size_t>(pick.part)]) + ' ' + std::to_string(pick.index) +
                              ui::format(" at (%.*f, %.*f)", decimals, at.x, decimals, at.y),
                          context.fonts.strong, context.fonts.small};
    const PixelRect &open = context.view.open;
    const std::vector<Vec2> nodes = nodesOf(judgement, pick);
    const std::optional<Pixel> found = offsetBeside(painter, open, judgement, plate, at, nodes);
    const double right = open.x + open.width - context.view.camera.toPixel(at).x; // to a column over the canvas
    const auto put = [&](const std::string &text, ImFont *font, Colour colour, double y, const char *name) {
        constexpr double kGap = 16.0; // design pixels
        const double width = painter.labelRect(at, {}, text, font).width;
        const Pixel over{std::min(kGap, (right - width) / painter.scale() - kGap), 14.0 + y};
        painter.label(at, found ? *found + Pixel(0.0, y) : over, text, colour, fade(context.theme.popup, 0.95), font);
        painter.nameLabel(name);
    };
    if (measured) {
        put(plate.value, plate.strong, context.theme.text, 0.0, "probe/plate/value");
    }
    put(plate.where, plate.small, context.theme.muted, plate.second(), "probe/plate/place");
}

} // namespace

void drawProbe(CanvasPainter &painter, const Workspace &context) {
    const Probe &probe = context.probe;
    const Judgement &judgement = *context.judgement;
    if (!judgement.of.mesh || judgement.of.mesh->version != probe.mesh) {
        return;
    }
    const auto mark = [&](const std::optional<MeshPick> &pick, Colour colour, double width) {
        const std::vector<Vec2> nodes = pick ? nodesOf(judgement, *pick) : std::vector<Vec2>();
        if (nodes.size() == 1) {
            painter.ring(nodes.front(), 7.0, colour, width);
        } else if (!nodes.empty()) {
            painter.polyline(nodes, pick->part == MeshPart::Elements, colour, width);
        }
    };
    if (probe.hovered != probe.chosen) {
        mark(probe.hovered, context.theme.text, 1.5);
    }
    mark(probe.chosen, context.theme.accent, 3.0);
    const std::optional<MeshPick> told = probe.chosen ? probe.chosen : probe.active ? probe.hovered : std::nullopt;
    if (told) {
        drawPlate(painter, context, judgement, *told);
    }
}

std::string measureText(Measure measure, double value, int digits) {
    if (std::isnan(value)) {
        return "none";
    }
    const bool whole = measure == Measure::Region || measure == Measure::Birth || measure == Measure::Valence ||
                       measure == Measure::Across;
    return whole ? ui::format("%.0f", value) : ui::number(value, digits) + infoOf(measure).unit;
}

} // namespace forefront
