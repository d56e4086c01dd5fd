#pragma once

#include "core/engine/base/vec2.hpp"
#include "core/engine/spacing/sites/site_words.hpp"
#include "core/engine/spacing/spec/source_box.hpp"
#include "core/engine/spacing/spec/spacing_sample.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace forefront {

/// The box sources: at a point, the spacing is the size plus the growth times the distance from the box.
class BoxSources {
  public:
    /// Takes the boxes among the sources; std::nullopt if there are none. Sizes are raised to `minimum` and grow by at
    /// most `gradation`, which may be infinite; the bounds are over `box`.
    static std::optional<BoxSources> build(std::span<const SizeSource> sources, double minimum, double gradation,
                                           const Box2 &box);

    double at(Vec2 p) const;
    SpacingSample sample(Vec2 p, const SiteWords &words) const;
    double minimum() const { return minimum_; }
    double maximum() const { return maximum_; }

  private:
    struct Entry {
        SourceBox box;
        double size = 0.0;
        double growth = 0.0;
        double radius = 0.0; ///< the size applies within this distance of the box
        std::uint32_t source = 0;

        double at(Vec2 p) const { return size + growth * std::max(0.0, box.distanceTo(p) - radius); }
    };

    std::vector<Entry> entries_;
    double minimum_ = 0.0;
    double maximum_ = 0.0;
};

} // namespace forefront
