#pragma once

#include "core/engine/mesh/measures.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace forefront {

/// A part of a mesh.
struct MeshPick {
    MeshPart part = MeshPart::Elements;
    std::uint32_t index = 0;
    friend bool operator==(const MeshPick &, const MeshPick &) = default;
};

/// The parts of the mesh that the user is looking at.
struct Probe {
    bool active = false;             ///< the tool is chosen, so that parts must be found at the pointer
    bool walks = false;              ///< the list of the worst has the keyboard: arrow keys go from one to the next
    std::uint64_t mesh = 0;          ///< version of the mesh that the parts belong to
    std::optional<MeshPick> hovered; ///< under the pointer
    std::optional<MeshPick> chosen;  ///< by a click or from the list of the worst
    std::optional<std::size_t> rank; ///< of the chosen part among the worst

    /// Forgets the parts of another mesh.
    void follow(std::uint64_t version) {
        if (mesh != version) {
            hovered.reset();
            chosen.reset();
            rank.reset();
            mesh = version;
        }
    }
};

} // namespace forefront
