#pragma once

#include "ui/parts/layer.hpp"

#include <memory>
#include <vector>

namespace forefront {

/// Draws the background picture.
std::unique_ptr<Layer> makePictureLayer();
/// Fills the inside of the domain.
std::unique_ptr<Layer> makeDomainLayer();
/// Draws the boundary, constraints and isolated points of the document.
std::unique_ptr<Layer> makeBoundaryLayer();
/// Draws the drawing lattice.
std::unique_ptr<Layer> makeLatticeLayer();
/// Colours the domain by the node spacing ρ (logarithmic), with a legend.
std::unique_ptr<Layer> makeSpacingLayer();
/// Colours elements, edges or nodes by the chosen measure, with a legend; hatches and numbers elements with bad α.
std::unique_ptr<Layer> makeQualityLayer();
/// Draws elements and their edges.
std::unique_ptr<Layer> makeMeshLayer();
/// Tints the faces that belong to regions.
std::unique_ptr<Layer> makeRegionsLayer();
/// Draws the cells of the background grid: those occupied, and those visited in this step.
std::unique_ptr<Layer> makeGridLayer();
/// Draws the directed generation front and the base segment AB.
std::unique_ptr<Layer> makeFrontLayer();
/// Draws the ideal point and the candidate nodes of this step with rank and verdict, and the new element.
std::unique_ptr<Layer> makeCandidatesLayer();
/// Draws the candidate segments of this step and the segments of Γ they are tested against.
std::unique_ptr<Layer> makeTestsLayer();
/// Draws the two colours of the nodes of the front of quadrilaterals.
std::unique_ptr<Layer> makeColoursLayer();
/// Draws what this step of the improvement changed.
std::unique_ptr<Layer> makeImprovementLayer();
/// Writes the names of boundary parts.
std::unique_ptr<Layer> makeLabelsLayer();
/// Writes the numbers of nodes and elements, close up.
std::unique_ptr<Layer> makeNumbersLayer();
/// Writes lengths, radii and angles of the drawing, or of the selected shapes.
std::unique_ptr<Layer> makeDimensionsLayer();
/// Draws the constraints of the sketch, with the values of its dimensions.
std::unique_ptr<Layer> makeSketchLayer();
/// Draws the rays of boundary layers, and those that are shorter than asked for.
std::unique_ptr<Layer> makeBoundaryLayersLayer();
/// Draws cracks, periodic parts and mapped regions.
std::unique_ptr<Layer> makeLinksLayer();
/// Draws the guides.
std::unique_ptr<Layer> makeGuidesLayer();
/// Draws size sources and region markers.
std::unique_ptr<Layer> makeMarksLayer();
/// Marks the faults of the drawing.
std::unique_ptr<Layer> makeFaultsLayer();

/// Creates all layers, from the lowest to the topmost.
std::vector<std::unique_ptr<Layer>> makeLayers();

} // namespace forefront
