#pragma once

#include "core/engine/mesher/front_state.hpp"
#include "core/engine/quads/front_layers.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace forefront {

/// How the elements of a two-coloured front were made.
struct ColouredWork {
    std::uint64_t rows = 0;     ///< squares that continue a row, with one new node
    std::uint64_t openings = 0; ///< squares that start a row, with two new nodes
    std::uint64_t closings = 0; ///< squares without a new node
    std::uint64_t searched =
        0; ///< other triangles: found by the search, or half of a square whose second half was refused
    std::uint64_t forced = 0; ///< triangles made of existing nodes because no other choice was left

    friend bool operator==(const ColouredWork &, const ColouredWork &) = default;
};

/// The state of a two-coloured front besides its FrontState, with the log by which advances are undone.
struct ColouredState {
    /// `rows`: see FrontLayers.
    ColouredState(std::vector<std::uint8_t> nodeColours, std::uint32_t rows)
        : colours(std::move(nodeColours)), layers(rows) {}

    std::vector<std::uint8_t> colours; ///< per node
    std::vector<NodeId> opposite;      ///< per slot: the third node of the element behind its segment
    FrontLayers layers;
    ColouredWork work;
    std::uint64_t advances = 0;

    /// The sizes of the logs before an advance, and how its elements were made.
    struct Logged {
        std::uint32_t halves = 0, replaced = 0;
        std::size_t layers = 0;
        std::uint64_t ColouredWork::*made = nullptr; ///< the count that it raised; null: none
    };
    struct Replaced {
        SlotId slot;
        NodeId before; ///< in `opposite`
    };
    bool logging = false;
    std::vector<Logged> log;          ///< per advance since the logging began or the last checkpoint
    std::vector<AdvanceDelta> halves; ///< of squares made by two changes of the front, in order
    std::vector<Replaced> replaced;

    void keepLog(bool keep) {
        logging = keep;
        layers.keepLog(keep);
    }
    void clearLog() {
        log.clear();
        halves.clear();
        replaced.clear();
    }
};

} // namespace forefront
