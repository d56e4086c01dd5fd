#include "ui/panels/panels.hpp"
#include "ui/parts/shell.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>

namespace forefront {

namespace {

class LayersPanel final : public Panel {
  public:
    const char *id() const override { return "layers"; }
    const char *title() const override { return "Layers"; }
    bool foldsInLowWindow() const override { return true; }

    void draw(Shell &context) override {
        ImGui::PushFont(context.fonts.small);
        constexpr float kEye = 24.0F, kGap = 2.0F, kMargin = 3.0F;
        float widest = 0.0F;
        for (const LayerSlot &slot : context.layers) {
            widest = std::max(widest, ImGui::CalcTextSize(slot.layer->name()).x / context.scale);
        }
        const float width = ImGui::GetContentRegionAvail().x / context.scale;
        const int columns = std::clamp(static_cast<int>((width + kGap) / (kEye + widest + kMargin + kGap)), 1, 4);
        const float each = width / static_cast<float>(columns) - kGap;
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(context.px(kGap), 0));
        int at = 0;
        for (LayerSlot &slot : context.layers) {
            if (at % columns != 0) {
                ImGui::SameLine();
            }
            ++at;
            bool visible = slot.visible;
            if (ui::eyeSwitch(context, std::string("layer/") + slot.layer->id(), slot.layer->name(), visible, each)) {
                showLayer(context.layers, slot.layer->id(), visible);
                if (slot.layer->coloursByValue()) {
                    context.coloursBefore.reset(); // the user's own choice
                }
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
