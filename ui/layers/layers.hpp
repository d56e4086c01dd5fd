#pragma once

#include "ui/layers/layer.hpp"

#include <memory>

namespace forefront {

/// Inside of the domain.
std::unique_ptr<Layer> makeDomainLayer();
/// Boundary, constraints and isolated points as drawn.
std::unique_ptr<Layer> makeBoundaryLayer();
/// Lattice for drawing.
std::unique_ptr<Layer> makeLatticeLayer();
/// Node spacing ρ as a tint (viridis, logarithmic), with a legend.
std::unique_ptr<Layer> makeSpacingLayer();
/// Elements coloured by α (cividis), bad ones hatched and numbered, with a legend.
std::unique_ptr<Layer> makeQualityLayer();
/// Elements and their edges.
std::unique_ptr<Layer> makeMeshLayer();
/// Cells of the background grid: occupied, and visited in this step.
std::unique_ptr<Layer> makeGridLayer();
/// The directed generation front and the base segment AB.
std::unique_ptr<Layer> makeFrontLayer();
/// Ideal point and candidate nodes of this step with rank and verdict, and the element made.
std::unique_ptr<Layer> makeCandidatesLayer();
/// Candidate segments of this step and the segments of Γ they are tested against.
std::unique_ptr<Layer> makeTestsLayer();
/// Names of boundary parts and, close up, numbers of nodes.
std::unique_ptr<Layer> makeLabelsLayer();
/// Size sources and region markers.
std::unique_ptr<Layer> makeMarksLayer();
/// Faults of the drawing, each at its place.
std::unique_ptr<Layer> makeFaultsLayer();

} // namespace forefront
