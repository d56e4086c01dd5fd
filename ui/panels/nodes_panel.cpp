#include "core/drawing/shapes/shape_commands.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/drawing_files/clipboard/node_table.hpp"
#include "core/engine/base/number_text.hpp"
#include "ui/panels/edit_panels.hpp"
#include "ui/panels/geometry_rows.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/text_wrap.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"
#include "ui/workspace/number_field.hpp"
#include "ui/workspace/typed_command.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace forefront {
namespace {

constexpr float kNodeRow = 28.0F, kNodeNumber = 40.0F; ///< height of a row, width of its number; design pixels
constexpr std::size_t kShownFaults = 20;               ///< lines of a pasted table that can be corrected at a time

/// A line of the panel: a node, or the heading of a shape.
struct NodeLine {
    NodeRef node;
    Vec2 at;
    bool heading = false;
};

/// The table of the nodes of the selected shapes, or of all. A pasted table with faults is kept until they are
/// corrected or it is discarded; nothing is moved before.
class NodesPanel final : public Panel {
  public:
    const char *id() const override { return "nodes"; }
    const char *title() const override { return "Nodes"; }

    void draw(Shell &context) override {
        constexpr std::array<const char *, 2> kChoices{"Selected", "All shapes"};
        int choice = all_ ? 1 : 0;
        if (ui::segmented(context, "nodes/which", std::span<const char *const>(kChoices), choice)) {
            all_ = choice == 1;
        }
        if (loads_ != context.document.loads()) {
            loads_ = context.document.loads();
            pasted_.clear(); // it was meant for another document
        }
        read(context);
        drawButtons(context);
        if (!pasted_.empty()) {
            drawPasted(context);
            return; // the table is as it was
        }
        if (lines_.empty()) {
            ui::small(context, all_ ? "Draw a shape to see its nodes here." : "Select shapes to see their nodes here.",
                      true);
            ui::mark(context, "nodes/empty");
            return;
        }
        drawLines(context);
    }

    std::vector<ContextGroup> menu(Shell &) override {
        return {{commandOf("nodes/copy", "Copy table", [this](Shell &c) { copy(c); }),
                 commandOf("nodes/paste", "Paste table", [this](Shell &c) { paste(c); })}};
    }

  private:
    void copy(Shell &context) const {
        const std::vector<NodeRow> rows = nodeRows(*context.document.current(), shapes_);
        context.platform.setClipboard(nodeTableText(rows));
        context.log.announce("Copied " + countText(rows.size(), "node"));
    }

    void paste(Shell &context) {
        pasted_ = linesOf(context.platform.clipboard());
        if (pasted_.empty()) {
            context.log.add(error("no-drawing", "the clipboard holds no text",
                                  "copy the columns x and y of a spreadsheet, or shape, node, x and y"));
            return;
        }
        takePasted(context);
    }

    /// Moves the nodes to the places of the pasted table, or keeps it with its faults.
    void takePasted(Shell &context) {
        NodeTableResult result = placeNodes(*context.document.current(), shapes_, pasted_);
        faults_ = std::move(result.faults);
        fault_ = std::move(result.fault);
        context.animate();
        if (!result.next) {
            return;
        }
        if (result.moved == 0) {
            context.log.announce("The nodes are where the table has them");
        } else if (applyTyped(context, *std::move(result.next), "Place " + countText(result.moved, "node"))) {
            context.log.announce("Placed " + countText(result.moved, "node"));
            context.view.reveal(boundsOf(*context.document.current(), context.selection));
        }
        pasted_.clear(); // what the drawing refuses is in the log
    }

    void drawButtons(Shell &context) {
        if (ui::button(context, "nodes/copy", "Copy table", ui::ButtonKind::Plain, !lines_.empty())) {
            copy(context);
        }
        ui::tooltip(context, "Copy the nodes for a spreadsheet: shape, node, x and y with all digits");
        ImGui::SameLine();
        if (ui::button(context, "nodes/paste", "Paste table")) {
            paste(context);
        }
        ui::tooltip(context,
                    "Move the nodes to the places in the clipboard: the table as copied here, or the columns x "
                    "and y for the nodes of the selected shape in their order");
    }

    /// Draws what is wrong with the pasted table; each line can be corrected in place.
    void drawPasted(Shell &context) {
        const std::size_t shown = std::min(faults_.size(), kShownFaults);
        drawReason(context, fault_.empty() ? countText(faults_.size(), "line") + " of the pasted table cannot be used; "
                                                                                 "no node was moved"
                                           : fault_);
        ui::mark(context, "nodes/fault");
        for (std::size_t k = 0; k < shown; ++k) {
            const std::size_t line = faults_[k].line;
            ImGui::AlignTextToFramePadding();
            ui::muted(context, std::to_string(line + 1));
            ImGui::SameLine(context.px(kNodeNumber));
            const std::optional<std::string> typed = ui::inputChecked(context, "nodes/pasted/" + std::to_string(line),
                                                                      pasted_[line], "leave out this line", -1.0F);
            drawReason(context, faults_[k].reason);
            if (typed) {
                pasted_[line] = *typed;
                takePasted(context);
                return;
            }
        }
        if (shown < faults_.size()) {
            ui::small(context, "and " + countText(faults_.size() - shown, "more line"), true);
        }
        if (ui::button(context, "nodes/again", "Try again")) {
            takePasted(context);
        }
        ui::tooltip(context, "Place the nodes of the pasted table, now that the drawing or the selection is another");
        ImGui::SameLine();
        if (ui::button(context, "nodes/discard", "Discard pasted table")) {
            pasted_.clear();
        }
    }

    static void drawReason(Shell &context, const std::string &reason) {
        ImGui::PushStyleColor(ImGuiCol_Text, context.theme.bad);
        ui::wrappedText(reason);
        ImGui::PopStyleColor();
    }

    /// Reads the nodes of the shapes if they are others than those listed.
    void read(const Shell &context) {
        const Document &document = *context.document.current();
        if (revision_ == context.document.revision() && selection_ == context.selection && readAll_ == all_) {
            return;
        }
        revision_ = context.document.revision();
        selection_ = context.selection;
        readAll_ = all_;
        shapes_.clear();
        for (const auto &shape : document.shapes) {
            if (all_ || selection_.touches(shape->id)) {
                shapes_.insert(shape->id);
            }
        }
        lines_.clear();
        for (const NodeRow &row : nodeRows(document, shapes_)) {
            if (row.node.node == 0) {
                lines_.push_back({row.node, {}, true});
            }
            lines_.push_back({row.node, row.at, false});
        }
    }

    void drawLines(Shell &context) {
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(6), 0));
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(lines_.size()), context.px(kNodeRow));
        // What is edited is drawn even if it is scrolled away, or its text would be lost, and so are its neighbours for
        // Tab.
        const int edited = editedLine(context), count = static_cast<int>(lines_.size());
        clipper.ForceDisplayRangeByIndices(std::max(edited - 2, 0), std::min(edited + 3, count));
        while (clipper.Step()) {
            for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
                drawLine(context, static_cast<std::size_t>(k));
                if (revision_ != context.document.revision()) {
                    clipper.End();
                    ImGui::PopStyleVar();
                    return; // the lines show the previous document
                }
            }
        }
        ImGui::PopStyleVar();
    }

    /// Returns the line whose field is being edited; the first one if none is.
    int editedLine(const Shell &context) const {
        const FieldFocus &fields = context.widgets.fields;
        if (edited_ < lines_.size() && fields.entry && fields.entry->name.starts_with(nameOf(lines_[edited_]) + '/')) {
            return static_cast<int>(edited_);
        }
        return 0;
    }

    static std::string nameOf(const NodeLine &line) {
        return "nodes/" + std::to_string(line.node.shape) + '/' + std::to_string(line.node.node + 1);
    }

    void drawLine(Shell &context, std::size_t index) {
        const NodeLine &line = lines_[index];
        const Shape &shape = *findShape(*context.document.current(), line.node.shape);
        const float top = ImGui::GetCursorPosY();
        if (line.heading) {
            ImGui::AlignTextToFramePadding();
            ui::small(context, displayName(shape));
        } else {
            drawNumber(context, line, shape.locked);
            ImGui::SameLine(0, context.px(6));
            drawPlace(context, index, shape);
        }
        ImGui::SetCursorPosY(top + context.px(kNodeRow));
    }

    static void drawNumber(Shell &context, const NodeLine &line, bool locked) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const ImVec2 size{context.px(kNodeNumber), context.px(24)};
        const std::string name = nameOf(line);
        const bool pressed = ui::hitArea(name.c_str(), size.x, size.y);
        ui::mark(context, name, !locked);
        ImDrawList &list = *ImGui::GetWindowDrawList();
        const bool chosen = context.selection.nodes.contains(line.node);
        if (chosen || (ImGui::IsItemHovered() && !locked)) {
            list.AddRectFilled(at, {at.x + size.x, at.y + size.y},
                               chosen ? context.theme.selectedRow : context.theme.hovered, context.px(4));
        }
        const std::string text = std::to_string(line.node.node + 1);
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        list.AddText({at.x + size.x - context.px(6) - width, std::round(at.y + 0.5F * (size.y - ImGui::GetFontSize()))},
                     context.theme.muted, text.c_str());
        if (pressed && !locked) {
            context.tools.choose("select", context);
            context.selection.clear();
            context.selection.nodes = {line.node};
            context.view.reveal(boxOf(line.at, line.at));
            context.animate();
        }
    }

    void drawPlace(Shell &context, std::size_t index, const Shape &shape) {
        const NodeLine &line = lines_[index];
        const std::string name = nameOf(line);
        const bool follows = shape.is<SlotForm>() && !isCentre(shape, line.node.node);
        if (shape.locked || follows) {
            ImGui::AlignTextToFramePadding();
            ui::muted(context, ui::editedNumber(line.at.x) + ", " + ui::editedNumber(line.at.y));
            ui::tooltip(context, shape.locked ? "The shape is locked" : "Follows from the width of the slot");
            return;
        }
        Vec2 at = line.at;
        const form::PairAddress address = handleAddress(shape, line.node.node);
        const bool changed =
            ui::inputPoint(context, name, at, form::halfWidth(context), address.x, address.y, ui::Digits::All);
        const FieldFocus &fields = context.widgets.fields;
        if (fields.entry && fields.entry->name.starts_with(name + '/')) {
            edited_ = index;
        }
        if (changed) {
            applyTyped(context, setHandle(*context.document.current(), line.node, at), "Move node");
            context.view.reveal(boxOf(at, at));
        }
    }

    bool all_ = false;
    std::vector<NodeLine> lines_;    ///< of the document of revision_
    std::set<std::uint32_t> shapes_; ///< that are listed
    Selection selection_;            ///< when they were read
    std::uint64_t revision_ = 0;
    bool readAll_ = false;
    std::size_t edited_ = 0; ///< line whose field was last edited

    std::uint64_t loads_ = 0;         ///< DocumentStore::loads() when the panel was last drawn
    std::vector<std::string> pasted_; ///< lines of a table that is at fault; empty: none is
    std::vector<TableFault> faults_;
    std::string fault_;
};

} // namespace

std::unique_ptr<Panel> makeNodesPanel() {
    return std::make_unique<NodesPanel>();
}

} // namespace forefront
