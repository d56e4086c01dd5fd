#pragma once

#include "ui/parts/panel.hpp"

#include <memory>
#include <vector>

namespace forefront {

/// Shows and hides layers.
std::unique_ptr<Panel> makeLayersPanel();
/// Lists the ten steps of the technique and marks the current one.
std::unique_ptr<Panel> makeStepsPanel();
/// Lists the candidates of the current advance with their scores and verdicts, and works out one of them in numbers.
std::unique_ptr<Panel> makeCandidatesPanel();
/// Shows a histogram of the chosen measure; clicking a bar isolates its parts.
std::unique_ptr<Panel> makeHistogramPanel();
/// Shows the values of the part of the mesh that is chosen or under the pointer, and steps through the worst parts.
std::unique_ptr<Panel> makeProbePanel();
/// Lists the worst parts of the mesh by the chosen measure, below the canvas.
std::unique_ptr<Panel> makeWorstPanel();
/// Adapts the mesh to a field in rounds and lists their meshes.
std::unique_ptr<Panel> makeAdaptPanel();
/// Shows Nn, Ne, Nb, Nc, Ns, α, δ, angles and times.
std::unique_ptr<Panel> makeStatisticsPanel();
/// Lists the commands of the history; a click returns to that state.
std::unique_ptr<Panel> makeHistoryPanel();
/// Lists messages with links to their locations.
std::unique_ptr<Panel> makeLogPanel();

/// Creates all panels: the stacked ones from top to bottom, then the tabs from left to right.
std::vector<std::unique_ptr<Panel>> makePanels();

} // namespace forefront
