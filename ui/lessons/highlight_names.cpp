#include "ui/lessons/highlight_names.hpp"

#include "ui/parts/shell.hpp"

#include <string_view>

namespace forefront {

namespace {

constexpr int kSteps = 10;

constexpr std::string_view kTimeline[] = {"start",
                                          "back",
                                          "play",
                                          "forward",
                                          "end",
                                          "speed",
                                          "scrubber",
                                          "position",
                                          "caption",
                                          "plotswitch",
                                          "plot",
                                          "breakpoints",
                                          "granularity/Event",
                                          "granularity/Element",
                                          "granularity/Advance",
                                          "granularity/Layer"};

constexpr std::string_view kStatistics[] = {"Nn",
                                            "Ne",
                                            "area",
                                            "\xce\x93",
                                            "Nb",
                                            "Nc",
                                            "Ns",
                                            "Nt",
                                            "cells",
                                            "candidates",
                                            "new nodes",
                                            "deferred",
                                            "time",
                                            "forced",
                                            "improve",
                                            "hash",
                                            "\xce\xb1 mean",
                                            "\xce\xb1 geom.",
                                            "\xce\xb1 min",
                                            "\xce\xb4 mean",
                                            "min \xe2\x88\xa0",
                                            "max \xe2\x88\xa0"};

} // namespace

std::map<std::string, std::vector<std::string>> highlightNames(const Shell &context) {
    std::map<std::string, std::vector<std::string>> names;
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
    for (const std::string_view name : kTimeline) {
        add("timeline", name);
    }
    for (const std::string_view name : kStatistics) {
        add("statistics", name);
    }
    for (int step = 1; step <= kSteps; ++step) {
        add("steps", std::to_string(step));
    }
    return names;
}

} // namespace forefront
