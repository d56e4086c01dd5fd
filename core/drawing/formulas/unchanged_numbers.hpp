#pragma once

#include "core/drawing/document/document.hpp"

#include <cstdint>
#include <unordered_set>

namespace forefront {

/// Tells which numbers of a document are certain to be as they were in the document that it came from, without
/// looking at each number. The documents must outlive it.
class UnchangedNumbers {
  public:
    UnchangedNumbers(const Document &before, const Document &next);

    /// Returns true if the number at an address exists and has not changed. It may be unchanged if this is false.
    bool contains(const NumberAddress &address) const;

  private:
    const Document &before_, &next_;
    std::unordered_set<std::uint32_t> changedShapes_; ///< also added and removed ones
    bool sameSources_ = false, sameMarkers_ = false;
};

} // namespace forefront
