#include "core/drawing/document/document.hpp"
#include "ui/panels/edit_panels.hpp"
#include "ui/panels/form.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/enum_choice.hpp"

#include <imgui.h>

namespace forefront {
namespace {

class MeshingPanel final : public Panel {
  public:
    const char *id() const override { return "meshing"; }
    const char *title() const override { return "Meshing"; }

    void draw(Shell &context) override {
        MeshingOptions options = context.document.current()->options;
        bool changed = drawElements(context, options);
        form::label(context, "Method");
        ImGui::BeginGroup();
        changed = ui::segmented(context, "meshing/method", options.method) || changed;
        ImGui::EndGroup();
        ui::rowTooltip(context, "Fast: walks along the front and makes up to three elements per advance. Classic: the "
                                "ten steps, one element per advance.");
        form::label(context, "Improve");
        ImGui::BeginGroup();
        changed = ui::segmented(context, "meshing/improve", options.improve) || changed;
        ImGui::EndGroup();
        ui::rowTooltip(context,
                       "Improve the finished mesh. Default: swap edges and move interior nodes. Best: slower, also "
                       "adds and removes interior nodes. None: fastest; the mesh does not change.");
        form::label(context, "Boundary");
        changed = ui::checkbox(context, "meshing/keepboundary", "Keep segments", options.keepBoundary) || changed;
        ui::rowTooltip(context, "Keep the drawn segments as mesh edges; do not subdivide them.");
        form::label(context, "Grid");
        changed = ui::combo(context, "meshing/grid", options.grid) || changed;
        ui::rowTooltip(context, "Background grid that speeds up searches on the front. It affects speed, never the "
                                "mesh. Turn on the Grid cells layer to see it.");
        if (changed) {
            Document next = *context.document.current();
            next.options = options;
            context.document.apply(std::move(next), "Change meshing options");
        }
    }

  private:
    /// Draws the shapes of the elements, their order, and the nodes of quadrilaterals of second order. Returns true if
    /// an option has changed.
    static bool drawElements(Shell &context, MeshingOptions &options) {
        form::label(context, "Elements");
        ImGui::BeginGroup();
        bool changed = ui::segmented(context, "meshing/elements", options.elements);
        ImGui::EndGroup();
        ui::rowTooltip(context, "Quads: quadrilaterals. Mixed: triangles where quadrilaterals would be badly shaped. "
                                "Only triangles can be stepped.");
        form::label(context, "Order");
        ImGui::BeginGroup();
        changed = ui::segmented(context, "meshing/order", options.order) || changed;
        ImGui::EndGroup();
        ui::rowTooltip(context, "2: each edge has a node in its middle, which lies on the curve of the boundary.");
        if (options.order == ElementOrder::Second && options.elements != Elements::Triangles) {
            form::label(context, "Nodes");
            ImGui::BeginGroup();
            changed = ui::segmented(context, "meshing/quadnodes", options.quadNodes) || changed;
            ImGui::EndGroup();
            ui::rowTooltip(context, "Nodes of each quadrilateral. 9: one in its centre as well.");
        }
        return changed;
    }
};

} // namespace

std::unique_ptr<Panel> makeMeshingPanel() {
    return std::make_unique<MeshingPanel>();
}

} // namespace forefront
