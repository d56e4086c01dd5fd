#include "core/edit/document.hpp"
#include "ui/editor/app_context.hpp"
#include "ui/panels/edit_panels.hpp"
#include "ui/panels/form.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

namespace forefront {
namespace {

class MeshingPanel final : public Panel {
  public:
    const char *id() const override { return "meshing"; }
    const char *title() const override { return "Meshing"; }

    void draw(AppContext &context) override {
        MeshingOptions options = context.document().current()->options;
        bool changed = false;
        form::label(context, "Method");
        static constexpr const char *kMethods[] = {"Fast", "Classic"};
        int method = static_cast<int>(options.method);
        ImGui::BeginGroup();
        if (ui::segmented(context, "meshing/method", kMethods, method)) {
            options.method = static_cast<Method>(method);
            changed = true;
        }
        ImGui::EndGroup();
        ui::tooltip(context,
                    "Fast: walks along the front, up to three elements an advance. Classic: the ten steps, one "
                    "element an advance.");
        form::label(context, "Improve");
        static constexpr const char *kLevels[] = {"None", "Default", "Best"};
        int level = static_cast<int>(options.improve);
        ImGui::BeginGroup();
        if (ui::segmented(context, "meshing/improve", kLevels, level)) {
            options.improve = static_cast<ImproveLevel>(level);
            changed = true;
        }
        ImGui::EndGroup();
        ui::tooltip(context, "Swapping edges and moving inner nodes once the front has closed. Best takes longer "
                             "and also adds and removes inner nodes; None goes with the quickest front.");
        form::label(context, "Boundary");
        changed = ui::checkbox(context, "meshing/keepboundary", "Keep its segments", options.keepBoundary) || changed;
        ui::tooltip(context, "The segments drawn become edges as they are, however long; no nodes are put between");
        form::label(context, "Grid");
        static constexpr const char *kGrids[] = {"none", "uniform", "hierarchical"};
        int grid = static_cast<int>(options.grid);
        if (ui::combo(context, "meshing/grid", kGrids, grid)) {
            options.grid = static_cast<GridKind>(grid);
            changed = true;
        }
        ui::tooltip(context, "The background grid answers the searches of the front: it changes the work, never the "
                             "mesh. Show it with the layer Grid cells.");
        if (changed) {
            Document next = *context.document().current();
            next.options = options;
            context.document().apply(std::move(next), "Change meshing options");
        }
    }
};

} // namespace

std::unique_ptr<Panel> makeMeshingPanel() {
    return std::make_unique<MeshingPanel>();
}

} // namespace forefront
