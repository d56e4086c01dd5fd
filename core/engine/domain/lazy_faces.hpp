#pragma once

#include "core/engine/domain/domain_graph.hpp"
#include "core/engine/domain/inside_test.hpp"

#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace forefront {

/// The faces of a domain, found when they are first needed. The domain must outlive it. Not for several threads at
/// once.
class LazyFaces {
  public:
    /// `places`: further places whose faces are to be found, see DomainGraph::place.
    explicit LazyFaces(const Domain &domain, std::stop_token stop = {}, std::vector<Vec2> places = {})
        : domain_(domain), stop_(std::move(stop)), places_(std::move(places)) {}

    /// Returns the faces; null if segments cross, so that there are none, and after a stop request.
    const DomainFaces *get() const;
    /// Returns a test of whether a point is inside; null if there are no faces, or if all of them are outside.
    const InsideTest *inside() const;

  private:
    const Domain &domain_;
    std::stop_token stop_;
    std::vector<Vec2> places_;
    mutable std::optional<DomainFaces> found_; ///< without faces if segments cross
    mutable std::optional<InsideTest> inside_;
};

} // namespace forefront
