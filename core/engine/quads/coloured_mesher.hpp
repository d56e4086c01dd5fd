#pragma once

#include "core/engine/mesher/mesher.hpp"
#include "core/engine/quads/coloured_state.hpp"
#include "core/engine/quads/even_boundary.hpp"
#include "core/engine/quads/pairing.hpp"

#include <cstdint>
#include <memory>

namespace forefront {

/// A run of the two-coloured front, which moves forward and back like those of the other methods. An advance makes a
/// whole square or half of one, or defers a base.
class ColouredMesher : public Mesher {
  public:
    /// `rows`: see FrontLayers.
    static std::unique_ptr<ColouredMesher> create(std::shared_ptr<const ColouredBoundary> boundary,
                                                  std::shared_ptr<const SpacingField> spacing,
                                                  const MeshingOptions &options, std::uint32_t rows);

    bool advanceInParallel(unsigned, const Progress &, double, std::uint64_t) override { return true; }
    Checkpoint checkpoint() const override;
    std::uint64_t stateHash() const override;
    std::optional<Mesh> joinedMesh() const override;
    const std::vector<std::uint8_t> *colours() const override { return &coloured_.colours; }

    const ColouredWork &squares() const { return coloured_.work; }
    /// Returns the triangles made so far.
    ColouredTriangles triangles() const;
    /// Returns them joined where both halves of a square are made.
    PairedCells joinedCells() const;
    /// Ends the run and moves its arrays into triangles.
    ColouredTriangles takeTriangles();
    const ColouredBoundary &colouredBoundary() const { return *colouredBoundary_; }

  protected:
    ColouredMesher(std::shared_ptr<const ColouredBoundary> boundary, std::shared_ptr<const SpacingField> spacing,
                   std::uint32_t rows);
    /// Restores everything but the background grid.
    void restoreColoured(const Checkpoint &checkpoint, const MadeSoFar &made);
    void keepColours();

    std::shared_ptr<const ColouredBoundary> colouredBoundary_;
    ColouredState coloured_;
    std::vector<std::uint8_t> everyColour_; ///< of the nodes made up to the furthest advance
};

} // namespace forefront
