#include "ui/layers/layers.hpp"

namespace forefront {

std::vector<std::unique_ptr<Layer>> makeLayers() {
    std::vector<std::unique_ptr<Layer>> layers;
    layers.push_back(makePictureLayer());
    layers.push_back(makeDomainLayer());
    layers.push_back(makeSpacingLayer());
    layers.push_back(makeLatticeLayer());
    layers.push_back(makeQualityLayer());
    layers.push_back(makeMeshLayer());
    layers.push_back(makeRegionsLayer());
    layers.push_back(makeGridLayer());
    layers.push_back(makeBoundaryLayer());
    layers.push_back(makeFrontLayer());
    layers.push_back(makeColoursLayer());
    layers.push_back(makeTestsLayer());
    layers.push_back(makeCandidatesLayer());
    layers.push_back(makeImprovementLayer());
    layers.push_back(makeBoundaryLayersLayer());
    layers.push_back(makeGuidesLayer());
    layers.push_back(makeLinksLayer());
    layers.push_back(makeSketchLayer());
    layers.push_back(makeMarksLayer());
    layers.push_back(makeLabelsLayer());
    layers.push_back(makeNumbersLayer());
    layers.push_back(makeDimensionsLayer());
    layers.push_back(makeFaultsLayer());
    return layers;
}

} // namespace forefront
