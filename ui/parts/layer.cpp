#include "ui/parts/layer.hpp"

#include <algorithm>

namespace forefront {

bool LayerFrame::visible(std::string_view id) const {
    for (const LayerSlot &slot : layers) {
        if (slot.layer->id() == id) {
            return slot.visible;
        }
    }
    return false;
}

Colour LayerFrame::area(Colour colour) const {
    constexpr double kOverPicture = 0.35;
    return picture && visible("picture") ? fade(colour, kOverPicture) : colour;
}

bool showsLayer(const std::vector<LayerSlot> &layers, std::string_view id) {
    return std::any_of(layers.begin(), layers.end(),
                       [&](const LayerSlot &slot) { return slot.visible && slot.layer->id() == id; });
}

void showLayer(std::vector<LayerSlot> &layers, std::string_view id, bool visible) {
    bool colours = false;
    for (LayerSlot &slot : layers) {
        if (slot.layer->id() == id) {
            slot.visible = visible;
            colours = visible && slot.layer->coloursByValue();
        }
    }
    for (LayerSlot &slot : layers) {
        if (colours && slot.layer->coloursByValue() && slot.layer->id() != id) {
            slot.visible = false;
        }
    }
}

} // namespace forefront
