#include "ui/lessons/highlight_names.hpp"

#include "core/teaching/lesson/lesson_names.hpp"
#include "ui/parts/shell.hpp"

#include <string_view>

namespace forefront {

std::map<std::string, std::vector<std::string>> highlightNames(const Shell &context) {
    std::map<std::string, std::vector<std::string>> names = widgetNames();
    const auto add = [&names](const std::string &group, std::string_view name) {
        names[group].push_back(group + '/' + std::string(name));
    };
    for (const LayerSlot &slot : context.layers) {
        add("layer", slot.layer->id());
    }
    for (const auto &panel : context.panels) {
        add("panel", panel->id());
    }
    for (const auto &tool : context.tools.tools) {
        add("tool", tool->id());
    }
    return names;
}

} // namespace forefront
