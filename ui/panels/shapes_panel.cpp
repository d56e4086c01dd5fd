#include "core/drawing/names/region_commands.hpp"
#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "ui/panels/edit_panels.hpp"
#include "ui/panels/shape_tree.hpp"
#include "ui/parts/shell.hpp"
#include "ui/style/icons.hpp"
#include "ui/widgets/shortened.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace forefront {
namespace {

using RowKind = TreeRow::Kind;

// Design pixels.
constexpr double kRow = 24.0, kIndent = 18.0, kSwitch = 20.0;
constexpr const char *kRenameField = "shapes/rename";

/// Returns the item of a row; nothing for a group.
std::optional<NamedThing> thingOf(const Document &document, const TreeRow &row) {
    using Named = NamedThing::Kind;
    switch (row.kind) {
    case RowKind::Shape:
        return NamedThing{.kind = Named::Shape, .shape = document.shapes[row.index]->id};
    case RowKind::ShapePart: {
        const Shape &shape = *document.shapes[row.index];
        return NamedThing{
            .kind = Named::Part, .shape = shape.id, .tag = row.tag, .part = {{}, segmentsOf(shape, row.tag)}};
    }
    case RowKind::Part:
        return NamedThing{.kind = Named::Tag, .tag = row.tag};
    case RowKind::Region:
        return NamedThing{.kind = Named::Region, .marker = row.index};
    default:
        return std::nullopt;
    }
}

/// Returns the row of an item, without its number of items.
TreeRow rowOf(const Document &document, const NamedThing &thing) {
    using Named = NamedThing::Kind;
    if (thing.kind == Named::Tag) {
        return {.kind = RowKind::Part, .tag = thing.tag};
    }
    if (thing.kind == Named::Region) {
        return {.kind = RowKind::Region, .index = thing.marker};
    }
    return {.kind = thing.kind == Named::Shape ? RowKind::Shape : RowKind::ShapePart,
            .index = static_cast<std::uint32_t>(positionOf(document, thing.shape)),
            .tag = thing.tag};
}

/// Returns the selection that a click on a row makes.
Selection itemsOf(const Document &document, const TreeRow &row) {
    Selection items;
    if (row.kind == RowKind::Shape) {
        items.shapes.insert(document.shapes[row.index]->id);
    } else if (row.kind == RowKind::ShapePart) {
        items.segments = segmentsOf(*document.shapes[row.index], row.tag);
    } else if (row.kind == RowKind::Part) {
        items = selectTag(document, row.tag);
    } else {
        items.markers.insert(row.index);
    }
    return items;
}

/// Lists shapes with their boundary parts, boundary parts and regions. Only the rows in sight are drawn.
class ShapesPanel final : public Panel {
  public:
    const char *id() const override { return "shapes"; }
    const char *title() const override { return "Shapes"; }
    void draw(Shell &context) override;

  private:
    void followSelection(const Shell &context, const Document &document);
    void noteSelection(const Shell &context, const Document &document);
    void followNaming(Shell &context, const Document &document);
    void drawRows(Shell &context, const Document &document);
    void drawRow(Shell &context, const Document &document, std::size_t index);
    void drawPlate(Shell &context, const Document &document, const TreeRow &row, ImVec2 at, ImVec2 end, bool lit) const;
    void drawArrow(Shell &context, const TreeRow &row, const Shape *shape, ImVec2 at, const std::string &name);
    void drawText(Shell &context, const Document &document, const TreeRow &row, ImVec2 at, float width) const;
    static void drawSwitches(Shell &context, const Shape &shape, bool lit);
    void drawField(Shell &context, const Document &document, const NamedThing &thing, float width);
    bool isSelected(const Shell &context, const Document &document, const TreeRow &row) const;
    void click(Shell &context, const Document &document, std::size_t index);
    void choose(Shell &context, const Document &document, std::size_t index);
    void chooseRange(Shell &context, const Document &document, std::size_t from, std::size_t to) const;
    void openMenu(Shell &context, const Document &document, std::size_t index);
    static void openHiddenMenu(Shell &context, const Shape &shape);
    void openGroupMenu(Shell &context);

    ShapeTree tree_;
    Selection seen_;                       ///< the selection of the last frame
    std::uint64_t seenRevision_ = 0;       ///< of the document, with `selectedTags_`
    std::set<std::int32_t> selectedTags_;  ///< see ShapeTree::selectedTags()
    std::set<ShapePartKey> selectedParts_; ///< see selectedParts()
    std::size_t regions_ = 0;              ///< region markers of the last frame
    std::optional<std::size_t> reveal_;    ///< row to scroll to
    std::string anchor_;                   ///< name of the row clicked last, where Shift+click begins
};

/// Reveals items that were selected elsewhere, such as on the canvas.
void ShapesPanel::followSelection(const Shell &context, const Document &document) {
    const bool changed = !(seen_ == context.selection);
    if (changed) {
        reveal_ = tree_.reveal(document, context.selection);
    }
    if (changed || seenRevision_ != context.document.revision()) {
        seenRevision_ = context.document.revision();
        noteSelection(context, document);
    }
}

void ShapesPanel::noteSelection(const Shell &context, const Document &document) {
    seen_ = context.selection;
    selectedTags_ = tree_.selectedTags(document, seen_);
    selectedParts_ = selectedParts(document, seen_);
}

/// Shows the row whose name is to be edited, and forgets rows that are gone.
void ShapesPanel::followNaming(Shell &context, const Document &document) {
    Naming &naming = context.naming;
    const bool wasShown = naming.rowFrame >= ImGui::GetFrameCount() - 1;
    naming.rowFrame = ImGui::GetFrameCount();
    // Markers have no ids: when one is deleted or added, the number in a row may mean another one.
    if (std::exchange(regions_, document.regionMarkers.size()) != document.regionMarkers.size() && naming.row &&
        naming.row->kind == NamedThing::Kind::Region) {
        naming.row.reset();
    }
    if (!naming.thing || !naming.inPanel) {
        return;
    }
    if (naming.frames == 0) {
        reveal_ = tree_.reveal(document, rowOf(document, *naming.thing));
    }
    if (!wasShown || (naming.frames == 0 && !reveal_)) {
        naming.close();
    }
}

void ShapesPanel::draw(Shell &context) {
    const std::shared_ptr<const Document> document = context.document.current();
    Naming &naming = context.naming;
    tree_.follow(*document, context.document.revision());
    followSelection(context, *document);
    followNaming(context, *document);
    if (document->shapes.empty() && document->regionMarkers.empty()) {
        ui::small(context, "No shapes yet. Draw one, or open a file or a sample.", true);
        return;
    }
    const int frames = naming.frames;
    drawRows(context, *document);
    if (naming.thing && naming.inPanel && naming.frames == frames && frames > 0) {
        naming.close(); // its row was scrolled away or is gone
    }
    if (ImGui::IsWindowHovered() && !ImGui::IsAnyItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
        openGroupMenu(context);
    }
}

/// Draws the rows in sight, after scrolling to the one to be revealed.
void ShapesPanel::drawRows(Shell &context, const Document &document) {
    const float row = context.px(kRow), top = ImGui::GetCursorPosY(), height = ImGui::GetWindowHeight();
    const std::size_t count = tree_.rows().size();
    if (reveal_ && *reveal_ < count) {
        const float y = top + row * static_cast<float>(*reveal_), scroll = ImGui::GetScrollY();
        if (y < scroll || y + row > scroll + height) {
            ImGui::SetScrollY(std::max(0.0F, y - (height - row) / 2));
            context.animate();
        }
    }
    reveal_.reset();
    const float scroll = ImGui::GetScrollY() - top;
    const auto first = static_cast<std::size_t>(std::max(0.0F, std::floor(scroll / row)));
    const auto last = static_cast<std::size_t>(std::max(0.0F, std::ceil((scroll + height) / row)));
    for (std::size_t k = first; k < std::min(last, count); ++k) {
        ImGui::SetCursorPosY(top + row * static_cast<float>(k));
        drawRow(context, document, k);
    }
    ImGui::SetCursorPosY(top + row * static_cast<float>(count));
    ImGui::Dummy({0, 0});
}

bool ShapesPanel::isSelected(const Shell &context, const Document &document, const TreeRow &row) const {
    const Selection &selection = context.selection;
    switch (row.kind) {
    case RowKind::Shape:
        return selection.shapes.contains(document.shapes[row.index]->id);
    case RowKind::ShapePart: {
        const std::uint32_t id = document.shapes[row.index]->id;
        return selection.shapes.contains(id) || selectedParts_.contains({id, row.tag});
    }
    case RowKind::Part:
        return selectedTags_.contains(row.tag);
    case RowKind::Region:
        return selection.markers.contains(row.index);
    default:
        return false;
    }
}

/// Draws the background of a row, brighter where it, or a part of it, is selected.
void ShapesPanel::drawPlate(Shell &context, const Document &document, const TreeRow &row, ImVec2 at, ImVec2 end,
                            bool lit) const {
    const bool selected = isSelected(context, document, row);
    const bool touched = row.kind == RowKind::Shape && context.selection.touches(document.shapes[row.index]->id);
    if (selected || touched || lit) {
        ImGui::GetWindowDrawList()->AddRectFilled(at, end,
                                                  selected  ? context.theme.selectedRow
                                                  : touched ? fade(context.theme.selectedRow, 0.5)
                                                            : context.theme.hovered,
                                                  context.px(4));
    }
}

/// Draws the arrow of a row that folds; that of a group is a part of its row.
void ShapesPanel::drawArrow(Shell &context, const TreeRow &row, const Shape *shape, ImVec2 at,
                            const std::string &name) {
    const float height = context.px(kRow);
    if (shape != nullptr) {
        ImGui::SetCursorScreenPos(at);
        if (ui::hitArea((name + "/fold").c_str(), context.px(kIndent), height)) {
            tree_.unfold(shape->id, !tree_.unfolded(shape->id));
            context.animate();
        }
        ui::mark(context, name + "/fold");
    }
    const bool open = shape != nullptr ? tree_.unfolded(shape->id) : !tree_.folded(row.kind);
    ImGui::GetWindowDrawList()->AddText({at.x + context.px(3), at.y + (height - ImGui::GetFontSize()) / 2},
                                        context.theme.muted, open ? icon::kDown : icon::kRight);
}

void ShapesPanel::drawRow(Shell &context, const Document &document, std::size_t index) {
    const TreeRow row = tree_.rows()[index];
    const Shape *const shape = row.kind == RowKind::Shape ? document.shapes[row.index].get() : nullptr;
    const std::string name = rowName(document, row);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 end{at.x + ImGui::GetContentRegionAvail().x, at.y + context.px(kRow)};
    const double depth = row.isGroup() ? 0.0 : row.kind == RowKind::ShapePart ? 2.0 : 1.0;
    const float left = at.x + context.px(kIndent * depth);
    const float text = left + context.px(row.isGroup() || shape != nullptr ? kIndent : 4.0);
    const float right = end.x - (shape != nullptr ? context.px(2.0 * kSwitch) : 0.0F);
    const bool lit = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(at, end);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    drawPlate(context, document, row, at, end, lit);
    const std::optional<NamedThing> &named = context.naming.thing;
    if (named && context.naming.inPanel && rowOf(document, *named).same(row)) {
        ImGui::SetCursorScreenPos({text, at.y});
        drawField(context, document, NamedThing(*named), (right - text) / context.scale);
    } else {
        const float begin = row.isGroup() ? at.x : text;
        ImGui::SetCursorScreenPos({begin, at.y});
        ui::hitArea(name.c_str(), right - begin, end.y - at.y);
        ui::mark(context, name);
        if (ImGui::IsItemClicked(ImGuiMouseButton_Left)) {
            click(context, document, index);
        } else if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
            openMenu(context, document, index);
        }
        drawText(context, document, row, {text, at.y}, right - text);
    }
    if (row.isGroup() || (shape != nullptr && row.count > 1)) {
        drawArrow(context, row, shape, {left, at.y}, name);
    }
    if (shape != nullptr) {
        ImGui::SetCursorScreenPos({right, at.y + context.px((kRow - kSwitch) / 2)});
        drawSwitches(context, *shape, lit);
    }
    ImGui::PopStyleVar();
}

void ShapesPanel::drawText(Shell &context, const Document &document, const TreeRow &row, ImVec2 at, float width) const {
    const Theme &theme = context.theme;
    const bool faint = row.kind == RowKind::Shape && document.shapes[row.index]->hidden;
    ImFont *const font = row.isGroup() ? context.fonts.heading : context.fonts.body;
    const float gap = context.px(6);
    const std::string title = rowTitle(document, row);
    ImGui::PushFont(font);
    const float left = width - ImGui::CalcTextSize(title.c_str()).x - 2.0F * gap; // beside the title
    ImGui::PopFont();
    ImGui::PushFont(context.fonts.small);
    const std::string detail = ui::oneLine(rowDetail(document, row), std::clamp(left, 0.3F * width, 0.6F * width));
    const float room = detail.empty() ? 0.0F : ImGui::CalcTextSize(detail.c_str()).x + gap;
    const float small = ImGui::GetFontSize();
    ImGui::PopFont();
    ImGui::PushFont(font);
    const float y = at.y + (context.px(kRow) - ImGui::GetFontSize()) / 2;
    ui::shortened(context, Pixel(at.x, y), at.x + width - room - gap, title,
                  faint           ? theme.faint
                  : row.isGroup() ? theme.muted
                                  : theme.text);
    ImGui::PopFont();
    ImGui::GetWindowDrawList()->AddText(context.fonts.small, small,
                                        {at.x + width - room, at.y + (context.px(kRow) - small) / 2},
                                        faint ? theme.faint : theme.muted, detail.c_str());
}

/// Draws the switches for visibility and lock; those that are off only faintly, unless the pointer is over the row.
void ShapesPanel::drawSwitches(Shell &context, const Shape &shape, bool lit) {
    const std::string name = "shapes/" + std::to_string(shape.id);
    const std::set<std::uint32_t> only{shape.id};
    const auto button = [&](const char *id, const char *icon, const char *tip, bool on) {
        ImGui::PushStyleVar(ImGuiStyleVar_Alpha, on || lit ? 1.0F : 0.45F);
        const bool pressed = ui::iconButton(context, name + id, icon, tip, on, true, static_cast<float>(kSwitch));
        ImGui::PopStyleVar();
        return pressed;
    };
    if (button("/eye", shape.hidden ? icon::kEyeClosed : icon::kEye, shape.hidden ? "Show" : "Hide", shape.hidden)) {
        context.applyCommand(setHidden(*context.document.current(), only, !shape.hidden),
                             shape.hidden ? "Show shape" : "Hide shape");
        context.selection.drop(only);
    }
    ImGui::SameLine(0, 0);
    if (button("/lock", shape.locked ? icon::kLock : icon::kUnlock, shape.locked ? "Unlock" : "Lock", shape.locked)) {
        context.applyCommand(setLocked(*context.document.current(), only, !shape.locked),
                             shape.locked ? "Unlock shape" : "Lock shape");
        context.selection.drop(only);
    }
}

/// Draws the field in which a row is renamed. Enter, Tab or a click elsewhere applies the name, Esc keeps the old one.
void ShapesPanel::drawField(Shell &context, const Document &document, const NamedThing &thing, float width) {
    Naming &naming = context.naming;
    if (naming.frames++ == 0) {
        context.widgets.fields.request(kRenameField);
    }
    const float pad = (context.px(kRow) - ImGui::GetFontSize()) / 2;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(context.px(4), pad));
    std::string text = thing.name(document);
    const bool changed = ui::entry(context, kRenameField, text, "name", width, true);
    ImGui::PopStyleVar();
    const auto &entry = context.widgets.fields.entry;
    const bool open = (entry && entry->name == kRenameField) || context.widgets.fields.travelling();
    if (changed) {
        naming.close();
        applyName(context, thing, text);
    } else if (!open && naming.frames > 1) {
        naming.close();
        context.animate();
    }
}

/// A click on a group folds it, on another row selects it; a double-click renames.
void ShapesPanel::click(Shell &context, const Document &document, std::size_t index) {
    const TreeRow row = tree_.rows()[index];
    if (row.isGroup()) {
        tree_.fold(row.kind, !tree_.folded(row.kind));
        context.animate();
        return;
    }
    context.naming.row = thingOf(document, row);
    const bool modified = ImGui::GetIO().KeyCtrl || ImGui::GetIO().KeyShift;
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && !modified) {
        context.naming.openInPanel(*context.naming.row);
        context.animate();
        return;
    }
    choose(context, document, index);
}

void ShapesPanel::choose(Shell &context, const Document &document, std::size_t index) {
    const TreeRow row = tree_.rows()[index];
    const bool toggles = ImGui::GetIO().KeyCtrl;
    const bool removes = toggles && isSelected(context, document, row);
    Selection &selection = context.selection;
    if (!toggles) {
        selection.clear();
    }
    const std::vector<TreeRow> &rows = tree_.rows();
    const auto anchor =
        std::find_if(rows.begin(), rows.end(), [&](const TreeRow &each) { return rowName(document, each) == anchor_; });
    if (ImGui::GetIO().KeyShift && anchor != rows.end()) {
        const auto from = static_cast<std::size_t>(anchor - rows.begin());
        chooseRange(context, document, std::min(from, index), std::max(from, index));
    } else {
        anchor_ = rowName(document, row);
        const Selection items = itemsOf(document, row);
        const auto change = [removes](auto &all, const auto &some) {
            for (const auto &item : some) {
                removes ? static_cast<void>(all.erase(item)) : static_cast<void>(all.insert(item));
            }
        };
        change(selection.shapes, items.shapes);
        change(selection.segments, items.segments);
        change(selection.markers, items.markers);
    }
    selection.prune(document); // hidden and locked shapes cannot be selected
    noteSelection(context, document);
    context.tools.choose("select", context);
    context.animate();
}

void ShapesPanel::chooseRange(Shell &context, const Document &document, std::size_t from, std::size_t to) const {
    Selection &selection = context.selection;
    for (std::size_t k = from; k <= to; ++k) {
        if (const TreeRow &row = tree_.rows()[k]; !row.isGroup()) {
            Selection items = itemsOf(document, row);
            selection.shapes.merge(items.shapes);
            selection.segments.merge(items.segments);
            selection.markers.merge(items.markers);
        }
    }
    std::erase_if(selection.segments,
                  [&](const SegmentRef &segment) { return selection.shapes.contains(segment.shape); });
}

/// Selects the item of a row, if possible, and opens its menu.
void ShapesPanel::openMenu(Shell &context, const Document &document, std::size_t index) {
    const TreeRow row = tree_.rows()[index];
    if (row.isGroup()) {
        openGroupMenu(context);
        return;
    }
    context.naming.row = thingOf(document, row);
    if (!isSelected(context, document, row)) {
        choose(context, document, index);
    }
    const Shape *const shape = row.kind == RowKind::Shape ? document.shapes[row.index].get() : nullptr;
    if (shape == nullptr || (!shape->hidden && !shape->locked)) {
        context.menu.open(selectionMenu());
        return;
    }
    openHiddenMenu(context, *shape);
}

/// Opens the menu of a hidden or locked shape, which cannot be selected.
void ShapesPanel::openHiddenMenu(Shell &context, const Shape &shape) {
    const std::uint32_t id = shape.id;
    const auto change = [id](Result<Document> (*command)(const Document &, const std::set<std::uint32_t> &, bool),
                             const char *label) {
        return [id, command, label](Shell &c) { c.applyCommand(command(*c.document.current(), {id}, false), label); };
    };
    ContextGroup own{actionOf("edit.rename")};
    if (shape.hidden) {
        own.push_back(commandOf("show", "Show", change(setHidden, "Show shape")));
    }
    if (shape.locked) {
        own.push_back(commandOf("unlock", "Unlock", change(setLocked, "Unlock shape")));
    }
    own.push_back(commandOf("zoom", "Zoom to shape", [box = boundsOf(shape)](Shell &c) {
        c.view.fit(box.grown(std::max(0.15 * box.diagonal(), 1e-3)));
        c.view.fitted.reset();
    }));
    own.push_back(commandOf("remove", "Delete",
                            [id](Shell &c) { c.applyCommand(removeShapes(*c.document.current(), {id}), "Delete"); }));
    context.menu.open({std::move(own), actionsOf({"shape.showAll", "shape.unlockAll"})});
}

void ShapesPanel::openGroupMenu(Shell &context) {
    const auto fold = [this](bool folds) {
        return [this, folds](Shell &c) { tree_.foldAll(*c.document.current(), folds); };
    };
    context.menu.open({actionsOf({"edit.selectAll", "edit.paste", "shape.showAll", "shape.unlockAll"}),
                       {commandOf("unfold", "Unfold all", fold(false)), commandOf("fold", "Fold all", fold(true))}});
}

} // namespace

std::unique_ptr<Panel> makeShapesPanel() {
    return std::make_unique<ShapesPanel>();
}

} // namespace forefront
