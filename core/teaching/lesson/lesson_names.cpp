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
                                        "labels",      "numbers", "dimensions", "faults"};
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
                                          "granularity/Layer"};
constexpr std::string_view kStatistics[] = {
    "Nn",       "Ne",   "area",   "Γ",       "Nb",   "Nc",     "Ns",      "Nt",    "cells",  "candidates", "new nodes",
    "deferred", "time", "forced", "improve", "hash", "α mean", "α geom.", "α min", "δ mean", "min ∠",      "max ∠"};

} // namespace

LessonNames editorNames() {
    LessonNames names;
    names.layers.assign(std::begin(kLayers), std::end(kLayers));
    names.panels.assign(std::begin(kPanels), std::end(kPanels));
    const auto add = [&names](const std::string &group, Names list) {
        for (const std::string_view name : list) {
            names.widgets[group].push_back(group + '/' + std::string(name));
        }
    };
    add("layer", kLayers);
    add("panel", kPanels);
    add("tool", kTools);
    add("timeline", kTimeline);
    add("statistics", kStatistics);
    for (int step = 1; step <= kStepRows; ++step) {
        names.widgets["steps"].push_back("steps/" + std::to_string(step));
    }
    return names;
}

} // namespace forefront
