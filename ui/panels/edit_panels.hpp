#pragma once

#include "ui/panels/panel.hpp"

#include <memory>

namespace forefront {

/// What is selected, in numbers, and the spacing under the pointer.
std::unique_ptr<Panel> makeInspectorPanel();
/// All that makes ρ: size, expression, sources, paint, limits.
std::unique_ptr<Panel> makeSpacingPanel();
/// How the front works: what MeshingOptions holds.
std::unique_ptr<Panel> makeMeshingPanel();
/// Names of boundary parts and regions.
std::unique_ptr<Panel> makeNamesPanel();
/// Faults of the drawing, live, with a way to each and the repair.
std::unique_ptr<Panel> makeChecksPanel();

} // namespace forefront
