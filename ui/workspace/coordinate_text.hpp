#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace forefront {

class DocumentStore;

/// The size of the drawing, by which coordinates are rounded where they are shown: to about a hundredth of a pixel of a
/// view of all of it, also far from the origin, as in maps.
class DrawingExtent {
  public:
    /// Returns the diagonal of the drawing's box; 0: it is empty. Measured once for each revision.
    double diagonal(const DocumentStore &document) const;

  private:
    mutable std::optional<std::uint64_t> revision_; ///< that was measured; absent: none
    mutable double diagonal_ = 0.0;
};

/// Returns the number of decimals that tell such a hundredth: 2 for a diagonal of 1000 to 9999, 0 to 9.
int coordinateDecimals(double diagonal);

/// Returns a coordinate or length with at least 6 significant digits, and as many decimals as that, without zeros at
/// its end: "687123.25" in a map of 1 km.
std::string coordinateText(double value, double diagonal);

} // namespace forefront
