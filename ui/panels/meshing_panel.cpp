#include "core/drawing/document/document.hpp"
#include "ui/panels/edit_panels.hpp"
#include "ui/panels/form.hpp"
#include "ui/parts/shell.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/widgets/enum_choice.hpp"

#include <imgui.h>

#include <string>

namespace forefront {
namespace {

class MeshingPanel final : public Panel {
  public:
    const char *id() const override { return "meshing"; }
    const char *title() const override { return "Meshing"; }

    void draw(Shell &context) override {
        MeshingOptions options = context.document.current()->options;
        bool changed = false;
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
