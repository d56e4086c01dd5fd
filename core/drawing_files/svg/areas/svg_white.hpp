#pragma once

#include "core/drawing_files/svg/drawing/svg_drawing.hpp"

#include <cstddef>
#include <vector>

namespace forefront {

/// White filled shapes of a drawing that lie on other ones, as programs without holes draw them.
class SvgWhiteShapes {
  public:
    explicit SvgWhiteShapes(const std::vector<SvgPath> &paths);

    /// Returns the number of white elements that lie on others.
    std::size_t count() const { return count_; }
    /// Returns true if a path belongs to one; `path`: its index.
    bool contains(std::size_t path) const { return !on_[path].empty(); }
    /// Returns the elements, drawn earlier and not white, that the element of a path lies on, in the order of drawing.
    const std::vector<std::size_t> &below(std::size_t path) const { return on_[path]; }

  private:
    std::vector<std::vector<std::size_t>> on_; ///< by path
    std::size_t count_ = 0;
};

} // namespace forefront
