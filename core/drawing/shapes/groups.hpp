#pragma once

#include "core/drawing/shapes/references.hpp"
#include "core/engine/base/result.hpp"

#include <cstdint>
#include <map>
#include <set>

namespace forefront {

// Groups: shapes that are selected as one. They do not change the domain.

/// Makes shapes one group, in which the groups that they belong to dissolve. Error: not-possible for fewer than two
/// shapes.
Result<Document> groupShapes(const Document &document, const std::set<std::uint32_t> &shapes);

/// Dissolves the groups that shapes belong to. Error: not-possible if they belong to none.
Result<Document> ungroupShapes(const Document &document, const std::set<std::uint32_t> &shapes);

/// Returns the shapes that are selected with a shape: those of its group that are visible and not locked, or the shape
/// alone.
std::set<std::uint32_t> shapesGroupedWith(const Document &document, std::uint32_t shape);

/// Adds to the selected shapes those that are selected with them.
void completeGroups(const Document &document, Selection &selection);

/// Gives groups that are copied into a document numbers that none of its groups has.
class CopiedGroups {
  public:
    explicit CopiedGroups(const Document &into);
    /// Returns the number for a group of the original; 0 for 0.
    std::uint32_t operator()(std::uint32_t original);
    /// Begins another copy: the same groups get other numbers.
    void beginCopy() { numbers_.clear(); }

  private:
    std::uint32_t next_ = 1;
    std::map<std::uint32_t, std::uint32_t> numbers_;
};

} // namespace forefront
