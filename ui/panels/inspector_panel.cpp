#include "core/drawing/commands/path_commands.hpp"
#include "core/drawing/constraints/constraint_commands.hpp"
#include "core/drawing/names/name_commands.hpp"
#include "core/drawing/picking/selected_faces.hpp"
#include "core/drawing/shapes/node_sizes.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing/shapes/slot.hpp"
#include "ui/panels/constraint_rows.hpp"
#include "ui/panels/edit_panels.hpp"
#include "ui/panels/element_count_row.hpp"
#include "ui/panels/form.hpp"
#include "ui/panels/geometry_rows.hpp"
#include "ui/panels/inspector_marks.hpp"
#include "ui/panels/part_rows.hpp"
#include "ui/panels/region_rows.hpp"
#include "ui/panels/size_rows.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/enum_choice.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/current_faces.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/joined_command.hpp"
#include "ui/workspace/number_field.hpp"
#include "ui/workspace/typed_command.hpp"

#include <imgui.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>

namespace forefront {
namespace {

using Names = std::map<std::int32_t, std::string>;

/// Shows and edits the selection; every edit is a command.
class InspectorPanel final : public Panel {
  public:
    const char *id() const override { return "inspector"; }
    const char *title() const override { return "Inspector"; }
    void draw(Shell &context) override;

  private:
    void drawHere(Shell &context) const;
    void drawShape(Shell &context, const Shape &shape);
    void drawShapeButtons(Shell &context, const Shape &shape) const;
    void drawNode(Shell &context, NodeRef ref) const;
    void drawNodeKind(Shell &context, const Shape &shape, NodeRef ref) const;
    void drawSegment(Shell &context, SegmentRef ref);
    void drawMany(Shell &context) const;

    ConstraintRows constraints_;
    PartRows parts_;
};

void changeTag(Shell &context, const BoundaryPart &part, std::int32_t tag) {
    Result<Document> next = setShapeTag(*context.document.current(), part.shapes, tag);
    if (next) {
        next = setSegmentTag(*next, part.segments, tag);
    }
    context.applyCommand(std::move(next), "Change tag");
}

/// Draws tag and name of a part of the boundary in one row; edits change only that part.
void boundaryTagRow(Shell &context, std::int32_t tag, const BoundaryPart &part) {
    const Document &document = *context.document.current();
    std::optional<std::string> rename;
    const std::string name = boundaryName(document.boundaryNames, tag);
    std::int32_t wanted = tag;
    if (form::tag(context, "inspector/tag", "Boundary", wanted, name, rename)) {
        changeTag(context, part, wanted);
    } else if (rename) {
        context.applyCommand(nameBoundaryPart(document, part, *rename), "Name boundary");
    }
}

/// Returns the tags of the segments of a boundary part, and of its points.
std::set<std::int32_t> tagsOf(const Document &document, const BoundaryPart &part) {
    std::set<std::int32_t> tags;
    for (const std::uint32_t id : part.shapes) {
        const Shape &shape = *findShape(document, id);
        const std::size_t segments = taggedSegments(shape);
        if (segments == 0) {
            tags.insert(shape.tag);
        }
        for (std::uint32_t k = 0; k < segments; ++k) {
            tags.insert(segmentTag(shape, k));
        }
    }
    for (const SegmentRef segment : part.segments) {
        tags.insert(segmentTag(*findShape(document, segment.shape), segment.segment));
    }
    return tags;
}

/// Draws boundaryTagRow() for several shapes or segments; if their tags differ, a field that gives all of them one.
void manyTagsRow(Shell &context, const BoundaryPart &part) {
    const Document &document = *context.document.current();
    const std::set<std::int32_t> tags = tagsOf(document, part);
    if (tags.size() == 1) {
        boundaryTagRow(context, *tags.begin(), part);
        return;
    }
    form::label(context, "Boundary");
    std::optional<double> wanted;
    if (form::optionalField(context, "inspector/tag", wanted, "several") && wanted &&
        ui::checkTag(context, "inspector/tag", *wanted)) {
        changeTag(context, part, static_cast<std::int32_t>(*wanted));
    }
    ui::rowTooltip(context, "The tags differ. Enter a number to give all of them that tag.");
}

/// Draws what the mesher makes of a part, by the role of its shape.
void roleRows(Shell &context, PartRows &rows, const Shape &shape, std::int32_t tag, const BoundaryPart &part) {
    if (shape.construction) {
        return;
    }
    shape.use == ShapeUse::Boundary ? rows.drawBoundary(context, tag, part) : PartRows::drawLine(context, tag, part);
}

void useRow(Shell &context, const std::set<std::uint32_t> &ids, ShapeUse use) {
    constexpr std::array<const char *, wordsOf<ShapeUse>().size()> kRoles{"Boundary", "Inner line"};
    form::label(context, "Role");
    if (int choice = static_cast<int>(use);
        ui::segmented(context, "inspector/use", std::span<const char *const>(kRoles), choice)) {
        context.applyCommand(setShapeUse(*context.document.current(), ids, static_cast<ShapeUse>(choice)),
                             "Change role");
    }
}

/// The node spacing under the pointer and what sets it.
struct SpacingHere {
    std::string winner;   ///< spacing and the part that sets it, or the reason why there is none
    std::string runnerUp; ///< the next larger spacing and its part; may be empty
};

SpacingHere spacingHere(const Workspace &context) {
    const std::shared_ptr<const SpacingField> &spacing = context.preview->spacing;
    const std::shared_ptr<const Domain> &domain = context.preview->domain;
    if (!spacing) {
        const bool empty = !domain || domain->nodes.empty();
        return {empty ? "Draw a domain to see its spacing here." : "The spacing has an error: see Checks.", {}};
    }
    if (!context.view.pointer) {
        return {"Point at the canvas to read the spacing there.", {}};
    }
    const SpacingSample sample = spacing->sample(*context.view.pointer);
    SpacingHere here{"Size \xcf\x81 at the pointer = " + ui::number(sample.rho, 3) + ": " + sample.describe, {}};
    if (sample.runnerUp) {
        here.runnerUp = "then " + ui::number(sample.runnerUp->rho, 3) + ": " + sample.runnerUp->describe;
    }
    return here;
}

/// Draws spacingHere() in exactly three lines, so that the fields below do not move under the pointer. A tooltip shows
/// text that does not fit.
void InspectorPanel::drawHere(Shell &context) const {
    const float top = ImGui::GetCursorPosY();
    const SpacingHere here = spacingHere(context);
    ImGui::PushFont(context.fonts.small);
    const float width = ImGui::GetContentRegionAvail().x;
    const std::string winner = ui::twoLines(here.winner, width);
    const bool wraps = winner.find('\n') != std::string::npos;
    const std::string runnerUp = wraps ? ui::oneLine(here.runnerUp, width) : ui::twoLines(here.runnerUp, width);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ImGui::GetStyle().ItemSpacing.x, 0.0F));
    ImGui::PushStyleColor(ImGuiCol_Text, context.theme.muted);
    ImGui::TextUnformatted(winner.c_str());
    ui::mark(context, "inspector/here");
    if (winner.ends_with("\xe2\x80\xa6")) {
        ui::tooltip(context, here.winner);
    }
    if (!context.preview->spacing && context.preview->domain && !context.preview->domain->nodes.empty()) {
        ui::mark(context, "inspector/fault");
    }
    ImGui::PopStyleColor();
    if (!runnerUp.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, fade(context.theme.muted, 0.8));
        ImGui::TextUnformatted(runnerUp.c_str());
        ImGui::PopStyleColor();
        ui::mark(context, "inspector/runnerup");
        if (runnerUp.ends_with("\xe2\x80\xa6")) {
            ui::tooltip(context, here.runnerUp);
        }
    }
    ImGui::PopStyleVar();
    const float room = 3.0F * ImGui::GetTextLineHeight() + ImGui::GetStyle().ItemSpacing.y;
    ImGui::PopFont();
    ImGui::SetCursorPosY(top + room);
}

void InspectorPanel::drawShapeButtons(Shell &context, const Shape &shape) const {
    const Document &document = *context.document.current();
    if (!isPath(shape) && !shape.is<PointForm>()) {
        if (ui::button(context, "inspector/topath", "To path")) {
            context.applyCommand(convertToPath(document, shape.id), "Convert to path");
        }
        ui::tooltip(context, "Turn the shape into a path whose nodes and segments can be edited, and named one by one");
        ImGui::SameLine();
    } else if (!shape.is<PointForm>()) {
        const bool closed = isClosed(shape);
        if (ui::button(context, "inspector/close", closed ? "Open" : "Close", ui::ButtonKind::Plain,
                       shape.nodes.size() > 2)) {
            context.applyCommand(toggleClosed(document, shape.id), closed ? "Open polygon" : "Close polyline");
        }
        ui::tooltip(context, closed ? "Turn the polygon into an open polyline" : "Join the two ends");
        ImGui::SameLine();
        if (isSlot(shape)) {
            if (ui::button(context, "inspector/toslot", "To slot")) {
                context.applyCommand(convertToSlot(document, shape.id), "Convert to slot");
            }
            ui::tooltip(context, "Edit it by its width and the centres of its ends");
            ImGui::SameLine();
        }
    }
    if (ui::button(context, "inspector/duplicate", "Duplicate")) {
        context.actions.run("edit.duplicate", context);
    }
    ImGui::SameLine();
    if (ui::button(context, "inspector/delete", "Delete")) {
        context.actions.run("edit.delete", context);
    }
}

void InspectorPanel::drawShape(Shell &context, const Shape &shape) {
    const Document &document = *context.document.current();
    inspectorHeading(context, displayName(shape));
    if (shape.segmentTags.empty()) {
        boundaryTagRow(context, shape.tag, {.shapes = {shape.id}, .segments = {}});
    } else {
        form::label(context, "Boundary");
        ui::muted(context, "several");
        ImGui::SameLine();
        if (ui::button(context, "inspector/onetag", "Same for all")) {
            context.applyCommand(setShapeTag(document, {shape.id}, shape.tag), "Change tag");
        }
    }
    std::string name = shape.name;
    if (form::text(context, "inspector/name", "Shape name", name, kindName(shape).c_str()) && name != shape.name) {
        context.applyCommand(setShapeName(document, shape.id, name), "Name shape");
    }
    ui::tooltip(context, "Name of the shape in the list Shapes alone; the mesh file has the name of its boundary");
    if (shape.is<PointForm>()) {
        nodeSizeRow(context, {{shape.id, 0}});
    }
    geometryRows(context, shape);
    segmentSizeRow(context, segmentsOf(document, {shape.id}));
    elementCountRow(context, std::set{shape.id});
    if (shape.segmentTags.empty()) {
        partSizeRow(context, shape.tag);
        if (taggedSegments(shape) > 0) {
            roleRows(context, parts_, shape, shape.tag, {.shapes = {shape.id}, .segments = {}});
        }
    }
    extentRows(context, shape);
    useRow(context, {shape.id}, shape.use);
    ImGui::Dummy({0, context.px(2)});
    drawShapeButtons(context, shape);
}

void InspectorPanel::drawNode(Shell &context, NodeRef ref) const {
    const Document &document = *context.document.current();
    const Shape *shape = findShape(document, ref.shape);
    const std::vector<Vec2> handles = handlesOf(*shape);
    Vec2 at = handles[ref.node];
    inspectorHeading(context, "Node " + std::to_string(ref.node + 1) + " of " + displayName(*shape));
    if (shape->is<SlotForm>() && !isCentre(*shape, ref.node)) {
        slotWidthRow(context, *shape); // the place of its side follows
    } else if (form::pair(context, "inspector/at", "Position", at, handleAddress(*shape, ref.node))) {
        if (applyTyped(context, setHandle(document, ref, at), "Move node")) {
            context.view.reveal(boxOf(at, at));
        }
    }
    if (isPath(*shape)) {
        drawNodeKind(context, *shape, ref);
    }
    nodeSizeRow(context, {ref});
    if (ui::button(context, "inspector/delete", "Delete node")) {
        context.actions.run("edit.delete", context);
    }
}

void InspectorPanel::drawNodeKind(Shell &context, const Shape &shape, NodeRef ref) const {
    NodeKind kind = nodeKind(shape, ref.node);
    form::label(context, "Kind");
    if (ui::segmented(context, "inspector/nodekind", kind)) {
        context.applyCommand(setNodeKind(*context.document.current(), {ref}, kind), "Change node");
    }
}

void InspectorPanel::drawSegment(Shell &context, SegmentRef ref) {
    const Document &document = *context.document.current();
    const Shape *shape = findShape(document, ref.shape);
    const bool corner = isRoundedCorner(*shape, ref.segment);
    inspectorHeading(context, (corner ? "Rounded corner " + std::to_string(ref.segment - 3)
                                      : "Segment " + std::to_string(ref.segment + 1)) +
                                  " of " + displayName(*shape));
    boundaryTagRow(context, segmentTag(*shape, ref.segment), {.shapes = {}, .segments = {ref}});
    segmentSizeRow(context, {ref});
    elementCountRow(context, std::set{ref});
    partSizeRow(context, segmentTag(*shape, ref.segment));
    roleRows(context, parts_, *shape, segmentTag(*shape, ref.segment), {.shapes = {}, .segments = {ref}});
    if (isRound(*shape) || ref.segment >= taggedSegments(*shape)) {
        return;
    }
    segmentRows(context, *shape, ref);
    const Outline outline = outlineOf(*shape);
    const bool curved = isPath(*shape) && outline.isCurved(ref.segment);
    std::size_t segment = 0; // of the outline
    while (segment + 1 < outline.segmentCount() && outline.part(segment) != ref.segment) {
        ++segment;
    }
    const Vec2 middle = outline.curve(segment).point(0.5);
    if (ui::button(context, "inspector/split", "Insert node")) {
        applyJoined(context, insertNode(document, ref, middle), "Insert node");
    }
    if (isPath(*shape)) {
        ImGui::SameLine();
        if (ui::button(context, "inspector/bend", curved ? "To line" : "To curve")) {
            context.actions.run(curved ? "path.line" : "path.curve", context);
        }
    }
}

void InspectorPanel::drawMany(Shell &context) const {
    const Selection &selection = context.selection;
    std::string what;
    const auto part = [&](std::size_t count, const char *one, const char *many) {
        if (count > 0) {
            what += (what.empty() ? "" : ", ") + ui::count(count) + " " + (count == 1 ? one : many);
        }
    };
    part(selection.shapes.size(), "shape", "shapes");
    part(selection.nodes.size(), "node", "nodes");
    part(selection.segments.size(), "segment", "segments");
    part(selection.sources.size(), "source", "sources");
    part(selection.markers.size(), "region", "regions");
    part(selection.faces.size(), "face", "faces");
    part(selection.constraints.size(), "sketch constraint", "sketch constraints");
    inspectorHeading(context, what);
    const Document &document = *context.document.current();
    if (!selection.shapes.empty()) {
        const Shape *first = findShape(document, *selection.shapes.begin());
        useRow(context, selection.shapes, first->use);
        manyTagsRow(context, {selection.shapes, selection.segments});
        std::set<SegmentRef> segments = segmentsOf(document, selection.shapes);
        segments.insert(selection.segments.begin(), selection.segments.end());
        segmentSizeRow(context, segments);
        elementCountRow(context, selection.shapes);
    } else if (!selection.segments.empty()) {
        manyTagsRow(context, {.shapes = {}, .segments = selection.segments});
        segmentSizeRow(context, selection.segments);
        elementCountRow(context, selection.segments);
    } else if (!selection.nodes.empty()) {
        nodeSizeRow(context, selection.nodes);
    } else if (selection.markers.size() == selection.size()) {
        manyRegionsRows(context, selection.markers);
    }
    Box2 box = boundsOf(document, selection);
    const std::shared_ptr<const FaceMap> map = selection.onlyFaces() ? readyFaces(context) : nullptr;
    for (const std::uint32_t face : map ? selectedFaces(*map, document, selection) : std::set<std::uint32_t>()) {
        box.add(map->faces()[face].box);
    }
    if (!box.empty()) {
        ui::field(context, "Extent",
                  ui::grouped(box.size().x) + " \xc3\x97 " + ui::grouped(box.size().y) + unitSuffix(document.unit),
                  form::kLabel);
    }
    if (selection.onlyFaces()) {
        if (ui::button(context, "inspector/border", "Select border")) {
            context.actions.run("edit.selectBorder", context);
            return;
        }
        ImGui::SameLine(0, context.px(6));
    }
    if (ui::button(context, "inspector/delete", "Delete all")) {
        context.actions.run("edit.delete", context);
    }
}

void InspectorPanel::draw(Shell &context) {
    const std::shared_ptr<const Document> held =
        context.document.current(); // keeps it alive: fields below may replace it
    const Selection &selection = context.selection;
    drawHere(context);
    if (selection.empty()) {
        return;
    }
    ImGui::Dummy({0, context.px(2)});
    if (selection.size() > 1) {
        drawMany(context);
    } else if (!selection.shapes.empty()) {
        drawShape(context, *findShape(*held, *selection.shapes.begin()));
    } else if (!selection.nodes.empty()) {
        drawNode(context, *selection.nodes.begin());
    } else if (!selection.segments.empty()) {
        drawSegment(context, *selection.segments.begin());
    } else if (!selection.sources.empty()) {
        inspectSource(context, *selection.sources.begin());
    } else if (!selection.markers.empty()) {
        inspectRegion(context, *selection.markers.begin());
    } else if (!selection.faces.empty()) {
        inspectFace(context, *selection.faces.begin());
    } else {
        inspectorHeading(context, findConstraint(*held, *selection.constraints.begin())->name);
    }
    constraints_.draw(context);
}

} // namespace

std::unique_ptr<Panel> makeInspectorPanel() {
    return std::make_unique<InspectorPanel>();
}

} // namespace forefront
