#include "ui/workspace/view/workspaces.hpp"

#include <algorithm>

namespace forefront {

namespace {

using Ids = std::string_view;

// What follows the selection is below what does not, which stays in place.
constexpr std::array<Ids, 5> kDrawPanels{"shapes", "parameters", "inspector", "nodes", "names"};
constexpr std::array<Ids, 2> kDrawFolded{"nodes", "names"};
constexpr std::array<Ids, 15> kDrawTools{"select",  "polygon", "polyline", "rectangle", "circle",
                                         "ellipse", "regular", "slot",     "arc",       "point",
                                         "trim",    "region",  "measure",  "picture",   "outline"};
constexpr std::array<Ids, 12> kDrawLayers{"domain",  "boundary", "faults", "marks",  "mesh",   "lattice",
                                          "picture", "regions",  "labels", "sketch", "guides", "links"};

constexpr std::array<Ids, 3> kSizePanels{"spacing", "parameters", "inspector"};
constexpr std::array<Ids, 1> kSizeFolded{"parameters"};
constexpr std::array<Ids, 8> kSizeTools{"select", "source", "gradient", "brush",
                                        "eraser", "region", "measure",  "picture"};
constexpr std::array<Ids, 11> kSizeLayers{"domain", "boundary", "faults", "marks", "lattice", "picture",
                                          "labels", "mesh",     "size",   "rays",  "links"};

constexpr std::array<Ids, 3> kMeshPanels{"meshing", "statistics", "names"};
constexpr std::array<Ids, 1> kMeshFolded{"names"};
constexpr std::array<Ids, 4> kMeshTools{"select", "region", "probe", "trace"};
// The front shows how far a run has come.
constexpr std::array<Ids, 10> kMeshLayers{"domain",  "boundary", "faults", "marks", "picture",
                                          "regions", "mesh",     "front",  "rays",  "links"};

constexpr std::array<Ids, 4> kStepPanels{"steps", "candidates", "rules", "statistics"};
constexpr std::array<Ids, 2> kStepFolded{"rules", "statistics"};
constexpr std::array<Ids, 5> kStepTools{"select", "trace", "probe", "guess", "measure"};
// Marks say what sizes are asked for; the words of a step have their places.
constexpr std::array<Ids, 10> kStepLayers{"domain", "boundary", "faults",     "picture", "mesh",
                                          "front",  "colours",  "candidates", "tests",   "improvement"};

constexpr std::array<Ids, 4> kJudgePanels{"checks", "histogram", "probe", "adapt"};
constexpr std::array<Ids, 2> kJudgeFolded{"probe", "adapt"}; // the canvas has the values of what is chosen
constexpr std::array<Ids, 4> kJudgeTools{"select", "probe", "trace", "measure"};
constexpr std::array<Ids, 7> kJudgeLayers{"domain", "boundary", "faults", "marks", "picture", "mesh", "quality"};

constexpr std::array<WorkspacePreset, 5> kPresets{
    {{"draw", "Draw", "Shapes, names and parameters", kDrawPanels, kDrawFolded, kDrawTools, kDrawLayers},
     {"size", "Size", "Element sizes and sources", kSizePanels, kSizeFolded, kSizeTools, kSizeLayers},
     {"mesh", "Mesh", "Method and figures of the mesh", kMeshPanels, kMeshFolded, kMeshTools, kMeshLayers},
     {"step", "Step", "The advancing front, step by step", kStepPanels, kStepFolded, kStepTools, kStepLayers},
     {"judge", "Judge", "Limits, quality and worst elements", kJudgePanels, kJudgeFolded, kJudgeTools, kJudgeLayers}}};

} // namespace

const WorkspacePreset &presetOf(WorkspaceKind kind) {
    return kPresets[static_cast<std::size_t>(kind)];
}

std::optional<WorkspaceKind> workspaceOf(std::string_view word) {
    const auto found = std::find_if(kWorkspaceKinds.begin(), kWorkspaceKinds.end(),
                                    [word](WorkspaceKind kind) { return presetOf(kind).word == word; });
    return found == kWorkspaceKinds.end() ? std::nullopt : std::optional(*found);
}

} // namespace forefront
