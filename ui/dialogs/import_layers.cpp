#include "ui/dialogs/import_layers.hpp"

#include "ui/widgets/widgets.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace forefront {

namespace {

constexpr float kMaxLayers = 4.5F; ///< switches shown at once; more are scrolled

/// Returns for each layer whether it is in a list with commas.
std::vector<bool> layersIn(const std::vector<std::string> &layers, const std::string &list) {
    std::vector<bool> on;
    for (const std::string &layer : layers) {
        on.push_back((',' + list + ',').find(',' + layer + ',') != std::string::npos);
    }
    return on;
}

std::string listOf(const std::vector<std::string> &layers, const std::vector<bool> &on) {
    std::string list;
    for (std::size_t k = 0; k < layers.size(); ++k) {
        list += on[k] ? (list.empty() ? "" : ",") + layers[k] : std::string();
    }
    return list;
}

bool drawSwitches(Shell &context, const DrawingContents &contents, std::optional<std::string> &chosen) {
    const std::vector<std::string> &layers = contents.layers;
    std::vector<bool> on = layersIn(layers, chosen.value_or(contents.layer));
    const auto used = std::count(on.begin(), on.end(), true);
    const float row = ImGui::GetFrameHeightWithSpacing();
    bool changed = false;
    ImGui::BeginChild("layers", {0, row * std::min(kMaxLayers, static_cast<float>(layers.size()))}, false,
                      ImGuiWindowFlags_NoNav);
    for (std::size_t k = 0; k < layers.size(); ++k) {
        bool read = on[k];
        if (ui::checkbox(context, "dialog/importoptions/layer/" + std::to_string(k), layers[k], read) &&
            (read || used > 1)) { // one layer stays
            on[k] = read;
            changed = true;
        }
    }
    ImGui::EndChild();
    if (changed) {
        chosen = listOf(layers, on);
    }
    return changed;
}

} // namespace

bool drawLayerChoice(Shell &context, const DrawingContents &contents, std::optional<std::string> &chosen, float labels,
                     float choices) {
    if (contents.layers.size() < 2) {
        return false;
    }
    if (contents.severalLayers) {
        ui::muted(context, "Layers");
        return drawSwitches(context, contents, chosen);
    }
    ui::rowLabel(context, "Layer", labels);
    const auto found = std::find(contents.layers.begin(), contents.layers.end(), chosen.value_or(contents.layer));
    int choice = static_cast<int>(found - contents.layers.begin());
    if (!ui::combo(context, "dialog/importoptions/layer", contents.layers, choice, choices)) {
        return false;
    }
    chosen = contents.layers[static_cast<std::size_t>(choice)];
    return true;
}

} // namespace forefront
