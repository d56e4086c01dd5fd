#include "core/teaching/lesson/lesson_names.hpp"

#include <span>
#include <string_view>

namespace forefront {

namespace {

using Names = std::span<const std::string_view>;

constexpr int kStepRows = 10;

constexpr std::string_view kLayers[] = {"picture",     "domain",  "size",       "lattice", "quality", "mesh",
                                        "regions",     "grid",    "boundary",   "front",   "tests",   "candidates",
                                        "improvement", "rays",    "guides",     "links",   "sketch",  "marks",
                                        "labels",      "numbers", "dimensions", "faults",  "colours"};
constexpr std::string_view kPanels[] = {"shapes",    "inspector", "names",      "parameters", "spacing",
                                        "meshing",   "steps",     "candidates", "rules",      "statistics",
                                        "histogram", "probe",     "checks",     "adapt",      "layers",
                                        "history",   "log",       "worst",      "nodes"};
constexpr std::string_view kTools[] = {"select",  "polygon",  "polyline", "rectangle", "circle", "ellipse",
                                       "regular", "slot",     "arc",      "point",     "trim",   "region",
                                       "source",  "gradient", "brush",    "eraser",    "probe",  "trace",
                                       "guess",   "measure",  "picture",  "outline"};
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
                                          "granularity/Square",
                                          "granularity/Layer"};
constexpr std::string_view kStatistics[] = {
    "Nn",       "Ne",   "area",   "Γ",       "Nb",   "Nc",     "Ns",      "Nt",    "cells",  "candidates", "new nodes",
    "deferred", "time", "forced", "improve", "hash", "α mean", "α geom.", "α min", "δ mean", "min ∠",      "max ∠"};

using WidgetNames = std::map<std::string, std::vector<std::string>>;

void add(WidgetNames &widgets, const std::string &group, Names list) {
    for (const std::string_view name : list) {
        widgets[group].push_back(group + '/' + std::string(name));
    }
}

} // namespace

WidgetNames widgetNames() {
    WidgetNames widgets;
    add(widgets, "timeline", kTimeline);
    add(widgets, "statistics", kStatistics);
    for (int step = 1; step <= kStepRows; ++step) {
        widgets["steps"].push_back("steps/" + std::to_string(step));
    }
    return widgets;
}

LessonNames editorNames() {
    LessonNames names;
    names.layers.assign(std::begin(kLayers), std::end(kLayers));
    names.panels.assign(std::begin(kPanels), std::end(kPanels));
    names.widgets = widgetNames();
    add(names.widgets, "layer", kLayers);
    add(names.widgets, "panel", kPanels);
    add(names.widgets, "tool", kTools);
    return names;
}

} // namespace forefront
