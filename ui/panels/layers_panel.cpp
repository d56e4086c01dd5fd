#include "ui/panels/panels.hpp"
#include "ui/widgets.hpp"

#include <imgui.h>

namespace forefront {

namespace {

class LayersPanel final : public Panel {
  public:
    const char *id() const override { return "layers"; }
    const char *title() const override { return "Layers"; }

    void draw(AppContext &context) override {
        const float width = ImGui::GetContentRegionAvail().x / context.scale;
        const int columns = width > 420.0F ? 3 : 2;
        const float each = width / static_cast<float>(columns) - 4.0F;
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(4), context.px(1)));
        int at = 0;
        for (LayerSlot &slot : context.layers) {
            if (at % columns != 0) {
                ImGui::SameLine();
            }
            ++at;
            if (ui::eyeSwitch(context, std::string("layer/") + slot.layer->id(), slot.layer->name(), slot.visible,
                              each)) {
                context.animate();
            }
        }
        ImGui::PopStyleVar();
    }
};

} // namespace

std::unique_ptr<Panel> makeLayersPanel() {
    return std::make_unique<LayersPanel>();
}

} // namespace forefront
