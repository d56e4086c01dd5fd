#include "core/edit/region_commands.hpp"
#include "core/edit/shape_commands.hpp"
#include "core/edit/shape_geometry.hpp"
#include "ui/panels/edit_panels.hpp"
#include "ui/parts/shell.hpp"
#include "ui/style/icons.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/workspace/edit_state.hpp"

#include <imgui.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace forefront {
namespace {

/// The drawing as a tree: boundary parts by tag with their shapes, constraints, regions.
class ShapesPanel final : public Panel {
  public:
    const char *id() const override { return "shapes"; }
    const char *title() const override { return "Shapes"; }
    PanelPlace place() const override { return PanelPlace::Tabbed; }

    void draw(Shell &context) override {
        const std::shared_ptr<const Document> document = context.document.current();
        if (revision_ != context.document.revision()) {
            revision_ = context.document.revision();
            group(*document);
        }
        if (document->shapes.empty()) {
            ui::small(context, "No shapes yet.", true);
        }
        drawShapes(context, *document);
        drawRegions(context, *document);
    }

  private:
    static constexpr std::size_t kMaxRows = 500;

    /// Shows how many rows of a list are not drawn.
    static void drawMissing(Shell &context, const char *name, std::size_t count) {
        if (count > kMaxRows) {
            ui::small(context, "and " + std::to_string(count - kMaxRows) + " more", true);
            ui::mark(context, name);
        }
    }

    void drawShapes(Shell &context, const Document &document) const {
        std::size_t left = kMaxRows;
        for (const auto &[part, shapes] : parts_) {
            if (left == 0) {
                break;
            }
            ui::heading(context, (part.second == ShapeUse::Boundary ? "Boundary " : "Constraint ") +
                                     boundaryName(document.boundaryNames, part.first));
            const std::size_t rows = std::min(left, shapes.size());
            for (std::size_t k = 0; k < rows; ++k) {
                drawShape(context, *document.shapes[shapes[k]]);
            }
            left -= rows;
        }
        drawMissing(context, "shapes/missing", document.shapes.size());
    }

    void group(const Document &document) {
        parts_.clear();
        for (std::size_t k = 0; k < document.shapes.size(); ++k) {
            parts_[{document.shapes[k]->tag, document.shapes[k]->use}].push_back(k);
        }
    }

    /// Draws a row with switches for visibility and lock; clicking the name selects the shape, Ctrl+click adds or
    /// removes it.
    static void drawShape(Shell &context, const Shape &shape) {
        const std::string name = "shapes/" + std::to_string(shape.id);
        const std::set<std::uint32_t> only{shape.id};
        if (ui::iconButton(context, name + "/eye", shape.hidden ? icon::kEyeClosed : icon::kEye,
                           shape.hidden ? "Show" : "Hide", false, true, 24.0F)) {
            EditState::apply(context, setHidden(*context.document.current(), only, !shape.hidden),
                             shape.hidden ? "Show shape" : "Hide shape");
            context.selection.drop(only);
        }
        ImGui::SameLine(0, context.px(4));
        if (ui::iconButton(context, name + "/lock", shape.locked ? icon::kLock : icon::kUnlock,
                           shape.locked ? "Unlock" : "Lock", shape.locked, true, 24.0F)) {
            EditState::apply(context, setLocked(*context.document.current(), only, !shape.locked),
                             shape.locked ? "Unlock shape" : "Lock shape");
            context.selection.drop(only);
        }
        ImGui::SameLine(0, context.px(4));
        const bool selected = context.selection.shapes.contains(shape.id);
        if (ui::selectable(context, name, displayName(shape), selected, kindName(shape)) && !shape.hidden &&
            !shape.locked) {
            choose(context, shape.id, selected);
        }
    }

    static void choose(Shell &context, std::uint32_t id, bool selected) {
        if (!ImGui::GetIO().KeyCtrl) {
            context.selection.clear();
        }
        if (ImGui::GetIO().KeyCtrl && selected) {
            context.selection.shapes.erase(id);
        } else {
            context.selection.shapes.insert(id);
        }
        context.tools.choose("select", context);
    }

    static void drawRegions(Shell &context, const Document &document) {
        if (document.regionMarkers.empty()) {
            return;
        }
        ui::heading(context, "Regions");
        const std::size_t shown = std::min(document.regionMarkers.size(), kMaxRows);
        for (std::uint32_t k = 0; k < shown; ++k) {
            const RegionMarker &marker = document.regionMarkers[k];
            if (ui::selectable(context, "shapes/region/" + std::to_string(k),
                               regionName(document.regionNames, marker.tag), context.selection.markers.contains(k))) {
                context.selection.clear();
                context.selection.markers.insert(k);
                context.tools.choose("select", context);
            }
        }
        drawMissing(context, "shapes/region/missing", document.regionMarkers.size());
    }

    std::map<std::pair<std::int32_t, ShapeUse>, std::vector<std::size_t>> parts_; ///< indices into Document::shapes
    std::uint64_t revision_ = 0;
};

} // namespace

std::unique_ptr<Panel> makeShapesPanel() {
    return std::make_unique<ShapesPanel>();
}

} // namespace forefront
