#pragma once

#include "core/drawing/arrangement/arrangement.hpp"

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace forefront {

/// A list of indices in no order from which each is removed in constant time.
class IndexBag {
  public:
    /// `place`: for all indices of all bags that share it, where they are in their bag.
    void add(std::uint32_t index, std::vector<std::uint32_t> &place) {
        place[index] = static_cast<std::uint32_t>(list_.size());
        list_.push_back(index);
    }
    void remove(std::uint32_t index, std::vector<std::uint32_t> &place) {
        const std::uint32_t last = list_.back();
        list_[place[index]] = last;
        place[last] = place[index];
        list_.pop_back();
    }
    const std::vector<std::uint32_t> &list() const { return list_; }

  private:
    std::vector<std::uint32_t> list_;
};

/// The winding numbers of the current face in a walk from face to face, and the shapes and features that cover it.
///
/// Only shapes and clips that cover the face are touched when a clip begins or ends, so that a clip of many shapes
/// costs no more than the shapes that lie on its outline.
class WindingWalk {
  public:
    explicit WindingWalk(const ArrangementInput &input);

    /// Crosses an outline to the side where the winding number is greater by `change`.
    void add(std::uint32_t contour, std::int32_t change);

    /// Returns the number of shapes of the domain that cover the place.
    std::uint32_t shapes() const { return shapes_; }
    /// Returns true if the place is inside a shape and its clip.
    bool covers(std::uint32_t shape) const { return insideShape(shape) && shows(input_.shapes[shape].limit); }
    /// Returns true if the place is inside a clip and all those around it.
    bool shows(std::uint32_t clip) const { return clip == kNoClip || clips_[clip].open; }
    const std::vector<std::uint32_t> &features() const { return features_.list(); }
    bool coversFeature(std::uint32_t feature) const { return ofFeature_[feature] > 0; }

    /// Returns the features that started or ceased to cover the place since the last call, or did both.
    std::vector<std::uint32_t> takeSwitched();

    /// Starts a list of the shapes of the domain that start or cease to cover the place.
    void watchShapes() { watches_ = true; }
    /// Ends the list and returns those that do so on the whole, sorted by index.
    std::vector<std::uint32_t> takeWatched();

  private:
    struct Clip {
        std::set<std::uint32_t> parts; ///< that cover the place
        bool inside = false;           ///< the last of them does not remove it
        bool open = false;             ///< and the place is inside all clips around
        IndexBag shapes;               ///< limited by this clip, and around the place
        IndexBag clips;                ///< within this clip, and around the place
    };

    bool insideContour(std::uint32_t contour) const;
    bool insideShape(std::uint32_t shape) const { return outer_[shape] > 0 && hole_[shape] == 0; }
    void setInside(std::uint32_t shape, bool inside);
    void setCovered(std::uint32_t shape, bool covered);
    void setPart(std::uint32_t shape, bool covered);
    void settle();
    void listSwitched(std::uint32_t feature);

    const ArrangementInput &input_;
    std::vector<std::int32_t> winding_;       // per contour
    std::vector<std::uint32_t> outer_, hole_; // per shape: contours that the place is inside of
    std::uint32_t shapes_ = 0;
    std::vector<std::uint32_t> ofFeature_; // per feature: shapes that cover the place
    IndexBag features_;                    // that do so
    std::vector<std::uint32_t> place_;     // in features_
    std::vector<std::uint32_t> switched_;  // see takeSwitched()
    std::vector<std::uint8_t> isListed_;   // per feature: in switched_
    std::vector<Clip> clips_;
    std::vector<std::uint32_t> shapePlace_, clipPlace_; // in the bags of clips_
    std::vector<std::uint32_t> unsettled_;              // clips that may have begun or ended
    bool watches_ = false;
    std::vector<std::uint32_t> watched_;
};

} // namespace forefront
