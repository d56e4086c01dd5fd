#include "ui/panels/edit_panels.hpp"
#include "ui/panels/panels.hpp"

namespace forefront {

std::vector<std::unique_ptr<Panel>> makePanels() {
    std::vector<std::unique_ptr<Panel>> panels;
    panels.push_back(makeLayersPanel());
    panels.push_back(makeInspectorPanel());
    panels.push_back(makeSpacingPanel());
    panels.push_back(makeMeshingPanel());
    panels.push_back(makeStepsPanel());
    panels.push_back(makeCandidatesPanel());
    panels.push_back(makeRulesPanel());
    panels.push_back(makeHistogramPanel());
    panels.push_back(makeProbePanel());
    panels.push_back(makeStatisticsPanel());
    panels.push_back(makeChecksPanel());
    panels.push_back(makeWorstPanel());
    panels.push_back(makeAdaptPanel());
    panels.push_back(makeLogPanel());
    panels.push_back(makeShapesPanel());
    panels.push_back(makeParametersPanel());
    panels.push_back(makeNodesPanel());
    panels.push_back(makeNamesPanel());
    panels.push_back(makeHistoryPanel());
    return panels;
}

} // namespace forefront
