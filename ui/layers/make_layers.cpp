#include "ui/layers/layers.hpp"

namespace forefront {

bool LayerFrame::visible(std::string_view id) const {
    for (const LayerSlot &slot : layers) {
        if (slot.layer->id() == id) {
            return slot.visible;
        }
    }
    return false;
}

std::vector<std::unique_ptr<Layer>> makeLayers() {
    std::vector<std::unique_ptr<Layer>> layers;
    layers.push_back(makeDomainLayer());
    layers.push_back(makeMarksLayer());
    return layers;
}

} // namespace forefront
