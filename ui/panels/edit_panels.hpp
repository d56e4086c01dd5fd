#pragma once

#include "ui/parts/panel.hpp"

#include <memory>

namespace forefront {

/// Shows and edits the selection, and shows the spacing under the pointer.
std::unique_ptr<Panel> makeInspectorPanel();
/// Edits the node spacing ρ: size, expression, sources, paint, limits.
std::unique_ptr<Panel> makeSpacingPanel();
/// Edits the MeshingOptions of the document.
std::unique_ptr<Panel> makeMeshingPanel();
/// Edits the rules of the classic method.
std::unique_ptr<Panel> makeRulesPanel();
/// Edits the names of boundary parts and regions.
std::unique_ptr<Panel> makeNamesPanel();
/// Lists shapes by boundary part, and regions; hides, locks and selects them.
std::unique_ptr<Panel> makeShapesPanel();
/// Lists the nodes of the selected shapes or of all, edits their places, copies and pastes them as a table.
std::unique_ptr<Panel> makeNodesPanel();
/// Edits the parameters: named values that number fields can use.
std::unique_ptr<Panel> makeParametersPanel();
/// Lists the faults of the drawing, with links to their locations and a button to repair them.
std::unique_ptr<Panel> makeChecksPanel();

} // namespace forefront
