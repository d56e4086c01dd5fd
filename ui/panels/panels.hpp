#pragma once

#include "ui/panels/panel.hpp"

#include <memory>

namespace forefront {

/// Switches of the layers.
std::unique_ptr<Panel> makeLayersPanel();
/// The ten steps of the technique with the live one marked.
std::unique_ptr<Panel> makeStepsPanel();
/// Histogram of α; a bar isolates its elements.
std::unique_ptr<Panel> makeHistogramPanel();
/// Nn, Ne, Nb, Nc, Ns, α, δ, angles, times.
std::unique_ptr<Panel> makeStatisticsPanel();
/// Messages with a way to their places.
std::unique_ptr<Panel> makeLogPanel();

} // namespace forefront
