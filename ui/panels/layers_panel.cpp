#include "ui/panels/panels.hpp"
#include "ui/parts/shell.hpp"
#include "ui/parts/shown_panels.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace forefront {

namespace {

class LayersPanel final : public Panel {
  public:
    const char *id() const override { return "layers"; }
    const char *title() const override { return "Layers"; }
    PanelPlace place() const override { return PanelPlace::Canvas; }

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
            if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
                openMenu(context, slot);
            }
        }
        ImGui::PopStyleVar();
        ImGui::PopFont();
    }

    std::vector<ContextGroup> menu(Shell &) override {
        return {{commandOf("defaults", "Default layers of this workspace", showPresetLayers)}};
    }

  private:
    void openMenu(Shell &context, const LayerSlot &slot) {
        const std::string id = slot.layer->id(), name = slot.layer->name();
        std::vector<ContextGroup> groups = menu(context);
        groups.insert(groups.begin(), {switchOf("show", "Show " + name, slot.visible,
                                                [id, on = !slot.visible](Shell &c) { showLayer(c.layers, id, on); }),
                                       commandOf("only", "Show only this layer and the boundary", [id](Shell &c) {
                                           for (const LayerSlot &other : c.layers) {
                                               const std::string_view each = other.layer->id();
                                               showLayer(c.layers, each, each == id || each == "boundary");
                                           }
                                           c.coloursBefore.reset();
                                       })});
        context.menu.open(std::move(groups));
    }
};

} // namespace

std::unique_ptr<Panel> makeLayersPanel() {
    return std::make_unique<LayersPanel>();
}

} // namespace forefront
