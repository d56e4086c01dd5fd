#include "ui/panels/panels.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

namespace forefront {

namespace {

class LayersPanel final : public Panel {
  public:
    const char *id() const override { return "layers"; }
    const char *title() const override { return "Layers"; }

    void draw(Shell &context) override {
        const float width = ImGui::GetContentRegionAvail().x / context.scale;
        const int columns = width > 390.0F ? 4 : 3;
        const float each = width / static_cast<float>(columns) - 2.0F;
        ImGui::PushFont(context.fonts.small);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(2), 0));
        int at = 0;
        for (LayerSlot &slot : context.layers) {
            if (at % columns != 0) {
                ImGui::SameLine();
            }
            ++at;
            bool visible = slot.visible;
            if (ui::eyeSwitch(context, std::string("layer/") + slot.layer->id(), slot.layer->name(), visible, each)) {
                showLayer(context.layers, slot.layer->id(), visible);
                context.animate();
            }
        }
        ImGui::PopStyleVar();
        ImGui::PopFont();
    }
};

} // namespace

std::unique_ptr<Panel> makeLayersPanel() {
    return std::make_unique<LayersPanel>();
}

} // namespace forefront
