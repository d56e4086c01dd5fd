#include "core/drawing/document/document.hpp"
#include "core/engine/refine/least_angle.hpp"
#include "ui/panels/edit_panels.hpp"
#include "ui/panels/form.hpp"
#include "ui/parts/shell.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/widgets/enum_choice.hpp"

#include <imgui.h>

#include <optional>
#include <string>

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
        drawRules(context, options);
        form::label(context, "Improve");
        ImGui::BeginGroup();
        changed = ui::segmented(context, "meshing/improve", options.improve) || changed;
        ImGui::EndGroup();
        ui::rowTooltip(context,
                       "Improve the finished mesh. Default: swap edges and move interior nodes. Best: slower, also "
                       "adds and removes interior nodes. None: fastest; the mesh does not change.");
        changed = drawLeastAngle(context, options) || changed;
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
    static constexpr float kAngleField = 58.0F;

    /// Draws the shapes of the elements, their order, and the nodes of quadrilaterals of second order. Returns true if
    /// an option has changed.
    static bool drawElements(Shell &context, MeshingOptions &options) {
        form::label(context, "Elements");
        ImGui::BeginGroup();
        bool changed = ui::segmented(context, "meshing/elements", options.elements);
        ImGui::EndGroup();
        ui::rowTooltip(context, "Quads: quadrilaterals. Mixed: triangles where quadrilaterals would be badly shaped. "
                                "A region can have its own.");
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

    /// Draws the least angle of triangles. Returns true if it has changed.
    static bool drawLeastAngle(Shell &context, MeshingOptions &options) {
        if (options.elements != Elements::Triangles) {
            return false;
        }
        form::label(context, "Least angle");
        std::optional<double> angle = options.leastAngle;
        const bool entered = form::optionalField(context, "meshing/leastangle", angle, "none", kAngleField, {});
        ui::rowTooltip(context, "No angle is smaller, in degrees up to 33, except at sharp corners and beside segments "
                                "that are kept: nodes are added and lines divided where needed. Empty: no promise.");
        if (!entered || (angle && !ui::checkRange(context, "meshing/leastangle", *angle, 0.0, kMaxLeastAngle))) {
            return false;
        }
        options.leastAngle = angle && *angle > 0.0 ? angle : std::nullopt;
        return true;
    }

    /// Leads to the rules of the classic method.
    static void drawRules(Shell &context, const MeshingOptions &options) {
        if (options.method != Method::Classic || options.elements != Elements::Triangles) {
            return;
        }
        const std::size_t changed = changedRules(options.rules).size();
        form::label(context, "Rules");
        ImGui::AlignTextToFramePadding();
        if (ui::link(context, "meshing/rules",
                     changed == 0   ? "Defaults\xe2\x80\xa6"
                     : changed == 1 ? "1 changed\xe2\x80\xa6"
                                    : std::to_string(changed) + " changed\xe2\x80\xa6")) {
            showPanel(context, "rules");
        }
        ui::rowTooltip(context, changed == 0 ? "Change the rules of the classic method in the Rules panel."
                                             : "Changed: " + changesText(options.rules));
    }
};

} // namespace

std::unique_ptr<Panel> makeMeshingPanel() {
    return std::make_unique<MeshingPanel>();
}

} // namespace forefront
