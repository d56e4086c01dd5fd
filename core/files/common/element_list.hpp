#pragma once

#include "core/engine/mesh/mesh.hpp"
#include "core/engine/mesh/mesh_numbers.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace forefront {

/// The elements of a mesh that is being read, in the order of the file, of any kinds. They are stored in the blocks
/// that the mesh gets, in the order in which the file begins each kind.
class ElementList {
  public:
    std::size_t size() const { return regions.size(); }
    bool empty() const { return regions.empty(); }
    bool hasSecondOrder() const;
    void add(CellKind kind, std::span<const NodeId> nodes, std::int32_t region);
    CellKind kindOf(std::size_t element) const { return blocks_[placeOf(element).block].kind(); }
    /// Returns all nodes of an element, in the order of CellTraits.
    std::span<const NodeId> nodesOf(std::size_t element) const {
        const Place place = placeOf(element);
        return blocks_[place.block].nodesOf(place.row);
    }
    /// Returns the corners of an element, counter-clockwise.
    std::span<const NodeId> cornersOf(std::size_t element) const {
        return nodesOf(element).first(traitsOf(kindOf(element)).corners);
    }

    /// Makes element k the one that was number order[k]; those that are not in `order` are dropped.
    void arrange(std::span<const std::uint32_t> order);
    /// Puts values of the elements, one each in the order of the file, in the order of the mesh.
    template <class T>
    void regroup(std::vector<T> &values) const {
        if (places_.empty()) {
            return;
        }
        const std::vector<std::size_t> begins = blockBegins();
        std::vector<T> moved(values.size());
        for (std::size_t e = 0; e < values.size(); ++e) {
            moved[begins[places_[e].block] + places_[e].row] = values[e];
        }
        values = std::move(moved);
    }
    /// Returns the numbers of the elements in the order of the mesh; `numbers`: in the order of the file.
    PartNumbers numbered(std::vector<std::int64_t> numbers) const;
    /// Returns the same for a file that numbers its elements first, first + 1, ...
    PartNumbers numberedFrom(std::int64_t first) const;

    /// Returns the elements as blocks of a mesh, with their regions; leaves the list empty.
    std::vector<CellBlock> takeBlocks();

    std::vector<std::int32_t> regions; ///< in the order of the file

  private:
    struct Place {
        std::uint32_t block = 0, row = 0;
    };
    Place placeOf(std::size_t element) const {
        return places_.empty() ? Place{0, static_cast<std::uint32_t>(element)} : places_[element];
    }
    std::vector<std::size_t> blockBegins() const;

    std::vector<CellBlock> blocks_;
    std::vector<Place> places_; ///< per element; empty while all are of one kind
};

} // namespace forefront
